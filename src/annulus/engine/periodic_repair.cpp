// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/periodic_repair.h>

#include <annulus/engine/cost_model.h>
#include <annulus/kernel/periodic_proof.h>
#include <annulus/mesh/sort_unique.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr int most_box_rounds = 64;
constexpr int most_idle_box_rounds = 24;  // in each a vertex tries half as much of its way; a build costs more

}  // namespace

/// The table is in work_ meanwhile. In the end it is as it was, unless it is kept.
template <int d>
class Periodic_repair<d>::Change {
  public:
    Change(Periodic_repair& repair, Periodic_table<d>& table) : repair_(repair), table_(table) {
        repair_.made_.journal.begin(table);
        std::swap(table_, repair_.work_);
    }
    ~Change() {
        if (!kept_) undo();
        std::swap(table_, repair_.work_);
    }
    Change(const Change&) = delete;
    Change& operator=(const Change&) = delete;
    Change(Change&&) = delete;
    Change& operator=(Change&&) = delete;

    /// For changes that may be of all cells.
    void keep_everything() { before_ = repair_.work_; }
    [[nodiscard]] bool may_be_of_everything() const { return before_.has_value(); }
    /// The table gets the flags of the signs.
    void take_cospherical() {
        std::swap(repair_.work_.cospherical, repair_.signs_.cospherical());
        took_cospherical_ = true;
    }
    void keep() { kept_ = true; }

  private:
    void undo() noexcept {
        repair_.star_.forget();
        if (took_cospherical_) std::swap(repair_.work_.cospherical, repair_.signs_.cospherical());
        if (before_) std::swap(repair_.work_, *before_);
        else repair_.made_.journal.undo(repair_.work_);
    }

    Periodic_repair& repair_;
    Periodic_table<d>& table_;
    std::optional<Periodic_table<d>> before_;
    bool took_cospherical_ = false, kept_ = false;
};

template <int d>
Periodic_repair_result Periodic_repair<d>::repair(Periodic_table<d>& table, const Periodic_points<d>& from,
                                                  const Periodic_points<d>& to, Budget& budget,
                                                  const Tolerances& tolerances) {
    Periodic_repair_result result;
    if (!motion_.begin(from, to)) return result;
    result.done = !motion_.moves();
    if (result.done) return result;
    result.by_tolerances = tolerances.of.begin_step(motion_, to.lattice, tolerances.most_failed);
    budget_ = &budget;
    made_.flips = 0;
    made_.unused.clear();
    Change change(*this, table);
    if (motion_.relabels_home()) {
        change.keep_everything();
        if (!motion_.relabel_home(work_)) return result;
    }
    signs_.begin(work_, to.lattice, motion_.goal(), budget);
    bool same_spheres = false;
    if (result.by_tolerances) same_spheres = test_expired(tolerances.of, to.lattice, result.evaluated);
    else if (!signs_.test_all_cells()) return result;
    const bool calm = signs_.inverted().empty() && signs_.violated().empty();
    if (!calm || change.may_be_of_everything() || !motion_.wrapped().empty()) {
        note_doubted();
        if (!calm && signs_.expected_cost() > budget.left()) return result;
        if (!calm && !flip_until_done(to.lattice)) return result;
        close_gaps();
        if (!relabel_goal()) return result;
        if (same_spheres) signs_.cospherical() = work_.cospherical;
        signs_.cospherical().resize(work_.size());
        change.take_cospherical();
        const bool proved = change.may_be_of_everything()
                                ? is_proved_delaunay<d>(work_, to.lattice, to.place)
                                : is_still_proved_delaunay<d>(work_, to.lattice, to.place,
                                                              {made_.journal, motion_.goal(), left_.doubted});
        if (!proved) return result;
    } else if (!same_spheres) change.take_cospherical();
    result.flips = made_.flips;
    count_outcomes(result, tolerances.of, calm);
    if (result.by_tolerances) keep_tolerances(tolerances.of, to, calm, result.evaluated);
    change.keep();
    result.done = true;
    return result;
}

