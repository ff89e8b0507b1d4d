// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/expiry.h>
#include <annulus/types.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace annulus::inline v1 {

/// The number of a certificate in an expiry list.
using Certificate_id = std::uint32_t;

/// The certificates of one vertex that expire first, by path length, and a bound for all others.
///
/// For every certificate of the vertex, either it is listed with an expiry not above its own, or its expiry is at
/// least `rest`. So nothing expires before `earliest()`. While the path length stays below `rest`, only listed
/// certificates have to be tested; beyond it a star walk is needed. Entries are hints; the record of the certificate
/// (Certificate_expiries) is the truth.
///
/// Entries are kept sorted without branches: the place of a new entry is as good as random, and a wrong prediction
/// costs more than all the moves.
template <std::size_t capacity>
class alignas(capacity == 6 ? 64 : 32) Expiry_list {  // a cache line, or one and a half
  public:
    /// Removes every certificate.
    void clear() {
        rest_ = Expiry::never();
        entry_.fill(empty_entry);
    }
    [[nodiscard]] Expiry earliest() const { return std::min(rest_, expiry_of(entry_[0])); }
    [[nodiscard]] Expiry rest() const { return rest_; }
    /// The latest of the listed expiries; `rest` when nothing is listed.
    [[nodiscard]] Expiry latest() const {
        for (std::size_t i = capacity; i-- > 0;)
            if (entry_[i] != empty_entry) return expiry_of(entry_[i]);
        return rest_;
    }

    /// Removes the entries whose expiry `path_length` has reached and calls visit(id) for each; visit may put
    /// entries.
    template <class Visit>
    void take_reached(double path_length, Visit visit) {
        const Entry end = (Entry{Expiry::lower(path_length).bits()} + 1) << 32;
        std::size_t count = 0;
        for (const Entry e : entry_) count += static_cast<std::size_t>((e < end) & (e < empty_entry));
        std::array<Entry, 2 * capacity> queue{};
        std::copy(entry_.begin(), entry_.end(), queue.begin());
        std::fill(queue.begin() + capacity, queue.end(), empty_entry);
        std::copy_n(queue.begin() + static_cast<std::ptrdiff_t>(count), capacity, entry_.begin());
        for (std::size_t i = 0; i < count; ++i) visit(id_of(queue[i]));
    }
    /// Certificate `id` now expires at `expiry`. Most certificates are neither listed nor below `rest`, which then
    /// covers them.
    void put(Certificate_id id, Expiry expiry) {
        bool listed = false;
        for (const Entry e : entry_) listed |= id_of(e) == id;
        if (!listed && !(expiry < rest_)) return;
        Entry found = 0;  // all ones from the entry of `id` on
        for (std::size_t i = 0; i < capacity; ++i) {
            const Entry next = i + 1 < capacity ? entry_[i + 1] : empty_entry;
            found |= mask(id_of(entry_[i]) == id);
            entry_[i] = (entry_[i] & ~found) | (next & found);
        }
        put_new(id, expiry);
    }
    /// The same for a certificate that is not listed.
    void put_new(Certificate_id id, Expiry expiry) {
        Entry moving = (Entry{expiry.bits()} << 32) | id;
        for (Entry& e : entry_) {
            const Entry exchange = (e ^ moving) & mask(moving < e);
            e ^= exchange;
            moving ^= exchange;
        }
        rest_ = std::min(rest_, expiry_of(moving));
    }

    /// The same for many certificates, none of which is listed. Faster than one by one where `rest` covers most of
    /// them: a bound below which about `capacity` of them lie is found by counting, without branches.
    void put_new(std::span<const Expiry> expiry, std::span<const Certificate_id> id) {
        const std::uint32_t never = Expiry::never().bits();
        std::uint32_t low = never;
        for (const Expiry e : expiry) low = std::min(low, e.bits());
        // At most `capacity` are below low; more are below high, unless high is `never`.
        std::uint32_t high = never;
        bool enough = expiry.size() <= capacity;
        if (enough) low = never;
        for (std::uint32_t step = 1U << 12; !enough && high - low > 1; step = std::min(4 * step, 1U << 28)) {
            const std::uint32_t bound = low + std::min(step, (high - low) / 2);
            std::size_t below = 0;
            for (const Expiry e : expiry) below += static_cast<std::size_t>(e.bits() < bound);
            (below > capacity ? high : low) = bound;
            enough = below <= capacity && below > capacity / 2;
        }
        for (std::size_t i = 0; i < expiry.size(); ++i) {
            if (expiry[i].bits() < low) put_new(id[i], expiry[i]);
            else rest_ = std::min(rest_, expiry[i]);
        }
    }

    /// Upper bound of the length of the path of fixed positions since this was 0.
    double base = 0.0;
    /// The step in which the vertex was last anchored (Displacement_budget::stamp_).
    std::uint32_t stamp = 0;

  private:
    friend struct Trace;          // trace.h
    using Entry = std::uint64_t;  // expiry and id: the order is that of expiries
    // No certificate has this id.
    static constexpr Entry empty_entry = (Entry{Expiry::never().bits()} << 32) | 0xFFFFFFFFU;

    /// All ones or all zeros; compilers turn the conditional operator and std::min into branches.
    [[nodiscard]] static Entry mask(bool b) { return Entry{0} - static_cast<Entry>(b); }
    [[nodiscard]] static Expiry expiry_of(Entry e) { return Expiry::of_bits(static_cast<std::uint32_t>(e >> 32)); }
    [[nodiscard]] static Certificate_id id_of(Entry e) { return static_cast<Certificate_id>(e); }

    Expiry rest_ = Expiry::never();
    std::array<Entry, capacity> entry_ = [] {
        std::array<Entry, capacity> none_yet{};
        none_yet.fill(empty_entry);
        return none_yet;
    }();
};
static_assert(sizeof(Expiry_list<Wide_limits::listed(2)>) == 64 && sizeof(Expiry_list<Wide_limits::listed(3)>) == 96);

}  // namespace annulus::inline v1
