// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic_mesh: moves, insertions and removals in any order, each of which begins at what the one before left: the
// cells of a fresh build after every call, audited, the pairs that it lists, and nothing changed where it throws.
#include <annulus/error.h>
#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/cells_of_periodic.h>
#include <support/failing_new.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <random>
#include <tuple>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

/// What moves of all walks have done, by vertex, and how many calls have thrown.
struct Met {
    std::size_t kept = 0, flipped = 0, rebuilt = 0, flipped_with_free = 0, thrown = 0, calls = 0, reinserted = 0,
                several_reinserted = 0;
};

template <int d>
class Walk {
  public:
    Walk(std::uint64_t seed, std::size_t n, Met& met)
        : cases_(seed),
          on_sites_(cases_.below(3) == 0),
          box_(cases_.box<d>(static_cast<int>(cases_.below(Periodic_cases::kinds)))),
          mesh_({}, box_, {.report_changes = cases_.below(2) == 0}),
          met_(met) {
        change([&] { mesh_.insert(several(n)); });
    }
    void step() {
        ++met_.calls;
        switch (cases_.below(13)) {
            case 0: return change([&] { mesh_.insert(point()); });
            case 1: return change([&] { mesh_.insert(several(cases_.below(mesh_.number_of_vertices() / 4 + 3))); });
            case 2: return remove(1);
            case 3: return remove(cases_.below(mesh_.number_of_vertices() / 4 + 3));
            case 4: return move(moved(cases_.below(4) + 1, 3), box_);  // some, far
            case 5: return move(moved(1, std::pow(10, cases_.uniform(-6, -2))), box_);
            case 6: return move(with_images(moved(4, 0.01)), box_);
            case 7: return move_in_another_box();
            case 8: return move_some(1, 3);
            case 9: return move_some(1, std::pow(10, cases_.uniform(-6, -1)));
            case 10: return move_some(cases_.below(4), 0.3);
            case 11: return move_some(cases_.below(9), 3);
            default: return move(where_two_coincide(), box_);
        }
    }

  private:
    using Points = std::vector<Coordinates<d>>;

