// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What `tolerances` decided, as a sequence of words below 2^63 that proofs/traces/replay.v reads:
// src/annulus/engine/trace.h says where this comes in. An event is its number (trace_events.h) and what the comment
// beside it says; a position is d numbers, a list of things is how many there are and these. A number is its
// bits, after `minus` when it is negative.
#include "trace_events.h"

#include <annulus/engine/displacement_budget.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace annulus::inline v1 {

struct Trace : Trace_events {
    static inline bool on = false;
    static inline std::vector<std::uint64_t> words;

    // What has been recorded.
    template <int d>
    struct Recorded {
        std::vector<Coordinates<d>> position;
        std::vector<char> lives;
        std::map<Certificate_id, std::vector<Index>> points;  // of certificates
    };
    template <int d>
    static inline Recorded<d> recorded;
    static inline std::vector<std::uint64_t> pending, around;  // of one vertex
    static inline bool has_walked = false, has_rebased = false;

    static void word(std::uint64_t w) { words.push_back(w); }
    static void vertex(Index v) { word(static_cast<std::uint64_t>(v)); }
    static void number(double x) {
        if (std::signbit(x)) word(minus);
        word(std::bit_cast<std::uint64_t>(std::fabs(x)));
    }
    template <std::size_t d>
    static void numbers(const std::array<double, d>& p) {
        for (const double c : p) number(c);
    }
    static void list(const std::vector<std::uint64_t>& ws) {
        word(ws.size());
        words.insert(words.end(), ws.begin(), ws.end());
    }
    template <class List>
    static void expiries(const List& l) {
        std::vector<std::uint64_t> entries;
        for (const std::uint64_t e : l.entry_)
            if (e != List::empty_entry) entries.push_back(e);
        word(l.rest_.bits());
        list(entries);
    }
    static std::size_t at(Index v) { return static_cast<std::size_t>(v); }

    /// Another engine: nothing has been recorded of it.
    template <int d>
    static void start() {
        recorded<d> = {};
        word(history);
        word(d);
    }

    template <int d>
    static void tell_positions(const Displacement_budget<d>& o, std::span<const Coordinates<d>> x) {
        Recorded<d>& t = recorded<d>;
        std::vector<Index> changed, left;
        t.position.resize(std::max(t.position.size(), x.size()));
        t.lives.resize(t.position.size());
        const Index bound = o.table_.vertex_bound();
        for (Index v = 0; at(v) < t.position.size(); ++v) {
            const bool lives = v < bound && at(v) < x.size() && o.table_.corner_of(v) != no_corner;
            const auto same = [&] {
                return std::equal(x[at(v)].begin(), x[at(v)].end(), t.position[at(v)].begin(), [](double a, double b) {
                    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
                });
            };
            if (lives && (!t.lives[at(v)] || !same())) changed.push_back(v);
            if (!lives && t.lives[at(v)]) left.push_back(v);
            t.lives[at(v)] = lives ? 1 : 0;
            if (lives) t.position[at(v)] = x[at(v)];
        }
        if (!left.empty()) {
            word(gone);
            word(left.size());
            for (const Index v : left) vertex(v);
        }
        if (changed.empty()) return;
        word(places);
        word(changed.size());
        for (const Index v : changed) {
            vertex(v);
            numbers(x[at(v)]);
        }
    }

    // ---- Named at ANNULUS_TRACED ----

