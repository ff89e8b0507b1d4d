// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/voronoi_exact.h>

#include <annulus/arithmetic/exact.h>
#include <annulus/error.h>
#include <annulus/measure/circumcentre.h>
#include <annulus/space/euclidean.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace annulus::inline v1 {

namespace {

template <int d>
using Integers = std::array<mpz_class, static_cast<std::size_t>(d)>;

/// The star of a vertex in integers, the vertex at the origin.
template <int d>
class Exact_star {
  public:
    Exact_star(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells, Index v,
               std::span<const std::size_t> around)
        : cells_(cells), v_(v), around_(around) {
        std::vector<double> numbers;
        for (const std::size_t c : around)
            for (const Index i : cells.vertices[c])
                for (const double x : points[static_cast<std::size_t>(i)]) numbers.push_back(x);
        Scaled_integers exactly(numbers);
        exponent_ = exactly.exponent;
        star_.corner.resize(around.size());
        star_.own.resize(around.size());
        auto next = exactly.integer.begin();
        for (std::size_t k = 0; k < around.size(); ++k) {
            const auto& cell = cells.vertices[around[k]];
            star_.own[k] = static_cast<std::size_t>(std::find(cell.begin(), cell.end(), v) - cell.begin());
            for (auto& corner : star_.corner[k])
                for (mpz_class& x : corner) x = std::move(*next++);
            const Integers<d> origin = star_.corner[k][star_.own[k]];
            for (auto& corner : star_.corner[k]) corner = Euclidean<d>::difference(corner, origin, Exact_minus());
            note_circumcentre(k);
        }
    }

    [[nodiscard]] double volume() {
        // The first of these suffices for points of one magnitude; none would suffice for a sum that is 0, which cells
        // that are not Delaunay can have.
        for (mp_bitcnt_t q = 16;; q = 2 * q + 48) {
            round_circumcentres(q);
            sum_terms();
            mpz_class doubtful = bound_;
            doubtful <<= 50;
            if (doubtful <= abs(sum_) || q > 100000) return as_double(q);
        }
    }

  private:
    void note_circumcentre(std::size_t k) {
        std::array<const Integers<d>*, static_cast<std::size_t>(d)> others{};
        for (std::size_t i = 0, n = 0; i <= d; ++i)
            if (i != star_.own[k]) others[n++] = &star_.corner[k][i];
        const auto note = [&](auto&& t) {
            if (sgn(t.denominator) == 0)
                throw Error(
                    Error_code::bad_input, "a cell is flat: its Voronoi vertex is nowhere",
                    std::vector<std::int64_t>(cells_.vertices[around_[k]].begin(), cells_.vertices[around_[k]].end()));
            centres_.numerator.push_back(std::move(t.numerator));
            centres_.denominator.push_back(2 * t.denominator);
        };
        if constexpr (d == 2) note(Circumcentre_2<mpz_class>(*others[0], *others[1]));
        else note(Circumcentre_3<mpz_class>(*others[0], *others[1], *others[2]));
    }

    /// In units of 2^-q; each coordinate is less than one unit off.
    void round_circumcentres(mp_bitcnt_t q) {
        centres_.rounded.resize(around_.size());
        for (std::size_t k = 0; k < around_.size(); ++k)
            for (std::size_t i = 0; i < d; ++i) {
                mpz_class& x = centres_.rounded[k][i];
                mpz_mul_2exp(x.get_mpz_t(), centres_.numerator[k][i].get_mpz_t(), q);
                mpz_tdiv_q(x.get_mpz_t(), x.get_mpz_t(), centres_.denominator[k].get_mpz_t());
            }
    }

