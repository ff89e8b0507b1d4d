// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/statistics/voronoi_volumes.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/arithmetic/environment.h>
#include <annulus/statistics/circumcentre.h>
#include <annulus/statistics/voronoi_exact.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

// Let F be a facet of the triangulation between two cells with circumcentres C and C', and n = q - p one of its edges, m a point of
// the line pq. The triangle m, C, C' is in the Voronoi facet of p and q; with signs these triangles, over all F around the edge, add up to it.
// So the pyramids over it with tips p and q, which are alike, are sums of (C left of F and C' right of it, as facet_of has them)
//
//     n . ((C - m) x (C' - m)) / 12     and in the plane     (C' - C) . (n_y, -n_x) / 4,
//
// and these, over all edges at p, add up to the volume of its Voronoi cell. m, which may be any point of the line, is the edge's midpoint
// in doubles, where short vectors are good, and the vertex itself in voronoi_exact.cpp, where nothing is rounded.
//
// Conditioning: a cell with inradius r and surface S has a volume of at least r S / 3, and moving its corners by e changes it by e S,
// so relatively by 3 e / r, where 2 r is the distance of the nearest neighbour. Hence circumcentres, compared with shortest edges, decide.

namespace annulus {

namespace {

constexpr double u = 0x1p-53;
constexpr double lost = 0x1p-1000;  // as in circumcentre.cpp
constexpr double unbounded = std::numeric_limits<double>::infinity();

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

template <std::size_t n>
double absolute_sum(const std::array<double, n>& x) {
    double sum = 0;
    for (const double c : x) sum += std::fabs(c);
    return sum;
}

template <int d>
class Voronoi_volumes {
  public:
    Voronoi_volumes(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells) : x_(points), cells_(cells) {}

    std::vector<double> operator()(Voronoi_counts& counts) {
        const bool spans = find_hull();
        volume_.assign(x_.size(), 0.0);
        error_.assign(x_.size(), unbounded);  // where nothing is added, all of it is left to integers
        if (spans) {
            find_circumcentres();
            if (!centre_.empty()) add_facets();
        }
        finish(counts);
        return std::move(volume_);
    }

  private:
    using Cell = std::array<Index, static_cast<std::size_t>(d + 1)>;
    enum class Where : char { nowhere, hull, inside };

    void require_whole(const Cell& neighbours) const {
        for (const Index n : neighbours)
            if (n != cells_.outside && (n < 0 || at(n) >= cells_.vertices.size()))
                throw Error(Error_code::bad_input,
                            "there is no cell " + std::to_string(n) + " that could be a neighbour");
    }

    /// What each vertex is, and the unit. False where no cell has d + 1 corners.
    bool find_hull() {
        if (cells_.neighbours.size() != cells_.vertices.size())
            throw Error(Error_code::wrong_size, "there are neighbours of " + std::to_string(cells_.neighbours.size()) +
                                                    " cells for " + std::to_string(cells_.vertices.size()) + " cells");
        where_.assign(x_.size(), Where::nowhere);
        double largest = 0;
        bool flat = false;
        for (std::size_t c = 0; c < cells_.vertices.size(); ++c) {
            const Cell& cell = cells_.vertices[c];
            require_whole(cells_.neighbours[c]);
            const bool padded = cell[d] == none;
            flat = flat || padded;
            for (const Index v : cell) {
                if (padded && v == none) continue;
                if (v < 0 || at(v) >= x_.size())
                    throw Error(Error_code::unknown_vertex,
                                "a cell names vertex " + std::to_string(v) + " of " + std::to_string(x_.size()));
                if (where_[at(v)] != Where::nowhere) continue;
                require_in_domain(x_[at(v)]);
                for (const double k : x_[at(v)]) largest = std::max(largest, std::fabs(k));
                where_[at(v)] = Where::inside;
            }
            for (std::size_t i = 0; i <= d; ++i) {
                if (!padded && cells_.neighbours[c][i] != cells_.outside) continue;
                for (std::size_t k = 0; k <= d; ++k)
                    if (cell[k] != none && (padded || k != i)) where_[at(cell[k])] = Where::hull;
            }
        }
        if (flat) std::replace(where_.begin(), where_.end(), Where::inside, Where::hull);
        exponent_ = largest == 0 ? 0 : std::ilogb(largest) + 1;
        return !flat;
    }

