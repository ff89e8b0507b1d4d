// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The structs of annulus.h, which grow: their first member is the size that the caller was compiled with.

#include <annulus/c/barrier.h>
#include <annulus/periodic_mesh.h>

#include <algorithm>
#include <cstring>

namespace annulus::inline v1::c {

/// Throws Refused unless the size is plausible for this or a later version: from `least` to a bound that no version
/// will reach.
inline void require_struct(std::size_t size, std::size_t least, const char* name) {
    if (size < least || size > 65536)
        throw Refused(ANNULUS_USAGE,
                      std::string(name) + ".size is " + std::to_string(size) + ": set it to sizeof(" + name + ")");
}

/// Writes the members that the caller's version has, and leaves those that the library does not have unchanged.
template <class Struct>
void write_struct(Struct* to, Struct value) {
    value.size = to->size;
    std::memcpy(to, &value, std::min(to->size, sizeof(Struct)));
}

/// NULL gives the defaults. Throws Refused for unknown names and invalid sizes.
[[nodiscard]] Options options_of(const annulus_options* given);
/// The same for a periodic box. Throws Refused for options that it does not have, too.
[[nodiscard]] Periodic_options periodic_options_of(const annulus_options* given);

inline void require_report(const annulus_report* report) {
    if (report != nullptr) require_struct(report->size, sizeof(report->size), "annulus_report");
}
/// Precondition: require_struct of its size.
void write_audit(annulus_audit_result* to, const Audit_result& verdict);
/// changed: the number of entries of Move_result::changed, d + 1 per cell.
void write_report(annulus_report* to, const Move_result& done, std::size_t changed);

}  // namespace annulus::inline v1::c
