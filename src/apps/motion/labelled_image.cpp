// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/labelled_image.h>

#include <annulus/error.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// Shares of labelled voxels at the nodes of a grid, with a layer of zeros all around.
struct Samples {
    std::array<std::size_t, 3> size{};
    Coordinates<3> origin{}, step{};
    std::vector<float> share;

    [[nodiscard]] std::size_t node(std::size_t i, std::size_t j, std::size_t k) const {
        return (k * size[1] + j) * size[0] + i;
    }
    [[nodiscard]] Coordinates<3> place(std::size_t n) const {
        const std::size_t at[3] = {n % size[0], n / size[0] % size[1], n / size[0] / size[1]};
        Coordinates<3> p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = origin[k] + static_cast<double>(at[k]) * step[k];
        return p;
    }
};

Samples average(const Labelled_image& image, std::size_t most) {
    Samples s;
    double block = 0;  // the least length of a block
    for (std::size_t k = 0; k < 3; ++k)
        block = std::max(block, image.spacing[k] * static_cast<double>(image.size[k]) / static_cast<double>(most));
    std::array<std::size_t, 3> voxels{};
    for (std::size_t k = 0; k < 3; ++k) {
        voxels[k] = std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(block / image.spacing[k] - 1e-9)), 1,
                                            image.size[k]);
        s.size[k] = (image.size[k] + voxels[k] - 1) / voxels[k] + 2;
        s.step[k] = image.spacing[k] * static_cast<double>(voxels[k]);
        // The middle of the first block, one block back: (voxels - 1) / 2 voxels from the middle of the first voxel.
        s.origin[k] = image.spacing[k] * 0.5 * (static_cast<double>(voxels[k]) - 1) - s.step[k];
    }
    s.share.assign(s.size[0] * s.size[1] * s.size[2], 0);
    const float one = 1.0F / static_cast<float>(voxels[0] * voxels[1] * voxels[2]);
    for (std::size_t k = 0; k < image.size[2]; ++k)
        for (std::size_t j = 0; j < image.size[1]; ++j)
            for (std::size_t i = 0; i < image.size[0]; ++i)
                if (image.at(i, j, k) != 0)
                    s.share[s.node(i / voxels[0] + 1, j / voxels[1] + 1, k / voxels[2] + 1)] += one;
    return s;
}

class Marching {
  public:
    explicit Marching(const Samples& s) : s_(s) {}

    Triangle_surface run() {
        // Freudenthal's six tetrahedra of a cube, along the orders of the axes; they agree on the faces of neighbours.
        constexpr std::size_t order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
        const std::size_t along[3] = {1, s_.size[0], s_.size[0] * s_.size[1]};
        for (std::size_t k = 0; k + 1 < s_.size[2]; ++k)
            for (std::size_t j = 0; j + 1 < s_.size[1]; ++j)
                for (std::size_t i = 0; i + 1 < s_.size[0]; ++i) {
                    const std::size_t corner = s_.node(i, j, k);
                    if (!crossed(corner, along)) continue;
                    for (std::size_t o = 0; o < 6; ++o) {
                        const std::size_t b = corner + along[order[o][0]], c = b + along[order[o][1]],
                                          d = c + along[order[o][2]];
                        // Even orders of the axes are positive tetrahedra.
                        if (o < 3) cut({corner, b, c, d});
                        else cut({corner, c, b, d});
                    }
                }
        return std::move(out_);
    }

  private:
    [[nodiscard]] bool inside(std::size_t n) const { return s_.share[n] >= 0.5F; }
    [[nodiscard]] bool crossed(std::size_t corner, const std::size_t (&along)[3]) const {
        int count = 0;
        for (unsigned m = 0; m < 8; ++m)
            count += inside(corner + (m & 1) * along[0] + (m >> 1 & 1) * along[1] + (m >> 2) * along[2]);
        return count != 0 && count != 8;
    }

    /// The point of the surface between two nodes, one inside.
    Index point(std::size_t a, std::size_t b) {
        const std::uint64_t low = std::min(a, b), key = low * 8 + direction(std::max(a, b) - low);
        const auto [at, is_new] = index_.emplace(key, static_cast<Index>(out_.points.size()));
        if (is_new) {
            const double fa = s_.share[a], fb = s_.share[b];
            // Not up to an end: points of different edges would coincide there.
            const double t = std::clamp((0.5 - fa) / (fb - fa), 0.02, 0.98);
            const Coordinates<3> p = s_.place(a), q = s_.place(b);
            Coordinates<3> x;
            for (std::size_t k = 0; k < 3; ++k) x[k] = p[k] + t * (q[k] - p[k]);
            out_.points.push_back(x);
        }
        return at->second;
    }
    /// 1 to 7: which of the axes an edge of the tetrahedra goes along.
    [[nodiscard]] std::uint64_t direction(std::size_t difference) const {
        std::uint64_t bits = 0;
        if (difference >= s_.size[0] * s_.size[1]) bits |= 4, difference -= s_.size[0] * s_.size[1];
        if (difference >= s_.size[0]) bits |= 2, difference -= s_.size[0];
        return bits | difference;
    }

    void cut(std::array<std::size_t, 4> t) {
        // Even permutations that bring the node that differs, or the two inside, to the front.
        constexpr std::size_t first[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 0, 1, 3}, {3, 0, 2, 1}};
        constexpr std::size_t pair[6][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2},
                                            {1, 2, 0, 3}, {3, 1, 0, 2}, {2, 3, 0, 1}};
        std::size_t count = 0;
        for (const std::size_t n : t) count += inside(n);
        if (count == 0 || count == 4) return;
        if (count == 2) {
            for (const auto& p : pair) {
                if (!inside(t[p[0]]) || !inside(t[p[1]])) continue;
                const Index q[4] = {point(t[p[0]], t[p[2]]), point(t[p[0]], t[p[3]]), point(t[p[1]], t[p[3]]),
                                    point(t[p[1]], t[p[2]])};
                out_.triangles.push_back({q[0], q[1], q[2]});
                out_.triangles.push_back({q[0], q[2], q[3]});
            }
            return;
        }
        for (const auto& f : first)
            if (inside(t[f[0]]) == (count == 1)) {
                const Index q[3] = {point(t[f[0]], t[f[1]]), point(t[f[0]], t[f[2]]), point(t[f[0]], t[f[3]])};
                if (count == 1) out_.triangles.push_back({q[0], q[1], q[2]});
                else out_.triangles.push_back({q[0], q[2], q[1]});
            }
    }

    const Samples& s_;
    Triangle_surface out_;
    std::unordered_map<std::uint64_t, Index> index_;
};

}  // namespace

Triangle_surface surface_of(const Labelled_image& image, std::size_t most) {
    if (image.label.size() != image.size[0] * image.size[1] * image.size[2] || most == 0)
        throw Error(Error_code::wrong_size, "surface_of: the image has not a label for every voxel");
    Triangle_surface surface = Marching(average(image, most)).run();
    if (surface.triangles.empty())
        throw Error(Error_code::bad_input, "the image has no label but 0, or none large enough");
    return surface;
}

}  // namespace annulus::inline v1
