// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/contender.h>

#include <apps/report/processor_time.h>
#include <apps/reproduction/cgal_costs.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace annulus::inline v1 {

template <int d>
Contender<d>::Contender(Contender_plan plan, std::span<const Coordinates<d>> points, std::uint64_t seed)
    : plan_(std::move(plan)), random_(seed) {
    record_.name = plan_.name;
    if (plan_.kind == Contender_plan::Kind::follower) build(points);
}

template <int d>
void Contender<d>::build(std::span<const Coordinates<d>> points) {
    const double begin = processor_seconds();
    dt_ = std::make_unique<Follower<d>>(points, plan_.options, plan_.paper);
    const double built = processor_seconds();
    dt_->recompute_tolerances();  // a second time, to measure it
    record_.first_seconds = built - begin;
    record_.precompute_seconds = processor_seconds() - built;
}

/// `more`: seconds that this step has already taken.
template <int d>
void Contender<d>::move_all(std::uint64_t step, std::span<const Coordinates<d>> target, double more) {
    const double begin = processor_seconds();
    const Move_result report = dt_->move_all(target);
    note(step, more + processor_seconds() - begin, report);
}

template <int d>
void Contender<d>::count_streaks(std::uint64_t step) {
    if (dt_->paper_strategy() == nullptr || plan_.kind != Contender_plan::Kind::follower) return;
    for (const Index i : dt_->paper_strategy()->failed()) {
        const auto v = static_cast<std::size_t>(i);
        streak_.resize(std::max(streak_.size(), v + 1));
        last_failure_.resize(streak_.size());
        streak_[v] = last_failure_[v] + 1 == step ? streak_[v] + 1 : 1;
        last_failure_[v] = step;
    }
    record_.streaks.assign(std::size(streak_lengths), 0);
    for (std::size_t v = 0; v < streak_.size(); ++v)
        for (std::size_t k = 0; k < std::size(streak_lengths); ++k)
            record_.streaks[k] += last_failure_[v] == step && streak_[v] >= streak_lengths[k] ? 1U : 0U;
}

template <int d>
void Contender<d>::note(std::uint64_t step, double seconds, const Move_result& report) {
    record_.step.push_back(step);
    record_.seconds.push_back(seconds);
    record_.asked.push_back(report.moves.asked);
    record_.failed.push_back(report.moves.asked - report.moves.within_tolerance);
    record_.requeued.push_back(report.statistics.requeued);
    record_.changed.push_back(report.moves.flipped + report.moves.reinserted + report.moves.rebuilt);
    record_.evaluated.push_back(report.statistics.evaluated);
}

template <int d>
void Contender<d>::audit(std::uint64_t step) {
    const Audit_result verdict = dt_->audit();
    last_audit_ = step;
    ++record_.audits;
    if (verdict.delaunay()) return;
    if (record_.audits_failed++ == 0) record_.first_fault = "step " + std::to_string(step) + ": " + verdict.first_fault;
}

template <int d>
void Contender<d>::follow(std::uint64_t step, std::span<const Coordinates<d>> before,
                          std::span<const Coordinates<d>> target) {
    if (step % plan_.every != 0) return;
    switch (plan_.kind) {
        case Contender_plan::Kind::cgal_rebuild: return note(step, time_range_insertion<d>(target), {});
        case Contender_plan::Kind::cgal_relocate: return note(step, time_relocation<d>(before, target), {});
        case Contender_plan::Kind::hybrid: return follow_hybrid(step, before, target);
        case Contender_plan::Kind::copy: build(before); break;
        case Contender_plan::Kind::follower: break;
    }
    move_all(step, target, 0);
    count_streaks(step);
    if (plan_.audit_every > 0 && step % plan_.audit_every == 0) audit(step);
}

/// The paper samples 40 random vertices at each group of four iterations.
template <int d>
void Contender<d>::follow_hybrid(std::uint64_t step, std::span<const Coordinates<d>> before,
                                 std::span<const Coordinates<d>> target) {
    double seconds = 0;
    if (record_.switched_at == 0 && step % 4 == 1) {
        const double sampled = record_.sampling_seconds;
        const bool stays = sample_stays(before, target);
        seconds = record_.sampling_seconds - sampled;
        if (stays) {
            record_.switched_at = step;
            build(before);
            seconds += record_.first_seconds;
        }
    }
    if (record_.switched_at == 0) return note(step, seconds + time_range_insertion<d>(target), {});
    move_all(step, target, seconds);
}

/// Times the tolerances of the sample, but not the construction of the triangulation with numbered vertices: a program
/// that rebuilds has one.
template <int d>
bool Contender<d>::sample_stays(std::span<const Coordinates<d>> before, std::span<const Coordinates<d>> target) {
    Options options;
    options.seed = random_();
    Follower<d> dt(before, options, Paper_choice{.rebuild_first = true});
    Move_result report;
    const double begin = processor_seconds();
    const bool stays = dt.paper_strategy()->sample_stays(target, report);
    record_.sampling_seconds += processor_seconds() - begin;
    return stays;
}

template <int d>
Contender_record Contender<d>::finish() {
    const std::uint64_t last = record_.step.empty() ? 0 : record_.step.back();
    if (dt_ && (last_audit_ != last || record_.audits == 0)) audit(last);
    return std::move(record_);
}

template class Contender<2>;
template class Contender<3>;

}  // namespace annulus::inline v1
