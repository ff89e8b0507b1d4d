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

template <int d>
using Integer_vector = std::array<mpz_class, static_cast<std::size_t>(d)>;

/// The vectors with their coordinates, which lengths and angles are computed of, and as combinations of the box's.
template <int d>
struct Vectors_in_integers {
    std::array<Integer_vector<d>, static_cast<std::size_t>(d + 1)> x, of_box;

    explicit Vectors_in_integers(const typename Box<d>::Vectors& box) {
        std::vector<double> numbers;
        for (const auto& v : box) numbers.insert(numbers.end(), v.begin(), v.end());
        const Scaled_integers exactly(numbers);
        std::array<Integer_vector<d>, static_cast<std::size_t>(d)> rows;
        for (std::size_t j = 0; j < d; ++j) {
            of_box[j + 1][j] = 1;
            for (std::size_t i = 0; i < d; ++i) x[j + 1][i] = rows[j][i] = exactly.integer[j * d + i];
        }
        if (sgn(determinant_of_rows(rows)) == 0)
            throw Error(Error_code::usage, "the vectors of the box span no volume");
        while (shorten()) continue;
        for (std::size_t k = 1; k <= d; ++k) add(0, -1, k);
    }

    [[nodiscard]] mpz_class dot(std::size_t v, std::size_t w) const {
        mpz_class sum = 0;
        for (std::size_t i = 0; i < d; ++i) sum += x[v][i] * x[w][i];
        return sum;
    }
    /// Adds times w to v.
    void add(std::size_t v, const mpz_class& times, std::size_t w) {
        for (std::size_t i = 0; i < d; ++i) {
            x[v][i] += times * x[w][i];
            of_box[v][i] += times * of_box[w][i];
        }
    }
    /// Euclid's algorithm on the basis, in pairs: what Selling's steps would do one by one. False if no pair is
    /// shorter afterwards.
    [[nodiscard]] bool shorten() {
        bool shorter = false;
        for (std::size_t v = 1; v <= d; ++v)
            for (std::size_t w = 1; w <= d; ++w) {
                if (v == w) continue;
                // The integer nearest to the quotient, a half towards 0.
                const mpz_class over = dot(v, w), square = dot(w, w);
                const mpz_class times = (2 * abs(over) + square - 1) / (2 * square);
                if (times == 0) continue;
                add(v, sgn(over) > 0 ? mpz_class(-times) : times, w);
                shorter = true;
            }
        return shorter;
    }
    /// The step for v and w.
    void turn(std::size_t v, std::size_t w) {
        constexpr int times = d == 2 ? 2 : 1;
        for (std::size_t k = 0; k <= d; ++k)
            if (k != v && k != w) add(k, times, v);
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
    while (vectors.step()) continue;
    std::array<std::size_t, static_cast<std::size_t>(d + 1)> order{};
    for (std::size_t k = 0; k <= d; ++k) order[k] = k;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t v, std::size_t w) { return vectors.dot(v, v) > vectors.dot(w, w); });
    Superbase<d> sorted;
    for (std::size_t k = 0; k <= d; ++k)
        for (std::size_t j = 0; j < d; ++j) {
            const mpz_class& factor = vectors.of_box[order[k]][j];
            if (!factor.fits_slong_p()) throw Error(Error_code::usage, "the box is far too skewed: reduce it first");
            sorted[k][j] = factor.get_si();
        }
    return sorted;
}

template Superbase<2> obtuse_superbase<2>(const Box<2>::Vectors&);
template Superbase<3> obtuse_superbase<3>(const Box<3>::Vectors&);

}  // namespace annulus::inline v1
