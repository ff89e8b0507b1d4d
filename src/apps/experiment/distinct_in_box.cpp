// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/distinct_in_box.h>

#include <annulus/space/lattice.h>
#include <apps/formats/distinct.h>

#include <algorithm>

namespace annulus::inline v1 {

namespace {

/// Of all images of a place whose coordinates in the basis are from -1/4 to 5/4 the least one: the same for every image
/// in the basis' cell, which rounding leaves by much less than 1/4.
template <int d>
Coordinates<d> least_image(const Lattice<d>& lattice, const Coordinates<d>& place) {
    const auto between = [](const Coordinates<d>& b, double least, double most) {
        return std::all_of(b.begin(), b.end(), [=](double c) { return c >= least && c <= most; });
    };
    if (between(lattice.in_basis(place), 0.3, 0.7)) return place;  // the only one
    Coordinates<d> best = place;
    Shift<d> o{};
    o.fill(-1);
    for (;;) {
        const Coordinates<d> image = lattice.place(place, Offset<d>(o));
        if (between(lattice.in_basis(image), -0.25, 1.25)) best = std::min(best, image);
        std::size_t k = 0;
        while (k < d && o[k] == 1) o[k++] = -1;
        if (k == d) return best;
        ++o[k];
    }
}

}  // namespace

template <int d>
std::vector<Coordinates<d>> distinct_in_box(std::vector<Coordinates<d>> x, const Box<d>& box) {
    const Lattice<d> lattice(box.vectors());
    std::vector<Coordinates<d>> place, given;
    std::vector<Shift<d>> image;
    lattice.represent(x, place, image, given);
    for (Coordinates<d>& p : place) p = least_image(lattice, p);
    const std::vector<std::size_t> first = first_at_place<d>(place);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (first[i] == i) x[kept++] = x[i];
    x.resize(kept);
    return x;
}

template std::vector<Coordinates<2>> distinct_in_box<2>(std::vector<Coordinates<2>>, const Box<2>&);
template std::vector<Coordinates<3>> distinct_in_box<3>(std::vector<Coordinates<3>>, const Box<3>&);

}  // namespace annulus::inline v1
