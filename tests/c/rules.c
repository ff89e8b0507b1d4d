// SPDX-License-Identifier: GPL-3.0-or-later
// Rules that hold in every language, as tables: what there is at a free index, what `threads` may be, defaults, order
// of arguments, which vertices an error names. tests/engine/rules_test.cpp and python/tests/test_rules.py are the same
// tables.
#include "check.h"

#include <math.h>
#include <string.h>

enum { points = 40 };

static double x[2 * points + 2];

static void fill(void) {
    uint64_t state = 11;
    for (int i = 0; i < 2 * points + 2; ++i) x[i] = uniform(&state);
}

static annulus_mesh* a_mesh(void) {
    annulus_mesh* mesh = NULL;
    fill();
    CHECK_STATUS(annulus_create(&mesh, 2, points, x, NULL), ANNULUS_OK);
    return mesh;
}

// ---- A free index: NaN, no neighbours, in no cell ---------------------------------------------------------

static int by_points(const annulus_mesh* mesh, double* out) { return annulus_points(mesh, points, out); }
static int by_tolerances(const annulus_mesh* mesh, double* out) { return annulus_tolerances(mesh, points, out); }
static int by_displacements(const annulus_mesh* mesh, double* out) { return annulus_displacements(mesh, points, out); }
static int by_volumes(const annulus_mesh* mesh, double* out) { return annulus_voronoi(mesh, points, out, NULL); }

static void check_free(const annulus_mesh* mesh, int32_t index) {
    const struct {
        int (*read)(const annulus_mesh*, double*);
        int each;  // numbers for each vertex
    } table[] = {{by_points, 2}, {by_tolerances, 1}, {by_displacements, 1}, {by_volumes, 1}};
    double numbers[2 * points];
    int32_t begin[points + 1], counts[points], cells[3 * 4 * points], corner = 0;
    size_t n = 0;
    int is = 7;
    for (size_t row = 0; row < sizeof table / sizeof *table; ++row) {
        CHECK_STATUS(table[row].read(mesh, numbers), ANNULUS_OK);
        for (int i = 0; i < points * table[row].each; ++i) CHECK(isnan(numbers[i]) == (i / table[row].each == index));
    }
    CHECK_STATUS(annulus_neighbour_lists(mesh, points + 1, begin, 0, NULL, &n), ANNULUS_OK);
    CHECK(begin[index] == begin[index + 1]);
    CHECK_STATUS(annulus_voronoi(mesh, points, NULL, counts), ANNULUS_OK);
    CHECK(counts[index] == 0);
    CHECK_STATUS(annulus_cells(mesh, 4 * points, cells, NULL, &n), ANNULUS_OK);
    for (size_t k = 0; k < 3 * n; ++k) corner += cells[k] == index;
    CHECK(n > 0 && corner == 0);
    CHECK_STATUS(annulus_is_vertex(mesh, index, &is), ANNULUS_OK);
    CHECK(is == 0);
}

static void check_free_indices(void) {
    annulus_mesh* mesh = a_mesh();
    const int32_t index = 9;
    CHECK_STATUS(annulus_remove(mesh, 1, &index, NULL, NULL), ANNULUS_OK);
    check_free(mesh, index);
    for (int i = 0; i < 2 * points; ++i) x[i] += 1e-3 * x[(i + 1) % (2 * points)];
    CHECK_STATUS(annulus_move_all(mesh, points, x, NULL), ANNULUS_OK);
    check_free(mesh, index);
    annulus_destroy(&mesh);
}

// ---- threads, defaults, order of arguments -----------------------------------------------------------------

