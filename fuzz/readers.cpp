// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes -> a file -> a reader. The first byte says which: A to Y of the table below, a to y the same packed by gzip.
// The result of a reader satisfies its header's contract; exceptions are an Input_error in one line; allocations are
// bounded by the bytes of the file.
#include <apps/formats/frame_points.h>
#include <apps/formats/read_gray_image.h>
#include <apps/formats/read_image.h>
#include <apps/formats/read_mesh.h>
#include <apps/formats/read_motion.h>
#include <apps/formats/read_points.h>
#include <apps/formats/read_surface.h>
#include <apps/formats/read_tetrahedra.h>
#include <common/largest_allocation.h>
#include <common/scratch_file.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace annulus;
namespace fs = std::filesystem;
using annulus::fuzz::gzip;
using annulus::fuzz::Memory;
using annulus::fuzz::Scratch;

void require(bool holds, const char* promise) {
    if (holds) return;
    std::cerr << "// broken: " << promise << "\n";
    std::abort();
}

void check_error(const Input_error& error, const fs::path& file, std::size_t size) {
    const std::string what = error.what();
    require(error.file() == file.string() && what.starts_with(error.file()), "an error names the file");
    require(!error.fault().empty() && !error.expected().empty(), "a fault, and what was expected");
    require(std::none_of(what.begin(), what.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }),
            "an error is one line");
    require(error.line() <= size + 1, "a line that is there");
}

template <std::size_t d>
bool finite(const std::vector<std::array<double, d>>& points) {
    return std::all_of(points.begin(), points.end(), [](const auto& p) {
        return std::all_of(p.begin(), p.end(), [](double c) { return std::isfinite(c); });
    });
}

template <std::size_t d>
bool distinct(std::vector<std::array<double, d>> points) {
    std::sort(points.begin(), points.end());
    return std::adjacent_find(points.begin(), points.end()) == points.end();
}

bool from_1(const std::vector<std::uint64_t>& lines) {
    return std::all_of(lines.begin(), lines.end(), [](std::uint64_t line) { return line > 0; });
}

template <int d>
void check_points(const Point_file<d>& file) {
    require(!file.points.empty() && finite(file.points), "points, all finite");
    require(file.lines.size() == file.points.size() && from_1(file.lines), "a line for each point");
    const std::vector<Coordinates<d>> x = distinct_points(file, 2).x;
    require(x.size() >= 2 && x.size() <= file.points.size() && distinct(x), "distinct points");
}

void points(const fs::path& file) {
    std::visit([](const auto& f) { check_points(f); }, read_points_of_any_dimension(file, {.box = {.ignored = true}}));
}

template <int d>
void check_frame(const Recorded_motion& motion, const Frame& frame) {
    const Frame_points<d> merged = points_of<d>(motion.name, frame, Coincident::merge);
    require(distinct(merged.x) && merged.id.size() == merged.x.size(), "distinct points in a frame");
    require(merged.merged + merged.id.size() == frame.id.size(), "every point is kept or merged");
    bool refused = false;
    try {
        (void)points_of<d>(motion.name, frame, Coincident::refuse);
    } catch (const Input_error& error) {
        refused = error.code() == Error_code::duplicate_point;
    }
    require(refused == (merged.merged > 0), "points at one place are refused, others not");
}

/// Reading frame by frame gives the same as reading at once, and is_flat is correct.
void check_motion(const fs::path& file, const Recorded_motion& m, const Motion_options& options) {
    std::size_t all = 0;
    for (const Frame& f : m.frames) {
        all += f.id.size();
        require(f.id.size() == f.position.size() && f.id.size() == f.line.size(), "an id and a line for each point");
        require(finite(f.position) && from_1(f.line), "finite points with a line");
        require(std::adjacent_find(f.id.begin(), f.id.end(), std::greater_equal<>()) == f.id.end(), "ids ascend");
    }
    require(all > 0, "a point in some frame");
    for (const Frame& f : m.frames) {
        check_frame<2>(m, f);
        if (m.has_z) check_frame<3>(m, f);
    }
    std::set<double> z;
    Motion_reader reader(file, options);
    Frame frame;
    for (const Frame& f : m.frames) {
        require(!reader.at_end() && reader.next(frame) && frame.id == f.id && frame.position == f.position,
                "the same frames one by one");
        for (const auto& p : f.position) z.insert(p[2]);
        require(f.box.has_value() == frame.box.has_value(), "the same boxes one by one");
        require(!f.box || from_1(std::vector{f.box->line}), "boxes with a line");
    }
    require(reader.at_end() && !reader.next(frame), "an end");
    require(is_flat(file, options) == (z.size() == 1), "flat where z is the same everywhere");
}

