// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace annulus::inline v1 {

/// The number of leading bytes that identify a file.
inline constexpr std::size_t telling_bytes = 8;

/// Whether a gzip file begins like this.
[[nodiscard]] bool begins_as_gzip(std::string_view bytes) noexcept;

/// What only some readers accept: text in UTF-16, arrays of NumPy. `other` is accepted by none.
enum class Foreign { other, utf16, numpy };

/// The kind of a file that is not text in ASCII or UTF-8, and what to supply instead.
struct Foreign_kind {
    std::string_view fault, expected;
    Foreign kind = Foreign::other;
};

/// Decides by the first bytes, `telling_bytes` of them where there are as many: text in UTF-16 or UTF-32, with a byte
/// order mark or without, files packed by other programs, and files of other programs that have the extensions of
/// tables.
[[nodiscard]] std::optional<Foreign_kind> foreign_kind(std::string_view bytes) noexcept;

}  // namespace annulus::inline v1
