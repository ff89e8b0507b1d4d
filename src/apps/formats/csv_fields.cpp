// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/csv_fields.h>

#include <algorithm>

namespace annulus::inline v1 {

std::string_view csv_trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

namespace {

/// Numbers need no quotes and no coordinate holds a separator, but some programs quote every field.
std::string_view unquoted(std::string_view text) {
    text = csv_trimmed(text);
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
        return csv_trimmed(text.substr(1, text.size() - 2));
    return text;
}

}  // namespace

bool split_csv(std::string_view line, char separator, std::vector<std::string_view>& fields) {
    if (separator == ' ') {
        split_at_blanks(line, fields);
        for (std::string_view& field : fields) field = unquoted(field);
        return true;
    }
    fields.clear();
    std::size_t begin = 0;
    bool in_quotes = false, quoted = false, blank = true;  // of the field so far
    for (std::size_t i = 0; i <= line.size(); ++i) {
        const char c = i < line.size() ? line[i] : separator;
        if (c == '"') {
            quoted = quoted || blank;
            in_quotes = quoted && !in_quotes;
        }
        blank = blank && (c == ' ' || c == '\t');
        if (i < line.size() && (in_quotes || c != separator)) continue;
        fields.push_back(unquoted(line.substr(begin, i - begin)));
        begin = i + 1;
        quoted = false;
        blank = true;
    }
    return !in_quotes;
}

char csv_separator(std::string_view line) {
    // The rarest in ordinary text first: a tab or semicolon in the first line is never accidental.
    if (line.find('\t') != std::string_view::npos) return '\t';
    for (const char separator : {';', ','})
        if (line.find(separator) != std::string_view::npos) return separator;
    return csv_trimmed(line).find(' ') != std::string_view::npos ? ' ' : ',';
}

bool equals_lower(std::string_view text, std::string_view lower) {
    return std::equal(text.begin(), text.end(), lower.begin(), lower.end(),
                      [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

bool is_missing(std::string_view field) {
    for (const std::string_view word : {"", "nan", "-nan", "na", "n/a", "null", "none", "-"})
        if (equals_lower(field, word)) return true;
    return false;
}

bool is_csv_header(const std::vector<std::string_view>& fields) {
    double unused = 0;
    const auto is_empty = [](std::string_view field) { return field.empty(); };
    return !std::all_of(fields.begin(), fields.end(), is_empty) &&
           std::none_of(fields.begin(), fields.end(), [&](std::string_view field) {
               return !field.empty() && (std::string_view("+-.0123456789").find(field[0]) != std::string_view::npos ||
                                         parse_double(field, unused) != Number_kind::not_a_number);
           });
}

bool next_csv_line(Line_reader& reader) {
    while (reader.next_line())
        if (!csv_trimmed(reader.line()).empty()) return true;
    return false;
}

}  // namespace annulus::inline v1
