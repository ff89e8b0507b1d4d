// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/cavity_retriangulator.h>

#include <annulus/error.h>
#include <annulus/kernel/builder.h>
#include <annulus/mesh/sort_unique.h>

#include <algorithm>

namespace annulus::inline v1 {

namespace {
constexpr int most_rounds = 40;
constexpr std::uint32_t nothing = ~std::uint32_t{0};
constexpr std::size_t many = 1U << 14;  // points: memory for more is not kept

/// A vertex that is set for the duration of a call, however the call ends.
class Set_for_call {
  public:
    Set_for_call(Index& name, Index v) : name_(name) { name_ = v; }
    ~Set_for_call() { name_ = none; }
    Set_for_call(const Set_for_call&) = delete;
    Set_for_call& operator=(const Set_for_call&) = delete;

  private:
    Index& name_;
};
}  // namespace

template <int d>
Cavity_retriangulator<d>::Cavity_retriangulator(Corner_table<d>& table)
    : table_(table), builder_(std::make_unique<Builder<d>>()) {}

template <int d>
Cavity_retriangulator<d>::~Cavity_retriangulator() = default;

template <int d>
bool Cavity_retriangulator<d>::rebuild(std::span<const Coordinates<d>> x, std::span<const Cell_index> cells,
                                       std::size_t most, std::vector<Cell_index>& touched) {
    points_ = 0;
    for (const Cell_index c : marks_.cells) marks_.of[c] = 0;  // those of a call that threw or gave up
    grow(marks_.of, table_.cell_bound());                      // there may be fewer
    marks_.cells.clear();
    for (const Cell_index c : cells) mark(c, 1);
    std::vector<Cell_index> cavity;
    for (const Cell_index first : cells) {
        // A cell that exists and still has mark 1 has not been met in an earlier cavity.
        if (!marks_.of.has(first) || marks_.of[first] != 1 || !table_.is_cell(first)) continue;
        cavity.assign(1, first);
        mark(first, 2);
        for (std::size_t k = 0; k < cavity.size(); ++k)
            for (int i = 0; i <= d; ++i) {
                const Cell_index n = table_.cell_of(table_.twin(table_.corner(cavity[k], i)));
                if (marks_.of[n] != 1) continue;
                mark(n, 2);
                cavity.push_back(n);
            }
        const bool built = rebuild_cavity(x, cavity, most, touched);
        if (points_ > many) {
            builder_->release();
            small_ = {};
            border_ = {};
            new_cells_ = {};
        }
        if (!built) return false;
        grow(marks_.of, table_.cell_bound());
    }
    return true;
}

/// marks_.of is 2 in the cavity.
template <int d>
bool Cavity_retriangulator<d>::rebuild_cavity(std::span<const Coordinates<d>> x, std::vector<Cell_index>& cavity,
                                              std::size_t most, std::vector<Cell_index>& touched) {
    std::vector<Cell_index> beyond;
    for (int round = 0; round < most_rounds; ++round) {
        region_.vertices.clear();
        region_.at_infinity = false;
        for (const Cell_index c : cavity)
            for (const Index v : cell_vertices(table_, c))
                if (v != infinite) region_.vertices.push_back(v);
                else region_.at_infinity = true;
        sort_unique(region_.vertices);
        if (region_.without != none) std::erase(region_.vertices, region_.without);
        if (points_ + region_.vertices.size() > most) return false;
        points_ += region_.vertices.size();
        beyond.clear();
        if (triangulate(x) && fill(cavity, beyond)) {
            std::vector<Cell_index> made;
            replace_cells<d>(table_, cavity, new_cells_.sites, new_cells_.neighbours, made);
            for (const Cell_index c : cavity) marks_.of[c] = 0;
            touched.insert(touched.end(), cavity.begin(), cavity.end());
            touched.insert(touched.end(), made.begin(), made.end());
            return true;
        }
        if (beyond.empty())  // a layer
            for (const Cell_index c : cavity)
                for (int i = 0; i <= d; ++i) beyond.push_back(table_.cell_of(table_.twin(table_.corner(c, i))));
        const std::size_t before = cavity.size();
        for (const Cell_index c : beyond) {
            if (marks_.of[c] == 2) continue;
            mark(c, 2);
            cavity.push_back(c);
        }
        if (cavity.size() == before) return false;  // it is everything
    }
    return false;
}

template <int d>
bool Cavity_retriangulator<d>::remove(std::span<const Coordinates<d>> x, std::span<const Cell_index> cells, Index v,
                                      std::size_t most, std::vector<Cell_index>& touched) {
    const Set_for_call named(region_.without, v);
    return rebuild(x, cells, most, touched);
}

/// Returns false when the vertices are flat, or two of them are at one position.
template <int d>
bool Cavity_retriangulator<d>::triangulate(std::span<const Coordinates<d>> x) {
    try {
        if (!builder_->build(x, region_.vertices)) return false;
    } catch (const Error& e) {
        if (e.code() != Error_code::duplicate_point) throw;
        return false;
    }
    small_.assign(builder_->cell_bound(), {});
    builder_->for_each_cell([this](std::uint32_t number, const Sites& sites, const auto& across) {
        small_[number] = {sites, across, {}, {}, 0};
    });
    return true;
}

template <int d>
std::vector<std::uint32_t> Cavity_retriangulator<d>::match_border() {
    std::vector<std::uint32_t> inside(border_.size(), nothing);
    builder_->for_each_cell([&](std::uint32_t number, const Sites& sites, const auto&) {
        for (int i = 0; i <= d; ++i) {
            const Facet_side<d> side(sites, i);
            border_.for_each_alike(side, [&](std::size_t k) {
                const bool is_inside = border_[k].side.left == side.left;
                if (is_inside) inside[k] = number;
                (is_inside ? small_[number].inside : small_[number].outside)[static_cast<std::size_t>(i)] =
                    static_cast<std::uint32_t>(k + 1);
            });
        }
    });
    return inside;
}

template <int d>
bool Cavity_retriangulator<d>::fill(std::span<const Cell_index> cavity, std::vector<Cell_index>& beyond) {
    const auto cell_beyond = [this](std::size_t k) { return table_.cell_of(border_[k].beyond); };
    border_.clear();
    for (const Cell_index c : cavity) {
        const Sites sites = cell_sites(table_, c);
        for (int i = 0; i <= d; ++i) {
            const Corner_index twin = table_.twin(table_.corner(c, i));
            if (marks_.of[table_.cell_of(twin)] != 2) border_.add(Facet_side<d>(sites, i), twin);
        }
    }
    std::vector<Cell_index> twice;  // beyond facets that occur twice, or from both sides: the cavity bends back
    border_.index([&](std::size_t k, std::size_t j) {
        twice.push_back(cell_beyond(k));
        twice.push_back(cell_beyond(j));
    });
    new_cells_.cells.clear();
    const std::vector<std::uint32_t> inside = match_border();
    for (std::size_t k = 0; k < border_.size(); ++k)
        if (inside[k] == nothing) beyond.push_back(cell_beyond(k));
        else enter(inside[k]);
    if (beyond.empty()) beyond = twice;
    if (!beyond.empty()) return false;
    if (border_.size() == 0)  // the cavity is everything
        builder_->for_each_cell([this](std::uint32_t number, const auto&, const auto&) { enter(number); });
    for (std::size_t k = 0; k < new_cells_.cells.size(); ++k) {
        const Small_cell& c = small_[new_cells_.cells[k]];
        for (std::size_t i = 0; i <= d; ++i) {
            if (c.inside[i] != 0) continue;
            if (c.outside[i] != 0) {  // from outside: the border folds
                beyond.push_back(cell_beyond(c.outside[i] - 1));
                return false;
            }
            enter(c.across[i] / 4);
        }
    }
    link_filled();
    return has_every_vertex();
}

template <int d>
void Cavity_retriangulator<d>::enter(std::uint32_t small) {
    if (small_[small].place != 0) return;
    new_cells_.cells.push_back(small);
    small_[small].place = static_cast<std::uint32_t>(new_cells_.cells.size());
}

template <int d>
void Cavity_retriangulator<d>::link_filled() {
    new_cells_.sites.clear();
    new_cells_.neighbours.clear();
    for (const std::uint32_t small : new_cells_.cells) {
        const Small_cell& c = small_[small];
        new_cells_.sites.push_back(c.sites);
        auto& n = new_cells_.neighbours.emplace_back();
        for (std::size_t i = 0; i <= d; ++i)
            n[i] = c.inside[i] != 0
                       ? Fresh_neighbour{0, border_[c.inside[i] - 1].beyond}
                       : Fresh_neighbour{4 * (small_[c.across[i] / 4].place - 1) + c.across[i] % 4, no_corner};
    }
}

template <int d>
bool Cavity_retriangulator<d>::has_every_vertex() const {
    std::vector<Index> found;
    bool at_infinity = false;
    for (const Sites& x : new_cells_.sites)
        for (const auto& [v, label] : x)
            if (v != infinite) found.push_back(v);
            else at_infinity = true;
    sort_unique(found);
    return found.size() == region_.vertices.size() && at_infinity == region_.at_infinity;
}

template class Cavity_retriangulator<2>;
template class Cavity_retriangulator<3>;

}  // namespace annulus::inline v1
