// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/predicate/batch.h>

#include <annulus/predicate/filtered_2.h>
#include <annulus/predicate/lanes.h>
#include <annulus/predicate/later_stages.h>

namespace annulus::inline v1 {

namespace {

template <class V>
inline constexpr std::size_t width = 1;
template <>
inline constexpr std::size_t width<Lanes> = Lanes::size();

/// Points i of the certificates x[0], x[1], ..., side by side.
template <class V, class T>
struct Gathered {
    const T* x;
    std::size_t i;

    V operator[](std::size_t c) const {
        if constexpr (width<V> == 1) return coordinate(*x, i, c);
        else return V([&](auto lane) { return coordinate(x[lane], i, c); });
    }
};

template <class V, std::size_t d, std::size_t k>
auto vector(const std::array<const std::array<double, d>*, k>* x, std::size_t i, std::size_t j) {
    using Point = Gathered<V, std::array<const std::array<double, d>*, k>>;
    return detail::as_vector(Euclidean<static_cast<int>(d)>::difference(Point{x, i}, Point{x, j}));
}

// The filter stage of width<V> certificates from x on.
template <class V>
detail::Bicell_decision<V> decide(const Tuple<2, 3>* x, bool certified, Cell_widths) {
    return {detail::decide_orientation(vector<V>(x, 1, 0), vector<V>(x, 2, 0), vector<V>(x, 2, 1), certified), V(0.0)};
}
template <class V>
detail::Bicell_decision<V> decide(const Tuple<2, 4>* x, bool certified, Cell_widths) {
    return {detail::decide_annulus(vector<V>(x, 1, 0), vector<V>(x, 2, 0), vector<V>(x, 3, 0), vector<V>(x, 3, 2),
                                   certified),
            V(0.0)};
}
template <class V>
detail::Bicell_decision<V> decide(const Tuple<3, 4>* x, bool certified, Cell_widths) {
    return {detail::decide_orientation(vector<V>(x, 1, 0), vector<V>(x, 2, 0), vector<V>(x, 3, 0), certified), V(0.0)};
}
template <class V>
detail::Bicell_decision<V> decide(const Tuple<3, 5>* x, bool certified, Cell_widths cells) {
    return detail::decide_annulus(vector<V>(x, 1, 0), vector<V>(x, 2, 0), vector<V>(x, 3, 0), vector<V>(x, 4, 0),
                                  certified, cells);
}

// The later stages, with one signature.
bool interval(const Tuple<2, 3>& x, Certificate_value& out, Cell_widths) { return orientation_interval(x, out); }
bool interval(const Tuple<2, 4>& x, Certificate_value& out, Cell_widths) { return empty_sphere_interval(x, out); }
bool interval(const Tuple<3, 4>& x, Certificate_value& out, Cell_widths) { return orientation_interval(x, out); }
bool interval(const Tuple<3, 5>& x, Certificate_value& out, Cell_widths cells) {
    return empty_sphere_interval(x, out, cells);
}
Certificate_value exact(const Tuple<2, 3>& x, Cell_widths) { return orientation_exact(x); }
Certificate_value exact(const Tuple<2, 4>& x, Cell_widths) { return empty_sphere_exact(x); }
Certificate_value exact(const Tuple<3, 4>& x, Cell_widths) { return orientation_exact(x); }
Certificate_value exact(const Tuple<3, 5>& x, Cell_widths cells) { return empty_sphere_exact(x, cells); }

/// Writes one lane. An open certificate is marked as the exact stage's until an earlier stage answers. Returns 1 for
/// an answer.
std::size_t store(double sign, double tolerance, double wrong_side, Certificate_value& out) {
    const bool answered = detail::answer(sign, tolerance, out);
    out.wrong_side = static_cast<std::uint8_t>(static_cast<int>(wrong_side));
    out.stage = answered ? Stage::filter : Stage::exact;
    return answered ? 1 : 0;
}

/// Flattened: a call in the middle of a formula would spill every register.
template <class T>
[[gnu::flatten]] std::size_t filter_stage(std::span<const T> x, bool certified, std::span<Certificate_value> out,
                                          Cell_widths cells) {
    constexpr std::size_t lanes = width<Lanes>;
    std::size_t answered = 0;
    std::size_t i = 0;
    for (; i + lanes <= x.size(); i += lanes) {
        const auto d = decide<Lanes>(&x[i], certified, cells);
        for (std::size_t k = 0; k < lanes; ++k)
            answered += store(d.decision.sign[k], d.decision.tolerance[k], d.wrong_side[k], out[i + k]);
    }
    for (; i < x.size(); ++i) {
        const auto d = decide<double>(&x[i], certified, cells);
        answered += store(d.decision.sign, d.decision.tolerance, d.wrong_side, out[i]);
    }
    return answered;
}

template <class T>
Stage_counts all_stages(std::span<const T> x, Tolerance_precision mode, std::span<Certificate_value> out,
                        Cell_widths cells) {
    Stage_counts counts;
    const std::size_t answered = filter_stage(x, mode != Tolerance_precision::approximate, out, cells);
    if (answered < x.size())
        counts = later_stages(
            x.size(), [&](std::size_t i) { return out[i].stage == Stage::exact; },
            [&](std::size_t i) {
                const bool decided = interval(x[i], out[i], cells);
                out[i].stage = decided ? Stage::interval : Stage::exact;
                return decided;
            },
            [&](std::size_t i) { out[i] = exact(x[i], cells); });
    counts.filter = answered;
    if (mode != Tolerance_precision::correctly_rounded) return counts;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (out[i].stage == Stage::exact || out[i].sign <= 0) continue;
        --(out[i].stage == Stage::filter ? counts.filter : counts.interval);
        out[i] = exact(x[i], cells);
        ++counts.exact;
    }
    return counts;
}

/// The filtered predicate for one certificate.
template <class T>
Certificate_value evaluate_one(const T& x, bool certified, Cell_widths cells) {
    Certificate_value out;
    (void)all_stages(std::span(&x, 1), certified ? Tolerance_precision::lower_bound : Tolerance_precision::approximate,
                     std::span(&out, 1), cells);
    return out;
}

}  // namespace

Stage_counts evaluate(std::span<const Tuple<2, 3>> x, Tolerance_precision mode, std::span<Certificate_value> out) {
    return all_stages(x, mode, out, Cell_widths::never);
}
Stage_counts evaluate(std::span<const Tuple<2, 4>> x, Tolerance_precision mode, std::span<Certificate_value> out) {
    return all_stages(x, mode, out, Cell_widths::never);
}
Stage_counts evaluate(std::span<const Tuple<3, 4>> x, Tolerance_precision mode, std::span<Certificate_value> out) {
    return all_stages(x, mode, out, Cell_widths::never);
}
Stage_counts evaluate(std::span<const Tuple<3, 5>> x, Tolerance_precision mode, std::span<Certificate_value> out,
                      Cell_widths cells) {
    return all_stages(x, mode, out, cells);
}

Certificate_value evaluate_orientation(const Tuple<2, 3>& x, bool certified) {
    return evaluate_one(x, certified, Cell_widths::never);
}
Certificate_value evaluate_orientation(const Tuple<3, 4>& x, bool certified) {
    return evaluate_one(x, certified, Cell_widths::never);
}
Certificate_value evaluate_empty_sphere(const Tuple<2, 4>& x, bool certified) {
    return evaluate_one(x, certified, Cell_widths::never);
}
Certificate_value evaluate_empty_sphere(const Tuple<3, 5>& x, bool certified, Cell_widths cells) {
    return evaluate_one(x, certified, cells);
}

}  // namespace annulus::inline v1
