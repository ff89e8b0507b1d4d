// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/periodic_mesh.h>

#include <annulus/arithmetic/environment.h>
#include <annulus/arithmetic/limits.h>
#include <annulus/engine/cost_model.h>
#include <annulus/engine/periodic_repair.h>
#include <annulus/kernel/periodic_builder.h>
#include <annulus/measure/periodic_voronoi.h>
#include <annulus/space/lattice.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// A triangulation and what it is of: replaced as a whole.
template <int d>
struct Periodic_state {
    Periodic_state(std::span<const Coordinates<d>> points, const Box<d>& box)
        : lattice(box.vectors()), rounded_box(lattice.box()) {
        given.reserve(points.size());
        place.reserve(points.size());
        image.reserve(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Representative<d> r = lattice.representative(points[i], static_cast<std::int64_t>(i));
            place.push_back(r.place);
            image.push_back(r.image);
            given.push_back(lattice.imaged(r));
        }
    }

    explicit Periodic_state(const Saved_periodic_mesh<d>& saved)
        : lattice(saved.vectors), rounded_box(lattice.box()), place(saved.places), image(saved.images) {
        if (image.size() != place.size()) throw Error(Error_code::bad_input, "not every saved place has an image");
        given.reserve(place.size());
        for (std::size_t i = 0; i < place.size(); ++i) {
            const Representative<d> r{place[i], image[i]};
            if (!lattice.is_representative(r))
                throw Error(Error_code::bad_input, "saved place " + std::to_string(i) + " is none of the saved box",
                            {static_cast<std::int64_t>(i)});
            given.push_back(lattice.imaged(r));
        }
    }

    /// The offset by vectors of the box, between representatives, or, less the images, between given points.
    [[nodiscard]] Shift<d> shift(Image<d> s, bool of_given) const {
        Shift<d> o = lattice.in_box(s.label);
        if (of_given)
            for (std::size_t k = 0; k < d; ++k) o[k] -= image[static_cast<std::size_t>(s.vertex)][k];
        return o;
    }

    Lattice<d> lattice;
    Box<d> rounded_box;
    std::vector<Coordinates<d>> given;
    std::vector<Coordinates<d>> place;
    std::vector<Shift<d>> image;
    Periodic_table<d> table;
};

template <int d>
Shift<d> minus(Shift<d> a, const Shift<d>& b) {
    for (std::size_t k = 0; k < d; ++k) a[k] -= b[k];
    return a;
}

/// The cells with offsets that refer to the given points or to the representatives. Each is moved so that its least
/// offsets are 0.
template <int d>
Periodic_cells<d> listed(const Periodic_state<d>& state, bool of_given) {
    const Periodic_table<d>& table = state.table;
    Periodic_cells<d> cells;
    std::vector<Shift<d>> moved(table.size());  // by cell: what was subtracted
    cells.vertices = table.vertex;
    cells.offsets.resize(table.size());
    cells.neighbours.resize(table.size());
    cells.translations.resize(table.size());
    for (std::size_t c = 0; c < table.size(); ++c) {
        auto& offsets = cells.offsets[c];
        for (std::size_t i = 0; i <= d; ++i) offsets[i] = state.shift(table.image(c, i), of_given);
        moved[c] = offsets[0];
        for (const Shift<d>& o : offsets)
            for (std::size_t k = 0; k < d; ++k) moved[c][k] = std::min(moved[c][k], o[k]);
        for (Shift<d>& o : offsets) o = minus<d>(o, moved[c]);
    }
    for (std::size_t c = 0; c < table.size(); ++c)
        for (std::size_t i = 0; i <= d; ++i) {
            const std::size_t m = table.cell_of(table.twin[c][i]);
            cells.neighbours[c][i] = static_cast<Index>(m);
            Shift<d>& t = cells.translations[c][i];
            t = minus<d>(state.lattice.in_box(table.translation(c, i)), moved[c]);
            for (std::size_t k = 0; k < d; ++k) t[k] += moved[m][k];
        }
    return cells;
}

}  // namespace

template <int d>
struct Periodic_mesh<d>::Parts {
    Parts(std::span<const Point> points, const Box<d>& box, const Periodic_options& chosen)
        : options(chosen), state(placed(points.size(), points, box)) {
        build(state);
    }
    Parts(const Saved_periodic_mesh<d>& saved, const Periodic_options& chosen)
        : options(chosen), state(placed(saved.places.size(), saved)) {
        build(state);
    }

    template <class... Of>
    Periodic_state<d> placed(std::size_t points, const Of&... of) {
        require_sound_environment();
        if (options.threads < 1) throw Error(Error_code::usage, "threads must be 1 or more");
        if (points > Limits::vertices)
            throw Error(Error_code::too_large, "more than " + std::to_string(Limits::vertices) + " points");
        return Periodic_state<d>(of...);
    }
    void build(Periodic_state<d>& at) { builder.build(at.lattice, at.place, options.threads, at.table); }

