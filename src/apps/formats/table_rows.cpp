// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/csv_fields.h>
#include <apps/formats/table_rows.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace annulus::inline v1 {

namespace {

/// Doubles up to here are whole numbers one by one.
constexpr double most_exact = 9007199254740992.;

struct Integer {
    std::uint64_t bits = 0;  ///< in two's complement
    bool is_negative = false;
};

/// An integer from -2^63 to 2^64 - 1, in digits or as 3.0 and 3.000e+00; 3e0, without a point, is a word.
std::optional<Integer> integer_of(std::string_view text) {
    if (text.size() > 1 && text[0] == '+') text.remove_prefix(1);
    const char* const end = text.data() + text.size();
    Integer result;
    const auto natural = std::from_chars(text.data(), end, result.bits);
    if (natural.ec == std::errc() && natural.ptr == end) return result;
    std::int64_t value = 0;
    const auto whole = std::from_chars(text.data(), end, value);
    double real = 0;
    if (whole.ec != std::errc() || whole.ptr != end) {
        if (text.find('.') == std::string_view::npos || parse_double(text, real) != Number_kind::finite)
            return std::nullopt;
        if (real != std::floor(real) || std::abs(real) > most_exact) return std::nullopt;
        value = static_cast<std::int64_t>(real);
    }
    return Integer{static_cast<std::uint64_t>(value), value < 0};
}

/// A quote in a quoted field is two.
std::string without_doubled_quotes(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        result += text[i];
        if (text[i] == '"' && i + 1 < text.size() && text[i + 1] == '"') ++i;
    }
    return result;
}

}  // namespace

bool Table_rows::next_line() {
    if (!next_csv_line(reader_)) return false;
    split_row(reader_, header_.separator, header_.columns.all, fields_);
    return true;
}

bool Table_rows::next() {
    if (!begun_) {
        begun_ = true;
        header_ = read_table_header(reader_, choice_, motion_, fields_);
        if (!header_.has_row) return false;
    } else if (!next_line()) {
        return false;
    }
    while (motion_ && is_blank())
        if (!next_line()) return false;
    const std::size_t all = header_.columns.all;
    if (fields_.size() == all) return true;
    const std::string fault = "has " + counted(fields_.size(), "column");
    const std::uint64_t line = reader_.number();
    while (csv_trimmed(reader_.line())[0] == '#')
        if (!next_csv_line(reader_)) return false;
    reader_.fail_at(line, fault,
                    std::to_string(all) + (header_.named ? " as in the header" : " as in the lines above"));
}

bool Table_rows::is_blank() const {
    return std::all_of(fields_.begin(), fields_.end(), [](std::string_view field) { return field.empty(); });
}

double Table_rows::number(std::string_view text, std::string_view what) {
    const bool comma = header_.separator != ',' && text.find(',') != std::string_view::npos;
    if (!comma && text.find('.') == std::string_view::npos) return reader_.real(text, what);
    const char point = comma ? ',' : '.';
    if (point_ == '\0') point_ = point;
    if (point != point_)
        reader_.fail(std::string(what) + " is " + shown(text) + ", and numbers above have a decimal " +
                         (point_ == ',' ? "comma" : "point"),
                     "the same throughout");
    if (!comma) return reader_.real(text, what);
    text_ = text;
    std::replace(text_.begin(), text_.end(), ',', '.');
    double unused = 0;
    if (parse_double(text_, unused) == Number_kind::not_a_number)
        reader_.fail(std::string(what) + " is not a number: " + shown(text), "a number");
    return reader_.real(text_, what);
}

Frame_value Table_rows::frame() {
    const std::string_view text = field(frame_column);
    Frame_value value;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value.number);
    if (end == text.data() + text.size() && !text.empty()) {
        if (code != std::errc()) return {true, reader_.whole(text, "the frame"), 0};  // too large
        value.time = static_cast<double>(value.number);
        return value;
    }
    value.time = number(text, "the frame") + 0.0;  // -0 is 0
    value.is_number = value.time >= 0 && value.time <= most_exact && value.time == std::floor(value.time);
    if (value.is_number) value.number = static_cast<std::uint64_t>(value.time);
    return value;
}

bool Table_rows::has_integer_id() const {
    const std::string_view text = field(id_column);
    if (is_missing(text)) reader_.fail("the id is missing", "an id in every row that has coordinates");
    if (integer_of(text)) return true;
    double unused = 0;
    if (text.find('.') != std::string_view::npos && parse_double(text, unused) == Number_kind::finite)
        reader_.fail("the id is not an integer: " + shown(text), "an integer or a word");
    return false;
}

std::uint64_t Table_rows::id(Point_ids& ids) {
    const std::string_view text = field(id_column);
    if (ids.are_words()) {
        if (is_missing(text)) reader_.fail("the id is missing", "an id in every row that has coordinates");
        if (text.find("\"\"") != std::string_view::npos) return ids.number_of(without_doubled_quotes(text));
        return ids.number_of(text);
    }
    if (!has_integer_id())
        reader_.fail("the id is not an integer: " + shown(text), "an integer of 64 bits, as the first id is");
    const Integer id = *integer_of(text);
    if (id.is_negative) ids.use_signs();
    has_large_id_ = has_large_id_ || (!id.is_negative && id.bits >> 63 != 0);
    if (has_large_id_ && ids.have_signs()) reader_.fail("ids below 0 and ids of 2^63 or more", "integers of 64 bits");
    return id.bits;
}

bool Table_rows::is_absent() const {
    if (!motion_) return false;
    for (const Table_column column : {x_column, y_column, z_column})
        if (has(column) && !is_missing(field(column))) return false;
    return true;
}

Coordinates<3> Table_rows::position() {
    return {number(field(x_column), "x"), number(field(y_column), "y"),
            has(z_column) ? number(field(z_column), "z") : 0.};
}

}  // namespace annulus::inline v1
