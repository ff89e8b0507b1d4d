// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/image_path.h>

#include <annulus/space/lattice.h>
#include <annulus/space/nearest_shift.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace annulus::inline v1::cli {

namespace {

/// The inverse of a matrix of rows, by Gauss and Jordan; precondition: it is a box.
template <int d>
typename Box<d>::Vectors inverse_of(typename Box<d>::Vectors m) {
    typename Box<d>::Vectors inverse{};
    for (std::size_t i = 0; i < d; ++i) inverse[i][i] = 1;
    for (std::size_t i = 0; i < d; ++i) {
        std::size_t pivot = i;
        for (std::size_t r = i + 1; r < d; ++r)
            if (std::abs(m[r][i]) > std::abs(m[pivot][i])) pivot = r;
        std::swap(m[i], m[pivot]);
        std::swap(inverse[i], inverse[pivot]);
        for (std::size_t r = 0; r < d; ++r) {
            const double factor = r == i ? 0 : m[r][i] / m[i][i];
            for (std::size_t k = 0; k < d; ++k) {
                m[r][k] -= factor * m[i][k];
                inverse[r][k] -= factor * inverse[i][k];
            }
        }
        const double diagonal = m[i][i];
        for (std::size_t k = 0; k < d; ++k) {
            m[i][k] /= diagonal;
            inverse[i][k] /= diagonal;
        }
    }
    return inverse;
}

template <int d>
Coordinates<d> times(const Coordinates<d>& row, const typename Box<d>::Vectors& m) {
    Coordinates<d> result{};
    for (std::size_t k = 0; k < d; ++k)
        for (std::size_t i = 0; i < d; ++i) result[i] += row[k] * m[k][i];
    return result;
}

/// `before` in terms of the vectors whose inverse is given; the unit matrix where these are not of the same lattice.
template <int d>
typename Image_path<d>::Matrix change_of_basis(const typename Box<d>::Vectors& before,
                                               const typename Box<d>::Vectors& inverse) {
    typename Image_path<d>::Matrix result{};
    typename Box<d>::Vectors rounded{};
    for (std::size_t j = 0; j < d; ++j) {
        const Coordinates<d> row = times<d>(before[j], inverse);
        for (std::size_t k = 0; k < d; ++k) {
            rounded[j][k] = std::nearbyint(row[k]);
            result[j][k] = std::abs(rounded[j][k]) < 1e6 ? std::llrint(rounded[j][k]) : 0;
        }
    }
    double determinant = 0;
    if constexpr (d == 2) {
        determinant = rounded[0][0] * rounded[1][1] - rounded[0][1] * rounded[1][0];
    } else {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
            determinant += rounded[0][k] * (rounded[1][a] * rounded[2][b] - rounded[1][b] * rounded[2][a]);
        }
    }
    if (std::abs(determinant) == 1) return result;
    result = {};
    for (std::size_t k = 0; k < d; ++k) result[k][k] = 1;
    return result;
}

}  // namespace

template <int d>
void Image_path<d>::follow(std::span<const std::uint64_t> id, std::span<const Coordinates<d>> x, const Box<d>& box) {
    const auto inverse = inverse_of<d>(box.vectors());
    const Lattice<d> lattice(box.vectors());
    basis_ = change_of_basis<d>(id_.empty() ? box.vectors() : vectors_, inverse);
    vectors_ = box.vectors();
    std::vector<Coordinates<d>> share(x.size());
    std::vector<Turns> turns(x.size(), Turns{});
    std::size_t before = 0, stay = 0;
    mean_ = max_ = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        share[i] = times<d>(x[i], inverse);
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
