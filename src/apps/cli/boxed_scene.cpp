// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/boxed_scene.h>

#include <annulus/error.h>
#include <apps/cli/frame_box.h>
#include <apps/cli/input.h>
#include <apps/motion/boxed_points.h>
#include <apps/motion/periodic_lloyd.h>

#include <cmath>
#include <numeric>

namespace annulus::inline v1::cli {

void add_lloyd_box(CLI::App& app, std::string& box) {
    app.add_option("--box", box,
                   "Periodic box, 2D or 3D, in place of a domain and of that of the input: the lengths of its edges,\n"
                   "Lx,Ly or Lx,Ly,Lz, or its vectors, 4 or 9 numbers, one vector after the other")
        ->type_name("LIST");
}

void require_boxed(const Lloyd_arguments& a) {
    const auto refuse = [](const char* what) { throw Error(Error_code::usage, what); };
    if (a.open) refuse("--open and --box exclude each other");
    if (!a.domain.empty() || a.radius != 0 || !a.size.empty())
        refuse("with --box the domain is the periodic box: no --domain, --radius or --size");
    if (a.keep_boundary) refuse("--keep-boundary is for polygons: a periodic box has no boundary");
    if (a.density != "one" || a.invert || a.dots != "equal")
        refuse("in a periodic box the density is one: no other --density, no picture with --invert or --dots");
    if (a.points == 0 && a.input.empty())
        refuse("say how many points with --points N, or name a file with --input FILE");
}

template <int d>
Boxed_scene<d> Boxed_scene<d>::made_of(const Lloyd_arguments& a, const std::string& box, std::uint64_t seed) {
    Boxed_scene scene{.box = box_of<d>(parse_box(box))};
    if (a.input.empty()) {
        scene.points = generate_in<d>(scene.box, Point_family::uniform, static_cast<std::size_t>(a.points), seed);
        return scene;
    }
    scene.file = read_points<d>(a.input, {.ignore_z = a.ignore_z, .format = a.format, .box = {.replaced = true}});
    scene.points = distinct_points(*scene.file, 1, &scene.box).x;
    scene.merged = scene.file->points.size() - scene.points.size();
    return scene;
}

template <int d>
std::vector<std::uint64_t> Boxed_scene<d>::ids() const {
    std::vector<std::uint64_t> id(points.size());
    std::iota(id.begin(), id.end(), std::uint64_t{0});
    return id;
}

template <int d>
double Boxed_scene<d>::spacing() const {
    return std::pow(box.volume() / static_cast<double>(points.size()), 1.0 / d);
}

template <int d>
Boxed_mesh<d> Boxed_scene<d>::mesh(const Options& options) const {
    return Boxed_mesh<d>(ids(), points, box, options);
}

template <int d>
Input_record Boxed_scene<d>::input() const {
    Input_record input;
    if (file) input = input_of(*file);
    input.box_from = "--box";
    for (const auto& vector : box.vectors()) input.box.emplace_back(vector.begin(), vector.end());
    return input;
}

template <int d>
Displacement find_centroids(const Periodic_mesh<d>& mesh, std::vector<Coordinates<d>>& target) {
    const std::vector<Coordinates<d>> offset = periodic_centroid_offsets<d>(mesh.audit_input());
    target.assign(mesh.points().begin(), mesh.points().end());
    Displacement way;
    for (std::size_t v = 0; v < target.size(); ++v) {
        double square = 0;
        for (std::size_t k = 0; k < d; ++k) {
            target[v][k] += offset[v][k];
            square += offset[v][k] * offset[v][k];
        }
        way.mean += std::sqrt(square) / static_cast<double>(target.size());
        way.max = std::max(way.max, std::sqrt(square));
    }
    return way;
}

template struct Boxed_scene<2>;
template struct Boxed_scene<3>;
template Displacement find_centroids<2>(const Periodic_mesh<2>&, std::vector<Coordinates<2>>&);
template Displacement find_centroids<3>(const Periodic_mesh<3>&, std::vector<Coordinates<3>>&);

}  // namespace annulus::inline v1::cli
