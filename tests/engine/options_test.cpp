// SPDX-License-Identifier: GPL-3.0-or-later
// Options that both classes refuse; and the names of vertices once indices are free.

#include <annulus/moving_mesh.h>

#include <support/catch.h>
#include <support/viewed_mesh.h>

#include <limits>
#include <span>
#include <string>
#include <vector>

using namespace annulus;

namespace {

template <int d>
std::vector<Coordinates<d>> corners() {
    std::vector<Coordinates<d>> x(d + 3);
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t k = 0; k < d; ++k) x[i][k] = i == k + 1 ? 1.0 : 0.01 * static_cast<double>(i * i * (k + 1));
    return x;
}

template <class Object, int d>
void refuses_threads() {
    const auto x = corners<d>();
    const std::span<const Coordinates<d>> points(x);
    for (const int threads : {0, -1, -3, std::numeric_limits<int>::min()})
        for (const Strategy strategy :
             {Strategy::automatic, Strategy::tolerances, Strategy::rebuild, Strategy::relocate}) {
            Options options;
            options.threads = threads;
            options.strategy = strategy;
            try {
                const Object made(points, options);
                FAIL("threads = " << threads << " was taken");
            } catch (const Error& e) {
                CHECK(e.code() == Error_code::usage);
                CHECK(std::string(e.what()) == "threads must be 1 or more, not " + std::to_string(threads));
            }
        }
    Options options;
    options.threads = 2;
    CHECK(Object(points, options).audit().delaunay());
}

template <class Object>
void names_vertices(Object& object, const std::vector<Index>& names) {
    auto input = object.audit_input();
    CHECK(input.names == names);
    CHECK(audit(input).delaunay());
    std::swap(input.cells.front()[0], input.cells.front()[1]);
    const auto& cell = input.cells.front();
    std::string expected = "cell not positively oriented:";
    for (const Index v : cell) expected += " " + std::to_string(names[static_cast<std::size_t>(v)]);
    CHECK(audit(input).first_fault == expected);
}

}  // namespace

TEST_CASE("Threads must be one or more", "[engine][options]") {
    refuses_threads<Moving_mesh_2, 2>();
    refuses_threads<Moving_mesh_3, 3>();
    refuses_threads<testing::Viewed_mesh<2>, 2>();
    refuses_threads<testing::Viewed_mesh<3>, 3>();
}

TEST_CASE("Tolerances that are not certified are for the paper's strategies alone", "[engine][options]") {
    const auto x = corners<3>();
    const std::span<const Coordinates<3>> points(x);
    for (const Strategy strategy :
         {Strategy::rebuild, Strategy::relocate, Strategy::relocate_flips, Strategy::in_place, Strategy::tolerances,
          Strategy::tolerances_each, Strategy::automatic, Strategy::paper, Strategy::paper_hybrid})
        for (const Tolerance_kind kind : {Tolerance_kind::certified, Tolerance_kind::paper, Tolerance_kind::floating}) {
            CAPTURE(name_of(strategy), name_of(kind));
            const bool fits =
                kind == Tolerance_kind::certified || strategy == Strategy::paper || strategy == Strategy::paper_hybrid;
            try {
                const Moving_mesh_3 made(points, Options{.strategy = strategy, .tolerance = kind});
                CHECK(fits);
                CHECK(made.strategy() == strategy);
                CHECK(made.audit().delaunay());
            } catch (const Error& e) {
                CHECK(!fits);
                CHECK(e.code() == Error_code::usage);
                CHECK(std::string(e.what()).find("'" + std::string(name_of(strategy)) + "'") != std::string::npos);
            }
        }
}

TEST_CASE("An audit names vertices by their indices, also when lower ones are free", "[engine][audit]") {
    const auto x = corners<2>();
    Moving_mesh_2 mesh{std::span<const Coordinates<2>>(x)};
    mesh.remove(0);
    mesh.remove(3);
    names_vertices(mesh, {1, 2, 4});
    const auto y = corners<3>();
    testing::Viewed_mesh<3> dt{std::span<const Coordinates<3>>(y)};
    dt.remove(1);
    names_vertices(dt, {0, 2, 3, 4, 5});
}
