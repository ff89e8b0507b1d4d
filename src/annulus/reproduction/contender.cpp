// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/reproduction/contender.h>

#include <annulus/engine/displacement.h>
#include <annulus/reproduction/processor_time.h>

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace annulus {

namespace {

/// Seconds of CGAL's insertion of a range into an empty triangulation. Making the points beforehand and destroying the
/// object afterwards are not counted.
template <int d>
double range_insertion(std::span<const Coordinates<d>> x) {
    using Moving = Moving_of<d>;
    std::vector<typename Moving::Point> points;
    points.reserve(x.size());
    for (const auto& p : x) points.push_back(std::apply([](auto... c) { return typename Moving::Point(c...); }, p));
    typename Moving::Triangulation triangulation;
    const double begin = processor_seconds();
    triangulation.insert(points.begin(), points.end());
    return processor_seconds() - begin;
}

}  // namespace

template <int d>
Contender<d>::Contender(Contender_plan plan, std::span<const Coordinates<d>> points, std::uint64_t seed)
    : plan_(std::move(plan)), random_(seed) {
    record_.name = plan_.name;
    if (plan_.kind == Contender_plan::Kind::follower) build(points);
}

template <int d>
void Contender<d>::build(std::span<const Coordinates<d>> points) {
    const double begin = processor_seconds();
    if (plan_.printed) printed_ = std::make_unique<Published_algorithm<d>>(points, *plan_.printed);
    else dt_ = std::make_unique<Moving_of<d>>(points, plan_.options);
    const double built = processor_seconds();
    if (dt_) (void)dt_->recompute_tolerances();  // a second time, to measure it
    else if (plan_.printed->tolerances) printed_->precompute();
    record_.first_seconds = built - begin;
    record_.precompute_seconds = processor_seconds() - built;
}

template <int d>
Move_report Contender<d>::move_all(std::span<const Coordinates<d>> target) {
    return dt_ ? dt_->move_all(target) : printed_->move_all(target);
}

template <int d>
void Contender<d>::count_streaks(std::uint64_t step) {
    if (!printed_ || plan_.kind != Contender_plan::Kind::follower) return;
    for (const Index i : printed_->failed()) {
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
void Contender<d>::note(std::uint64_t step, double seconds, const Move_report& report) {
    record_.step.push_back(step);
    record_.seconds.push_back(seconds);
    record_.asked.push_back(report.moves.asked);
    record_.failed.push_back(report.moves.asked - report.moves.within_tolerance);
    record_.requeued.push_back(report.requeued);
    record_.changed.push_back(report.moves.flipped + report.moves.reinserted + report.moves.rebuilt);
    record_.evaluated.push_back(report.evaluated);
}

template <int d>
void Contender<d>::audit(std::uint64_t step) {
    const Audit_result verdict = dt_ ? dt_->audit() : printed_->audit();
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
        case Contender_plan::Kind::cgal: return note(step, range_insertion<d>(target), {});
        case Contender_plan::Kind::hybrid: return follow_hybrid(step, before, target);
        case Contender_plan::Kind::copy: build(before); break;
        case Contender_plan::Kind::follower: break;
    }
    const double begin = processor_seconds();
    const Move_report report = move_all(target);
    note(step, processor_seconds() - begin, report);
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
    if (record_.switched_at == 0) return note(step, seconds + range_insertion<d>(target), {});
    const double begin = processor_seconds();
    const Move_report report = move_all(target);
    note(step, seconds + processor_seconds() - begin, report);
}

/// Times the tolerances of the sample, but not the construction of the triangulation with numbered vertices: a program
/// that rebuilds has one.
template <int d>
bool Contender<d>::sample_stays(std::span<const Coordinates<d>> before, std::span<const Coordinates<d>> target) {
    constexpr int sample = 40;
    constexpr double share = d == 2 ? 0.75 : 0.55;
    const Published_algorithm<d> dt(before, {.tolerances = false});
    const double begin = processor_seconds();
    int within = 0;
    for (int k = 0; k < sample; ++k) {
        const std::size_t v = random_() % before.size();
        within += distance_upper<d>(target[v], before[v]) < dt.tolerance(static_cast<Index>(v)) ? 1 : 0;
    }
    record_.sampling_seconds += processor_seconds() - begin;
    return within >= share * sample;
}

template <int d>
Contender_record Contender<d>::finish() {
    const std::uint64_t last = record_.step.empty() ? 0 : record_.step.back();
    if (is_built() && (last_audit_ != last || record_.audits == 0)) audit(last);
    return std::move(record_);
}

template class Contender<2>;
template class Contender<3>;

}  // namespace annulus
