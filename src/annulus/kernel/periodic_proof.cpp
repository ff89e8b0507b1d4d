// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/periodic_proof.h>

#include <annulus/arithmetic/exact.h>
#include <annulus/mesh/clear_cells.h>
#include <annulus/mesh/clear_periodic_cells.h>
#include <annulus/predicate/bounds.h>
#include <annulus/predicate/circumcircle_2.h>
#include <annulus/predicate/circumsphere_3.h>
#include <annulus/predicate/exact_sign.h>
#include <annulus/predicate/perturbed_sign.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <vector>

namespace annulus::inline v1 {

namespace {

template <int d>
class Periodic_proof {
  public:
    Periodic_proof(Periodic_table<d>& table, const Lattice<d>& lattice, std::span<const Coordinates<d>> place)
        : table_(table), lattice_(lattice), place_(place) {}

    /// By at most this many threads.
    [[nodiscard]] bool operator()(int threads = 1) {
        if (!is_glued() || !has_every_vertex()) return false;
        table_.cospherical.assign(table_.size(), {});
        if (!is_right(threads)) return false;
        sum_ = error_ = 0;
        for (std::size_t c = 0; c < table_.size(); ++c) add_volume(places(c), 1);
        return covers_once();
    }

    [[nodiscard]] bool operator()(const Periodic_table_changes<d>& changes) {
        std::vector<std::size_t> came;
        std::vector<const Kept_cell<d>*> gone;
        for (const Kept_cell<d>& k : changes.journal.kept()) {
            if (is_same(k)) {
                if (!is_glued_again(k)) return false;
                continue;
            }
            gone.push_back(&k);
            if (k.cell < table_.size()) came.push_back(k.cell);
        }
        for (std::size_t c = changes.journal.size(); c < table_.size(); ++c) came.push_back(c);
        if (!is_glued(came, gone) || !has_every_vertex(came, gone)) return false;
        for (const Kept_cell<d>* const k : gone) {
            Places x;
            for (std::size_t i = 0; i <= d; ++i) x[i] = at(changes.place, Image<d>(k->vertex[i], k->offset[i]));
            add_volume(x, -1);
        }
        for (const std::size_t c : came) add_volume(places(c), 1);
        for (const std::size_t c : changes.unfinished)
            if (c < table_.size()) came.push_back(c);
        for (const std::size_t c : came) forget_cospherical(c);
        for (const std::size_t c : came)
            if (!is_right(c, 0)) return false;
        const double whole = parts * lattice_.volume();
        if (error_ + error_of_lattice() < whole / 8) return std::fabs(sum_) < whole / 4;
        return (*this)();
    }

  private:
    using Table = Periodic_table<d>;
    using Places = std::array<Coordinates<d>, static_cast<std::size_t>(d + 1)>;
    using Sphere = std::conditional_t<d == 2, Circumcircle_2, Circumsphere_3>;

    static constexpr double parts = d == 2 ? 2 : 6;  // of the volume of a parallelepiped is a cell

    [[nodiscard]] Coordinates<d> at(std::span<const Coordinates<d>> place, Image<d> s) const {
        const Coordinates<d>& x = place[static_cast<std::size_t>(s.vertex)];
        return s.label.is_zero() ? x : lattice_.place(x, s.label);
    }
    [[nodiscard]] Coordinates<d> at(Image<d> s) const { return at(place_, s); }
    [[nodiscard]] Places places(std::size_t c) const {
        Places x;
        for (std::size_t i = 0; i <= d; ++i) x[i] = at(table_.image(c, i));
        return x;
    }

