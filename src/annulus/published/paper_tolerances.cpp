// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/published/paper_tolerances.h>

#include <annulus/mesh/sort_unique.h>
#include <annulus/predicate/batch.h>
#include <annulus/published/standard_annulus.h>

#include <algorithm>
#include <iterator>

namespace annulus::inline v1 {

namespace {
constexpr std::size_t batch_size = 1024;  // certificates: they stay in the cache from one stage to the next
}  // namespace

/// Removes what a call that ran out of memory has left.
template <int d>
void Paper_tolerances<d>::clear() {
    orientations_.clear();
    spheres_.clear();
}

template <int d>
void Paper_tolerances<d>::add_cell(Cell_index c, std::span<const Coordinates<d>> x) {
    if (kind_ == Tolerance_kind::paper || table_.is_infinite(c)) return;
    const Cell_sites<d> point = cell_sites(table_, c);
    Facet_certificate<d>& s = orientations_.certificate.emplace_back();
    s.kind = Facet_kind::nothing;
    s.point.fill(Site<d>(none));
    std::copy(point.begin(), point.end(), s.point.begin());
    orientations_.tuple.push_back(tuple<d, d + 1>(point, x));
}

template <int d>
void Paper_tolerances<d>::add_facet(Corner_index f, std::span<const Coordinates<d>> x) {
    const Facet_certificate<d> s = facet_certificate(table_, f, kind_ == Tolerance_kind::paper);
    if (s.kind == Facet_kind::nothing) return;
    if (s.kind == Facet_kind::empty_sphere) {
        spheres_.certificate.push_back(s);
        spheres_.tuple.push_back(tuple<d, d + 2>(s.point, x));
    } else {
        orientations_.certificate.push_back(s);
        orientations_.tuple.push_back(tuple<d, d + 1>(s.point, x));
    }
}

/// The paper's tolerance instead of that of the filtered predicate, if plain double decides that the certificate
/// holds. That of an empty circle is what the filter has computed.
template <int d>
double Paper_tolerances<d>::tolerance(const Facet_certificate<d>& f, const Certificate_value& v,
                                      std::span<const Coordinates<d>> x) const {
    const bool holds = v.stage == Stage::filter && v.sign > 0;
    const bool same = d == 2 && f.kind == Facet_kind::empty_sphere;
    return kind_ == Tolerance_kind::paper && holds && !same ? paper_half_width(f, x) : v.tolerance;
}

template <int d>
template <std::size_t k>
void Paper_tolerances<d>::evaluate(Batch<k>& batch, std::span<const Coordinates<d>> x, Least_tolerance& least,
                                   Move_result& report) {
    using T = Tuple<d, static_cast<int>(k)>;
    values_.resize(batch.tuple.size());
    const Tolerance_precision mode =
        kind_ == Tolerance_kind::certified ? Tolerance_precision::lower_bound : Tolerance_precision::approximate;
    const Stage_counts counts = annulus::evaluate(std::span<const T>(batch.tuple), mode, values_);
    for (std::size_t i = 0; i < values_.size(); ++i)
        least.note(batch.certificate[i].point, tolerance(batch.certificate[i], values_[i], x));
    report.statistics.evaluated += counts.total();
    report.statistics.arithmetic += counts;
    batch.clear();
}

template <int d>
void Paper_tolerances<d>::note(std::span<const Cell_index> cells, std::span<const Coordinates<d>> x,
                               Least_tolerance& least, Move_result& report) {
    clear();
    std::vector<Cell_index> present;
    std::copy_if(cells.begin(), cells.end(), std::back_inserter(present),
                 [this](Cell_index c) { return table_.is_cell(c); });
    sort_unique(present);
    std::vector<Corner_index> facets;
    for (const Cell_index c : present) {
        add_cell(c, x);
        for (int i = 0; i <= d; ++i) facets.push_back(table_.facet(table_.corner(c, i)));
    }
    sort_unique(facets);
    for (const Corner_index f : facets) add_facet(f, x);
    evaluate(orientations_, x, least, report);
    evaluate(spheres_, x, least, report);
}

template <int d>
void Paper_tolerances<d>::note_everything(std::span<const Coordinates<d>> x, Least_tolerance& least,
                                          Move_result& report) {
    clear();
    const auto take_full = [&](bool all) {
        if (all || orientations_.tuple.size() >= batch_size) evaluate(orientations_, x, least, report);
        if (all || spheres_.tuple.size() >= batch_size) evaluate(spheres_, x, least, report);
    };
    for (const Cell_index c : table_.cells()) {
        add_cell(c, x);
        take_full(false);
    }
    for (const Corner_index f : table_.facets()) {
        add_facet(f, x);
        take_full(false);
    }
    take_full(true);
}

template class Paper_tolerances<2>;
template class Paper_tolerances<3>;

}  // namespace annulus::inline v1
