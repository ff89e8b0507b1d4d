// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/xyz_comment.h>

#include <algorithm>

namespace annulus::inline v1 {

namespace {

/// More columns than a sensible row has; a bound that keeps sums of widths from overflowing.
constexpr std::uint64_t most_columns = 1 << 20;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same(std::string_view text, std::string_view lower_case) {
    return std::equal(text.begin(), text.end(), lower_case.begin(), lower_case.end(),
                      [](char a, char b) { return lower(a) == b; });
}

/// Takes words from the front of a comment line.
class Comment {
  public:
    explicit Comment(std::string_view text) : rest_(text) {}

    /// The next KEY=VALUE; false at the end. Words without a value have an empty one.
    bool next(std::string_view& key, std::string_view& value) {
        skip_blanks();
        if (rest_.empty()) return false;
        key = word("= \t");
        value = {};
        skip_blanks();
        if (!rest_.starts_with('=')) return true;
        rest_.remove_prefix(1);
        skip_blanks();
        value = word(" \t");
        return true;
    }

  private:
    void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size())); }

    /// Reads up to one of `ends`, or the text between quotes or brackets. A character after a backslash does not close
    /// them.
    std::string_view word(std::string_view ends) {
        constexpr std::string_view open = "\"'{[", close = "\"'}]";
        const std::size_t kind = rest_.empty() ? std::string_view::npos : open.find(rest_[0]);
        if (kind != std::string_view::npos)
            for (std::size_t end = 1; end < rest_.size(); end += rest_[end] == '\\' ? 2 : 1)
                if (rest_[end] == close[kind]) return take(1, end, end + 1);
        const std::size_t end = std::min(rest_.find_first_of(ends), rest_.size());
        return take(0, end, end);
    }
    std::string_view take(std::size_t begin, std::size_t end, std::size_t next) {
        const std::string_view text = rest_.substr(begin, end - begin);
        rest_.remove_prefix(next);
        return text;
    }

    std::string_view rest_;
};

Xyz_columns columns_of(const Line_reader& reader, std::string_view list) {
    Xyz_columns columns;
    columns.announced = true;
    bool has_pos = false;
    const auto take = [&] {
        const std::size_t end = list.find(':');
        const std::string_view word = list.substr(0, end);
        list = end == std::string_view::npos ? std::string_view() : list.substr(end + 1);
        return word;
    };
    while (!list.empty()) {
        const std::string_view name = take(), type = take(), width_text = take();
        if (type.empty() || width_text.empty())
            reader.fail("Properties end within " + shown(name), "NAME:TYPE:COLUMNS for each of them");
        const std::uint64_t width = reader.whole(width_text, "the number of columns in Properties");
        if (width == 0 || width > most_columns || columns.all + width > most_columns)
            reader.fail("Properties give " + shown(name) + " " + counted(width, "column"),
                        "at least 1, and at most " + std::to_string(most_columns) + " in all");
        if (name == "pos") {
            if (has_pos) reader.fail("Properties have pos twice", "one pos");
            if (width != 2 && width != 3) reader.fail("Properties give pos " + counted(width, "column"), "2 or 3");
            if (!same(type, "r") && !same(type, "i"))
                reader.fail("Properties give pos the type " + shown(type), "pos:R:2 or pos:R:3");
            has_pos = true;
            columns.x = columns.all;
            columns.has_z = width == 3;
        } else if (name == "id" && width == 1 && same(type, "i")) {
            if (columns.id) reader.fail("Properties have id twice", "one id");
            columns.id = columns.all;
        }
        columns.all += width;
    }
    if (!has_pos) reader.fail("Properties have no pos", "pos:R:2 or pos:R:3");
    return columns;
}

/// A box given by its sides, with its angles, or by its vectors: 3, 6 or 9 numbers.
bool is_box(std::string_view key, std::string_view values) {
    if (!same(key, "cell") && !same(key, "box")) return false;
    std::string text(values);
    std::replace(text.begin(), text.end(), ',', ' ');
    std::vector<std::string_view> words;
    split_at_blanks(text, words);
    double unused = 0;
    return (words.size() == 3 || words.size() == 6 || words.size() == 9) &&
           std::all_of(words.begin(), words.end(),
                       [&](std::string_view word) { return parse_double(word, unused) == Number_kind::finite; });
}

/// The words of a value, without brackets and quotes: `1, 0, 0`, `[true false]`.
std::vector<std::string_view> words_of(std::string& text) {
    for (char& c : text)
        if (std::string_view(",[](){}\"'\t").find(c) != std::string_view::npos) c = ' ';
    std::vector<std::string_view> words;
    split_at_blanks(text, words);
    return words;
}

/// Whether one of the words means true. `T F F`, `[true, false, false]`, `1 0 0`.
bool any_true(std::string_view values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool begins = i == 0 || values[i - 1] == ' ' || values[i - 1] == ',' || values[i - 1] == '\t';
        if (begins && (lower(values[i]) == 't' || values[i] == '1')) return true;
    }
    return false;
}

}  // namespace

Xyz_comment parse_xyz_comment(const Line_reader& reader) {
    Xyz_comment result;
    Comment comment(reader.line());
    std::string lattice;
    std::optional<bool> pbc;
    for (std::string_view key, value; comment.next(key, value);) {
        if (key.starts_with("CELL(") || key.starts_with("CELL{")) lattice = key.substr(0, key.find(':'));
        if (value.empty()) continue;
        if (same(key, "properties")) {
            if (result.columns) reader.fail("a second Properties", "one");
            result.columns = columns_of(reader, value);
        } else if (same(key, "lattice")) {
            lattice = "Lattice";
            result.vectors = value;
        } else if (is_box(key, value)) {
            lattice = key;
            result.vectors = value;
        } else if (same(key, "pbc")) {
            pbc = any_true(value);
            result.directions = value;
        }
    }
    if (pbc.value_or(!lattice.empty()))
        result.periodic = !pbc ? lattice : lattice.empty() ? "pbc" : lattice + " and pbc";
    return result;
}

File_box box_of(const Line_reader& reader, const Xyz_comment& comment) {
    File_box box{.what = comment.periodic, .line = reader.number()};
    std::string text = comment.vectors;
    const std::vector<std::string_view> numbers = words_of(text);
    const bool lengths = numbers.size() == 3 && !comment.periodic.starts_with("Lattice");
    if (!lengths && numbers.size() != 9)
        reader.fail(comment.periodic + ": a periodic box of " + counted(numbers.size(), "number"),
                    "Lattice=\"..\" with nine, three vectors one after the other");
    for (std::size_t k = 0; k < numbers.size(); ++k)
        box.vectors[lengths ? k : k / 3][k % 3] = reader.real(numbers[k], "a number of the box");
    std::string said = comment.directions;
    const std::vector<std::string_view> directions = words_of(said);
    if (directions.size() != 0 && directions.size() != 1 && directions.size() != 3)
        reader.fail("pbc has " + counted(directions.size(), "value"), "one for each direction");
    for (std::size_t k = 0; k < 3; ++k)
        box.periodic[k] = directions.empty() || any_true(directions[directions.size() == 1 ? 0 : k]);
    return box;
}

}  // namespace annulus::inline v1
