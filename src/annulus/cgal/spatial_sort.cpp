// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL sorts in parallel where it is told of TBB, which changes its triangulations too: so it is told here, where there are none. What
// is instantiated here has types of this file among its arguments, so that none of it is instantiated otherwise elsewhere.
#ifndef CGAL_LINKED_WITH_TBB
#define CGAL_LINKED_WITH_TBB
#endif

#include <annulus/cgal/spatial_sort.h>

#include <annulus/mesh/parallel_runs.h>

#include <CGAL/spatial_sort.h>
#include <CGAL/tags.h>

#include <cstddef>

namespace annulus {

namespace {

/// Compares points, named by their indices, by one coordinate.
template <int d, int axis>
struct Less {
    const Coordinates<d>* x;
    bool operator()(Index p, Index q) const {
        return x[static_cast<std::size_t>(p)][axis] < x[static_cast<std::size_t>(q)][axis];
    }
};

/// CGAL's concept SpatialSortingTraits; its points are the indices themselves, so that nothing is copied.
template <int d>
struct By_index;

template <>
struct By_index<2> {
    using Point_2 = Index;
    using Less_x_2 = Less<2, 0>;
    using Less_y_2 = Less<2, 1>;
    const Coordinates<2>* x;
    [[nodiscard]] Less_x_2 less_x_2_object() const { return {x}; }
    [[nodiscard]] Less_y_2 less_y_2_object() const { return {x}; }
};

template <>
struct By_index<3> {
    using Point_3 = Index;
    using Less_x_3 = Less<3, 0>;
    using Less_y_3 = Less<3, 1>;
    using Less_z_3 = Less<3, 2>;
    const Coordinates<3>* x;
    [[nodiscard]] Less_x_3 less_x_3_object() const { return {x}; }
    [[nodiscard]] Less_y_3 less_y_3_object() const { return {x}; }
    [[nodiscard]] Less_z_3 less_z_3_object() const { return {x}; }
};

}  // namespace

template <int d>
void spatial_sort(std::vector<Index>& order, std::span<const Coordinates<d>> x, int threads) {
    constexpr std::size_t few = 1U << 14;  // not worth a second thread
    const By_index<d> traits{x.data()};
    if (threads == 1 || order.size() < few) CGAL::spatial_sort<CGAL::Sequential_tag>(order.begin(), order.end(), traits);
    else in_arena(threads, [&] { CGAL::spatial_sort<CGAL::Parallel_tag>(order.begin(), order.end(), traits); });
}

template void spatial_sort<2>(std::vector<Index>&, std::span<const Coordinates<2>>, int);
template void spatial_sort<3>(std::vector<Index>&, std::span<const Coordinates<3>>, int);

}  // namespace annulus
