// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/paper_tolerance.h>

#include <annulus/mesh/at.h>
#include <annulus/mesh/certificates.h>
#include <annulus/mesh/parallel_runs.h>

#include <algorithm>
#include <atomic>
#include <iterator>
#include <limits>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The number of facets or cells that one thread processes at a time.
constexpr std::size_t run_length = 4096;
constexpr std::size_t runs_of(std::size_t n) { return (n + run_length - 1) / run_length; }

/// Written by several threads: least values, which do not depend on the order, and marks.
void lower(double& least, double y) {
    const std::atomic_ref shared(least);
    double seen = shared.load(std::memory_order_relaxed);
    while (y < seen && !shared.compare_exchange_weak(seen, y, std::memory_order_relaxed)) {
    }
}
void mark(char& one) { std::atomic_ref(one).store(1, std::memory_order_relaxed); }

template <int d>
Facet_certificate<d> certificate_of(const Corner_table<d>& t, Corner_index f) {
    return facet_certificate(t, f, true);
}

}  // namespace

/// Calls visit(run, facet) for each facet, by all threads; each run is processed by one thread.
template <int d>
template <class Visit>
void Paper_tolerance<d>::for_each_facet(const Visit& visit) const {
    for_each_run(static_cast<std::size_t>(t_.facet_bound().value()), run_length, threads_,
                 [&](std::size_t first, std::size_t last) {
                     for (std::size_t i = first; i < last; ++i)
                         if (const Corner_index f(static_cast<Index>(i)); t_.is_facet(f)) visit(first / run_length, f);
                 });
}
template <int d>
template <class Visit>
void Paper_tolerance<d>::for_each_finite_cell(const Visit& visit) const {
    for_each_run(static_cast<std::size_t>(t_.cell_bound().value()), run_length, threads_,
                 [&](std::size_t first, std::size_t last) {
                     for (std::size_t i = first; i < last; ++i)
                         if (const Cell_index c(static_cast<Index>(i)); t_.is_cell(c) && !t_.is_infinite(c))
                             visit(first / run_length, c);
                 });
}

/// Computes the paper's tolerance of every vertex from the numbers of facets.
template <int d>
void Paper_tolerance<d>::take_least() {
    least_.assign(vertices_, {infinity, infinity, Stage::interval});
    for_each_facet([&](std::size_t, Corner_index f) {
        const Half_width& h = paper_[f];
        for (const auto& [v, label] : certificate_of(t_, f).point) {
            if (v == none) continue;
            lower(least_[at(v)].lower, h.lower);
            lower(least_[at(v)].upper, h.upper);
        }
    });
}

/// Calls visit(run, half width, points, exactly) for each certificate whose half width is not the paper's own number;
/// exactly(x) computes it with integers. By all threads: runs are numbered below runs().
template <int d>
template <class Visit>
void Paper_tolerance<d>::for_each_certificate(const Visit& visit) {
    for_each_facet([&](std::size_t run, Corner_index f) {
        if (own_[f] != 0) return;
        const Facet_certificate<d> p = certificate_of(t_, f);
        if (p.kind == Facet_kind::empty_sphere) {
            visit(run, facet_[f], std::span<const Site<d>>(p.point), [&](std::span<const Coordinates<d>> x) {
                return enclose_exactly(tuple<d, d + 2>(p.point, x)).least;
            });
        } else if (p.kind == Facet_kind::ridge) {
            visit(run, facet_[f], std::span<const Site<d>>(p.point).first(d + 1),
                  [&](std::span<const Coordinates<d>> x) {
                      return enclose_exactly(tuple<d, d + 1>(p.point, x), Width::least);
                  });
        }
    });
    const std::size_t behind = runs_of(static_cast<std::size_t>(t_.facet_bound().value()));
    for_each_finite_cell([&](std::size_t run, Cell_index c) {
        const Cell_sites<d> p = cell_sites(t_, c);
        visit(behind + run, cell_[c], std::span<const Site<d>>(p),
              [&](std::span<const Coordinates<d>> x) { return enclose_exactly(tuple<d, d + 1>(p, x), Width::least); });
    });
}
template <int d>
std::size_t Paper_tolerance<d>::runs() const {
    return runs_of(static_cast<std::size_t>(t_.facet_bound().value())) +
           runs_of(static_cast<std::size_t>(t_.cell_bound().value()));
}

