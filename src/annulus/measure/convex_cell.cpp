// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/convex_cell.h>

#include <annulus/space/dot.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace annulus::inline v1 {

namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

Coordinates<3> cross(const Coordinates<3>& a, const Coordinates<3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <int d>
Coordinates<d> minus(Coordinates<d> a, const Coordinates<d>& b) {
    for (std::size_t k = 0; k < d; ++k) a[k] -= b[k];
    return a;
}

}  // namespace

template <int d>
Convex_cell<d>::Convex_cell(const Coordinates<d>& lower, const Coordinates<d>& upper, Index label) {
    for (std::size_t i = 0; i < (d == 2 ? 4 : 8); ++i) {
        auto& x = corner_.emplace_back();
        for (std::size_t k = 0; k < d; ++k) x[k] = (i >> k & 1) != 0 ? upper[k] : lower[k];
    }
    if constexpr (d == 2) sides_ = {{label, {0, 1}}, {label, {1, 3}}, {label, {3, 2}}, {label, {2, 0}}};
    else
        sides_ = {{label, {0, 4, 6, 2}}, {label, {1, 3, 7, 5}}, {label, {0, 1, 5, 4}},
                  {label, {2, 6, 7, 3}}, {label, {0, 2, 3, 1}}, {label, {4, 5, 7, 6}}};
}

template <int d>
void Convex_cell<d>::cut(const Coordinates<d>& normal, double offset, Index label) {
    beyond_.clear();
    bool any = false;
    for (const auto& x : corner_) {
        beyond_.push_back(dot<d>(normal, x) - offset);
        any = any || beyond_.back() > 0;
    }
    if (!any) return;
    made_.clear();
    std::vector<std::pair<std::size_t, std::size_t>> gaps;  // from where a side is left to where it is entered again
    for (Side& side : sides_) {
        std::vector<std::size_t> kept;
        const std::size_t n = side.corners.size();
        std::size_t left = 0;  // the corner where the side was left last; before that, where it was first entered
        std::size_t entered = 0;
        bool is_out = false;
        bool entered_first = false;
        for (std::size_t k = 0; k < n; ++k) {
            const std::size_t a = side.corners[k];
            const std::size_t b = side.corners[(k + 1) % n];
            if (!(beyond_[a] > 0)) kept.push_back(a);
            if (d == 2 && k == 1) break;  // an edge, not a cycle
            if ((beyond_[a] > 0) == (beyond_[b] > 0)) continue;
            if (beyond_[b] > 0) {
                left = crossing(a, b);
                kept.push_back(left);
                is_out = true;
            } else {
                const std::size_t x = crossing(b, a);
                kept.push_back(x);
                if (is_out) gaps.emplace_back(left, x);
                else {
                    entered = x;
                    entered_first = true;
                }
                is_out = false;
            }
        }
        if constexpr (d == 2) {
            if (is_out) gaps.emplace_back(left, left);
            if (entered_first) gaps.emplace_back(entered, entered);
        } else if (is_out && entered_first) gaps.emplace_back(left, entered);
        side.corners = std::move(kept);
    }
    sides_.erase(std::remove_if(sides_.begin(), sides_.end(),
                                [](const Side& s) { return s.corners.size() < static_cast<std::size_t>(d); }),
                 sides_.end());
    close(gaps, label);
    drop_unused();
}

/// The corner where the edge from `inside` to `outside` meets the plane.
template <int d>
std::size_t Convex_cell<d>::crossing(std::size_t inside, std::size_t outside) {
    for (const auto& [edge, corner] : made_)
        if (edge.first == inside && edge.second == outside) return corner;
    const double t = beyond_[inside] / (beyond_[inside] - beyond_[outside]);
    Coordinates<d> x = corner_[inside];
    for (std::size_t k = 0; k < d; ++k) x[k] += t * (corner_[outside][k] - x[k]);
    corner_.push_back(x);
    made_.push_back({{inside, outside}, corner_.size() - 1});
    return corner_.size() - 1;
}

/// Fills what a cut leaves open. In 3D each gap of a side is an edge of the new one, in the other direction: where one
/// side is left, another is entered, so gaps make cycles.
template <int d>
void Convex_cell<d>::close(const std::vector<std::pair<std::size_t, std::size_t>>& gaps, Index label) {
    if constexpr (d == 2) {
        if (sides_.empty() || gaps.size() != 2) return;
        // From the end of the edge that is left to the beginning of that which is entered.
        const auto ends_at = [this](std::size_t corner) {
            return std::any_of(sides_.begin(), sides_.end(),
                               [corner](const Side& s) { return s.corners[1] == corner; });
        };
        const std::size_t a = gaps[0].first;
        const std::size_t b = gaps[1].first;
        sides_.push_back(ends_at(a) ? Side{label, {a, b}} : Side{label, {b, a}});
    } else {
        std::vector<char> used(gaps.size(), 0);
        for (std::size_t g = 0; g < gaps.size(); ++g) {
            if (used[g] != 0) continue;
            Side side{label, {}};
            std::size_t at = g;
            while (at < gaps.size() && used[at] == 0) {
                used[at] = 1;
                side.corners.push_back(gaps[at].second);
                const std::size_t next = gaps[at].first;  // where the side across is entered
                at = 0;
                while (at < gaps.size() && gaps[at].second != next) ++at;
            }
            if (side.corners.size() >= 3) sides_.push_back(std::move(side));
        }
    }
}

