// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/degeneracy.h>
#include <annulus/mesh/certificates.h>
#include <annulus/predicate/filtered.h>
#include <annulus/predicate/half_width.h>
#include <annulus/predicate/theta.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace annulus::inline v1 {

/// A half width compared with thresholds: bit k for threshold k.
struct Below_thresholds {
    std::uint32_t width = 0;      ///< twice the half width is below the threshold
    std::uint32_t tolerance = 0;  ///< the half width itself is below it
    bool with_integers = false;   ///< whether integers were needed, here or before

    /// Replaces h by exactly() where its enclosure does not decide. Without `tolerances` these bits stay 0.
    template <class Exactly>
    Below_thresholds(Half_width& h, std::span<const Threshold> thresholds, bool tolerances, const Exactly& exactly)
        : with_integers(h.stage == Stage::exact) {
        const auto below = [&](double y) {
            if (h.is_below(y)) return true;
            if (h.is_not_below(y)) return false;
            h = exactly();
            with_integers = true;
            return h.is_below(y);
        };
        for (std::size_t k = 0; k < thresholds.size(); ++k) {
            const double y = thresholds[k].width;
            width |= below(y / 2) ? 1U << k : 0U;
            tolerance |= tolerances && below(y) ? 1U << k : 0U;
        }
    }
};

/// Some certificates of one kind, and the results for each. T is the tuple of their points.
template <int d, class Id, class T>
struct Certificate_batch {
    using Vertices = std::array<Index, static_cast<std::size_t>(d) + 2>;
    std::vector<Id> id{};
    std::vector<Vertices> point{};  ///< the last is `none` where there are only d + 1
    std::vector<T> tuple{};
    // Found:
    std::vector<Certificate_value> value{};  ///< of the filtered predicate, as in a run
    Stage_counts arithmetic{};               ///< of the values
    std::vector<Half_width> half{};          ///< the least one
    std::vector<Below_thresholds> below{};   ///< the least one compared

    template <std::size_t k>
    void append(Id named, const std::array<Site<d>, k>& v, std::span<const Coordinates<d>> x) {
        T t{};
        Vertices p;
        p.fill(none);
        for (std::size_t i = 0; i < k; ++i) {
            t[i] = &x[static_cast<std::size_t>(v[i].vertex)];
            p[i] = v[i].vertex;
        }
        id.push_back(named);
        point.push_back(p);
        tuple.push_back(t);
    }
    /// Points whose positions are kept elsewhere: refer_to() before they are used.
    template <std::size_t k>
    void append(Id named, const std::array<Index, k>& v) {
        Vertices p;
        p.fill(none);
        std::copy(v.begin(), v.end(), p.begin());
        id.push_back(named);
        point.push_back(p);
        tuple.emplace_back();
    }
    template <class Places>
    void refer_to(std::span<const Places> places) {
        for (std::size_t c = 0; c < tuple.size(); ++c)
            for (std::size_t i = 0; i < tuple[c].size(); ++i) tuple[c][i] = &places[c][i];
    }
    void clear() {
        id.clear();
        point.clear();
        tuple.clear();
    }
    void judge() {
        value.resize(id.size());
        arithmetic = evaluate(std::span<const T>(tuple), Tolerance_precision::lower_bound, value);
    }
};

/// Where the line through p and q meets the facet: inside (1), outside (-1), or on its border (0).
inline int convexity_of(std::span<const Certificate_value> v) {
    const auto negative = [](const Certificate_value& w) { return w.sign < 0; };
    const auto positive = [](const Certificate_value& w) { return w.sign > 0; };
    if (std::any_of(v.begin(), v.end(), negative) && std::any_of(v.begin(), v.end(), positive)) return -1;
    return std::any_of(v.begin(), v.end(), [](const Certificate_value& w) { return w.sign == 0; }) ? 0 : 1;
}

/// The orientations of p, q and each ridge of the facet, turned so that they agree where the bi-cell is convex.
inline void append_sides(const Tuple<2, 4>& x, std::vector<Tuple<2, 3>>& out) {
    out.push_back({x[2], x[3], x[0]});
    out.push_back({x[3], x[2], x[1]});
}
inline void append_sides(const Tuple<3, 5>& x, std::vector<Tuple<3, 4>>& out) {
    out.push_back({x[3], x[4], x[0], x[1]});
    out.push_back({x[3], x[4], x[1], x[2]});
    out.push_back({x[3], x[4], x[2], x[0]});
}
template <class Bicell>
double theta_of(const Bicell& x) {
    return std::apply([](const auto*... p) { return theta(*p...); }, x);
}

/// Bi-cells.
template <int d>
struct Bicell_batch : Certificate_batch<d, Corner_index, Tuple<d, d + 2>> {
    std::vector<Bicell_half_widths> all{};
    std::vector<Below_thresholds> below_standard{};  ///< in 3D
    std::vector<double> theta{};
    /// Where the line through p and q meets the facet: inside (1), outside (-1), or on its border (0).
    std::vector<int> convex{};
    Stage_counts convexity{};  ///< stages of these signs

    void find(std::span<const Threshold> thresholds) {
        this->judge();
        const std::size_t n = this->id.size();
        all.resize(n);
        enclose(std::span<const Tuple<d, d + 2>>(this->tuple), std::span(all));
        this->half.clear();
        this->below.clear();
        below_standard.clear();
        theta.clear();
        for (std::size_t i = 0; i < n; ++i) {
            const auto exactly = [&] { return enclose_exactly(this->tuple[i]); };
            this->below.emplace_back(all[i].least, thresholds, true, [&] { return exactly().least; });
            if (d == 3)
                below_standard.emplace_back(all[i].standard, thresholds, false, [&] { return exactly().standard; });
            this->half.push_back(all[i].least);
            theta.push_back(theta_of(this->tuple[i]));
        }
        find_convexity();
    }

  private:
    void find_convexity() {
        sides_.clear();
        for (const auto& x : this->tuple) append_sides(x, sides_);
        signs_.resize(sides_.size());
        convexity = evaluate(std::span<const Tuple<d, d + 1>>(sides_), Tolerance_precision::approximate, signs_);
        convex.clear();
        for (std::size_t i = 0; i < this->id.size(); ++i)
            convex.push_back(convexity_of(std::span<const Certificate_value>(signs_).subspan(i * d, d)));
    }
    std::vector<Tuple<d, d + 1>> sides_{};
    std::vector<Certificate_value> signs_{};
};

/// Cells, ridges, and facets of the border, which are no certificates.
template <int d, class Id>
struct Simplex_batch : Certificate_batch<d, Id, Tuple<d, d + 1>> {
    using Simplex = Tuple<d, d + 1>;
    std::vector<Half_width> paper{};  ///< of a slab of the paper

    void find(std::span<const Threshold> thresholds) {
        this->judge();
        this->half.resize(this->id.size());
        enclose(std::span<const Simplex>(this->tuple), Width::least, std::span(this->half));
        this->below.clear();
        for (std::size_t i = 0; i < this->id.size(); ++i)
            this->below.emplace_back(this->half[i], thresholds, true,
                                     [&] { return enclose_exactly(this->tuple[i], Width::least); });
    }
    void find_paper(Width which) {
        paper.resize(this->id.size());
        enclose(std::span<const Simplex>(this->tuple), which, std::span(paper));
    }
};

}  // namespace annulus::inline v1
