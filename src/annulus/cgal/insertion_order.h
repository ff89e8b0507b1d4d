// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>
#include <annulus/arithmetic/error.h>
#include <annulus/cgal/order_age.h>
#include <annulus/cgal/spatial_sort.h>

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace annulus {

/// The order in which the vertices of a CGAL triangulation are inserted: CGAL's spatial sort. It serves for some rebuilds to come,
/// since vertices that were near each other stay so for a while: sorting is a quarter of the time of a rebuild in the plane.
template <int d>
class Insertion_order {
  public:
    /// Of the indices i with lives(i). O(n log n), or O(1) when it was sorted a while ago and vertices have not gone far.
    template <class Lives>
    std::span<const Index> of(std::span<const Coordinates<d>> x, Lives lives, int threads) {
        constexpr int most_uses = 16;
        if (!order_.empty() && uses_++ < most_uses && !age_.is_stale(order_, x)) return order_;
        uses_ = 0;
        std::vector<Index> order;
        order.reserve(x.size());
        for (std::size_t i = 0; i < x.size(); ++i)
            if (lives(static_cast<Index>(i))) order.push_back(static_cast<Index>(i));
        spatial_sort<d>(order, x, threads);
        order_ = std::move(order);
        age_.note(order_, x);
        return order_;
    }
    /// To be called when vertices come or go.
    void forget() noexcept { order_.clear(); }

  private:
    std::vector<Index> order_;
    Order_age<d> age_;
    int uses_ = 0;
};

/// Inserts x[i] for every i of the order, the last vertex' place as hint, and calls assign(vertex, i). Throws Error(collision) naming
/// a point whose position another has. CGAL's insertion of a range of points with info does just this; here the assigner learns of
/// duplicates.
template <class Traits, class Assign>
void insert_in_order(typename Traits::Triangulation& tr, std::span<const Coordinates<Traits::dimension>> x,
                     std::span<const Index> order, Assign assign) {
    typename Traits::Vertex_handle last;
    std::size_t count = 0;
    for (const Index i : order) {
        last = Traits::insert(tr, Traits::point(x[static_cast<std::size_t>(i)]), last);
        if (tr.number_of_vertices() == count)
            throw Error(Error_code::collision, "point " + std::to_string(i) + " has the position of another point");
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
