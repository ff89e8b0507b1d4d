// SPDX-License-Identifier: GPL-3.0-or-later
// Holding back, flipping, going on: what is the same in every dimension.
#include <annulus/engine/mender.h>

#include <annulus/engine/displacement.h>
#include <annulus/engine/prices.h>
#include <annulus/mesh/make_unique.h>

#include <algorithm>

namespace annulus {

namespace {
constexpr int most_rounds = 64;
constexpr int most_idle_rounds = 3;
}  // namespace

template <int d>
void Mender<d>::begin(std::span<const Coordinates<d>> x) {
    signs_.begin(x);
    price_ = 0.0;
    flips_ = 0;
    built_anew_ = false;
    touched_.clear();
    reinserted_.clear();
    folded_.clear();
    stuck_.clear();
    waiting_.clear();
}

/// Who is held back is at the goal again, and nobody is held back.
template <int d>
void Mender<d>::release() {
    for (const Held& held : held_) {
        course_.x[at(held.vertex)] = held.goal;
        place_of_[at(held.vertex)] = 0;
    }
    held_.clear();
}

template <int d>
void Mender<d>::place(Index v, const Coordinates<d>& p) {
    course_.x[at(v)] = p;
    signs_.look_around(v, true);
}

template <int d>
void Mender<d>::made(std::span<const Cell_index> cells) {
    ++flips_;
    price_ += Prices<d>::flip;
    for (const Cell_index c : cells) {
        touched_.push_back(c);
        signs_.look_at(c, true);
    }
}

/// Puts the vertex of c that is farthest from where it comes from half way, and the next time home. False when all are there.
template <int d>
bool Mender<d>::hold_back(Cell_index c) {
    Index farthest = none;
    double most = 0.0;
    for (const Index v : cell_points(table_, c)) {
        if (v == infinite) continue;
        const Index k = place_of_[at(v)];
        if (k == 0 && !first_round_) continue;  // where it is the others have been flipped for it
        const Coordinates<d>& home = k != 0 ? held_[at(k - 1)].home : course_.home_of(v);
        const double way = squared_distance<d>(course_.x[at(v)], home);  // may underflow
        if (way > most || (farthest == none && course_.x[at(v)] != home)) {
            most = way;
            farthest = v;
        }
    }
    if (farthest == none) return false;
    Index& k = place_of_[at(farthest)];
    if (k == 0) {
        held_.push_back({farthest, course_.home_of(farthest), course_.x[at(farthest)], 1.0, 0});
        k = static_cast<Index>(held_.size());
    }
    Held& held = held_[at(k - 1)];
    held.share *= 0.5;
    if (++held.times > 1) {
        place(farthest, held.home);
        return true;
    }
    Coordinates<d> p = held.home;
    for (std::size_t i = 0; i < p.size(); ++i) p[i] += held.share * (held.goal[i] - held.home[i]);
    place(farthest, p == course_.x[at(farthest)] ? held.home : p);
    return true;
}

/// No cell is inverted afterwards, except those that are at hand in folded_. False when it has become too dear.
template <int d>
bool Mender<d>::unfold_or_hold() {
    auto& inverted = signs_.inverted();
    while (!inverted.empty()) {
        const Cell_index c = inverted.back();
        inverted.pop_back();
        if (!table_.is_cell(c) || !signs_.is_inverted(c)) continue;
        if (!affordable()) return false;
        if (!unfold(c) && !hold_back(c)) folded_.push_back(c);
    }
    return true;
}

/// What no flip mends has to wait for others, and is stuck when there are none left.
template <int d>
bool Mender<d>::flip_violated() {
    auto& violated = signs_.violated();
    violated.insert(violated.end(), stuck_.begin(), stuck_.end());
    stuck_.clear();
    bool flipped = false;
    while (!violated.empty() || (flipped && !waiting_.empty())) {
        if (violated.empty()) {
            make_unique(waiting_);
            std::swap(violated, waiting_);
            flipped = false;
        }
        const Corner_index f = violated.back();
        violated.pop_back();
        if (!table_.is_facet(f) || !signs_.is_violated(f)) continue;
        if (!affordable()) return false;
        if (flip(f)) flipped = true;
        else waiting_.push_back(f);
    }
    std::swap(stuck_, waiting_);
    make_unique(stuck_);
    return true;
}

template <int d>
bool Mender<d>::go_on() {
    bool progress = false;
    std::size_t left = 0;
    first_round_ = false;
    for (Held held : held_) {
        const Coordinates<d>& here = course_.x[at(held.vertex)];
        if (here != held.home) {
            progress = true;
            held.share = 1.0;
        }
        place_of_[at(held.vertex)] = 0;
        if (here == held.goal) continue;
        held.home = here;
        held.times = 0;
        held_[left++] = held;
        place_of_[at(held.vertex)] = static_cast<Index>(left);
    }
    held_.resize(left);
    for (const Held& held : held_) {
        Coordinates<d> p = held.goal;
        if (held.share < 1.0)
            for (std::size_t i = 0; i < p.size(); ++i) p[i] = held.home[i] + held.share * (held.goal[i] - held.home[i]);
        place(held.vertex, p);
    }
    return progress;
}

/// Everybody goes to the goal, and what does not hold there is built anew.
template <int d>
bool Mender<d>::finish_locally() {
    std::vector<Cell_index> seeds;
    for (const Held& held : held_) {
        if (course_.x[at(held.vertex)] != held.goal) place(held.vertex, held.goal);
        reinserted_.push_back(held.vertex);
    }
    release();
    const auto seed = [&](Cell_index c) {
        seeds.push_back(c);
        for (const Index v : cell_points(table_, c))
            if (v != infinite) reinserted_.push_back(v);
    };
    auto& violated = signs_.violated();
    violated.insert(violated.end(), stuck_.begin(), stuck_.end());
    stuck_.clear();
    for (const Cell_index c : folded_)
        if (table_.is_cell(c)) seed(c);
    folded_.clear();
    for (const Cell_index c : signs_.inverted())
        if (table_.is_cell(c) && signs_.is_inverted(c)) seed(c);
    for (const Corner_index f : violated) {
        if (!table_.is_facet(f) || !signs_.is_violated(f)) continue;
        seed(table_.cell_of(f));
        seed(table_.cell_of(table_.twin(f)));
    }
    signs_.inverted().clear();
    violated.clear();
    make_unique(reinserted_);
    make_unique(seeds);
    built_anew_ = true;
    const std::size_t first = touched_.size();
    const double room = std::max(0.0, most_ - price()) / Prices<d>::point;
    const std::size_t most_points = at(table_.vertex_bound()) + 64;  // with more, everything is built anew
    const bool built = local_.rebuild(
        course_.x, seeds, static_cast<std::size_t>(std::min(room, static_cast<double>(most_points))), touched_);
    price_ += Prices<d>::point * static_cast<double>(local_.points());
    if (!built) return false;
    for (std::size_t i = first; i < touched_.size(); ++i)
        if (table_.is_cell(touched_[i])) signs_.look_at(touched_[i], true);
    return nothing_inverted() && flip_violated() && stuck_.empty() && nothing_inverted();
}

/// And then the list is empty.
template <int d>
bool Mender<d>::nothing_inverted() {
    std::erase_if(signs_.inverted(), [this](Cell_index c) { return !table_.is_cell(c) || !signs_.is_inverted(c); });
    return signs_.inverted().empty();
}

template <int d>
bool Mender<d>::mend(const Course<d>& course, double most) {
    course_ = course;
    signs_.rebind(course.x);
    most_ = most;
    first_round_ = true;
    place_of_.resize(at(table_.vertex_bound()), 0);
    struct Back {
        Mender& mender;
        ~Back() {
            mender.release();
            make_unique(mender.touched_);
        }
    } back{*this};
    int idle = 0;
    for (int round = 0; round < most_rounds && idle < most_idle_rounds; ++round) {
        signs_.inverted().insert(signs_.inverted().end(), folded_.begin(), folded_.end());
        folded_.clear();
        if (!unfold_or_hold() || !flip_violated()) return false;
        if (held_.empty() && folded_.empty() && nothing_inverted()) break;
        idle = go_on() ? 0 : idle + 1;
    }
    const bool done = held_.empty() && folded_.empty() && stuck_.empty() && signs_.inverted().empty() && signs_.violated().empty();
    return done || finish_locally();
}

template class Mender<2>;
template class Mender<3>;

}  // namespace annulus