    void find_circumcentres() {
        const double scale = std::ldexp(1.0, -exponent_);
        if (!std::isnormal(scale)) return;  // every coordinate is subnormal
        centre_.resize(cells_.vertices.size());
        for (std::size_t c = 0; c < centre_.size(); ++c) {
            Corners<d> corners;
            for (std::size_t i = 0; i <= d; ++i) corners[i] = x_[at(cells_.vertices[c][i])];
            centre_[c] = circumcentre<d>(corners, scale);
        }
    }

    /// (b - a) in the unit, each coordinate within u of it, relatively.
    Coordinates<d> difference(Index a, Index b, double scale) const {
        Coordinates<d> out;
        for (std::size_t k = 0; k < d; ++k) out[k] = (x_[at(b)][k] - x_[at(a)][k]) * scale;
        return out;
    }

    void add_facets() {
        std::fill(error_.begin(), error_.end(), 0.0);
        const double scale = std::ldexp(1.0, -exponent_);
        for (std::size_t c = 0; c < cells_.vertices.size(); ++c)
            for (std::size_t i = 0; i <= d; ++i) {
                const Index n = cells_.neighbours[c][i];
                if (n == cells_.outside || at(n) < c) continue;
                const Cell& cell = cells_.vertices[c];
                for (std::size_t e = 0; e < (d == 2 ? 1 : 3); ++e)
                    add(cell[facet_of<d>[i][e]], cell[facet_of<d>[i][(e + 1) % d]], c, at(n), scale);
            }
    }

    /// The terms of edge pq between two cells, without their denominator. An offset and its error, as circumcentre() has them, are carried on in sums of absolutes.
    void add(Index p, Index q, std::size_t left, std::size_t right, double scale) {
        const Coordinates<d> n = difference(p, q, scale);
        const double length = absolute_sum(n);
        double term = 0;
        double error = 0;
        if constexpr (d == 2) {
            const Coordinates<d> step = difference(cells_.vertices[left][0], cells_.vertices[right][0], scale);
            Coordinates<d> dual;
            for (std::size_t k = 0; k < d; ++k)
                dual[k] = step[k] + (centre_[right].offset[k] - centre_[left].offset[k]);
            // u each for step, the inner difference, the sum.
            const double moved =
                centre_[left].error + centre_[right].error +
                4 * u * (absolute_sum(step) + absolute_sum(centre_[left].offset) + absolute_sum(centre_[right].offset));
            term = dual[0] * n[1] - dual[1] * n[0];
            error = length * (moved + 4 * u * absolute_sum(dual));  // n, product, difference: 3 u
        } else {
            double error_of_from = 0;
            double error_of_to = 0;
            const Coordinates<d> from = seen_from_middle(p, n, left, scale, error_of_from);
            const Coordinates<d> to = seen_from_middle(p, n, right, scale, error_of_to);
            for (std::size_t k = 0; k < d; ++k) {
                const std::size_t i = (k + 1) % 3;
                const std::size_t j = (k + 2) % 3;
                term += n[k] * (from[i] * to[j] - from[j] * to[i]);
            }
            const double far_from = absolute_sum(from);
            const double far_to = absolute_sum(to);
            // n 1, a minor 2, times n 1, sums 2: 8 u is used.
            error = length *
                    (far_from * (error_of_to + 8 * u * far_to) + far_to * error_of_from + error_of_from * error_of_to);
        }
        error += lost;
        for (const Index v : {p, q}) {
            volume_[at(v)] += term;
            error_[at(v)] += error + u * std::fabs(volume_[at(v)]);
        }
    }

