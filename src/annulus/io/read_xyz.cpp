// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/io/point_formats.h>

namespace annulus {

namespace {

/// Where the coordinates stand among the fields of every line.
struct Columns {
    std::size_t all = 0;    ///< fields a line must have
    std::size_t first = 0;  ///< the one with x
    bool has_z = false;
};

void read_line(const Line_reader& reader, const Columns& columns, Raw_points& raw) {
    const auto& fields = reader.fields();
    if (fields.size() != columns.all)
        reader.fail("has " + counted(fields.size(), "column"), std::to_string(columns.all) + " as in the lines above");
    raw.points.push_back({reader.real(fields[columns.first], "x"), reader.real(fields[columns.first + 1], "y"),
                          columns.has_z ? reader.real(fields[columns.first + 2], "z") : 0.});
    raw.lines.push_back(reader.number());
}

/// The shape of a file from its first line of coordinates.
Columns columns_of_plain(const Line_reader& reader) {
    const std::size_t all = reader.fields().size();
    if (all < 2) reader.fail("has 1 column", "x y [z]");
    return {all, 0, all >= 3};
}

/// A name or atomic number may lead the line: up to three columns beginning with a number have none.
Columns columns_of_counted(const Line_reader& reader) {
    const auto& fields = reader.fields();
    double unused = 0;
    const bool leads_with_number = parse_double(fields[0], unused) != Number_kind::not_a_number;
    const std::size_t first = leads_with_number && fields.size() <= 3 ? 0 : 1;
    if (fields.size() < first + 2) reader.fail("has " + counted(fields.size(), "column"), "[element] x y [z]");
    return {fields.size(), first, fields.size() >= first + 3};
}

void read_counted(Line_reader& reader, Raw_points& raw) {
    const std::uint64_t count = reader.whole(reader.fields()[0], "the count of points");
    const std::size_t room = reader.room_for(count, 4, "points");
    raw.points.reserve(room);
    raw.lines.reserve(room);
    if (!reader.next_line()) reader.fail("the file ends after its count", "a comment line and the points");
    Columns columns;
    for (std::uint64_t i = 0; i < count; ++i) {
        reader.require_record(i, count, "points");
        if (i == 0) columns = columns_of_counted(reader);
        read_line(reader, columns, raw);
    }
    raw.has_z = columns.has_z;
    if (reader.next_record())
        reader.fail("there is more after the " + counted(count, "point") + " that the file announces",
                    "the end of the file (one frame)");
}

}  // namespace

Raw_points read_xyz(const Source& source) {
    Raw_points raw;
    Line_reader reader(source);
    if (!reader.next_record()) return raw;
    if (reader.fields().size() == 1) {
        read_counted(reader, raw);
        return raw;
    }
    const Columns columns = columns_of_plain(reader);
    raw.has_z = columns.has_z;
    do {
        read_line(reader, columns, raw);
    } while (reader.next_record());
    return raw;
}

}  // namespace annulus
