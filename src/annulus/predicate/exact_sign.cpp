// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/predicate/exact_sign.h>

#include <annulus/arithmetic/exact.h>
#include <annulus/predicate/integer_signs.h>
#include <annulus/predicate/interval_stage.h>
#include <annulus/predicate/later_stages.h>
#include <annulus/predicate/sphere_terms.h>

#include <optional>
#include <utility>

namespace annulus::inline v1 {

namespace {

template <class T>
T orientation(const Vector_2<T>& u, const Vector_2<T>& v) {
    return T(u.x * v.y - u.y * v.x);
}
template <class T>
T orientation(const Vector_3<T>& u, const Vector_3<T>& v, const Vector_3<T>& w) {
    return dot(cross(u, v), w);
}
/// Of the triangle 0, u, v and the point w.
template <class T>
T empty_sphere(const Vector_2<T>& u, const Vector_2<T>& w, const Vector_2<T>& v) {
    const auto triangle = sphere_terms(u, v);
    return sphere_determinant(triangle.normal, triangle.determinant, w);
}
/// Of the cell 0, u, v, t and the point w.
template <class T>
T empty_sphere(const Vector_3<T>& u, const Vector_3<T>& v, const Vector_3<T>& w, const Vector_3<T>& t) {
    const auto cell = sphere_terms(u, v, t);
    return sphere_determinant(cell.normal, cell.determinant, w);
}

/// Calls determinant(v_1, .., v_(k-1)) with vectors to the first point.
template <class T, std::size_t... i, class Vector, class Determinant>
T of_vectors(std::index_sequence<i...>, const Vector& vector, const Determinant& determinant) {
    return determinant(vector(i + 1)...);
}

/// By `integers`, which says nothing where the points span too many bits for it.
template <int d, int k, class Integers, class Determinant>
Staged_sign sign_of(const Tuple<d, k>& x, const Integers& integers, const Determinant& determinant) {
    if (const std::optional<int> decided = integers(scaled_points(x)))
        return {static_cast<std::int8_t>(*decided), Stage::exact};
    constexpr auto vectors = std::make_index_sequence<k - 1>();
    Staged_sign sign{0, Stage::exact, true};
    const auto interval = [&](std::size_t) {
        Certificate_value out;
        const bool decided = detail::with_scale(x, [&](const auto& difference, const detail::Scale&) {
            const auto to_first = [&](std::size_t i) { return detail::difference(x, i, 0, difference); };
            return detail::interval_sign(of_vectors<Interval>(vectors, to_first, determinant), out);
        });
        if (decided) sign = {out.sign, Stage::interval};
        return decided;
    };
    const auto exact = [&](std::size_t) {
        const Scaled_integers z(coordinates(x));
        const auto to_first = [&](std::size_t i) { return detail::difference<d>(z, i, 0); };
        sign.sign = static_cast<std::int8_t>(sgn(of_vectors<mpz_class>(vectors, to_first, determinant)));
    };
    (void)later_stages(
        1, [&](std::size_t) { return sign.stage == Stage::exact; }, interval, exact);
    return sign;
}

template <int d>
Staged_sign orientation_of(const Tuple<d, d + 1>& x) {
    return sign_of<d, d + 1>(
        x, [](const auto& p) { return integer_orientation<d>(p); }, [](const auto&... v) { return orientation(v...); });
}
template <int d>
Staged_sign empty_sphere_of(const Tuple<d, d + 2>& x) {
    return sign_of<d, d + 2>(
        x, [](const auto& p) { return integer_empty_sphere<d>(p); },
        [](const auto&... v) { return empty_sphere(v...); });
}

}  // namespace

Staged_sign exact_orientation_sign(const Tuple<2, 3>& x) { return orientation_of<2>(x); }
Staged_sign exact_orientation_sign(const Tuple<3, 4>& x) { return orientation_of<3>(x); }
Staged_sign exact_empty_sphere_sign(const Tuple<2, 4>& x) { return empty_sphere_of<2>(x); }
Staged_sign exact_empty_sphere_sign(const Tuple<3, 5>& x) { return empty_sphere_of<3>(x); }

}  // namespace annulus::inline v1
