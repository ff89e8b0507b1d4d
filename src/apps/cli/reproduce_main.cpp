// SPDX-License-Identifier: GPL-3.0-or-later
// The program `annulus-reproduce`, which `annulus reproduce` starts with the same arguments.
#include <apps/cli/tool.h>

int main(int argc, char** argv) {
    using namespace annulus::cli;
    constexpr Subcommand subcommands[] = {{"reproduce", add_reproduce_command}};
    return run_tool(argc, argv, subcommands);
}
