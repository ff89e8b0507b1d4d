// SPDX-License-Identifier: GPL-3.0-or-later
// Results of the C interface: after moves, insertions and removals the cells are those of a new mesh at the same
// positions, changed cells are listed, Voronoi cells of a box add up, and sets that are empty, flat or have duplicates
// give the results documented in annulus.h.
#include "check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int width;  // corners of a cell, for compare_cells

static int compare_numbers(const void* a, const void* b) {
    const int32_t x = *(const int32_t*)a;
    const int32_t y = *(const int32_t*)b;
    return (x > y) - (x < y);
}
static int compare_cells(const void* a, const void* b) {
    for (int k = 0; k < width; ++k) {
        const int c = compare_numbers((const int32_t*)a + k, (const int32_t*)b + k);
        if (c != 0) return c;
    }
    return 0;
}

// Cells with their corners sorted, in order; malloc's.
static int32_t* sorted_cells(const annulus_mesh* mesh, int dimension, size_t* count) {
    int32_t* cells = NULL;
    const size_t corners = (size_t)dimension + 1;
    CHECK_STATUS(annulus_cells(mesh, 0, NULL, NULL, count), ANNULUS_OK);
    cells = malloc((*count + 1) * corners * sizeof *cells);
    CHECK_STATUS(annulus_cells(mesh, *count, cells, NULL, count), ANNULUS_OK);
    for (size_t c = 0; c < *count; ++c) qsort(cells + c * corners, corners, sizeof *cells, compare_numbers);
    width = (int)corners;
    qsort(cells, *count, corners * sizeof *cells, compare_cells);
    return cells;
}

static void check_delaunay(const annulus_mesh* mesh) {
    annulus_audit_result audit = {0};
    audit.size = sizeof audit;
    CHECK_STATUS(annulus_audit(mesh, &audit), ANNULUS_OK);
    CHECK(audit.delaunay == 1);
    if (!audit.delaunay) printf("%s\n", audit.first_fault);
}

// Steps of all and of some vertices, compared with a mesh that is built again after each.
static void check_motion(int dimension, const char* strategy, size_t n) {
    const size_t d = (size_t)dimension;
    const size_t corners = d + 1;
    uint64_t state = 11;
    double* x = malloc(n * d * sizeof *x);
    double* some = malloc(n * d * sizeof *some);
    int32_t* indices = malloc(n * sizeof *indices);
    annulus_mesh* mesh = NULL;
    annulus_options options = {0};
    annulus_report report = {0};
    options.size = sizeof options;
    options.strategy = strategy;
    options.report_changes = 1;
    report.size = sizeof report;
    for (size_t i = 0; i < n * d; ++i) x[i] = uniform(&state);
    CHECK_STATUS(annulus_create(&mesh, dimension, n, x, &options), ANNULUS_OK);
    for (int step = 0; step < 12; ++step) {
        annulus_mesh* fresh = NULL;
        size_t before = 0;
        size_t now = 0;
        size_t anew = 0;
        size_t changed = 0;
        size_t movers = 0;
        int32_t* old_cells = sorted_cells(mesh, dimension, &before);
        if (step % 3 == 0) {
            for (size_t i = 0; i < n * d; ++i) x[i] += 0.02 * (uniform(&state) - 0.5);
            CHECK_STATUS(annulus_move_all(mesh, n, x, &report), ANNULUS_OK);
            CHECK(report.asked == n);
        } else {
            for (size_t i = (size_t)step; i < n; i += 9) {
                indices[movers] = (int32_t)i;
                for (size_t k = 0; k < d; ++k) some[movers * d + k] = x[i * d + k] += 0.05 * (uniform(&state) - 0.5);
                ++movers;
            }
            CHECK_STATUS(annulus_move(mesh, movers, indices, some, &report), ANNULUS_OK);
            CHECK(report.asked == movers);
        }
        CHECK(report.within_tolerance + report.kept_in_place + report.flipped + report.reinserted + report.rebuilt ==
              report.asked);
        CHECK_STATUS(annulus_points(mesh, n, some), ANNULUS_OK);
        CHECK(memcmp(some, x, n * d * sizeof *x) == 0);
        check_delaunay(mesh);

        CHECK_STATUS(annulus_create(&fresh, dimension, n, x, NULL), ANNULUS_OK);
        {
            int32_t* cells = sorted_cells(mesh, dimension, &now);
            int32_t* fresh_cells = sorted_cells(fresh, dimension, &anew);
            int32_t* list = NULL;
            CHECK(now == anew && memcmp(cells, fresh_cells, now * corners * sizeof *cells) == 0);
            // Cells that did not exist before are listed.
            CHECK_STATUS(annulus_changed(mesh, 0, NULL, &changed), ANNULUS_OK);
            CHECK(changed == report.changed);
            list = malloc((changed + 1) * corners * sizeof *list);
            CHECK_STATUS(annulus_changed(mesh, changed, list, &changed), ANNULUS_OK);
            for (size_t c = 0; c < changed; ++c) qsort(list + c * corners, corners, sizeof *list, compare_numbers);
            qsort(list, changed, corners * sizeof *list, compare_cells);
            for (size_t c = 0; c < now; ++c)
                if (!bsearch(cells + c * corners, old_cells, before, corners * sizeof *cells, compare_cells))
                    CHECK(bsearch(cells + c * corners, list, changed, corners * sizeof *cells, compare_cells));
            free(list);
            free(cells);
            free(fresh_cells);
        }
        free(old_cells);
        annulus_destroy(&fresh);
    }
    annulus_destroy(&mesh);
    free(x);
    free(some);
    free(indices);
}

