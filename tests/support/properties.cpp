// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/arbitrary.h>
#include <support/properties.h>

namespace annulus::testing {

bool for_all(const std::string& what, const std::function<void(const Seed&)>& property) {
    return rc::check(what, property);
}
bool for_all(const std::string& what, const std::function<void()>& property) { return rc::check(what, property); }
bool for_all(const std::function<void(const Seed&)>& property) { return rc::check(property); }
bool for_all(const std::function<void()>& property) { return rc::check(property); }

}  // namespace annulus::testing
