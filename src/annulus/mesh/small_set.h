// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/index.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

/// The keys met on a walk around a vertex. Allocates no memory while they are few. Nothing is marked in the cells
/// themselves, so several walks may run at the same time. `empty` is a key that never occurs. Open addressing;
/// insertion is O(1) on average.
template <class Key, class Hash>
class Small_set {
  public:
    explicit Small_set(Key empty) : empty_(empty), slot_(few, empty) {}

    /// Returns false when the key was there already.
    bool insert(Key key) {
        if (2 * (count_ + 1) > slot_.size()) grow();
        Key& slot = find(key);
        if (slot == key) return false;
        slot = key;
        ++count_;
        return true;
    }
    [[nodiscard]] bool contains(Key key) const { return const_cast<Small_set*>(this)->find(key) == key; }

  private:
    static constexpr std::size_t few = 128;  // a star in 3D has some 24 cells

    /// Where the key is, or belongs.
    [[nodiscard]] Key& find(Key key) {
        const std::size_t last = slot_.size() - 1;
        std::size_t i = static_cast<std::size_t>((Hash{}(key)*0x9E3779B97F4A7C15U) >> 32) & last;
        while (!(slot_[i] == empty_) && !(slot_[i] == key)) i = (i + 1) & last;
        return slot_[i];
    }
    void grow() {
        const std::vector<Key> old(slot_.begin(), slot_.end());
        slot_.assign(2 * old.size(), empty_);
        for (const Key key : old)
            if (!(key == empty_)) find(key) = key;
    }

    Key empty_;
    boost::container::small_vector<Key, few> slot_;
    std::size_t count_ = 0;
};

/// The hash of an index.
struct Index_hash {
    template <class Tag>
    [[nodiscard]] std::uint64_t operator()(Typed_index<Tag> i) const {
        return static_cast<std::uint32_t>(i.value());
    }
};

}  // namespace annulus::inline v1
