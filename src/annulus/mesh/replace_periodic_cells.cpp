// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/replace_periodic_cells.h>

#include <algorithm>
#include <array>
#include <functional>

namespace annulus::inline v1 {

namespace {

constexpr std::size_t nothing = ~std::size_t{0};

/// A facet of the border.
template <int d>
struct Border_facet {
    Facet_images<d> images;
    Corner_index outer = no_corner;  // the half-facet outside, if it stays
    Facet_images<d> partner{};       // otherwise the facet of the border that this one is glued to
    std::size_t side = nothing;      // the new half-facet: (d + 1) * number of the new cell + slot
};

template <int d>
class Replacement {
  public:
    Replacement(Periodic_table<d>& table, std::span<const Lifted_cell<d>> gone, std::span<const Cell_images<d>> came)
        : table_(table), gone_(gone), came_(came) {}

    [[nodiscard]] bool operator()(std::vector<std::size_t>& unused, std::vector<std::size_t>& made) {
        if (!find_border() || !match() || !find_offsets()) return false;
        take_numbers(unused, made);
        glue(made);
        return true;
    }

  private:
    static constexpr std::size_t corners = d + 1, most = most_replaced * corners;
    using Table = Periodic_table<d>;

    [[nodiscard]] std::size_t gone_number(std::size_t cell) const {
        for (std::size_t k = 0; k < gone_.size(); ++k)
            if (gone_[k].cell == cell) return k;
        return nothing;
    }
    [[nodiscard]] Border_facet<d>* find(const Facet_images<d>& images) {
        for (std::size_t k = 0; k < size_; ++k)
            if (border_[k].images == images) return &border_[k];
        return nullptr;
    }

    [[nodiscard]] bool find_border() {
        for (std::size_t k = 0; k < gone_.size(); ++k)
            if (gone_number(gone_[k].cell) != k) return false;
        for (const Lifted_cell<d>& g : gone_)
            for (std::size_t i = 0; i < corners; ++i) {
                const Lifted_cell<d> m = beyond<d>(table_, g, i);
                const std::size_t other = gone_number(m.cell);
                if (other != nothing && gone_[other] == m) continue;  // inside
                const Corner_index twin = table_.twin[g.cell][i];
                Border_facet<d> b;
                b.images = facet_images<d>(table_.images(g.cell, g.shift), i);
                if (find(b.images) != nullptr) return false;
                if (other == nothing) b.outer = twin;
                else
                    b.partner =
                        facet_images<d>(table_.images(gone_[other].cell, gone_[other].shift), Table::slot_of(twin));
                border_[size_++] = b;
            }
        return true;
    }

    /// Matches the facets of the new cells with each other and with the border.
    [[nodiscard]] bool match() {
        std::array<Facet_images<d>, most> facet;
        const std::size_t sides = came_.size() * corners;
        for (std::size_t s = 0; s < sides; ++s) facet[s] = facet_images<d>(came_[s / corners], s % corners);
        partner_.fill(nothing);
        std::size_t matched = 0;
        for (std::size_t s = 0; s < sides; ++s) {
            if (partner_[s] != nothing) continue;
            Border_facet<d>* b = find(facet[s]);
            for (std::size_t t = s + 1; t < sides; ++t) {
                if (facet[t] != facet[s]) continue;
                if (b != nullptr || partner_[s] != nothing || t / corners == s / corners) return false;
                partner_[s] = t;
                partner_[t] = s;
            }
            if (partner_[s] != nothing) continue;
            if (b == nullptr) return false;
            b->side = s;
            ++matched;
        }
        if (matched != size_) return false;
        for (std::size_t k = 0; k < size_; ++k)
            if (border_[k].outer == no_corner && find(border_[k].partner) == nullptr) return false;
        return true;
    }

    [[nodiscard]] bool find_offsets() {
        for (std::size_t k = 0; k < came_.size(); ++k) {
            for (std::size_t i = 0; i < corners; ++i) offset_[k][i] = came_[k][i].label;
            if (!normalise<d>(offset_[k])) return false;
        }
        return true;
    }

