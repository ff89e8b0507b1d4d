// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A program of moves, insertions and removals in the plane or in space, run against the library with a model beside it that
// knows what every call has to do. Shared by the fuzz targets (which decode bytes into programs) and the property tests.

#include "oracle.h"
#include "oracle_3.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <set>
#include <sstream>
#include <string>

namespace annulus::oracle {

/// One of the ways to keep a triangulation right.
struct Setting {
    Strategy strategy = Strategy::filter;
    Second_look second_look = Second_look::off;
    Tolerance_kind tolerance = Tolerance_kind::certified;

    // NOLINTNEXTLINE: a strategy alone is a setting
    constexpr Setting(Strategy s = Strategy::filter, Second_look look = Second_look::off,
                      Tolerance_kind kind = Tolerance_kind::certified)
        : strategy(s), second_look(look), tolerance(kind) {}
};

inline constexpr std::array<Setting, 9> certified_settings{{{Strategy::rebuild},
                                                            {Strategy::relocate},
                                                            {Strategy::relocate_flips},
                                                            {Strategy::in_place},
                                                            {Strategy::filter},
                                                            {Strategy::filter, Second_look::unequal_moves},
                                                            {Strategy::filter, Second_look::safe_region},
                                                            {Strategy::filter_each},
                                                            {Strategy::hybrid}}};

/// In space there are no second looks.
inline constexpr std::array<Setting, 7> certified_settings_3{{{Strategy::rebuild},
                                                              {Strategy::relocate},
                                                              {Strategy::relocate_flips},
                                                              {Strategy::in_place},
                                                              {Strategy::filter},
                                                              {Strategy::filter_each},
                                                              {Strategy::hybrid}}};

enum class Operation_kind { move, move_all, insert, remove, settle };

template <int d>
struct Operation_of {
    using Kind = Operation_kind;
    Kind kind = Kind::settle;
    Index vertex = none;                   ///< move, remove
    std::vector<Coordinates<d>> points{};  ///< one for move and insert, all for move_all
};
using Operation = Operation_of<2>;
using Operation_3 = Operation_of<3>;

[[nodiscard]] inline Operation move(Index v, Position p) { return {Operation::Kind::move, v, {p}}; }
[[nodiscard]] inline Operation move_all(std::vector<Position> x) {
    return {Operation::Kind::move_all, none, std::move(x)};
}
[[nodiscard]] inline Operation insert(Position p) { return {Operation::Kind::insert, none, {p}}; }
[[nodiscard]] inline Operation remove(Index v) { return {Operation::Kind::remove, v, {}}; }
[[nodiscard]] inline Operation settle() { return {}; }

template <int d>
struct Program_of {
    Setting setting;
    std::vector<Coordinates<d>> points;
    std::vector<Operation_of<d>> operations{};
};
using Program = Program_of<2>;
using Program_3 = Program_of<3>;

// ---- As code ------------------------------------------------------------------------------------------------------

[[nodiscard]] inline std::string number_as_code(double x) {
    if (std::isnan(x)) return "NAN";
    if (std::isinf(x)) return x > 0 ? "INFINITY" : "-INFINITY";
    std::array<char, 40> text{};
    if (x == std::nearbyint(x) && std::fabs(x) < 1e6) {
        std::snprintf(text.data(), text.size(), std::signbit(x) && x == 0.0 ? "-0.0" : "%.0f", x);
    } else {
        std::snprintf(text.data(), text.size(), "%a", x);
    }
    return text.data();
}
[[nodiscard]] inline std::string name_as_code(Second_look look) {
    return look == Second_look::off ? "off" : look == Second_look::unequal_moves ? "unequal_moves" : "safe_region";
}
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

/// A definition ready to paste into tests/relocation/finds.cpp.
template <int d>
[[nodiscard]] std::string as_code(const Program_of<d>& program) {
    const auto identifier = [](std::string_view name) {
        std::string s(name);
        std::replace(s.begin(), s.end(), '-', '_');
        return s;
    };
    std::ostringstream out;
    out << (d == 2 ? "const Program" : "const Program_3")
        << " program{{Strategy::" << identifier(name_of(program.setting.strategy))
        << ", Second_look::" << name_as_code(program.setting.second_look)
        << ", Tolerance_kind::" << name_of(program.setting.tolerance) << "},\n    {" << points_as_code(program.points)
        << "},\n    {";
    constexpr std::array names{"move", "move_all", "insert", "remove", "settle"};
    for (std::size_t i = 0; i < program.operations.size(); ++i) {
        const Operation_of<d>& o = program.operations[i];
        if (i > 0) out << ",\n     ";
        out << "{Operation_kind::" << names[static_cast<std::size_t>(o.kind)] << ", " << o.vertex << ", {"
            << points_as_code(o.points) << "}}";
    }
    out << "}};\n";
    return out.str();
}

// ---- State --------------------------------------------------------------------------------------------------------

/// All a caller can see of an object.
template <int d>
struct State_of {
    std::vector<Coordinates<d>> positions;
    std::vector<Coordinates<d>> fixed;
    std::vector<Coordinates<d>> cgal_points;
    std::vector<double> tolerances;
    std::vector<typename Space<d>::Moving::Vertex_handle> handles;
    Cells_of<d> cells;
    std::size_t vertices = 0;
    bool keeps_tolerances = false;
};
using State = State_of<2>;

template <class Moving>
[[nodiscard]] auto state_of(const Moving& dt) {
    constexpr int d = Moving::dimension_of_space;
    State_of<d> s;
    for (std::size_t i = 0; i < dt.index_bound(); ++i) {
        const auto v = dt.vertex(i);
        s.handles.push_back(v);
        if (v == typename Moving::Vertex_handle()) continue;
        s.positions.push_back(Space<d>::coordinates(dt.position(v)));
        s.fixed.push_back(Space<d>::coordinates(dt.fixed_position(v)));
        s.cgal_points.push_back(Space<d>::coordinates(v->point()));
        s.tolerances.push_back(dt.tolerance(v));
    }
    s.cells = cells_of(dt.triangulation());
    s.vertices = dt.number_of_vertices();
    s.keeps_tolerances = dt.strategy() == Strategy::filter || dt.strategy() == Strategy::filter_each;
    return s;
}

/// Bit for bit where tolerances are kept. Else they are computed when asked for, and the order in which a triangle
/// lists its vertices, which means nothing, is in their rounding.
template <int d>
[[nodiscard]] bool same_tolerances(const State_of<d>& before, const State_of<d>& after) {
    if (before.keeps_tolerances && after.keeps_tolerances) return before.tolerances == after.tolerances;
    return std::equal(before.tolerances.begin(), before.tolerances.end(), after.tolerances.begin(),
                      after.tolerances.end(),
                      [](double a, double b) { return a == b || std::fabs(a - b) <= 0x1p-8 * std::max(a, b); });
}

/// Empty, or what a call that failed has changed. If it `renews` tolerances, they and the references may be others, and as right.
template <int d>
[[nodiscard]] std::string difference(const State_of<d>& before, const State_of<d>& after, bool renews) {
    std::string s;
    if (before.positions != after.positions) s += " positions";
    if (!renews && before.fixed != after.fixed) s += " fixed-positions";
    if (before.cgal_points != after.cgal_points) s += " CGAL-points";
    if (!renews && !same_tolerances(before, after)) s += " tolerances";
    if (before.handles != after.handles) s += " handles";
    if (before.cells != after.cells) s += " cells";
    if (before.vertices != after.vertices) s += " number-of-vertices";
    return s;
}

/// Empty, or how a report contradicts itself.
[[nodiscard]] inline std::string report_fault(const Move_report& r) {
    const Move_counts& m = r.moves;
    if (m.asked != m.within_tolerance + m.kept_in_place + m.flipped + m.reinserted + m.rebuilt)
        return "the counts of a report do not add up to asked";
    if (r.evaluated != r.arithmetic.total()) return "evaluated is not the sum of the stages";
    return {};
}

// ---- Session ------------------------------------------------------------------------------------------------------

/// The library's object and the model of what it must hold.
template <int d>
class Session_of {
  public:
    using Moving = typename Space<d>::Moving;
    using Kind = Operation_kind;

