// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of several threads, one mesh that several threads read, and programs whose floating-point exceptions trap.
#if defined(__linux__)
#define _GNU_SOURCE  // feenableexcept
#endif
#include "check.h"

#include <fenv.h>
#include <pthread.h>
#include <string.h>

enum { n = 400, readers = 4 };

static int failed(int status) { return status != ANNULUS_OK; }

// Uses its own mesh, and its own error message. Returns the number of failures: checks are counted in one thread.
static void* moves(void* seed) {
    static int wrong;
    uint64_t state = *(const uint64_t*)seed;
    double x[3 * n];
    char text[80];
    annulus_mesh* mesh = NULL;
    annulus_audit_result audit = {0};
    int faults = 0;
    audit.size = sizeof audit;
    for (int i = 0; i < 3 * n; ++i) x[i] = uniform(&state);
    faults += failed(annulus_create(&mesh, 3, n, x, NULL));
    for (int step = 0; step < 10; ++step) {
        for (int i = 0; i < 3 * n; ++i) x[i] += 0.01 * (uniform(&state) - 0.5);
        faults += failed(annulus_move_all(mesh, n, x, NULL));
    }
    faults += failed(annulus_audit(mesh, &audit)) || !audit.delaunay;
    annulus_destroy(&mesh);
    faults += annulus_create(&mesh, 100 + (int)(state % 800), 0, NULL, NULL) != ANNULUS_USAGE;
    faults += annulus_message(NULL, text, sizeof text) == 0;
    faults += strstr(text, "dimension") == NULL;
    faults += mesh != NULL;
    return faults == 0 ? NULL : &wrong;
}

static void* reads(void* given) {
    static int wrong;
    const annulus_mesh* mesh = given;
    double volumes[n];
    double lengths[n];
    int32_t counts[n];
    char text[80];
    size_t count = 0;
    int faults = 0;
    for (int k = 0; k < 20; ++k) {
        faults += failed(annulus_voronoi(mesh, n, volumes, counts));
        faults += failed(annulus_cells(mesh, 0, NULL, NULL, &count)) || count < n;
        faults += failed(annulus_tolerances(mesh, n, lengths));
        faults += annulus_points(mesh, 1, lengths) != ANNULUS_WRONG_SIZE;  // all threads write an error message
        faults += annulus_message(mesh, text, sizeof text) != strlen(text);
        faults += strcmp(text, "there is room for 1 of 400 vertices") != 0;
    }
    return faults == 0 ? NULL : &wrong;
}

int main(void) {
    pthread_t thread[readers];
    uint64_t seeds[readers] = {1, 2, 3, 4};
    uint64_t state = 9;
    double x[3 * n];
    double volumes[n];
    void* fault = NULL;
    annulus_mesh* mesh = NULL;
    annulus_audit_result audit = {0};
    audit.size = sizeof audit;

    for (int k = 0; k < readers; ++k) CHECK(pthread_create(&thread[k], NULL, moves, &seeds[k]) == 0);
    for (int k = 0; k < readers; ++k) {
        CHECK(pthread_join(thread[k], &fault) == 0);
        CHECK(fault == NULL);
    }

    for (int i = 0; i < 3 * n; ++i) x[i] = uniform(&state);
    CHECK_STATUS(annulus_create(&mesh, 3, n, x, NULL), ANNULUS_OK);
    for (int step = 0; step < 3; ++step) {
        for (int k = 0; k < readers; ++k) CHECK(pthread_create(&thread[k], NULL, reads, mesh) == 0);
        for (int k = 0; k < readers; ++k) {
            CHECK(pthread_join(thread[k], &fault) == 0);
            CHECK(fault == NULL);
        }
        for (int i = 0; i < 3 * n; ++i) x[i] += 0.01 * (uniform(&state) - 0.5);
        CHECK_STATUS(annulus_move_all(mesh, n, x, NULL), ANNULUS_OK);
    }

#if defined(__GLIBC__) && (defined(__x86_64__) || defined(__i386__))
    // A program that enables traps is not stopped by exceptions inside the library: flat cells and huge coordinates
    // overflow, and are computed exactly.
    feclearexcept(FE_ALL_EXCEPT);
    CHECK(feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW | FE_UNDERFLOW | FE_INEXACT) != -1);
    x[0] = 0x1p499;
    x[3] = 0x1p-1060;
    x[4] = -0x1p300;
    CHECK_STATUS(annulus_move_all(mesh, n, x, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_voronoi(mesh, n, volumes, NULL), ANNULUS_OK);
    CHECK_STATUS(annulus_tolerances(mesh, n, volumes), ANNULUS_OK);
    CHECK_STATUS(annulus_audit(mesh, &audit), ANNULUS_OK);
    CHECK(fegetexcept() == (FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW | FE_UNDERFLOW | FE_INEXACT));
    fedisableexcept(FE_ALL_EXCEPT);
    CHECK(audit.delaunay == 1);
#else
    (void)volumes;
#endif
    annulus_destroy(&mesh);
    return verdict("threads and traps");
}
