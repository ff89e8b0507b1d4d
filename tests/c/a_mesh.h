// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A mesh of random points.
#include "check.h"

enum { points = 40 };

static annulus_mesh* a_mesh(int dimension, const annulus_options* options) {
    uint64_t state = 7;
    double x[3 * points];
    annulus_mesh* mesh = NULL;
    for (int i = 0; i < 3 * points; ++i) x[i] = uniform(&state);
    CHECK_STATUS(annulus_create(&mesh, dimension, points, x, options), ANNULUS_OK);
    return mesh;
}
