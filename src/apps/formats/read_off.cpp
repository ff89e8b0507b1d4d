// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/point_formats.h>
#include <apps/formats/surface_formats.h>

namespace annulus::inline v1 {

namespace {

/// [ST][C][N]OFF: the letters announce columns after x y z.
bool is_keyword(std::string_view word) {
    if (word.starts_with("ST")) word.remove_prefix(2);
    if (word.starts_with("C")) word.remove_prefix(1);
    if (word.starts_with("N")) word.remove_prefix(1);
    return word == "OFF";
}

}  // namespace

Raw_points read_off(const Source& source, Raw_faces* wanted) {
    Raw_points raw;
    raw.has_z = true;
    Line_reader reader(source);
    if (!reader.next_record()) return raw;
    std::vector<std::string_view> header = reader.fields();
    if (!is_keyword(header[0])) reader.fail("begins with " + shown(header[0]), "OFF, COFF or NOFF");
    const bool more_columns = header[0] != "OFF";
    header.erase(header.begin());
    if (header.empty()) {  // the counts are on the next line, or on the same one
        if (!reader.next_record()) reader.fail("the file ends after its keyword", "counts of vertices, faces, edges");
        header = reader.fields();
    }
    if (header.size() < 2 || header.size() > 3)
        reader.fail("has " + counted(header.size(), "count"), "counts of vertices, faces and perhaps edges");
    const std::uint64_t vertices = reader.whole(header[0], "the count of vertices");
    const std::uint64_t faces = reader.whole(header[1], "the count of faces");

    const std::size_t room = reader.room_for(vertices, 6, "vertices");
    raw.points.reserve(room);
    raw.lines.reserve(room);
    for (std::uint64_t i = 0; i < vertices; ++i) {
        reader.require_record(i, vertices, "vertices");
        const auto& fields = reader.fields();
        if (fields.size() < 3 || (fields.size() > 3 && !more_columns))
            reader.fail("has " + counted(fields.size(), "column"),
                        more_columns ? "x y z and more" : "x y z (COFF and NOFF have more)");
        raw.points.push_back({reader.real(fields[0], "x"), reader.real(fields[1], "y"), reader.real(fields[2], "z")});
        raw.lines.push_back(reader.number());
    }
    // Read even when not needed: a wrong count of vertices shows here.
    for (std::uint64_t i = 0; i < faces; ++i) {
        reader.require_record(i, faces, "faces");
        const auto& fields = reader.fields();
        const std::uint64_t corners = reader.whole(fields[0], "the count of corners");
        if (corners == 0 || corners > fields.size() - 1)
            reader.fail(
                "has " + std::to_string(fields.size() - 1) + " indices for a face of " + std::to_string(corners),
                "a count and as many indices");
        if (wanted == nullptr) continue;
        for (std::uint64_t k = 1; k <= corners; ++k)
            wanted->corners.push_back(reader.whole(fields[k], "the index of a vertex"));
        wanted->close(reader.number());
    }
    if (reader.next_record())
        reader.fail("there is more after the " + std::to_string(faces) + " faces that the file announces",
                    "the end of the file");
    return raw;
}

}  // namespace annulus::inline v1
