// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of annulus.h for periodic boxes.
#include <annulus/annulus.h>
#include <annulus/arithmetic/environment.h>
#include <annulus/c/periodic_handle.h>
#include <annulus/c/structs.h>
#include <annulus/periodic_mesh.h>

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

using namespace annulus;
using namespace annulus::c;

namespace {

template <int d>
std::span<const Coordinates<d>> as_points(const double* x, std::size_t points) {
    static_assert(sizeof(Coordinates<d>) == d * sizeof(double) && alignof(Coordinates<d>) == alignof(double));
    return {reinterpret_cast<const Coordinates<d>*>(x), points};
}
template <int d>
Box<d> as_box(const double* box) {
    typename Box<d>::Vectors vectors;
    for (std::size_t j = 0; j < d; ++j) std::copy_n(box + d * j, d, vectors[j].begin());
    return Box<d>(vectors);
}

template <class To, class Read>
int answer(const annulus_periodic* mesh, To* to, const char* name, Read read) {
    return on(mesh, [&](const auto& boxed) {
        require(to, name);
        *to = static_cast<To>(read(boxed.mesh()));
    });
}

void require_changes(const Periodic_options& options) {
    if (!options.report_changes) throw Refused(ANNULUS_USAGE, "the mesh was made without report_changes");
}

int listed_pairs(const annulus_periodic* mesh, std::size_t capacity, std::int32_t* first, std::int32_t* second,
                 std::int32_t* shifts, std::size_t* count, bool made) {
    return on(mesh, [&](const auto& boxed) {
        require(count, "count");
        require_changes(boxed.mesh().options());
        const auto& changes = boxed.mesh().changes();
        const auto& pairs = made ? changes.made : changes.broken;
        count_list(capacity, {first, second, shifts}, pairs.first.size(), "pairs", count);
        copy_flat(pairs.first, first);
        copy_flat(pairs.second, second);
        copy_flat(pairs.shift, shifts);
    });
}

int listed_cells(const annulus_periodic* mesh, std::size_t capacity, std::int32_t* vertices, std::int32_t* offsets,
                 std::size_t* count, bool created) {
    return on(mesh, [&](const auto& boxed) {
        require(count, "count");
        require_changes(boxed.mesh().options());
        const auto& changes = boxed.mesh().changes();
        const auto& cells = created ? changes.changed : changes.gone;
        count_list(capacity, {vertices, offsets}, cells.vertices.size(), "cells", count);
        copy_flat(cells.vertices, vertices);
        copy_flat(cells.offsets, offsets);
    });
}

}  // namespace

int annulus_periodic_create(annulus_periodic** mesh, int dimension, size_t points, const double* coordinates,
                            const double* box, const annulus_options* options) {
    return guarded(error_of_thread(), [&] {
        require(mesh, "mesh");
        *mesh = nullptr;
        if (dimension != 2 && dimension != 3)
            throw Refused(ANNULUS_USAGE, "the dimension is " + std::to_string(dimension) + ": it can be 2 or 3");
        require_count(points, "points");
        require(coordinates, points, "coordinates");
        require(box, "box");
        const Periodic_options chosen = periodic_options_of(options);
        require_sound_environment();
        auto made = std::make_unique<annulus_periodic>();
        if (dimension == 2) made->mesh.emplace<1>(as_points<2>(coordinates, points), as_box<2>(box), chosen);
        else made->mesh.emplace<2>(as_points<3>(coordinates, points), as_box<3>(box), chosen);
        *mesh = made.release();
    });
}

void annulus_periodic_destroy(annulus_periodic** mesh) {
    if (mesh == nullptr) return;
    delete *mesh;
    *mesh = nullptr;
}

size_t annulus_periodic_message(const annulus_periodic* mesh, char* buffer, size_t capacity) {
    return (mesh == nullptr ? error_of_thread() : mesh->error).copy(buffer, capacity);
}

size_t annulus_periodic_error_vertices(const annulus_periodic* mesh, size_t capacity, int32_t* vertices) {
    return (mesh == nullptr ? error_of_thread() : mesh->error).copy_vertices(capacity, vertices);
}

