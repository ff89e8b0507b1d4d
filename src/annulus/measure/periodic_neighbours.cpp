// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/periodic_places.h>
#include <annulus/measure/periodic_rings.h>
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
        Periodic_rings<d>(table_).for_each([this](const Periodic_ring<d>& ring) { add(ring); });
        return std::move(edges_);
    }

  private:
    void add(const Periodic_ring<d>& ring) {
        const Coordinates<d> here = places_.at(ring.from);
        Coordinates<d> vector = places_.at(ring.to);
        for (std::size_t i = 0; i < d; ++i) vector[i] -= here[i];
        const double area = ring.empty ? 0 : positive(area_of(ring, here, vector));
        const Shift<d> shift = lattice_.in_box(ring.to.label);
        add(ring.from.vertex, ring.to.vertex, shift, vector, area, 1);
        add(ring.to.vertex, ring.from.vertex, shift, vector, area, -1);
    }

    /// Of the polygon of the circumcentres around the edge `vector` from `here`.
    double area_of(const Periodic_ring<d>& ring, const Coordinates<d>& here, const Coordinates<d>& vector) const {
        const auto centre = [&](std::size_t k) {
            return places_.centre(ring.cells[k].number, ring.cells[k].shift, here);
        };
        const Coordinates<d> first = centre(0);
        Coordinates<d> last = centre(1);
        if constexpr (d == 2) {
            // The facet is perpendicular to the edge: along it a long box would leave its rounding only.
            const double cross = (last[0] - first[0]) * vector[1] - (last[1] - first[1]) * vector[0];
            return std::fabs(cross) / std::hypot(vector[0], vector[1]);
        } else {
            Coordinates<d> doubled{};
            for (std::size_t c = 2; c < ring.cells.size(); ++c) {
                const Coordinates<d> next = centre(c);
                for (std::size_t i = 0; i < d; ++i) {
                    const std::size_t j = (i + 1) % d, k = (i + 2) % d;
                    doubled[i] +=
                        (last[j] - first[j]) * (next[k] - first[k]) - (last[k] - first[k]) * (next[j] - first[j]);
                }
                last = next;
            }
            double sum = 0;
            for (std::size_t i = 0; i < d; ++i) sum += doubled[i] * vector[i];
            return std::fabs(sum) / (2 * length<d>(vector));
        }
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
