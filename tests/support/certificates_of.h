// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificates of a triangulation, found by comparing the facets of its cells. In 2D and in 3D.

#include <annulus/types.h>

#include <algorithm>
#include <array>
#include <vector>

namespace annulus::testing {

template <int d>
struct Certificates_of {
    std::vector<std::array<Index, d + 1>> cells;
    std::vector<std::array<Index, d + 1>> ridges;   ///< two border facets, positive where the border is convex
    std::vector<std::array<Index, d + 2>> bicells;  ///< facet.., p, q with q on the positive side
};

/// The certificates of positively oriented cells that triangulate a convex body, found by comparing facets.
template <int d>
[[nodiscard]] Certificates_of<d> certificates_of(const std::vector<std::array<Index, d + 1>>& cells) {
    struct Facet {
        std::array<Index, d> name, corner;  // sorted; and such that {corner.., apex} is positive
        Index apex;
    };
    std::vector<Facet> facets;
    for (const auto& c : cells)
        for (std::size_t i = 0; i <= d; ++i) {
            Facet f;
            for (std::size_t k = 0, r = 0; k <= d; ++k)
                if (k != i) f.corner[r++] = c[k];
            if ((d - i) % 2 != 0) std::swap(f.corner[0], f.corner[1]);
            f.apex = c[i];
            f.name = f.corner;
            std::sort(f.name.begin(), f.name.end());
            facets.push_back(f);
        }
    std::sort(facets.begin(), facets.end(), [](const Facet& l, const Facet& r) { return l.name < r.name; });
    Certificates_of<d> out;
    out.cells = cells;
    std::vector<Facet> border;
    for (std::size_t i = 0; i < facets.size(); ++i) {
        if (i + 1 == facets.size() || facets[i].name != facets[i + 1].name) {
            border.push_back(facets[i]);
            continue;
        }
        std::array<Index, d + 2> b{};
        std::copy(facets[i].corner.begin(), facets[i].corner.end(), b.begin());
        b[d] = facets[i + 1].apex;
        b[d + 1] = facets[i].apex;
        out.bicells.push_back(b);
        ++i;
    }
    // Two border facets that share all corners but one. The interior is on the positive side of each, and where the
    // border is convex the odd corner of the other is too.
    for (std::size_t i = 0; i < border.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            Index odd = none;
            std::size_t shared = 0;
            for (const Index v : border[j].corner) {
                if (std::find(border[i].name.begin(), border[i].name.end(), v) != border[i].name.end()) ++shared;
                else odd = v;
            }
            if (shared != d - 1) continue;
            std::array<Index, d + 1> r{};
            std::copy(border[i].corner.begin(), border[i].corner.end(), r.begin());
            r[d] = odd;
            out.ridges.push_back(r);
        }
    return out;
}

/// The points of a certificate.
template <int d, std::size_t n>
[[nodiscard]] std::array<Coordinates<d>, n> points_of(const std::array<Index, n>& names,
                                                      const std::vector<Coordinates<d>>& x) {
    std::array<Coordinates<d>, n> p;
    for (std::size_t i = 0; i < n; ++i) p[i] = x[static_cast<std::size_t>(names[i])];
    return p;
}

}  // namespace annulus::testing
