// SPDX-License-Identifier: GPL-3.0-or-later
// Nearest_search, which keeps a list, on a tree without CGAL whose triangles are points.
#include <apps/motion/nearest_search.h>

#include <support/cases.h>
#include <support/catch.h>
#include <support/generators.h>

#include <array>
#include <new>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

struct Point_tree {
    using Triangle = std::array<Coordinates<3>, 3>;
    std::vector<Triangle> triangles;
    mutable int memory = -1;  // entries of lists until memory runs out; negative: never

    [[nodiscard]] const Triangle& triangle(std::int32_t number) const {
        return triangles[static_cast<std::size_t>(number)];
    }
    [[nodiscard]] static Coordinates<3> project(const Triangle& t, const Coordinates<3>&) { return t[0]; }
    void list(const Coordinates<3>& centre, double reach, std::vector<Nearby_3::Part>& parts) const {
        for (std::size_t k = 0; k < triangles.size(); ++k) {
            const double gap = std::sqrt(squared_gap(centre, triangles[k][0], triangles[k][0]));
            if (gap > reach) continue;
            if (memory == 0) throw std::bad_alloc();
            if (memory > 0) --memory;
            parts.push_back({gap, static_cast<std::int32_t>(k)});
        }
    }
    [[nodiscard]] Coordinates<3> nearest(const Coordinates<3>& p) const {
        Coordinates<3> best{};
        double least = std::numeric_limits<double>::infinity();
        for (const Triangle& t : triangles)
            if (const double square = squared_gap(p, t[0], t[0]); square < least) {
                least = square;
                best = t[0];
            }
        return best;
    }
};

Coordinates<3> somewhere(Random& random) { return {unit(random), unit(random), unit(random)}; }

}  // namespace

TEST_CASE("a nearest point is the nearest after memory ran out, too", "[motion][surface]") {
    for_each_seed(20, [](Random& random) {
        Point_tree tree;
        for (int k = 0; k < 300; ++k) {
            const Coordinates<3> p = somewhere(random);
            tree.triangles.push_back({p, p, p});
        }
        Nearby_3 nearby;
        Coordinates<3> p = somewhere(random);
        for (int k = 0; k < 200; ++k) {
            const double stride = random() % 8 == 0 ? 0.5 : 0.02;
            for (double& c : p) c += stride * (unit(random) - 0.5);
            const Coordinates<3> near = tree.nearest(somewhere(random));
            tree.memory = random() % 2 == 0 ? static_cast<int>(random() % 40) : -1;
            Coordinates<3> found{};
            try {
                found = Nearest_search(tree, nearby).nearest(p, near);
            } catch (const std::bad_alloc&) {
                tree.memory = -1;
                found = Nearest_search(tree, nearby).nearest(p, near);
            }
            REQUIRE(found == tree.nearest(p));
        }
    });
}
