// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/degeneracy.h>
#include <annulus/moving_mesh.h>
#include <annulus/version.h>
#include <annulus/voronoi.h>

#include <iostream>
#include <type_traits>
#include <vector>

#if ANNULUS_VERSION < 100
#error "annulus/version.h is older than 0.1.0"
#endif
// Both spellings name one class.
static_assert(std::is_same_v<annulus::Moving_mesh<2>, annulus::v1::Moving_mesh<2>>);

int main() {
    const std::vector<annulus::Coordinates<2>> points{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, 0}};
    const std::vector<double> areas = annulus::Moving_mesh<2>(points).voronoi_volumes();
    annulus::Histogram histogram = annulus::Histogram::linear(0, 4, 4);
    histogram.add(areas);
    const annulus::Degeneracy found = annulus::degeneracy(annulus::Moving_mesh<2>(points));
    std::cout << "consumer: the cell in the middle has the area " << areas[4] << "\n";
    // The four others are unbounded.
    return areas[4] == 2 && found.bicells.least.total == 4 && histogram.overflow() == 4 ? 0 : 1;
}
