// SPDX-License-Identifier: GPL-3.0-or-later
// Engine: construction, recovery, queries. Moves are in engine_moves.cpp.
#include <annulus/engine/engine.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/arithmetic/environment.h>
#include <annulus/engine/displacement.h>
#include <annulus/engine/guarded.h>
#include <annulus/engine/listing_changes.h>
#include <annulus/engine/naming_duplicates.h>
#include <annulus/engine/update_strategy.h>
#include <annulus/error.h>

#include <algorithm>
#include <map>
#include <utility>

namespace annulus::inline v1 {

template <int d>
Engine<d>::Engine(Delaunay_mesh<d>& mesh, const Options& options, std::unique_ptr<Update_strategy<d>> strategy)
    : options_(options), mesh_(mesh), strategy_(std::move(strategy)) {
    if (options.report_changes) change_log_ = std::make_unique<Change_log<d>>();
    require_sound_environment();
    if (options.threads < 1)
        throw Error(Error_code::usage, "threads must be 1 or more, not " + std::to_string(options.threads));
    mesh_.set_threads(options.threads);
}

template <int d>
Engine<d>::~Engine() = default;

template <int d>
Strategy Engine<d>::strategy() const {
    return strategy_->strategy();
}

template <int d>
void Engine<d>::build(std::span<const Point> points) {
    require_in_domain(points, "point");
    if (points.size() > Limits::vertices)
        throw Error(Error_code::too_large, "more than " + std::to_string(Limits::vertices) + " vertices");
    std::vector<Point> distinct;
    vertex_of_input_.reserve(points.size());
    if (options_.merge_duplicates) {
        std::map<Point, Index> seen;
        for (auto p : points) {
            for (double& c : p) c += 0.0;  // -0 and 0 are one position
            const auto [it, fresh] = seen.emplace(p, static_cast<Index>(distinct.size()));
            if (fresh) distinct.push_back(p);
            vertex_of_input_.push_back(it->second);
        }
        points = distinct;
    } else {
        for (std::size_t i = 0; i < points.size(); ++i) vertex_of_input_.push_back(static_cast<Index>(i));
    }
    naming_duplicates<d>(
        points, [](Index) { return true; }, "points", [&] { mesh_.build(points); });
    Move_result report;
    strategy_->begin(points, report);
}

template <int d>
void Engine<d>::build_copy(const Engine& other) {
    const auto x = other.positions();
    vertex_of_input_ = other.vertex_of_input_;
    free_indices_ = other.free_indices_;
    naming_duplicates<d>(
        x, [&](Index i) { return other.is_vertex(i); }, "vertices", [&] { mesh_.build(x, free_indices_); });
    Move_result discarded;
    strategy_->begin(x, discarded);
    clear_free_positions();
}

template <int d>
void Engine<d>::require_whole() {
    if (whole_) return;
    recover(index_bound(), none);
    if (!whole_) throw std::bad_alloc();
}

/// Whatever is left, one set of positions is complete: the previous ones.
template <int d>
void Engine<d>::recover(std::size_t bound, Index fresh) noexcept {
    whole_ = false;
    try {
        strategy_->truncate(bound);
        restore_cells(fresh);
        whole_ = true;
    } catch (...) {
        mesh_.clear_cells();
    }
}

/// Tolerances that are not certified may let two positions coincide. Those at which the mesh was Delaunay do not.
template <int d>
void Engine<d>::restore_cells(Index fresh) {
    try {
        mesh_.restore(positions(), fresh);
    } catch (const Error&) {
        mesh_.restore(strategy_->delaunay_positions().first(index_bound()), fresh);
        strategy_->resume_at_delaunay_positions();
        return;
    }
    Move_result discarded;
    strategy_->begin(positions(), discarded);
}

template <int d>
bool Engine<d>::is_vertex(Index i) const {
    return i >= 0 && at(i) < index_bound() && at(i) < mesh_.vertex_bound() && mesh_.has(i);
}

template <int d>
void Engine<d>::require_vertex(Index i) const {
    if (!is_vertex(i)) throw Error(Error_code::unknown_vertex, "no vertex has index " + std::to_string(i), {i});
}

template <int d>
auto Engine<d>::positions() const -> std::span<const Point> {
    return strategy_->positions();
}

template <int d>
auto Engine<d>::delaunay_positions() const -> std::span<const Point> {
    return strategy_->delaunay_positions();
}

template <int d>
auto Engine<d>::fixed_position(Index i) const -> Point {
    return strategy_->fixed_position(i);
}

template <int d>
double Engine<d>::tolerance(Index i) const {
    if (mesh_.dimension() != d) return 0.0;
    const auto kept = strategy_->tolerance(i);
    return kept ? *kept : mesh_.star_tolerance(strategy_->delaunay_positions(), i);
}

template <int d>
double Engine<d>::displacement(Index i) const {
    return distance_upper<d>(positions()[at(i)], strategy_->fixed_position(i));
}

template <int d>
Move_result Engine<d>::recompute_tolerances() {
    Move_result report;
    guarded([&] {
        listing_changes(report, {}, [&] {
            if (strategy_->trusted()) strategy_->refresh_all(report);
            else make_trusted(report);
        });
    });
    return report;
}

/// Insertion and removal need a Delaunay triangulation. Tolerances that are not certified may have left another one,
/// or one at other positions.
template <int d>
void Engine<d>::make_trusted(Move_result& report) {
    if (strategy_->trusted()) return;
    const std::vector<Point> x(positions().begin(), positions().end());
    naming_duplicates<d>(
        std::span<const Point>(x), [this](Index i) { return is_vertex(i); }, "vertices", [&] { mesh_.rebuild(x); });
    strategy_->begin(x, report);
}

/// Throws the name of the vertex at p, searched below the bound.
template <int d>
void Engine<d>::throw_taken(const Point& p, std::size_t bound) const {
    const Index other = vertex_at(p, bound);
    if (other == none)
        throw Error(Error_code::duplicate_point, "a vertex has the position of the point to be inserted");
    throw Error(Error_code::duplicate_point,
                "vertex " + std::to_string(other) + " has the position of the point to be inserted", {other});
}

/// O(bound).
template <int d>
Index Engine<d>::vertex_at(const Point& p, std::size_t bound) const {
    for (Index i = 0; at(i) < bound; ++i)
        if (is_vertex(i) && positions()[at(i)] == p) return i;
    return none;
}

template <int d>
Index Engine<d>::insert(const Point& p, Move_result& report) {
    require_in_domain(p);
    require_whole();
    if (free_indices_.empty() && index_bound() >= Limits::vertices)
        throw Error(Error_code::too_large, "more than " + std::to_string(Limits::vertices) + " vertices");
    const Index i = free_indices_.empty() ? static_cast<Index>(index_bound()) : free_indices_.back();
    const Point here = p;  // it may be one of positions(), which are about to grow
    const auto put = [&] {
        const std::size_t bound = index_bound();
        if (!strategy_->trusted() && vertex_at(here, bound) != none) throw_taken(here, bound);
        make_trusted(report);
        std::vector<Cell_index> changed;
        const int before = mesh_.dimension();
        if (!mesh_.insert(strategy_->resize_for_insertion(std::max(bound, at(i) + 1)), i, here, changed)) {
            (void)strategy_->resize_for_insertion(bound);
            throw_taken(here, bound);
        }
        strategy_->add_vertex(i, here);
        if (before == d) strategy_->refresh(changed, report);
        else if (mesh_.dimension() == d) strategy_->refresh_rebuilt(report);
    };
    try {
        guarded([&] { listing_changes(report, {}, put); }, i);
    } catch (...) {
        clear_free_positions();
        throw;
    }
    if (!free_indices_.empty()) free_indices_.pop_back();
    return i;
}

template <int d>
void Engine<d>::remove(Index i, Move_result& report) {
    free_indices_.reserve(free_indices_.size() + 1);
    const auto take = [&] {
        make_trusted(report);
        std::vector<Cell_index> changed;
        const int before = mesh_.dimension();
        try {
            mesh_.remove(positions(), i, changed);
        } catch (...) {
            if (!mesh_.has(i)) free_indices_.push_back(i);  // removed, but what followed failed
            throw;
        }
        free_indices_.push_back(i);
        if (!changed.empty()) strategy_->refresh(changed, report);
        else if (before == d || mesh_.dimension() == d) strategy_->refresh_rebuilt(report);
    };
    try {
        guarded([&] { listing_changes(report, {}, take); });
    } catch (...) {
        clear_free_positions();
        throw;
    }
    strategy_->clear_position(i);
}

template <int d>
Mesh_cells<d> Engine<d>::cells() const {
    return mesh_.cells(delaunay_positions());
}

template <int d>
Audit_input<d> Engine<d>::audit_input() const {
    Audit_input<d> input;
    std::vector<Index> squeezed(index_bound(), none);
    for (std::size_t i = 0; i < index_bound(); ++i) {
        if (!is_vertex(static_cast<Index>(i))) continue;
        squeezed[i] = static_cast<Index>(input.points.size());
        input.points.push_back(positions()[i]);
        input.names.push_back(static_cast<Index>(i));
    }
    std::vector<Index> corners;
    mesh_.list_cells(delaunay_positions(), corners);
    for (std::size_t k = 0; k < corners.size(); k += d + 1) {
        auto& cell = input.cells.emplace_back();
        for (std::size_t i = 0; i <= d; ++i) cell[i] = corners[k + i] == none ? none : squeezed[at(corners[k + i])];
    }
    return input;
}

template class Engine<2>;
template class Engine<3>;

}  // namespace annulus::inline v1
