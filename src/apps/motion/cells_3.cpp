// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/cells_3.h>

#include <annulus/error.h>
#include <annulus/mesh/parallel_runs.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr Index outside = Mesh_cells<3>::outside;

struct Facet {
    Index middle, last;  // its vertices but the least, in order
    Index cell;
    Index corner;
};

/// Links the cells across facets that have the same least vertex. `table` is work space: a hash table of the facets
/// seen.
void join(std::span<const Facet> facets, std::vector<Index>& table, Mesh_cells<3>& out) {
    std::size_t size = 16;
    while (size < 2 * facets.size()) size *= 2;
    table.assign(size, none);
    const auto hash = [size](const Facet& f) {
        const auto key =
            static_cast<std::uint32_t>(f.middle) * 0x9E3779B1U ^ static_cast<std::uint32_t>(f.last) * 0x85EBCA77U;
        return static_cast<std::size_t>(key ^ (key >> 15)) & (size - 1);
    };
    for (std::size_t k = 0; k < facets.size(); ++k) {
        const Facet& f = facets[k];
        std::size_t h = hash(f);
        const auto other = [&] { return facets[static_cast<std::size_t>(table[h])]; };
        while (table[h] != none && (other().middle != f.middle || other().last != f.last)) h = (h + 1) & (size - 1);
        if (table[h] == none) {
            table[h] = static_cast<Index>(k);
            continue;
        }
        const Facet g = other();
        Index& beyond = out.neighbours[static_cast<std::size_t>(g.cell)][static_cast<std::size_t>(g.corner)];
        if (beyond != outside) throw Error(Error_code::bad_input, "linked: three cells share a facet");
        beyond = f.cell;
        out.neighbours[static_cast<std::size_t>(f.cell)][static_cast<std::size_t>(f.corner)] = g.cell;
    }
}

}  // namespace

Mesh_cells<3> linked(std::vector<std::array<Index, 4>> cells, std::size_t n, int threads) {
    Mesh_cells<3> out;
    out.vertices = std::move(cells);
    out.neighbours.assign(out.vertices.size(), {outside, outside, outside, outside});
    // Sorts facets by their least vertex (counting sort), then searches among the few that share it.
    std::vector<std::size_t> begin(n + 2, 0);
    const auto ends = [&](std::size_t c, std::size_t i) {
        const auto& f = facet_corners[i];
        const Index p = out.vertices[c][f[0]], q = out.vertices[c][f[1]], r = out.vertices[c][f[2]];
        const Index low = std::min({p, q, r}), high = std::max({p, q, r});
        return std::array<Index, 3>{low, p ^ q ^ r ^ low ^ high, high};
    };
    for (std::size_t c = 0; c < out.vertices.size(); ++c) {
        for (const Index v : out.vertices[c])
            if (v < 0 || static_cast<std::size_t>(v) >= n)
                throw Error(Error_code::unknown_vertex, "linked: a cell names no vertex");
        for (std::size_t i = 0; i < 4; ++i) ++begin[static_cast<std::size_t>(ends(c, i)[0]) + 2];
    }
    for (std::size_t v = 2; v < begin.size(); ++v) begin[v] += begin[v - 1];
    std::vector<Facet> facets(4 * out.vertices.size());
    for (std::size_t c = 0; c < out.vertices.size(); ++c)
        for (std::size_t i = 0; i < 4; ++i) {
            const auto v = ends(c, i);
            facets[begin[static_cast<std::size_t>(v[0]) + 1]++] = {v[1], v[2], static_cast<Index>(c),
                                                                   static_cast<Index>(i)};
        }
    for_each_run(n, 1024, threads, [&](std::size_t first, std::size_t last) {
        std::vector<Index> table;
        for (std::size_t v = first; v < last; ++v)
            join(std::span<const Facet>(facets).subspan(begin[v], begin[v + 1] - begin[v]), table, out);
    });
    return out;
}

Cell_moment cell_moment(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c,
                        const Coordinates<3>& d) {
    // With the origin at a: 12 V x = |b|² c×d + |c|² d×b + |d|² b×c, 6 V = b · (c×d).
    Coordinates<3> e[3];
    double square[3];
    for (std::size_t k = 0; k < 3; ++k) {
        e[0][k] = b[k] - a[k];
        e[1][k] = c[k] - a[k];
        e[2][k] = d[k] - a[k];
    }
    for (std::size_t i = 0; i < 3; ++i) square[i] = e[i][0] * e[i][0] + e[i][1] * e[i][1] + e[i][2] * e[i][2];
    Cell_moment out;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& p = e[(i + 1) % 3];
        const auto& q = e[(i + 2) % 3];
        const Coordinates<3> n{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
        for (std::size_t k = 0; k < 3; ++k) out.moment[k] += square[i] * n[k];
        if (i == 0) out.volume = (e[0][0] * n[0] + e[0][1] * n[1] + e[0][2] * n[2]) * (1.0 / 6);
    }
    for (double& x : out.moment) x *= 1.0 / 12;
    return out;
}

bool is_inside(const Domain_3& domain, const Coordinates<3>& a, const Cell_moment& cell) {
    Coordinates<3> centre;
    for (std::size_t k = 0; k < 3; ++k) centre[k] = a[k] + cell.moment[k] / cell.volume;
    return std::isfinite(centre[0]) && std::isfinite(centre[1]) && std::isfinite(centre[2]) && domain.contains(centre);
}

std::vector<char> cells_inside(const Domain_3& domain, const Mesh_cells<3>& cells,
                               std::span<const Coordinates<3>> position, int threads) {
    std::vector<char> inside(cells.vertices.size(), 0);
    for_each_run(cells.vertices.size(), 1024, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t c = first; c < last; ++c) {
            const auto x = [&](std::size_t i) -> const Coordinates<3>& {
                return position[static_cast<std::size_t>(cells.vertices[c][i])];
            };
            inside[c] = is_inside(domain, x(0), cell_moment(x(0), x(1), x(2), x(3))) ? 1 : 0;
        }
    });
    return inside;
}

std::vector<std::array<Index, 3>> surface_facets(const Mesh_cells<3>& cells, std::span<const char> inside,
                                                 int threads) {
    constexpr std::size_t length = 4096;
    std::vector<std::vector<std::array<Index, 3>>> of_run((cells.vertices.size() + length - 1) / length);
    for_each_run(cells.vertices.size(), length, threads, [&](std::size_t first, std::size_t last) {
        auto& facets = of_run[first / length];
        for (std::size_t c = first; c < last; ++c)
            for (std::size_t i = 0; inside[c] != 0 && i < 4; ++i) {
                const Index beyond = cells.neighbours[c][i];
                if (beyond != outside && inside[static_cast<std::size_t>(beyond)] != 0) continue;
                const auto& f = facet_corners[i];
                facets.push_back({cells.vertices[c][f[0]], cells.vertices[c][f[1]], cells.vertices[c][f[2]]});
            }
    });
    std::vector<std::array<Index, 3>> all;
    for (const auto& facets : of_run) all.insert(all.end(), facets.begin(), facets.end());
    return all;
}

}  // namespace annulus::inline v1
