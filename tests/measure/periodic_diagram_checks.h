// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/periodic_mesh.h>
#include <annulus/voronoi.h>

#include <support/catch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

// Checks of Voronoi diagrams in periodic boxes: that lists agree, that facets are polygons, and that cells close.
namespace annulus::testing::periodic_diagrams {

template <int d>
using Point_list = std::vector<Coordinates<d>>;

inline std::size_t at(Index i) { return static_cast<std::size_t>(i); }

template <int d>
Coordinates<d> minus(Coordinates<d> a, const Coordinates<d>& b) {
    for (std::size_t k = 0; k < d; ++k) a[k] -= b[k];
    return a;
}
template <int d>
Coordinates<d> image(Coordinates<d> p, const Shift<d>& shift, const Box<d>& box) {
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t k = 0; k < d; ++k) p[k] += shift[j] * box.vectors()[j][k];
    return p;
}
template <int d>
double dot(const Coordinates<d>& a, const Coordinates<d>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}
template <int d>
double length(const Coordinates<d>& a) {
    return std::sqrt(dot<d>(a, a));
}
template <int d>
Shift<d> difference(Shift<d> a, const Shift<d>& b) {
    for (std::size_t k = 0; k < d; ++k) a[k] -= b[k];
    return a;
}

/// An image of a Voronoi vertex.
template <int d>
using Corner = std::pair<Index, Shift<d>>;

/// Those of a facet, each once, as seen from its first point, with the way from corner to corner.
template <int d>
std::vector<Corner<d>> corners_of(const Periodic_voronoi_diagram<d>& v, std::size_t facet) {
    std::vector<Corner<d>> ring;
    for (std::size_t k = at(v.ring_begin[facet]); k < at(v.ring_begin[facet + 1]); ++k)
        ring.push_back({v.ring[k], v.ring_shift[k]});
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
}

/// Lists agree with those of neighbours, of cells and of volumes.
template <int d>
void expect_lists(const Periodic_mesh<d>& mesh, const Periodic_voronoi_diagram<d>& v) {
    const auto list = mesh.neighbours();
    std::size_t pairs = 0;
    for (std::size_t k = 0; k < list.first.size(); ++k) {
        const std::pair<Index, Shift<d>> there{list.second[k], list.shift[k]};
        if (there < std::pair(list.first[k], Shift<d>{})) continue;
        REQUIRE(pairs < v.pair.size());
        REQUIRE(v.pair[pairs] == std::array{list.first[k], list.second[k]});
        REQUIRE(v.shift[pairs] == list.shift[k]);
        CHECK(v.vector[pairs] == list.vector[k]);
        CHECK(v.distance[pairs] == list.distance[k]);
        CHECK((v.exactly_empty[pairs] != 0) == (list.area[k] == 0));
        CHECK((v.measure[pairs] == 0) == (list.area[k] == 0));
        CHECK(std::isnan(v.centroid[pairs][0]) == (list.area[k] == 0));
        CHECK(v.measure[pairs] == Approx(list.area[k]).epsilon(1e-9).margin(1e-11 * std::pow(list.distance[k], d - 1)));
        ++pairs;
    }
    CHECK(pairs == v.pair.size());
    const auto volumes = mesh.voronoi_volumes();
    REQUIRE(v.volume.size() == volumes.size());
    double sum = 0;
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        CHECK(std::isnan(v.volume[i]) == !mesh.is_vertex(static_cast<Index>(i)));
        CHECK(std::isnan(v.surface[i]) == std::isnan(v.volume[i]));
        CHECK(std::isnan(v.cell_centroid[i][0]) == std::isnan(v.volume[i]));
        if (std::isnan(v.volume[i])) continue;
        CHECK(v.volume[i] == Approx(volumes[i]).epsilon(2 * voronoi_diagram_error));
        sum += v.volume[i];
    }
    if (mesh.number_of_vertices() > 0) CHECK(sum == Approx(mesh.box().volume()).epsilon(2 * voronoi_diagram_error));
    const auto cells = mesh.cells();
    REQUIRE(v.vertex.size() == cells.vertices.size());
    for (std::size_t c = 0; c < v.vertex.size(); ++c) {
        const Index first = v.vertex_of_cell[c];
        CHECK(at(first) <= c);
        CHECK(v.vertex_of_cell[at(first)] == first);
        CHECK((at(first) != c || v.vertex_shift[c] == Shift<d>{}));
        double radius = 0;
        for (std::size_t i = 0; i <= d; ++i) {
            const auto x = image<d>(mesh.points()[at(cells.vertices[c][i])], cells.offsets[c][i], mesh.box());
            const double r = length<d>(minus<d>(v.vertex[c], x));
            if (i > 0) CHECK(r == Approx(radius).epsilon(1e-7));
            radius = r;
        }
        const auto other = image<d>(v.vertex[at(first)], v.vertex_shift[c], mesh.box());
        CHECK(length<d>(minus<d>(v.vertex[c], other)) <= 1e-9 * radius);
    }
}

