// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/motion/domain_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// Raises the least dihedral angle of an optimised mesh, which stays Delaunay: small moves of the corners of its worst
/// cells, as CGAL's perturb_mesh_3 makes them, but without random numbers.
///
/// A move is tried on a Delaunay triangulation of all vertices. It is kept if the least dihedral angle of the cells of
/// the domain that it changes rises by more than `least_gain`, and the surface of the domain has the same triangles as
/// before; else the vertex goes back. An inner vertex moves by 0.3 times the distance to its nearest neighbour, or a
/// half, a quarter, an eighth of this, in 26 directions: those to the facets, edges and corners of a cube. A vertex on
/// the surface then goes to the nearest point of the surface. Vertices that are held rest.
///
/// Cells whose least angle is below the goal come worst first; of the moves of the corners of one the best is kept.
/// Cells without such a move wait for the next pass; passes end when one keeps no move, or after `most_passes`. The
/// result depends on the positions alone, not on the history of the triangulation unless points are cospherical.
class Finish_3 {
  public:
    using Cell = std::array<Index, 4>;

    struct Vertices {
        std::vector<Coordinates<3>> position;
        std::vector<char> on_surface, held;
    };
    struct Changes {
        std::vector<Cell> came, gone;  ///< finite cells, positive
    };
    /// Moves one vertex of the triangulation and returns the cells that came and went; nothing, with nothing changed,
    /// if another vertex is there.
    using Mover = std::function<std::optional<Changes>(Index v, const Coordinates<3>& p)>;

    struct Counts {
        std::uint64_t tried = 0;  ///< moves
        std::uint64_t kept = 0;
    };

    static constexpr double default_goal = 15;  ///< degrees
    static constexpr double least_gain = 0.01;
    static constexpr int most_passes = 5;

    /// `cells` are the finite cells of the triangulation. Throws Error(wrong_size) unless there is a flag for every
    /// vertex, Error(unknown_vertex). Refers to the domain. O(n log n).
    Finish_3(const Domain_3& domain, Vertices vertices, std::span<const Cell> cells, Mover mover,
             double goal = default_goal);

    /// Treats one cell: at most 416 moves are tried. Returns false if there is nothing left to do.
    bool step();

    [[nodiscard]] const std::vector<Coordinates<3>>& position() const { return vertices_.position; }
    [[nodiscard]] const Counts& counts() const { return counts_; }

  private:
    using Ranked = std::set<std::pair<double, Cell>>;  // by least angle
    struct Part;
    struct Passes {
        int done = 0;
        std::uint64_t kept_before = 0;
    };
    struct Best {
        Index vertex = none;
        Coordinates<3> position{};
        double gain = least_gain;
    };

    [[nodiscard]] const Coordinates<3>& at(Index v) const { return vertices_.position[static_cast<std::size_t>(v)]; }
    [[nodiscard]] double angle(const Cell& cell) const;
    [[nodiscard]] bool inside(const Cell& cell) const;
    [[nodiscard]] Part part(const std::vector<Cell>& cells) const;
    void replace_stars(const Changes& changes);
    void rank(const Cell& cell);
    void forget(const Cell& cell);
    [[nodiscard]] double gain_of(Index v, const Coordinates<3>& p);
    void try_moves(Index v, Best& best);
    void keep(const Best& best);

    const Domain_3& domain_;
    Vertices vertices_;
    std::vector<std::vector<Cell>> star_;  // by vertex
    Mover move_;
    double goal_;
    std::array<Ranked, 2> below_;  // cells of the domain below the goal: to be tried in this pass, and tried
    Counts counts_;
    Passes passes_;
};

}  // namespace annulus::inline v1
