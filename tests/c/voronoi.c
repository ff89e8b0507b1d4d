// SPDX-License-Identifier: GPL-3.0-or-later
// Facets and cells of Voronoi diagrams, gradients of volumes; and what these functions refuse.
#include "check.h"

#include <math.h>
#include <stdlib.h>

enum { n = 90 };

static void check_diagram(int dimension) {
    const size_t d = (size_t)dimension;
    const int32_t removed = 5;
    const double lower[3] = {0, 0, 0};
    const double upper[3] = {1, 1, 1};
    uint64_t state = 31;
    double x[3 * n];
    double volumes[n];
    double others[n];
    double centroids[3 * n];
    double weights[n];
    double gradient[3 * n];
    double sum = 0;
    int32_t begin[n + 1];
    int32_t* all = NULL;
    double* measures = NULL;
    double* middles = NULL;
    size_t total = 0;
    size_t count = 0;
    int finite = 0;
    annulus_mesh* mesh = NULL;
    for (int i = 0; i < 3 * n; ++i) x[i] = uniform(&state);
    CHECK_STATUS(annulus_create(&mesh, dimension, n, x, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_remove(mesh, 1, &removed, NULL, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_neighbour_lists(mesh, 0, NULL, 0, NULL, &total), ANNULUS_OK);
    CHECK_STATUS(annulus_voronoi_facets(mesh, 0, NULL, NULL, &count), ANNULUS_OK);
    CHECK(count == total);
    all = malloc(total * sizeof *all);
    measures = malloc(total * sizeof *measures);
    middles = malloc(d * total * sizeof *middles);
    CHECK_STATUS(annulus_neighbour_lists(mesh, n + 1, begin, total, all, &total), ANNULUS_OK);
    CHECK_STATUS(annulus_voronoi_facets(mesh, total, measures, middles, &count), ANNULUS_OK);
    CHECK_STATUS(annulus_voronoi(mesh, n, others, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_voronoi_cells(mesh, NULL, NULL, n, volumes, centroids), ANNULUS_OK);

    // Each cell is pyramids over its facets, and their derivatives add up to the gradient of its volume.
    for (int32_t v = 0; v < n; ++v) {
        double volume = 0;
        double rates[3 * n] = {0};
        for (int32_t k = begin[v]; k < begin[v + 1]; ++k) {
            double square = 0;
            for (size_t a = 0; a < d; ++a) {
                const double e = x[(size_t)all[k] * d + a] - x[(size_t)v * d + a];
                square += e * e;
            }
            volume += measures[k] * sqrt(square) / (2 * (double)d);
            for (size_t a = 0; a < d; ++a) {
                const double to = measures[k] / sqrt(square);
                rates[(size_t)all[k] * d + a] += to * (x[(size_t)all[k] * d + a] - middles[(size_t)k * d + a]);
                rates[(size_t)v * d + a] += to * (middles[(size_t)k * d + a] - x[(size_t)v * d + a]);
            }
        }
        if (v == removed) CHECK(isnan(volumes[v]) && isnan(centroids[(size_t)v * d]));
        else if (isinf(others[v])) CHECK(isinf(volumes[v]) && isnan(centroids[(size_t)v * d]));
        else {
            CHECK(fabs(volume - others[v]) < 1e-9 * volume && fabs(volumes[v] - others[v]) < 1e-9 * volume);
            for (int w = 0; w < n; ++w) weights[w] = w == v;
            CHECK_STATUS(annulus_voronoi_gradient(mesh, n, weights, gradient), ANNULUS_OK);
            for (size_t a = 0; a < d * n; ++a) CHECK(fabs(gradient[a] - rates[a]) < 1e-9);
            ++finite;
        }
    }
    CHECK(finite > 5);
    CHECK_STATUS(annulus_voronoi_cells(mesh, lower, upper, n, volumes, NULL), ANNULUS_OK);
    for (int v = 0; v < n; ++v) sum += v == removed ? 0 : volumes[v];
    CHECK(fabs(sum - 1) < 1e-12);

    // Refused.
    CHECK_STATUS(annulus_voronoi_cells(mesh, lower, NULL, n, volumes, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_voronoi_cells(mesh, NULL, NULL, n, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_voronoi_cells(mesh, lower, lower, n, volumes, NULL), ANNULUS_USAGE);
    CHECK_STATUS(annulus_voronoi_cells(mesh, NULL, NULL, n - 1, volumes, NULL), ANNULUS_WRONG_SIZE);
    {
        const double infinite[3] = {INFINITY, INFINITY, INFINITY};
        CHECK_STATUS(annulus_voronoi_cells(mesh, lower, infinite, n, volumes, NULL), ANNULUS_NOT_FINITE);
    }
    CHECK_STATUS(annulus_voronoi_gradient(mesh, n - 1, weights, gradient), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_voronoi_gradient(mesh, n, NULL, gradient), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_voronoi_gradient(mesh, n, weights, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_voronoi_facets(mesh, total - 1, measures, NULL, &count), ANNULUS_WRONG_SIZE);
    CHECK(count == total);
    CHECK_STATUS(annulus_voronoi_facets(mesh, total, NULL, NULL, &count), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_voronoi_facets(mesh, total, measures, NULL, NULL), ANNULUS_NULL_POINTER);
    annulus_destroy(&mesh);
    free(all);
    free(measures);
    free(middles);
}

int main(void) {
    check_diagram(2);
    check_diagram(3);
    return verdict("voronoi");
}
