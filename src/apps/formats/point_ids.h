// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace annulus::inline v1 {

/// How the ids of a file are written. An id is a number of 64 bits, by which points are compared and sorted: an integer
/// itself (a negative one in two's complement, so that it comes after the others), or the place of a word in the order
/// of first appearance, from 0. Memory for words is linear in the number of different ones.
class Point_ids {
  public:
    /// From now on ids are words. To be called before the first id, if at all.
    void use_words() noexcept { kind_ = Kind::words; }
    /// A negative integer was met; no id is 2^63 or more.
    void use_signs() noexcept { kind_ = Kind::with_signs; }
    [[nodiscard]] bool are_words() const noexcept { return kind_ == Kind::words; }
    [[nodiscard]] bool have_signs() const noexcept { return kind_ == Kind::with_signs; }

    /// The number of a word. O(log n).
    [[nodiscard]] std::uint64_t number_of(std::string_view word);
    /// The id as it is in the file.
    [[nodiscard]] std::string text(std::uint64_t id) const;
    [[nodiscard]] const std::vector<std::string>& words() const noexcept { return words_; }

  private:
    enum class Kind { integers, with_signs, words };

    Kind kind_ = Kind::integers;
    std::vector<std::string> words_;  ///< by number
    std::map<std::string, std::uint64_t, std::less<>> numbers_;
};

}  // namespace annulus::inline v1
