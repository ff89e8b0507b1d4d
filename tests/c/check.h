// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shared by the C programs of the tests: checks that are counted, and random points.

#include <annulus/annulus.h>

#include <stdint.h>
#include <stdio.h>

static int checks = 0;
static int failures = 0;

#define CHECK(what) check((what) != 0, #what, __FILE__, __LINE__)
#define CHECK_STATUS(call, wanted) check_status((call), (wanted), #call, __FILE__, __LINE__)

static inline void check(int holds, const char* what, const char* file, int line) {
    ++checks;
    if (holds) return;
    ++failures;
    printf("%s:%d: does not hold: %s\n", file, line, what);
}

static inline void check_status(int status, int wanted, const char* call, const char* file, int line) {
    ++checks;
    if (status == wanted) return;
    ++failures;
    printf("%s:%d: %s: %s instead of %s\n", file, line, call, annulus_status_name(status), annulus_status_name(wanted));
}

// Between 0 and 1; a linear congruential generator, so that a seed means the same everywhere.
static inline double uniform(uint64_t* state) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) / 9007199254740992.0;
}

static inline int verdict(const char* name) {
    printf("%s: %d checks, %d failures\n", name, checks, failures);
    return failures == 0 && checks > 0 ? 0 : 1;
}