    /// The terms of voronoi_terms.h without their common factor. The origin is the vertex, which is on each edge.
    void sum_terms() {
        sum_ = 0;
        bound_ = 0;
        for (std::size_t k = 0; k < around_.size(); ++k)
            for (std::size_t i = 0; i <= d; ++i) {
                if (i == star_.own[k]) continue;
                const std::size_t other = static_cast<std::size_t>(cells_.neighbours[around_[k]][i]);
                if (other <= around_[k]) continue;
                const auto found = std::lower_bound(around_.begin(), around_.end(), other);
                if (found == around_.end() || *found != other)
                    throw Error(Error_code::bad_input,
                                "neighbours of the cells around vertex " + std::to_string(v_) + " do not go round it",
                                {v_});
                const Integers<d>& from = centres_.rounded[k];
                const Integers<d>& to = centres_.rounded[static_cast<std::size_t>(found - around_.begin())];
                if constexpr (d == 2) add(edge(k, facet_corners<2>[i][0], facet_corners<2>[i][1]), from, to);
                else
                    for (std::size_t e = 0; e < 3; ++e) {
                        const std::size_t p = facet_corners<3>[i][e];
                        const std::size_t q = facet_corners<3>[i][(e + 1) % 3];
                        if (p == star_.own[k] || q == star_.own[k]) add(edge(k, p, q), from, to);
                    }
            }
    }

    Integers<d> edge(std::size_t k, std::size_t p, std::size_t q) const {
        return Euclidean<d>::difference(star_.corner[k][q], star_.corner[k][p], Exact_minus());
    }

    static mpz_class size(const Integers<d>& x) {
        mpz_class sum = 0;
        for (const mpz_class& c : x) sum += abs(c);
        return sum;
    }

    void add(const Integers<2>& n, const Integers<2>& from, const Integers<2>& to) {
        sum_ += (to[0] - from[0]) * n[1] - (to[1] - from[1]) * n[0];
        bound_ += 2 * size(n);  // each coordinate of either end is less than a unit off
    }
    void add(const Integers<3>& n, const Integers<3>& from, const Integers<3>& to) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t i = (k + 1) % 3;
            const std::size_t j = (k + 2) % 3;
            sum_ += n[k] * (from[i] * to[j] - from[j] * to[i]);
        }
        // n . ((from + r) x (to + s)) with coordinates of r and s below 1: |from x s| and |r x to| are in each
        // coordinate at most a sum of two coordinates, |r x s| at most 2.
        bound_ += size(n) * (size(from) + size(to) + 2);
    }

    [[nodiscard]] double as_double(mp_bitcnt_t q) const {
        long scale = 0;
        const double mantissa = mpz_get_d_2exp(&scale, sum_.get_mpz_t());
        const long shift = scale + d * exponent_ - static_cast<long>((d - 1) * q);
        const double volume =
            std::ldexp(mantissa / (d == 2 ? 4 : 12), static_cast<int>(std::clamp(shift, -4000L, 4000L)));
        return std::clamp(volume, std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max());
    }

    const Mesh_cells<d>& cells_;
    Index v_;
    std::span<const std::size_t> around_;
    long exponent_ = 0;
    struct Star {
        std::vector<std::array<Integers<d>, static_cast<std::size_t>(d + 1)>> corner;
        std::vector<std::size_t> own;  ///< which corner is v
    };
    Star star_;
    /// Circumcentres from v on: numerator / denominator, and rounded in the unit of the sum.
    struct Centres {
        std::vector<Integers<d>> numerator;
        std::vector<mpz_class> denominator;
        std::vector<Integers<d>> rounded;
    };
    Centres centres_;
    mpz_class sum_, bound_;
};

}  // namespace

template <int d>
double exact_voronoi_volume(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells, Index v,
                            std::span<const std::size_t> around) {
    return Exact_star<d>(points, cells, v, around).volume();
}

template double exact_voronoi_volume<2>(std::span<const Coordinates<2>>, const Mesh_cells<2>&, Index,
                                        std::span<const std::size_t>);
template double exact_voronoi_volume<3>(std::span<const Coordinates<3>>, const Mesh_cells<3>&, Index,
                                        std::span<const std::size_t>);

}  // namespace annulus::inline v1
