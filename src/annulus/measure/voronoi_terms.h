// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/circumcentre.h>
#include <annulus/measure/inner_facets.h>
#include <annulus/predicate/bounds.h>
#include <annulus/space/euclidean.h>
#include <annulus/voronoi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
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

/// Converts sums in the unit 2^exponent to volumes in the caller's unit of length to the d-th power.
template <int d>
class Volume_unit {
  public:
    explicit Volume_unit(int exponent)
        : exponent_(d * exponent), factor_(std::ldexp(1.0, std::clamp(exponent_, -1022, 1023))) {}

    [[nodiscard]] double volume(const Voronoi_sum& sum) const {
        constexpr double parts = d == 2 ? 4 : 12;
        const double x = sum.volume / parts;
        // The same number if the factor is 2^exponent: each rounds once, and only where x is subnormal or too large.
        const bool is_factor = std::abs(exponent_) < 1022;
        return std::min(is_factor ? x * factor_ : std::ldexp(x, exponent_), std::numeric_limits<double>::max());
    }

  private:
    int exponent_;
    double factor_;  // 2^exponent_ where that is a normal number
};

/// Computes the terms of facets. Refers to arrays of the caller: positions by vertex, circumcentres by cell, sums by
/// vertex.
///
/// A pass over all cells in ascending order adds the terms of every vertex in an order that depends only on the cells
/// around it. So does a pass over some of the cells, if those around the vertex are among them, bit for bit.
template <int d>
class Voronoi_terms {
  public:
    /// `scale` as for circumcentre().
    Voronoi_terms(std::span<const Coordinates<d>> x, std::span<const Circumcentre<d>> centre, double scale,
                  std::span<Voronoi_sum> sum)
        : x_(x), centre_(centre), scale_(scale), sum_(sum) {}

    /// Adds the terms of the facets that for_each_inner_facet(cells, numbers) visits.
    template <class Cells, class Numbers>
    void add_facets(const Cells& cells, const Numbers& numbers) const {
        for_each_inner_facet<d>(cells, numbers, [this](const Inner_facet<d>& f) {
            if constexpr (d == 2) add_edge(f);
            else add_facet(f);
        });
    }

  private:
    static constexpr double u = bounds::u;
    static constexpr double lost = 0x1p-1000;
    static constexpr double units =
        d == 2 ? bounds::voronoi_2 + 1 : std::max(bounds::voronoi_3_edge, bounds::voronoi_3_facet) + 7;
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
    /// The circumcentre of a cell relative to vertex a.
    [[nodiscard]] Seen seen_from(Index a, Index cell, Index first) const {
        Seen out{difference(a, first), 0};
        const double far = absolute_sum(out.offset);
        for (std::size_t k = 0; k < d; ++k) out.offset[k] += centre_[at(cell)].offset[k];
        out.error = centre_[at(cell)].error + u * (far + absolute_sum(out.offset));
        return out;
    }

    void add_edge(const Inner_facet<d>& f) const {
        const Circumcentre<d>& left = centre_[at(f.cell)];
        const Seen right = seen_from(f.first, f.beyond, f.first_beyond);
        Coordinates<d> dual;
        for (std::size_t k = 0; k < d; ++k) dual[k] = right.offset[k] - left.offset[k];
        const Coordinates<d> e = difference(f.corners[0], f.corners[1]);
        const double term = dual[0] * e[1] - dual[1] * e[0];
        const double across = largest(dual);
        const double error = largest(e) * (left.error + right.error + units * u * across) + lost * (1 + across);
        sum_[at(f.corners[0])].add(term, error);
        sum_[at(f.corners[1])].add(term, error);
    }

    void add_facet(const Inner_facet<d>& facet) const {
        const Index a = facet.corners[0];
        const Coordinates<d> e = difference(a, facet.corners[1]);
        const Coordinates<d> f = difference(a, facet.corners[2]);
        const Seen left = seen_from(a, facet.cell, facet.first);
        const Seen right = seen_from(a, facet.beyond, facet.first_beyond);
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
        sum_[at(facet.corners[1])].add(f_w + g, error);
        sum_[at(facet.corners[2])].add(g - e_w, error);
    }

    std::span<const Coordinates<d>> x_;
    std::span<const Circumcentre<d>> centre_;
    double scale_;
    std::span<Voronoi_sum> sum_;
};

}  // namespace annulus::inline v1
