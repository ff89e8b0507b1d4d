// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/periodic_mesh.h>

#include <annulus/arithmetic/environment.h>
#include <annulus/arithmetic/limits.h>
#include <annulus/engine/merged_points.h>
#include <annulus/engine/periodic_changes.h>
#include <annulus/engine/periodic_editor.h>
#include <annulus/engine/periodic_mover.h>
#include <annulus/engine/periodic_state.h>
#include <annulus/engine/require_vertices.h>
#include <annulus/kernel/periodic_builder.h>
#include <annulus/measure/periodic_diagram.h>
#include <annulus/measure/periodic_queries.h>
#include <annulus/measure/periodic_thetas.h>
#include <annulus/measure/periodic_voronoi.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// A member of every entry.
template <class Entry, class Member>
std::vector<Member> column(const std::vector<Entry>& entries, Member Entry::*member) {
    std::vector<Member> all;
    all.reserve(entries.size());
    for (const Entry& e : entries) all.push_back(e.*member);
    return all;
}
template <int d>
Periodic_pairs<d> listed(const std::vector<Image_pair<d>>& pairs) {
    using Pair = Image_pair<d>;
    return {column(pairs, &Pair::first), column(pairs, &Pair::second), column(pairs, &Pair::shift)};
}
template <int d>
Periodic_cell_list<d> listed(const std::vector<Image_cell<d>>& cells) {
    return {column(cells, &Image_cell<d>::vertices), column(cells, &Image_cell<d>::offsets)};
}

}  // namespace

template <int d>
struct Periodic_mesh<d>::Parts {
    Parts(std::span<const Point> points, const Box<d>& box, const Periodic_options& chosen)
        : options(chosen), state(placed(points.size(), points, box)) {
        if (options.merge_duplicates) merge(points, box);
        build_first();
    }
    Parts(const Saved_periodic_mesh<d>& saved, const Periodic_options& chosen)
        : options(chosen),
          state(placed(saved.places.size(), saved.vectors, saved.places, saved.images, saved.free_indices)) {
        build_first();
    }

    template <class... Of>
    Periodic_state<d> placed(std::size_t points, Of&&... of) {
        require_sound_environment();
        if (options.threads < 1) throw Error(Error_code::usage, "threads must be 1 or more");
        if (points > Limits::vertices)
            throw Error(Error_code::too_large, "more than " + std::to_string(Limits::vertices) + " points");
        return Periodic_state<d>(std::forward<Of>(of)...);
    }
    void merge(std::span<const Point> points, const Box<d>& box) {
        Merged_points<d> merged = merged_points<d>(state.lattice, points, state.place);
        vertex_of_input = std::move(merged.vertex);
        if (merged.distinct.size() < points.size())
            state = placed(merged.distinct.size(), std::span<const Point>(merged.distinct), box);
    }
    void build_first() {
        if (vertex_of_input.empty()) {
            vertex_of_input.resize(state.place.size());
            std::iota(vertex_of_input.begin(), vertex_of_input.end(), Index{0});
        }
        builder.build(state.lattice, state.place, options.threads, state.table);
        builder.release();  // some meshes are never built again
    }

    /// The same box is of the same bits.
    [[nodiscard]] Periodic_state<d> moved(std::span<const Point> points, const typename Box<d>::Vectors& box) {
        const std::size_t n = state.place.size();
        if (points.size() != n)
            throw Error(Error_code::wrong_size,
                        std::to_string(points.size()) + " positions for " + std::to_string(n) + " vertices");
        if (std::memcmp(&box, &state.lattice.given(), sizeof box) != 0)
            return placed(n, points, Box<d>(box), state.free);
        return placed(n, points, state, mover.take_memory());
    }
    /// Makes a call that changes the state, and lists the changes. Where it throws, the state is as it was.
    template <class Call>
    auto changing(Call call) {
        if (!options.report_changes) return call();
        Periodic_state<d> before = state;
        try {
            auto result = call();
            const Image_changes<d> all = periodic_changes(before, state);
            changes = {listed(all.made), listed(all.broken), listed(all.changed), listed(all.gone)};
            return result;
        } catch (...) {
            state = std::move(before);
            mover.forget();
            throw;
        }
    }

    Periodic_options options;
    Periodic_builder<d> builder;
    Periodic_mover<d> mover{builder, options.strategy, options.threads};
    Periodic_editor<d> editor{builder, options.threads};
    Periodic_state<d> state;
    Periodic_changes<d> changes;  // of the last call
    std::vector<Index> vertex_of_input;
};

