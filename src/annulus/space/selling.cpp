// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/space/selling.h>

#include <annulus/arithmetic/exact.h>
#include <annulus/error.h>
#include <annulus/space/lattice.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

namespace {

constexpr int most_steps = 1000;

template <int d>
using Integer_vector = std::array<mpz_class, static_cast<std::size_t>(d)>;

/// The vectors with their coordinates, which lengths and angles are computed of, and as combinations of the box's.
template <int d>
struct Vectors_in_integers {
    std::array<Integer_vector<d>, static_cast<std::size_t>(d + 1)> x;
    Superbase<d> of_box{};

    explicit Vectors_in_integers(const typename Box<d>::Vectors& box) {
        std::vector<double> numbers;
        for (const auto& v : box) numbers.insert(numbers.end(), v.begin(), v.end());
        const Scaled_integers exactly(numbers);
        std::array<Integer_vector<d>, static_cast<std::size_t>(d)> rows;
        for (std::size_t j = 0; j < d; ++j) {
            of_box[j + 1][j] = 1;
            of_box[0][j] = -1;
            for (std::size_t i = 0; i < d; ++i) {
                rows[j][i] = exactly.integer[j * d + i];
                x[j + 1][i] = rows[j][i];
                x[0][i] -= rows[j][i];
            }
        }
        if (sgn(determinant_of_rows(rows)) == 0)
            throw Error(Error_code::usage, "the vectors of the box span no volume");
    }

    [[nodiscard]] mpz_class dot(std::size_t v, std::size_t w) const {
        mpz_class sum = 0;
        for (std::size_t i = 0; i < d; ++i) sum += x[v][i] * x[w][i];
        return sum;
    }
    /// The step for v and w.
    void turn(std::size_t v, std::size_t w) {
        constexpr int times = d == 2 ? 2 : 1;
        for (std::size_t k = 0; k <= d; ++k) {
            if (k == v || k == w) continue;
            for (std::size_t i = 0; i < d; ++i) {
                x[k][i] += times * x[v][i];
                of_box[k][i] += times * of_box[v][i];
            }
        }
        for (std::size_t i = 0; i < d; ++i) {
            x[v][i] = -x[v][i];
            of_box[v][i] = -of_box[v][i];
        }
    }
    [[nodiscard]] bool step() {
        for (std::size_t v = 0; v <= d; ++v)
            for (std::size_t w = v + 1; w <= d; ++w)
                if (sgn(dot(v, w)) > 0) {
                    turn(v, w);
                    return true;
                }
        return false;
    }
};

}  // namespace

template <int d>
Superbase<d> obtuse_superbase(const typename Box<d>::Vectors& box) {
    Vectors_in_integers<d> vectors(box);
    int steps = 0;
    while (vectors.step())
        if (++steps == most_steps) throw Error(Error_code::usage, "the box is far too skewed: reduce it first");
    std::array<std::size_t, static_cast<std::size_t>(d + 1)> order{};
    for (std::size_t k = 0; k <= d; ++k) order[k] = k;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t v, std::size_t w) { return vectors.dot(v, v) > vectors.dot(w, w); });
    Superbase<d> sorted;
    for (std::size_t k = 0; k <= d; ++k) sorted[k] = vectors.of_box[order[k]];
    return sorted;
}

template Superbase<2> obtuse_superbase<2>(const Box<2>::Vectors&);
template Superbase<3> obtuse_superbase<3>(const Box<3>::Vectors&);

}  // namespace annulus::inline v1
