// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/solid_mesh.h>
#include <apps/cli/stopwatch.h>
#include <apps/cli/tracker.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1::cli {

template <class Moving>
Tracker<Moving>::Tracker(std::string name, std::span<const Coordinates<d>> points, const Options& options,
                         double spacing, std::uint64_t iterations, std::uint64_t audit_every, bool measure)
    : Run_tracker<Moving>(
          std::move(name), [&] { return Moving(points, options); }, options, spacing, iterations, audit_every,
          measure) {}

template <class Moving>
void Tracker<Moving>::step(std::span<const Coordinates<d>> x, double motion_seconds, double displacement_mean,
                           double displacement_max) {
    this->step([x](Moving& dt) { return dt.move_all(x); }, motion_seconds, {displacement_mean, displacement_max});
}

template <class Moving>
std::vector<Index> Tracker<Moving>::follow(std::span<const Index> leave, std::span<const Coordinates<d>> x,
                                           std::span<const Coordinates<d>> arrive, double motion_seconds,
                                           double displacement_mean, double displacement_max) {
    Move_result report;
    double seconds = 0;
    std::vector<Index> indices;
    const auto call = [&](auto change, bool counts) {
        Move_result one;
        const Stopwatch watch(this->threads());
        const Index arrived = change(one);
        seconds += watch.seconds();
        this->hear(one, arrived);
        if (!counts) one.moves = {};  // only the moves of move_all are counted
        report += one;
        return arrived;
    };
    for (const Index i : leave) (void)call([&](Move_result& one) { return this->mesh().remove(i, &one), none; }, false);
    (void)call([&](Move_result& one) { return one = this->mesh().move_all(x), none; }, true);
    for (const auto& p : arrive)
        indices.push_back(call([&](Move_result& one) { return this->mesh().insert(p, &one); }, false));
    this->record_step(report, seconds, motion_seconds, {displacement_mean, displacement_max});
    if (!leave.empty() || !arrive.empty()) this->note_changed_cells();
    return indices;
}

template <int d>
std::vector<std::array<Index, static_cast<std::size_t>(d) + 1>> canonical_cells(const Moving_mesh<d>& dt) {
    auto cells = dt.audit_input().cells;
    for (auto& c : cells)
        if constexpr (d == 3) {
            std::sort(c.begin(), c.end());  // the audit has checked the orientation
        } else if (c[2] == none) {
            if (c[0] > c[1]) std::swap(c[0], c[1]);
        } else {
            std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
        }
    std::sort(cells.begin(), cells.end());
    return cells;
}

template <int d>
std::vector<Boxed_cell<d>> canonical_cells(const Boxed_mesh<d>& dt) {
    const Periodic_cells<d> in = dt.mesh().cells();  // with offsets from 0 on
    std::vector<Boxed_cell<d>> cells(in.vertices.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
        for (std::size_t k = 0; k <= d; ++k) cells[c][k] = {in.vertices[c][k], in.offsets[c][k]};
        std::sort(cells[c].begin(), cells[c].end());  // the audit has checked the orientation
    }
    std::sort(cells.begin(), cells.end());
    return cells;
}

template std::vector<std::array<Index, 3>> canonical_cells<2>(const Moving_mesh_2&);
template std::vector<std::array<Index, 4>> canonical_cells<3>(const Moving_mesh_3&);
template std::vector<Boxed_cell<2>> canonical_cells<2>(const Boxed_mesh<2>&);
template std::vector<Boxed_cell<3>> canonical_cells<3>(const Boxed_mesh<3>&);

template class Tracker<Moving_mesh_2>;
template class Tracker<Moving_mesh_3>;

namespace {

Picture picture_of(std::vector<Coordinates<2>> points, const std::vector<std::array<Index, 3>>& cells,
                   std::string caption) {
    Picture picture;
    picture.caption = std::move(caption);
    for (const auto& c : cells)
        for (std::size_t i = 0; i < 3; ++i) {
            const Index a = c[i];
            const Index b = c[(i + 1) % 3];
            if (a == none || b == none) continue;
            picture.edges.push_back({std::min(a, b), std::max(a, b)});
        }
    std::sort(picture.edges.begin(), picture.edges.end());
    picture.edges.erase(std::unique(picture.edges.begin(), picture.edges.end()), picture.edges.end());
    picture.points = std::move(points);
    return picture;
}

}  // namespace

Picture picture_of(const Moving_mesh_2& dt, std::string caption) {
    Audit_input<2> in = dt.audit_input();
    return picture_of(std::move(in.points), in.cells, std::move(caption));
}

Picture picture_of(const Boxed_mesh<2>& dt, std::string caption) {
    Solid_mesh<2> mesh = cells_in_box(dt);
    Picture picture = picture_of(std::move(mesh.points), mesh.cells, std::move(caption) + with_images);
    picture.dots = Dots::images;
    picture.outline.push_back(outline_of(dt.box()));
    return picture;
}

}  // namespace annulus::inline v1::cli
