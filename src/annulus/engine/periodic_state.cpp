// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/periodic_state.h>

#include <annulus/error.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace annulus::inline v1 {

namespace {

template <int d>
Shift<d> minus(Shift<d> a, const Shift<d>& b) {
    for (std::size_t k = 0; k < d; ++k) a[k] -= b[k];
    return a;
}

template <int d>
Coordinates<d> no_place() {
    Coordinates<d> p;
    p.fill(std::numeric_limits<double>::quiet_NaN());
    return p;
}

/// By index: whether it is free. Throws bad_input.
std::vector<char> marked(std::span<const Index> free_indices, std::size_t bound) {
    std::vector<char> is_free(bound, 0);
    for (const Index i : free_indices) {
        if (i < 0 || static_cast<std::size_t>(i) >= bound || is_free[static_cast<std::size_t>(i)] != 0)
            throw Error(Error_code::bad_input,
                        "a saved free index is " + std::to_string(i) + ", which is none of the mesh, or there twice");
        is_free[static_cast<std::size_t>(i)] = 1;
    }
    return is_free;
}

/// Room for more entries, so that a growth by few costs O(1) on average.
template <class T>
void room_for(std::vector<T>& v, std::size_t size) {
    if (v.capacity() < size) v.reserve(std::max(size, 2 * v.size()));
}

}  // namespace

template <int d>
std::vector<Vertex_move<d>> vertex_moves(const Lattice<d>& lattice, std::span<const Index> indices,
                                         std::span<const Coordinates<d>> points) {
    std::vector<Vertex_move<d>> moves;
    moves.reserve(indices.size());
    for (std::size_t k = 0; k < indices.size(); ++k)
        moves.push_back({indices[k], lattice.representative(points[k], indices[k])});
    std::reverse(moves.begin(), moves.end());  // so that the last one of each stays
    std::stable_sort(moves.begin(), moves.end(), [](const auto& l, const auto& r) { return l.vertex < r.vertex; });
    const auto same = [](const auto& l, const auto& r) { return l.vertex == r.vertex; };
    moves.erase(std::unique(moves.begin(), moves.end(), same), moves.end());
    return moves;
}

template <int d>
Periodic_state<d>::Periodic_state(std::span<const Coordinates<d>> points, const Box<d>& box,
                                  std::span<const Index> free_indices)
    : lattice(box.vectors()),
      rounded_box(typename Box<d>::Rounded{lattice.box()}),
      free(free_indices.begin(), free_indices.end()) {
    static_cast<void>(marked(free, points.size()));
    represent(points);
}

template <int d>
Periodic_state<d>::Periodic_state(std::span<const Coordinates<d>> points, const Periodic_state& now,
                                  Placed_points<d> memory)
    : Placed_points<d>(std::move(memory)), lattice(now.lattice), rounded_box(now.rounded_box), free(now.free) {
    represent(points);
}

/// Points at free indices are not read.
template <int d>
void Periodic_state<d>::represent(std::span<const Coordinates<d>> points) {
    if (free.empty()) {
        lattice.represent(points, place, image, given);
        return;
    }
    std::vector<Coordinates<d>> vertices(points.begin(), points.end());
    for (const Index i : free) vertices[static_cast<std::size_t>(i)] = {};
    lattice.represent(vertices, place, image, given);
    for (const Index i : free) clear(i);
}

template <int d>
void Periodic_state<d>::clear(Index i) noexcept {
    const auto k = static_cast<std::size_t>(i);
    given[k] = place[k] = no_place<d>();
    image[k] = {};
}

template <int d>
Periodic_state<d>::Periodic_state(const typename Box<d>::Vectors& vectors, std::vector<Coordinates<d>> places,
                                  std::vector<Shift<d>> images, std::vector<Index> free_indices)
    : Placed_points<d>{{}, std::move(places), std::move(images)},
      lattice(vectors),
      rounded_box(typename Box<d>::Rounded{lattice.box()}),
      free(std::move(free_indices)) {
    if (image.size() != place.size()) throw Error(Error_code::bad_input, "not every saved place has an image");
    const std::vector<char> is_free = marked(free, place.size());
    given.reserve(place.size());
    for (std::size_t i = 0; i < place.size(); ++i) {
        if (is_free[i] != 0) {
            given.emplace_back();
            clear(static_cast<Index>(i));
            continue;
        }
        const Representative<d> r{place[i], image[i]};
        if (!lattice.is_representative(r))
            throw Error(Error_code::bad_input, "saved place " + std::to_string(i) + " is none of the saved box",
                        {static_cast<std::int64_t>(i)});
        given.push_back(lattice.imaged(r));
    }
}

template <int d>
Periodic_cells<d> Periodic_state<d>::cells(bool of_given) const {
    Periodic_cells<d> cells;
    std::vector<Shift<d>> moved(table.size());  // by cell: what was subtracted
    cells.vertices = table.vertex;
    cells.offsets.resize(table.size());
    cells.neighbours.resize(table.size());
    cells.translations.resize(table.size());
    for (std::size_t c = 0; c < table.size(); ++c) {
        auto& offsets = cells.offsets[c];
        for (std::size_t i = 0; i <= d; ++i) offsets[i] = shift(table.image(c, i), of_given);
        moved[c] = least_shift(c, of_given);
        for (Shift<d>& o : offsets) o = minus<d>(o, moved[c]);
    }
    for (std::size_t c = 0; c < table.size(); ++c)
        for (std::size_t i = 0; i <= d; ++i) {
            const std::size_t m = table.cell_of(table.twin[c][i]);
            cells.neighbours[c][i] = static_cast<Index>(m);
            Shift<d>& t = cells.translations[c][i];
            t = minus<d>(lattice.in_box(table.translation(c, i)), moved[c]);
            for (std::size_t k = 0; k < d; ++k) t[k] += moved[m][k];
        }
    return cells;
}

template <int d>
void Periodic_state<d>::make_room(std::size_t more) {
    room_for(given, given.size() + more);
    room_for(place, place.size() + more);
    room_for(image, image.size() + more);
    room_for(free, free.size() + more);
}

template <int d>
void Periodic_state<d>::set(Index i, const Representative<d>& r) noexcept {
    const auto k = static_cast<std::size_t>(i);
    given[k] = lattice.imaged(r);
    place[k] = r.place;
    image[k] = r.image;
}

template <int d>
void Periodic_state<d>::put(const Representative<d>& r) noexcept {
    const Index i = next_index();
    if (free.empty()) {
        given.emplace_back();
        place.emplace_back();
        image.emplace_back();
    } else free.pop_back();
    set(i, r);
}

template <int d>
void Periodic_state<d>::take_out(Index i) noexcept {
    clear(i);
    free.push_back(i);
}

template <int d>
void Periodic_state<d>::undo_put(Index i, bool was_free) noexcept {
    take_out(i);
    if (was_free) return;
    free.pop_back();
    given.pop_back();
    place.pop_back();
    image.pop_back();
}

template std::vector<Vertex_move<2>> vertex_moves(const Lattice<2>&, std::span<const Index>,
                                                  std::span<const Coordinates<2>>);
template std::vector<Vertex_move<3>> vertex_moves(const Lattice<3>&, std::span<const Index>,
                                                  std::span<const Coordinates<3>>);
template struct Periodic_state<2>;
template struct Periodic_state<3>;

}  // namespace annulus::inline v1
