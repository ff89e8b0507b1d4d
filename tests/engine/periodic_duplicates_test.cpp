// SPDX-License-Identifier: GPL-3.0-or-later
// The error of points of a periodic box that are images of one another: the same words and the same vertices, by
// whatever call, strategy or algorithm it is found.
#include <annulus/error.h>
#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/periodic_boxes.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

using Names = std::vector<std::int64_t>;
template <int d>
using Points = std::vector<Coordinates<d>>;

void check_refused(const std::function<void()>& call, const Names& names, const std::string& words) {
    try {
        call();
        FAIL_CHECK("nothing was thrown");
    } catch (const Error& e) {
        CHECK(e.code() == Error_code::duplicate_point);
        CHECK(Names(e.vertices().begin(), e.vertices().end()) == names);
        CHECK(std::string(e.what()) == words);
    }
}

/// Points with few digits, so that images are exact: in a box whose lengths are 1 and more.
template <int d>
struct Scene {
    explicit Scene(std::size_t n) {
        typename Box<d>::Vectors v{};
        for (std::size_t i = 0; i < d; ++i) v[i][i] = 1.0 + static_cast<double>(i) / 4;
        v[1][0] = 0.5;
        vectors = v;
        Periodic_cases cases(3);
        for (std::size_t k = 0; k < n; ++k) {
            Coordinates<d> p{};
            for (double& c : p) c = static_cast<double>(1 + cases.below(1U << 20U)) * 0x1p-20;
            x.push_back(p);
        }
        x[9] = {};  // on a corner of the box, and the least place of all
    }
    /// Another image of point k.
    [[nodiscard]] Coordinates<d> image(std::size_t k, int by) const {
        Coordinates<d> p = x[k];
        for (std::size_t j = 0; j < d; ++j)
            for (std::size_t i = 0; i < d; ++i) p[i] += (j == 0 ? by : 1) * vectors[j][i];
        return p;
    }
    [[nodiscard]] Box<d> box() const { return Box<d>(vectors); }

    typename Box<d>::Vectors vectors;
    Points<d> x;
};

/// Three sets of vertices come together: 2, 17 and 30; 5 and 40; 9 and 10.
template <int d>
void expect_the_lowest(Periodic_strategy strategy, bool report_changes, std::size_t n) {
    CAPTURE(d, name_of(strategy), report_changes, n);
    const Scene<d> scene(n);
    const std::vector<std::pair<std::size_t, std::size_t>> pairs{{10, 9}, {40, 5}, {17, 30}, {2, 30}};
    Points<d> y = scene.x, targets;
    std::vector<Index> indices;
    for (const auto& [k, to] : pairs) {
        y[k] = scene.image(to, static_cast<int>(k) - 12);
        indices.push_back(static_cast<Index>(k));
        targets.push_back(y[k]);
    }
    const Names lowest{2, 17, 30};
    const std::string words = "points 2, 17 and 30 have, up to vectors of the box, the same position";
    const Periodic_options options{.report_changes = report_changes, .strategy = strategy};
    check_refused([&] { (void)Periodic_mesh<d>(y, scene.box(), options); }, lowest, words);
    Periodic_mesh<d> mesh(scene.x, scene.box(), options);
    check_refused([&] { (void)mesh.move_all(y); }, lowest, words);
    check_refused([&] { (void)mesh.move_all(y, scene.box()); }, lowest, words);
    check_refused([&] { (void)mesh.move(indices, targets); }, lowest, words);
    check_refused([&] { (void)mesh.move(30, scene.image(2, 1)); }, {2, 30},
                  "points 2 and 30 have, up to vectors of the box, the same position");
    check_refused(
        [&] {
            (void)mesh.move({{30, 2}}, Points<d>{scene.image(7, 0), scene.image(7, 1)});
        },
        {2, 7, 30}, "points 2, 7 and 30 have, up to vectors of the box, the same position");
    CHECK(mesh.audit().delaunay());
}

/// Of these points, which are inserted one after the other or at once, the first one that cannot be is named.
template <int d>
void expect_the_first(std::size_t n) {
    CAPTURE(d, n);
    const Scene<d> scene(n + 4);
    Periodic_mesh<d> mesh(Points<d>(scene.x.begin(), scene.x.end() - 4), scene.box());
    const std::vector<Index> free{8, 3};
    mesh.remove(free);  // so that new points have lower indices than old ones
    const auto fresh = [&](std::size_t k) { return scene.x[n + k]; };
    check_refused(
        [&] {
            (void)mesh.insert(Points<d>{fresh(0), fresh(1), scene.image(n + 1, 3), scene.image(6, 0)});
        },
        {}, "points 1 and 2 to be inserted have, up to vectors of the box, the same position");
    const std::string taken = "vertex 6 has, up to vectors of the box, the position of a point to be inserted";
    check_refused(
        [&] {
            (void)mesh.insert(Points<d>{fresh(0), scene.image(6, 0), fresh(1), scene.image(n, 3)});
        },
        {6}, taken);
    check_refused([&] { (void)mesh.insert(scene.image(6, 0)); }, {6}, taken);
    CHECK(mesh.insert(Points<d>{fresh(0), scene.image(8, 1)}) == std::vector<Index>{3, 8});
    CHECK(mesh.audit().delaunay());
}

}  // namespace

TEST_CASE("Of vertices that coincide in a box the lowest are named, by every call and strategy", "[periodic]") {
    for (const auto strategy : {Periodic_strategy::automatic, Periodic_strategy::signs, Periodic_strategy::tolerances})
        for (const bool report_changes : {false, true})
            for (const std::size_t n : {41U, 2000U}) {  // a build where some move, and reinsertions
                expect_the_lowest<2>(strategy, report_changes, n);
                expect_the_lowest<3>(strategy, report_changes, n);
            }
}

TEST_CASE("Of points that cannot be inserted in a box the first is named", "[periodic]") {
    for (const std::size_t n : {31U, 500U}) {  // at once, and one after the other
        expect_the_first<2>(n);
        expect_the_first<3>(n);
    }
}
