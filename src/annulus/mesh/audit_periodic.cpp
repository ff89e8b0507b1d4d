// SPDX-License-Identifier: GPL-3.0-or-later
// The audit of periodic triangulations, in both dimensions. Integers; shares nothing with what builds them.
#include <annulus/audit.h>
#include <annulus/box.h>

#include <annulus/error.h>

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace annulus::inline v1 {

namespace {

template <int d>
using Vector = std::array<mpz_class, static_cast<std::size_t>(d)>;

template <std::size_t d>
std::array<mpz_class, d> difference(const std::array<mpz_class, d>& a, const std::array<mpz_class, d>& b) {
    std::array<mpz_class, d> c;
    for (std::size_t i = 0; i < d; ++i) c[i] = a[i] - b[i];
    return c;
}
template <int d>
mpz_class product(const Vector<d>& a, const Vector<d>& b) {
    mpz_class sum = 0;
    for (std::size_t i = 0; i < d; ++i) sum += a[i] * b[i];
    return sum;
}

/// Coordinates times a power of two that makes all of them integers.
template <int d>
class Integers {
  public:
    explicit Integers(const Periodic_audit_input<d>& input) {
        for (const auto& p : input.points) note(p);
        for (const auto& v : input.box) note(v);
    }
    [[nodiscard]] Vector<d> operator()(const Coordinates<d>& p) const {
        Vector<d> x;
        for (std::size_t i = 0; i < d; ++i) {
            if (p[i] == 0 || std::isnan(p[i])) continue;
            int e = 0;
            x[i] = std::ldexp(std::frexp(p[i], &e), 53);
            x[i] <<= static_cast<mp_bitcnt_t>(e - 53 - least_);
        }
        return x;
    }

  private:
    void note(const Coordinates<d>& p) {
        for (const double c : p) {
            int e = 0;
            if (c != 0 && !std::isnan(c)) (void)std::frexp(c, &e), least_ = std::min(least_, e - 53);
        }
    }
    int least_ = 1100;
};

/// A cell in integers, from its first corner: d! times its volume and twice that times its circumcentre.
struct Sphere_2 {
    mpz_class determinant;
    Vector<2> centre;
    Sphere_2(const Vector<2>& u, const Vector<2>& v) {
        const mpz_class uu = product<2>(u, u), vv = product<2>(v, v);
        determinant = u[0] * v[1] - u[1] * v[0];
        centre = {uu * v[1] - vv * u[1], vv * u[0] - uu * v[0]};
    }
};
struct Sphere_3 {
    mpz_class determinant;
    Vector<3> centre;
    Sphere_3(const Vector<3>& u, const Vector<3>& v, const Vector<3>& w) {
        const mpz_class uu = product<3>(u, u), vv = product<3>(v, v), ww = product<3>(w, w);
        const Vector<3> vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
        determinant = product<3>(u, vw);
        for (std::size_t i = 0; i < 3; ++i) centre[i] = uu * vw[i] + vv * wu[i] + ww * uv[i];
    }
    static Vector<3> cross(const Vector<3>& a, const Vector<3>& b) {
        Vector<3> c;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            c[i] = a[j] * b[k] - a[k] * b[j];
        }
        return c;
    }
};
Sphere_2 sphere(const std::array<Vector<2>, 3>& x) { return {difference(x[1], x[0]), difference(x[2], x[0])}; }
Sphere_3 sphere(const std::array<Vector<3>, 4>& x) {
    return {difference(x[1], x[0]), difference(x[2], x[0]), difference(x[3], x[0])};
}

template <int d>
struct Corner {
    Index vertex;
    Shift<d> offset;
    friend auto operator<=>(const Corner&, const Corner&) = default;
};

template <int d>
class Periodic_audit {
  public:
    explicit Periodic_audit(const Periodic_audit_input<d>& input) : in_(input), integers_(input) {
        for (const auto& p : input.points) points_.push_back(integers_(p));
        for (std::size_t j = 0; j < d; ++j) box_[j] = integers_(input.box[j]);
    }

    Audit_result operator()() {
        const auto& cells = in_.cells;
        const bool glued = !cells.neighbours.empty() || !cells.translations.empty();
        if (cells.offsets.size() != cells.vertices.size() ||
            (glued &&
             (cells.neighbours.size() != cells.vertices.size() || cells.translations.size() != cells.vertices.size())))
            throw Error(Error_code::wrong_size, "the arrays of the cells differ in length");
        for (std::size_t c = 0; c < cells.vertices.size(); ++c)
            for (const Index v : cells.vertices[c])
                if (v < 0 || static_cast<std::size_t>(v) >= points_.size() || !is_there(static_cast<std::size_t>(v))) {
                    fault(Fault::unknown_vertex, "a cell names vertex " + std::to_string(v), {v}, c);
                    return r_;
                }
        look_at_vertices();
        look_at_cells();
        look_at_facets(glued);
        return r_;
    }

  private:
    static constexpr std::size_t corners = d + 1;
    struct Facet_side {
        std::array<Corner<d>, static_cast<std::size_t>(d)> facet;  // up to a translation
        Shift<d> first;                                            // the translation
        bool odd;
        std::size_t cell, slot;
    };

    void fault(Fault kind, const std::string& text, std::initializer_list<Index> vertices, std::size_t cell) {
        ++(kind == Fault::flat_cell      ? r_.inverted_cells
           : kind == Fault::not_delaunay ? r_.violated_facets
                                         : r_.topological_faults);
        if (r_.first_fault.empty()) r_.first_fault = text;
        if (r_.faults.size() >= in_.most_faults) return;
        Audit_fault& f = r_.faults.emplace_back();
        f.kind = kind;
        f.text = text;
        f.cells[0] = static_cast<std::int64_t>(cell);
        std::copy(vertices.begin(), vertices.end(), f.vertices.begin());
    }
    [[nodiscard]] bool is_there(std::size_t v) const { return !std::isnan(in_.points[v][0]); }
    [[nodiscard]] Vector<d> place(Index v, const Shift<d>& offset) const {
        Vector<d> x = points_[static_cast<std::size_t>(v)];
        for (std::size_t j = 0; j < d; ++j)
            if (offset[j] != 0)
                for (std::size_t i = 0; i < d; ++i) x[i] += offset[j] * box_[j][i];
        return x;
    }
    [[nodiscard]] auto places(std::size_t c) const {
        std::array<Vector<d>, corners> x;
        for (std::size_t i = 0; i < corners; ++i) x[i] = place(in_.cells.vertices[c][i], in_.cells.offsets[c][i]);
        return x;
    }

    void look_at_vertices() {
        std::vector<char> used(points_.size(), 0);
        for (const auto& cell : in_.cells.vertices)
            for (const Index v : cell) used[static_cast<std::size_t>(v)] = 1;
        for (std::size_t v = 0; v < used.size(); ++v)
            if (!used[v] && is_there(v))
                fault(Fault::unused_vertex, "no cell has vertex " + std::to_string(v), {static_cast<Index>(v)}, 0);
    }

    void look_at_cells() {
        mpz_class sum = 0;
        for (std::size_t c = 0; c < in_.cells.vertices.size(); ++c) {
            const mpz_class volume = sphere(places(c)).determinant;
            if (sgn(volume) <= 0) fault(Fault::flat_cell, "cell " + std::to_string(c) + " is not positive", {}, c);
            sum += volume;
        }
        if (in_.cells.vertices.empty()) return;  // a point would be in none
        mpz_class whole = sphere(with_origin()).determinant;
        whole = abs(whole) * (d == 2 ? 2 : 6);
        if (sum != whole) fault(Fault::overlap, "the volumes of the cells do not add up to that of the box", {}, 0);
    }
    [[nodiscard]] auto with_origin() const {
        std::array<Vector<d>, corners> x;
        for (std::size_t j = 0; j < d; ++j) x[j + 1] = box_[j];
        return x;
    }

    [[nodiscard]] Facet_side side(std::size_t c, std::size_t slot) const {
        Facet_side s{{}, {}, (d - slot) % 2 != 0, c, slot};
        for (std::size_t i = 0, n = 0; i < corners; ++i)
            if (i != slot) s.facet[n++] = {in_.cells.vertices[c][i], in_.cells.offsets[c][i]};
        for (std::size_t k = 0; k < d; ++k)
            for (std::size_t l = k + 1; l < d; ++l)
                if (s.facet[l] < s.facet[k]) {
                    std::swap(s.facet[k], s.facet[l]);
                    s.odd = !s.odd;
                }
        s.first = s.facet[0].offset;
        for (auto& corner : s.facet)
            for (std::size_t i = 0; i < d; ++i) corner.offset[i] -= s.first[i];
        return s;
    }

    void look_at_facets(bool glued) {
        std::vector<Facet_side> sides;
        for (std::size_t c = 0; c < in_.cells.vertices.size(); ++c)
            for (std::size_t i = 0; i < corners; ++i) sides.push_back(side(c, i));
        std::sort(sides.begin(), sides.end(), [](const Facet_side& l, const Facet_side& r) {
            if (l.facet != r.facet) return l.facet < r.facet;
            return l.cell != r.cell ? l.cell < r.cell : l.slot < r.slot;
        });
        for (std::size_t k = 0, next = 0; k < sides.size(); k = next) {
            next = k + 1;
            while (next < sides.size() && sides[next].facet == sides[k].facet) ++next;
            const std::string of_cell = " of cell " + std::to_string(sides[k].cell);
            if (next == k + 1) fault(Fault::hull_broken, "a facet" + of_cell + " has no other side", {}, sides[k].cell);
            else if (next > k + 2 || sides[k].odd == sides[k + 1].odd)
                fault(Fault::overlap, "two cells on one side of a facet" + of_cell, {}, sides[k].cell);
            else look_at_facet(sides[k], sides[k + 1], glued);
        }
    }

    void look_at_facet(const Facet_side& a, const Facet_side& b, bool glued) {
        if (glued && !(is_named(a, b) && is_named(b, a)))
            fault(Fault::hull_broken, "a neighbour of cell " + std::to_string(a.cell) + " is not the one at its facet",
                  {}, a.cell);
        const auto x = places(a.cell);
        const auto s = sphere(x);
        if (sgn(s.determinant) <= 0) return;
        const Index v = in_.cells.vertices[b.cell][b.slot];
        Shift<d> offset = in_.cells.offsets[b.cell][b.slot];
        for (std::size_t i = 0; i < d; ++i) offset[i] += a.first[i] - b.first[i];
        const Vector<d> w = difference(place(v, offset), x[0]);
        // |w|^2 - 2 w . centre is positive outside.
        const mpz_class outside = product<d>(w, w) * s.determinant - product<d>(w, s.centre);
        if (sgn(outside) == 0) ++r_.degenerate_facets;
        if (sgn(outside) < 0)
            fault(Fault::not_delaunay,
                  "the sphere of cell " + std::to_string(a.cell) + " holds an image of vertex " + std::to_string(v),
                  {v}, a.cell);
    }
    /// Whether a's cell says that b is its neighbour there, and how it is moved.
    [[nodiscard]] bool is_named(const Facet_side& a, const Facet_side& b) const {
        if (in_.cells.neighbours[a.cell][a.slot] != static_cast<Index>(b.cell)) return false;
        for (std::size_t i = 0; i < d; ++i)
            if (in_.cells.translations[a.cell][a.slot][i] != a.first[i] - b.first[i]) return false;
        return true;
    }

    const Periodic_audit_input<d>& in_;
    Integers<d> integers_;
    std::vector<Vector<d>> points_;
    std::array<Vector<d>, static_cast<std::size_t>(d)> box_;
    Audit_result r_;
};

}  // namespace

Audit_result audit(const Periodic_audit_input<2>& input) { return Periodic_audit<2>(input)(); }
Audit_result audit(const Periodic_audit_input<3>& input) { return Periodic_audit<3>(input)(); }

}  // namespace annulus::inline v1
