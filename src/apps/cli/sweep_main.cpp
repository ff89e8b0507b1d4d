// SPDX-License-Identifier: GPL-3.0-or-later
// The program `annulus-sweep`, which `annulus sweep` starts with the same arguments.
#include <apps/cli/tool.h>

int main(int argc, char** argv) {
    using namespace annulus::cli;
    constexpr Subcommand subcommands[] = {{"sweep", add_sweep_command}};
    return run_tool(argc, argv, subcommands);
}
