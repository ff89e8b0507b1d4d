// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/limits.h>
#include <annulus/engine/expiry_list.h>
#include <annulus/mesh/certificates.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

// Ids of facets and cells in one numbering.
static_assert(Wide_limits::cells <= Index{1} << 29, "the greatest corner, twice, is below the reserved id");
[[nodiscard]] constexpr Certificate_id id_of_facet(Corner_index f) {
    return 2 * static_cast<Certificate_id>(f.value());
}
[[nodiscard]] constexpr Certificate_id id_of_cell(Cell_index c) {
    return 2 * static_cast<Certificate_id>(c.value()) + 1;
}
[[nodiscard]] constexpr bool is_of_cell(Certificate_id id) { return (id & 1U) != 0; }
/// The facet or the cell of an id.
[[nodiscard]] constexpr Corner_index facet_of(Certificate_id id) { return Corner_index(static_cast<Index>(id >> 1)); }
[[nodiscard]] constexpr Cell_index cell_of(Certificate_id id) { return Cell_index(static_cast<Index>(id >> 1)); }

/// The path lengths at which certificates expire, for each of their points. This is the truth; expiry lists hold
/// hints.
///
/// Everything is stored at the corners of the cells, nothing by facet, so that all that a star walk of a vertex reads
/// is in its own cells: one cache line each in 3D. The certificate of facet f has at most the d + 2 points of
/// bicell_sites(f), none of them infinity. First come the d points of the facet: the first d - 1 are stored at f, the
/// last one at its twin. Then comes the corner of twin(f), stored at the twin, and that of f, stored at f. 64 bytes
/// per cell in 3D, 36 in 2D. When a cell or a facet changes, its expiries must be written again, as its certificate
/// must be evaluated again.
template <int d>
class Certificate_expiries {
  public:
    /// Makes room for the cells below this one; a new certificate never expires.
    void resize(Cell_index bound) { grow(corner_, bound); }
    void free() noexcept { release(corner_); }
    [[nodiscard]] bool has(Cell_index cell) const { return corner_.has(cell); }

    /// The expiry of the certificate of the cell of corner h, for the vertex of h.
    [[nodiscard]] Expiry& of_cell(Corner_index h) { return at(h).cell; }
    [[nodiscard]] const Expiry& of_cell(Corner_index h) const { return at(h).cell; }
    /// The expiry of the certificate of the facet opposite to corner h, for the vertex of h.
    [[nodiscard]] Expiry& of_opposite(Corner_index h) { return at(h).opposite; }
    [[nodiscard]] const Expiry& of_opposite(Corner_index h) const { return at(h).opposite; }
    /// The expiry of the certificate of facet f for the k-th of bicell_sites(f).
    [[nodiscard]] Expiry& of_facet(Corner_index f, Corner_index twin, std::size_t k) {
        if (k < d - 1) return at(f).own[k];
        return k == d - 1 ? at(twin).own[0] : of_opposite(k == d ? twin : f);
    }
    [[nodiscard]] const Expiry& of_facet(Corner_index f, Corner_index twin, std::size_t k) const {
        return const_cast<Certificate_expiries&>(*this).of_facet(f, twin, k);
    }
    /// The same for vertex v, without branches: which of the points it is cannot be predicted. Never, when it is none
    /// of them.
    [[nodiscard]] Expiry of_facet(const Corner_table<d>& t, Corner_index f, Index v) const {
        const Corner_index twin = t.twin(f);
        const Facet_sites<d> point = bicell_sites(t, f);
        Expiry e = Expiry::never();
        for (std::size_t k = 0; k < point.size(); ++k) e = point[k].vertex == v ? of_facet(f, twin, k) : e;
        return e;
    }
    /// The same for the vertex of corner h, when f is a corner of the same cell: no search is needed. f may be the
    /// greater half-facet in 2D, or when it is h.
    [[nodiscard]] Expiry of_facet(const Corner_table<d>& t, Corner_index f, Corner_index h) const {
        if (h == f) return of_opposite(h);
        if constexpr (d == 2) {
            return h == Corner_table<2>::ccw(f) ? at(f).own[0] : at(t.twin(f)).own[0];
        } else {
            const std::size_t k =
                place_facing[static_cast<std::size_t>(t.slot_of(f))][static_cast<std::size_t>(t.slot_of(h))];
            return k < d - 1 ? at(f).own[k] : at(t.twin(f)).own[0];
        }
    }
    void prefetch(Cell_index cell) const { __builtin_prefetch(&corner_[cell]); }

  private:
    struct Corner {
        Expiry cell = Expiry::never();
        Expiry opposite = Expiry::never();
        std::array<Expiry, d - 1> own = [] {
            std::array<Expiry, d - 1> e{};
            e.fill(Expiry::never());
            return e;
        }();
    };
    struct alignas(d == 3 ? 64 : 4) Cell {
        std::array<Corner, d + 1> corner;
    };
    static_assert(sizeof(Cell) == (d == 3 ? 64 : 36));
    /// By slots: which of `facing_corners` of the first slot the second one is.
    static constexpr auto place_facing = [] {
        std::array<std::array<std::uint8_t, 4>, 4> place{};
        for (std::size_t i = 0; i < 4; ++i)
            for (std::uint8_t k = 0; k < 3; ++k) place[i][static_cast<std::size_t>(facing_corners[i][k])] = k;
        return place;
    }();

    [[nodiscard]] Corner& at(Corner_index h) {
        return corner_[Corner_table<d>::cell_of(h)].corner[static_cast<std::size_t>(Corner_table<d>::slot_of(h))];
    }
    [[nodiscard]] const Corner& at(Corner_index h) const { return const_cast<Certificate_expiries&>(*this).at(h); }

    By_cell<Cell> corner_;
};

}  // namespace annulus::inline v1
