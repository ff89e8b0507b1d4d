// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/voronoi_kept_diagram.h>

#include <annulus/measure/voronoi_facets.h>
#include <annulus/measure/voronoi_records.h>
#include <annulus/mesh/at.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// By number of a finite cell its place in the table, ascending.
template <int d>
std::vector<Index> places_of(const Corner_table<d>& table, std::size_t expected) {
    std::vector<Index> places;
    places.reserve(expected);
    for (const Cell_index c : table.cells())
        if (!table.is_infinite(c)) places.push_back(c.value());
    return places;
}

/// Appends elements first to last - 1 of an array to another one.
template <class T>
void append(std::vector<T>& to, const std::vector<T>& from, std::size_t first, std::size_t last) {
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(first),
              from.begin() + static_cast<std::ptrdiff_t>(last));
}

}  // namespace

/// One update: what has changed, and the new diagram.
template <int d>
class Kept_voronoi_diagram<d>::Update {
  public:
    Update(const Kept_voronoi_diagram& old, std::span<const Coordinates<d>> x, const Mesh_cells<d>& cells,
           std::span<const Index> place)
        : old_(old), x_(x), cells_(cells) {
        match(place);
        note_affected();
    }
    /// Whether so many facets are to be computed that copying the others gains nothing.
    [[nodiscard]] bool concerns_most() const { return 2 * affected_vertices_ > x_.size(); }
    /// Computes the diagram; false if its unit is another one.
    bool make(Diagram_parts<d>& parts, Voronoi_diagram<d>& out) {
        const Known_circumcentres<d> known{before_, old_.parts_.centre, old_.parts_.exponent};
        Voronoi_facets<d> facets(x_, cells_, &known);
        if (!facets.input().spans || facets.exponent() != old_.parts_.exponent) return false;
        Facet_records<d> found(x_, facets.exponent(), affected_vertices_ * (d == 2 ? 6 : 16));
        facets.for_each_of(
            affected_cells(), [this](Index i, Index j) { return affected_[at(i)] != 0 || affected_[at(j)] != 0; },
            [&found](const Voronoi_facet<d>& f) { found.add(f, f.ring); });
        computed_ = found.records().size();
        write_vertices(facets, parts, out);
        write_facets(found, out);
        write_cells(found, facets.input().where, out);
        parts.centre = facets.take_centres();
        parts.exponent = facets.exponent();
        parts.spans = true;
        return true;
    }
    [[nodiscard]] std::size_t computed() const { return computed_; }

  private:
    [[nodiscard]] bool is_unmoved(Index v) const { return at(v) < moved_.size() && moved_[at(v)] == 0; }

    /// Which cells are what they were: at the same place, with the same corners, none of which moved.
    void match(std::span<const Index> place) {
        moved_.assign(x_.size(), 1);
        for (std::size_t v = 0; v < std::min(x_.size(), old_.x_.size()); ++v)
            moved_[v] = std::memcmp(&x_[v], &old_.x_[v], sizeof x_[v]) != 0 ? 1 : 0;  // -0 and 0 are equal otherwise
        const auto& old_cells = old_.cells_->cells.vertices;
        before_.assign(place.size(), none);
        after_.assign(old_.place_.size(), none);
        std::size_t b = 0;
        for (std::size_t c = 0; c < place.size(); ++c) {
            while (b < old_.place_.size() && old_.place_[b] < place[c]) ++b;
            if (b == old_.place_.size()) break;
            const auto& corners = cells_.vertices[c];
            if (old_.place_[b] != place[c] || old_cells[b] != corners ||
                !std::all_of(corners.begin(), corners.end(), [this](Index v) { return is_unmoved(v); }))
                continue;
            before_[c] = static_cast<Index>(b);
            after_[b] = static_cast<Index>(c);
        }
    }