template <Absent_frames absent>
void motion(const fs::path& file) {
    const Motion_options options{.absent = absent, .box = {.taken = absent == Absent_frames::skip, .ignored = true}};
    const Recorded_motion m = read_motion(file, options);
    for (std::size_t i = 1; i < m.frames.size(); ++i)
        require(m.frames[i - 1].number < m.frames[i].number, "numbers of frames ascend");
    check_motion(file, m, options);
}

void dump(const fs::path& file) {
    const Motion_options options{.box = {.taken = true}};
    check_motion(file, read_motion(file, options), options);
}

/// A table whose columns the caller names, by names and by numbers.
void named(const fs::path& file) {
    for (const char* columns : {"id=a,frame=b,x=c,y=d", "id=1,frame=2,x=3,y=4,z=5"}) {
        const Motion_options options{
            .absent = Absent_frames::skip, .box = {.ignored = true}, .columns = parse_column_choice(columns)};
        try {
            check_motion(file, read_motion(file, options), options);
        } catch (const Input_error& error) {
            check_error(error, file, std::numeric_limits<std::size_t>::max() - 1);  // the file may be packed
        }
    }
}

/// Rows taken as they come are those of the frames in order.
void any_order(const fs::path& file) {
    File_bytes bytes(file);
    const auto frames = frames_of(bytes, Format::csv, {.box = {.ignored = true}, .in_order = false});
    Raw_frame raw;
    std::size_t rows = 0;
    while (frames->next(raw)) rows += raw.points.points.size();
    const Recorded_motion m = read_motion(file, {.absent = Absent_frames::skip});
    std::size_t points = 0;
    for (const Frame& frame : m.frames) points += frame.position.size();
    require(points == rows, "the same rows in any order");
}

void check_closed(const Triangle_surface& s) {
    require(finite(s.points) && distinct(s.points), "points finite and distinct");
    std::set<Index> used;
    std::map<std::pair<Index, Index>, int> edges;
    for (const auto& t : s.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            require(t[i] >= 0 && static_cast<std::size_t>(t[i]) < s.points.size(), "corners that are there");
            used.insert(t[i]);
            ++edges[{t[i], t[(i + 1) % 3]}];
        }
    require(used.size() == s.points.size(), "every point is used");
    for (const auto& [edge, count] : edges) {
        const auto back = edges.find({edge.second, edge.first});
        require(count == 1 && edge.first != edge.second && back != edges.end() && back->second == 1, "closed");
    }
}

void surface(const fs::path& file) {
    const Triangle_surface s = read_surface(file).surface;
    check_closed(s);
    require(enclosed_volume(s) > 0, "a positive volume");
}

void check_tetrahedra(const Tetrahedra_file& m) {
    require(finite(m.points) && distinct(m.points), "points finite and distinct");
    require(m.cell_lines.size() == m.cells.size() && from_1(m.cell_lines), "a line for each cell");
    std::set<Index> used;
    for (const auto& cell : m.cells) used.insert(cell.begin(), cell.end());
    require(used.size() == m.points.size() && *used.begin() == 0 &&
                *used.rbegin() + 1 == static_cast<Index>(m.points.size()),
            "every point is used");
    require(m.boundary.triangles.size() == m.boundary.cells.size(), "a cell behind each facet");
    check_closed(m.surface());
}

