// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/medit_parser.h>

#include <algorithm>

namespace annulus::inline v1 {

namespace {

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

/// The value of a keyword, on its own line or the next: `Vertices 5`, or `Vertices` and 5 below it.
std::uint64_t keyword_value(Line_reader& reader, const std::string& keyword) {
    if (reader.fields().size() == 1 && !reader.next_record()) reader.fail("the file ends after " + keyword, "a number");
    const auto& fields = reader.fields();
    if (fields.size() > 2 || (fields.size() == 2 && fields[0] != keyword))
        reader.fail("has " + counted(fields.size(), "field"), "one number after " + keyword);
    return reader.whole(fields.back(), "the number after " + keyword);
}

/// A record of `columns` fields; one that begins with a letter is the next keyword, so the section is too short.
void next_record_of(Line_reader& reader, std::uint64_t done, std::uint64_t count, std::size_t columns,
                    const std::string& noun) {
    reader.require_record(done, count, noun);
    const auto& fields = reader.fields();
    if (fields.size() != columns) {
        if (is_letter(fields[0][0]))
            reader.fail("only " + std::to_string(done) + " of " + std::to_string(count) + " " + noun + " before " +
                            shown(fields[0]),
                        std::to_string(count - done) + " more");
        reader.fail("has " + counted(fields.size(), "column"),
                    std::to_string(columns) + " in " + noun + " (the last is a reference)");
    }
}

/// References are integers, negative ones too; they are checked and dropped.
void check_reference(const Line_reader& reader, std::string_view text) {
    if (text.starts_with('-')) text.remove_prefix(1);
    (void)reader.whole(text, "the reference");
}

void read_vertices(Line_reader& reader, Medit_content& content) {
    if (content.has_vertices) reader.fail("a second section Vertices", "one");
    content.has_vertices = true;
    const std::uint64_t count = keyword_value(reader, "Vertices");
    const auto dimension = static_cast<std::size_t>(content.dimension);
    const std::size_t room = reader.room_for(count, 2 * (dimension + 1), "vertices");
    content.points.reserve(room);
    content.lines.reserve(room);
    for (std::uint64_t i = 0; i < count; ++i) {
        next_record_of(reader, i, count, dimension + 1, "Vertices");
        const auto& fields = reader.fields();
        content.points.push_back({reader.real(fields[0], "x"), reader.real(fields[1], "y"),
                                  dimension == 3 ? reader.real(fields[2], "z") : 0.});
        check_reference(reader, fields.back());
        content.lines.push_back(reader.number());
    }
}

template <std::size_t corners>
void read_cells(Line_reader& reader, const std::string& keyword, Medit_cells<corners>& result) {
    if (!result.cells.empty()) reader.fail("a second section " + keyword, "one");
    const std::uint64_t count = keyword_value(reader, keyword);
    const std::size_t room = reader.room_for(count, 2 * (corners + 1), keyword);
    result.cells.reserve(room);
    result.lines.reserve(room);
    for (std::uint64_t i = 0; i < count; ++i) {
        next_record_of(reader, i, count, corners + 1, keyword);
        std::array<Index, corners> cell;
        for (std::size_t k = 0; k < corners; ++k) {
            const std::uint64_t index = reader.whole(reader.fields()[k], "an index");
            // The count of points may come later in the file; here only numbers that no Index can hold are refused.
            if (index > (1ULL << 31) - 1)
                reader.fail("names vertex " + std::to_string(index), "an index from 1 to the count of vertices");
            cell[k] = static_cast<Index>(index) - 1;
        }
        check_reference(reader, reader.fields().back());
        result.cells.push_back(cell);
        result.lines.push_back(reader.number());
    }
}

template <std::size_t corners>
void check_cells(const std::string& name, const Medit_cells<corners>& cells, std::size_t points) {
    for (std::size_t i = 0; i < cells.cells.size(); ++i) {
        const auto& cell = cells.cells[i];
        for (std::size_t k = 0; k < corners; ++k) {
            if (static_cast<std::size_t>(cell[k]) >= points)
                throw Input_error(Error_code::bad_input, name, cells.lines[i],
                                  "names vertex " + std::to_string(cell[k] + 1LL) + " of " + std::to_string(points),
                                  "an index from 1 to " + std::to_string(points));
            if (std::find(cell.begin(), cell.begin() + k, cell[k]) != cell.begin() + k)
                throw Input_error(Error_code::bad_input, name, cells.lines[i],
                                  "names vertex " + std::to_string(cell[k] + 1LL) + " twice", "different vertices");
        }
    }
}

/// Sections with one record per line that are skipped by their count, with the data for checking them.
bool is_counted_by_lines(std::string_view keyword) {
    return keyword == "Quadrilaterals" || keyword == "Hexahedra" || keyword == "Prisms" || keyword == "Pyramids";
}

void skip_lines(Line_reader& reader, const std::string& keyword) {
    const std::uint64_t count = keyword_value(reader, keyword);
    for (std::uint64_t i = 0; i < count; ++i) {
        reader.require_record(i, count, keyword);
        if (is_letter(reader.fields()[0][0]))
            reader.fail("only " + std::to_string(i) + " of " + std::to_string(count) + " " + keyword + " before " +
                            shown(reader.fields()[0]),
                        std::to_string(count - i) + " more");
    }
}

void read_dimension(Line_reader& reader, Medit_content& content) {
    const std::uint64_t dimension = keyword_value(reader, "Dimension");
    if (dimension != 2 && dimension != 3) reader.fail("has dimension " + std::to_string(dimension), "2 or 3");
    if (content.dimension != 0) reader.fail("a second Dimension", "one");
    content.dimension = static_cast<int>(dimension);
}

}  // namespace

Medit_content parse_medit(const Source& source) {
    Medit_content content;
    Line_reader reader(source);
    if (!reader.next_record()) return content;
    if (reader.fields()[0] != "MeshVersionFormatted")
        reader.fail("begins with " + shown(reader.fields()[0]), "MeshVersionFormatted");
    const std::uint64_t version = keyword_value(reader, "MeshVersionFormatted");
    if (version < 1 || version > 4) reader.fail("has version " + std::to_string(version), "1 to 4");

    bool skipping = false;  // inside a section whose length is not known
    while (reader.next_record()) {
        const std::string keyword(reader.fields()[0]);
        if (!is_letter(keyword[0])) {
            if (!skipping) reader.fail(shown(keyword) + " where a keyword should be", "a keyword or End");
            continue;
        }
        skipping = false;
        if (keyword == "End") {
            if (reader.next_record()) reader.fail("there is more after End", "the end of the file");
            break;
        }
        if (keyword == "Dimension") {
            read_dimension(reader, content);
            continue;
        }
        if (content.dimension == 0) reader.fail(shown(keyword) + " before Dimension", "Dimension 2 or 3");
        if (keyword == "Vertices") read_vertices(reader, content);
        else if (keyword == "Edges") read_cells(reader, keyword, content.edges);
        else if (keyword == "Triangles") read_cells(reader, keyword, content.triangles);
        else if (keyword == "Tetrahedra") read_cells(reader, keyword, content.tetrahedra);
        else if (is_counted_by_lines(keyword)) skip_lines(reader, keyword);
        else skipping = true;
    }
    content.last_line = std::max<std::uint64_t>(reader.number(), 1);
    if (content.dimension == 0) reader.fail("the file ends without Dimension", "Dimension 2 or 3");
    check_cells(source.name, content.edges, content.points.size());
    check_cells(source.name, content.triangles, content.points.size());
    check_cells(source.name, content.tetrahedra, content.points.size());
    return content;
}

}  // namespace annulus::inline v1
