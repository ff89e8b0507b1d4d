// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/version.h>
#include <apps/formats/decimal.h>
#include <apps/report/degeneracy_report.h>
#include <apps/report/summary.h>

namespace annulus::inline v1 {

namespace {

using Json = nlohmann::ordered_json;

Json stages_json(const Stage_counts& s) { return {{"filter", s.filter}, {"interval", s.interval}, {"exact", s.exact}}; }

Json distribution_json(const Distribution& d) {
    Json json;
    Json& quantiles = json["quantiles"] = Json::object();
    for (std::size_t i = 0; i < d.quantiles.size(); ++i)
        quantiles[decimal(Distribution::probabilities[i])] = d.quantiles[i];
    const Histogram& h = d.histogram;
    json["histogram"] = Json{{"edges", std::vector<double>(h.edges().begin(), h.edges().end())},
                             {"counts", std::vector<std::uint64_t>(h.counts().begin(), h.counts().end())},
                             {"underflow", h.underflow()},
                             {"overflow", h.overflow()}};
    return json;
}

Json below_json(const std::vector<std::uint64_t>& below, const std::vector<Threshold>& thresholds) {
    Json json = Json::object();
    for (std::size_t k = 0; k < below.size(); ++k) json[thresholds[k].name] = below[k];
    return json;
}

Json widths_json(const Width_counts& c, const std::vector<Threshold>& thresholds) {
    return {{"total", c.total},
            {"zero", c.zero},
            {"below", below_json(c.below, thresholds)},
            {"width", distribution_json(c.width)}};
}

Json certificates_json(const Certificate_counts& c, const std::vector<Threshold>& thresholds) {
    Json json = widths_json(c.least, thresholds);
    json["arithmetic"] = stages_json(c.arithmetic);
    json["counted_exactly"] = c.decided_exactly;
    return json;
}

double share(std::uint64_t part, std::uint64_t all) {
    return all == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(all);
}

}  // namespace

Json degeneracy_json(const Degeneracy_record& r) {
    Json json{{"command", r.command},
              {"version", ANNULUS_VERSION_STRING},
              {"file", r.file},
              {"dimension", r.dimension},
              {"points", r.points},
              {"merged", r.points - r.vertices},
              {"vertices", r.vertices},
              {"affine_dimension", r.affine_dimension},
              {"simplices", r.simplices},
              {"seconds", {{"triangulation", r.seconds_triangulation}, {"analysis", r.seconds_analysis}}}};
    append_input(json, r.input);
    const bool measured = r.measured.has_value();
    for (const char* name : {"mean_spacing", "resolution", "thresholds", "bicells", "standard_annuli", "cells",
                             "ridges", "convexity", "theta", "tolerance"})
        json[name] = nullptr;
    if (!measured) return json;
    const Degeneracy& d = *r.measured;
    json["mean_spacing"] = d.spacing;
    json["resolution"] = d.resolution;
    Json& thresholds = json["thresholds"] = Json::array();
    for (const Threshold& t : d.thresholds)
        thresholds.push_back({{"name", t.name}, {"width", t.width}, {"relative", t.relative}});
    json["bicells"] = certificates_json(d.bicells, d.thresholds);
    if (d.dimension == 3) json["standard_annuli"] = widths_json(d.standard, d.thresholds);
    json["cells"] = certificates_json(d.cells, d.thresholds);
    if (!d.periodic) json["ridges"] = certificates_json(d.ridges, d.thresholds);
    const std::uint64_t bicells = d.bicells.least.total;
    json["convexity"] = Json{{"non_convex", d.non_convex},
                             {"share_non_convex", share(d.non_convex, bicells)},
                             {"flat", d.flat},
                             {"arithmetic", stages_json(d.convexity)}};
    json["theta"] = distribution_json(d.theta);
    const Vertex_counts& v = d.vertices;
    json["tolerance"] = Json{{"total", v.total},
                             {"zero", v.zero},
                             {"below", below_json(v.below, d.thresholds)},
                             {"certified", distribution_json(v.certified)}};
    if (d.periodic) return json;
    json["tolerance"].update(Json{{"paper", distribution_json(v.paper)},
                                  {"paper_above_exact", v.paper_above_exact},
                                  {"share_above_exact", share(v.paper_above_exact, v.total)},
                                  {"paper_unsound", v.paper_unsound},
                                  {"share_unsound", share(v.paper_unsound, v.total)},
                                  {"unsound_certificates", v.unsound_certificates}});
    return json;
}

}  // namespace annulus::inline v1
