// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is true of every Periodic_mesh, in integers and rational numbers: its audit, which shares nothing with what
// makes it, and whether its other answers agree with its cells.

#include <annulus/error.h>
#include <annulus/periodic_mesh.h>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

namespace annulus::oracle {

template <int d>
using Rationals = std::array<mpq_class, static_cast<std::size_t>(d)>;

template <std::size_t d>
[[nodiscard]] Rationals<static_cast<int>(d)> rationals(const std::array<double, d>& p) {
    Rationals<static_cast<int>(d)> x;
    for (std::size_t i = 0; i < d; ++i) x[i] = p[i];
    return x;
}
/// x + factor * (shift . box).
template <int d>
[[nodiscard]] Rationals<d> translated(Rationals<d> x, const Shift<d>& shift, int factor,
                                      const typename Box<d>::Vectors& box) {
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t i = 0; i < d && shift[j] != 0; ++i)
            x[i] += factor * mpq_class(shift[j]) * mpq_class(box[j][i]);
    return x;
}
/// The determinant of x[1] - x[0] .. x[d] - x[0].
template <std::size_t d>
[[nodiscard]] mpq_class determinant(const std::array<std::array<mpq_class, d>, d + 1>& x) {
    std::array<std::array<mpq_class, d>, d> m;
    for (std::size_t k = 0; k < d; ++k)
        for (std::size_t i = 0; i < d; ++i) m[k][i] = x[k + 1][i] - x[0][i];
    if constexpr (d == 2) return m[0][0] * m[1][1] - m[0][1] * m[1][0];
    else {
        mpq_class sum = 0;
        for (std::size_t i = 0; i < 3; ++i)
            sum += m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3]);
        return sum;
    }
}

/// Whether two points have, up to vectors of the box, positions that may be rounded to one.
template <int d>
[[nodiscard]] bool may_coincide(const Coordinates<d>& p, const Coordinates<d>& q, const typename Box<d>::Vectors& box) {
    std::array<Rationals<d>, static_cast<std::size_t>(d + 1)> corners;
    for (std::size_t j = 0; j < d; ++j) corners[j + 1] = rationals(box[j]);
    const mpq_class whole = determinant(corners);
    Rationals<d> way = rationals(p);
    for (std::size_t i = 0; i < d; ++i) way[i] -= mpq_class(q[i]);
    const Rationals<d> far = way;
    for (std::size_t j = 0; j < d; ++j) {  // Cramer's rule
        auto replaced = corners;
        replaced[j + 1] = far;
        const mpq_class f = determinant(replaced) / whole + mpq_class(1, 2);
        mpz_class times;
        mpz_fdiv_q(times.get_mpz_t(), f.get_num().get_mpz_t(), f.get_den().get_mpz_t());
        for (std::size_t i = 0; i < d; ++i) way[i] -= times * mpq_class(box[j][i]);
    }
    for (std::size_t i = 0; i < d; ++i) {
        double extent = 0;
        for (std::size_t j = 0; j < d; ++j) extent += std::abs(box[j][i]);
        if (abs(way[i]) > mpq_class(std::ldexp(extent, -44))) return false;
    }
    return true;
}

/// Whether an error rightly says that points have one place.
template <int d>
[[nodiscard]] bool names_one_place(const Error& e, const std::vector<Coordinates<d>>& x, const Box<d>& box) {
    if (e.code() != Error_code::duplicate_point || e.vertices().size() < 2) return false;
    const auto at = [&x](std::int64_t v) { return x[static_cast<std::size_t>(v)]; };
    return std::all_of(e.vertices().begin() + 1, e.vertices().end(), [&](std::int64_t v) {
        return v != e.vertices()[0] && may_coincide<d>(at(e.vertices()[0]), at(v), box.vectors());
    });
}

/// Which image of a second vertex is a neighbour of a first one.
template <int d>
using Pair_of_images = std::tuple<Index, Index, Shift<d>>;

