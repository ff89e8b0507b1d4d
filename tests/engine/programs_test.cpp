// SPDX-License-Identifier: GPL-3.0-or-later
// Whole programs of calls on point sets of every family, in 2D and in 3D: after each call the audit, CGAL and a rebuild
// must agree. A failure is printed as a small program (fuzz/common/shrink.h).
#include <common/operation.h>

#include <support/cases.h>

#include <cmath>
#include <iostream>

using namespace annulus;
using namespace annulus::oracle;
using namespace annulus::testing;

namespace {

constexpr std::array paces{0x1p-40, 0x1p-30, 0x1p-20, 0x1p-14, 0x1p-10, 0x1p-8, 0x1p-6, 0x1p-4, 0x1p-3, 0.5};
constexpr std::array shares{0.1, 0.5, 0.9, 0.99, 0.9999, 1.0001, 1.01, 1.3, 3.0, 10.0};

template <int d>
class Author {
  public:
    using Do = Calls<d>;

    Author(Set_of<d> set, std::uint64_t seed, int most) : set_(set), random_(seed) {
        n_ = static_cast<std::size_t>(integer(random_, 0, most));
        pool_ = point_set(set, n_ + n_ / 2 + 3, random_);
    }

    /// Moves between the positions of a pool, so that vertices return and meet; motions in between.
    [[nodiscard]] Program_of<d> program(const Setting& setting, int calls, int steps) {
        Program_of<d> program{setting, {pool_.begin(), pool_.begin() + static_cast<std::ptrdiff_t>(n_)}, {}};
        for (int call = 0; call < calls; ++call) {
            program.operations.push_back(operation(steps));
            steps -= program.operations.back().times;
        }
        return program;
    }

  private:
    std::size_t number(std::size_t bound) { return static_cast<std::size_t>(random_() % bound); }
    Index someone() { return static_cast<Index>(number(2 * n_ + 2)); }
    Coordinates<d> place() { return pool_[number(pool_.size())]; }
    Coordinates<d> near(Coordinates<d> p) {
        const Coordinates<d> other = place();
        const int share = -static_cast<int>(number(55));
        for (std::size_t k = 0; k < p.size(); ++k) p[k] += std::ldexp(other[k] - p[k], share);
        return p;
    }
    Points_of<d> shuffled() {
        Points_of<d> x = pool_;
        for (std::size_t i = x.size(); i > 1; --i) std::swap(x[i - 1], x[number(i)]);
        return x;
    }
    Operation_of<d> operation(int steps) {
        switch (number(16)) {
            case 0:
            case 1: return Do::move_some(someone(), place());
            case 2: return Do::move_some(someone(), near(place()));
            case 3: return Do::move_most(shuffled());
            case 4: {
                Points_of<d> x = pool_;
                for (auto& p : x)
                    if (number(3) == 0) p = near(p);
                return Do::move_most(x);
            }
            case 10: return Do::insert_near(place());
            case 11: return Do::remove_some(someone());
            case 12: return Do::recompute_tolerances();
            case 13: return Do::stay();
            case 14: return Do::refused(static_cast<Refusal>(number(refusals)), someone());
            case 15: return as_written();
            default: break;
        }
        const Motion motion = annulus::oracle::all_motions[number(annulus::oracle::all_motions.size())];
        const double pace = motion == Motion::tolerances ? shares[number(shares.size())] : paces[number(paces.size())];
        const int most = std::max(1, std::min(steps, number(4) == 0 ? 64 : 9));
        return Do::steady(motion, integer(random_, 1, most), pace, number(1000));
    }
    /// Legal or not, at random.
    Operation_of<d> as_written() {
        switch (number(4)) {
            case 0: return Do::insert(place());
            case 1: return Do::remove(static_cast<Index>(number(n_ + 2)));
            case 2: {
                Points_of<d> x = shuffled();
                x.resize(std::min(n_, x.size()));
                return Do::move_all(x);
            }
            default: return Do::move(static_cast<Index>(number(n_ + 2)), place());
        }
    }

