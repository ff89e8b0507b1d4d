// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/published/strategies.h>

#include <annulus/engine/rebuild_strategy.h>
#include <annulus/engine/tolerance_strategy.h>
#include <annulus/error.h>
#include <annulus/published/paper_strategy.h>
#include <annulus/published/relocation_strategy.h>

#include <string>

namespace annulus::inline v1 {

template <int d>
std::unique_ptr<Update_strategy<d>> make_paper(Delaunay_mesh<d>& mesh, const Paper_choice& choice, Tolerance_kind kind,
                                               std::uint64_t seed) {
    if (!choice.tolerances) return std::make_unique<Relocation_strategy<d>>(mesh, choice);
    return std::make_unique<Paper_strategy<d>>(mesh, choice, kind, seed);
}

template <int d>
std::unique_ptr<Update_strategy<d>> make_strategy(Delaunay_mesh<d>& mesh, const Options& options) {
    const Strategy strategy = options.strategy;
    const bool is_paper = strategy == Strategy::paper || strategy == Strategy::paper_hybrid;
    if (options.tolerance != Tolerance_kind::certified && !is_paper)
        throw Error(Error_code::usage, "tolerances of kind '" + std::string(name_of(options.tolerance)) +
                                           "' are for the strategies 'paper' and 'paper-hybrid', not '" +
                                           std::string(name_of(strategy)) + "'");
    switch (strategy) {
        case Strategy::rebuild: return std::make_unique<Rebuild_strategy<d>>(mesh);
        case Strategy::relocate:
        case Strategy::relocate_flips:
        case Strategy::paper:
        case Strategy::paper_hybrid:
            return make_paper<d>(mesh, Paper_choice::of(strategy), options.tolerance, options.seed);
        default: break;
    }
    auto made = std::make_unique<Tolerance_strategy<d>>(mesh, strategy);
    made->set_threads(options.threads);
    return made;
}

template std::unique_ptr<Update_strategy<2>> make_strategy(Delaunay_mesh<2>&, const Options&);
template std::unique_ptr<Update_strategy<3>> make_strategy(Delaunay_mesh<3>&, const Options&);
template std::unique_ptr<Update_strategy<2>> make_paper(Delaunay_mesh<2>&, const Paper_choice&, Tolerance_kind,
                                                        std::uint64_t);
template std::unique_ptr<Update_strategy<3>> make_paper(Delaunay_mesh<3>&, const Paper_choice&, Tolerance_kind,
                                                        std::uint64_t);

}  // namespace annulus::inline v1
