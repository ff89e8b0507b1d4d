// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <annulus/moving_mesh.h>
#include <apps/motion/ball_3.h>
#include <apps/motion/cells_3.h>
#include <apps/motion/finish_3.h>
#include <apps/motion/mesh_quality.h>
#include <apps/motion/vectors_3.h>

#include <support/catch.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

using namespace annulus;

namespace {

using Points = std::vector<Coordinates<3>>;

std::vector<Finish_3::Cell> finite(const std::vector<Index>& vertices) {
    std::vector<Finish_3::Cell> cells;
    for (std::size_t i = 0; i < vertices.size(); i += 4) {
        const Finish_3::Cell c{vertices[i], vertices[i + 1], vertices[i + 2], vertices[i + 3]};
        if (*std::min_element(c.begin(), c.end()) >= 0) cells.push_back(c);
    }
    return cells;
}

/// A triangulation with its cells in the ball.
struct Ball_mesh {
    const Ball_3 ball{1};
    Finish_3::Vertices vertices;
    Moving_mesh_3 dt;

    explicit Ball_mesh(unsigned seed, std::size_t inner = 250, std::size_t outer = 120)
        : dt(std::span<const Coordinates<3>>(points(seed, inner, outer)), reporting()) {
        vertices.position.assign(dt.points().begin(), dt.points().end());
        vertices.on_surface.assign(inner + outer, 0);
        std::fill(vertices.on_surface.begin() + static_cast<std::ptrdiff_t>(inner), vertices.on_surface.end(), 1);
        vertices.held.assign(inner + outer, 0);
    }
    static Options reporting() {
        Options options;
        options.report_changes = true;
        return options;
    }
    /// Inner ones, then some on the sphere, at some distance from each other.
    static Points points(unsigned seed, std::size_t inner, std::size_t outer) {
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal;
        std::uniform_real_distribution<double> uniform;
        Points all;
        while (all.size() < inner + outer) {
            const bool deep = all.size() < inner;
            Coordinates<3> p{normal(random), normal(random), normal(random)};
            const double length = std::sqrt(dot(p, p)), to = deep ? 0.85 * std::cbrt(uniform(random)) : 1;
            for (double& x : p) x *= to / length;
            if (std::all_of(all.begin(), all.end(), [&](const auto& q) { return distance(p, q) > 0.12; }))
                all.push_back(p);
        }
        return all;
    }
    Finish_3 finish(double goal = Finish_3::default_goal) {
        const auto move = [this](Index v, const Coordinates<3>& p) -> std::optional<Finish_3::Changes> {
            const Move_result r = dt.move(v, p);
            return Finish_3::Changes{finite(r.changed), finite(r.gone)};
        };
        return {ball, vertices, dt.cells().vertices, move, goal};
    }
    [[nodiscard]] Mesh_quality quality() const {
        const Mesh_cells<3> cells = dt.cells();
        return mesh_quality(cells, cells_inside(ball, cells, dt.points()), dt.points());
    }
    [[nodiscard]] std::vector<std::array<Index, 3>> surface() const {
        const Mesh_cells<3> cells = dt.cells();
        auto facets = surface_facets(cells, cells_inside(ball, cells, dt.points()));
        for (auto& f : facets) std::sort(f.begin(), f.end());
        std::sort(facets.begin(), facets.end());
        return facets;
    }
};

Points finished(Ball_mesh& mesh) {
    Finish_3 finish = mesh.finish();
    while (finish.step()) {
    }
    return finish.position();
}

}  // namespace

TEST_CASE("the least dihedral angle rises, and the mesh stays Delaunay with the same surface", "[motion][finish]") {
    for (const unsigned seed : {1u, 2u}) {
        Ball_mesh mesh(seed);
        const auto surface = mesh.surface();
        const Mesh_quality before = mesh.quality();
        Finish_3 finish = mesh.finish();
        double least = before.dihedral.min();
        std::uint64_t kept = 0;
        while (finish.step()) {
            if (finish.counts().kept == kept) continue;
            kept = finish.counts().kept;
            const double now = mesh.quality().dihedral.min();
            CHECK(now >= least - 1e-9);
            least = now;
        }
        const Mesh_quality after = mesh.quality();
        CHECK(after.dihedral.min() > before.dihedral.min() + 1);
        CHECK(after.slivers < before.slivers);
        CHECK(finish.counts().kept > 0);
        CHECK(finish.counts().tried > finish.counts().kept);
        CHECK(mesh.surface() == surface);
        CHECK(mesh.dt.audit().delaunay());
        const Points reported = finish.position();
        for (std::size_t v = 0; v < reported.size(); ++v) {
            CHECK(reported[v] == mesh.dt.points()[v]);
            if (mesh.vertices.on_surface[v] != 0) CHECK(dot(reported[v], reported[v]) == Approx(1).epsilon(1e-12));
        }
    }
}

TEST_CASE("the finish is the same again, whatever the order of the cells", "[deep][motion][finish]") {
    Ball_mesh one(3, 120, 80), two(3, 120, 80), three(3, 120, 80);
    const Points result = finished(one);
    CHECK(result != two.vertices.position);
    CHECK(finished(two) == result);
    // A triangulation with another history.
    (void)three.dt.move(0, {0.01, 0.02, 0.03});
    (void)three.dt.move(0, three.vertices.position[0]);
    CHECK(finished(three) == result);
}

TEST_CASE("vertices that are held rest, and a mesh above the goal is left alone", "[motion][finish]") {
    Ball_mesh mesh(1, 120, 80);
    for (std::size_t v = 0; v < mesh.vertices.held.size(); v += 2) mesh.vertices.held[v] = 1;
    const Points result = finished(mesh);
    bool moved = false;
    for (std::size_t v = 0; v < result.size(); ++v) {
        if (v % 2 == 0) CHECK(result[v] == mesh.vertices.position[v]);
        else moved = moved || result[v] != mesh.vertices.position[v];
    }
    CHECK(moved);
    Ball_mesh other(1, 120, 80);
    Finish_3 none = other.finish(0);
    CHECK_FALSE(none.step());
    CHECK(none.counts().tried == 0);
}

TEST_CASE("the finish needs flags for all vertices and cells of these", "[motion][finish]") {
    const Ball_3 ball(1);
    const Finish_3::Mover none = [](Index, const Coordinates<3>&) { return std::nullopt; };
    const std::vector<Finish_3::Cell> cells{{0, 1, 2, 3}};
    const Points four{{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}};
    CHECK_THROWS_AS(Finish_3(ball, {four, {0, 0, 0}, {0, 0, 0, 0}}, cells, none), Error);
    CHECK_THROWS_AS(Finish_3(ball, {four, {0, 0, 0, 0}, {0, 0, 0}}, cells, none), Error);
    const std::vector<Finish_3::Cell> wrong{{0, 1, 2, 4}};
    CHECK_THROWS_AS(Finish_3(ball, {four, {0, 0, 0, 0}, {0, 0, 0, 0}}, wrong, none), Error);
}
