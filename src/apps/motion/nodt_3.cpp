// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/nodt_3.h>

#include <annulus/error.h>
#include <annulus/mesh/parallel_runs.h>
#include <apps/motion/dihedral.h>
#include <apps/motion/distinct_targets.h>
#include <apps/motion/surface_stars.h>
#include <apps/motion/vectors_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr std::size_t run_length = 256;

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

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

/// The area of a triangle times the vector from a to its circumcentre. Precondition: the area is not 0.
Coordinates<3> weighted_circumcentre(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c,
                                     double& area) {
    // With the origin at a and n = b × c: 2 |n|² x = |b|² c×n + |c|² n×b; the area is |n| / 2.
    const Coordinates<3> u = minus(b, a), v = minus(c, a);
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

/// The point at this fraction of the way from p to q, but no farther than `most`.
Coordinates<3> towards(const Coordinates<3>& p, const Coordinates<3>& q, double share, double most) {
    const double way = distance(p, q);
    return between(p, q, share * way > most ? most / way : share);
}

/// The foot of q in the plane through p whose normal is the mean of those of the facets around p, weighted with area;
/// q where these are none.
Coordinates<3> in_tangent_plane(const Coordinates<3>& p, const Coordinates<3>& q,
                                std::span<const std::array<Index, 2>> around,
                                std::span<const Coordinates<3>> position) {
    Coordinates<3> normal{};
    for (const auto& [a, b] : around) {
        const Coordinates<3> n = cross(minus(position[at(a)], p), minus(position[at(b)], p));
        for (std::size_t k = 0; k < 3; ++k) normal[k] += n[k];
    }
    const double square = dot(normal, normal), height = dot(minus(q, p), normal) / square;
    if (!std::isfinite(height)) return q;
    return {q[0] - height * normal[0], q[1] - height * normal[1], q[2] - height * normal[2]};
}

/// The mean of the sizing over corners.
double size_of(std::span<const double> mu, std::span<const Index> corners) {
    if (mu.empty()) return 1.0;
    double sum = 0;
    for (const Index v : corners) sum += mu[at(v)];
    return sum / static_cast<double>(corners.size());
}

}  // namespace

double rounding_of(const Domain_3& domain) {
    const Domain_3::Box box = domain.bounding_box();
    return 1e-9 * distance(box.lower, box.upper);
}

std::vector<char> vertices_on_surface(const Domain_3& domain, std::span<const Coordinates<3>> points) {
    const double rounding = rounding_of(domain);
    std::vector<char> on(points.size());
    std::transform(points.begin(), points.end(), on.begin(),
                   [&](const Coordinates<3>& p) { return distance(p, domain.project(p)) <= rounding ? 1 : 0; });
    return on;
}

Nodt_3::Nodt_3(const Domain_3& domain, Sizing_3 sizing, std::vector<char> on_surface,
               std::optional<double> lock_degrees, int threads, Curve_motion sharp)
    : domain_(domain),
      sizing_(sizing),
      on_surface_(std::move(on_surface)),
      threads_(threads),
      sharp_(std::move(sharp)) {
    if (threads < 1) throw Error(Error_code::usage, "natural ODT needs at least 1 thread");
    if (!lock_degrees) return;
    if (!(*lock_degrees > 0 && *lock_degrees < 70.5))
        throw Error(Error_code::usage, "the angle of locks must be between 0 and 70.5 degrees");
    lock_cosine_ = std::cos(*lock_degrees * std::numbers::pi / 180);
}

/// Cells with their data.
struct Nodt_3::Mesh {
    const Mesh_cells<3>& cells;
    std::span<const char> inside;
    std::span<const Cell_moment> moments;
};

/// The mean of each vertex' circumcentres, and whether one of its cells is badly shaped.
struct Nodt_3::Sums {
    std::vector<Mean> volume;
    std::vector<char> bad;
};

Nodt_step Nodt_3::step(const Mesh_cells<3>& cells, std::span<const char> inside,
                       std::span<const Coordinates<3>> position, std::span<Coordinates<3>> target) const {
    if (inside.size() != cells.vertices.size())
        throw Error(Error_code::wrong_size, "natural ODT needs a flag for every cell");
    std::vector<Cell_moment> moments(cells.vertices.size());
    for_each_run(cells.vertices.size(), run_length, threads_, [&](std::size_t first, std::size_t last) {
        for (std::size_t c = first; c < last; ++c) {
            const auto& v = cells.vertices[c];
            if (inside[c] != 0)
                moments[c] =
                    cell_moment(position[at(v[0])], position[at(v[1])], position[at(v[2])], position[at(v[3])]);
        }
    });
    Nodt_memory memory;
    return step_of({cells, inside, moments}, position, target, memory);
}

Nodt_step Nodt_3::step(const Kept_cells_3& cells, std::span<const Coordinates<3>> position,
                       std::span<Coordinates<3>> target, Nodt_memory& memory) const {
    return step_of({cells.cells(), cells.inside(), cells.moments()}, position, target, memory);
}

/// The sizing at every vertex, also stored in the memory.
void Nodt_3::size_up(std::span<const Coordinates<3>> position, Nodt_memory& memory) const {
    if (sizing_.constant()) return;
    const bool known = memory.position_.size() == position.size();
    memory.position_.resize(position.size());
    memory.mu_.resize(position.size());
    for_each_run(position.size(), run_length, threads_, [&](std::size_t first, std::size_t last) {
        for (std::size_t v = first; v < last; ++v) {
            if (known && memory.position_[v] == position[v]) continue;
            memory.mu_[v] = sizing_.at(position[v]);
            memory.position_[v] = position[v];
        }
    });
}

