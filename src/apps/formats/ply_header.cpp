// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/ply_header.h>

#include <bit>
#include <cstring>

namespace annulus::inline v1 {

namespace {

std::optional<Ply_type> type_named(std::string_view name) {
    if (name == "char" || name == "int8") return Ply_type::int8;
    if (name == "uchar" || name == "uint8") return Ply_type::uint8;
    if (name == "short" || name == "int16") return Ply_type::int16;
    if (name == "ushort" || name == "uint16") return Ply_type::uint16;
    if (name == "int" || name == "int32") return Ply_type::int32;
    if (name == "uint" || name == "uint32") return Ply_type::uint32;
    if (name == "float" || name == "float32") return Ply_type::float32;
    if (name == "double" || name == "float64") return Ply_type::float64;
    return std::nullopt;
}

Ply_type type_of(const Line_reader& reader, std::string_view name) {
    const auto type = type_named(name);
    if (!type) reader.fail("unknown type " + shown(name), "char, uchar, short, ushort, int, uint, float or double");
    return *type;
}

Ply_format format_of(const Line_reader& reader) {
    const auto& fields = reader.fields();
    const std::string expected = "format ascii|binary_little_endian|binary_big_endian 1.0";
    if (fields.size() != 3 || fields[2] != "1.0") reader.fail("bad format line", expected);
    if (fields[1] == "ascii") return Ply_format::ascii;
    if (fields[1] == "binary_little_endian") return Ply_format::binary_little_endian;
    if (fields[1] == "binary_big_endian") return Ply_format::binary_big_endian;
    reader.fail("unknown format " + shown(fields[1]), expected);
}

Ply_property property_of(const Line_reader& reader) {
    const auto& fields = reader.fields();
    Ply_property property;
    if (fields.size() == 3) {
        property.type = type_of(reader, fields[1]);
    } else if (fields.size() == 5 && fields[1] == "list") {
        property.is_list = true;
        property.length_type = type_of(reader, fields[2]);
        property.type = type_of(reader, fields[3]);
        if (property.length_type == Ply_type::float32 || property.length_type == Ply_type::float64)
            reader.fail("the length of a list is no integer type: " + shown(fields[2]), "an integer type");
    } else {
        reader.fail("bad property line", "property TYPE NAME or property list TYPE TYPE NAME");
    }
    property.name = std::string(fields.back());
    return property;
}

template <class T>
double decoded(const char* little_endian, std::size_t size) noexcept {
    char bytes[sizeof(T)];
    for (std::size_t i = 0; i < size; ++i)
        bytes[i] = little_endian[std::endian::native == std::endian::little ? i : size - 1 - i];
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

}  // namespace

std::size_t ply_size(Ply_type type) noexcept {
    switch (type) {
        case Ply_type::int8:
        case Ply_type::uint8: return 1;
        case Ply_type::int16:
        case Ply_type::uint16: return 2;
        case Ply_type::int32:
        case Ply_type::uint32:
        case Ply_type::float32: return 4;
        case Ply_type::float64: break;
    }
    return 8;
}

double ply_decode(Ply_type type, const char* little_endian) noexcept {
    switch (type) {
        case Ply_type::int8: return decoded<std::int8_t>(little_endian, 1);
        case Ply_type::uint8: return decoded<std::uint8_t>(little_endian, 1);
        case Ply_type::int16: return decoded<std::int16_t>(little_endian, 2);
        case Ply_type::uint16: return decoded<std::uint16_t>(little_endian, 2);
        case Ply_type::int32: return decoded<std::int32_t>(little_endian, 4);
        case Ply_type::uint32: return decoded<std::uint32_t>(little_endian, 4);
        case Ply_type::float32: return decoded<float>(little_endian, 4);
        case Ply_type::float64: break;
    }
    return decoded<double>(little_endian, 8);
}

std::uint64_t Ply_element::least_bytes() const noexcept {
    std::uint64_t bytes = 0;
    for (const Ply_property& property : properties)
        bytes += ply_size(property.is_list ? property.length_type : property.type);
    return bytes;
}

Ply_header read_ply_header(Line_reader& reader) {
    Ply_header header;
    bool has_format = false;
    if (!reader.next_record() || reader.fields()[0] != "ply" || reader.number() != 1)
        reader.fail("does not begin with ply", "the word ply alone on the first line");
    while (reader.next_record()) {
        const auto& fields = reader.fields();
        const std::string_view keyword = fields[0];
        if (keyword == "end_header") {
            if (!has_format) reader.fail("the header has no format line", "format ascii 1.0 or a binary one");
            return header;
        }
        if (keyword == "comment" || keyword == "obj_info") continue;
        if (keyword == "format") {
            header.format = format_of(reader);
            has_format = true;
        } else if (keyword == "element") {
            if (fields.size() != 3) reader.fail("bad element line", "element NAME COUNT");
            header.elements.push_back(
                {std::string(fields[1]), reader.whole(fields[2], "the count of the element"), {}});
        } else if (keyword == "property") {
            if (header.elements.empty()) reader.fail("a property before any element", "element NAME COUNT");
            header.elements.back().properties.push_back(property_of(reader));
        } else {
            reader.fail("unknown header line " + shown(keyword),
                        "format, element, property, comment, obj_info or end_header");
        }
    }
    reader.fail("the file ends within its header", "end_header");
}

Ply_vertex_columns ply_vertex_columns(const Ply_header& header, const Line_reader& reader) {
    std::optional<std::size_t> found[3];
    std::size_t vertices = 0;
    for (const Ply_element& element : header.elements) {
        if (element.name != "vertex") continue;
        ++vertices;
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            const Ply_property& property = element.properties[i];
            for (std::size_t k = 0; k < 3; ++k) {
                if (property.name.size() != 1 || property.name[0] != "xyz"[k]) continue;
                if (found[k] || property.is_list)
                    reader.fail("the element vertex has no plain property " + property.name,
                                "one number " + property.name);
                found[k] = i;
            }
        }
    }
    if (vertices != 1) reader.fail("the header has " + counted(vertices, "element") + " vertex", "one element vertex");
    if (!found[0] || !found[1])
        reader.fail(std::string("the element vertex has no property ") + (found[0] ? "y" : "x"), "properties x, y, z");
    return {*found[0], *found[1], found[2]};
}

}  // namespace annulus::inline v1
