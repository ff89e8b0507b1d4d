// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/statistics/degeneracy.h>

#include <annulus/certificate/half_width.h>
#include <annulus/certificate/ladder.h>
#include <annulus/certificate/theta.h>
#include <annulus/mesh/certificates.h>
#include <annulus/statistics/paper_tolerance.h>
#include <annulus/statistics/spacing.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace annulus {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

constexpr double infinity = std::numeric_limits<double>::infinity();
/// So many certificates at a time are gathered for the ladder.
constexpr std::size_t batch = 4096;

/// Samples of one distribution on their way into it: all of them are kept only where quantiles are wanted.
class Samples {
  public:
    explicit Samples(Distribution empty = {}) : distribution_(std::move(empty)) {}
    void add(double sample, bool keep) {
        distribution_.histogram.add(sample);
        if (keep) kept_.push_back(sample);
    }
    Distribution result() {
        if (!kept_.empty()) distribution_.quantiles = quantiles(std::move(kept_), Distribution::probabilities);
        return std::move(distribution_);
    }

  private:
    Distribution distribution_;
    std::vector<double> kept_;
};
Distribution angles() { return {Histogram::linear(0, std::numbers::pi / 2, 36)}; }

/// Where the line through p and q meets the facet: inside (1), outside (-1), or on its border (0).
int convexity(std::span<const Verdict> v) {
    const auto negative = [](const Verdict& w) { return w.sign < 0; };
    const auto positive = [](const Verdict& w) { return w.sign > 0; };
    if (std::any_of(v.begin(), v.end(), negative) && std::any_of(v.begin(), v.end(), positive)) return -1;
    return std::any_of(v.begin(), v.end(), [](const Verdict& w) { return w.sign == 0; }) ? 0 : 1;
}

/// The orientations of p, q and each ridge of the facet, turned so that they agree where the bi-cell is convex.
void append_sides(const Tuple<2, 4>& x, std::vector<Tuple<2, 3>>& out) {
    out.push_back({x[2], x[3], x[0]});
    out.push_back({x[3], x[2], x[1]});
}
void append_sides(const Tuple<3, 5>& x, std::vector<Tuple<3, 4>>& out) {
    out.push_back({x[3], x[4], x[0], x[1]});
    out.push_back({x[3], x[4], x[1], x[2]});
    out.push_back({x[3], x[4], x[2], x[0]});
}
double theta_of(const Tuple<2, 4>& x) { return theta(*x[0], *x[1], *x[2], *x[3]); }
double theta_of(const Tuple<3, 5>& x) { return theta(*x[0], *x[1], *x[2], *x[3], *x[4]); }

/// One look at everything.
template <int d>
class Survey {
  public:
    Survey(const Cell_table<d>& t, std::span<const Coordinates<d>> x, const Degeneracy_options<d>& options)
        : t_(t), x_(x), options_(options), tolerance_(x.size(), infinity), marks_(x.size(), 0), paper_(t, x.size()) {
        r_.dimension = d;
        r_.spacing = mean_spacing(t, x);
        r_.resolution = resolution(x);
        for (const auto& [name, relative] : options.thresholds)
            r_.thresholds.push_back({name, relative * r_.spacing, relative});
        r_.thresholds.push_back({"ulp", r_.resolution, r_.resolution / r_.spacing});
        for (auto* counts : {&r_.standard, &r_.bicells.least, &r_.cells.least, &r_.ridges.least})
            counts->below.resize(r_.thresholds.size());
        r_.vertices.below.resize(r_.thresholds.size());
    }

    Degeneracy result() {
        look_at_facets();
        look_at_cells();
        sum_up();
        return std::move(r_);
    }

  private:
    using Bicell = Tuple<d, d + 2>;
    using Simplex = Tuple<d, d + 1>;
    template <class I, class T>
    struct Batch {
        std::vector<T> tuple;
        std::vector<Facet_points<d>> point;  // the last one none where there are only d + 1
        std::vector<I> id;
        void clear() {
            tuple.clear();
            point.clear();
            id.clear();
        }
    };

    template <std::size_t k, class I>
    void append(Batch<I, Tuple<d, static_cast<int>(k)>>& b, const std::array<Index, k>& v, I id) {
        Tuple<d, static_cast<int>(k)> tuple{};
        Facet_points<d> point;
        point.fill(none);
        for (std::size_t i = 0; i < k; ++i) {
            tuple[i] = &x_[at(v[i])];
            point[i] = v[i];
        }
        b.tuple.push_back(tuple);
        b.point.push_back(point);
        b.id.push_back(id);
    }