static void check_threads(void) {
    // 0 is the default of every member.
    const struct {
        int32_t threads;
        int status;
    } table[] = {{0, ANNULUS_OK},     {1, ANNULUS_OK},     {2, ANNULUS_OK},
                 {-1, ANNULUS_USAGE}, {-3, ANNULUS_USAGE}, {INT32_MIN, ANNULUS_USAGE}};
    fill();
    for (size_t row = 0; row < sizeof table / sizeof *table; ++row) {
        annulus_mesh* mesh = NULL;
        annulus_options options = {0};
        options.size = sizeof options;
        options.threads = table[row].threads;
        CHECK_STATUS(annulus_create(&mesh, 2, points, x, &options), table[row].status);
        CHECK((mesh != NULL) == (table[row].status == ANNULUS_OK));
        annulus_destroy(&mesh);
    }
}

static void check_defaults(void) {
    annulus_mesh* mesh = a_mesh();
    annulus_mesh* other = NULL;
    annulus_options options = {0};
    const char* strategy = NULL;
    size_t n = 0;
    CHECK_STATUS(annulus_strategy(mesh, &strategy), ANNULUS_OK);
    CHECK(strcmp(strategy, "auto") == 0);
    CHECK_STATUS(annulus_changed(mesh, 0, NULL, &n), ANNULUS_USAGE);  // report_changes is off
    options.size = sizeof options;
    options.report_changes = 1;
    CHECK_STATUS(annulus_create(&other, 2, points, x, &options), ANNULUS_OK);
    CHECK_STATUS(annulus_changed(other, 0, NULL, &n), ANNULUS_OK);
    memcpy(x, x + 2, 2 * sizeof *x);
    annulus_destroy(&other);
    CHECK_STATUS(annulus_create(&other, 2, points, x, NULL), ANNULUS_DUPLICATE_POINT);  // merge_duplicates is off
    annulus_destroy(&mesh);
}

