// SPDX-License-Identifier: GPL-3.0-or-later
// Arguments that the C interface refuses, leaving the mesh unchanged: sizes, names, indices, positions,
// environments.
#include "a_mesh.h"
#include "check.h"

#include <annulus/version.h>

#include <fenv.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static void check_sizes_and_names(void) {
    double x[3 * points + 3] = {0};
    int32_t numbers[points];
    size_t count = 0;
    annulus_mesh* mesh = NULL;
    annulus_options options = {0};
    annulus_report report = {0};
    annulus_audit_result audit = {0};
    struct {
        annulus_options known;
        int64_t later;
    } longer;

    CHECK_STATUS(annulus_create(&mesh, 1, 1, x, NULL), ANNULUS_USAGE);
    CHECK_STATUS(annulus_create(&mesh, 4, 1, x, NULL), ANNULUS_USAGE);
    CHECK_STATUS(annulus_create(&mesh, 2, SIZE_MAX, x, NULL), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_create(&mesh, 2, SIZE_MAX / 16, x, NULL), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_create(&mesh, 2, 1, x, &options), ANNULUS_USAGE);  // size is 0
    options.size = sizeof options;
    options.strategy = "fastest";
    CHECK_STATUS(annulus_create(&mesh, 2, 1, x, &options), ANNULUS_USAGE);
    options.strategy = "tolerances";
    options.tolerance = "Certified";
    CHECK_STATUS(annulus_create(&mesh, 2, 1, x, &options), ANNULUS_USAGE);
    options.tolerance = NULL;
    options.second_look = "";
    CHECK_STATUS(annulus_create(&mesh, 2, 1, x, &options), ANNULUS_USAGE);
    options.second_look = "unequal";
    CHECK_STATUS(annulus_create(&mesh, 2, 1, x, &options), ANNULUS_USAGE);
    options.second_look = "off";
    options.threads = -1;
    CHECK_STATUS(annulus_create(&mesh, 2, 1, x, &options), ANNULUS_USAGE);
    options.threads = 2;
    options.reserved = 1;
    CHECK_STATUS(annulus_create(&mesh, 2, 1, x, &options), ANNULUS_USAGE);
    options.reserved = 0;
    CHECK(mesh == NULL);

    // A caller that is newer than the library: members that the library does not have must be 0.
    memset(&longer, 0, sizeof longer);
    longer.known = options;
    longer.known.size = sizeof longer;
    longer.later = 1;
    CHECK_STATUS(annulus_create(&mesh, 2, 1, x, &longer.known), ANNULUS_USAGE);
    longer.later = 0;
    CHECK_STATUS(annulus_create(&mesh, 2, 1, x, &longer.known), ANNULUS_OK);
    annulus_destroy(&mesh);
    // A caller that is older: members that it does not have take their defaults.
    options.size = offsetof(annulus_options, tolerance);
    options.tolerance = "not looked at";
    CHECK_STATUS(annulus_create(&mesh, 2, 1, x, &options), ANNULUS_OK);
    annulus_destroy(&mesh);

    mesh = a_mesh(3, NULL);
    CHECK_STATUS(annulus_points(mesh, points, x), ANNULUS_OK);
    CHECK_STATUS(annulus_move_all(mesh, points - 1, x, NULL), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_move_all(mesh, points + 1, x, NULL), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_move_all(mesh, SIZE_MAX - 1, x, NULL), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_move_all(mesh, points, x, &report), ANNULUS_USAGE);  // size is 0
    report.size = sizeof report;
    report.cost = -1;
    CHECK_STATUS(annulus_move_all(mesh, points, x, &report), ANNULUS_OK);
    CHECK(report.asked == points && report.size == sizeof report && report.cost >= 0);
    report.size = offsetof(annulus_report, within_tolerance);
    report.asked = 0;
    report.within_tolerance = 1234;
    CHECK_STATUS(annulus_move_all(mesh, points, x, &report), ANNULUS_OK);
    CHECK(report.asked == points && report.within_tolerance == 1234);
    CHECK_STATUS(annulus_points(mesh, points - 1, x), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_tolerances(mesh, 0, NULL), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_displacements(mesh, points - 1, x), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_voronoi(mesh, points - 1, x, numbers), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_vertex_of_input(mesh, points - 1, numbers, &count), ANNULUS_WRONG_SIZE);
    CHECK(count == points);
    CHECK_STATUS(annulus_vertex_of_input(mesh, 0, NULL, &count), ANNULUS_OK);
    numbers[0] = -77;
    CHECK_STATUS(annulus_cells(mesh, points / 4, numbers, NULL, &count), ANNULUS_WRONG_SIZE);
    CHECK(count > points / 4 && numbers[0] == -77);
    CHECK_STATUS(annulus_cells(mesh, 0, numbers, NULL, &count), ANNULUS_WRONG_SIZE);
    CHECK_STATUS(annulus_changed(mesh, 0, NULL, &count), ANNULUS_USAGE);
    CHECK_STATUS(annulus_gone(mesh, 0, NULL, &count), ANNULUS_USAGE);
    CHECK_STATUS(annulus_edges_made(mesh, 0, NULL, &count), ANNULUS_USAGE);
    CHECK_STATUS(annulus_edges_broken(mesh, 0, NULL, &count), ANNULUS_USAGE);
    CHECK_STATUS(annulus_t1(mesh, 0, NULL, &count), ANNULUS_USAGE);
    CHECK_STATUS(annulus_audit(mesh, &audit), ANNULUS_USAGE);
    audit.size = sizeof audit;
    CHECK_STATUS(annulus_audit(mesh, &audit), ANNULUS_OK);
    CHECK(audit.delaunay == 1 && audit.first_fault[0] == 0);
    annulus_destroy(&mesh);
}

