// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Bytes to degenerate and nearly degenerate points, and to changes of a Delaunay_mesh of them, which is compared with
// CGAL's triangulation after each. The first byte has the dimension in its lowest bit and a power of two in the others;
// then the kind of points, their number, the points, and changes until the bytes run out.

#include "bytes.h"
#include "cgal_cells.h"

#include <annulus/error.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/mesh/table_flips_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <vector>

namespace annulus::oracle {

enum class Point_kind { random, lattice, rational, cospherical, near_sphere, collinear, coplanar, off_by_an_ulp };
inline constexpr unsigned point_kinds = 8;

template <int d>
class Mesh_case {
  public:
    explicit Mesh_case(Bytes bytes) : bytes_(bytes) {
        scale_ = static_cast<int>(bytes_.next()) / 2;
        // Half of them at ordinary magnitudes, others between both ends of the domain of coordinates.
        scale_ = scale_ < 64 ? 0 : (scale_ - 96) * 14;
        kind_ = kind(bytes_.next());
        const std::size_t n = bytes_.next() % 25;
        for (std::size_t i = 0; i < n; ++i) x_.push_back(free_point());
        std::erase(x_, std::nullopt);
    }

    /// Empty, or the difference.
    [[nodiscard]] std::string fault() {
        home_.assign(x_.size() + most_changes, Coordinates<d>{});
        for (std::size_t i = 0; i < x_.size(); ++i) home_[i] = *x_[i];
        mesh_.build(std::span<const Coordinates<d>>(home_).first(x_.size()));
        std::string found = difference("build");
        for (int k = 0; k < most_changes && !bytes_.empty() && found.empty(); ++k) found = difference(change());
        return found;
    }
    /// The points at the time of the difference.
    [[nodiscard]] std::string points() const {
        std::ostringstream out;
        out << std::hexfloat;
        for (std::size_t v = 0; v < x_.size(); ++v) {
            out << v << ":";
            if (!x_[v]) out << " free";
            for (int c = 0; c < d && x_[v]; ++c) out << " " << (*x_[v])[static_cast<std::size_t>(c)];
            out << "\n";
        }
        return out.str();
    }

  private:
    static constexpr int most_changes = 16;

    static Point_kind kind(unsigned byte) { return static_cast<Point_kind>(byte % point_kinds); }

    /// Every point with integer coordinates on a sphere around the origin.
    static const std::vector<std::array<int, d>>& on_sphere() {
        static const std::vector<std::array<int, d>> all = [] {
            constexpr int square = d == 2 ? 1105 : 101, most = d == 2 ? 33 : 10;
            std::vector<std::array<int, d>> found;
            for (int a = -most; a <= most; ++a)
                for (int b = -most; b <= most; ++b) {
                    if constexpr (d == 2) {
                        if (a * a + b * b == square) found.push_back({a, b});
                    } else
                        for (int c = -most; c <= most; ++c)
                            if (a * a + b * b + c * c == square) found.push_back({a, b, c});
                }
            return found;
        }();
        return all;
    }

    Coordinates<d> point() {
        Coordinates<d> p{};
        const auto each = [&p](auto coordinate) {
            for (double& c : p) c = coordinate();
        };
        switch (kind_) {
            case Point_kind::random:
                each([&] {
                    const double high = bytes_.next();  // first: in one expression the order is unspecified
                    return high / 16 + bytes_.next() / 4096.0;
                });
                break;
            case Point_kind::lattice: each([&] { return bytes_.next() % 4; }); break;
            case Point_kind::rational: {
                const double denominator = 3 + 2 * (bytes_.next() % 4);
                each([&] { return static_cast<double>(bytes_.next() % 32) / denominator; });
                break;
            }
            case Point_kind::cospherical: {
                const auto& q = on_sphere()[bytes_.next() % on_sphere().size()];
                for (std::size_t c = 0; c < d; ++c) p[c] = q[c];
                break;
            }
            case Point_kind::near_sphere: {
                double square = 0;
                each([&] { return static_cast<std::int8_t>(bytes_.next()) + 0.5; });
                for (const double c : p) square += c * c;
                for (double& c : p) c /= std::sqrt(square);
                break;
            }
            case Point_kind::collinear: {
                const int t = static_cast<std::int8_t>(bytes_.next());
                for (std::size_t c = 0; c < d; ++c) p[c] = static_cast<int>(c + 1) * t + 5;
                break;
            }
            case Point_kind::coplanar:
                each([&] { return bytes_.next() % 8; });
                p[d - 1] = p[0] + (d == 3 ? 2 * p[1] : 1);
                break;
            case Point_kind::off_by_an_ulp:
                each([&] {
                    const unsigned b = bytes_.next();
                    const double x = 1.0 + b % 4;
                    return b < 64 ? std::nextafter(x, (b & 4) != 0 ? 0.0 : 9.0) : x;
                });
        }
        for (double& c : p) c = std::ldexp(c, scale_);
        return p;
    }
    [[nodiscard]] bool is_taken(const Coordinates<d>& p, std::size_t but) const {
        for (std::size_t v = 0; v < x_.size(); ++v)
            if (v != but && x_[v] == p) return true;
        return false;
    }
    [[nodiscard]] std::optional<Coordinates<d>> free_point() {
        const Coordinates<d> p = point();
        return is_taken(p, x_.size()) ? std::nullopt : std::optional(p);
    }
    /// An existing vertex, or x_.size().
    [[nodiscard]] std::size_t some_vertex() {
        for (std::size_t v = x_.empty() ? 0 : bytes_.next() % x_.size(), k = 0; k < x_.size(); ++k, ++v)
            if (x_[v % x_.size()]) return v % x_.size();
        return x_.size();
    }

