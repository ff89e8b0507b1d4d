// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Bytes to periodic boxes and other boxes made of them, and to points in them: ordinary, thin, skewed and tiny boxes;
// points at random, of a lattice, rational, cospherical, equal, near to each other and far from the box.

#include "bytes.h"

#include <annulus/box.h>
#include <annulus/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace annulus::oracle {

template <int d>
class Periodic_inputs {
  public:
    using Point = Coordinates<d>;
    using Vectors = typename Box<d>::Vectors;

    explicit Periodic_inputs(Bytes bytes) : bytes_(bytes) {
        const int head = static_cast<int>(bytes_.next()) / 4;  // most at ordinary magnitudes
        scale_ = head < 40 ? 0 : (head - 52) * 11;
    }
    [[nodiscard]] bool empty() const { return bytes_.empty(); }
    std::size_t below(std::size_t n) { return bytes_.below(n); }

    // ---- Boxes --------------------------------------------------------------------------------------------------

    /// A cube where the bytes make a box that is refused.
    [[nodiscard]] Box<d> box() {
        Vectors v = identity();
        switch (below(10)) {
            case 1:
                for (std::size_t i = 0; i < d; ++i) v[i][i] = 0.5 + static_cast<double>(below(256)) / 128;
                break;
            case 2: {
                const std::size_t i = below(d);
                v[i][i] = std::ldexp(1, -static_cast<int>(below(30)));
                break;
            }
            case 3:
                for (std::size_t i = 0; i + 1 < d; ++i) v[i][i] = std::ldexp(1, -static_cast<int>(below(16)));
                break;
            case 4: tilt(v, 512); break;
            case 5: tilt(v, 64); break;
            case 6: v[1] = {}, v[1][0] = 0.5, v[1][1] = std::sqrt(0.75); break;
            case 7:
                for (Point& row : v)
                    for (double& c : row) c = signed_byte() / 64;
                break;
            case 8:
                for (std::size_t i = 0; i < d; ++i) v[i][i] = 3.615;
                break;
            case 9:  // thin, and not along the axes
                tilt(v, 256);
                v[d - 1] = scaled(v[d - 1], std::ldexp(1, -static_cast<int>(below(20))));
                break;
            default: break;
        }
        for (Point& row : v) row = scaled(row, std::ldexp(1, scale_));
        if (const auto made = taken(v)) return *made;
        v = identity();
        for (Point& row : v) row = scaled(row, std::ldexp(1, scale_));
        return Box<d>(v);
    }
    /// One vector is moved along another, and then perhaps brought back by whole vectors, as programs of molecular
    /// dynamics do in simple shear.
    [[nodiscard]] std::optional<Box<d>> sheared(const Box<d>& box) {
        Vectors v = box.vectors();
        const auto [i, j] = two();
        const double by = std::ldexp(signed_byte() / 128, -static_cast<int>(below(12)));
        for (std::size_t k = 0; k < d; ++k) v[i][k] += by * v[j][k];
        double along = 0, square = 0;
        for (std::size_t k = 0; k < d; ++k) {
            along += v[i][k] * v[j][k];
            square += v[j][k] * v[j][k];
        }
        const double back = below(2) == 0 && square > 0 ? std::round(along / square) : 0;
        for (std::size_t k = 0; k < d; ++k) v[i][k] -= back * v[j][k];
        return taken(v);
    }
    /// Shorter along one axis or all, by a little or nearly to nothing; or longer, as far again.
    [[nodiscard]] std::optional<Box<d>> squeezed(const Box<d>& box) {
        const std::size_t axis = below(d + 1);
        const double by = below(2) == 0 ? std::ldexp(1, static_cast<int>(below(21)) - 10) : 1 + signed_byte() / 1024;
        Vectors v = box.vectors();
        for (Point& row : v)
            for (std::size_t k = 0; k < d; ++k)
                if (axis == d || axis == k) row[k] *= by;
        return taken(v);
    }
    /// Of the same lattice.
    [[nodiscard]] std::optional<Box<d>> other_basis(const Box<d>& box) {
        Vectors v = box.vectors();
        const auto [i, j] = two();
        switch (below(4)) {
            case 0: std::swap(v[i], v[j]); break;
            case 1: v[i] = scaled(v[i], -1); break;
            default: {
                const double sign = below(2) == 0 ? 1 : -1;
                for (std::size_t k = 0; k < d; ++k) v[i][k] += sign * v[j][k];
            }
        }
        return taken(v);
    }

    // ---- Points -------------------------------------------------------------------------------------------------

    /// How many to begin with, few or some dozens, and of which kind.
    [[nodiscard]] std::size_t number() {
        choose_kind();
        const std::size_t n = bytes_.next();
        return n < 192 ? n % 13 : n % 49;
    }
    void choose_kind() { kind_ = below(8); }

