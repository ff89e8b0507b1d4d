// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/input.h>
#include <apps/cli/print_degeneracy.h>

#include <apps/cli/counted_vertices.h>
#include <apps/formats/formatted.h>
#include <apps/formats/input_error.h>

#include <algorithm>
#include <cstdio>

namespace annulus::inline v1::cli {

namespace {

void print_counts(const char* name, std::uint64_t total, std::uint64_t zero, const std::vector<std::uint64_t>& below) {
    const auto count = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    std::printf("%-14s %11llu %11llu", name, count(total), count(zero));
    for (const std::uint64_t n : below) std::printf(" %11llu", count(n));
    std::printf("\n");
}

void print(const Degeneracy& d) {
    const auto count = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    const auto percent = [](std::uint64_t part, std::uint64_t all) {
        return 100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::uint64_t>(all, 1));
    };
    std::printf("mean spacing   %.6g; %s %.3g, %.3g spacings\n", d.spacing,
                d.periodic ? "ulp of the grid" : "ulp of the largest coordinate", d.resolution,
                d.resolution / d.spacing);
    std::printf("%-14s %11s %11s", "widths", "number", "exactly 0");
    for (const Threshold& t : d.thresholds) std::printf(" %11s", ("< " + t.name).c_str());
    std::printf("\n");
    const auto widths = [](const char* name, const Width_counts& c) { print_counts(name, c.total, c.zero, c.below); };
    widths("bi-cells", d.bicells.least);
    if (d.dimension == 3) widths("  paper's", d.standard);
    widths("cells", d.cells.least);
    if (!d.periodic) widths("hull ridges", d.ridges.least);
    print_counts("tolerances", d.vertices.total, d.vertices.zero, d.vertices.below);
    const auto median = [](const Distribution& q) { return q.quantiles.empty() ? 0.0 : q.quantiles[5]; };
    const std::string paper = d.periodic ? "" : formatted(", paper's tolerance %.4g", median(d.vertices.paper));
    std::printf("medians        width of bi-cells %.4g, certified tolerance %.4g%s, theta %.4g\n",
                median(d.bicells.least.width), median(d.vertices.certified), paper.c_str(), median(d.theta));
    std::printf("non-convex     %s (%.4g %%); with %s points %llu\n", counted(d.non_convex, "bi-cell").c_str(),
                percent(d.non_convex, d.bicells.least.total), d.dimension == 2 ? "three collinear" : "four coplanar",
                count(d.flat));
    const Vertex_counts& v = d.vertices;
    if (d.periodic) std::printf("periodic       no hull ridges; the paper's tolerances are not computed\n");
    else
        std::printf("paper          tolerance unsound at %s (%.4g %%), above the exact one at %llu (%.4g %%)\n",
                    counted_vertices(v.paper_unsound).c_str(), percent(v.paper_unsound, v.total),
                    count(v.paper_above_exact), percent(v.paper_above_exact, v.total));
    Stage_counts all = d.bicells.arithmetic;
    all += d.cells.arithmetic;
    all += d.ridges.arithmetic;
    std::printf("certificates   %llu decided: filter %llu, interval %llu, exact %llu\n", count(all.total()),
                count(all.filter), count(all.interval), count(all.exact));
}

}  // namespace

void print_degeneracy(const Degeneracy_record& r) {
    constexpr std::array simplex{"point", "edge", "triangle", "tetrahedron"};
    const bool tetrahedra = r.affine_dimension == 3 && r.simplices != 1;
    std::printf("%s in dimension %d, %s\n", counted(r.vertices, "point").c_str(), r.dimension,
                tetrahedra ? (std::to_string(r.simplices) + " tetrahedra").c_str()
                           : counted(r.simplices, simplex[static_cast<std::size_t>(r.affine_dimension)]).c_str());
    print_input(r.input, r.dimension);
    if (r.measured) print(*r.measured);
    else std::printf("flat           all points lie %s\n", r.affine_dimension == 2 ? "in a plane" : "on a line");
    std::printf("time           triangulation %.3f s, analysis %.3f s\n", r.seconds_triangulation, r.seconds_analysis);
}

void print_degeneracy_head(const Degeneracy_series& s) {
    std::printf("%12s %10s %10s", "frame", "points", "zero");
    for (const std::string& name : s.thresholds) std::printf(" %10s", ("< " + name).c_str());
    std::printf(" %12s %12s\n", "width", "tolerance");
}
void print_degeneracy(const Degeneracy_row& row) {
    const auto count = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    std::printf("%12llu %10llu", count(row.frame), count(row.vertices));
    if (!row.numbers) {
        std::printf(" flat\n");
        return;
    }
    std::printf(" %10llu", count(row.numbers->zero));
    for (const std::uint64_t n : row.numbers->below) std::printf(" %10llu", count(n));
    std::printf(" %12.4g %12.4g\n", row.numbers->width[2], row.numbers->tolerance[2]);
}

}  // namespace annulus::inline v1::cli
