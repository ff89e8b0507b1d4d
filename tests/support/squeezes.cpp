// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/squeezes.h>

namespace annulus::testing {

template std::vector<Squeeze<mpq_class, 2, 3>> slabs<mpq_class, 2>(const Points_of_certificate<2, 3>& x);
template std::vector<Squeeze<mpq_class, 3, 4>> slabs<mpq_class, 3>(const Points_of_certificate<3, 4>& x);
template std::vector<Squeeze<mpq_class, 2, 4>> annuli<mpq_class, 2>(const Points_of_certificate<2, 4>& x);
template std::vector<Squeeze<mpq_class, 3, 5>> annuli<mpq_class, 3>(const Points_of_certificate<3, 5>& x);
template std::vector<Squeeze<double, 2, 3>> slabs<double, 2>(const Points_of_certificate<2, 3>& x);
template std::vector<Squeeze<double, 3, 4>> slabs<double, 3>(const Points_of_certificate<3, 4>& x);
template std::vector<Squeeze<double, 2, 4>> annuli<double, 2>(const Points_of_certificate<2, 4>& x);
template std::vector<Squeeze<double, 3, 5>> annuli<double, 3>(const Points_of_certificate<3, 5>& x);

}  // namespace annulus::testing
