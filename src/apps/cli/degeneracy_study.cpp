// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/degeneracy_study.h>

#include <annulus/error.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/measure/degeneracy.h>
#include <annulus/periodic_mesh.h>
#include <apps/cli/raw_file.h>
#include <apps/cli/stopwatch.h>

#include <charconv>
#include <cmath>

namespace annulus::inline v1::cli {

/// Each threshold as text, for example "1e-4", and as a number.
std::vector<std::pair<std::string, double>> thresholds_of(const std::vector<std::string>& words) {
    std::vector<std::pair<std::string, double>> thresholds;
    for (const std::string& word : words) {
        double value = 0;
        const char* const end = word.data() + word.size();
        const auto [stop, error] = std::from_chars(word.data(), end, value);
        if (error == std::errc::result_out_of_range && stop == end)
            throw Error(Error_code::usage, "--thresholds: '" + word + "' is beyond what a double can hold");
        if (error != std::errc() || stop != end || !(value > 0) || !std::isfinite(value))
            throw Error(Error_code::usage, "--thresholds: '" + word + "' is not a positive number");
        for (const auto& [name, other] : thresholds)
            if (other == value) throw Error(Error_code::usage, "--thresholds: " + word + " is named twice");
        thresholds.emplace_back(word, value);
    }
    if (thresholds.size() > Degeneracy_options<2>::most_thresholds)
        throw Error(Error_code::usage,
                    "--thresholds takes " + std::to_string(Degeneracy_options<2>::most_thresholds) + " at most");
    return thresholds;
}

namespace {

/// With the time that the triangulation takes.
template <int d>
void study_open(const Studied_points<d>& points, const Degeneracy_options<d>& options, Degeneracy_record& r) {
    const auto begin = Clock::now();
    Delaunay_mesh<d> mesh;
    mesh.build(points.x);
    r.seconds_triangulation = since(begin);
    r.affine_dimension = mesh.dimension();
    std::vector<Index> corners;
    mesh.list_cells(points.x, corners);
    r.simplices = corners.size() / (d + 1);
    if (r.affine_dimension == d) r.measured = degeneracy(mesh.table(), points.x, options);
}
template <int d>
void study_in_box(const Studied_points<d>& points, const Degeneracy_options<d>& options, Degeneracy_record& r) {
    const auto begin = Clock::now();
    const Periodic_mesh<d> mesh(points.x, *points.box, {.threads = options.threads});
    r.seconds_triangulation = since(begin);
    r.affine_dimension = d;
    r.simplices = mesh.number_of_cells();
    if (!points.x.empty()) r.measured = degeneracy(mesh, options);
}

}  // namespace

template <int d>
Degeneracy_record study_points(const Studied_points<d>& points, const Study_options& a) {
    Degeneracy_record r;
    r.file = points.file;
    r.dimension = d;
    r.vertices = points.x.size();
    std::optional<Raw_file<d>> raw;
    if (!a.raw.empty()) raw.emplace(a.raw, points.id, points.ids);
    Degeneracy_options<d> options;
    options.threads = a.threads;
    if (!a.thresholds.empty()) options.thresholds = thresholds_of(a.thresholds);
    if (raw) options.raw = [&raw](const Raw_certificate<d>& c) { (*raw)(c); };
    const auto begin = Clock::now();
    if (points.box) study_in_box(points, options, r);
    else study_open(points, options, r);
    if (raw) raw->commit();
    r.seconds_analysis = since(begin) - r.seconds_triangulation;
    return r;
}

template Degeneracy_record study_points(const Studied_points<2>&, const Study_options&);
template Degeneracy_record study_points(const Studied_points<3>&, const Study_options&);

}  // namespace annulus::inline v1::cli
