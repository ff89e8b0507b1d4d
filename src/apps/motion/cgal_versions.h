// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060000000
#include <optional>
#include <variant>
#else
#include <boost/optional.hpp>
#include <boost/variant.hpp>
#endif

namespace annulus::inline v1 {

// Up to 5.6 CGAL returns variants and optionals of Boost, from 6.0 on those of C++.
#if CGAL_VERSION_NR >= 1060000000
template <class... T>
using Cgal_variant = std::variant<T...>;
template <class T>
using Cgal_optional = std::optional<T>;
#else
template <class... T>
using Cgal_variant = boost::variant<T...>;
template <class T>
using Cgal_optional = boost::optional<T>;
#endif

/// The T that a CGAL variant holds, or nullptr.
template <class T, class... U>
[[nodiscard]] const T* alternative(const Cgal_variant<U...>& v) noexcept {
#if CGAL_VERSION_NR >= 1060000000
    return std::get_if<T>(&v);
#else
    return boost::get<T>(&v);
#endif
}

}  // namespace annulus::inline v1
