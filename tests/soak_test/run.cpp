// SPDX-License-Identifier: GPL-3.0-or-later
#include <soak_test/run.h>

#include <annulus/moving_delaunay_2.h>
#include <annulus/moving_delaunay_3.h>

#include <limits>
#include <set>

namespace annulus::soak {

namespace {

using testing::Long_motion;
using testing::Motion_kind;
using testing::Random;

template <int d>
struct Space;
template <>
struct Space<2> {
    using Moving = Moving_delaunay_2;
    static Moving::Point point(const Coordinates<2>& p) { return {p[0], p[1]}; }
};
template <>
struct Space<3> {
    using Moving = Moving_delaunay_3;
    static Moving::Point point(const Coordinates<3>& p) { return {p[0], p[1], p[2]}; }
};

struct Fault {
    std::string words;
};

template <int d>
class Runner {
  public:
    using Moving = typename Space<d>::Moving;
    using Handle = typename Moving::Vertex_handle;
    using Places = std::vector<Coordinates<d>>;

    Runner(const Case& c, Random random)
        : case_(c),
          motion_(c.motion, c.points, random),
          calls_(random()),
          looks_(random()),
          options_{.strategy = c.setting.strategy, .seed = random()},
          dt_(motion_.positions(), options_),
          expected_(motion_.positions()),
          live_(c.points, true) {
        for (std::size_t i = 0; i < c.points; ++i) handles_.push_back(dt_.vertex(i));
    }

    Outcome run() {
        try {
            const std::uint64_t every =
                std::max<std::uint64_t>(1, case_.steps / std::max<std::uint64_t>(1, case_.audits));
            look();
            std::uint64_t next = 1;
            while (outcome_.steps < case_.steps) {
                step();
                if (case_.calls && calls_() % 128 == 0) call_in_between();
                if (outcome_.steps < next && outcome_.steps < case_.steps) continue;
                // Not at regular times: a motion may be periodic.
                next = outcome_.steps + 1 + looks_() % (2 * every);
                look();
            }
        } catch (const Fault& fault) {
            outcome_.fault = "step " + std::to_string(outcome_.steps) + ": " + fault.words;
        } catch (const std::exception& e) {
            outcome_.fault = "step " + std::to_string(outcome_.steps) + " threw: " + e.what();
        }
        return outcome_;
    }

  private:
    // ---- Calls --------------------------------------------------------------------------------------------------

    void count(const Move_result& report, std::size_t asked) {
        if (report.moves.asked != asked) throw Fault{"a report asked for " + std::to_string(report.moves.asked)};
        outcome_.asked += asked;
        outcome_.within += report.moves.within_tolerance;
        outcome_.flips += report.statistics.flips;
    }

    /// The position at a free index is ignored.
    [[nodiscard]] Places asked_for() {
        Places x = motion_.positions();
        for (std::size_t i = 0; i < x.size(); ++i)
            if (!live_[i]) x[i].fill(calls_() % 2 == 0 ? std::numeric_limits<double>::quiet_NaN() : 1e300);
        return x;
    }

    [[nodiscard]] bool collides(const Places& x) const {
        std::set<Coordinates<d>> seen;
        for (std::size_t i = 0; i < x.size(); ++i)
            if (live_[i] && !seen.insert(x[i]).second) return true;
        return false;
    }

    void step() {
        motion_.advance();
        ++outcome_.steps;
        const Places x = free_indices_.empty() ? motion_.positions() : asked_for();
        if (singly() && step_singly(x)) return;
        try {
            count(dt_.move_all(x), dt_.number_of_vertices());
        } catch (const Error& e) {
            if (e.code() != Error_code::duplicate_point || !collides(x)) throw;
            ++outcome_.refused;
            return;
        }
        expected_ = x;
    }

    /// Motions of one vertex or few are made by single moves every other time.
    [[nodiscard]] bool singly() const {
        const bool few = case_.motion == Motion_kind::teleports || case_.motion == Motion_kind::few_movers;
        return few && (outcome_.steps / 64) % 2 == 1;
    }
    bool step_singly(const Places& x) {
        for (std::size_t i = 0; i < x.size(); ++i)
            if (live_[i] && x[i] != expected_[i]) move_one(i, x[i]);
        return true;
    }
    void move_one(std::size_t i, const Coordinates<d>& p) {
        try {
            count(dt_.move(static_cast<Index>(i), p), 1);
            expected_[i] = p;
        } catch (const Error& e) {
            Places x = expected_;
            x[i] = p;
            if (e.code() != Error_code::duplicate_point || !collides(x)) throw;
            ++outcome_.refused;
        }
    }

