// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/published/strategies.h>

#include <annulus/arithmetic/error.h>
#include <annulus/engine/filter.h>
#include <annulus/engine/rebuilder.h>
#include <annulus/published/paper_filter.h>
#include <annulus/published/relocator.h>

#include <string>

namespace annulus {

template <int d>
std::unique_ptr<Upkeep<d>> make_strategy(Delaunay_mesh<d>& mesh, const Options& options) {
    const Strategy strategy = options.strategy;
    const std::string name(name_of(strategy));
    switch (strategy) {
        case Strategy::paper:
        case Strategy::paper_hybrid:
            return std::make_unique<Paper_filter<d>>(mesh, strategy, options.tolerance, options.seed);
        default: break;
    }
    if (options.tolerance != Tolerance_kind::certified)
        throw Error(Error_code::usage, "tolerances of kind '" + std::string(name_of(options.tolerance)) +
                                           "' are for the strategies 'paper' and 'paper-hybrid', not '" + name + "'");
    switch (strategy) {
        case Strategy::rebuild: return std::make_unique<Rebuilder<d>>(mesh);
        case Strategy::relocate:
        case Strategy::relocate_flips: return std::make_unique<Relocator<d>>(mesh, strategy);
        default: break;
    }
    auto filter = std::make_unique<Filter<d>>(mesh, strategy);
    filter->set_threads(options.threads);
    return filter;
}

template std::unique_ptr<Upkeep<2>> make_strategy(Delaunay_mesh<2>&, const Options&);
template std::unique_ptr<Upkeep<3>> make_strategy(Delaunay_mesh<3>&, const Options&);

}  // namespace annulus
