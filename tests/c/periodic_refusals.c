// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of options that there are not in a periodic box, and of points that are images of one another.
#include "check.h"

#include <string.h>

static const double cube[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
static const double copper[12] = {0, 0, 0, .5, .5, 0, .5, 0, .5, 0, .5, .5};

static const char* message_of(const annulus_periodic* mesh) {
    static char text[400];
    CHECK(annulus_periodic_message(mesh, text, sizeof text) < sizeof text);
    return text;
}

// Names that there are are taken, and listed where another one is given.
static void check_options(void) {
    static const char no_strategy[] = "there is no strategy in a periodic box \"%\"; there are auto, signs, tolerances";
    static const char no_kind[] = "there is no kind of tolerance in a periodic box \"%\"; there is certified";
    static const struct {
        const char* strategy;
        const char* tolerance;
        const char* words;  // of the error, % for the name that is given
    } table[] = {
        {NULL, NULL, NULL},
        {"auto", NULL, NULL},
        {"signs", "certified", NULL},
        {"tolerances", NULL, NULL},
        {"rebuild", NULL, no_strategy},
        {"tolerances-each", NULL, no_strategy},
        {"in-place", NULL, no_strategy},
        {"paper", "paper", no_strategy},
        {"paper-hybrid", NULL, no_strategy},
        {"relocate", NULL, no_strategy},
        {"relocate-flips", NULL, no_strategy},
        {"fastest", NULL, no_strategy},
        {"", NULL, no_strategy},
        {NULL, "paper", no_kind},
        {"signs", "floating", no_kind},
        {NULL, "Certified", no_kind},
    };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; ++k) {
        annulus_options options = {0};
        annulus_periodic* mesh = NULL;
        char expected[400];
        options.size = sizeof options;
        options.strategy = table[k].strategy;
        options.tolerance = table[k].tolerance;
        const int status = annulus_periodic_create(&mesh, 3, 4, copper, cube, &options);
        CHECK_STATUS(status, table[k].words == NULL ? ANNULUS_OK : ANNULUS_USAGE);
        CHECK((mesh != NULL) == (table[k].words == NULL));
        if (table[k].words != NULL) {
            const char* name = table[k].words == no_kind ? table[k].tolerance : table[k].strategy;
            const char* at = strchr(table[k].words, '%');
            snprintf(expected, sizeof expected, "%.*s%s%s", (int)(at - table[k].words), table[k].words, name, at + 1);
            CHECK(strcmp(message_of(NULL), expected) == 0);
        }
        annulus_periodic_destroy(&mesh);
    }
}

// The same words and vertices, by a build and by every move; of all that coincide the lowest.
static void check_duplicates(void) {
    static const char words[] = "points 0 and 3 have, up to vectors of the box, the same position";
    const int32_t indices[3] = {3, 1, 2};
    double x[12], moved[9];
    int32_t named[4];
    annulus_periodic* mesh = NULL;
    memcpy(x, copper, sizeof x);
    for (int c = 0; c < 3; ++c) {
        x[3 + c] = x[6 + c] - 1;  // 1 and 2
        x[9 + c] = x[c] + 2;      // 0 and 3
    }
    memcpy(moved, x + 9, 3 * sizeof *x);
    memcpy(moved + 3, x + 3, 3 * sizeof *x);
    memcpy(moved + 6, x + 6, 3 * sizeof *x);
    CHECK_STATUS(annulus_periodic_create(&mesh, 3, 4, x, cube, NULL), ANNULUS_DUPLICATE_POINT);
    CHECK(strcmp(message_of(NULL), words) == 0);
    CHECK_STATUS(annulus_periodic_create(&mesh, 3, 4, copper, cube, NULL), ANNULUS_OK);
    for (int call = 0; call < 3; ++call) {
        CHECK_STATUS(call == 2 ? annulus_periodic_move(mesh, 3, indices, moved, NULL)
                               : annulus_periodic_move_all(mesh, 4, x, call == 0 ? NULL : cube, NULL),
                     ANNULUS_DUPLICATE_POINT);
        CHECK(strcmp(message_of(mesh), words) == 0);
        CHECK(annulus_periodic_error_vertices(mesh, 4, named) == 2 && named[0] == 0 && named[1] == 3);
    }
    annulus_periodic_destroy(&mesh);
}

int main(void) {
    check_options();
    check_duplicates();
    return verdict("periodic_refusals");
}
