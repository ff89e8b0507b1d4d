// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/reproduction/records.h>
#include <apps/reproduction/size.h>

#include <map>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// The input of the pages of a reproduction.
struct Reproduction {
    std::string command;
    std::string machine;  ///< processor and compiler, for display
    Reproduction_size size;
    std::map<std::string, Benchmark_record> benchmarks;  ///< by name
    std::string date{};                                  ///< of the pages, for display: "29 November 2026"

    /// Null if it was not requested, or could not be made.
    [[nodiscard]] const Benchmark_record* benchmark(const std::string& name) const {
        const auto found = benchmarks.find(name);
        return found == benchmarks.end() ? nullptr : &found->second;
    }
};

/// A file of the results: its name and its content.
struct Result_file {
    std::string name, content;
};

/// index.html with the claims of the paper and our results, a page for each figure with its numbers, reproduction.json.
[[nodiscard]] std::vector<Result_file> reproduction_files(const Reproduction& reproduction);

}  // namespace annulus::inline v1
