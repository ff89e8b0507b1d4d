// SPDX-License-Identifier: GPL-3.0-or-later
// usage: traces SEED WORDS
//
// Histories of triangulations that move, in the plane and in space, under `tolerances` and `tolerances-each`: steps of
// all vertices, of some, of one, insertions, removals, tolerance_recomputations, calls that fail. Compiled with
// ANNULUS_TRACE the engine reports what it decided (trace.h); a line is what it reported of one history, as hexadecimal
// words, after two for the dimension and the bounds in use. Lines that begin with `table` are triangulations of the
// plane as they are after a call (audits.v). Ends when so many words have been written; on stderr how often what
// occurred.
#ifndef ANNULUS_TRACE
#error "the engine and this are to be compiled with ANNULUS_TRACE"
#endif
#include ANNULUS_TRACE

#include <annulus/arithmetic/limits.h>
#include <annulus/moving_delaunay_2.h>
#include <annulus/moving_delaunay_3.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numeric>
#include <random>
#include <string>

namespace {
using namespace annulus;

std::vector<std::vector<std::uint64_t>> tables;  // of the history that is lived
std::mt19937_64 generator;                       // NOLINT(cert-msc32-c,cert-msc51-cpp): seeded in main
std::uint64_t below(std::uint64_t n) { return generator() % n; }
/// In [-1, 1), with all its bits.
double unit() { return std::ldexp(static_cast<double>(static_cast<std::int64_t>(generator())), -63); }

template <int d>
struct History {
    using Mesh = std::conditional_t<d == 2, Moving_delaunay_2, Moving_delaunay_3>;
    using Point = Coordinates<d>;

    double scale = 1.0;
    double grid = 0.0;  // of coordinates, or 0
    std::vector<Point> points;
    std::map<std::string, int>& count;

    explicit History(std::map<std::string, int>& c) : count(c) {}

    double coordinate() {
        const double x = 0.75 * unit() + 0.5;
        return scale * (grid > 0.0 ? grid * std::floor(x / grid) : x);
    }
    Point somewhere() {
        Point p;
        for (double& c : p) c = coordinate();
        return p;
    }
    void wander(Point& p, double way) {
        for (double& c : p) c += scale * way * unit();
    }

    void live() {
        constexpr std::array scales{1.0, 1.0, 1.0, 1.0, 0x1p60, 0x1p-90, 0x1p-447};
        scale = scales[below(scales.size())];
        grid = below(4) == 0 ? 0.125 : 0.0;
        const bool large = below(8) == 0;
        const std::size_t n = d == 2 ? 4 + below(large ? 14 : 4) : 5 + below(large ? 6 : 3);
        while (points.size() < n) {
            const Point p = somewhere();
            if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
        }
        Options options;
        options.strategy = below(4) == 0 ? Strategy::tolerances_each : Strategy::tolerances;
        Trace::start<d>();
        Mesh mesh(std::span<const Point>(points), options);
        const double pace = std::ldexp(1.0, -4 - static_cast<int>(below(14)));
        const Point wind = [&] {
            Point p{};
            wander(p, pace);
            return p;
        }();
        const bool blows = below(3) == 0;
        const bool hops = below(12) == 0;  // one vertex: its path length grows fast
        const std::uint64_t calls = hops ? 40 : below(16) == 0 ? 60 : 4 + below(12);
        for (std::uint64_t k = 0; k < calls; ++k) {
            try {
                if (hops && below(8) != 0) move(mesh, 0, somewhere());
                else call(mesh, pace, blows ? wind : Point{});
            } catch (const Error&) {
                ++count["failed calls"];
                Trace::word(Trace::failed);
            }
            if constexpr (d == 2)
                if (k % 4 == 3 || k + 1 == calls) tell_table(mesh);
        }
    }

    // Moves, written once they have been made: of vertices that exist.
    static void write_requested(Mesh& mesh, std::span<const Index> movers, std::span<const Point> where) {
        std::map<Index, Point> requested;
        for (std::size_t k = 0; k < movers.size(); ++k)
            if (mesh.vertex(static_cast<std::size_t>(movers[k])) != typename Mesh::Vertex_handle())
                requested[movers[k]] = where[k];
        Trace::word(Trace::requested);
        Trace::word(requested.size());
        for (const auto& [v, p] : requested) {
            Trace::vertex(v);
            Trace::numbers(p);
        }
    }
    static void move(Mesh& mesh, Index v, const Point& p) {
        mesh.move(v, p);
        write_requested(mesh, std::span(&v, 1), std::span(&p, 1));
    }
    static void move_all(Mesh& mesh, const std::vector<Point>& x) {
        mesh.move_all(x);
        std::vector<Index> all(x.size());
        std::iota(all.begin(), all.end(), Index{0});
        write_requested(mesh, all, x);
    }

