// SPDX-License-Identifier: GPL-3.0-or-later
// The same certificates give the same bits with every compiler, at every level of optimisation and under sanitizers.
// Results are hashed and compared with stored hashes.
//
// The points come from integers and powers of two alone, for a cosine may differ from one library to the next.

#include <annulus/predicate/batch.h>
#include <annulus/predicate/circumcircle_2.h>
#include <annulus/predicate/circumsphere_3.h>
#include <annulus/predicate/filtered.h>
#include <annulus/predicate/half_width.h>
#include <annulus/predicate/tolerances.h>

#include <support/catch.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

using namespace annulus;

namespace {

/// FNV-1a over 64-bit words.
class Hash {
  public:
    void add(std::uint64_t word) {
        for (int i = 0; i < 64; i += 8) value_ = (value_ ^ (word >> i & 255U)) * 0x100000001b3U;
    }
    /// The sign of NaN is not hashed.
    void add(double x) { add(std::isnan(x) ? std::uint64_t{0} : std::bit_cast<std::uint64_t>(x)); }
    void add(const Certificate_value& v) {
        add(v.tolerance);
        add(static_cast<std::uint64_t>(v.sign + 1) << 16 | static_cast<std::uint64_t>(v.stage) << 8 | v.wrong_side);
    }
    void add(const Half_width& h) {
        add(h.lower);
        add(h.upper);
        add(static_cast<std::uint64_t>(h.stage));
    }
    void add(const Bicell_half_widths& h) {
        add(h.least);
        add(h.standard);
        add(std::uint64_t{h.standard_is_least});
    }
    [[nodiscard]] std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325U;
};

enum class Numbers { any, small_grid, near_grid, near_sphere, tiny, huge, subnormal, last };

/// n points of d coordinates.
template <int d, std::size_t n>
std::array<Coordinates<d>, n> points(Numbers kind, std::mt19937_64& random) {
    const auto integer = [&random](std::uint64_t below) { return static_cast<int>(random() % below); };
    const auto fraction = [&random] { return std::ldexp(static_cast<double>(random() >> 11), -53) - 0.5; };
    const int off = -10 - integer(43);
    std::array<Coordinates<d>, n> x;
    for (auto& p : x) {
        if (kind == Numbers::near_sphere) {  // permutations and signs of 1, 4, 8: norm 9
            constexpr std::array<std::array<int, 3>, 3> triples{{{1, 4, 8}, {4, 8, 1}, {8, 1, 4}}};
            constexpr std::array<std::array<int, 2>, 4> pairs{{{7, 24}, {24, 7}, {15, 20}, {20, 15}}};
            const auto which = static_cast<std::size_t>(integer(12));
            for (std::size_t k = 0; k < d; ++k) p[k] = d == 3 ? triples[which % 3][k] : pairs[which % 4][k % 2];
        }
        for (double& c : p) switch (kind) {
                case Numbers::any: c = fraction(); break;
                case Numbers::small_grid: c = integer(5); break;
                case Numbers::near_grid: c = integer(3) + std::ldexp(fraction(), off); break;
                case Numbers::near_sphere: c = (random() % 2 == 0 ? c : -c) + std::ldexp(fraction(), off); break;
                case Numbers::tiny: c = std::ldexp(fraction(), -400); break;
                case Numbers::huge: c = std::ldexp(fraction(), 490); break;
                default: c = std::ldexp(static_cast<double>(random() % 4096) - 2048, -1074); break;
            }
    }
    return x;
}

template <class Tuple_type, std::size_t n, std::size_t d>
Tuple_type tuple_of(const std::array<std::array<double, d>, n>& x) {
    Tuple_type t;
    for (std::size_t i = 0; i < n; ++i) t[i] = &x[i];
    return t;
}

template <class X, class... More>
void add_evaluated(Hash& hash, const std::vector<X>& x, More... more) {
    std::vector<Certificate_value> out(x.size());
    for (const Tolerance_precision mode : {Tolerance_precision::lower_bound, Tolerance_precision::approximate}) {
        evaluate(std::span<const X>(x), mode, out, more...);
        for (const Certificate_value& v : out) hash.add(v);
    }
}

/// All results for d + 1 and for d + 2 points.
template <int d>
std::uint64_t hash_of_certificates(std::size_t each) {
    Hash hash;
    std::mt19937_64 random(20);  // the engine is defined by the standard, bit for bit
    for (int kind = 0; kind < static_cast<int>(Numbers::last); ++kind) {
        std::vector<std::array<Coordinates<d>, d + 2>> points_of;
        for (std::size_t i = 0; i < each; ++i)
            points_of.push_back(points<d, d + 2>(static_cast<Numbers>(kind), random));
        std::vector<Tuple<d, d + 1>> simplices;
        std::vector<Tuple<d, d + 2>> bicells;
        for (const auto& x : points_of) {
            Tuple<d, d + 2> b = tuple_of<Tuple<d, d + 2>>(x);
            // q on the positive side of the facet; where p is on the wrong side this is not a bi-cell, but has a sign.
            Tuple<d, d + 1> cell;
            std::copy_n(b.begin(), d, cell.begin());
            cell[d] = b[d + 1];
            if (orientation_exact(cell).sign < 0) std::swap(b[0], b[1]), std::swap(cell[0], cell[1]);
            simplices.push_back(cell);
            Tuple<d, d + 1> other = cell;
            std::swap(other[0], other[1]);
            other[d] = b[d];
            if (orientation_exact(cell).sign > 0 && orientation_exact(other).sign > 0) bicells.push_back(b);
        }
        add_evaluated(hash, simplices);
        if constexpr (d == 2) {
            add_evaluated(hash, bicells);
        } else {
            for (const Cell_widths cells : {Cell_widths::never, Cell_widths::where_needed, Cell_widths::always})
                add_evaluated(hash, bicells, cells);
        }
        for (const auto& x : simplices) {
            hash.add(orientation_exact(x));
            hash.add(paper_slab(x));
            hash.add(paper_ridge(x));
        }
        for (const auto& x : bicells) {
            hash.add(empty_sphere_exact(x));
            hash.add(evaluate_sign_tolerance(x));
        }
        for (const Width which : {Width::least, Width::slab, Width::ridge}) {
            std::vector<Half_width> h(simplices.size());
            enclose(simplices, which, h);
            for (const Half_width& e : h) hash.add(e);
        }
        std::vector<Bicell_half_widths> h(bicells.size());
        enclose(bicells, h);
        for (const Bicell_half_widths& e : h) hash.add(e);
        for (const auto& x : bicells) {
            if constexpr (d == 2) {
                const Circumcircle_2 circle(*x[0], *x[1], *x[3]);
                hash.add(std::uint64_t{circle.positive()} << 1 | std::uint64_t{circle.excludes(*x[2])});
            } else {
                const Circumsphere_3 sphere(*x[0], *x[1], *x[2], *x[4]);
                hash.add(std::uint64_t{sphere.positive()} << 1 | std::uint64_t{sphere.excludes(*x[3])});
                hash.add(paper_annulus(x));
            }
        }
    }
    return hash.value();
}

}  // namespace

TEST_CASE("The certificates of the plane have the same bits whatever compiled them", "[certificate][bits]") {
    CHECK(hash_of_certificates<2>(600) == 0xbc046b9ad692b72dU);
}

TEST_CASE("The certificates of space have the same bits whatever compiled them", "[certificate][bits][space]") {
    CHECK(hash_of_certificates<3>(300) == 0xb5bb13810ed7b30aU);
}
