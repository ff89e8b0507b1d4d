// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/statistics/paper_tolerance.h>

#include <annulus/mesh/certificates.h>

#include <algorithm>
#include <limits>

namespace annulus {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

template <int d>
Facet_certificate<d> certificate_of(const Cell_table<d>& t, Corner_index f) {
    return facet_certificate(t, f, true);
}

}  // namespace

/// The paper's tolerance of every vertex from what is known of facets.
template <int d>
void Paper_tolerance<d>::take_least() {
    least_.assign(vertices_, {infinity, infinity, Stage::interval});
    for (const Corner_index f : t_.facets()) {
        const Half_width& h = paper_[f];
        for (const Index v : certificate_of(t_, f).point) {
            if (v == none) continue;
            Half_width& l = least_[at(v)];
            l.lower = std::min(l.lower, h.lower);
            l.upper = std::min(l.upper, h.upper);
        }
    }
}

/// Calls visit(half width, points, exactly) for each certificate whose half width is not the paper's own number; exactly(x)
/// computes it with integers.
template <int d>
template <class Visit>
void Paper_tolerance<d>::for_each_certificate(Visit visit) {
    for (const Corner_index f : t_.facets()) {
        if (own_[f] != 0) continue;
        const Facet_certificate<d> p = certificate_of(t_, f);
        if (p.kind == Facet_kind::empty_sphere) {
            visit(facet_[f], std::span<const Index>(p.point), [&](std::span<const Coordinates<d>> x) {
                return enclose_exactly(tuple<d, d + 2>(p.point, x)).least;
            });
        } else if (p.kind == Facet_kind::ridge) {
            visit(facet_[f], std::span<const Index>(p.point).first(d + 1), [&](std::span<const Coordinates<d>> x) {
                return enclose_exactly(tuple<d, d + 1>(p.point, x), Width::least);
            });
        }
    }
    for (const Cell_index c : t_.finite_cells()) {
        const Cell_points<d> p = cell_points(t_, c);
        visit(cell_[c], std::span<const Index>(p),
              [&](std::span<const Coordinates<d>> x) { return enclose_exactly(tuple<d, d + 1>(p, x), Width::least); });
    }
}

/// Integers for what the enclosures leave open: the certificate, and the paper's numbers that may be the least of such a vertex.
template <int d>
void Paper_tolerance<d>::refine(std::span<const Coordinates<d>> x) {
    std::vector<char> open(vertices_, 0);
    bool any = false;
    for_each_certificate([&](Half_width& h, std::span<const Index> points, const auto& exactly) {
        bool mine = false;
        for (const Index v : points) {
            const Half_width& l = least_[at(v)];
            if (h.is_below(l.lower) || h.is_not_below(l.upper)) continue;
            open[at(v)] = 1;
            mine = true;
        }
        if (mine && h.stage != Stage::exact) h = exactly(x);
        any = any || mine;
    });
    if (!any) return;
    for (const Corner_index f : t_.facets()) {
        if (paper_[f].stage == Stage::exact) continue;
        const Facet_certificate<d> p = certificate_of(t_, f);
        if (std::none_of(p.point.begin(), p.point.end(), [&](Index v) {
                return v != none && open[at(v)] != 0 && paper_[f].lower <= least_[at(v)].upper;
            }))
            continue;
        paper_[f] = p.kind == Facet_kind::empty_sphere
                        ? enclose_exactly(tuple<d, d + 2>(p.point, x)).standard
                        : enclose_exactly(tuple<d, d + 1>(p.point, x),
                                          p.kind == Facet_kind::ridge ? Width::ridge : Width::slab);
    }
    take_least();
}

template <int d>
std::vector<double> Paper_tolerance<d>::least_of_all() const {
    std::vector<double> least(vertices_, infinity);
    const auto lower = [&](Index v, double y) { least[at(v)] = std::min(least[at(v)], y); };
    for (const Corner_index f : t_.facets()) {
        const Facet_certificate<d> p = certificate_of(t_, f);
        if (p.kind != Facet_kind::empty_sphere && p.kind != Facet_kind::ridge) continue;
        for (const Index v : p.point)
            if (v != none) lower(v, facet_[f].lower);
    }
    for (const Cell_index c : t_.finite_cells())
        for (const Index v : cell_points(t_, c)) lower(v, cell_[c].lower);
    return least;
}

template <int d>
Paper_verdict Paper_tolerance<d>::verdict(std::span<const Coordinates<d>> x) {
    take_least();
    refine(x);
    std::vector<char> above(vertices_, 0);
    std::vector<char> unsound(vertices_, 0);
    Paper_verdict out;
    for_each_certificate([&](const Half_width& h, std::span<const Index> points, const auto&) {
        bool all = true;
        for (const Index v : points) {
            if (h.is_below(least_[at(v)].lower)) above[at(v)] = 1;
            else all = false;
        }
        if (!all) return;
        ++out.certificates;
        out.points.emplace_back(points.begin(), points.end());
        for (const Index v : points) unsound[at(v)] = 1;
    });
    out.above_exact = static_cast<std::uint64_t>(std::count(above.begin(), above.end(), 1));
    out.unsound = static_cast<std::uint64_t>(std::count(unsound.begin(), unsound.end(), 1));
    for (const Half_width& l : least_) out.tolerance.push_back(l.lower);
    out.exact = least_of_all();
    return out;
}

template class Paper_tolerance<2>;
template class Paper_tolerance<3>;

}  // namespace annulus