    void take_numbers(std::vector<std::size_t>& unused, std::vector<std::size_t>& made) {
        made.clear();
        for (const Lifted_cell<d>& g : gone_) {
            if (made.size() < came_.size()) made.push_back(g.cell);
            else {
                table_.vertex[g.cell].fill(none);
                unused.push_back(g.cell);
            }
        }
        while (made.size() < came_.size()) {
            if (!unused.empty()) {
                made.push_back(unused.back());
                unused.pop_back();
                continue;
            }
            made.push_back(table_.size());
            table_.vertex.emplace_back().fill(none);
            table_.offset.emplace_back();
            table_.twin.emplace_back().fill(no_corner);
        }
        for (std::size_t k = 0; k < made.size(); ++k) {
            table_.offset[made[k]] = offset_[k];
            for (std::size_t i = 0; i < corners; ++i) table_.vertex[made[k]][i] = came_[k][i].vertex;
        }
    }

    void glue(const std::vector<std::size_t>& made) {
        const auto half = [&](std::size_t s) { return Table::corner(made[s / corners], s % corners); };
        const auto set = [&](Corner_index h, Corner_index t) { table_.twin[Table::cell_of(h)][Table::slot_of(h)] = t; };
        for (std::size_t s = 0; s < came_.size() * corners; ++s)
            if (partner_[s] != nothing) set(half(s), half(partner_[s]));
        for (std::size_t k = 0; k < size_; ++k) {
            const Border_facet<d>& b = border_[k];
            const Corner_index h = half(b.side);
            if (b.outer == no_corner) set(h, half(find(b.partner)->side));
            else {
                set(h, b.outer);
                set(b.outer, h);
            }
        }
    }

    Table& table_;
    std::span<const Lifted_cell<d>> gone_;
    std::span<const Cell_images<d>> came_;
    std::array<Border_facet<d>, most> border_;
    std::size_t size_ = 0;                                              // of the border
    std::array<std::size_t, most> partner_;                             // of new half-facets: another new one
    std::array<std::array<Offset<d>, corners>, most_replaced> offset_;  // of the new cells
};

}  // namespace

template <int d>
bool replace_periodic_cells(Periodic_table<d>& table, std::span<const Lifted_cell<d>> gone,
                            std::span<const Cell_images<d>> came, std::vector<std::size_t>& unused,
                            std::vector<std::size_t>& made) {
    return Replacement<d>(table, gone, came)(unused, made);
}

template <int d>
void close_gaps(Periodic_table<d>& table, std::vector<std::size_t>& unused) {
    std::sort(unused.begin(), unused.end(), std::greater<>());
    for (const std::size_t c : unused) {
        const std::size_t last = table.size() - 1;
        if (c != last) {
            table.vertex[c] = table.vertex[last];
            table.offset[c] = table.offset[last];
            table.twin[c] = table.twin[last];
            for (std::size_t i = 0; i <= d; ++i) {
                const Corner_index t = table.twin[c][i];
                table.twin[table.cell_of(t)][table.slot_of(t)] = table.corner(c, i);
            }
        }
        table.vertex.pop_back();
        table.offset.pop_back();
        table.twin.pop_back();
    }
    unused.clear();
}

template bool replace_periodic_cells(Periodic_table<2>&, std::span<const Lifted_cell<2>>,
                                     std::span<const Cell_images<2>>, std::vector<std::size_t>&,
                                     std::vector<std::size_t>&);
template bool replace_periodic_cells(Periodic_table<3>&, std::span<const Lifted_cell<3>>,
                                     std::span<const Cell_images<3>>, std::vector<std::size_t>&,
                                     std::vector<std::size_t>&);
template void close_gaps(Periodic_table<2>&, std::vector<std::size_t>&);
template void close_gaps(Periodic_table<3>&, std::vector<std::size_t>&);

}  // namespace annulus::inline v1