/// The area of a polygon with this normal and its centroid, relative to `from`.
template <int d>
std::pair<double, Coordinates<d>> polygon(const Point_list<d>& corners, const Coordinates<d>& normal) {
    Coordinates<d> centroid{};
    if constexpr (d == 2) {
        for (std::size_t k = 0; k < 2; ++k) centroid[k] = (corners[0][k] + corners[1][k]) / 2;
        const auto way = minus<2>(corners[1], corners[0]);
        // The first point, the origin, is on the left: turned to the right the way is the normal's.
        return {(way[1] * normal[0] - way[0] * normal[1]) / length<2>(normal), centroid};
    } else {
        double area = 0;
        for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
            const auto p = minus<3>(corners[k], corners[0]), q = minus<3>(corners[k + 1], corners[0]);
            const Coordinates<3> cross{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
            const double part = dot<3>(cross, normal) / length<3>(normal) / 2;
            CHECK(part > -1e-12 * (dot<3>(p, p) + dot<3>(q, q)));
            area += part;
            for (std::size_t i = 0; i < 3; ++i) centroid[i] += part * (corners[0][i] + p[i] / 3 + q[i] / 3);
        }
        for (double& c : centroid) c /= area;
        return {area, centroid};
    }
}

/// Facets are polygons around their normals; cells made of them have the volumes and centroids.
template <int d>
void expect_polygons(const Periodic_mesh<d>& mesh, const Periodic_voronoi_diagram<d>& v) {
    const std::size_t n = mesh.index_bound();
    std::vector<double> volume(n, 0), surface(n, 0);
    Point_list<d> moment(n);
    for (std::size_t f = 0; f < v.pair.size(); ++f) {
        CAPTURE(f);
        const auto ring = corners_of<d>(v, f);
        if (v.exactly_empty[f] != 0) {
            CHECK(ring.size() <= (d == 2 ? 1 : 2));
            continue;
        }
        REQUIRE(ring.size() >= (d == 2 ? 2 : 3));
        CHECK(std::set<Corner<d>>(ring.begin(), ring.end()).size() == ring.size());
        const auto& x = mesh.points()[at(v.pair[f][0])];
        Point_list<d> corners;
        double size = 0;
        for (const auto& [vertex, shift] : ring) {
            CHECK(v.vertex_of_cell[at(vertex)] == vertex);
            corners.push_back(minus<d>(image<d>(v.vertex[at(vertex)], shift, mesh.box()), x));
            size = std::max(size, length<d>(corners.back()));
        }
        for (const auto& p : corners)  // in the plane in the middle
            CHECK(std::fabs(dot<d>(p, v.vector[f]) / v.distance[f] - v.distance[f] / 2) < 1e-10 * size);
        const auto [area, centroid] = polygon<d>(corners, v.vector[f]);
        CHECK(v.measure[f] == Approx(area).margin(1e-9 * std::pow(size, d - 1)));
        const auto middle = minus<d>(v.centroid[f], x);
        if (area > 1e-5 * std::pow(size, d - 1)) CHECK(length<d>(minus<d>(middle, centroid)) < 1e-5 * size);
        for (const bool other : {false, true}) {
            const std::size_t i = at(v.pair[f][other ? 1 : 0]);
            const double part = v.measure[f] * v.distance[f] / 2 / d;
            volume[i] += part;
            surface[i] += v.measure[f];
            for (std::size_t k = 0; k < d; ++k)
                moment[i][k] += part * (middle[k] - (other ? v.vector[f][k] : 0)) * d / (d + 1);
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (!mesh.is_vertex(static_cast<Index>(i))) continue;
        CHECK(v.volume[i] == Approx(volume[i]).epsilon(1e-9));
        CHECK(v.surface[i] == Approx(surface[i]).epsilon(1e-9));
        for (std::size_t k = 0; k < d; ++k)
            CHECK(v.cell_centroid[i][k] - mesh.points()[i][k] ==
                  Approx(moment[i][k] / volume[i]).margin(1e-9 * surface[i] / std::pow(volume[i], d - 2.0) + 1e-9));
    }
}

/// Each cell is closed, and a ball; all of them are a torus.
template <int d>
void expect_closed(const Periodic_mesh<d>& mesh, const Periodic_voronoi_diagram<d>& v) {
    std::vector<std::map<std::pair<Corner<d>, Corner<d>>, int>> sides(mesh.index_bound());
    std::vector<std::set<Corner<d>>> corners(mesh.index_bound());
    std::vector<int> facets(mesh.index_bound(), 0);
    std::set<Index> all;
    std::set<std::tuple<Index, Index, Shift<d>>> edges;
    long full = 0;
    for (std::size_t f = 0; f < v.pair.size(); ++f) {
        if (v.exactly_empty[f] != 0) continue;
        ++full;
        auto ring = corners_of<d>(v, f);
        for (const bool other : {false, true}) {
            const std::size_t i = at(v.pair[f][other ? 1 : 0]);
            if (other) {
                std::reverse(ring.begin(), ring.end());
                for (auto& [vertex, shift] : ring) shift = difference<d>(shift, v.shift[f]);
            }
            ++facets[i];
            for (std::size_t k = 0; k < (d == 2 ? 1 : ring.size()); ++k) {
                const auto& p = ring[k];
                const auto& q = ring[(k + 1) % ring.size()];
                ++sides[i][{p, q}];
                corners[i].insert({p, q});
                all.insert(p.first);
                all.insert(q.first);
                edges.insert({p.first, q.first, difference<d>(q.second, p.second)});
            }
        }
    }
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (!mesh.is_vertex(static_cast<Index>(i))) continue;
        CAPTURE(i);
        if constexpr (d == 2) {
            std::set<Corner<d>> begins, ends;
            for (const auto& [side, times] : sides[i]) {
                CHECK(times == 1);
                begins.insert(side.first);
                ends.insert(side.second);
            }
            CHECK((begins == corners[i] && ends == corners[i]));
            CHECK(static_cast<int>(corners[i].size()) == facets[i]);
        } else {
            for (const auto& [side, times] : sides[i]) {
                CHECK(times == 1);
                CHECK(sides[i].count({side.second, side.first}) == 1);
            }
            const auto e = static_cast<long>(sides[i].size() / 2);
            CHECK(static_cast<long>(corners[i].size()) - e + facets[i] == 2);
        }
    }
    const auto n = static_cast<long>(mesh.number_of_vertices());
    const auto vertices = static_cast<long>(all.size());
    if constexpr (d == 2) CHECK(vertices - full + n == 0);
    else CHECK(vertices - static_cast<long>(edges.size() / 2) + full - n == 0);
}

template <int d>
void expect_whole(const Periodic_mesh<d>& mesh) {
    const auto v = mesh.voronoi();
    expect_lists<d>(mesh, v);
    expect_polygons<d>(mesh, v);
    expect_closed<d>(mesh, v);
}

}  // namespace annulus::testing::periodic_diagrams
