// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/periodic_lloyd.h>

#include <annulus/measure/circumcentre.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// A cell with its corners in a canonical order, and what is beyond its facets.
template <int d>
struct Canonical_cell {
    template <class T>
    using By_corner = std::array<T, static_cast<std::size_t>(d + 1)>;
    By_corner<std::pair<Index, Shift<d>>> corner;
    By_corner<Index> beyond;
    By_corner<Shift<d>> translation;
};

/// The cells in a canonical order: corners ascend, but for the last two where that keeps the orientation.
template <int d>
std::vector<Canonical_cell<d>> canonical_cells(const Periodic_cells<d>& cells) {
    const std::size_t count = cells.vertices.size();
    std::vector<Canonical_cell<d>> out(count);
    for (std::size_t c = 0; c < count; ++c) {
        Canonical_cell<d>& cell = out[c];
        for (std::size_t i = 0; i <= d; ++i) {
            cell.corner[i] = {cells.vertices[c][i], cells.offsets[c][i]};
            cell.beyond[i] = cells.neighbours[c][i];
            cell.translation[i] = cells.translations[c][i];
        }
        const auto swap = [&cell](std::size_t i, std::size_t j) {
            std::swap(cell.corner[i], cell.corner[j]);
            std::swap(cell.beyond[i], cell.beyond[j]);
            std::swap(cell.translation[i], cell.translation[j]);
        };
        bool odd = false;
        for (std::size_t i = 1; i <= d; ++i)
            for (std::size_t j = i; j > 0 && cell.corner[j] < cell.corner[j - 1]; --j, odd = !odd) swap(j, j - 1);
        if (odd) swap(d - 1, d);
    }
    std::vector<std::size_t> order(count), rank(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return out[a].corner < out[b].corner; });
    for (std::size_t k = 0; k < count; ++k) rank[order[k]] = k;
    std::vector<Canonical_cell<d>> sorted;
    sorted.reserve(count);
    for (const std::size_t c : order) {
        sorted.push_back(out[c]);
        for (Index& beyond : sorted.back().beyond) beyond = static_cast<Index>(rank[static_cast<std::size_t>(beyond)]);
    }
    return sorted;
}

/// Sums of the first moments of Voronoi cells about their vertices, in a unit in which the box is below 1.
template <int d>
class Periodic_centroids {
  public:
    explicit Periodic_centroids(const Periodic_audit_input<d>& mesh)
        : mesh_(mesh),
          cell_(canonical_cells<d>(mesh.cells)),
          volume_(mesh.points.size()),
          moment_(mesh.points.size()),
          centre_(cell_.size()) {
        double extent = 0;
        for (std::size_t k = 0; k < d; ++k) {
            double sum = 0;
            for (const Coordinates<d>& vector : mesh.box) sum += std::fabs(vector[k]);
            extent = std::max(extent, sum);
        }
        exponent_ = std::ilogb(extent) + 4;  // a cell is at most twice as large as a box
    }

