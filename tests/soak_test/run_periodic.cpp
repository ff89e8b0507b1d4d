// SPDX-License-Identifier: GPL-3.0-or-later
// The motions in a periodic box that moves, too.
#include <soak_test/box_motion.h>
#include <soak_test/run.h>

#include <common/periodic_checks.h>
#include <support/cells_of_periodic.h>

#include <annulus/error.h>
#include <annulus/periodic_mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace annulus::soak {

namespace {

using testing::Long_motion;
using testing::Motion_kind;
using testing::Random;

struct Fault {
    std::string words;
};

/// The coordinates of a motion are coordinates in the vectors of the box, which is as large as they are.
template <int d>
class Periodic_runner {
  public:
    using Places = std::vector<Coordinates<d>>;

    Periodic_runner(const Case& c, Random random)
        : case_(c),
          motion_(c.motion, c.points, random),
          box_motion_(random),
          calls_(random()),
          looks_(random()),
          pushes_(c.seed),
          live_(c.points, true),
          expected_(asked_for()),
          mesh_(expected_, box_motion_.box(scale()),
                {.threads = 1, .report_changes = random() % 2 == 0, .strategy = c.setting.in_box}) {}

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
    /// The power of two above the largest coordinate, 1 for most motions: of points of a lattice no two are images.
    [[nodiscard]] double scale() {
        if (case_.motion != Motion_kind::growth && scale_ > 0) return scale_;
        double most = 0;
        for (const auto& p : motion_.positions())
            for (const double c : p) most = std::max(most, std::fabs(c));
        return scale_ = std::exp2(std::floor(std::log2(most)) + 1);
    }
    /// The position at a free index is ignored.
    [[nodiscard]] Places asked_for() {
        Places x = motion_.positions();
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] = box_motion_.at(x[i]);
            if (!live_[i]) x[i].fill(calls_() % 2 == 0 ? std::numeric_limits<double>::quiet_NaN() : 1e300);
        }
        return x;
    }
    void step() {
        motion_.advance();
        box_motion_.advance();
        ++outcome_.steps;
        const Places x = asked_for();
        const Box<d> box = box_motion_.box(scale());
        try {
            count(mesh_.move_all(x, box));
        } catch (const Error& e) {
            if (!oracle::names_one_place(e, x, box)) throw;
            ++outcome_.refused;
            return;
        }
        expected_ = x;
    }
    void count(const Move_result& report) {
        if (report.moves.asked != mesh_.number_of_vertices())
            throw Fault{"a report asked for " + std::to_string(report.moves.asked)};
        if (report.moves.within_tolerance + report.moves.kept_in_place + report.moves.flipped + report.moves.rebuilt !=
            report.moves.asked)
            throw Fault{"a report that does not add up"};
        outcome_.asked += report.moves.asked;
        outcome_.within += report.moves.within_tolerance + report.moves.kept_in_place;
        outcome_.flips += report.statistics.flips;
    }

    void call_in_between() {
        const std::size_t i = calls_() % expected_.size();
        switch (calls_() % 6) {
            case 0: mesh_ = Periodic_mesh<d>(mesh_.saved(), mesh_.options()); break;
            case 1:
            case 2:  // down to none, at times
                if (!live_[i]) break;
                mesh_.remove(static_cast<Index>(i));
                live_[i] = false;
                free_indices_.push_back(i);
                break;
            case 3:
            case 4: insert(); break;
            default: refused_call(i); break;
        }
    }
    void insert() {
        if (free_indices_.empty()) return;
        const std::size_t i = free_indices_.back();  // the next insertion takes the index freed last
        const Coordinates<d> p = box_motion_.at(motion_.renew(i));
        try {
            if (mesh_.insert(p) != static_cast<Index>(i)) throw Fault{"an insertion took another index"};
        } catch (const Error& e) {
            const auto is_there = [&](std::size_t v) {
                return live_[v] && oracle::may_coincide<d>(expected_[v], p, mesh_.saved().vectors);
            };
            bool rightly = false;
            for (std::size_t v = 0; v < expected_.size(); ++v) rightly = rightly || is_there(v);
            if (e.code() != Error_code::duplicate_point || !rightly) throw;
            ++outcome_.refused;
            return;
        }
        free_indices_.pop_back();
        live_[i] = true;
        expected_[i] = p;
    }
    /// Calls that must be refused and change nothing.
    void refused_call(std::size_t i) {
        if (!live_[i] || mesh_.number_of_vertices() < 2) return;
        std::size_t other = 0;
        while (other == i || !live_[other]) ++other;
        Places x = expected_;
        x[i] = x[other];
        refused_move_all(x, Error_code::duplicate_point);
        x[i].fill(std::numeric_limits<double>::quiet_NaN());
        refused_move_all(x, Error_code::not_finite);
    }
    void refused_move_all(const Places& x, Error_code code) {
        const auto before = testing::cells_of(mesh_);
        try {
            (void)mesh_.move_all(x);
        } catch (const Error& e) {
            if (e.code() != code) throw;
            if (testing::cells_of(mesh_) != before) throw Fault{"a refused call changed cells"};
            return;
        }
        throw Fault{"a bad call was accepted"};
    }

    void look() {
        ++outcome_.audits;
        if (mesh_.index_bound() != expected_.size()) throw Fault{"index_bound()"};
        const oracle::Periodic_checks<d> checks(mesh_);
        for (std::size_t i = 0; i < expected_.size(); ++i)
            if (live_[i] ? !checks.is_at(i, expected_[i]) : mesh_.is_vertex(static_cast<Index>(i)))
                throw Fault{"a position is not the requested one"};
        if (const std::string found = checks.fault(); !found.empty()) throw Fault{found};
        if (mesh_.audit().degenerate_facets > 0) ++outcome_.degenerate;
        if (testing::cells_of(mesh_) != testing::cells_of(Periodic_mesh<d>(mesh_.saved())))
            throw Fault{"the cells are not those of a rebuild"};
        push();
    }
    /// A mesh of the same points that moves by nearly its tolerances, each in some direction.
    void push() {
        const std::vector<double> tolerance = mesh_.tolerances();
        Periodic_mesh<d> pushed(mesh_.saved(), {.strategy = Periodic_strategy::signs});
        Places x(mesh_.places().begin(), mesh_.places().end());
        (void)pushed.move_all(x);
        const auto before = testing::cells_of(pushed);
        for (std::size_t v = 0; v < x.size(); ++v) {
            Coordinates<d> way;
            double squares = 0;
            for (double& c : way) {
                c = testing::between(pushes_, -1, 1);
                squares += c * c;
            }
            for (std::size_t i = 0; i < d; ++i) x[v][i] += 0.9999 * tolerance[v] * way[i] / std::sqrt(squares);
        }
        const Move_result r = pushed.move_all(x);
        if (r.moves.flipped > 0 || r.moves.rebuilt > 0 || testing::cells_of(pushed) != before)
            throw Fault{"a cell changes within tolerances"};
    }

    const Case& case_;
    Long_motion<d> motion_;
    Box_motion<d> box_motion_;
    Random calls_;
    Random looks_;
    Random pushes_;
    double scale_ = 0;
    std::vector<bool> live_;
    Places expected_;
    std::vector<std::size_t> free_indices_;
    Periodic_mesh<d> mesh_;
    Outcome outcome_;
};

template <int d>
Outcome run_in(const Case& c) {
    return Periodic_runner<d>(c, Random(c.seed * 1000003 + static_cast<std::uint64_t>(c.motion))).run();
}

}  // namespace

Outcome run_periodic(const Case& c) { return c.dimension == 2 ? run_in<2>(c) : run_in<3>(c); }

}  // namespace annulus::soak
