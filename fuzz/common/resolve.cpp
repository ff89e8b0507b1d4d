// SPDX-License-Identifier: GPL-3.0-or-later
// Resolves an operation when it is run.
#include "program.h"

#include <cmath>
#include <limits>

namespace annulus::oracle {

namespace {
std::size_t at(Index i) { return static_cast<std::size_t>(i); }
}  // namespace

template <int d>
std::vector<Index> Session_of<d>::living() const {
    std::vector<Index> alive;
    for (std::size_t i = 0; i < sites_.size(); ++i)
        if (sites_[i]) alive.push_back(static_cast<Index>(i));
    return alive;
}

template <int d>
std::vector<Coordinates<d>> Session_of<d>::present() const {
    std::vector<Coordinates<d>> x(sites_.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = sites_[i].value_or(Coordinates<d>{});
    return x;
}

/// The call of an operation in the present state.
template <int d>
Operation_of<d> Session_of<d>::resolved(const Operation_of<d>& o) const {
    if (o.kind == Kind::refused) return refusal_of(static_cast<Refusal>(o.seed % refusals), at(std::max(o.vertex, 0)));
    if (!o.fits) return o;
    Operation_of<d> call = o;
    const std::vector<Index> alive = living();
    if (o.kind == Kind::move || o.kind == Kind::remove) {
        if (alive.empty()) return Calls<d>::recompute_tolerances();
        call.vertex = alive[at(std::max(o.vertex, 0)) % alive.size()];
    }
    if (o.kind == Kind::move || o.kind == Kind::insert)
        call.points[0] = free_place<d>(o.points[0], sites_, o.kind == Kind::move ? call.vertex : none);
    if (o.kind == Kind::move_all) make_fit<d>(call.points, sites_, sites_.size());
    return call;
}

/// A call that is refused for this reason, or, where there are too few points for that, because of an invalid point.
template <int d>
Operation_of<d> Session_of<d>::refusal_of(Refusal why, std::size_t v) const {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double sign = v % 2 == 0 ? 1.0 : -1.0;
    const double beyond = sign * (v % 3 == 0 ? 0x1p1023 : 0x1.0000000000001p500);
    const std::vector<Index> alive = living();
    const auto some = [&](std::size_t k) { return alive[(v + k) % alive.size()]; };
    const auto bad = [&](double c) {
        Coordinates<d> p = alive.empty() ? Coordinates<d>{} : *sites_[at(some(0))];
        p[v % p.size()] = c;
        return p;
    };
    const auto all = [&](double c) {
        std::vector<Coordinates<d>> x = present();
        x[at(some(0))] = bad(c);
        return Calls<d>::move_all(x);
    };
    const bool one = !alive.empty();
    const bool two = alive.size() >= 2;
    switch (why) {
        case Refusal::move_to_nan:
            if (one) return Calls<d>::move(some(0), bad(nan));
            break;
        case Refusal::move_to_infinity:
            if (one) return Calls<d>::move(some(0), bad(sign * infinity));
            break;
        case Refusal::move_out_of_domain:
            if (one) return Calls<d>::move(some(0), bad(beyond));
            break;
        case Refusal::insert_nan: break;
        case Refusal::insert_out_of_domain: return Calls<d>::insert(bad(beyond));
        case Refusal::move_all_to_nan:
            if (one) return all(v % 2 == 0 ? nan : infinity);
            break;
        case Refusal::move_all_out_of_domain:
            if (one) return all(beyond);
            break;
        case Refusal::one_point_too_many: {
            std::vector<Coordinates<d>> x = present();
            x.push_back(bad(0.375));
            return Calls<d>::move_all(x);
        }
        case Refusal::one_point_too_few: {
            std::vector<Coordinates<d>> x = present();
            if (x.empty()) break;
            x.pop_back();
            return Calls<d>::move_all(x);
        }
        case Refusal::move_meets:
            if (two) return Calls<d>::move(some(0), *sites_[at(some(1))]);
            break;
        case Refusal::insert_meets:
            if (one) return Calls<d>::insert(*sites_[at(some(0))]);
            break;
        case Refusal::move_all_meets: {
            if (!two) break;
            const Operation_of<d> o =
                Calls<d>::steady(Motion::jitter, 1, std::ldexp(1.0, -static_cast<int>(v % 30)), v);
            std::vector<Coordinates<d>> x = next_positions<d>(o, 0, sites_, sites_, {});
            x[at(some(1))] = x[at(some(0))];
            return Calls<d>::move_all(x);
        }
        case Refusal::move_free:
            return Calls<d>::move(
                free_indices_.empty() ? static_cast<Index>(sites_.size()) : free_indices_[v % free_indices_.size()],
                Coordinates<d>{});
        case Refusal::remove_free:
            return Calls<d>::remove(free_indices_.empty() ? static_cast<Index>(sites_.size())
                                                          : free_indices_[v % free_indices_.size()]);
        case Refusal::move_beyond: return Calls<d>::move(std::array{-1, 1000000, -2000000000}[v % 3], Coordinates<d>{});
    }
    return Calls<d>::insert(bad(nan));
}

template class Session_of<2>;
template class Session_of<3>;

}  // namespace annulus::oracle
