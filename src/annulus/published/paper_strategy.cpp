// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/published/paper_strategy.h>

#include <annulus/arithmetic/error.h>
#include <annulus/mesh/table_measures.h>
#include <annulus/published/lawson_flips.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace annulus {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

template <int d>
void append_star(const Corner_table<d>& table, Index v, std::vector<Cell_index>& cells) {
    table.for_each_corner(v, [&](Corner_index h) { cells.push_back(table.cell_of(h)); });
}

}  // namespace

template <int d>
void Paper_strategy<d>::resize() {
    const std::size_t n = this->mesh().vertex_bound();
    this->position_.resize(n);
    state_.fixed.resize(n);
    state_.epsilon.resize(n, unlimited);
    state_.threshold.resize(n, 0.0);
    queue_.has.resize(n, 0);
    least_.resize(n);
}

template <int d>
void Paper_strategy<d>::forget_queue() noexcept {
    for (const Index w : queue_.vertex) queue_.has[at(w)] = 0;
    queue_.vertex.clear();
}

template <int d>
void Paper_strategy<d>::set_tolerance(Index v, double tolerance) {
    state_.epsilon[at(v)] = tolerance;
    state_.threshold[at(v)] = squared_threshold_lower(tolerance);
}

template <int d>
void Paper_strategy<d>::recompute_tolerances(std::span<const Coordinates<d>> x, Move_report& report) {
    const bool own = x.data() == this->position_.data();
    forget_queue();
    least_.clear();  // it may name a vertex that a call that ran out of memory has not inserted
    resize();
    if (own) x = this->position_;
    std::copy(x.begin(), x.end(), state_.fixed.begin());
    std::fill(state_.epsilon.begin(), state_.epsilon.end(), unlimited);
    std::fill(state_.threshold.begin(), state_.threshold.end(), 0.0);
    if (this->mesh().dimension() == d) {
        tolerances_.note_everything(state_.fixed, least_, report);
        least_.take([this](Index v, double tolerance) { set_tolerance(v, tolerance); });
    }
    // Last: after an exception the mesh is rebuilt at the old positions.
    if (!own) std::copy(x.begin(), x.end(), this->position_.begin());
}

template <int d>
void Paper_strategy<d>::begin(std::span<const Coordinates<d>> x, Move_report& report) {
    if (std::exchange(switch_.fresh, false)) this->set_strategy(Strategy::paper_hybrid);
    if (has_switched()) return recompute_tolerances(x, report);
    least_.clear();
    Rebuild_strategy<d>::begin(x, report);
}

/// Whether the tolerance of v is greater than its displacement to x, with all other vertices at rest.
template <int d>
bool Paper_strategy<d>::stays(std::span<const Coordinates<d>> x, Index v, Move_report& report) {
    std::vector<Cell_index> star;
    append_star(this->mesh().table(), v, star);
    tolerances_.note(star, this->position_, least_, report);
    double own = unlimited;
    least_.take([&](Index w, double tolerance) { own = w == v ? tolerance : own; });
    return distance_upper<d>(x[at(v)], this->position_[at(v)]) < own;
}

template <int d>
void Paper_strategy<d>::before_step(std::span<const Coordinates<d>> x, Move_report& report) {
    constexpr int sample = 40;
    constexpr double share = d == 2 ? 0.75 : 0.55;
    if (has_switched() || switch_.steps++ % 4 != 0) return;
    if (this->mesh().dimension() != d || this->mesh().vertices() < 4) return;
    least_.resize(this->mesh().vertex_bound());
    int within = 0;
    for (int k = 0; k < sample; ++k) {
        Index v = 0;
        do v = static_cast<Index>(random_() % this->mesh().vertex_bound());
        while (!this->mesh().has(v));
        within += stays(x, v, report) ? 1 : 0;
    }
    if (within < share * sample) return;
    recompute_tolerances(this->position_, report);
    this->set_strategy(Strategy::paper);
    switch_.fresh = true;
}

template <int d>
void Paper_strategy<d>::add_vertex(Index v, const Coordinates<d>& p) {
    Rebuild_strategy<d>::add_vertex(v, p);
    if (!has_switched()) return;
    resize();
    state_.fixed[at(v)] = p;
    state_.epsilon[at(v)] = unlimited;
    state_.threshold[at(v)] = 0.0;
}

template <int d>
void Paper_strategy<d>::begin_transaction(std::span<const Coordinates<d>> x, Move_report& report) {
    Rebuild_strategy<d>::begin_transaction(x, report);
    saved_ = state_;
}

template <int d>
void Paper_strategy<d>::commit_transaction(Move_report& report) {
    Rebuild_strategy<d>::commit_transaction(report);
    saved_ = {};
    switch_.fresh = false;
}

template <int d>
void Paper_strategy<d>::rollback() noexcept {
    Rebuild_strategy<d>::rollback();
    std::swap(state_, saved_);
    forget_queue();
    if (std::exchange(switch_.fresh, false)) this->set_strategy(Strategy::paper_hybrid);
}

template <int d>
void Paper_strategy<d>::lower(Index v, double tolerance) {
    if (!(tolerance < state_.epsilon[at(v)])) return;
    set_tolerance(v, tolerance);
    if (queue_.has[at(v)] != 0 || passes(v)) return;
    queue_.vertex.push_back(v);
    queue_.has[at(v)] = 1;
}

