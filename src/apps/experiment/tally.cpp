// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/tally.h>

#include <annulus/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace annulus::inline v1 {

namespace {

constexpr std::array counted_stages{Stage::filter, Stage::interval, Stage::exact};
constexpr double infinity = std::numeric_limits<double>::infinity();

std::string with_stage(const std::string& name, Stage stage) { return name + "." + std::string(name_of(stage)); }

std::vector<Scale_of> all_scales() {
    const Distribution lengths{};
    std::vector<Scale_of> all;
    for (const char* name :
         {"bicells.width", "standard.width", "cells.width", "ridges.width", "tolerance.certified", "tolerance.paper"})
        all.push_back({name, "mean spacings", lengths.histogram});
    all.push_back({"tolerance.paper_over_exact", "1", Vertex_counts{}.paper_ratio});
    all.push_back({"theta", "radians", Histogram::linear(0, std::numbers::pi / 2, 36)});
    for (const Stage stage : counted_stages) {
        all.push_back({with_stage("theta_log", stage), "radians", Histogram::log10(1e-12, 10, 52)});
        all.push_back({with_stage("bicells.width_ulps", stage), "ulps of the largest coordinate",
                       Histogram::log10(1e-8, 1e20, 112)});
        all.push_back({with_stage("cells.width_ulps", stage), "ulps of the largest coordinate",
                       Histogram::log10(1e-8, 1e20, 112)});
    }
    return all;
}

void add_stages(Tally& t, const std::string& name, const Stage_counts& s) {
    t.counts[name + ".stage.filter"] = s.filter;
    t.counts[name + ".stage.interval"] = s.interval;
    t.counts[name + ".stage.exact"] = s.exact;
}

void add_widths(Tally& t, const std::string& name, const Width_counts& w, const std::vector<Threshold>& thresholds) {
    t.counts[name + ".total"] = w.total;
    t.counts[name + ".zero"] = w.zero;
    for (std::size_t k = 0; k < w.below.size(); ++k) t.counts[name + ".below." + thresholds[k].name] = w.below[k];
    t.histograms[name + ".width"] = bins_of(w.width.histogram);
}

}  // namespace

Tally& Tally::operator+=(const Tally& other) {
    for (const auto& [name, n] : other.counts) counts[name] += n;
    for (const auto& [name, from] : other.histograms) {
        Bins& to =
            histograms.try_emplace(name, Bins{0, 0, std::vector<std::uint64_t>(from.in.size(), 0)}).first->second;
        if (to.in.size() != from.in.size())
            throw Error(Error_code::bad_input, "histograms '" + name + "' have different bins");
        to.below += from.below;
        to.above += from.above;
        for (std::size_t i = 0; i < from.in.size(); ++i) to.in[i] += from.in[i];
    }
    for (const auto& [name, x] : other.least) {
        const auto [at, fresh] = least.try_emplace(name, x);
        if (!fresh) at->second = std::min(at->second, x);
    }
    return *this;
}

std::uint64_t count(const Tally& tally, const std::string& name) {
    const auto found = tally.counts.find(name);
    return found == tally.counts.end() ? 0 : found->second;
}

const std::vector<Scale_of>& scales() {
    static const std::vector<Scale_of> all = all_scales();
    return all;
}
const Histogram& scale(const std::string& name) {
    for (const Scale_of& s : scales())
        if (s.name == name) return s.empty;
    throw std::out_of_range("no histogram is called " + name);
}

Bins bins_of(const Histogram& h) { return {h.underflow(), h.overflow(), {h.counts().begin(), h.counts().end()}}; }

double quantile(const Bins& bins, const Histogram& scale, double p) {
    std::uint64_t total = bins.below + bins.above;
    for (const std::uint64_t n : bins.in) total += n;
    if (total == 0) return std::numeric_limits<double>::quiet_NaN();
    const double rank = p * static_cast<double>(total);
    double passed = static_cast<double>(bins.below);
    const auto edges = scale.edges();
    if (rank <= passed) return edges.front();
    for (std::size_t i = 0; i < bins.in.size(); ++i) {
        const double n = static_cast<double>(bins.in[i]);
        if (n > 0 && rank <= passed + n) {
            const double t = (rank - passed) / n;
            return scale.logarithmic() ? edges[i] * std::pow(edges[i + 1] / edges[i], t)
                                       : edges[i] * (1 - t) + edges[i + 1] * t;
        }
        passed += n;
    }
    return edges.back();
}

