// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/ply_header.h>
#include <apps/formats/surface_formats.h>

#include <cmath>
#include <cstring>

namespace annulus::inline v1 {

namespace {

constexpr std::size_t head = 84;    // 80 arbitrary bytes, then the count of triangles
constexpr std::size_t record = 50;  // normal, three corners (12 floats), two arbitrary bytes

std::uint32_t count_of(const std::string& bytes) {
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < 4; ++i)
        count |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[head - 4 + i])) << (8 * i);
    return count;
}

void read_binary(const Source& source, Raw_points& raw, Raw_faces& faces) {
    const std::string& bytes = source.content;
    const std::uint64_t count = count_of(bytes);
    raw.points.reserve(3 * count);
    for (std::uint64_t t = 0; t < count; ++t) {
        const char* at = bytes.data() + head + t * record + 12;
        for (int c = 0; c < 3; ++c) {
            Coordinates<3> p;
            for (double& x : p) {
                x = ply_decode(Ply_type::float32, at);
                at += 4;
                if (!std::isfinite(x))
                    throw Input_error(Error_code::not_finite, source.name, t + 1,
                                      "in binary triangle " + std::to_string(t + 1) + ", a coordinate is not finite",
                                      "finite numbers");
            }
            faces.corners.push_back(raw.points.size());
            raw.points.push_back(p);
            raw.lines.push_back(t + 1);
        }
        faces.close(t + 1);
    }
}

std::string lower(std::string_view word) {
    std::string result(word);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

void read_ascii(const Source& source, Raw_points& raw, Raw_faces& faces) {
    Line_reader reader(source);
    std::size_t corners = 0;
    bool in_facet = false;
    while (reader.next_record()) {
        const auto& fields = reader.fields();
        const std::string word = lower(fields[0]);
        if (word == "facet") {
            if (in_facet) reader.fail("a facet begins within another", "endfacet");
            in_facet = true;
            corners = 0;
        } else if (word == "vertex") {
            if (!in_facet) reader.fail("a vertex outside of any facet", "facet");
            if (++corners > 3) reader.fail("a facet has a fourth vertex", "three vertices");
            if (fields.size() != 4) reader.fail("has " + counted(fields.size() - 1, "coordinate"), "vertex x y z");
            faces.corners.push_back(raw.points.size());
            raw.points.push_back(
                {reader.real(fields[1], "x"), reader.real(fields[2], "y"), reader.real(fields[3], "z")});
            raw.lines.push_back(reader.number());
        } else if (word == "endfacet") {
            if (!in_facet || corners != 3) reader.fail("a facet has " + std::to_string(corners) + " vertices", "three");
            in_facet = false;
            faces.close(reader.number());
        } else if (word != "solid" && word != "endsolid" && word != "outer" && word != "endloop") {
            reader.fail("unknown word " + shown(fields[0]), "facet, vertex, endfacet or another word of ASCII STL");
        }
    }
    if (in_facet) reader.fail("the file ends within a facet", "endfacet");
}

}  // namespace

Raw_points read_stl(const Source& source, Raw_faces& faces) {
    Raw_points raw;
    raw.has_z = true;
    // A binary file may begin with "solid", too; only the length distinguishes them.
    const std::size_t size = source.content.size();
    if (size >= head && size == head + record * static_cast<std::uint64_t>(count_of(source.content))) {
        read_binary(source, raw, faces);
    } else if (lower(source.content.substr(0, 5)) == "solid" && source.content.find('\0') == std::string::npos) {
        read_ascii(source, raw, faces);
    } else if (size >= head) {
        throw Input_error(Error_code::bad_input, source.name, 0,
                          "has " + std::to_string(size) + " bytes for " + std::to_string(count_of(source.content)) +
                              " binary triangles",
                          "84 bytes and 50 for each, or an ASCII file that begins with solid");
    } else {
        throw Input_error(Error_code::bad_input, source.name, 1, "is neither ASCII nor binary STL",
                          "solid, or at least 84 bytes");
    }
    return raw;
}

}  // namespace annulus::inline v1
