// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/xyz_guess.h>

#include <algorithm>
#include <charconv>

namespace annulus::inline v1 {

namespace {

constexpr const char* how_to_say =
    "[element] x y [z]; what columns are else is said in the comment, as Properties=id:I:1:pos:R:3:charge:R:1";

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

bool is_number(std::string_view text) {
    double unused = 0;
    return parse_double(text, unused) != Number_kind::not_a_number;
}

std::uint64_t value_of(std::string_view integer) {
    std::uint64_t value = 0;
    const auto [end, code] = std::from_chars(integer.data(), integer.data() + integer.size(), value);
    return code == std::errc() && end == integer.data() + integer.size() ? value : ~std::uint64_t{0};
}

bool is_atomic_number(std::string_view text) {
    constexpr std::uint64_t most = 118;
    return is_integer(text) && value_of(text) >= 1 && value_of(text) <= most;
}

}  // namespace

bool is_integer(std::string_view text) {
    if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
    return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

bool is_element_name(std::string_view text) {
    if (is_number(text)) return false;  // nan, inf
    std::size_t i = 0;
    while (i < text.size() && is_digit(text[i])) ++i;
    if (i == 0) return std::string_view("+-.,").find(text[0]) == std::string_view::npos;
    return i < text.size() && std::all_of(text.begin() + static_cast<std::ptrdiff_t>(i), text.end(), is_letter);
}

bool looks_like_row(const std::vector<std::string_view>& fields) {
    const std::size_t first = !fields.empty() && is_element_name(fields[0]) ? 1 : 0;
    return fields.size() >= first + 2 &&
           std::all_of(fields.begin() + static_cast<std::ptrdiff_t>(first), fields.end(), is_number);
}

Xyz_guess::Xyz_guess(const Line_reader& reader, std::size_t first, Lead lead)
    : columns_{reader.fields().size(), first, reader.fields().size() >= first + 3, {}, false},
      lead_(lead),
      first_line_(reader.number()) {}

Xyz_guess Xyz_guess::of_plain(const Line_reader& reader) {
    const std::size_t all = reader.fields().size();
    if (all < 2) reader.fail("has 1 column", "x y [z]");
    if (all > 3)
        reader.fail("has " + counted(all, "column") + ", and nothing says which of them are x, y and z",
                    "x y [z]; more columns take the header of a .csv file, or a count and a comment with "
                    "Properties=id:I:1:pos:R:3");
    return {reader, 0, Lead::nothing};
}

Xyz_guess Xyz_guess::of_counted(const Line_reader& reader) {
    const auto& fields = reader.fields();
    const bool named = is_element_name(fields[0]);
    const Lead lead = named ? Lead::name : fields.size() <= 3 ? Lead::nothing : Lead::number;
    const std::size_t first = lead == Lead::nothing ? 0 : 1;
    if (fields.size() < first + 2) reader.fail("has " + counted(fields.size(), "column"), "[element] x y [z]");
    return {reader, first, lead};
}

void Xyz_guess::examine(const Line_reader& reader) {
    const auto& fields = reader.fields();
    if (fields.size() != columns_.all) return;  // reported as a separate fault
    if (lead_ == Lead::name && !is_element_name(fields[0]))
        reader.fail("begins with " + shown(fields[0]) + ", where rows above begin with the name of an element",
                    how_to_say);
    if (lead_ == Lead::number && !is_atomic_number(fields[0]))
        reader.fail("has " + counted(fields.size(), "column") + " and begins with " + shown(fields[0]) +
                        ", which is no element",
                    how_to_say);
    for (std::size_t k = 0; k < (columns_.has_z ? 3u : 2u); ++k)
        integers_[k] = integers_[k] && is_integer(fields[columns_.x + k]);
    const std::uint64_t x = integers_[0] ? value_of(fields[columns_.x]) : ~std::uint64_t{0};
    from_0_ = from_0_ && x == rows_;
    from_1_ = from_1_ && x == rows_ + 1;
    ++rows_;
}

void Xyz_guess::require_clear(const Line_reader& reader) const {
    const std::size_t last = columns_.x + (columns_.has_z ? 3 : 2);
    const bool more = columns_.all > last;
    const bool all_integers = integers_[0] && integers_[1] && integers_[2];
    if (lead_ == Lead::number && all_integers)
        reader.fail_at(first_line_,
                       "has " + counted(columns_.all, "column") + " of integers: the first may be x or an element",
                       how_to_say);
    if (!more || !integers_[0]) return;
    if (!(integers_[1] && integers_[2]) || (rows_ >= 3 && (from_0_ || from_1_)))
        reader.fail_at(first_line_,
                       "has " + counted(columns_.all, "column") + ", and " + "column " +
                           std::to_string(columns_.x + 1) + ", where x is to be, holds integers as ids and types do",
                       how_to_say);
}

bool Xyz_guess::x_may_be_an_id() const noexcept {
    return columns_.all == 3 && rows_ >= 3 && integers_[0] && !integers_[1] && !integers_[2];
}

}  // namespace annulus::inline v1
