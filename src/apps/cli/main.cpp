// SPDX-License-Identifier: GPL-3.0-or-later
// The program `annulus`.
#include <apps/cli/companion.h>
#include <apps/cli/tool.h>

int main(int argc, char** argv) {
    using namespace annulus::cli;
    constexpr Subcommand subcommands[] = {{"lloyd", add_lloyd_command},
                                          {"nodt", add_nodt_companion},
                                          {"replay", add_replay_command},
                                          {"advise", add_advise_command},
                                          {"compare", add_compare_command},
                                          {"audit", add_audit_command},
                                          {"degeneracy", add_degeneracy_command},
                                          {"generate", add_generate_command},
                                          {"sweep", add_sweep_companion},
                                          {"reproduce", add_reproduce_companion},
                                          {"counterexample", add_counterexample_command}};
    return run_tool(argc, argv, subcommands);
}
