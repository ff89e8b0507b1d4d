// SPDX-License-Identifier: GPL-3.0-or-later
// The program `annulus-nodt`: natural ODT, alone and under several strategies.
#include <apps/cli/compare.h>
#include <apps/cli/guided_nodt.h>
#include <apps/cli/tool.h>

namespace {

using namespace annulus::cli;

Run add_compare_with_nodt(CLI::App& app, const Invocation& invocation) {
    return add_compare(app, invocation,
                       [](const Nodt_arguments& arguments,
                          const Common_arguments& common) -> std::unique_ptr<Guided_motion<annulus::Moving_mesh_3>> {
                           return std::make_unique<Guided_nodt>(arguments, common);
                       });
}

}  // namespace

int main(int argc, char** argv) {
    constexpr Subcommand subcommands[] = {{"nodt", add_nodt_command}, {"compare", add_compare_with_nodt}};
    return run_tool(argc, argv, subcommands);
}
