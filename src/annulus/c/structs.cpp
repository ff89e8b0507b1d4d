// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/c/structs.h>

namespace annulus::inline v1::c {

namespace {

template <class Value>
void choose(Value& value, const char* name, std::optional<Value> (*named)(std::string_view), const char* what,
            const char* all) {
    if (name == nullptr) return;
    const std::optional<Value> found = named(name);
    if (!found)
        throw Refused(ANNULUS_USAGE, "there is no " + std::string(what) + " \"" + std::string(name).substr(0, 40) +
                                         "\"; there " + all);
    value = *found;
}

std::optional<Tolerance_kind> certified_named(std::string_view name) {
    const std::optional<Tolerance_kind> kind = tolerance_kind_named(name);
    return kind == Tolerance_kind::certified ? kind : std::nullopt;
}

/// What is given, as this version knows it.
annulus_options known_of(const annulus_options* given) {
    annulus_options known{};
    if (given == nullptr) return known;
    require_struct(given->size, sizeof(given->size), "annulus_options");
    std::memcpy(&known, given, std::min(given->size, sizeof known));
    // A caller compiled with a later version of the header must leave the members unknown to this library at 0.
    const auto* beyond = reinterpret_cast<const unsigned char*>(given);
    for (std::size_t i = sizeof known; i < given->size; ++i)
        if (beyond[i] != 0)
            throw Refused(ANNULUS_USAGE, "annulus_options sets options that this version of the library does not have");
    if (known.reserved != 0) throw Refused(ANNULUS_USAGE, "annulus_options.reserved is not 0");
    return known;
}

/// All but the strategy and the kind of tolerance.
Options others_of(const annulus_options& known) {
    Options options;
    if (known.second_look != nullptr && std::string_view(known.second_look) != "off")
        throw Refused(ANNULUS_USAGE, "annulus_options.second_look is neither NULL nor \"off\"");
    if (known.threads != 0) options.threads = known.threads;  // Engine refuses what is below 1
    options.merge_duplicates = known.merge_duplicates != 0;
    options.report_changes = known.report_changes != 0;
    options.seed = known.seed;
    return options;
}

}  // namespace

Options options_of(const annulus_options* given) {
    const annulus_options known = known_of(given);
    Options options = others_of(known);
    choose(options.strategy, known.strategy, strategy_named, "strategy",
           "are auto, tolerances, tolerances-each, in-place, paper, paper-hybrid, relocate, relocate-flips, rebuild");
    choose(options.tolerance, known.tolerance, tolerance_kind_named, "kind of tolerance",
           "are certified, paper, floating");
    return options;
}

Periodic_options periodic_options_of(const annulus_options* given) {
    const annulus_options known = known_of(given);
    const Options others = others_of(known);
    Periodic_options options;
    Tolerance_kind tolerance{};
    choose(options.strategy, known.strategy, periodic_strategy_named, "strategy in a periodic box",
           "are auto, signs, tolerances");
    choose(tolerance, known.tolerance, certified_named, "kind of tolerance in a periodic box", "is certified");
    options.merge_duplicates = others.merge_duplicates;
    options.threads = others.threads;
    options.report_changes = others.report_changes;
    return options;
}

void write_report(annulus_report* to, const Move_result& done, std::size_t changed) {
    if (to == nullptr) return;
    annulus_report r{};
    const Move_statistics& cost = done.statistics;
    r.asked = done.moves.asked;
    r.within_tolerance = done.moves.within_tolerance;
    r.kept_in_place = done.moves.kept_in_place;
    r.flipped = done.moves.flipped;
    r.reinserted = done.moves.reinserted;
    r.rebuilt = done.moves.rebuilt;
    r.evaluated = cost.evaluated;
    r.by_filter = cost.arithmetic.filter;
    r.by_intervals = cost.arithmetic.interval;
    r.by_integers = cost.arithmetic.exact;
    r.flips = cost.flips;
    r.tolerance_steps = cost.tolerance_steps;
    r.sign_steps = cost.sign_steps;
    r.rebuild_steps = cost.rebuild_steps;
    r.changed = changed;
    r.cost = cost.cost;
    write_struct(to, r);
}

void write_audit(annulus_audit_result* to, const Audit_result& verdict) {
    annulus_audit_result r{};
    r.delaunay = verdict.delaunay() ? 1 : 0;
    r.inverted_cells = verdict.inverted_cells;
    r.violated_facets = verdict.violated_facets;
    r.concave_ridges = verdict.concave_ridges;
    r.topological_faults = verdict.topological_faults;
    r.degenerate_facets = verdict.degenerate_facets;
    const std::size_t length = std::min(verdict.first_fault.size(), sizeof r.first_fault - 1);
    std::copy_n(verdict.first_fault.data(), length, r.first_fault);
    write_struct(to, r);
}

}  // namespace annulus::inline v1::c
