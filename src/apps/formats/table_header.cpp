// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/csv_fields.h>
#include <apps/formats/printable.h>
#include <apps/formats/table_header.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace annulus::inline v1 {

namespace {

using Fields = std::vector<std::string_view>;

/// Lines of text before a header, and lines of names below it. Without an end, text is no table.
constexpr std::uint64_t most_before = 1000, most_below = 3;

/// A text without the marks of a comment that it begins with: # or, where no numbers alone follow, so that it is no
/// row, % (MATLAB), * (Viswalk) or //.
std::string_view without_comment_mark(std::string_view text) {
    const std::size_t end = std::min(text.find_first_not_of("#%*/"), text.size());
    if (end == 0 || text == "/" || (text[0] == '/' && text[1] != '/')) return text;
    const std::string_view words = csv_trimmed(text.substr(end));
    if (text[0] == '#') return words;
    Fields fields;
    double unused = 0;
    const bool is_text = !split_csv(words, csv_separator(words), fields) ||
                         std::any_of(fields.begin(), fields.end(), [&](std::string_view field) {
                             return parse_double(field, unused) == Number_kind::not_a_number;
                         });
    return is_text ? words : text;
}

/// A line that may be the header.
struct Candidate {
    Table_columns columns;
    Taken_columns taken;
    char separator = ',';
    std::uint64_t line = 0;
    std::string comment{};  ///< the line, if it is a comment
};

Taken_columns taken_of(const Table_columns& columns, const Fields& names, bool motion) {
    Taken_columns taken;
    for (std::size_t k = motion ? frame_column : x_column; k < columns.at.size(); ++k) {
        const auto at = columns.at[k];
        if (at)
            taken.emplace_back(table_column_names[k],
                               column_words(*at, *at < names.size() ? printable(names[*at]) : ""));
    }
    return taken;
}

/// The separator by which a row has as many fields as the header: that of the header, unless it is a blank, else the
/// first of those that give this number, else the one that a row without a header would have.
char row_separator(std::string_view row, const Candidate& header) {
    Fields fields;
    const auto fits = [&](char separator) {
        if (!split_csv(row, separator, fields)) return false;
        const std::size_t all = header.columns.all;
        return fields.size() == all || (fields.size() == all + 1 && fields.back().empty());
    };
    if (header.separator != ' ' && fits(header.separator)) return header.separator;
    for (const char separator : {'\t', ';', ',', ' '})
        if (fits(separator)) return separator;
    return header.separator != ' ' ? header.separator : csv_separator(csv_trimmed(row));
}

class Header_search {
  public:
    Header_search(Line_reader& reader, const Column_choice& choice, bool motion, Fields& fields)
        : reader_(reader), choice_(choice), motion_(motion), fields_(fields) {}

    Table_header run() {
        Table_header result;
        while (next_csv_line(reader_)) {
            const std::string_view text = csv_trimmed(reader_.line());
            const std::string_view words = without_comment_mark(text);
            const std::optional<Candidate>& header = text_ || text[0] == '#' ? text_ : comment_;
            if (words.size() < text.size() && !(header && is_row(reader_.line(), *header))) {
                take_comment(text, words);
            } else if (!take_text(reader_.line(), result)) {
                result.has_row = true;
                break;
            }
        }
        finish(result);
        return result;
    }

  private:
    [[nodiscard]] Candidate candidate(char separator) const {
        Candidate result{find_columns(fields_, choice_, motion_), {}, separator, reader_.number()};
        result.taken = taken_of(result.columns, fields_, motion_);
        return result;
    }

    void take_comment(std::string_view text, std::string_view words) {
        const char separator = csv_separator(words);
        last_comment_ = shown(text);
        if (!split_csv(words, separator, fields_) || !is_csv_header(fields_)) return;
        Candidate found = candidate(separator);
        if (!found.columns.at[x_column] || !found.columns.at[y_column]) return;
        if (comment_ && comment_->columns.complete() && !found.columns.complete()) return;
        found.comment = shown(text);
        comment_ = std::move(found);
    }

    [[nodiscard]] bool has_all_fields(const Candidate& header) const {
        const std::size_t all = header.columns.all;
        return fields_.size() == all || (fields_.size() == all + 1 && fields_.back().empty());
    }
    /// Whether a line below the header that begins like a comment is a row.
    [[nodiscard]] bool is_row(std::string_view line, const Candidate& header) {
        return split_csv(line, row_separator(line, header), fields_) && has_all_fields(header) &&
               !is_csv_header(fields_);
    }

