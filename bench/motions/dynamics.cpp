// SPDX-License-Identifier: GPL-3.0-or-later
#include "dynamics.h"

#include "near_pairs.h"

#include <numbers>

namespace bench {

namespace {

constexpr double density = 0.8442;
constexpr double time_step = 0.005;
constexpr double cut = 2.5;
constexpr double wall = 50.0;  // the force of the spring one diameter outside the container

double square(const annulus::Coordinates<3>& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

/// The n sites of a face-centred cubic crystal that are nearest to a point beside the origin (so that no two are
/// equally near), in its order.
Points<3> crystal(std::size_t n) {
    const double edge = std::cbrt(4.0 / density);
    const int half = static_cast<int>(std::cbrt(static_cast<double>(n))) / 2 + 3;
    Points<3> sites;
    for (int i = -half; i < half; ++i)
        for (int j = -half; j < half; ++j)
            for (int k = -half; k < half; ++k)
                for (const auto& [a, b, c] :
                     {annulus::Coordinates<3>{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}})
                    sites.push_back({edge * (i + a - 0.0321), edge * (j + b - 0.0123), edge * (k + c - 0.0213)});
    std::vector<double> distance;
    for (const auto& p : sites) distance.push_back(square(p));
    std::nth_element(distance.begin(), distance.begin() + static_cast<std::ptrdiff_t>(n), distance.end());
    const double limit = distance[n];
    std::erase_if(sites, [limit](const auto& p) { return square(p) >= limit; });
    return sites;
}

}  // namespace

Dynamics::Dynamics(std::size_t n, int every, std::uint64_t seed)
    : every_(every), radius_(std::cbrt(3.0 * static_cast<double>(n) / (4.0 * std::numbers::pi * density))) {
    Random random(seed);
    start(crystal(n), std::cbrt(1.0 / density));
    velocity_.resize(x_.size());
    acceleration_.resize(x_.size());
    for (auto& v : velocity_)
        for (double& c : v) c = random.normal();
    accelerations();
    for (int step = 0; step < 1200; ++step) {
        if (step % 20 == 0) rescale(step < 500 ? 1.5 : 0.75);
        integrate();
    }
}

bool Dynamics::advance() {
    for (int k = 0; k < every_; ++k) integrate();
    return true;
}

void Dynamics::integrate() {
    for (std::size_t i = 0; i < x_.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            velocity_[i][k] += 0.5 * time_step * acceleration_[i][k];
            x_[i][k] += time_step * velocity_[i][k];
        }
    accelerations();
    for (std::size_t i = 0; i < x_.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) velocity_[i][k] += 0.5 * time_step * acceleration_[i][k];
}

void Dynamics::accelerations() {
    for (std::size_t i = 0; i < x_.size(); ++i) {
        const double r = std::sqrt(square(x_[i]));
        const double pull = r > radius_ ? -wall * (r - radius_) / r : 0.0;
        for (std::size_t k = 0; k < 3; ++k) acceleration_[i][k] = pull * x_[i][k];
    }
    for_each_near_pair<3>(x_, cut, [this](std::size_t i, std::size_t j) {
        annulus::Coordinates<3> off;
        for (std::size_t k = 0; k < 3; ++k) off[k] = x_[i][k] - x_[j][k];
        const double r2 = square(off);
        if (r2 >= cut * cut) return;
        const double s6 = 1.0 / (r2 * r2 * r2);
        const double push = 24.0 * s6 * (2.0 * s6 - 1.0) / r2;
        for (std::size_t k = 0; k < 3; ++k) {
            acceleration_[i][k] += push * off[k];
            acceleration_[j][k] -= push * off[k];
        }
    });
}

void Dynamics::rescale(double temperature) {
    annulus::Coordinates<3> mean{};
    const double n = static_cast<double>(x_.size());
    for (const auto& v : velocity_)
        for (std::size_t k = 0; k < 3; ++k) mean[k] += v[k] / n;
    double energy = 0.0;
    for (auto& v : velocity_) {
        for (std::size_t k = 0; k < 3; ++k) v[k] -= mean[k];
        energy += square(v);
    }
    const double factor = std::sqrt(3.0 * n * temperature / energy);
    for (auto& v : velocity_)
        for (double& c : v) c *= factor;
}

}  // namespace bench
