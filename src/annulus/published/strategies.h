// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/update_strategy.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/options.h>
#include <annulus/published/paper_choice.h>

#include <memory>

namespace annulus::inline v1 {

/// The strategy that the options name, for this mesh, which must outlive it. Throws Error(usage) where the options do
/// not fit together: only the paper's strategies allow tolerances that are not certified.
template <int d>
[[nodiscard]] std::unique_ptr<Update_strategy<d>> make_strategy(Delaunay_mesh<d>& mesh, const Options& options);

/// The strategy object for any variant of the paper's algorithms, also those that no option names. Kind and seed are as
/// in the options.
template <int d>
[[nodiscard]] std::unique_ptr<Update_strategy<d>> make_paper(Delaunay_mesh<d>& mesh, const Paper_choice& choice,
                                                             Tolerance_kind kind, std::uint64_t seed = 0);

extern template std::unique_ptr<Update_strategy<2>> make_strategy(Delaunay_mesh<2>&, const Options&);
extern template std::unique_ptr<Update_strategy<3>> make_strategy(Delaunay_mesh<3>&, const Options&);
extern template std::unique_ptr<Update_strategy<2>> make_paper(Delaunay_mesh<2>&, const Paper_choice&, Tolerance_kind,
                                                               std::uint64_t);
extern template std::unique_ptr<Update_strategy<3>> make_paper(Delaunay_mesh<3>&, const Paper_choice&, Tolerance_kind,
                                                               std::uint64_t);

}  // namespace annulus::inline v1