    /// False at the first row.
    bool take_text(std::string_view line, Table_header& result) {
        const char separator = text_ ? row_separator(line, *text_) : csv_separator(csv_trimmed(line));
        if (!split_csv(line, separator, fields_))
            reader_.fail("a quoted field does not end", "its end in the same line");
        if (!is_csv_header(fields_)) return false;
        if (text_) {
            if (!has_all_fields(*text_) || result.continued == most_below) return false;
            if (result.continued++ == 0) result.continued_at = reader_.number();
            return true;
        }
        if (++words_ > most_before)
            reader_.fail("has " + std::to_string(most_before) + " lines without a number", "a table");
        Candidate found = candidate(separator);
        if (found.columns.complete()) text_ = std::move(found);
        else if (!other_ || (found.columns.all > 1 && other_->columns.all == 1)) other_ = std::move(found);
        return true;
    }

    /// A comment whose words are separated by blanks may be a sentence.
    [[nodiscard]] bool is_sentence(const Candidate& header, std::string_view row) const {
        if (header.separator != ' ') return false;
        const char separator = row_separator(row, header);
        Fields fields;
        return (separator != ' ' && separator != '\t') || !split_csv(row, separator, fields) ||
               fields.size() != header.columns.all;
    }

    void finish(Table_header& result) {
        const std::string_view row = reader_.line();  // none at the end
        if (comment_ && result.has_row && is_sentence(*comment_, row)) comment_.reset();
        const std::optional<Candidate>& header = text_ ? text_ : comment_;
        if (!header && other_)
            reader_.fail_at(other_->line, "the header " + other_->columns.fault, other_->columns.expected);
        if (header && !header->columns.complete())
            reader_.fail("the header in the comment " + header->comment + " " + header->columns.fault,
                         header->columns.expected);
        if (header) {
            result.columns = header->columns;
            result.taken = header->taken;
            result.named = true;
            result.separator = result.has_row ? row_separator(row, *header) : header->separator;
        } else if (result.has_row) {
            take_unnamed(result);
        }
        if (result.has_row) split_row(reader_, result.separator, result.columns.all, fields_);
    }

    /// The first row of a table without a header.
    void take_unnamed(Table_header& result) const {
        const std::string no_header = last_comment_.empty() ? "no header" : "no header but a comment, " + last_comment_;
        const std::size_t all = fields_.size();
        result.separator = csv_separator(csv_trimmed(reader_.line()));
        if (const auto columns = numbered_columns(choice_, all, motion_)) {
            if (!columns->complete()) reader_.fail(columns->fault, columns->expected);
            result.columns = *columns;
        } else {
            if (motion_ || !is_empty(choice_))
                reader_.fail("has " + no_header,
                             "a line above that names the columns: frame,id,x,y and perhaps z, or numbers of columns "
                             "given by --columns");
            if (all < 2)
                reader_.fail("has 1 column", "x, y and perhaps z, separated by comma, semicolon, tab or blank");
            if (all > 3)
                reader_.fail("has " + counted(all, "column") + " and " + no_header +
                                 ", so nothing says which of them are x, y and z",
                             "a header that names x, y and perhaps z, or two or three columns");
            result.columns.all = all;
            for (std::size_t k = 0; k < all; ++k) result.columns.at[x_column + k] = k;
        }
        result.taken = taken_of(result.columns, {}, motion_);
    }

    Line_reader& reader_;
    const Column_choice& choice_;
    bool motion_;
    Fields& fields_;
    std::optional<Candidate> text_, comment_;  ///< lines that may be the header
    std::optional<Candidate> other_;           ///< a line of text that names not all of the columns
    std::uint64_t words_ = 0;                  ///< lines of text so far
    std::string last_comment_;                 ///< for messages
};

}  // namespace

Table_header read_table_header(Line_reader& reader, const Column_choice& choice, bool motion, Fields& fields) {
    return Header_search(reader, choice, motion, fields).run();
}

void split_row(const Line_reader& reader, char separator, std::size_t columns, Fields& fields) {
    if (!split_csv(reader.line(), separator, fields))
        reader.fail("a quoted field does not end", "its end in the same line");
    if (fields.size() == columns + 1 && fields.back().empty()) fields.pop_back();
}

}  // namespace annulus::inline v1
