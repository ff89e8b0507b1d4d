// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes -> four points in 2D -> every stage of the filtered predicate compared with rational arithmetic: signs, and on
// which side of the half width a tolerance is; also enclosures, prepared circles (many points against one), and
// the perturbation. A find is printed as the four points.
#include "common/decode.h"
#include "common/rational_2.h"
#include "common/value_fault.h"

#include <annulus/predicate/batch.h>
#include <annulus/predicate/circumcircle_2.h>
#include <annulus/predicate/half_width.h>
#include <annulus/predicate/perturbed_sign.h>
#include <annulus/predicate/tolerances.h>

#include <cstdlib>
#include <iostream>

namespace {

using namespace annulus;
using oracle::fault_of;

std::string check_triangle(const Tuple<2, 3>& t) {
    const oracle::Half_width_3 truth = oracle::simplex(t);
    std::array<Certificate_value, 1> batch;
    evaluate(std::span(&t, 1), Tolerance_precision::lower_bound, batch);
    for (const Certificate_value& v : {evaluate_orientation(t), batch[0], orientation_exact(t)})
        if (const std::string f = fault_of(v, truth); !f.empty()) return "orientation: " + f;
    if (evaluate_orientation(t, false).sign != truth.sign()) return "orientation without certification: sign";
    for (const Width which : {Width::least, Width::slab, Width::ridge}) {
        std::array<Half_width, 1> h;
        enclose(std::span(&t, 1), which, h);
        const oracle::Half_width_3 half = which == Width::least ? truth : oracle::altitude(t);
        for (const Half_width& e : {h[0], enclose_exactly(t, which)})
            if (const std::string f = fault_of(e, half); !f.empty()) return "width: " + f;
    }
    if (Circumcircle_2(*t[0], *t[1], *t[2]).positive() && truth.sign() <= 0) return "a circle of no positive triangle";
    return {};
}

/// Both triangles are positive.
std::string check_bicell(const Tuple<2, 4>& x) {
    const oracle::Half_width_3 truth = oracle::annulus_2(x);
    std::array<Certificate_value, 1> batch;
    evaluate(std::span(&x, 1), Tolerance_precision::lower_bound, batch);
    for (const Certificate_value& v : {evaluate_empty_sphere(x), batch[0], empty_sphere_exact(x)})
        if (const std::string f = fault_of(v, truth); !f.empty()) return "empty circle: " + f;
    if (evaluate_empty_sphere(x, false).sign != truth.sign()) return "empty circle without certification: sign";
    oracle::Half_width_3 with_cells = truth;
    with_cells.add(oracle::simplex({x[0], x[1], x[3]}));
    with_cells.add(oracle::simplex({x[1], x[0], x[2]}));
    if (const std::string f = fault_of(evaluate_sign_tolerance(x), with_cells, oracle::Made_of::several); !f.empty())
        return "circle and triangles: " + f;
    if (const std::string f = fault_of(evaluate_sign_tolerance(x, Tolerance_precision::correctly_rounded), with_cells);
        !f.empty())
        return "circle and triangles, tight: " + f;
    std::array<Bicell_half_widths, 1> h;
    enclose(std::span(&x, 1), h);
    for (const Bicell_half_widths& e : {h[0], enclose_exactly(x)})
        for (const Half_width& end : {e.least, e.standard})
            if (const std::string f = fault_of(end, truth); !f.empty()) return "annulus: " + f;

    for (const bool turned : {false, true}) {
        const Circumcircle_2 circle(*x[turned ? 1 : 0], *x[turned ? 0 : 1], *x[turned ? 2 : 3]);
        if (circle.positive() && circle.excludes(*x[turned ? 3 : 2]) && truth.sign() <= 0)
            return "a circle excludes what is not outside";
    }
    // Cocircular: exactly one of the two diagonals where the four points are in convex position.
    if (truth.sign() == 0) {
        const Tuple<2, 4> flipped{x[2], x[3], x[1], x[0]};
        const int sign = perturbed_sign(x);
        if (sign != 1 && sign != -1) return "the perturbed sign is none";
        if (perturbed_sign(flipped) != -sign) return "both diagonals are chosen, or neither";
    }
    return {};
}

std::string check(const std::vector<Coordinates<2>>& x) {
    for (const auto& p : x)
        for (const double c : p)
            if (!(std::fabs(c) <= 0x1p500)) return {};
    const Tuple<2, 3> left{&x[0], &x[1], &x[3]}, right{&x[1], &x[0], &x[2]};
    for (const Tuple<2, 3>& t : {left, right})
        if (const std::string f = check_triangle(t); !f.empty()) return f;
    if (oracle::turn(*left[0], *left[1], *left[2]) <= 0 || oracle::turn(*right[0], *right[1], *right[2]) <= 0)
        return {};
    return check_bicell({&x[0], &x[1], &x[2], &x[3]});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    annulus::oracle::Decoder decoder(std::span(data, size));
    const auto x = decoder.points<2>(4);
    const std::string fault = check(x);
    if (fault.empty()) return 0;
    std::cerr << "// " << fault << "\n{" << annulus::oracle::points_as_code(x) << "}\n";
    std::abort();
}