    /// The circumcentre of a cell less the midpoint of the edge that begins at p; u each for the two differences (n is halved), the sums.
    Coordinates<d> seen_from_middle(Index p, const Coordinates<d>& n, std::size_t cell, double scale,
                                    double& error) const {
        const Coordinates<d> base = difference(p, cells_.vertices[cell][0], scale);
        Coordinates<d> out;
        for (std::size_t k = 0; k < d; ++k) out[k] = (base[k] - n[k] / 2) + centre_[cell].offset[k];
        error = centre_[cell].error + 3 * u * (absolute_sum(base) + absolute_sum(n) + absolute_sum(out));
        return out;
    }

    /// Takes the unit back where a sum is good enough, computes what is not from exact circumcentres, and says what is unbounded or no cell.
    void finish(Voronoi_counts& counts) {
        constexpr double good = 0.99 * voronoi_volume_error;  // sums of errors are rounded, too
        constexpr double parts = d == 2 ? 4 : 12;
        std::vector<Index> poor;
        for (std::size_t v = 0; v < x_.size(); ++v) {
            if (where_[v] != Where::inside) {
                volume_[v] = where_[v] == Where::hull ? unbounded : std::numeric_limits<double>::quiet_NaN();
                continue;
            }
            ++counts.bounded;
            if (error_[v] < good * volume_[v])  // false for what is no number, and for what has overflowed
                volume_[v] = std::min(std::ldexp(volume_[v] / parts, d * exponent_), std::numeric_limits<double>::max());
            else poor.push_back(static_cast<Index>(v));
        }
        counts.exact = poor.size();
        if (!poor.empty()) compute_exactly(poor);
    }

    void compute_exactly(std::span<const Index> poor) {
        // Where the cells around a vertex end, among those around all of these; then where they begin.
        std::vector<std::size_t> end(x_.size(), 0);
        std::vector<char> wanted(x_.size(), 0);
        for (const Index v : poor) wanted[at(v)] = 1;
        for (const Cell& cell : cells_.vertices)
            for (const Index v : cell) end[at(v)] += static_cast<std::size_t>(wanted[at(v)]);
        std::size_t total = 0;
        for (const Index v : poor) end[at(v)] = total += end[at(v)];
        std::vector<std::size_t> around(total);
        for (std::size_t c = cells_.vertices.size(); c-- > 0;)
            for (const Index v : cells_.vertices[c])
                if (wanted[at(v)] != 0) around[--end[at(v)]] = c;
        for (std::size_t k = 0; k < poor.size(); ++k) {
            const std::size_t begin = end[at(poor[k])];
            const std::size_t next = k + 1 < poor.size() ? end[at(poor[k + 1])] : total;
            volume_[at(poor[k])] = exact_voronoi_volume<d>(
                x_, cells_, poor[k], std::span<const std::size_t>(around).subspan(begin, next - begin));
        }
    }

    std::span<const Coordinates<d>> x_;
    const Mesh_cells<d>& cells_;
    int exponent_ = 0;  // of the unit: every coordinate is below 2^exponent
    std::vector<Where> where_;
    std::vector<Circumcentre<d>> centre_;
    std::vector<double> volume_, error_;  // in the unit and times 4 or 12, until finish()
};

}  // namespace

template <int d>
std::vector<double> voronoi_volumes(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells,
                                    Voronoi_counts* counts) {
    require_sound_environment();
    Voronoi_counts counted;
    std::vector<double> volumes = Voronoi_volumes<d>(points, cells)(counted);
    if (counts != nullptr) *counts = counted;
    return volumes;
}

template std::vector<double> voronoi_volumes<2>(std::span<const Coordinates<2>>, const Mesh_cells<2>&, Voronoi_counts*);
template std::vector<double> voronoi_volumes<3>(std::span<const Coordinates<3>>, const Mesh_cells<3>&, Voronoi_counts*);

}  // namespace annulus
