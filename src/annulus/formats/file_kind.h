// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

#include <optional>
#include <string_view>

namespace annulus {

/// How many bytes of a file tell what it is.
inline constexpr std::size_t telling_bytes = 8;

/// Does gzip begin so?
[[nodiscard]] bool begins_as_gzip(std::string_view bytes) noexcept;

/// What a file is that no reader here takes, and what to have in its place.
struct Foreign_kind {
    std::string_view fault, expected;
};

/// By the first bytes, `telling_bytes` of them where there are as many: text in UTF-16 or UTF-32, with a byte order
/// mark or without, what other programs have packed, and files of other programs that are met under the names of
/// tables.
[[nodiscard]] std::optional<Foreign_kind> foreign_kind(std::string_view bytes) noexcept;

}  // namespace annulus