template <int d>
void Paper_strategy<d>::lower_points() {
    least_.take([this](Index w, double least) { lower(w, least); });
}

template <int d>
void Paper_strategy<d>::refresh(std::span<const Cell_index> cells, Move_report& report) {
    if (!has_switched()) return;
    resize();
    tolerances_.note(cells, state_.fixed, least_, report);
    lower_points();
    for (std::size_t i = 0; i < queue_.vertex.size(); ++i) process(queue_.vertex[i], report, false);
    queue_.vertex.clear();
}

/// Makes the moving position of h its fixed one, and the mesh Delaunay there; `changed` receives the cells around h
/// and the new cells. Returns the counter of what became of h. Throws Error(duplicate_point), with nothing changed.
template <int d>
std::uint64_t& Paper_strategy<d>::bring(Index h, std::vector<Cell_index>& changed, Move_counts& moves) {
    Delaunay_mesh<d>& mesh = this->mesh();
    const Coordinates<d> old = std::exchange(state_.fixed[at(h)], this->position_[at(h)]);
    std::uint64_t* done = nullptr;
    if (star_holds<d>(mesh.table(), state_.fixed, h)) {
        done = &moves.kept_in_place;
    } else {
        if constexpr (d == 2)
            if (flip_after_move(mesh.table(), state_.fixed, h, signs_, changed)) done = &moves.flipped;
        if (done == nullptr) {
            state_.fixed[at(h)] = old;
            if (!mesh.reinsert(state_.fixed, h, this->position_[at(h)], changed)) return moves.rebuilt;
            done = &moves.reinserted;
        }
    }
    append_star(mesh.table(), h, changed);
    return *done;
}

template <int d>
void Paper_strategy<d>::process(Index h, Move_report& report, bool first) {
    const Coordinates<d> old_fixed = state_.fixed[at(h)];
    Move_counts moves;
    std::uint64_t* done = &moves.rebuilt;
    std::vector<Cell_index> changed;
    try {
        done = &bring(h, changed, moves);
    } catch (const Error& e) {
        if (e.code() != Error_code::duplicate_point || is_taken(h)) throw;
        // h is at the fixed position of a vertex that has moved on.
    }
    queue_.has[at(h)] = 0;
    const bool rebuilt = done == &moves.rebuilt;
    if (rebuilt) rebuild(h, old_fixed);
    if (first) {
        ++*done;
        ++moves.asked;
        report.moves += moves;
    } else {
        ++report.requeued;
    }
    if (rebuilt) return recompute_tolerances(this->position_, report);
    state_.epsilon[at(h)] = unlimited;
    state_.threshold[at(h)] = 0.0;
    tolerances_.note(changed, state_.fixed, least_, report);
    lower_points();
}

/// Whether another vertex is at the position of h. O(n).
template <int d>
bool Paper_strategy<d>::is_taken(Index h) const {
    const Coordinates<d>& p = this->position_[at(h)];
    for (Index w = 0; at(w) < this->position_.size(); ++w)
        if (w != h && this->mesh().has(w) && this->position_[at(w)] == p) return true;
    return false;
}

/// Rebuilds at the moving positions. Where two of them coincide, which tolerances that are not certified allow, the
/// previous cells are rebuilt.
template <int d>
void Paper_strategy<d>::rebuild(Index h, const Coordinates<d>& old_fixed) {
    try {
        this->mesh().rebuild(this->position_);
    } catch (const Error&) {
        state_.fixed[at(h)] = old_fixed;
        this->mesh().rebuild(state_.fixed);
        throw;
    }
}

/// After a move that was interrupted and undone: rebuilds cells and tolerances at the moving positions, O(n).
template <int d>
void Paper_strategy<d>::begin_again(Move_report& report) {
    try {
        this->mesh().rebuild(this->position_);
    } catch (const Error&) {  // two coincide: as in rebuild()
        this->mesh().rebuild(state_.fixed);
        return;
    }
    recompute_tolerances(this->position_, report);
}

template <int d>
void Paper_strategy<d>::move(Index v, const Coordinates<d>& p, Move_report& report) {
    if (!has_switched()) return Rebuild_strategy<d>::move(v, p, report);
    const Coordinates<d> old = std::exchange(this->position_[at(v)], p);
    if (passes(v)) {
        ++report.moves.asked;
        ++report.moves.within_tolerance;
        return;
    }
    const auto moves = report.moves;  // a vertex that meets another one is moved again later
    bool begun = false;
    const auto rollback = [&] {
        report.moves = moves;
        this->position_[at(v)] = old;
        forget_queue();
    };
    try {
        process(v, report, true);
        begun = true;
        for (std::size_t i = 0; i < queue_.vertex.size(); ++i) process(queue_.vertex[i], report, false);
    } catch (const Error&) {
        rollback();
        if (begun) begin_again(report);
        throw;
    } catch (...) {
        rollback();
        throw;
    }
    queue_.vertex.clear();
}

template class Paper_strategy<2>;
template class Paper_strategy<3>;

}  // namespace annulus
