// SPDX-License-Identifier: GPL-3.0-or-later
// Paper_strategy: what the engine requires of every strategy: starting, insertions, time steps as transactions.
#include <annulus/published/paper_strategy.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace annulus::inline v1 {

namespace {
constexpr double no_limit = std::numeric_limits<double>::infinity();
}  // namespace

template <int d>
void Paper_strategy<d>::resize() {
    const std::size_t n = this->mesh().vertex_bound();
    this->position_.resize(n);
    state_.fixed.resize(n);
    state_.epsilon.resize(n, no_limit);
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
void Paper_strategy<d>::recompute_tolerances(std::span<const Coordinates<d>> x, Move_result& report) {
    const bool own = x.data() == this->position_.data();
    forget_queue();
    least_.clear();  // it may name a vertex that a call that ran out of memory has not inserted
    resize();
    if (own) x = this->position_;
    std::copy(x.begin(), x.end(), state_.fixed.begin());
    compute_tolerances(report);
    // Last: after an exception the mesh is rebuilt at the old positions.
    if (!own) std::copy(x.begin(), x.end(), this->position_.begin());
}

/// Computes every tolerance at the fixed positions.
template <int d>
void Paper_strategy<d>::compute_tolerances(Move_result& report) {
    std::fill(state_.epsilon.begin(), state_.epsilon.end(), no_limit);
    std::fill(state_.threshold.begin(), state_.threshold.end(), 0.0);
    if (this->mesh().dimension() != d) return;
    tolerances_.note_everything(state_.fixed, least_, report);
    least_.take([this](Index v, double tolerance) { set_tolerance(v, tolerance); });
}

/// A vertex that is beyond its tolerance is relocated when it moves next.
template <int d>
void Paper_strategy<d>::clear_position(Index v) noexcept {
    Rebuild_strategy<d>::clear_position(v);
    if (at(v) < state_.fixed.size()) state_.fixed[at(v)] = this->position_[at(v)];
}

template <int d>
void Paper_strategy<d>::resume_at_delaunay_positions() {
    forget_queue();
    least_.clear();
    resize();
    Move_result discarded;
    compute_tolerances(discarded);
}

template <int d>
void Paper_strategy<d>::begin(std::span<const Coordinates<d>> x, Move_result& report) {
    if (std::exchange(switch_.fresh, false)) this->set_strategy(Strategy::paper_hybrid);
    if (has_switched()) return recompute_tolerances(x, report);
    least_.clear();
    Rebuild_strategy<d>::begin(x, report);
}

template <int d>
void Paper_strategy<d>::add_vertex(Index v, const Coordinates<d>& p) {
    Rebuild_strategy<d>::add_vertex(v, p);
    if (!has_switched()) return;
    resize();
    state_.fixed[at(v)] = p;
    set_unlimited(v);
}

template <int d>
void Paper_strategy<d>::refresh(std::span<const Cell_index> cells, Move_result& report) {
    if (!has_switched()) return;
    resize();
    tolerances_.note(cells, state_.fixed, least_, report);
    lower_points();
    for (std::size_t i = 0; i < queue_.vertex.size(); ++i) process(queue_.vertex[i], report, false);
    queue_.vertex.clear();
}

template <int d>
void Paper_strategy<d>::begin_transaction(std::span<const Coordinates<d>> x, Move_result& report) {
    Rebuild_strategy<d>::begin_transaction(x, report);
    saved_ = state_;
}

template <int d>
void Paper_strategy<d>::commit_transaction(Move_result& report) {
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

template class Paper_strategy<2>;
template class Paper_strategy<3>;

}  // namespace annulus::inline v1