template <int d>
Periodic_mesh<d>::Periodic_mesh(std::span<const Point> points, const Box<d>& box, const Periodic_options& options)
    : parts_(std::make_unique<Parts>(points, box, options)) {}
template <int d>
Periodic_mesh<d>::Periodic_mesh(const Saved_periodic_mesh<d>& saved, const Periodic_options& options)
    : parts_(std::make_unique<Parts>(saved, options)) {}
template <int d>
Periodic_mesh<d>::~Periodic_mesh() = default;
template <int d>
Periodic_mesh<d>::Periodic_mesh(Periodic_mesh&&) noexcept = default;
template <int d>
Periodic_mesh<d>& Periodic_mesh<d>::operator=(Periodic_mesh&&) noexcept = default;

template <int d>
Move_result Periodic_mesh<d>::move_all(std::span<const Point> points) {
    Periodic_state<d> next = parts_->moved(points, parts_->state.lattice.given());
    return parts_->changing([&] { return parts_->mover.move(parts_->state, std::move(next)); });
}
template <int d>
Move_result Periodic_mesh<d>::move_all(std::span<const Point> points, const Box<d>& box) {
    Periodic_state<d> next = parts_->moved(points, box.vectors());
    return parts_->changing([&] { return parts_->mover.move(parts_->state, std::move(next)); });
}
template <int d>
Move_result Periodic_mesh<d>::move(Index i, const Point& p) {
    return move(std::span(&i, 1), std::span(&p, 1));
}
template <int d>
Move_result Periodic_mesh<d>::move(std::span<const Index> indices, std::span<const Point> points) {
    require_sound_environment();
    if (points.size() != indices.size())
        throw Error(Error_code::wrong_size,
                    std::to_string(points.size()) + " positions for " + std::to_string(indices.size()) + " vertices");
    require_vertices(indices, [&](Index i) { return is_vertex(i); });
    Periodic_state<d>& state = parts_->state;
    const std::vector<Vertex_move<d>> moves = vertex_moves<d>(state.lattice, indices, points);
    return parts_->changing([&]() -> Move_result {
        if (moves.empty()) return {};
        if (parts_->mover.is_for_editor(state, moves)) {
            const auto staying =
                static_cast<std::size_t>(std::count_if(moves.begin(), moves.end(), [&](const Vertex_move<d>& m) {
                    return state.representative(m.vertex).place == m.to.place;
                }));
            if (parts_->editor.move(state, moves)) {
                if (staying < moves.size()) parts_->mover.forget();
                Move_result result;
                result.moves.asked = moves.size();
                result.moves.kept_in_place = staying;
                result.moves.reinserted = moves.size() - staying;
                return result;
            }
        }
        Periodic_state<d> next(state, Placed_points<d>(state));
        for (const Vertex_move<d>& m : moves) next.set(m.vertex, m.to);
        return parts_->mover.move(state, std::move(next));
    });
}
template <int d>
Move_result Periodic_mesh<d>::recompute_tolerances() {
    require_sound_environment();
    Move_result result;
    parts_->mover.recompute(parts_->state, result.statistics);
    return result;
}
template <int d>
Index Periodic_mesh<d>::insert(const Point& p) {
    return insert(std::span(&p, 1)).front();
}
template <int d>
std::vector<Index> Periodic_mesh<d>::insert(std::span<const Point> points) {
    require_sound_environment();
    parts_->mover.forget();
    return parts_->changing([&] { return parts_->editor.insert(parts_->state, points); });
}
template <int d>
void Periodic_mesh<d>::remove(Index i) {
    remove(std::span<const Index>(&i, 1));
}
template <int d>
void Periodic_mesh<d>::remove(std::span<const Index> indices) {
    require_sound_environment();
    parts_->mover.forget();
    parts_->changing([&] {
        parts_->editor.remove(parts_->state, indices);
        return true;
    });
}

