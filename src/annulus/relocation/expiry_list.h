// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>
#include <annulus/relocation/expiry.h>

#include <array>
#include <cstdint>

namespace annulus {

/// The certificates of one vertex that expire first, at its odometer readings, and a bound for all others.
///
/// For every certificate of the vertex, either it is listed with an expiry not above its own, or its expiry is at least
/// `rest`. So nothing expires before `earliest()`, and while readings stay below `rest` only listed certificates have to
/// be looked at: a full tour of the vertex' certificates is needed only when the list has run dry. Entries are hints;
/// the record of the certificate is the truth.
class alignas(64) Expiry_list {  // one cache line
  public:
    /// No certificate at all.
    void clear() {
        size_ = 0;
        rest_ = Expiry::never();
    }
    [[nodiscard]] Expiry earliest() const { return size_ == 0 ? rest_ : expiry_[0]; }
    [[nodiscard]] Expiry rest() const { return rest_; }
    /// The last of those listed.
    [[nodiscard]] Expiry latest() const { return size_ == 0 ? rest_ : expiry_[size_ - 1]; }
    [[nodiscard]] bool empty() const { return size_ == 0; }

    /// Takes the first entry off; precondition: not empty.
    Index pop() {
        const Index id = id_[0];
        remove(0);
        return id;
    }
    /// States that certificate `id` now expires at `expiry`.
    void put(Index id, Expiry expiry) {
        for (std::size_t i = 0; i < size_; ++i)
            if (id_[i] == id) {
                remove(i);
                break;
            }
        put_new(id, expiry);
    }
    /// The same for a certificate that is not listed.
    void put_new(Index id, Expiry expiry) {
        if (!(expiry < rest_)) return;
        if (size_ == capacity) {
            if (!(expiry < expiry_[capacity - 1])) {
                rest_ = expiry;
                return;
            }
            rest_ = expiry_[capacity - 1];
            --size_;
        }
        std::size_t i = size_++;
        for (; i > 0 && expiry < expiry_[i - 1]; --i) {
            expiry_[i] = expiry_[i - 1];
            id_[i] = id_[i - 1];
        }
        expiry_[i] = expiry;
        id_[i] = id;
    }

    /// Upper bound of the length of the path of fixed positions since the odometer was at 0.
    double base = 0.0;

  private:
    static constexpr std::size_t capacity = 6;

    void remove(std::size_t i) {
        --size_;
        for (; i < size_; ++i) {
            expiry_[i] = expiry_[i + 1];
            id_[i] = id_[i + 1];
        }
    }

    Expiry rest_ = Expiry::never();
    std::uint32_t size_ = 0;
    std::array<Expiry, capacity> expiry_{};
    std::array<Index, capacity> id_{};
};
static_assert(sizeof(Expiry_list) == 64);

}  // namespace annulus
