// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reports the decisions of `tolerances` as they happen. If the macro ANNULUS_TRACE is defined, it names a header that
// defines annulus::v1::Trace, a class of static functions with the names and arguments used in ANNULUS_TRACED; the only
// one is in proofs/traces. Otherwise nothing is reported, and the arguments are not evaluated.
#ifdef ANNULUS_TRACE
#include ANNULUS_TRACE
#define ANNULUS_TRACED(event) ::annulus::Trace::event
#else
#define ANNULUS_TRACED(event) static_cast<void>(0)
#endif