    [[nodiscard]] Point point(const Box<d>& box, std::span<const Point> others) {
        const bool with_other = (kind_ == 4 || kind_ == 5) && !others.empty() && below(2) == 0;
        if (with_other) {
            Point p = others[below(others.size())];
            if (std::isnan(p[0])) p = {};
            if (kind_ == 4) take_image(p, box);
            else move(p, box, static_cast<int>(below(56)));
            return p;
        }
        if (kind_ == 3) return on_sphere(box);
        const double denominator = kind_ == 2 ? 3 + 2 * static_cast<double>(below(4)) : 1;
        const int near = kind_ == 7 ? static_cast<int>(below(48)) : 0;
        Point f{};
        for (double& c : f) {
            if (kind_ == 1) c = static_cast<double>(below(4)) / 4;
            else if (kind_ == 2) c = static_cast<double>(below(32)) / denominator;
            else {
                c = static_cast<double>(bytes_.next()) / 256;
                c += static_cast<double>(bytes_.next()) / 65536;
            }
            c = std::ldexp(c, -near);
        }
        Point p = combined(f, box);
        for (int k = 0; kind_ == 6 && k < 2; ++k) far_image(p, box);
        return p;
    }
    /// A site of a lattice that has so many along each vector of the box.
    [[nodiscard]] Point site(std::size_t number, std::size_t times, const Box<d>& box) const {
        Point f{};
        for (double& c : f) {
            c = static_cast<double>(number % times) / static_cast<double>(times);
            number /= times;
        }
        return combined(f, box);
    }
    /// Within two boxes of the origin.
    [[nodiscard]] Point near(const Box<d>& box) {
        Point f{};
        for (double& c : f) c = signed_byte() / 64;
        return combined(f, box);
    }
    [[nodiscard]] int size_of_move() { return static_cast<int>(below(16) * 3); }
    /// By up to 2^-size of each vector.
    void move(Point& p, const Box<d>& box, int size) {
        for (const Point& v : box.vectors()) {
            const double f = std::ldexp(signed_byte() / 128, -size);
            for (std::size_t i = 0; i < d; ++i) p[i] += f * v[i];
        }
    }
    void take_image(Point& p, const Box<d>& box) {
        for (const Point& v : box.vectors()) {
            const double k = static_cast<double>(below(5)) - 2;
            for (std::size_t i = 0; i < d; ++i) p[i] += k * v[i];
        }
    }
    /// Points that keep their coordinates in the vectors of a box.
    [[nodiscard]] std::vector<Point> carried(std::vector<Point> x, const Box<d>& from, const Box<d>& to) const {
        const double whole = determinant(from.vectors());
        for (Point& p : x) {
            Point f;
            for (std::size_t j = 0; j < d; ++j) {
                Vectors replaced = from.vectors();
                replaced[j] = p;
                f[j] = determinant(replaced) / whole;
            }
            p = combined(f, to);
        }
        return x;
    }

  private:
    static Vectors identity() {
        Vectors v{};
        for (std::size_t i = 0; i < d; ++i) v[i][i] = 1;
        return v;
    }
    static Point scaled(Point p, double by) {
        for (double& c : p) c *= by;
        return p;
    }
    static Point combined(const Point& f, const Box<d>& box) {
        Point p{};
        for (std::size_t j = 0; j < d; ++j)
            for (std::size_t i = 0; i < d; ++i) p[i] += f[j] * box.vectors()[j][i];
        return p;
    }
    static double determinant(const Vectors& v) {
        if constexpr (d == 2) return v[0][0] * v[1][1] - v[0][1] * v[1][0];
        else {
            double sum = 0;
            for (std::size_t i = 0; i < 3; ++i)
                sum += v[0][i] * (v[1][(i + 1) % 3] * v[2][(i + 2) % 3] - v[1][(i + 2) % 3] * v[2][(i + 1) % 3]);
            return sum;
        }
    }
    static std::optional<Box<d>> taken(const Vectors& v) {
        try {
            return Box<d>(v);
        } catch (const Error&) {  // too skewed, thin, large or small
            return std::nullopt;
        }
    }
    double signed_byte() { return static_cast<std::int8_t>(bytes_.next()); }
    std::pair<std::size_t, std::size_t> two() {
        const std::size_t i = below(d);
        return {i, (i + 1 + below(d - 1)) % d};
    }
    void tilt(Vectors& v, double unit) {
        for (std::size_t i = 0; i < d; ++i)
            for (std::size_t j = 0; j < i; ++j) v[i][j] = signed_byte() / unit * 2;
    }
    /// Points with integer coordinates on a sphere, in a unit that is a 32nd of the first vector.
    Point on_sphere(const Box<d>& box) {
        static const std::vector<std::array<int, d>> all = [] {
            constexpr int square = d == 2 ? 65 : 41;
            std::vector<std::array<int, d>> found;
            for (int a = -8; a <= 8; ++a)
                for (int b = -8; b <= 8; ++b) {
                    if constexpr (d == 2) {
                        if (a * a + b * b == square) found.push_back({a, b});
                    } else
                        for (int c = -8; c <= 8; ++c)
                            if (a * a + b * b + c * c == square) found.push_back({a, b, c});
                }
            return found;
        }();
        double length = 0;
        for (const double c : box.vectors()[0]) length = std::max(length, std::abs(c));
        const auto& q = all[below(all.size())];
        Point p;
        for (std::size_t i = 0; i < d; ++i) p[i] = q[i] * length / 32;
        return p;
    }
    void far_image(Point& p, const Box<d>& box) {
        const double k = std::ldexp(signed_byte() / 128, static_cast<int>(below(21)));
        const Point& v = box.vectors()[below(d)];
        for (std::size_t i = 0; i < d; ++i) p[i] += std::trunc(k) * v[i];
    }

    Bytes bytes_;
    int scale_ = 0;
    std::size_t kind_ = 0;
};

}  // namespace annulus::oracle
