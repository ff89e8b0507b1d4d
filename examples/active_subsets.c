/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [c.md] A gas of particles in C99, each with a time step of its own: fast ones move in every substep, slow ones rest
   until it is their turn. */
#include <annulus/annulus.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { particles = 2000, levels = 4, steps = 3 };

static annulus_mesh* mesh = NULL;

/* Every call says how it went; what went wrong is kept with the mesh. */
static void must(int status) {
    char why[256];
    if (status == ANNULUS_OK) return;
    annulus_message(mesh, why, sizeof why);
    fprintf(stderr, "annulus: %s: %s\n", annulus_status_name(status), why);
    annulus_destroy(&mesh);
    exit(1);
}

int main(void) {
    static double x[3 * particles], v[3 * particles], volume[particles], there[3 * particles];
    static int32_t active[particles], neighbours[particles];
    annulus_options options = {0};
    annulus_report report = {0};
    annulus_audit_result audit = {0};
    size_t cells = 0;
    options.size = sizeof options; /* what is 0 has its default */
    options.threads = 2;
    report.size = sizeof report;
    audit.size = sizeof audit;

    srand(1);
    for (int i = 0; i < 3 * particles; ++i) {
        x[i] = rand() / (RAND_MAX + 1.0);
        /* Particle i is of level i % levels: half as fast, and moved half as often, as those one level below. */
        v[i] = (2.0 * rand() / (RAND_MAX + 1.0) - 1.0) / (1 << i / 3 % levels);
    }
    must(annulus_create(&mesh, 3, particles, x, &options));

    const double dt = 0.002;
    for (int substep = 1; substep <= steps << (levels - 1); ++substep) {
        size_t count = 0;
        for (int i = 0; i < particles; ++i) {
            const int every = 1 << i % levels;
            if (substep % every != 0) continue;
            for (int k = 0; k < 3; ++k) there[3 * count + (size_t)k] = x[3 * i + k] += every * dt * v[3 * i + k];
            active[count++] = i;
        }
        must(annulus_move(mesh, count, active, there, &report)); /* at the cost of those that move */
        if (substep % (1 << (levels - 1)) != 0) continue;

        /* All are at one time: densities, from Voronoi cells; those at the border have none. */
        double least = INFINITY, greatest = 0;
        must(annulus_voronoi(mesh, particles, volume, neighbours));
        for (int i = 0; i < particles; ++i) {
            if (isinf(volume[i])) continue;
            least = fmin(least, 1 / volume[i]);
            greatest = fmax(greatest, 1 / volume[i]);
        }
        must(annulus_cells(mesh, 0, NULL, NULL, &cells));
        printf("substep %d: %lu moved, %lu flips; %lu cells, densities from %.3g to %.3g\n", substep,
               (unsigned long)report.asked, (unsigned long)report.flips, (unsigned long)cells, least, greatest);
    }
    must(annulus_audit(mesh, &audit));
    printf("Delaunay: %s\n", audit.delaunay ? "yes" : audit.first_fault);
    annulus_destroy(&mesh);
    return audit.delaunay ? 0 : 1;
}
/* [c.md] */
