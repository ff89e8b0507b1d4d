// SPDX-License-Identifier: GPL-3.0-or-later
// The bounds of Reference_box against rational numbers.
#include <annulus/engine/reference_box.h>
#include <annulus/error.h>

#include <support/catch.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
using Matrix = std::array<Coordinates<d>, static_cast<std::size_t>(d)>;
template <int d>
using Exact_vector = std::array<mpq_class, static_cast<std::size_t>(d)>;
template <int d>
using Exact_matrix = std::array<Exact_vector<d>, static_cast<std::size_t>(d)>;

template <int d>
Exact_vector<d> exact(const Coordinates<d>& x) {
    Exact_vector<d> e;
    for (std::size_t i = 0; i < d; ++i) e[i] = mpq_class(x[i]);
    return e;
}
template <int d>
Exact_matrix<d> exact(const Matrix<d>& x) {
    Exact_matrix<d> e;
    for (std::size_t i = 0; i < d; ++i) e[i] = exact<d>(x[i]);
    return e;
}
template <int d>
Exact_vector<d> times(const Exact_matrix<d>& m, const Exact_vector<d>& x) {
    Exact_vector<d> y;
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t k = 0; k < d; ++k) y[i] += m[i][k] * x[k];
    return y;
}
template <int d>
Exact_matrix<d> times(const Exact_matrix<d>& a, const Exact_matrix<d>& b) {
    Exact_matrix<d> c;
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t j = 0; j < d; ++j)
            for (std::size_t k = 0; k < d; ++k) c[i][j] += a[i][k] * b[k][j];
    return c;
}
template <int d>
Exact_matrix<d> inverse(Exact_matrix<d> m) {  // by elimination
    Exact_matrix<d> w;
    for (std::size_t i = 0; i < d; ++i) w[i][i] = 1;
    for (std::size_t i = 0; i < d; ++i) {
        std::size_t pivot = i;
        while (m[pivot][i] == 0) ++pivot;
        std::swap(m[i], m[pivot]);
        std::swap(w[i], w[pivot]);
        const mpq_class by = m[i][i];
        for (std::size_t k = 0; k < d; ++k) m[i][k] /= by, w[i][k] /= by;
        for (std::size_t r = 0; r < d; ++r) {
            if (r == i) continue;
            const mpq_class less = m[r][i];
            for (std::size_t k = 0; k < d; ++k) m[r][k] -= less * m[i][k], w[r][k] -= less * w[i][k];
        }
    }
    return w;
}
template <int d>
Exact_matrix<d> transposed(const Exact_matrix<d>& m) {
    Exact_matrix<d> t;
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t j = 0; j < d; ++j) t[i][j] = m[j][i];
    return t;
}
template <int d>
mpq_class squared(const Exact_vector<d>& x) {
    mpq_class sum = 0;
    for (const mpq_class& c : x) sum += c * c;
    return sum;
}

/// Not above e^x.
mpq_class exponential_lower(const mpq_class& x) {
    mpq_class sum = 1, term = 1;
    for (int k = 1; k < 30; ++k) {
        term *= x / k;
        sum += term;
    }
    return sum;
}

/// Eigenvectors of X^T X, nearly, by Jacobi's rotations: the quotients below are off by the square of their errors.
template <int d>
Matrix<d> principal_directions(const Matrix<d>& x) {
    Matrix<d> g{}, v{};
    for (std::size_t i = 0; i < d; ++i) v[i][i] = 1;
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t j = 0; j < d; ++j)
            for (std::size_t k = 0; k < d; ++k) g[i][j] += x[k][i] * x[k][j];
    for (int sweep = 0; sweep < 40; ++sweep)
        for (std::size_t i = 0; i < d; ++i)
            for (std::size_t j = i + 1; j < d; ++j) {
                if (g[i][j] == 0) continue;
                const double angle = 0.5 * std::atan2(2 * g[i][j], g[j][j] - g[i][i]);
                const double c = std::cos(angle), s = std::sin(angle);
                for (std::size_t k = 0; k < d; ++k) {
                    const double p = g[k][i], q = g[k][j];
                    g[k][i] = c * p - s * q, g[k][j] = s * p + c * q;
                }
                for (std::size_t k = 0; k < d; ++k) {
                    const double p = g[i][k], q = g[j][k];
                    g[i][k] = c * p - s * q, g[j][k] = s * p + c * q;
                }
                for (std::size_t k = 0; k < d; ++k) {
                    const double p = v[i][k], q = v[j][k];
                    v[i][k] = c * p - s * q, v[j][k] = s * p + c * q;
                }
            }
    return v;
}
template <int d>
Matrix<d> rounded(const Exact_matrix<d>& m) {
    Matrix<d> x;
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t j = 0; j < d; ++j) x[i][j] = m[i][j].get_d();
    return x;
}

