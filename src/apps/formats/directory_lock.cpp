// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/directory_lock.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace annulus::inline v1 {

Directory_lock::Directory_lock(const std::filesystem::path& directory, Access use) noexcept
    : descriptor_(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_NONBLOCK | O_CLOEXEC)) {
    if (descriptor_ >= 0) (void)::flock(descriptor_, use == Access::reading ? LOCK_SH : LOCK_EX);
}

Directory_lock::~Directory_lock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace annulus::inline v1