    /// Makes one change; returns its name.
    std::string change() {
        const unsigned code = bytes_.next();
        if ((code & 128) != 0) kind_ = kind(code >> 4);
        switch (code % 8) {
            case 0:
            case 1:
            case 2: return insert();
            case 3:
            case 4: return remove();
            case 5: return reinsert();
            case 6: return flip_and_restore();
            default: return rebuild(1 + static_cast<int>(code >> 3 & 3));
        }
    }
    std::string insert() {
        const auto free_place = std::find(x_.begin(), x_.end(), std::nullopt);
        const auto v = static_cast<std::size_t>(free_place - x_.begin());
        const Coordinates<d> p = point();
        const bool taken = is_taken(p, x_.size());
        std::vector<Cell_index> changed;
        if (mesh_.insert(home_, static_cast<Index>(v), p, changed) == taken) return "! insert";
        if (taken) return "insert of what there is";
        if (free_place == x_.end()) x_.push_back(p);
        else *free_place = p;
        return home_[v] == p ? "insert" : "! insert: position";
    }
    std::string remove() {
        const std::size_t v = some_vertex();
        if (v == x_.size()) return "nothing";
        std::vector<Cell_index> changed;
        mesh_.remove(home_, static_cast<Index>(v), changed);
        x_[v].reset();
        return "remove";
    }
    std::string reinsert() {
        const std::size_t v = some_vertex();
        if (v == x_.size() || mesh_.dimension() < d) return "nothing";
        const Coordinates<d> p = point();
        const bool taken = is_taken(p, v);
        std::vector<Cell_index> changed;
        try {
            if (!mesh_.reinsert(home_, static_cast<Index>(v), p, changed)) return "reinsert of what spans";
        } catch (const Error& e) {
            return taken && e.code() == Error_code::duplicate_point ? "reinsert at another"
                                                                    : std::string("! reinsert: ") + e.what();
        }
        if (taken) return "! reinsert at another";
        x_[v] = p;
        return "reinsert";
    }
    /// Flips that make cells which are not Delaunay, and their repair.
    std::string flip_and_restore() {
        if (mesh_.dimension() < d) return "nothing";
        std::vector<Cell_index> touched, made;
        for (unsigned k = bytes_.next() % 8; k > 0; --k) {
            const Corner_index h = some_corner();
            if constexpr (d == 2) flip_edge_of_plane(h, touched);
            else {
                std::array<Cell_index, 3> cells{};
                Corner_table<3>& t = mesh_.table();
                const int other = (t.slot_of(h) + 1 + bytes_.next() % 3) % 4;
                if (flip_facet(t, h, cells) || flip_edge(t, h, t.corner(t.cell_of(h), other), cells))
                    touched.insert(touched.end(), cells.begin(), cells.end());
            }
        }
        mesh_.restore_cells(home_, touched, made);
        return "flip and restore";
    }
    Corner_index some_corner() {
        std::vector<Cell_index> cells;
        for (const Cell_index c : mesh_.table().cells()) cells.push_back(c);
        const std::size_t k = (bytes_.next() + 256 * (bytes_.next() % 2U)) % cells.size();
        return Corner_table<d>::corner(cells[k], bytes_.next() % (d + 1));
    }
    /// Where the opposite vertices are not adjacent.
    void flip_edge_of_plane(Corner_index h, std::vector<Cell_index>& touched) {
        Corner_table<2>& t = mesh_.table();
        const Index p = t.vertex(h), q = t.vertex(t.twin(h));
        bool adjacent = p == q;
        t.for_each_corner(p, [&](Corner_index k) { adjacent = adjacent || t.vertex(t.ccw(k)) == q; });
        if (adjacent) return;
        touched.push_back(t.cell_of(h));
        touched.push_back(t.cell_of(t.twin(h)));
        t.flip(h);
    }
    /// With a vertex elsewhere.
    std::string rebuild(int threads) {
        mesh_.set_threads(threads);
        const std::size_t v = some_vertex();
        if (v == x_.size()) return "nothing";
        const Coordinates<d> p = point();
        const bool taken = is_taken(p, v);
        std::vector<Coordinates<d>> there = home_;
        there[v] = p;
        try {
            mesh_.rebuild(there);
        } catch (const Error& e) {
            return taken && e.code() == Error_code::duplicate_point ? "rebuild with two at one place" : "! rebuild";
        }
        if (taken) return "! rebuild with two at one place";
        home_ = there;
        x_[v] = p;
        return "rebuild";
    }

    [[nodiscard]] std::string difference(const std::string& done) const {
        if (done.starts_with("!")) return done;
        const auto [dimension, cells] = cells_by_cgal<d>(x_);
        if (mesh_.dimension() != dimension) return done + ": dimension";
        std::size_t there = 0;
        for (std::size_t v = 0; v < x_.size(); ++v) {
            if (!x_[v]) continue;
            ++there;
            if (home_[v] != *x_[v] || !mesh_.has(static_cast<Index>(v))) return done + ": position or vertex";
        }
        if (mesh_.vertices() != there) return done + ": number of vertices";
        if (dimension < d) return {};
        if (cells_of(mesh_.table()) != cells) return done + ": the cells are not CGAL's";
        return glued(mesh_.table()) ? std::string() : done + ": neighbours";
    }

    Bytes bytes_;
    int scale_ = 0;
    Point_kind kind_{};
    std::vector<std::optional<Coordinates<d>>> x_;  // by vertex; none for a free index
    std::vector<Coordinates<d>> home_;
    Delaunay_mesh<d> mesh_;
};

}  // namespace annulus::oracle
