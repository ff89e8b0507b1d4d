// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of annulus.h that read a mesh.
#include <annulus/annulus.h>
#include <annulus/arithmetic/environment.h>
#include <annulus/c/structs.h>
#include <annulus/version.h>

#include <algorithm>

using namespace annulus;
using namespace annulus::c;

namespace {

/// Writes a single value to *to.
template <class To, class Read>
int answer(const annulus_mesh* mesh, To* to, const char* name, Read read) {
    return guarded(mesh, [&](const annulus_mesh& m) {
        require(to, name);
        *to = static_cast<To>(read(*m.mesh));
    });
}

void require_capacity(std::size_t capacity, std::size_t needed, const char* of) {
    if (capacity < needed)
        throw Refused(ANNULUS_WRONG_SIZE,
                      "there is room for " + std::to_string(capacity) + " of " + std::to_string(needed) + ' ' + of);
}

/// Writes an array by vertex index.
template <class Read>
int by_vertex(const annulus_mesh* mesh, std::size_t capacity, const void* array, const char* name, Read read) {
    return guarded(mesh, [&](const annulus_mesh& m) {
        require_capacity(capacity, m.mesh->index_bound(), "vertices");
        require(array, capacity, name);
        require_sound_environment();
        read(*m.mesh);
    });
}

void copy(const Index* from, std::size_t numbers, std::int32_t* to) {
    if (to != nullptr) std::copy_n(from, numbers, to);
}

void require_lists(const annulus_mesh& m) {
    if (!m.mesh->options().report_changes) throw Refused(ANNULUS_USAGE, "the mesh was made without report_changes");
}

/// Writes the cells that the last call made or removed.
template <class List>
int listed_cells(const annulus_mesh* mesh, std::size_t capacity, std::int32_t* vertices, std::size_t* count,
                 List list) {
    return guarded(mesh, [&](const annulus_mesh& m) {
        require(count, "count");
        require_lists(m);
        const std::vector<Index>& all = (m.changes.*list)();
        *count = all.size() / static_cast<std::size_t>(m.mesh->dimension() + 1);
        if (vertices != nullptr || capacity > 0) require_capacity(capacity, *count, "cells");
        require(vertices, capacity, "vertices");
        copy(all.data(), all.size(), vertices);
    });
}

/// Writes the edges that the last call made or broke.
int listed_edges(const annulus_mesh* mesh, std::size_t capacity, std::int32_t* vertices, std::size_t* count,
                 Vertex_pairs Edge_changes::*list) {
    return guarded(mesh, [&](const annulus_mesh& m) {
        require(count, "count");
        require_lists(m);
        const Vertex_pairs& all = m.changes.edges(m.mesh->dimension()).*list;
        *count = all.size();
        if (vertices != nullptr || capacity > 0) require_capacity(capacity, *count, "edges");
        require(vertices, capacity, "vertices");
        if (vertices == nullptr) return;
        for (std::size_t k = 0; k < all.size(); ++k) {
            vertices[2 * k] = all[k].first;
            vertices[2 * k + 1] = all[k].second;
        }
    });
}

}  // namespace

size_t annulus_message(const annulus_mesh* mesh, char* buffer, size_t capacity) {
    return (mesh == nullptr ? error_of_thread() : mesh->error).copy(buffer, capacity);
}

size_t annulus_message_vertices(const annulus_mesh* mesh, int32_t vertices[2]) {
    return std::min<size_t>(2, annulus_error_vertices(mesh, 2, vertices));
}

size_t annulus_error_vertices(const annulus_mesh* mesh, size_t capacity, int32_t* vertices) {
    return (mesh == nullptr ? error_of_thread() : mesh->error).copy_vertices(capacity, vertices);
}

const char* annulus_status_name(int status) {
    switch (status) {
        case ANNULUS_OK: return "ok";
        case ANNULUS_NULL_POINTER: return "null pointer";
        case ANNULUS_USAGE: return "usage";
        case ANNULUS_WRONG_SIZE: return "wrong size";
        case ANNULUS_NOT_FINITE: return "not finite";
        case ANNULUS_OUT_OF_DOMAIN: return "out of domain";
        case ANNULUS_DUPLICATE_POINT: return "duplicate point";
        case ANNULUS_UNKNOWN_VERTEX: return "unknown vertex";
        case ANNULUS_ENVIRONMENT: return "environment";
        case ANNULUS_TOO_LARGE: return "too large";
        case ANNULUS_NO_MEMORY: return "no memory";
        case ANNULUS_NO_TRIANGULATION: return "no triangulation";
        case ANNULUS_INTERNAL: return "internal";
        default: return "unknown status";
    }
}

const char* annulus_version(void) { return ANNULUS_VERSION_STRING; }
int annulus_interface(void) { return ANNULUS_INTERFACE; }

