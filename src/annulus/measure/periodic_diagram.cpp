// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/periodic_diagram.h>

#include <annulus/measure/periodic_facets.h>
#include <annulus/measure/periodic_rings.h>
#include <annulus/measure/voronoi_records.h>
#include <annulus/mesh/at.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

namespace {

template <int d>
Shift<d> plus(Shift<d> a, const Shift<d>& b, int sign = 1) {
    for (std::size_t k = 0; k < d; ++k) a[k] += sign * b[k];
    return a;
}

/// The Voronoi vertex of each cell, as an image of that of the least cell that has exactly the same circumcentre and is
/// connected to it by such cells. No chain of them leads from a cell to another image of it: that has another
/// circumcentre.
template <int d>
class Vertices {
  public:
    explicit Vertices(const Periodic_table<d>& table) : table_(table), first_(table.size(), none), seen_(table.size()) {
        std::vector<std::size_t> open;
        for (std::size_t c = 0; c < table.size(); ++c) {
            if (first_[c] != none) continue;
            first_[c] = static_cast<Index>(c);
            open.push_back(c);
            while (!open.empty()) {
                const std::size_t here = open.back();
                open.pop_back();
                for (std::size_t i = 0; i <= d; ++i) {
                    const std::size_t beyond = table.cell_of(table.twin[here][i]);
                    if (table.cospherical[here][i] == 0 || first_[beyond] != none) continue;
                    first_[beyond] = static_cast<Index>(c);
                    seen_[beyond] = seen_[here] + table.translation(here, i);
                    open.push_back(beyond);
                }
            }
        }
    }
    [[nodiscard]] Index first(std::size_t c) const { return first_[c]; }
    /// The offset of cell c, moved by `shift`, as that of the first cell: the vertex of both is the same one then.
    [[nodiscard]] Offset<d> shift_of_first(std::size_t c, Offset<d> shift) const { return shift - seen_[c]; }
    [[nodiscard]] std::vector<Index> take_first() { return std::move(first_); }

  private:
    const Periodic_table<d>& table_;
    std::vector<Index> first_;
    std::vector<Offset<d>>
        seen_;  // by cell: what is added to its offsets, so that the first cell sees it beside itself
};

template <int d>
class Diagram {
  public:
    explicit Diagram(const Periodic_state<d>& state)
        : state_(state),
          facets_(state.table, state.lattice, state.place),
          vertices_(state.table),
          found_(state.given, facets_.exponent(), state.place.size() * (d == 2 ? 3 : 8)) {
        Periodic_rings<d>(state.table).for_each([this](const Periodic_ring<d>& ring) { add(ring); });
        write_facets();
        list_vertices();
        measure_cells();
    }
    Periodic_voronoi_diagram<d> take() { return std::move(out_); }

  private:
    /// Which image of the point at one end of a ring the other end is, where the first is the point as it was given.
    [[nodiscard]] Shift<d> shift_of(const Periodic_ring<d>& ring) const {
        return plus<d>(state_.shift(ring.to, true), state_.image[at(ring.from.vertex)]);
    }

    void add(const Periodic_ring<d>& ring) {
        if (std::pair(ring.from.vertex, Shift<d>{}) > std::pair(ring.to.vertex, shift_of(ring)))
            add_ordered(ring.reversed(memory_));
        else add_ordered(ring);
    }
    void add_ordered(const Periodic_ring<d>& ring) {
        const Shift<d>& image = state_.image[at(ring.from.vertex)];
        numbers_.clear();
        for (std::size_t k = 0; k < ring.cells.size(); ++k) {
            // In 2D the first cell is on the left of the edge.
            const auto& [c, shift] = ring.cells[d == 2 ? 1 - k : k];
            const Index first = vertices_.first(c);
            numbers_.push_back(first);
            const Shift<d> of_first = state_.lattice.in_box(vertices_.shift_of_first(c, shift));
            ring_shifts_.push_back(plus<d>(plus<d>(of_first, image), state_.least_shift(at(first), true)));
        }
        Periodic_facet<d> facet = facets_.facet_of(ring);
        if (facet.empty) facet.centroid.fill(std::numeric_limits<double>::quiet_NaN());
        found_.add(facet, numbers_);
        shifts_.push_back(shift_of(ring));
    }

