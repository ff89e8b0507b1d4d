// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh: construction and changes. Its queries are in mesh_queries.cpp.
#include <module/mesh.h>

#include <module/mesh_locked.h>
#include <module/point_set.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/arithmetic/environment.h>
#include <annulus/engine/naming_duplicates.h>
#include <annulus/engine/require_vertices.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace annulus::python {

namespace {

template <int d>
Moving_mesh<d> mesh_of(std::span<const Coordinates<d>> points, const Options& options) {
    const Without_gil without_gil;
    return Moving_mesh<d>(points, options);
}

/// The same with a vertex at every free index, at an unused position.
template <int d>
Moving_mesh<d> mesh_with(std::span<const Coordinates<d>> points, const std::vector<Index>& free_indices,
                         const Options& options) {
    const Without_gil without_gil;
    std::vector<Coordinates<d>> x(points.begin(), points.end());
    for (const Index i : free_indices) {
        if (at(i) >= x.size())
            throw Error(Error_code::bad_input, "free_indices: there is no index " + std::to_string(i));
        x[at(i)] = {};
    }
    double far = 0x1p-500;
    for (const auto& p : x)
        for (const double c : p) far = std::max(far, std::fabs(c));
    far = std::min(far, 0x1p499);
    const Point_set<d> taken(x);
    double step = 0;
    for (const Index i : free_indices) {
        auto& p = x[at(i)];
        do p[0] = far * (1 + 0x1p-40 * ++step);
        while (taken.has(p));
    }
    return Moving_mesh<d>(std::span<const Coordinates<d>>(x), options);
}

/// Throws an error that names two equal points of those to be inserted, which are not vertices.
template <int d>
[[noreturn]] void throw_equal(std::span<const Coordinates<d>> points) {
    const auto pair = coinciding<d>(points, [](Index) { return true; });
    throw Error(Error_code::duplicate_point, "points " + std::to_string(pair->first) + " and " +
                                                 std::to_string(pair->second) +
                                                 " to be inserted have the same position");
}

}  // namespace

template <int d>
Mesh<d>::Mesh(const Points_in<d>& points, const Options& options)
    : options_(options), mesh_(mesh_of<d>(points.span(), options)) {}

template <int d>
Mesh<d>::Mesh(const Points_in<d>& points, std::vector<Index> free_indices, const Options& options)
    : options_(options), mesh_(mesh_with<d>(points.span(), free_indices, options)) {
    remove(free_indices);
}

template <int d>
Mesh<d>::Mesh(const Without_gil&, std::span<const Point> points, const Options& options)
    : options_(options), mesh_(points, options) {}

/// Makes a call that may change the mesh. If it throws, positions are as they were, but the cells may be different
/// ones that are right, too.
template <int d>
template <class Call>
Move_result Mesh<d>::changing(Call call) {
    const Without_gil without_gil;
    return changing(without_gil, std::move(call));
}

template <int d>
template <class Call>
Move_result Mesh<d>::changing(const Without_gil& without_gil, Call call) {
    return locked(without_gil, [&] {
        require_sound_environment();  // another module may have changed it
        Move_result report;
        try {
            call(report);
        } catch (...) {
            points_.reset();
            throw;
        }
        points_.reset();
        return report;
    });
}

template <int d>
Move_result Mesh<d>::move(const Points_in<d>& points) {
    return changing([&](Move_result& report) { report = mesh_.move_all(points.span()); });
}

template <int d>
Move_result Mesh<d>::move(const Without_gil& without_gil, std::span<const Point> points) {
    return changing(without_gil, [&](Move_result& report) { report = mesh_.move_all(points); });
}

template <int d>
Move_result Mesh<d>::move(const std::vector<Index>& indices, const Points_in<d>& points) {
    return changing([&](Move_result& report) { report = mesh_.move(indices, points.span()); });
}

template <int d>
Move_result Mesh<d>::recompute_tolerances() {
    return changing([&](Move_result& report) { report = mesh_.recompute_tolerances(); });
}

/// Throws unless the points are in the domain, are distinct, and none of them has the position of a vertex. O(n).
template <int d>
void Mesh<d>::require_free(std::span<const Point> points) const {
    require_in_domain(points, "point");
    if (points.size() < 2) return;  // the mesh checks a single point itself, at lower cost
    const Point_set<d> fresh(points);
    if (fresh.size() < points.size()) throw_equal<d>(points);
    const auto x = mesh_.points();
    std::vector<std::int64_t> there;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (mesh_.is_vertex(static_cast<Index>(i)) && fresh.has(x[i])) there.push_back(static_cast<std::int64_t>(i));
    if (there.empty()) return;
    const auto first = static_cast<std::size_t>(there.front());
    throw Error(Error_code::duplicate_point,
                "vertex " + std::to_string(first) + " has the position of point " +
                    std::to_string(std::find(points.begin(), points.end(), x[first]) - points.begin()) +
                    " to be inserted",
                std::move(there));
}

template <int d>
std::vector<Index> Mesh<d>::insert(const Points_in<d>& points) {
    std::vector<Index> indices;
    (void)changing([&](Move_result&) {
        require_free(points.span());
        indices.reserve(points.span().size());
        free_indices_.reserve(free_indices_.size() + points.span().size());
        try {
            for (const Point& p : points.span()) {
                indices.push_back(mesh_.insert(p));
                if (!free_indices_.empty()) free_indices_.pop_back();
            }
        } catch (...) {
            for (; !indices.empty(); indices.pop_back()) remove_one(indices.back());
            throw;
        }
    });
    return indices;
}

template <int d>
void Mesh<d>::remove_one(Index i) {
    try {
        mesh_.remove(i);
    } catch (...) {
        if (!mesh_.is_vertex(i)) free_indices_.push_back(i);
        throw;
    }
    free_indices_.push_back(i);
}

template <int d>
void Mesh<d>::remove(const std::vector<Index>& indices) {
    (void)changing([&](Move_result&) {
        require_vertices(
            std::span<const Index>(indices), [this](Index i) { return mesh_.is_vertex(i); }, Repeats::refused);
        free_indices_.reserve(free_indices_.size() + indices.size());
        for (const Index i : indices) remove_one(i);
    });
}

template class Mesh<2>;
template class Mesh<3>;

}  // namespace annulus::python