    /// No cell is its own neighbour (in a positive one no facet is a translate of another).
    [[nodiscard]] bool is_glued() const {
        for (std::size_t c = 0; c < table_.size(); ++c)
            for (std::size_t i = 0; i <= d; ++i) {
                const Corner_index t = table_.twin[c][i];
                if (t == no_corner) return false;
                const std::size_t m = Table::cell_of(t), j = Table::slot_of(t);
                if (m == c || table_.twin[m][j] != Table::corner(c, i)) return false;
                if (m > c && !is_glued(c, i, m, j)) return false;
            }
        return true;
    }
    /// Whether the cell has the corners that it had.
    [[nodiscard]] bool is_same(const Kept_cell<d>& k) const {
        return k.cell < table_.size() && table_.vertex[k.cell] == k.vertex && table_.offset[k.cell] == k.offset;
    }
    [[nodiscard]] bool is_mutual(Corner_index h) const {
        const Corner_index t = table_.twin[Table::cell_of(h)][Table::slot_of(h)];
        return t != no_corner && Table::cell_of(t) < table_.size() && Table::cell_of(t) != Table::cell_of(h) &&
               table_.twin[Table::cell_of(t)][Table::slot_of(t)] == h;
    }
    [[nodiscard]] bool is_glued(std::size_t c, std::size_t i) const {
        const Corner_index t = table_.twin[c][i];
        return is_mutual(Table::corner(c, i)) && is_glued(c, i, Table::cell_of(t), Table::slot_of(t));
    }
    /// Whether the half-facets of a cell that are glued to something else are glued, and what they were glued to is.
    [[nodiscard]] bool is_glued_again(const Kept_cell<d>& k) const {
        for (std::size_t i = 0; i <= d; ++i)
            if (table_.twin[k.cell][i] != k.twin[i] && (!is_glued(k.cell, i) || !is_left_glued(k.twin[i])))
                return false;
        return true;
    }
    /// Whether a half-facet is not glued to what is there no more. A cell that has another number now is one that came.
    [[nodiscard]] bool is_left_glued(Corner_index h) const {
        return Table::cell_of(h) >= table_.size() || is_mutual(h);
    }
    /// All facets of cells that came, and half-facets that were glued to cells that are gone.
    [[nodiscard]] bool is_glued(std::span<const std::size_t> came, std::span<const Kept_cell<d>* const> gone) const {
        for (const std::size_t c : came)
            for (std::size_t i = 0; i <= d; ++i)
                if (!is_glued(c, i)) return false;
        for (const Kept_cell<d>* const k : gone)
            for (const Corner_index h : k->twin)
                if (!is_left_glued(h)) return false;
        return true;
    }
    /// The slots other than i, ascending.
    [[nodiscard]] static constexpr std::array<std::size_t, static_cast<std::size_t>(d)> others(std::size_t i) {
        std::array<std::size_t, static_cast<std::size_t>(d)> slot{};
        for (std::size_t k = 0; k < d; ++k) slot[k] = k < i ? k : k + 1;
        return slot;
    }
    /// Whether the facets opposite to these corners have the same images, in opposite orders: with the opposite corners
    /// paired, too, the corners of one cell are an odd permutation of those of the other. So those of the facets, each
    /// in ascending order of slots, are an even one where i + j is odd, which is a rotation, and else a reflection.
    [[nodiscard]] bool is_glued(std::size_t c, std::size_t i, std::size_t m, std::size_t j) const {
        const Offset<d> shift = table_.translation(c, i);
        const auto here = others(i), there = others(j);
        const bool rotated = (i + j) % 2 != 0;
        for (std::size_t r = 0; r < (d == 2 ? 1 : 3); ++r) {
            bool same = true;
            for (std::size_t k = 0; k < d; ++k) {
                const std::size_t l = there[rotated ? (r + k) % d : (r + 2 * d - 1 - k) % d];
                same = same && table_.vertex[c][here[k]] == table_.vertex[m][l] &&
                       table_.offset[c][here[k]] == table_.offset[m][l] + shift;
            }
            if (same) return true;
        }
        return false;
    }
    [[nodiscard]] bool has_every_vertex() const {
        std::vector<char> used(place_.size(), 0);
        for (const auto& cell : table_.vertex)
            for (const Index v : cell) used[static_cast<std::size_t>(v)] = 1;
        for (std::size_t v = 0; v < used.size(); ++v)
            if (used[v] == 0 && is_place<d>(place_[v])) return false;
        return true;
    }

    [[nodiscard]] bool has_every_vertex(std::span<const std::size_t> came,
                                        std::span<const Kept_cell<d>* const> gone) const {
        std::vector<char> used(place_.size(), 0);
        for (const std::size_t c : came)
            for (const Index v : table_.vertex[c]) used[static_cast<std::size_t>(v)] = 1;
        for (const Kept_cell<d>* const k : gone)
            for (const Index v : k->vertex)
                if (used[static_cast<std::size_t>(v)] == 0) return false;
        return true;
    }

    [[nodiscard]] static bool is_positive(const Places& x) {
        Tuple<d, d + 1> corners;
        for (std::size_t i = 0; i <= d; ++i) corners[i] = &x[i];
        return exact_orientation_sign(corners).sign > 0;
    }
    [[nodiscard]] static Sphere sphere_of(const Places& x) {
        return std::apply([](const auto&... p) { return Sphere(p...); }, x);
    }

    void forget_cospherical(std::size_t c) {
        table_.cospherical[c] = {};
        for (const Corner_index t : table_.twin[c]) table_.cospherical[Table::cell_of(t)][Table::slot_of(t)] = 0;
    }
    /// Whether all cells are positive, and no sphere holds an opposite vertex.
    [[nodiscard]] bool is_right(int threads) {
        if (has_fast_clear_cells()) {
            Clear_periodic_cells<d> clear;
            clear.set_threads(threads);
            clear.find(table_, lattice_, place_);
            return std::all_of(clear.rest().begin(), clear.rest().end(),
                               [this](std::size_t c) { return this->is_right(c, 0); });
        }
        for (std::size_t c = 0; c < table_.size(); ++c)
            if (!is_right(c, c)) return false;
        return true;
    }
    /// Whether c is positive and its sphere holds no opposite vertex of a cell with this number or a larger one.
    [[nodiscard]] bool is_right(std::size_t c, std::size_t least) {
        const Places x = places(c);
        const Sphere sphere = sphere_of(x);
        const bool clear = sphere.positive();
        if (!clear && !is_positive(x)) return false;
        for (std::size_t i = 0; i <= d; ++i) {
            const Corner_index t = table_.twin[c][i];
            const std::size_t m = Table::cell_of(t), j = Table::slot_of(t);
            if (m < least) continue;
            const Coordinates<d> q = at(table_.image(m, j, table_.translation(c, i)));
            if (clear && sphere.excludes(q)) continue;
            if (!is_positive(places(m))) return false;  // what the exact signs require
            Tuple<d, d + 2> bicell{};
            for (std::size_t k = 0; k < d; ++k) bicell[k] = &x[k];
            bicell[d] = &q;
            bicell[d + 1] = &x[d];
            int sign = exact_empty_sphere_sign(bicell).sign;
            if (sign == 0) {
                table_.cospherical[c][i] = table_.cospherical[m][j] = 1;
                sign = perturbed_sign(bicell);
            }
            if (sign < 0) return false;
        }
        return true;
    }