/// Every edge of the cells, in both directions, once.
template <int d>
[[nodiscard]] std::vector<Pair_of_images<d>> edges_of(const Periodic_cells<d>& cells) {
    std::vector<Pair_of_images<d>> edges;
    for (std::size_t c = 0; c < cells.vertices.size(); ++c)
        for (std::size_t k = 0; k <= d; ++k)
            for (std::size_t l = 0; l <= d; ++l) {
                if (k == l) continue;
                Shift<d> shift;
                for (std::size_t j = 0; j < d; ++j) shift[j] = cells.offsets[c][l][j] - cells.offsets[c][k][j];
                edges.emplace_back(cells.vertices[c][k], cells.vertices[c][l], shift);
            }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

template <int d>
class Periodic_checks {
  public:
    explicit Periodic_checks(const Periodic_mesh<d>& mesh)
        : mesh_(mesh), cells_(mesh.cells()), given_(mesh.saved().vectors) {}

    /// Empty, or what is wrong.
    [[nodiscard]] std::string fault() const {
        const auto input = mesh_.audit_input();
        const Audit_result audit = annulus::audit(input);
        if (!audit.delaunay() || !audit.first_fault.empty()) return "audit: " + audit.first_fault;
        if (!are_cells_of(input.cells)) return "cells() are not those of places()";
        std::string found = fault_of_pairs();
        if (found.empty()) found = fault_of_volumes();
        return found;
    }

    /// Whether a vertex is where it was asked for, in the box as it was given: the point less its image is the place,
    /// but for rounding.
    [[nodiscard]] bool is_at(std::size_t v, const Coordinates<d>& p) const {
        if (!mesh_.is_vertex(static_cast<Index>(v))) return false;
        const Rationals<d> x = translated<d>(rationals(p), mesh_.images()[v], -1, given_);
        for (std::size_t k = 0; k < d; ++k)
            if (abs(x[k] - mpq_class(mesh_.places()[v][k])) > 3 * mpq_class(mesh_.grid()[k])) return false;
        return true;
    }

    /// Whether find_cell names a cell that contains p, a point within two boxes of the origin. It is brought into the
    /// reduced box by vectors that are not rounded, some hundred times at most, so it may be off by as many spacings of
    /// the grid.
    [[nodiscard]] bool is_found(const Coordinates<d>& p) const {
        const Periodic_location<d> at = mesh_.find_cell(p);
        if (cells_.vertices.empty()) return at.cell == -1;
        if (at.cell < 0 || static_cast<std::size_t>(at.cell) >= cells_.vertices.size()) return false;
        const auto c = static_cast<std::size_t>(at.cell);
        std::array<Rationals<d>, static_cast<std::size_t>(d + 1)> x;
        for (std::size_t k = 0; k <= d; ++k) x[k] = position(cells_.vertices[c][k], cells_.offsets[c][k], at.shift);
        for (std::size_t k = 0; k <= d; ++k) {
            auto replaced = x;
            replaced[k] = rationals(p);
            const mpq_class inside = determinant(replaced);
            mpq_class change = 0;
            for (std::size_t i = 0; i < d; ++i) {
                auto beside = replaced;
                beside[k][i] += 256 * mpq_class(mesh_.grid()[i]);
                change += abs(determinant(beside) - inside);
            }
            if (inside + change < 0) return false;
        }
        return true;
    }
    /// Whether find_cell names, for a vertex, a cell of it: exactly where the box is on its grid and the vertex near.
    [[nodiscard]] bool is_corner_found(std::size_t v) const {
        if (given_ != mesh_.box().vectors()) return true;
        for (const auto image : mesh_.images()[v])
            if (std::abs(image) > 2) return true;
        const Periodic_location<d> at = mesh_.find_cell(mesh_.points()[v]);
        if (at.cell < 0 || static_cast<std::size_t>(at.cell) >= cells_.vertices.size()) return false;
        const auto c = static_cast<std::size_t>(at.cell);
        for (std::size_t k = 0; k <= d; ++k) {
            bool same = cells_.vertices[c][k] == static_cast<Index>(v);
            for (std::size_t j = 0; j < d; ++j) same = same && cells_.offsets[c][k][j] + at.shift[j] == 0;
            if (same) return true;
        }
        return false;
    }

  private:
    /// Of an image of a vertex, at points()[v] + (offset + shift) . box.
    [[nodiscard]] Rationals<d> position(Index v, const Shift<d>& offset, const Shift<d>& shift) const {
        const auto i = static_cast<std::size_t>(v);
        Rationals<d> x = translated<d>(rationals(mesh_.places()[i]), mesh_.images()[i], 1, mesh_.box().vectors());
        x = translated<d>(x, offset, 1, mesh_.box().vectors());
        return translated<d>(x, shift, 1, mesh_.box().vectors());
    }

    /// The offsets of one refer to points(), and of the other to places(): all corners of a cell differ by images(),
    /// up to a translation.
    [[nodiscard]] bool are_cells_of(const Periodic_cells<d>& others) const {
        if (cells_.vertices != others.vertices || cells_.neighbours != others.neighbours) return false;
        for (std::size_t c = 0; c < others.vertices.size(); ++c)
            for (std::size_t j = 0; j < d; ++j) {
                const auto way = [&](std::size_t k) {
                    const auto v = static_cast<std::size_t>(others.vertices[c][k]);
                    return cells_.offsets[c][k][j] + mesh_.images()[v][j] - others.offsets[c][k][j];
                };
                for (std::size_t k = 1; k <= d; ++k)
                    if (way(k) != way(0)) return false;
            }
        return true;
    }

    [[nodiscard]] std::string fault_of_pairs() const {
        const Periodic_neighbours<d> pairs = mesh_.neighbours();
        std::vector<Pair_of_images<d>> listed;
        for (std::size_t k = 0; k < pairs.first.size(); ++k)
            listed.emplace_back(pairs.first[k], pairs.second[k], pairs.shift[k]);
        if (listed != edges_of(cells_)) return "neighbours() are not the edges of the cells";
        for (std::size_t k = 0; k < listed.size(); ++k) {
            const Rationals<d> from = position(pairs.first[k], {}, {});
            const Rationals<d> to = position(pairs.second[k], pairs.shift[k], {});
            for (std::size_t i = 0; i < d; ++i)
                if (to[i] - from[i] != mpq_class(pairs.vector[k][i])) return "a vector of neighbours() is not exact";
            const auto [i, j, shift] = listed[k];
            Shift<d> back;
            for (std::size_t c = 0; c < d; ++c) back[c] = -shift[c];
            const auto other = std::lower_bound(listed.begin(), listed.end(), Pair_of_images<d>(j, i, back));
            const auto area = pairs.area[static_cast<std::size_t>(other - listed.begin())];
            if (!(pairs.area[k] >= 0) || (area == 0) != (pairs.area[k] == 0)) return "a facet is empty on one side";
        }
        // Euler's relation: 3n edges in 2D, and as many as cells and vertices in 3D.
        const std::size_t n = mesh_.number_of_vertices(), edges = listed.size() / 2;
        if (edges != (d == 2 ? 3 * n : mesh_.number_of_cells() + n)) return "number of edges";
        if (mesh_.number_of_cells() != cells_.vertices.size() || (d == 2 && cells_.vertices.size() != 2 * n))
            return "number of cells";
        std::vector<Index> degrees(mesh_.index_bound(), 0), filled = degrees;
        for (std::size_t k = 0; k < listed.size(); ++k) {
            const auto v = static_cast<std::size_t>(pairs.first[k]);
            ++degrees[v];
            if (pairs.area[k] > 0) ++filled[v];
        }
        if (mesh_.neighbour_counts(0, false) != degrees || mesh_.neighbour_counts() != filled)
            return "neighbour_counts() are not those of neighbours()";
        return {};
    }

    [[nodiscard]] std::string fault_of_volumes() const {
        const std::vector<double> volumes = mesh_.voronoi_volumes();
        if (volumes.size() != mesh_.index_bound()) return "number of volumes";
        mpq_class sum = 0;
        for (std::size_t v = 0; v < volumes.size(); ++v) {
            if (mesh_.is_vertex(static_cast<Index>(v)) != (volumes[v] > 0)) return "a volume is not positive";
            if (volumes[v] > 0) sum += mpq_class(volumes[v]);
        }
        if (mesh_.number_of_vertices() == 0) return {};
        std::array<Rationals<d>, static_cast<std::size_t>(d + 1)> corners;
        for (std::size_t j = 0; j < d; ++j) corners[j + 1] = rationals(mesh_.box().vectors()[j]);
        const mpq_class whole = abs(determinant(corners));
        return abs(sum - whole) > whole * mpq_class(0x1p-33) ? "volumes do not add up to that of the box" : "";
    }

    const Periodic_mesh<d>& mesh_;
    const Periodic_cells<d> cells_;
    const typename Box<d>::Vectors given_;
};

}  // namespace annulus::oracle
