// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/annulus.h>

#include <stdio.h>

int main(void) {
    const double x[] = {0, 0, 4, 0, 0, 4, 3, 3, 1, 1};
    const double there[] = {2, 1};
    const int32_t last = 4;
    size_t cells = 0;
    double areas[5];
    annulus_mesh* mesh = NULL;
    int wrong = annulus_create(&mesh, 2, 5, x, NULL) != ANNULUS_OK;
    wrong = wrong || annulus_move(mesh, 1, &last, there, NULL) != ANNULUS_OK;
    wrong = wrong || annulus_cells(mesh, 0, NULL, NULL, &cells) != ANNULUS_OK || cells != 4;
    wrong = wrong || annulus_voronoi(mesh, 5, areas, NULL) != ANNULUS_OK || !(areas[4] > 0 && areas[4] < 16);
    annulus_destroy(&mesh);
    printf("c-consumer: %s\n", wrong ? "wrong" : "right");
    return wrong;
}
