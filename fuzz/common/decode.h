// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Bytes to programs and to points. A program's first byte is the setting (low four bits) and the kind of coordinates
// (high four); then the number of points, the points, and operations until the bytes run out. fuzz/make-seeds writes
// such bytes.

#include "operation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>

namespace annulus::oracle {

/// Kinds of coordinates; those from `fine` on are all `fine`.
enum class Numbers { grid, sixteen, small, raw, short_, ulp, tiny, huge, far, subnormal, cluster, fine };
[[nodiscard]] constexpr std::string_view name_of(Numbers n) {
    constexpr std::array<std::string_view, 12> names{"grid", "sixteen", "signed", "raw",       "short",   "ulp",
                                                     "tiny", "huge",    "far",    "subnormal", "cluster", "fine"};
    return names[static_cast<std::size_t>(n)];
}

class Decoder {
  public:
    explicit Decoder(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    template <int d>
    [[nodiscard]] Program_of<d> program() {
        Program_of<d> program;
        const std::uint8_t head = byte();
        program.setting = setting(head & 15);
        numbers_ = numbers(head >> 4);
        const std::size_t n = byte() % 24;
        for (std::size_t i = 0; i < n && !bytes_.empty(); ++i) {  // in most programs duplicate points are left out
            const Coordinates<d> p = point<d>();
            const auto& x = program.points;
            if (numbers_ == Numbers::raw || std::find(x.begin(), x.end(), p) == x.end()) program.points.push_back(p);
        }
        int calls = d == 2 ? 64 : 32;  // calls in 3D are expensive
        int steps = d == 2 ? 320 : 96;
        for (; !bytes_.empty() && calls > 0 && steps > 0; --calls) {
            program.operations.push_back(operation<d>());
            steps -= program.operations.back().times;
        }
        return program;
    }

    /// n points; the first byte is the kind of coordinates.
    template <int d>
    [[nodiscard]] std::vector<Coordinates<d>> points(std::size_t n) {
        numbers_ = numbers(byte() >> 4);
        std::vector<Coordinates<d>> x;
        for (std::size_t i = 0; i < n; ++i) x.push_back(point<d>());
        return x;
    }

    [[nodiscard]] static Numbers numbers(unsigned high) { return static_cast<Numbers>(std::min(high, 11U)); }

    /// The certified settings, the others, and again the most complex ones.
    [[nodiscard]] static Setting setting(unsigned low) {
        // `auto` was added later: it is among the last.
        const auto old = static_cast<unsigned>(certified_settings.size() - 1);
        if (low < old) return certified_settings[low];
        low -= old;
        if (low < uncertified_settings.size()) return uncertified_settings[low];
        return std::array<Setting, 3>{Strategy::tolerances, Strategy::automatic, Strategy::tolerances_each}[low % 3];
    }

    static constexpr std::array paces{0x1p-40, 0x1p-30, 0x1p-24, 0x1p-20, 0x1p-17, 0x1p-14, 0x1p-12, 0x1p-10,
                                      0x1p-8,  0x1p-6,  0x1p-5,  0x1p-4,  0x1p-3,  0.25,    0.5,     1.0};
    /// Of Motion::tolerances: in tolerances.
    static constexpr std::array shares{0.0625,  0.25,   0.5,   0.75, 0.9, 0.99, 0.9999, 0.99999,
                                       1.00001, 1.0001, 1.002, 1.01, 1.3, 2.0,  3.0,    8.0};
    static constexpr std::array times{1, 2, 3, 4, 5, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 300};

  private:
    std::uint8_t byte() {
        if (bytes_.empty()) return 0;
        const std::uint8_t b = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return b;
    }

    /// By the low four bits of its first byte.
    template <int d>
    Operation_of<d> operation() {
        using Do = Calls<d>;
        const std::uint8_t code = byte();
        switch (code & 15) {
            case 0:
            case 1: {
                const Index v = byte();
                return Do::move_some(v, point<d>());
            }
            case 2:
            case 3:
            case 4:
            case 5:
            case 6:
            case 7: {
                // The motion in the high bits and one more bit, pace and times in a byte, the seed in another.
                const std::size_t m = static_cast<std::size_t>(code >> 4) % all_motions.size();
                const std::uint8_t how = byte();
                const Motion motion = all_motions[m];
                const double pace = motion == Motion::tolerances ? shares[how & 15] : paces[how & 15];
                return Do::steady(motion, times[how >> 4], pace, byte());
            }
            case 8:
            case 9: {  // to explicit positions
                std::vector<Coordinates<d>> x;
                const std::size_t some = 1 + byte() % 24;
                while (x.size() < some && !bytes_.empty()) x.push_back(point<d>());
                return Do::move_most(x);
            }
            case 10: return Do::insert_near(point<d>());
            case 11: return Do::remove_some(byte());
            case 12: return Do::recompute_tolerances();
            case 13: return Do::stay();
            case 14: return Do::refused(static_cast<Refusal>(static_cast<std::size_t>(code >> 4) % refusals), byte());
            default: break;
        }
        // Unchanged, legal or not.
        const auto v = static_cast<Index>(byte() % 32) - 1;
        switch (code >> 4 & 3) {
            case 0: return Do::insert(point<d>());
            case 1: return Do::remove(v);
            default: return Do::move(v, point<d>());
        }
    }

    template <int d>
    Coordinates<d> point() {
        Coordinates<d> p;
        for (double& c : p) c = coordinate();
        return p;
    }
    double raw(std::size_t size) {
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < size; ++i) bits = bits << 8 | byte();
        bits <<= 8 * (8 - size);
        double x = 0.0;
        std::memcpy(&x, &bits, sizeof x);
        return x;
    }
    double coordinate() {
        switch (numbers_) {
            case Numbers::grid: return byte() % 5;
            case Numbers::sixteen: return byte() % 16;
            case Numbers::small: return static_cast<std::int8_t>(byte());
            case Numbers::raw: return raw(8);     // any double, also NaN and infinity
            case Numbers::short_: return raw(3);  // any magnitude, few bits
            case Numbers::ulp: {                  // a small grid, off by an ulp
                const std::uint8_t b = byte();
                const double x = 1.0 + b % 5;
                return (b >> 4) < 5 ? std::nextafter(x, (b & 16) != 0 ? 0.0 : 9.0) : x;
            }
            case Numbers::tiny: return std::ldexp(byte() % 16, -400);
            case Numbers::huge: return std::ldexp(byte() % 16, 480);
            case Numbers::far: return 0x1p40 + byte() % 16;
            case Numbers::subnormal: return std::ldexp(byte() % 16, -1074);
            case Numbers::cluster:
            case Numbers::fine: break;
        }
        const double first = byte();  // two statements: in one expression the order is unspecified
        const double second = byte();
        return numbers_ == Numbers::fine ? first / 16.0 + second / 4096.0 : std::fmod(first, 5.0) + second * 0x1p-30;
    }

    std::span<const std::uint8_t> bytes_;
    Numbers numbers_ = Numbers::grid;
};

}  // namespace annulus::oracle
