// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace annulus {

/// Memory of this process that is in RAM, in bytes; 0 where the system does not say.
struct Resident_memory {
    std::uint64_t current = 0;
    std::uint64_t peak = 0;
};

/// Reads /proc/self/status (Linux). Never throws; both are 0 on other systems. A few tens of microseconds.
[[nodiscard]] Resident_memory resident_memory() noexcept;

}  // namespace annulus