int annulus_periodic_move_all(annulus_periodic* mesh, size_t points, const double* coordinates, const double* box,
                              annulus_report* report) {
    return on(mesh, [&](auto& boxed) {
        constexpr int d = std::decay_t<decltype(boxed)>::dimension;
        require_count(points, "points");
        require(coordinates, points, "coordinates");
        require_report(report);
        require_sound_environment();
        const auto x = as_points<d>(coordinates, points);
        const Move_result done =
            box == nullptr ? boxed.changing().move_all(x) : boxed.changing().move_all(x, as_box<d>(box));
        write_report(report, done, boxed.mesh().changes().changed.vertices.size());
    });
}

int annulus_periodic_move(annulus_periodic* mesh, size_t count, const int32_t* indices, const double* coordinates,
                          annulus_report* report) {
    return on(mesh, [&](auto& boxed) {
        constexpr int d = std::decay_t<decltype(boxed)>::dimension;
        require_count(count, "vertices");
        require(indices, count, "indices");
        require(coordinates, count, "coordinates");
        require_report(report);
        require_sound_environment();
        const Move_result done = boxed.changing().move({indices, count}, as_points<d>(coordinates, count));
        write_report(report, done, boxed.mesh().changes().changed.vertices.size());
    });
}

int annulus_periodic_recompute_tolerances(annulus_periodic* mesh, annulus_report* report) {
    return on(mesh, [&](auto& boxed) {
        require_report(report);
        write_report(report, boxed.changing().recompute_tolerances(), 0);
    });
}

int annulus_periodic_insert(annulus_periodic* mesh, size_t count, const double* coordinates, int32_t* indices) {
    return on(mesh, [&](auto& boxed) {
        constexpr int d = std::decay_t<decltype(boxed)>::dimension;
        require_count(count, "points");
        require(coordinates, count, "coordinates");
        require(indices, count, "indices");
        const std::vector<Index> made = boxed.changing().insert(as_points<d>(coordinates, count));
        std::copy(made.begin(), made.end(), indices);
    });
}

int annulus_periodic_remove(annulus_periodic* mesh, size_t count, const int32_t* indices) {
    return on(mesh, [&](auto& boxed) {
        require_count(count, "vertices");
        require(indices, count, "indices");
        boxed.changing().remove(std::span<const Index>(indices, count));
    });
}

int annulus_periodic_dimension(const annulus_periodic* mesh, int* dimension) {
    return answer(mesh, dimension, "dimension", [](const auto& m) { return m.dimension_of_space; });
}
int annulus_periodic_vertex_count(const annulus_periodic* mesh, size_t* count) {
    return answer(mesh, count, "count", [](const auto& m) { return m.number_of_vertices(); });
}
int annulus_periodic_index_bound(const annulus_periodic* mesh, size_t* bound) {
    return answer(mesh, bound, "bound", [](const auto& m) { return m.index_bound(); });
}
int annulus_periodic_is_vertex(const annulus_periodic* mesh, int32_t index, int* answered) {
    return answer(mesh, answered, "answer", [&](const auto& m) { return m.is_vertex(index) ? 1 : 0; });
}
int annulus_periodic_box(const annulus_periodic* mesh, double* box) {
    return on(mesh, [&](const auto& boxed) {
        require(box, "box");
        copy_flat(boxed.mesh().box().vectors(), box);
    });
}

