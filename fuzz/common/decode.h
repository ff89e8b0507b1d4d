// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Bytes to programs. The first byte is the strategy (low four bits) and the kind of coordinates (high four); then the
// number of points, the points, and operations until the bytes run out.

#include "program.h"

#include <cstdint>
#include <cstring>
#include <span>

namespace annulus::oracle {

class Decoder {
  public:
    explicit Decoder(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    [[nodiscard]] Program program() {
        Program program;
        const std::uint8_t head = byte();
        if ((head & 15) < certified_settings.size()) {
            program.setting = certified_settings[head & 15];
        } else {
            program.setting.strategy = (head & 1) != 0 ? Strategy::filter : Strategy::filter_each;
            program.setting.tolerance = (head & 2) != 0 ? Tolerance_kind::paper : Tolerance_kind::floating;
        }
        coordinates_ = head >> 4;
        const std::size_t n = byte() % 24;
        std::size_t count = 0;
        for (; count < n; ++count) program.points.push_back(point());
        std::size_t budget = 64;
        while (!bytes_.empty() && budget-- > 0) {
            const std::uint8_t code = byte();
            switch (code % 8) {
                case 0:
                case 1:
                case 2: program.operations.push_back(move(vertex(count), point())); break;
                case 3:
                case 4: {  // a whole timestamp: a few vertices take new places, the rest those they began with
                    std::vector<Position> x = program.points;
                    x.resize(count, Position{static_cast<double>(code), 1000.0});
                    const std::size_t some = byte() % 8;
                    for (std::size_t k = 0; k < some && count > 0; ++k) x[byte() % count] = point();
                    program.operations.push_back(move_all(std::move(x)));
                    break;
                }
                case 5:
                    program.operations.push_back(insert(point()));
                    ++count;  // at most: a vacant index may be taken
                    break;
                case 6: program.operations.push_back(remove(vertex(count))); break;
                default: program.operations.push_back(settle()); break;
            }
        }
        return program;
    }

  private:
    std::uint8_t byte() {
        if (bytes_.empty()) return 0;
        const std::uint8_t b = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return b;
    }
    Index vertex(std::size_t count) { return static_cast<Index>(byte() % (count + 1)); }
    Position point() {
        const double x = coordinate();
        return {x, coordinate()};
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