Tally tally_of(const Degeneracy& d) {
    Tally t;
    t.counts["experiments"] = 1;
    t.counts["vertices"] = d.vertices.total;
    add_widths(t, "bicells", d.bicells.least, d.thresholds);
    add_widths(t, "cells", d.cells.least, d.thresholds);
    if (!d.periodic) add_widths(t, "ridges", d.ridges.least, d.thresholds);
    if (d.dimension == 3) add_widths(t, "standard", d.standard, d.thresholds);
    add_stages(t, "bicells", d.bicells.arithmetic);
    add_stages(t, "cells", d.cells.arithmetic);
    if (!d.periodic) add_stages(t, "ridges", d.ridges.arithmetic);
    add_stages(t, "convexity", d.convexity);
    t.counts["bicells.not_convex"] = d.non_convex;
    t.counts["bicells.flat"] = d.flat;
    const Vertex_counts& v = d.vertices;
    t.counts["tolerance.zero"] = v.zero;
    for (std::size_t k = 0; k < v.below.size(); ++k) t.counts["tolerance.below." + d.thresholds[k].name] = v.below[k];
    t.histograms["tolerance.certified"] = bins_of(v.certified.histogram);
    t.histograms["theta"] = bins_of(d.theta.histogram);
    if (d.periodic) return t;
    t.counts["tolerance.paper_above_exact"] = v.paper_above_exact;
    t.counts["tolerance.paper_unsound"] = v.paper_unsound;
    t.counts["tolerance.unsound_certificates"] = v.unsound_certificates;
    t.histograms["tolerance.paper"] = bins_of(v.paper.histogram);
    t.histograms["tolerance.paper_over_exact"] = bins_of(v.paper_ratio);
    return t;
}

Certificate_tally::Certificate_tally(double resolution)
    : resolution_(resolution),
      theta_(counted_stages.size(), scale("theta_log.filter")),
      width_(counted_stages.size(), scale("bicells.width_ulps.filter")),
      cell_width_(counted_stages.size(), scale("cells.width_ulps.filter")),
      least_(infinity),
      least_positive_(infinity) {}

void Certificate_tally::add_bicell(double theta, double width, Stage stage) {
    const auto s = static_cast<std::size_t>(stage);
    theta_[s].add(theta);
    width_[s].add(width / resolution_);
    least_ = std::min(least_, width);
    if (width > 0) least_positive_ = std::min(least_positive_, width);
}
void Certificate_tally::add_cell(double width, Stage stage) {
    cell_width_[static_cast<std::size_t>(stage)].add(width / resolution_);
}

void Certificate_tally::add_to(Tally& tally, double spacing) const {
    Tally more;
    for (const Stage stage : counted_stages) {
        const auto s = static_cast<std::size_t>(stage);
        more.histograms[with_stage("theta_log", stage)] = bins_of(theta_[s]);
        more.histograms[with_stage("bicells.width_ulps", stage)] = bins_of(width_[s]);
        more.histograms[with_stage("cells.width_ulps", stage)] = bins_of(cell_width_[s]);
    }
    if (least_ < infinity) more.least["bicells.width"] = least_ / spacing;
    if (least_positive_ < infinity) more.least["bicells.width.positive"] = least_positive_ / spacing;
    tally += more;
}

nlohmann::ordered_json tally_json(const Tally& t) {
    nlohmann::ordered_json json{{"counts", nlohmann::ordered_json::object()},
                                {"least", nlohmann::ordered_json::object()},
                                {"histograms", nlohmann::ordered_json::object()}};
    for (const auto& [name, n] : t.counts) json["counts"][name] = n;
    for (const auto& [name, x] : t.least) json["least"][name] = x;
    for (const auto& [name, bins] : t.histograms) {
        const auto some = [](std::uint64_t n) { return n != 0; };
        const auto first = std::find_if(bins.in.begin(), bins.in.end(), some);
        const auto last = std::find_if(bins.in.rbegin(), bins.in.rend(), some).base();
        json["histograms"][name] = {
            {"below", bins.below},
            {"above", bins.above},
            {"first", first == bins.in.end() ? 0 : first - bins.in.begin()},
            {"in", first == bins.in.end() ? std::vector<std::uint64_t>() : std::vector<std::uint64_t>(first, last)}};
    }
    return json;
}

Tally tally_of(const nlohmann::ordered_json& json) {
    Tally t;
    for (const auto& [name, n] : json.at("counts").items()) t.counts[name] = n.get<std::uint64_t>();
    for (const auto& [name, x] : json.at("least").items()) t.least[name] = x.get<double>();
    for (const auto& [name, h] : json.at("histograms").items()) {
        Bins& bins = t.histograms[name];
        bins.below = h.at("below").get<std::uint64_t>();
        bins.above = h.at("above").get<std::uint64_t>();
        const auto in = h.at("in").get<std::vector<std::uint64_t>>();
        const auto first = h.at("first").get<std::size_t>();
        bins.in.assign(scale(name).counts().size(), 0);
        if (first > bins.in.size() || in.size() > bins.in.size() - first)
            throw Error(Error_code::bad_input, "histogram '" + name + "' has more bins than there are");
        std::copy(in.begin(), in.end(), bins.in.begin() + static_cast<std::ptrdiff_t>(first));
    }
    return t;
}

}  // namespace annulus::inline v1
