// SPDX-License-Identifier: GPL-3.0-or-later
// The lists of what a call changed, with numbers that can be verified by hand: a flip in 2D, a vertex that comes and
// goes, buffers that are too small, points on a line.
#include "check.h"

#include <string.h>

static annulus_mesh* mesh_of(size_t count, const double* x) {
    annulus_mesh* mesh = NULL;
    annulus_options options = {0};
    options.size = sizeof options;
    options.report_changes = 1;
    CHECK_STATUS(annulus_create(&mesh, 2, count, x, &options), ANNULUS_OK);
    return mesh;
}

typedef int (*list_function)(const annulus_mesh*, size_t, int32_t*, size_t*);

static void check_list(const annulus_mesh* mesh, list_function list, int each, size_t wanted, const int32_t* numbers) {
    int32_t got[64] = {0};
    size_t count = 77;
    CHECK_STATUS(list(mesh, 0, NULL, &count), ANNULUS_OK);
    CHECK(count == wanted);
    CHECK_STATUS(list(mesh, wanted, got, &count), ANNULUS_OK);
    CHECK(count == wanted);
    if (numbers != NULL) CHECK(memcmp(got, numbers, wanted * (size_t)each * sizeof *got) == 0);
    if (wanted == 0) return;
    got[0] = -77;
    count = 77;
    CHECK_STATUS(list(mesh, wanted - 1, got, &count), ANNULUS_WRONG_SIZE);
    CHECK(count == wanted && got[0] == -77);
    CHECK_STATUS(list(mesh, wanted, NULL, &count), ANNULUS_NULL_POINTER);
}

// The corner 3 of a quadrilateral with the diagonal 0 3 moves away from 0, so that 1 2 becomes the diagonal.
static void check_flip(void) {
    const double x[8] = {0, 0, 4, 0, 0, 4, 3, 3};
    const double away[2] = {5, 5};
    const double back[2] = {3, 3};
    const int32_t vertex = 3;
    const int32_t short_one[2] = {0, 3};
    const int32_t long_one[2] = {1, 2};
    const int32_t there[4] = {0, 3, 1, 2};
    const int32_t and_back[4] = {1, 2, 0, 3};
    int32_t cells[6];
    size_t count = 0;
    annulus_mesh* mesh = mesh_of(4, x);
    check_list(mesh, annulus_gone, 3, 0, NULL);  // no call has changed it
    check_list(mesh, annulus_edges_made, 2, 0, NULL);
    check_list(mesh, annulus_edges_broken, 2, 0, NULL);
    check_list(mesh, annulus_t1, 4, 0, NULL);

    CHECK_STATUS(annulus_move(mesh, 1, &vertex, away, NULL), ANNULUS_OK);
    check_list(mesh, annulus_gone, 3, 2, NULL);
    check_list(mesh, annulus_edges_made, 2, 1, long_one);
    check_list(mesh, annulus_edges_broken, 2, 1, short_one);
    check_list(mesh, annulus_t1, 4, 1, there);
    CHECK_STATUS(annulus_gone(mesh, 2, cells, &count), ANNULUS_OK);
    for (int c = 0; c < 2; ++c) {  // 0 1 3 and 0 3 2, counter-clockwise, from any corner
        int at = 0;
        while (at < 3 && cells[3 * c + at] != 0) ++at;
        CHECK(at < 3);
        const int32_t second = cells[3 * c + (at + 1) % 3], third = cells[3 * c + (at + 2) % 3];
        CHECK((second == 1 && third == 3) || (second == 3 && third == 2));
    }
    CHECK_STATUS(annulus_move(mesh, 1, &vertex, back, NULL), ANNULUS_OK);
    check_list(mesh, annulus_edges_made, 2, 1, short_one);
    check_list(mesh, annulus_edges_broken, 2, 1, long_one);
    check_list(mesh, annulus_t1, 4, 1, and_back);
    CHECK_STATUS(annulus_move(mesh, 1, &vertex, back, NULL), ANNULUS_OK);  // nothing changes
    check_list(mesh, annulus_changed, 3, 0, NULL);
    check_list(mesh, annulus_gone, 3, 0, NULL);
    check_list(mesh, annulus_edges_made, 2, 0, NULL);
    check_list(mesh, annulus_edges_broken, 2, 0, NULL);
    check_list(mesh, annulus_t1, 4, 0, NULL);
    annulus_destroy(&mesh);
}

// The second point lies between the first one and vertex 0, which are neighbours for a moment only.
static void check_vertices(void) {
    const double x[6] = {0, 0, 8, 0, 0, 8};
    const double inside[4] = {2, 2, 1, 1};
    const int32_t made[10] = {0, 4, 1, 3, 1, 4, 2, 3, 2, 4};
    const int32_t pair[2] = {3, 4};
    int32_t indices[2];
    int32_t list[12];
    size_t count = 0;
    annulus_mesh* mesh = mesh_of(3, x);
    CHECK_STATUS(annulus_insert(mesh, 2, inside, indices, NULL, NULL), ANNULUS_OK);
    CHECK(indices[0] == 3 && indices[1] == 4);
    check_list(mesh, annulus_edges_made, 2, 6, NULL);
    CHECK_STATUS(annulus_edges_made(mesh, 6, list, &count), ANNULUS_OK);
    CHECK(memcmp(list, made, sizeof made) == 0 && memcmp(list + 10, pair, sizeof pair) == 0);
    check_list(mesh, annulus_edges_broken, 2, 0, NULL);
    CHECK_STATUS(annulus_remove(mesh, 2, indices, NULL, NULL), ANNULUS_OK);
    check_list(mesh, annulus_edges_made, 2, 0, NULL);
    check_list(mesh, annulus_edges_broken, 2, 6, list);
    annulus_destroy(&mesh);
}

static void check_line(void) {
    const double x[6] = {0, 0, 1, 0, 2, 0};
    const double jump[2] = {3, 0};
    const int32_t vertex = 0;
    const int32_t broken[2] = {0, 1};
    const int32_t made[2] = {0, 2};
    int32_t cells[6];
    size_t count = 0;
    annulus_mesh* mesh = mesh_of(3, x);
    CHECK_STATUS(annulus_move(mesh, 1, &vertex, jump, NULL), ANNULUS_OK);
    check_list(mesh, annulus_edges_made, 2, 1, made);
    check_list(mesh, annulus_edges_broken, 2, 1, broken);
    check_list(mesh, annulus_gone, 3, 2, NULL);
    CHECK_STATUS(annulus_gone(mesh, 2, cells, &count), ANNULUS_OK);
    CHECK(cells[2] == -2 && cells[5] == -2);
    annulus_destroy(&mesh);
}

int main(void) {
    check_flip();
    check_vertices();
    check_line();
    return verdict("changes");
}
