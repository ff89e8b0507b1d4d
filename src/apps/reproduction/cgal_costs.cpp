// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/cgal_costs.h>

#include <annulus/error.h>
#include <apps/report/processor_time.h>

#include <algorithm>
#include <tuple>

namespace annulus::inline v1 {

namespace {

template <int d>
using Cgal = typename Moving_of<d>::Triangulation;
template <int d>
using Vertex = typename Moving_of<d>::Vertex_handle;

template <int d>
typename Moving_of<d>::Point point(const Coordinates<d>& x) {
    return std::apply([](auto... c) { return typename Moving_of<d>::Point(c...); }, x);
}
template <int d>
auto cell_of(Vertex<d> v) {
    if constexpr (d == 2) return v->face();
    else return v->cell();
}
/// The vertices in the order of their indices.
template <int d>
std::vector<Vertex<d>> vertices_of(Cgal<d>& tr) {
    std::vector<Vertex<d>> all;
    for (auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v) all.push_back(v);
    std::sort(all.begin(), all.end(), [](auto a, auto b) { return a->index() < b->index(); });
    return all;
}

}  // namespace

template <int d>
double time_range_insertion(std::span<const Coordinates<d>> x) {
    std::vector<typename Moving_of<d>::Point> points;
    points.reserve(x.size());
    for (const auto& p : x) points.push_back(point<d>(p));
    Cgal<d> tr;
    const double begin = processor_seconds();
    tr.insert(points.begin(), points.end());
    return processor_seconds() - begin;
}

template <int d>
double time_relocation(std::span<const Coordinates<d>> before, std::span<const Coordinates<d>> target) {
    Options options;
    options.strategy = Strategy::rebuild;
    Cgal<d> tr = Moving_of<d>(before, options).triangulation();
    const std::vector<Vertex<d>> all = vertices_of<d>(tr);
    const double begin = processor_seconds();
    for (std::size_t v = 0; v < all.size(); ++v) {
        if (target[v] == before[v]) continue;
        const auto present = tr.number_of_vertices();
        (void)tr.insert(point<d>(target[v]), cell_of<d>(all[v]));
        if (tr.number_of_vertices() == present)
            throw Error(Error_code::duplicate_point, "another vertex is at that position",
                        {static_cast<std::int64_t>(v)});
        tr.remove(all[v]);
    }
    return processor_seconds() - begin;
}

template <int d>
Operation_record time_operations(const Moving_of<d>& dt) {
    Cgal<d> tr = dt.triangulation();
    const std::vector<Vertex<d>> all = vertices_of<d>(tr);
    std::vector<Vertex<d>> taken, near;
    std::vector<typename Moving_of<d>::Point> points;
    for (std::size_t k = 0; k < all.size(); k += 10) {
        taken.push_back(all[k]);
        points.push_back(all[k]->point());
        // A neighbour that is not removed.
        Vertex<d> stays = all[k + 1 < all.size() ? k + 1 : k - 1];
        const auto c = cell_of<d>(all[k]);
        for (int i = 0; i <= d; ++i)
            if (const auto w = c->vertex(i); !tr.is_infinite(w) && w->index() % 10 != 0) stays = w;
        near.push_back(stays);
    }
    Operation_record r;
    r.vertices = taken.size();
    const double begin = processor_seconds();
    for (const auto v : taken) tr.remove(v);
    const double middle = processor_seconds();
    for (std::size_t k = 0; k < points.size(); ++k) (void)tr.insert(points[k], cell_of<d>(near[k]));
    const double end = processor_seconds();
    const auto n = static_cast<double>(std::max<std::size_t>(taken.size(), 1));
    r.removal = (middle - begin) / n;
    r.insertion = (end - middle) / n;
    return r;
}

template double time_range_insertion<2>(std::span<const Coordinates<2>>);
template double time_range_insertion<3>(std::span<const Coordinates<3>>);
template double time_relocation<2>(std::span<const Coordinates<2>>, std::span<const Coordinates<2>>);
template double time_relocation<3>(std::span<const Coordinates<3>>, std::span<const Coordinates<3>>);
template Operation_record time_operations<2>(const Moving_delaunay_2&);
template Operation_record time_operations<3>(const Moving_delaunay_3&);

}  // namespace annulus::inline v1
