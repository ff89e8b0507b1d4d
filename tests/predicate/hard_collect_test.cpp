// SPDX-License-Identifier: GPL-3.0-or-later
// Hard inputs of all families, and inputs at the limits of the stages: hidden; tests/data/hard/collect runs it.
#include "hard_case.h"

#include <support/catch.h>
#include <support/generators_3.h>

#include <annulus/predicate/margin.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <tuple>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

constexpr int cases_of_family = 3000;
constexpr int searches_of_family = 60;
constexpr int limits_of_family = 3;  // of each limit

/// The number kept of a family, by stage and sign. Few orientations are hard.
template <int d, std::size_t k>
constexpr std::size_t kept_of_family = is_orientation<d, k> ? 7 : 3;

Case<2, 3> points_of(const Triangle& t) { return {t.a, t.b, t.c}; }
Case<2, 4> points_of(const Bicell& c) { return {c.a, c.b, c.p, c.q}; }
Case<3, 4> points_of(const Tetrahedron& t) { return {t.a, t.b, t.c, t.d}; }
Case<3, 5> points_of(const Bicell_3& c) { return {c.a, c.b, c.c, c.p, c.q}; }

/// The condition of the filtered predicate for returning a tolerance.
bool is_legal(const Case<2, 3>&) { return true; }
bool is_legal(const Case<3, 4>&) { return true; }
bool is_legal(const Case<2, 4>& x) {
    return exact_orientation(x[0], x[1], x[3]) > 0 && exact_orientation(x[1], x[0], x[2]) > 0;
}
bool is_legal(const Case<3, 5>& x) {
    return exact_orientation(x[0], x[1], x[2], x[4]) > 0 && exact_orientation(x[1], x[0], x[2], x[3]) > 0;
}
template <int d, std::size_t k>
bool is_in_domain(const Case<d, k>& x) {
    for (const auto& p : x)
        for (const double c : p)
            if (!(std::fabs(c) <= 0x1p500)) return false;
    return true;
}

template <int d, std::size_t k>
void print(const char* source, std::string_view family, double key, const Case<d, k>& x, const Certificate_value& v) {
    std::string word(family);
    std::replace(word.begin(), word.end(), ' ', '_');
    std::printf("%s %s %s %s %d %a %a", std::string(certificate_name<d, k>()).c_str(), source, word.c_str(),
                std::string(name_of(v.stage)).c_str(), v.sign, key, v.tolerance);
    for (const auto& p : x)
        for (const double c : p) std::printf(" %a", c);
    std::printf("\n");
}

/// As in Hard_input, where there is a tolerance; else the filter's margin, and for degenerate inputs the size.
template <int d, std::size_t k>
double key_of(const Case<d, k>& x, const Certificate_value& v) {
    const auto t = tuple_of<d, k>(x);
    const double margin = std::fabs(filter_margin(t));
    if (v.sign > 0 && v.stage != Stage::filter) return 2 * v.tolerance / extent<d>(t);
    return v.sign != 0 && std::isfinite(margin) ? margin : extent<d>(t);
}

template <int d, std::size_t k, class Make>
void print_hardest(std::string_view family, Make make) {
    std::map<std::tuple<Stage, int>, std::map<double, Case<d, k>>> hardest;
    for (int i = 0; i < cases_of_family; ++i) {
        const Case<d, k> x = make();
        const Certificate_value v = filtered_value<d, k>(x);
        auto& of = hardest[{v.stage, v.sign}];
        of.emplace(key_of<d, k>(x, v), x);
        if (of.size() > kept_of_family<d, k>) of.erase(std::prev(of.end()));
    }
    for (const auto& [where, of] : hardest)
        for (const auto& [key, x] : of)
            print<d, k>(std::get<1>(where) == 0 ? "degenerate" : "family", family, key, x, filtered_value<d, k>(x));
}

/// Moves one coordinate from where the certificate holds to where it does not, and bisects for the last place at
/// which a stage not later than `last` decides and the first at which it does not.
template <int d, std::size_t k>
bool print_limit(std::string_view family, const Case<d, k>& from, Stage last, Random& random) {
    const auto decides = [last](const Certificate_value& v) { return v.sign > 0 && v.stage <= last; };
    Case<d, k> in = from, out = from;
    if (!decides(filtered_value<d, k>(in))) return false;
    double& c = out[random() % k][random() % static_cast<std::size_t>(d)];
    const std::size_t place = static_cast<std::size_t>(&c - &out[0][0]);
    double way = (random() % 2 == 0 ? 1 : -1) * 0x1p-20 * extent<d>(tuple_of<d, k>(from));
    const double start = c;
    for (int i = 0; i < 60 && decides(filtered_value<d, k>(out)); ++i, way *= 2) {
        c = start + way;
        if (!is_in_domain<d, k>(out) || !is_legal(out)) return false;
    }
    if (decides(filtered_value<d, k>(out))) return false;
    double& good = in[place / d][place % d];
    while (true) {
        const double middle = good / 2 + c / 2;
        if (middle == good || middle == c) break;
        Case<d, k> x = in;
        x[place / d][place % d] = middle;
        (decides(filtered_value<d, k>(x)) ? good : c) = middle;
    }
    const Certificate_value v = filtered_value<d, k>(in), w = filtered_value<d, k>(out);
    if (v.stage != last || w.sign <= 0 || !is_legal(in) || !is_legal(out)) return false;
    print<d, k>("limit", family, key_of<d, k>(in, v), in, v);
    print<d, k>("limit", family, key_of<d, k>(out, w), out, w);
    return true;
}

template <int d, std::size_t k, class Make>
void print_limits(std::string_view family, Make make, Random& random) {
    for (const Stage last : {Stage::filter, Stage::interval}) {
        int found = 0;
        for (int i = 0; i < searches_of_family && found < limits_of_family; ++i)
            found += print_limit<d, k>(family, make(), last, random);
    }
}

template <int d, std::size_t k, class Families, class Make>
void collect(const Families& families, Make make) {
    for (const auto family : families) {
        Random random(14);
        print_hardest<d, k>(name_of(family), [&] { return points_of(make(family, random)); });
        print_limits<d, k>(
            name_of(family), [&] { return points_of(make(family, random)); }, random);
    }
}

}  // namespace

TEST_CASE("Hard inputs of every family, and both sides of the limits of the stages, are printed", "[.hard]") {
    collect<2, 3>(all_triangle_families, [](Triangle_family f, Random& r) { return triangle(f, r); });
    collect<2, 4>(all_bicell_families, [](Bicell_family f, Random& r) { return bicell(f, r); });
    collect<3, 4>(all_families_3, [](Family_3 f, Random& r) { return tetrahedron(f, r); });
    collect<3, 5>(all_families_3, [](Family_3 f, Random& r) { return bicell(f, r); });
}
