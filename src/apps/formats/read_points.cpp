// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/arithmetic/domain.h>
#include <apps/formats/distinct.h>
#include <apps/formats/file_bytes.h>
#include <apps/formats/format.h>
#include <apps/formats/frame_readers.h>
#include <apps/formats/point_formats.h>
#include <apps/formats/read_points.h>

#include <algorithm>
#include <numeric>

namespace annulus::inline v1 {

namespace {

/// These formats define which numbers are coordinates.
Raw_points read_raw(File_bytes& bytes, Format format, const Read_options& options) {
    require_table(format, options.columns);
    const auto with = [](const char* what, Raw_points raw) {
        for (const char* axis : {"x", "y", "z"})
            if (*axis != 'z' || raw.has_z) raw.columns.emplace_back(axis, std::string(what) + axis);
        return raw;
    };
    switch (format) {
        case Format::off: return with("vertex ", read_off(load_file(bytes)));
        case Format::ply: return with("property ", read_ply(load_file(bytes)));
        case Format::mesh: return with("vertex ", read_medit_points(load_file(bytes)));
        default: return read_only_frame(bytes, format, {.box = options.box, .columns = options.columns});
    }
}

/// The points of a file, at least one.
Raw_points read_raw(const std::filesystem::path& file, const Read_options& options, std::string& name) {
    File_bytes bytes(file);
    name = bytes.name();
    Raw_points raw = read_raw(bytes, format_of(file, point_formats, options.format), options);
    if (raw.points.empty()) throw Input_error(Error_code::bad_input, name, 1, "has no points", "at least one point");
    return raw;
}

template <int d>
Point_file<d> points_of(std::string name, Raw_points raw, const Read_options& options) {
    static_assert(d == 2 || d == 3);
    Point_file<d> result;
    result.name = std::move(name);
    if (d == 2 && raw.has_z && !options.ignore_z)
        throw Input_error(Error_code::bad_input, result.name, raw.lines.front(),
                          "has a z coordinate; pass --ignore-z to drop it", "x and y only");
    if (d == 3 && !raw.has_z)
        throw Input_error(Error_code::bad_input, result.name, raw.lines.front(), "has no z coordinate", "x, y and z");
    result.points.reserve(raw.points.size());
    for (const Coordinates<3>& p : raw.points) {
        Coordinates<d> q;
        std::copy_n(p.begin(), d, q.begin());
        result.points.push_back(q);
    }
    result.lines = std::move(raw.lines);
    result.columns = std::move(raw.columns);
    if (d == 2) std::erase_if(result.columns, [](const auto& column) { return column.first == "z"; });
    result.notes = std::move(raw.notes);
    result.ignored_box = raw.ignored_box;
    result.box = std::move(raw.box);
    return result;
}

}  // namespace

template <int d>
Point_file<d> read_points(const std::filesystem::path& file, const Read_options& options) {
    std::string name;
    Raw_points raw = read_raw(file, options, name);
    return points_of<d>(std::move(name), std::move(raw), options);
}

std::variant<Point_file<2>, Point_file<3>> read_points_of_any_dimension(const std::filesystem::path& file,
                                                                        const Read_options& options) {
    std::string name;
    Raw_points raw = read_raw(file, options, name);
    if (raw.has_z && !options.ignore_z) return points_of<3>(std::move(name), std::move(raw), options);
    return points_of<2>(std::move(name), std::move(raw), options);
}

template <int d>
Distinct_points<d> distinct_points(const Point_file<d>& file, std::size_t at_least, const Box<d>* box) {
    Distinct_points<d> points{file.points, std::vector<std::uint64_t>(file.points.size())};
    std::iota(points.index.begin(), points.index.end(), std::uint64_t{0});
    for (std::size_t i = 0; i < points.x.size(); ++i) {
        for (double& c : points.x[i]) c += 0.0;  // no -0
        if (!in_domain(points.x[i]))
            throw file.fault(i, Error_code::out_of_domain, "coordinate out of domain", "magnitudes of at most 2^500");
    }
    const std::vector<std::size_t> first = [&] {
        if (box == nullptr) return first_at_place<d>(points.x);
        try {
            return first_at_place<d>(points.x, *box);
        } catch (const Error& error) {
            if (error.vertices().empty()) throw;
            throw file.fault(static_cast<std::size_t>(error.vertices().back()), error.code(), error.what(),
                             "a point nearer to the box");
        }
    }();
    keep_first(first, points.x);
    keep_first(first, points.index);
    if (points.x.size() < at_least)
        throw file.fault(file.points.size() - 1, Error_code::too_few,
                         counted(points.x.size(), "distinct point") + " in the file",
                         "at least " + std::to_string(at_least));
    return points;
}

template Point_file<2> read_points<2>(const std::filesystem::path&, const Read_options&);
template Point_file<3> read_points<3>(const std::filesystem::path&, const Read_options&);
template Distinct_points<2> distinct_points<2>(const Point_file<2>&, std::size_t, const Box<2>*);
template Distinct_points<3> distinct_points<3>(const Point_file<3>&, std::size_t, const Box<3>*);

}  // namespace annulus::inline v1