    std::vector<Coordinates<d>> operator()() {
        for (std::size_t c = 0; c < cell_.size(); ++c) {
            Corners<d> x{};
            for (std::size_t i = 1; i <= d; ++i) x[i] = from_to(c, 0, cell_[c].corner[i]);
            centre_[c] = circumcentre<d>(x, 1.0).offset;
        }
        for (std::size_t c = 0; c < cell_.size(); ++c)
            for (std::size_t i = 0; i <= d; ++i)
                if (at(cell_[c].beyond[i]) > c) add_facet(c, i);
        std::vector<Coordinates<d>> offset(volume_.size());
        for (std::size_t v = 0; v < offset.size(); ++v)
            for (std::size_t k = 0; k < d; ++k) offset[v][k] = moment_[v][k] / ((d + 1) * volume_[v]);
        replace_those_outside(offset);
        for (Coordinates<d>& o : offset)
            for (double& x : o) x = std::ldexp(x, exponent_);
        return offset;
    }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    static Coordinates<d> difference(const Coordinates<d>& a, const Coordinates<d>& b) {
        Coordinates<d> out;
        for (std::size_t k = 0; k < d; ++k) out[k] = a[k] - b[k];
        return out;
    }
    /// The corners of the facet opposite to corner i: the cell is to their left.
    static constexpr auto facet_of(std::size_t i) {
        if constexpr (d == 2) return std::array<std::size_t, 2>{(i + 1) % 3, (i + 2) % 3};
        else {
            constexpr std::array<std::array<std::size_t, 3>, 4> corners{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
            return corners[i];
        }
    }
    /// In the unit, from a corner of cell c to an image in the frame of that cell: without rounding, wherever in the
    /// lattice the frame is.
    [[nodiscard]] Coordinates<d> from_to(std::size_t c, std::size_t i, std::pair<Index, Shift<d>> to) const {
        const auto& [v, shift] = cell_[c].corner[i];
        Coordinates<d> out;
        for (std::size_t k = 0; k < d; ++k) {
            long double x = mesh_.points[at(to.first)][k];
            x -= mesh_.points[at(v)][k];
            for (std::size_t j = 0; j < d; ++j)
                x += static_cast<long double>(to.second[j] - shift[j]) * mesh_.box[j][k];
            out[k] = static_cast<double>(std::ldexp(x, -exponent_));
        }
        return out;
    }
    /// The circumcentre beyond facet i of cell c, from corner `from` of c.
    [[nodiscard]] Coordinates<d> centre_beyond(std::size_t c, std::size_t i, std::size_t from) const {
        const std::size_t n = at(cell_[c].beyond[i]);
        auto base = cell_[n].corner[0];
        for (std::size_t j = 0; j < d; ++j) base.second[j] += cell_[c].translation[i][j];
        Coordinates<d> out = from_to(c, from, base);
        for (std::size_t k = 0; k < d; ++k) out[k] += centre_[n][k];
        return out;
    }
    /// The circumcentre of cell c, from one of its corners.
    [[nodiscard]] Coordinates<d> centre_from(std::size_t c, std::size_t from) const {
        return difference(centre_[c], from_to(c, 0, cell_[c].corner[from]));
    }
    /// A simplex of this volume, times 4 in 2D and 12 in 3D, at a corner of cell c; `sum` is that of its other corners,
    /// relative to that one.
    void add(std::size_t c, std::size_t corner, double volume, const Coordinates<d>& sum) {
        const std::size_t v = at(cell_[c].corner[corner].first);
        volume_[v] += volume;
        for (std::size_t k = 0; k < d; ++k) moment_[v][k] += volume * sum[k];
    }
    void add_facet(std::size_t c, std::size_t i) {
        const auto facet = facet_of(i);
        const Coordinates<d> x = centre_from(c, facet[0]), y = centre_beyond(c, i, facet[0]), dual = difference(y, x);
        const Coordinates<d> e = from_to(c, facet[0], cell_[c].corner[facet[1]]);
        if constexpr (d == 2) {
            const double term = dual[0] * e[1] - dual[1] * e[0];
            Coordinates<d> near, far;
            for (std::size_t k = 0; k < d; ++k) {
                near[k] = x[k] + y[k];
                far[k] = near[k] - 2 * e[k];
            }
            add(c, facet[0], term, near);
            add(c, facet[1], term, far);
        } else {
            const Coordinates<d> f = from_to(c, facet[0], cell_[c].corner[facet[2]]);
            double e_w = 0, f_w = 0, g = 0;
            for (std::size_t k = 0; k < d; ++k) {
                const std::size_t j = (k + 1) % d, l = (k + 2) % d;
                const double w = x[j] * dual[l] - x[l] * dual[j];
                e_w += e[k] * w;
                f_w += f[k] * w;
                g += dual[k] * (e[j] * f[l] - e[l] * f[j]);
            }
            // Relative to each of the three corners: the two circumcentres and the midpoint of the edge.
            const std::array<double, 3> of_edge{e_w, f_w - e_w + g, -f_w};
            const std::array<Coordinates<d>, 3> corner{Coordinates<d>{}, e, f};
            for (std::size_t a = 0; a < 3; ++a)
                for (const std::size_t edge : {a, (a + 2) % 3}) {  // edge b is from corner b to the next
                    const std::size_t b = edge == a ? (a + 1) % 3 : edge;
                    Coordinates<d> sum;
                    for (std::size_t k = 0; k < d; ++k)
                        sum[k] = (x[k] - corner[a][k]) + (y[k] - corner[a][k]) + (corner[b][k] - corner[a][k]) / 2;
                    add(c, facet[a], of_edge[edge], sum);
                }
        }
    }
    /// Every Voronoi cell contains its centroid: it is nearer to its vertex than to any neighbour.
    void replace_those_outside(std::vector<Coordinates<d>>& offset) const {
        std::vector<char> beyond(offset.size(), 0);
        for (std::size_t c = 0; c < cell_.size(); ++c)
            for (std::size_t i = 0; i <= d; ++i)
                for (std::size_t j = 0; j <= d; ++j) {
                    if (j == i) continue;
                    const std::size_t v = at(cell_[c].corner[i].first);
                    const Coordinates<d> way = from_to(c, i, cell_[c].corner[j]);
                    double along = 0, square = 0;
                    for (std::size_t k = 0; k < d; ++k) {
                        along += offset[v][k] * way[k];
                        square += way[k] * way[k];
                    }
                    if (!(2 * along < square)) beyond[v] = 1;
                }
        if (std::find(beyond.begin(), beyond.end(), 1) == beyond.end()) return;
        std::vector<std::size_t> count(offset.size(), 0);
        for (std::size_t v = 0; v < offset.size(); ++v)
            if (beyond[v] != 0) offset[v] = {};
        for (std::size_t c = 0; c < cell_.size(); ++c)
            for (std::size_t i = 0; i <= d; ++i) {
                const std::size_t v = at(cell_[c].corner[i].first);
                if (beyond[v] == 0) continue;
                const Coordinates<d> x = centre_from(c, i);
                ++count[v];
                for (std::size_t k = 0; k < d; ++k) offset[v][k] += x[k];
            }
        for (std::size_t v = 0; v < offset.size(); ++v)
            for (std::size_t k = 0; beyond[v] != 0 && k < d; ++k) offset[v][k] /= static_cast<double>(count[v]);
    }

    const Periodic_audit_input<d>& mesh_;
    std::vector<Canonical_cell<d>> cell_;
    std::vector<double> volume_;
    std::vector<Coordinates<d>> moment_;
    std::vector<Coordinates<d>> centre_;  // of each cell, from its first corner
    int exponent_ = 0;
};

}  // namespace

template <int d>
std::vector<Coordinates<d>> periodic_centroid_offsets(const Periodic_audit_input<d>& mesh) {
    return Periodic_centroids<d>(mesh)();
}

template std::vector<Coordinates<2>> periodic_centroid_offsets(const Periodic_audit_input<2>&);
template std::vector<Coordinates<3>> periodic_centroid_offsets(const Periodic_audit_input<3>&);

}  // namespace annulus::inline v1
