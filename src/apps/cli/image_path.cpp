// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/image_path.h>

#include <annulus/space/lattice.h>
#include <annulus/space/nearest_shift.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace annulus::inline v1::cli {

namespace {

/// A combination of the rows.
template <int d>
Coordinates<d> times(const Coordinates<d>& row, const typename Box<d>::Vectors& m) {
    Coordinates<d> result{};
    for (std::size_t k = 0; k < d; ++k)
        for (std::size_t i = 0; i < d; ++i) result[i] += row[k] * m[k][i];
    return result;
}

/// Old vectors in terms of new ones; the unit matrix where these are not of the same lattice.
template <int d>
Integer_matrix<d> change_of_basis(const typename Box<d>::Vectors& before, const typename Box<d>::Vectors& now) {
    constexpr double most = 1e6;
    const auto relation =
        basis_relation<d>(now, most, [&](const Coordinates<d>& v) { return in_vectors<d>(before, v); });
    if (relation) return relation->to_new;
    Integer_matrix<d> unit{};
    for (std::size_t k = 0; k < d; ++k) unit[k][k] = 1;
    return unit;
}

}  // namespace

template <int d>
void Image_path<d>::follow(std::span<const std::uint64_t> id, std::span<const Coordinates<d>> x, const Box<d>& box) {
    const Lattice<d> lattice(box.vectors());
    basis_ = change_of_basis<d>(id_.empty() ? box.vectors() : vectors_, box.vectors());
    vectors_ = box.vectors();
    std::vector<Coordinates<d>> share(x.size());
    std::vector<Turns> turns(x.size(), Turns{});
    std::size_t before = 0, stay = 0;
    mean_ = max_ = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        share[i] = in_vectors<d>(vectors_, x[i]);
        while (before < id_.size() && id_[before] < id[i]) ++before;
        if (before == id_.size() || id_[before] != id[i]) continue;
        Coordinates<d> way{};
        for (std::size_t k = 0; k < d; ++k) {
            double expected = 0;
            for (std::size_t j = 0; j < d; ++j)
                expected +=
                    (share_[before][j] - static_cast<double>(turns_[before][j])) * static_cast<double>(basis_[j][k]);
            const double ahead = share[i][k] - expected, whole = std::nearbyint(ahead);
            turns[i][k] = std::llrint(whole);
            way[k] = ahead - whole;
        }
        // The nearest image: in a box that is skewed not that of each coordinate by itself.
        const Shift<d> nearer = nearest_shift<d>(lattice, times<d>(way, vectors_));
        for (std::size_t k = 0; k < d; ++k) {
            turns[i][k] += nearer[k];
            way[k] -= nearer[k];
        }
        double length = 0;
        for (const double c : times<d>(way, vectors_)) length = std::hypot(length, c);
        mean_ += length;
        max_ = std::max(max_, length);
        ++stay;
    }
    if (stay > 0) mean_ /= static_cast<double>(stay);
    id_.assign(id.begin(), id.end());
    share_ = std::move(share);
    turns_ = std::move(turns);
}

template class Image_path<2>;
template class Image_path<3>;

}  // namespace annulus::inline v1::cli
