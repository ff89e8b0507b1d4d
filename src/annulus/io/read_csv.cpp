// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/io/csv_fields.h>
#include <annulus/io/point_formats.h>

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

}  // namespace

Raw_points read_csv(const Source& source) {
    Raw_points raw;
    Line_reader reader(source);
    if (!next_csv_row(reader)) return raw;
    const char separator = csv_separator(reader.line());
    std::vector<std::string_view> fields;
    split_csv(reader.line(), separator, fields);
    const bool header = is_csv_header(fields);
    const Columns columns = header ? columns_of_header(reader, fields) : columns_without_header(reader, fields);
    raw.has_z = columns.z.has_value();
    if (header && !next_csv_row(reader)) return raw;
    do {
        split_csv(reader.line(), separator, fields);
        if (fields.size() != columns.all)
            reader.fail("has " + counted(fields.size(), "column"),
                        std::to_string(columns.all) + (header ? " as in the header" : " as in the lines above"));
        raw.points.push_back({reader.real(fields[columns.x], "x"), reader.real(fields[columns.y], "y"),
                              columns.z ? reader.real(fields[*columns.z], "z") : 0.});
        raw.lines.push_back(reader.number());
    } while (next_csv_row(reader));
    return raw;
}

}  // namespace annulus