/// Computes with integers what the enclosures leave open: the certificate, and the paper's numbers that may be the
/// least of such a vertex.
template <int d>
void Paper_tolerance<d>::refine(std::span<const Coordinates<d>> x) {
    std::vector<char> open(vertices_, 0);
    char any = 0;
    for_each_certificate([&](std::size_t, Half_width& h, std::span<const Site<d>> points, const auto& exactly) {
        bool mine = false;
        for (const auto& [v, label] : points) {
            const Half_width& l = least_[at(v)];
            if (h.is_below(l.lower) || h.is_not_below(l.upper)) continue;
            mark(open[at(v)]);
            mine = true;
        }
        if (mine && h.stage != Stage::exact) h = exactly(x);
        if (mine) mark(any);
    });
    if (any == 0) return;
    for_each_facet([&](std::size_t, Corner_index f) {
        if (paper_[f].stage == Stage::exact) return;
        const Facet_certificate<d> p = certificate_of(t_, f);
        if (std::none_of(p.point.begin(), p.point.end(), [&](Site<d> p_k) {
                const Index v = p_k.vertex;
                return v != none && open[at(v)] != 0 && paper_[f].lower <= least_[at(v)].upper;
            }))
            return;
        paper_[f] = p.kind == Facet_kind::empty_sphere
                        ? enclose_exactly(tuple<d, d + 2>(p.point, x)).standard
                        : enclose_exactly(tuple<d, d + 1>(p.point, x),
                                          p.kind == Facet_kind::ridge ? Width::ridge : Width::slab);
    });
    take_least();
}

template <int d>
std::vector<double> Paper_tolerance<d>::least_of_all() const {
    std::vector<double> least(vertices_, infinity);
    for_each_facet([&](std::size_t, Corner_index f) {
        const Facet_certificate<d> p = certificate_of(t_, f);
        if (p.kind != Facet_kind::empty_sphere && p.kind != Facet_kind::ridge) return;
        for (const auto& [v, label] : p.point)
            if (v != none) lower(least[at(v)], facet_[f].lower);
    });
    for_each_finite_cell([&](std::size_t, Cell_index c) {
        for (const Index v : cell_vertices(t_, c)) lower(least[at(v)], cell_[c].lower);
    });
    return least;
}

template <int d>
Paper_verdict Paper_tolerance<d>::verdict(std::span<const Coordinates<d>> x) {
    take_least();
    refine(x);
    std::vector<char> above(vertices_, 0);
    std::vector<char> unsound(vertices_, 0);
    std::vector<std::vector<std::vector<Index>>> points_of_run(runs());
    for_each_certificate([&](std::size_t run, const Half_width& h, std::span<const Site<d>> points, const auto&) {
        bool all = true;
        for (const auto& [v, label] : points) {
            if (h.is_below(least_[at(v)].lower)) mark(above[at(v)]);
            else all = false;
        }
        if (!all) return;
        std::vector<Index>& vertices = points_of_run[run].emplace_back();
        for (const auto& [v, label] : points) {
            vertices.push_back(v);
            mark(unsound[at(v)]);
        }
    });
    Paper_verdict out;
    for (std::vector<std::vector<Index>>& points : points_of_run)
        std::move(points.begin(), points.end(), std::back_inserter(out.points));
    out.certificates = out.points.size();
    out.above_exact = static_cast<std::uint64_t>(std::count(above.begin(), above.end(), 1));
    out.unsound = static_cast<std::uint64_t>(std::count(unsound.begin(), unsound.end(), 1));
    for (const Half_width& l : least_) out.tolerance.push_back(l.lower);
    out.exact = least_of_all();
    return out;
}

template class Paper_tolerance<2>;
template class Paper_tolerance<3>;

}  // namespace annulus::inline v1
