// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/solid_mesh.h>

#include <algorithm>
#include <map>
#include <utility>

namespace annulus::inline v1::cli {

template <int d>
Solid_mesh<d> solid_mesh(const Moving_mesh<d>& dt) {
    Solid_mesh<d> result;
    std::vector<Index> place(dt.index_bound(), none);
    for (std::size_t i = 0; i < place.size(); ++i) {
        if (!dt.is_vertex(static_cast<Index>(i))) continue;
        place[i] = static_cast<Index>(result.points.size());
        result.points.push_back(dt.points()[i]);
        result.vertex.push_back(static_cast<Index>(i));
    }
    for (auto cell : dt.cells().vertices) {
        if (cell[d] == none) continue;  // the cell of a flat set
        for (Index& v : cell) v = place[static_cast<std::size_t>(v)];
        result.cells.push_back(cell);
    }
    return result;
}

template <int d>
Solid_mesh<d> solid_mesh(const Boxed_mesh<d>& dt) {
    Periodic_audit_input<d> in = dt.mesh().audit_input();
    Solid_mesh<d> result{std::move(in.points), {}, std::move(in.cells.vertices)};
    for (std::size_t i = 0; i < result.points.size(); ++i) result.vertex.push_back(static_cast<Index>(i));
    std::map<std::pair<Index, Shift<d>>, Index> images;
    for (std::size_t c = 0; c < result.cells.size(); ++c)
        for (std::size_t k = 0; k <= d; ++k) {
            const Shift<d>& shift = in.cells.offsets[c][k];
            if (shift == Shift<d>{}) continue;
            Index& corner = result.cells[c][k];
            const auto [image, is_new] = images.try_emplace({corner, shift}, static_cast<Index>(result.points.size()));
            if (is_new) {
                Coordinates<d> p = result.points[static_cast<std::size_t>(corner)];
                for (std::size_t j = 0; j < d; ++j)
                    for (std::size_t i = 0; i < d; ++i) p[i] += shift[j] * in.box[j][i];
                result.points.push_back(p);
                result.vertex.push_back(corner);
            }
            corner = image->second;
        }
    return result;
}

template Solid_mesh<2> solid_mesh(const Moving_mesh<2>&);
template Solid_mesh<3> solid_mesh(const Moving_mesh<3>&);
template Solid_mesh<2> solid_mesh(const Boxed_mesh<2>&);
template Solid_mesh<3> solid_mesh(const Boxed_mesh<3>&);

}  // namespace annulus::inline v1::cli
