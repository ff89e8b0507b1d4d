// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic_tolerances: how they begin, what is left of them, what they are worth. A step: periodic_tolerances_step.cpp.
#include <annulus/engine/periodic_tolerances.h>

#include <annulus/engine/displacement.h>
#include <annulus/engine/tolerance_policy.h>
#include <annulus/internal/grow.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace annulus::inline v1 {

namespace {

constexpr double no_tolerance = std::numeric_limits<double>::quiet_NaN();
constexpr double typical_radius = 1.25;  // of certificates, in spacings

/// All ids of a table, in order.
template <int d>
std::vector<Certificate_id> all_certificates(const Periodic_table<d>& table) {
    std::vector<Certificate_id> ids;
    ids.reserve(table.size() * (d + 3) / 2 + 1);
    for (std::size_t c = 0; c < table.size(); ++c) {
        ids.push_back(periodic_cell_id(c));
        for (std::size_t i = 0; i <= d; ++i)
            if (table.corner(c, i) < table.twin[c][i]) ids.push_back(id_of_facet(table.corner(c, i)));
    }
    return ids;
}

/// Calls take(certificates) with some at a time, so that all of them need no memory at once.
template <int d, class Take>
Stage_counts evaluate_all(const Periodic_view<d>& view, int threads, Take take) {
    constexpr std::size_t some = std::size_t{1} << 14;
    const std::vector<Certificate_id> ids = all_certificates<d>(view.table);
    std::vector<Evaluated_certificate<d>> evaluated;
    Stage_counts counts;
    for (std::size_t first = 0; first < ids.size(); first += some) {
        const auto here = std::span(ids).subspan(first, std::min(some, ids.size() - first));
        evaluated.resize(here.size());
        counts += evaluate_periodic<d>(view, here, threads, evaluated);
        take(std::span<const Evaluated_certificate<d>>(evaluated));
    }
    return counts;
}

/// A tolerance that a place keeps when it is rounded to the grid.
template <int d>
double on_grid_lower(double tolerance, const Coordinates<d>& grid) {
    double squares = 0;
    for (const double g : grid) squares += g * g;
    const double left = tolerance - std::sqrt(squares) * (1 + 0x1p-40);
    return std::max(0.0, left - left * 0x1p-50);
}

}  // namespace

template <int d>
void Periodic_tolerances<d>::drop() noexcept {
    kept_ = false;
    release(of_.vertex);
    release(of_.list);
    of_.expiries.free();
}

template <int d>
void Periodic_tolerances<d>::resize(const Periodic_view<d>& view) {
    of_.vertex.resize(view.place.size());
    of_.list.resize(view.place.size());
    of_.expiries.resize(Cell_index(static_cast<Index>(view.table.size())));
}

template <int d>
Stage_counts Periodic_tolerances<d>::recompute(const Periodic_view<d>& view, double spacing) {
    kept_ = false;
    box_.begin(view.lattice);
    reach_ = typical_radius * spacing;
    resize(view);
    std::fill(of_.list.begin(), of_.list.end(), Vertex_expiries<d>{});
    for (std::size_t v = 0; v < view.place.size(); ++v)
        of_.vertex[v] = {is_place<d>(view.place[v]) ? box_.anchor(view.place[v]) : view.place[v], 0};
    const Stage_counts counts = evaluate_all<d>(view, threads_, [&](std::span<const Evaluated> some) {
        for (const Evaluated& e : some) write(view.table, e);
    });
    for (std::size_t v = 0; v < view.place.size(); ++v) set_until(static_cast<Index>(v));
    kept_ = true;
    return counts;
}

template <int d>
std::vector<double> Periodic_tolerances<d>::left(const Periodic_view<d>& view) const {
    std::vector<double> tolerance(view.place.size(), no_tolerance);
    const double gone = gone_upper();
    for (std::size_t v = 0; v < tolerance.size(); ++v) {
        if (!is_place<d>(view.place[v])) continue;
        const Record& r = of_.vertex[v];
        const double way = sum_upper(distance_upper<d>(box_.comoving(view.place[v]), r.anchor), gone);
        const double left = r.until - way;  // a difference of doubles is off by u of it
        tolerance[v] =
            left > 0 ? on_grid_lower<d>(left / Reference_box<d>::stretch_upper * (1 - 0x1p-50), view.lattice.grid())
                     : 0;
    }
    return tolerance;
}

template <int d>
std::vector<double> Periodic_tolerances<d>::evaluate(const Periodic_view<d>& view, int threads) {
    std::vector<double> tolerance(view.place.size(), std::numeric_limits<double>::infinity());
    (void)evaluate_all<d>(view, threads, [&](std::span<const Evaluated> some) {
        for (const Evaluated& e : some)
            for (const Index v : e.vertex)
                if (v != none) tolerance[at(v)] = std::min(tolerance[at(v)], e.tolerance);
    });
    for (std::size_t v = 0; v < tolerance.size(); ++v)
        tolerance[v] = is_place<d>(view.place[v]) ? on_grid_lower<d>(tolerance[v], view.lattice.grid()) : no_tolerance;
    return tolerance;
}

template <int d>
double Periodic_tolerances<d>::expected_share(const Periodic_view<d>& view, Periodic_motion<d>& motion,
                                              const Lattice<d>& before, double spacing, Move_statistics& statistics) {
    Reference_box<d> box;
    box.begin(before);
    if (motion.relabels_home() || !box.follow(view.lattice)) return 1;
    const double deviation = box.deviation_upper(), reach = typical_radius * spacing;
    const auto home = motion.home();
    const auto goal = motion.goal();
    std::vector<Certificate_id> ids;
    const std::size_t stride = 1 + view.table.size() * (d + 1) / 1024;  // of half-facets: 512 facets or so
    for (std::size_t k = 0; k < view.table.size() * (d + 1); k += stride) {
        const Corner_index h = view.table.corner(k / (d + 1), k % (d + 1));
        if (h < view.table.twin[k / (d + 1)][k % (d + 1)]) ids.push_back(id_of_facet(h));
    }
    std::vector<Evaluated> sample(ids.size());
    const Stage_counts counts = evaluate_periodic<d>(view, ids, 1, sample);
    statistics.evaluated += counts.total();
    statistics.arithmetic += counts;
    if (Tolerance_policy<d>::are_too_expensive(counts)) return 1;
    double sum = 0;
    for (const Evaluated& e : sample) {
        double fastest = 0;
        for (const Index v : e.vertex) fastest = std::max(fastest, squared_distance<d>(home[at(v)], goal[at(v)]));
        const double way = std::sqrt(fastest) + std::max(reach, e.radius) * deviation;
        sum += way < e.tolerance ? way / e.tolerance : 1;
    }
    return sum / static_cast<double>(std::max<std::size_t>(sample.size(), 1));
}

template class Periodic_tolerances<2>;
template class Periodic_tolerances<3>;

}  // namespace annulus::inline v1
