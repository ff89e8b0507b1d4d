// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/periodic_builder.h>

#include <annulus/arithmetic/limits.h>
#include <annulus/kernel/builder.h>
#include <annulus/kernel/coinciding_images.h>
#include <annulus/kernel/periodic_proof.h>
#include <annulus/mesh/corner_table.h>
#include <annulus/predicate/sphere_terms.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

namespace {

constexpr double first_collar[] = {0, 0, 2.0, 1.5};  // by dimension, in mean spacings
constexpr double wider = 1.4;

/// The mean distance of neighbours, roughly. In a box that is thinner than that, points are spread over its other
/// directions only.
template <int d>
double mean_spacing(double volume, Coordinates<d> heights, std::size_t points) {
    std::sort(heights.begin(), heights.end());
    const auto spacing = [&](std::size_t thin) {
        return std::pow(volume / static_cast<double>(points), 1.0 / static_cast<double>(d - thin));
    };
    std::size_t thin = 0;
    while (thin + 1 < d && heights[thin] < spacing(thin)) volume /= heights[thin++];
    return spacing(thin);
}

/// The circumcentre of a cell relative to its first corner, from where the others are relative to it. Rounded, and NaN
/// or far off where the cell is nearly flat.
Coordinates<2> circumcentre_of(const std::array<Coordinates<2>, 2>& u) {
    const auto terms = sphere_terms(Vector_2<double>{u[0][0], u[0][1]}, Vector_2<double>{u[1][0], u[1][1]});
    const double scale = -0.5 / terms.determinant;
    return {scale * terms.normal.x, scale * terms.normal.y};
}
Coordinates<3> circumcentre_of(const std::array<Coordinates<3>, 3>& u) {
    const auto terms =
        sphere_terms(Vector_3<double>{u[0][0], u[0][1], u[0][2]}, Vector_3<double>{u[1][0], u[1][1], u[1][2]},
                     Vector_3<double>{u[2][0], u[2][1], u[2][2]});
    const double scale = 0.5 / terms.determinant;
    return {scale * terms.normal.x, scale * terms.normal.y, scale * terms.normal.z};
}

/// A facet up to a translation, and where it is.
template <int d>
struct Open_facet {
    Facet_images<d> images;
    Corner_index corner;
};

/// The facet opposite to corner i, its first image at offset 0.
template <int d>
Open_facet<d> open_facet(const Periodic_table<d>& table, std::size_t c, std::size_t i) {
    Open_facet<d> h{facet_images<d>(table.images(c), i), table.corner(c, i)};
    const Offset<d> first = h.images[0].label;
    for (Image<d>& s : h.images) s.label = s.label - first;
    return h;
}

}  // namespace

/// One build.
template <int d>
struct Periodic_builder<d>::Work {
    /// Where a vertex is.
    struct Home {
        Coordinates<d> fraction;  // coordinates in the basis of the image in its cell, at least 0 and below 1
        Offset<d> offset;         // of this image
        bool deep;                // it is in no collar of another basis cell
    };

    void copy_into(const Lattice<d>& lattice, std::span<const Coordinates<d>> place, const Coordinates<d>& collar);
    [[nodiscard]] bool triangulate_copies(const Lattice<d>& lattice, std::span<const Coordinates<d>> place,
                                          int threads);
    /// False where the kept cells do not fit together.
    [[nodiscard]] bool keep_one_of_each(const Lattice<d>& lattice, bool by_centre, Periodic_table<d>& table);
    /// Whether the circumcentre is in the basis' cell: true of one translate of a cell at most, and where all are among
    /// the copies, of exactly one.
    [[nodiscard]] bool has_centre_at_home(const Lattice<d>& lattice,
                                          std::array<Index, static_cast<std::size_t>(d + 1)> copies) const;
    [[nodiscard]] bool match_facets(Periodic_table<d>& table);

    Builder<d> builder;
    std::vector<Coordinates<d>> copy;  // places
    std::vector<Image<d>> image;       // by copy
    std::vector<Home> home;            // by vertex
    std::vector<Index> numbers;        // 0, 1, 2 ..
    Corner_table<d> cells;             // of the copies, in an order that does not depend on threads
    std::vector<Index> kept;           // by cell of the copies: its number in the table, or -1
};