int annulus_dimension(const annulus_mesh* mesh, int* dimension) {
    return answer(mesh, dimension, "dimension", [](const Any_mesh& m) { return m.dimension(); });
}
int annulus_affine_dimension(const annulus_mesh* mesh, int* dimension) {
    return answer(mesh, dimension, "dimension", [](const Any_mesh& m) { return m.affine_dimension(); });
}
int annulus_vertex_count(const annulus_mesh* mesh, size_t* count) {
    return answer(mesh, count, "count", [](const Any_mesh& m) { return m.vertices(); });
}
int annulus_index_bound(const annulus_mesh* mesh, size_t* bound) {
    return answer(mesh, bound, "bound", [](const Any_mesh& m) { return m.index_bound(); });
}
int annulus_is_vertex(const annulus_mesh* mesh, int32_t index, int* given) {
    return answer(mesh, given, "answer", [&](const Any_mesh& m) { return m.is_vertex(index); });
}
int annulus_strategy(const annulus_mesh* mesh, const char** name) {
    return answer(mesh, name, "name", [](const Any_mesh& m) {
        return name_of(m.strategy()).data();
    });  // a string literal, so it ends with a 0
}

int annulus_points(const annulus_mesh* mesh, size_t capacity, double* coordinates) {
    return by_vertex(mesh, capacity, coordinates, "coordinates", [&](const Any_mesh& m) { m.points(coordinates); });
}
int annulus_tolerances(const annulus_mesh* mesh, size_t capacity, double* lengths) {
    return by_vertex(mesh, capacity, lengths, "lengths", [&](const Any_mesh& m) { m.tolerances(lengths); });
}
int annulus_displacements(const annulus_mesh* mesh, size_t capacity, double* lengths) {
    return by_vertex(mesh, capacity, lengths, "lengths", [&](const Any_mesh& m) { m.displacements(lengths); });
}
int annulus_voronoi(const annulus_mesh* mesh, size_t capacity, double* volumes, int32_t* neighbour_counts) {
    const void* either = volumes != nullptr ? static_cast<const void*>(volumes) : neighbour_counts;
    return by_vertex(mesh, capacity, either, "volumes, like neighbour_counts,",
                     [&](const Any_mesh& m) { m.voronoi(volumes, neighbour_counts); });
}

int annulus_voronoi_cells(const annulus_mesh* mesh, const double* lower, const double* upper, size_t capacity,
                          double* volumes, double* centroids) {
    const void* either = volumes != nullptr ? volumes : centroids;
    return by_vertex(mesh, capacity, either, "volumes, like centroids,", [&](const Any_mesh& m) {
        if ((lower == nullptr) != (upper == nullptr))
            throw Refused(ANNULUS_NULL_POINTER, "one of lower and upper is NULL, and the other is not");
        if (lower == nullptr) return m.voronoi_cells(nullptr, volumes, centroids);
        const auto d = static_cast<std::size_t>(m.dimension());
        double box[6];
        std::copy_n(lower, d, box);
        std::copy_n(upper, d, box + d);
        for (std::size_t k = 0; k < d; ++k)
            if (box[k] >= box[d + k]) throw Refused(ANNULUS_USAGE, "the box has no interior: lower is not below upper");
        m.voronoi_cells(box, volumes, centroids);
    });
}
int annulus_voronoi_gradient(const annulus_mesh* mesh, size_t capacity, const double* weights, double* gradient) {
    return by_vertex(mesh, capacity, gradient, "gradient", [&](const Any_mesh& m) {
        require(weights, capacity, "weights");
        m.voronoi_gradient(weights, gradient);
    });
}

int annulus_vertex_of_input(const annulus_mesh* mesh, size_t capacity, int32_t* indices, size_t* count) {
    return guarded(mesh, [&](const annulus_mesh& m) {
        require(count, "count");
        const auto all = m.mesh->vertex_of_input();
        *count = all.size();
        if (indices != nullptr || capacity > 0) require_capacity(capacity, all.size(), "points");
        require(indices, capacity, "indices");
        copy(all.data(), all.size(), indices);
    });
}

int annulus_cells(const annulus_mesh* mesh, size_t capacity, int32_t* vertices, int32_t* neighbours, size_t* count) {
    return guarded(mesh, [&](const annulus_mesh& m) {
        require(count, "count");
        const Cells cells = m.mesh->cells();
        *count = cells.count;
        if (vertices != nullptr || neighbours != nullptr || capacity > 0)
            require_capacity(capacity, cells.count, "cells");
        if (vertices == nullptr) require(neighbours, capacity, "vertices, like neighbours,");
        const std::size_t numbers = cells.count * static_cast<std::size_t>(m.mesh->dimension() + 1);
        copy(cells.vertices, numbers, vertices);
        copy(cells.neighbours, numbers, neighbours);
    });
}

