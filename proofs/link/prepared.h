// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families.h"
#include "print.h"

#include <annulus/predicate/circumcircle_2.h>
#include <annulus/predicate/circumsphere_3.h>

#include <vector>

namespace annulus::link {

/// What a prepared circle or sphere keeps to itself, for the replay: an explicit instantiation may name private
/// members.
template <class Tag, typename Tag::Member member>
struct Opened {
    friend typename Tag::Member open(Tag) { return member; }
};
template <class Class, class Type, int number>
struct Inner {
    using Member = Type Class::*;
    friend Member open(Inner);
};
using Normal_2 = Inner<Circumcircle_2, Vector_2<double>, 0>;
using Area_2 = Inner<Circumcircle_2, double, 1>;
using Extent_2 = Inner<Circumcircle_2, double, 2>;
using Outside_2 = Inner<Circumcircle_2, double(const Coordinates<2>&, double&) const, 3>;
template struct Opened<Normal_2, &Circumcircle_2::normal_>;
template struct Opened<Area_2, &Circumcircle_2::twice_area_>;
template struct Opened<Extent_2, &Circumcircle_2::magnitude_>;
template struct Opened<Outside_2, &Circumcircle_2::outside_of>;

using Normal_3 = Inner<Circumsphere_3, Vector_3<double>, 0>;
using Volume_3 = Inner<Circumsphere_3, double, 1>;
using Extent_3 = Inner<Circumsphere_3, double, 2>;
using Outside_3 = Inner<Circumsphere_3, double(const Coordinates<3>&, double&) const, 3>;
template struct Opened<Normal_3, &Circumsphere_3::normal_>;
template struct Opened<Volume_3, &Circumsphere_3::determinant_>;
template struct Opened<Extent_3, &Circumsphere_3::magnitude_>;
template struct Opened<Outside_3, &Circumsphere_3::outside_of>;

/// One row: the corners and two points, what is prepared, the determinants with their m, and the answers for the
/// first point and for both.
template <class Outside, class Extent, class Sphere, class Point>
void write_answers(Row& row, const Sphere& k, const Point& p, const Point& r) {
    for (const Point& x : {p, r}) {
        double m = k.*open(Extent{});
        const double outside = (k.*open(Outside{}))(x, m);
        row.numbers({outside, m});
    }
    row.truth(k.positive());
    row.truth(k.excludes(p));
    row.truth(k.contains(p));
    row.truth(k.excludes_all(p, r));
}

inline void prepared_2(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const auto x = bicell_2(i);
        const Coordinates<2> r = bicell_2(i + 1)[2];
        const Circumcircle_2 k(x[0], x[1], x[3]);
        Row row("Prepared_2");
        row.points(std::array{x[0], x[1], x[3], x[2], r});
        const Vector_2<double>& n = k.*open(Normal_2{});
        row.numbers({n.x, n.y, k.*open(Area_2{}), k.*open(Extent_2{})});
        write_answers<Outside_2, Extent_2>(row, k, x[2], r);
    }
}

inline void prepared_3(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const auto x = bicell_3(i);
        const Coordinates<3> r = bicell_3(i + 1)[3];
        const Circumsphere_3 k(x[0], x[1], x[2], x[4]);
        Row row("Prepared_3");
        row.points(std::array{x[0], x[1], x[2], x[4], x[3], r});
        const Vector_3<double>& n = k.*open(Normal_3{});
        row.numbers({n.x, n.y, n.z, k.*open(Volume_3{}), k.*open(Extent_3{})});
        write_answers<Outside_3, Extent_3>(row, k, x[3], r);
    }
}

}  // namespace annulus::link
