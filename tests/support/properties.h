// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <support/generators.h>

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>

namespace annulus::testing {

/// The start of a std::mt19937_64, for properties that draw many cases from it.
struct Seed {
    std::uint64_t value;
    [[nodiscard]] Random random() const { return Random(value); }
};
inline void showValue(const Seed& s, std::ostream& out) { out << "seed " << s.value; }

/// rc::check of a property. All properties have the same type here, so that RapidCheck's templates are compiled once,
/// in properties.cpp, and not for each lambda: they were two thirds of the code of a file of tests.
bool for_all(const std::string& what, const std::function<void(const Seed&)>& property);
bool for_all(const std::string& what, const std::function<void()>& property);
bool for_all(const std::function<void(const Seed&)>& property);
bool for_all(const std::function<void()>& property);

}  // namespace annulus::testing