    void write_facets() {
        const auto found = found_.records();
        const auto order = found_.in_order([&](std::size_t a, std::size_t b) {
            return std::tie(found[a].j, shifts_[a]) < std::tie(found[b].j, shifts_[b]);
        });
        reserve_facets(out_, found.size(), found_.length_of_rings());
        out_.ring_begin.push_back(0);
        for (const std::size_t k : order) {
            const Facet_record<d>& f = found[k];
            out_.pair.push_back({f.i, f.j});
            out_.shift.push_back(shifts_[k]);
            found_.write(f, out_);
            const auto ring = std::span(ring_shifts_).subspan(f.ring_begin, f.ring_size);
            out_.ring_shift.insert(out_.ring_shift.end(), ring.begin(), ring.end());
        }
    }

    void measure_cells() {
        const auto& place = state_.place;
        out_.volume.resize(place.size());
        out_.surface.resize(place.size());
        out_.cell_centroid.resize(place.size());
        for (std::size_t v = 0; v < place.size(); ++v)
            found_.write_cell(v, is_place<d>(place[v]) ? Vertex_location::inside : Vertex_location::nowhere, out_);
    }

    void list_vertices() {
        const std::size_t n = state_.table.size();
        out_.vertex.resize(n);
        out_.vertex_shift.resize(n);
        for (std::size_t c = 0; c < n; ++c) {
            const Index first = vertices_.first(c);
            const Shift<d> least = state_.least_shift(c, true);
            const Shift<d> of_first = state_.lattice.in_box(vertices_.shift_of_first(c, {}));
            out_.vertex_shift[c] = plus<d>(plus<d>(of_first, state_.least_shift(at(first), true)), least, -1);
            out_.vertex[c] = vertex(at(first), vertices_.shift_of_first(c, {}), least);
        }
        out_.vertex_of_cell = vertices_.take_first();
    }
    /// The circumcentre of a cell, moved by an offset, less a shift by the vectors of the box; rounded once, or twice
    /// where long double is double.
    [[nodiscard]] Coordinates<d> vertex(std::size_t c, Offset<d> offset, const Shift<d>& less) const {
        const Coordinates<d> base = facets_.places().at(state_.table.image(c, 0, offset));
        const Coordinates<d>& centre = facets_.places().centres()[c].offset;
        Coordinates<d> out;
        for (std::size_t k = 0; k < d; ++k) {
            long double x = 0;
            for (std::size_t j = 0; j < d; ++j) x -= static_cast<long double>(less[j]) * state_.lattice.box()[j][k];
            x += static_cast<long double>(base[k]) + std::ldexp(centre[k], facets_.exponent());
            out[k] = static_cast<double>(x);
        }
        return out;
    }

    const Periodic_state<d>& state_;
    Periodic_facets<d> facets_;
    Vertices<d> vertices_;
    Facet_records<d> found_;
    std::vector<Shift<d>> shifts_;       // by record
    std::vector<Shift<d>> ring_shifts_;  // as the rings of the records
    std::vector<Index> numbers_;
    std::vector<typename Periodic_ring<d>::Cell> memory_;
    Periodic_voronoi_diagram<d> out_;
};

}  // namespace

template <int d>
Periodic_voronoi_diagram<d> periodic_voronoi_diagram(const Periodic_state<d>& state) {
    return Diagram<d>(state).take();
}

template Periodic_voronoi_diagram<2> periodic_voronoi_diagram(const Periodic_state<2>&);
template Periodic_voronoi_diagram<3> periodic_voronoi_diagram(const Periodic_state<3>&);

}  // namespace annulus::inline v1