    explicit Session_of(const Program_of<d>& program) : setting_(program.setting) {
        Options options;
        options.strategy = setting_.strategy;
        options.tolerance = setting_.tolerance;
        options.second_look = setting_.second_look;
        const std::optional<Error_code> refusal = verdict(program.points);
        try {
            dt_.emplace(program.points, options);
            if (refusal) throw Fault{"the constructor accepted bad points"};
        } catch (const Error& e) {
            if (!refusal || *refusal != e.code()) throw Fault{std::string("the constructor threw: ") + e.what()};
            dt_.emplace(options);
            return;
        }
        for (const auto& p : program.points) sites_.emplace_back(p);
        for (std::size_t i = 0; i < sites_.size(); ++i) handles_.push_back(dt_->vertex(i));
    }

    Session_of(Strategy strategy, const std::vector<Coordinates<d>>& points)
        : Session_of(Program_of<d>{strategy, points, {}}) {}

    struct Fault {
        std::string words;
    };

    [[nodiscard]] Moving& dt() { return *dt_; }
    [[nodiscard]] const Sites_of<d>& sites() const { return sites_; }
    [[nodiscard]] const Move_report& last() const { return last_; }

    /// Makes the call and compares it with the model. Throws Fault.
    void apply(const Operation_of<d>& o) {
        const std::optional<Error_code> refusal = expected_refusal(o);
        const State_of<d> before = refusal ? state_of(*dt_) : State_of<d>{};
        last_ = {};
        try {
            call(o);
        } catch (const Error& e) {
            if (!certified() && e.code() == Error_code::collision) {
                wrecked_ = true;  // the model cannot tell when a wrong triangulation notices a collision
                return;
            }
            if (!refusal) throw Fault{std::string("a legal call threw: ") + e.what()};
            if (*refusal != e.code()) throw Fault{std::string("a bad call threw the wrong code: ") + e.what()};
            const std::string changed = difference(before, state_of(*dt_), renews_tolerances(o.kind, e.code()));
            if (!changed.empty()) throw Fault{"a failed call changed:" + changed};
            return;
        }
        if (refusal && certified()) throw Fault{"a bad call was accepted"};
        if (refusal) wrecked_ = true;
        follow(o);
        if (const std::string words = report_fault(last_); !words.empty()) throw Fault{words};
    }

