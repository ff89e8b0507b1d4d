// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.h"

#include <cmath>
#include <set>

namespace annulus::oracle {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

template <class Moving>
State_of<Moving::dimension_of_space> state_of(const Moving& dt) {
    constexpr int d = Moving::dimension_of_space;
    State_of<d> s;
    for (std::size_t i = 0; i < dt.index_bound(); ++i) {
        const auto v = dt.vertex(i);
        s.handles.push_back(v);
        if (v == typename Moving::Vertex_handle()) continue;
        s.positions.push_back(Space<d>::coordinates(dt.position(v)));
        s.fixed.push_back(Space<d>::coordinates(dt.fixed_position(v)));
        s.cgal_points.push_back(Space<d>::coordinates(v->point()));
        if (keeps_tolerances(dt)) s.tolerances.push_back(dt.tolerance(v));
    }
    s.cells = cells_of(dt.triangulation());
    s.vertices = dt.number_of_vertices();
    return s;
}

/// Empty, or what a failed call has changed. If it `renews` tolerances, they and the fixed positions may differ, but
/// must be valid.
template <int d>
std::string difference(const State_of<d>& before, const State_of<d>& after, bool renews) {
    std::string s;
    if (before.positions != after.positions) s += " positions";
    if (!renews && before.fixed != after.fixed) s += " fixed-positions";
    if (before.cgal_points != after.cgal_points) s += " CGAL-points";
    // There may be fewer before than after: paper-hybrid may have switched to paper.
    const bool kept = before.tolerances.size() == after.tolerances.size();
    if (!renews && kept && before.tolerances != after.tolerances) s += " tolerances";
    if (before.handles != after.handles) s += " handles";
    if (before.cells != after.cells) s += " cells";
    if (before.vertices != after.vertices) s += " number-of-vertices";
    return s;
}

/// Empty, or how a report contradicts itself.
std::string report_fault(const Move_result& r) {
    const Move_counts& m = r.moves;
    if (m.asked != m.within_tolerance + m.kept_in_place + m.flipped + m.reinserted + m.rebuilt)
        return "the counts of a report do not add up to asked";
    if (r.statistics.evaluated != r.statistics.arithmetic.total()) return "evaluated is not the sum of the stages";
    return {};
}

template <int d>
std::optional<Error_code> verdict(const std::vector<Coordinates<d>>& points) {
    for (const auto& p : points)
        if (const auto bad = domain_verdict<d>(p)) return bad;
    const std::set<Coordinates<d>> distinct(points.begin(), points.end());
    return distinct.size() == points.size() ? std::nullopt : std::optional(Error_code::duplicate_point);
}

/// A call that must be refused although it is legal: the limits, which are tiny for tests, are reached.
bool is_out_of_room(Error_code code) {
    if constexpr (Limits::tiny) return code == Error_code::too_large;
    return false;
}

}  // namespace

template <int d>
Session_of<d>::Session_of(const Program_of<d>& program) : setting_(program.setting) {
    Options options;
    options.strategy = setting_.strategy;
    options.tolerance = setting_.tolerance;
    const std::optional<Error_code> refusal = verdict<d>(program.points);
    try {
        dt_.emplace(program.points, options);
        if (refusal) throw Fault{"the constructor accepted bad points"};
    } catch (const Error& e) {
        if (is_out_of_room(e.code()) ? refusal.has_value() : refusal != e.code())
            throw Fault{std::string("the constructor threw: ") + e.what()};
        dt_.emplace(options);
        twin_.emplace(program.points, options, e.code());
        return;
    }
    twin_.emplace(program.points, options, std::nullopt);
    for (const auto& p : program.points) sites_.emplace_back(p);
    for (std::size_t i = 0; i < sites_.size(); ++i) handles_.push_back(dt_->vertex(i));
}

template <int d>
void Session_of<d>::apply(const Operation_of<d>& o) {
    if (o.kind == Kind::steady) {
        ++coverage_.operations;
        ++coverage_.legal_operations;
        go_on(o);
        return;
    }
    const Operation_of<d> call = resolved(o);
    if (o.kind != Kind::recompute_tolerances) {
        ++coverage_.operations;
        if (!expected_refusal(call)) ++coverage_.legal_operations;
    }
    make(call);
}

/// A steady motion: checked after its first steps, then less and less often.
template <int d>
void Session_of<d>::go_on(const Operation_of<d>& o) {
    const Sites_of<d> home = sites_;
    const std::function<Leeway<d>(std::size_t)> leeway = [this](std::size_t v) {
        const auto h = dt_->vertex(v);
        return Leeway<d>{Space<d>::coordinates(dt_->fixed_position(h)), dt_->tolerance(h)};
    };
    int due = 1;
    for (int k = 0; k < o.times; ++k) {
        make(Calls<d>::move_all(next_positions<d>(o, k, home, sites_, leeway)));
        if (k + 1 < due) continue;
        due = 2 * due + 1;
        if (k + 1 < o.times) check();
    }
}

