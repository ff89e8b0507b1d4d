// SPDX-License-Identifier: GPL-3.0-or-later
// Bi-cells in 3D that are far from degenerate but that the filter does not decide: shows what the filter cannot decide.
// For each it evaluates the sign alone, the tolerance of the four annuli alone, and everything, which may include the
// signs of the sums of lambda.
//
// usage: example-wide_bicells [KIND POINTS SEED [DIGITS]]
//
// KIND, POINTS and SEED are those of `annulus generate`; coordinates are rounded to DIGITS after the point. Without
// arguments a small set of clusters. Wide: a width of 1e7 units in the last place of the largest coordinate, or more.
// docs/degeneracy.md quotes what it prints.
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/measure/degeneracy.h>
#include <annulus/predicate/filtered_3.h>
#include <apps/motion/generated_motion.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace annulus;
constexpr double wide = 1e7;

double rounded(double x, const char* digits) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", std::atoi(digits), x);
    return std::strtod(text, nullptr) + 0.0;
}

/// The longest distance between two of the points over the shortest.
double stretch(const Tuple<3, 5>& t) {
    double shortest = INFINITY, longest = 0;
    for (std::size_t i = 0; i < t.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const auto &x = *t[i], &y = *t[j];
            const double distance = std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
            shortest = std::min(shortest, distance);
            longest = std::max(longest, distance);
        }
    return longest / shortest;
}

/// A description of what decides a bi-cell.
std::string ways(const Tuple<3, 5>& t) {
    const Stage sign = evaluate_empty_sphere(t, false, Cell_widths::never).stage,
                annuli = evaluate_empty_sphere(t, true, Cell_widths::never).stage, all = evaluate_empty_sphere(t).stage;
    const auto side = annuli_exact(t).side;
    const bool zero = std::any_of(side.begin() + 1, side.end(), [](int s) { return s == 0; });
    return std::string(name_of(all)) + "; annuli alone: " + std::string(name_of(annuli)) +
           "; sign alone: " + std::string(name_of(sign)) + (zero ? "; a sum is exactly 0" : "");
}

int run(int argc, char** argv) {
    const auto family = family_named(point_families, argc > 3 ? argv[1] : "clusters");
    if (!family) return 2;
    std::vector<Coordinates<3>> x = generate<3>(*family, argc > 3 ? std::strtoul(argv[2], nullptr, 10) : 1000,
                                                argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
    if (argc > 4)
        for (auto& p : x)
            for (double& c : p) c = rounded(c, argv[4]);
    std::set<Coordinates<3>> seen;
    std::erase_if(x, [&seen](const auto& p) { return !seen.insert(p).second; });

    double largest = 0;
    for (const auto& p : x)
        for (const double c : p) largest = std::max(largest, std::fabs(c));
    const double ulp = std::nextafter(largest, INFINITY) - largest;
    Delaunay_mesh<3> mesh;
    mesh.build(x);
    std::map<std::string, std::vector<double>> found;  // stretches
    Degeneracy_options<3> options;
    options.raw = [&](const Raw_certificate<3>& c) {
        if (c.kind != Raw_certificate<3>::Kind::bicell || c.width_lower < wide * ulp) return;
        Tuple<3, 5> t{};
        for (std::size_t i = 0; i < t.size(); ++i) t[i] = &x[static_cast<std::size_t>(c.point[i])];
        found[ways(t)].push_back(stretch(t));
    };
    (void)degeneracy(mesh.table(), x, options);
    for (auto& [how, stretches] : found) {
        std::sort(stretches.begin(), stretches.end());
        std::printf("%8zu %s; longest over shortest distance: median %.3g\n", stretches.size(), how.c_str(),
                    stretches[stretches.size() / 2]);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "wide_bicells: %s\n", e.what());
        return 1;
    }
}