/// The greatest quotient of squared lengths' factors, of the principal directions, exactly.
template <int d>
mpq_class quotient(const Exact_matrix<d>& x) {
    mpq_class least, most;
    bool first = true;
    for (const Coordinates<d>& direction : principal_directions<d>(rounded<d>(x))) {
        const Exact_vector<d> v = exact<d>(direction);
        const mpq_class factor = squared<d>(times<d>(x, v)) / squared<d>(v);
        least = first ? factor : std::min(least, factor);
        most = first ? factor : std::max(most, factor);
        first = false;
    }
    return most / least;
}

template <int d>
void expect_bound(const Exact_matrix<d>& x, double bound) {
    const mpq_class q = quotient<d>(x);
    CHECK(q <= exponential_lower(4 * mpq_class(bound)));
    const double truth = 0.25 * std::log1p(mpq_class(q - 1).get_d());
    CHECK(bound <= 2 * truth + 0.1 * truth + 1e-14);  // in 3D the norm is estimated
}

template <int d>
Matrix<d> strained(Periodic_cases& cases, double most, bool scaled) {
    Matrix<d> x{};
    const double scale = scaled ? cases.uniform(0.5, 2) : 1;
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t j = 0; j < d; ++j) x[i][j] = scale * ((i == j ? 1 : 0) + cases.uniform(-most, most));
    return x;
}

template <int d>
void expect_deviation_bounds() {
    Periodic_cases cases(17 + d);
    for (int k = 0; k < repeats(300); ++k) {
        const Matrix<d> x = strained<d>(cases, std::exp2(cases.uniform(-45, -4)), k % 2 == 0);
        CAPTURE(x);
        expect_bound<d>(exact<d>(x), deviation_upper<d>(x, 0));
    }
    for (int k = 0; k < repeats(100); ++k) {  // of one that is off
        const double off = std::exp2(cases.uniform(-40, -8));
        const Matrix<d> x = strained<d>(cases, 0.02, false);
        Matrix<d> y = x;
        y[cases.below(d)][cases.below(d)] += off * (k % 3 - 1);
        CHECK(quotient<d>(exact<d>(y)) <= exponential_lower(4 * mpq_class(deviation_upper<d>(x, off * (1 + 0x1p-40)))));
    }
    Matrix<d> isotropic{};
    for (std::size_t i = 0; i < d; ++i) isotropic[i][i] = 1.37;
    CHECK(deviation_upper<d>(isotropic, 0) < 1e-14);
    isotropic[0][0] = 0;
    CHECK(!(deviation_upper<d>(isotropic, 0) < 1));
}

template <int d>
void expect_rigidity() {
    Periodic_cases cases(5 + d);
    int rigid = 0, other = 0;
    for (int k = 0; k < 300; ++k) {
        const Matrix<d> x = strained<d>(cases, 0.03, false);
        const bool said = is_nearly_rigid<d>(x);
        ++(said ? rigid : other);
        if (!said) continue;
        const Exact_matrix<d> e = exact<d>(x);
        for (const Coordinates<d>& direction : principal_directions<d>(x)) {
            const Exact_vector<d> v = exact<d>(direction);
            const mpq_class factor = squared<d>(times<d>(e, v)) / squared<d>(v);
            CHECK(factor > mpq_class(31 * 31, 32 * 32));
            CHECK(factor < mpq_class(33 * 33, 32 * 32));
        }
    }
    CHECK((rigid > 20 && other > 20));
    Matrix<d> x{};
    for (std::size_t i = 0; i < d; ++i) x[i][i] = 33.001 / 32;
    CHECK(!is_nearly_rigid<d>(x));
    for (std::size_t i = 0; i < d; ++i) x[i][i] = 30.999 / 32;
    CHECK(!is_nearly_rigid<d>(x));
}