    /// Everything that must be true between calls. Throws Fault.
    void check() const {
        const auto& tr = dt_->triangulation();
        if (!certified()) {
            if (setting_.strategy == Strategy::filter_each && !is_valid(tr))
                throw Fault{"CGAL's object is not valid at the fixed positions"};
            return;
        }
        if (dt_->index_bound() != sites_.size()) throw Fault{"index_bound()"};
        std::size_t count = 0;
        for (std::size_t i = 0; i < sites_.size(); ++i) {
            const auto v = dt_->vertex(i);
            if (v != handles_[i]) throw Fault{"a handle changed"};
            if (!sites_[i]) continue;
            ++count;
            if (dt_->index(v) != static_cast<Index>(i)) throw Fault{"index(vertex(i)) != i"};
            const auto p = Space<d>::point(*sites_[i]);
            if (dt_->position(v) != p) throw Fault{"a position is not what was asked for"};
            if (v->point() != p) throw Fault{"CGAL's point is not the position"};
            if (!(dt_->tolerance(v) >= 0.0)) throw Fault{"a tolerance is negative or NaN"};
        }
        if (dt_->number_of_vertices() != count) throw Fault{"number_of_vertices()"};
        const Audit_result audit = dt_->audit();
        if (!audit.delaunay()) throw Fault{"audit: " + audit.first_fault};
        if (!is_valid(tr)) throw Fault{"CGAL's object is not valid"};
        const Cells_of<d> cells = cells_of(tr);
        // CGAL's perturbation makes the triangulation unique where the points do not.
        if (cells != rebuilt_cells(sites_))
            throw Fault{audit.degenerate_facets == 0 ? "the cells are not those of a rebuild"
                                                     : "the cells are not those of a rebuild (degenerate)"};
        if constexpr (d == 3)
            if (const std::string words = mirror_fault(*dt_); !words.empty()) throw Fault{words};
    }

