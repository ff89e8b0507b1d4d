// SPDX-License-Identifier: GPL-3.0-or-later
// Neighbours, hull and cells of points, which follow from annulus_cells; signs of points, and audits of any cells. And
// what these functions refuse.
#include "check.h"

#include <fenv.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { n = 80 };

static double turn(const double* a, const double* b, const double* c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Whether v and w are corners of one cell.
static int joined(const int32_t* cells, size_t count, size_t corners, int32_t v, int32_t w) {
    for (size_t c = 0; c < count; ++c) {
        int met = 0;
        for (size_t i = 0; i < corners; ++i) met += cells[c * corners + i] == v || cells[c * corners + i] == w;
        if (met == 2) return 1;
    }
    return 0;
}

static void check_lists(int dimension) {
    const size_t d = (size_t)dimension;
    const size_t corners = d + 1;
    const int32_t removed = 5;
    uint64_t state = 21;
    double x[3 * n];
    int32_t list[n];
    int32_t begin[n + 1];
    int32_t* all = NULL;
    int32_t* cells = NULL;
    int32_t* neighbours = NULL;
    int32_t* hull = NULL;
    size_t count = 0;
    size_t total = 0;
    size_t facets = 0;
    size_t open = 0;
    annulus_mesh* mesh = NULL;
    for (int i = 0; i < 3 * n; ++i) x[i] = uniform(&state);
    CHECK_STATUS(annulus_create(&mesh, dimension, n, x, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_remove(mesh, 1, &removed, NULL, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_cells(mesh, 0, NULL, NULL, &count), ANNULUS_OK);
    cells = malloc(count * corners * sizeof *cells);
    neighbours = malloc(count * corners * sizeof *neighbours);
    CHECK_STATUS(annulus_cells(mesh, count, cells, neighbours, &count), ANNULUS_OK);

    CHECK_STATUS(annulus_neighbour_lists(mesh, 0, NULL, 0, NULL, &total), ANNULUS_OK);
    all = malloc(total * sizeof *all);
    CHECK_STATUS(annulus_neighbour_lists(mesh, n + 1, begin, total, all, &total), ANNULUS_OK);
    CHECK(begin[0] == 0 && begin[n] == (int32_t)total);
    for (int32_t v = 0; v < n; ++v) {
        size_t degree = 77;
        const size_t expected = (size_t)(begin[v + 1] - begin[v]);
        if (v == removed) {
            CHECK(expected == 0);
            CHECK_STATUS(annulus_neighbours(mesh, v, n, list, &degree), ANNULUS_UNKNOWN_VERTEX);
            continue;
        }
        CHECK_STATUS(annulus_neighbours(mesh, v, n, list, &degree), ANNULUS_OK);
        CHECK(degree == expected && memcmp(list, all + begin[v], degree * sizeof *list) == 0);
        for (int32_t w = 0, k = 0; w < n; ++w) {
            const int listed = k < (int32_t)degree && list[k] == w;
            CHECK(listed == (w != v && joined(cells, count, corners, v, w)));
            k += listed;
        }
    }

    for (size_t k = 0; k < count * corners; ++k) open += neighbours[k] == -1;
    CHECK_STATUS(annulus_convex_hull(mesh, 0, NULL, &facets), ANNULUS_OK);
    CHECK(facets == open && facets > 2);
    hull = malloc(facets * d * sizeof *hull);
    CHECK_STATUS(annulus_convex_hull(mesh, facets, hull, &facets), ANNULUS_OK);
    if (dimension == 2)
        for (size_t f = 0; f < facets; ++f)
            for (int v = 0; v < n; ++v)
                CHECK(v == removed || turn(x + 2 * hull[2 * f], x + 2 * hull[2 * f + 1], x + 2 * v) >= 0);

    // The middle of every cell is in this cell; points far away and NaN are in none.
    for (size_t c = 0; c < count; ++c) {
        double middle[3] = {0};
        int32_t found = 77;
        for (size_t i = 0; i < corners; ++i)
            for (size_t k = 0; k < d; ++k) middle[k] += x[(size_t)cells[c * corners + i] * d + k] / (double)corners;
        CHECK_STATUS(annulus_find_cells(mesh, 1, middle, &found), ANNULUS_OK);
        CHECK(found == (int32_t)c);
    }
    {
        const double away[6] = {9, 9, 9, NAN, 0, 0};
        int32_t found[2] = {77, 77};
        CHECK_STATUS(annulus_find_cells(mesh, 1, away, found), ANNULUS_OK);
        CHECK_STATUS(annulus_find_cells(mesh, 1, away + 3, found + 1), ANNULUS_OK);
        CHECK(found[0] == -1 && found[1] == -1);
    }

    // Refused.
    CHECK_STATUS(annulus_neighbours(mesh, 0, 1, list, &count), ANNULUS_WRONG_SIZE);
    CHECK(count == (size_t)(begin[1] - begin[0]));
    CHECK_STATUS(annulus_neighbours(mesh, -1, n, list, &count), ANNULUS_UNKNOWN_VERTEX);
    CHECK_STATUS(annulus_neighbours(mesh, 0, n, NULL, &count), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_neighbours(mesh, 0, 0, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_neighbour_lists(mesh, n, begin, total, all, &count), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_neighbour_lists(mesh, n + 1, begin, total - 1, all, &count), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_neighbour_lists(mesh, n + 1, NULL, total, all, &count), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_convex_hull(mesh, facets - 1, hull, &count), ANNULUS_WRONG_SIZE);
    CHECK(count == facets);
    CHECK_STATUS(annulus_find_cells(mesh, 1, NULL, list), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_find_cells(mesh, 1, x, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_find_cells(mesh, 0, NULL, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_find_cells(NULL, 0, NULL, NULL), ANNULUS_NULL_POINTER);
    fesetround(FE_UPWARD);
    CHECK_STATUS(annulus_find_cells(mesh, 1, x, list), ANNULUS_ENVIRONMENT);
    fesetround(FE_TONEAREST);
    annulus_destroy(&mesh);
    free(all);
    free(cells);
    free(neighbours);
    free(hull);
}

static void check_signs(void) {
    const double triangle[12] = {0, 0, 8, 0, 4, 2, 0, 0, 4, 2, 8, 0};
    const double tetrahedron[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const double circles[16] = {-1, 0, 0, -0.75, 1, 0, 0, 0.75, 0, 0, 1, 0, 1, 1, 0, 1};
    const double sphere[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.25, 0.25, 0.25};
    double wrong[12];
    int32_t named[2] = {0, 0};
    annulus_sign signs[2];
    CHECK_STATUS(annulus_orient_2d(2, triangle, signs), ANNULUS_OK);
    CHECK(signs[0].sign == 1 && signs[1].sign == -1 && isnan(signs[0].theta));
    CHECK(fabs(signs[0].tolerance - 1) < 0.01 && signs[0].tolerance <= 1);
    CHECK(signs[0].width_lower <= 2 && signs[0].width_upper >= 2 && signs[0].stage == 0);
    CHECK_STATUS(annulus_orient_3d(1, tetrahedron, signs), ANNULUS_OK);
    CHECK(signs[0].sign == 1);
    CHECK_STATUS(annulus_in_circle(2, circles, signs), ANNULUS_OK);
    CHECK(signs[0].sign == 1 && fabs(signs[0].tolerance - 0.125) < 0.001 && signs[0].tolerance <= 0.125);
    CHECK(signs[1].sign == 0 && signs[1].tolerance == 0 && signs[1].width_upper == 0 && signs[1].stage == 2);
    CHECK(fabs(signs[1].theta - 1.5707963267948966) < 1e-12);
    CHECK_STATUS(annulus_in_sphere(1, sphere, signs), ANNULUS_OK);
    CHECK(signs[0].sign == 1 && signs[0].tolerance > 0);

    CHECK_STATUS(annulus_orient_2d(0, NULL, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_in_sphere(1, NULL, signs), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_in_sphere(1, sphere, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_in_sphere(SIZE_MAX / 64, sphere, signs), ANNULUS_WRONG_SIZE);
    memcpy(wrong, triangle, sizeof wrong);
    wrong[9] = HUGE_VAL;
    CHECK_STATUS(annulus_orient_2d(2, wrong, signs), ANNULUS_NOT_FINITE);
    CHECK(annulus_message_vertices(NULL, named) == 1 && named[0] == 1);
    wrong[9] = 1e200;
    CHECK_STATUS(annulus_orient_2d(2, wrong, signs), ANNULUS_OUT_OF_DOMAIN);
    fesetround(FE_DOWNWARD);
    CHECK_STATUS(annulus_orient_2d(2, triangle, signs), ANNULUS_ENVIRONMENT);
    fesetround(FE_TONEAREST);
}

static void check_audit(void) {
    const double kite[8] = {0, 0, 4, 0, 5, 5, 0, 4};
    const int32_t right[6] = {3, 1, 0, 2, 1, 3};
    const int32_t wrong[6] = {0, 1, 2, 3, 0, 2};
    const int32_t unknown[6] = {0, 1, 3, 1, 2, 9};
    const double tetrahedron[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const int32_t turned[4] = {1, 0, 2, 3};
    double bad[8];
    size_t count = 77;
    annulus_fault faults[3];
    annulus_audit_result result = {0};
    CHECK_STATUS(annulus_audit_cells(2, 4, kite, 2, right, &result, 0, NULL, NULL), ANNULUS_USAGE);  // size is 0
    result.size = sizeof result;
    CHECK_STATUS(annulus_audit_cells(2, 4, kite, 2, right, &result, 0, NULL, NULL), ANNULUS_OK);
    CHECK(result.delaunay == 1 && result.first_fault[0] == 0);
    CHECK_STATUS(annulus_audit_cells(2, 4, kite, 2, wrong, &result, 3, faults, &count), ANNULUS_OK);
    CHECK(result.delaunay == 0 && result.violated_facets == 1 && count == 1);
    CHECK(faults[0].kind == ANNULUS_NOT_DELAUNAY && faults[0].cells[0] + faults[0].cells[1] == 1);
    CHECK(faults[0].vertices[0] + faults[0].vertices[1] == 2 && faults[0].vertices[4] == -2);
    CHECK(strstr(result.first_fault, "not locally Delaunay") != NULL);
    CHECK_STATUS(annulus_audit_cells(2, 4, kite, 2, unknown, &result, 3, faults, &count), ANNULUS_OK);
    CHECK(count == 1 && faults[0].kind == ANNULUS_UNKNOWN_POINT && faults[0].cells[0] == 1);
    CHECK_STATUS(annulus_audit_cells(2, 4, kite, 1, right, &result, 3, faults, &count), ANNULUS_OK);
    CHECK(count == 1 && faults[0].kind == ANNULUS_UNUSED_POINT && faults[0].vertices[0] == 2);
    CHECK_STATUS(annulus_audit_cells(3, 4, tetrahedron, 1, turned, &result, 0, NULL, NULL), ANNULUS_OK);
    CHECK(result.delaunay == 1);
    CHECK_STATUS(annulus_audit_cells(3, 0, NULL, 0, NULL, &result, 0, NULL, NULL), ANNULUS_OK);
    CHECK(result.delaunay == 1);

    CHECK_STATUS(annulus_audit_cells(4, 4, kite, 2, right, &result, 0, NULL, NULL), ANNULUS_USAGE);
    CHECK_STATUS(annulus_audit_cells(2, 4, NULL, 2, right, &result, 0, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_audit_cells(2, 4, kite, 2, NULL, &result, 0, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_audit_cells(2, 4, kite, 2, right, NULL, 0, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_audit_cells(2, 4, kite, 2, right, &result, 3, NULL, &count), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_audit_cells(2, 4, kite, 2, right, &result, 3, faults, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_audit_cells(2, SIZE_MAX, kite, 2, right, &result, 0, NULL, NULL), ANNULUS_WRONG_SIZE);
    memcpy(bad, kite, sizeof bad);
    bad[5] = NAN;
    CHECK_STATUS(annulus_audit_cells(2, 4, bad, 2, right, &result, 0, NULL, NULL), ANNULUS_NOT_FINITE);
}

int main(void) {
    check_lists(2);
    check_lists(3);
    check_signs();
    check_audit();
    return verdict("geometry");
}
