// SPDX-License-Identifier: GPL-3.0-or-later
// Points of a periodic box and their places: what is computed with a lattice once it is there (lattice.cpp).
#include <annulus/space/lattice.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/arithmetic/wide_integer.h>
#include <annulus/error.h>
#include <annulus/space/dot.h>
#include <annulus/space/rounded_sum.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace annulus::inline v1 {

namespace {

constexpr double most_images = 0x1p29;

/// Whether a place with these coordinates in the basis is in its cell, up to half a vector.
template <int d>
bool is_near(const Coordinates<d>& f) {
    return std::all_of(f.begin(), f.end(), [](double c) { return c >= -0.5 && c < 1.5; });
}

}  // namespace

template <int d>
Coordinates<d> Lattice<d>::in_basis(const Coordinates<d>& p) const {
    Coordinates<d> f;
    for (std::size_t j = 0; j < d; ++j) f[j] = dot<d>(dual_[j], p);
    return f;
}

template <int d>
Coordinates<d> Lattice<d>::place(const Coordinates<d>& place, Offset<d> offset) const {
    if (offset.is_zero()) return place;
    const Shift<d> o = offset.unpacked();
    Coordinates<d> p = place;
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t i = 0; i < d; ++i) p[i] += o[j] * basis_[j][i];
    return p;
}

template <int d>
Shift<d> Lattice<d>::in_box(Offset<d> offset) const {
    const Shift<d> o = offset.unpacked();
    Shift<d> shift{};
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t i = 0; i < d; ++i) shift[i] += o[j] * static_cast<std::int32_t>(to_box_[j][i]);
    return shift;
}

template <int d>
Representative<d> Lattice<d>::representative(const Coordinates<d>& p, std::int64_t i) const {
    for (const double c : p)
        if (!is_finite_number(c))
            throw Error(Error_code::not_finite,
                        "a coordinate of point " + std::to_string(i) + " is not a finite number", {i});
    Representative<d> r;
    std::array<std::int64_t, static_cast<std::size_t>(d)> image{};  // by vectors of the box
    Coordinates<d> left = p;
    for (int turn = 0; turn < 8; ++turn) {
        const Coordinates<d> f = in_basis(left);
        if (turn > 0 && is_near<d>(f)) return r;
        for (std::size_t j = 0; j < d; ++j) {
            const double k = std::floor(f[j]);
            if (!(std::fabs(k) <= most_images)) break;
            for (std::size_t c = 0; c < d; ++c) image[c] += static_cast<std::int64_t>(k) * to_box_[j][c];
        }
        for (std::size_t c = 0; c < d; ++c) {
            if (!(std::fabs(f[c]) <= most_images) || !(std::fabs(p[c] / grid_[c]) < 0x1p100) ||
                std::fabs(static_cast<double>(image[c])) > most_images)
                throw Error(Error_code::out_of_domain,
                            "point " + std::to_string(i) + " is more than 2^29 boxes away from the origin", {i});
            r.image[c] = static_cast<std::int32_t>(image[c]);
        }
        for (std::size_t c = 0; c < d; ++c) {
            Rounded_sum sum;
            sum.add(p[c] / grid_[c]);
            for (std::size_t j = 0; j < d; ++j) {
                if (image[j] == 0) continue;
                const double times = -static_cast<double>(image[j]);
                const double length = given_[j][c] / grid_[c];
                const double product = times * length;
                sum.add(product);
                sum.add(std::fma(times, length, -product));
            }
            r.place[c] = static_cast<double>(sum.nearest()) * grid_[c];
        }
        left = r.place;
    }
    throw_thin();
}

template <int d>
bool Lattice<d>::is_representative(const Representative<d>& r) const {
    for (std::size_t i = 0; i < d; ++i) {
        const double units = r.place[i] / grid_[i];
        if (!(std::fabs(units) < 0x1p53) || std::floor(units) != units) return false;
        if (std::fabs(static_cast<double>(r.image[i])) > most_images) return false;
    }
    return is_near<d>(in_basis(r.place));
}

template <int d>
Coordinates<d> Lattice<d>::imaged(const Representative<d>& r) const {
    Coordinates<d> p;
    for (std::size_t i = 0; i < d; ++i) {
        Int128 sum = static_cast<std::int64_t>(r.place[i] / grid_[i]);
        for (std::size_t j = 0; j < d; ++j)
            sum += Int128{r.image[j]} * static_cast<std::int64_t>(box_[j][i] / grid_[i]);
        p[i] = static_cast<double>(sum) * grid_[i];
    }
    return p;
}

template class Lattice<2>;
template class Lattice<3>;

}  // namespace annulus::inline v1
