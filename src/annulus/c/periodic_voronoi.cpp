// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of annulus.h for Voronoi diagrams in periodic boxes.
#include <annulus/annulus.h>
#include <annulus/c/periodic_handle.h>
#include <annulus/c/structs.h>

#include <cstdint>

using namespace annulus;
using namespace annulus::c;

int annulus_periodic_voronoi_cells(const annulus_periodic* mesh, size_t capacity, double* volumes, double* surfaces,
                                   double* centroids) {
    return on(mesh, [&](const auto& boxed) {
        require_room(capacity, boxed.mesh().index_bound(), "vertices");
        if (volumes == nullptr && surfaces == nullptr) require(centroids, capacity, "every array");
        const auto& v = boxed.voronoi();
        copy_flat(v.volume, volumes);
        copy_flat(v.surface, surfaces);
        copy_flat(v.cell_centroid, centroids);
    });
}

int annulus_periodic_voronoi_gradient(const annulus_periodic* mesh, size_t capacity, const double* weights,
                                      double* gradient) {
    return on(mesh, [&](const auto& boxed) {
        require_room(capacity, boxed.mesh().index_bound(), "vertices");
        require(weights, capacity, "weights");
        require(gradient, capacity, "gradient");
        copy_flat(boxed.mesh().voronoi_gradient({weights, boxed.mesh().index_bound()}), gradient);
    });
}

int annulus_periodic_voronoi_facets(const annulus_periodic* mesh, size_t capacity, int32_t* first, int32_t* second,
                                    int32_t* shifts, double* measures, double* centroids, size_t* count) {
    return on(mesh, [&](const auto& boxed) {
        require(count, "count");
        const auto& v = boxed.voronoi();
        count_list(capacity, {first, second, shifts, measures, centroids}, v.pair.size(), "facets", count);
        for (const auto& [i, j] : v.pair) {
            if (first != nullptr) *first++ = i;
            if (second != nullptr) *second++ = j;
        }
        copy_flat(v.shift, shifts);
        copy_flat(v.measure, measures);
        copy_flat(v.centroid, centroids);
    });
}

int annulus_periodic_voronoi_corners(const annulus_periodic* mesh, size_t begins, int32_t* begin, size_t capacity,
                                     int32_t* vertices, int32_t* shifts, size_t* count) {
    return on(mesh, [&](const auto& boxed) {
        require(count, "count");
        const auto& v = boxed.voronoi();
        count_list(capacity, {vertices, shifts}, v.ring.size(), "corners", count);
        if (begin != nullptr || begins > 0) require_room(begins, v.ring_begin.size(), "begins");
        require(begin, begins, "begin");
        copy_flat(v.ring_begin, begin);
        copy_flat(v.ring, vertices);
        copy_flat(v.ring_shift, shifts);
    });
}

int annulus_periodic_voronoi_vertices(const annulus_periodic* mesh, size_t capacity, double* coordinates,
                                      size_t* count) {
    return on(mesh, [&](const auto& boxed) {
        require(count, "count");
        const auto& v = boxed.voronoi();
        count_list(capacity, {coordinates}, v.vertex.size(), "vertices", count);
        copy_flat(v.vertex, coordinates);
    });
}
