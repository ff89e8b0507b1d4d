// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace annulus::oracle {

/// A list of bytes that ends in zeros.
class Bytes {
  public:
    explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
    [[nodiscard]] bool empty() const { return bytes_.empty(); }
    std::uint8_t next() {
        if (bytes_.empty()) return 0;
        const std::uint8_t b = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return b;
    }
    std::size_t below(std::size_t n) { return n == 0 ? 0 : next() % n; }

  private:
    std::span<const std::uint8_t> bytes_;
};

}  // namespace annulus::oracle
