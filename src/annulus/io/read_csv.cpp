// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/io/point_formats.h>

#include <algorithm>
#include <optional>

namespace annulus {

namespace {

/// Position of x, y and z among the columns.
struct Columns {
    std::size_t all = 0;
    std::size_t x = 0;
    std::size_t y = 1;
    std::optional<std::size_t> z;
};

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Numbers need no quotes and no coordinate holds a separator, but some programs quote every field.
std::string_view unquoted(std::string_view text) {
    text = trimmed(text);
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') return trimmed(text.substr(1, text.size() - 2));
    return text;
}

/// Splits at separators outside quotes.
void split(std::string_view line, char separator, std::vector<std::string_view>& fields) {
    fields.clear();
    std::size_t begin = 0;
    bool in_quotes = false;
    for (std::size_t i = 0; i <= line.size(); ++i) {
        if (i < line.size() && line[i] == '"') in_quotes = !in_quotes;
        if (i < line.size() && (in_quotes || line[i] != separator)) continue;
        fields.push_back(unquoted(line.substr(begin, i - begin)));
        begin = i + 1;
    }
}

/// The rarest in ordinary text first: a tab or semicolon in the first line is never there by accident.
char separator_of(std::string_view line) {
    if (line.find('\t') != std::string_view::npos) return '\t';
    return line.find(';') != std::string_view::npos ? ';' : ',';
}

/// A header has names only. What begins like a number is none, so that `1 2` is not taken for the name of a column.
bool is_header(const std::vector<std::string_view>& fields) {
    double unused = 0;
    return std::none_of(fields.begin(), fields.end(), [&](std::string_view field) {
        return field.empty() || std::string_view("+-.0123456789").find(field[0]) != std::string_view::npos ||
               parse_double(field, unused) != Number_kind::not_a_number;
    });
}

std::optional<std::size_t> named(const Line_reader& reader, const std::vector<std::string_view>& fields, char name) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (fields[i].size() != 1 || (fields[i][0] != name && fields[i][0] != name - 'a' + 'A')) continue;
        if (found) reader.fail(std::string("names two columns ") + name, "one");
        found = i;
    }
    return found;
}

Columns columns_of_header(const Line_reader& reader, const std::vector<std::string_view>& fields) {
    const auto x = named(reader, fields, 'x');
    const auto y = named(reader, fields, 'y');
    if (!x || !y)
        reader.fail(std::string("the header names no column ") + (x ? 'y' : 'x'), "columns x, y and perhaps z");
    return {fields.size(), *x, *y, named(reader, fields, 'z')};
}

Columns columns_without_header(const Line_reader& reader, const std::vector<std::string_view>& fields) {
    if (fields.size() < 2) reader.fail("has 1 column", "x, y and perhaps z, separated by comma, semicolon or tab");
    Columns columns;
    columns.all = fields.size();
    if (fields.size() > 2) columns.z = 2;
    return columns;
}

bool next_row(Line_reader& reader) {
    while (reader.next_line())
        if (const auto text = trimmed(reader.line()); !text.empty() && text[0] != '#') return true;
    return false;
}

}  // namespace

Raw_points read_csv(const Source& source) {
    Raw_points raw;
    Line_reader reader(source);
    if (!next_row(reader)) return raw;
    const char separator = separator_of(reader.line());
    std::vector<std::string_view> fields;
    split(reader.line(), separator, fields);
    const bool header = is_header(fields);
    const Columns columns = header ? columns_of_header(reader, fields) : columns_without_header(reader, fields);
    raw.has_z = columns.z.has_value();
    if (header && !next_row(reader)) return raw;
    do {
        split(reader.line(), separator, fields);
        if (fields.size() != columns.all)
            reader.fail("has " + counted(fields.size(), "column"),
                        std::to_string(columns.all) + (header ? " as in the header" : " as in the lines above"));
        raw.points.push_back({reader.real(fields[columns.x], "x"), reader.real(fields[columns.y], "y"),
                              columns.z ? reader.real(fields[*columns.z], "z") : 0.});
        raw.lines.push_back(reader.number());
    } while (next_row(reader));
    return raw;
}

}  // namespace annulus
