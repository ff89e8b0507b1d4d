// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/table_measures.h>

#include <annulus/mesh/at.h>
#include <annulus/mesh/evaluate.h>

#include <algorithm>
#include <limits>

namespace annulus::inline v1 {

namespace {

constexpr double right_angle = 1.5707963267948966;

/// The positions of points. Where a point is `none` the value does not matter.
template <int d, std::size_t k>
std::array<Coordinates<d>, k> places(std::span<const Coordinates<d>> x, const std::array<Site<d>, k>& point) {
    std::array<Coordinates<d>, k> y{};
    for (std::size_t i = 0; i < k; ++i)
        if (point[i].vertex != none) y[i] = x[at(point[i].vertex)];
    return y;
}

/// Calls visit(value) for every certificate of v until it returns false.
template <int d, class Visit>
void for_each_value(const Corner_table<d>& t, std::span<const Coordinates<d>> x, Index v, Visit visit) {
    bool on = true;
    for_each_certificate(
        t, v,
        [&](Corner_index h) {
            if (on && !t.is_infinite(t.cell_of(h)))
                on = visit(evaluate_cell(places<d>(x, cell_sites(t, t.cell_of(h)))));
        },
        [&](Corner_index h) {
            if (!on) return;
            const Facet_certificate<d> f = facet_certificate(t, h, false);
            on = visit(evaluate_facet(f.kind, places<d>(x, f.point)));
        });
}

}  // namespace

template <int d>
double star_tolerance(const Corner_table<d>& t, std::span<const Coordinates<d>> x, Index v) {
    double least = std::numeric_limits<double>::infinity();
    for_each_value(t, x, v, [&](const Certificate_value& value) {
        least = std::min(least, value.tolerance);
        return true;
    });
    return least;
}

template <int d>
bool star_holds(const Corner_table<d>& t, std::span<const Coordinates<d>> x, Index v) {
    bool holds = true;
    for_each_value(t, x, v, [&](const Certificate_value& value) { return holds = value.sign > 0; });
    return holds;
}

template <int d>
double star_theta(const Corner_table<d>& t, std::span<const Coordinates<d>> x, Index v) {
    double least = right_angle;
    for_each_certificate(
        t, v, [](Corner_index) {},
        [&](Corner_index h) {
            const Facet_certificate<d> f = facet_certificate(t, h, false);
            if (f.kind == Facet_kind::empty_sphere) least = std::min(least, bicell_theta(places<d>(x, f.point)));
        });
    return least;
}

template <int d>
Measures measure(const Corner_table<d>& t, std::span<const Coordinates<d>> x) {
    Measures m;
    m.tolerance.assign(x.size(), std::numeric_limits<double>::infinity());
    const auto lower = [&](const auto& points, double tolerance) {
        for (const auto& [v, label] : points)
            if (v != none) m.tolerance[at(v)] = std::min(m.tolerance[at(v)], tolerance);
    };
    for (const Cell_index c : t.finite_cells())
        lower(cell_sites(t, c), evaluate_cell(places<d>(x, cell_sites(t, c))).tolerance);
    for (const Corner_index h : t.facets()) {
        const Facet_certificate<d> f = facet_certificate(t, h, false);
        if (f.kind == Facet_kind::nothing) continue;
        const auto y = places<d>(x, f.point);
        lower(f.point, evaluate_facet(f.kind, y).tolerance);
        if (f.kind != Facet_kind::empty_sphere) continue;
        m.annulus_width.push_back(annulus_width_lower(y));
        m.theta_min = std::min(m.theta_min, bicell_theta(y));
    }
    return m;
}

#define ANNULUS_INSTANTIATE(d)                                                                         \
    template double star_tolerance<d>(const Corner_table<d>&, std::span<const Coordinates<d>>, Index); \
    template double star_theta<d>(const Corner_table<d>&, std::span<const Coordinates<d>>, Index);     \
    template bool star_holds<d>(const Corner_table<d>&, std::span<const Coordinates<d>>, Index);       \
    template Measures measure<d>(const Corner_table<d>&, std::span<const Coordinates<d>>);
ANNULUS_INSTANTIATE(2)
ANNULUS_INSTANTIATE(3)
#undef ANNULUS_INSTANTIATE

}  // namespace annulus::inline v1
