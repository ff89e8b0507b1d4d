// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/spatial_order.h>

#include <annulus/kernel/bounding_box.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace annulus {

namespace {

/// The Hilbert curve as an automaton (Hamilton, "Compact Hilbert indices", 2006): in a state, an octant (or quadrant)
/// has a place on the curve, and leads to a state for what is inside it.
template <int d>
struct Hilbert_curve {
    static constexpr unsigned octants = 1U << d;
    static constexpr unsigned states = octants * d;
    std::array<std::array<std::uint8_t, octants>, states> place{};
    std::array<std::array<std::uint8_t, octants>, states> inner{};

    static constexpr unsigned rotate_left(unsigned x, unsigned k) {
        k %= d;
        return ((x << k) | (x >> (d - k))) & (octants - 1);
    }
    static constexpr unsigned rotate_right(unsigned x, unsigned k) { return rotate_left(x, d - k % d); }
    static constexpr unsigned gray_code(unsigned i) { return i ^ (i >> 1); }
    static constexpr unsigned gray_code_inverse(unsigned g) {
        for (unsigned shift = 1; shift < d; shift <<= 1) g ^= g >> shift;
        return g;
    }
    static constexpr unsigned trailing_ones(unsigned i) { return static_cast<unsigned>(std::countr_one(i)); }

    constexpr Hilbert_curve() {
        for (unsigned entry = 0; entry < octants; ++entry)
            for (unsigned direction = 0; direction < d; ++direction)
                for (unsigned octant = 0; octant < octants; ++octant) {
                    const unsigned w = gray_code_inverse(rotate_right(octant ^ entry, direction + 1));
                    const unsigned in = w == 0 ? 0 : gray_code(2 * ((w - 1) / 2));
                    const unsigned turn = w == 0 ? 0 : trailing_ones(w % 2 == 0 ? w - 1 : w) % d;
                    const unsigned next_entry = entry ^ rotate_left(in, direction + 1);
                    const unsigned next_direction = (direction + turn + 1) % d;
                    place[entry * d + direction][octant] = static_cast<std::uint8_t>(w);
                    inner[entry * d + direction][octant] = static_cast<std::uint8_t>(next_entry * d + next_direction);
                }
    }
    /// The place on the curve of a box with these coordinates, of `bits` bits each.
    [[nodiscard]] std::uint64_t key(const std::array<std::uint32_t, d>& box, int bits) const {
        std::uint64_t key = 0;
        unsigned state = 0;
        for (int bit = bits - 1; bit >= 0; --bit) {
            unsigned octant = 0;
            for (unsigned c = 0; c < d; ++c) octant |= ((box[c] >> bit) & 1U) << c;
            key = key << d | place[state][octant];
            state = inner[state][octant];
        }
        return key;
    }
};

template <int d>
constexpr Hilbert_curve<d> hilbert_curve;

struct Keyed {
    std::uint64_t key;
    Index vertex;
};

/// Stable, by keys of `bits` bits, 11 at a time.
void radix_sort(std::vector<Keyed>& a, std::vector<Keyed>& other, int bits) {
    constexpr std::size_t few = 512;  // to sort them costs less than to count 2,048 digits
    if (a.size() < few) {
        std::stable_sort(a.begin(), a.end(), [](const Keyed& l, const Keyed& r) { return l.key < r.key; });
        return;
    }
    constexpr int digit = 11;
    constexpr std::uint64_t mask = (1U << digit) - 1;
    other.resize(a.size());
    for (int shift = 0; shift < bits; shift += digit) {
        std::array<std::size_t, (1U << digit) + 1> begin{};
        for (const Keyed& k : a) ++begin[((k.key >> shift) & mask) + 1];
        if (std::find(begin.begin(), begin.end(), a.size()) != begin.end()) continue;  // all have the same digit
        for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
        for (const Keyed& k : a) other[begin[(k.key >> shift) & mask]++] = k;
        a.swap(other);
    }
}

/// The finalizer of MurmurHash3: every bit of the result depends on every bit of x.
std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 33)) * 0xff51afd7ed558ccdULL;
    x = (x ^ (x >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    return x ^ (x >> 33);
}

/// Of n vertices the last round has seven eighths, the one before it seven eighths of the rest, and so on, down to some
/// `first` of them in round 0.
class Rounds {
  public:
    Rounds(std::size_t n, std::size_t first) {
        for (std::size_t m = n; m > first; m /= 8) ++last_;
    }
    [[nodiscard]] int bits() const { return static_cast<int>(std::bit_width(static_cast<unsigned>(last_))); }
    [[nodiscard]] std::uint64_t of(Index v) const {
        const std::uint64_t h = mixed(2 * static_cast<std::uint64_t>(v) + 1);
        return static_cast<std::uint64_t>(last_ - std::min(last_, std::countr_zero(h | 1ULL << 63) / 3));
    }

  private:
    int last_ = 0;
};

template <int d>
void sort_along_curve(std::span<const Coordinates<d>> x, std::span<Index> vertices, bool in_rounds) {
    constexpr std::size_t least_run = 4, first_round = 64;
    const std::size_t n = vertices.size();
    const Bounding_box<d> around(x, vertices);
    const double extent = around.extent();
    if (!(extent > 0)) return;
    const int bits = d == 3 ? (n < 100'000 ? 12 : 17) : (n < 100'000 ? 11 : n < 2'000'000 ? 14 : 16);
    const double boxes = static_cast<double>(1U << bits) - 0.5;
    const Rounds rounds(in_rounds ? n : 0, first_round);
    std::vector<Keyed> keyed(n), other;
    for (std::size_t i = 0; i < n; ++i) {
        std::array<std::uint32_t, d> box{};
        for (std::size_t c = 0; c < d; ++c)
            box[c] = static_cast<std::uint32_t>((x[static_cast<std::size_t>(vertices[i])][c] - around.low[c]) /
                                                extent * boxes);
        keyed[i] = {rounds.of(vertices[i]) << (d * bits) | hilbert_curve<d>.key(box, bits), vertices[i]};
    }
    radix_sort(keyed, other, d * bits + rounds.bits());
    for (std::size_t i = 0; i < n; ++i) vertices[i] = keyed[i].vertex;
    for (std::size_t i = 0, end = 0; i < n; i = end) {
        for (end = i + 1; end < n && keyed[end].key == keyed[i].key;) ++end;
        if (end - i > least_run) sort_along_curve<d>(x, vertices.subspan(i, end - i), false);
    }
}

}  // namespace

template <int d>
void spatial_order(std::span<const Coordinates<d>> x, std::vector<Index>& vertices) {
    sort_along_curve<d>(x, vertices, true);
}

template void spatial_order<2>(std::span<const Coordinates<2>>, std::vector<Index>&);
template void spatial_order<3>(std::span<const Coordinates<3>>, std::vector<Index>&);

}  // namespace annulus