    void call_in_between() {
        const std::size_t i = calls_() % expected_.size();
        switch (calls_() % 8) {
            case 0: count(dt_.recompute_tolerances(), 0); break;
            case 1:
            case 2:
                // Down to far below the initial size, but never to zero.
                if (!live_[i] || dt_.number_of_vertices() < 8) break;
                dt_.remove(handles_[i]);
                live_[i] = false;
                free_indices_.push_back(i);
                break;
            case 3:
            case 4:
            case 5: insert(); break;
            case 6:
                if (live_[i]) move_one(i, motion_.renew(i));
                break;
            default: refused_call(i); break;
        }
    }

    void insert() {
        if (free_indices_.empty()) return;
        const std::size_t i = free_indices_.back();  // the next insertion takes the index freed last
        const Coordinates<d> p = motion_.renew(i);
        try {
            handles_[i] = dt_.insert(Space<d>::point(p));
        } catch (const Error& e) {
            Places x = expected_;
            x[i] = p;
            live_[i] = true;
            const bool rightly = e.code() == Error_code::duplicate_point && collides(x);
            live_[i] = false;
            if (!rightly) throw;
            ++outcome_.refused;
            return;
        }
        free_indices_.pop_back();
        live_[i] = true;
        expected_[i] = p;
        if (dt_.index(handles_[i]) != static_cast<Index>(i)) throw Fault{"an insertion took another index"};
    }

    /// Calls that must be refused and change nothing; the fault is late in the call, so that changes could have
    /// happened.
    void refused_call(std::size_t i) {
        if (!live_[i]) return;
        std::size_t other = 0;
        while (other == i || !live_[other]) ++other;
        Places x = expected_;
        x[i] = x[other];
        refused_move_all(x, Error_code::duplicate_point);
        x[i].fill(std::numeric_limits<double>::quiet_NaN());
        refused_move_all(x, Error_code::not_finite);
    }
    void refused_move_all(const Places& x, Error_code code) {
        try {
            (void)dt_.move_all(x);
        } catch (const Error& e) {
            if (e.code() == code) return;
            throw;
        }
        throw Fault{"a bad call was accepted"};
    }

    // ---- Looks --------------------------------------------------------------------------------------------------

    using Cells = decltype(Audit_input<d>::cells);

    static Cells sorted(Cells cells) {
        for (auto& c : cells) std::sort(c.begin(), c.end());
        std::sort(cells.begin(), cells.end());
        return cells;
    }

    /// Calls const members only.
    void look() {
        ++outcome_.audits;
        const Moving& dt = dt_;
        if (dt.index_bound() != expected_.size()) throw Fault{"index_bound()"};
        std::size_t vertices = 0;
        for (std::size_t i = 0; i < expected_.size(); ++i) {
            if (!live_[i]) continue;
            ++vertices;
            if (dt.vertex(i) != handles_[i]) throw Fault{"a handle changed"};
            if (dt.positions()[i] != expected_[i]) throw Fault{"a position is not the requested one"};
            if (handles_[i]->point() != Space<d>::point(expected_[i])) throw Fault{"CGAL's point is not the position"};
        }
        if (dt.number_of_vertices() != vertices) throw Fault{"number_of_vertices()"};

        const Audit_result audit = dt.audit();
        if (!audit.delaunay()) throw Fault{"audit: " + audit.first_fault};
        if (audit.degenerate_facets > 0) {
            ++outcome_.degenerate;
            return;
        }
        const Audit_input<d> found = dt.audit_input();
        const Moving fresh(found.points, Options{.strategy = Strategy::rebuild});
        if (sorted(found.cells) != sorted(fresh.audit_input().cells))
            throw Fault{"the cells are not those of a rebuild"};
    }

    const Case& case_;
    Long_motion<d> motion_;
    Random calls_;
    Random looks_;
    Options options_;
    Moving dt_;
    Places expected_;
    std::vector<bool> live_;
    std::vector<std::size_t> free_indices_;
    std::vector<Handle> handles_;
    Outcome outcome_;
};

template <int d>
Outcome run_in(const Case& c) {
    // Every combination has its own random numbers; dimension and setting do not change those of the motion.
    return Runner<d>(c, Random(c.seed * 1000003 + static_cast<std::uint64_t>(c.motion))).run();
}

}  // namespace

Outcome run(const Case& c) {
    try {
        if (c.setting.periodic) return run_periodic(c);
        return c.dimension == 2 ? run_in<2>(c) : run_in<3>(c);
    } catch (const std::exception& e) {
        Outcome outcome;
        outcome.fault = std::string("the constructor threw: ") + e.what();
        return outcome;
    }
}

}  // namespace annulus::soak