    void note_affected() {
        affected_.assign(x_.size(), 0);
        const auto note = [this](const auto& corners) {
            for (const Index v : corners)
                if (at(v) < affected_.size()) affected_[at(v)] = 1;
        };
        for (std::size_t c = 0; c < before_.size(); ++c)
            if (before_[c] == none) note(cells_.vertices[c]);
        for (std::size_t b = 0; b < after_.size(); ++b)
            if (after_[b] == none) note(old_.cells_->cells.vertices[b]);
        affected_vertices_ = static_cast<std::size_t>(std::count(affected_.begin(), affected_.end(), 1));
    }

    [[nodiscard]] std::vector<Index> affected_cells() const {
        std::vector<Index> out;
        for (std::size_t c = 0; c < cells_.vertices.size(); ++c)
            if (std::any_of(cells_.vertices[c].begin(), cells_.vertices[c].end(),
                            [this](Index v) { return affected_[at(v)] != 0; }))
                out.push_back(static_cast<Index>(c));
        return out;
    }

    void write_vertices(Voronoi_facets<d>& facets, Diagram_parts<d>& parts, Voronoi_diagram<d>& out) const {
        for (const auto& [a, b] : old_.parts_.cospherical)
            if (after_[at(a)] != none && after_[at(b)] != none)
                parts.cospherical.push_back({after_[at(a)], after_[at(b)]});
        const std::size_t n = before_.size();
        for (std::size_t c = 0; c < n; ++c) {
            if (before_[c] != none) continue;
            for (std::size_t k = 0; k <= d; ++k) {
                const Index here = static_cast<Index>(c);
                const Index beyond = cells_.neighbours[c][k];
                if (beyond == cells_.outside || (beyond < here && before_[at(beyond)] == none)) continue;
                if (facets.is_cospherical(here, k))
                    parts.cospherical.push_back({std::min(here, beyond), std::max(here, beyond)});
            }
        }
        out.vertex_of_cell = least_connected(n, parts.cospherical);
        out.vertex.resize(n);
        for (std::size_t c = 0; c < n; ++c) {
            const Index first = out.vertex_of_cell[c];
            const Index old = before_[c];
            if (at(first) != c) out.vertex[c] = out.vertex[at(first)];
            else if (old != none && old_.diagram_.vertex_of_cell[at(old)] == old)
                out.vertex[c] = old_.diagram_.vertex[at(old)];
            else out.vertex[c] = facets.vertex(first);
        }
    }

    /// The facets of i with larger indices are all computed if i is affected; if not, all of them are there already.
    void write_facets(const Facet_records<d>& found, Voronoi_diagram<d>& out) const {
        std::vector<const Facet_record<d>*> fresh;
        for (const Facet_record<d>& f : found.records())
            if (affected_[at(f.i)] != 0) fresh.push_back(&f);
        std::sort(fresh.begin(), fresh.end(),
                  [](const auto* a, const auto* b) { return std::pair(a->i, a->j) < std::pair(b->i, b->j); });
        reserve_facets(out, old_.diagram_.pair.size() + fresh.size(),
                       old_.diagram_.ring.size() + found.length_of_rings());
        out.ring_begin.push_back(0);
        const auto& pairs = old_.diagram_.pair;
        const auto first_of = [&pairs](std::size_t from, std::size_t v) {
            return static_cast<std::size_t>(std::lower_bound(pairs.begin() + static_cast<std::ptrdiff_t>(from),
                                                             pairs.end(),
                                                             std::array<Index, 2>{static_cast<Index>(v), 0}) -
                                            pairs.begin());
        };
        std::size_t pair = 0;
        auto next = fresh.begin();
        for (std::size_t v = 0; v < x_.size();) {
            std::size_t end = v;
            while (end < x_.size() && affected_[end] == 0) ++end;
            const std::size_t last = first_of(pair, end);
            copy(pair, last, out);
            for (v = end; v < x_.size() && affected_[v] != 0; ++v)
                for (; next != fresh.end() && at((*next)->i) == v; ++next) {
                    out.pair.push_back({(*next)->i, (*next)->j});
                    found.write(**next, out);
                }
            pair = first_of(last, v);
        }
    }
    /// Facets that are what they were, under other numbers of cells.
    void copy(std::size_t first, std::size_t last, Voronoi_diagram<d>& out) const {
        const Voronoi_diagram<d>& from = old_.diagram_;
        append(out.pair, from.pair, first, last);
        append(out.measure, from.measure, first, last);
        append(out.centroid, from.centroid, first, last);
        append(out.distance, from.distance, first, last);
        append(out.vector, from.vector, first, last);
        append(out.exactly_empty, from.exactly_empty, first, last);
        const Index shift = static_cast<Index>(out.ring.size()) - from.ring_begin[first];
        for (std::size_t k = first; k < last; ++k) out.ring_begin.push_back(from.ring_begin[k + 1] + shift);
        for (Index k = from.ring_begin[first]; k < from.ring_begin[last]; ++k)
            out.ring.push_back(from.ring[at(k)] < 0 ? -1 : after_[at(from.ring[at(k)])]);
    }