    [[nodiscard]] Coordinates<d> point() {
        if (!on_sites_) return cases_.point<d>(box_, 3);
        Coordinates<d> p{};
        for (const auto& v : box_.vectors()) {
            const double f = static_cast<double>(cases_.below(24)) / 8 - 1;
            for (std::size_t i = 0; i < d; ++i) p[i] += f * v[i];
        }
        return p;
    }
    [[nodiscard]] Points several(std::size_t n) {
        Points x(n);
        for (auto& p : x) p = point();
        return x;
    }
    /// One point in so many, by up to so much of the vectors of the box; anything at free indices.
    [[nodiscard]] Points moved(std::size_t one_in, double most) {
        Points x(mesh_.points().begin(), mesh_.points().end());
        for (std::size_t v = 0; v < x.size(); ++v) {
            if (!mesh_.is_vertex(static_cast<Index>(v)))
                x[v].fill(cases_.below(2) == 0 ? std::numeric_limits<double>::infinity() : cases_.uniform(-9, 9));
            else if (cases_.below(one_in) == 0) {
                const Coordinates<d> way = cases_.point<d>(box_, most);
                for (std::size_t i = 0; i < d; ++i) x[v][i] += way[i];
            }
        }
        return x;
    }
    [[nodiscard]] Points with_images(Points x) {
        for (auto& p : x)
            for (const auto& v : box_.vectors()) {
                const double k = static_cast<double>(cases_.below(5)) - 2;
                for (std::size_t i = 0; i < d; ++i) p[i] += k * v[i];
            }
        return x;
    }
    /// Which throws, after flips perhaps, where there are two points.
    [[nodiscard]] Points where_two_coincide() {
        Points x = moved(4, 0.003);
        const std::size_t v = x.empty() ? 0 : cases_.below(x.size());
        for (std::size_t k = 0; k < x.size(); ++k)
            if (k != v && mesh_.is_vertex(static_cast<Index>(k)) && mesh_.is_vertex(static_cast<Index>(v))) {
                x[v] = x[k];
                break;
            }
        return x;
    }
    /// Strained, in another basis, or any.
    void move_in_another_box() {
        typename Box<d>::Vectors v = box_.vectors();
        Points x = moved(2, 0.001);
        const std::size_t how = cases_.below(3);
        if (how == 0) {
            const double stretch = 1 + cases_.uniform(-0.02, 0.02);
            for (auto& row : v) row[0] *= stretch;
            for (auto& p : x) p[0] *= stretch;
        }
        if (how == 1) {
            const double sign = cases_.below(2) == 0 ? 1 : -1;
            for (std::size_t i = 0; i < d; ++i) v[0][i] += sign * v[d - 1][i];
        }
        if (how == 2) v = cases_.box<d>(static_cast<int>(cases_.below(Periodic_cases::kinds))).vectors();
        try {
            move(x, Box<d>(v));
        } catch (const Error&) {  // too skewed
        }
    }
    void move(const Points& x, const Box<d>& box) {
        change([&] {
            const bool same = box.vectors() == box_.vectors() && cases_.below(2) == 0;
            const Move_result r = same ? mesh_.move_all(x) : mesh_.move_all(x, box);
            CHECK(r.moves.asked == mesh_.number_of_vertices());
            CHECK(r.moves.within_tolerance + r.moves.kept_in_place + r.moves.flipped + r.moves.rebuilt ==
                  r.moves.asked);
            met_.kept += r.moves.within_tolerance + r.moves.kept_in_place;
            met_.flipped += r.moves.flipped;
            met_.rebuilt += r.moves.rebuilt;
            if (mesh_.number_of_vertices() < mesh_.index_bound()) met_.flipped_with_free += r.moves.flipped;
            box_ = box;
        });
    }
    [[nodiscard]] std::vector<Index> some(std::size_t most) {
        std::vector<Index> all;
        for (std::size_t v = 0; v < mesh_.index_bound(); ++v)
            if (mesh_.is_vertex(static_cast<Index>(v))) all.push_back(static_cast<Index>(v));
        for (std::size_t k = 0; k < all.size(); ++k) std::swap(all[k], all[k + cases_.below(all.size() - k)]);
        all.resize(std::min(all.size(), most));
        return all;
    }
    /// So many, by up to so much of the vectors of the box; sometimes two of them to each other's place, to that of a
    /// vertex, or to another image of theirs.
    void move_some(std::size_t count, double most) {
        const std::vector<Index> which = some(count);
        const Points x(mesh_.points().begin(), mesh_.points().end());
        Points to;
        for (const Index v : which) {
            to.push_back(x[static_cast<std::size_t>(v)]);
            const Coordinates<d> way = cases_.point<d>(box_, most);
            for (std::size_t i = 0; i < d; ++i) to.back()[i] += way[i];
        }
        if (const std::size_t how = cases_.below(8); !which.empty() && how == 0) {
            to[0] = x[static_cast<std::size_t>(some(1)[0])];
        } else if (which.size() > 1 && how <= 2) {
            to[0] = x[static_cast<std::size_t>(which[1])];
            to[1] = x[static_cast<std::size_t>(which[0])];
        } else if (!which.empty() && how == 3) {
            to[0] = x[static_cast<std::size_t>(which[0])];
            for (std::size_t i = 0; i < d; ++i) to[0][i] += 2 * box_.vectors()[0][i];
        }
        change([&] {
            const Move_result r = which.size() == 1 ? mesh_.move(which[0], to[0]) : mesh_.move(which, to);
            if (r.moves.reinserted > 0) ++met_.reinserted;
            if (r.moves.reinserted > 1) ++met_.several_reinserted;
            CHECK((r.moves.asked == which.size() || r.moves.asked == mesh_.number_of_vertices()));
            CHECK((r.moves.reinserted == 0 || r.moves.reinserted + r.moves.kept_in_place == which.size()));
            for (std::size_t k = 0; k < which.size(); ++k) {
                const auto& p = mesh_.points()[static_cast<std::size_t>(which[k])];
                const double near = 1e-14 * (std::fabs(to[k][0]) + std::fabs(to[k][1]) + box_.vectors()[0][0]);
                for (std::size_t i = 0; i < d; ++i)
                    CHECK(std::fabs(p[i] - to[k][i]) <= 64 * mesh_.grid()[i] + std::fabs(near));
            }
        });
    }
    void remove(std::size_t most) {
        const std::vector<Index> all = some(most);
        change([&] {
            if (all.size() == 1) mesh_.remove(all[0]);
            else mesh_.remove(all);
        });
    }

    [[nodiscard]] auto seen() const {
        const auto of = [](auto span) { return std::vector(span.begin(), span.end()); };
        Points places = of(mesh_.places());
        std::erase_if(places, [](const auto& p) { return std::isnan(p[0]); });  // which is not equal to itself
        return std::tuple(cells_of(mesh_), places, of(mesh_.images()), mesh_.saved().free_indices,
                          mesh_.box().vectors());
    }
    template <class Call>
    void change(Call call) {
        const auto before = seen();
        const std::size_t pairs = mesh_.neighbours().first.size() / 2;
        try {
            call();
            if (mesh_.options().report_changes) {
                const auto& changes = mesh_.changes();
                CHECK(pairs - changes.broken.first.size() + changes.made.first.size() ==
                      mesh_.neighbours().first.size() / 2);
            }
        } catch (const Error&) {
            ++met_.thrown;
            CHECK(seen() == before);
        }
        expect_fresh();
    }
    void expect_fresh() const {
        const Periodic_mesh<d> fresh(mesh_.saved());
        CHECK(cells_of(mesh_) == cells_of(fresh));
        const auto a = mesh_.neighbours(), b = fresh.neighbours();
        CHECK((a.first == b.first && a.second == b.second && a.shift == b.shift));
        REQUIRE(a.area.size() == b.area.size());
        for (std::size_t k = 0; k < a.area.size(); ++k) CHECK((a.area[k] == 0) == (b.area[k] == 0));  // cospherical
        const Audit_result audit = mesh_.audit();
        CHECK(audit.first_fault.empty());
        CHECK(audit.delaunay());
    }

