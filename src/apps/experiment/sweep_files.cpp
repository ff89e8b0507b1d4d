// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/sweep_files.h>

#include <annulus/version.h>
#include <apps/formats/decimal.h>
#include <apps/formats/text_output.h>
#include <apps/formats/write_json.h>

#include <cmath>

namespace annulus::inline v1 {

namespace {

using Json = nlohmann::ordered_json;

Json scales_json() {
    Json json = Json::object();
    for (const Scale_of& s : scales()) {
        const auto edges = s.empty.edges();
        json[s.name] = {{"unit", s.unit},
                        {"scale", s.empty.logarithmic() ? "log10" : "linear"},
                        {"lower", edges.front()},
                        {"upper", edges.back()},
                        {"bins", edges.size() - 1}};
    }
    return json;
}

Json quantiles_json(const Tally& t) {
    Json json = Json::object();
    for (const auto& [name, bins] : t.histograms) {
        const Histogram& s = scale(name);
        Json& of = json[name] = Json::object();
        for (const double p : Distribution::probabilities)
            if (const double x = quantile(bins, s, p); p > 0 && p < 1 && !std::isnan(x)) of[decimal(p)] = x;
    }
    return json;
}

Json sums_json(const Spec& spec, const std::vector<Grid_point>& points) {
    Json json{{"command", "annulus sweep"},
              {"version", ANNULUS_VERSION_STRING},
              {"identity", spec.identity},
              {"title", spec.title},
              {"seed", spec.seed},
              {"hardest", spec.hardest},
              {"trials", spec.trials.size()},
              {"scales", scales_json()}};
    Json& sums = json["sums"] = Json::array();
    for (const Grid_point& point : points) {
        Json& one = sums.emplace_back(point.where);
        one.update(tally_json(point.tally));
        one["quantiles"] = quantiles_json(point.tally);
    }
    return json;
}

}  // namespace

void write_sweep(const Spec& spec, std::string_view text, const Journal& journal,
                 const std::vector<std::optional<std::size_t>>& entry, const Hard_inputs& hard, Output_directory& out) {
    Sums sums;
    {
        Text_output results(out.path_of("results.jsonl")), costs(out.path_of("costs.jsonl"));
        for (std::size_t i = 0; i < entry.size(); ++i) {
            const Json json = Json::parse(journal.entry(entry[i].value()));
            for (const Json& line : json.at("lines")) {
                results.write(line.dump() + "\n");
                sums.add(line);
            }
            Json cost{{"trial", i}};
            cost.update(json.at("cost"));
            costs.write(cost.dump() + "\n");
        }
        results.commit();
        costs.commit();
    }
    Text_output hardest(out.path_of("hard.jsonl"));
    for (const Json& one : hard.json()) hardest.write(one.dump() + "\n");
    hardest.commit();
    out.write("sums.json", write_json(sums_json(spec, sums.points())));
    out.write("sweep.html", sweep_html(spec, sums.points()));
    out.write("spec.toml", text);
}

}  // namespace annulus::inline v1
