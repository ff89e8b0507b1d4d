// SPDX-License-Identifier: GPL-3.0-or-later
// The second looks of `filter` after a failed tolerance.
#include <annulus/engine/filter.h>

#include <algorithm>

namespace annulus {

/// A cheap proof that facet f's certificate holds at x although a tolerance failed; `renewals_` gets new expiries for
/// commit().
template <int d>
bool Filter<d>::second_look(Corner_index f, std::span<const Coordinates<d>> x) {
    if constexpr (d == 2) {
        if (facet_kind(table_, f) != Facet_kind::empty_sphere || !(tolerance_[f] > 0.0)) return false;
        return look_ == Second_look::unequal_moves ? unequal_moves(f, x)
               : look_ == Second_look::safe_region ? safe_region(f, x)
                                                   : false;
    } else {
        return false;  // there are none in space: look_ is off
    }
}

/// The delimiter kept with the certificate still separates; every point may then move as far as the circle is. The
/// renewal holds these distances; commit_renewals() anchors the points where they are and makes expiries of them.
template <int d>
bool Filter<d>::safe_region(Corner_index f, std::span<const Coordinates<d>> x) {
    if constexpr (d == 2) {
        const Facet_points<d> point = bicell_points(table_, f);
        const auto points = tuple<d, d + 2>(point, x);
        Renewal renewal{f, {}};
        std::array<double, static_cast<std::size_t>(d + 2)> room{};
        if (!safe_region_lower(delimiter_[f], points, room)) return false;
        for (std::size_t k = 0; k < room.size(); ++k) {
            if (!(room[k] > 0.25 * tolerance_[f])) return false;  // too little to live on until the next step
            renewal.expiry[k] = room[k];
            const double now = reading(point[k], x[at(point[k])]);
            if (!(now < Expiry::lower(sum_lower(now, room[k])).reading())) return false;  // rounded away
        }
        renewals_.push_back(renewal);
        return true;
    } else {
        return false;
    }
}

/// Whether facet f's certificate is proved at x by the unequal moves of its two sides (theory 2): the sides travelled
/// dA and dB since the reference at most, and dA + dB < width. What is left of the width is shared: `renewals_` gets
/// new expiries ref + dA + rest / 2 and ref + dB + rest / 2, which commit_renewals() writes. A renewed record has tolerance 0:
/// its next failure is an evaluation.
template <int d>
bool Filter<d>::unequal_moves(Corner_index f, std::span<const Coordinates<d>> x) {
    const Facet_points<d> point = bicell_points(table_, f);
    std::array<double, static_cast<std::size_t>(d + 2)> expiry{};
    for (std::size_t k = 0; k < point.size(); ++k) expiry[k] = expiries_.of_facet(f, table_.twin(f), k).reading();
    const double tolerance = tolerance_[f];
    std::array<double, 2> travelled{};
    Renewal renewal{f, {}};
    for (std::size_t k = 0; k < point.size(); ++k) {
        const std::size_t w = at(point[k]);
        const double reading = this->reading(point[k], x[w]);
        // expiry <= reference + tolerance, so this is at least reading - reference up to rounding, which is added.
        const double expired = expiry[k] - tolerance;
        const double way = (reading - expired) + (reading + tolerance) * 0x1p-50;
        double& side = travelled[k < static_cast<std::size_t>(d) ? 0 : 1];
        side = std::max(side, way);
    }
    const double rest = 2.0 * tolerance - (travelled[0] + travelled[1]) * (1.0 + 0x1p-50);
    if (!(rest > 0.25 * tolerance)) return false;  // too little to live on until the next step
    for (std::size_t k = 0; k < point.size(); ++k) {
        const double side = travelled[k < static_cast<std::size_t>(d) ? 0 : 1];
        const double reference = expiry[k] - tolerance;  // rounded: at most one unit above the reference
        const double until = reference + (side + 0.5 * rest);
        renewal.expiry[k] = until - until * 0x1p-50;
        const double now = this->reading(point[k], x[at(point[k])]);
        if (!(now < Expiry::lower(renewal.expiry[k]).reading())) return false;  // rounded away
    }
    renewals_.push_back(renewal);
    return true;
}

template <int d>
void Filter<d>::keep_delimiter(Corner_index f, const Facet_points<d>& point, std::span<const Coordinates<d>> x) {
    if constexpr (d == 2) {
        if (!delimiter_.has(f)) delimiter_.resize(table_.facet_bound().offset());
        delimiter_[f] = standard_delimiter(tuple<d, d + 2>(point, x));
    }
}

template class Filter<2>;
template class Filter<3>;

}  // namespace annulus
