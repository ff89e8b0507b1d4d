// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Calls of a moving triangulation as data: settings, operations, programs, and programs as code. No CGAL here: the code
// that runs them is in program.h, and compiled once.
//
// An operation may be symbolic instead of explicit ("the third existing vertex", "all vertices a little along the x
// axis"): the session resolves it when it is run, so that a program stays legal whatever the results of earlier calls,
// and remains legal when it is shrunk.

#include <annulus/error.h>
#include <annulus/options.h>
#include <annulus/types.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace annulus::oracle {

// ---- Settings -----------------------------------------------------------------------------------------------------

/// An update strategy with its options.
struct Setting {
    Strategy strategy = Strategy::tolerances;
    Tolerance_kind tolerance = Tolerance_kind::certified;

    // NOLINTNEXTLINE: a strategy alone is a setting
    constexpr Setting(Strategy s = Strategy::tolerances, Tolerance_kind kind = Tolerance_kind::certified)
        : strategy(s), tolerance(kind) {}
    friend constexpr bool operator==(const Setting&, const Setting&) = default;
};
[[nodiscard]] inline Options options_of(const Setting& s) {
    Options o;
    o.strategy = s.strategy;
    o.tolerance = s.tolerance;
    return o;
}

inline constexpr std::array<Setting, 9> certified_settings{{{Strategy::rebuild},
                                                            {Strategy::relocate},
                                                            {Strategy::relocate_flips},
                                                            {Strategy::in_place},
                                                            {Strategy::tolerances},
                                                            {Strategy::tolerances_each},
                                                            {Strategy::paper},
                                                            {Strategy::paper_hybrid},
                                                            {Strategy::automatic}}};

/// Settings whose only guarantee is not to crash.
inline constexpr std::array<Setting, 3> uncertified_settings{{{Strategy::paper, Tolerance_kind::floating},
                                                              {Strategy::paper, Tolerance_kind::paper},
                                                              {Strategy::paper_hybrid, Tolerance_kind::paper}}};

/// tolerances, tolerances-each, paper-floating ...
[[nodiscard]] std::string name_of(const Setting& s);

/// The certified strategies that keep tolerances from one call to the next.
[[nodiscard]] inline std::vector<Setting> tolerance_settings() {
    std::vector<Setting> settings;
    for (const Setting& s : certified_settings)
        if (s.strategy == Strategy::tolerances || s.strategy == Strategy::tolerances_each ||
            s.strategy == Strategy::automatic)
            settings.push_back(s);
    return settings;
}

// ---- Operations ---------------------------------------------------------------------------------------------------

enum class Operation_kind {
    move,
    move_all,
    insert,
    remove,
    recompute_tolerances,
    stay,     ///< move_all with the object's own positions()
    steady,   ///< many time steps of one motion
    refused,  ///< a call that must be refused
};

/// The motion of all vertices in a time step, from their present positions.
enum class Motion {
    drift,           ///< all the same way
    own_ways,        ///< straight on, each its own way
    orbits,          ///< each around a circle of its own
    shear,           ///<
    rotation,        ///< around the centre of the whole
    breathing,       ///< away from the centre, and back after a while
    jitter,          ///< anywhere within the pace
    tolerances,      ///< `pace` tolerances from the fixed position, or, if the seed is odd, all the same way from here
    ulps,            ///< one or two ulps a coordinate
    few,             ///< one to three vertices, others after a while
    exchange,        ///< two vertices, or if the seed is odd several in a cycle, exchange positions
    there_and_back,  ///< a jitter, and back
    rest_and_go,     ///< rest, a step, rest
    bursts,          ///< a small jitter; now and then one vertex, or all, to any place
};
inline constexpr std::array all_motions{
    Motion::drift,     Motion::own_ways,       Motion::orbits,      Motion::shear, Motion::rotation,
    Motion::breathing, Motion::jitter,         Motion::tolerances,  Motion::ulps,  Motion::few,
    Motion::exchange,  Motion::there_and_back, Motion::rest_and_go, Motion::bursts};
[[nodiscard]] std::string_view name_of(Motion m);

/// Why a call must be refused.
enum class Refusal {
    move_to_nan,
    move_to_infinity,
    move_out_of_domain,
    insert_nan,
    insert_out_of_domain,
    move_all_to_nan,
    move_all_out_of_domain,
    one_point_too_many,
    one_point_too_few,
    move_meets,      ///< the position of another vertex
    insert_meets,    ///<
    move_all_meets,  ///< two at one position, and the others moved a little
    move_free,       ///< a free index, or, where there is none, the first beyond
    remove_free,     ///<
    move_beyond,     ///< not an index at all
};
inline constexpr std::size_t refusals = static_cast<std::size_t>(Refusal::move_beyond) + 1;

template <int d>
struct Operation_of {
    using Kind = Operation_kind;
    Kind kind = Kind::recompute_tolerances;
    Index vertex = none;                   ///< move, remove; refused: the vertex concerned
    std::vector<Coordinates<d>> points{};  ///< one for move and insert, all for move_all
    bool fits = false;       ///< made legal: `vertex` counts existing ones, occupied or invalid positions are replaced
    Motion motion{};         ///< steady
    int times = 0;           ///< steady: time steps
    double pace = 0.0;       ///< steady: share of the extent; in bursts and others see their comments
    std::uint64_t seed = 0;  ///< steady: for its random numbers. refused: which Refusal
};
using Operation = Operation_of<2>;
using Operation_3 = Operation_of<3>;

