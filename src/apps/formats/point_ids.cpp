// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/point_ids.h>

namespace annulus::inline v1 {

std::uint64_t Point_ids::number_of(std::string_view word) {
    const auto found = numbers_.find(word);
    if (found != numbers_.end()) return found->second;
    const std::uint64_t number = words_.size();
    words_.emplace_back(word);
    numbers_.emplace(word, number);
    return number;
}

std::string Point_ids::text(std::uint64_t id) const {
    if (kind_ == Kind::words && id < words_.size()) return words_[static_cast<std::size_t>(id)];
    return kind_ == Kind::with_signs ? std::to_string(static_cast<std::int64_t>(id)) : std::to_string(id);
}

}  // namespace annulus::inline v1