    void look_at_facets() {
        Batch<Corner_index, Bicell> bicells;
        Batch<Corner_index, Simplex> ridges;
        Batch<Corner_index, Simplex> border;
        for (const Corner_index h : t_.facets()) {
            switch (facet_kind(t_, h)) {
                case Facet_kind::empty_sphere: append(bicells, bicell_points(t_, h), h); break;
                case Facet_kind::ridge: append(ridges, ridge_vertex_last(t_, h, ridge_points(t_, h)), h); break;
                default: append(border, slab_points(t_, h), h); break;
            }
            if (bicells.id.size() == batch) take_bicells(bicells);
            if (ridges.id.size() == batch) take_ridges(ridges);
            if (border.id.size() == batch) take_border(border);
        }
        take_bicells(bicells);
        take_ridges(ridges);
        take_border(border);
    }

    void look_at_cells() {
        Batch<Cell_index, Simplex> cells;
        for (const Cell_index c : t_.finite_cells()) {
            append(cells, cell_points(t_, c), c);
            if (cells.id.size() == batch) take_cells(cells);
        }
        take_cells(cells);
    }

    void take_bicells(Batch<Corner_index, Bicell>& b) {
        const std::size_t n = b.id.size();
        judge(b, r_.bicells);
        bicell_.resize(n);
        enclose(std::span<const Bicell>(b.tuple), std::span(bicell_));
        sides_.clear();
        for (const Bicell& x : b.tuple) append_sides(x, sides_);
        verdict_.resize(sides_.size());
        r_.convexity += evaluate(std::span<const Simplex>(sides_), Mode::floating, verdict_);
        for (std::size_t i = 0; i < n; ++i) {
            const auto exactly = [&] { return enclose_exactly(b.tuple[i]); };
            Bicell_half_widths& h = bicell_[i];
            count(
                h.least, width_samples_[0], r_.bicells.least, b.point[i], [&] { return exactly().least; },
                &r_.bicells.decided_exactly);
            if (d == 3)
                count(
                    h.standard, width_samples_[3], r_.standard, {}, [&] { return exactly().standard; }, nullptr);
            const double theta = theta_of(b.tuple[i]);
            tell(Raw_certificate<d>::Kind::bicell, b.point[i], h.least, i, theta);
            const int convex = convexity(std::span(verdict_).subspan(i * d, d));
            r_.non_convex += convex < 0 ? 1U : 0U;
            r_.flat += convex == 0 ? 1U : 0U;
            theta_samples_.add(theta, options_.quantiles);
            paper_.note_bicell(b.id[i], h);
        }
        b.clear();
    }

    void take_ridges(Batch<Corner_index, Simplex>& b) {
        take_simplices(b, Raw_certificate<d>::Kind::ridge, r_.ridges, width_samples_[2],
                       [&](std::size_t i, const Half_width& h) { paper_.note_ridge(b.id[i], h); });
        half_.resize(b.id.size());
        enclose(std::span<const Simplex>(b.tuple), Width::ridge, std::span(half_));
        for (std::size_t i = 0; i < b.id.size(); ++i) paper_.note_paper(b.id[i], half_[i]);
        b.clear();
    }
    void take_border(Batch<Corner_index, Simplex>& b) {
        half_.resize(b.id.size());
        enclose(std::span<const Simplex>(b.tuple), Width::slab, std::span(half_));
        for (std::size_t i = 0; i < b.id.size(); ++i) paper_.note_paper(b.id[i], half_[i]);
        b.clear();
    }
    void take_cells(Batch<Cell_index, Simplex>& b) {
        take_simplices(b, Raw_certificate<d>::Kind::cell, r_.cells, width_samples_[1],
                       [&](std::size_t i, const Half_width& h) { paper_.note_cell(b.id[i], h); });
        b.clear();
    }

    template <class I, class Note>
    void take_simplices(Batch<I, Simplex>& b, typename Raw_certificate<d>::Kind kind, Certificate_counts& counts,
                        Samples& samples, Note note) {
        judge(b, counts);
        half_.resize(b.id.size());
        enclose(std::span<const Simplex>(b.tuple), Width::least, std::span(half_));
        for (std::size_t i = 0; i < b.id.size(); ++i) {
            count(
                half_[i], samples, counts.least, b.point[i], [&] { return enclose_exactly(b.tuple[i], Width::least); },
                &counts.decided_exactly);
            tell(kind, b.point[i], half_[i], i);
            note(i, half_[i]);
        }
    }

