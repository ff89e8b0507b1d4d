// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/periodic_thetas.h>

#include <annulus/engine/periodic_certificates.h>
#include <annulus/mesh/evaluate.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numbers>

namespace annulus::inline v1 {

template <int d>
std::vector<double> periodic_thetas(const Periodic_table<d>& table, const Lattice<d>& lattice,
                                    std::span<const Coordinates<d>> place) {
    std::vector<double> least(place.size(), std::numbers::pi / 2);
    for (std::size_t c = 0; c < table.size(); ++c)
        for (std::size_t i = 0; i <= d; ++i) {
            if (table.twin[c][i] < table.corner(c, i)) continue;
            const auto images = certificate_images<d>(table, facet_id(table, c, i));
            std::array<Coordinates<d>, static_cast<std::size_t>(d + 2)> x;
            for (std::size_t k = 0; k < x.size(); ++k)
                x[k] = lattice.place(place[static_cast<std::size_t>(images[k].vertex)], images[k].label);
            const double theta = bicell_theta(x);
            for (const Image<d> s : images) {
                double& of = least[static_cast<std::size_t>(s.vertex)];
                of = std::min(of, theta);
            }
        }
    for (std::size_t v = 0; v < place.size(); ++v)
        if (!is_place<d>(place[v])) least[v] = std::numeric_limits<double>::quiet_NaN();
    return least;
}

template std::vector<double> periodic_thetas(const Periodic_table<2>&, const Lattice<2>&,
                                             std::span<const Coordinates<2>>);
template std::vector<double> periodic_thetas(const Periodic_table<3>&, const Lattice<3>&,
                                             std::span<const Coordinates<3>>);

}  // namespace annulus::inline v1
