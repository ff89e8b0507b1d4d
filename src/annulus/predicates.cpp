// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/predicates.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/arithmetic/environment.h>
#include <annulus/predicate/circumcircle_2.h>
#include <annulus/predicate/circumsphere_3.h>
#include <annulus/predicate/half_width.h>
#include <annulus/predicate/sure_orientation.h>
#include <annulus/predicate/theta.h>
#include <annulus/predicate/tolerances.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

namespace annulus::inline v1 {

namespace {

template <int d, int k>
using Row = std::array<Coordinates<d>, static_cast<std::size_t>(k)>;

template <int d, int k>
Tuple<d, k> tuple_of(const Row<d, k>& row) {
    Tuple<d, k> x{};
    for (std::size_t i = 0; i < row.size(); ++i) x[i] = &row[i];
    return x;
}

/// The exact orientation and the stage that decided it.
template <int d>
Staged_sign staged_orientation(const Tuple<d, d + 1>& x) {
    const int sign = orientation_sign(x);
    return sign != 0 ? Staged_sign{static_cast<std::int8_t>(sign), Stage::filter} : exact_orientation_sign(x);
}

void set_width(const Half_width& half, Certified_sign& out) {
    out.width_lower = 2.0 * half.lower;
    out.width_upper = 2.0 * half.upper;
}

template <int d>
Certified_sign evaluate(const Row<d, d + 1>& row) {
    Tuple<d, d + 1> x = tuple_of<d, d + 1>(row);
    const Staged_sign s = staged_orientation<d>(x);
    Certified_sign out{s.sign, 0.0, 0.0, 0.0, std::numeric_limits<double>::quiet_NaN(), s.stage};
    if (s.sign == 0) return out;
    if (s.sign < 0) std::swap(x[0], x[1]);
    out.tolerance = evaluate_orientation(x).tolerance;
    Half_width half;
    enclose(std::span<const Tuple<d, d + 1>>(&x, 1), Width::least, std::span(&half, 1));
    set_width(half, out);
    return out;
}

// ---- Spheres ----------------------------------------------------------------------------------------------------

Circumcircle_2 sphere_of(const Tuple<2, 3>& x) { return {*x[0], *x[1], *x[2]}; }
Circumsphere_3 sphere_of(const Tuple<3, 4>& x) { return {*x[0], *x[1], *x[2], *x[3]}; }

/// Whether the last point is inside (1) or outside (-1) the sphere of the others, which have this orientation: exact,
/// with the sign of the orientation as a factor.
template <int d>
Staged_sign staged_in_sphere(const Tuple<d, d + 2>& x, int orientation) {
    Tuple<d, d + 1> cell{};
    std::copy_n(x.begin(), d + 1, cell.begin());
    const Coordinates<d>& p = *x[d + 1];
    if (orientation < 0) std::swap(cell[0], cell[1]);
    const auto sphere = sphere_of(cell);
    if (orientation != 0 && sphere.positive()) {
        const auto sign = static_cast<std::int8_t>(orientation);
        if (sphere.contains(p)) return {sign, Stage::filter};
        if (sphere.excludes(p)) return {static_cast<std::int8_t>(-sign), Stage::filter};
    }
    Tuple<d, d + 2> in_order = x;  // the exact predicate has the last corner of the cell last; it is positive outside
    std::swap(in_order[d], in_order[d + 1]);
    const Staged_sign outside = exact_empty_sphere_sign(in_order);
    return {static_cast<std::int8_t>(-outside.sign), outside.stage};
}

/// The signs of the affine dependence lambda of d + 2 points (docs/theory.md 2.2), such that the sum of
/// lambda_i |x_i|^2 has the sign of in_circle or in_sphere: that of point i is the orientation of the others, with
/// signs that alternate.
template <int d>
std::array<int, static_cast<std::size_t>(d) + 2> dependence(const Tuple<d, d + 2>& x) {
    std::array<int, static_cast<std::size_t>(d) + 2> lambda{};
    for (std::size_t i = 0; i < lambda.size(); ++i) {
        Tuple<d, d + 1> others{};
        for (std::size_t j = 0, k = 0; j < lambda.size(); ++j)
            if (j != i) others[k++] = x[j];
        const int sign = sure_orientation<d>(others);
        lambda[i] = (d + 1 - i) % 2 == 0 ? -sign : sign;
    }
    return lambda;
}

/// The bi-cell with opposite vertices p < q, whose lambda have the sign `side`: they are on different sides of the
/// facet of the others. In the order of the predicates, both cells positive.
template <int d>
Tuple<d, d + 2> bicell(const Tuple<d, d + 2>& x, std::size_t p, std::size_t q, int side) {
    Tuple<d, d + 2> out{};
    std::size_t k = 0;
    for (std::size_t j = 0; j < x.size(); ++j)
        if (j != p && j != q) out[k++] = x[j];
    // lambda_p gives the orientation of all but p in their order, in which d + 1 - q points come after q.
    const int without_p = (d + 1 - p) % 2 == 0 ? -side : side;
    const bool q_in_front = ((d + 1 - q) % 2 == 0 ? without_p : -without_p) > 0;
    out[d] = x[q_in_front ? p : q];
    out[d + 1] = x[q_in_front ? q : p];
    return out;
}

template <int d>
double theta_of(const Tuple<d, d + 2>& x) {
    return std::apply([](const auto*... p) { return theta(*p...); }, x);
}

template <int d>
Certified_sign evaluate(const Row<d, d + 2>& row) {
    const Tuple<d, d + 2> x = tuple_of<d, d + 2>(row);
    const auto lambda = dependence<d>(x);
    const Staged_sign s = staged_in_sphere<d>(x, -lambda[d + 1]);
    Certified_sign out{s.sign, 0.0, 0.0, 0.0, 0.0, s.stage};
    Tuple<d, d + 2> best{};
    bool found = false;
    for (std::size_t p = 0; p < x.size(); ++p)
        for (std::size_t q = p + 1; q < x.size(); ++q) {
            if (lambda[p] == 0 || lambda[p] != lambda[q] || (s.sign != 0 && lambda[p] != s.sign)) continue;
            const auto cells = bicell<d>(x, p, q, lambda[p]);
            const double tolerance = s.sign == 0 ? 0.0 : evaluate_sign_tolerance(cells).tolerance;
            const double angle = theta_of<d>(cells);
            if (found && (tolerance < out.tolerance || (tolerance == out.tolerance && angle >= out.theta))) continue;
            found = true;
            best = cells;
            out.tolerance = tolerance;
            out.theta = angle;
        }
    if (s.sign == 0) return out;
    assert(found);  // points that are not on a sphere have a Delaunay triangulation with an inner facet
    Bicell_half_widths half;
    enclose(std::span<const Tuple<d, d + 2>>(&best, 1), std::span(&half, 1));
    set_width(half.standard, out);
    return out;
}

// ---- Checks -----------------------------------------------------------------------------------------------------

template <int d, int k>
Certified_sign one(const Row<d, k>& row) {
    require_sound_environment();
    require_in_domain(std::span<const Coordinates<d>>(row), "point");
    return evaluate<d>(row);
}

template <int d, int k>
void all(std::span<const Row<d, k>> rows, std::span<Certified_sign> out) {
    assert(rows.size() == out.size());
    require_sound_environment();
    const std::span<const Coordinates<d>> points(rows.empty() ? nullptr : rows.front().data(), k * rows.size());
    require_in_domain(points, "row", [](std::size_t i) { return static_cast<std::int64_t>(i / k); });
    for (std::size_t r = 0; r < rows.size(); ++r) out[r] = evaluate<d>(rows[r]);
}

}  // namespace

Certified_sign orient_2d(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& c) {
    return one<2, 3>({a, b, c});
}
Certified_sign orient_3d(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c,
                         const Coordinates<3>& d) {
    return one<3, 4>({a, b, c, d});
}
Certified_sign in_circle(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& c,
                         const Coordinates<2>& d) {
    return one<2, 4>({a, b, c, d});
}
Certified_sign in_sphere(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c,
                         const Coordinates<3>& d, const Coordinates<3>& e) {
    return one<3, 5>({a, b, c, d, e});
}

void orient_2d(std::span<const std::array<Coordinates<2>, 3>> points, std::span<Certified_sign> out) {
    all<2, 3>(points, out);
}
void orient_3d(std::span<const std::array<Coordinates<3>, 4>> points, std::span<Certified_sign> out) {
    all<3, 4>(points, out);
}
void in_circle(std::span<const std::array<Coordinates<2>, 4>> points, std::span<Certified_sign> out) {
    all<2, 4>(points, out);
}
void in_sphere(std::span<const std::array<Coordinates<3>, 5>> points, std::span<Certified_sign> out) {
    all<3, 5>(points, out);
}

}  // namespace annulus::inline v1
