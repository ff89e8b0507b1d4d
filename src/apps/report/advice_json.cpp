// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/version.h>
#include <apps/formats/decimal.h>
#include <apps/report/advice.h>
#include <apps/report/summary.h>
#include <apps/report/walk_ratios.h>

namespace annulus::inline v1 {

namespace {

using Json = nlohmann::ordered_json;

/// `key` is the name of Id_event::what.
Json events_json(const Id_events& events, const char* key) {
    Json first = Json::array();
    for (const Id_event& e : events.first) first.push_back({{"frame", e.frame}, {"id", e.id}, {key, e.what}});
    return first;
}

Json displacement_json(const Displacement_record& d) {
    if (d.total == 0) return nullptr;
    Json quantiles = Json::object();
    for (std::size_t i = 0; i < d.quantiles.size(); ++i) quantiles[decimal(d.probabilities[i])] = d.quantiles[i];
    return {{"total", d.total}, {"at_rest", d.at_rest}, {"mean", d.mean}, {"quantiles", quantiles}};
}

Json degeneracy_json(const Advice_record& r) {
    if (!r.degeneracy) return nullptr;
    const Degeneracy& d = *r.degeneracy;
    Json below = Json::object(), tolerance = Json::object();
    for (std::size_t i = 0; i < d.thresholds.size(); ++i) below[d.thresholds[i].name] = d.bicells.least.below[i];
    const Distribution& t = d.vertices.certified;
    for (std::size_t i = 0; i < t.quantiles.size(); ++i) tolerance[decimal(t.probabilities[i])] = t.quantiles[i];
    Stage_counts all = d.bicells.arithmetic;
    all += d.cells.arithmetic;
    all += d.ridges.arithmetic;
    return {{"frame", r.degeneracy_frame},
            {"bicells", d.bicells.least.total},
            {"zero", d.bicells.least.zero},
            {"below", below},
            {"arithmetic", {{"filter", all.filter}, {"interval", all.interval}, {"exact", all.exact}}},
            {"tolerance", tolerance}};
}

Json expected_json(const Advice_record& r) {
    Json table = Json::array();
    for (const Walk_ratio& row : walk_ratios(r.dimension)) table.push_back({row.s, row.ratio});
    Json json{{"source", walk_ratios_source}, {"table", table}, {"s", nullptr}};
    json["gain"] = json["gain_over_cgal"] = nullptr;
    if (r.motion.displacement.total == 0) return json;
    const double s = walk_pace(r.dimension, r.motion.displacement.mean);
    json["s"] = s;
    json["gain"] = walk_gain(r.dimension, s);
    json["gain_over_cgal"] = walk_ratio(r.dimension, s);
    return json;
}

Json measured_json(const Prefix_record& p) {
    if (p.steps == 0) return nullptr;
    return {{"steps", p.steps},
            {"cost_in_rebuilds", {{"auto", p.automatic}, {"tolerances", p.tolerances}}},
            {"gain", 1 / p.automatic},  // null where nothing moves
            {"moves",
             {{"asked", p.moves.asked},
              {"within_tolerance", p.moves.within_tolerance},
              {"kept_in_place", p.moves.kept_in_place},
              {"flipped", p.moves.flipped},
              {"reinserted", p.moves.reinserted},
              {"rebuilt", p.moves.rebuilt}}},
            {"flips", p.flips},
            {"rebuild_steps", p.rebuild_steps}};
}

}  // namespace

Json advice_json(const Advice_record& r) {
    const Motion_record& m = r.motion;
    const auto d = static_cast<std::ptrdiff_t>(r.dimension);
    Json json{{"command", r.command},
              {"version", ANNULUS_VERSION_STRING},
              {"file", r.file},
              {"dimension", r.dimension},
              {"frames", m.frames},
              {"vertices", {{"least", m.least_vertices}, {"most", m.most_vertices}}},
              {"box",
               {{"low", std::vector<double>(m.low.begin(), m.low.begin() + d)},
                {"high", std::vector<double>(m.high.begin(), m.high.begin() + d)}}},
              {"mean_spacing", m.spacing}};
    append_input(json, r.input);
    json["frame_distance"] = nullptr;
    if (m.frames > 1) json["frame_distance"] = Json{{"least", m.least_distance}, {"most", m.most_distance}};
    json["displacement"] = displacement_json(m.displacement);
    json["duplicates"] = Json{{"points", m.duplicates.count},
                              {"frames", m.duplicates.frames},
                              {"first", events_json(m.duplicates, "where_is")}};
    json["ids"] = Json{{"appeared", m.appeared},
                       {"disappeared", m.disappeared},
                       {"steps", m.traffic.frames},
                       {"first", events_json(m.traffic, "what")}};
    json["wrapped"] = Json{{"suspected", m.wrapped},
                           {"jumps", m.jumps.count},
                           {"steps", m.jumps.frames},
                           {"first", events_json(m.jumps, "axis")}};
    json["degeneracy"] = degeneracy_json(r);
    json["expected"] = expected_json(r);
    json["measured"] = measured_json(r.prefix);
    json["seconds"] =
        Json{{"reading", r.seconds_reading}, {"following", r.seconds_following}, {"analysis", r.seconds_analysis}};
    const Advice advice = advice_of(r);
    json["advice"] = Json{{"strategy", advice.strategy},
                          {"reason", advice.reason},
                          {"times_as_often", advice.times_as_often},
                          {"sentence", advice.sentence}};
    return json;
}

}  // namespace annulus::inline v1
