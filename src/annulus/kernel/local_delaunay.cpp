// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/local_delaunay.h>

#include <annulus/arithmetic/error.h>
#include <annulus/kernel/builder.h>
#include <annulus/mesh/make_unique.h>
#include <annulus/mesh/replace_cells.h>

#include <algorithm>

namespace annulus {

namespace {
constexpr int most_rounds = 40;
constexpr std::size_t many = 1U << 14;  // points: memory for so many is not kept

/// A vertex that is named for the length of a call, however that ends.
class Named {
  public:
    Named(Index& name, Index v) : name_(name) { name_ = v; }
    ~Named() { name_ = none; }
    Named(const Named&) = delete;
    Named& operator=(const Named&) = delete;

  private:
    Index& name_;
};
}  // namespace

template <int d>
Local_delaunay<d>::Local_delaunay(Cell_table<d>& table) : table_(table), builder_(std::make_unique<Builder<d>>()) {}

template <int d>
Local_delaunay<d>::~Local_delaunay() = default;

/// Corners but one, in the order that makes an even permutation of the cell with that one last; turned to a standard
/// order, which is left of it or not.
template <int d>
template <class Cell>
auto Local_delaunay<d>::side(const Sites& x, int slot, Cell cell) -> Side<Cell> {
    Side<Cell> s{{}, false, cell, slot};
    bool odd = (d - slot) % 2 != 0;  // the swaps that bring the corner to the end
    for (int k = 0, n = 0; k <= d; ++k)
        if (k != slot) s.sites[static_cast<std::size_t>(n++)] = x[static_cast<std::size_t>(k)];
    for (std::size_t i = 1; i < s.sites.size(); ++i)
        for (std::size_t j = i; j > 0 && s.sites[j] < s.sites[j - 1]; --j) {
            std::swap(s.sites[j], s.sites[j - 1]);
            odd = !odd;
        }
    s.left = !odd;
    return s;
}

template <int d>
bool Local_delaunay<d>::rebuild(std::span<const Coordinates<d>> x, std::span<const Cell_index> cells, std::size_t most,
                                std::vector<Cell_index>& touched) {
    points_ = 0;
    for (const Cell_index c : marks_.cells) marks_.of[c] = 0;  // those of a call that threw or gave up
    grow(marks_.of, table_.cell_bound());                      // there may be fewer
    marks_.cells.clear();
    for (const Cell_index c : cells) mark(c, 1);
    std::vector<Cell_index> region;
    for (const Cell_index first : cells) {
        // Cells that were marked and are still there have not been met in an earlier region.
        if (!marks_.of.has(first) || marks_.of[first] != 1 || !table_.is_cell(first)) continue;
        region.assign(1, first);
        mark(first, 2);
        for (std::size_t k = 0; k < region.size(); ++k)
            for (int i = 0; i <= d; ++i) {
                const Cell_index n = table_.cell_of(table_.twin(table_.corner(region[k], i)));
                if (marks_.of[n] != 1) continue;
                mark(n, 2);
                region.push_back(n);
            }
        const bool built = rebuild_region(x, region, most, touched);
        if (points_ > many) builder_->release();
        if (!built) return false;
        grow(marks_.of, table_.cell_bound());
    }
    return true;
}

/// marks_.of is 2 in the region.
template <int d>
bool Local_delaunay<d>::rebuild_region(std::span<const Coordinates<d>> x, std::vector<Cell_index>& region,
                                       std::size_t most, std::vector<Cell_index>& touched) {
    std::vector<Cell_index> beyond;
    for (int round = 0; round < most_rounds; ++round) {
        region_.vertices.clear();
        region_.at_infinity = false;
        for (const Cell_index c : region)
            for (const Index v : cell_vertices(table_, c))
                if (v != infinite) region_.vertices.push_back(v);
                else region_.at_infinity = true;
        make_unique(region_.vertices);
        if (region_.without != none) std::erase(region_.vertices, region_.without);
        if (points_ + region_.vertices.size() > most) return false;
        points_ += region_.vertices.size();
        made_.cells.clear();
        beyond.clear();
        if (triangulate(x) && fill(region, beyond)) {
            std::vector<Cell_index> made;
            replace_cells<d>(table_, region, filled_, made);
            for (const Cell_index c : region) marks_.of[c] = 0;
            touched.insert(touched.end(), region.begin(), region.end());
            touched.insert(touched.end(), made.begin(), made.end());
            return true;
        }
        if (beyond.empty())  // a layer
            for (const Cell_index c : region)
                for (int i = 0; i <= d; ++i) beyond.push_back(table_.cell_of(table_.twin(table_.corner(c, i))));
        const std::size_t before = region.size();
        for (const Cell_index c : beyond) {
            if (marks_.of[c] == 2) continue;
            mark(c, 2);
            region.push_back(c);
        }
        if (region.size() == before) return false;  // it is everything
    }
    return false;
}

template <int d>
bool Local_delaunay<d>::remove(std::span<const Coordinates<d>> x, std::span<const Cell_index> cells, Index v,
                               std::size_t most, std::vector<Cell_index>& touched) {
    const Named named(region_.without, v);
    return rebuild(x, cells, most, touched);
}

/// False when the vertices are flat, or two of them are at one place.
template <int d>
bool Local_delaunay<d>::triangulate(std::span<const Coordinates<d>> x) {
    try {
        if (!builder_->build(x, region_.vertices)) return false;
    } catch (const Error& e) {
        if (e.code() != Error_code::collision) throw;
        return false;
    }
    builder_->for_each_cell([this](const Sites& cell) { made_.cells.push_back(cell); });
    return true;
}

template <int d>
bool Local_delaunay<d>::fill(std::span<const Cell_index> region, std::vector<Cell_index>& beyond) {
    const auto precedes = [](const auto& l, const auto& r) { return l.precedes(r); };
    made_.sides.clear();
    for (Small_index c(0); made_.cells.has(c); ++c)
        for (int i = 0; i <= d; ++i) made_.sides.push_back(side(made_.cells[c], i, c));
    std::sort(made_.sides.begin(), made_.sides.end(), precedes);
    border_.clear();
    std::vector<Small_index> behind;
    Indexed<Small_index, char> met(made_.cells.size(), 0);
    const auto enter = [&](Small_index c) {
        if (met[c] != 0) return;
        met[c] = 1;
        behind.push_back(c);
    };
    for (const Cell_index c : region)
        for (int i = 0; i <= d; ++i) {
            const Cell_index out = table_.cell_of(table_.twin(table_.corner(c, i)));
            if (marks_.of[out] == 2) continue;
            border_.push_back(side(cell_sites(table_, c), i, out));
            const auto it = std::lower_bound(made_.sides.begin(), made_.sides.end(), border_.back(), precedes);
            if (it == made_.sides.end() || precedes(border_.back(), *it)) {
                beyond.push_back(out);
                continue;
            }
            enter(it->cell);
        }
    if (!beyond.empty()) return false;
    if (border_.empty()) {  // the region is everything
        filled_ = made_.cells;
        return has_every_vertex();
    }
    std::sort(border_.begin(), border_.end(), precedes);
    for (std::size_t i = 1; i < border_.size(); ++i)
        if (border_[i].same_facet(border_[i - 1])) {  // twice, or from both sides: the region bends back to itself
            beyond.push_back(border_[i].cell);
            beyond.push_back(border_[i - 1].cell);
        }
    if (!beyond.empty()) return false;
    filled_.clear();
    for (std::size_t k = 0; k < behind.size(); ++k) {
        const Sites& x = made_.cells[behind[k]];
        filled_.push_back(x);
        for (int i = 0; i <= d; ++i) {
            Side<Small_index> own = side(x, i, behind[k]);
            const auto border = std::lower_bound(border_.begin(), border_.end(), own, precedes);
            if (border != border_.end() && !precedes(own, *border)) continue;
            own.left = !own.left;
            const auto turned = std::lower_bound(border_.begin(), border_.end(), own, precedes);
            if (turned != border_.end() && !precedes(own, *turned)) {  // from outside: the border folds
                beyond.push_back(turned->cell);
                return false;
            }
            const auto it = std::lower_bound(made_.sides.begin(), made_.sides.end(), own, precedes);
            if (it == made_.sides.end() || precedes(own, *it)) return false;
            enter(it->cell);
        }
    }
    return has_every_vertex();
}

template <int d>
bool Local_delaunay<d>::has_every_vertex() const {
    std::vector<Index> found;
    bool at_infinity = false;
    for (const Sites& x : filled_)
        for (const auto& [v, label] : x)
            if (v != infinite) found.push_back(v);
            else at_infinity = true;
    make_unique(found);
    return found.size() == region_.vertices.size() && at_infinity == region_.at_infinity;
}

template class Local_delaunay<2>;
template class Local_delaunay<3>;

}  // namespace annulus
