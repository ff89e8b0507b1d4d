// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Bytes to a few points and a list of cells, a Delaunay triangulation of them that may have been damaged; and the
// results of the audit and of brute force. Shared by the fuzz target and a property test.

#include "brute_force.h"
#include "bytes.h"

#include <annulus/audit.h>

#include <cmath>
#include <span>
#include <sstream>

namespace annulus::oracle {

template <int d>
struct Audit_case {
    std::vector<Grid_point<d>> points;
    std::vector<Cell_of<d>> cells;
    double scale = 1, offset = 0;  ///< the audit gets point * scale + offset, which is exact
    int changes = 0;               ///< made to a Delaunay triangulation

    [[nodiscard]] Audit_input<d> input() const {
        Audit_input<d> in;
        for (const Grid_point<d>& p : points) {
            Coordinates<d> x;
            for (std::size_t k = 0; k < d; ++k) x[k] = p[k] * scale + offset;
            in.points.push_back(x);
        }
        in.cells = cells;
        return in;
    }
};

/// Replaces two cells that share a facet by d others, or in 3D three around an edge by two, valid or not.
template <int d>
void flip(std::vector<Cell_of<d>>& cells, std::size_t one, std::size_t other) {
    Cell_of<d>& c = cells[one];
    const Cell_of<d> e = cells[other];
    const auto is_in = [](const Cell_of<d>& cell, Index v) {
        return std::find(cell.begin(), cell.end(), v) != cell.end();
    };
    std::size_t p = d + 1, q = d + 1;  // where the odd corners are
    for (std::size_t i = 0; i <= d; ++i) {
        if (!is_in(e, c[i])) p = p == d + 1 ? i : d + 2;
        if (!is_in(c, e[i])) q = q == d + 1 ? i : d + 2;
    }
    if (p > d || q > d) return;
    const Index apex = c[p], opposite = e[q];
    if (d == 3) {  // a third cell with both odd corners: 3-2
        for (std::size_t t = 0; t < cells.size(); ++t) {
            if (t == one || t == other || !is_in(cells[t], apex) || !is_in(cells[t], opposite)) continue;
            std::vector<Index> ring{apex, opposite}, axis;
            for (const Index v : c)
                if (v != apex) (is_in(cells[t], v) ? ring : axis).push_back(v);
            if (ring.size() != 3 || axis.size() != 2) continue;
            Cell_of<d> upper, lower;
            std::copy(ring.begin(), ring.end(), upper.begin());
            std::copy(ring.begin(), ring.end(), lower.begin());
            std::swap(lower[0], lower[1]);
            upper[d] = axis[0], lower[d] = axis[1];
            cells[one] = upper, cells[other] = lower;
            cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(t));
            return;
        }
    }
    // 2-2 in 2D, 2-3 in 3D: each corner of the facet is replaced by the opposite vertex.
    std::vector<Cell_of<d>> made;
    for (std::size_t i = 0; i <= d; ++i) {
        if (i == p || c[i] == none) continue;
        Cell_of<d> m = c;
        m[i] = opposite;
        made.push_back(m);
    }
    if (made.size() < 2) return;
    cells[one] = made[0];
    cells[other] = made[1];
    for (std::size_t i = 2; i < made.size(); ++i) cells.push_back(made[i]);
}

