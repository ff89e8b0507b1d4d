// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/index.h>
#include <annulus/mesh/corner_table.h>
#include <annulus/space/lattice.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

template <int d>
using Cell_images = std::array<Image<d>, static_cast<std::size_t>(d + 1)>;
template <int d>
using Facet_images = std::array<Image<d>, static_cast<std::size_t>(d)>;

/// A triangulation of R^d that a lattice maps to itself, as the finitely many cells that differ by more than a
/// translation: a cell has d + 1 vertices and their offsets, up to adding one offset to all. In the normal form the
/// least offset is 0 in each direction. Vertices may be in a cell several times, with different offsets, and two cells
/// may share several facets, so a corner is found by its image (vertex and offset), never by its vertex.
///
/// Corners and half-facets are numbered as in Corner_table, 4 * cell + slot.
template <int d>
struct Periodic_table {
    static constexpr std::size_t corners = d + 1;

    std::vector<std::array<Index, corners>> vertex;
    std::vector<std::array<Offset<d>, corners>> offset;
    std::vector<std::array<Corner_index, corners>> twin;
    /// Whether the d + 2 points of the bi-cell at this half-facet are on one sphere, exactly.
    std::vector<std::array<std::uint8_t, corners>> cospherical;

    [[nodiscard]] std::size_t size() const { return vertex.size(); }
    [[nodiscard]] static std::size_t cell_of(Corner_index h) { return h.offset() / 4; }
    [[nodiscard]] static std::size_t slot_of(Corner_index h) { return h.offset() % 4; }
    [[nodiscard]] static Corner_index corner(std::size_t c, std::size_t i) {
        return Corner_index(static_cast<Index>(4 * c + i));
    }

    [[nodiscard]] Image<d> image(std::size_t c, std::size_t i, Offset<d> shift = {}) const {
        return Image<d>(vertex[c][i], offset[c][i] + shift);
    }
    [[nodiscard]] Cell_images<d> images(std::size_t c, Offset<d> shift = {}) const {
        Cell_images<d> all;
        for (std::size_t i = 0; i < corners; ++i) all[i] = image(c, i, shift);
        return all;
    }
    /// What to add to the offsets of the cell beyond facet i of c, to have them as c sees them: the facet has d images
    /// on both sides, so d times the translation is the difference of their sums, whatever vertices repeat.
    [[nodiscard]] Offset<d> translation(std::size_t c, std::size_t i) const {
        const Corner_index t = twin[c][i];
        const std::size_t m = cell_of(t);
        std::int64_t sum = 0;
        for (std::size_t k = 0; k < corners; ++k) sum += std::int64_t{offset[c][k].packed()} - offset[m][k].packed();
        sum += std::int64_t{offset[m][slot_of(t)].packed()} - offset[c][i].packed();
        return Offset<d>::fraction(sum, d);
    }
    /// The slot of an image in cell c, whose offsets are moved by `shift`. Precondition: it is there.
    [[nodiscard]] std::size_t slot(std::size_t c, Image<d> s, Offset<d> shift) const {
        std::size_t i = 0;
        while (image(c, i, shift) != s) ++i;
        return i;
    }
    void clear() {
        vertex.clear();
        offset.clear();
        twin.clear();
        cospherical.clear();
    }
};

/// Moves a cell so that the least of its offsets is 0 in each direction. False where another one is then so large that
/// the places of a bi-cell need not be exact (Lattice): no edge is so long, so the cell is wrong.
template <int d>
[[nodiscard]] bool normalise(std::array<Offset<d>, static_cast<std::size_t>(d + 1)>& offset) {
    constexpr std::int32_t largest = 5;  // a reach of 2.5, and places from -1/2 to 3/2
    Shift<d> least = offset[0].unpacked();
    for (const Offset<d> o : offset) {
        const Shift<d> s = o.unpacked();
        for (std::size_t i = 0; i < d; ++i) least[i] = std::min(least[i], s[i]);
    }
    bool small = true;
    for (Offset<d>& o : offset) {
        o = o - Offset<d>(least);
        for (const std::int32_t s : o.unpacked()) small = small && s <= largest;
    }
    return small;
}

/// The images of the facet opposite to corner i of a cell, in ascending order.
template <int d>
[[nodiscard]] Facet_images<d> facet_images(const Cell_images<d>& cell, std::size_t i) {
    Facet_images<d> facet;
    for (std::size_t k = 0, n = 0; k <= d; ++k)
        if (k != i) facet[n++] = cell[k];
    std::sort(facet.begin(), facet.end());
    return facet;
}

}  // namespace annulus::inline v1
