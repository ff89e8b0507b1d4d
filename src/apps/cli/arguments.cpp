// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/arguments.h>

#include <annulus/error.h>
#include <apps/formats/input_error.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

namespace annulus::inline v1::cli {

void Common_arguments::say_merged(const std::string& file, std::uint64_t count) const {
    if (count > 0 && !quiet)
        std::fprintf(stderr, "annulus: %s: merged %s\n", file.c_str(), counted(count, "duplicate point").c_str());
}

void Common_arguments::say_notes(const std::vector<std::string>& notes) const {
    for (const std::string& note : notes)
        if (!quiet) std::fprintf(stderr, "annulus: %s\n", note.c_str());
}

CLI::Validator whole_number(std::uint64_t least, std::uint64_t most) {
    const std::string range = std::to_string(least) + " to " + std::to_string(most);
    const auto check = [=](const std::string& word) {
        std::uint64_t value = 0;
        const char* const end = word.data() + word.size();
        const auto [stop, error] = std::from_chars(word.data(), end, value);
        const bool plain = error == std::errc() && stop == end && (word[0] != '0' || word.size() == 1);
        if (plain && value >= least && value <= most) return std::string();
        return "'" + word + "' is not a whole number from " + range;
    };
    return {check, most < std::numeric_limits<std::uint64_t>::max() ? range : "", "whole number"};
}

CLI::Validator number_within(double least, double most) {
    const CLI::Range range(least, most);
    const auto check = [range](const std::string& word) {
        double value = 0;
        if (CLI::detail::lexical_cast(word, value) && std::isnan(value)) return "'" + word + "' is not a number";
        return range(word);
    };
    return {check, range.get_description(), "number"};
}

void refuse_empty_values(CLI::App& app) {
    const auto check = [](const std::string& word) { return word.empty() ? std::string("the value is empty") : ""; };
    for (CLI::Option* const option : app.get_options())
        if (option->get_items_expected_max() > 0) option->check(check);
}

void add_common(CLI::App& app, Common_arguments& a, const std::string& files, const Common_words& words) {
    app.add_option("-o,--output", a.output, "Write " + files + " to this directory")->type_name("DIR");
    app.add_flag("--force", a.force, "Write to a directory that holds files other than results; these are kept");
    app.add_option("--seed", a.seed, words.seed)
        ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
        ->capture_default_str();
    app.add_option("--threads", a.threads, words.threads)->check(whole_number(1, 1024))->capture_default_str();
    app.add_flag("-q,--quiet", a.quiet, "No progress and no summary, only errors and the exit status");
}

void add_format(CLI::App& app, std::string& format, std::span<const Format> formats) {
    app.add_option("--format", format, "Format of the file, whatever its extension says; standard input has none")
        ->check(CLI::IsMember(names_of(formats)));
}

void add_columns(CLI::App& app, std::string& columns) {
    app.add_option("--columns", columns,
                   "Columns of a table, by name or number: id=particle,frame=t,x=POSITION_X,y=POSITION_Y; without it\n"
                   "they are found by the names that tracking programs give them")
        ->type_name("LIST");
}

void add_tracking(CLI::App& app, Tracking_arguments& a, bool boxed) {
    std::vector<std::string> strategies{"auto",       "rebuild",         "relocate", "relocate-flips", "in-place",
                                        "tolerances", "tolerances-each", "paper",    "paper-hybrid"};
    if (boxed) strategies.emplace_back("signs");
    app.add_option("--strategy", a.strategy,
                   boxed
                       ? "How the triangulation is kept right; in a periodic box auto, rebuild, tolerances, or signs,\n"
                         "which is for boxes only"
                       : "How the triangulation is kept right")
        ->check(CLI::IsMember(strategies))
        ->capture_default_str();
    app.add_option("--tolerance", a.tolerance,
                   "Kind of tolerance; only certified ones are proved, the others are for the strategies paper and "
                   "paper-hybrid")
        ->check(CLI::IsMember({"certified", "paper", "floating"}))
        ->capture_default_str();
    app.add_option("--audit", a.audit, "Exact audit every N steps and at the end; 0: never")
        ->type_name("N")
        ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
        ->capture_default_str();
}

Options options_of(const Tracking_arguments& tracking, const Common_arguments& common) {
    Options o;
    const auto strategy = strategy_named(tracking.strategy);
    const auto tolerance = tolerance_kind_named(tracking.tolerance);
    if (!strategy && tracking.strategy == "signs")
        throw Error(Error_code::usage, "the strategy signs is for periodic boxes: use auto, or in-place");
    if (!strategy) throw Error(Error_code::usage, "no strategy is called '" + tracking.strategy + "'");
    if (!tolerance) throw Error(Error_code::usage, "no kind of tolerance is called '" + tracking.tolerance + "'");
    o.strategy = *strategy;
    o.tolerance = *tolerance;
    o.threads = common.threads;
    o.seed = common.seed;
    return o;
}

Options boxed_options_of(const Tracking_arguments& tracking, const Common_arguments& common,
                         const std::string& otherwise) {
    if (tracking.tolerance != "certified")
        throw Error(Error_code::usage,
                    "in a periodic box tolerances are certified, not " + tracking.tolerance + otherwise);
    Tracking_arguments open = tracking;
    if (tracking.strategy == "signs") open.strategy = name_of(Strategy::in_place);
    else if (tracking.strategy != "rebuild" && !periodic_strategy_named(tracking.strategy))
        throw Error(Error_code::usage,
                    "in a periodic box the strategies are auto, rebuild, signs and tolerances, not " +
                        tracking.strategy + otherwise);
    return options_of(open, common);
}

std::string command_line(const std::vector<std::string>& words) {
    std::string line = "annulus";
    for (const std::string& w : words) {
        const bool plain = !w.empty() && w.find_first_not_of(
                                             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                             "0123456789-_./:,=+") == std::string::npos;
        if (plain) {
            line += " " + w;
            continue;
        }
        line += " '";
        for (const char c : w) {
            if (c == '\'') {
                line += "'\\''";
            } else {
                line += c;
            }
        }
        line += "'";
    }
    return line;
}

}  // namespace annulus::inline v1::cli