    /// A determinant whose largest difference this is is off by this much.
    [[nodiscard]] static double error_of(double magnitude) {
        constexpr double constant = (d == 2 ? bounds::orientation_2 : bounds::orientation_3) + 8;
        double power = magnitude * magnitude;
        if (d == 3) power *= magnitude;
        return constant * bounds::u * power;
    }
    void add_volume(const Places& x, double times) {
        typename Box<d>::Vectors edge;
        double magnitude = 0;
        for (std::size_t k = 0; k < d; ++k)
            for (std::size_t i = 0; i < d; ++i) {
                edge[k][i] = x[k + 1][i] - x[0][i];
                magnitude = std::max(magnitude, std::fabs(edge[k][i]));
            }
        sum_ += times * determinant_of_rows(edge);
        error_ += error_of(magnitude) + 2 * bounds::u * std::fabs(sum_);
    }
    [[nodiscard]] double error_of_lattice() const {
        double largest = 0;
        for (const auto& v : lattice_.basis())
            for (const double x : v) largest = std::max(largest, std::fabs(x));
        return parts * error_of(largest);
    }

    /// The volumes add up to N times the lattice's, with N an integer whatever the places are (docs/theory.md 8.3), so
    /// a sum in doubles with an error below an eighth decides whether N is 1.
    [[nodiscard]] bool covers_once() const {
        if (table_.size() == 0) return true;  // of no points
        const double whole = parts * lattice_.volume();
        if (error_ + error_of_lattice() < whole / 8) return std::fabs(sum_ - whole) < whole / 4;
        return covers_once_exactly();
    }
    [[nodiscard]] bool covers_once_exactly() const {
        const auto whole_number = [this](double x, std::size_t i) { return mpz_class(x / lattice_.grid()[i]); };
        using Rows = std::array<std::array<mpz_class, static_cast<std::size_t>(d)>, static_cast<std::size_t>(d)>;
        mpz_class sum = 0;
        Rows rows;
        for (std::size_t c = 0; c < table_.size(); ++c) {
            const Places x = places(c);
            for (std::size_t k = 0; k < d; ++k)
                for (std::size_t i = 0; i < d; ++i)
                    rows[k][i] = whole_number(x[k + 1][i], i) - whole_number(x[0][i], i);
            sum += determinant_of_rows(rows);
        }
        for (std::size_t k = 0; k < d; ++k)
            for (std::size_t i = 0; i < d; ++i) rows[k][i] = whole_number(lattice_.basis()[k][i], i);
        return sum == static_cast<int>(parts) * determinant_of_rows(rows);
    }

    Periodic_table<d>& table_;
    const Lattice<d>& lattice_;
    std::span<const Coordinates<d>> place_;
    double sum_ = 0, error_ = 0;  // of d! times the volumes of the cells so far, and how far it is off
};

}  // namespace

template <int d>
bool is_proved_delaunay(Periodic_table<d>& table, const Lattice<d>& lattice, std::span<const Coordinates<d>> place,
                        int threads) {
    return Periodic_proof<d>(table, lattice, place)(threads);
}

template <int d>
bool is_still_proved_delaunay(Periodic_table<d>& table, const Lattice<d>& lattice,
                              std::span<const Coordinates<d>> place, const Periodic_table_changes<d>& changes) {
    return Periodic_proof<d>(table, lattice, place)(changes);
}

template bool is_proved_delaunay(Periodic_table<2>&, const Lattice<2>&, std::span<const Coordinates<2>>, int);
template bool is_proved_delaunay(Periodic_table<3>&, const Lattice<3>&, std::span<const Coordinates<3>>, int);
template bool is_still_proved_delaunay(Periodic_table<2>&, const Lattice<2>&, std::span<const Coordinates<2>>,
                                       const Periodic_table_changes<2>&);
template bool is_still_proved_delaunay(Periodic_table<3>&, const Lattice<3>&, std::span<const Coordinates<3>>,
                                       const Periodic_table_changes<3>&);

}  // namespace annulus::inline v1
