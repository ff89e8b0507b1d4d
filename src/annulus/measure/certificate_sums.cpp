// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/certificate_sums.h>

#include <annulus/error.h>

#include <numbers>
#include <string>

namespace annulus::inline v1 {

template <int d>
Certificate_sums<d>::Certificate_sums(std::size_t indices, double spacing, double resolution,
                                      const Degeneracy_options<d>& options)
    : options_(options),
      theta_samples_({Histogram::linear(0, std::numbers::pi / 2, 36)}),
      tolerance_(indices, std::numeric_limits<double>::infinity()),
      marks_(indices, 0) {
    if (options.threads < 1)
        throw Error(Error_code::usage, "threads must be 1 or more, not " + std::to_string(options.threads));
    r_.dimension = d;
    r_.spacing = spacing;
    r_.resolution = resolution;
    for (const auto& [name, relative] : options.thresholds)
        r_.thresholds.push_back({name, relative * r_.spacing, relative});
    r_.thresholds.push_back({"ulp", r_.resolution, r_.resolution / r_.spacing});
    for (auto* counts : {&r_.standard, &r_.bicells.least, &r_.cells.least, &r_.ridges.least})
        counts->below.resize(r_.thresholds.size());
    r_.vertices.below.resize(r_.thresholds.size());
}

template <int d>
void Certificate_sums<d>::enter_bicells(const Bicell_batch<d>& b) {
    enter_certificates(b, Kind::bicell, r_.bicells, width_samples_[0], b.theta);
    r_.convexity += b.convexity;
    for (std::size_t i = 0; i < b.id.size(); ++i) {
        if (d == 3) enter_width(b.all[i].standard, b.below_standard[i], r_.standard, width_samples_[3]);
        r_.non_convex += b.convex[i] < 0 ? 1U : 0U;
        r_.flat += b.convex[i] == 0 ? 1U : 0U;
        theta_samples_.add(b.theta[i], options_.quantiles);
    }
}

template <int d>
void Certificate_sums<d>::enter_width(const Half_width& h, const Below_thresholds& below, Width_counts& counts,
                                      Samples& samples) const {
    ++counts.total;
    counts.zero += h.upper == 0.0 ? 1U : 0U;
    for (std::size_t k = 0; k < counts.below.size(); ++k) counts.below[k] += below.width >> k & 1U;
    samples.add(2 * h.lower / r_.spacing, options_.quantiles);
}

template <int d>
Degeneracy Certificate_sums<d>::result() {
    r_.bicells.least.width = width_samples_[0].result();
    r_.cells.least.width = width_samples_[1].result();
    r_.ridges.least.width = width_samples_[2].result();
    if (d == 3) r_.standard.width = width_samples_[3].result();
    r_.theta = theta_samples_.result();
    Vertex_counts& v = r_.vertices;
    for (const unsigned mark : marks_) {
        v.zero += mark & 1U;
        for (std::size_t k = 0; k < v.below.size(); ++k) v.below[k] += mark >> (k + 1) & 1U;
    }
    std::erase(tolerance_, std::numeric_limits<double>::infinity());
    v.total = tolerance_.size();
    Samples certified;
    for (const double x : tolerance_) certified.add(x / r_.spacing, options_.quantiles);
    v.certified = certified.result();
    return std::move(r_);
}

template class Certificate_sums<2>;
template class Certificate_sums<3>;

}  // namespace annulus::inline v1
