// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/solid_mesh.h>

#include <algorithm>
#include <cmath>
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

namespace {

double determinant(const Box<2>::Vectors& v) { return v[0][0] * v[1][1] - v[0][1] * v[1][0]; }
double determinant(const Box<3>::Vectors& v) {
    return v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) - v[0][1] * (v[1][0] * v[2][2] - v[1][2] * v[2][0]) +
           v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
}

/// In which copy of the box a point is. What is in a side up to rounding is above it.
template <int d>
Shift<d> copy_of_box(const typename Box<d>::Vectors& vectors, const Coordinates<d>& p) {
    Shift<d> copy{};
    for (std::size_t k = 0; k < d; ++k) {
        typename Box<d>::Vectors replaced = vectors;
        replaced[k] = p;
        copy[k] = static_cast<std::int32_t>(std::floor(determinant(replaced) / determinant(vectors) + 1e-9));
    }
    return copy;
}

}  // namespace

template <int d>
Solid_mesh<d> cells_in_box(const Boxed_mesh<d>& dt) {
    const Periodic_audit_input<d> in = dt.mesh().audit_input();
    Solid_mesh<d> result;
    std::map<std::pair<Index, Shift<d>>, Index> images;
    for (std::size_t c = 0; c < in.cells.vertices.size(); ++c) {
        std::array<Coordinates<d>, d + 1> corner{};
        Coordinates<d> middle{};
        for (std::size_t k = 0; k <= d; ++k) {
            corner[k] = in.points[static_cast<std::size_t>(in.cells.vertices[c][k])];
            for (std::size_t i = 0; i < d; ++i) {
                for (std::size_t j = 0; j < d; ++j) corner[k][i] += in.cells.offsets[c][k][j] * in.box[j][i];
                middle[i] += corner[k][i] / (d + 1);
            }
        }
        const Shift<d> copy = copy_of_box<d>(in.box, middle);
        auto& cell = result.cells.emplace_back();
        for (std::size_t k = 0; k <= d; ++k) {
            Shift<d> shift = in.cells.offsets[c][k];
            for (std::size_t j = 0; j < d; ++j) {
                shift[j] -= copy[j];
                for (std::size_t i = 0; i < d; ++i) corner[k][i] -= copy[j] * in.box[j][i];
            }
            const Index v = in.cells.vertices[c][k];
            const auto [image, is_new] = images.try_emplace({v, shift}, static_cast<Index>(result.points.size()));
            if (is_new) {
                result.points.push_back(corner[k]);
                result.vertex.push_back(v);
            }
            cell[k] = image->second;
        }
    }
    return result;
}

template Solid_mesh<2> cells_in_box(const Boxed_mesh<2>&);
template Solid_mesh<3> cells_in_box(const Boxed_mesh<3>&);
template Solid_mesh<2> solid_mesh(const Moving_mesh<2>&);
template Solid_mesh<3> solid_mesh(const Moving_mesh<3>&);
template Solid_mesh<2> solid_mesh(const Boxed_mesh<2>&);
template Solid_mesh<3> solid_mesh(const Boxed_mesh<3>&);

}  // namespace annulus::inline v1::cli
