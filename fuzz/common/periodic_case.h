// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Bytes to a box, points in it and changes of a Periodic_mesh of them, which is compared after each with what was asked
// for, with a build of the same points and with common/periodic_checks.h. The first byte has the dimension in its
// lowest bit, whether changes are reported in the next one, and a power of two and the strategy in the others; then the
// kind of box, its numbers, the kind of points, their number, the points, and changes until the bytes run out.

#include "bytes.h"
#include "periodic_checks.h"
#include "periodic_inputs.h"

#include <support/cells_of_periodic.h>

#include <annulus/error.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <sstream>

namespace annulus::oracle {

template <int d>
class Periodic_case {
  public:
    explicit Periodic_case(Bytes bytes)
        : options_{.threads = 1,
                   .report_changes = (Bytes(bytes).next() & 2U) != 0,
                   .strategy = strategies[Bytes(bytes).next() / 4 % strategies.size()]},
          inputs_(bytes),
          box_(inputs_.box()) {
        const std::size_t n = inputs_.number();
        for (std::size_t i = 0; i < n; ++i) x_.push_back(inputs_.point(box_, x_));
    }

    /// Empty, or what is wrong.
    [[nodiscard]] std::string fault() {
        std::string found = built();
        for (int k = 0; k < most_changes && !inputs_.empty() && found.empty(); ++k) {
            before_ = mesh_->saved();
            const std::string done = change();
            found = done.starts_with("!") ? done : fault_after(done);
        }
        return found;
    }
    /// The mesh before the last change, and what was asked of it.
    [[nodiscard]] std::string words() const {
        std::ostringstream out;
        out << std::hexfloat << "const Saved_periodic_mesh<" << d << "> before{" << listed(before_.vectors) << ", "
            << listed(before_.places) << ", " << listed(before_.images) << ", " << listed(before_.free_indices)
            << "};\nbox " << listed(asked_.box) << "\npoints " << listed(asked_.points) << "\n";
        return out.str();
    }

  private:
    using Points = std::vector<Coordinates<d>>;
    static constexpr int most_changes = 12;
    static constexpr std::array strategies{Periodic_strategy::tolerances, Periodic_strategy::automatic,
                                           Periodic_strategy::signs};
    struct Asked {
        Points points;
        typename Box<d>::Vectors box{};
    };

    template <class T>
    static std::string listed(const T& t) {
        std::ostringstream out;
        out << std::hexfloat;
        if constexpr (requires { t.begin(); }) {
            out << "{";
            for (const auto& part : t) out << listed(part) << ",";
            out << "}";
        } else out << t;
        return out.str();
    }

    /// Makes the mesh; of points that have one place all but one are left out.
    std::string built() {
        for (;;) try {
                asked_.points = x_;
                asked_.box = box_.vectors();
                mesh_.emplace(x_, box_, options_);
                break;
            } catch (const Error& e) {
                if (!names_one_place(e, x_, box_)) return std::string("! build: ") + e.what();
                x_.erase(x_.begin() + static_cast<std::ptrdiff_t>(e.vertices().back()));
            }
        before_ = mesh_->saved();
        return fault_after("build");
    }
    [[nodiscard]] bool is_taken(const Coordinates<d>& p) const {
        return std::any_of(x_.begin(), x_.end(), [&](const Coordinates<d>& q) {
            return !std::isnan(q[0]) && may_coincide<d>(p, q, box_.vectors());
        });
    }
    [[nodiscard]] std::vector<Index> vertices() const {
        std::vector<Index> all;
        for (std::size_t v = 0; v < x_.size(); ++v)
            if (!std::isnan(x_[v][0])) all.push_back(static_cast<Index>(v));
        return all;
    }
    static Coordinates<d> nowhere() {
        Coordinates<d> p;
        p.fill(std::numeric_limits<double>::quiet_NaN());
        return p;
    }