/// Tests the certificates that have expired. Whether the same facets are cospherical as before; if not, signs_ has
/// them.
template <int d>
bool Periodic_repair<d>::test_expired(Periodic_tolerances<d>& tolerances, const Lattice<d>& lattice,
                                      Stage_counts& counts) {
    using Table = Periodic_table<d>;
    star_.begin(motion_.home().size());
    counts += tolerances.find_expired({work_, lattice, motion_.goal()}, star_);
    budget_->charge(Cost_model<d>::failure * static_cast<double>(tolerances.failed().size()) +
                    Cost_model<d>::evaluation * static_cast<double>(tolerances.evaluated().size()));
    bool same = true;
    for (const auto& e : tolerances.evaluated()) {
        const std::size_t c = is_of_cell(e.id) ? cell_of(e.id).offset() : Table::cell_of(facet_of(e.id));
        if (!e.holds) signs_.test_cell(c);
        if (is_of_cell(e.id)) continue;
        const Corner_index f = facet_of(e.id), t = work_.twin[c][Table::slot_of(f)];
        const std::uint8_t now = e.cospherical ? 1 : 0;
        if (work_.cospherical[c][Table::slot_of(f)] == now) continue;
        if (same) signs_.cospherical() = work_.cospherical;
        same = false;
        signs_.cospherical()[c][Table::slot_of(f)] = signs_.cospherical()[Table::cell_of(t)][Table::slot_of(t)] = now;
    }
    return same;
}

/// The table is right at its new places. Without flips what was evaluated at the goals is so there, too.
template <int d>
void Periodic_repair<d>::keep_tolerances(Periodic_tolerances<d>& tolerances, const Periodic_points<d>& to, bool calm,
                                         Stage_counts& counts) {
    if (calm) {
        tolerances.commit({work_, to.lattice, motion_.goal()});
        tolerances.relabel(motion_);
        return;
    }
    tolerances.relabel(motion_);
    std::vector<std::size_t> changed;
    for (const Kept_cell<d>& k : made_.journal.kept())
        if (k.cell < work_.size()) changed.push_back(k.cell);
    for (std::size_t c = made_.journal.size(); c < work_.size(); ++c) changed.push_back(c);
    counts += tolerances.evaluate_again({work_, to.lattice, to.place}, changed);
    budget_->charge(Cost_model<d>::evaluation * static_cast<double>(tolerances.evaluated().size()));
    tolerances.commit({work_, to.lattice, to.place});
}

template <int d>
void Periodic_repair<d>::count_outcomes(Periodic_repair_result& result, const Periodic_tolerances<d>& tolerances,
                                        bool calm) const {
    if (!calm) result.flipped = static_cast<std::size_t>(std::count(made_.flipped.begin(), made_.flipped.end(), 1));
    if (!result.by_tolerances) return;
    for (const Index v : tolerances.failed())
        if (calm || made_.flipped[static_cast<std::size_t>(v)] == 0) ++result.failed;
}

/// Cells of which a certificate does not hold at the goals.
template <int d>
void Periodic_repair<d>::note_doubted() {
    left_.doubted = signs_.inverted();
    for (const Corner_index h : signs_.violated()) left_.doubted.push_back(Periodic_table<d>::cell_of(h));
    sort_unique(left_.doubted);
}

/// Cells with the largest numbers take those of no cell.
template <int d>
void Periodic_repair<d>::close_gaps() {
    for (std::size_t k = 1; k <= made_.unused.size(); ++k)
        if (const std::size_t c = work_.size() - k; is_cell(c)) made_.journal.keep_around(work_, c);
    annulus::close_gaps<d>(work_, made_.unused);
}

/// Offsets at the goals become such for the new places, in the stars of vertices that have left the box.
template <int d>
bool Periodic_repair<d>::relabel_goal() {
    std::vector<std::size_t> cells;
    star_.begin(motion_.home().size());
    for (const Index v : motion_.wrapped())
        for (const Corner_index h : star_.of(work_, v)) cells.push_back(work_.cell_of(h));
    sort_unique(cells);
    for (const std::size_t c : cells) made_.journal.keep(work_, c);
    return motion_.relabel_goal(work_, cells);
}

template <int d>
void Periodic_repair<d>::moved(Index v) {
    for (const Corner_index h : star_.of(work_, v)) signs_.test_cell(work_.cell_of(h));
}

