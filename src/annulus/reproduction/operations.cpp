// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/reproduction/operations.h>

#include <annulus/reproduction/processor_time.h>
#include <annulus/reproduction/published_pieces.h>

#include <algorithm>

namespace annulus {

template <int d>
Operation_record time_operations(const Moving_of<d>& dt) {
    using Pieces = Published_pieces<d>;
    typename Pieces::Triangulation tr = dt.triangulation();
    std::vector<typename Pieces::Vertex> all, near;
    for (auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v) all.push_back(v);
    std::sort(all.begin(), all.end(), [](auto a, auto b) { return a->index() < b->index(); });
    std::vector<typename Pieces::Vertex> taken;
    std::vector<typename Pieces::Point> points;
    for (std::size_t k = 0; k < all.size(); k += 10) {
        taken.push_back(all[k]);
        points.push_back(all[k]->point());
        // A neighbour that is not removed.
        typename Pieces::Vertex stays = all[k + 1 < all.size() ? k + 1 : k - 1];
        const auto c = Pieces::cell_of(all[k]);
        for (int i = 0; i <= d; ++i)
            if (const auto w = c->vertex(i); !tr.is_infinite(w) && w->index() % 10 != 0) stays = w;
        near.push_back(stays);
    }
    Operation_record r;
    r.vertices = taken.size();
    const double begin = processor_seconds();
    for (const auto v : taken) tr.remove(v);
    const double middle = processor_seconds();
    for (std::size_t k = 0; k < points.size(); ++k) (void)tr.insert(points[k], Pieces::cell_of(near[k]));
    const double end = processor_seconds();
    const auto n = static_cast<double>(std::max<std::size_t>(taken.size(), 1));
    r.removal = (middle - begin) / n;
    r.insertion = (end - middle) / n;
    return r;
}

template Operation_record time_operations<2>(const Moving_delaunay_2&);
template Operation_record time_operations<3>(const Moving_delaunay_3&);

}  // namespace annulus
