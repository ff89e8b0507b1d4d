// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/voronoi_facet_exact.h>

#include <annulus/arithmetic/exact.h>
#include <annulus/error.h>
#include <annulus/mesh/at.h>
#include <annulus/space/euclidean.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace annulus::inline v1 {

namespace {

template <int d>
using Integers = std::array<mpz_class, static_cast<std::size_t>(d)>;

template <int d>
mpz_class dot(const Integers<d>& a, const Integers<d>& b) {
    mpz_class sum = a[0] * b[0];
    for (std::size_t k = 1; k < d; ++k) sum += a[k] * b[k];
    return sum;
}
template <std::size_t k>
mpz_class size(const std::array<mpz_class, k>& x) {
    mpz_class sum = 0;
    for (const mpz_class& c : x) sum += abs(c);
    return sum;
}

/// Its circumcentre is numerator / (2 denominator), relative to the corner at the origin.
template <int d>
auto circumcentre_terms(const std::array<const Integers<d>*, static_cast<std::size_t>(d)>& others) {
    const auto t = [&others] {
        if constexpr (d == 2) return Circumcentre_2<mpz_class>(*others[0], *others[1]);
        else return Circumcentre_3<mpz_class>(*others[0], *others[1], *others[2]);
    }();
    if (sgn(t.denominator) == 0) throw Error(Error_code::bad_input, "a cell is flat: its Voronoi vertex is nowhere");
    return t;
}

/// A number as mantissa * 2^exponent with a mantissa of magnitude 1/2 to 1, or 0.
struct Scaled {
    double mantissa;
    long exponent;

    explicit Scaled(const mpz_class& x) : exponent(0) { mantissa = mpz_get_d_2exp(&exponent, x.get_mpz_t()); }
    template <class T = double>
    [[nodiscard]] T times_power(long e) const {
        return std::ldexp(static_cast<T>(mantissa), static_cast<int>(std::clamp(exponent + e, -12000L, 12000L)));
    }
};
Scaled root(const Scaled& x) {
    Scaled out = x;
    if (out.exponent % 2 != 0) {
        out.mantissa *= 2;
        --out.exponent;
    }
    out.mantissa = std::sqrt(out.mantissa);
    out.exponent /= 2;
    return out;
}

/// The circumcentres around an edge, in integers with vertex i at the origin.
template <int d>
class Exact_ring {
  public:
    Exact_ring(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells, Index i, Index j,
               std::span<const Index> ring) {
        std::vector<double> numbers(points[at(i)].begin(), points[at(i)].end());
        numbers.insert(numbers.end(), points[at(j)].begin(), points[at(j)].end());
        for (const Index c : ring)
            for (const Index v : cells.vertices[at(c)])
                if (v != i) numbers.insert(numbers.end(), points[at(v)].begin(), points[at(v)].end());
        const Scaled_integers exactly(numbers);
        exponent_ = exactly.exponent;
        const auto relative = [&exactly](std::size_t k) {
            return Euclidean<d>::difference(&exactly.integer[k * d], &exactly.integer[0], Exact_minus());
        };
        edge_ = relative(1);
        for (std::size_t c = 0; c < ring.size(); ++c) {
            std::array<Integers<d>, static_cast<std::size_t>(d)> corner;
            std::array<const Integers<d>*, static_cast<std::size_t>(d)> others{};
            for (std::size_t k = 0; k < d; ++k) {
                corner[k] = relative(2 + c * d + k);
                others[k] = &corner[k];
            }
            auto t = circumcentre_terms<d>(others);
            numerator_.push_back(std::move(t.numerator));
            denominator_.push_back(2 * t.denominator);
        }
    }

    [[nodiscard]] Facet_measure<d> measure() {
        for (mp_bitcnt_t q = 64;; q = 2 * q) {
            round_circumcentres(q);
            if (add_up() || q > 100000) return as_doubles(q);
        }
    }

  private:
    /// In units of 2^-q; each coordinate is less than one unit off.
    void round_circumcentres(mp_bitcnt_t q) {
        centre_.resize(numerator_.size());
        for (std::size_t k = 0; k < centre_.size(); ++k)
            for (std::size_t i = 0; i < d; ++i) {
                mpz_class& x = centre_[k][i];
                mpz_mul_2exp(x.get_mpz_t(), numerator_[k][i].get_mpz_t(), q);
                mpz_tdiv_q(x.get_mpz_t(), x.get_mpz_t(), denominator_[k].get_mpz_t());
            }
    }

