// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/box_change.h>

#include <apps/report/axis_ticks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace annulus::inline v1 {

namespace {

using Vector = std::vector<double>;
using Vectors = std::vector<Vector>;

double product(const Vector& a, const Vector& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }
double length(const Vector& a) { return std::sqrt(product(a, a)); }

double volume(const Vectors& v) {
    if (v.size() == 2) return std::fabs(v[0][0] * v[1][1] - v[0][1] * v[1][0]);
    return std::fabs(v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) -
                     v[0][1] * (v[1][0] * v[2][2] - v[1][2] * v[2][0]) +
                     v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]));
}

/// In degrees.
double angle(const Vector& a, const Vector& b) {
    return std::acos(std::clamp(product(a, b) / length(a) / length(b), -1.0, 1.0)) * 180 / std::numbers::pi;
}

/// Whether a page shows the numbers as different.
bool differ(double a, double b) { return readable(a) != readable(b) && std::fabs(a - b) > 1e-9 * std::fabs(a); }

std::string lengths(const Vectors& vectors) {
    std::string text;
    for (std::size_t i = 0; i < vectors.size(); ++i)
        text += (i == 0 ? "" : i + 1 < vectors.size() ? ", " : " and ") + readable(length(vectors[i]));
    return text;
}

}  // namespace

bool only_box_moves(const Run_record& run) {
    return box_changes(run) && std::all_of(run.steps.begin(), run.steps.end(),
                                           [](const Iteration_record& s) { return s.displacement_max < 1e-12; });
}

std::string on_box(const Run_record& run) {
    if (!box_changes(run)) return {};
    const Vectors &before = run.input.box_before, &after = run.input.box;
    const double from = volume(before), to = volume(after);
    std::string text = std::string("The box changed: its ") + (before.size() == 2 ? "area " : "volume ");
    text += differ(from, to) ? "went from " + readable(from) + " to " + readable(to)
                             : "is " + readable(to) + " at the end, as at the start";
    bool longer = false;
    std::array<std::size_t, 2> turned{0, 1};  // the two vectors whose angle changed most
    const auto turn = [&](std::size_t i, std::size_t j) {
        return std::fabs(angle(after[i], after[j]) - angle(before[i], before[j]));
    };
    for (std::size_t i = 0; i < before.size(); ++i) {
        longer = longer || differ(length(before[i]), length(after[i]));
        for (std::size_t j = i + 1; j < before.size(); ++j)
            if (turn(i, j) > turn(turned[0], turned[1])) turned = {i, j};
    }
    if (longer) text += ", the lengths of its vectors from " + lengths(before) + " to " + lengths(after);
    const double was = angle(before[turned[0]], before[turned[1]]), is = angle(after[turned[0]], after[turned[1]]);
    if (differ(was, is)) {
        text += ", the angle between its vectors ";
        if (before.size() == 3) text += std::to_string(turned[0] + 1) + " and " + std::to_string(turned[1] + 1) + " ";
        text += "from " + readable(was) + " to " + readable(is) + " degrees";
    }
    return text + ".";
}

}  // namespace annulus::inline v1
