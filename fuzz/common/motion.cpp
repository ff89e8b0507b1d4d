// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion.h"

#include <cmath>
#include <limits>
#include <map>

namespace annulus::oracle {

std::uint64_t hashed(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
    std::uint64_t h = a * 0x9e3779b97f4a7c15U + 0x2545f4914f6cdd1dU;  // splitmix64 of each
    for (const std::uint64_t x : {b, c}) {
        h += x * 0x9e3779b97f4a7c15U + 0x9e3779b97f4a7c15U;
        h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9U;
        h = (h ^ (h >> 27)) * 0x94d049bb133111ebU;
        h ^= h >> 31;
    }
    return h;
}

template <int d>
std::optional<Error_code> domain_verdict(const Coordinates<d>& p) {
    for (const double c : p)
        if (!std::isfinite(c)) return Error_code::not_finite;
    for (const double c : p)
        if (std::fabs(c) > 0x1p500) return Error_code::out_of_domain;
    return std::nullopt;
}

namespace {

constexpr double turn = 6.283185307179586;

/// In [-1, 1).
double signed_unit(std::uint64_t h) { return static_cast<double>(h >> 10) * 0x1p-53 - 1.0; }

template <int d>
Coordinates<d> direction(std::uint64_t seed, std::uint64_t v, std::uint64_t salt) {
    Coordinates<d> u;
    for (std::size_t c = 0; c < u.size(); ++c) u[c] = signed_unit(hashed(seed, v, 31 * salt + c));
    return u;
}

template <int d>
struct Extent {
    Coordinates<d> least, greatest, centre;
    double size = 0.0;

