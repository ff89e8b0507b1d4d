// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Bytes to programs and to points. A program's first byte is the strategy (low four bits) and the kind of coordinates (high four);
// then the number of points, the points, and operations until the bytes run out.

#include "program.h"

#include <cstdint>
#include <cstring>
#include <span>

namespace annulus::oracle {

class Decoder {
  public:
    explicit Decoder(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    template <int d>
    [[nodiscard]] Program_of<d> program() {
        Program_of<d> program;
        const std::uint8_t head = byte();
        program.setting = setting<d>(head & 15);
        coordinates_ = head >> 4;
        const std::size_t n = byte() % 24;
        std::size_t count = 0;
        for (; count < n; ++count) program.points.push_back(point<d>());
        std::size_t budget = d == 2 ? 64 : 32;  // calls; those of space are dear
        while (!bytes_.empty() && budget-- > 0) {
            const std::uint8_t code = byte();
            switch (code % 8) {
                case 0:
                case 1:
                case 2: {
                    const Index v = vertex(count);
                    program.operations.push_back({Operation_kind::move, v, {point<d>()}});
                    break;
                }
                case 3:
                case 4: {  // a whole timestamp: a few vertices take new places, the rest those they began with
                    std::vector<Coordinates<d>> x = program.points;
                    x.resize(count, Coordinates<d>{static_cast<double>(code), 1000.0});
                    const std::size_t some = byte() % 8;
                    for (std::size_t k = 0; k < some && count > 0; ++k) x[byte() % count] = point<d>();
                    program.operations.push_back({Operation_kind::move_all, none, std::move(x)});
                    break;
                }
                case 5:
                    program.operations.push_back({Operation_kind::insert, none, {point<d>()}});
                    ++count;  // at most: a vacant index may be taken
                    break;
                case 6: program.operations.push_back({Operation_kind::remove, vertex(count), {}}); break;
                default: program.operations.push_back({}); break;
            }
        }
        return program;
    }

    /// n points; the first byte is the kind of coordinates.
    template <int d>
    [[nodiscard]] std::vector<Coordinates<d>> points(std::size_t n) {
        coordinates_ = byte() >> 4;
        std::vector<Coordinates<d>> x;
        for (std::size_t i = 0; i < n; ++i) x.push_back(point<d>());
        return x;
    }

  private:
    template <int d>
    [[nodiscard]] static Setting setting(unsigned head) {
        if constexpr (d == 2) {
            if (head < certified_settings.size()) return certified_settings[head];
        } else {
            if (head < certified_settings_3.size()) return certified_settings_3[head];
        }
        if (d == 3 && head < 14) return head % 2 != 0 ? Strategy::filter : Strategy::filter_each;
        return {(head & 1) != 0 ? Strategy::filter : Strategy::filter_each, Second_look::off,
                (head & 2) != 0 ? Tolerance_kind::paper : Tolerance_kind::floating};
    }

    std::uint8_t byte() {
        if (bytes_.empty()) return 0;
        const std::uint8_t b = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return b;
    }
    Index vertex(std::size_t count) { return static_cast<Index>(byte() % (count + 1)); }
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
        switch (coordinates_) {
            case 0: return byte() % 5;  // a small grid
            case 1: return byte() % 16;
            case 2: return static_cast<std::int8_t>(byte());
            case 3: return raw(8);  // any double, also NaN and infinity
            case 4: return raw(3);  // any magnitude, few bits
            case 5: {               // a small grid, off by an ulp
                const std::uint8_t b = byte();
                const double x = 1.0 + b % 5;
                return (b >> 4) < 5 ? std::nextafter(x, (b & 16) != 0 ? 0.0 : 9.0) : x;
            }
            case 6: return std::ldexp(byte() % 16, -400);
            case 7: return std::ldexp(byte() % 16, 480);
            case 8: return 0x1p40 + byte() % 16;
            case 9: return std::ldexp(byte() % 16, -1074);
            case 10: return byte() % 5 + std::ldexp(byte(), -30);  // clusters
            default: return byte() / 16.0 + byte() / 4096.0;
        }
    }

    std::span<const std::uint8_t> bytes_;
    int coordinates_ = 0;
};

}  // namespace annulus::oracle