    /// After its width was counted, which may have made it narrower.
    void tell(typename Raw_certificate<d>::Kind kind, const Facet_points<d>& points, const Half_width& h,
              std::size_t i, double theta = 0) const {
        if (options_.raw)
            options_.raw({kind, points, 2 * h.lower, 2 * h.upper, judged_[i].tolerance, judged_[i].stage, theta});
    }

    /// The ladder, as a run has it, for stages and tolerances.
    template <class I, class T>
    void judge(const Batch<I, T>& b, Certificate_counts& counts) {
        verdict_.resize(b.id.size());
        counts.arithmetic += evaluate(std::span<const T>(b.tuple), Mode::fast, verdict_);
        if (options_.raw) judged_ = verdict_;
        for (std::size_t i = 0; i < b.id.size(); ++i)
            for (const Index v : b.point[i])
                if (v != none) tolerance_[at(v)] = std::min(tolerance_[at(v)], verdict_[i].tolerance);
    }

    /// Enters one half width into the counts: of widths as they are, of tolerances at the points that it limits.
    template <class Exactly>
    void count(Half_width& h, Samples& samples, Width_counts& counts, const Facet_points<d>& points,
               Exactly exactly, std::uint64_t* integers) {
        bool asked = h.stage == Stage::exact;
        const auto below = [&](double y) {
            if (h.is_below(y)) return true;
            if (h.is_not_below(y)) return false;
            h = exactly();
            asked = true;
            return h.is_below(y);
        };
        ++counts.total;
        if (h.upper == 0.0) ++counts.zero;
        unsigned mark = h.upper == 0.0 ? 1U : 0U;
        for (std::size_t k = 0; k < r_.thresholds.size(); ++k) {
            const double y = r_.thresholds[k].width;
            if (below(y / 2)) ++counts.below[k];
            if (integers != nullptr && below(y)) mark |= 2U << k;
        }
        samples.add(2 * h.lower / r_.spacing, options_.quantiles);
        if (integers == nullptr) return;
        *integers += asked ? 1U : 0U;
        for (const Index v : points)
            if (v != none) marks_[at(v)] |= mark;
    }

    void sum_up() {
        const auto relative = [this](const std::vector<double>& lengths) {
            Samples samples;
            for (const double x : lengths) samples.add(x / r_.spacing, options_.quantiles);
            return samples.result();
        };
        r_.bicells.least.width = width_samples_[0].result();
        r_.cells.least.width = width_samples_[1].result();
        r_.ridges.least.width = width_samples_[2].result();
        if (d == 3) r_.standard.width = width_samples_[3].result();
        r_.theta = theta_samples_.result();
        Vertex_counts& v = r_.vertices;
        v.total = x_.size();
        for (const unsigned mark : marks_) {
            v.zero += mark & 1U;
            for (std::size_t k = 0; k < v.below.size(); ++k) v.below[k] += mark >> (k + 1) & 1U;
        }
        v.certified = relative(tolerance_);
        const Paper_verdict p = paper_.verdict(x_);
        v.paper_above_exact = p.above_exact;
        v.paper_unsound = p.unsound;
        v.unsound_certificates = p.certificates;
        v.paper = relative(p.tolerance);
        for (std::size_t i = 0; i < p.exact.size(); ++i) v.paper_ratio.add(p.tolerance[i] / p.exact[i]);  // 0 / 0 is no number
        if (options_.unsound)
            for (const auto& points : p.points) options_.unsound(points);
    }

    const Cell_table<d>& t_;
    std::span<const Coordinates<d>> x_;
    const Degeneracy_options<d>& options_;
    Degeneracy r_;
    std::array<Samples, 4> width_samples_;  // bi-cells, cells, ridges, standard annuli
    Samples theta_samples_{angles()};
    std::vector<double> tolerance_;  // by vertex
    std::vector<unsigned> marks_;    // by vertex: tolerance 0, tolerance below threshold k in bit k + 1
    Paper_tolerance<d> paper_;
    // Of a batch.
    std::vector<Verdict> verdict_;
    std::vector<Verdict> judged_;  // the certificates', where somebody is told
    std::vector<Bicell_half_widths> bicell_;
    std::vector<Half_width> half_;
    std::vector<Simplex> sides_;
};

}  // namespace

Degeneracy degeneracy(const Cell_table<2>& t, std::span<const Coordinates<2>> x, const Degeneracy_options<2>& options) {
    return Survey<2>(t, x, options).result();
}
Degeneracy degeneracy(const Cell_table<3>& t, std::span<const Coordinates<3>> x, const Degeneracy_options<3>& options) {
    return Survey<3>(t, x, options).result();
}

}  // namespace annulus