static void check_order(void) {
    annulus_mesh* mesh = a_mesh();
    const int32_t indices[] = {3, 1};
    const double to[] = {0.25, 0.5, 0.75, 0.625};
    double now[2 * points];
    CHECK_STATUS(annulus_move(mesh, 2, indices, to, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_points(mesh, points, now), ANNULUS_OK);
    CHECK(now[6] == 0.25 && now[7] == 0.5 && now[2] == 0.75 && now[3] == 0.625);
    annulus_destroy(&mesh);
}

// ---- Errors name all vertices ------------------------------------------------------------------------------

enum call { create, move_all, move_some, insert, remove_some, neighbours };

static int make(enum call call, annulus_mesh* mesh, size_t count, const int32_t* indices, const double* to) {
    annulus_mesh* other = NULL;
    int32_t numbers[points];
    size_t n = 0;
    switch (call) {
        case create: return annulus_create(&other, 2, points, to, NULL);
        case move_all: return annulus_move_all(mesh, points, to, NULL);
        case move_some: return annulus_move(mesh, count, indices, to, NULL);
        case insert: return annulus_insert(mesh, count, to, numbers, NULL, NULL);
        case remove_some: return annulus_remove(mesh, count, indices, NULL, NULL);
        case neighbours: return annulus_neighbours(mesh, indices[0], 0, NULL, &n);
    }
    return ANNULUS_INTERNAL;
}

static void check_vertices(void) {
    // Points `from` become those of `place`, a vertex, or NaN (-1) or far (-2), before the call, in its coordinates.
    const struct {
        enum call call;
        size_t count;
        int32_t indices[4];
        int changed[3];
        int place;
        int status;
        size_t named;
        int32_t names[4];
    } table[] = {
        {create, 0, {0}, {9, 4, 2}, 4, ANNULUS_DUPLICATE_POINT, 3, {2, 4, 9}},
        {create, 0, {0}, {9, 5, 9}, -1, ANNULUS_NOT_FINITE, 2, {5, 9}},
        {move_all, 0, {0}, {9, 30, 9}, 4, ANNULUS_DUPLICATE_POINT, 3, {4, 9, 30}},
        {move_all, 0, {0}, {9, 4, 7}, -2, ANNULUS_OUT_OF_DOMAIN, 3, {4, 7, 9}},
        {move_all, 0, {0}, {6, 8, 6}, -1, ANNULUS_NOT_FINITE, 1, {8}},
        {move_some, 2, {5, 8}, {0, 1, 0}, 3, ANNULUS_DUPLICATE_POINT, 3, {3, 5, 8}},
        {move_some, 2, {8, 5}, {0, 1, 0}, -1, ANNULUS_NOT_FINITE, 2, {5, 8}},
        {move_some, 4, {6, 1, -1, 99}, {0, 0, 0}, 0, ANNULUS_UNKNOWN_VERTEX, 3, {-1, 6, 99}},
        {insert, 2, {0}, {0, 1, 0}, -1, ANNULUS_NOT_FINITE, 2, {0, 1}},
        {insert, 1, {0}, {0, 0, 0}, 7, ANNULUS_DUPLICATE_POINT, 1, {7}},
        {remove_some, 4, {6, 1, 1, 99}, {0, 0, 0}, 0, ANNULUS_UNKNOWN_VERTEX, 3, {1, 6, 99}},
        {neighbours, 1, {6}, {0, 0, 0}, 0, ANNULUS_UNKNOWN_VERTEX, 1, {6}},
    };
    const int32_t index = 6;
    annulus_mesh* mesh = a_mesh();
    CHECK_STATUS(annulus_remove(mesh, 1, &index, NULL, NULL), ANNULUS_OK);
    for (size_t row = 0; row < sizeof table / sizeof *table; ++row) {
        double to[2 * points];
        int32_t named[4] = {77, 77, 77, 77}, first[2] = {77, 77};
        const annulus_mesh* const of = table[row].call == create ? NULL : mesh;
        const int place = table[row].place;
        fill();
        memcpy(to, x, sizeof to);
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < 2; ++i)
                to[2 * table[row].changed[k] + i] = place == -1 ? NAN : place == -2 ? 1e200 : x[2 * place + i];
        printf("row %d\n", (int)row);
        CHECK_STATUS(make(table[row].call, mesh, table[row].count, table[row].indices, to), table[row].status);
        CHECK(annulus_error_vertices(of, 4, named) == table[row].named);
        CHECK(memcmp(named, table[row].names, table[row].named * sizeof *named) == 0);
        CHECK(table[row].named == 4 || named[table[row].named] == 77);
        // As many as there is room for, and the count of all.
        CHECK(annulus_error_vertices(of, 0, NULL) == table[row].named);
        CHECK(annulus_error_vertices(of, 1, first) == table[row].named);
        CHECK(first[0] == named[0] && first[1] == 77);
        CHECK(annulus_message_vertices(of, first) == (table[row].named < 2 ? table[row].named : 2));
    }
    annulus_destroy(&mesh);
}

static void check_single_points(void) {
    const double place[] = {0.5, 0.25, 1, 1};
    const struct {
        size_t points, cells;
        int32_t cell[3];
        int delaunay;
    } table[] = {{0, 0, {0}, 1},         {1, 0, {0}, 1},        {2, 0, {0}, 0},        {2, 1, {0, 1, -2}, 1},
                 {1, 1, {0, -2, -2}, 0}, {1, 1, {0, 0, -2}, 0}, {1, 1, {0, 1, -2}, 0}, {0, 1, {-2, -2, -2}, 0}};
    for (size_t row = 0; row < sizeof table / sizeof *table; ++row) {
        annulus_audit_result result = {0};
        result.size = sizeof result;
        CHECK_STATUS(
            annulus_audit_cells(2, table[row].points, place, table[row].cells, table[row].cell, &result, 0, NULL, NULL),
            ANNULUS_OK);
        CHECK(result.delaunay == table[row].delaunay);
    }
}

int main(void) {
    check_single_points();
    check_free_indices();
    check_threads();
    check_defaults();
    check_order();
    check_vertices();
    return verdict("rules");
}