static void check_neighbours(int dimension) {
    enum { n = 120 };
    const size_t corners = (size_t)dimension + 1;
    uint64_t state = 3;
    double x[3 * n];
    double volumes[n];
    int32_t neighbour_counts[n];
    int32_t* vertices = NULL;
    int32_t* neighbours = NULL;
    size_t count = 0;
    annulus_mesh* mesh = NULL;
    for (int i = 0; i < 3 * n; ++i) x[i] = uniform(&state);
    CHECK_STATUS(annulus_create(&mesh, dimension, n, x, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_cells(mesh, 0, NULL, NULL, &count), ANNULUS_OK);
    vertices = malloc(count * corners * sizeof *vertices);
    neighbours = malloc(count * corners * sizeof *neighbours);
    CHECK_STATUS(annulus_cells(mesh, count, vertices, neighbours, &count), ANNULUS_OK);
    CHECK_STATUS(annulus_voronoi(mesh, n, volumes, neighbour_counts), ANNULUS_OK);
    for (size_t c = 0; c < count; ++c)
        for (size_t i = 0; i < corners; ++i) {
            const int32_t other = neighbours[c * corners + i];
            int mutual = 0;
            CHECK(other >= -1 && other < (int32_t)count);
            for (size_t k = 0; k < corners; ++k) {
                if (other >= 0) mutual = mutual || neighbours[(size_t)other * corners + k] == (int32_t)c;
                else if (k != i) CHECK(isinf(volumes[vertices[c * corners + k]]));  // on the hull
            }
            CHECK(other < 0 || mutual);
        }
    for (int i = 0; i < n; ++i) CHECK(volumes[i] > 0 && neighbour_counts[i] >= dimension);
    // Only neighbours, only volumes.
    CHECK_STATUS(annulus_voronoi(mesh, n, NULL, neighbour_counts), ANNULUS_OK);
    volumes[0] = -1;
    CHECK_STATUS(annulus_voronoi(mesh, n, volumes, NULL), ANNULUS_OK);
    CHECK(volumes[0] > 0);
    free(vertices);
    free(neighbours);
    annulus_destroy(&mesh);
}

// The inner points of a lattice have its boxes as cells.
static void check_volumes(void) {
    enum { side = 5, n = side * side * side };
    double x[3 * n];
    double volumes[n];
    int32_t counts[n];
    annulus_mesh* mesh = NULL;
    for (int i = 0; i < n; ++i) {
        x[3 * i] = i % side;
        x[3 * i + 1] = 0.5 * (i / side % side);
        x[3 * i + 2] = 4.0 * (i / side / side);
    }
    CHECK_STATUS(annulus_create(&mesh, 3, n, x, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_voronoi(mesh, n, volumes, counts), ANNULUS_OK);
    for (int i = 0; i < n; ++i) {
        const int a = i % side, b = i / side % side, c = i / side / side;
        const int inside = a > 0 && a < side - 1 && b > 0 && b < side - 1 && c > 0 && c < side - 1;
        CHECK(inside ? volumes[i] == 2.0 : isinf(volumes[i]));
    }
    annulus_destroy(&mesh);
}

static void check_small_sets(int dimension) {
    const size_t d = (size_t)dimension;
    double x[3 * 6] = {0};
    double volumes[8];
    int32_t counts[8];
    int32_t cells[64];
    int32_t indices[6];
    size_t count = 77;
    int affine = 77;
    const char* strategy = NULL;
    annulus_mesh* mesh = NULL;
    annulus_options options = {0};
    options.size = sizeof options;

    CHECK_STATUS(annulus_create(&mesh, dimension, 0, NULL, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_strategy(mesh, &strategy), ANNULUS_OK);
    CHECK(strcmp(strategy, "auto") == 0);
    CHECK_STATUS(annulus_affine_dimension(mesh, &affine), ANNULUS_OK);
    CHECK(affine == -1);
    CHECK_STATUS(annulus_cells(mesh, 0, NULL, NULL, &count), ANNULUS_OK);
    CHECK(count == 0);
    CHECK_STATUS(annulus_voronoi(mesh, 0, NULL, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_points(mesh, 0, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_move_all(mesh, 0, NULL, NULL), ANNULUS_OK);
    check_delaunay(mesh);

    // One vertex, then a line, then more.
    CHECK_STATUS(annulus_insert(mesh, 1, x, indices, &count, NULL), ANNULUS_OK);
    CHECK(count == 1 && indices[0] == 0);
    CHECK_STATUS(annulus_voronoi(mesh, 8, volumes, counts), ANNULUS_OK);
    CHECK(isinf(volumes[0]) && counts[0] == 0);
    for (int i = 1; i < 4; ++i) x[d * (size_t)i] = i;
    CHECK_STATUS(annulus_insert(mesh, 3, x + d, indices, &count, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_affine_dimension(mesh, &affine), ANNULUS_OK);
    CHECK(affine == 1);
    CHECK_STATUS(annulus_cells(mesh, 16, cells, NULL, &count), ANNULUS_OK);
    CHECK(count == 3 && cells[0] >= 0 && cells[1] >= 0 && cells[2] == -2);
    CHECK_STATUS(annulus_voronoi(mesh, 8, volumes, counts), ANNULUS_OK);
    CHECK(isinf(volumes[1]) && counts[0] == 1 && counts[1] == 2);
    x[4 * d] = 1.25;
    x[4 * d + 1] = 1;
    CHECK_STATUS(annulus_insert(mesh, 1, x + 4 * d, indices, NULL, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_affine_dimension(mesh, &affine), ANNULUS_OK);
    CHECK(affine == 2);
    check_delaunay(mesh);
    for (int i = 0; i < 5; ++i) indices[i] = i;
    CHECK_STATUS(annulus_remove(mesh, 5, indices, &count, NULL), ANNULUS_OK);
    CHECK(count == 5);
    CHECK_STATUS(annulus_vertex_count(mesh, &count), ANNULUS_OK);
    CHECK(count == 0);
    CHECK_STATUS(annulus_voronoi(mesh, 5, volumes, counts), ANNULUS_OK);
    CHECK(isnan(volumes[4]) && counts[4] == 0);
    annulus_destroy(&mesh);

    memset(x, 0, sizeof x);
    x[d] = 1;  // two places for six points
    CHECK_STATUS(annulus_create(&mesh, dimension, 6, x, NULL), ANNULUS_DUPLICATE_POINT);
    CHECK(mesh == NULL && annulus_message(NULL, NULL, 0) > 0);
    options.merge_duplicates = 1;
    CHECK_STATUS(annulus_create(&mesh, dimension, 6, x, &options), ANNULUS_OK);
    CHECK_STATUS(annulus_vertex_count(mesh, &count), ANNULUS_OK);
    CHECK(count == 2);
    CHECK_STATUS(annulus_vertex_of_input(mesh, 6, indices, &count), ANNULUS_OK);
    CHECK(count == 6 && indices[0] == 0 && indices[1] == 1 && indices[2] == 0 && indices[5] == 0);
    annulus_destroy(&mesh);
}

// The paper's tolerance lets a spindle of five points (docs/theory.md 3) grow past the sphere of four of them: the
// audit's message names vertices by their indices, of which 0 is free.
static void check_first_fault(void) {
    const double s = sqrt(0.75);
    double x[18] = {5, 5, 5, 0, 0, 0.99, 0, 0, -0.99, 1, 0, 0, -0.5, s, 0, -0.5, -s, 0};
    const int32_t first = 0;
    annulus_mesh* mesh = NULL;
    annulus_options options = {0};
    annulus_audit_result audit = {0};
    char opposites[6] = {0};
    options.size = sizeof options;
    options.strategy = "paper";
    options.tolerance = "paper";
    audit.size = sizeof audit;
    CHECK_STATUS(annulus_create(&mesh, 3, 6, x, &options), ANNULUS_OK);
    CHECK_STATUS(annulus_remove(mesh, 1, &first, NULL, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_recompute_tolerances(mesh, NULL), ANNULUS_OK);
    for (int k = 9; k < 18; ++k) x[k] *= 1 - 0.007;
    x[5] += 0.007;
    x[8] -= 0.007;
    CHECK_STATUS(annulus_move_all(mesh, 6, x, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_audit(mesh, &audit), ANNULUS_OK);
    CHECK(audit.delaunay == 0 && audit.violated_facets > 0);
    CHECK(sscanf(audit.first_fault, "not locally Delaunay: facet, opposites %c %c %c %c %c", opposites, opposites + 1,
                 opposites + 2, opposites + 3, opposites + 4) == 5);
    for (char v = '1'; v <= '5'; ++v) CHECK(strchr(opposites, v) != NULL);
    annulus_destroy(&mesh);
}

int main(void) {
    static const char* const strategies[] = {"auto",     "tolerances",   "tolerances-each", "in-place", "paper",
                                             "relocate", "paper-hybrid", "relocate-flips",  "rebuild"};
    for (int k = 0; k < 9; ++k) {
        check_motion(2, strategies[k], 150);
        check_motion(3, strategies[k], 60);
    }
    check_neighbours(2);
    check_neighbours(3);
    check_volumes();
    check_small_sets(2);
    check_small_sets(3);
    check_first_fault();
    return verdict("answers");
}
