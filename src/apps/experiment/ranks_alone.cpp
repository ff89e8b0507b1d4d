// SPDX-License-Identifier: GPL-3.0-or-later
// One process, in a build without MPI (ranks_mpi.cpp is the other).
#include <apps/experiment/ranks.h>

#include <annulus/error.h>
#include <apps/experiment/launched.h>

namespace annulus::inline v1 {

struct Ranks::Messages {};

Ranks::Ranks() {
    if (const int n = launched_processes(); n > 1)
        throw Error(Error_code::usage,
                    "started as one of " + std::to_string(n) +
                        " processes, but this build has no MPI: each would run all of the sweep (build it with "
                        "-DANNULUS_MPI=ON, or start it once, with --threads)");
}
Ranks::~Ranks() = default;
bool Ranks::built_with_mpi() noexcept { return false; }
void Ranks::share(std::string&) {}
void Ranks::serve(Coordinator&, int, const std::function<void()>&) {}
void Ranks::work(const Spec&, int) {}
void Ranks::give_up(const std::exception_ptr&) {}

}  // namespace annulus::inline v1
