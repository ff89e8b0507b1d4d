// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/csv_fields.h>
#include <apps/formats/frame_readers.h>
#include <apps/formats/xyz_guess.h>

#include <array>

namespace annulus::inline v1 {

namespace {

constexpr std::array<std::string_view, 5> names{"frame", "id", "x", "y", "z"};

bool is_named(std::string_view field, std::string_view name) {
    if (field.size() != name.size()) return false;
    for (std::size_t i = 0; i < name.size(); ++i)
        if (field[i] != name[i] && field[i] != name[i] - 'a' + 'A') return false;
    return true;
}

}  // namespace

/// Finds the fields that name columns which are needed.
Csv_frames::Header Csv_frames::header() const {
    Header result;
    result.all = fields_.size();
    result.separator = separator_;
    for (std::size_t i = 0; i < fields_.size(); ++i)
        for (std::size_t k = 0; k < names.size(); ++k) {
            if (!is_named(fields_[i], names[k]) || (k == id_column && !wants_ids())) continue;
            if (result.at[k]) reader_.fail("names two columns " + std::string(names[k]), "one");
            result.at[k] = i;
        }
    for (std::size_t k = 0; k < names.size(); ++k)
        if (result.at[k] && (wants_ids() || k >= x_column))
            result.taken.emplace_back(names[k], column_words(*result.at[k], std::string(fields_[*result.at[k]])));
    return result;
}

/// Fields that continue on the next line are not supported: reading rows as parts of them, or the other way round,
/// would lose or invent points.
void Csv_frames::split(std::string_view text) {
    if (!split_csv(text, separator_, fields_)) reader_.fail("a quoted field does not end", "its end in the same line");
}

/// Finds the columns; afterwards the first row, if any, is next.
void Csv_frames::begin() {
    begun_ = true;
    const bool motion = wants_ids();
    std::optional<Header> commented;
    std::string comment;  // the header, or the last one before the first row
    while (true) {
        if (!next_csv_line(reader_)) return;
        const std::string_view text = csv_trimmed(reader_.line());
        const std::string_view row = text.substr(text[0] == '#' ? 1 : 0);
        separator_ = csv_separator(row);
        if (text[0] != '#') {
            split(row);
            break;
        }
        (void)split_csv(row, separator_, fields_);  // it may be free text
        if (!commented) comment = shown(text);
        if (!is_csv_header(fields_)) continue;
        const Header found = header();
        if (!found.at[x_column] || !found.at[y_column]) continue;
        commented = found;
        comment = shown(text);
    }
    const std::string no_header = comment.empty() ? "no header" : "no header but a comment, " + comment;
    row_is_due_ = !is_csv_header(fields_) && (!motion || commented);
    has_header_ = !row_is_due_ || commented;
    if (!row_is_due_) {
        columns_ = header();
    } else if (commented) {
        columns_ = *commented;
        separator_ = columns_.separator;
        split(reader_.line());
    } else {
        columns_.all = fields_.size();
        if (columns_.all < 2) reader_.fail("has 1 column", "x, y and perhaps z, separated by comma, semicolon or tab");
        if (columns_.all > 3)
            reader_.fail("has " + counted(columns_.all, "column") + " and " + no_header +
                             ", so nothing says which of them are x, y and z",
                         "a header that names x, y and perhaps z, or two or three columns");
        for (std::size_t k = 0; k < columns_.all; ++k) {
            columns_.at[x_column + k] = k;
            columns_.taken.emplace_back(names[x_column + k], column_words(k));
        }
    }
    for (std::size_t k = motion ? frame_column : x_column; k <= y_column; ++k)
        if (!columns_.at[k]) {
            const char* expected = motion ? "frame, id, x, y and perhaps z" : "columns x, y and perhaps z";
            if (columns_.taken.empty() && !is_csv_header(fields_))
                reader_.fail("has " + no_header, "a line above that names the columns: frame,id,x,y and perhaps z");
            if (!commented && fields_.size() == 1 && fields_[0].find(' ') != std::string_view::npos)
                reader_.fail("the header is separated by blanks: " + shown(fields_[0]),
                             std::string(expected) + ", separated by comma, semicolon or tab");
            reader_.fail("the header " + (commented ? "in the comment " + comment + " " : "") + "names no column " +
                             std::string(names[k]),
                         expected);
        }
    take_columns(columns_.taken);
    if (!row_is_due_) (void)next_row();
}

bool Csv_frames::next_row() {
    row_is_due_ = next_csv_line(reader_);
    if (row_is_due_) split(reader_.line());
    return row_is_due_;
}

bool Csv_frames::seek() {
    if (!begun_) begin();
    return row_is_due_;
}

void Csv_frames::read(Raw_frame& frame) {
    const auto& at = columns_.at;
    frame.points.has_z = at[z_column].has_value();
    std::array<bool, 3> integers{!has_header_ && columns_.all == 3, true, true};  // of x, y, z
    const std::uint64_t first = reader_.number();
    do {
        if (fields_.size() != columns_.all)
            reader_.fail("has " + counted(fields_.size(), "column"),
                         std::to_string(columns_.all) + (has_header_ ? " as in the header" : " as in the lines above"));
        if (at[frame_column]) {
            const std::uint64_t number = reader_.whole(fields_[*at[frame_column]], "the frame");
            if (!frame.points.points.empty() && number != frame.number) {
                if (number > frame.number) return;
                reader_.fail("frame " + std::to_string(number) + " after frame " + std::to_string(frame.number),
                             "frames in order");
            }
            frame.number = number;
        }
        if (wants_ids()) frame.id.push_back(reader_.whole(fields_[*at[id_column]], "the id"));
        frame.points.points.push_back({reader_.real(fields_[*at[x_column]], "x"),
                                       reader_.real(fields_[*at[y_column]], "y"),
                                       at[z_column] ? reader_.real(fields_[*at[z_column]], "z") : 0.});
        frame.points.lines.push_back(reader_.number());
        if (integers[0])
            for (std::size_t k = 0; k < 3; ++k) integers[k] = integers[k] && is_integer(fields_[k]);
    } while (next_row());
    if (frame.points.points.size() >= 3 && integers[0] && !integers[1] && !integers[2]) note(first, x_may_be_an_id);
}

void Csv_frames::refuse_more(const Raw_frame& frame) const {
    reader_.fail("a second frame after frame " + std::to_string(frame.number), "one frame, or no column frame");
}

}  // namespace annulus::inline v1