template <int d>
bool Periodic_repair<d>::replace(std::span<const Lifted_cell<d>> gone, std::span<const Cell_images<d>> came) {
    for (const Lifted_cell<d>& g : gone) made_.journal.keep_around(work_, g.cell);
    if (!replace_periodic_cells<d>(work_, gone, came, made_.unused, made_.latest)) return false;
    ++made_.flips;
    budget_->charge(Cost_model<d>::flip);
    for (const std::size_t c : made_.latest) {
        star_.add(work_, c);
        for (const Index v : work_.vertex[c]) made_.flipped[static_cast<std::size_t>(v)] = 1;
        signs_.test_cell(c);
    }
    return true;
}

/// Afterwards no cell is inverted except those in `inverted_at_source`. False when it has become too expensive.
template <int d>
bool Periodic_repair<d>::hold_back_inverted() {
    auto& inverted = signs_.inverted();
    while (!inverted.empty()) {
        const std::size_t c = inverted.back();
        inverted.pop_back();
        if (!is_cell(c) || !signs_.is_inverted(c)) continue;
        if (!budget_->within_limit()) return false;
        Cell_sites<d> vertices;
        for (std::size_t i = 0; i <= d; ++i) vertices[i] = Site<d>(work_.vertex[c][i]);
        const Index v = held_.hold_back(vertices);
        if (v != none) moved(v);
        else left_.inverted_at_source.push_back(c);
    }
    return true;
}

/// A facet that no flip repairs waits for other flips; it is stuck when there are none left.
template <int d>
bool Periodic_repair<d>::flip_violated() {
    auto& violated = signs_.violated();
    auto &stuck = left_.stuck, &waiting = left_.waiting;
    violated.insert(violated.end(), stuck.begin(), stuck.end());
    stuck.clear();
    bool flipped = false;
    while (!violated.empty() || (flipped && !waiting.empty())) {
        if (violated.empty()) {
            sort_unique(waiting);
            std::swap(violated, waiting);
            flipped = false;
        }
        const Corner_index h = violated.back();
        violated.pop_back();
        if (!is_cell(work_.cell_of(h)) || !signs_.is_violated(h)) continue;
        if (!budget_->within_limit()) return false;
        if (flip(h)) flipped = true;
        else waiting.push_back(h);
    }
    std::swap(stuck, waiting);
    sort_unique(stuck);
    return true;
}

/// Whether no cell is inverted; then the list is empty.
template <int d>
bool Periodic_repair<d>::nothing_inverted() {
    std::erase_if(signs_.inverted(), [this](std::size_t c) { return !is_cell(c) || !signs_.is_inverted(c); });
    return signs_.inverted().empty();
}

template <int d>
bool Periodic_repair<d>::flip_until_done(const Lattice<d>& lattice) {
    left_.inverted_at_source.clear();
    left_.stuck.clear();
    left_.waiting.clear();
    made_.flipped.assign(motion_.home().size(), 0);
    star_.begin(motion_.home().size());
    held_.begin({.x = motion_.goal(), .source = motion_.home(), .mover = none, .grid = lattice.grid()},
                motion_.home().size());
    struct Back {
        Held_back<d>& held;
        ~Back() {
            held.release([](Index) {});
        }
    } back{held_};
    int idle = 0;
    for (int round = 0; round < most_box_rounds && idle < most_idle_box_rounds; ++round) {
        auto& inverted = signs_.inverted();
        inverted.insert(inverted.end(), left_.inverted_at_source.begin(), left_.inverted_at_source.end());
        left_.inverted_at_source.clear();
        if (!hold_back_inverted() || !flip_violated()) return false;
        if (held_.empty() && left_.inverted_at_source.empty() && nothing_inverted()) break;
        idle = held_.advance([this](Index v) { moved(v); }) ? 0 : idle + 1;
    }
    return held_.empty() && left_.inverted_at_source.empty() && left_.stuck.empty() && signs_.inverted().empty() &&
           signs_.violated().empty();
}

template class Periodic_repair<2>;
template class Periodic_repair<3>;

}  // namespace annulus::inline v1
