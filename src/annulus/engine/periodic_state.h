// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <annulus/mesh/periodic_table.h>
#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// Points of a periodic box, by number. At free indices given and place are NaN, and images 0.
template <int d>
struct Placed_points {
    std::vector<Coordinates<d>> given;
    std::vector<Coordinates<d>> place;
    std::vector<Shift<d>> image;
};

/// A vertex, and where it is to be.
template <int d>
struct Vertex_move {
    Index vertex;
    Representative<d> to;
};

/// indices[k] to any image of points[k]: by index, each once; if one is named twice, its last point counts. Throws what
/// Lattice::representative throws, naming indices. O(k log k).
template <int d>
[[nodiscard]] std::vector<Vertex_move<d>> vertex_moves(const Lattice<d>& lattice, std::span<const Index> indices,
                                                       std::span<const Coordinates<d>> points);

/// A triangulation in a periodic box and what it is of, by the caller's indices.
template <int d>
struct Periodic_state : Placed_points<d> {
    using Placed_points<d>::given, Placed_points<d>::place, Placed_points<d>::image;

    /// Points at free indices are not read. Throws what Lattice::representative throws. The table is empty.
    Periodic_state(std::span<const Coordinates<d>> points, const Box<d>& box, std::span<const Index> free_indices = {});
    /// In the box of `now`, with its free indices, in memory that has been used before. Throws what the first one does.
    Periodic_state(std::span<const Coordinates<d>> points, const Periodic_state& now, Placed_points<d> memory);
    /// The same with other places. The table is empty.
    Periodic_state(const Periodic_state& now, Placed_points<d> places)
        : Placed_points<d>(std::move(places)), lattice(now.lattice), rounded_box(now.rounded_box), free(now.free) {}
    /// What was saved (Saved_periodic_mesh). Throws bad_input, and what Box throws.
    Periodic_state(const typename Box<d>::Vectors& vectors, std::vector<Coordinates<d>> places,
                   std::vector<Shift<d>> images, std::vector<Index> free_indices);

    [[nodiscard]] std::size_t vertices() const { return place.size() - free.size(); }
    [[nodiscard]] bool is_vertex(Index i) const {
        return i >= 0 && static_cast<std::size_t>(i) < place.size() &&
               !std::isnan(place[static_cast<std::size_t>(i)][0]);
    }
    /// The offset by vectors of the box, between representatives, or, less the images, between given points.
    [[nodiscard]] Shift<d> shift(Image<d> s, bool of_given) const {
        Shift<d> o = lattice.in_box(s.label);
        if (of_given)
            for (std::size_t k = 0; k < d; ++k) o[k] -= image[static_cast<std::size_t>(s.vertex)][k];
        return o;
    }
    /// The least offsets of the corners of a cell in each direction.
    [[nodiscard]] Shift<d> least_shift(std::size_t cell, bool of_given) const {
        Shift<d> least = shift(table.image(cell, 0), of_given);
        for (std::size_t i = 1; i <= d; ++i) {
            const Shift<d> o = shift(table.image(cell, i), of_given);
            for (std::size_t k = 0; k < d; ++k) least[k] = std::min(least[k], o[k]);
        }
        return least;
    }
    /// The cells with offsets that refer to the given points or to the representatives. Each is moved so that its least
    /// offsets are 0. O(n).
    [[nodiscard]] Periodic_cells<d> cells(bool of_given) const;

    /// Room for more indices, so that put and take_out throw nothing. Throws bad_alloc, with nothing changed.
    void make_room(std::size_t more);
    /// The index that the next point takes: the one that was freed last, or a new one.
    [[nodiscard]] Index next_index() const { return free.empty() ? static_cast<Index>(place.size()) : free.back(); }
    /// Vertex i is there from now on.
    void set(Index i, const Representative<d>& r) noexcept;
    [[nodiscard]] Representative<d> representative(Index i) const {
        return {place[static_cast<std::size_t>(i)], image[static_cast<std::size_t>(i)]};
    }
    /// Puts a point at next_index().
    void put(const Representative<d>& r) noexcept;
    /// The index becomes free.
    void take_out(Index i) noexcept;
    /// What the last call of put has done is undone.
    void undo_put(Index i, bool was_free) noexcept;

    Lattice<d> lattice;
    Box<d> rounded_box;
    std::vector<Index> free;  // the next one to be used last
    Periodic_table<d> table;

  private:
    void represent(std::span<const Coordinates<d>> points);
    void clear(Index i) noexcept;
};

extern template std::vector<Vertex_move<2>> vertex_moves(const Lattice<2>&, std::span<const Index>,
                                                         std::span<const Coordinates<2>>);
extern template std::vector<Vertex_move<3>> vertex_moves(const Lattice<3>&, std::span<const Index>,
                                                         std::span<const Coordinates<3>>);
extern template struct Periodic_state<2>;
extern template struct Periodic_state<3>;

}  // namespace annulus::inline v1
