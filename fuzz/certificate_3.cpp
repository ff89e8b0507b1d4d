// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes -> five points in 3D -> every stage of the filtered predicate compared with rational arithmetic: signs, and on
// which side of the half width a tolerance is. A find is printed as the five points.
#include "common/decode.h"
#include "common/rational_3.h"
#include "common/value_fault.h"

#include <annulus/predicate/batch.h>
#include <annulus/predicate/half_width.h>

#include <annulus/arithmetic/rounding_guard.h>

#include <cstdlib>
#include <iostream>

namespace {

using namespace annulus;
using oracle::fault_of;

std::string check(const std::vector<Coordinates<3>>& x) {
    for (const auto& p : x)
        for (const double c : p)
            if (!(std::fabs(c) <= 0x1p500)) return {};
    const Tuple<3, 4> cell{&x[0], &x[1], &x[2], &x[4]};
    const Tuple<3, 4> other{&x[1], &x[0], &x[2], &x[3]};
    for (const Tuple<3, 4>& t : {cell, other}) {
        const oracle::Half_width_3 truth = oracle::simplex(t);
        for (const Certificate_value& v : {evaluate_orientation(t), orientation_exact(t)})
            if (const std::string f = fault_of(v, truth); !f.empty()) return "orientation: " + f;
        std::array<Half_width, 1> h;
        enclose(std::span(&t, 1), Width::least, h);
        for (const Half_width& e : {h[0], enclose_exactly(t, Width::least)})
            if (const std::string f = fault_of(e, truth); !f.empty()) return "width: " + f;
    }
    const Tuple<3, 5> bicell{&x[0], &x[1], &x[2], &x[3], &x[4]};
    const auto positive = [](const Tuple<3, 4>& t) { return oracle::simplex(t).sign() > 0; };
    if (!positive(cell) || !positive(other)) return {};
    const oracle::Half_width_3 least = oracle::least_annulus(bicell);
    const oracle::Half_width_3 with_cells = oracle::least_annulus_and_cells(bicell);
    std::array<Certificate_value, 1> batch;
    evaluate(std::span(&bicell, 1), Tolerance_precision::lower_bound, batch, Cell_widths::always);
    for (const Certificate_value& v : {evaluate_empty_sphere(bicell, true, Cell_widths::always), batch[0],
                                       empty_sphere_exact(bicell, Cell_widths::always)})
        if (const std::string f = fault_of(v, with_cells); !f.empty()) return "empty sphere and cells: " + f;
    for (const Certificate_value& v :
         {evaluate_empty_sphere(bicell, true, Cell_widths::never), empty_sphere_exact(bicell, Cell_widths::never)})
        if (const std::string f = fault_of(v, least); !f.empty()) return "empty sphere: " + f;
    const Certificate_value needed = evaluate_empty_sphere(bicell);
    if (needed.sign > 0 && !least.is_at_least(needed.tolerance)) return "empty sphere, cells where needed";
    std::array<Bicell_half_widths, 1> h;
    enclose(std::span(&bicell, 1), h);
    for (const Bicell_half_widths& e : {h[0], enclose_exactly(bicell)}) {
        if (const std::string f = fault_of(e.least, least); !f.empty()) return "least annulus: " + f;
        if (const std::string f = fault_of(e.standard, oracle::standard_annulus(bicell)); !f.empty())
            return "standard annulus: " + f;
    }
    return {};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    annulus::oracle::Decoder decoder(std::span(data, size));
    const auto x = decoder.points<3>(5);
    const std::string fault = check(x);
    if (fault.empty()) return 0;
    std::cerr << "// " << fault << "\n{" << annulus::oracle::points_as_code(x) << "}\n";
    std::abort();
}