/// Operations by their names.
template <int d>
struct Calls {
    using Place = Coordinates<d>;
    using Operation = Operation_of<d>;
    using Kind = Operation_kind;

    // As they are written.
    [[nodiscard]] static Operation move(Index v, const Place& p) { return {Kind::move, v, {p}}; }
    [[nodiscard]] static Operation move_all(std::vector<Place> x) { return {Kind::move_all, none, std::move(x)}; }
    [[nodiscard]] static Operation insert(const Place& p) { return {Kind::insert, none, {p}}; }
    [[nodiscard]] static Operation remove(Index v) { return {Kind::remove, v, {}}; }
    [[nodiscard]] static Operation recompute_tolerances() { return {}; }
    [[nodiscard]] static Operation stay() { return {Kind::stay, none, {}}; }
    // Made legal.
    [[nodiscard]] static Operation move_some(Index k, const Place& p) { return {Kind::move, k, {p}, true}; }
    [[nodiscard]] static Operation insert_near(const Place& p) { return {Kind::insert, none, {p}, true}; }
    [[nodiscard]] static Operation remove_some(Index k) { return {Kind::remove, k, {}, true}; }
    /// x: the vertices from the first on; the others, and those whose target is occupied, stay.
    [[nodiscard]] static Operation move_most(std::vector<Place> x) {
        return {Kind::move_all, none, std::move(x), true};
    }
    [[nodiscard]] static Operation steady(Motion m, int times, double pace, std::uint64_t seed) {
        return {Kind::steady, none, {}, true, m, times, pace, seed};
    }
    // Made illegal.
    [[nodiscard]] static Operation refused(Refusal why, Index v = 0) {
        return {Kind::refused, v, {}, false, Motion{}, 0, 0.0, static_cast<std::uint64_t>(why)};
    }
};

using Position = Coordinates<2>;
[[nodiscard]] inline Operation move(Index v, Position p) { return Calls<2>::move(v, p); }
[[nodiscard]] inline Operation move_all(std::vector<Position> x) { return Calls<2>::move_all(std::move(x)); }
[[nodiscard]] inline Operation insert(Position p) { return Calls<2>::insert(p); }
[[nodiscard]] inline Operation remove(Index v) { return Calls<2>::remove(v); }
[[nodiscard]] inline Operation recompute_tolerances() { return {}; }

template <int d>
struct Program_of {
    Setting setting;
    std::vector<Coordinates<d>> points;
    std::vector<Operation_of<d>> operations{};
};
using Program = Program_of<2>;
using Program_3 = Program_of<3>;

/// What a run of a program finds: the library's object and the model differ.
struct Session_fault {
    std::string words;
};

// ---- As code ------------------------------------------------------------------------------------------------------

[[nodiscard]] std::string number_as_code(double x);
template <std::size_t d>
[[nodiscard]] std::string points_as_code(const std::vector<std::array<double, d>>& points) {
    std::string s;
    for (const auto& p : points) {
        s += s.empty() ? "{" : ", {";
        for (std::size_t k = 0; k < d; ++k) s += (k > 0 ? ", " : "") + number_as_code(p[k]);
        s += "}";
    }
    return s;
}

/// A definition ready to paste into tests/engine/finds.cpp.
template <int d>
[[nodiscard]] std::string as_code(const Program_of<d>& program);

// ---- Running ------------------------------------------------------------------------------------------------------

/// The sum of what programs have covered.
struct Coverage {
    std::uint64_t operations = 0;        ///< but recompute_tolerances(), which is always legal; a steady motion is one
    std::uint64_t legal_operations = 0;  ///< of these: what the model expects to be accepted
    std::uint64_t calls = 0;             ///< of the library
    std::array<std::uint64_t, 32> refused{};  ///< by error code
    Move_result report;                       ///< of all calls that were accepted
    std::uint64_t switches = 0;               ///< of paper-hybrid to paper

    Coverage& operator+=(const Coverage& o);
    [[nodiscard]] double legal_share() const;
    [[nodiscard]] std::uint64_t duplicate_points() const {
        return refused[static_cast<std::size_t>(Error_code::duplicate_point)];
    }
    /// A line each, `prefix` before it.
    [[nodiscard]] std::string words(std::string_view prefix = "") const;
};

/// Runs a program, checks everything after every call, and compares recomputed tolerances with rational numbers the
/// first `rational` times, which is slow in 3D. Empty, or the fault and its place.
[[nodiscard]] std::string run(const Program& program, int rational = 64, Coverage* coverage = nullptr);
[[nodiscard]] std::string run(const Program_3& program, int rational = 2, Coverage* coverage = nullptr);

/// The same; a failing program is shrunk first, and printed as code with the fault.
[[nodiscard]] std::string run_and_shrink(const Program& program, int rational = 64, Coverage* coverage = nullptr);
[[nodiscard]] std::string run_and_shrink(const Program_3& program, int rational = 2, Coverage* coverage = nullptr);

}  // namespace annulus::oracle