    /// To be called after settle(): tolerances against the exact ones. Throws Fault.
    void check_settled_tolerances() const requires(d == 3) {
        if (sites_.size() > 8) return;  // rational numbers are slow
        if (const std::string words = tolerance_fault(*dt_); !words.empty()) throw Fault{words};
    }
    void check_settled_tolerances() const requires(d == 2) {
        const auto truth = vertex_tolerances(dt_->triangulation(), sites_);
        for (std::size_t i = 0; i < sites_.size(); ++i) {
            if (!sites_[i]) continue;
            const mpf_class found(dt_->tolerance(dt_->vertex(i)), precision);
            if (found > truth[i] * (1 + mpf_class(0x1p-200, precision)))
                throw Fault{"the tolerance of vertex " + std::to_string(i) + " is above the truth"};
            // Rounding to subnormal numbers may lose everything.
            if (truth[i] > mpf_class(0x1p-1000, precision) && found < truth[i] * mpf_class(0.998, precision))
                throw Fault{"the tolerance of vertex " + std::to_string(i) + " is far below the truth"};
        }
    }

    [[nodiscard]] bool certified() const { return setting_.tolerance == Tolerance_kind::certified; }
    /// A collision was met under a kind of tolerance that promises nothing: the model has lost track.
    [[nodiscard]] bool wrecked() const { return wrecked_; }

  private:
    /// CGAL says no by throwing where its assertions are compiled in. In space it is asked for the combinatorics only.
    static bool is_valid(const typename Moving::Triangulation& tr) {
        try {
            if constexpr (d == 2) return tr.is_valid();
            else return tr.tds().is_valid();
        } catch (const CGAL::Failure_exception&) {
            return false;
        }
    }
    static std::optional<Error_code> domain_verdict(const Coordinates<d>& p) {
        for (const double c : p)
            if (!std::isfinite(c)) return Error_code::not_finite;
        for (const double c : p)
            if (std::fabs(c) > 0x1p500) return Error_code::out_of_domain;
        return std::nullopt;
    }
    static std::optional<Error_code> verdict(const std::vector<Coordinates<d>>& points) {
        for (const auto& p : points)
            if (const auto bad = domain_verdict(p)) return bad;
        const std::set<Coordinates<d>> distinct(points.begin(), points.end());
        return distinct.size() == points.size() ? std::nullopt : std::optional(Error_code::collision);
    }
    [[nodiscard]] bool live(Index v) const {
        return v >= 0 && static_cast<std::size_t>(v) < sites_.size() && sites_[static_cast<std::size_t>(v)];
    }

    /// Whether a call that fails may leave other tolerances. A move that finds its place taken may have flipped by then: in
    /// space, what comes back when the flips are undone has other numbers and is evaluated anew (Filter::renew_restored).
    /// A timestamp of single moves may have gone half way: everything is evaluated where it was.
    [[nodiscard]] bool renews_tolerances(Kind kind, Error_code code) const {
        if (code != Error_code::collision) return false;
        const bool each = setting_.strategy == Strategy::filter_each && certified();
        return (kind == Kind::move && d == 3) || (kind == Kind::move_all && (d == 3 || each));
    }

    [[nodiscard]] std::optional<Error_code> expected_refusal(const Operation_of<d>& o) const {
        std::vector<Coordinates<d>> after;
        switch (o.kind) {
            case Kind::settle: return std::nullopt;
            case Kind::remove: return live(o.vertex) ? std::nullopt : std::optional(Error_code::unknown_vertex);
            case Kind::move:
                if (!live(o.vertex)) return Error_code::unknown_vertex;
                break;
            case Kind::move_all:
                if (o.points.size() != sites_.size()) return Error_code::wrong_size;
                for (std::size_t i = 0; i < sites_.size(); ++i)
                    if (sites_[i]) after.push_back(o.points[i]);
                return verdict(after);
            case Kind::insert: break;
        }
        if (const auto bad = domain_verdict(o.points[0])) return bad;
        for (std::size_t i = 0; i < sites_.size(); ++i)
            if (sites_[i] && static_cast<Index>(i) != o.vertex && *sites_[i] == o.points[0])
                return Error_code::collision;
        return std::nullopt;
    }

