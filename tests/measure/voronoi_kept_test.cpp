// SPDX-License-Identifier: GPL-3.0-or-later
// Voronoi volumes kept from step to step, compared with those that are recomputed, bit for bit, and with cells cut out
// in rational numbers.
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/measure/voronoi_kept.h>
#include <annulus/moving_mesh.h>
#include <annulus/voronoi.h>
#include <measure/voronoi_changes.h>
#include <measure/voronoi_oracle.h>
#include <support/catch.h>
#include <support/failing_new.h>
#include <support/meshes.h>
#include <support/point_sets_3.h>
#include <support/repeats.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <new>

using namespace annulus;
using namespace annulus::testing;

TEMPLATE_TEST_CASE_SIG(
    "Kept volumes are those of a fresh computation, bit for bit, whatever happens to a mesh, dimension",
    "[measure][voronoi]", ((int d), d), 2, 3) {
    for (int round = 0; round < repeats(2); ++round)
        for (const Strategy strategy : strategies) {
            Random random(static_cast<std::uint64_t>(100 + round));
            std::size_t kind = 0;
            for (const auto& x : inputs<d>(random)) {
                INFO("round " << round << ", " << name_of(strategy) << ", input " << kind++);
                Options options;
                options.strategy = strategy;
                Moving_mesh<d> mesh{std::span<const Coordinates<d>>(x), options};
                require_fresh(mesh);
                for (int k = 0; k < 24; ++k) {
                    INFO("change " << k);
                    change(mesh, random);
                    if (random() % 3 != 0) require_fresh(mesh);  // else changes pile up
                }
                require_fresh(mesh);
                const Moving_mesh<d> taken = std::move(mesh);
                require_fresh(taken);
            }
        }
}

TEMPLATE_TEST_CASE_SIG("Kept volumes are those of cells cut out exactly, after few have moved, dimension",
                       "[measure][voronoi]", ((int d), d), 2, 3) {
    Random random(7);
    Points_of<d> uniform = inputs<d>(random)[0];
    uniform.resize(24);
    for (const auto& x : {grid<d>(), uniform}) {
        Moving_mesh<d> mesh{std::span<const Coordinates<d>>(x)};
        (void)mesh.voronoi_volumes();
        for (int k = 0; k < 3; ++k) {
            const Index i = any_vertex(mesh, random);
            mesh.move(i, near<d>(mesh.points()[static_cast<std::size_t>(i)], 0.05, random));
            const auto volume = mesh.voronoi_volumes();
            for (std::size_t v = 0; v < x.size(); ++v) {
                const auto truth = exact_cell(mesh.points(), v);
                REQUIRE(truth.has_value() == std::isfinite(volume[v]));
                if (truth) REQUIRE(abs(mpq_class(volume[v]) - *truth) <= mpq_class(voronoi_volume_error) * *truth);
            }
        }
    }
}

TEMPLATE_TEST_CASE_SIG("Of many volumes those around few movers are computed, and all where all move, dimension",
                       "[measure][voronoi]", ((int d), d), 2, 3) {
    Random random(11);
    Points_of<d> x(3000);
    for (auto& p : x)
        for (double& c : p) c = between(random, -1, 1);
    Delaunay_mesh<d> mesh;
    mesh.build(x);
    Kept_voronoi_volumes<d> kept(mesh);
    (void)kept.update(x);
    CHECK(kept.computed() == x.size());
    (void)kept.update(x);
    CHECK(kept.computed() == 0);
    for (int k = 0; k < 5; ++k) {
        const auto v = static_cast<Index>(random() % x.size());
        const Coordinates<d> target = near<d>(x[static_cast<std::size_t>(v)], 0.01, random);
        std::vector<Cell_index> changed;
        CHECK(mesh.reinsert(x, v, target, changed));
        const auto volumes = kept.update(x);
        CHECK(kept.computed() > d);
        CHECK(kept.computed() < 150);
        CHECK(same_bits(volumes, voronoi_volumes<d>(x, mesh.cells(x))));
    }
    for (auto& p : x)
        for (double& c : p) c /= 2;  // without evaluating any certificate
    CHECK(same_bits(kept.update(x), voronoi_volumes<d>(x, mesh.cells(x))));
    CHECK(kept.computed() == x.size());
    // Another unit, although no other vertex has moved.
    x[0] = {100, 0};
    mesh.rebuild(x);
    CHECK(same_bits(kept.update(x), voronoi_volumes<d>(x, mesh.cells(x))));
}

