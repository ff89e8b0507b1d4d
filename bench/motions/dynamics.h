// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion.h"
#include "random.h"

#include <cstdint>

namespace bench {

/// Molecular dynamics: a drop of a Lennard-Jones liquid near its triple point (density 0.8442, temperature 0.75,
/// potential cut at 2.5 diameters) in a spherical container whose wall is a spring, by velocity Verlet with steps of
/// 0.005, in reduced units: the standard example of textbooks. It starts as a crystal, melts at twice the temperature
/// and is cooled before the first time step. Time steps are `every` steps of integration apart: 1 is the rate of a
/// simulation program (displacements of some 0.007 spacings), 100 a common rate of trajectory files. Displacements are
/// unlike a walk's: persistent for some ten steps, bounded by neighbours for some hundred.
class Dynamics : public Motion<3> {
  public:
    Dynamics(std::size_t n, int every, std::uint64_t seed);

  private:
    bool advance() override;
    void integrate();
    void accelerations();
    void rescale(double temperature);

    int every_;
    double radius_;  // of the container
    Points<3> velocity_;
    Points<3> acceleration_;
};

}  // namespace bench