    Periodic_cases cases_;
    bool on_sites_;  // with many cospherical points
    Box<d> box_;
    Periodic_mesh<d> mesh_;
    Met& met_;
};

template <int d>
void expect_right_walks(int walks, std::initializer_list<std::size_t> sizes, int steps) {
    Met met;
    for (int k = 0; k < walks; ++k)
        for (const std::size_t n : sizes) {
            const std::uint64_t seed = 1000 * static_cast<std::uint64_t>(k) + n;
            CAPTURE(d, n, seed);
            Walk<d> walk(seed, n, met);
            for (int step = 0; step < steps; ++step) {
                CAPTURE(step);
                walk.step();
            }
        }
    CAPTURE(d, met.calls, met.thrown, met.kept, met.flipped, met.flipped_with_free, met.rebuilt, met.reinserted,
            met.several_reinserted);
    CHECK(met.kept > 0);
    CHECK(met.reinserted > 0);
    if (walks > 1) CHECK(met.several_reinserted > 0);  // not in the few calls of ANNULUS_TEST_MULTIPLIER=0.1
    CHECK(met.flipped_with_free > 0);
    CHECK(met.rebuilt > 0);
    CHECK(met.thrown > 0);
    CHECK(met.thrown < met.calls / 4);
}

/// What is at a free index is no point, and does not count as one that moves.
template <int d>
void expect_idle_step_to_cost_nothing() {
    CAPTURE(d);
    Periodic_cases cases(d);
    const Box<d> box = cases.box<d>(0);  // on the grid, so that points() have the places that they had
    Periodic_mesh<d> mesh(cases.points<d>(box, 80), box);
    mesh.remove(std::vector<Index>{5, 33, 79});
    std::vector<Coordinates<d>> x(mesh.points().begin(), mesh.points().end());
    x[33].fill(std::numeric_limits<double>::infinity());
    x[79].fill(1e300);
    const Move_result idle = mesh.move_all(x);
    CHECK(idle.statistics.cost == 0);
    CHECK(idle.moves.kept_in_place == 77);
    x[40][0] += 1e-9;
    CHECK(mesh.move_all(x).statistics.cost > 0);
}

}  // namespace

TEST_CASE("a step of a periodic mesh in which no vertex moves tests nothing, with free indices, too",
          "[engine][periodic]") {
    expect_idle_step_to_cost_nothing<2>();
    expect_idle_step_to_cost_nothing<3>();
}

TEST_CASE("periodic moves, insertions and removals in any order: the cells of a fresh build", "[engine][periodic]") {
    expect_right_walks<2>(repeats(12), {0, 3, 17, 90, 300}, 25);
    expect_right_walks<3>(repeats(6), {0, 2, 12, 60, 200}, 20);
}

TEMPLATE_TEST_CASE_SIG("A move that runs out of memory keeps neighbours and what is cospherical", "[engine][periodic]",
                       ((int d), d), 2, 3) {
    std::vector<Coordinates<d>> lattice;
    for (int k = 0; k < (d == 2 ? 16 : 64); ++k) {
        Coordinates<d> p;
        for (int i = 0, rest = k; i < d; ++i, rest /= 4) p[static_cast<std::size_t>(i)] = rest % 4 / 4.0;
        lattice.push_back(p);
    }
    auto moved = lattice;
    std::mt19937_64 random(1);
    for (auto& p : moved)
        for (double& c : p) c += std::uniform_real_distribution(-1e-6, 1e-6)(random);
    Coordinates<d> one;
    one.fill(1);
    int refused = 0;
    for (std::uint64_t n = 0;; ++n) {
        Periodic_mesh<d> mesh(lattice, Box<d>::orthorhombic(one));
        const auto counts = mesh.neighbour_counts();
        const auto outcome = starve(n, Memory::short_once, [&] { mesh.move_all(moved); });
        if (outcome == Starved::done) break;
        if (outcome != Starved::refused) continue;
        ++refused;
        REQUIRE(mesh.neighbour_counts() == counts);
        REQUIRE(mesh.audit().delaunay());
    }
    CHECK(refused > 20);
}
