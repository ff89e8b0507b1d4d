// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/motion/cells_3.h>

#include <annulus/arithmetic/error.h>
#include <annulus/mesh/parallel_runs.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace annulus {

namespace {

struct Facet {
    Index middle, last;  // its vertices but the least, in order
    Index cell;
    Index corner;
};

}  // namespace

Cells_3 linked(std::vector<std::array<Index, 4>> cells, std::size_t n) {
    Cells_3 out;
    out.vertex = std::move(cells);
    out.adjacent.assign(out.size(), {none, none, none, none});
    // Facets by their least vertex (counting sort), then a search among the few with the same one.
    std::vector<std::size_t> begin(n + 2, 0);
    const auto sorted = [&](std::size_t c, std::size_t i) {
        const auto& f = facet_corners[i];
        std::array<Index, 3> v{out.vertex[c][f[0]], out.vertex[c][f[1]], out.vertex[c][f[2]]};
        std::sort(v.begin(), v.end());
        return v;
    };
    for (std::size_t c = 0; c < out.size(); ++c) {
        for (const Index v : out.vertex[c])
            if (v < 0 || static_cast<std::size_t>(v) >= n)
                throw Error(Error_code::unknown_vertex, "linked: a cell names no vertex");
        for (std::size_t i = 0; i < 4; ++i) ++begin[static_cast<std::size_t>(sorted(c, i)[0]) + 2];
    }
    for (std::size_t v = 2; v < begin.size(); ++v) begin[v] += begin[v - 1];
    std::vector<Facet> facets(4 * out.size());
    for (std::size_t c = 0; c < out.size(); ++c)
        for (std::size_t i = 0; i < 4; ++i) {
            const auto v = sorted(c, i);
            facets[begin[static_cast<std::size_t>(v[0]) + 1]++] = {v[1], v[2], static_cast<Index>(c),
                                                                   static_cast<Index>(i)};
        }
    const auto ends = [](const Facet& f) { return std::pair(f.middle, f.last); };
    for (std::size_t v = 0; v < n; ++v) {
        const auto first = facets.begin() + static_cast<std::ptrdiff_t>(begin[v]),
                   last = facets.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]);
        std::sort(first, last, [&](const Facet& a, const Facet& b) {
            return std::tuple(a.middle, a.last, a.cell) < std::tuple(b.middle, b.last, b.cell);
        });
        for (auto f = first; f != last; ++f) {
            if (f + 1 == last || ends(*f) != ends(*(f + 1))) continue;
            if (f + 2 != last && ends(*f) == ends(*(f + 2)))
                throw Error(Error_code::bad_input, "linked: three cells share a facet");
            const Facet& g = *(f + 1);
            out.adjacent[static_cast<std::size_t>(f->cell)][static_cast<std::size_t>(f->corner)] = g.cell;
            out.adjacent[static_cast<std::size_t>(g.cell)][static_cast<std::size_t>(g.corner)] = f->cell;
        }
    }
    return out;
}

Coordinates<3> weighted_circumcentre(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c,
                                     const Coordinates<3>& d, double& volume) {
    // With the origin at a: 12 V x = |b|² c×d + |c|² d×b + |d|² b×c, 6 V = b · (c×d).
    Coordinates<3> e[3];
    double square[3];
    for (std::size_t k = 0; k < 3; ++k) {
        e[0][k] = b[k] - a[k];
        e[1][k] = c[k] - a[k];
        e[2][k] = d[k] - a[k];
    }
    for (std::size_t i = 0; i < 3; ++i) square[i] = e[i][0] * e[i][0] + e[i][1] * e[i][1] + e[i][2] * e[i][2];
    Coordinates<3> sum{};
    volume = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& p = e[(i + 1) % 3];
        const auto& q = e[(i + 2) % 3];
        const Coordinates<3> n{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
        for (std::size_t k = 0; k < 3; ++k) sum[k] += square[i] * n[k] / 12;
        if (i == 0) volume = (e[0][0] * n[0] + e[0][1] * n[1] + e[0][2] * n[2]) / 6;
    }
    return sum;
}

std::vector<char> cells_inside(const Domain_3& domain, const Cells_3& cells, std::span<const Coordinates<3>> position,
                               int threads) {
    std::vector<char> inside(cells.size(), 0);
    for_each_run(cells.size(), 1024, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t c = first; c < last; ++c) {
            const auto x = [&](std::size_t i) -> const Coordinates<3>& {
                return position[static_cast<std::size_t>(cells.vertex[c][i])];
            };
            double volume = 0;
            const Coordinates<3> w = weighted_circumcentre(x(0), x(1), x(2), x(3), volume);
            Coordinates<3> centre;
            for (std::size_t k = 0; k < 3; ++k) centre[k] = x(0)[k] + w[k] / volume;
            if (std::isfinite(centre[0]) && std::isfinite(centre[1]) && std::isfinite(centre[2]))
                inside[c] = domain.contains(centre) ? 1 : 0;
        }
    });
    return inside;
}

std::vector<std::array<Index, 3>> surface_facets(const Cells_3& cells, std::span<const char> inside) {
    std::vector<std::array<Index, 3>> facets;
    for (std::size_t c = 0; c < cells.size(); ++c)
        for (std::size_t i = 0; inside[c] != 0 && i < 4; ++i) {
            const Index beyond = cells.adjacent[c][i];
            if (beyond != none && inside[static_cast<std::size_t>(beyond)] != 0) continue;
            const auto& f = facet_corners[i];
            facets.push_back({cells.vertex[c][f[0]], cells.vertex[c][f[1]], cells.vertex[c][f[2]]});
        }
    return facets;
}

}  // namespace annulus
