// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/degeneracy.h>
#include <annulus/measure/certificate_batch.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// Collects the samples of one distribution; all of them are kept only where quantiles are needed.
class Samples {
  public:
    explicit Samples(Distribution empty = {}) : distribution_(std::move(empty)) {}
    void add(double sample, bool keep) {
        distribution_.histogram.add(sample);
        if (keep) kept_.push_back(sample);
    }
    [[nodiscard]] Distribution result() {
        if (!kept_.empty()) distribution_.quantiles = quantiles(std::move(kept_), Distribution::probabilities);
        return std::move(distribution_);
    }

  private:
    Distribution distribution_;
    std::vector<double> kept_;
};

/// What the certificates of a triangulation add up to, with open boundaries or in a periodic box: batches that found
/// their numbers are entered one after another.
template <int d>
class Certificate_sums {
  public:
    using Kind = typename Raw_certificate<d>::Kind;

    /// Of so many indices of vertices. Refers to the options. Throws Error(usage) for a number of threads below 1.
    Certificate_sums(std::size_t indices, double spacing, double resolution, const Degeneracy_options<d>& options);

    [[nodiscard]] std::span<const Threshold> thresholds() const { return r_.thresholds; }
    void enter_bicells(const Bicell_batch<d>& b);
    /// Precondition: Kind is cell or ridge.
    template <class Id>
    void enter(Kind kind, const Simplex_batch<d, Id>& b) {
        if (kind == Kind::cell) enter_certificates(b, kind, r_.cells, width_samples_[1]);
        else enter_certificates(b, kind, r_.ridges, width_samples_[2]);
    }
    /// All but the paper's tolerances. Vertices that are in no certificate are not counted.
    [[nodiscard]] Degeneracy result();

  private:
    /// Certificates: the stages that decided, widths as they are, tolerances at the points that they limit.
    template <class Batch>
    void enter_certificates(const Batch& b, Kind kind, Certificate_counts& counts, Samples& samples,
                            std::span<const double> theta = {});
    void enter_width(const Half_width& h, const Below_thresholds& below, Width_counts& counts, Samples& samples) const;

    const Degeneracy_options<d>& options_;
    Degeneracy r_;
    std::array<Samples, 4> width_samples_;  // bi-cells, cells, ridges, standard annuli
    Samples theta_samples_;
    std::vector<double> tolerance_;  // by vertex
    std::vector<unsigned> marks_;    // by vertex: tolerance 0, tolerance below threshold k in bit k + 1
};

template <int d>
template <class Batch>
void Certificate_sums<d>::enter_certificates(const Batch& b, Kind kind, Certificate_counts& counts, Samples& samples,
                                             std::span<const double> theta) {
    counts.arithmetic += b.arithmetic;
    for (std::size_t i = 0; i < b.id.size(); ++i) {
        const Half_width& h = b.half[i];
        enter_width(h, b.below[i], counts.least, samples);
        counts.decided_exactly += b.below[i].with_integers ? 1U : 0U;
        const unsigned mark = (h.upper == 0.0 ? 1U : 0U) | b.below[i].tolerance << 1;
        for (const Index v : b.point[i]) {
            if (v == none) continue;
            const auto at = static_cast<std::size_t>(v);
            tolerance_[at] = std::min(tolerance_[at], b.value[i].tolerance);
            marks_[at] |= mark;
        }
        if (!options_.raw) continue;
        Raw_certificate<d> raw{kind,
                               b.point[i],
                               2 * h.lower,
                               2 * h.upper,
                               b.value[i].tolerance,
                               b.value[i].stage,
                               theta.empty() ? 0 : theta[i]};
        for (std::size_t k = 0; k < b.tuple[i].size(); ++k) raw.place[k] = *b.tuple[i][k];
        options_.raw(raw);
    }
}

extern template class Certificate_sums<2>;
extern template class Certificate_sums<3>;

}  // namespace annulus::inline v1