    Set_of<d> set_;
    Random random_;
    std::size_t n_;
    Points_of<d> pool_;
};

template <int d>
std::string run_random(const Setting& setting, Random& random, Coverage& coverage, int calls = 12) {
    const Set_of<d> set = any_set<d>(random);
    const int most = std::array{4, 9, 9, 30}[random() % 4];
    return run_and_shrink(Author<d>(set, random(), most).program(setting, calls, d == 2 ? 120 : 40), d == 2 ? 2 : 1,
                          &coverage);
}

template <int d>
void holds(const Program_of<d>& program) {
    const std::string fault = run_and_shrink(program);
    INFO(fault);
    REQUIRE(fault.empty());
}

/// Covers everything that the strategies can do.
bool reached_everything(const Coverage& c) {
    const Move_result& r = c.report;
    return r.moves.within_tolerance > 0 && r.moves.kept_in_place > 0 && r.moves.flipped > 0 && r.moves.reinserted > 0 &&
           r.moves.rebuilt > 0 && r.statistics.undone_flips > 0 && r.statistics.star_walks > 0 &&
           r.statistics.arithmetic.filter > 0 && r.statistics.arithmetic.interval > 0 &&
           r.statistics.arithmetic.exact > 0 && c.switches > 0 && c.duplicate_points() > 0;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG(
    "After any calls under any strategy the audit passes and the cells are those of a rebuild, dimension",
    "[relocation]", ((int d), d), 2, 3) {
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(name_of(setting)) {
            Coverage coverage;
            for_each_seed(d == 2 ? 100 : 30, [&](Random& random) {
                const std::string fault = run_random<d>(setting, random, coverage);
                INFO(fault);
                REQUIRE(fault.empty());
            });
            std::cout << "dimension " << d << ", " << name_of(setting) << ": " << coverage.operations << " operations, "
                      << std::lround(100.0 * coverage.legal_share()) << " % legal\n";
            CHECK(coverage.legal_share() >= 0.8);
            CHECK(coverage.legal_share() <= 0.98);  // some have to be refused
        }
    }
}

TEMPLATE_TEST_CASE_SIG("Programs reach every way out of every stage, dimension", "[relocation][coverage]", ((int d), d),
                       2, 3) {
    Random random(run_seed());
    Coverage coverage;
    for (int run = 0; run < 3000 && !reached_everything(coverage); ++run)
        for (const Setting& setting : certified_settings) {
            const std::string fault = run_random<d>(setting, random, coverage);
            if (!fault.empty()) FAIL(fault);
        }
    std::cout << coverage.words("dimension " + std::to_string(d) + ", ");
    INFO(coverage.words());
    CHECK(reached_everything(coverage));
}

TEMPLATE_TEST_CASE_SIG("A failed call leaves everything as it was, with the right code, dimension", "[relocation]",
                       ((int d), d), 2, 3) {
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(name_of(setting)) {
            Coverage coverage;
            for_each_seed(d == 2 ? 40 : 15, [&](Random& random) {
                const Set_of<d> set = any_set<d>(random);
                const Points_of<d> points = some_points<d>(set, 2, d == 2 ? 20 : 10, random);
                // A drift first, so that fixed positions and tolerances are not freshly computed; a free index later.
                Program_of<d> program{setting, points, {}};
                auto& calls = program.operations;
                calls.push_back(Calls<d>::move_all(point_set(set, points.size(), random)));
                calls.push_back(Calls<d>::steady(Motion::tolerances, 2, 0.5, random() % 1000));
                const auto all = [&] {
                    for (std::size_t why = 0; why < refusals; ++why)
                        calls.push_back(
                            Calls<d>::refused(static_cast<Refusal>(why), static_cast<Index>(random() % 1000)));
                };
                all();
                // Back to where another vertex was: the whole time step fails although each vertex alone could move.
                Points_of<d> elsewhere = points;
                elsewhere[0] = elsewhere[1];
                calls.push_back(Calls<d>::move_all(elsewhere));
                calls.push_back(Calls<d>::remove_some(static_cast<Index>(random() % 1000)));
                all();
                calls.push_back(Calls<d>::move_most(points));
                calls.push_back(Calls<d>::recompute_tolerances());
                const std::string fault = run_and_shrink(program, 1, &coverage);
                INFO(fault);
                REQUIRE(fault.empty());
            });
            for (const Error_code code :
                 {Error_code::not_finite, Error_code::out_of_domain, Error_code::duplicate_point,
                  Error_code::wrong_size, Error_code::unknown_vertex})
                CHECK(coverage.refused[static_cast<std::size_t>(code)] > 0);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("Equal input points are refused, dimension", "[relocation]", ((int d), d), 2, 3) {
    for_each_seed(30, [](Random& random) {
        Points_of<d> points = some_points<d>(any_set<d>(random), 2, 12, random);
        points.push_back(points[points.size() / 2]);
        for (const Setting& setting : certified_settings)
            CHECK(run(Program_of<d>{setting, points, {Calls<d>::insert(points[0])}}) == "");
    });
}

TEMPLATE_TEST_CASE_SIG("Positions that are an object's own may be given back to it, dimension", "[relocation]",
                       ((int d), d), 2, 3) {
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(name_of(setting)) {
            for_each_seed(20, [&](Random& random) {
                const Points_of<d> points = some_points<d>(any_set<d>(random), 0, 12, random);
                using Do = Calls<d>;
                holds<d>({setting,
                          points,
                          {Do::stay(), Do::stay(), Do::steady(Motion::own_ways, 3, 0x1p-20, 1), Do::stay(),
                           Do::remove_some(1), Do::stay(), Do::stay(), Do::stay(), Do::stay()}});
            });
        }
    }
}

TEMPLATE_TEST_CASE_SIG(
    "Tolerances that may be wrong give no crash, and CGAL's object is valid at the fixed positions, dimension",
    "[relocation]", ((int d), d), 2, 3) {
    for (const Setting& setting : uncertified_settings) {
        DYNAMIC_SECTION(name_of(setting)) {
            Coverage coverage;
            for_each_seed(d == 2 ? 100 : 30, [&](Random& random) {
                const std::string fault = run_random<d>(setting, random, coverage);
                INFO(fault);
                REQUIRE(fault.empty());
            });
        }
    }
}
