// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/periodic_editor.h>

#include <annulus/arithmetic/limits.h>
#include <annulus/engine/require_vertices.h>
#include <annulus/error.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace annulus::inline v1 {

namespace {

// A build costs about as much as inserting or removing one point in so many, near it.
constexpr std::size_t points_an_insertion = 8, points_a_removal = 12;

[[noreturn]] void throw_taken(Index by) {
    throw Error(
        Error_code::duplicate_point,
        "vertex " + std::to_string(by) + " has, up to vectors of the box, the position of a point to be inserted",
        {by});
}
[[noreturn]] void throw_equal(std::size_t k, std::size_t l) {
    throw Error(Error_code::duplicate_point, "points " + std::to_string(std::min(k, l)) + " and " +
                                                 std::to_string(std::max(k, l)) +
                                                 " to be inserted have, up to vectors of the box, the same position");
}

/// Throws the error of several points to be inserted at these indices: some of these vertices, two or more, are at one
/// place.
[[noreturn]] void throw_coinciding(std::span<const std::int64_t> vertices, std::span<const Index> indices) {
    std::vector<std::size_t> among;
    for (const std::int64_t v : vertices) {
        const auto k = std::find(indices.begin(), indices.end(), static_cast<Index>(v));
        if (k == indices.end()) throw_taken(static_cast<Index>(v));
        among.push_back(static_cast<std::size_t>(k - indices.begin()));
    }
    throw_equal(among[0], among[1]);
}

}  // namespace

/// With the table as it was where it throws.
template <int d>
void Periodic_editor<d>::build(Periodic_state<d>& state) {
    Periodic_table<d> table;
    builder_.build(state.lattice, state.place, threads_, table);
    std::swap(state.table, table);
}

template <int d>
Index Periodic_editor<d>::insert_one(Periodic_state<d>& state, const Representative<d>& r) {
    using enum Periodic_insertion::Outcome;
    state.make_room(1);
    const bool was_free = !state.free.empty(), first = state.vertices() == 0;
    const Index i = state.next_index();
    state.put(r);
    try {
        Periodic_insertion inserted{not_local};
        if (!first) inserted = inserter_.insert({state.table, state.lattice, state.place}, i);
        if (inserted.outcome == taken) throw_taken(inserted.vertex);
        if (inserted.outcome == not_local) build(state);
    } catch (const Error& e) {
        state.undo_put(i, was_free);
        if (e.code() == Error_code::duplicate_point && e.vertices().size() > 1)  // of the build
            throw_coinciding(e.vertices(), std::span(&i, 1));
        throw;
    } catch (...) {
        state.undo_put(i, was_free);
        throw;
    }
    return i;
}

template <int d>
std::vector<Index> Periodic_editor<d>::insert_at_once(Periodic_state<d>& state,
                                                      std::span<const Representative<d>> points) {
    std::vector<Index> indices;
    state.make_room(points.size());
    for (const Representative<d>& r : points) {
        indices.push_back(state.next_index());
        state.put(r);
    }
    try {
        build(state);
    } catch (const Error& e) {
        if (e.code() != Error_code::duplicate_point) throw;
        throw_coinciding(e.vertices(), indices);
    }
    return indices;
}

template <int d>
std::vector<Index> Periodic_editor<d>::insert(Periodic_state<d>& state, std::span<const Coordinates<d>> points) {
    std::vector<Representative<d>> taken;
    for (std::size_t k = 0; k < points.size(); ++k)
        taken.push_back(state.lattice.representative(points[k], static_cast<std::int64_t>(k)));
    if (taken.size() > state.free.size() && state.place.size() + taken.size() - state.free.size() > Limits::vertices)
        throw Error(Error_code::too_large, "more than " + std::to_string(Limits::vertices) + " points");
    if (taken.empty()) return {};
    if (taken.size() == 1) {
        std::vector<Index> indices(1);
        indices[0] = insert_one(state, taken[0]);
        return indices;
    }
    Periodic_state<d> next = state;
    std::vector<Index> indices;
    if (taken.size() > next.vertices() / points_an_insertion) indices = insert_at_once(next, taken);
    else
        for (const Representative<d>& r : taken) try {
                indices.push_back(insert_one(next, r));
            } catch (const Error& e) {
                if (e.code() != Error_code::duplicate_point) throw;
                const auto k = std::find(indices.begin(), indices.end(), static_cast<Index>(e.vertices().front()));
                if (k == indices.end()) throw;
                throw_equal(static_cast<std::size_t>(k - indices.begin()), indices.size());
            }
    state = std::move(next);
    return indices;
}