template <int d>
[[nodiscard]] Audit_case<d> decode_audit_case(Bytes bytes) {
    Audit_case<d> out;
    const std::uint8_t head = bytes.next();
    const std::size_t n = bytes.next() % 9;
    const auto coordinate = [&]() -> int {
        switch (head % 4) {
            case 0: return static_cast<int>(bytes.below(3));
            case 1: return static_cast<int>(bytes.below(5));
            case 2: return static_cast<int>(bytes.below(16));
            default: return static_cast<std::int8_t>(bytes.next());
        }
    };
    for (std::size_t i = 0; i < n; ++i) {
        Grid_point<d> p;
        for (int& c : p) c = coordinate();
        if (i >= 3 && (head >> 6) == 1) p[d - 1] = out.points[i - 1][d - 1];  // often flat
        if (i >= 2 && (head >> 6) == 2)                                       // often on a line
            for (std::size_t k = 1; k < d; ++k) p[k] = out.points[0][k];
        out.points.push_back(p);
    }
    switch (head >> 3 & 7U) {
        case 1: out.scale = 0x1p-1074; break;
        case 2: out.scale = 0x1p490; break;
        case 3: out.offset = 0x1p52; break;
        case 4: out.scale = 0x1p-30, out.offset = 1; break;
        case 5: out.scale = 0x1p-400; break;
        default: break;
    }
    const std::uint64_t order = bytes.next();  // selects one triangulation of cospherical points
    const Brute_force<d> brute(out.points);
    for (std::uint64_t attempt = 0; attempt < 16; ++attempt) {  // sometimes heights are degenerate, too
        std::vector<std::uint64_t> height;
        for (std::size_t i = 0; i < n; ++i)
            height.push_back(((order + 256 * attempt + 1) * (i + 1) * (2 * i + 3) * 0x9e3779b97f4a7c15U) >> 32);
        out.cells = brute.triangulated(height);
        if (brute.verdict(out.cells).fault.empty()) break;
    }

    const auto vertex = [&] {
        const auto v = static_cast<Index>(bytes.below(n + 2));
        return v == 0 ? none : v - 1;  // n also means none
    };
    for (int budget = 8; !bytes.empty() && budget > 0; --budget) {
        const std::uint8_t code = bytes.next();
        auto& cells = out.cells;
        const std::size_t i = bytes.below(cells.size());
        ++out.changes;
        if (cells.empty()) {
            cells.emplace_back();
            for (Index& v : cells.back()) v = vertex();
            continue;
        }
        const auto at = cells.begin() + static_cast<std::ptrdiff_t>(i);
        switch (code % 12) {
            case 0: cells.erase(at); break;
            case 1: cells.push_back(cells[i]); break;
            case 2: std::swap(cells[i][0], cells[i][1]); break;
            case 3: cells[i][bytes.below(d + 1)] = vertex(); break;
            case 4: flip<d>(cells, i, bytes.below(cells.size())); break;
            case 5: {  // the first existing neighbour
                const auto before = cells;
                for (std::size_t j = 0; j < cells.size() && cells == before; ++j) flip<d>(cells, i, j);
                break;
            }
            case 6: {  // no change
                std::rotate(cells[i].begin(), cells[i].begin() + (d == 2 ? 1 : 0), cells[i].end());
                if (d == 3) std::rotate(cells[i].begin(), cells[i].begin() + 1, cells[i].begin() + 3);
                break;
            }
            case 7: std::swap(cells[i], cells[bytes.below(cells.size())]); break;
            case 8: {  // a new cell
                Cell_of<d> c;
                for (Index& v : c) v = vertex();
                cells.push_back(c);
                break;
            }
            case 9: {  // everything reversed
                for (auto& c : cells) std::swap(c[0], c[1]);
                break;
            }
            default:  // a vertex moves
                if (n > 0) {
                    int& c = out.points[bytes.below(n)][bytes.below(d)];
                    c += static_cast<int>(bytes.below(3)) - 1;
                }
        }
    }
    return out;
}

template <int d>
[[nodiscard]] std::string as_code(const Audit_case<d>& c) {
    std::ostringstream out;
    out << "const Audit_case<" << d << "> x{{";
    for (const auto& p : c.points) {
        out << "{";
        for (const int x : p) out << x << ",";
        out << "},";
    }
    out << "}, {";
    for (const auto& cell : c.cells) {
        out << "{";
        for (const Index v : cell) out << v << ",";
        out << "},";
    }
    out << "}, " << std::hexfloat << c.scale << ", " << c.offset << "};";
    return out.str();
}

/// Empty, or the difference between the audit and brute force.
template <int d>
[[nodiscard]] std::string audit_fault(const Audit_case<d>& c) {
    const Audit_result r = audit(c.input());
    const Brute_verdict truth = Brute_force<d>(c.points).verdict(c.cells);
    if (r.delaunay() != r.first_fault.empty()) return "the audit's verdict and its words differ";
    if (r.delaunay() && !truth.fault.empty()) return "the audit passes, but " + truth.fault;
    if (!r.delaunay() && truth.fault.empty()) return "the audit refuses what is right: " + r.first_fault;
    if (r.delaunay() && r.degenerate_facets != truth.degenerate)
        return "the audit counts " + std::to_string(r.degenerate_facets) + " degenerate facets of " +
               std::to_string(truth.degenerate);
    if (c.changes == 0 && !truth.fault.empty() && truth.fault != "two points are one")
        return "the triangulation to begin with is none: " + truth.fault;
    return {};
}

}  // namespace annulus::oracle
