// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/periodic_places.h>
#include <annulus/measure/periodic_voronoi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace annulus::inline v1 {

namespace {

template <int d>
struct Edge {
    Index first, second;
    Shift<d> shift;
    Coordinates<d> vector;
    double area;
};

template <int d>
double length(const Coordinates<d>& x) {
    if constexpr (d == 2) return std::hypot(x[0], x[1]);
    else return std::hypot(x[0], x[1], x[2]);
}

template <int d>
class Edges {
  public:
    Edges(const Periodic_table<d>& table, const Lattice<d>& lattice, std::span<const Coordinates<d>> place,
          std::span<const Shift<d>> image)
        : table_(table), lattice_(lattice), image_(image), places_(table, lattice, place) {}

    /// Each edge in both directions.
    std::vector<Edge<d>> operator()() {
        for (std::size_t c = 0; c < table_.size(); ++c)
            for (std::size_t a = 0; a <= d; ++a)
                for (std::size_t b = a + 1; b <= d; ++b) visit(c, a, b);
        return std::move(edges_);
    }

  private:
    using Table = Periodic_table<d>;

    /// Takes the edge of these corners if c has the least number of all cells around it.
    void visit(std::size_t c, std::size_t a, std::size_t b) {
        const Image<d> from = table_.image(c, a), to = table_.image(c, b);
        const Coordinates<d> here = places_.at(from);
        Coordinates<d> vector = places_.at(to);
        for (std::size_t i = 0; i < d; ++i) vector[i] -= here[i];
        double area = 0;
        if constexpr (d == 2) {
            const std::size_t i = 3 - a - b;
            const Corner_index t = table_.twin[c][i];
            const std::size_t m = Table::cell_of(t);
            if (m < c) return;
            if (table_.cospherical[c][i] == 0) {
                const Coordinates<2> one = places_.centre(c, {}, here);
                const Coordinates<2> other = places_.centre(m, table_.translation(c, i), here);
                // The facet is perpendicular to the edge: along it a long box would leave its rounding only.
                const double cross = (other[0] - one[0]) * vector[1] - (other[1] - one[1]) * vector[0];
                area = positive(std::fabs(cross) / std::hypot(vector[0], vector[1]));
            }
        } else if (!go_round(c, a, b, here, vector, area)) {
            return;
        }
        const Shift<d> shift = lattice_.in_box(to.label - from.label);
        add(from.vertex, to.vertex, shift, vector, area, 1);
        add(to.vertex, from.vertex, shift, vector, area, -1);
    }

    /// The area of the polygon of circumcentres around an edge; false where a cell has a smaller number than c. The
    /// cells around an edge are different ones (docs/theory.md 8.1), so that the first to come again is c.
    bool go_round(std::size_t c, std::size_t a, std::size_t b, const Coordinates<d>& here, const Coordinates<d>& vector,
                  double& area) const {
        // Leaves through the facet opposite to `leave`; the other one of these two stays.
        std::size_t leave = 0;
        while (leave == a || leave == b) ++leave;
        std::size_t cell = c, stays = 6 - a - b - leave;
        Offset<d> shift;
        int different = 0;
        const Coordinates<d> first = places_.centre(c, {}, here);
        Coordinates<d> last = first, doubled{};
        do {
            const Corner_index t = table_.twin[cell][leave];
            const std::size_t m = Table::cell_of(t);
            if (m < c) return false;
            if (table_.cospherical[cell][leave] == 0) ++different;
            const Image<d> kept = table_.image(cell, stays, shift);
            shift = shift + table_.translation(cell, leave);
            cell = m;
            leave = table_.slot(m, kept, shift);
            stays = Table::slot_of(t);
            const Coordinates<d> next = places_.centre(cell, shift, here);
            for (std::size_t i = 0; i < d; ++i) {
                const std::size_t j = (i + 1) % d, k = (i + 2) % d;
                doubled[i] += (last[j] - first[j]) * (next[k] - first[k]) - (last[k] - first[k]) * (next[j] - first[j]);
            }
            last = next;
        } while (cell != c);
        if (different <= 2) return true;
        double sum = 0;
        for (std::size_t i = 0; i < d; ++i) sum += doubled[i] * vector[i];
        area = positive(std::fabs(sum) / (2 * length<d>(vector)));
        return true;
    }

    /// In the caller's unit. The facet is not empty, whatever its computed area.
    [[nodiscard]] double positive(double area) const {
        return std::max(std::ldexp(area, (d - 1) * places_.exponent()), std::numeric_limits<double>::min());
    }
    /// The shift between representatives as one between the images that the caller gave.
    void add(Index i, Index j, const Shift<d>& shift, const Coordinates<d>& vector, double area, int direction) {
        Edge<d>& e = edges_.emplace_back(Edge<d>{i, j, {}, {}, area});
        for (std::size_t k = 0; k < d; ++k) {
            e.vector[k] = direction * vector[k];
            e.shift[k] =
                direction * shift[k] + image_[static_cast<std::size_t>(i)][k] - image_[static_cast<std::size_t>(j)][k];
        }
    }

    const Periodic_table<d>& table_;
    const Lattice<d>& lattice_;
    std::span<const Shift<d>> image_;
    Periodic_places<d> places_;
    std::vector<Edge<d>> edges_;
};

/// In ascending order: by the first vertex by counting, then each run.
template <int d>
std::vector<Edge<d>> sorted(const std::vector<Edge<d>>& edges, std::size_t vertices) {
    std::vector<std::size_t> begin(vertices + 1, 0);
    for (const Edge<d>& e : edges) ++begin[static_cast<std::size_t>(e.first) + 1];
    for (std::size_t v = 0; v < vertices; ++v) begin[v + 1] += begin[v];
    std::vector<Edge<d>> out(edges.size());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (const Edge<d>& e : edges) out[next[static_cast<std::size_t>(e.first)]++] = e;
    for (std::size_t v = 0; v < vertices; ++v)
        std::sort(out.begin() + static_cast<std::ptrdiff_t>(begin[v]),
                  out.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]), [](const Edge<d>& l, const Edge<d>& r) {
                      return std::tie(l.second, l.shift) < std::tie(r.second, r.shift);
                  });
    return out;
}

}  // namespace

template <int d>
Periodic_neighbours<d> periodic_neighbours(const Periodic_table<d>& table, const Lattice<d>& lattice,
                                           std::span<const Coordinates<d>> place, std::span<const Shift<d>> image) {
    Periodic_neighbours<d> list;
    for (const Edge<d>& e : sorted<d>(Edges<d>(table, lattice, place, image)(), place.size())) {
        list.first.push_back(e.first);
        list.second.push_back(e.second);
        list.shift.push_back(e.shift);
        list.vector.push_back(e.vector);
        list.distance.push_back(length<d>(e.vector));
        list.area.push_back(e.area);
    }
    return list;
}

template Periodic_neighbours<2> periodic_neighbours(const Periodic_table<2>&, const Lattice<2>&,
                                                    std::span<const Coordinates<2>>, std::span<const Shift<2>>);
template Periodic_neighbours<3> periodic_neighbours(const Periodic_table<3>&, const Lattice<3>&,
                                                    std::span<const Coordinates<3>>, std::span<const Shift<3>>);

}  // namespace annulus::inline v1