    void write_cells(const Facet_records<d>& found, std::span<const Vertex_location> where,
                     Voronoi_diagram<d>& out) const {
        constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
        Coordinates<d> no_centroid;
        no_centroid.fill(nowhere);
        out.volume = old_.diagram_.volume;
        out.surface = old_.diagram_.surface;
        out.cell_centroid = old_.diagram_.cell_centroid;
        out.volume.resize(x_.size(), nowhere);
        out.surface.resize(x_.size(), nowhere);
        out.cell_centroid.resize(x_.size(), no_centroid);
        for (std::size_t v = 0; v < x_.size(); ++v)
            if (affected_[v] != 0) found.write_cell(v, where[v], out);
    }

    const Kept_voronoi_diagram& old_;
    std::span<const Coordinates<d>> x_;
    const Mesh_cells<d>& cells_;
    std::vector<char> moved_, affected_;  // by vertex
    std::vector<Index> before_, after_;   // by cell, by former cell: its number before, and now; none if it changed
    std::size_t affected_vertices_ = 0, computed_ = 0;
};

template <int d>
void Kept_voronoi_diagram<d>::compute_all(std::span<const Coordinates<d>> x, const Mesh_cells<d>& cells) {
    diagram_ = fresh_diagram<d>(x, cells, nullptr, &parts_);
    computed_ = diagram_.pair.size();
}

template <int d>
const Voronoi_diagram<d>& Kept_voronoi_diagram<d>::update(const Corner_table<d>& table,
                                                          std::span<const Coordinates<d>> x,
                                                          const std::shared_ptr<const Cell_lists<d>>& cells) {
    if (cells_ && cells_ == cells && x_.size() == x.size() && std::memcmp(x_.data(), x.data(), x.size_bytes()) == 0) {
        computed_ = 0;
        return diagram_;
    }
    const auto old = std::exchange(cells_, nullptr);  // in case of an exception
    const Mesh_cells<d>& now = cells->cells;
    std::vector<Index> place = places_of(table, now.vertices.size());
    const bool listed = place.size() == now.vertices.size();  // else the cells are those of a hyperplane
    bool made = false;
    if (old && listed && parts_.spans) {
        cells_ = old;
        Update update(*this, x, now, place);
        if (!update.concerns_most()) {
            Diagram_parts<d> parts;
            Voronoi_diagram<d> diagram;
            try {
                made = update.make(parts, diagram);
            } catch (...) {
                cells_ = nullptr;
                throw;
            }
            if (made) {
                parts_ = std::move(parts);
                diagram_ = std::move(diagram);
                computed_ = update.computed();
            }
        }
        cells_ = nullptr;
    }
    if (!made) compute_all(x, now);
    x_.assign(x.begin(), x.end());
    place_ = std::move(place);
    cells_ = parts_.spans && listed ? cells : nullptr;
    return diagram_;
}

template class Kept_voronoi_diagram<2>;
template class Kept_voronoi_diagram<3>;

}  // namespace annulus::inline v1
