// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/second_look.h>

#include <annulus/engine/displacement.h>

#include <algorithm>

namespace annulus {

template <int d>
void Second_looks<d>::keep(Corner_index f, Facet_kind kind, const Facet_points<d>& point, double tolerance,
                           std::span<const Coordinates<d>> x) {
    tolerance_[f] = tolerance;
    if constexpr (d == 2) {
        if (kind_ != Second_look::safe_region || kind != Facet_kind::empty_sphere) return;
        if (!delimiter_.has(f)) delimiter_.resize(tolerance_.size());
        delimiter_[f] = standard_delimiter(tuple<d, d + 2>(point, x));
    }
}

template <int d>
bool Second_looks<d>::proves(Corner_index f, const Facet_points<d>& point, const Facet_numbers& expiry, const Facet_numbers& reading,
                             std::span<const Coordinates<d>> x, Renewal<d>& renewal) const {
    renewal.facet = f;
    if (!on() || !(tolerance_[f] > 0.0)) return false;
    const bool proved = gives_room() ? safe_region(f, point, reading, x, renewal.expiry)
                                     : unequal_moves(tolerance_[f], expiry, reading, renewal.expiry);
    if (!proved) return false;
    for (std::size_t k = 0; k < point.size(); ++k) {
        const double until = gives_room() ? sum_lower(reading[k], renewal.expiry[k]) : renewal.expiry[k];
        if (!(reading[k] < Expiry::lower(until).reading())) return false;  // rounded away
    }
    return true;
}

/// The delimiter kept with the certificate still separates; every point may then move as far as the circle is.
template <int d>
bool Second_looks<d>::safe_region(Corner_index f, const Facet_points<d>& point, const Facet_numbers&, std::span<const Coordinates<d>> x,
                                  Facet_numbers& room) const {
    if constexpr (d == 2) {
        if (!safe_region_lower(delimiter_[f], tuple<d, d + 2>(point, x), room)) return false;
        // Otherwise too little to live on until the next step.
        return std::all_of(room.begin(), room.end(), [&](double r) { return r > 0.25 * tolerance_[f]; });
    } else {
        return false;  // there are none in space
    }
}

/// Whether the certificate is proved by the unequal moves of its two sides (theory 2): the sides travelled dA and dB since the
/// reference at most, and dA + dB < width. What is left of the width is shared: new expiries are ref + dA + rest / 2 and
/// ref + dB + rest / 2.
template <int d>
bool Second_looks<d>::unequal_moves(double tolerance, const Facet_numbers& expiry, const Facet_numbers& reading,
                                    Facet_numbers& renewed) const {
    const auto side_of = [](std::size_t k) { return k < static_cast<std::size_t>(d) ? 0U : 1U; };
    std::array<double, 2> travelled{};
    for (std::size_t k = 0; k < expiry.size(); ++k) {
        // expiry <= reference + tolerance, so this is at least reading - reference up to rounding, which is added.
        const double expired = expiry[k] - tolerance;
        const double way = (reading[k] - expired) + (reading[k] + tolerance) * 0x1p-50;
        travelled[side_of(k)] = std::max(travelled[side_of(k)], way);
    }
    const double rest = 2.0 * tolerance - (travelled[0] + travelled[1]) * (1.0 + 0x1p-50);
    if (!(rest > 0.25 * tolerance)) return false;  // too little to live on until the next step
    for (std::size_t k = 0; k < expiry.size(); ++k) {
        const double reference = expiry[k] - tolerance;  // rounded: at most one unit above the reference
        const double until = reference + (travelled[side_of(k)] + 0.5 * rest);
        renewed[k] = until - until * 0x1p-50;
    }
    return true;
}

template class Second_looks<2>;
template class Second_looks<3>;

}  // namespace annulus
