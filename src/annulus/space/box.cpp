// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/box.h>

#include <annulus/space/lattice.h>

#include <cmath>

namespace annulus::inline v1 {

template <int d>
Box<d>::Box(const Vectors& vectors) : vectors_(vectors) {
    (void)Lattice<d>(vectors);
}

template <int d>
double Box<d>::volume() const noexcept {
    return std::fabs(determinant_of_rows(vectors_));
}

template class Box<2>;
template class Box<3>;

}  // namespace annulus::inline v1