template <int d>
void Session_of<d>::make(const Operation_of<d>& o) {
    const std::optional<Error_code> refusal = expected_refusal(o);
    const State_of<d> before = refusal || Limits::tiny ? state_of(*dt_) : State_of<d>{};
    last_ = {};
    refused_ = true;
    ++coverage_.calls;
    const Strategy strategy = dt_->strategy();
    try {
        call(o);
    } catch (const Error& e) {
        ++coverage_.refused[static_cast<std::size_t>(e.code()) % coverage_.refused.size()];
        if (!certified() && (e.code() == Error_code::duplicate_point || is_out_of_room(e.code()))) {
            wrecked_ = true;  // the model cannot tell when a wrong triangulation notices a duplicate point
            (void)twin_->apply(o, e.code());
            return;
        }
        if (!is_out_of_room(e.code())) {
            if (!refusal) throw Fault{std::string("a legal call threw: ") + e.what()};
            if (*refusal != e.code()) throw Fault{std::string("a bad call threw the wrong code: ") + e.what()};
        }
        const std::string changed = difference(before, state_of(*dt_), renews_tolerances(o.kind, e.code()));
        if (!changed.empty()) throw Fault{"a failed call changed:" + changed};
        if (const std::string words = twin_->apply(o, e.code()); !words.empty()) throw Fault{words};
        if (const std::string words = twin_->fault(sites_, before.cells); !words.empty())
            throw Fault{words + ", after a refused call"};
        return;
    }
    refused_ = false;
    if (refusal && certified()) throw Fault{"a bad call was accepted"};
    if (refusal) wrecked_ = true;
    follow(o);
    if (const std::string words = report_fault(last_); !words.empty()) throw Fault{words};
    if (const std::string words = twin_->apply(o, std::nullopt); !words.empty()) throw Fault{words};
    coverage_.report += last_;
    coverage_.switches += strategy != dt_->strategy() ? 1U : 0U;
}

// ---- The model ----------------------------------------------------------------------------------------------------

/// Whether a failed call may leave other tolerances. A move whose target is occupied may have flipped cells already:
/// the cells are rebuilt and evaluated (Tolerance_strategy::renew_renumbered). A time step of single moves may have
/// been made in part: everything is evaluated at the old positions.
template <int d>
bool Session_of<d>::renews_tolerances(Kind kind, Error_code code) const {
    if (is_out_of_room(code)) return true;
    if (code != Error_code::duplicate_point) return false;
    return kind == Kind::move || kind == Kind::move_all;
}

template <int d>
std::optional<Error_code> Session_of<d>::expected_refusal(const Operation_of<d>& o) const {
    std::vector<Coordinates<d>> after;
    switch (o.kind) {
        case Kind::recompute_tolerances:
        case Kind::stay:
        case Kind::steady:
        case Kind::refused: return std::nullopt;
        case Kind::remove: return live(o.vertex) ? std::nullopt : std::optional(Error_code::unknown_vertex);
        case Kind::move:
            if (!live(o.vertex)) return Error_code::unknown_vertex;
            break;
        case Kind::move_all:
            if (o.points.size() != sites_.size()) return Error_code::wrong_size;
            for (std::size_t i = 0; i < sites_.size(); ++i)
                if (sites_[i]) after.push_back(o.points[i]);
            return verdict<d>(after);
        case Kind::insert: break;
    }
    if (const auto bad = domain_verdict<d>(o.points[0])) return bad;
    for (std::size_t i = 0; i < sites_.size(); ++i)
        if (sites_[i] && static_cast<Index>(i) != o.vertex && *sites_[i] == o.points[0])
            return Error_code::duplicate_point;
    return std::nullopt;
}

template <int d>
void Session_of<d>::call(const Operation_of<d>& o) {
    switch (o.kind) {
        case Kind::steady:
        case Kind::refused:
        case Kind::recompute_tolerances: last_ = dt_->recompute_tolerances(); break;
        case Kind::remove:
            dt_->remove(o.vertex < 0 ? typename Moving::Vertex_handle() : dt_->vertex(at(o.vertex)), &last_);
            break;
        case Kind::move: last_ = dt_->move(o.vertex, o.points[0]); break;
        case Kind::move_all: last_ = dt_->move_all(o.points); break;
        case Kind::stay: last_ = dt_->move_all(dt_->positions()); break;
        case Kind::insert: inserted_ = dt_->insert(Space<d>::point(o.points[0]), &last_); break;
    }
}

template <int d>
void Session_of<d>::follow(const Operation_of<d>& o) {
    switch (o.kind) {
        case Kind::steady:
        case Kind::refused:
        case Kind::recompute_tolerances: break;
        case Kind::remove:
            sites_[at(o.vertex)].reset();
            handles_[at(o.vertex)] = {};
            free_indices_.push_back(o.vertex);
            break;
        case Kind::move:
            sites_[at(o.vertex)] = o.points[0];
            if (last_.moves.asked != 1) throw Fault{"move asked for more or less than one vertex"};
            break;
        case Kind::stay:
        case Kind::move_all: {
            std::size_t count = 0;
            for (std::size_t i = 0; i < sites_.size(); ++i) {
                if (!sites_[i]) continue;
                if (o.kind == Kind::move_all) sites_[i] = o.points[i];
                ++count;
            }
            if (last_.moves.asked != count) throw Fault{"move_all did not ask for every vertex"};
            break;
        }
        case Kind::insert: {
            const Index i = free_indices_.empty() ? static_cast<Index>(sites_.size()) : free_indices_.back();
            if (!free_indices_.empty()) free_indices_.pop_back();
            sites_.resize(std::max(sites_.size(), at(i) + 1));
            handles_.resize(sites_.size());
            sites_[at(i)] = o.points[0];
            handles_[at(i)] = inserted_;
            if (dt_->index(inserted_) != i) throw Fault{"an insertion took an unexpected index"};
            break;
        }
    }
}

template class Session_of<2>;
template class Session_of<3>;

}  // namespace annulus::oracle
