// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cli/arguments.h>
#include <annulus/cli/commands.h>
#include <annulus/cli/result_files.h>
#include <annulus/cli/stopwatch.h>
#include <annulus/report/degeneracy_report.h>
#include <annulus/formats/read_points.h>
#include <annulus/formats/write_json.h>
#include <annulus/moving_delaunay_2.h>
#include <annulus/moving_delaunay_3.h>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace annulus::cli {

namespace {

struct Degeneracy_call {
    Common_arguments common;
    std::string file;
    int dimension = 0;  // that of the file
    bool ignore_z = false;
    std::string format;
};

template <class Embedding_of_cgal, int d>
Degeneracy_record study(const Point_file<d>& file) {
    Degeneracy_record r;
    r.file = file.name;
    r.dimension = d;
    r.points = file.points.size();
    const std::vector<Coordinates<d>> x = distinct_points(file, 2);
    r.vertices = x.size();
    const auto begin = Clock::now();
    Embedding_of_cgal embedding;
    embedding.build(x);
    r.seconds_triangulation = since(begin);
    const auto built = Clock::now();
    r.affine_dimension = embedding.dimension();
    embedding.for_each_finite_cell([&r](const auto&) { ++r.simplices; });
    if (r.affine_dimension == d) {
        embedding.mirror();
        r.measured = degeneracy(embedding.table(), x);
    }
    r.seconds_analysis = since(built);
    return r;
}

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
    std::printf("mean spacing   %.6g; ulp of the largest coordinate %.3g, %.3g spacings\n", d.spacing, d.resolution,
                d.resolution / d.spacing);
    std::printf("%-14s %11s %11s", "widths", "number", "exactly 0");
    for (const Threshold& t : d.thresholds) std::printf(" %11s", ("< " + t.name).c_str());
    std::printf("\n");
    const auto widths = [](const char* name, const Width_counts& c) { print_counts(name, c.total, c.zero, c.below); };
    widths("bi-cells", d.bicells.least);
    if (d.dimension == 3) widths("  paper's", d.standard);
    widths("cells", d.cells.least);
    widths("hull ridges", d.ridges.least);
    print_counts("tolerances", d.vertices.total, d.vertices.zero, d.vertices.below);
    const auto median = [](const Distribution& q) { return q.quantiles.empty() ? 0.0 : q.quantiles[5]; };
    std::printf("medians        width of bi-cells %.4g, certified tolerance %.4g, paper's tolerance %.4g, theta %.4g\n",
                median(d.bicells.least.width), median(d.vertices.certified), median(d.vertices.paper), median(d.theta));
    std::printf("non-convex     %llu bi-cells (%.4g %%); with %s points %llu\n", count(d.non_convex),
                percent(d.non_convex, d.bicells.least.total), d.dimension == 2 ? "three collinear" : "four coplanar",
                count(d.flat));
    const Vertex_counts& v = d.vertices;
    std::printf("paper          tolerance unsound at %llu vertices (%.4g %%), above the exact one at %llu (%.4g %%)\n",
                count(v.paper_unsound), percent(v.paper_unsound, v.total), count(v.paper_above_exact),
                percent(v.paper_above_exact, v.total));
    Stage_counts all = d.bicells.arithmetic;
    all += d.cells.arithmetic;
    all += d.ridges.arithmetic;
    std::printf("certificates   %llu decided: filter %llu, interval %llu, exact %llu\n", count(all.total()),
                count(all.filter), count(all.interval), count(all.exact));
}

void print(const Degeneracy_record& r) {
    constexpr std::array simplex{"point", "edge", "triangle", "tetrahedron"};
    const bool tetrahedra = r.affine_dimension == 3 && r.simplices != 1;
    std::printf("%s in dimension %d, %s\n", counted(r.vertices, "point").c_str(), r.dimension,
                tetrahedra ? (std::to_string(r.simplices) + " tetrahedra").c_str()
                           : counted(r.simplices, simplex[static_cast<std::size_t>(r.affine_dimension)]).c_str());
    if (r.measured) print(*r.measured);
    else std::printf("flat           all points lie %s\n", r.affine_dimension == 2 ? "in a plane" : "on a line");
    std::printf("time           triangulation %.3f s, analysis %.3f s\n", r.seconds_triangulation, r.seconds_analysis);
}

bool is_degeneracy(std::string_view name) { return name == "degeneracy.json" || name == "degeneracy.html"; }

int run(const Degeneracy_call& a, const std::string& command) {
    if (!a.common.output.empty()) require_writable(a.common, is_degeneracy);
    const Read_options options{.ignore_z = a.ignore_z, .format = a.format};
    std::variant<Point_file<2>, Point_file<3>> file;
    if (a.dimension == 2) file = read_points<2>(a.file, options);
    else if (a.dimension == 3) file = read_points<3>(a.file, options);
    else file = read_points_of_any_dimension(a.file, options);
    const auto* plane = std::get_if<Point_file<2>>(&file);
    Degeneracy_record r = plane != nullptr ? study<Cgal_embedding_2<No_info>>(*plane)
                                           : study<Cgal_embedding_3<No_info>>(std::get<Point_file<3>>(file));
    r.command = command;
    a.common.say_merged(r.file, r.points - r.vertices);
    std::visit([&](const auto& points) { a.common.say_notes(points.notes); }, file);
    if (!a.common.output.empty()) {
        Result_files out(a.common, is_degeneracy);
        out.write("degeneracy.json", write_json(degeneracy_json(r)));
        out.write("degeneracy.html", degeneracy_html(r));
        out.commit();
    }
    if (!a.common.quiet) {
        print(r);
        if (!a.common.output.empty()) std::printf("written to     %s\n", a.common.output.c_str());
    }
    return done;
}

}  // namespace

Run add_degeneracy_command(CLI::App& app, const Invocation& invocation) {
    auto* sub = app.add_subcommand(
        "degeneracy", "How degenerate points are: certified counts and distributions of their Delaunay triangulation");
    const auto a = std::make_shared<Degeneracy_call>();
    sub->add_option("FILE", a->file, "Points, .xyz, .csv, .lammpstrj, .off, .ply or .mesh; - is standard input")
        ->required();
    add_format(*sub, a->format, point_formats);
    auto* dimension = sub->add_option("--dim", a->dimension, "2 or 3; default: that of the file")
                          ->type_name("D")
                          ->check(whole_number(2, 3));
    sub->add_flag("--ignore-z", a->ignore_z, "Drop the z coordinate of the file");
    add_common(*sub, a->common, "degeneracy.json and degeneracy.html", false);
    return [a, dimension, command = command_line(invocation.words)] {
        if (a->ignore_z && dimension->count() > 0 && a->dimension == 3)
            throw Error(Error_code::usage, "--ignore-z and --dim 3 exclude each other");
        return run(*a, command);
    };
}

}  // namespace annulus::cli
