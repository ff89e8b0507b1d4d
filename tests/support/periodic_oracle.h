// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/audit.h>
#include <annulus/box.h>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

// Periodic Delaunay triangulations by brute force, in rational numbers, for few points. Shares nothing with the
// library.
namespace annulus::testing {

template <int d>
class Periodic_oracle {
  public:
    Periodic_oracle(const Periodic_audit_input<d>& input) : in_(input) {}

    /// What is wrong; empty if nothing is.
    [[nodiscard]] std::string fault() const {
        mpq_class sum = 0;
        std::set<Index> met;
        std::map<std::vector<long>, int> facets;
        for (std::size_t c = 0; c < in_.cells.vertices.size(); ++c) {
            const auto x = corners(c);
            const mpq_class volume = determinant(edges(x));
            if (volume <= 0) return "cell " + std::to_string(c) + " is not positive";
            sum += volume;
            for (const Index v : in_.cells.vertices[c]) met.insert(v);
            for (std::size_t i = 0; i <= d; ++i) ++facets[facet(c, i)];
            if (!is_empty(x)) return "the sphere of cell " + std::to_string(c) + " is not empty";
        }
        for (const auto& [key, times] : facets)
            if (times != 2) return "a facet has " + std::to_string(times) + " cells";
        if (met.size() != in_.points.size()) return "a vertex is in no cell";
        Rows box;
        for (std::size_t j = 0; j < d; ++j)
            for (std::size_t i = 0; i < d; ++i) box[j][i] = mpq_class(in_.box[j][i]);
        if (!in_.points.empty() && sum != (d == 2 ? 2 : 6) * abs(determinant(box))) return "volumes do not add up";
        return "";
    }

  private:
    using Place = std::array<mpq_class, static_cast<std::size_t>(d)>;
    using Rows = std::array<Place, static_cast<std::size_t>(d)>;
    using Simplex = std::array<Place, static_cast<std::size_t>(d + 1)>;

    [[nodiscard]] Place place(Index v, const std::array<long, static_cast<std::size_t>(d)>& offset) const {
        Place p;
        for (std::size_t i = 0; i < d; ++i) {
            p[i] = mpq_class(in_.points[static_cast<std::size_t>(v)][i]);
            for (std::size_t j = 0; j < d; ++j) p[i] += offset[j] * mpq_class(in_.box[j][i]);
        }
        return p;
    }
    [[nodiscard]] Simplex corners(std::size_t c) const {
        Simplex x;
        for (std::size_t i = 0; i <= d; ++i) {
            std::array<long, static_cast<std::size_t>(d)> o{};
            for (std::size_t j = 0; j < d; ++j) o[j] = in_.cells.offsets[c][i][j];
            x[i] = place(in_.cells.vertices[c][i], o);
        }
        return x;
    }
    static Rows edges(const Simplex& x) {
        Rows rows;
        for (std::size_t k = 0; k < d; ++k)
            for (std::size_t i = 0; i < d; ++i) rows[k][i] = x[k + 1][i] - x[0][i];
        return rows;
    }
    static mpq_class determinant(const Rows& m) {
        if constexpr (d == 2) return m[0][0] * m[1][1] - m[0][1] * m[1][0];
        else {
            mpq_class sum = 0;
            for (std::size_t i = 0; i < 3; ++i)
                sum += m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3]);
            return sum;
        }
    }
    /// The facet opposite to corner i as numbers: vertices and offsets, sorted, less the first offset.
    [[nodiscard]] std::vector<long> facet(std::size_t c, std::size_t i) const {
        std::vector<std::vector<long>> images;
        for (std::size_t k = 0; k <= d; ++k) {
            if (k == i) continue;
            std::vector<long> image{in_.cells.vertices[c][k]};
            for (const auto o : in_.cells.offsets[c][k]) image.push_back(o);
            images.push_back(image);
        }
        std::sort(images.begin(), images.end());
        std::vector<long> key;
        for (const auto& image : images)
            for (std::size_t k = 0; k < image.size(); ++k) key.push_back(k == 0 ? image[0] : image[k] - images[0][k]);
        return key;
    }

    /// Compares the distance of every image near the sphere with its radius.
    [[nodiscard]] bool is_empty(const Simplex& x) const {
        // The centre solves 2 (x_k - x_0) . y = |x_k - x_0|^2, y relative to x_0; by Cramer's rule.
        const Rows rows = edges(x);
        const mpq_class whole = determinant(rows);
        Place centre;
        mpq_class square = 0;
        for (std::size_t i = 0; i < d; ++i) {
            Rows replaced = rows;
            for (std::size_t k = 0; k < d; ++k) {
                replaced[k][i] = 0;
                for (std::size_t j = 0; j < d; ++j) replaced[k][i] += rows[k][j] * rows[k][j] / 2;
            }
            centre[i] = determinant(replaced) / whole;
            square += centre[i] * centre[i];
            centre[i] += x[0][i];
        }
        const double radius = std::sqrt(square.get_d());
        for (std::size_t v = 0; v < in_.points.size(); ++v) {
            std::array<long, static_cast<std::size_t>(d)> low{}, high{};
            for (std::size_t j = 0; j < d; ++j) {
                double f = 0, norm = 0;  // the coordinate of centre - point in the box, and how much a length adds
                for (std::size_t i = 0; i < d; ++i) {
                    const double dual = dual_coordinate(j, i);
                    f += dual * (centre[i].get_d() - in_.points[v][i]);
                    norm += dual * dual;
                }
                low[j] = static_cast<long>(std::floor(f - radius * std::sqrt(norm) - 0.001));
                high[j] = static_cast<long>(std::ceil(f + radius * std::sqrt(norm) + 0.001));
            }
            for (auto o = low;;) {
                if (is_near(v, o, centre, radius)) {
                    const Place p = place(static_cast<Index>(v), o);
                    mpq_class distance = 0;
                    for (std::size_t i = 0; i < d; ++i) distance += (p[i] - centre[i]) * (p[i] - centre[i]);
                    if (distance < square) return false;
                }
                std::size_t i = 0;
                while (i < d && ++o[i] > high[i]) {
                    o[i] = low[i];
                    ++i;
                }
                if (i == d) break;
            }
        }
        return true;
    }
    /// False only where an image is outside by far, so that doubles decide.
    [[nodiscard]] bool is_near(std::size_t v, const std::array<long, static_cast<std::size_t>(d)>& offset,
                               const Place& centre, double radius) const {
        double square = 0;
        for (std::size_t i = 0; i < d; ++i) {
            double x = in_.points[v][i] - centre[i].get_d();
            for (std::size_t j = 0; j < d; ++j) x += static_cast<double>(offset[j]) * in_.box[j][i];
            square += x * x;
        }
        return square < radius * radius * 1.001;
    }
    /// d f_j / d x_i for the coordinates f in the box.
    [[nodiscard]] double dual_coordinate(std::size_t j, std::size_t i) const {
        Rows box, replaced;
        for (std::size_t k = 0; k < d; ++k)
            for (std::size_t l = 0; l < d; ++l) box[k][l] = mpq_class(in_.box[k][l]);
        replaced = box;
        for (std::size_t l = 0; l < d; ++l) replaced[j][l] = l == i ? 1 : 0;
        return mpq_class(determinant(replaced) / determinant(box)).get_d();
    }

    const Periodic_audit_input<d>& in_;
};

}  // namespace annulus::testing
