// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle_3.h"

#include <algorithm>
#include <optional>

namespace annulus::testing {

namespace {

using Vector = std::array<mpq_class, 3>;

Vector from(const Point_3& origin, const Point_3& p) {
    Vector v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = mpq_class(p[k]) - mpq_class(origin[k]);
    return v;
}
mpq_class dot(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
Vector cross(const Vector& u, const Vector& v) {
    Vector n;
    for (std::size_t k = 0; k < 3; ++k) n[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    return n;
}

constexpr long precision = 500;

/// sqrt(x), rounded outward. A fraction of integers as large as fourth powers of doubles does not fit in a double.
Enclosure root_of(const mpq_class& x) {
    const auto enclosed = [](const mpz_class& z) {
        Enclosure e(0, precision);
        const std::size_t bits = mpz_sizeinbase(z.get_mpz_t(), 2);
        // Digits of 53 bits; what is beyond 500 bits is enclosed by the additions.
        const mpz_class base = mpz_class(1) << 53;
        for (std::size_t i = bits / 53 + 1; i-- > 0;) {
            const mpz_class digit = (z >> static_cast<mp_bitcnt_t>(53 * i)) % base;
            e = e * Enclosure(0x1p53, precision) + Enclosure(digit.get_d(), precision);
        }
        return e;
    };
    return (enclosed(x.get_num()) / enclosed(x.get_den())).root();
}

/// The point equally far from the points of each group relative to the origin, when there is just one.
std::optional<Vector> centre(const std::vector<Point_3>& one, const std::vector<Point_3>& other,
                             const Point_3& origin) {
    std::vector<Vector> row;
    std::vector<mpq_class> side;
    for (const auto* group : {&one, &other})
        for (std::size_t i = 1; i < group->size(); ++i) {
            const Vector first = from(origin, group->front()), p = from(origin, (*group)[i]);
            row.push_back(from(group->front(), (*group)[i]));
            side.emplace_back((dot(p, p) - dot(first, first)) / 2);
        }
    const Vector minors = cross(row[1], row[2]);
    const mpq_class det = dot(row[0], minors);
    if (det == 0) return std::nullopt;
    const Vector second = cross(row[2], row[0]), third = cross(row[0], row[1]);
    Vector c;
    for (std::size_t k = 0; k < 3; ++k) c[k] = (side[0] * minors[k] + side[1] * second[k] + side[2] * third[k]) / det;
    return c;
}

}  // namespace

void Truth_3::add_slab(const Point_3& low, const Point_3& high, const std::array<Point_3, 2>& u,
                       const std::array<Point_3, 2>& v) {
    const Vector n = cross(from(u[0], u[1]), from(v[0], v[1]));
    const mpq_class height = dot(n, from(low, high));
    slabs_.push_back({height * height, dot(n, n)});
}

bool Truth_3::is_at_least(double y) const {
    const mpq_class exact_y(y);
    const mpq_class y2 = exact_y * exact_y;
    for (const Slab& s : slabs_) {
        const mpq_class left = 4 * y2 * s.normal_2;
        if (left > s.height_2) return false;
    }
    for (const Annulus& a : annuli_) {
        // 2 y + sqrt(r2) <= sqrt(R2)  <=>  4 y sqrt(r2) <= R2 - r2 - 4 y^2
        const mpq_class rest = a.R2 - a.r2 - 4 * y2;
        const mpq_class left = 16 * y2 * a.r2;
        const mpq_class right = rest * rest;
        if (sgn(rest) < 0 || left > right) return false;
    }
    return true;
}

Enclosure Truth_3::enclosure() const {
    std::optional<Enclosure> least;
    const auto include = [&least](const Enclosure& e) { least = least ? least->least(e) : e; };
    for (const Slab& s : slabs_) {
        const mpq_class square = s.height_2 / s.normal_2;
        include(root_of(square).half());
    }
    for (const Annulus& a : annuli_) include((root_of(a.R2) - root_of(a.r2)).half());
    return *least;
}

Tetrahedron_truth::Tetrahedron_truth(const Tetrahedron& t) {
    sign_ = exact_orientation(t.a, t.b, t.c, t.d);
    if (sign_ == 0) return;
    const std::array<Point_3, 4> x{t.a, t.b, t.c, t.d};
    for (std::size_t i = 0; i < 4; ++i) {  // a facet and its vertex
        const Point_3 &j = x[(i + 1) % 4], &k = x[(i + 2) % 4], &l = x[(i + 3) % 4];
        add_slab(j, x[i], {j, k}, {j, l});
    }
    add_slab(t.a, t.b, {t.a, t.c}, {t.b, t.d});  // an edge and the opposite one
    add_slab(t.a, t.c, {t.a, t.b}, {t.c, t.d});
    add_slab(t.a, t.b, {t.a, t.d}, {t.b, t.c});
}

Annulus_truth::Annulus_truth(const Bicell_3& x, std::size_t partition) {
    sign_ = exact_empty_sphere(x.a, x.b, x.c, x.q, x.p);
    const std::array<std::array<std::vector<Point_3>, 2>, 4> groups{{{{{x.a, x.b, x.c}, {x.p, x.q}}},
                                                                     {{{x.a, x.b}, {x.c, x.p, x.q}}},
                                                                     {{{x.c, x.a}, {x.b, x.p, x.q}}},
                                                                     {{{x.b, x.c}, {x.a, x.p, x.q}}}}};
    const auto& [one, other] = groups[partition];
    if (const auto c = centre(one, other, x.a)) {
        const auto radius_2 = [&](const Point_3& p) {
            Vector v = from(x.a, p);
            for (std::size_t k = 0; k < 3; ++k) v[k] -= (*c)[k];
            return dot(v, v);
        };
        const mpq_class inner = radius_2(one.front()), outer = radius_2(other.front());
        forward_ = inner < outer;
        annuli_.push_back({std::min(inner, outer), std::max(inner, outer)});
        return;
    }
    // The centre is at infinity: two parallel planes.
    const auto& three = one.size() == 3 ? one : other;
    const auto& two = one.size() == 3 ? other : one;
    add_slab(one.front(), other.front(), {three[0], three[1]}, {three[0], three[2]});
    if (slabs_.back().normal_2 == 0)
        slabs_.pop_back(), add_slab(one.front(), other.front(), {three[0], three[1]}, {two[0], two[1]});
}

Bicell_3_truth::Bicell_3_truth(const Bicell_3& x, bool with_cells) {
    sign_ = exact_empty_sphere(x.a, x.b, x.c, x.q, x.p);
    const auto include = [this](const std::vector<Slab>& slabs, const std::vector<Annulus>& annuli) {
        slabs_.insert(slabs_.end(), slabs.begin(), slabs.end());
        annuli_.insert(annuli_.end(), annuli.begin(), annuli.end());
    };
    for (std::size_t k = 0; k < 4; ++k) {
        const Annulus_truth t(x, k);
        include(t.slabs_, t.annuli_);
    }
    if (!with_cells) return;
    for (const Tetrahedron& cell : {x.cell_p(), x.cell_q()}) {
        struct Opened : Tetrahedron_truth {
            using Tetrahedron_truth::Tetrahedron_truth;
            using Truth_3::slabs_;
        };
        include(Opened(cell).slabs_, {});
    }
}

}  // namespace annulus::testing
