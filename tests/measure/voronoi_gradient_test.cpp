// SPDX-License-Identifier: GPL-3.0-or-later
// Gradients of Voronoi volumes beside finite differences, and beside each other.
#include <annulus/error.h>
#include <annulus/moving_mesh.h>
#include <annulus/voronoi.h>
#include <support/catch.h>
#include <support/generators.h>
#include <support/meshes.h>
#include <support/repeats.h>

#include <cmath>
#include <numeric>

using namespace annulus;
using namespace annulus::testing;

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

}  // namespace

TEMPLATE_TEST_CASE_SIG("Gradients of volumes are those of finite differences, dimension", "[measure][voronoi]",
                       ((int d), d), 2, 3) {
    for (const bool lattice : {false, true}) {
        Random random(17);
        Points_d<d> x = uniform<d>(d == 2 ? 40 : 60, random);
        if (lattice)
            for (std::size_t i = 0; i < x.size(); ++i) {
                const int side = d == 2 ? 7 : 4;
                int rest = static_cast<int>(i);
                for (std::size_t k = 0; k < d; ++k, rest /= side) x[i][k] = 0.125 * (rest % side);
            }
        const auto cells = [](const Points_d<d>& p) {
            return Moving_mesh<d>{std::span<const Coordinates<d>>(p)}.cells();
        };
        const auto volumes = [&](const Points_d<d>& p) { return voronoi_volumes<d>(p, cells(p)); };
        const auto start = volumes(x);
        std::vector<double> weights(x.size());
        for (double& w : weights) w = between(random, -1, 1);
        const auto total = [&](const Points_d<d>& p) {
            const auto v = volumes(p);
            double sum = 0;
            for (std::size_t i = 0; i < v.size(); ++i)
                if (std::isfinite(start[i])) sum += weights[i] * v[i];
            return sum;
        };
        const auto gradient = voronoi_gradient<d>(x, cells(x), weights);
        const Moving_mesh<d> mesh{std::span<const Coordinates<d>>(x)};
        const auto kept = mesh.voronoi_gradient(weights);
        for (std::size_t i = 0; i < x.size(); ++i)
            for (std::size_t a = 0; a < d; ++a) CHECK(kept[i][a] == Approx(gradient[i][a]).margin(1e-12));
        const auto jacobian = voronoi_jacobian<d>(x, cells(x));
        REQUIRE(jacobian.begin.size() == x.size() + 1);
        Points_d<d> product(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            Coordinates<d> sum{};
            double size = 0;
            for (Index k = jacobian.begin[i]; k < jacobian.begin[i + 1]; ++k) {
                REQUIRE((k == jacobian.begin[i] || jacobian.index[at(k - 1)] < jacobian.index[at(k)]));
                for (std::size_t a = 0; a < d; ++a) {
                    product[at(jacobian.index[at(k)])][a] += weights[i] * jacobian.value[at(k)][a];
                    sum[a] += jacobian.value[at(k)][a];
                    size += std::fabs(jacobian.value[at(k)][a]);
                }
            }
            for (const double s : sum) CHECK(std::fabs(s) <= 1e-13 * size);
            CHECK((jacobian.begin[i] == jacobian.begin[i + 1]) == std::isinf(start[i]));
        }
        for (std::size_t i = 0; i < x.size(); ++i)
            for (std::size_t a = 0; a < d; ++a) {
                CHECK(product[i][a] == Approx(gradient[i][a]).margin(1e-12));
                // A facet that is empty grows with the first power of the displacement, and the volume with the second.
                const double h = lattice ? 1e-8 : 1e-5;
                Points_d<d> up = x;
                Points_d<d> down = x;
                up[i][a] += h;
                down[i][a] -= h;
                CAPTURE(lattice, i, a);
                const double difference = (total(up) - total(down)) / (2 * h);
                if (std::isfinite(difference)) CHECK(gradient[i][a] == Approx(difference).epsilon(1e-4).margin(1e-7));
            }
    }
}

TEST_CASE("Kept gradients are those of the edges, points of every kind", "[measure][voronoi]") {
    for (int i = 0; i < repeats(3); ++i)
        for (const Family family : all_families) {
            const auto seed = static_cast<std::uint64_t>(8000 + i);
            Random random(seed);
            const Points x = point_set(family, 10 + random() % 30, random);
            INFO(name_of(family) << ", seed " << seed << "\n" << as_code(x));
            const Moving_mesh<2> mesh{std::span<const Coordinates<2>>(x)};
            std::vector<double> weights(x.size());
            for (double& w : weights) w = between(random, -1, 1);
            const auto kept = mesh.voronoi_gradient(weights);
            const auto gradient = voronoi_gradient<2>(x, mesh.cells(), weights);
            const auto jacobian = voronoi_jacobian<2>(x, mesh.cells());
            std::vector<double> size(x.size());  // the sum of the magnitudes of the terms
            for (std::size_t v = 0; v < x.size(); ++v)
                for (Index k = jacobian.begin[v]; k < jacobian.begin[v + 1]; ++k)
                    for (const double c : jacobian.value[at(k)]) size[at(jacobian.index[at(k)])] += std::fabs(c);
            for (std::size_t v = 0; v < x.size(); ++v)
                for (std::size_t a = 0; a < 2; ++a) {
                    CAPTURE(v, a, kept[v][a], gradient[v][a], size[v]);
                    CHECK(std::fabs(kept[v][a] - gradient[v][a]) <= 1e-8 * size[v] + 0x1p-1060);
                }
        }
}

TEMPLATE_TEST_CASE_SIG("Gradients do not depend on which triangulation cospherical points have, dimension",
                       "[measure][voronoi]", ((int d), d), 2, 3) {
    Points_d<d> x;
    const int side = 4;
    for (int i = 0; i < (d == 2 ? 16 : 64); ++i) {
        auto& p = x.emplace_back();
        for (int k = 0, rest = i; k < d; ++k, rest /= side) p[static_cast<std::size_t>(k)] = rest % side;
    }
    std::vector<double> weights(x.size());
    std::iota(weights.begin(), weights.end(), 1);
    std::vector<std::size_t> order(x.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto of = [&] {
        Points_d<d> shuffled;
        std::vector<double> w;
        for (const std::size_t i : order) {
            shuffled.push_back(x[i]);
            w.push_back(weights[i]);
        }
        const auto g =
            voronoi_gradient<d>(shuffled, Moving_mesh<d>{std::span<const Coordinates<d>>(shuffled)}.cells(), w);
        Points_d<d> out(x.size());
        for (std::size_t k = 0; k < order.size(); ++k) out[order[k]] = g[k];
        return out;
    };
    const auto first = of();
    Random random(19);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    const auto second = of();
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t a = 0; a < d; ++a) CHECK(first[i][a] == Approx(second[i][a]).margin(1e-14));
    CHECK_THROWS_AS(voronoi_gradient<d>(x, Moving_mesh<d>{std::span<const Coordinates<d>>(x)}.cells(), {}), Error);
}
