// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic boxes through the C interface: a crystal, moves with a box, points that come and go, lists, refusals.
#include "check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { most = 4096 };

static const double cube[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
static const double copper[12] = {0, 0, 0, 0.5, 0.5, 0, 0.5, 0, 0.5, 0, 0.5, 0.5};

static annulus_periodic* mesh_of(int dimension, size_t count, const double* x, const double* box) {
    annulus_periodic* mesh = NULL;
    annulus_options options = {0};
    options.size = sizeof options;
    options.report_changes = 1;
    CHECK_STATUS(annulus_periodic_create(&mesh, dimension, count, x, box, &options), ANNULUS_OK);
    return mesh;
}

static int is_delaunay(const annulus_periodic* mesh) {
    annulus_audit_result result = {0};
    result.size = sizeof result;
    CHECK_STATUS(annulus_periodic_audit(mesh, &result), ANNULUS_OK);
    CHECK((result.first_fault[0] == 0) == (result.delaunay == 1));
    return result.delaunay;
}

// Volumes that add up to that of the box; neighbours in both directions; corners that cells and neighbours share.
static void check_lists(const annulus_periodic* mesh, int d, double volume) {
    static int32_t first[most], second[most], shifts[3 * most], vertices[4 * most], offsets[12 * most],
        neighbours[4 * most], translations[12 * most];
    static double vectors[3 * most], distances[most], areas[most], volumes[most], tolerances[most], x[3 * most],
        weights[most], gradient[3 * most];
    double box[9], sum = 0;
    size_t bound = 0, pairs = 0, cells = 0;
    int dimension = 0;
    CHECK_STATUS(annulus_periodic_dimension(mesh, &dimension), ANNULUS_OK);
    CHECK(dimension == d);
    CHECK_STATUS(annulus_periodic_index_bound(mesh, &bound), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_box(mesh, box), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_points(mesh, bound, x), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_voronoi(mesh, bound, volumes), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_tolerances(mesh, bound, tolerances), ANNULUS_OK);
    for (size_t i = 0; i < bound; ++i) {
        int there = 0;
        CHECK_STATUS(annulus_periodic_is_vertex(mesh, (int32_t)i, &there), ANNULUS_OK);
        CHECK(isnan(volumes[i]) == !there && isnan(x[(size_t)d * i]) == !there);
        CHECK(there ? tolerances[i] >= 0 : isnan(tolerances[i]));
        if (there) sum += volumes[i];
    }
    CHECK(fabs(sum - volume) < 1e-9 * volume);
    // All volumes together do not change, and one alone does.
    for (size_t i = 0; i < bound; ++i) weights[i] = 1;
    CHECK_STATUS(annulus_periodic_voronoi_gradient(mesh, bound, weights, gradient), ANNULUS_OK);
    for (size_t k = 0; k < (size_t)d * bound; ++k) CHECK(isnan(gradient[k]) || fabs(gradient[k]) < 1e-9 * volume);

    CHECK_STATUS(annulus_periodic_neighbours(mesh, 0, NULL, NULL, NULL, NULL, NULL, NULL, &pairs), ANNULUS_OK);
    CHECK(pairs > 0 && pairs < most);
    CHECK_STATUS(annulus_periodic_neighbours(mesh, pairs, first, second, shifts, vectors, distances, areas, &pairs),
                 ANNULUS_OK);
    for (size_t k = 0; k < pairs; ++k) {
        double squared = 0;
        for (int c = 0; c < d; ++c) {
            double expected = x[d * second[k] + c] - x[d * first[k] + c];
            for (int j = 0; j < d; ++j) expected += shifts[(size_t)d * k + (size_t)j] * box[d * j + c];
            CHECK(fabs(vectors[(size_t)d * k + (size_t)c] - expected) < 1e-12);
            squared += expected * expected;
        }
        CHECK(fabs(distances[k] - sqrt(squared)) < 1e-12 && areas[k] >= 0);
    }
    CHECK_STATUS(annulus_periodic_neighbours(mesh, pairs - 1, first, NULL, NULL, NULL, NULL, NULL, &pairs),
                 ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_periodic_neighbours(mesh, pairs, NULL, NULL, NULL, NULL, NULL, NULL, &pairs),
                 ANNULUS_NULL_POINTER);

    CHECK_STATUS(annulus_periodic_cells(mesh, 0, NULL, NULL, NULL, NULL, &cells), ANNULUS_OK);
    CHECK(cells > 0 && cells < most);
    CHECK_STATUS(annulus_periodic_cells(mesh, cells, vertices, offsets, neighbours, translations, &cells), ANNULUS_OK);
    const size_t corners = (size_t)d + 1;
    for (size_t c = 0; c < cells; ++c)
        for (size_t i = 0; i < corners; ++i) {  // the corners of the neighbour, but one, are corners of the cell
            const size_t m = (size_t)neighbours[corners * c + i];
            size_t common = 0;
            CHECK(m < cells && m != c);
            for (size_t k = 0; k < corners; ++k)
                for (size_t l = 0; l < corners; ++l) {
                    int same = k != i && vertices[corners * c + k] == vertices[corners * m + l];
                    for (int j = 0; j < d; ++j)
                        same = same && offsets[(corners * c + k) * (size_t)d + (size_t)j] ==
                                           offsets[(corners * m + l) * (size_t)d + (size_t)j] +
                                               translations[(corners * c + i) * (size_t)d + (size_t)j];
                    if (same) ++common;
                }
            CHECK(common == (size_t)d);
        }
    CHECK_STATUS(annulus_periodic_cells(mesh, cells, NULL, NULL, neighbours, NULL, &cells), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_cells(mesh, cells - 1, vertices, NULL, NULL, NULL, &cells), ANNULUS_WRONG_SIZE);
}

static void check_crystal(void) {
    double areas[most], moved[12];
    const double sheared[9] = {1, 0, 0, 0.125, 1, 0, 0, 0, 1};
    int32_t first[most], second[most], shifts[3 * most], counts[4] = {0};
    size_t pairs = 0, made = 0, broken = 0;
    annulus_report report = {0};
    annulus_periodic* mesh = mesh_of(3, 4, copper, cube);
    report.size = sizeof report;
    CHECK_STATUS(annulus_periodic_neighbours(mesh, most, first, NULL, NULL, NULL, NULL, areas, &pairs), ANNULUS_OK);
    for (size_t k = 0; k < pairs; ++k)
        if (areas[k] > 0) ++counts[first[k]];
    for (int i = 0; i < 4; ++i) CHECK(counts[i] == 12);
    check_lists(mesh, 3, 1);
    CHECK(is_delaunay(mesh));

    for (int i = 0; i < 4; ++i) {  // a shear; and each point as another image
        for (int c = 0; c < 3; ++c) moved[3 * i + c] = copper[3 * i + c] + (c == 2 ? i : 0);
        moved[3 * i] += 0.125 * copper[3 * i + 1];
    }
    CHECK_STATUS(annulus_periodic_move_all(mesh, 4, moved, sheared, &report), ANNULUS_OK);
    CHECK(report.asked == 4 && report.within_tolerance + report.kept_in_place + report.flipped + report.rebuilt == 4);
    check_lists(mesh, 3, 1);
    CHECK(is_delaunay(mesh));
    CHECK_STATUS(annulus_periodic_pairs_made(mesh, 0, NULL, NULL, NULL, &made), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_pairs_broken(mesh, most, first, second, shifts, &broken), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_neighbours(mesh, 0, NULL, NULL, NULL, NULL, NULL, NULL, &made), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_move_all(mesh, 4, moved, NULL, NULL), ANNULUS_OK);  // nothing changes
    CHECK_STATUS(annulus_periodic_pairs_made(mesh, 0, NULL, NULL, NULL, &made), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_pairs_broken(mesh, 0, NULL, NULL, NULL, &broken), ANNULUS_OK);
    CHECK(made == 0 && broken == 0);
    CHECK_STATUS(annulus_periodic_changed(mesh, 0, NULL, NULL, &made), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_gone(mesh, 0, NULL, NULL, &broken), ANNULUS_OK);
    CHECK(made == 0 && broken == 0);
    annulus_periodic_destroy(&mesh);
    CHECK(mesh == NULL);
    annulus_periodic_destroy(&mesh);
    annulus_periodic_destroy(NULL);
}

static void check_coming_and_going(int d) {
    const double tilted[2][9] = {{2, 0, 0.5, 1.5}, {2, 0, 0, 0.5, 1.5, 0, -0.25, 0.5, 1.25}};
    const double* box = tilted[d - 2];
    const double volume = d == 2 ? 3 : 3.75;
    const int32_t some[3] = {1, 20, 7};
    uint64_t seed = 5;
    double x[3 * 40];
    int32_t indices[40], first[most], second[most], vertices[4 * most], offsets[12 * most];
    size_t count = 0, bound = 0, made = 0, broken = 0, cells = 0;
    annulus_periodic* mesh = mesh_of(d, 0, NULL, box);
    for (int k = 0; k < 40 * d; ++k) x[k] = 4 * uniform(&seed) - 2;
    CHECK(is_delaunay(mesh));
    CHECK_STATUS(annulus_periodic_insert(mesh, 30, x, indices), ANNULUS_OK);
    for (int32_t k = 0; k < 30; ++k) CHECK(indices[k] == k);
    check_lists(mesh, d, volume);
    CHECK_STATUS(annulus_periodic_remove(mesh, 3, some), ANNULUS_OK);
    check_lists(mesh, d, volume);
    CHECK(is_delaunay(mesh));
    CHECK_STATUS(annulus_periodic_vertex_count(mesh, &count), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_index_bound(mesh, &bound), ANNULUS_OK);
    CHECK(count == 27 && bound == 30);
    CHECK_STATUS(annulus_periodic_insert(mesh, 1, x + 30 * d, indices), ANNULUS_OK);
    CHECK(indices[0] == 7);
    CHECK_STATUS(annulus_periodic_pairs_made(mesh, most, first, second, NULL, &made), ANNULUS_OK);
    CHECK(made > 0);
    for (size_t k = 0; k < made; ++k) CHECK(first[k] <= second[k] && (first[k] == 7 || second[k] == 7));
    CHECK_STATUS(annulus_periodic_remove(mesh, 1, indices), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_pairs_broken(mesh, 0, NULL, NULL, NULL, &broken), ANNULUS_OK);
    CHECK(broken == made);
    CHECK_STATUS(annulus_periodic_gone(mesh, 0, NULL, NULL, &cells), ANNULUS_OK);
    CHECK(cells > 0 && cells <= most);
    CHECK_STATUS(annulus_periodic_gone(mesh, cells, vertices, offsets, &cells), ANNULUS_OK);
    for (size_t c = 0; c < cells; ++c) {  // all of them had the vertex, each as its least or a later corner
        int has = 0;
        for (size_t i = 0; i <= (size_t)d; ++i) has = has || vertices[((size_t)d + 1) * c + i] == 7;
        CHECK(has);
    }
    CHECK_STATUS(annulus_periodic_gone(mesh, cells, NULL, NULL, &cells), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_gone(mesh, cells - 1, vertices, NULL, &cells), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_periodic_changed(mesh, most, vertices, offsets, &count), ANNULUS_OK);
    if (d == 2) CHECK(cells == count + 2);
    CHECK_STATUS(annulus_periodic_pairs_broken(mesh, broken - 1, first, NULL, NULL, &broken), ANNULUS_WRONG_SIZE);
    double further[3];
    annulus_report moved_one = {0};
    moved_one.size = sizeof moved_one;
    for (int c = 0; c < d; ++c) further[c] = x[10 * d + c] + 0.125;
    CHECK_STATUS(annulus_periodic_move(mesh, 1, (const int32_t[]){10}, further, &moved_one), ANNULUS_OK);
    CHECK(moved_one.asked == 1 && moved_one.changed > 0 && is_delaunay(mesh));
    CHECK_STATUS(annulus_periodic_changed(mesh, 0, NULL, NULL, &count), ANNULUS_OK);
    CHECK(moved_one.changed == count);
    CHECK_STATUS(annulus_periodic_move(mesh, 1, (const int32_t[]){1}, further, NULL), ANNULUS_UNKNOWN_VERTEX);
    CHECK_STATUS(annulus_periodic_move(mesh, 1, (const int32_t[]){11}, further, NULL), ANNULUS_DUPLICATE_POINT);
    CHECK_STATUS(annulus_periodic_move(mesh, 1, (const int32_t[]){10}, x + 10 * d, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_insert(mesh, 5, x + 30 * d, indices), ANNULUS_OK);
    CHECK(indices[0] == 7 && indices[1] == 20 && indices[2] == 1 && indices[3] == 30 && indices[4] == 31);
    CHECK_STATUS(annulus_periodic_move_all(mesh, 32, x, NULL, NULL), ANNULUS_OK);
    check_lists(mesh, d, volume);
    CHECK(is_delaunay(mesh));

    // A vertex is a corner of the cell that contains it, and the middle of the box is in one.
    int32_t found[2] = {-9, -9}, moved[6] = {0};
    double two[6];
    int corner = 0;
    memcpy(two, x + 3 * d, (size_t)d * sizeof *x);
    for (int c = 0; c < d; ++c) two[d + c] = c == 0 ? NAN : 0;
    CHECK_STATUS(annulus_periodic_find_cells(mesh, 2, two, found, moved), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_cells(mesh, most, vertices, NULL, NULL, NULL, &cells), ANNULUS_OK);
    CHECK(found[0] >= 0 && (size_t)found[0] < cells && found[1] == -1);
    for (int k = 0; k <= d; ++k)
        if (vertices[(d + 1) * found[0] + k] == 3) corner = 1;
    CHECK(corner);
    two[d] = INFINITY;
    CHECK_STATUS(annulus_periodic_find_cells(mesh, 2, two, found, NULL), ANNULUS_NOT_FINITE);
    CHECK_STATUS(annulus_periodic_find_cells(mesh, 1, two, NULL, NULL), ANNULUS_NULL_POINTER);

    // All or none.
    int32_t named[4] = {-9, -9, -9, -9};
    char why[200];
    for (int c = 0; c < d; ++c) x[33 * d + c] = x[12 * d + c] + box[c] - 2 * box[d + c];
    CHECK_STATUS(annulus_periodic_insert(mesh, 3, x + 32 * d, indices), ANNULUS_DUPLICATE_POINT);
    CHECK(annulus_periodic_error_vertices(mesh, 4, named) == 1 && named[0] == 12 && named[1] == -9);
    CHECK(annulus_periodic_message(mesh, why, sizeof why) > 0 && strstr(why, "vertex 12") != NULL);
    x[33 * d] = NAN;
    CHECK_STATUS(annulus_periodic_insert(mesh, 3, x + 32 * d, indices), ANNULUS_NOT_FINITE);
    CHECK(annulus_periodic_error_vertices(mesh, 4, named) == 1 && named[0] == 1);
    x[33 * d] = 1e40;
    CHECK_STATUS(annulus_periodic_insert(mesh, 3, x + 32 * d, indices), ANNULUS_OUT_OF_DOMAIN);
    const int32_t twice[3] = {4, 9, 4}, beyond[2] = {2, 32};
    CHECK_STATUS(annulus_periodic_remove(mesh, 3, twice), ANNULUS_UNKNOWN_VERTEX);
    CHECK_STATUS(annulus_periodic_remove(mesh, 2, beyond), ANNULUS_UNKNOWN_VERTEX);
    CHECK(annulus_periodic_error_vertices(mesh, 4, named) == 1 && named[0] == 32);
    CHECK_STATUS(annulus_periodic_move_all(mesh, 31, x, NULL, NULL), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_periodic_vertex_count(mesh, &count), ANNULUS_OK);
    CHECK(count == 32 && is_delaunay(mesh));
    annulus_periodic_destroy(&mesh);
}

static void check_refusals(void) {
    const double flat[9] = {1, 0, 0, 0, 1, 0, 1, 1, 0}, not_a_number[9] = {1, 0, 0, 0, NAN, 0, 0, 0, 1};
    double x[12];
    int32_t named[4];
    size_t count = 0;
    int answer = 0;
    annulus_options options = {0};
    annulus_report no_size = {0};
    annulus_audit_result no_size_either = {0};
    annulus_periodic* mesh = (annulus_periodic*)x;
    CHECK_STATUS(annulus_periodic_create(NULL, 3, 4, copper, cube, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_create(&mesh, 3, 4, NULL, cube, NULL), ANNULUS_NULL_POINTER);
    CHECK(mesh == NULL);
    CHECK_STATUS(annulus_periodic_create(&mesh, 3, 4, copper, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_create(&mesh, 4, 4, copper, cube, NULL), ANNULUS_USAGE);
    CHECK_STATUS(annulus_periodic_create(&mesh, 3, 4, copper, flat, NULL), ANNULUS_USAGE);
    CHECK_STATUS(annulus_periodic_create(&mesh, 3, 4, copper, not_a_number, NULL), ANNULUS_NOT_FINITE);
    CHECK_STATUS(annulus_periodic_create(&mesh, 3, 4, copper, cube, &options), ANNULUS_USAGE);
    options.size = sizeof options;
    options.strategy = "in-place";
    CHECK_STATUS(annulus_periodic_create(&mesh, 3, 4, copper, cube, &options), ANNULUS_USAGE);
    options.strategy = "tolerances";
    options.tolerance = "paper";
    CHECK_STATUS(annulus_periodic_create(&mesh, 3, 4, copper, cube, &options), ANNULUS_USAGE);
    options.tolerance = NULL;
    options.threads = -1;
    CHECK_STATUS(annulus_periodic_create(&mesh, 3, 4, copper, cube, &options), ANNULUS_USAGE);
    options.threads = 2;
    memcpy(x, copper, sizeof x);
    x[3] = 3;
    x[4] = -1;
    CHECK_STATUS(annulus_periodic_create(&mesh, 3, 4, x, cube, &options), ANNULUS_DUPLICATE_POINT);
    CHECK(annulus_periodic_error_vertices(NULL, 4, named) == 2 && named[0] == 0 && named[1] == 1);
    CHECK(annulus_error_vertices(NULL, 4, named) == 2 && mesh == NULL);
    CHECK(annulus_periodic_message(NULL, NULL, 0) > 0);
    options.merge_duplicates = 1;
    CHECK_STATUS(annulus_periodic_create(&mesh, 3, 4, x, cube, &options), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_vertex_count(mesh, &count), ANNULUS_OK);
    CHECK(count == 3);
    CHECK_STATUS(annulus_periodic_vertex_of_input(mesh, 0, NULL, &count), ANNULUS_OK);
    CHECK(count == 4);
    CHECK_STATUS(annulus_periodic_vertex_of_input(mesh, 3, named, &count), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_periodic_vertex_of_input(mesh, 4, named, &count), ANNULUS_OK);
    CHECK(named[0] == 0 && named[1] == 0 && named[2] == 1 && named[3] == 2);
    annulus_periodic_destroy(&mesh);
    options.merge_duplicates = 0;

    CHECK_STATUS(annulus_periodic_create(&mesh, 3, 4, copper, cube, &options), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_pairs_made(mesh, 0, NULL, NULL, NULL, &count), ANNULUS_USAGE);
    CHECK_STATUS(annulus_periodic_pairs_broken(mesh, 0, NULL, NULL, NULL, &count), ANNULUS_USAGE);
    CHECK_STATUS(annulus_periodic_changed(mesh, 0, NULL, NULL, &count), ANNULUS_USAGE);
    CHECK_STATUS(annulus_periodic_gone(mesh, 0, NULL, NULL, &count), ANNULUS_USAGE);
    CHECK_STATUS(annulus_periodic_move_all(mesh, 4, NULL, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_move_all(mesh, 4, copper, NULL, &no_size), ANNULUS_USAGE);
    CHECK_STATUS(annulus_periodic_move_all(mesh, 4, copper, flat, NULL), ANNULUS_USAGE);
    CHECK_STATUS(annulus_periodic_move_all(mesh, 4, x, NULL, NULL), ANNULUS_DUPLICATE_POINT);
    CHECK_STATUS(annulus_periodic_insert(mesh, 1, x, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_insert(mesh, 0, NULL, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_remove(mesh, 1, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_points(mesh, 3, x), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_periodic_voronoi(mesh, 3, x), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_periodic_voronoi(mesh, 4, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_voronoi_gradient(mesh, 3, x, x), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_periodic_voronoi_gradient(mesh, 4, NULL, x), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_voronoi_gradient(mesh, 4, x, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_recompute_tolerances(mesh, &no_size), ANNULUS_USAGE);
    CHECK_STATUS(annulus_periodic_recompute_tolerances(mesh, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_periodic_tolerances(mesh, 3, x), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_periodic_tolerances(mesh, 4, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_box(mesh, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_cells(mesh, 0, NULL, NULL, NULL, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_audit(mesh, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_audit(mesh, &no_size_either), ANNULUS_USAGE);
    CHECK_STATUS(annulus_periodic_dimension(NULL, &answer), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_index_bound(NULL, &count), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_vertex_count(mesh, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_periodic_is_vertex(mesh, 4, &answer), ANNULUS_OK);
    CHECK(answer == 0);
    CHECK(is_delaunay(mesh));
    annulus_periodic_destroy(&mesh);
}

// What docs/c.md shows.
static size_t room = 0;
static int32_t *i = NULL, *j = NULL, *shift = NULL;
static double* area = NULL;

static int simulate(double* x, double* box) {
    static int step = 0;
    for (int c = 0; c < 12; ++c) x[c] += 0.01 * (c % 5);
    box[3] += 0.01;
    return step++ < 5;
}

static void check_the_loop(void) {
    double x[12], box[9], volumes[4];
    size_t n = 4;
    memcpy(x, copper, sizeof x);
    memcpy(box, cube, sizeof box);
    // [docs]
    annulus_periodic* mesh = NULL; /* x: n points; box: three vectors, one after another */
    int status = annulus_periodic_create(&mesh, 3, n, x, box, NULL);
    while (status == ANNULUS_OK && simulate(x, box)) {
        size_t pairs = 0;
        status = annulus_periodic_move_all(mesh, n, x, box, NULL);
        if (status == ANNULUS_OK) status = annulus_periodic_voronoi(mesh, n, volumes);
        if (status == ANNULUS_OK) /* how many */
            status = annulus_periodic_neighbours(mesh, 0, NULL, NULL, NULL, NULL, NULL, NULL, &pairs);
        if (pairs > room) {
            room = 2 * pairs;
            i = realloc(i, room * sizeof *i);
            j = realloc(j, room * sizeof *j);
            shift = realloc(shift, 3 * room * sizeof *shift);
            area = realloc(area, room * sizeof *area);
        }
        if (status == ANNULUS_OK)
            status = annulus_periodic_neighbours(mesh, room, i, j, shift, NULL, NULL, area, &pairs);
    }
    char why[256] = "";
    if (status != ANNULUS_OK) annulus_periodic_message(mesh, why, sizeof why);
    annulus_periodic_destroy(&mesh);
    // [docs]
    CHECK(status == ANNULUS_OK && why[0] == 0 && room > 0);
    CHECK(fabs(volumes[0] + volumes[1] + volumes[2] + volumes[3] - 1) < 1e-9);
    free(i);
    free(j);
    free(shift);
    free(area);
}

int main(void) {
    check_the_loop();
    check_crystal();
    check_coming_and_going(2);
    check_coming_and_going(3);
    check_refusals();
    return verdict("periodic");
}
