// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/engine.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <apps/motion/ball_3.h>
#include <apps/motion/lloyd_2.h>
#include <apps/motion/nodt_3.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

// Motions that need the triangulation, unlike Generated_motion: points(), step().
namespace annulus::inline v1 {

/// Lloyd's iteration over the unit square, density 1.
class Lloyd_motion {
  public:
    /// Merges points that coincide. Throws Error(too_few) if fewer than three are left, or all are on a line.
    Lloyd_motion(std::vector<Coordinates<2>> points, int threads);
    [[nodiscard]] std::span<const Coordinates<2>> points() const { return engine_->positions(); }
    void step();

  private:
    Lloyd_2 lloyd_;
    std::unique_ptr<Delaunay_mesh<2>> mesh_;
    std::unique_ptr<Engine<2>> engine_;
    Stars_2 stars_;
    Lloyd_memory memory_;
    std::vector<Coordinates<2>> target_;
};

/// Natural optimal Delaunay triangulation of the unit ball, sizing 1. It begins with uniform points, with as many on
/// the sphere as it has room for at their mean spacing.
class Nodt_motion {
  public:
    Nodt_motion(std::size_t points, std::uint64_t seed, int threads);
    [[nodiscard]] std::span<const Coordinates<3>> points() const { return engine_->positions(); }
    void step();

  private:
    Ball_3 ball_{1.0};
    int threads_;
    std::unique_ptr<Nodt_3> nodt_;
    std::unique_ptr<Delaunay_mesh<3>> mesh_;
    std::unique_ptr<Engine<3>> engine_;
    Kept_cells_3 cells_;
    Nodt_memory memory_;
    std::vector<Coordinates<3>> target_;
};

}  // namespace annulus::inline v1