int annulus_periodic_points(const annulus_periodic* mesh, size_t capacity, double* coordinates) {
    return on(mesh, [&](const auto& boxed) {
        require_room(capacity, boxed.mesh().index_bound(), "vertices");
        require(coordinates, capacity, "coordinates");
        copy_flat(boxed.mesh().points(), coordinates);
    });
}
int annulus_periodic_tolerances(const annulus_periodic* mesh, size_t capacity, double* tolerances) {
    return on(mesh, [&](const auto& boxed) {
        require_room(capacity, boxed.mesh().index_bound(), "vertices");
        require(tolerances, capacity, "tolerances");
        copy_flat(boxed.mesh().tolerances(), tolerances);
    });
}
int annulus_periodic_vertex_of_input(const annulus_periodic* mesh, size_t capacity, int32_t* indices, size_t* count) {
    return on(mesh, [&](const auto& boxed) {
        require(count, "count");
        const auto all = boxed.mesh().vertex_of_input();
        count_list(capacity, {indices}, all.size(), "points", count);
        copy_flat(all, indices);
    });
}
int annulus_periodic_voronoi(const annulus_periodic* mesh, size_t capacity, double* volumes) {
    return on(mesh, [&](const auto& boxed) {
        require_room(capacity, boxed.mesh().index_bound(), "vertices");
        require(volumes, capacity, "volumes");
        copy_flat(boxed.mesh().voronoi_volumes(), volumes);
    });
}

int annulus_periodic_cells(const annulus_periodic* mesh, size_t capacity, int32_t* vertices, int32_t* offsets,
                           int32_t* neighbours, int32_t* translations, size_t* count) {
    return on(mesh, [&](const auto& boxed) {
        require(count, "count");
        count_list(capacity, {vertices, offsets, neighbours, translations}, boxed.mesh().number_of_cells(), "cells",
                   count);
        if (capacity == 0) return;
        const auto& cells = boxed.cells();
        copy_flat(cells.vertices, vertices);
        copy_flat(cells.offsets, offsets);
        copy_flat(cells.neighbours, neighbours);
        copy_flat(cells.translations, translations);
    });
}

int annulus_periodic_neighbours(const annulus_periodic* mesh, size_t capacity, int32_t* first, int32_t* second,
                                int32_t* shifts, double* vectors, double* distances, double* areas, size_t* count) {
    return on(mesh, [&](const auto& boxed) {
        require(count, "count");
        const auto& list = boxed.neighbours();
        count_list(capacity, {first, second, shifts, vectors, distances, areas}, list.first.size(), "pairs", count);
        copy_flat(list.first, first);
        copy_flat(list.second, second);
        copy_flat(list.shift, shifts);
        copy_flat(list.vector, vectors);
        copy_flat(list.distance, distances);
        copy_flat(list.area, areas);
    });
}

int annulus_periodic_find_cells(const annulus_periodic* mesh, size_t points, const double* coordinates, int32_t* cells,
                                int32_t* shifts) {
    return on(mesh, [&](const auto& boxed) {
        constexpr int d = std::decay_t<decltype(boxed)>::dimension;
        require_count(points, "points");
        require(coordinates, points, "coordinates");
        require(cells, points, "cells");
        for (const auto& found : boxed.mesh().find_cells(as_points<d>(coordinates, points))) {
            *cells++ = found.cell;
            if (shifts != nullptr) flatten(found.shift, shifts);
        }
    });
}

int annulus_periodic_pairs_made(const annulus_periodic* mesh, size_t capacity, int32_t* first, int32_t* second,
                                int32_t* shifts, size_t* count) {
    return listed_pairs(mesh, capacity, first, second, shifts, count, true);
}
int annulus_periodic_pairs_broken(const annulus_periodic* mesh, size_t capacity, int32_t* first, int32_t* second,
                                  int32_t* shifts, size_t* count) {
    return listed_pairs(mesh, capacity, first, second, shifts, count, false);
}

int annulus_periodic_changed(const annulus_periodic* mesh, size_t capacity, int32_t* vertices, int32_t* offsets,
                             size_t* count) {
    return listed_cells(mesh, capacity, vertices, offsets, count, true);
}
int annulus_periodic_gone(const annulus_periodic* mesh, size_t capacity, int32_t* vertices, int32_t* offsets,
                          size_t* count) {
    return listed_cells(mesh, capacity, vertices, offsets, count, false);
}

int annulus_periodic_audit(const annulus_periodic* mesh, annulus_audit_result* result) {
    return on(mesh, [&](const auto& boxed) {
        require(result, "result");
        require_struct(result->size, sizeof(result->size), "annulus_audit_result");
        write_audit(result, boxed.mesh().audit());
    });
}
