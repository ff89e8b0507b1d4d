// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/reproduction/certificate_survey.h>

#include <optional>
#include <span>
#include <vector>

namespace annulus {

/// Where the points of one certificate go so that it fails although each goes less far than its reach: those of a
/// bi-cell {a, b, c, p, q}, or of a cell or a hull ridge {a, b, c, d}, as the predicates take them and holding where
/// they are. They go along the radii of an annulus through them, or across a slab, until its two sides have changed
/// places; every annulus and every slab of the points is tried. That the certificate fails is exact, that no way is
/// found proves nothing. A hundred microseconds at most.
[[nodiscard]] std::optional<std::vector<Coordinates<3>>> break_certificate(std::span<const Coordinates<3>> points,
                                                                           std::span<const double> reach);

/// Attacks each unsound certificate of a paper_triangulation (at most `most`, spread evenly) by moves below the
/// paper's tolerances of its points, and has those that break it made: is every move accepted, as within tolerance,
/// and what does the exact audit say (of the first `audits`)? Afterwards all are moved back.
[[nodiscard]] Attack_record attack(Moving_delaunay_3& dt, std::span<const std::vector<Index>> certificates,
                                   std::uint64_t most, std::uint64_t audits);

}  // namespace annulus
