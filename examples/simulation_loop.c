/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The loop of docs/c.md: a simulation in C99 that computes volumes, neighbours and cells at each step. */
#include <annulus/annulus.h>

#include <stdio.h>
#include <stdlib.h>

enum { n = 500, active_count = 20, steps = 10 };

static double x[3 * n], new_positions[3 * active_count], volume[n];
static int32_t active[active_count], neighbour_counts[n];

/* What the simulation does: some particles go a little. */
static void simulate(int step) {
    for (int i = 0; i < active_count; ++i) {
        active[i] = (step + i * (n / active_count)) % n;
        for (int k = 0; k < 3; ++k) new_positions[3 * i + k] = x[3 * active[i] + k] += 1e-3 * rand() / RAND_MAX;
    }
}

int main(void) {
    int32_t *vertices = NULL, *neighbours = NULL;
    size_t room = 0;
    for (int i = 0; i < 3 * n; ++i) x[i] = rand() / (RAND_MAX + 1.0);
    /* [docs] */
    annulus_mesh* mesh = NULL;
    int status = annulus_create(&mesh, 3, n, x, NULL);
    for (int step = 0; step < steps && status == ANNULUS_OK; ++step) {
        simulate(step);
        status =
            annulus_move(mesh, active_count, active, new_positions, NULL); /* or annulus_move_all(mesh, n, x, NULL) */
        if (status == ANNULUS_OK) status = annulus_voronoi(mesh, n, volume, neighbour_counts);
        size_t cells = 0;
        if (status == ANNULUS_OK) status = annulus_cells(mesh, 0, NULL, NULL, &cells); /* how many */
        if (cells > room) {                                                            /* four numbers for each */
            room = 2 * cells;
            vertices = realloc(vertices, 4 * room * sizeof *vertices);
            neighbours = realloc(neighbours, 4 * room * sizeof *neighbours);
            if (vertices == NULL || neighbours == NULL) return 1;
        }
        if (status == ANNULUS_OK) status = annulus_cells(mesh, room, vertices, neighbours, &cells);
    }
    char why[256] = "";
    if (status != ANNULUS_OK) annulus_message(mesh, why, sizeof why); /* in words */
    annulus_destroy(&mesh);
    /* [docs] */
    if (status != ANNULUS_OK) fprintf(stderr, "annulus: %s\n", why);
    free(vertices);
    free(neighbours);
    return status != ANNULUS_OK;
}
