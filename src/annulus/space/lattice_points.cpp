// SPDX-License-Identifier: GPL-3.0-or-later
// Many points of a periodic box at once: what lattice_places.cpp says of each, in loops without branches.
#include <annulus/space/lattice.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

namespace {

constexpr std::size_t block = 16;  // points
constexpr double many = 0x1p51;    // units of the grid

// All of it is inlined into functions for two kinds of processors, with the same results.

/// The largest integer up to x, for |x| <= 2^51: in rounding to nearest, x + 1.5 2^52 is rounded to an integer.
[[gnu::always_inline]] inline double floor_of(double x) {
    constexpr double no_fractions = 0x1.8p52;
    const double nearest = (x + no_fractions) - no_fractions;
    return nearest - (nearest > x ? 1.0 : 0.0);
}

/// A double as a sum of two of which the first has 24 digits.
struct Halves {
    double high, low;
    explicit Halves(double x = 0) : high(static_cast<double>(static_cast<float>(x))), low(x - high) {}
};

/// What is the same for all points, in units of the grid.
template <int d>
struct In_units {
    std::array<std::array<Halves, static_cast<std::size_t>(d)>, static_cast<std::size_t>(d)> given;
    typename Box<d>::Vectors box, in_basis, to_box;
    Coordinates<d> grid, per_grid;
    double most_images;  // of a point that is placed here; negative where none is
};

/// Coordinates of points, by axis.
template <int d>
using Block = std::array<std::array<double, block>, static_cast<std::size_t>(d)>;

/// Points of a block. The sums are those of Rounded_sum: whole numbers and fractions are added up in doubles, which
/// hold them as long as a point is at most `most_images` away.
template <int d>
class Placing {
  public:
    explicit Placing(const In_units<d>& units) : units_(units) {}

    /// False, with nothing written, where a point is too far away for this.
    [[nodiscard, gnu::always_inline]] inline bool operator()(const Coordinates<d>* point, Coordinates<d>* place,
                                                             Shift<d>* image, Coordinates<d>* given) {
        read(point);
        find_images();
        if (is_far_ || !(most_ <= units_.most_images)) return false;
        if (most_ == 0) place_in_box();
        else if (!place_elsewhere()) return false;
        write(place, image, given);
        return true;
    }

  private:
    [[gnu::always_inline]] inline void read(const Coordinates<d>* point) {
        for (std::size_t k = 0; k < block; ++k)
            for (std::size_t c = 0; c < d; ++c) x_[c][k] = point[k][c];
    }
    /// By vectors of the basis, with the sums of Lattice::in_basis.
    [[gnu::always_inline]] inline void find_images() {
        std::array<double, block> most{};
        for (std::size_t j = 0; j < d; ++j)
            for (std::size_t k = 0; k < block; ++k) {
                const auto& u = units_.in_basis[j];
                double f = u[0] * x_[0][k] + u[1] * x_[1][k];
                if constexpr (d == 3) f = f + u[2] * x_[2][k];
                image_[j][k] = floor_of(f);
                most[k] = std::max(most[k], std::fabs(image_[j][k]));
            }
        most_ = 0;
        for (const double m : most) most_ = std::max(most_, m);
        unsigned far = 0;  // or no number
        for (std::size_t c = 0; c < d; ++c)
            for (std::size_t k = 0; k < block; ++k) {
                x_[c][k] *= units_.per_grid[c];
                far |= std::fabs(x_[c][k]) <= many ? 0U : 1U;
            }
        is_far_ = far != 0;
    }
    /// Images by vectors of the box. False where one is too far away.
    [[nodiscard, gnu::always_inline]] inline bool take_images_in_box() {
        const Block<d> in_basis = image_;
        double most = 0;
        for (std::size_t c = 0; c < d; ++c)
            for (std::size_t k = 0; k < block; ++k) {
                double sum = 0;
                for (std::size_t j = 0; j < d; ++j) sum += in_basis[j][k] * units_.to_box[j][c];
                image_[c][k] = sum;
                most = std::max(most, std::fabs(sum));
            }
        return most <= units_.most_images;
    }
    [[gnu::always_inline]] static inline double nearest(double whole, double fraction) {
        return whole + (fraction + 0.5 >= 1 ? 1.0 : 0.0);
    }
    [[gnu::always_inline]] inline void place_in_box() {
        for (std::size_t c = 0; c < d; ++c)
            for (std::size_t k = 0; k < block; ++k) {
                const double below = floor_of(x_[c][k]);
                place_[c][k] = given_[c][k] = nearest(below, x_[c][k] - below) * units_.grid[c];
            }
    }
    [[nodiscard, gnu::always_inline]] inline bool place_elsewhere() {
        if (!take_images_in_box()) return false;
        for (std::size_t c = 0; c < d; ++c)
            for (std::size_t k = 0; k < block; ++k) {
                double whole = floor_of(x_[c][k]);
                double fraction = x_[c][k] - whole;
                double moved = 0;
                for (std::size_t j = 0; j < d; ++j) {
                    const auto& [high, low] = units_.given[j][c];
                    const double times = -image_[j][k];
                    const double product = times * (high + low);
                    const double rest = (times * high - product) + times * low;
                    const double below = floor_of(product), rest_below = floor_of(rest);
                    whole += below;
                    fraction += product - below;
                    whole += rest_below;
                    fraction += rest - rest_below;
                    moved += image_[j][k] * units_.box[j][c];
                }
                const double units = whole + floor_of(fraction + 0.5);
                place_[c][k] = units * units_.grid[c];
                given_[c][k] = (units + moved) * units_.grid[c];
            }
        return true;
    }
    [[gnu::always_inline]] inline void write(Coordinates<d>* place, Shift<d>* image, Coordinates<d>* given) const {
        for (std::size_t k = 0; k < block; ++k)
            for (std::size_t c = 0; c < d; ++c) {
                place[k][c] = place_[c][k];
                given[k][c] = given_[c][k];
                image[k][c] = static_cast<std::int32_t>(image_[c][k]);
            }
    }

