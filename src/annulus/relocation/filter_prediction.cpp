// SPDX-License-Identifier: GPL-3.0-or-later
// When `filter` predicts a motion, and when it stops.
#include <annulus/relocation/filter.h>

#include <algorithm>

namespace annulus {

namespace {
// Prices in units of 400 ns, measured.
template <int d>
struct Prices;
template <>
struct Prices<2> {
    static constexpr double failure = 0.4;
    static constexpr double evaluation = 0.6;
    static constexpr double signs = 0.11;    // of all signs, a vertex
    static constexpr double star = 0.5;      // of the signs around a vertex that moves alone
    static constexpr double settling = 0.8;  // a vertex
    // Of a certificate that the outlook lets expire, which is more than do.
    static constexpr double resting = 0.74;
    static constexpr double predicted = 0.38;
};
template <>
struct Prices<3> {
    static constexpr double failure = 4.0;
    static constexpr double evaluation = 1.0;
    static constexpr double signs = 1.2;
    static constexpr double star = 5.5;
    static constexpr double settling = 12.0;
    static constexpr double resting = 2.5;
    static constexpr double predicted = 2.5;
};
constexpr std::size_t patience = 3;          // failures a vertex after which another prediction is considered
constexpr std::uint64_t check_interval = 8;  // steps without tolerances, between looks whether they would pay
}  // namespace

/// Whether tolerances have to be given up: so many failed, in this step and before, that with the signs of all certificates
/// instead a settling would have been paid for (rent or buy).
template <int d>
bool Filter<d>::too_dear() const {
    if (repair_.kind() == Tolerance_kind::paper) return false;
    const auto n = static_cast<double>(embedding_.vertices());
    return overdraft_ + static_cast<double>(failed_.size()) > (Prices<d>::settling + Prices<d>::signs) * n;
}

template <int d>
void Filter<d>::note_expenses(bool each) {
    spent_ += failures_;
    const double price =
        Prices<d>::failure * static_cast<double>(failures_) + Prices<d>::evaluation * static_cast<double>(evaluated_);
    const double signs = each ? Prices<d>::star : Prices<d>::signs;
    if (failures_ > 0) overdraft_ += std::max(0.0, price - signs * static_cast<double>(embedding_.vertices()));
    failures_ = evaluated_ = 0;
}

/// Displacements of two consecutive steps are compared once as much was spent on failures as is worth a look (rent or
/// buy), and from time to time while no tolerances are kept.
template <int d>
void Filter<d>::note_displacements(std::span<const Coordinates<d>> x, bool each) {
    this_step_.clear();
    if (tracks_ ? each || spent_ < patience * x.size() : untracked_ % check_interval > 1) return;
    this_step_.resize(x.size());
    for (std::size_t v = 0; v < x.size(); ++v)
        if (table_.corner_of(static_cast<Index>(v)) != none)
            for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) this_step_[v][k] = x[v][k] - position_[v][k];
}

template <int d>
void Filter<d>::end_timestamp(bool each, Move_report& report) {
    note_expenses(each);
    if (each) {
        const double settling = Prices<d>::settling * static_cast<double>(embedding_.vertices());
        if (!tracks_) ++untracked_;
        else if (overdraft_ > settling) stop_tracking();
    }
    reconsider(each, report);
}

/// By a sample of facets. At rest a certificate of tolerance s expires after s / max |u| steps. Under a prediction its term
/// ends after (1 - share) s / rho steps, and deviations, when velocities change by a at every step beyond what the clock
/// follows, have used share s up after sqrt(2 share s / a) steps.
template <int d>
auto Filter<d>::outlook(double pace, Move_report& report) -> Outlook {
    constexpr double share = Prediction<d>::deviation_share;
    const Index stride = 1 + table_.facet_bound() / 512;
    repair_.begin(position_, false);
    for (Index f = 0; f < table_.facet_bound(); f += stride)
        if (table_.is_facet(f)) repair_.suspect_facet(f);
    (void)repair_.evaluate();
    report.evaluated += repair_.report().evaluated;
    report.arithmetic += repair_.report().arithmetic;
    Outlook sum;
    std::size_t sampled = 0;
    for (const auto& s : repair_.facets()) {
        if (s.kind != Facet_kind::empty_sphere) continue;
        double fastest = 0.0;
        double change = 0.0;
        for (const Index v : s.point) {
            fastest = std::max(fastest, squared_distance<d>(this_step_[at(v)], Coordinates<d>{}));
            Coordinates<d> slowed = last_step_[at(v)];
            for (double& c : slowed) c *= pace;
            change = std::max(change, squared_distance<d>(this_step_[at(v)], slowed));
        }
        const double rho = Prediction<d>::spread(s.point, [this](Index v) { return this_step_[at(v)]; });
        const double room = s.verdict.tolerance;
        const auto rate = [](double cost, double budget) {
            return cost < budget ? cost / budget : cost > 0.0 ? 1.0 : 0.0;
        };
        sum.resting += rate(std::sqrt(fastest), room);
        sum.predicted +=
            std::max(rate(rho, (1.0 - share) * room), std::sqrt(rate(std::sqrt(change), 2.0 * share * room)));
        ++sampled;
    }
    const double scale = 1.0 / static_cast<double>(std::max<std::size_t>(sampled, 1));
    return {sum.resting * scale, sum.predicted * scale};
}

/// With two consecutive displacements at hand: how to go on.
template <int d>
void Filter<d>::reconsider(bool each, Move_report& report) {
    if (this_step_.empty()) {
        last_step_.clear();
        return;
    }
    if (last_step_.size() != this_step_.size()) {
        std::swap(last_step_, this_step_);
        return;
    }
    double along = 0.0;
    double before = 0.0;
    for (std::size_t v = 0; v < this_step_.size(); ++v)
        for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) {
            along += this_step_[v][k] * last_step_[v][k];
            before += last_step_[v][k] * last_step_[v][k];
        }
    const Outlook o = outlook(before > 0.0 ? along / before : 0.0, report);
    last_step_.clear();
    spent_ = 0;
    // Facets and cells a vertex.
    const double certificates = d == 2 ? 5.0 : 20.0;
    const double at_rest = Prices<d>::resting * certificates * o.resting;
    const double on_course = Prices<d>::predicted * certificates * o.predicted;
    const bool predict = !each && on_course < at_rest;
    if (!tracks_ && (predict ? on_course : at_rest) > (each ? Prices<d>::star : Prices<d>::signs)) return;
    if (predict) {
        prediction_.adopt(this_step_, vertex_, reach());
        settle_here(report);
    } else if (prediction_.active() || !tracks_) {
        settle(position_, report);
    }
}

template class Filter<2>;
template class Filter<3>;

}  // namespace annulus
