// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/smoothing.h>

#include <annulus/error.h>
#include <annulus/published/strategies.h>
#include <apps/motion/generated_points.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace annulus::inline v1 {

namespace {

Domain_2 unit_square() {
    const std::array<Coordinates<2>, 4> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    return Domain_2::polygon(corners);
}

Options options_with(int threads) {
    Options options;
    options.threads = threads;
    options.merge_duplicates = true;
    return options;
}

template <int d>
void require_spanning(const Delaunay_mesh<d>& mesh) {
    if (mesh.dimension() < d)
        throw Error(Error_code::too_few, "a motion that smooths needs points that span the space");
}

/// Uniform points, those on the sphere first: with a volume of h^3 per point, the sphere has room for as many points as
/// squares of side h.
std::vector<Coordinates<3>> points_of_ball(const Ball_3& ball, std::size_t n, std::uint64_t seed) {
    const double square = std::pow(ball.volume() / static_cast<double>(n), 2.0 / 3);
    const auto on_sphere = std::min(n, static_cast<std::size_t>(4 * std::numbers::pi / square));
    std::vector<Coordinates<3>> points = ball.surface_sample(on_sphere, seed);
    Portable_random random(seed + 1);  // not the numbers of the sample
    while (points.size() < n) {
        Coordinates<3> p;
        for (double& c : p) c = 2 * random.unit() - 1;
        if (ball.contains(p)) points.push_back(p);
    }
    return points;
}

}  // namespace

Lloyd_motion::Lloyd_motion(std::vector<Coordinates<2>> points, int threads)
    : lloyd_(unit_square(), Density::one, threads),
      mesh_(std::make_unique<Delaunay_mesh<2>>()),
      engine_(
          std::make_unique<Engine<2>>(*mesh_, options_with(threads), make_strategy<2>(*mesh_, options_with(threads)))) {
    engine_->build(points);
    require_spanning(*mesh_);
    target_.resize(engine_->index_bound());
}

void Lloyd_motion::step() {
    stars_.read(mesh_->table());
    (void)lloyd_.step(stars_, engine_->positions(), target_, memory_);
    engine_->move_all(target_);
}

Nodt_motion::Nodt_motion(std::size_t n, std::uint64_t seed, int threads)
    : threads_(threads),
      mesh_(std::make_unique<Delaunay_mesh<3>>()),
      engine_(
          std::make_unique<Engine<3>>(*mesh_, options_with(threads), make_strategy<3>(*mesh_, options_with(threads)))) {
    engine_->build(points_of_ball(ball_, n, seed));
    require_spanning(*mesh_);
    target_.resize(engine_->index_bound());
    nodt_ = std::make_unique<Nodt_3>(ball_, Sizing_3(ball_), vertices_on_surface(ball_, engine_->positions()),
                                     std::optional<double>(), threads);
}

void Nodt_motion::step() {
    cells_.read(mesh_->table(), threads_);
    cells_.measure(ball_, engine_->positions(), threads_);
    (void)nodt_->step(cells_, engine_->positions(), target_, memory_);
    engine_->move_all(target_);
}

}  // namespace annulus::inline v1
