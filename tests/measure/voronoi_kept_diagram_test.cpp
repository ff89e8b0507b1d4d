// SPDX-License-Identifier: GPL-3.0-or-later
// Voronoi diagrams kept from step to step, compared with those that are computed afresh, bit for bit.
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/measure/voronoi_kept_diagram.h>
#include <annulus/moving_mesh.h>
#include <annulus/voronoi.h>
#include <measure/voronoi_changes.h>
#include <support/catch.h>
#include <support/failing_new.h>
#include <support/meshes.h>
#include <support/point_sets_3.h>
#include <support/repeats.h>

#include <cstring>
#include <limits>
#include <new>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <class T>
bool same_elements(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

template <int d>
void require_same_diagram(const Voronoi_diagram<d>& a, const Voronoi_diagram<d>& b) {
    REQUIRE(same_elements(a.pair, b.pair));
    REQUIRE(same_elements(a.measure, b.measure));
    REQUIRE(same_elements(a.centroid, b.centroid));
    REQUIRE(same_elements(a.distance, b.distance));
    REQUIRE(same_elements(a.vector, b.vector));
    REQUIRE(same_elements(a.exactly_empty, b.exactly_empty));
    REQUIRE(same_elements(a.ring_begin, b.ring_begin));
    REQUIRE(same_elements(a.ring, b.ring));
    REQUIRE(same_elements(a.vertex, b.vertex));
    REQUIRE(same_elements(a.vertex_of_cell, b.vertex_of_cell));
    REQUIRE(same_elements(a.volume, b.volume));
    REQUIRE(same_elements(a.cell_centroid, b.cell_centroid));
    REQUIRE(same_elements(a.surface, b.surface));
}

template <int d>
void require_fresh_diagram(const Moving_mesh<d>& mesh) {
    Voronoi_diagram<d> fresh = voronoi_diagram<d>(mesh.points(), mesh.cells());
    if (mesh.number_of_vertices() == 1)
        for (std::size_t i = 0; i < fresh.volume.size(); ++i)
            if (mesh.is_vertex(static_cast<Index>(i)))
                fresh.volume[i] = fresh.surface[i] = std::numeric_limits<double>::infinity();
    require_same_diagram(voronoi(mesh), fresh);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Kept diagrams are those of a fresh computation, bit for bit, whatever happens, dimension",
                       "[measure][voronoi]", ((int d), d), 2, 3) {
    for (int round = 0; round < repeats(2); ++round)
        for (const Strategy strategy : strategies) {
            Random random(static_cast<std::uint64_t>(500 + round));
            std::size_t kind = 0;
            for (const auto& x : inputs<d>(random)) {
                INFO("round " << round << ", " << name_of(strategy) << ", input " << kind++);
                Options options;
                options.strategy = strategy;
                Moving_mesh<d> mesh{std::span<const Coordinates<d>>(x), options};
                require_fresh_diagram(mesh);
                for (int k = 0; k < 24; ++k) {
                    INFO("change " << k);
                    change(mesh, random);
                    if (random() % 3 != 0) require_fresh_diagram(mesh);  // else changes pile up
                }
                require_fresh_diagram(mesh);
                const Moving_mesh<d> taken = std::move(mesh);
                require_fresh_diagram(taken);
            }
        }
}

// Most facets are copied here, in the inputs above few.
TEMPLATE_TEST_CASE_SIG("Kept diagrams of many points, of which few change, are those of a fresh computation, dimension",
                       "[measure][voronoi]", ((int d), d), 2, 3) {
    Random random(19);
    for (const bool lattice : {false, true}) {
        Points_of<d> x = uniform<d>(2000, random);
        if (lattice)  // with many equal circumcentres, some of which come and go
            for (auto& p : x)
                for (double& c : p) c = std::round(c * (d == 2 ? 30 : 8)) / 8;
        std::sort(x.begin(), x.end());
        x.erase(std::unique(x.begin(), x.end()), x.end());
        std::shuffle(x.begin(), x.end(), random);
        Moving_mesh<d> mesh{std::span<const Coordinates<d>>(x)};
        require_fresh_diagram(mesh);
        std::size_t cospherical = 0;
        for (int k = 0; k < repeats(30); ++k) {
            INFO("lattice " << lattice << ", change " << k);
            try {
                const auto& somewhere = mesh.points()[static_cast<std::size_t>(any_vertex(mesh, random))];
                switch (random() % 4) {
                    case 0: mesh.remove(any_vertex(mesh, random)); break;
                    case 1: (void)mesh.insert(near<d>(somewhere, 0.2, random)); break;
                    case 2: {  // along a line of the lattice: facets become empty, and are so no longer
                        Coordinates<d> target = somewhere;
                        target[0] += 0.0625;
                        mesh.move(any_vertex(mesh, random), target);
                        break;
                    }
                    default: mesh.move(any_vertex(mesh, random), near<d>(somewhere, 0.01, random));
                }
            } catch (const Error& e) {
                REQUIRE(e.code() == Error_code::duplicate_point);
            }
            require_fresh_diagram(mesh);
            const auto diagram = voronoi(mesh);
            for (std::size_t c = 0; c < diagram.vertex_of_cell.size(); ++c)
                cospherical += diagram.vertex_of_cell[c] != static_cast<Index>(c) ? 1 : 0;
        }
        CHECK((cospherical > 0) == lattice);
    }
}

TEMPLATE_TEST_CASE_SIG("Of a kept diagram the facets around few movers are computed, and all where all move, dimension",
                       "[measure][voronoi]", ((int d), d), 2, 3) {
    Random random(23);
    Points_of<d> x = uniform<d>(3000, random);
    Delaunay_mesh<d> mesh;
    mesh.build(x);
    Kept_voronoi_diagram<d> kept;
    const auto update = [&] {
        const auto cells = std::make_shared<const Cell_lists<d>>(mesh.cells(x), d, x.size());
        require_same_diagram(kept.update(mesh.table(), x, cells), voronoi_diagram<d>(x, cells->cells));
        return cells;
    };
    const auto last = update();
    const std::size_t all = voronoi_diagram<d>(x, last->cells).pair.size();
    CHECK(kept.computed() == all);
    (void)kept.update(mesh.table(), x, last);
    CHECK(kept.computed() == 0);
    for (int k = 0; k < 5; ++k) {
        const auto v = static_cast<Index>(random() % x.size());
        const Coordinates<d> target = near<d>(x[static_cast<std::size_t>(v)], 0.01, random);
        std::vector<Cell_index> changed;
        CHECK(mesh.reinsert(x, v, target, changed));
        (void)update();
        CHECK(kept.computed() > d);
        CHECK(kept.computed() < 1500);
    }
    for (auto& p : x)
        for (double& c : p) c *= 0.75;  // without evaluating any certificate
    (void)update();
    CHECK(kept.computed() > all - all / 8);
    // Another unit, although no other vertex has moved.
    x[0].fill(100);
    mesh.rebuild(x);
    (void)update();
    CHECK(kept.computed() > all - all / 8);
    // Other numbers of cells, but none that moved.
    mesh.rebuild(x);
    (void)update();
}

TEMPLATE_TEST_CASE_SIG("A diagram that memory ran out for, or that was refused, is computed later, dimension",
                       "[measure][voronoi]", ((int d), d), 2, 3) {
    Random random(29);
    const Points_of<d> x = uniform<d>(40, random);
    bool done = false;
    for (std::uint64_t n = 0; !done; ++n) {
        CAPTURE(n);
        Moving_mesh<d> mesh{std::span<const Coordinates<d>>(x)};
        (void)voronoi(mesh);
        mesh.move(5, near<d>(x[5], 0.02, random));
        done = starve(n, Memory::short_once, [&] { (void)voronoi(mesh); }) == Starved::done;
        require_fresh_diagram(mesh);
        mesh.move(9, near<d>(x[9], 0.02, random));
        require_fresh_diagram(mesh);
    }
    Points_of<d> y = grid<d>();
    Delaunay_mesh<d> mesh;
    mesh.build(y);
    const auto cells = std::make_shared<const Cell_lists<d>>(mesh.cells(y), d, y.size());
    Kept_voronoi_diagram<d> kept;
    (void)kept.update(mesh.table(), y, cells);
    const std::size_t middle = d == 2 ? 12 : 13;
    const Coordinates<d> here = y[middle];
    y[middle][0] += 100;  // out of the hull, without evaluating any certificate
    REQUIRE_THROWS_AS(kept.update(mesh.table(), y, cells), Error);
    y[middle] = here;
    require_same_diagram(kept.update(mesh.table(), y, cells), voronoi_diagram<d>(y, cells->cells));
}