    // ---- Changes: each makes one and returns its name, or after ! what is wrong ---------------------------------

    std::string change() {
        switch (inputs_.below(17)) {
            case 0: return insert();
            case 1: return insert_several();
            case 2: return remove(1);
            case 3: return remove(inputs_.below(x_.size() / 2 + 2));
            case 4: return move(moved(1), box_, "all moved");
            case 5: return move(moved(5), box_, "some moved");
            case 6: return move(with_other_images(), box_, "other images");
            case 7: return move(drifted(), box_, "drift");
            case 8: return move(onto_sites(), box_, "onto sites");
            case 9: return move_two_together();
            case 10: return refused_for_a_number();
            case 11: return restored();
            case 12: return in_box(inputs_.sheared(box_), true, "sheared");
            case 13: return in_box(inputs_.sheared(box_), false, "sheared, points stay");
            case 14: return in_box(inputs_.squeezed(box_), true, "squeezed");
            case 15: return move_some();
            default: return in_box(inputs_.other_basis(box_), false, "another basis");
        }
    }
    std::string insert() {
        inputs_.choose_kind();
        const Coordinates<d> p = inputs_.point(box_, x_);
        asked_.points = {p};
        try {
            return keep_inserted({mesh_->insert(p)}) ? "insert" : "! insert: index";
        } catch (const Error& e) {
            return e.code() == Error_code::duplicate_point && is_taken(p) ? refused("insert")
                                                                          : std::string("! insert: ") + e.what();
        }
    }
    std::string insert_several() {
        inputs_.choose_kind();
        asked_.points.clear();
        bool taken = false;
        for (std::size_t k = inputs_.below(6); k > 0; --k) {
            const Coordinates<d> p = inputs_.point(box_, x_);
            taken = taken || is_taken(p);
            for (const Coordinates<d>& q : asked_.points) taken = taken || may_coincide<d>(p, q, box_.vectors());
            asked_.points.push_back(p);
        }
        try {
            return keep_inserted(mesh_->insert(asked_.points)) ? "several inserted" : "! several inserted: indices";
        } catch (const Error& e) {
            return e.code() == Error_code::duplicate_point && taken ? refused("several inserted")
                                                                    : std::string("! several inserted: ") + e.what();
        }
    }
    /// The index that was freed last comes first.
    bool keep_inserted(const std::vector<Index>& indices) {
        if (indices.size() != asked_.points.size()) return false;
        for (std::size_t k = 0; k < indices.size(); ++k) {
            if (free_.empty()) {
                free_.push_back(static_cast<Index>(x_.size()));
                x_.push_back(nowhere());
            }
            if (indices[k] != free_.back()) return false;
            x_[static_cast<std::size_t>(free_.back())] = asked_.points[k];
            free_.pop_back();
        }
        return true;
    }
    /// One or some, anywhere or where others are or were; the last point of a vertex counts.
    std::string move_some() {
        const std::vector<Index> all = vertices();
        if (all.empty()) return "nothing to move";
        inputs_.choose_kind();
        const Points old = x_;
        std::vector<Index> which;
        asked_.points.clear();
        for (std::size_t k = 1 + inputs_.below(5); k > 0; --k) {
            which.push_back(all[inputs_.below(all.size())]);
            const auto other = static_cast<std::size_t>(all[inputs_.below(all.size())]);
            asked_.points.push_back(inputs_.below(3) == 0 ? old[other] : inputs_.point(box_, old));
            x_[static_cast<std::size_t>(which.back())] = asked_.points.back();
        }
        try {
            if (which.size() == 1) mesh_->move(which[0], asked_.points[0]);
            else mesh_->move(which, asked_.points);
        } catch (const Error& e) {
            const bool right = names_one_place(e, x_, box_);
            x_ = old;
            return right ? refused("move some") : std::string("! move some: ") + e.what();
        }
        return "move some";
    }
    std::string remove(std::size_t most) {
        std::vector<Index> all = vertices();
        for (std::size_t k = 0; k < std::min(most, all.size()); ++k)
            std::swap(all[k], all[k + inputs_.below(all.size() - k)]);
        all.resize(std::min(most, all.size()));
        if (all.size() == 1) mesh_->remove(all[0]);
        else mesh_->remove(all);
        for (const Index v : all) {
            free_.push_back(v);
            x_[static_cast<std::size_t>(v)] = nowhere();
        }
        return "remove " + std::to_string(all.size());
    }

