// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The same program on a Moving_mesh: it must accept and refuse the same calls, and have the same cells afterwards. Time
// steps alternate between move_all and a move of the vertices that change position.

#include "operation.h"

#include <annulus/arithmetic/limits.h>
#include <annulus/moving_mesh.h>

#include <optional>
#include <string>
#include <vector>

namespace annulus::oracle {

template <int d>
class Mesh_twin {
  public:
    /// Where tolerances are not certified the only guarantee is not to crash.
    Mesh_twin(const std::vector<Coordinates<d>>& points, const Options& options, std::optional<Error_code> refused)
        : promises_(options.tolerance == Tolerance_kind::certified) {
        guard(refused, [&] { mesh_.emplace(std::span<const Coordinates<d>>(points), options); });
        if (!mesh_ && !lost_) mesh_.emplace(options);
    }

    /// Makes a call whose expected result is `refused`. Empty, or the fault.
    [[nodiscard]] std::string apply(const Operation_of<d>& o, std::optional<Error_code> refused) {
        if (lost_ || !fault_.empty()) return fault_;
        using Kind = Operation_kind;
        ++calls_;
        guard(refused, [&] {
            switch (o.kind) {
                case Kind::steady:
                case Kind::refused:
                case Kind::recompute_tolerances: (void)mesh_->recompute_tolerances(); break;
                case Kind::remove: mesh_->remove(o.vertex); break;
                case Kind::move: (void)mesh_->move(o.vertex, o.points[0]); break;
                case Kind::stay: (void)mesh_->move_all(mesh_->points()); break;
                case Kind::insert: (void)mesh_->insert(o.points[0]); break;
                case Kind::move_all:
                    calls_ % 2 == 0 && o.points.size() == mesh_->index_bound() ? move_some(o.points)
                                                                               : (void)mesh_->move_all(o.points);
            }
        });
        return fault_;
    }

    /// Empty, or how it differs from the triangulation of these sites, whose finite cells are `expected` (vertices in
    /// any order).
    template <class Cells>
    [[nodiscard]] std::string fault(const std::vector<std::optional<Coordinates<d>>>& sites,
                                    const Cells& expected) const {
        if (lost_ || !promises_ || !fault_.empty()) return fault_;
        if (mesh_->index_bound() != sites.size()) return "mesh: index_bound()";
        for (std::size_t i = 0; i < sites.size(); ++i) {
            if (mesh_->is_vertex(static_cast<Index>(i)) != sites[i].has_value()) return "mesh: vertices";
            if (sites[i] && mesh_->points()[i] != *sites[i]) return "mesh: a position is not the requested one";
        }
        const Mesh_cells<d> cells = mesh_->cells();
        if (sorted(cells.vertices) != sorted(expected)) return "mesh: the cells are not CGAL's";
        for (std::size_t c = 0; c < cells.vertices.size(); ++c)
            for (std::size_t i = 0; i <= d; ++i)
                if (!is_beyond(cells, c, i)) return "mesh: neighbours";
        return {};
    }

  private:
    /// Makes a call that must be refused like that of the other object.
    template <class Call>
    void guard(std::optional<Error_code> refused, Call call) {
        std::optional<Error_code> code;
        try {
            call();
        } catch (const Error& e) {
            code = e.code();
        }
        if constexpr (Limits::tiny)
            if (code == Error_code::too_large || refused == Error_code::too_large) {  // not at the same call in both
                lost_ = true;
                return;
            }
        if (promises_ && code != refused)
            fault_ = code ? "mesh: refused what the other took" : "mesh: took what the other refused";
    }

    void move_some(const std::vector<Coordinates<d>>& x) {
        std::vector<Index> movers;
        std::vector<Coordinates<d>> where;
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (!mesh_->is_vertex(static_cast<Index>(i)) || x[i] == mesh_->points()[i]) continue;
            movers.push_back(static_cast<Index>(i));
            where.push_back(x[i]);
        }
        const Move_counts m = mesh_->move(movers, where).moves;
        if (m.asked != movers.size() ||
            m.asked != m.within_tolerance + m.kept_in_place + m.flipped + m.reinserted + m.rebuilt)
            fault_ = "mesh: the counts of a report do not add up";
    }

    template <class Cells>
    [[nodiscard]] static Cells sorted(Cells cells) {
        for (auto& c : cells) std::sort(c.begin(), c.end());
        std::sort(cells.begin(), cells.end());
        return cells;
    }
    /// Whether the cell given as beyond the facet opposite to corner i has its vertices, and this cell as its
    /// neighbour.
    [[nodiscard]] static bool is_beyond(const Mesh_cells<d>& cells, std::size_t c, std::size_t i) {
        const Index n = cells.neighbours[c][i];
        if (n == Mesh_cells<d>::outside) return true;
        const auto& there = cells.vertices[static_cast<std::size_t>(n)];
        for (std::size_t k = 0; k <= d; ++k)
            if (k != i && std::find(there.begin(), there.end(), cells.vertices[c][k]) == there.end()) return false;
        for (const Index back : cells.neighbours[static_cast<std::size_t>(n)])
            if (back == static_cast<Index>(c)) return true;
        return false;
    }

    bool promises_;
    std::optional<Moving_mesh<d>> mesh_;
    std::string fault_;
    bool lost_ = false;
    std::uint64_t calls_ = 0;
};

}  // namespace annulus::oracle
