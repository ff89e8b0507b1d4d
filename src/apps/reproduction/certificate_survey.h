// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/moving_delaunay_2.h>
#include <annulus/moving_delaunay_3.h>
#include <apps/reproduction/records.h>

#include <functional>
#include <span>
#include <type_traits>

namespace annulus::inline v1 {

template <int d>
using Moving_of = std::conditional_t<d == 2, Moving_delaunay_2, Moving_delaunay_3>;

/// The paper's algorithm (3.2) with its tolerances in plain double, every vertex at its fixed position.
template <int d>
[[nodiscard]] Moving_of<d> paper_triangulation(std::span<const Coordinates<d>> x);

/// Statistics of certificates and tolerances at the positions of `dt`, a paper_triangulation, before points move to
/// `next`. With `widths` also their distribution. O(n).
template <int d>
[[nodiscard]] Certificate_survey_record survey(const Moving_of<d>& dt, std::span<const Coordinates<d>> next,
                                               double spacing, Width_record* widths = nullptr);

/// Certified counts; passes the points of each unsound certificate to the listener. A few microseconds per bi-cell.
template <int d>
[[nodiscard]] Degeneracy_count_record count_degeneracy(const Moving_of<d>& dt,
                                                       const std::function<void(std::span<const Index>)>& unsound = {});

extern template Moving_delaunay_2 paper_triangulation<2>(std::span<const Coordinates<2>>);
extern template Moving_delaunay_3 paper_triangulation<3>(std::span<const Coordinates<3>>);
extern template Certificate_survey_record survey<2>(const Moving_delaunay_2&, std::span<const Coordinates<2>>, double,
                                                    Width_record*);
extern template Certificate_survey_record survey<3>(const Moving_delaunay_3&, std::span<const Coordinates<3>>, double,
                                                    Width_record*);
extern template Degeneracy_count_record count_degeneracy<2>(const Moving_delaunay_2&,
                                                            const std::function<void(std::span<const Index>)>&);
extern template Degeneracy_count_record count_degeneracy<3>(const Moving_delaunay_3&,
                                                            const std::function<void(std::span<const Index>)>&);

}  // namespace annulus::inline v1
