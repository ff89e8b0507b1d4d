// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/degeneracy.h>

#include <annulus/error.h>
#include <annulus/measure/certificate_batch.h>
#include <annulus/measure/paper_tolerance.h>
#include <annulus/measure/spacing.h>
#include <annulus/mesh/parallel_runs.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace annulus::inline v1 {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

constexpr double infinity = std::numeric_limits<double>::infinity();
/// The number of certificates that one thread evaluates at a time.
constexpr std::size_t batch = 4096;

/// Collects the samples of one distribution; all of them are kept only where quantiles are needed.
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

/// One scan of all certificates.
template <int d>
class Degeneracy_scan {
  public:
    Degeneracy_scan(const Corner_table<d>& t, std::span<const Coordinates<d>> x, const Degeneracy_options<d>& options)
        : t_(t),
          x_(x),
          options_(options),
          tolerance_(x.size(), infinity),
          marks_(x.size(), 0),
          paper_(t, x.size(), options.threads) {
        if (options.threads < 1)
            throw Error(Error_code::usage, "threads must be 1 or more, not " + std::to_string(options.threads));
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

    /// Batches are evaluated by all threads and entered one after another.
    Degeneracy result() {
        for_each_in_order<Slot>(
            options_.threads, [this](Slot& slot) { return fill(slot); }, [this](Slot& slot) { find(slot); },
            [this](const Slot& slot) { enter(slot); });
        sum_up();
        return std::move(r_);
    }

  private:
    enum class Kind : std::uint8_t { bicells, ridges, border, cells };
    using Facets = Simplex_batch<d, Corner_index>;
    using Cells = Simplex_batch<d, Cell_index>;
    /// Whether the batch of its kind is full or the last.
    struct Slot {
        Kind kind = Kind::bicells;
        Bicell_batch<d> bicells{};
        Facets facets{};
        Cells cells{};
    };

    /// The next batch, none after the last: facets in their order, then cells.
    bool fill(Slot& slot) {
        const auto give = [&slot](Kind kind, auto& from, auto& to) {
            slot.kind = kind;
            std::swap(from, to);
            from.clear();
            return true;
        };
        for (; next_facet_ != t_.facet_bound(); ++next_facet_) {
            if (bicells_.id.size() == batch) return give(Kind::bicells, bicells_, slot.bicells);
            if (ridges_.id.size() == batch) return give(Kind::ridges, ridges_, slot.facets);
            if (border_.id.size() == batch) return give(Kind::border, border_, slot.facets);
            if (t_.is_facet(next_facet_)) append(next_facet_);
        }
        if (!bicells_.id.empty()) return give(Kind::bicells, bicells_, slot.bicells);
        if (!ridges_.id.empty()) return give(Kind::ridges, ridges_, slot.facets);
        if (!border_.id.empty()) return give(Kind::border, border_, slot.facets);
        for (; next_cell_ != t_.cell_bound() && cells_.id.size() < batch; ++next_cell_)
            if (t_.is_cell(next_cell_) && !t_.is_infinite(next_cell_))
                cells_.append(next_cell_, cell_sites(t_, next_cell_), x_);
        return !cells_.id.empty() && give(Kind::cells, cells_, slot.cells);
    }
    void append(Corner_index h) {
        switch (facet_kind(t_, h)) {
            case Facet_kind::empty_sphere: bicells_.append(h, bicell_sites(t_, h), x_); break;
            case Facet_kind::ridge: ridges_.append(h, ridge_vertex_last(t_, h, ridge_sites(t_, h)), x_); break;
            default: border_.append(h, slab_sites(t_, h), x_); break;
        }
    }

    /// The part that concerns one batch alone; run by several threads at once.
    void find(Slot& slot) const {
        switch (slot.kind) {
            case Kind::bicells: slot.bicells.find(r_.thresholds); break;
            case Kind::ridges:
                slot.facets.find(r_.thresholds);
                slot.facets.find_paper(Width::ridge);
                break;
            case Kind::border: slot.facets.find_paper(Width::slab); break;
            case Kind::cells: slot.cells.find(r_.thresholds); break;
        }
    }

    void enter(const Slot& slot) {
        switch (slot.kind) {
            case Kind::bicells: enter_bicells(slot.bicells); break;
            case Kind::ridges:
                enter_certificates(slot.facets, Raw_certificate<d>::Kind::ridge, r_.ridges, width_samples_[2]);
                for (std::size_t i = 0; i < slot.facets.id.size(); ++i)
                    paper_.note_ridge(slot.facets.id[i], slot.facets.half[i]);
                enter_paper(slot.facets);
                break;
            case Kind::border: enter_paper(slot.facets); break;
            case Kind::cells:
                enter_certificates(slot.cells, Raw_certificate<d>::Kind::cell, r_.cells, width_samples_[1]);
                for (std::size_t i = 0; i < slot.cells.id.size(); ++i)
                    paper_.note_cell(slot.cells.id[i], slot.cells.half[i]);
                break;
        }
    }
    void enter_bicells(const Bicell_batch<d>& b) {
        enter_certificates(b, Raw_certificate<d>::Kind::bicell, r_.bicells, width_samples_[0], b.theta);
        r_.convexity += b.convexity;
        for (std::size_t i = 0; i < b.id.size(); ++i) {
            if (d == 3) enter_width(b.all[i].standard, b.below_standard[i], r_.standard, width_samples_[3]);
            r_.non_convex += b.convex[i] < 0 ? 1U : 0U;
            r_.flat += b.convex[i] == 0 ? 1U : 0U;
            theta_samples_.add(b.theta[i], options_.quantiles);
            paper_.note_bicell(b.id[i], b.all[i]);
        }
    }
    void enter_paper(const Facets& b) {
        for (std::size_t i = 0; i < b.id.size(); ++i) paper_.note_paper(b.id[i], b.paper[i]);
    }

    /// Certificates: the stages that decided, widths as they are, tolerances at the points that they limit.
    template <class Batch>
    void enter_certificates(const Batch& b, typename Raw_certificate<d>::Kind kind, Certificate_counts& counts,
                            Samples& samples, std::span<const double> theta = {}) {
        counts.arithmetic += b.arithmetic;
        for (std::size_t i = 0; i < b.id.size(); ++i) {
            const Half_width& h = b.half[i];
            enter_width(h, b.below[i], counts.least, samples);
            counts.decided_exactly += b.below[i].with_integers ? 1U : 0U;
            const unsigned mark = (h.upper == 0.0 ? 1U : 0U) | b.below[i].tolerance << 1;
            for (const Index v : b.point[i]) {
                if (v == none) continue;
                tolerance_[at(v)] = std::min(tolerance_[at(v)], b.value[i].tolerance);
                marks_[at(v)] |= mark;
            }
            if (options_.raw)
                options_.raw({kind, b.point[i], 2 * h.lower, 2 * h.upper, b.value[i].tolerance, b.value[i].stage,
                              theta.empty() ? 0 : theta[i]});
        }
    }
    void enter_width(const Half_width& h, const Below_thresholds& below, Width_counts& counts, Samples& samples) const {
        ++counts.total;
        counts.zero += h.upper == 0.0 ? 1U : 0U;
        for (std::size_t k = 0; k < counts.below.size(); ++k) counts.below[k] += below.width >> k & 1U;
        samples.add(2 * h.lower / r_.spacing, options_.quantiles);
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
        // 0 / 0 is no number.
        for (std::size_t i = 0; i < p.exact.size(); ++i) v.paper_ratio.add(p.tolerance[i] / p.exact[i]);
        if (options_.unsound)
            for (const auto& points : p.points) options_.unsound(points);
    }

    const Corner_table<d>& t_;
    std::span<const Coordinates<d>> x_;
    const Degeneracy_options<d>& options_;
    Degeneracy r_;
    std::array<Samples, 4> width_samples_;  // bi-cells, cells, ridges, standard annuli
    Samples theta_samples_{angles()};
    std::vector<double> tolerance_;  // by vertex
    std::vector<unsigned> marks_;    // by vertex: tolerance 0, tolerance below threshold k in bit k + 1
    Paper_tolerance<d> paper_;
    // What fills slots.
    Corner_index next_facet_{0};
    Cell_index next_cell_{0};
    Bicell_batch<d> bicells_;
    Facets ridges_, border_;
    Cells cells_;
};

}  // namespace

Degeneracy degeneracy(const Corner_table<2>& t, std::span<const Coordinates<2>> x,
                      const Degeneracy_options<2>& options) {
    return Degeneracy_scan<2>(t, x, options).result();
}
Degeneracy degeneracy(const Corner_table<3>& t, std::span<const Coordinates<3>> x,
                      const Degeneracy_options<3>& options) {
    return Degeneracy_scan<3>(t, x, options).result();
}

}  // namespace annulus::inline v1
