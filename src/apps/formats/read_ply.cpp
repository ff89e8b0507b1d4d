// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/ply_header.h>
#include <apps/formats/point_formats.h>
#include <apps/formats/surface_formats.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace annulus::inline v1 {

namespace {

bool is_face_list(const Ply_element& element, const Ply_property& property) {
    return element.name == "face" && property.is_list &&
           (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Triangle strips, as those of Stanford's scans: -1 ends one.
bool is_strip_list(const Ply_element& element, const Ply_property& property) {
    return element.name == "tristrips" && property.is_list &&
           (property.name == "vertex_indices" || property.name == "vertex_index");
}

constexpr std::uint64_t end_of_strip = ~std::uint64_t{0};

/// -1, or the index of a vertex.
std::uint64_t strip_entry(const Line_reader& reader, std::string_view text) {
    if (text == "-1") return end_of_strip;
    return std::min(reader.whole(text, "the index of a vertex"), end_of_strip - 1);  // both are too large
}

/// Adds the triangles of strips, of which every other one has its first two corners exchanged; those with a corner
/// twice, by which strips are joined, are left out.
void append_strips(const std::vector<std::uint64_t>& strips, std::uint64_t line, Raw_faces& faces) {
    std::size_t length = 0;  // of the strip so far
    for (std::size_t i = 0; i < strips.size(); ++i) {
        length = strips[i] == end_of_strip ? 0 : length + 1;
        if (length < 3) continue;
        const std::uint64_t a = strips[i - 2], b = strips[i - 1], c = strips[i];
        if (a == b || b == c || c == a) continue;
        const bool turned = length % 2 == 0;
        faces.corners.insert(faces.corners.end(), {turned ? b : a, turned ? a : b, c});
        faces.close(line);
    }
}

/// Adds one vertex, given the values of all its properties.
void append_vertex(const Ply_vertex_columns& columns, const std::vector<double>& values, std::uint64_t line,
                   Raw_points& raw) {
    raw.points.push_back({values[columns.x], values[columns.y], columns.z ? values[*columns.z] : 0.});
    raw.lines.push_back(line);
}

/// Every record of an ASCII file is one line.
void read_ascii(Line_reader& reader, const Ply_header& header, const Ply_vertex_columns& columns, Raw_points& raw,
                Raw_faces* faces) {
    std::vector<double> values;
    std::vector<std::uint64_t> strips;
    for (const Ply_element& element : header.elements) {
        if (element.properties.empty()) continue;
        const bool is_vertex = element.name == "vertex";
        if (is_vertex) raw.points.reserve(reader.room_for(element.count, 4, "vertices"));
        for (std::uint64_t i = 0; i < element.count; ++i) {
            reader.require_record(i, element.count, element.name + " records");
            const bool is_face = faces != nullptr && (element.name == "face" || element.name == "tristrips");
            if (!is_vertex && !is_face) continue;
            const auto& fields = reader.fields();
            values.clear();
            std::size_t next = 0;
            const auto take = [&](const std::string& name) {
                if (next == fields.size())
                    reader.fail("has " + counted(fields.size(), "column") + ", " + name + " is missing",
                                "all properties of the header");
                return fields[next++];
            };
            for (const Ply_property& property : element.properties) {
                const std::string_view field = take(property.name);
                if (!property.is_list) {
                    values.push_back(is_vertex && columns.uses(values.size()) ? reader.real(field, property.name) : 0.);
                    continue;
                }
                const std::uint64_t length = reader.whole(field, "the length of " + property.name);
                const bool wanted = is_face && is_face_list(element, property);
                const bool in_strips = is_face && is_strip_list(element, property);
                strips.clear();
                for (std::uint64_t k = 0; k < length; ++k) {
                    const std::string_view index = take(property.name);
                    if (wanted) faces->corners.push_back(reader.whole(index, "the index of a vertex"));
                    if (in_strips) strips.push_back(strip_entry(reader, index));
                }
                if (wanted) faces->close(reader.number());
                if (in_strips) append_strips(strips, reader.number(), *faces);
                values.push_back(0.);
            }
            if (next != fields.size())
                reader.fail("has " + counted(fields.size(), "column"), std::to_string(next) + " from the header");
            if (is_vertex) append_vertex(columns, values, reader.number(), raw);
        }
    }
    if (reader.next_record()) reader.fail("there is more after the last record", "the end of the file");
}

/// Steps through the records after the header, checking every step against the end of the file.
class Binary_reader {
  public:
    Binary_reader(const std::string& name, std::string_view bytes, bool big_endian)
        : name_(name), bytes_(bytes), big_endian_(big_endian) {}

    void enter(const Ply_element& element, std::uint64_t record) {
        element_ = &element;
        record_ = record;
    }

    [[nodiscard]] std::size_t left() const noexcept { return bytes_.size(); }

    [[noreturn]] void fail(const std::string& fault, std::string expected,
                           Error_code code = Error_code::bad_input) const {
        throw Input_error(code, name_, record_,
                          "in binary " + element_->name + " " + std::to_string(record_) + ", " + fault,
                          std::move(expected));
    }

    void skip(std::uint64_t size) {
        if (size > bytes_.size())
            fail("the file ends", counted(size - bytes_.size(), "byte") + " more, of " +
                                      std::to_string(element_->count) + " " + element_->name + " records");
        bytes_.remove_prefix(size);
    }

    double scalar(Ply_type type) {
        const std::size_t size = ply_size(type);
        const char* const at = bytes_.data();
        skip(size);
        char little[8] = {};
        for (std::size_t i = 0; i < size; ++i) little[i] = at[big_endian_ ? size - 1 - i : i];
        return ply_decode(type, little);
    }

    void skip_list(const Ply_property& property) {
        // At most 2^32, as the header accepts integer types only, so the product is exact.
        skip(length_of(property) * ply_size(property.type));
    }

    /// The corners of a face, or of strips, in which -1 ends one.
    void read_list(const Ply_property& property, bool in_strips, std::vector<std::uint64_t>& corners) {
        for (std::uint64_t left = length_of(property); left > 0; --left) {
            const double index = scalar(property.type);
            if (in_strips && index == -1) {
                corners.push_back(end_of_strip);
                continue;
            }
            if (!(index >= 0 && index < 0x1p32 && index == std::floor(index)))
                fail("the index of a vertex is not an integer of 0 or more", "an integer of 0 or more");
            corners.push_back(static_cast<std::uint64_t>(index));
        }
    }

  private:
    std::uint64_t length_of(const Ply_property& property) {
        const double length = scalar(property.length_type);
        if (!(length >= 0)) fail("the length of " + property.name + " is negative", "a length of 0 or more");
        return static_cast<std::uint64_t>(length);
    }

    const std::string& name_;
    std::string_view bytes_;
    bool big_endian_;
    const Ply_element* element_ = nullptr;
    std::uint64_t record_ = 1;
};

void read_binary(const Source& source, std::string_view bytes, const Ply_header& header,
                 const Ply_vertex_columns& columns, Raw_points& raw, Raw_faces* faces) {
    Binary_reader reader(source.name, bytes, header.format == Ply_format::binary_big_endian);
    std::vector<double> values;
    std::vector<std::uint64_t> strips;
    for (const Ply_element& element : header.elements) {
        if (element.properties.empty()) continue;
        reader.enter(element, 1);
        // Every property takes at least one byte, so a count beyond the file cannot allocate memory.
        if (element.count > reader.left() / element.least_bytes())
            reader.fail("the file ends: only " + counted(reader.left(), "byte") + " are left for " +
                            std::to_string(element.count) + " records",
                        "at least " + std::to_string(element.least_bytes()) + " bytes for each");
        const bool is_vertex = element.name == "vertex";
        if (is_vertex) raw.points.reserve(element.count);
        for (std::uint64_t i = 1; i <= element.count; ++i) {
            reader.enter(element, i);
            values.clear();
            for (const Ply_property& property : element.properties) {
                if (property.is_list) {
                    if (faces != nullptr && is_face_list(element, property)) {
                        reader.read_list(property, false, faces->corners);
                        faces->close(i);
                    } else if (faces != nullptr && is_strip_list(element, property)) {
                        strips.clear();
                        reader.read_list(property, true, strips);
                        append_strips(strips, i, *faces);
                    } else {
                        reader.skip_list(property);
                    }
                    values.push_back(0.);
                    continue;
                }
                const double value = reader.scalar(property.type);
                if (is_vertex && columns.uses(values.size()) && !std::isfinite(value))
                    reader.fail(property.name + (std::isnan(value) ? " is nan" : " is infinite"), "a finite number",
                                Error_code::not_finite);
                values.push_back(value);
            }
            if (is_vertex) append_vertex(columns, values, i, raw);
        }
    }
    if (reader.left() > 0 && !header.elements.empty())
        reader.fail(counted(reader.left(), "byte") + " follow the last record", "the end of the file");
}

}  // namespace

Raw_points read_ply(const Source& source, Raw_faces* faces) {
    Raw_points raw;
    Line_reader reader(source);
    const Ply_header header = read_ply_header(reader);
    const Ply_vertex_columns columns = ply_vertex_columns(header, reader);
    raw.has_z = columns.z.has_value();
    if (header.format == Ply_format::ascii) read_ascii(reader, header, columns, raw, faces);
    else read_binary(source, reader.rest(), header, columns, raw, faces);
    return raw;
}

}  // namespace annulus::inline v1
