// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/audit.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/arithmetic/limits.h>
#include <annulus/error.h>
#include <annulus/mesh/audit_predicates_3.h>

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

namespace {

using namespace auditing;

template <std::size_t k>
bool names_points(const std::array<Index, k>& cell, std::size_t corners, std::size_t points) {
    return std::all_of(cell.begin(), cell.begin() + static_cast<std::ptrdiff_t>(corners),
                       [points](Index v) { return v >= 0 && at(v) < points; });
}

/// Makes every triangle turn left.
void orient(Audit_input<2>& in) {
    const auto sites = integer_points<2>(in.points);
    std::vector<Audit_predicates_2::Point> points;
    points.reserve(sites.size());
    for (const auto& s : sites) points.push_back({&s[0], &s[1]});
    Audit_predicates_2 predicates(std::move(points));
    for (auto& c : in.cells)
        if (names_points(c, 3, sites.size()) && predicates.turn(c[0], c[1], c[2]) < 0) std::swap(c[0], c[1]);
}

/// Makes every tetrahedron positive, and all triangles of points in a plane turn the same way.
void orient(Audit_input<3>& in) {
    const auto sites = integer_points<3>(in.points);
    Audit_predicates_3 predicates(sites);
    int side = 0;  // of the first triangle, along the axis
    std::size_t axis = 0;
    for (auto& c : in.cells) {
        if (names_points(c, 4, sites.size())) {
            if (predicates.orientation(c[0], c[1], c[2], c[3]) < 0) std::swap(c[0], c[1]);
            continue;
        }
        if (c[3] != none || !names_points(c, 3, sites.size())) continue;
        for (std::size_t k = 0; side == 0 && k < 3; ++k) side = predicates.turn(c[0], c[1], c[2], axis = k);
        if (side != 0 && predicates.turn(c[0], c[1], c[2], axis) == -side) std::swap(c[0], c[1]);
    }
}

/// Finds cells by their vertices.
template <int d>
class Cell_numbers {
  public:
    using Cell = std::array<Index, static_cast<std::size_t>(d) + 1>;

    /// Vertices have these names, or their indices where there are none.
    Cell_numbers(const std::vector<Cell>& cells, std::span<const Index> names) {
        for (std::size_t c = 0; c < cells.size(); ++c) {
            Cell cell = cells[c];
            for (Index& v : cell)
                if (v >= 0 && at(v) < names.size()) v = names[at(v)];
            numbers_.emplace(sorted(cell), static_cast<std::int64_t>(c));
        }
    }
    /// The number of the cell with these vertices; of several equal ones that after `but`. -1 if there is none.
    [[nodiscard]] std::int64_t find(Cell cell, std::int64_t but = -1) const {
        const auto [first, last] = numbers_.equal_range(sorted(cell));
        for (auto c = first; c != last; ++c)
            if (c->second > but) return c->second;
        return -1;
    }

  private:
    static Cell sorted(Cell cell) {
        std::sort(cell.begin(), cell.end());
        return cell;
    }
    std::multimap<Cell, std::int64_t> numbers_;
};

/// The cell of a fault that consists of the first `facet` vertices and vertex `apex` of those that it lists.
template <int d>
typename Cell_numbers<d>::Cell cell_of(const Audit_fault& f, std::size_t facet, std::size_t apex) {
    typename Cell_numbers<d>::Cell cell;
    cell.fill(none);
    std::copy_n(f.vertices.begin(), facet, cell.begin());
    cell[facet] = f.vertices[apex];
    return cell;
}

/// Adds the cells to listed faults.
template <int d>
void number_cells(const Audit_input<d>& in, std::vector<Audit_fault>& faults) {
    const bool flat = std::all_of(in.cells.begin(), in.cells.end(), [](const auto& c) { return c[d] == none; });
    const std::size_t facet = flat && d == 3 ? 2 : d;  // vertices of a facet
    const Cell_numbers<d> numbers(in.cells, in.names);
    for (Audit_fault& f : faults) {
        if (f.kind == Fault::unknown_vertex || f.kind == Fault::flat_cell) {
            f.cells[0] = numbers.find(cell_of<d>(f, facet, facet));
            if (f.kind == Fault::flat_cell) f.text.replace(0, f.text.find(':'), "flat cell");
        } else if (f.kind == Fault::overlap || f.kind == Fault::not_delaunay) {
            f.cells[0] = numbers.find(cell_of<d>(f, facet, facet));
            const bool equal = f.vertices[facet] == f.vertices[facet + 1];
            f.cells[1] = numbers.find(cell_of<d>(f, facet, facet + 1), equal ? f.cells[0] : -1);
        }
        if (f.cells[0] < 0) continue;
        f.text += f.cells[1] < 0 ? " (cell " : " (cells ";
        f.text += std::to_string(f.cells[0]);
        if (f.cells[1] >= 0) {
            f.text += ", ";
            f.text += std::to_string(f.cells[1]);
        }
        f.text += ')';
    }
}

template <int d>
Audit_result audit_any(Audit_input<d>& in) {
    if (in.points.size() > Limits::vertices || in.cells.size() > static_cast<std::size_t>(Limits::cells))
        throw Error(Error_code::too_large, "more points or cells than there are indices");
    std::vector<std::int64_t> refused;
    for (std::size_t i = 0; i < in.points.size(); ++i)
        if (!std::all_of(in.points[i].begin(), in.points[i].end(), [](double c) { return is_finite_number(c); }))
            refused.push_back(static_cast<std::int64_t>(i));
    if (!refused.empty())
        throw Error(Error_code::not_finite,
                    "a coordinate of point " + std::to_string(refused.front()) + " is not a finite number", refused);
    orient(in);
    const std::size_t most = in.most_faults;
    in.most_faults = std::max<std::size_t>(most, 1);
    Audit_result r = audit(in);
    in.most_faults = most;
    if (r.faults.empty()) return r;
    number_cells<d>(in, r.faults);
    const auto key = [](const Audit_fault& f) { return std::tie(f.kind, f.cells, f.vertices); };
    std::sort(r.faults.begin(), r.faults.end(),
              [&key](const Audit_fault& f, const Audit_fault& g) { return key(f) < key(g); });
    r.first_fault = r.faults.front().text;
    r.faults.resize(std::min(r.faults.size(), most));
    return r;
}

template <int d, std::size_t k>
Audit_result audit_arrays(std::span<const Coordinates<d>> points, std::span<const std::array<Index, k>> cells,
                          std::size_t most_faults) {
    Audit_input<d> in;
    in.points.assign(points.begin(), points.end());
    in.cells.assign(cells.begin(), cells.end());
    in.most_faults = most_faults;
    return audit_any(in);
}

}  // namespace

Audit_result audit_unoriented(Audit_input<2>& input) { return audit_any(input); }
Audit_result audit_unoriented(Audit_input<3>& input) { return audit_any(input); }

Audit_result audit(std::span<const Coordinates<2>> points, std::span<const std::array<Index, 3>> cells,
                   std::size_t most_faults) {
    return audit_arrays<2>(points, cells, most_faults);
}
Audit_result audit(std::span<const Coordinates<3>> points, std::span<const std::array<Index, 4>> cells,
                   std::size_t most_faults) {
    return audit_arrays<3>(points, cells, most_faults);
}

}  // namespace annulus::inline v1
