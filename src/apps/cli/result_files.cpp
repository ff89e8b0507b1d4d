// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/result_files.h>
#include <apps/experiment/sweep_names.h>
#include <apps/formats/directory_lock.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

namespace annulus::inline v1::cli {

namespace {

/// The main result files, by which a directory of results is recognised. Each contains its command.
constexpr std::array<std::string_view, 8> heads{"summary.json",    "compare.json",        "audit.json",
                                                "degeneracy.json", "counterexample.json", "reproduction.json",
                                                "sums.json",       "advise.json"};
constexpr std::array<std::string_view, 18> others{
    "iterations.csv",  "dihedral.csv",   "final.mesh", "domain.mesh", "domain.vtu",   "domain.msh",
    "domain.vtk",      "quality.csv",    "final.vtu",  "report.html", "stipples.svg", "ids.csv",
    "degeneracy.html", "degeneracy.csv", "frames.pvd", "voronoi.csv", "pairs.csv",    "changes.csv"};

/// frame-000012.vtu
bool is_frame(std::string_view name) {
    return name.starts_with("frame-") && name.ends_with(".vtu") && name.size() >= 16 &&
           name.substr(6, name.size() - 10).find_first_not_of("0123456789") == std::string_view::npos;
}

template <std::size_t n>
bool is_one_of(const std::array<std::string_view, n>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether annulus has written results to this directory. A summary.json of another program does not count.
bool holds_results(const std::filesystem::path& directory) {
    const Directory_lock reading(directory,
                                 Directory_lock::Access::reading);  // another run may be moving its files there
    return std::any_of(heads.begin(), heads.end(), [&](std::string_view name) {
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(directory / name, ignored)) return false;  // a pipe could block for ever
        std::string begin(4096, '\0');
        std::ifstream file(directory / name, std::ios::binary);
        file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
        return begin.find("\"command\": \"annulus ") != std::string::npos;
    });
}

bool holds_anything(const std::filesystem::path&) { return true; }

std::string directory_of(const Common_arguments& a, bool interrupted) {
    return interrupted ? partial(a.output) : a.output;
}

}  // namespace

/// Whether a file is a page of `reproduce` or one of its tables: figure-7.html, figure-7a.csv.
bool is_of_reproduction(std::string_view name) {
    const bool known = name == "index.html" || name == "claims.csv" || name.starts_with("unsound.") ||
                       name.starts_with("figure-") || name.starts_with("slivers.") || name.starts_with("locked.") ||
                       name.starts_with("movers.") || name.starts_with("movers-");
    return known && (name.ends_with(".html") || name.ends_with(".csv"));
}

bool is_result(std::string_view name) {
    return is_one_of(heads, name) || is_one_of(others, name) || is_sweep_file(name) || is_frame(name) ||
           is_of_reproduction(name) || (name.starts_with("iterations-") && name.ends_with(".csv"));
}

Result_files::Result_files(const Common_arguments& a, Output_directory::Replaced replaced, bool interrupted)
    : out_(directory_of(a, interrupted), replaced, a.force ? holds_anything : holds_results) {}

void require_writable(const Common_arguments& arguments, Output_directory::Replaced replaced) {
    Result_files(arguments, replaced).write("probe", "");
}

std::string partial(const std::string& directory) {
    std::filesystem::path path(directory);
    if (!path.has_filename()) path = path.parent_path();  // "out/"
    if (path.filename() == "." || path.filename() == "..") path = std::filesystem::weakly_canonical(path);
    return path.string() + ".partial";
}

}  // namespace annulus::inline v1::cli
