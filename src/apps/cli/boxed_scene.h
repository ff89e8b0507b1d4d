// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/options.h>
#include <apps/cli/boxed_mesh.h>
#include <apps/cli/lloyd_scene.h>
#include <apps/cli/run_tracker.h>
#include <apps/formats/read_points.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1::cli {

void add_lloyd_box(CLI::App& app, std::string& box);

/// Throws Error(usage) for arguments of Lloyd iterations that are for open boundaries only.
void require_boxed(const Lloyd_arguments& arguments);

/// Points of Lloyd iterations in a periodic box, no two images of one another, and how the file was interpreted.
template <int d>
struct Boxed_scene {
    Box<d> box;
    std::vector<Coordinates<d>> points{};
    std::uint64_t merged = 0;
    std::optional<Point_file<d>> file{};

    /// In the box of --box. Throws Input_error or Error.
    [[nodiscard]] static Boxed_scene made_of(const Lloyd_arguments& arguments, const std::string& box,
                                             std::uint64_t seed);
    /// 0, 1, ..
    [[nodiscard]] std::vector<std::uint64_t> ids() const;
    /// The d-th root of the volume of the box per point.
    [[nodiscard]] double spacing() const;
    /// The triangulation of the points.
    [[nodiscard]] Boxed_mesh<d> mesh(const Options& options) const;
    [[nodiscard]] Input_record input() const;
};

/// Where Lloyd's iteration moves the points, the centroids of their cells, and how far. O(n).
template <int d>
[[nodiscard]] Displacement find_centroids(const Periodic_mesh<d>& mesh, std::vector<Coordinates<d>>& target);

extern template struct Boxed_scene<2>;
extern template struct Boxed_scene<3>;
extern template Displacement find_centroids<2>(const Periodic_mesh<2>&, std::vector<Coordinates<2>>&);
extern template Displacement find_centroids<3>(const Periodic_mesh<3>&, std::vector<Coordinates<3>>&);

}  // namespace annulus::inline v1::cli
