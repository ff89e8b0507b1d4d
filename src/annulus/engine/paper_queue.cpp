// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/paper_queue.h>

#include <annulus/arithmetic/error.h>
#include <annulus/engine/chooser.h>

#include <algorithm>
#include <limits>

namespace annulus {

namespace {
constexpr double unlimited = std::numeric_limits<double>::infinity();
}  // namespace

template <int d>
void Paper_queue<d>::resize() {
    const std::size_t n = at(mesh_.table().vertex_bound());
    position_.resize(n);
    fixed_.resize(n);
    epsilon_.resize(n, unlimited);
    threshold_.resize(n, 0.0);
    queued_.resize(n, 0);
    least_.resize(n);
}

template <int d>
void Paper_queue<d>::settle(std::span<const Coordinates<d>> x, Move_report& report) {
    const bool own = x.data() == position_.data();
    resize();
    if (own) x = position_;
    std::copy(x.begin(), x.end(), fixed_.begin());
    least_.clear();
    std::fill(epsilon_.begin(), epsilon_.end(), unlimited);
    std::fill(threshold_.begin(), threshold_.end(), 0.0);
    if (mesh_.dimension() == d) {
        repair_.begin(x);
        repair_.suspect_everything();
        (void)repair_.evaluate();
        update();
        report += repair_.report();
    }
    queue_.clear();
    std::fill(queued_.begin(), queued_.end(), char{0});
    if (!own)
        std::copy(x.begin(), x.end(), position_.begin());  // last: whoever fails before builds anew at the old ones
}

template <int d>
void Paper_queue<d>::place(Index v, const Coordinates<d>& p) {
    resize();
    position_[at(v)] = fixed_[at(v)] = p;
    epsilon_[at(v)] = unlimited;
    threshold_[at(v)] = 0.0;
}

template <int d>
void Paper_queue<d>::take_back() noexcept {
    position_.swap(noted_.position);
    fixed_.swap(noted_.fixed);
    epsilon_.swap(noted_.epsilon);
    threshold_.swap(noted_.threshold);
    queue_.clear();
    std::fill(queued_.begin(), queued_.end(), char{0});
}

template <int d>
void Paper_queue<d>::lower(Index v, double tolerance) {
    if (!(tolerance < epsilon_[at(v)])) return;
    epsilon_[at(v)] = tolerance;
    threshold_[at(v)] = squared_threshold_lower(tolerance);
    if (queued_[at(v)] || passes(v)) return;
    queued_[at(v)] = 1;
    queue_.push_back(v);
}

/// Tolerances of what has been evaluated, for the points of it.
template <int d>
void Paper_queue<d>::update() {
    const auto note = [this](const auto& s) {
        if (repair_.exists(s) && s.kind != Facet_kind::nothing) least_.note(s.point, s.verdict.tolerance);
    };
    for (const auto& s : repair_.facets()) note(s);
    if (repair_.kind() != Tolerance_kind::paper)
        for (const auto& s : repair_.cells()) note(s);
    lower_points();
}

template <int d>
void Paper_queue<d>::lower_points() {
    least_.take([this](Index w, double least) { lower(w, least); });
}

template <int d>
void Paper_queue<d>::refresh(std::span<const Cell_index> cells, Move_report& report) {
    resize();
    repair_.begin(fixed_);
    repair_.suspect_cells(cells);
    (void)repair_.evaluate();
    update();
    report += repair_.report();
    for (std::size_t i = 0; i < queue_.size(); ++i) process(queue_[i], report, false);
    queue_.clear();
}

template <int d>
void Paper_queue<d>::process(Index h, Move_report& report, bool first) {
    const Coordinates<d> old_fixed = fixed_[at(h)];
    fixed_[at(h)] = position_[at(h)];
    repair_.begin(fixed_, false);
    bool rebuilt = false;
    const bool held = repair_.star_holds(h, least_);
    bool holds = held;
    if (!held) {
        repair_.suspect_star(h);
        holds = repair_.evaluate();
    }
    if (!holds) {
        try {
            rebuilt = !repair_.mend_one(fixed_, h, old_fixed, Chooser<d>::most_generous_repair(mesh_.vertices()));
        } catch (const Error&) {
            fixed_[at(h)] = old_fixed;
            // Two vertices at one place among the fixed positions need not be so among the moving ones.
            rebuilt = true;
        }
    }
    queued_[at(h)] = 0;
    report += repair_.report();
    if (rebuilt) rebuild(h, old_fixed);  // or a collision, and nothing is counted
    if (first) {
        ++report.moves.asked;
        ++(holds                                    ? report.moves.kept_in_place
           : rebuilt                                ? report.moves.rebuilt
           : repair_.reinserted().empty()           ? report.moves.flipped
                                                    : report.moves.reinserted);
    } else {
        ++report.requeued;
    }
    if (rebuilt) {
        settle(position_, report);
        return;
    }
    epsilon_[at(h)] = unlimited;
    threshold_[at(h)] = 0.0;
    if (held) lower_points();
    else update();
}

/// At the moving positions, after repair gave up on h. Where two of them coincide the cells of before are built again.
template <int d>
void Paper_queue<d>::rebuild(Index h, const Coordinates<d>& old_fixed) {
    try {
        mesh_.rebuild(position_);
    } catch (const Error&) {
        fixed_[at(h)] = old_fixed;
        mesh_.rebuild(fixed_);
        throw;
    }
}

template <int d>
void Paper_queue<d>::move(Index v, const Coordinates<d>& p, Move_report& report) {
    const Coordinates<d> old = position_[at(v)];
    position_[at(v)] = p;
    if (passes(v)) {
        ++report.moves.asked;
        ++report.moves.within_tolerance;
        return;
    }
    const auto moves = report.moves;  // a vertex that meets another is asked to move again later
    try {
        process(v, report, true);
        for (std::size_t i = 0; i < queue_.size(); ++i) process(queue_[i], report, false);
    } catch (...) {
        report.moves = moves;
        position_[at(v)] = old;
        for (const Index w : queue_) queued_[at(w)] = 0;
        queue_.clear();
        throw;
    }
    queue_.clear();
}

template <int d>
void Paper_queue<d>::move_all(std::span<const Coordinates<d>> x, Move_report& report) {
    for (std::size_t v = 0; v < x.size(); ++v)
        if (mesh_.has(static_cast<Index>(v))) move(static_cast<Index>(v), x[v], report);
}

template class Paper_queue<2>;
template class Paper_queue<3>;

}  // namespace annulus