    const In_units<d>& units_;
    Block<d> x_, image_, place_, given_;
    double most_ = 0;
    bool is_far_ = false;
};

template <int d>
using Place_block = bool(Placing<d>&, const Coordinates<d>*, Coordinates<d>*, Shift<d>*, Coordinates<d>*);

template <int d>
bool place_block(Placing<d>& placing, const Coordinates<d>* point, Coordinates<d>* place, Shift<d>* image,
                 Coordinates<d>* given) {
    return placing(point, place, image, given);
}

#if defined(__x86_64__)
template <int d>
__attribute__((target("avx2"))) bool place_block_avx2(Placing<d>& placing, const Coordinates<d>* point,
                                                      Coordinates<d>* place, Shift<d>* image, Coordinates<d>* given) {
    return placing(point, place, image, given);
}
template <int d>
Place_block<d>* best_place_block() {
    return __builtin_cpu_supports("avx2") != 0 ? place_block_avx2<d> : place_block<d>;
}
#else
template <int d>
Place_block<d>* best_place_block() {
    return place_block<d>;
}
#endif

}  // namespace

template <int d>
void Lattice<d>::represent(std::span<const Coordinates<d>> points, std::vector<Coordinates<d>>& place,
                           std::vector<Shift<d>>& image, std::vector<Coordinates<d>>& given) const {
    const std::size_t n = points.size();
    place.resize(n);
    image.resize(n);
    given.resize(n);
    In_units<d> units;
    units.grid = grid_;
    units.in_basis = dual_;
    units.most_images = 7;
    double rounding = 0;  // of coordinates in the basis, at most: of points, of vectors of the box, and in in_basis
    for (std::size_t c = 0; c < d; ++c) {
        units.per_grid[c] = 1 / grid_[c];
        double extent = 0;
        for (std::size_t j = 0; j < d; ++j) {
            units.given[j][c] = Halves(given_[j][c] / grid_[c]);
            units.box[j][c] = box_[j][c] / grid_[c];
            extent += std::fabs(units.box[j][c]) + 1;
            units.to_box[j][c] = static_cast<double>(to_box_[j][c]);
            if (given_[j][c] != 0 && std::fabs(given_[j][c]) < 0x1p-60 * grid_[c]) units.most_images = 0;
        }
        units.most_images = std::min(units.most_images, std::floor(0x1p51 / extent));
    }
    for (std::size_t j = 0; j < d; ++j) {
        double sum = 0;
        for (std::size_t i = 0; i < d; ++i) sum += 16 * std::fabs(dual_[j][i]) * grid_[i];
        rounding = std::max(rounding, sum);
    }
    if (!(rounding <= 0.25)) units.most_images = -1;  // a place may be far from the cell
    Placing<d> placing(units);
    Place_block<d>* const place_all = best_place_block<d>();
    for (std::size_t v = 0; v < n;) {
        if (v + block <= n && place_all(placing, &points[v], &place[v], &image[v], &given[v])) {
            v += block;
            continue;
        }
        for (const std::size_t end = std::min(v + block, n); v < end; ++v) {
            const Representative<d> r = representative(points[v], static_cast<std::int64_t>(v));
            place[v] = r.place;
            image[v] = r.image;
            given[v] = imaged(r);
        }
    }
}

template void Lattice<2>::represent(std::span<const Coordinates<2>>, std::vector<Coordinates<2>>&,
                                    std::vector<Shift<2>>&, std::vector<Coordinates<2>>&) const;
template void Lattice<3>::represent(std::span<const Coordinates<3>>, std::vector<Coordinates<3>>&,
                                    std::vector<Shift<3>>&, std::vector<Coordinates<3>>&) const;

}  // namespace annulus::inline v1