template <int d>
void Periodic_editor<d>::remove_one(Periodic_state<d>& state, Index i) {
    state.make_room(1);
    if (state.vertices() == 1) state.table.clear();
    else if (!inserter_.remove({state.table, state.lattice, state.place}, i)) {
        std::vector<Coordinates<d>> others = state.place;
        others[static_cast<std::size_t>(i)].fill(std::numeric_limits<double>::quiet_NaN());
        Periodic_table<d> table;
        builder_.build(state.lattice, others, threads_, table);
        std::swap(state.table, table);
    }
    state.take_out(i);
}

template <int d>
void Periodic_editor<d>::remove(Periodic_state<d>& state, std::span<const Index> indices) {
    require_vertices(
        indices, [&](Index i) { return state.is_vertex(i); }, Repeats::refused);
    if (indices.empty()) return;
    if (indices.size() == 1) return remove_one(state, indices[0]);
    Periodic_state<d> next = state;
    if (indices.size() > (next.vertices() - indices.size()) / points_a_removal) {
        next.make_room(indices.size());
        for (const Index i : indices) next.take_out(i);
        build(next);
    } else
        for (const Index i : indices) remove_one(next, i);
    state = std::move(next);
}

template <int d>
bool Periodic_editor<d>::move(Periodic_state<d>& state, Index i, const Representative<d>& to) {
    using enum Periodic_insertion::Outcome;
    const auto at = static_cast<std::size_t>(i);
    const auto write = [&] {
        state.given[at] = state.lattice.imaged(to);
        state.place[at] = to.place;
        state.image[at] = to.image;
    };
    if (state.place[at] == to.place) {
        write();
        return true;
    }
    if (state.free.empty() && state.place.size() == Limits::vertices) return false;
    state.make_room(1);
    const bool was_free = !state.free.empty();
    const Index there = state.next_index();  // until the vertex has gone
    state.put(to);
    const Periodic_scene<d> scene{state.table, state.lattice, state.place};
    bool moved = false;
    try {
        const Periodic_insertion inserted = inserter_.insert_for_now(scene, there);
        if (inserted.outcome == taken) {
            const auto [low, high] = std::minmax(i, inserted.vertex);
            throw Error(Error_code::duplicate_point,
                        "vertices " + std::to_string(low) + " and " + std::to_string(high) +
                            " have, up to vectors of the box, the same position",
                        {low, high});
        }
        if (inserted.outcome == done) {
            try {
                moved = !inserter_.has_gaps() && remover_.remove_for_now(scene, i);
            } catch (...) {
                inserter_.take_back(state.table);
                throw;
            }
            if (!moved) inserter_.take_back(state.table);
        }
    } catch (...) {
        state.undo_put(there, was_free);
        throw;
    }
    if (moved) {
        for (const auto made : {inserter_.made(), remover_.made()})  // all cells of the new vertex, and others
            for (const std::size_t c : made)
                std::replace(state.table.vertex[c].begin(), state.table.vertex[c].end(), there, i);
        remover_.keep(state.table);
        write();
    }
    state.undo_put(there, was_free);
    return moved;
}

template class Periodic_editor<2>;
template class Periodic_editor<3>;

}  // namespace annulus::inline v1
