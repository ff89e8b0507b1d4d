// SPDX-License-Identifier: GPL-3.0-or-later
// When the buffers of periodic builds are there, by the memory that a step takes: a build in buffers that are there
// takes less than three fifths of what it takes without.
#include <annulus/kernel/periodic_builder.h>
#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/failing_new.h>
#include <support/generators.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
struct Run {
    Run() {
        for (double& l : lengths) l = 1.0;
        scatter();
        mesh.emplace(std::span<const Coordinates<d>>(x), Box<d>::orthorhombic(lengths));
    }
    void scatter() {
        for (auto& p : x)
            for (double& c : p) c = unit(random);
    }
    /// The bytes that a step to the present points takes.
    std::uint64_t step(bool rebuilt) {
        const Failing_new counting(std::numeric_limits<std::uint64_t>::max() - 1);
        const Move_result result = mesh->move_all(x);
        CHECK((result.moves.rebuilt > 0) == rebuilt);
        return Failing_new::bytes();
    }
    std::uint64_t far() {
        scatter();
        return step(true);
    }
    void near() {
        for (auto& p : x)
            for (double& c : p) c += between(random, -1e-6, 1e-6);
        (void)step(false);
    }

    Random random{3};
    Coordinates<d> lengths;
    std::vector<Coordinates<d>> x{std::vector<Coordinates<d>>(600)};
    std::optional<Periodic_mesh<d>> mesh;
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("Buffers of periodic builds are there while steps are rebuilt, and a few more, dimension",
                       "[engine][periodic]", ((int d), d), 2, 3) {
    Run<d> run;
    for (int k = 0; k < 2; ++k) (void)run.far();  // what else a mesh keeps is there
    for (int k = 0; k < 8; ++k) run.near();
    const std::uint64_t fresh = run.far();
    for (int k = 0; k < 4; ++k) (void)run.far();  // until no array grows
    CHECK(5 * run.far() < 3 * fresh);
    for (int k = 0; k < 7; ++k) run.near();
    CHECK(5 * run.far() < 3 * fresh);
    for (int k = 0; k < 8; ++k) run.near();
    CHECK(5 * run.far() > 3 * fresh);
}

TEMPLATE_TEST_CASE_SIG("A periodic builder without buffers builds the same, dimension", "[engine][periodic]",
                       ((int d), d), 2, 3) {
    Random random(4);
    Coordinates<d> lengths;
    lengths.fill(1.0);
    const Lattice<d> lattice(Box<d>::orthorhombic(lengths).vectors());
    std::vector<Coordinates<d>> place(100);
    for (auto& p : place) {
        for (double& c : p) c = unit(random);
        p = lattice.representative(p, 0).place;
    }
    Periodic_builder<d> builder;
    Periodic_table<d> first, second;
    CHECK(!builder.holds_buffers());
    builder.build(lattice, place, 1, first);
    CHECK(builder.holds_buffers());
    const std::size_t copies = builder.copies();
    builder.release();
    CHECK(!builder.holds_buffers());
    CHECK(builder.copies() == copies);
    builder.build(lattice, place, 1, second);
    CHECK((first.vertex == second.vertex && first.offset == second.offset && first.twin == second.twin));
}
