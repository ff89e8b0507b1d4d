// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace annulus::inline v1 {

/// A file of a series, and its time.
struct Pvd_entry {
    std::string file;
    std::uint64_t time = 0;
};

/// The text of a ParaView collection (.pvd): .vtu files that are a series in time.
[[nodiscard]] std::string write_pvd(std::span<const Pvd_entry> series);

}  // namespace annulus::inline v1
