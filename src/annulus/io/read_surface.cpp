// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/io/read_surface.h>
#include <annulus/io/surface_formats.h>

#include <algorithm>
#include <map>
#include <utility>

namespace annulus {

namespace {

Raw_points read_raw(const std::filesystem::path& file, const Source& source, Raw_faces& faces) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (extension == ".off") return read_off(source, &faces);
    if (extension == ".obj") return read_obj(source, faces);
    if (extension == ".ply") return read_ply(source, &faces);
    if (extension == ".stl") return read_stl(source, faces);
    throw Input_error(Error_code::bad_input, source.name, 0,
                      extension.empty() ? "has no extension" : "has the unknown extension " + shown(extension),
                      ".off, .obj, .ply or .stl");
}

/// Numbers points from 0 in the order in which faces first name them, equal ones alike.
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

struct Half_edge {
    Index from, to;
    std::uint64_t line;
};

/// Every edge once in each direction.
void require_closed(const std::string& name, std::vector<Half_edge> edges) {
    const auto ends = [](const Half_edge& e) { return std::pair(std::min(e.from, e.to), std::max(e.from, e.to)); };
    std::sort(edges.begin(), edges.end(), [&](const Half_edge& a, const Half_edge& b) {
        return ends(a) != ends(b) ? ends(a) < ends(b) : a.line < b.line;
    });
    const Half_edge* open = nullptr;
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t next = i + 1;
        while (next < edges.size() && ends(edges[next]) == ends(edges[i])) ++next;
        if (next - i > 2)
            throw Input_error(Error_code::bad_input, name, edges[i + 2].line,
                              "an edge is in " + std::to_string(next - i) + " triangles", "a closed surface: two");
        if (next - i == 2 && edges[i].from == edges[i + 1].from)
            throw Input_error(
                Error_code::bad_input, name, edges[i + 1].line,
                "a triangle is turned against the one beside it, at line " + std::to_string(edges[i].line),
                "all counter-clockwise from outside");
        if (next - i == 1 && (open == nullptr || edges[i].line < open->line)) open = &edges[i];
        i = next;
    }
    if (open != nullptr)
        throw Input_error(Error_code::bad_input, name, open->line, "an edge is in one triangle only: a hole",
                          "a closed surface");
}

}  // namespace

Surface_file read_surface(const std::filesystem::path& file) {
    const Source source = load_file(file);
    Raw_faces faces;
    const Raw_points raw = read_raw(file, source, faces);
    Surface_file result;
    result.name = source.name;
    Triangle_surface& surface = result.surface;
    const auto fail = [&](std::uint64_t line, std::string fault, std::string expected) {
        throw Input_error(Error_code::bad_input, source.name, line, std::move(fault), std::move(expected));
    };
    if (faces.size() == 0) fail(1, "has no faces", "a closed surface");

    Numbering number(raw, surface);
    std::vector<Half_edge> edges;
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
            for (std::size_t i = 0; i < 3; ++i) edges.push_back({t[i], t[(i + 1) % 3], faces.lines[f]});
        }
    }
    require_closed(source.name, std::move(edges));
    result.merged = number.merged();
    const double volume = enclosed_volume(surface);
    if (!(volume > 0 || volume < 0)) fail(1, "encloses no volume", "a surface around something");
    if (volume < 0)
        for (auto& t : surface.triangles) std::swap(t[1], t[2]);
    return result;
}

}  // namespace annulus
