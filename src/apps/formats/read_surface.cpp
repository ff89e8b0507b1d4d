// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/file_bytes.h>
#include <apps/formats/format.h>
#include <apps/formats/read_surface.h>
#include <apps/formats/surface_formats.h>
#include <apps/motion/surface_faults.h>

#include <algorithm>
#include <map>
#include <utility>

namespace annulus::inline v1 {

namespace {

Raw_points read_raw(Format format, const Source& source, Raw_faces& faces) {
    switch (format) {
        case Format::off: return read_off(source, &faces);
        case Format::obj: return read_obj(source, faces);
        case Format::ply: return read_ply(source, &faces);
        default: return read_stl(source, faces);
    }
}

/// Numbers points from 0 in the order in which faces first name them; equal points have the same number.
class Numbering {
  public:
    Numbering(const Raw_points& raw, Triangle_surface& surface)
        : raw_(raw), surface_(surface), index_(raw.points.size(), none) {}

    Index operator()(std::uint64_t corner) {
        Index& index = index_[corner];
        if (index != none) return index;
        Coordinates<3> p = raw_.points[corner];
        for (double& x : p) x += 0.0;  // -0 is 0
        const auto [at, is_new] = seen_.emplace(p, static_cast<Index>(surface_.points.size()));
        if (is_new) surface_.points.push_back(p);
        else ++merged_;
        return index = at->second;
    }
    [[nodiscard]] std::uint64_t merged() const { return merged_; }

  private:
    const Raw_points& raw_;
    Triangle_surface& surface_;
    std::vector<Index> index_;
    std::map<Coordinates<3>, Index> seen_;
    std::uint64_t merged_ = 0;
};

/// Checks that every edge occurs once in each direction. `lines` are those of the triangles.
void require_closed(const std::string& name, const Triangle_surface& surface, const std::vector<std::uint64_t>& lines) {
    const auto fault = edge_fault(surface.triangles);
    if (!fault) return;
    const auto fail = [&](const std::string& what, const std::string& expected) {
        throw Input_error(Error_code::bad_input, name, lines[fault->triangle], what, expected);
    };
    switch (fault->kind) {
        case Edge_fault::Kind::open: return fail("an edge is in one triangle only: a hole", "a closed surface");
        case Edge_fault::Kind::crowded:
            return fail("an edge is in " + std::to_string(fault->count) + " triangles", "a closed surface: two");
        case Edge_fault::Kind::turned:
            return fail(
                "a triangle is turned against the one beside it, at line " + std::to_string(lines[fault->other]),
                "all counter-clockwise from outside");
    }
}

}  // namespace

Surface_file read_surface(const std::filesystem::path& file) {
    File_bytes bytes(file);
    const Format format = format_of(file, surface_formats);
    const Source source = load_file(bytes);
    Raw_faces faces;
    const Raw_points raw = read_raw(format, source, faces);
    Surface_file result;
    result.name = source.name;
    Triangle_surface& surface = result.surface;
    const auto fail = [&](std::uint64_t line, std::string fault, std::string expected) {
        throw Input_error(Error_code::bad_input, source.name, line, std::move(fault), std::move(expected));
    };
    if (faces.size() == 0)
        fail(1, "has no faces", "a closed surface, its faces one by one (in PLY the element face, or tristrips)");

    Numbering number(raw, surface);
    std::vector<std::uint64_t> lines;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto corners = faces.of(f);
        if (corners.size() < 3) fail(faces.lines[f], "a face of " + counted(corners.size(), "corner"), "at least 3");
        for (const std::uint64_t c : corners)
            if (c >= raw.points.size())
                fail(faces.lines[f],
                     "a face names vertex " + std::to_string(c) + " (from 0) of " + std::to_string(raw.points.size()),
                     "one that is there");
        for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
            const std::array<Index, 3> t{number(corners[0]), number(corners[k]), number(corners[k + 1])};
            if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
                fail(faces.lines[f], "a triangle has two corners at one point", "three different points");
            surface.triangles.push_back(t);
            lines.push_back(faces.lines[f]);
        }
    }
    require_closed(source.name, surface, lines);
    result.merged = number.merged();
    const double volume = enclosed_volume(surface);
    if (!(volume > 0 || volume < 0)) fail(1, "encloses no volume", "a surface around something");
    if (volume < 0)
        for (auto& t : surface.triangles) std::swap(t[1], t[2]);
    return result;
}

}  // namespace annulus::inline v1
