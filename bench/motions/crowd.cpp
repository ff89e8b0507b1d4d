// SPDX-License-Identifier: GPL-3.0-or-later
#include "crowd.h"

#include "near_pairs.h"

namespace bench {

namespace {

constexpr double width = 20.0;  // metres, seconds from here on
constexpr double people = 0.5;  // on a square metre
constexpr double time_step = 0.02;
constexpr double relaxation = 0.5;  // to the desired speed
constexpr double repulsion = 2.1;   // V / mass, and its range
constexpr double range = 0.3;
constexpr double stride_time = 2.0;  // the length of the other person's next steps
constexpr double wall_repulsion = 10.0;
constexpr double wall_range = 0.2;
constexpr double out_of_sight = 0.5;  // of forces from persons not within 100 degrees of the heading
constexpr double cosine_of_sight = -0.17364817766693;
constexpr double most_speed = 1.3;  // of the desired one
constexpr double sight = 4.0;       // forces from farther away are negligible
constexpr double column = 0.6;      // radius
constexpr double columns_apart = 12.0;

double norm(const annulus::Coordinates<2>& v) { return std::hypot(v[0], v[1]); }

/// The force of another person at -off who walks at speed `pace` in direction `heading`: the gradient of V exp(-b /
/// range), b the half axis of the ellipse.
annulus::Coordinates<2> push(const annulus::Coordinates<2>& off, double pace,
                             const annulus::Coordinates<2>& direction) {
    const double ahead = pace * stride_time;
    const annulus::Coordinates<2> rest{off[0] - ahead * direction[0], off[1] - ahead * direction[1]};
    const double a = std::max(norm(off), 1e-6);
    const double b = std::max(norm(rest), 1e-6);
    const double axis = 0.5 * std::sqrt(std::max((a + b) * (a + b) - ahead * ahead, 1e-6));
    const double strength = repulsion / range * std::exp(-axis / range) * (a + b) / (4.0 * axis);
    return {strength * (off[0] / a + rest[0] / b), strength * (off[1] / a + rest[1] / b)};
}

}  // namespace

Crowd::Crowd(std::size_t n, int every, std::uint64_t seed)
    : every_(every), length_(static_cast<double>(n) / (people * width)), random_(seed) {
    for (double at = 0.5 * columns_apart; at < length_; at += columns_apart) columns_.push_back({at, 0.5 * width});
    for (std::size_t i = 0; i < n; ++i) {
        Point p{};
        for (int tries = 0; tries < 50; ++tries) {
            p = {length_ * random_.unit(), 0.5 + (width - 1.0) * random_.unit()};
            if (is_free(p)) break;
        }
        x_.push_back(p);
    }
    start(std::move(x_), std::sqrt(1.0 / people));
    for (std::size_t i = 0; i < n; ++i) {
        heading_.push_back(random_.bits() % 2 == 0 ? 1 : -1);
        speed_.push_back(wished_speed());
        velocity_.push_back({heading_.back() * speed_.back(), 0.0});
    }
    // Ten seconds of integration, in which no person leaves yet.
    for (int k = 0; k < 500; ++k) {
        integrate();
        for (auto& p : x_) p[0] += p[0] < 0.0 ? length_ : p[0] > length_ ? -length_ : 0.0;
    }
}

double Crowd::wished_speed() { return std::max(0.5, 1.34 + 0.26 * random_.normal()); }

bool Crowd::is_free(const Point& p) const {
    for (const Point& c : columns_)
        if (norm({p[0] - c[0], p[1] - c[1]}) < column + 0.3) return false;
    for (const Point& q : x_)
        if (norm({p[0] - q[0], p[1] - q[1]}) < 0.4) return false;
    return true;
}

bool Crowd::advance() {
    for (int k = 0; k < every_; ++k) integrate();
    // Persons outside the corridor leave, and as many arrive at the other end. A new person gets the index freed last.
    std::vector<std::pair<double, int>> newcomers;
    for (std::size_t i = 0; i < x_.size(); ++i) {
        if (x_[i][0] >= 0.0 && x_[i][0] <= length_) continue;
        leaves(static_cast<Index>(i));
        newcomers.emplace_back(heading_[i] > 0 ? 0.0 : length_, heading_[i]);
    }
    for (std::size_t k = 0; k < newcomers.size(); ++k) {
        const auto [at, heading] = newcomers[k];
        Point p{};
        for (int tries = 0; tries < 50; ++tries) {
            p = {at + 0.5 * heading * random_.unit(), 0.5 + (width - 1.0) * random_.unit()};
            if (is_free(p)) break;
        }
        const auto i = static_cast<std::size_t>(number_of_arrival(k));
        heading_[i] = heading;
        speed_[i] = wished_speed();
        velocity_[i] = {heading * speed_[i], 0.0};
        arrives(p);
    }
    return true;
}

void Crowd::integrate() {
    Points<2> force(x_.size());
    for (std::size_t i = 0; i < x_.size(); ++i)
        force[i] = {(heading_[i] * speed_[i] - velocity_[i][0]) / relaxation, -velocity_[i][1] / relaxation};
    add_repulsions(force);
    add_walls(force);
    for (std::size_t i = 0; i < x_.size(); ++i) {
        Point& v = velocity_[i];
        for (std::size_t k = 0; k < 2; ++k) v[k] += time_step * force[i][k] + 0.01 * random_.normal();
        const double pace = norm(v);
        if (pace > most_speed * speed_[i])
            for (double& c : v) c *= most_speed * speed_[i] / pace;
        for (std::size_t k = 0; k < 2; ++k) x_[i][k] += time_step * v[k];
        // Forces keep persons away from walls; this is for one that the crowd pushes into a wall.
        double& y = x_[i][1];
        y = y < 0.0 ? -y : y > width ? 2.0 * width - y : y;
    }
}

void Crowd::add_repulsions(Points<2>& force) const {
    for_each_near_pair<2>(x_, sight, [&](std::size_t i, std::size_t j) {
        const Point off{x_[i][0] - x_[j][0], x_[i][1] - x_[j][1]};
        if (off[0] * off[0] + off[1] * off[1] > sight * sight) return;
        const auto feels = [&](std::size_t who, std::size_t other, double sign) {
            const double pace = norm(velocity_[other]);
            const Point direction =
                pace > 1e-9 ? Point{velocity_[other][0] / pace, velocity_[other][1] / pace} : Point{1.0, 0.0};
            const Point f = push({sign * off[0], sign * off[1]}, pace, direction);
            // The other person is in the direction from which the force comes.
            const double seen = -f[0] * heading_[who] >= norm(f) * cosine_of_sight ? 1.0 : out_of_sight;
            for (std::size_t k = 0; k < 2; ++k) force[who][k] += seen * f[k];
        };
        feels(i, j, 1.0);
        feels(j, i, -1.0);
    });
}

void Crowd::add_walls(Points<2>& force) const {
    for (std::size_t i = 0; i < x_.size(); ++i) {
        const Point& p = x_[i];
        force[i][1] +=
            wall_repulsion / wall_range * (std::exp(-p[1] / wall_range) - std::exp((p[1] - width) / wall_range));
        for (const Point& c : columns_) {
            const Point off{p[0] - c[0], p[1] - c[1]};
            const double r = std::max(norm(off), 1e-6);
            if (r > sight) continue;
            const double f = wall_repulsion / wall_range * std::exp(-std::max(r - column, 0.0) / wall_range);
            for (std::size_t k = 0; k < 2; ++k) force[i][k] += f * off[k] / r;
        }
    }
}

}  // namespace bench
