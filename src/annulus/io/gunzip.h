// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/io/text_input.h>

namespace annulus {

/// The content of a gzip file (all members of it), at most `most` bytes. Throws Input_error when it is damaged, cut off
/// or longer.
[[nodiscard]] Source gunzip(const Source& packed, std::uint64_t most);

}  // namespace annulus
