// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/arrays.h>
#include <module/box_vectors.h>
#include <module/errors.h>
#include <module/finalizing.h>
#include <module/json.h>
#include <module/parts.h>
#include <module/point_set.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/arithmetic/environment.h>
#include <annulus/degeneracy.h>
#include <annulus/engine/naming_duplicates.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/periodic_mesh.h>
#include <apps/report/degeneracy_report.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace annulus::python {

namespace {

using Clock = std::chrono::steady_clock;
double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// The points without duplicate points: the first point at each position.
template <int d>
struct Distinct {
    std::vector<Coordinates<d>> x;
    std::vector<Index> place;  // of each, in the array
};
template <int d>
Distinct<d> distinct(std::span<const Coordinates<d>> points, bool merge_duplicates) {
    Distinct<d> out;
    Point_set<d> seen{std::span<const Coordinates<d>>{}};
    const auto first_at = [&](std::size_t i) {
        return std::find(points.begin(), points.end(), points[i]) - points.begin();
    };
    require_in_domain(points, "point");
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (seen.add(points[i])) {
            out.x.push_back(points[i]);
            out.place.push_back(static_cast<Index>(i));
        } else if (!merge_duplicates) {
            throw Error(Error_code::duplicate_point,
                        "points " + std::to_string(first_at(i)) + " and " + std::to_string(i) +
                            " have the same position (merge_duplicates=True counts such once)",
                        sharing<d>(points, static_cast<Index>(i), [](Index) { return true; }));
        }
    }
    return out;
}

/// Thresholds by name; those of the tool where none are given.
using Thresholds = std::optional<std::vector<std::pair<std::string, double>>>;

/// Every certificate of one kind, in the order of the scan.
struct Values {
    py::ssize_t width = 0;  // points of each
    bool with_places = false;
    std::vector<Index> points{};
    std::vector<double> places{};
    std::vector<double> width_lower{}, width_upper{}, tolerance{}, theta{};
    std::vector<std::int8_t> stage{};

    template <int d>
    void add(const Raw_certificate<d>& c, std::span<const Index> place) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(width); ++i) {
            points.push_back(place.empty() ? c.point[i] : place[at(c.point[i])]);
            if (with_places) places.insert(places.end(), c.place[i].begin(), c.place[i].end());
        }
        width_lower.push_back(c.width_lower);
        width_upper.push_back(c.width_upper);
        tolerance.push_back(c.tolerance);
        if (width == d + 2) theta.push_back(c.theta);
        stage.push_back(static_cast<std::int8_t>(c.stage));
    }
    [[nodiscard]] py::dict arrays(int d) && {
        const auto n = static_cast<py::ssize_t>(stage.size());
        py::dict all;
        all["points"] = give(std::move(points), {n, width});
        if (with_places) all["places"] = give(std::move(places), {n, width, d});
        all["width_lower"] = give(std::move(width_lower));
        all["width_upper"] = give(std::move(width_upper));
        all["tolerance"] = give(std::move(tolerance));
        if (width == d + 2) all["theta"] = give(std::move(theta));
        all["stage"] = give(std::move(stage));
        return all;
    }
};
using Values_by_kind = std::array<Values, 3>;  // in the order of Raw_certificate::Kind

/// `place` of a point in the array; empty where numbers are the same.
template <int d>
Degeneracy_options<d> degeneracy_options(const Thresholds& thresholds, Values_by_kind* values,
                                         std::span<const Index> place) {
    Degeneracy_options<d> options;
    if (thresholds) options.thresholds = *thresholds;
    // With one thread, the callback runs in this thread.
    options.raw = [calls = 0U, values, place](const Raw_certificate<d>& c) mutable {
        if (values != nullptr) (*values)[static_cast<std::size_t>(c.kind)].add(c, place);
        if (++calls % 16384 == 0) look_for_signals();
    };
    return options;
}

template <int d>
Degeneracy_record record_of(std::size_t points) {
    require_sound_environment();
    Degeneracy_record r;
    r.command = "annulus.degeneracy";
    r.dimension = d;
    r.points = points;
    return r;
}

