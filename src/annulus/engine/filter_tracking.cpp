// SPDX-License-Identifier: GPL-3.0-or-later
// When `filter` keeps tolerances, and when it asks for signs alone. Nothing here has a say in what is right.
#include <annulus/engine/filter.h>

#include <algorithm>
#include <cmath>
#include <new>

namespace annulus {

namespace {
constexpr std::uint64_t check_interval = 8;  // steps without tolerances, between looks whether they would pay
}  // namespace

/// Whether tolerances have to be given up: so many failed, in this step and before, that with the signs of all certificates
/// instead a settling would have been paid for (rent or buy).
template <int d>
bool Filter<d>::too_dear() const {
    if (repair_.kind() == Tolerance_kind::paper) return false;
    const auto n = static_cast<double>(embedding_.vertices());
    return overdraft_ + Prices<d>::failure * static_cast<double>(failed_.size()) > (Prices<d>::settling + Prices<d>::signs) * n;
}

/// Whether looking for what expired would already cost a good part of what repair may.
template <int d>
bool Filter<d>::too_many_failed() const {
    return repair_.kind() != Tolerance_kind::paper && Prices<d>::failure * static_cast<double>(failed_.size()) > 0.25 * most_repair();
}

/// What a step of tolerances cost above what signs would have, or saved, is added up; savings are not put aside.
template <int d>
void Filter<d>::note_expenses(bool each) {
    const double price =
        Prices<d>::failure * static_cast<double>(failures_) + Prices<d>::evaluation * static_cast<double>(evaluated_);
    const double signs = (each ? Prices<d>::star : Prices<d>::signs) * static_cast<double>(embedding_.vertices());
    overdraft_ = std::max(0.0, overdraft_ + price - signs);
    failures_ = evaluated_ = 0;
}

/// Displacements are kept from time to time while no tolerances are.
template <int d>
void Filter<d>::note_displacements(std::span<const Coordinates<d>> x) {
    displacement_.clear();
    if (tracks_ || untracked_ % check_interval != 0) return;
    displacement_.resize(x.size());
    for (std::size_t v = 0; v < x.size(); ++v)
        if (table_.corner_of(static_cast<Index>(v)) != no_corner)
            for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k)
                displacement_[v][k] = x[v][k] - position_[v][k];
}

template <int d>
void Filter<d>::end_timestamp(bool each, Move_report& report) {
    if (tracks_) note_expenses(each);
    if (each) {
        const double settling = Prices<d>::settling * static_cast<double>(embedding_.vertices());
        if (!tracks_) ++untracked_;
        else if (overdraft_ > settling) stop_tracking();
    }
    reconsider(each, report);
}

/// By a sample of facets: a certificate of tolerance s expires after s / max |u| steps.
template <int d>
double Filter<d>::outlook(Move_report& report) {
    const Index bound = table_.facet_bound().value();
    const Index stride = 1 + bound / 1024;
    repair_.begin(position_, false);
    for (Index f = 0; f < bound; f += stride)
        if (table_.is_facet(Corner_index(f))) repair_.suspect_facet(Corner_index(f));
    (void)repair_.evaluate();
    report.evaluated += repair_.report().evaluated;
    report.arithmetic += repair_.report().arithmetic;
    double sum = 0.0;
    std::size_t sampled = 0;
    for (const auto& s : repair_.facets()) {
        if (s.kind != Facet_kind::empty_sphere) continue;
        double fastest = 0.0;
        for (const Index v : s.point)
            fastest = std::max(fastest, squared_distance<d>(displacement_[at(v)], Coordinates<d>{}));
        const double way = std::sqrt(fastest);
        const double room = s.verdict.tolerance;
        sum += way < room ? way / room : way > 0.0 ? 1.0 : 0.0;
        ++sampled;
    }
    return sum / static_cast<double>(std::max<std::size_t>(sampled, 1));
}

template <int d>
void Filter<d>::reconsider(bool each, Move_report& report) {
    if (displacement_.empty()) return;
    double share = 0.0;
    try {
        share = outlook(report);
    } catch (const std::bad_alloc&) {  // the timestamp has been made, and this has no say in what is right
        release(displacement_);
        return;
    }
    constexpr double margin = 0.75;  // the first of them costs a settling
    settles_next_ =
        Prices<d>::expected * Prices<d>::certificates * share <= margin * (each ? Prices<d>::star : Prices<d>::signs);
    release(displacement_);
}

/// At the end of a timestamp that was mended by signs (after a rebuild nothing is settled), not the one that found out: at its beginning
/// nobody knows whether a rebuild is to come. The two cost no more than a timestamp may.
template <int d>
void Filter<d>::settle_afterwards(Move_report& report) {
    static_assert(Chooser<d>::share + Prices<d>::settling < 1.45 * Prices<d>::rebuild);
    try {
        settle_if_it_pays(report);
    } catch (const std::bad_alloc&) {  // the timestamp has been made
    }
}

template <int d>
void Filter<d>::settle_if_it_pays(Move_report& report) {
    if (!settles_next_) return;
    settles_next_ = false;
    report.price += Prices<d>::settling * static_cast<double>(embedding_.vertices());
    settle(position_, report);
}

template class Filter<2>;
template class Filter<3>;

}  // namespace annulus