    void call(const Operation_of<d>& o) {
        switch (o.kind) {
            case Kind::settle: last_ = dt_->settle(); break;
            case Kind::remove:
                dt_->remove(
                    o.vertex < 0 ? typename Moving::Vertex_handle() : dt_->vertex(static_cast<std::size_t>(o.vertex)),
                    &last_);
                break;
            case Kind::move: last_ = dt_->move(o.vertex, o.points[0]); break;
            case Kind::move_all: last_ = dt_->move_all(o.points); break;
            case Kind::insert: inserted_ = dt_->insert(Space<d>::point(o.points[0]), &last_); break;
        }
    }

    void follow(const Operation_of<d>& o) {
        const auto at = [](Index i) { return static_cast<std::size_t>(i); };
        switch (o.kind) {
            case Kind::settle: break;
            case Kind::remove:
                sites_[at(o.vertex)].reset();
                handles_[at(o.vertex)] = {};
                vacant_.push_back(o.vertex);
                break;
            case Kind::move:
                sites_[at(o.vertex)] = o.points[0];
                if (certified() && last_.moves.asked != 1) throw Fault{"move asked for more or less than one vertex"};
                break;
            case Kind::move_all: {
                std::size_t count = 0;
                for (std::size_t i = 0; i < sites_.size(); ++i) {
                    if (!sites_[i]) continue;
                    sites_[i] = o.points[i];
                    ++count;
                }
                if (certified() && last_.moves.asked != count) throw Fault{"move_all did not ask for every vertex"};
                break;
            }
            case Kind::insert: {
                const Index i = vacant_.empty() ? static_cast<Index>(sites_.size()) : vacant_.back();
                if (!vacant_.empty()) vacant_.pop_back();
                sites_.resize(std::max(sites_.size(), at(i) + 1));
                handles_.resize(sites_.size());
                sites_[at(i)] = o.points[0];
                handles_[at(i)] = inserted_;
                if (dt_->index(inserted_) != i) throw Fault{"an insertion took an unexpected index"};
                break;
            }
        }
    }

    Setting setting_;
    std::optional<Moving> dt_;
    Sites_of<d> sites_;
    std::vector<typename Moving::Vertex_handle> handles_;
    std::vector<Index> vacant_;
    typename Moving::Vertex_handle inserted_;
    Move_report last_;
    bool wrecked_ = false;
};

using Session = Session_of<2>;
using Session_3 = Session_of<3>;

template <int d>
[[nodiscard]] std::string run_program(const Program_of<d>& program, int rational) {
    std::size_t step = 0;
    try {
        Session_of<d> session(program);
        session.check();
        for (const Operation_of<d>& o : program.operations) {
            ++step;
            session.apply(o);
            session.check();
            if (o.kind == Operation_kind::settle && session.certified() && rational-- > 0)
                session.check_settled_tolerances();
        }
    } catch (const typename Session_of<d>::Fault& fault) {
        return "operation " + std::to_string(step) + ": " + fault.words;
    } catch (const std::exception& e) {
        return "operation " + std::to_string(step) + " threw " + e.what();
    }
    return {};
}

/// Runs a program, checking everything after every call, and settled tolerances against rational numbers the first `rational` times,
/// which is slow in space. Empty, or what went wrong and where.
[[nodiscard]] inline std::string run(const Program& program, int rational = 64) {
    return run_program(program, rational);
}
[[nodiscard]] inline std::string run(const Program_3& program, int rational = 0) {
    return run_program(program, rational);
}

}  // namespace annulus::oracle