template <int d>
std::span<const Index> Periodic_mesh<d>::vertex_of_input() const {
    return parts_->vertex_of_input;
}
template <int d>
std::size_t Periodic_mesh<d>::number_of_vertices() const {
    return parts_->state.vertices();
}
template <int d>
std::size_t Periodic_mesh<d>::index_bound() const {
    return parts_->state.place.size();
}
template <int d>
bool Periodic_mesh<d>::is_vertex(Index i) const {
    return parts_->state.is_vertex(i);
}
template <int d>
const Box<d>& Periodic_mesh<d>::box() const {
    return parts_->state.rounded_box;
}
template <int d>
auto Periodic_mesh<d>::points() const -> std::span<const Point> {
    return parts_->state.given;
}
template <int d>
auto Periodic_mesh<d>::places() const -> std::span<const Point> {
    return parts_->state.place;
}
template <int d>
std::span<const Shift<d>> Periodic_mesh<d>::images() const {
    return parts_->state.image;
}
template <int d>
auto Periodic_mesh<d>::grid() const -> Point {
    return parts_->state.lattice.grid();
}
template <int d>
std::size_t Periodic_mesh<d>::number_of_cells() const {
    return parts_->state.table.size();
}
template <int d>
Periodic_cells<d> Periodic_mesh<d>::cells() const {
    return parts_->state.cells(true);
}
template <int d>
Periodic_audit_input<d> Periodic_mesh<d>::audit_input() const {
    const Periodic_state<d>& state = parts_->state;
    return {state.place, state.lattice.box(), state.cells(false)};
}
template <int d>
Periodic_location<d> Periodic_mesh<d>::find_cell(const Point& p) const {
    return find_cells(std::span(&p, 1)).front();
}
template <int d>
std::vector<Periodic_location<d>> Periodic_mesh<d>::find_cells(std::span<const Point> points) const {
    require_sound_environment();
    return Periodic_queries<d>(parts_->state).cells(points);
}
template <int d>
Periodic_image<d> Periodic_mesh<d>::nearest_vertex(const Point& p) const {
    return nearest_vertices(std::span(&p, 1)).front();
}
template <int d>
std::vector<Periodic_image<d>> Periodic_mesh<d>::nearest_vertices(std::span<const Point> points) const {
    require_sound_environment();
    return Periodic_queries<d>(parts_->state).nearest(points);
}
template <int d>
Periodic_weights<d> Periodic_mesh<d>::natural_neighbours(std::span<const Point> points) const {
    require_sound_environment();
    return Periodic_queries<d>(parts_->state).natural_neighbours(points);
}
template <int d>
Periodic_neighbours<d> Periodic_mesh<d>::neighbours() const {
    require_sound_environment();
    const Periodic_state<d>& state = parts_->state;
    return periodic_neighbours<d>(state.table, state.lattice, state.place, state.image);
}
template <int d>
std::vector<Index> Periodic_mesh<d>::neighbour_counts(double least_area, bool strict) const {
    if (std::isnan(least_area)) throw Error(Error_code::not_finite, "the least area is not a number");
    const Periodic_neighbours<d> list = neighbours();
    std::vector<Index> counts(index_bound(), 0);
    for (std::size_t k = 0; k < list.first.size(); ++k)
        if (strict ? list.area[k] > least_area : list.area[k] >= least_area)
            ++counts[static_cast<std::size_t>(list.first[k])];
    return counts;
}
template <int d>
std::vector<double> Periodic_mesh<d>::voronoi_volumes() const {
    require_sound_environment();
    const Periodic_state<d>& state = parts_->state;
    return periodic_voronoi_volumes<d>(state.table, state.lattice, state.place);
}
template <int d>
Periodic_voronoi_diagram<d> Periodic_mesh<d>::voronoi() const {
    require_sound_environment();
    return periodic_voronoi_diagram(parts_->state);
}
template <int d>
std::vector<double> Periodic_mesh<d>::tolerances() const {
    require_sound_environment();
    return parts_->mover.tolerances(parts_->state);
}
template <int d>
std::vector<double> Periodic_mesh<d>::thetas() const {
    require_sound_environment();
    const Periodic_state<d>& state = parts_->state;
    return periodic_thetas<d>(state.table, state.lattice, state.place);
}
template <int d>
const Periodic_changes<d>& Periodic_mesh<d>::changes() const {
    return parts_->changes;
}
template <int d>
auto Periodic_mesh<d>::voronoi_gradient(std::span<const double> weights) const -> std::vector<Point> {
    require_sound_environment();
    const Periodic_state<d>& state = parts_->state;
    return periodic_voronoi_gradient<d>(state.table, state.lattice, state.place, weights);
}
template <int d>
Voronoi_jacobian<d> Periodic_mesh<d>::voronoi_jacobian() const {
    require_sound_environment();
    const Periodic_state<d>& state = parts_->state;
    return periodic_voronoi_jacobian<d>(state.table, state.lattice, state.place);
}
template <int d>
const Periodic_options& Periodic_mesh<d>::options() const {
    return parts_->options;
}
template <int d>
Saved_periodic_mesh<d> Periodic_mesh<d>::saved() const {
    const Periodic_state<d>& state = parts_->state;
    return {state.lattice.given(), state.place, state.image, state.free};
}

template class Periodic_mesh<2>;
template class Periodic_mesh<3>;

}  // namespace annulus::inline v1
