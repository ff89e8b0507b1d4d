// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

// What `tolerances` decides, told as it happens. Where the macro ANNULUS_TRACE names a header, that defines
// annulus::Trace, a class of static functions with the names and arguments that stand at ANNULUS_TRACED;
// proofs/traces has the one there is. Otherwise nothing is told, and arguments are not evaluated.
#ifdef ANNULUS_TRACE
#include ANNULUS_TRACE
#define ANNULUS_TRACED(event) ::annulus::Trace::event
#else
#define ANNULUS_TRACED(event) static_cast<void>(0)
#endif
