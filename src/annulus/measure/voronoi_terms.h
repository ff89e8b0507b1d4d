// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/circumcentre.h>
#include <annulus/measure/voronoi_exact.h>
#include <annulus/predicate/bounds.h>
#include <annulus/space/euclidean.h>
#include <annulus/voronoi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

// Let F be a facet of the triangulation between two cells with circumcentres C and C', and n = q - p one of its edges,
// m a point of the line pq. The triangle m, C, C' is in the Voronoi facet of p and q; the signed triangles of all F
// around the edge add up to it. So the pyramids over it with tips p and q, which are congruent, are sums of (C left of
// F and C' right of it, as in facet_corners)
//
//     n . ((C - m) x (C' - m)) / 12     and in 2D     (C' - C) . (n_y, -n_x) / 4,
//
// and these, over all edges at p, add up to the volume of its Voronoi cell. In voronoi_exact.cpp m is the vertex. Here
// the three edges of a facet a, b, c share terms: with e = b - a, f = c - a, X = C - a, D = C' - C, W = X x D and g = D
// . (e x f) the terms of ab, ca and bc are e . W, -f . W and (f - e) . W + g, for m = a, a and b; each goes to both
// ends of its edge, hence
//
//     (e - f) . W to a,     f . W + g to b,     g - e . W to c.
//
// Conditioning: a cell with inradius r and surface S has a volume of at least r S / 3, and moving its corners by h
// changes it by h S, so relatively by 3 h / r, where 2 r is the distance of the nearest neighbour. Hence circumcentres,
// compared with shortest edges, decide.
//
// Errors, u = 2^-53; |v| is the largest coordinate of a vector, without its sign. X and C' - a are off by h and h' at
// most, summed over coordinates: a circumcentre's own bound, and u of each difference and sum on the way. e, f and D
// are rounded differences. For the order of operations below proofs/gappa/voronoi_terms_3.g proves that e . W, and f .
// W alike, is off by voronoi_3_edge u |e| |X| |D| at most, and g by voronoi_3_facet u |e| |f| |D|. Each of the two is
// at most 6 such products, so that their sum or difference is off by 6 u more; the constant used is the larger one plus
// 6 plus 1. The effect of h and h' is added to that. Of the six products that e . W is, two have a given coordinate of
// X, two a given one of D, and one has both, so that it changes by
//
//     2 |e| |D| h + 2 |e| |X| (h + h') + |e| h (h + h')     at most, and g by     2 |e| |f| (h + h').
//
// In 2D (proofs/gappa/voronoi_terms_2.g) a term is off by voronoi_2 u |e| |D|, for which voronoi_2 plus 1 is used, and
// by |e| (h + h').
//
// An underflow is an error of 2^-1075, multiplied by edges, which are below 2, and perhaps by X, by D or by both:
// `lost` covers all of it with 2^70 to spare. Products of two errors, which are left out, and the rounding of the bound
// itself are less than 2^-40 of it; is_good() leaves a hundredth for that.

namespace annulus::inline v1 {

/// The partial sum of a Voronoi cell, times 4 in 2D and 12 in 3D, and a bound of its error, in the unit of
/// circumcentre().
struct Voronoi_sum {
    double volume = 0, error = 0;

    void add(double term, double error_of_term) {
        volume += term;
        error += error_of_term + bounds::u * std::fabs(volume);
    }
    /// Whether that is as accurate as voronoi_volumes promises. False for NaN and after overflow.
    [[nodiscard]] bool is_good() const {
        constexpr double good = 0.99 * voronoi_volume_error;
        return error < good * volume;
    }
};

/// The volume in the caller's unit of length to the d-th power; the unit of `sum` is 2^exponent.
template <int d>
[[nodiscard]] double voronoi_volume(const Voronoi_sum& sum, int exponent) {
    constexpr double parts = d == 2 ? 4 : 12;
    return std::min(std::ldexp(sum.volume / parts, d * exponent), std::numeric_limits<double>::max());
}

/// Computes the terms of facets, cell by cell. Refers to arrays of the caller: positions by vertex, circumcentres by
/// cell, sums by vertex.
///
/// `Cells` gives access to the table or list of cells: corner(c, i), a vertex; beyond(c, i), the cell beyond the facet
/// opposite to it, a number below c where there is none; is_finite(c) of such a cell. A pass over all cells in
/// ascending order adds the terms of every vertex in an order that depends only on the cells around it. So does a pass
/// over some of the cells, if those around the vertex are among them, bit for bit.
template <int d>
class Voronoi_terms {
  public:
    /// `scale` as for circumcentre().
    Voronoi_terms(std::span<const Coordinates<d>> x, std::span<const Circumcentre<d>> centre, double scale,
                  std::span<Voronoi_sum> sum)
        : x_(x), centre_(centre), scale_(scale), sum_(sum) {}

