// SPDX-License-Identifier: GPL-3.0-or-later
// A call of Moving_mesh that runs out of memory: positions, indices, cells and the results of later calls are
// unchanged.
#include <annulus/moving_mesh.h>

#include <support/catch.h>
#include <support/failing_new.h>
#include <support/meshes.h>

#include <functional>
#include <string_view>

using namespace annulus;
using namespace annulus::testing;

TEMPLATE_TEST_CASE_SIG("A mesh whose call runs out of memory is as it was, and goes on, dimension", "[mesh][deep]",
                       ((int d), d), 2, 3) {
    struct Call {
        const char* name;
        std::function<void(Moving_mesh<d>&)> make;
    };
    Coordinates<d> inside;
    inside.fill(1.3);
    Coordinates<d> outside;
    outside.fill(-3.25);
    const std::vector<Call> calls{
        {"move_all",
         [](auto& m) { (void)m.move_all(sheared<d>(Points_d<d>(m.points().begin(), m.points().end()), 1e-3)); }},
        {"move_all, far",
         [](auto& m) { (void)m.move_all(sheared<d>(Points_d<d>(m.points().begin(), m.points().end()), 0.7)); }},
        {"move some",
         [](auto& m) {
             Points_d<d> x(m.points().begin(), m.points().begin() + 3);
             for (auto& p : x) p[0] -= 0.1;
             (void)m.move(std::vector<Index>{0, 1, 2}, x);
         }},
        {"move", [=](auto& m) { (void)m.move(5, inside); }},
        {"insert", [=](auto& m) { (void)m.insert(inside); }},
        {"insert outside", [=](auto& m) { (void)m.insert(outside); }},
        {"remove", [](auto& m) { m.remove(12); }},
        {"recompute_tolerances", [](auto& m) { (void)m.recompute_tolerances(); }}};
    for (const Strategy strategy :
         {Strategy::automatic, Strategy::tolerances, Strategy::tolerances_each, Strategy::relocate})
        for (const int before : {0, 1, 4})  // time steps
            for (const Memory memory : {Memory::short_once, Memory::short_for_good})
                for (const Call& call : calls) {
                    if (before == 4 && (strategy == Strategy::tolerances_each || strategy == Strategy::relocate))
                        continue;
                    bool done = false;
                    for (std::uint64_t n = static_cast<std::uint64_t>(before); !done && n < 100000; n += 1 + n) {
                        CAPTURE(name_of(strategy), before, static_cast<int>(memory), call.name, n);
                        Options options;
                        options.strategy = strategy;
                        Moving_mesh<d> mesh(std::span<const Coordinates<d>>(grid<d>()), options);
                        for (int step = 0; step < before; ++step)
                            (void)mesh.move_all(sheared<d>(grid<d>(), 1e-3 * step));
                        const Points_d<d> points(mesh.points().begin(), mesh.points().end());
                        const auto cells = sorted_cells(mesh);
                        const Starved became = starve(n, memory, [&] { call.make(mesh); });
                        done = became == Starved::done;
                        if (became == Starved::refused) {
                            const bool gone = std::string_view(call.name) == "remove" && !mesh.is_vertex(12);
                            Points_d<d> now(mesh.points().begin(), mesh.points().end());
                            if (gone) now[12] = points[12];  // no number there
                            REQUIRE(now == points);
                            if (memory == Memory::short_for_good)
                                (void)mesh.recompute_tolerances();  // there may have been no cells
                            if (!gone) REQUIRE(sorted_cells(mesh) == cells);
                            if (!gone) call.make(mesh);
                        }
                        REQUIRE(mesh.audit().first_fault == "");
                        (void)mesh.insert([] {
                            Coordinates<d> p;
                            p.fill(0.77);
                            return p;
                        }());
                        mesh.remove(7);
                        REQUIRE(mesh.audit().first_fault == "");
                    }
                    REQUIRE(done);
                }
}