    /// Sums, and whether they are accurate: coordinates of differences of centres are less than two units off.
    bool add_up() {
        const auto chord = [this](std::size_t k) {
            return Euclidean<d>::difference(centre_[k], centre_[0], Exact_minus());
        };
        moment_ = {};
        sum_ = 0;
        mpz_class bound;
        if constexpr (d == 2) {
            const Integers<2> across = chord(1);
            sum_ = dot<2>(across, across);
            for (std::size_t i = 0; i < 2; ++i) moment_[i] = across[i];  // twice that of the middle
            bound = 8 * size(across);
        } else {
            for (std::size_t k = 1; k + 1 < centre_.size(); ++k) {
                const Integers<3> p = chord(k);
                const Integers<3> r = chord(k + 1);
                mpz_class twice = 0;
                for (std::size_t a = 0; a < 3; ++a)
                    twice += edge_[a] * (p[(a + 1) % 3] * r[(a + 2) % 3] - p[(a + 2) % 3] * r[(a + 1) % 3]);
                sum_ += twice;
                for (std::size_t a = 0; a < 3; ++a) moment_[a] += twice * (p[a] + r[a]);
                bound += size(edge_) * (2 * size(p) + 2 * size(r) + 8);
            }
        }
        bound <<= 50;
        return bound <= abs(sum_);
    }

    [[nodiscard]] Facet_measure<d> as_doubles(mp_bitcnt_t q) const {
        long unit = 0;  // the largest coordinate of a centre is below 2^unit
        for (const auto& c : centre_)
            for (const mpz_class& x : c) unit = std::max(unit, static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)));
        Facet_measure<d> out;
        const Scaled sum(sum_);
        if constexpr (d == 2) out.measure = root(sum).times_power<long double>(-unit);
        else {
            const Scaled length = root(Scaled(dot<3>(edge_, edge_)));
            Scaled twice = sum;
            twice.mantissa /= length.mantissa;
            out.measure = twice.times_power<long double>(-length.exponent - 2 * unit - 1);
        }
        for (std::size_t i = 0; i < d; ++i) {
            double inward = 0;
            if constexpr (d == 2) inward = Scaled(moment_[i]).times_power(-unit - 1);
            else {
                Scaled quotient(moment_[i]);
                quotient.mantissa /= 3 * sum.mantissa;
                inward = quotient.times_power(-sum.exponent - unit);
            }
            out.centroid[i] = Scaled(centre_[0][i]).times_power(-unit) + inward;
        }
        out.exponent = static_cast<int>(unit + exponent_ - static_cast<long>(q));
        return out;
    }

    long exponent_ = 0;
    Integers<d> edge_;
    std::vector<Integers<d>> numerator_;
    std::vector<mpz_class> denominator_;
    std::vector<Integers<d>> centre_;
    mpz_class sum_;  // 2D: the square of the length; 3D: twice the area times the length of the edge
    Integers<d> moment_;
};

}  // namespace

template <int d>
bool is_on_circumsphere(const Corners<d>& cell, const Coordinates<d>& t) {
    std::vector<double> numbers;
    for (const auto& x : cell) numbers.insert(numbers.end(), x.begin(), x.end());
    numbers.insert(numbers.end(), t.begin(), t.end());
    const Scaled_integers exactly(numbers);
    std::array<Integers<d>, static_cast<std::size_t>(d + 1)> v;
    std::array<const Integers<d>*, static_cast<std::size_t>(d)> others{};
    for (std::size_t i = 0; i <= d; ++i)
        v[i] = Euclidean<d>::difference(&exactly.integer[(i + 1) * d], &exactly.integer[0], Exact_minus());
    for (std::size_t i = 0; i < d; ++i) others[i] = &v[i];
    const auto centre = circumcentre_terms<d>(others);
    return dot<d>(v[d], v[d]) * centre.denominator == dot<d>(v[d], centre.numerator);
}

bool are_coplanar(const Corners<3>& x) {
    std::vector<double> numbers;
    for (const auto& p : x) numbers.insert(numbers.end(), p.begin(), p.end());
    const Scaled_integers exactly(numbers);
    const auto v = [&exactly](std::size_t i) {
        return Euclidean<3>::difference(&exactly.integer[3 * i], &exactly.integer[0], Exact_minus());
    };
    return sgn(Circumcentre_3<mpz_class>(v(1), v(2), v(3)).denominator) == 0;
}

template <int d>
Facet_measure<d> exact_facet(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells, Index i, Index j,
                             std::span<const Index> ring) {
    return Exact_ring<d>(points, cells, i, j, ring).measure();
}

template bool is_on_circumsphere<2>(const Corners<2>&, const Coordinates<2>&);
template bool is_on_circumsphere<3>(const Corners<3>&, const Coordinates<3>&);
template Facet_measure<2> exact_facet<2>(std::span<const Coordinates<2>>, const Mesh_cells<2>&, Index, Index,
                                         std::span<const Index>);
template Facet_measure<3> exact_facet<3>(std::span<const Coordinates<3>>, const Mesh_cells<3>&, Index, Index,
                                         std::span<const Index>);

}  // namespace annulus::inline v1