/// Box vectors times a matrix.
template <int d>
typename Box<d>::Vectors deformed(const typename Box<d>::Vectors& box, const Matrix<d>& by) {
    auto v = box;
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t i = 0; i < d; ++i) {
            v[j][i] = 0;
            for (std::size_t k = 0; k < d; ++k) v[j][i] += by[i][k] * box[j][k];
        }
    return v;
}

/// Whether the basis is the other one, deformed: no other basis of the lattice.
template <int d>
bool corresponds(const Lattice<d>& one, const Lattice<d>& other) {
    for (std::size_t j = 0; j < d; ++j) {
        const Coordinates<d> f = one.in_basis(other.basis()[j]);
        for (std::size_t i = 0; i < d; ++i)
            if (std::fabs(f[i] - (i == j ? 1 : 0)) > 0.4) return false;
    }
    return true;
}

struct Followed {
    int all = 0, followed = 0;
};

/// A box that is deformed step by step, and sites seen at the steps.
template <int d>
Followed expect_box_to_be_followed(int kind, double most, std::uint64_t seed) {
    CAPTURE(d, kind, most, seed);
    Periodic_cases cases(seed);
    auto vectors = cases.box<d>(kind).vectors();
    const Lattice<d> first(vectors);
    Reference_box<d> box;
    box.begin(first);
    CHECK(box.deviation_upper() == 0);
    Followed count;
    double before = 0;
    Exact_matrix<d> last = transposed<d>(exact<d>(first.basis()));
    for (int step = 0; step < 6; ++step) {
        vectors = deformed<d>(vectors, strained<d>(cases, most, false));
        const Lattice<d> lattice(vectors);
        if (!corresponds<d>(first, lattice)) break;
        ++count.all;
        if (!box.follow(lattice)) break;
        ++count.followed;
        CHECK(box.deviation_upper() >= before);
        // A = L L0^-1 of vectors as columns.
        const Exact_matrix<d> l = transposed<d>(exact<d>(lattice.basis())), l0 = transposed<d>(exact<d>(first.basis()));
        const mpq_class more = mpq_class(box.deviation_upper()) - mpq_class(before) + mpq_class(1e-13);
        CHECK(quotient<d>(times<d>(l, inverse<d>(last))) <= exponential_lower(4 * more));
        before = box.deviation_upper();
        last = l;
        const Exact_matrix<d> a = times<d>(l, inverse<d>(l0));
        CHECK(quotient<d>(a) <= exponential_lower(4 * mpq_class(box.deviation_upper() + 1e-13)));
        for (int k = 0; k < 4; ++k) {
            Shift<d> o;
            for (auto& c : o) c = static_cast<std::int32_t>(cases.below(21)) - 10;
            Coordinates<d> p = cases.point<d>(Box<d>(vectors), 1);
            for (std::size_t i = 0; i < d; ++i) p[i] = std::nearbyint(p[i] / lattice.grid()[i]) * lattice.grid()[i];
            // The co-moving place, with an offset, is the one of the moved place, up to an error; and nearly the truth.
            Exact_vector<d> with_offset = exact<d>(box.comoving(p)), anchored = exact<d>(box.anchor(p));
            Exact_vector<d> moved = exact<d>(p);
            for (std::size_t j = 0; j < d; ++j)
                for (std::size_t i = 0; i < d; ++i) {
                    with_offset[i] += o[j] * l0[i][j];
                    anchored[i] += o[j] * l0[i][j];
                    moved[i] += o[j] * l[i][j];
                }
            const Exact_vector<d> truth = times<d>(inverse<d>(a), moved);
            Exact_vector<d> off, off_anchored;
            for (std::size_t i = 0; i < d; ++i)
                off[i] = with_offset[i] - truth[i], off_anchored[i] = anchored[i] - truth[i];
            const mpq_class most_off = mpq_class(box.error_upper()) / 2;
            CHECK(squared<d>(off) <= most_off * most_off);
            CHECK(squared<d>(off_anchored) <= most_off * most_off);
            // Relabelled, an anchor is exactly where its site was.
            const Exact_vector<d> back = exact<d>(box.relabelled(box.anchor(p), Offset<d>(o)));
            for (std::size_t i = 0; i < d; ++i) {
                mpq_class expected = mpq_class(box.anchor(p)[i]);
                for (std::size_t j = 0; j < d; ++j) expected -= o[j] * l0[i][j];
                CHECK(back[i] == expected);
            }
        }
    }
    return count;
}