    template <int d>
    static void begun(const Displacement_budget<d>& o, std::span<const Coordinates<d>> x) {
        if (!on) return;
        recorded<d> = {};
        word(begin);
        tell_positions(o, x);
    }
    template <int d>
    static void recomputed(const Displacement_budget<d>& o) {
        if (!on) return;
        word(recompute);
        std::vector<Index> lives;
        for (Index v = 0; v < o.table_.vertex_bound(); ++v)
            if (o.table_.corner_of(v) != no_corner) lives.push_back(v);
        word(lives.size());
        for (const Index v : lives) {
            vertex(v);
            word(o.vertex_[at(v)].threshold.bits());
            expiries(o.list_[at(v)]);
        }
    }
    template <int d>
    static void placed(const Displacement_budget<d>& o, Index v) {
        if (!on) return;
        word(place);
        vertex(v);
        numbers(o.vertex_[at(v)].fixed);
    }
    template <int d>
    static void untracking(const Displacement_budget<d>& o) {
        if (on && !o.kept()) word(untracked);
    }
    template <int d>
    static void tested(const Displacement_budget<d>& o, const Step<d>& step) {
        untracking(o);
        if (!on || !o.kept()) return;
        tell_positions(o, step.x);
        word(test);
        word(step.mover == none ? 0 : at(step.mover) + 1);
        word(step.failed.size());
        for (const Index v : step.failed) vertex(v);
    }
    template <int d>
    static void passed(const Displacement_budget<d>& o, Index v, const Coordinates<d>& p) {
        untracking(o);
        if (!on || !o.kept()) return;
        recorded<d>.position[at(v)] = p;
        word(places);
        word(1);
        vertex(v);
        numbers(p);
        word(test);
        word(at(v) + 1);
        word(0);
    }
    template <int d>
    static void anchoring(const Displacement_budget<d>& o, const Step<d>& step) {
        if (!on) return;
        tell_positions(o, step.x);
        word(stamp);
        word(o.stamp_);
    }
    template <int d>
    static void anchored(const Displacement_budget<d>& o, const Step<d>& step) {
        if (!on) return;
        word(anchor);
        word(step.failed.size());
        for (const Index v : step.failed) {
            vertex(v);
            number(o.list_[at(v)].base);
        }
    }
    static void made_pending(Certificate_id id) {
        if (on) pending.push_back(id);
    }
    template <int d>
    static void walked(const Displacement_budget<d>& o, Index) {
        if (!on) return;
        has_walked = true;
        for (const std::uint32_t k : o.walk_.certificates) {
            const Corner_index h(static_cast<Index>(k >> 1));
            around.push_back((k & 1) ? id_of_cell(o.table_.cell_of(h)) : id_of_facet(o.table_.facet(h)));
        }
    }
    template <int d>
    static void examined(const Displacement_budget<d>& o, Index v) {
        if (!on) return;
        word(examine);
        vertex(v);
        word(has_walked ? 1 : 0);
        list(around);
        list(pending);
        expiries(o.list_[at(v)]);
        around.clear();
        pending.clear();
        has_walked = false;
    }
    template <int d>
    static void undone(const Displacement_budget<d>&, const Step<d>&) {
        if (on) word(undo);
    }
    /// In their order where that matters, of a bi-cell: it names sides.
    template <int d, class Sites>
    static std::vector<Index> listed(const Sites& sites) {
        std::vector<Index> p;
        for (const auto& [v, label] : sites)
            if (v != none) p.push_back(v);
        if (p.size() != d + 2) std::sort(p.begin(), p.end());
        return p;
    }
    /// The points of certificate id as the table has it now; none when there is no such certificate.
    template <int d>
    static std::vector<Index> present(const Corner_table<d>& t, Certificate_id id) {
        if (is_of_cell(id)) {
            const Cell_index c = cell_of(id);
            if (!(c < t.cell_bound()) || !t.is_cell(c) || t.is_infinite(c)) return {};
            return listed<d>(cell_sites(t, c));
        }
        const Corner_index f = facet_of(id);
        if (!(f < t.facet_bound()) || !t.is_facet(f)) return {};
        return listed<d>(facet_certificate(t, f, false).point);
    }
    template <int d>
    static void committing(const Displacement_budget<d>& o, const Certificate_checker<d>&) {
        if (!on) return;
        std::vector<std::uint64_t> lost;
        for (const auto& [id, points] : recorded<d>.points)
            if (present(o.table_, id) != points) lost.push_back(id);
        for (const std::uint64_t id : lost) recorded<d>.points.erase(static_cast<Certificate_id>(id));
        word(replaced);
        list(lost);
    }
    template <int d, class S, class Expiry_of>
    static void written(const Displacement_budget<d>& o, const S& s, Certificate_id id, Expiry_of expiry_of) {
        if (!on) return;
        recorded<d>.points[id] = listed<d>(s.point);
        word(write);
        word(id);
        number(s.value.tolerance);
        word(recorded<d>.points[id].size());
        for (std::size_t k = 0; k < s.point.size(); ++k) {
            if (s.point[k].vertex == none) continue;
            vertex(s.point[k].vertex);
            number(o.list_[at(s.point[k].vertex)].base);
            word(expiry_of(k).bits());
        }
    }
    template <int d>
    static void rebased(const Displacement_budget<d>& o, Index v) {
        if (!on) return;
        has_rebased = true;
        for_each_certificate(
            o.table_, v, [&](Corner_index h) { around.push_back(id_of_cell(o.table_.cell_of(h))); },
            [&](Corner_index h) { around.push_back(id_of_facet(o.table_.facet(h))); });
    }
    template <int d>
    static void finished(const Displacement_budget<d>& o, Index v) {
        if (!on) return;
        word(finish);
        vertex(v);
        word(has_rebased ? 1 : 0);
        list(around);
        number(o.list_[at(v)].base);
        word(o.vertex_[at(v)].threshold.bits());
        expiries(o.list_[at(v)]);
        around.clear();
        has_rebased = false;
    }
    template <int d>
    static void committed(const Displacement_budget<d>& o) {
        if (!on) return;
        std::uint64_t certificates = 0;
        for (const Cell_index c : o.table_.finite_cells()) {
            static_cast<void>(c);
            ++certificates;
        }
        for (const Corner_index f : o.table_.facets())
            certificates += facet_kind(o.table_, f) != Facet_kind::nothing ? 1 : 0;
        word(over);
        word(certificates);
    }
};

}  // namespace annulus::inline v1
