// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/spatial_order.h>

#include <annulus/mesh/parallel_runs.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// The Hilbert curve as an automaton (Hamilton, "Compact Hilbert indices", 2006): in each state, an octant (or
/// quadrant) has a place on the curve, and leads to a state for its interior.
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
};

/// The same for `levels` levels at once: an entry of the table is a place among the boxes so many levels deeper, and
/// the state there.
template <int d>
class Hilbert_steps {
  public:
    constexpr Hilbert_steps() {
        constexpr Hilbert_curve<d> curve;
        for (unsigned state = 0; state < curve.states; ++state)
            for (unsigned box = 0; box < boxes; ++box) {
                unsigned place = 0, in = state;
                for (int bit = levels - 1; bit >= 0; --bit) {
                    unsigned octant = 0;
                    for (unsigned c = 0; c < d; ++c)
                        octant |= ((box >> (static_cast<int>(c) * levels + bit)) & 1U) << c;
                    place = place << d | curve.place[in][octant];
                    in = curve.inner[in][octant];
                }
                step_[state][box] = static_cast<std::uint16_t>(place << state_bits | in);
            }
    }
    /// The place on the curve of a box with these coordinates, of `bits` bits each. Levels above are boxes at the
    /// curve's beginning, whose places are 0.
    [[nodiscard]] std::uint64_t key(const std::array<std::uint32_t, d>& box, int bits) const {
        std::uint64_t key = 0;
        unsigned state = 0;
        for (int shift = (bits - 1) / levels * levels; shift >= 0; shift -= levels) {
            unsigned inner = 0;
            for (unsigned c = 0; c < d; ++c)
                inner |= ((box[c] >> shift) & ((1U << levels) - 1)) << (static_cast<int>(c) * levels);
            const unsigned step = step_[state][inner];
            key = key << (d * levels) | step >> state_bits;
            state = step & ((1U << state_bits) - 1);
        }
        return key;
    }

  private:
    static constexpr int levels = d == 3 ? 2 : 3, state_bits = 5;
    static constexpr unsigned boxes = 1U << (d * levels);
    static_assert(Hilbert_curve<d>::states <= 1U << state_bits && d * levels + state_bits <= 16);
    std::array<std::array<std::uint16_t, boxes>, Hilbert_curve<d>::states> step_{};
};

template <int d>
constexpr Hilbert_steps<d> hilbert_curve;

/// The finalizer of MurmurHash3: every bit of the result depends on every bit of x.
std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 33)) * 0xff51afd7ed558ccdULL;
    x = (x ^ (x >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    return x ^ (x >> 33);
}

/// Of n vertices the last round has seven eighths, the one before it seven eighths of the rest, and so on, down to
/// about `first` of them in round 0.
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

}  // namespace

/// Stable sort by keys of `bits` bits, 11 at a time. Each thread counts the digits of a run, and moves it to its
/// places.
template <int d>
void Spatial_order<d>::sort_by_key(Keys& a, Keys& other, int bits, int threads) {
    constexpr std::size_t few = 512;  // sorting them costs less than counting 2,048 digits
    if (a.size() < few) {
        std::stable_sort(a.begin(), a.end(), [](const Keyed& l, const Keyed& r) { return l.key < r.key; });
        return;
    }
    constexpr std::size_t digits = 1U << digit, least_run = 1U << 15;
    const std::size_t runs = std::clamp(a.size() / least_run, std::size_t{1}, static_cast<std::size_t>(threads));
    const std::size_t length = (a.size() + runs - 1) / runs;
    std::vector<std::array<std::size_t, digits>> places(runs);
    other.resize(a.size());
    for (int shift = 0; shift < bits; shift += digit) {
        const auto digit_of = [shift](const Keyed& k) { return (k.key >> shift) & (digits - 1); };
        for_each_run(a.size(), length, threads, [&](std::size_t first, std::size_t last) {
            auto& count = places[first / length];
            count.fill(0);
            for (std::size_t i = first; i < last; ++i) ++count[digit_of(a[i])];
        });
        std::size_t sum = 0;
        for (std::size_t k = 0; k < digits; ++k)
            for (auto& place : places) sum += std::exchange(place[k], sum);
        for_each_run(a.size(), length, threads, [&](std::size_t first, std::size_t last) {
            auto& place = places[first / length];
            for (std::size_t i = first; i < last; ++i) other[place[digit_of(a[i])]++] = a[i];
        });
        a.swap(other);
    }
}

/// The bits of a coordinate of a box on the curve: there are at least 16 boxes a vertex, as many as fit into the same
/// number of digits.
template <int d>
int Spatial_order<d>::bits_of_box(std::size_t n, int round_bits) {
    const int least = std::max(static_cast<int>(std::bit_width(n)) + 4 + round_bits, 2 * digit);
    return ((least + digit - 1) / digit * digit - round_bits) / d;
}

template <int d>
void Spatial_order<d>::sort_along_curve(std::span<const Coordinates<d>> x, const Bounding_box<d>& around,
                                        std::span<Index> vertices, bool in_rounds, int threads, Keys& keys, Keys& other,
                                        int& place_bits) {
    constexpr std::size_t least_run = 4, first_round = 64, run = 1U << 14;
    const std::size_t n = vertices.size();
    const double extent = around.extent();
    const Rounds rounds(in_rounds ? n : 0, first_round);
    const int bits = bits_of_box(n, rounds.bits());
    const double boxes = static_cast<double>(1U << bits) - 0.5;
    place_bits = d * bits;
    keys.resize(n);
    for_each_run(n, run, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Coordinates<d>& p = x[static_cast<std::size_t>(vertices[i])];
            std::array<std::uint32_t, d> box{};
            if (extent > 0)
                for (std::size_t c = 0; c < d; ++c)
                    box[c] = static_cast<std::uint32_t>((p[c] - around.low[c]) / extent * boxes);
            keys[i] = {rounds.of(vertices[i]) << (d * bits) | hilbert_curve<d>.key(box, bits), vertices[i]};
        }
    });
    if (!(extent > 0)) return;
    sort_by_key(keys, other, d * bits + rounds.bits(), threads);
    for_each_run(n, run, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) vertices[i] = keys[i].vertex;
    });
    for (std::size_t i = 0, end = 0; i < n; i = end) {
        for (end = i + 1; end < n && keys[end].key == keys[i].key;) ++end;
        if (end - i <= least_run) continue;
        const auto equal = vertices.subspan(i, end - i);
        Keys of_equal, more;
        int own_bits = 0;
        sort_along_curve(x, Bounding_box<d>(x, equal), equal, false, 1, of_equal, more, own_bits);
    }
}

template <int d>
std::uint64_t Spatial_order<d>::moved_place(const Coordinates<d>& p, const Bounding_box<d>& around, double moved) {
    constexpr int bits = 16;
    constexpr double boxes = (1U << bits) - 0.5;
    std::array<std::uint32_t, d> box;
    for (std::size_t c = 0; c < d; ++c)
        box[c] = static_cast<std::uint32_t>(((p[c] - around.low[c]) / around.extent() + moved) / 2 * boxes);
    return hilbert_curve<d>.key(box, bits);
}

template <int d>
void Spatial_order<d>::sort(std::span<const Coordinates<d>> x, const Bounding_box<d>& around, std::span<Index> vertices,
                            int threads) {
    sort_along_curve(x, around, vertices, true, threads, keyed_, other_, bits_);
}

template class Spatial_order<2>;
template class Spatial_order<3>;

}  // namespace annulus::inline v1