int annulus_neighbours(const annulus_mesh* mesh, int32_t vertex, size_t capacity, int32_t* vertices, size_t* count) {
    return guarded(mesh, [&](const annulus_mesh& m) {
        require(count, "count");
        const auto all = m.mesh->neighbours(vertex);
        *count = all.size();
        if (vertices != nullptr || capacity > 0) require_capacity(capacity, all.size(), "neighbours");
        require(vertices, capacity, "vertices");
        copy(all.data(), all.size(), vertices);
    });
}

int annulus_neighbour_lists(const annulus_mesh* mesh, size_t begins, int32_t* begin, size_t capacity, int32_t* vertices,
                            size_t* count) {
    return guarded(mesh, [&](const annulus_mesh& m) {
        require(count, "count");
        const auto lists = m.mesh->neighbour_lists();
        *count = lists->index.size();
        if (begin != nullptr || begins > 0) require_capacity(begins, lists->begin.size(), "begins");
        if (vertices != nullptr || capacity > 0) require_capacity(capacity, lists->index.size(), "neighbours");
        require(begin, begins, "begin");
        require(vertices, capacity, "vertices");
        copy(lists->begin.data(), lists->begin.size(), begin);
        copy(lists->index.data(), lists->index.size(), vertices);
    });
}

int annulus_voronoi_facets(const annulus_mesh* mesh, size_t capacity, double* measures, double* centroids,
                           size_t* count) {
    return guarded(mesh, [&](const annulus_mesh& m) {
        require(count, "count");
        *count = m.mesh->neighbour_lists()->index.size();
        if (measures == nullptr && centroids == nullptr && capacity == 0) return;
        require_capacity(capacity, *count, "facets");
        if (measures == nullptr) require(centroids, capacity, "measures, like centroids,");
        require_sound_environment();
        m.mesh->voronoi_facets(measures, centroids);
    });
}

int annulus_convex_hull(const annulus_mesh* mesh, size_t capacity, int32_t* vertices, size_t* count) {
    return guarded(mesh, [&](const annulus_mesh& m) {
        require(count, "count");
        const auto all = m.mesh->hull();
        *count = all.size() / static_cast<std::size_t>(m.mesh->dimension());
        if (vertices != nullptr || capacity > 0) require_capacity(capacity, *count, "facets");
        require(vertices, capacity, "vertices");
        copy(all.data(), all.size(), vertices);
    });
}

int annulus_find_cells(const annulus_mesh* mesh, size_t points, const double* coordinates, int32_t* cells) {
    return guarded(mesh, [&](const annulus_mesh& m) {
        require_count(points, "points");
        require(coordinates, points, "coordinates");
        require(cells, points, "cells");
        m.mesh->find_cells(coordinates, points, cells);
    });
}

int annulus_changed(const annulus_mesh* mesh, size_t capacity, int32_t* vertices, size_t* count) {
    return listed_cells(mesh, capacity, vertices, count, &Changes_of_call::came);
}
int annulus_gone(const annulus_mesh* mesh, size_t capacity, int32_t* vertices, size_t* count) {
    return listed_cells(mesh, capacity, vertices, count, &Changes_of_call::gone);
}
int annulus_edges_made(const annulus_mesh* mesh, size_t capacity, int32_t* vertices, size_t* count) {
    return listed_edges(mesh, capacity, vertices, count, &Edge_changes::made);
}
int annulus_edges_broken(const annulus_mesh* mesh, size_t capacity, int32_t* vertices, size_t* count) {
    return listed_edges(mesh, capacity, vertices, count, &Edge_changes::broken);
}
int annulus_t1(const annulus_mesh* mesh, size_t capacity, int32_t* vertices, size_t* count) {
    return guarded(mesh, [&](const annulus_mesh& m) {
        require(count, "count");
        if (m.mesh->dimension() != 2) throw Refused(ANNULUS_USAGE, "T1 transitions are in 2D, and the mesh is in 3D");
        require_lists(m);
        const T1_transitions& all = m.changes.t1();
        *count = all.size();
        if (vertices != nullptr || capacity > 0) require_capacity(capacity, *count, "transitions");
        require(vertices, capacity, "vertices");
        if (vertices == nullptr) return;
        for (std::size_t k = 0; k < all.size(); ++k) std::copy(all[k].begin(), all[k].end(), vertices + 4 * k);
    });
}

int annulus_audit(const annulus_mesh* mesh, annulus_audit_result* result) {
    return guarded(mesh, [&](const annulus_mesh& m) {
        require(result, "result");
        require_struct(result->size, sizeof(result->size), "annulus_audit_result");
        write_audit(result, m.mesh->audit());
    });
}
