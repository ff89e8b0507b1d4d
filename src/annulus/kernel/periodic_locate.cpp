// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/periodic_locate.h>

#include <annulus/predicate/exact_sign.h>
#include <annulus/predicate/orientation_sign.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace annulus::inline v1 {

namespace {

/// The cells of a table as a point p, or an image of it, sees them.
template <int d>
class Seen_from {
  public:
    Seen_from(const Periodic_table<d>& table, const Lattice<d>& lattice, std::span<const Coordinates<d>> place,
              const Coordinates<d>& p)
        : table_(table), lattice_(lattice), place_(place), p_(p) {}

    /// The offset with which p is near the first corner of cell c.
    [[nodiscard]] Offset<d> nearest(std::size_t c) const {
        const Coordinates<d> x = corner(c, 0);
        Coordinates<d> way;
        for (std::size_t i = 0; i < d; ++i) way[i] = x[i] - p_[i];
        way = lattice_.in_basis(way);
        Shift<d> o;
        for (std::size_t j = 0; j < d; ++j) o[j] = static_cast<std::int32_t>(std::nearbyint(way[j]));
        return Offset<d>(o);
    }
    /// The squared distance of p with this offset from the first corner of c.
    [[nodiscard]] double squared_distance(std::size_t c, Offset<d> offset) const {
        const Coordinates<d> x = corner(c, 0), q = lattice_.place(p_, offset);
        double squared = 0;
        for (std::size_t i = 0; i < d; ++i) squared += (x[i] - q[i]) * (x[i] - q[i]);
        return squared;
    }
    /// A facet of c that p is beyond, by its corner; d + 1 where c contains p. Begins at corner `first`.
    [[nodiscard]] std::size_t facet_before(Lifted_cell<d> c, std::size_t first) const {
        std::array<Coordinates<d>, static_cast<std::size_t>(d + 1)> x;
        for (std::size_t i = 0; i <= d; ++i) x[i] = corner(c.cell, i);
        const Coordinates<d> q = lattice_.place(p_, c.shift);
        for (std::size_t k = 0; k <= d; ++k) {
            const std::size_t i = (k + first) % (d + 1);
            Tuple<d, d + 1> corners;
            for (std::size_t j = 0; j <= d; ++j) corners[j] = j == i ? &q : &x[j];
            const int clear = orientation_sign(corners);
            if ((clear != 0 ? clear : exact_orientation_sign(corners).sign) < 0) return i;
        }
        return d + 1;
    }

  private:
    [[nodiscard]] Coordinates<d> corner(std::size_t c, std::size_t i) const {
        const Image<d> s = table_.image(c, i);
        return lattice_.place(place_[static_cast<std::size_t>(s.vertex)], s.label);
    }

    const Periodic_table<d>& table_;
    const Lattice<d>& lattice_;
    std::span<const Coordinates<d>> place_;
    Coordinates<d> p_;
};

}  // namespace

/// A walk that crosses any facet that p is beyond; it ends, since the power of p to the spheres of its cells falls.
template <int d>
std::optional<Lifted_cell<d>> walk_to(const Periodic_table<d>& table, const Lattice<d>& lattice,
                                      std::span<const Coordinates<d>> place, const Coordinates<d>& p) {
    const Seen_from<d> seen(table, lattice, place, p);
    const auto samples = static_cast<std::size_t>(std::pow(static_cast<double>(table.size()), 1.0 / (d + 1)));
    Lifted_cell<d> at{};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < table.size(); c += table.size() / (samples + 1) + 1) {
        const Offset<d> offset = seen.nearest(c);
        const double squared = seen.squared_distance(c, offset);
        if (squared >= least) continue;
        least = squared;
        at = {c, offset};
    }
    for (std::size_t step = 0; step <= 8 * table.size() + 64 && is_near(at.shift); ++step) {
        const std::size_t i = seen.facet_before(at, step);
        if (i > d) return at;
        at = {table.cell_of(table.twin[at.cell][i]), at.shift - table.translation(at.cell, i)};
    }
    return {};
}

/// In the basis the edges of a cell have coordinates up to 2.5, so that p is within 3 of the nearest image.
template <int d>
Lifted_cell<d> search_for(const Periodic_table<d>& table, const Lattice<d>& lattice,
                          std::span<const Coordinates<d>> place, const Coordinates<d>& p) {
    constexpr std::int32_t most = 3;
    const Seen_from<d> seen(table, lattice, place, p);
    for (std::size_t c = 0; c < table.size(); ++c) {
        const Offset<d> near = seen.nearest(c);
        Shift<d> o;
        o.fill(-most);
        for (std::size_t i = 0; i < d;) {
            const Lifted_cell<d> at{c, near + Offset<d>(o)};
            if (is_near(at.shift) && seen.facet_before(at, 0) > d) return at;
            for (i = 0; i < d && ++o[i] > most; ++i) o[i] = -most;
        }
    }
    throw std::logic_error("no cell of a box contains a point: please report this");
}

template <int d>
Lifted_cell<d> locate(const Periodic_table<d>& table, const Lattice<d>& lattice, std::span<const Coordinates<d>> place,
                      const Coordinates<d>& p) {
    const auto found = walk_to(table, lattice, place, p);
    return found ? *found : search_for(table, lattice, place, p);
}

template std::optional<Lifted_cell<2>> walk_to(const Periodic_table<2>&, const Lattice<2>&,
                                               std::span<const Coordinates<2>>, const Coordinates<2>&);
template std::optional<Lifted_cell<3>> walk_to(const Periodic_table<3>&, const Lattice<3>&,
                                               std::span<const Coordinates<3>>, const Coordinates<3>&);
template Lifted_cell<2> search_for(const Periodic_table<2>&, const Lattice<2>&, std::span<const Coordinates<2>>,
                                   const Coordinates<2>&);
template Lifted_cell<3> search_for(const Periodic_table<3>&, const Lattice<3>&, std::span<const Coordinates<3>>,
                                   const Coordinates<3>&);
template Lifted_cell<2> locate(const Periodic_table<2>&, const Lattice<2>&, std::span<const Coordinates<2>>,
                               const Coordinates<2>&);
template Lifted_cell<3> locate(const Periodic_table<3>&, const Lattice<3>&, std::span<const Coordinates<3>>,
                               const Coordinates<3>&);

}  // namespace annulus::inline v1
