// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/formats/markup.h>
#include <apps/formats/write_vtu.h>

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <new>

namespace annulus::inline v1 {

namespace {

void append_base64(std::string& out, std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    out.reserve(out.size() + (bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t have = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word = word << 8 | (k < have ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) out += k <= have ? digits[word >> (18 - 6 * k) & 63] : '=';
    }
}

template <class T>
constexpr const char* type_name = nullptr;
template <>
constexpr const char* type_name<double> = "Float64";
template <>
constexpr const char* type_name<std::int64_t> = "Int64";
template <>
constexpr const char* type_name<std::uint64_t> = "UInt64";
template <>
constexpr const char* type_name<std::uint8_t> = "UInt8";

/// As VTK reads it: the number of blocks, the length of one and of the last if it is shorter, their packed lengths
/// (UInt64), encoded as one piece; then the blocks, as another.
void append_packed(std::string& out, const char* bytes, std::size_t size) {
    constexpr std::size_t block = std::size_t{1} << 18;
    std::vector<std::uint64_t> header{(size + block - 1) / block, block, size % block};
    std::string packed;
    for (std::size_t first = 0; first < size; first += block) {
        const std::size_t now = std::min(block, size - first);
        uLongf length = ::compressBound(static_cast<uLong>(now));
        const std::size_t before = packed.size();
        packed.resize(before + length);
        if (::compress2(reinterpret_cast<Bytef*>(packed.data() + before), &length,
                        reinterpret_cast<const Bytef*>(bytes + first), static_cast<uLong>(now), 1) != Z_OK)
            throw std::bad_alloc();
        packed.resize(before + length);
        header.push_back(length);
    }
    append_base64(out, {reinterpret_cast<const char*>(header.data()), header.size() * sizeof header[0]});
    append_base64(out, packed);
}

/// One DataArray.
template <class T>
void append_array(std::string& out, std::string_view name, int components, const std::vector<T>& values) {
    out += std::string("        <DataArray type=\"") + type_name<T> + "\" Name=\"" + escaped(name) + '"';
    if (components > 1) out += " NumberOfComponents=\"" + std::to_string(components) + '"';
    out += " format=\"binary\">";
    append_packed(out, reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    out += "</DataArray>\n";
}

void append_fields(std::string& out, const char* section, std::span<const Vtu_field> fields, std::size_t size) {
    out += std::string("      <") + section + ">\n";
    for (const Vtu_field& field : fields)
        std::visit(
            [&](const auto& values) {
                if (values.size() != size)
                    throw Error(Error_code::wrong_size, "write_vtu: the field " + field.name + " has " +
                                                            std::to_string(values.size()) + " values for " +
                                                            std::to_string(size) + " items");
                append_array(out, field.name, 1, values);
            },
            field.values);
    out += std::string("      </") + section + ">\n";
}

constexpr std::uint8_t vtk_triangle = 5;
constexpr std::uint8_t vtk_tetra = 10;

/// Points with three coordinates each, and cells of any kind.
struct Grid {
    std::vector<double> coordinates;
    std::vector<std::int64_t> connectivity, offsets;
    std::vector<std::uint8_t> types;

    template <std::size_t n>
    void add(std::span<const std::array<Index, n>> cells, std::uint8_t type) {
        for (const auto& cell : cells) {
            for (const Index i : cell) {
                if (i < 0 || 3 * static_cast<std::size_t>(i) >= coordinates.size())
                    throw Error(Error_code::unknown_vertex, "write_vtu: a cell names no point");
                connectivity.push_back(i);
            }
            offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
        }
        types.resize(offsets.size(), type);
    }
};

template <int d>
Grid grid_of(std::span<const Coordinates<d>> points) {
    Grid grid;
    grid.coordinates.resize(3 * points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        std::copy(points[i].begin(), points[i].end(), grid.coordinates.begin() + static_cast<std::ptrdiff_t>(3 * i));
    return grid;
}

std::string text_of(const Grid& grid, std::span<const Vtu_field> point_fields, std::span<const Vtu_field> cell_fields) {
    std::string out =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
        "byte_order=\"";
    out += std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
    out +=
        "\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n  <UnstructuredGrid>\n    <Piece "
        "NumberOfPoints=\"" +
        std::to_string(grid.coordinates.size() / 3) + "\" NumberOfCells=\"" + std::to_string(grid.types.size()) +
        "\">\n";
    append_fields(out, "PointData", point_fields, grid.coordinates.size() / 3);
    append_fields(out, "CellData", cell_fields, grid.types.size());
    out += "      <Points>\n";
    append_array(out, "Points", 3, grid.coordinates);
    out += "      </Points>\n      <Cells>\n";
    append_array(out, "connectivity", 1, grid.connectivity);
    append_array(out, "offsets", 1, grid.offsets);
    append_array(out, "types", 1, grid.types);
    out += "      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n";
    return out;
}

}  // namespace

template <int d>
std::string write_vtu(std::span<const Coordinates<d>> points,
                      std::span<const std::array<Index, static_cast<std::size_t>(d) + 1>> cells,
                      std::span<const Vtu_field> point_fields, std::span<const Vtu_field> cell_fields) {
    static_assert(d == 2 || d == 3);
    Grid grid = grid_of<d>(points);
    grid.connectivity.reserve(cells.size() * (static_cast<std::size_t>(d) + 1));
    grid.offsets.reserve(cells.size());
    grid.add(cells, d == 2 ? vtk_triangle : vtk_tetra);
    return text_of(grid, point_fields, cell_fields);
}

std::string write_vtu(const Mesh_part& part, std::span<const Vtu_field> point_fields,
                      std::span<const Vtu_field> cell_fields) {
    Grid grid = grid_of<3>(part.points);
    grid.add(std::span<const std::array<Index, 4>>(part.tetrahedra), vtk_tetra);
    grid.add(std::span<const std::array<Index, 3>>(part.triangles), vtk_triangle);
    return text_of(grid, point_fields, cell_fields);
}

template std::string write_vtu<2>(std::span<const Coordinates<2>>, std::span<const std::array<Index, 3>>,
                                  std::span<const Vtu_field>, std::span<const Vtu_field>);
template std::string write_vtu<3>(std::span<const Coordinates<3>>, std::span<const std::array<Index, 4>>,
                                  std::span<const Vtu_field>, std::span<const Vtu_field>);

}  // namespace annulus::inline v1
