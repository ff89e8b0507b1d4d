// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The filtered predicate of every dimension: overloads on the tuple type, so that code over `d` need not name it.
#include <annulus/certificate/batch.h>
#include <annulus/certificate/filtered_2.h>
#include <annulus/certificate/filtered_3.h>
#include <annulus/certificate/tolerances.h>
