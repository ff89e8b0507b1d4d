// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/initial_mesh_3.h>

#include <annulus/error.h>
#include <apps/motion/mesh_domain_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_domain_with_polyline_features_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Random.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/make_mesh_3.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>
#include <string>
#include <unordered_set>

namespace annulus::inline v1 {

namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The same with curves and corners on which vertices are placed; there are none unless they are added.
using Sharp_domain = CGAL::Mesh_domain_with_polyline_features_3<Mesh_domain_3>;

void add(Sharp_domain& domain, const Feature_curves& sharp) {
    std::vector<K::Point_3> corners;
    for (const auto& c : sharp.corners()) corners.push_back(domain.inside(c));
    std::vector<std::vector<K::Point_3>> curves;
    for (const auto& c : sharp.curves()) {
        curves.emplace_back();
        for (const auto& p : c.points()) curves.back().push_back(domain.inside(p));
    }
    domain.add_corners(corners.begin(), corners.end());
    domain.add_features(curves.begin(), curves.end());
}

struct Field {
    using FT = K::FT;
    using Point_3 = K::Point_3;
    using Index = Sharp_domain::Index;
    const Sizing_3* sizing;
    const Mesh_domain_3* domain;
    double size;
    FT operator()(const Point_3& p, int, const Index&) const { return size * sizing->at(domain->outside(p)); }
};

using Triangulation = CGAL::Mesh_triangulation_3<Sharp_domain>::type;
/// A class of this namespace, so that lookup finds `dump_c3t3` below.
struct Complex
    : CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Sharp_domain::Corner_index, Sharp_domain::Curve_index> {};
/// Mesh_3 writes a file named dump-bug before some of its failures. This overload writes none: the failures are caught.
[[maybe_unused]] void dump_c3t3(const Complex&, const std::string&) {}
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

/// Criteria for shapes. Refinement for angles of facets and cells need not terminate next to sharp edges, which Mesh_3
/// has not been given: vertices come closer and closer, until points coincide and it throws. The last of these criteria
/// has sizes and distances only, so that every new vertex keeps a distance from the others.
struct Shapes {
    double angle;        ///< of facets, at least, in degrees
    double radius_edge;  ///< of cells, at most; 0 is any
};
constexpr std::array<Shapes, 3> shapes{{{25, 2}, {0, 2}, {0, 0}}};

/// CGAL writes warnings to standard error. Here each of these cases is either handled or an exception.
class Silence {
  public:
    Silence() : warning_(CGAL::set_warning_handler(nothing)), error_(CGAL::set_error_handler(nothing)) {}
    ~Silence() {
        CGAL::set_warning_handler(warning_);
        CGAL::set_error_handler(error_);
    }
    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;