template <int d>
void expect_boxes_to_be_followed() {
    Followed small, large;
    for (int k = 0; k < repeats(60); ++k) {
        const int kind = k % Periodic_cases::kinds;
        if (kind == 8) continue;  // thin ones in any direction need not be
        const Followed s = expect_box_to_be_followed<d>(kind, 1e-3, static_cast<std::uint64_t>(k));
        small.all += s.all, small.followed += s.followed;
        const Followed l = expect_box_to_be_followed<d>(kind, 0.05, static_cast<std::uint64_t>(k));
        large.all += l.all, large.followed += l.followed;
    }
    CHECK(small.followed == small.all);
    CHECK(small.all > repeats(60) * 3);
    CHECK(large.followed < large.all);
}

}  // namespace

TEST_CASE("deviation_upper is an upper bound, and not much more", "[engine][periodic]") {
    expect_deviation_bounds<2>();
    expect_deviation_bounds<3>();
}

TEST_CASE("a map is nearly rigid where its singular values are within a thirty-second of 1", "[engine][periodic]") {
    expect_rigidity<2>();
    expect_rigidity<3>();
}

TEST_CASE("Reference_box follows a box that is deformed, with sites that are where they should be up to its error",
          "[engine][periodic]") {
    expect_boxes_to_be_followed<2>();
    expect_boxes_to_be_followed<3>();
}

TEST_CASE("Reference_box counts nothing where the box stays, or is strained in all directions alike, or turned",
          "[engine][periodic]") {
    const auto vectors = Box<3>::orthorhombic({1, 1.5, 0.75}).vectors();
    Reference_box<3> box;
    box.begin(Lattice<3>(vectors));
    CHECK(box.follow(Lattice<3>(vectors)));
    CHECK(box.deviation_upper() == 0);
    const Coordinates<3> p{0.25, 0.5, 0.125};
    CHECK(box.comoving(p) == p);
    auto larger = vectors;
    for (auto& row : larger)
        for (double& c : row) c *= 1.015625;
    CHECK(box.follow(Lattice<3>(larger)));
    CHECK(box.deviation_upper() < 1e-13);
    auto turned = larger;
    for (auto& row : turned) {
        const double x = row[0];
        row[0] = std::cos(0.3) * x - std::sin(0.3) * row[1];
        row[1] = std::sin(0.3) * x + std::cos(0.3) * row[1];
    }
    CHECK(box.follow(Lattice<3>(turned)));
    CHECK(box.deviation_upper() < 1e-13);
    for (auto& row : turned)
        for (double& c : row) c *= 1.03;
    CHECK(!box.follow(Lattice<3>(turned)));
}

TEST_CASE("Reference_box counts what a box is deformed that turns under a load, and nothing where it turns with it",
          "[engine][periodic]") {
    const auto turned = [](double angle) {
        return Matrix<3>{{{std::cos(angle), -std::sin(angle), 0}, {std::sin(angle), std::cos(angle), 0}, {0, 0, 1}}};
    };
    const Matrix<3> load{{{1.02, 0, 0}, {0, 0.98, 0}, {0, 0, 1}}};
    const auto cube = Box<3>::orthorhombic({1, 1, 1}).vectors();
    Reference_box<3> box, along;
    for (Reference_box<3>* each : {&box, &along}) {
        each->begin(Lattice<3>(cube));
        REQUIRE(each->follow(Lattice<3>(deformed<3>(cube, load))));
    }
    const double loaded = box.deviation_upper();
    for (int k = 1; k <= 10; ++k) {
        REQUIRE(box.follow(Lattice<3>(deformed<3>(deformed<3>(cube, turned(0.05 * k)), load))));
        REQUIRE(along.follow(Lattice<3>(deformed<3>(deformed<3>(cube, load), turned(0.05 * k)))));
    }
    CHECK(box.deviation_upper() > loaded + 0.01);
    CHECK(along.deviation_upper() < loaded + 1e-13);
}
