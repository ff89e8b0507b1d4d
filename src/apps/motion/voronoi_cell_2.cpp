// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/voronoi_cell_2.h>

#include <apps/motion/vector_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace annulus::inline v1 {

const Cell_2& Voronoi_cell_2::operator()(const Coordinates<2>& site, std::span<const Index> neighbours,
                                         std::span<const Coordinates<2>> position, bool cyclic) {
    plump_ = false;
    if (!cyclic || !from_circumcentres(site, neighbours, position)) from_bisectors(site, neighbours, position);
    return cell_;
}

bool Voronoi_cell_2::from_circumcentres(const Coordinates<2>& site, std::span<const Index> neighbours,
                                        std::span<const Coordinates<2>> position) {
    const std::size_t n = neighbours.size();
    if (n < 3) return false;
    cell_.origin = site;
    cell_.corners.resize(n);
    Corner_2* const corner = cell_.corners.data();
    Coordinates<2> a = minus(position[static_cast<std::size_t>(neighbours.back())], site);
    double a2 = dot(a, a);
    bool good = true;
    for (std::size_t i = 0; i < n; ++i) {
        const Coordinates<2> b = minus(position[static_cast<std::size_t>(neighbours[i])], site);
        const double b2 = dot(b, b), turn = cross(a, b);
        // Sine of the angle at the site below 2^-24, or NaN, or clockwise.
        good = good && turn > 0 && turn * turn > 0x1p-48 * (a2 * b2);
        const double scale = 0.5 / turn;
        const Coordinates<2> centre{(b[1] * a2 - a[1] * b2) * scale, (a[0] * b2 - b[0] * a2) * scale};
        good = good && domain_->well_contains({site[0] + centre[0], site[1] + centre[1]});
        corner[i] = {centre, false};
        a = b;
        a2 = b2;
    }
    if (!good) return false;
    Coordinates<2> before = corner[n - 1].offset;
    double before2 = dot(before, before), twice_area = 0, greatest = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Coordinates<2> now = corner[i].offset;
        const double now2 = dot(now, now), twice = cross(before, now);
        good = good && twice >= -1e-12 * (before2 + now2);
        twice_area += twice;
        greatest = std::max(greatest, now2);
        before = now;
        before2 = now2;
    }
    plump_ = good && twice_area > 2e-6 * greatest;
    return good;
}

void Voronoi_cell_2::from_bisectors(const Coordinates<2>& site, std::span<const Index> neighbours,
                                    std::span<const Coordinates<2>> position) {
    start_corners_.clear();
    start_lines_.clear();
    const bool disc = domain_->kind() == Domain_2::Kind::disc;
    if (disc) {
        // A square around the disc, larger so that its edges do not touch.
        const double h = 1.5 * domain_->radius();
        for (const Coordinates<2>& corner :
             {Coordinates<2>{-h, -h}, Coordinates<2>{h, -h}, Coordinates<2>{h, h}, Coordinates<2>{-h, h}}) {
            const Coordinates<2> outward{(corner[0] - corner[1]) / (2 * h), (corner[0] + corner[1]) / (2 * h)};
            start_corners_.push_back(minus(corner, site));
            start_lines_.push_back({outward, h - dot(outward, site)});
        }
    } else {
        for (std::size_t i = 0; i < domain_->corners().size(); ++i) {
            const Half_plane_2& edge = domain_->edges()[i];
            start_corners_.push_back(minus(domain_->corners()[i], site));
            start_lines_.push_back({edge.normal, edge.bound - dot(edge.normal, site)});
        }
    }
    clipper_.start(start_corners_, start_lines_);
    for (const Index v : neighbours) {
        const Coordinates<2> d = minus(position[static_cast<std::size_t>(v)], site);
        const double d2 = dot(d, d);
        if (d2 > 0) clipper_.clip({d, d2 / 2});
    }
    cell_.origin = site;
    clipper_.write_corners(cell_.corners);
    if (disc) clip_to_disc(cell_, domain_->radius(), scratch_);
    if (cell_.corners.empty() || domain_->well_contains(site)) return;
    // The site may be far from its part of the domain: move the origin there, and shift the corners by the rounded
    // displacement of the origin.
    Coordinates<2> mean{};
    for (const Corner_2& corner : cell_.corners)
        for (std::size_t k = 0; k < 2; ++k) mean[k] += corner.offset[k] / static_cast<double>(cell_.corners.size());
    cell_.origin = {site[0] + mean[0], site[1] + mean[1]};
    const Coordinates<2> shift = minus(cell_.origin, site);
    for (Corner_2& corner : cell_.corners) corner.offset = minus(corner.offset, shift);
}

}  // namespace annulus::inline v1
