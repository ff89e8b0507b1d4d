// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>
#include <annulus/arithmetic/error.h>
#include <annulus/arithmetic/collision.h>
#include <annulus/cgal/order_age.h>
#include <annulus/cgal/spatial_sort.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace annulus {

/// The order in which the vertices of a CGAL triangulation are inserted: CGAL's spatial sort. It serves for some rebuilds to come,
/// since vertices that were near each other stay so for a while: sorting is a quarter of the time of a rebuild in the plane. Vertices
/// that come are sorted by themselves and follow after the others, until they are many.
template <int d>
class Insertion_order {
  public:
    /// Of the indices i with lives(i). O(n log n), or O(n) when it was sorted a while ago and neighbours in it have not gone far apart.
    template <class Lives>
    std::span<const Index> of(std::span<const Coordinates<d>> x, Lives lives, int threads) {
        if (!sorts(x)) {
            ++uses_;
            if (gone_ || !come_.empty()) take_up_changes(x, lives, threads);
            if (is_of(x.size(), lives) && !age_.is_stale(order_, x)) return order_;
        }
        std::vector<Index> order = living(x.size(), lives);
        spatial_sort<d>(order, x, threads);
        forget();
        age_.note(order, x);
        order_ = std::move(order);
        uses_ = 0;
        return order_;
    }
    /// Whether the next call of of() sorts all of them, as far as some of them tell: of() asks all. O(1).
    [[nodiscard]] bool sorts(std::span<const Coordinates<d>> x) const {
        return order_.empty() || uses_ >= most_uses || age_.seems_stale(order_, x);
    }
    /// Vertex i is going to come, to where another of this index may have been before.
    void note_coming(Index i) {
        constexpr std::size_t few = 16, share = 16;
        if (order_.empty()) return;
        if (come_.size() >= few + order_.size() / share) return forget();
        come_.push_back(i);
        age_.forget(i);
    }
    /// It is going to go.
    void note_going(Index i) noexcept {
        gone_ = true;
        age_.forget(i);
    }
    /// To be called when others take their places.
    void forget() noexcept {
        order_.clear();
        come_.clear();
        gone_ = false;
    }

  private:
    static constexpr int most_uses = 16;

    template <class Lives>
    [[nodiscard]] static std::vector<Index> living(std::size_t bound, Lives lives) {
        std::vector<Index> all;
        all.reserve(bound);
        for (std::size_t i = 0; i < bound; ++i)
            if (lives(static_cast<Index>(i))) all.push_back(static_cast<Index>(i));
        return all;
    }
    /// Whether it has just these: whoever forgets to say who comes pays for a sort, not with a vertex. No index is in it twice.
    template <class Lives>
    [[nodiscard]] bool is_of(std::size_t bound, Lives lives) const {
        std::size_t count = 0;
        for (std::size_t i = 0; i < bound; ++i) count += lives(static_cast<Index>(i)) ? 1U : 0U;
        return count == order_.size() &&
               std::all_of(order_.begin(), order_.end(), [&](Index i) { return at(i) < bound && lives(i); });
    }
    /// Leaves what is known as it is when memory runs out.
    template <class Lives>
    void take_up_changes(std::span<const Coordinates<d>> x, Lives lives, int threads) {
        std::vector<char> left(x.size());  // no more, or not where it was
        for (const Index i : come_)
            if (at(i) < left.size()) left[at(i)] = 1;
        std::vector<Index> newcomers;
        for (std::size_t i = 0; i < left.size(); ++i)
            if (left[i] != 0 && lives(static_cast<Index>(i))) newcomers.push_back(static_cast<Index>(i));
        spatial_sort<d>(newcomers, x, threads);
        order_.reserve(order_.size() + newcomers.size());
        age_.reserve(x.size());
        const auto has_left = [&](Index i) { return at(i) >= left.size() || left[at(i)] != 0 || !lives(i); };
        std::erase_if(order_, has_left);
        order_.insert(order_.end(), newcomers.begin(), newcomers.end());
        age_.note(newcomers, x);
        come_.clear();
        gone_ = false;
    }
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }

    std::vector<Index> order_;
    std::vector<Index> come_;  // since it was sorted or used, some of them more than once
    bool gone_ = false;
    Order_age<d> age_;
    int uses_ = 0;
};

/// Inserts x[i] for every i of the order, the last vertex' place as hint, and calls assign(vertex, i). Throws Error(collision) naming
/// two points of one position. CGAL's insertion of a range of points with info does just this; here the assigner learns of
/// duplicates.
template <class Traits, class Assign>
void insert_in_order(typename Traits::Triangulation& tr, std::span<const Coordinates<Traits::dimension>> x,
                     std::span<const Index> order, Assign assign) {
    typename Traits::Vertex_handle last;
    std::size_t count = 0;
    for (const Index i : order) {
        last = Traits::insert(tr, Traits::point(x[static_cast<std::size_t>(i)]), last);
        if (tr.number_of_vertices() == count)
            throw collision_of("points", "have", last->index(), i);
        ++count;
        assign(last, i);
    }
}

/// The cells of the Delaunay triangulation of some vertices at x (Embedding::delaunay_of). Traits has no info.
template <class Traits>
[[nodiscard]] bool cgal_delaunay_of(std::span<const Coordinates<Traits::dimension>> x, std::span<const Index> vertices,
                                    std::vector<std::array<Index, static_cast<std::size_t>(Traits::dimension + 1)>>& cells) {
    typename Traits::Triangulation tr;
    Traits::edit([&] {
        typename Traits::Vertex_handle last;
        for (const Index i : vertices) {
            last = Traits::insert(tr, Traits::point(x[static_cast<std::size_t>(i)]), last);
            last->set_index(i);
        }
    });
    if (tr.dimension() != Traits::dimension || tr.number_of_vertices() != vertices.size()) return false;
    Traits::for_each_cell(tr, [&](typename Traits::Cell_handle c) {
        auto& v = cells.emplace_back();
        for (int i = 0; i <= Traits::dimension; ++i) {
            const auto w = c->vertex(i);
            v[static_cast<std::size_t>(i)] = tr.is_infinite(w) ? infinite : w->index();
        }
    });
    return true;
}

}  // namespace annulus
