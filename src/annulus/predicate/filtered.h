// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The filtered predicate in every dimension: overloads on the tuple type, so that code over `d` need not name it.
#include <annulus/predicate/batch.h>
#include <annulus/predicate/filtered_2.h>
#include <annulus/predicate/filtered_3.h>
#include <annulus/predicate/tolerances.h>
