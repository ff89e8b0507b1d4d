// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A moving triangulation of space beside a model that knows what it must hold after every call.

#include <annulus/moving_delaunay_3.h>
#include <support/point_sets_3.h>

#include <optional>
#include <string>

namespace annulus::testing {

using Cells_3 = std::vector<std::array<Index, 4>>;  ///< sorted, each sorted

/// The finite cells of any triangulation whose vertices have an `index()`; triangles and edges where there are no cells.
template <class Triangulation>
[[nodiscard]] Cells_3 cells_of(const Triangulation& tr) {
    Cells_3 cells;
    const auto take = [&cells](std::initializer_list<Index> v) {
        std::array<Index, 4> c{none, none, none, none};
        std::copy(v.begin(), v.end(), c.begin());
        std::sort(c.begin(), c.end());
        cells.push_back(c);
    };
    if (tr.dimension() == 3)
        for (auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
            take({c->vertex(0)->index(), c->vertex(1)->index(), c->vertex(2)->index(), c->vertex(3)->index()});
    if (tr.dimension() == 2)
        for (auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
            take({f->first->vertex(0)->index(), f->first->vertex(1)->index(), f->first->vertex(2)->index()});
    if (tr.dimension() == 1)
        for (auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e)
            take({e->first->vertex(e->second)->index(), e->first->vertex(e->third)->index()});
    std::sort(cells.begin(), cells.end());
    return cells;
}

struct Operation_3 {
    enum class Kind { move, move_all, insert, remove, settle };
    Kind kind = Kind::settle;
    Index vertex = none;
    Points_3 points{};  ///< one for move and insert, all for move_all
};

struct Program_3 {
    Strategy strategy = Strategy::filter;
    Points_3 points;
    std::vector<Operation_3> operations{};
};
[[nodiscard]] std::string as_code(const Program_3& program);

/// The library's object and the model of what it must hold.
class Session_3 {
  public:
    struct Fault {
        std::string words;
    };
    Session_3(Strategy strategy, const Points_3& points);

    [[nodiscard]] Moving_delaunay_3& dt() { return dt_; }
    [[nodiscard]] const Move_report& last() const { return last_; }
    /// Makes the call and compares with the model. Throws Fault.
    void apply(const Operation_3& o);
    /// Everything that must be true between calls: the audit, CGAL's points, the cells of a rebuild, the mirror.
    void check() const;

  private:
    [[nodiscard]] bool refused(const Operation_3& o) const;
    void check_mirror() const;

    Moving_delaunay_3 dt_;
    std::vector<std::optional<Coordinates<3>>> sites_;
    std::vector<Moving_delaunay_3::Vertex_handle> handles_;
    std::vector<Index> vacant_;
    Move_report last_;
};

/// Runs a program, checking everything after every call. Empty, or what went wrong and where.
[[nodiscard]] std::string run(const Program_3& program);

}  // namespace annulus::testing
