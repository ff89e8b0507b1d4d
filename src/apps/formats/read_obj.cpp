// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/surface_formats.h>

namespace annulus::inline v1 {

namespace {

/// "7", "7/1", "7//3", "-1/2/3": the first number, from 1, or from the end where it is negative.
std::uint64_t corner(const Line_reader& reader, std::string_view field, std::size_t points) {
    std::string_view word = field.substr(0, field.find('/'));
    const bool from_the_end = word.starts_with('-');
    if (from_the_end) word.remove_prefix(1);
    const std::uint64_t index = reader.whole(word, "the index of a vertex");
    if (index == 0) reader.fail("the index of a vertex is 0", "indices from 1, or from -1 backwards");
    if (!from_the_end) return index - 1;
    if (index > points) reader.fail("there is no vertex " + shown(field), "one of the vertices so far");
    return points - index;
}

}  // namespace

Raw_points read_obj(const Source& source, Raw_faces& faces) {
    Raw_points raw;
    raw.has_z = true;
    Line_reader reader(source);
    while (reader.next_record()) {
        const auto& fields = reader.fields();
        if (fields[0] == "v") {
            if (fields.size() < 4) reader.fail("has " + counted(fields.size() - 1, "coordinate"), "v x y z");
            raw.points.push_back(
                {reader.real(fields[1], "x"), reader.real(fields[2], "y"), reader.real(fields[3], "z")});
            raw.lines.push_back(reader.number());
        } else if (fields[0] == "f") {
            for (std::size_t k = 1; k < fields.size(); ++k)
                faces.corners.push_back(corner(reader, fields[k], raw.points.size()));
            faces.close(reader.number());
        }
    }
    return raw;
}

}  // namespace annulus::inline v1
