// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/reproduction/certificate_survey.h>

namespace annulus {

/// The time that CGAL needs to remove a vertex and to insert one where a neighbour is known: means over a tenth of the
/// vertices, which are removed one after another and then inserted again, so that the triangulation is always similar
/// to the original. Processor time of one thread.
template <int d>
[[nodiscard]] Operation_record time_operations(const Moving_of<d>& dt);

extern template Operation_record time_operations<2>(const Moving_delaunay_2&);
extern template Operation_record time_operations<3>(const Moving_delaunay_3&);

}  // namespace annulus
