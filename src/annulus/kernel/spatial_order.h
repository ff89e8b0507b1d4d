// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/bounding_box.h>
#include <annulus/kernel/default_init_vector.h>
#include <annulus/types.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The order in which Builder inserts vertices. Memory is kept from one call to the next.
///
/// A biased randomized insertion order (Amenta, Choi, Rote, SoCG 2003): rounds, each eight times as large as the one
/// before, to which vertices are assigned by a hash of the index; within a round along a Hilbert curve. Without
/// rounds, points on few lines or spheres would make cavities that grow with n. Points with equal keys on the curve
/// are sorted again in their own box, so clusters of any scale are resolved; points at one position keep the order of
/// `vertices`. The order depends only on indices and positions.
template <int d>
class Spatial_order {
  public:
    /// Sorts vertices, given as indices of points x with this bounding box. Expected O(n).
    void sort(std::span<const Coordinates<d>> x, const Bounding_box<d>& around, std::span<Index> vertices,
              int threads = 1);

    /// The round of the vertex that is k-th now, and its place on the curve (equal places are near).
    [[nodiscard]] std::uint64_t round(std::size_t k) const { return keyed_[k].key >> bits_; }
    [[nodiscard]] std::uint64_t place(std::size_t k) const { return keyed_[k].key & ((std::uint64_t{1} << bits_) - 1); }

    /// The place of p on another curve, through a box of twice the extent that begins `moved` times the extent before
    /// the bounding box: its pieces have other borders. Preconditions: 0 <= moved <= 1; there are points at different
    /// positions.
    [[nodiscard]] static std::uint64_t moved_place(const Coordinates<d>& p, const Bounding_box<d>& around,
                                                   double moved);

  private:
    struct Keyed {
        std::uint64_t key;
        Index vertex;
    };
    using Keys = Default_init_vector<Keyed>;

    static constexpr int digit = 11;  // bits of a key that are sorted at once

    [[nodiscard]] static int bits_of_box(std::size_t n, int round_bits);
    static void sort_by_key(Keys& keys, Keys& other, int bits, int threads);
    static void sort_along_curve(std::span<const Coordinates<d>> x, const Bounding_box<d>& around,
                                 std::span<Index> vertices, bool in_rounds, int threads, Keys& keys, Keys& other,
                                 int& bits);

    Keys keyed_, other_;
    int bits_ = 0;  // of a place
};

extern template class Spatial_order<2>;
extern template class Spatial_order<3>;

}  // namespace annulus::inline v1