template <int d>
void Convex_cell<d>::drop_unused() {
    std::vector<std::size_t> number(corner_.size(), corner_.size());
    std::vector<Coordinates<d>> kept;
    for (Side& side : sides_)
        for (std::size_t& c : side.corners) {
            if (number[c] == corner_.size()) {
                number[c] = kept.size();
                kept.push_back(corner_[c]);
            }
            c = number[c];
        }
    corner_ = std::move(kept);
}

template <int d>
std::vector<Cell_side<d>> Convex_cell<d>::sides() const {
    std::vector<Cell_side<d>> out;
    for (const Side& side : sides_) {
        const Coordinates<d>& base = corner_[side.corners[0]];
        Cell_side<d> of{side.label, 0, base};
        if constexpr (d == 2) {
            const auto e = minus<2>(corner_[side.corners[1]], base);
            of.measure = std::sqrt(dot<d>(e, e));
            for (std::size_t k = 0; k < 2; ++k) of.centroid[k] += 0.5 * e[k];
        } else {
            // The vector of the area, and the centroid with weights in its direction.
            Coordinates<3> area{};
            for (std::size_t k = 1; k + 1 < side.corners.size(); ++k) {
                const auto a =
                    cross(minus<3>(corner_[side.corners[k]], base), minus<3>(corner_[side.corners[k + 1]], base));
                for (std::size_t i = 0; i < 3; ++i) area[i] += 0.5 * a[i];
            }
            of.measure = std::sqrt(dot<d>(area, area));
            if (of.measure > 0) {
                Coordinates<3> moment{};
                for (std::size_t k = 1; k + 1 < side.corners.size(); ++k) {
                    const auto p = minus<3>(corner_[side.corners[k]], base);
                    const auto q = minus<3>(corner_[side.corners[k + 1]], base);
                    const double weight = dot<d>(cross(p, q), area) / (6 * of.measure);
                    for (std::size_t i = 0; i < 3; ++i) moment[i] += weight * (p[i] + q[i]);
                }
                for (std::size_t i = 0; i < 3; ++i) of.centroid[i] += moment[i] / of.measure;
            }
        }
        out.push_back(of);
    }
    return out;
}

template <int d>
Cell_content<d> Convex_cell<d>::content() const {
    Cell_content<d> out{0, {}};
    out.centroid.fill(nowhere);
    if (sides_.empty()) return out;
    const Coordinates<d> base = corner_[0];
    Coordinates<d> moment{};
    const auto add = [&](double part, const Coordinates<d>& sum) {
        out.volume += part;
        for (std::size_t i = 0; i < d; ++i) moment[i] += part * sum[i] / (d + 1);
    };
    for (const Side& side : sides_) {
        const auto p = minus<d>(corner_[side.corners[0]], base);
        const auto plus = [](Coordinates<d> a, const Coordinates<d>& b) {
            for (std::size_t i = 0; i < d; ++i) a[i] += b[i];
            return a;
        };
        if constexpr (d == 2) {
            const auto q = minus<d>(corner_[side.corners[1]], base);
            add(0.5 * (p[0] * q[1] - p[1] * q[0]), plus(p, q));
        } else {
            for (std::size_t k = 1; k + 1 < side.corners.size(); ++k) {
                const auto q = minus<d>(corner_[side.corners[k]], base);
                const auto r = minus<d>(corner_[side.corners[k + 1]], base);
                add(dot<d>(p, cross(q, r)) / 6, plus(plus(p, q), r));
            }
        }
    }
    if (!(out.volume > 0)) out.volume = 0;
    else
        for (std::size_t i = 0; i < d; ++i) out.centroid[i] = base[i] + moment[i] / out.volume;
    return out;
}

template <int d>
std::pair<Coordinates<d>, Coordinates<d>> Convex_cell<d>::bounds() const {
    std::pair<Coordinates<d>, Coordinates<d>> out;
    out.first.fill(std::numeric_limits<double>::max());
    out.second.fill(std::numeric_limits<double>::lowest());
    for (const auto& x : corner_)
        for (std::size_t k = 0; k < d; ++k) {
            out.first[k] = std::min(out.first[k], x[k]);
            out.second[k] = std::max(out.second[k], x[k]);
        }
    return out;
}

template class Convex_cell<2>;
template class Convex_cell<3>;

}  // namespace annulus::inline v1