bool Nodt_3::is_good(const std::array<Index, 4>& v, std::span<const Coordinates<3>> position) const {
    const auto cosines =
        dihedral_cosines(position[at(v[0])], position[at(v[1])], position[at(v[2])], position[at(v[3])]);
    // Not >: where a cell is flat the cosines are NaN, and it is badly shaped.
    return std::all_of(cosines.begin(), cosines.end(), [&](double x) { return std::abs(x) <= *lock_cosine_; });
}

/// Every thread has a range of vertices and reads all cells, in their order: so sums do not depend on the number of
/// threads.
void Nodt_3::sum_cells(const Mesh& mesh, std::span<const Coordinates<3>> position, std::span<const double> mu,
                       Sums& sums) const {
    const std::size_t n = position.size(), cells = mesh.cells.vertices.size();
    std::vector<char> good(lock_cosine_ ? cells : 0, 1);
    for_each_run(good.size(), run_length, threads_, [&](std::size_t first, std::size_t last) {
        for (std::size_t c = first; c < last; ++c)
            if (mesh.inside[c] != 0) good[c] = is_good(mesh.cells.vertices[c], position) ? 1 : 0;
    });
    const std::size_t range =
        std::max<std::size_t>(1, (n + static_cast<std::size_t>(threads_) - 1) / static_cast<std::size_t>(threads_));
    for_each_run(n, range, threads_, [&](std::size_t first, std::size_t last) {
        for (std::size_t c = 0; c < cells; ++c) {
            if (mesh.inside[c] == 0) continue;
            const auto& v = mesh.cells.vertices[c];
            const auto mine = [&](Index i) { return at(i) - first < last - first; };
            if (!(mine(v[0]) || mine(v[1]) || mine(v[2]) || mine(v[3]))) continue;
            const Coordinates<3>& a = position[at(v[0])];
            const double size = size_of(mu, v), scale = mu.empty() ? 1 : 1 / (size * size * size);
            Coordinates<3> moment = mesh.moments[c].moment;
            for (double& x : moment) x *= scale;
            const double weight = mesh.moments[c].volume * scale;
            for (const Index i : v) {
                if (!mine(i)) continue;
                sums.volume[at(i)].add(moment, weight, a, position[at(i)]);
                if (lock_cosine_ && good[c] == 0) sums.bad[at(i)] = 1;
            }
        }
    });
}

Nodt_step Nodt_3::step_of(const Mesh& mesh, std::span<const Coordinates<3>> position, std::span<Coordinates<3>> target,
                          Nodt_memory& memory) const {
    const std::size_t n = position.size();
    if (target.size() != n || on_surface_.size() != n || mesh.inside.size() != mesh.cells.vertices.size() ||
        mesh.moments.size() != mesh.cells.vertices.size() || mesh.cells.neighbours.size() != mesh.cells.vertices.size())
        throw Error(Error_code::wrong_size, "natural ODT needs a target for every vertex, and flags for every cell");
    size_up(position, memory);
    const std::span<const double> mu = memory.mu_;
    Sums sums{std::vector<Mean>(n), std::vector<char>(n, 0)};
    sum_cells(mesh, position, mu, sums);

    memory.nearby_.resize(n);
    std::vector<Mean> area(n);
    const auto facets = surface_facets(mesh.cells, mesh.inside, threads_);
    const Surface_stars surface(facets, n);
    for (const auto& t : facets) {
        const Coordinates<3>& a = position[at(t[0])];
        double weight = 0;
        Coordinates<3> moment = weighted_circumcentre(a, position[at(t[1])], position[at(t[2])], weight);
        const double size = size_of(mu, t), scale = 1 / (size * size);
        for (double& x : moment) x *= scale;
        for (const Index k : t) area[at(k)].add(moment, scale * weight, a, position[at(k)]);
    }

    const auto stride = [&](Index v) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& [a, b] : surface.around(v))
            nearest = std::min(nearest, distance(position[at(v)], position[at(a)]));
        return surface_stride * nearest;
    };
    const auto locked = [&](std::size_t v) { return lock_cosine_ && sums.bad[v] == 0; };

    std::vector<Partial> partial((n + run_length - 1) / run_length);
    for_each_run(n, run_length, threads_, [&](std::size_t first, std::size_t last) {
        Partial& counts = partial[first / run_length];
        for (std::size_t v = first; v < last; ++v) {
            target[v] = position[v];
            if (!(sums.volume[v].weight > 0)) continue;
            const bool boundary = on_surface_[v] != 0;
            ++counts.vertices;
            counts.boundary += boundary;
            if (locked(v)) {
                ++counts.locked;
                continue;
            }
            if (sharp_.holds(v)) {
                counts.kept += sharp_.is_corner(v);
                continue;
            }
            Coordinates<3> wanted;
            bool good = boundary ? surface.disc(static_cast<Index>(v)) && area[v].from(position[v], wanted)
                                 : sums.volume[v].from(position[v], wanted);
            if (good && boundary) {
                wanted = in_tangent_plane(position[v], wanted, surface.around(static_cast<Index>(v)), position);
                wanted = towards(position[v], wanted, surface_relaxation, stride(static_cast<Index>(v)));
                wanted = domain_.project(wanted, position[v], memory.nearby_[v]);
            } else if (good) {
                good = domain_.contains(wanted);
            }
            if (good) target[v] = wanted;
            else ++counts.kept;
        }
    });
    for (const Curve_motion::Target_on_curve& w : sharp_.wishes(position)) {
        const std::size_t v = at(w.vertex);
        if (sums.volume[v].weight > 0 && !locked(v)) target[v] = sharp_.place(w, surface_relaxation, stride(w.vertex));
    }
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

}  // namespace annulus::inline v1
