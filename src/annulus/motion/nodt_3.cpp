// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/motion/nodt_3.h>

#include <annulus/arithmetic/error.h>
#include <annulus/motion/dihedral.h>
#include <annulus/mesh/parallel_runs.h>
#include <annulus/motion/surface_stars.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace annulus {

namespace {

constexpr std::size_t run_length = 256;

/// A sum of weighted offsets from a vertex, and of the weights.
struct Mean {
    Coordinates<3> offset{};
    double weight = 0;

    /// Adds w times (x - p), given m = w (x - a).
    void add(const Coordinates<3>& m, double w, const Coordinates<3>& a, const Coordinates<3>& p) {
        for (std::size_t k = 0; k < 3; ++k) offset[k] += m[k] - w * (p[k] - a[k]);
        weight += w;
    }
    [[nodiscard]] bool from(const Coordinates<3>& p, Coordinates<3>& x) const {
        for (std::size_t k = 0; k < 3; ++k) x[k] = p[k] + offset[k] / weight;
        return weight > 0 && std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
    }
};

/// The area of a triangle times the vector from a to its circumcentre. Nothing is asked of a triangle without area.
Coordinates<3> weighted_circumcentre(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c,
                                     double& area) {
    // With the origin at a and n = b × c: 2 |n|² x = |b|² c×n + |c|² n×b; the area is |n| / 2.
    Coordinates<3> u, v;
    for (std::size_t k = 0; k < 3; ++k) u[k] = b[k] - a[k], v[k] = c[k] - a[k];
    const auto cross = [](const Coordinates<3>& p, const Coordinates<3>& q) {
        return Coordinates<3>{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    };
    const auto dot = [](const Coordinates<3>& p, const Coordinates<3>& q) {
        return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    };
    const Coordinates<3> n = cross(u, v), vn = cross(v, n), nu = cross(n, u);
    const double length = std::sqrt(dot(n, n));
    area = length / 2;
    Coordinates<3> sum{};
    if (length > 0)
        for (std::size_t k = 0; k < 3; ++k) sum[k] = (dot(u, u) * vn[k] + dot(v, v) * nu[k]) / (4 * length);
    return sum;
}

struct Partial {
    double sum = 0, max = 0;
    std::size_t vertices = 0, boundary = 0, locked = 0, kept = 0;
};

double distance(const Coordinates<3>& p, const Coordinates<3>& q) {
    return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
}

/// This share of the way from p to q, but no farther than `most`.
Coordinates<3> towards(const Coordinates<3>& p, const Coordinates<3>& q, double share, double most) {
    const double way = distance(p, q);
    if (share * way > most) share = most / way;
    Coordinates<3> x;
    for (std::size_t k = 0; k < 3; ++k) x[k] = p[k] + share * (q[k] - p[k]);
    return x;
}

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Two vertices with one target would collide: they rest, and so do those that are then in the way of one that rests.
void rest_where_equal(std::span<const Coordinates<3>> position, std::span<Coordinates<3>> target, std::size_t& kept) {
    std::vector<Index> order(target.size());
    for (std::size_t v = 0; v < order.size(); ++v) order[v] = static_cast<Index>(v);
    for (bool again = true; again;) {
        again = false;
        std::sort(order.begin(), order.end(), [&](Index a, Index b) { return target[at(a)] < target[at(b)]; });
        for (std::size_t i = 0; i < order.size();) {
            std::size_t next = i + 1;
            while (next < order.size() && target[at(order[next])] == target[at(order[i])]) ++next;
            for (std::size_t k = i; next - i > 1 && k < next; ++k) {
                const std::size_t v = at(order[k]);
                if (target[v] == position[v]) continue;
                again = true;
                ++kept;
                target[v] = position[v];
            }
            i = next;
        }
    }
}

}  // namespace

std::vector<char> vertices_on_surface(const Domain_3& domain, std::span<const Coordinates<3>> points) {
    const Domain_3::Box box = domain.bounding_box();
    const double rounding = 1e-9 * distance(box.lower, box.upper);
    std::vector<char> on(points.size());
    std::transform(points.begin(), points.end(), on.begin(),
                   [&](const Coordinates<3>& p) { return distance(p, domain.project(p)) <= rounding ? 1 : 0; });
    return on;
}

Nodt_3::Nodt_3(const Domain_3& domain, Sizing_3 sizing, std::vector<char> on_surface,
               std::optional<double> lock_degrees, int threads)
    : domain_(domain), sizing_(sizing), on_surface_(std::move(on_surface)), threads_(threads) {
    if (threads < 1) throw Error(Error_code::usage, "natural ODT needs at least 1 thread");
    if (!lock_degrees) return;
    if (!(*lock_degrees > 0 && *lock_degrees < 70.5))
        throw Error(Error_code::usage, "the angle of locks must be between 0 and 70.5 degrees");
    lock_cosine_ = std::cos(*lock_degrees * std::numbers::pi / 180);
}

Nodt_step Nodt_3::step(const Cells_3& cells, std::span<const char> inside, std::span<const Coordinates<3>> position,
                       std::span<Coordinates<3>> target) const {
    const std::size_t n = position.size();
    if (target.size() != n || on_surface_.size() != n || inside.size() != cells.size() ||
        cells.adjacent.size() != cells.size())
        throw Error(Error_code::wrong_size, "natural ODT needs a target for every vertex, and flags for every cell");
    std::vector<double> mu(sizing_.constant() ? 0 : n);
    for_each_run(mu.size(), run_length, threads_, [&](std::size_t first, std::size_t last) {
        for (std::size_t v = first; v < last; ++v) mu[v] = sizing_.at(position[v]);
    });
    const auto size_of = [&](std::span<const Index> corners) {
        if (mu.empty()) return 1.0;
        double sum = 0;
        for (const Index v : corners) sum += mu[at(v)];
        return sum / static_cast<double>(corners.size());
    };

    // Cell by cell in their order, so that sums do not depend on threads.
    std::vector<Mean> volume(n), area(n);
    std::vector<char> bad(n, 0);
    for (std::size_t c = 0; c < cells.size(); ++c) {
        if (inside[c] == 0) continue;
        const auto& v = cells.vertex[c];
        const Coordinates<3>& a = position[at(v[0])];
        double weight = 0;
        Coordinates<3> moment =
            weighted_circumcentre(a, position[at(v[1])], position[at(v[2])], position[at(v[3])], weight);
        const double size = size_of(v), scale = 1 / (size * size * size);
        for (double& x : moment) x *= scale;
        weight *= scale;
        for (const Index i : v) volume[at(i)].add(moment, weight, a, position[at(i)]);
        if (!lock_cosine_) continue;
        const auto cosines = dihedral_cosines(a, position[at(v[1])], position[at(v[2])], position[at(v[3])]);
        // Not >: where a cell is flat the cosines are NaN, and it is no good.
        if (!std::all_of(cosines.begin(), cosines.end(), [&](double x) { return std::abs(x) <= *lock_cosine_; }))
            for (const Index i : v) bad[at(i)] = 1;
    }

    const auto facets = surface_facets(cells, inside);
    const Surface_stars surface(facets, n);
    for (const auto& t : facets) {
        const Coordinates<3>& a = position[at(t[0])];
        double weight = 0;
        Coordinates<3> moment = weighted_circumcentre(a, position[at(t[1])], position[at(t[2])], weight);
        const double size = size_of(t), scale = 1 / (size * size);
        for (double& x : moment) x *= scale;
        for (const Index k : t) area[at(k)].add(moment, scale * weight, a, position[at(k)]);
    }

    std::vector<Partial> partial((n + run_length - 1) / run_length);
    for_each_run(n, run_length, threads_, [&](std::size_t first, std::size_t last) {
        Partial& sums = partial[first / run_length];
        for (std::size_t v = first; v < last; ++v) {
            target[v] = position[v];
            if (!(volume[v].weight > 0)) continue;
            const bool boundary = on_surface_[v] != 0;
            ++sums.vertices;
            sums.boundary += boundary;
            if (lock_cosine_ && bad[v] == 0) {
                ++sums.locked;
                continue;
            }
            Coordinates<3> wanted;
            bool good = boundary ? surface.disc(static_cast<Index>(v)) && area[v].from(position[v], wanted)
                                 : volume[v].from(position[v], wanted);
            if (good && boundary) {
                double nearest = std::numeric_limits<double>::infinity();
                for (const auto& [a, b] : surface.around(static_cast<Index>(v)))
                    nearest = std::min(nearest, distance(position[v], position[at(a)]));
                wanted = domain_.project(towards(position[v], wanted, surface_relaxation, surface_stride * nearest));
            } else if (good) {
                good = domain_.contains(wanted);
            }
            if (good) target[v] = wanted;
            else ++sums.kept;
        }
    });
    Nodt_step total;
    for (const Partial& p : partial) {
        total.vertices += p.vertices;
        total.boundary += p.boundary;
        total.locked += p.locked;
        total.kept += p.kept;
    }
    rest_where_equal(position, target, total.kept);
    for (std::size_t v = 0; v < n; ++v) {
        const double moved = distance(position[v], target[v]);
        total.mean_displacement += moved;
        total.max_displacement = std::max(total.max_displacement, moved);
    }
    if (total.vertices > 0) total.mean_displacement /= static_cast<double>(total.vertices);
    return total;
}

}  // namespace annulus
