// SPDX-License-Identifier: GPL-3.0-or-later
// Two moving positions that coincide, which tolerances that are not certified may allow, and memory that runs out: the
// cells are built again at the fixed positions, and the object goes on.
#include <annulus/engine/engine.h>
#include <annulus/published/paper_strategy.h>

#include <support/catch.h>
#include <support/failing_new.h>
#include <support/meshes.h>

#include <engine/strategy_session.h>

#include <functional>
#include <limits>
#include <memory>

using namespace annulus;
using namespace annulus::testing;

namespace {

REVEAL(Plane_state, &Paper_strategy<2>::state_);
REVEAL(Space_state, &Paper_strategy<3>::state_);

/// Vertices 0 and 1 are at one position. Rounding would have to make a tolerance too large by more than moves are
/// likely to find, so it is set.
template <int d>
struct Coinciding {
    Delaunay_mesh<d> mesh;
    Paper_strategy<d>* strategy = new Paper_strategy<d>(mesh, Paper_choice{}, Tolerance_kind::floating, 0);
    Engine<d> engine{mesh,
                     {.strategy = Strategy::paper, .tolerance = Tolerance_kind::floating},
                     std::unique_ptr<Update_strategy<d>>(strategy)};

    Coinciding() {
        engine.build(grid<d>());
        auto& state = [this]() -> auto& {
            if constexpr (d == 2) return strategy->*member(Plane_state{});
            else return strategy->*member(Space_state{});
        }
        ();
        state.epsilon[0] = state.threshold[0] = std::numeric_limits<double>::infinity();
        REQUIRE(engine.move(0, engine.positions()[1]).moves.within_tolerance == 1);
    }
    [[nodiscard]] Points_d<d> positions() const { return {engine.positions().begin(), engine.positions().end()}; }
    /// Whether there are cells, and they are Delaunay at the fixed positions.
    [[nodiscard]] bool is_whole() const {
        Audit_input<d> input = engine.audit_input();
        for (std::size_t i = 0; i < input.points.size(); ++i) input.points[i] = engine.fixed_position(input.names[i]);
        return input.points.size() == grid<d>().size() && audit(input).delaunay();
    }
};

template <int d>
using Call = std::function<void(Engine<d>&)>;

/// Whether the call found that two positions coincide.
template <int d>
bool is_refused(const Call<d>& call, Engine<d>& engine) {
    try {
        call(engine);
    } catch (const Error& e) {
        return e.code() == Error_code::duplicate_point;
    }
    return false;
}

template <int d>
void starve_at(std::uint64_t n, Memory memory, const Call<d>& call, bool& done) {
    Coinciding<d> scene;
    Engine<d>& engine = scene.engine;
    const Points_d<d> before = scene.positions();
    const Starved became = starve(n, memory, [&] { (void)is_refused<d>(call, engine); });
    done = became == Starved::done;
    if (became == Starved::refused) {
        REQUIRE(scene.positions() == before);
        if (memory == Memory::short_for_good) (void)engine.move(2, before[2]);
        REQUIRE(scene.is_whole());
        REQUIRE(is_refused<d>([](Engine<d>& e) { (void)e.recompute_tolerances(); }, engine));
        (void)is_refused<d>(call, engine);
    }
    REQUIRE(scene.is_whole());
    Points_d<d> apart = sheared<d>(grid<d>(), 1e-3);
    (void)engine.move_all(apart);
    (void)engine.recompute_tolerances();
    REQUIRE(scene.positions() == apart);
    REQUIRE(audit(engine.audit_input()).delaunay());
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Where two positions coincide, a call that runs out of memory leaves all as it was, dimension",
                       "[published][allocation]", ((int d), d), 2, 3) {
    Coordinates<d> inside;
    inside.fill(1.3);
    const std::vector<Call<d>> calls{
        [=](auto& e) { (void)e.move(5, inside); }, [=](auto& e) { (void)e.move(5, e.positions()[7]); },
        [](auto& e) { (void)e.move_all(sheared<d>(grid<d>(), 0.7)); }, [](auto& e) { (void)e.recompute_tolerances(); },
        [=](auto& e) {
            Move_result report;
            (void)e.insert(inside, report);
        }};
    for (std::size_t k = 0; k < calls.size(); ++k)
        for (const Memory memory : {Memory::short_once, Memory::short_for_good}) {
            bool done = false;
            for (std::uint64_t n = 0; !done; n += 1 + n / 8) {
                CAPTURE(k, memory == Memory::short_for_good, n);
                starve_at<d>(n, memory, calls[k], done);
            }
        }
}
