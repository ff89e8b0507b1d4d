// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/reproduction/certificate_survey.h>

#include <optional>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Positions at which a certificate fails although each of its points moves less far than its reach. The points are
/// those of a bi-cell {a, b, c, p, q}, or of a cell or a hull ridge {a, b, c, d}, in the order of the predicates; the
/// certificate holds at their present positions. They move along the radii of an annulus through them, or across a
/// slab, until its two sides have changed places; every annulus and every slab of the points is tried. A failure is
/// proved exactly; if none is found this proves nothing. A hundred microseconds at most.
[[nodiscard]] std::optional<std::vector<Coordinates<3>>> break_certificate(std::span<const Coordinates<3>> points,
                                                                           std::span<const double> reach);

/// Attacks each unsound certificate of a paper_triangulation (at most `most`, spread evenly) by moves below the paper's
/// tolerances of its points, and makes the moves that break it: records whether every move is accepted as within
/// tolerance, and the result of the exact audit (of the first `audits`). Afterwards all points are moved back.
[[nodiscard]] Attack_record attack(Moving_delaunay_3& dt, std::span<const std::vector<Index>> certificates,
                                   std::uint64_t most, std::uint64_t audits);

}  // namespace annulus::inline v1