TEMPLATE_TEST_CASE_SIG("Volumes that memory ran out for, or for whose mesh it did, are computed later, dimension",
                       "[measure][voronoi]", ((int d), d), 2, 3) {
    Random random(13);
    Points_of<d> x = inputs<d>(random)[0];
    x.resize(40);
    const auto moved = [&](double by) {
        Points_of<d> out = x;
        for (auto& p : out) p[0] *= 1 + by * p[1];
        return out;
    };
    struct Call {
        const char* name;
        std::function<void(Moving_mesh<d>&)> make;
    };
    const Coordinates<d> nearby = near<d>(x[3], 0.05, random);
    const std::vector<Call> calls{{"volumes", [](auto& m) { (void)m.voronoi_volumes(); }},
                                  {"move", [&](auto& m) { (void)m.move(3, nearby); }},
                                  {"move_all", [&](auto& m) { (void)m.move_all(moved(0.4)); }},
                                  {"insert", [&](auto& m) { (void)m.insert(nearby); }},
                                  {"remove", [](auto& m) { m.remove(7); }}};
    bool refused = false;
    for (const Strategy strategy : {Strategy::tolerances, Strategy::relocate})
        for (const Memory memory : {Memory::short_once, Memory::short_for_good})
            for (const bool requested : {false, true})
                for (const Call& call : calls) {
                    bool done = false;
                    for (std::uint64_t n = 0; !done && n < 10000; n += call.name[0] == 'v' ? 1 : 1 + n / 4) {
                        CAPTURE(name_of(strategy), static_cast<int>(memory), requested, call.name, n);
                        Options options;
                        options.strategy = strategy;
                        Moving_mesh<d> mesh(std::span<const Coordinates<d>>(x), options);
                        if (requested) (void)mesh.voronoi_volumes();
                        if (requested) (void)mesh.move(5, near<d>(x[5], 0.02, random));
                        const Starved became = starve(n, memory, [&] { call.make(mesh); });
                        done = became == Starved::done;
                        if (mesh.dimension() < 0) {  // there was no memory for cells, either
                            REQUIRE_THROWS_AS(mesh.voronoi_volumes(), std::bad_alloc);
                            refused = true;
                            (void)mesh.recompute_tolerances();
                        }
                        require_fresh(mesh);
                        (void)mesh.move(9, near<d>(x[9], 0.02, random));
                        require_fresh(mesh);
                    }
                    REQUIRE(done);
                }
    CHECK(refused);
}

TEMPLATE_TEST_CASE_SIG(
    "Volumes that were refused are computed again, and a mesh outlives those that were kept, dimension",
    "[measure][voronoi]", ((int d), d), 2, 3) {
    Points_of<d> x = grid<d>();
    Delaunay_mesh<d> mesh;
    mesh.build(x);
    {
        Kept_voronoi_volumes<d> kept(mesh);
        (void)kept.update(x);
        const std::size_t middle = d == 2 ? 12 : 13;
        const Coordinates<d> here = x[middle];
        x[middle][0] += 100;  // out of the hull, without evaluating any certificate
        REQUIRE_THROWS_AS(kept.update(x), Error);
        REQUIRE_THROWS_AS(voronoi_volumes<d>(x, mesh.cells(x)), Error);
        x[middle] = here;
        CHECK(same_bits(kept.update(x), voronoi_volumes<d>(x, mesh.cells(x))));
        CHECK(kept.computed() == x.size());
        // Flat for a while.
        Points_of<d> line(x.size());
        for (std::size_t v = 0; v < line.size(); ++v) line[v] = {static_cast<double>(v)};
        mesh.rebuild(line);
        for (const double volume : kept.update(line)) CHECK(volume == std::numeric_limits<double>::infinity());
        mesh.rebuild(x);
        CHECK(same_bits(kept.update(x), voronoi_volumes<d>(x, mesh.cells(x))));
    }
    std::vector<Cell_index> changed;
    CHECK_THROWS_AS(mesh.reinsert(x, 0, x[1], changed), Error);
    Coordinates<d> outside{};
    outside[0] = -3;
    CHECK(mesh.reinsert(x, 0, outside, changed));
    Kept_voronoi_volumes<d> other(mesh);
    CHECK(same_bits(other.update(x), voronoi_volumes<d>(x, mesh.cells(x))));
}
