// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/counterexample_json.h>

#include <annulus/version.h>

namespace annulus::inline v1 {

nlohmann::ordered_json counterexample_json(const Counterexample& r, const std::string& command) {
    return {{"command", command},
            {"version", ANNULUS_VERSION_STRING},
            {"delta", r.delta},
            {"tolerance", {{"paper", r.paper}, {"certified", r.certified.tolerance}, {"exact", r.exact}}},
            {"stage", name_of(r.certified.stage)},
            {"theta_min", r.theta},
            {"move", r.move},
            {"largest_displacement_upper", r.displaced},
            {"accepted", {{"paper", r.displaced < r.paper}, {"certified", r.displaced < r.certified.tolerance}}},
            {"delaunay",
             {{"three_cells_before", r.three_before},
              {"three_cells_after", r.three_after},
              {"two_cells_after", r.two_after}}}};
}

}  // namespace annulus::inline v1