template <int d>
void check_mesh(const Mesh_file<d>& m) {
    require(!m.points.empty() && !m.cells.empty() && finite(m.points), "points, finite, and cells");
    require(m.point_lines.size() == m.points.size() && from_1(m.point_lines), "a line for each point");
    require(m.cell_lines.size() == m.cells.size() && from_1(m.cell_lines), "a line for each cell");
    for (auto cell : m.cells) {
        const bool edge = d == 2 && cell.back() == none;
        std::sort(cell.begin(), cell.end() - (edge ? 1 : 0));
        require(std::adjacent_find(cell.begin(), cell.end()) == cell.end(), "corners that differ");
        for (std::size_t i = 0; i < cell.size() - (edge ? 1 : 0); ++i)
            require(cell[i] >= 0 && static_cast<std::size_t>(cell[i]) < m.points.size(), "corners that are there");
    }
}

void mesh(const fs::path& file) {
    const auto read = read_mesh(file);
    std::visit([](const auto& m) { check_mesh(m); }, read);
    if (std::holds_alternative<Mesh_file<3>>(read)) check_tetrahedra(read_tetrahedra(file));
}

void image(const fs::path& file) {
    const Labelled_image i = read_image(file);
    require(i.label.size() == i.size[0] * i.size[1] * i.size[2] && !i.label.empty(), "a label for every voxel");
    for (const double length : i.spacing) require(length > 0 && std::isfinite(length), "positive lengths");
}

void picture(const fs::path& file) {
    const Gray_image i = read_gray_image(file);
    require(i.value.size() == i.width * i.height && !i.value.empty(), "a value for every pixel");
    require(std::all_of(i.value.begin(), i.value.end(), [&](std::uint16_t v) { return v <= i.white; }),
            "no value above white");
}

struct Kind {
    const char* extension;
    void (*read)(const fs::path&);
};
constexpr Kind kinds[] = {
    {".xyz", points},                         // A
    {".csv", points},                         // B
    {".off", points},                         // C
    {".ply", points},                         // D
    {".mesh", points},                        // E
    {".xyz", motion<Absent_frames::skip>},    // F
    {".csv", motion<Absent_frames::refuse>},  // G
    {".csv", motion<Absent_frames::empty>},   // H
    {".csv", motion<Absent_frames::skip>},    // I
    {".off", surface},                        // J
    {".obj", surface},                        // K
    {".stl", surface},                        // L
    {".ply", surface},                        // M
    {".mesh", mesh},                          // N
    {".inr", image},                          // O
    {".xyz.gz", points},                      // P: the bytes are the packed ones
    {".lammpstrj", points},                   // Q
    {".dump", dump},                          // R
    {".pgm", picture},                        // S
    {".png", picture},                        // T
    {".npy", points},                         // U
    {".npy", dump},                           // V
    {".csv", named},                          // W
    {".csv", any_order},                      // X
    {".txt", motion<Absent_frames::skip>},    // Y
    {".ppm", picture},                        // Z
    {".jpg", picture},                        // [
};
constexpr unsigned packed_bytes = 15;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Scratch scratch;
    if (size == 0) return 0;
    const std::string_view content(reinterpret_cast<const char*>(data) + 1, size - 1);
    const unsigned letter = data[0] - unsigned{'A'};
    const auto which = static_cast<unsigned>(letter % 32 % std::size(kinds));
    const Kind& kind = kinds[which];
    const bool packed = (letter & 32) != 0 && which != packed_bytes;
    const fs::path file = scratch.file(std::string("a") + kind.extension + (packed ? ".gz" : ""),
                                       packed ? gzip(content) : std::string(content));
    Memory::reset();
    try {
        kind.read(file);
    } catch (const Input_error& error) {
        check_error(error, file, content.size());
    }
    // Deflate packs a thousand bytes into one at the best, or eight thousand pixels of a bit each; JPEG 512 pixels.
    const std::string_view extension = kind.extension;
    const bool deflated = which == packed_bytes || extension == ".png" || extension == ".jpg";
    const std::size_t most = (std::size_t{1} << 20) + (deflated ? 100'000 : 200) * size;
    if (Memory::peak > most) {
        std::cerr << "// " << Memory::peak << " bytes of memory for " << size << " bytes of input\n";
        std::abort();
    }
    return 0;
}