// After each refusal positions, cells and indices are unchanged.
static void check_indices_and_positions(int dimension) {
    const double far_out = 0x1p501;
    const int32_t bad[] = {-1, -2, INT32_MIN, points, INT32_MAX, 5};
    double before[3 * points] = {0};
    double x[3 * points + 3];
    double after[3 * points] = {0};
    int32_t indices[3] = {1, 2, 1};
    int answer = 77;
    size_t count = 77;
    annulus_audit_result audit = {0};
    const double origin[6] = {0};
    int32_t named[2] = {77, 77};
    char text[80];
    annulus_mesh* mesh = a_mesh(dimension, NULL);
    annulus_mesh* other = NULL;
    const size_t d = (size_t)dimension;

    CHECK(annulus_message_vertices(mesh, named) == 0 && named[0] == 77);
    CHECK_STATUS(annulus_remove(mesh, 1, &bad[5], &count, NULL), ANNULUS_OK);  // 5 is free now
    CHECK(count == 1);
    CHECK_STATUS(annulus_points(mesh, points, before), ANNULUS_OK);
    CHECK(before[5 * d] != before[5 * d]);
    memcpy(x, before, sizeof before);
    for (int k = 0; k < 6; ++k) {
        CHECK_STATUS(annulus_move(mesh, 1, &bad[k], x, NULL), ANNULUS_UNKNOWN_VERTEX);
        indices[2] = bad[k];
        CHECK_STATUS(annulus_remove(mesh, 3, indices, &count, NULL), ANNULUS_UNKNOWN_VERTEX);
        CHECK(count == 0);
        CHECK_STATUS(annulus_is_vertex(mesh, bad[k], &answer), ANNULUS_OK);
        CHECK(answer == 0);
    }
    indices[2] = 1;
    CHECK_STATUS(annulus_remove(mesh, 3, indices, NULL, NULL), ANNULUS_UNKNOWN_VERTEX);
    CHECK(annulus_message_vertices(mesh, named) == 1);
    CHECK_STATUS(annulus_is_vertex(mesh, 1, &answer), ANNULUS_OK);
    CHECK(answer == 1);

    x[3 * d] = NAN;
    CHECK_STATUS(annulus_move_all(mesh, points, x, NULL), ANNULUS_NOT_FINITE);
    CHECK(annulus_message_vertices(mesh, named) == 1 && named[0] == 3);
    CHECK_STATUS(annulus_insert(mesh, 4, x, indices, &count, NULL), ANNULUS_NOT_FINITE);
    CHECK(annulus_message_vertices(mesh, named) == 1 && named[0] == 3);
    CHECK(count == 0);
    x[3 * d] = -INFINITY;
    CHECK_STATUS(annulus_move_all(mesh, points, x, NULL), ANNULUS_NOT_FINITE);
    x[3 * d] = far_out;
    CHECK_STATUS(annulus_move_all(mesh, points, x, NULL), ANNULUS_OUT_OF_DOMAIN);
    memcpy(x + 3 * d, x + 7 * d, d * sizeof *x);
    CHECK_STATUS(annulus_move_all(mesh, points, x, NULL), ANNULUS_DUPLICATE_POINT);
    CHECK(annulus_message_vertices(mesh, named) == 2 && named[0] == 3 && named[1] == 7);
    CHECK_STATUS(annulus_create(&other, dimension, points, x, NULL), ANNULUS_NOT_FINITE);
    CHECK(annulus_message_vertices(NULL, named) == 1 && named[0] == 5);
    CHECK_STATUS(annulus_create(&other, dimension, 2, origin, NULL), ANNULUS_DUPLICATE_POINT);
    CHECK(annulus_message_vertices(NULL, named) == 2 && named[0] == 0 && named[1] == 1);
    indices[0] = 3;
    CHECK_STATUS(annulus_move(mesh, 1, indices, x + 7 * d, NULL), ANNULUS_DUPLICATE_POINT);
    CHECK(annulus_message_vertices(mesh, named) == 2 && named[0] == 3 && named[1] == 7);
    CHECK(annulus_message_vertices(mesh, NULL) == 2);
    CHECK(annulus_message(mesh, text, sizeof text) > 0);
    CHECK(strcmp(text, "vertices 3 and 7 would have the same position") == 0);

    CHECK_STATUS(annulus_points(mesh, points, after), ANNULUS_OK);
    CHECK(memcmp(before, after, d * points * sizeof *after) == 0);
    audit.size = sizeof audit;
    CHECK_STATUS(annulus_audit(mesh, &audit), ANNULUS_OK);
    CHECK(audit.delaunay == 1);

    // The second of three is where a vertex is: the first stays, at the index that was free.
    x[0] = 3.5;
    memcpy(x + d, x + 7 * d, d * sizeof *x);
    CHECK_STATUS(annulus_insert(mesh, 3, x, indices, &count, NULL), ANNULUS_DUPLICATE_POINT);
    CHECK(count == 1 && indices[0] == 5);
    CHECK(annulus_message_vertices(mesh, named) == 1 && named[0] == 7);
    CHECK_STATUS(annulus_vertex_count(mesh, &count), ANNULUS_OK);
    CHECK(count == points);
    CHECK_STATUS(annulus_audit(mesh, &audit), ANNULUS_OK);
    CHECK(audit.delaunay == 1);
    annulus_destroy(&mesh);
}