template <int d>
Periodic_builder<d>::Periodic_builder() = default;

template <int d>
Periodic_builder<d>::~Periodic_builder() = default;

template <int d>
void Periodic_builder<d>::end_step() noexcept {
    work_.end_step();
}

template <int d>
void Periodic_builder<d>::release() noexcept {
    work_.release();
}

template <int d>
void Periodic_builder<d>::build(const Lattice<d>& lattice, std::span<const Coordinates<d>> place, int threads,
                                Periodic_table<d>& table) {
    table.clear();
    copies_ = 0;
    attempts_ = 0;
    const auto points = static_cast<std::size_t>(std::count_if(place.begin(), place.end(), is_place<d>));
    if (points == 0) return;
    const Coordinates<d> heights = lattice.heights();
    Work& work = work_.get();
    const double spacing = mean_spacing<d>(lattice.volume(), heights, points);
    for (double width = first_collar[d] * spacing;; width *= wider) {
        ++attempts_;
        Coordinates<d> collar;
        bool widest = true;
        for (std::size_t i = 0; i < d; ++i) {
            collar[i] = std::min(width / heights[i], lattice.reach()[i]);
            widest = widest && collar[i] == lattice.reach()[i];
        }
        work.copy_into(lattice, place, collar);
        copies_ = work.copy.size();
        if (work.triangulate_copies(lattice, place, threads) && work.keep_one_of_each(lattice, !widest, table) &&
            is_proved_delaunay(table, lattice, place, threads))
            return;
        if (widest) throw std::logic_error("a periodic triangulation was not proved: please report this");
    }
}

/// All images with coordinates in the basis from -collar to 1 + collar.
template <int d>
void Periodic_builder<d>::Work::copy_into(const Lattice<d>& lattice, std::span<const Coordinates<d>> place,
                                          const Coordinates<d>& collar) {
    copy.clear();
    image.clear();
    home.resize(place.size());
    for (std::size_t v = 0; v < place.size(); ++v) {
        if (!is_place<d>(place[v])) continue;
        const Coordinates<d> f = lattice.in_basis(place[v]);
        Shift<d> low, high, o;
        Home& here = home[v];
        here.deep = true;
        for (std::size_t i = 0; i < d; ++i) {
            const double whole = std::floor(f[i]);
            low[i] = static_cast<std::int32_t>(std::ceil(-collar[i] - f[i]));
            high[i] = static_cast<std::int32_t>(std::floor(1 + collar[i] - f[i]));
            o[i] = static_cast<std::int32_t>(-whole);
            here.fraction[i] = f[i] - whole;
            here.deep = here.deep && low[i] == high[i];
        }
        here.offset = Offset<d>(o);
        for (o = low;;) {
            const Offset<d> offset(o);
            copy.push_back(lattice.place(place[v], offset));
            image.emplace_back(static_cast<Index>(v), offset);
            std::size_t i = 0;
            while (i < d && ++o[i] > high[i]) {
                o[i] = low[i];
                ++i;
            }
            if (i == d) break;
        }
    }
    if (copy.size() > Limits::vertices)
        throw Error(Error_code::too_large, "more than " + std::to_string(Limits::vertices) + " copies of points");
}

/// False where the copies are in a hyperplane.
template <int d>
bool Periodic_builder<d>::Work::triangulate_copies(const Lattice<d>& lattice, std::span<const Coordinates<d>> place,
                                                   int threads) {
    numbers.resize(copy.size());
    std::iota(numbers.begin(), numbers.end(), Index{0});
    try {
        if (!builder.build(copy, numbers, threads)) return false;
    } catch (const Error& e) {
        if (e.code() != Error_code::duplicate_point || e.vertices().empty()) throw;
        throw coinciding_images_error<d>(lattice, place);
    }
    builder.copy_to(cells, copy.size(), threads);
    return true;
}