    /// One point in so many is moved.
    [[nodiscard]] Points moved(std::size_t one_in) {
        Points x = x_;
        const int size = inputs_.size_of_move();
        for (auto& p : x)
            if (one_in == 1 || inputs_.below(one_in) == 0) inputs_.move(p, box_, size);
        return x;
    }
    [[nodiscard]] Points with_other_images() {
        Points x = moved(4);
        for (auto& p : x) inputs_.take_image(p, box_);
        return x;
    }
    [[nodiscard]] Points drifted() {
        Points x = x_;
        Coordinates<d> way{};
        inputs_.move(way, box_, inputs_.size_of_move());
        for (auto& p : x)
            for (std::size_t i = 0; i < d; ++i) p[i] += way[i];
        return x;
    }
    /// To sites of a lattice, each its own, as a crystal that comes to rest.
    [[nodiscard]] Points onto_sites() {
        Points x = x_;
        std::size_t times = 1, sites = 1;
        while (sites < x.size()) {
            ++times;
            sites = d == 2 ? times * times : times * times * times;
        }
        std::size_t first = inputs_.below(sites + 1);
        for (auto& p : x) p = inputs_.site(first++ % std::max<std::size_t>(sites, 1), times, box_);
        return x;
    }
    std::string move(Points x, const Box<d>& box, const std::string& name) {
        for (const Index v : free_) x[static_cast<std::size_t>(v)].fill(inputs_.below(2) == 0 ? 1e300 : -1);
        asked_.points = x;
        asked_.box = box.vectors();
        try {
            const bool same = asked_.box == box_.vectors() && inputs_.below(2) == 0;
            const Move_result r = same ? mesh_->move_all(x) : mesh_->move_all(x, box);
            if (r.moves.asked != vertices().size() ||
                r.moves.within_tolerance + r.moves.kept_in_place + r.moves.flipped + r.moves.rebuilt != r.moves.asked)
                return "! " + name + ": counts";
        } catch (const Error& e) {
            return names_one_place(e, x, box) ? refused(name) : "! " + name + ": " + e.what();
        }
        for (const Index v : free_) x[static_cast<std::size_t>(v)] = nowhere();
        x_ = x;
        box_ = box;
        return name;
    }
    /// `with_points`: they follow the box.
    std::string in_box(const std::optional<Box<d>>& box, bool with_points, const std::string& name) {
        if (!box) return "a box that is refused";
        Points x = with_points ? inputs_.carried(x_, box_, *box) : x_;
        const int size = inputs_.size_of_move();
        for (auto& p : x)
            if (inputs_.below(3) == 0) inputs_.move(p, *box, size);
        return move(std::move(x), *box, name);
    }

