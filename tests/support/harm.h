// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The worst moves for a whole triangulation, and the guarantees of its tolerances against them. In 2D and in 3D.

#include <support/certificates_of.h>
#include <support/exact_moves.h>
#include <support/point_sets_3.h>
#include <support/squeezes.h>
#include <support/stages.h>

#include <annulus/audit.h>
#include <annulus/options.h>
#include <annulus/types.h>

#include <limits>
#include <span>

namespace annulus::testing {

/// The nearest squeeze of one certificate.
template <int d>
struct Harm {
    std::vector<Index> vertices;
    std::vector<Coordinates<d>> direction;  ///< unit vectors
    double half_width;                      ///< rounded to nearest
};

/// The nearest squeezes of every cell, bi-cell and ridge; none where points are flat. For a bi-cell only its annuli:
/// its cells are separate certificates. With T = double half widths may be far off where they are small beside the
/// points' distances.
template <int d, class T>
[[nodiscard]] std::vector<Harm<d>> harms(const Audit_input<d>& input) {
    std::vector<Harm<d>> out;
    for (const auto& c : input.cells)
        if (std::find(c.begin(), c.end(), none) != c.end()) return out;
    const auto take = [&out](const auto& names, const auto& squeezes) {
        if (squeezes.empty()) return;
        const auto& s = least_of(squeezes);
        double half_width = 0;
        if constexpr (std::is_same_v<T, double>) half_width = s.half_width;
        else half_width = s.half_width.get_d();
        out.push_back({{names.begin(), names.end()}, {s.direction.begin(), s.direction.end()}, half_width});
    };
    const auto all = certificates_of<d>(input.cells);
    for (const auto& c : all.cells) take(c, slabs<T, d>(points_of<d>(c, input.points)));
    for (const auto& r : all.ridges) take(r, slabs<T, d>(points_of<d>(r, input.points)));
    for (const auto& b : all.bicells) take(b, annuli<T, d>(points_of<d>(b, input.points)));
    return out;
}

// Compiled once, in harm.cpp.
extern template std::vector<Harm<2>> harms<2, double>(const Audit_input<2>& input);
extern template std::vector<Harm<2>> harms<2, mpq_class>(const Audit_input<2>& input);
extern template std::vector<Harm<3>> harms<3, double>(const Audit_input<3>& input);
extern template std::vector<Harm<3>> harms<3, mpq_class>(const Audit_input<3>& input);

/// For every vertex the direction in which its tightest certificate is squeezed; none where it has no certificate.
template <int d>
[[nodiscard]] std::vector<Coordinates<d>> harmful_directions(const std::vector<Harm<d>>& all, std::size_t n) {
    std::vector<Coordinates<d>> direction(n);
    std::vector<double> least(n, std::numeric_limits<double>::infinity());
    for (const Harm<d>& h : all)
        for (std::size_t i = 0; i < h.vertices.size(); ++i) {
            const auto v = static_cast<std::size_t>(h.vertices[i]);
            if (!(h.half_width < least[v])) continue;
            least[v] = h.half_width;
            direction[v] = h.direction[i];
        }
    return direction;
}
template <class Moving>
[[nodiscard]] auto harmful_directions(const Moving& dt) {
    constexpr int d = Moving::dimension_of_space;
    return harmful_directions<d>(harms<d, double>(dt.audit_input()), dt.index_bound());
}

template <std::size_t d>
[[nodiscard]] std::array<double, d> stepped(std::array<double, d> p, const std::array<double, d>& direction,
                                            double length) {
    for (std::size_t k = 0; k < d; ++k) p[k] += length * direction[k];
    return p;
}

/// The number of certificates that fail under moves slightly beyond the tolerances of their vertices, and of all that
/// were tried.
struct Undone {
    int triangulations = 0, certificates = 0, tight = 0;
};

/// Recomputed tolerances against the worst moves, certificate by certificate and all at once. Precondition: no free
/// index.
template <class Moving, class Points>
void check_worst_moves(const Points& x, const Options& options, Undone& undone) {
    constexpr int d = Moving::dimension_of_space;
    Moving dt(std::span<const Coordinates<d>>(x), options);
    const Audit_input<d> before = dt.audit_input();
    const auto all = harms<d, mpq_class>(before);
    double least = std::numeric_limits<double>::infinity();
    for (const auto& h : all) least = std::min(least, h.half_width);
    if (all.empty() || !(least > 0x1p-34)) return;  // coordinates are about 1: a ten-thousandth must be many ulps
    std::vector<double> s;
    for (std::size_t i = 0; i < x.size(); ++i) s.push_back(dt.tolerance(static_cast<Index>(i)));
    const auto passes = [&](const Points& y) { return audit(Audit_input<d>{y, before.cells}).delaunay(); };
    ++undone.triangulations;

    for (const auto& h : all) {
        const auto squeezed = [&](double share) {
            Points y = x;
            for (std::size_t i = 0; i < h.vertices.size(); ++i) {
                const auto v = static_cast<std::size_t>(h.vertices[i]);
                y[v] = stepped(x[v], h.direction[i], share * s[v]);
            }
            return y;
        };
        HOLDS(passes(squeezed(0.9999)), x);
        ++undone.certificates;
        // It determines the tolerance of all its vertices, as the tightest of all does. The slack is a fifth of a per
        // cent.
        bool tight = true;
        for (const Index v : h.vertices) {
            HOLDS(s[static_cast<std::size_t>(v)] <= h.half_width * (1 + 0x1p-50), x);
            tight = tight && s[static_cast<std::size_t>(v)] >= 0.998 * h.half_width;
        }
        HOLDS(tight || h.half_width > least, x);
        if (!tight) continue;
        ++undone.tight;
        HOLDS(!passes(squeezed(1.001 / 0.998)), x);
        Moving repaired(std::span<const Coordinates<d>>(x), options);
        HOLDS(repaired.move_all(squeezed(1.001 / 0.998)).statistics.evaluated > 0, x);
        HOLDS(repaired.audit().delaunay(), x);
    }
    const auto worst = harmful_directions<d>(all, x.size());
    for (const double share : {0.9999, -0.9999}) {
        Points y = x;
        for (std::size_t i = 0; i < x.size(); ++i) y[i] = stepped(x[i], worst[i], share * s[i]);
        HOLDS(passes(y), x);
        Moving moving(std::span<const Coordinates<d>>(x), options);
        const Move_result report = moving.move_all(y);
        HOLDS(report.statistics.evaluated == 0 && report.moves.within_tolerance == x.size(), x);
        HOLDS(moving.audit_input().cells == before.cells, x);
    }
}

/// Empty, or a certificate that could fail within the tolerances. A tolerance is how far each vertex may be from its
/// fixed position, all at the same time, so that in every certificate at least one vertex has no more room left than
/// the present half width.
template <class Moving>
[[nodiscard]] std::string room_fault(const Moving& dt) {
    constexpr int d = Moving::dimension_of_space;
    const Audit_input<d> now = dt.audit_input();
    std::vector<double> room(dt.index_bound());
    for (std::size_t i = 0; i < room.size(); ++i) {
        const auto v = static_cast<Index>(i);
        const auto fixed = dt.fixed_position(v);
        mpq_class square = 0;
        for (std::size_t k = 0; k < d; ++k) {
            const mpq_class step = mpq_class(now.points[i][k]) - mpq_class(fixed[k]);
            square += step * step;
        }
        const double away = squeezing::root(square).get_d(), s = dt.tolerance(v);
        room[i] = s - away - 0x1p-50 * (s + away);
    }
    for (const auto& h : harms<d, mpq_class>(now)) {
        double least = std::numeric_limits<double>::infinity();
        for (const Index v : h.vertices) least = std::min(least, room[static_cast<std::size_t>(v)]);
        if (least <= h.half_width) continue;
        std::string s = "a certificate has half width " + as_code(h.half_width) +
                        " and its vertices' tolerances leave " + as_code(least) + ":";
        for (const Index v : h.vertices) s += " " + std::to_string(v);
        return s;
    }
    return {};
}

}  // namespace annulus::testing
