// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>

namespace annulus::inline v1 {

/// Keeps other runs of annulus out of a directory while its files are replaced, or from replacing them while they are
/// read. Waits for the lock. Does nothing where there is no such directory, or the file system has no locks.
class Directory_lock {
  public:
    enum class Access : std::uint8_t { reading, writing };
    Directory_lock(const std::filesystem::path& directory, Access use) noexcept;
    ~Directory_lock();
    Directory_lock(const Directory_lock&) = delete;
    Directory_lock& operator=(const Directory_lock&) = delete;

  private:
    int descriptor_;
};

}  // namespace annulus::inline v1
