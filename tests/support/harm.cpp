// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/harm.h>

namespace annulus::testing {

template std::vector<Harm<2>> harms<2, double>(const Audit_input<2>& input);
template std::vector<Harm<2>> harms<2, mpq_class>(const Audit_input<2>& input);
template std::vector<Harm<3>> harms<3, double>(const Audit_input<3>& input);
template std::vector<Harm<3>> harms<3, mpq_class>(const Audit_input<3>& input);

}  // namespace annulus::testing
