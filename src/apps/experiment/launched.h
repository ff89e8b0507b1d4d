// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace annulus::inline v1 {

/// The number of processes that were started together with this one, including it, from environment variables of
/// launchers: Open MPI's mpirun; those of MPICH, Intel MPI and MVAPICH; Slurm's srun. 1 by default.
[[nodiscard]] inline int launched_processes() {
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE", "SLURM_STEP_NUM_TASKS"}) {
        const char* const value = std::getenv(name);
        if (value == nullptr) continue;
        const std::string_view digits(value);
        int n = 0;
        const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n);
        if (error == std::errc() && stop == digits.data() + digits.size() && n > 1) return n;
    }
    return 1;
}

}  // namespace annulus::inline v1
