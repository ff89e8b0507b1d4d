// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/tolerance_policy.h>

#include <annulus/engine/displacement.h>

#include <algorithm>
#include <cmath>
#include <new>

namespace annulus::inline v1 {

namespace {
constexpr std::uint64_t check_interval = 8;  // time steps without tolerances, between checks whether they would pay
}  // namespace

/// So many vertices failed, in this step and before, that using the signs of all certificates instead would have paid
/// for a recomputation of tolerances.
template <int d>
bool Tolerance_policy<d>::exceeds_budget(std::size_t failures, std::size_t vertices) const {
    return excess_cost_ + Cost_model<d>::failure * static_cast<double>(failures) >
           (Cost_model<d>::recomputation + Cost_model<d>::signs) * static_cast<double>(vertices);
}

/// Savings are not carried over.
template <int d>
bool Tolerance_policy<d>::end_step_with_tolerances(bool each, std::size_t vertices) {
    const double cost = Cost_model<d>::failure * static_cast<double>(failures_) +
                        Cost_model<d>::evaluation * static_cast<double>(evaluated_);
    const double signs = (each ? Cost_model<d>::star : Cost_model<d>::signs) * static_cast<double>(vertices);
    excess_cost_ = std::max(0.0, excess_cost_ + cost - signs);
    failures_ = evaluated_ = 0;
    return each && excess_cost_ > Cost_model<d>::recomputation * static_cast<double>(vertices);
}

template <int d>
void Tolerance_policy<d>::note_displacements(const Corner_table<d>& table, std::span<const Coordinates<d>> from,
                                             std::span<const Coordinates<d>> to) {
    displacement_.clear();
    if (!is_time_to_check()) return;
    displacement_.resize(to.size());
    for (std::size_t v = 0; v < to.size(); ++v)
        if (table.corner_of(static_cast<Index>(v)) != no_corner)
            for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) displacement_[v][k] = to[v][k] - from[v][k];
}

/// Evaluates a sample of facets between two cells, which the checker has then. False where tolerances are expensive,
/// mostly after a few of them: these cost a quarter of a rebuild, or one exact evaluation, if all are decided exactly.
template <int d>
bool Tolerance_policy<d>::evaluate_sample(const Corner_table<d>& table, Certificate_checker<d>& checker,
                                          std::span<const Coordinates<d>> x, Move_result& report) {
    constexpr std::size_t prime = 7919;  // more than the sample has, so that multiples of it visit all of it
    const Index bound = table.facet_bound().value();
    const Index stride = 1 + bound / 1024;
    std::vector<Corner_index> sample;
    for (Index f = 0; f < bound; f += stride)
        if (table.is_facet(Corner_index(f)) && facet_kind(table, Corner_index(f)) == Facet_kind::empty_sphere)
            sample.emplace_back(f);
    const double rebuild = Cost_model<d>::rebuild * static_cast<double>(table.vertex_bound());
    auto end = static_cast<std::size_t>(std::clamp(rebuild / (4.0 * exact_evaluation_cost), 1.0, 32.0));
    checker.begin(x);
    Stage_counts counts;
    for (std::size_t begin = 0; begin < sample.size(); begin = std::exchange(end, 2 * end)) {
        for (std::size_t i = begin; i < std::min(end, sample.size()); ++i)
            checker.add_new_facet(sample[prime * i % sample.size()]);
        const Stage_counts here = checker.evaluate_from(begin, 0);
        report.statistics.evaluated += here.total();
        report.statistics.arithmetic += here;
        report.statistics.cost += Certificate_checker<d>::later_cost(here);
        counts += here;
        if (are_too_expensive(counts)) return false;
    }
    return true;
}

/// The fraction of the certificates that would expire at a step like this one, by the facets of the sample: a
/// certificate of tolerance s expires after s / max |u| steps.
template <int d>
double Tolerance_policy<d>::expired_share(const Certificate_checker<d>& checker) const {
    double sum = 0.0;
    for (const auto& s : checker.facets()) {
        double fastest = 0.0;
        for (const auto& [v, label] : s.point)
            fastest =
                std::max(fastest, squared_distance<d>(displacement_[static_cast<std::size_t>(v)], Coordinates<d>{}));
        const double way = std::sqrt(fastest);
        const double room = s.value.tolerance;
        sum += way < room ? way / room : way > 0.0 ? 1.0 : 0.0;
    }
    return sum / static_cast<double>(std::max<std::size_t>(checker.facets().size(), 1));
}

template <int d>
void Tolerance_policy<d>::reconsider(const Corner_table<d>& table, Certificate_checker<d>& checker,
                                     std::span<const Coordinates<d>> x, bool each, Move_result& report) {
    if (displacement_.empty()) return;
    double share = 0.0;
    try {
        share = evaluate_sample(table, checker, x, report) ? expired_share(checker) : 1.0;
    } catch (const std::bad_alloc&) {  // the time step has been made; correctness does not depend on this
        release(displacement_);
        return;
    }
    decide(share, each);
    release(displacement_);
}

template <int d>
bool Tolerance_policy<d>::is_time_to_check() const {
    return steps_without_ % check_interval == 0;
}

template <int d>
void Tolerance_policy<d>::decide(double share, bool each) {
    constexpr double margin = 0.75;  // the first of them costs a recomputation of tolerances
    recomputes_next_ = Cost_model<d>::expected * Cost_model<d>::certificates * share <=
                       margin * (each ? Cost_model<d>::star : Cost_model<d>::signs);
}

/// What it costs is in excess of signs, which the steps in between have to save.
template <int d>
bool Tolerance_policy<d>::renews(std::size_t vertices) {
    excess_cost_ += Cost_model<d>::recomputation * static_cast<double>(vertices);
    return excess_cost_ <= (Cost_model<d>::recomputation + Cost_model<d>::signs) * static_cast<double>(vertices);
}

/// The signs around one vertex cost a thousandth of a recomputation of tolerances, which then pays for the moves to
/// come (the ski-rental rule). Moves that needed flips, or more, do not count: no tolerance lets them pass.
template <int d>
bool Tolerance_policy<d>::recomputes_for_single_move(const Corner_table<d>& table, Certificate_checker<d>& checker,
                                                     std::span<const Coordinates<d>> x, std::size_t vertices,
                                                     Move_result& report) {
    constexpr std::uint64_t share = 64;
    if (share * (calm_moves_ + 1) <= vertices) return false;
    if (evaluate_sample(table, checker, x, report)) return true;
    calm_moves_ = 0;  // asked again after as many
    return false;
}

/// Adds up what tolerances cost in excess of signs, as for time steps.
template <int d>
bool Tolerance_policy<d>::end_single_move(std::size_t vertices) {
    const double cost = Cost_model<d>::failure * static_cast<double>(failures_) +
                        Cost_model<d>::evaluation * static_cast<double>(evaluated_);
    excess_cost_ = std::max(0.0, excess_cost_ + cost - Cost_model<d>::star);
    failures_ = evaluated_ = 0;
    return excess_cost_ > Cost_model<d>::recomputation * static_cast<double>(vertices);
}

template <int d>
void Tolerance_policy<d>::note_recomputed() {
    failures_ = evaluated_ = 0;
    excess_cost_ = 0.0;
    recomputes_next_ = false;
}

template <int d>
void Tolerance_policy<d>::note_dropped() {
    recomputes_next_ = false;
    steps_without_ = 0;
    calm_moves_ = 0;
}

template class Tolerance_policy<2>;
template class Tolerance_policy<3>;

}  // namespace annulus::inline v1
