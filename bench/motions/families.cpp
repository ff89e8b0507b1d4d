// SPDX-License-Identifier: GPL-3.0-or-later
#include "families.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace bench {

template <int d>
Scene<d>::Scene(std::string_view family, std::string_view motion, std::size_t n, double spacings, std::uint64_t seed)
    : family_(family), motion_(motion), random_(seed), scale_(n, 1.0), face_(n, 0) {
    const auto is_in = [family](const auto& names) {
        return std::find(std::begin(names), std::end(names), family) != std::end(names);
    };
    if (!is_in(families) && !is_in(lattices) && !is_in(irregular))
        throw std::invalid_argument("no family " + std::string(family));
    if (std::find(std::begin(kinds_of_motion), std::end(kinds_of_motion), motion) == std::end(kinds_of_motion))
        throw std::invalid_argument("no motion " + std::string(motion));
    x_.resize(n);
    const double many = static_cast<double>(n);
    const double spacing = family == "sphere" || family == "faces" ? std::pow(12.0 / many, 1.0 / (d - 1))
                           : family == "slab"                      ? std::pow(0.01 / many, 1.0 / d)
                           : family == "ball"                      ? std::pow(4.0 / many, 1.0 / d)
                           : family == "integers"                  ? 1.0
                                                                   : std::pow(1.0 / many, 1.0 / d);
    reach_ = spacings * spacing;
    const auto side = static_cast<std::size_t>(std::ceil(std::pow(many, 1.0 / d) - 1e-9));
    Points<d> centre(static_cast<std::size_t>(7));
    for (auto& c : centre)
        for (double& k : c) k = random_.unit();
    for (std::size_t i = 0; i < n; ++i) {
        auto& p = x_[i];
        for (double& c : p) c = random_.unit();
        if (family == "sphere" || family == "ball") {
            const double radius = family == "ball" ? std::pow(random_.unit(), 1.0 / d) : 1.0;
            double norm = 0.0;
            for (double& c : p) {
                c = random_.normal();
                norm += c * c;
            }
            for (double& c : p) c *= radius / std::sqrt(norm);
        } else if (family == "outliers") {
            if (i % 100 == 0)
                for (double& c : p) c = 1000.0 * random_.normal();
        } else if (family == "hubs") {
            const std::size_t hub = i % 8;
            double norm = 0.0;
            for (double& c : p) {
                c = random_.normal();
                norm += c * c;
            }
            const double radius = i < 8 ? 0.0 : 1.0 + 1e-3 * random_.normal();
            for (double& c : p) c *= radius / std::sqrt(norm);
            p[0] += 5.0 * static_cast<double>(hub % 4);
            p[1] += 5.0 * static_cast<double>(hub / 4);
        } else if (family == "slab") {
            p[d - 1] *= 0.01;
        } else if (family == "clusters") {
            const std::size_t k = i % 7;
            scale_[i] = std::pow(10.0, -static_cast<double>(k));
            for (std::size_t c = 0; c < d; ++c) p[c] = centre[k][c] + scale_[i] * (p[c] - 0.5);
        } else if (family == "faces") {
            face_[i] = static_cast<int>(random_.bits() % (2 * d));
            keep(i);
        } else if (family == "lattice") {
            std::size_t rest = i;
            for (double& c : p) {
                c = static_cast<double>(rest % side) / static_cast<double>(side);
                c += std::ldexp(static_cast<double>(static_cast<int>(random_.bits() % 3) - 1), -53);
                rest /= side;
            }
        } else if (family == "jittered" || family == "integers") {
            std::size_t rest = i;
            for (double& c : p) {
                const auto k = static_cast<double>(rest % side);
                c = family == "integers" ? k : (k + 0.4 * c - 0.2) / static_cast<double>(side);
                rest /= side;
            }
        }
    }
    // In the order of a space-filling curve, Morton's, as in programs written for speed.
    std::vector<std::size_t> order(n);
    std::vector<std::uint64_t> code(n, 0);
    double reach = 0.0;
    for (const auto& p : x_)
        for (const double c : p) reach = std::max(reach, std::fabs(c));
    for (std::size_t i = 0; i < n; ++i) {
        order[i] = i;
        for (int bit = 19; bit >= 0; --bit)
            for (const double c : x_[i]) {
                const auto k = static_cast<std::uint64_t>((c / reach + 1.0) * 0.5 * 1048575.0);
                code[i] = 2 * code[i] + (k >> bit & 1);
            }
    }
    std::sort(order.begin(), order.end(), [&](std::size_t l, std::size_t r) { return code[l] < code[r]; });
    const auto reordered = [&](auto& values) {
        auto old = values;
        for (std::size_t i = 0; i < n; ++i) values[i] = old[order[i]];
    };
    reordered(x_);
    reordered(scale_);
    reordered(face_);
    this->start(std::move(x_), spacing);
}

/// Projects back to the surface of the family.
template <int d>
void Scene<d>::keep(std::size_t i) {
    auto& p = x_[i];
    if (family_ == "sphere") {
        double norm = 0.0;
        for (const double c : p) norm += c * c;
        for (double& c : p) c /= std::sqrt(norm);
    } else if (family_ == "faces") {
        for (double& c : p) c = c < 0.0 ? -c : c > 1.0 ? 2.0 - c : c;
        p[static_cast<std::size_t>(face_[i] / 2)] = face_[i] % 2;
    }
}

template <int d>
void Scene<d>::walk(std::size_t i, double reach) {
    for (double& c : x_[i]) c += reach * scale_[i] * random_.normal() / std::sqrt(static_cast<double>(d));
    keep(i);
}

template <int d>
bool Scene<d>::advance() {
    ++steps_;
    if (motion_ == "drift") {
        annulus::Coordinates<d> off{};
        for (double& c : off) c = reach_ * random_.normal();
        for (auto& p : x_)
            for (std::size_t k = 0; k < d; ++k) p[k] += off[k];
    } else if (motion_ == "shear") {
        for (auto& p : x_) p[0] += reach_ * p[1];
    } else if (motion_ == "few") {
        for (std::size_t i = steps_ % 100; i < x_.size(); i += 100) walk(i, reach_);
    } else if (motion_ == "burst") {
        if (steps_ % 8 == 0)
            for (std::size_t i = 0; i < x_.size(); ++i) walk(i, 8.0 * reach_);
    } else {
        for (std::size_t i = 0; i < x_.size(); ++i) walk(i, reach_);
    }
    return true;
}

template class Scene<2>;
template class Scene<3>;

}  // namespace bench