/// What is computed is the same, bit for bit, for each translate: differences of places are not rounded, the order of
/// the corners is that of their images, and what a translation adds is subtracted from both sides of a comparison.
template <int d>
bool Periodic_builder<d>::Work::has_centre_at_home(const Lattice<d>& lattice,
                                                   std::array<Index, static_cast<std::size_t>(d + 1)> copies) const {
    const auto image_of = [this](Index c) -> const Image<d>& { return image[static_cast<std::size_t>(c)]; };
    const auto place = [this](Index c) -> const Coordinates<d>& { return copy[static_cast<std::size_t>(c)]; };
    std::sort(copies.begin(), copies.end(), [&](Index l, Index r) { return image_of(l) < image_of(r); });
    std::array<Coordinates<d>, static_cast<std::size_t>(d)> u;
    for (std::size_t k = 0; k < d; ++k)
        for (std::size_t i = 0; i < d; ++i) u[k][i] = place(copies[k + 1])[i] - place(copies[0])[i];
    const Coordinates<d> centre = lattice.in_basis(circumcentre_of(u));
    const Home& first = home[static_cast<std::size_t>(image_of(copies[0]).vertex)];
    const Shift<d> away = (image_of(copies[0]).label - first.offset).unpacked();
    bool inside = true;  // not where the centre is NaN
    for (std::size_t i = 0; i < d; ++i) {
        const double f = first.fraction[i] + centre[i];
        inside = inside && f >= -away[i] && f < 1 - away[i];
    }
    return inside;
}

template <int d>
bool Periodic_builder<d>::Work::keep_one_of_each(const Lattice<d>& lattice, bool by_centre, Periodic_table<d>& table) {
    table.clear();
    kept.assign(cells.cell_bound().offset(), -1);
    for (const Cell_index c : cells.finite_cells()) {
        std::array<Index, static_cast<std::size_t>(d + 1)> copies;
        Cell_images<d> cell;
        bool deep = true;
        for (std::size_t i = 0; i <= d; ++i) {
            copies[i] = cells.vertex(cells.corner(c, static_cast<int>(i)));
            cell[i] = image[static_cast<std::size_t>(copies[i])];
            deep = deep && home[static_cast<std::size_t>(cell[i].vertex)].deep;
        }
        if (by_centre) {
            if (!deep && !has_centre_at_home(lattice, copies)) continue;
        } else {
            const Image<d> least = *std::min_element(cell.begin(), cell.end());
            if (least.label != home[static_cast<std::size_t>(least.vertex)].offset) continue;
        }
        kept[c.offset()] = static_cast<Index>(table.size());
        auto& vertex = table.vertex.emplace_back();
        auto& offset = table.offset.emplace_back();
        auto& twin = table.twin.emplace_back();
        for (std::size_t i = 0; i <= d; ++i) {
            vertex[i] = cell[i].vertex;
            offset[i] = cell[i].label;
            twin[i] = cells.twin(cells.corner(c, static_cast<int>(i)));  // a cell of the copies
        }
    }
    return match_facets(table);
}

template <int d>
bool Periodic_builder<d>::Work::match_facets(Periodic_table<d>& table) {
    std::vector<Open_facet<d>> open;
    for (std::size_t c = 0; c < table.size(); ++c)
        for (std::size_t i = 0; i <= d; ++i) {
            const Corner_index t = table.twin[c][i];
            const Index m = kept[table.cell_of(t)];
            table.twin[c][i] = m < 0 ? no_corner : table.corner(static_cast<std::size_t>(m), table.slot_of(t));
            if (m < 0) open.push_back(open_facet(table, c, i));
        }
    std::sort(open.begin(), open.end(), [](const Open_facet<d>& l, const Open_facet<d>& r) {
        return l.images != r.images ? l.images < r.images : l.corner < r.corner;
    });
    if (open.size() % 2 != 0) return false;
    const auto twin = [&](Corner_index h) -> Corner_index& { return table.twin[table.cell_of(h)][table.slot_of(h)]; };
    for (std::size_t k = 0; k < open.size(); k += 2) {
        if (open[k].images != open[k + 1].images) return false;
        twin(open[k].corner) = open[k + 1].corner;
        twin(open[k + 1].corner) = open[k].corner;
    }
    return std::all_of(table.offset.begin(), table.offset.end(), [](auto& offset) { return normalise<d>(offset); });
}

template class Periodic_builder<2>;
template class Periodic_builder<3>;

}  // namespace annulus::inline v1