static void check_environment(void) {
    double x[3 * points];
    double lengths[points];
    int32_t index = 0;
    size_t count = 0;
    annulus_mesh* mesh = a_mesh(3, NULL);
    annulus_mesh* other = NULL;
    annulus_audit_result audit = {0};
    audit.size = sizeof audit;
    CHECK_STATUS(annulus_points(mesh, points, x), ANNULUS_OK);
    const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    for (int k = 0; k < 3; ++k) {
        fesetround(modes[k]);
        CHECK_STATUS(annulus_create(&other, 3, points, x, NULL), ANNULUS_ENVIRONMENT);
        CHECK_STATUS(annulus_move_all(mesh, points, x, NULL), ANNULUS_ENVIRONMENT);
        CHECK_STATUS(annulus_move(mesh, 1, &index, x, NULL), ANNULUS_ENVIRONMENT);
        CHECK_STATUS(annulus_insert(mesh, 1, x, &index, NULL, NULL), ANNULUS_ENVIRONMENT);
        CHECK_STATUS(annulus_remove(mesh, 1, &index, NULL, NULL), ANNULUS_ENVIRONMENT);
        CHECK_STATUS(annulus_recompute_tolerances(mesh, NULL), ANNULUS_ENVIRONMENT);
        CHECK_STATUS(annulus_tolerances(mesh, points, lengths), ANNULUS_ENVIRONMENT);
        CHECK_STATUS(annulus_displacements(mesh, points, lengths), ANNULUS_ENVIRONMENT);
        CHECK_STATUS(annulus_voronoi(mesh, points, lengths, NULL), ANNULUS_ENVIRONMENT);
        CHECK(fegetround() == modes[k]);
        fesetround(FE_TONEAREST);
    }
    CHECK(other == NULL);
    CHECK_STATUS(annulus_move_all(mesh, points, x, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_audit(mesh, &audit), ANNULUS_OK);
    CHECK(audit.delaunay == 1);

    // The caller's floating-point flags are unchanged.
    feclearexcept(FE_ALL_EXCEPT);
    x[0] += 1.0 / 3.0;
    feclearexcept(FE_ALL_EXCEPT);
    feraiseexcept(FE_DIVBYZERO);
    CHECK_STATUS(annulus_move_all(mesh, points, x, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_voronoi(mesh, points, lengths, NULL), ANNULUS_OK);
    CHECK(fetestexcept(FE_ALL_EXCEPT) == FE_DIVBYZERO);
    feclearexcept(FE_ALL_EXCEPT);
    CHECK_STATUS(annulus_cells(mesh, 0, NULL, NULL, &count), ANNULUS_OK);
    annulus_destroy(&mesh);
}

int main(void) {
    check_sizes_and_names();
    check_indices_and_positions(2);
    check_indices_and_positions(3);
    check_environment();
    CHECK(strcmp(annulus_status_name(ANNULUS_DUPLICATE_POINT), "duplicate point") == 0);
    CHECK(strcmp(annulus_status_name(-5), "unknown status") == 0);
    CHECK(annulus_interface() == ANNULUS_INTERFACE);
    CHECK(strcmp(annulus_version(), ANNULUS_VERSION_STRING) == 0);
    char numbers[40];
    snprintf(numbers, sizeof numbers, "%d.%d.%d", ANNULUS_VERSION_MAJOR, ANNULUS_VERSION_MINOR, ANNULUS_VERSION_PATCH);
    CHECK(strcmp(numbers, ANNULUS_VERSION_STRING) == 0);
    CHECK(ANNULUS_VERSION / 10000 == ANNULUS_VERSION_MAJOR && ANNULUS_VERSION % 100 == ANNULUS_VERSION_PATCH);
    return verdict("refusals");
}
