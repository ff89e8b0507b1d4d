// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace annulus::inline v1 {

/// Text in UTF-16 to UTF-8, in pieces that may end within a character.
class Utf16_decoder {
  public:
    /// Decides the order of bytes by the first two: by the mark FF FE or FE FF, else by which of them is 0.
    explicit Utf16_decoder(std::string_view begin) noexcept;

    /// Appends the next piece. False where a surrogate is alone: then the text is no UTF-16.
    [[nodiscard]] bool append(std::string_view bytes, std::string& utf8);
    /// Whether the pieces end between two characters.
    [[nodiscard]] bool complete() const noexcept { return rest_.empty() && high_ == 0; }

  private:
    [[nodiscard]] bool take(unsigned unit, std::string& utf8);

    bool little_;
    std::string rest_;   ///< a byte of the next unit
    unsigned high_ = 0;  ///< the first half of a pair of surrogates
};

}  // namespace annulus::inline v1
