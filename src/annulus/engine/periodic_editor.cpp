// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/periodic_editor.h>

#include <annulus/arithmetic/limits.h>
#include <annulus/engine/require_vertices.h>
#include <annulus/error.h>
#include <annulus/kernel/coinciding_images.h>
#include <annulus/space/least_image.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
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

/// Throws the error of points that were put at these indices, some of which coincide with vertices or with one another:
/// that of the first one, as if they had been inserted one after the other.
template <int d>
[[noreturn]] void throw_first_taken(const Periodic_state<d>& state, std::span<const Index> indices) {
    std::vector<std::size_t> number(state.place.size(), indices.size());
    for (std::size_t k = 0; k < indices.size(); ++k) number[static_cast<std::size_t>(indices[k])] = k;
    const auto image = [&](Index i) { return least_image<d>(state.lattice, state.place[static_cast<std::size_t>(i)]); };
    std::map<Coordinates<d>, Index> at;
    for (Index i = 0; static_cast<std::size_t>(i) < number.size(); ++i)
        if (state.is_vertex(i) && number[static_cast<std::size_t>(i)] == indices.size()) at.emplace(image(i), i);
    for (std::size_t k = 0; k < indices.size(); ++k) {
        const auto [there, is_first] = at.emplace(image(indices[k]), indices[k]);
        if (is_first) continue;
        const std::size_t other = number[static_cast<std::size_t>(there->second)];
        if (other == indices.size()) throw_taken(there->second);
        throw_equal(other, k);
    }
    throw std::logic_error("points that coincide are not found");
}

/// Throws the error of vertices of which some come together.
template <int d>
[[noreturn]] void throw_together(const Periodic_state<d>& state, std::span<const Vertex_move<d>> moves) {
    std::vector<Coordinates<d>> place = state.place;
    for (const Vertex_move<d>& m : moves) place[static_cast<std::size_t>(m.vertex)] = m.to.place;
    throw coinciding_images_error<d>(state.lattice, place);
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
            throw_taken(static_cast<Index>(e.vertices()[e.vertices()[0] == i ? 1 : 0]));
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
        throw_first_taken<d>(state, indices);
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

/// Leaves what it has done in the table and the state where it returns false or throws.
template <int d>
bool Periodic_editor<d>::reinsert(Periodic_state<d>& state, std::span<const Vertex_move<d>> moves) {
    using enum Periodic_insertion::Outcome;
    const Periodic_scene<d> scene{state.table, state.lattice, state.place, &journal_};
    const auto stays = [&](const Vertex_move<d>& m) {
        return state.place[static_cast<std::size_t>(m.vertex)] == m.to.place;
    };
    for (const Vertex_move<d>& m : moves)
        if (!stays(m) && !inserter_.remove(scene, m.vertex)) return false;
    for (const Vertex_move<d>& m : moves) {
        const bool stayed = stays(m);
        state.set(m.vertex, m.to);
        if (stayed) continue;
        const Periodic_insertion::Outcome outcome = inserter_.insert(scene, m.vertex).outcome;
        if (outcome == taken) throw_together(state, moves);
        if (outcome != done) return false;
    }
    return true;
}

template <int d>
bool Periodic_editor<d>::move(Periodic_state<d>& state, std::span<const Vertex_move<d>> moves) {
    std::vector<Vertex_move<d>> back;
    for (const Vertex_move<d>& m : moves) back.push_back({m.vertex, state.representative(m.vertex)});
    journal_.begin(state.table, Periodic_journal<d>::Flags::kept);
    const auto undo = [&]() noexcept {
        journal_.undo(state.table);
        for (const Vertex_move<d>& was : back) state.set(was.vertex, was.to);
    };
    try {
        if (reinsert(state, moves)) return true;
    } catch (...) {
        undo();
        throw;
    }
    undo();
    return false;
}

template class Periodic_editor<2>;
template class Periodic_editor<3>;

}  // namespace annulus::inline v1
