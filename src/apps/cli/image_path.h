// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <annulus/space/basis_relation.h>
#include <annulus/types.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1::cli {

/// Which image of its point a frame has, from frame to frame: positions of a file jump where a point leaves the box on
/// one side and enters on the other. The path of a point goes on at the image that is nearest to where the box carries
/// it, from the image in which the point appears. So a pair of neighbours keeps one name while both points go around
/// the box, and while the box changes its vectors for others of the same lattice, as a sheared box of LAMMPS does.
template <int d>
class Image_path {
  public:
    /// By how many vectors of the present box the position in the frame is ahead of the path.
    using Turns = std::array<std::int64_t, static_cast<std::size_t>(d)>;

    /// Takes the next frame; ids ascend. O(n).
    void follow(std::span<const std::uint64_t> id, std::span<const Coordinates<d>> x, const Box<d>& box);

    [[nodiscard]] const std::vector<Turns>& turns() const { return turns_; }
    /// The vectors of the box of the frame before, as combinations of those of this one: rows.
    [[nodiscard]] const Integer_matrix<d>& basis() const { return basis_; }
    /// Displacements of the points that stay, relative to the box: their mean and maximum.
    [[nodiscard]] double mean() const { return mean_; }
    [[nodiscard]] double max() const { return max_; }

  private:
    std::vector<std::uint64_t> id_;
    std::vector<Coordinates<d>> share_;  // in shares of the box, as in the frame
    std::vector<Turns> turns_;
    typename Box<d>::Vectors vectors_{};  // of the last frame
    Integer_matrix<d> basis_{};
    double mean_ = 0, max_ = 0;
};

/// The shift of a pair as named by the paths: vector = path[j] - path[i] + shift . box.
template <int d>
[[nodiscard]] typename Image_path<d>::Turns shift_of_paths(const Image_path<d>& path, Index i, Index j,
                                                           const Shift<d>& shift) {
    typename Image_path<d>::Turns result;
    const auto& a = path.turns()[static_cast<std::size_t>(i)];
    const auto& b = path.turns()[static_cast<std::size_t>(j)];
    for (std::size_t k = 0; k < d; ++k) result[k] = shift[k] + b[k] - a[k];
    return result;
}

extern template class Image_path<2>;
extern template class Image_path<3>;

}  // namespace annulus::inline v1::cli