    std::string move_two_together() {
        const std::vector<Index> all = vertices();
        Points x = moved(3);
        if (all.size() < 2) return "nothing";
        const auto one = static_cast<std::size_t>(all[inputs_.below(all.size())]);
        const auto other = static_cast<std::size_t>(all[inputs_.below(all.size())]);
        if (one == other) return "nothing";
        x[one] = x[other];
        const std::string done = move(x, box_, "two together");
        return done.ends_with("refused") ? done : "! two together: taken";
    }
    std::string refused_for_a_number() {
        Points x = moved(3);
        if (!free_.empty() || x.empty()) return "nothing";
        x[inputs_.below(x.size())][inputs_.below(d)] =
            inputs_.below(2) == 0 ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
        try {
            mesh_->move_all(x);
        } catch (const Error& e) {
            return e.code() == Error_code::not_finite ? refused("not a number") : std::string("! ") + e.what();
        }
        return "! not a number: taken";
    }
    /// Goes on with the mesh that was saved, whose cells are the same.
    std::string restored() {
        Periodic_mesh<d> again(mesh_->saved(), options_);
        *mesh_ = std::move(again);
        return "restored";
    }
    /// Where a call was refused nothing has changed.
    std::string refused(const std::string& name) {
        const Saved_periodic_mesh<d> now = mesh_->saved();
        bool same = now.vectors == before_.vectors && now.images == before_.images &&
                    now.free_indices == before_.free_indices && now.places.size() == before_.places.size();
        for (std::size_t v = 0; same && v < now.places.size(); ++v)
            same = now.places[v] == before_.places[v] || (std::isnan(now.places[v][0]) && std::isnan(x_[v][0]));
        return same ? name + ", refused" : "! " + name + ": refused, and something changed";
    }

    // ---- Comparisons --------------------------------------------------------------------------------------------

    [[nodiscard]] std::string fault_after(const std::string& done) {
        if (mesh_->index_bound() != x_.size() || mesh_->number_of_vertices() != vertices().size())
            return done + ": number of vertices";
        const Saved_periodic_mesh<d> saved = mesh_->saved();
        if (saved.vectors != box_.vectors()) return done + ": box";
        if (saved.free_indices != free_) return done + ": free indices";
        const Periodic_checks<d> checks(*mesh_);
        for (std::size_t v = 0; v < x_.size(); ++v)
            if (std::isnan(x_[v][0]) ? mesh_->is_vertex(static_cast<Index>(v)) : !checks.is_at(v, x_[v]))
                return done + ": position of " + std::to_string(v);
        if (const std::string found = checks.fault(); !found.empty()) return done + ": " + found;
        if (testing::cells_of(*mesh_) != testing::cells_of(Periodic_mesh<d>(saved)))
            return done + ": the cells are not those of a build";
        if (const std::string found = fault_of_tolerances(); !found.empty()) return done + ": " + found;
        if (!checks.is_found(inputs_.near(box_))) return done + ": find_cell";
        for (std::size_t v = 0; v < x_.size(); ++v)
            if (!std::isnan(x_[v][0]) && !checks.is_corner_found(v)) return done + ": find_cell of a vertex";
        return {};
    }
    /// Points that move by nearly their tolerances, each along an axis, change no cell.
    [[nodiscard]] std::string fault_of_tolerances() const {
        const std::vector<double> tolerance = mesh_->tolerances();
        Points x(mesh_->places().begin(), mesh_->places().end());
        Periodic_mesh<d> pushed(mesh_->saved(), {.strategy = Periodic_strategy::signs});
        pushed.move_all(x);
        const auto before = testing::cells_of(pushed);
        for (std::size_t v = 0; v < x.size(); ++v) {
            if (std::isnan(x[v][0]) != std::isnan(tolerance[v])) return "tolerances at free indices";
            if (!std::isnan(x[v][0])) x[v][v % d] += (v / d % 2 == 0 ? 0.9999 : -0.9999) * tolerance[v];
        }
        const Move_result r = pushed.move_all(x);
        if (r.moves.flipped != 0 || r.moves.rebuilt != 0 || testing::cells_of(pushed) != before)
            return "a cell changes within tolerances";
        return {};
    }

    Periodic_options options_;
    Periodic_inputs<d> inputs_;
    Box<d> box_;
    Points x_;                 // as they were given; NaN at free indices
    std::vector<Index> free_;  // the one to be used next is last
    std::optional<Periodic_mesh<d>> mesh_;
    Saved_periodic_mesh<d> before_;
    Asked asked_;
};

}  // namespace annulus::oracle