    /// How many points and their coordinates, how many cells and their corners; nothing while all points are on a line.
    static void tell_table(const Mesh& mesh) requires(d == 2) {
        const Audit_input<2> in = mesh.audit_input();
        if (in.cells.empty() || in.cells[0][2] == none) return;
        std::swap(Trace::words, tables.emplace_back());
        Trace::word(in.points.size());
        for (const Point& p : in.points) Trace::numbers(p);
        Trace::word(in.cells.size());
        for (const auto& c : in.cells)
            for (const Index v : c) Trace::vertex(v);
        std::swap(Trace::words, tables.back());
    }

    void call(Mesh& mesh, double pace, const Point& wind) {
        std::vector<Point> x(mesh.positions().begin(), mesh.positions().end());
        const auto someone = [&] { return static_cast<Index>(below(x.size())); };
        switch (below(40)) {
            case 0: {
                ++count["insertions"];
                mesh.insert(cgal(mesh, somewhere()));
                return;
            }
            case 1: {
                const auto v = mesh.vertex(static_cast<std::size_t>(someone()));
                if (v == typename Mesh::Vertex_handle() || mesh.number_of_vertices() < d + 4) return;
                ++count["removals"];
                mesh.remove(v);
                return;
            }
            case 2: mesh.recompute_tolerances(); return;
            case 3: move(mesh, someone(), x[static_cast<std::size_t>(someone())]); return;  // collides, as a rule
            case 4: {  // all to where one is, or nowhere
                x[static_cast<std::size_t>(someone())] = x[static_cast<std::size_t>(someone())];
                if (below(3) == 0) x[static_cast<std::size_t>(someone())][0] = below(2) == 0 ? std::nan("") : 0x1p1000;
                move_all(mesh, x);
                return;
            }
            case 5: {  // far
                move(mesh, someone(), somewhere());
                return;
            }
            case 6:
            case 7:
            case 8:
            case 9:
            case 10:
            case 11: {
                const Index v = someone();
                wander(x[static_cast<std::size_t>(v)], pace * std::ldexp(1.0, static_cast<int>(below(6)) - 2));
                move(mesh, v, x[static_cast<std::size_t>(v)]);
                return;
            }
            case 12:
            case 13: {
                std::vector<Index> movers{someone(), someone()};
                std::vector<Point> where{x[static_cast<std::size_t>(movers[0])],
                                         x[static_cast<std::size_t>(movers[1])]};
                for (Point& p : where) wander(p, pace);
                mesh.move(movers, where);
                write_requested(mesh, movers, where);
                return;
            }
            default: {
                const double way = pace * std::ldexp(1.0, static_cast<int>(below(4)) - 3);
                const std::uint64_t share = 1 + below(3);
                for (Point& p : x) {
                    for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) p[k] += wind[k];
                    if (below(share) == 0) wander(p, way);
                }
                move_all(mesh, x);
                return;
            }
        }
    }
    static auto cgal(Mesh&, const Point& p) {
        if constexpr (d == 2) return typename Mesh::Point(p[0], p[1]);
        else return typename Mesh::Point(p[0], p[1], p[2]);
    }
};

void write(const char* first, const std::vector<std::uint64_t>& words) {
    std::printf("%s", first);
    for (const std::uint64_t w : words) std::printf("%lx ", static_cast<unsigned long>(w));
    std::printf("\n");
}

template <int d>
void write_history(std::map<std::string, int>& count) {
    Trace::words.clear();
    for (const std::uint64_t w : {std::uint64_t{d}, std::uint64_t{Limits::listed(d)}, std::uint64_t{Limits::stamps},
                                  std::uint64_t{Limits::half_mask}, std::bit_cast<std::uint64_t>(Limits::path_ratio)})
        Trace::word(w);
    Trace::on = true;
    History<d>(count).live();
    Trace::word(0);  // the end
    Trace::on = false;
    write("", Trace::words);
    for (const auto& t : tables) write("table ", t);
    tables.clear();
}
}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    generator.seed(std::strtoull(argv[1], nullptr, 10));
    const std::uint64_t most = std::strtoull(argv[2], nullptr, 10);
    std::map<std::string, int> count;
    for (std::uint64_t words = 0; words < most; words += Trace::words.size()) {
        ++count["histories"];
        if (count["histories"] % 4 == 0) write_history<3>(count);
        else write_history<2>(count);
    }
    for (const auto& [what, n] : count) std::fprintf(stderr, "%d %s\n", n, what.c_str());
    return 0;
}
