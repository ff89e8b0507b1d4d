// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/periodic_facets.h>
#include <annulus/measure/periodic_rings.h>
#include <annulus/measure/periodic_voronoi.h>
#include <annulus/measure/saturated.h>

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
        : table_(table), lattice_(lattice), image_(image), facets_(table, lattice, place) {}

    /// Each edge in both directions.
    std::vector<Edge<d>> operator()() {
        Periodic_rings<d>(table_).for_each([this](const Periodic_ring<d>& ring) { add(ring); });
        return std::move(edges_);
    }

  private:
    void add(const Periodic_ring<d>& ring) {
        const Periodic_facet<d> facet = facets_.facet_of(ring);
        const double area = ring.empty ? 0 : in_callers_unit(facet);
        const Shift<d> shift = lattice_.in_box(ring.to.label);
        add(ring.from.vertex, ring.to.vertex, shift, facet.vector, area, 1);
        add(ring.to.vertex, ring.from.vertex, shift, facet.vector, area, -1);
    }
    /// The measure of a facet that is not empty, whatever can be represented.
    [[nodiscard]] static double in_callers_unit(const Periodic_facet<d>& facet) {
        const long double unit = std::ldexp(1.0L, facet.exponent);
        const long double measure = d == 2 ? facet.measure * unit : facet.measure * unit * unit;
        return saturated(std::max<long double>(measure, std::numeric_limits<double>::min()));
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
    Periodic_facets<d> facets_;
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
