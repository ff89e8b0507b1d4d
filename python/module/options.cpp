// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/parts.h>

#include <annulus/error.h>

#include <optional>

namespace annulus::python {

namespace {

template <class T>
T chosen(const char* what, std::optional<T> value, const std::string& name, const char* choices) {
    if (!value) throw Error(Error_code::usage, std::string(what) + " '" + name + "' is none; there are " + choices);
    return *value;
}

}  // namespace

Options options_of(const std::string& strategy, const std::string& tolerance, int threads, bool merge_duplicates,
                   bool report_changes, std::uint64_t seed) {
    Options o;
    o.strategy = chosen(
        "strategy", strategy_named(strategy), strategy,
        "auto, tolerances, tolerances-each, in-place, rebuild, relocate, relocate-flips, paper and paper-hybrid");
    o.tolerance = chosen("tolerance", tolerance_kind_named(tolerance), tolerance, "certified, paper and floating");
    if (threads < 1) throw Error(Error_code::usage, "threads must be 1 or more, not " + std::to_string(threads));
    o.threads = threads;
    o.merge_duplicates = merge_duplicates;
    o.report_changes = report_changes;
    o.seed = seed;
    return o;
}

}  // namespace annulus::python