    /// Adds the terms of those facets of a finite cell beyond which there is a finite cell with a larger number.
    template <class Cells>
    void add_facets(const Cells& cells, Index c) const {
        std::array<Index, static_cast<std::size_t>(d + 1)> v;
        for (std::size_t i = 0; i <= d; ++i) v[i] = cells.corner(c, i);
        std::array<Coordinates<d>, static_cast<std::size_t>(d + 1)> edge{};  // from the first corner
        for (std::size_t i = 1; i <= d; ++i) edge[i] = difference(v[0], v[i]);
        for (std::size_t i = 0; i <= d; ++i) {
            const Index n = cells.beyond(c, i);
            if (n < c || !cells.is_finite(n)) continue;
            const auto& facet = facet_corners<d>[i];
            if constexpr (d == 2) add_edge(v, edge[facet[0]], edge[facet[1]], i, centre_[at(c)], n, cells.corner(n, 0));
            else {
                Seen left{centre_[at(c)].offset, centre_[at(c)].error};
                if (i == 0) {
                    for (std::size_t k = 0; k < d; ++k) left.offset[k] -= edge[1][k];
                    left.error += u * (absolute_sum(edge[1]) + absolute_sum(left.offset));
                    add_facet(v, i, difference(v[1], v[2]), difference(v[1], v[3]), left, n, cells.corner(n, 0));
                } else add_facet(v, i, edge[facet[1]], edge[facet[2]], left, n, cells.corner(n, 0));
            }
        }
    }

  private:
    static constexpr double u = bounds::u;
    static constexpr double lost = 0x1p-1000;
    static constexpr double units =
        d == 2 ? bounds::voronoi_2 + 1 : std::max(bounds::voronoi_3_edge, bounds::voronoi_3_facet) + 7;
    using Corners_of = std::array<Index, static_cast<std::size_t>(d + 1)>;
    /// A circumcentre relative to another point, with its error.
    struct Seen {
        Coordinates<d> offset;
        double error;
    };

    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    static double absolute_sum(const Coordinates<d>& x) {
        double sum = std::fabs(x[0]);
        for (std::size_t k = 1; k < d; ++k) sum += std::fabs(x[k]);
        return sum;
    }
    static double largest(const Coordinates<d>& x) {
        double most = std::fabs(x[0]);
        for (std::size_t k = 1; k < d; ++k) most = std::max(most, std::fabs(x[k]));
        return most;
    }
    /// (b - a) in the unit, each coordinate with a relative error of u at most.
    [[nodiscard]] Coordinates<d> difference(Index a, Index b) const {
        return Euclidean<d>::difference(x_[at(b)], x_[at(a)], [this](double p, double q) { return (p - q) * scale_; });
    }
    /// The circumcentre of cell n, whose first corner is `base`, relative to vertex a.
    [[nodiscard]] Seen seen_from(Index a, Index n, Index base) const {
        Seen out{difference(a, base), 0};
        const double far = absolute_sum(out.offset);
        for (std::size_t k = 0; k < d; ++k) out.offset[k] += centre_[at(n)].offset[k];
        out.error = centre_[at(n)].error + u * (far + absolute_sum(out.offset));
        return out;
    }

    /// From p to q, both relative to the first corner; the cell is to the left, n to the right.
    void add_edge(const Corners_of& v, const Coordinates<d>& p, const Coordinates<d>& q, std::size_t i,
                  const Circumcentre<d>& left, Index n, Index base) const {
        const Seen right = seen_from(v[0], n, base);
        Coordinates<d> dual;
        for (std::size_t k = 0; k < d; ++k) dual[k] = right.offset[k] - left.offset[k];
        const Index from = v[facet_corners<d>[i][0]];
        const Index to = v[facet_corners<d>[i][1]];
        Coordinates<d> e;
        if (i == 0) e = difference(from, to);
        else
            for (std::size_t k = 0; k < d; ++k) e[k] = q[k] - p[k];  // one of them is 0
        const double term = dual[0] * e[1] - dual[1] * e[0];
        const double across = largest(dual);
        const double error = largest(e) * (left.error + right.error + units * u * across) + lost * (1 + across);
        sum_[at(from)].add(term, error);
        sum_[at(to)].add(term, error);
    }

    /// The facet opposite to corner i: e and f from its first corner to the others, `left` relative to that corner.
    void add_facet(const Corners_of& v, std::size_t i, const Coordinates<d>& e, const Coordinates<d>& f,
                   const Seen& left, Index n, Index base) const {
        const auto& facet = facet_corners<d>[i];
        const Index a = v[facet[0]];
        const Seen right = seen_from(a, n, base);
        const Coordinates<d>& x = left.offset;
        Coordinates<d> dual;
        for (std::size_t k = 0; k < d; ++k) dual[k] = right.offset[k] - x[k];
        double e_w = 0;
        double f_w = 0;
        double g = 0;
        for (std::size_t k = 0; k < d; ++k) {
            const std::size_t j = (k + 1) % d;
            const std::size_t l = (k + 2) % d;
            const double w = x[j] * dual[l] - x[l] * dual[j];
            e_w += e[k] * w;
            f_w += f[k] * w;
            g += dual[k] * (e[j] * f[l] - e[l] * f[j]);
        }
        const double length_e = largest(e);
        const double length_f = largest(f);
        const double length = length_e + length_f;
        const double far = largest(x);
        const double across = largest(dual);
        const double moved = left.error + right.error;
        const double error = (length * far + length_e * length_f) * (units * u * across + 2 * moved) +
                             length * left.error * (2 * across + moved) + lost * (1 + far) * (1 + across);
        sum_[at(a)].add(e_w - f_w, error);
        sum_[at(v[facet[1]])].add(f_w + g, error);
        sum_[at(v[facet[2]])].add(g - e_w, error);
    }

    std::span<const Coordinates<d>> x_;
    std::span<const Circumcentre<d>> centre_;
    double scale_;
    std::span<Voronoi_sum> sum_;
};

}  // namespace annulus::inline v1
