// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace annulus::inline v1 {

/// The peak of this process' resident memory, in bytes; 0 where the system does not say. Never throws; a few tens of
/// microseconds.
///
/// From /proc/self/status (Linux), because getrusage includes the process that started this one: it says 300 MB under a
/// Python script where this process has 1 MB.
[[nodiscard]] std::uint64_t peak_resident_memory() noexcept;
/// The same from a file of the form of /proc/self/status.
[[nodiscard]] std::uint64_t peak_resident_memory(const char* status) noexcept;

/// The memory that processes may still take before the machine swaps, in bytes; 0 where the system does not say. From
/// /proc/meminfo (Linux), and no more than the limit of the control group (cgroup v2) leaves.
[[nodiscard]] std::uint64_t available_memory() noexcept;
/// The same from files of the form of /proc/meminfo, and memory.max and memory.current of a control group.
[[nodiscard]] std::uint64_t available_memory(const char* meminfo, const char* most, const char* used) noexcept;

}  // namespace annulus::inline v1
