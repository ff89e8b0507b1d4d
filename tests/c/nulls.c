// SPDX-License-Identifier: GPL-3.0-or-later
// NULL pointers, which the C interface refuses, leaving the mesh unchanged.
#include "a_mesh.h"
#include "check.h"

#include <string.h>

static void check_null(void) {
    const double x[4] = {0, 0, 1, 0};
    const int32_t index = 0;
    double place[3 * points];
    int32_t numbers[points];
    size_t count = 77;
    int answer = 77;
    char text[64];
    annulus_mesh* none = NULL;
    annulus_mesh* mesh = a_mesh(2, NULL);

    CHECK_STATUS(annulus_create(NULL, 2, 2, x, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_create(&none, 2, 2, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK(none == NULL);
    CHECK(annulus_message(NULL, text, sizeof text) == strlen("coordinates is NULL"));
    CHECK(strcmp(text, "coordinates is NULL") == 0);

    CHECK_STATUS(annulus_move_all(NULL, 2, x, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_move(NULL, 1, &index, x, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_insert(NULL, 1, x, numbers, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_remove(NULL, 1, &index, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_recompute_tolerances(NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_dimension(NULL, &answer), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_affine_dimension(NULL, &answer), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_vertex_count(NULL, &count), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_index_bound(NULL, &count), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_is_vertex(NULL, 0, &answer), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_points(NULL, points, place), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_tolerances(NULL, points, place), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_displacements(NULL, points, place), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_voronoi(NULL, points, place, numbers), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_vertex_of_input(NULL, points, numbers, &count), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_cells(NULL, 0, NULL, NULL, &count), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_changed(NULL, 0, NULL, &count), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_gone(NULL, 0, NULL, &count), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_edges_made(NULL, 0, NULL, &count), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_edges_broken(NULL, 0, NULL, &count), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_t1(NULL, 0, NULL, &count), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_audit(NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_strategy(NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK(count == 77 && answer == 77);

    CHECK_STATUS(annulus_move_all(mesh, points, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_move(mesh, 1, NULL, x, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_move(mesh, 1, &index, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_insert(mesh, 1, NULL, numbers, &count, NULL), ANNULUS_NULL_POINTER);
    CHECK(count == 0);
    CHECK_STATUS(annulus_insert(mesh, 1, x, NULL, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_remove(mesh, 1, NULL, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_dimension(mesh, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_vertex_count(mesh, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_is_vertex(mesh, 0, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_strategy(mesh, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_points(mesh, points, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_voronoi(mesh, points, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_cells(mesh, 0, NULL, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_cells(mesh, 1000, NULL, NULL, &count), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_gone(mesh, 0, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_edges_made(mesh, 0, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_edges_broken(mesh, 0, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_t1(mesh, 0, NULL, NULL), ANNULUS_NULL_POINTER);
    CHECK_STATUS(annulus_audit(mesh, NULL), ANNULUS_NULL_POINTER);
    CHECK(annulus_message(mesh, NULL, 0) == strlen("result is NULL"));
    CHECK(annulus_message(mesh, text, 4) == strlen("result is NULL"));
    CHECK(strcmp(text, "res") == 0);

    // NULL is allowed for empty arrays.
    CHECK_STATUS(annulus_move(mesh, 0, NULL, NULL, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_insert(mesh, 0, NULL, NULL, NULL, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_remove(mesh, 0, NULL, NULL, NULL), ANNULUS_OK);
    annulus_destroy(NULL);
    annulus_destroy(&none);
    annulus_destroy(&mesh);
    CHECK(mesh == NULL);
    annulus_destroy(&mesh);
    CHECK_STATUS(annulus_recompute_tolerances(mesh, NULL), ANNULUS_NULL_POINTER);
}

int main(void) {
    check_null();
    return verdict("nulls");
}