    explicit Extent(const Sites_of<d>& sites) {
        least.fill(std::numeric_limits<double>::max());
        greatest.fill(-std::numeric_limits<double>::max());
        for (const auto& s : sites)
            for (std::size_t c = 0; s && c < least.size(); ++c) {
                least[c] = std::min(least[c], (*s)[c]);
                greatest[c] = std::max(greatest[c], (*s)[c]);
            }
        for (std::size_t c = 0; c < least.size(); ++c) {
            if (least[c] > greatest[c]) least[c] = greatest[c] = 0.0;
            centre[c] = 0.5 * least[c] + 0.5 * greatest[c];
            size = std::max(size, greatest[c] - least[c]);
        }
        if (size == 0.0) size = 1.0;
    }
    [[nodiscard]] Coordinates<d> place(std::uint64_t seed, std::uint64_t v) const {
        Coordinates<d> p = direction<d>(seed, v, 77);
        for (std::size_t c = 0; c < p.size(); ++c) p[c] = centre[c] + 0.6 * size * p[c];
        return p;
    }
};

std::vector<std::size_t> living(const auto& sites) {
    std::vector<std::size_t> alive;
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (sites[i]) alive.push_back(i);
    return alive;
}

}  // namespace

template <int d>
std::vector<Coordinates<d>> next_positions(const Operation_of<d>& o, int k, const Sites_of<d>& source,
                                           const Sites_of<d>& now,
                                           const std::function<Leeway<d>(std::size_t)>& leeway) {
    constexpr auto n = static_cast<std::size_t>(d);
    const auto step = static_cast<std::uint64_t>(k);
    const Extent<d> extent(source);
    const double far = o.pace * extent.size;
    const std::size_t axis = o.seed % n;
    const std::size_t other = (axis + 1) % n;
    const std::vector<std::size_t> alive = living(now);
    std::vector<Coordinates<d>> x(now.size());
    for (const std::size_t v : alive) x[v] = *now[v];
    const auto shift = [&x](std::size_t v, const Coordinates<d>& u, double by) {
        for (std::size_t c = 0; c < n; ++c) x[v][c] += by * u[c];
    };
    const auto each = [&alive](auto act) {
        for (const std::size_t v : alive) act(v);
    };
    switch (o.motion) {
        case Motion::drift: each([&](std::size_t v) { shift(v, direction<d>(o.seed, 0, 1), far); }); break;
        case Motion::own_ways: each([&](std::size_t v) { shift(v, direction<d>(o.seed, v, 2), far); }); break;
        case Motion::orbits:
            each([&](std::size_t v) {
                const double angle = 0.125 * k + turn * signed_unit(hashed(o.seed, v));
                x[v][axis] += far * std::cos(angle);
                x[v][other] += far * std::sin(angle);
            });
            break;
        case Motion::shear:
            each([&](std::size_t v) { x[v][axis] += o.pace * (x[v][other] - extent.centre[other]); });
            break;
        case Motion::rotation:
            each([&](std::size_t v) {
                const double a = x[v][axis] - extent.centre[axis];
                const double b = x[v][other] - extent.centre[other];
                x[v][axis] = extent.centre[axis] + (std::cos(o.pace) * a - std::sin(o.pace) * b);
                x[v][other] = extent.centre[other] + (std::sin(o.pace) * a + std::cos(o.pace) * b);
            });
            break;
        case Motion::breathing: {
            const std::uint64_t half = 1 + o.seed % 50;
            const double factor = step / half % 2 == 0 ? 1.0 + o.pace : 1.0 / (1.0 + o.pace);
            each([&](std::size_t v) {
                for (std::size_t c = 0; c < n; ++c) x[v][c] = extent.centre[c] + factor * (x[v][c] - extent.centre[c]);
            });
            break;
        }
        case Motion::jitter: each([&](std::size_t v) { shift(v, direction<d>(o.seed, v, 100 + step), far); }); break;
        case Motion::tolerances:
            each([&](std::size_t v) {
                const bool together = o.seed % 2 == 1;
                Coordinates<d> u = together ? direction<d>(o.seed, 0, 3) : direction<d>(o.seed, v, 200 + step);
                double length = 0.0;
                for (const double c : u) length += c * c;
                const Leeway<d> room = leeway(v);
                if (!(length > 0.0) || !(room.tolerance < 0x1p600)) return;
                if (!together) x[v] = room.fixed;
                shift(v, u, o.pace * room.tolerance / std::sqrt(length));
            });
            break;
        case Motion::ulps:
            each([&](std::size_t v) {
                for (std::size_t c = 0; c < n; ++c)
                    for (std::uint64_t h = hashed(o.seed, v, n * step + c) % 8; h >= 4;
                         h -= 2)  // 5 and 7 up, 6 and 7 twice
                        x[v][c] = std::nextafter(x[v][c], h % 2 == 0 ? -HUGE_VAL : HUGE_VAL);
            });
            break;
        case Motion::few:
            for (std::uint64_t m = 0; m <= o.seed % 3 && !alive.empty(); ++m) {
                const std::size_t v = alive[hashed(o.seed, step / 8, m) % alive.size()];
                shift(v, direction<d>(o.seed, v, 300 + (o.seed % 5 == 0 ? step : step / 8)), far);
            }
            break;
        case Motion::exchange:
            if (alive.size() >= 2) {
                const std::size_t first = hashed(o.seed, step) % alive.size();
                const std::size_t all = o.seed % 2 == 0 ? 2 : 2 + hashed(o.seed, step, 1) % (alive.size() - 1);
                for (std::size_t i = 0; i < all; ++i) {
                    const std::size_t next = i + 1 < all ? i + 1 : 0;
                    x[alive[(first + i) % alive.size()]] = *now[alive[(first + next) % alive.size()]];
                }
            }
            break;
        case Motion::there_and_back:
            each([&](std::size_t v) {
                x[v] = *source[v];
                if (k % 2 == 0) shift(v, direction<d>(o.seed, v, 400 + (o.seed % 2) * step), far);
            });
            break;
        case Motion::rest_and_go:
            if (step % (2 + o.seed % 6) == 0) each([&](std::size_t v) { shift(v, direction<d>(o.seed, v, 500), far); });
            break;
        case Motion::bursts:
            each([&](std::size_t v) { shift(v, direction<d>(o.seed, v, 600 + step), 0x1p-10 * far); });
            if (step % 8 == 7 && !alive.empty()) {
                if (o.seed % 4 == 0) {
                    each([&](std::size_t v) { x[v] = extent.place(hashed(o.seed, step), v); });
                } else {
                    const std::size_t v = alive[hashed(o.seed, step) % alive.size()];
                    x[v] = extent.place(hashed(o.seed, step), v);
                }
            }
            break;
    }
    make_fit<d>(x, now, hashed(o.seed, step, 9));
    return x;
}

template <int d>
void make_fit(std::vector<Coordinates<d>>& x, const Sites_of<d>& now, std::uint64_t seed) {
    const std::size_t given = std::min(x.size(), now.size());
    x.resize(now.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!now[i]) {
            constexpr std::array at_free_indices{0.0, 0x1p1000, std::numeric_limits<double>::quiet_NaN(), -0x1p-1074};
            x[i].fill(at_free_indices[hashed(seed, i) % at_free_indices.size()]);
        } else if (i >= given || domain_verdict<d>(x[i])) {
            x[i] = *now[i];
        }
    }
    for (bool met = true; met;) {  // a vertex that stays may be at the target of another; ends when all stay, or before
        met = false;
        std::map<Coordinates<d>, std::size_t> visitors;
        for (std::size_t i = 0; i < x.size(); ++i)
            if (now[i]) ++visitors[x[i]];
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (!now[i] || visitors[x[i]] == 1 || x[i] == *now[i]) continue;
            x[i] = *now[i];
            met = true;
        }
    }
}

template <int d>
Coordinates<d> free_place(Coordinates<d> p, const Sites_of<d>& now, Index self) {
    for (double& c : p) {
        if (std::isnan(c)) c = 0.0;
        c = std::clamp(c, -0x1p500, 0x1p500);
    }
    const auto taken = [&] {
        for (std::size_t i = 0; i < now.size(); ++i)
            if (now[i] && static_cast<Index>(i) != self && *now[i] == p) return true;
        return false;
    };
    const double inward = p[0] > 0.0 ? -HUGE_VAL : HUGE_VAL;
    while (taken()) p[0] = std::nextafter(p[0], inward);
    return p;
}

#define ANNULUS_INSTANTIATE(d)                                                                           \
    template std::vector<Coordinates<d>> next_positions(const Operation_of<d>&, int, const Sites_of<d>&, \
                                                        const Sites_of<d>&,                              \
                                                        const std::function<Leeway<d>(std::size_t)>&);   \
    template void make_fit<d>(std::vector<Coordinates<d>>&, const Sites_of<d>&, std::uint64_t);          \
    template Coordinates<d> free_place<d>(Coordinates<d>, const Sites_of<d>&, Index);                    \
    template std::optional<Error_code> domain_verdict<d>(const Coordinates<d>&);
ANNULUS_INSTANTIATE(2)
ANNULUS_INSTANTIATE(3)
#undef ANNULUS_INSTANTIATE

}  // namespace annulus::oracle