    Move_result move(Periodic_state<d> next) {
        // What a build costs, a copy of a point, in the unit of cost_model.h; and a little, for few points. Flips of
        // cells with offsets take two to four times what that model says, so it is less than for builds without.
        constexpr double copy = d == 2 ? 25 : 60, little = 8000;
        const std::size_t n = next.place.size();
        Budget budget{little + copy * static_cast<double>(builder.copies())};
        const Periodic_repair_result repaired =
            repair.repair(state.table, {state.lattice, state.place}, {next.lattice, next.place}, budget);
        if (repaired.done) std::swap(next.table, state.table);
        else {
            build(next);
            budget.charge(copy * static_cast<double>(builder.copies()));
        }
        state = std::move(next);
        Move_result result;
        result.moves.asked = n;
        result.moves.flipped = repaired.flipped;
        (repaired.done ? result.moves.kept_in_place : result.moves.rebuilt) = n - repaired.flipped;
        result.statistics.flips = repaired.flips;
        result.statistics.cost = budget.spent;
        return result;
    }

    Periodic_options options;
    Periodic_builder<d> builder;
    Periodic_repair<d> repair;
    Periodic_state<d> state;
};

template <int d>
Periodic_mesh<d>::Periodic_mesh(std::span<const Point> points, const Box<d>& box, const Periodic_options& options)
    : parts_(std::make_unique<Parts>(points, box, options)) {}
template <int d>
Periodic_mesh<d>::Periodic_mesh(const Saved_periodic_mesh<d>& saved, const Periodic_options& options)
    : parts_(std::make_unique<Parts>(saved, options)) {}
template <int d>
Periodic_mesh<d>::~Periodic_mesh() = default;
template <int d>
Periodic_mesh<d>::Periodic_mesh(Periodic_mesh&&) noexcept = default;
template <int d>
Periodic_mesh<d>& Periodic_mesh<d>::operator=(Periodic_mesh&&) noexcept = default;

template <int d>
Move_result Periodic_mesh<d>::move_all(std::span<const Point> points) {
    return move_all(points, Box<d>(parts_->state.lattice.given()));
}
template <int d>
Move_result Periodic_mesh<d>::move_all(std::span<const Point> points, const Box<d>& box) {
    if (points.size() != number_of_vertices())
        throw Error(Error_code::wrong_size, std::to_string(points.size()) + " positions for " +
                                                std::to_string(number_of_vertices()) + " vertices");
    return parts_->move(parts_->placed(points.size(), points, box));
}

template <int d>
std::size_t Periodic_mesh<d>::number_of_vertices() const {
    return parts_->state.place.size();
}
template <int d>
const Box<d>& Periodic_mesh<d>::box() const {
    return parts_->state.rounded_box;
}
template <int d>
auto Periodic_mesh<d>::points() const -> std::span<const Point> {
    return parts_->state.given;
}
template <int d>
auto Periodic_mesh<d>::places() const -> std::span<const Point> {
    return parts_->state.place;
}
template <int d>
std::span<const Shift<d>> Periodic_mesh<d>::images() const {
    return parts_->state.image;
}
template <int d>
auto Periodic_mesh<d>::grid() const -> Point {
    return parts_->state.lattice.grid();
}
template <int d>
std::size_t Periodic_mesh<d>::number_of_cells() const {
    return parts_->state.table.size();
}
template <int d>
Periodic_cells<d> Periodic_mesh<d>::cells() const {
    return listed(parts_->state, true);
}
template <int d>
Periodic_audit_input<d> Periodic_mesh<d>::audit_input() const {
    const Periodic_state<d>& state = parts_->state;
    return {state.place, state.lattice.box(), listed(state, false)};
}
template <int d>
Periodic_neighbours<d> Periodic_mesh<d>::neighbours() const {
    require_sound_environment();
    const Periodic_state<d>& state = parts_->state;
    return periodic_neighbours<d>(state.table, state.lattice, state.place, state.image);
}
template <int d>
std::vector<Index> Periodic_mesh<d>::neighbour_counts(double least_area, bool strict) const {
    if (std::isnan(least_area)) throw Error(Error_code::not_finite, "the least area is not a number");
    const Periodic_neighbours<d> list = neighbours();
    std::vector<Index> counts(number_of_vertices(), 0);
    for (std::size_t k = 0; k < list.first.size(); ++k)
        if (strict ? list.area[k] > least_area : list.area[k] >= least_area)
            ++counts[static_cast<std::size_t>(list.first[k])];
    return counts;
}
template <int d>
std::vector<double> Periodic_mesh<d>::voronoi_volumes() const {
    require_sound_environment();
    const Periodic_state<d>& state = parts_->state;
    return periodic_voronoi_volumes<d>(state.table, state.lattice, state.place);
}
template <int d>
const Periodic_options& Periodic_mesh<d>::options() const {
    return parts_->options;
}
template <int d>
Saved_periodic_mesh<d> Periodic_mesh<d>::saved() const {
    const Periodic_state<d>& state = parts_->state;
    return {state.lattice.given(), state.place, state.image};
}

template class Periodic_mesh<2>;
template class Periodic_mesh<3>;

}  // namespace annulus::inline v1
