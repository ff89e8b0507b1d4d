// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/cell_changes.h>

#include <annulus/mesh/certificates.h>

#include <algorithm>
#include <tuple>

namespace annulus::inline v1 {

namespace {

/// A cell, preceded by its key: equal cells have the same sorted sites and the same orientation.
template <class Cell>
struct Keyed {
    Cell sites;
    bool odd = false;
    Cell cell;

    explicit Keyed(const Cell& x) : sites(x), cell(x) {
        for (std::size_t i = 0; i < x.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) odd = odd != (x[k] > x[i]);
        std::sort(sites.begin(), sites.end());
    }
    [[nodiscard]] auto key() const { return std::tie(sites, odd); }
};

template <class Cell>
using Sorted = std::vector<Keyed<Cell>>;

template <class Cell>
Sorted<Cell> sorted(const std::vector<Cell>& cells) {
    Sorted<Cell> out(cells.begin(), cells.end());
    std::sort(out.begin(), out.end(), [](const auto& l, const auto& r) { return l.key() < r.key(); });
    return out;
}

/// The cells that `others` lacks, corner by corner; all cells if `everything`.
template <class Cell>
std::vector<Index> without(const Sorted<Cell>& cells, const Sorted<Cell>& others, bool everything) {
    std::vector<Index> out;
    auto other = others.begin();
    for (const Keyed<Cell>& x : cells) {
        while (other != others.end() && other->key() < x.key()) ++other;
        if (everything || other == others.end() || other->key() != x.key())
            for (const auto& [v, label] : x.cell) out.push_back(v);
    }
    return out;
}

}  // namespace

template <int d>
Cell_changes<d>::Cell_changes(Delaunay_mesh<d>& mesh, std::span<const Coordinates<d>> x, Change_log<d>& log)
    : mesh_(mesh), change_log_(log), watched_(mesh.dimension() == d) {
    log.begin();
    if (watched_) mesh.table().set_observer(&log);
    else before_ = all_cells(x);
}

template <int d>
auto Cell_changes<d>::all_cells(std::span<const Coordinates<d>> x) const -> std::vector<Sites> {
    std::vector<Index> corners;
    mesh_.list_all_cells(x, corners);
    std::vector<Sites> cells(corners.size() / (d + 1));
    for (std::size_t k = 0; k < corners.size(); ++k) cells[k / (d + 1)][k % (d + 1)] = Site<d>(corners[k]);
    return cells;
}

template <int d>
void Cell_changes<d>::list(std::span<const Coordinates<d>> x, Move_result& report) {
    change_log_.check();
    std::vector<Sites> came;
    if (watched_ && !change_log_.replaced()) {
        const Corner_table<d>& t = mesh_.table();
        for (const Cell_index c : change_log_.written())
            if (t.is_cell(c)) came.push_back(cell_sites(t, c));
    } else {
        came = all_cells(x);
    }
    const Sorted<Sites> before = sorted(watched_ ? change_log_.gone() : before_), after = sorted(came);
    const bool flat = !watched_ || mesh_.dimension() != d;
    report.changed = without(after, before, flat);
    report.gone = without(before, after, flat);
}

template class Cell_changes<2>;
template class Cell_changes<3>;

}  // namespace annulus::inline v1
