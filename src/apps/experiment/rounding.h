// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace annulus::inline v1 {

/// The rounding of an input's coordinates, like that of programs which write files.
struct Rounding {
    enum class Kind : std::uint8_t {
        plain,    ///< "double"
        single,   ///< "float": to the nearest float
        decimal,  ///< "decimal:K": to K digits after the point
        grid,     ///< "grid:H": to the nearest multiple of H
    };
    std::string name = "double";  ///< as in the specification
    Kind kind = Kind::plain;
    int digits = 0;
    double spacing = 0;

    static constexpr int most_digits = 17;
    friend bool operator==(const Rounding&, const Rounding&) = default;
};

/// None where `word` is not a rounding.
[[nodiscard]] std::optional<Rounding> rounding_named(std::string_view word);

/// The nearest number of that kind, as a double; ties as in printf (decimal), otherwise to even. A multiple of H is the
/// double nearest to it. Throws Error(out_of_domain) if the value exceeds the range of float.
[[nodiscard]] double rounded(double x, const Rounding& rounding);

template <int d>
void round_to(const Rounding& rounding, std::span<Coordinates<d>> points) {
    if (rounding.kind == Rounding::Kind::plain) return;
    for (Coordinates<d>& p : points)
        for (double& c : p) c = rounded(c, rounding);
}

}  // namespace annulus::inline v1
