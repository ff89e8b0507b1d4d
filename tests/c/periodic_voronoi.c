// SPDX-License-Identifier: GPL-3.0-or-later
// Voronoi diagrams of periodic boxes through the C interface: polygons from corners, sums of cells, refusals.
#include "check.h"

#include <math.h>
#include <stdlib.h>

enum { most = 8192 };

static annulus_periodic* mesh_of(int dimension, size_t count, const double* x, const double* box) {
    annulus_periodic* mesh = NULL;
    CHECK_STATUS(annulus_periodic_create(&mesh, dimension, count, x, box, NULL), ANNULUS_OK);
    return mesh;
}

// The length or area of a polygon: half of the sum of the cross products of its corners, relative to the first.
static double measure_of(int d, size_t corners, const double* p) {
    double sum[3] = {0};
    if (d == 2) return corners == 2 ? hypot(p[2] - p[0], p[3] - p[1]) : -1;
    for (size_t k = 1; k + 1 < corners; ++k)
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, l = (i + 2) % 3;
            const double *a = p + 3 * k, *b = p + 3 * (k + 1);
            sum[i] += ((a[j] - p[j]) * (b[l] - p[l]) - (a[l] - p[l]) * (b[j] - p[j])) / 2;
        }
    return sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
}

// Returns the number of facets that are not empty.
static size_t check_diagram(const annulus_periodic* mesh, int d) {
    static int32_t first[most], second[most], shifts[3 * most], begin[most], vertices[8 * most], moved[24 * most];
    static double measures[most], centroids[3 * most], coordinates[3 * most], x[3 * most], volumes[most],
        surfaces[most], middles[3 * most], same[most], sums[most], pieces[most], polygon[300];
    const size_t n = (size_t)d;
    double box[9];
    size_t facets = 0, corners = 0, cells = 0, listed = 0, bound = 0, full = 0;
    CHECK_STATUS(annulus_periodic_index_bound(mesh, &bound), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_box(mesh, box), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_points(mesh, bound, x), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_voronoi_facets(mesh, 0, NULL, NULL, NULL, NULL, NULL, &facets), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_voronoi_corners(mesh, 0, NULL, 0, NULL, NULL, &corners), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_voronoi_vertices(mesh, 0, NULL, &listed), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_cells(mesh, 0, NULL, NULL, NULL, NULL, &cells), ANNULUS_OK);
    CHECK(facets > 0 && facets < most && corners < 8 * most && cells == listed && cells < most);
    CHECK_STATUS(annulus_periodic_voronoi_facets(mesh, facets, first, second, shifts, measures, centroids, &facets),
                 ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_voronoi_corners(mesh, facets + 1, begin, corners, vertices, moved, &corners),
                 ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_voronoi_vertices(mesh, cells, coordinates, &cells), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_voronoi_cells(mesh, bound, volumes, surfaces, middles), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_voronoi(mesh, bound, same), ANNULUS_OK);
    CHECK(begin[0] == 0 && (size_t)begin[facets] == corners);
    for (size_t i = 0; i < bound; ++i) sums[i] = pieces[i] = 0;
    for (size_t k = 0; k < facets; ++k) {
        const size_t size = (size_t)(begin[k + 1] - begin[k]);
        double distance = 0;
        CHECK(first[k] <= second[k] && size >= 2 && size < 100);
        CHECK(isnan(centroids[n * k]) == (measures[k] == 0));
        if (measures[k] > 0) ++full;
        for (size_t c = 0; c < n; ++c) {
            double way = x[n * (size_t)second[k] + c] - x[n * (size_t)first[k] + c];
            for (size_t j = 0; j < n; ++j) way += shifts[n * k + j] * box[n * j + c];
            distance += way * way;
        }
        for (size_t corner = 0; corner < size; ++corner) {
            const size_t at = (size_t)begin[k] + corner;
            for (size_t c = 0; c < n; ++c) {
                double* p = polygon + n * corner + c;
                *p = coordinates[n * (size_t)vertices[at] + c];
                for (size_t j = 0; j < n; ++j) *p += moved[n * at + j] * box[n * j + c];
            }
        }
        CHECK(fabs(measure_of(d, size, polygon) - measures[k]) < 1e-9);
        for (int side = 0; side < 2; ++side) {
            const int32_t i = side == 0 ? first[k] : second[k];
            sums[i] += measures[k] * sqrt(distance) / (2 * d);
            pieces[i] += measures[k];
        }
    }
    for (size_t i = 0; i < bound; ++i) {
        int there = 0;
        CHECK_STATUS(annulus_periodic_is_vertex(mesh, (int32_t)i, &there), ANNULUS_OK);
        CHECK(isnan(volumes[i]) == !there && isnan(surfaces[i]) == !there && isnan(middles[n * i]) == !there);
        if (!there) continue;
        CHECK(fabs(volumes[i] - sums[i]) < 1e-9 && fabs(volumes[i] - same[i]) < 1e-9);
        CHECK(fabs(surfaces[i] - pieces[i]) < 1e-9);
    }

    CHECK_STATUS(annulus_periodic_voronoi_facets(mesh, facets - 1, first, NULL, NULL, NULL, NULL, &facets),
                 ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_periodic_voronoi_facets(mesh, facets, NULL, NULL, NULL, NULL, NULL, &facets),
                 ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_voronoi_facets(mesh, facets, NULL, NULL, NULL, measures, NULL, NULL),
                 ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_voronoi_corners(mesh, facets, begin, 0, NULL, NULL, &corners), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_periodic_voronoi_corners(mesh, facets + 1, NULL, 0, NULL, NULL, &corners),
                 ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_voronoi_corners(mesh, 0, NULL, corners - 1, vertices, NULL, &corners),
                 ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_periodic_voronoi_corners(mesh, 0, NULL, corners, NULL, moved, &corners), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_voronoi_vertices(mesh, cells - 1, coordinates, &cells), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_periodic_voronoi_vertices(mesh, cells, coordinates, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_voronoi_cells(mesh, bound - 1, volumes, NULL, NULL), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_periodic_voronoi_cells(mesh, bound, NULL, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_voronoi_cells(mesh, bound, NULL, NULL, middles), ANNULUS_OK);
    return full;
}

int main(void) {
    static const double cube[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const double copper[12] = {0, 0, 0, 0.5, 0.5, 0, 0.5, 0, 0.5, 0, 0.5, 0.5};
    static const double tilted[2][9] = {{2, 0, 0.5, 1.5}, {2, 0, 0, 0.5, 1.5, 0, -0.25, 0.5, 1.25}};
    annulus_periodic* mesh = mesh_of(3, 4, copper, cube);
    CHECK(check_diagram(mesh, 3) == 24);
    annulus_periodic_destroy(&mesh);
    for (int d = 2; d <= 3; ++d) {
        const int32_t some[3] = {1, 20, 7};
        uint64_t seed = 5;
        int32_t indices[3];
        double x[90];
        for (int k = 0; k < 30 * d; ++k) x[k] = 4 * uniform(&seed) - 2;
        mesh = mesh_of(d, 30, x, tilted[d - 2]);
        check_diagram(mesh, d);
        CHECK_STATUS(annulus_periodic_remove(mesh, 3, some), ANNULUS_OK);
        check_diagram(mesh, d);
        CHECK_STATUS(annulus_periodic_insert(mesh, 1, x + d, indices), ANNULUS_OK);
        check_diagram(mesh, d);
        for (int k = 0; k < 30 * d; ++k) x[k] += 0.1 * uniform(&seed);
        CHECK_STATUS(annulus_periodic_move_all(mesh, 30, x, NULL, NULL), ANNULUS_OK);
        check_diagram(mesh, d);
        annulus_periodic_destroy(&mesh);
        mesh = mesh_of(d, 1, x, tilted[d - 2]);
        CHECK(check_diagram(mesh, d) == (d == 2 ? 3 : 7));
        annulus_periodic_destroy(&mesh);
    }
    return verdict("periodic_voronoi");
}