  private:
    static void nothing(const char*, const char*, const char*, int, const char*) {}
    CGAL::Failure_function warning_, error_;
};

/// Where the shortest edge of the mesh is this small a part of the requested size, the criteria for shapes are too
/// strict.
constexpr double wild = 0.01;

bool runs_wild(const Complex& c3t3, double h) {
    const auto& t = c3t3.triangulation();
    return std::any_of(t.finite_edges_begin(), t.finite_edges_end(), [&](const auto& e) {
        return CGAL::squared_distance(e.first->vertex(e.second)->point().point(),
                                      e.first->vertex(e.third)->point().point()) < wild * wild * h * h;
    });
}

struct Attempt {
    enum class Outcome { complete, too_many, failed };
    Outcome outcome = Outcome::failed;
    std::vector<K::Point_3> points;  ///< of a complete one
};

/// 1, or about the longest side of the box where that is far from 1: CGAL's constructions lose accuracy there.
double unit_of(const Domain_3& domain) {
    const auto b = domain.bounding_box();
    const int exponent =
        std::ilogb(std::max({b.upper[0] - b.lower[0], b.upper[1] - b.lower[1], b.upper[2] - b.lower[2]}));
    return std::abs(exponent) <= 20 ? 1 : std::exp2(exponent);
}

/// A mesh with cells of size h and fewer vertices than `most`, if there is one. Its points are in unit_of(domain).
Attempt mesh(const Domain_3& domain, const Sizing_3& sizing, double h, std::uint64_t seed, const Shapes& shape,
             std::size_t most, const Feature_curves* sharp) {
    const Silence silence;
    std::atomic<bool> stop = false;
    // Measured: 15 to 50 queries per vertex. Refinement that rejects each of its own points queries for ever, and
    // slowly, because everything is nearly degenerate there.
    const double unit = unit_of(domain);
    Sharp_domain mesh_domain(domain, unit, seed, 25 * std::uint64_t{most}, &stop);
    h /= unit;
    const Field field{&sizing, &mesh_domain, h};
    CGAL::get_default_random() = CGAL::Random(static_cast<unsigned>(seed));
    const Criteria criteria(Criteria::Edge_criteria(field), Criteria::Facet_criteria(shape.angle, field, 0.2 * h),
                            Criteria::Cell_criteria(shape.radius_edge, field));
    using namespace CGAL::parameters;
    Attempt result;
    try {
        if (sharp != nullptr) add(mesh_domain, *sharp);
        const Complex c3t3 = CGAL::make_mesh_3<Complex>(
            mesh_domain, criteria, sharp != nullptr ? features() : no_features(), no_perturb(), no_exude(),
            mesh_3_options(maximal_number_of_vertices = most, pointer_to_stop_atomic_boolean = &stop));
        if (stop) return result;
        if (c3t3.triangulation().number_of_vertices() >= most) {
            if (!runs_wild(c3t3, h)) result.outcome = Attempt::Outcome::too_many;
            return result;
        }
        std::unordered_set<const void*> seen;
        const auto take = [&](const auto& v) {
            if (seen.insert(&*v).second) result.points.push_back(v->point().point());
        };
        for (auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
            for (int i = 0; i < 4; ++i) take(c->vertex(i));
        const auto& t = c3t3.triangulation();  // where cells beside a sharp edge are thought to be outside
        for (auto v = t.finite_vertices_begin(); v != t.finite_vertices_end(); ++v)
            if (c3t3.in_dimension(v) < 2) take(v);
        result.outcome = Attempt::Outcome::complete;
    } catch (const CGAL::Failure_exception&) {
    }
    return result;
}

}  // namespace

std::vector<Coordinates<3>> initial_mesh(const Domain_3& domain, const Sizing_3& sizing, std::size_t n,
                                         std::uint64_t seed, const Feature_curves* sharp) {
    if (sharp != nullptr && sharp->corners().empty() && sharp->curves().empty()) sharp = nullptr;
    if (n < 4) throw Error(Error_code::usage, "a mesh needs at least 4 vertices");
    // The counts so far that bracket n, as logarithms of (size, count); the count falls about as the third power of the
    // size.
    const double first = 1.2 * std::cbrt(domain.volume() / static_cast<double>(n));
    double h = first;
    const std::size_t most = 10 * n + 2000;
    std::optional<std::array<double, 2>> coarse, fine;
    std::vector<K::Point_3> best;
    const auto distance = [n](std::size_t count) {
        return count == 0 ? 1e9 : std::abs(std::log(static_cast<double>(count) / static_cast<double>(n)));
    };
    bool too_many = false;
    auto shape = shapes.begin();
    for (int tries = 0; tries < 12 && distance(best.size()) > 0.01; ++tries) {
        Attempt attempt = mesh(domain, sizing, h, seed, *shape, most, sharp);
        if (attempt.outcome == Attempt::Outcome::failed) {
            if (++shape == shapes.end()) throw Error(Error_code::bad_input, "Mesh_3 cannot refine this domain");
            h = first;
            coarse.reset();
            fine.reset();
            tries = -1;
            continue;
        }
        too_many = attempt.outcome == Attempt::Outcome::too_many;
        const std::size_t size = too_many ? most : attempt.points.size();
        const double count = std::max(1.0, static_cast<double>(size)), wanted = static_cast<double>(n);
        const std::array<double, 2> now{std::log(h), std::log(count / wanted)};
        (now[1] > 0 ? fine : coarse) = now;
        if (!too_many && distance(size) < distance(best.size())) best = std::move(attempt.points);
        if (coarse && fine) {
            // Regula falsi, kept off the ends, where it would stall.
            const double t = std::clamp((*fine)[1] / ((*fine)[1] - (*coarse)[1]), 0.1, 0.9);
            h = std::exp((*fine)[0] + t * ((*coarse)[0] - (*fine)[0]));
        } else {
            h *= std::clamp(std::cbrt(count / wanted) * (now[1] > 0 ? 1.02 : 0.98), 0.4, 2.5);
        }
    }
    if (best.size() < 4)
        throw Error(Error_code::too_few,
                    too_many ? "Mesh_3 needs more than " + std::to_string(most) + " vertices for features so fine"
                             : "refinement found no cell in the domain");
    CGAL::hilbert_sort(best.begin(), best.end(), K());
    std::vector<Coordinates<3>> points;
    points.reserve(best.size());
    const double unit = unit_of(domain);
    for (const K::Point_3& p : best) points.push_back({unit * p.x(), unit * p.y(), unit * p.z()});
    return points;
}

}  // namespace annulus::inline v1
