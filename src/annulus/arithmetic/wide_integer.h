// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace annulus::inline v1 {

using Int128 = __int128;
using Unsigned128 = unsigned __int128;

/// An integer of 64 N bits in two's complement, the lowest word first. Overflow is lost: the caller must
/// bound its numbers.
template <std::size_t N>
struct Wide_integer {
    std::array<std::uint64_t, N> word{};

    [[nodiscard]] int sign() const {
        if (static_cast<std::int64_t>(word[N - 1]) < 0) return -1;
        std::uint64_t any = 0;
        for (const std::uint64_t w : word) any |= w;
        return any != 0 ? 1 : 0;
    }
    [[gnu::always_inline]] friend Wide_integer operator+(const Wide_integer& a, const Wide_integer& b) {
        Wide_integer r;
        std::uint64_t carry = 0;
        for (std::size_t i = 0; i < N; ++i) {
            const Unsigned128 s = Unsigned128{a.word[i]} + b.word[i] + carry;
            r.word[i] = static_cast<std::uint64_t>(s);
            carry = static_cast<std::uint64_t>(s >> 64);
        }
        return r;
    }
    [[gnu::always_inline]] friend Wide_integer operator-(const Wide_integer& a, const Wide_integer& b) {
        Wide_integer r;
        std::uint64_t borrow = 0;
        for (std::size_t i = 0; i < N; ++i) {
            const Unsigned128 s = Unsigned128{a.word[i]} - b.word[i] - borrow;
            r.word[i] = static_cast<std::uint64_t>(s);
            borrow = static_cast<std::uint64_t>(s >> 64) & 1U;
        }
        return r;
    }
};

/// The lowest 64 (N + M) bits of the product. Multiplies as unsigned words. For each factor that is negative it then
/// subtracts the other factor, shifted up by the number of words of the negative one. Without branches.
template <std::size_t N, std::size_t M>
[[nodiscard, gnu::always_inline]] inline Wide_integer<N + M> product(const Wide_integer<N>& a,
                                                                     const Wide_integer<M>& b) {
    Wide_integer<N + M> r;
    for (std::size_t i = 0; i < N; ++i) {
        std::uint64_t carry = 0;
        for (std::size_t j = 0; j < M; ++j) {
            const Unsigned128 t = Unsigned128{a.word[i]} * b.word[j] + r.word[i + j] + carry;
            r.word[i + j] = static_cast<std::uint64_t>(t);
            carry = static_cast<std::uint64_t>(t >> 64);
        }
        r.word[i + M] = carry;
    }
    const auto subtract_above = [&r](std::size_t from, const auto& words, std::uint64_t mask) {
        std::uint64_t borrow = 0;
        for (std::size_t i = 0; i < words.size(); ++i) {
            const Unsigned128 s = Unsigned128{r.word[from + i]} - (words[i] & mask) - borrow;
            r.word[from + i] = static_cast<std::uint64_t>(s);
            borrow = static_cast<std::uint64_t>(s >> 64) & 1U;
        }
    };
    const auto mask_of = [](std::uint64_t top) {
        return static_cast<std::int64_t>(top) < 0 ? ~std::uint64_t{0} : std::uint64_t{0};
    };
    subtract_above(N, b.word, mask_of(a.word[N - 1]));
    subtract_above(M, a.word, mask_of(b.word[M - 1]));
    return r;
}

[[nodiscard]] inline Wide_integer<1> wide(std::int64_t x) { return {{static_cast<std::uint64_t>(x)}}; }
[[nodiscard]] inline Wide_integer<2> wide(Int128 x) {
    return {{static_cast<std::uint64_t>(static_cast<Unsigned128>(x)),
             static_cast<std::uint64_t>(static_cast<Unsigned128>(x) >> 64)}};
}

}  // namespace annulus::inline v1