template <int d>
Degeneracy_record study(std::span<const Coordinates<d>> points, bool merge_duplicates, const Thresholds& thresholds,
                        Values_by_kind* values) {
    auto r = record_of<d>(points.size());
    const auto [x, place] = distinct<d>(points, merge_duplicates);
    if (x.size() < 2) throw Error(Error_code::too_few, "degeneracy needs two points that differ");
    r.vertices = x.size();
    const auto begin = Clock::now();
    Delaunay_mesh<d> mesh;
    mesh.build(x);
    r.seconds_triangulation = since(begin);
    const auto built = Clock::now();
    r.affine_dimension = mesh.dimension();
    std::vector<Index> corners;
    mesh.list_cells(x, corners);
    r.simplices = corners.size() / (d + 1);
    if (r.affine_dimension == d)
        r.measured = degeneracy(mesh.table(), x, degeneracy_options<d>(thresholds, values, place));
    r.seconds_analysis = since(built);
    return r;
}

template <int d>
Degeneracy_record study_in_box(std::span<const Coordinates<d>> points, const typename Box<d>::Vectors& box,
                               bool merge_duplicates, const Thresholds& thresholds, Values_by_kind* values) {
    auto r = record_of<d>(points.size());
    r.affine_dimension = d;
    const auto begin = Clock::now();
    const Periodic_mesh<d> mesh(points, Box<d>(box), {.merge_duplicates = merge_duplicates});
    r.seconds_triangulation = since(begin);
    r.vertices = mesh.number_of_vertices();
    std::vector<Index> place;  // of each vertex; without merged ones they have the numbers of the points
    for (std::size_t k = 0; k < mesh.vertex_of_input().size(); ++k)
        if (static_cast<std::size_t>(mesh.vertex_of_input()[k]) == place.size()) place.push_back(static_cast<Index>(k));
    const auto built = Clock::now();
    r.simplices = mesh.number_of_cells();
    if (points.empty()) throw Error(Error_code::too_few, "degeneracy in a box needs a point");
    r.measured = degeneracy(mesh, degeneracy_options<d>(thresholds, values, place));
    r.seconds_analysis = since(built);
    return r;
}

template <int d>
py::object study_of(Numbers numbers, const py::object& box, bool merge_duplicates, const Thresholds& thresholds,
                    bool with_values) {
    const Points_in<d> points(std::move(numbers), "points");
    const bool boxed = !box.is_none();
    const typename Box<d>::Vectors vectors = boxed ? box_vectors_of<d>(box) : typename Box<d>::Vectors{};
    Values_by_kind values{Values{d + 2, boxed}, Values{d + 1, boxed}, Values{d + 1, boxed}};
    Values_by_kind* const asked = with_values ? &values : nullptr;
    Degeneracy_record record;
    {
        const Without_gil without_gil;
        record = boxed ? study_in_box<d>(points.span(), vectors, merge_duplicates, thresholds, asked)
                       : study<d>(points.span(), merge_duplicates, thresholds, asked);
    }
    py::object result = object_of(degeneracy_json(record));
    if (with_values) {
        py::dict arrays;
        arrays["bicells"] = std::move(values[0]).arrays(d);
        arrays["cells"] = std::move(values[1]).arrays(d);
        if (!boxed) arrays["ridges"] = std::move(values[2]).arrays(d);
        result["values"] = arrays;
    }
    return result;
}

}  // namespace

void add_degeneracy(py::module_& m) {
    m.def("degeneracy", [](const py::object& points, const py::object& box, bool merge_duplicates,
                           const Thresholds& thresholds, bool values) {
        Numbers numbers = numbers_of(points, "points");
        const bool space = numbers.ndim() == 2 && numbers.shape(1) == 3;
        return space ? study_of<3>(std::move(numbers), box, merge_duplicates, thresholds, values)
                     : study_of<2>(std::move(numbers), box, merge_duplicates, thresholds, values);
    });
}

}  // namespace annulus::python
