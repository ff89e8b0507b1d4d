// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/default_init_vector.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus {

/// Glues the new cells {v, facet of the border} to one another. Two of them are neighbours when their facets of the border
/// share a ridge, a vertex in 2D and an edge in 3D; the two facets run through it in opposite directions.
///
/// glue(facets, cells, set): cells[f] is 4 times the new cell of facets[f]; calls set(half-facet, its twin) for each
/// half-facet that has v. O(number of facets).
template <int d>
class Ridges;

template <>
class Ridges<2> {
  public:
    void begin(std::size_t vertices) {
        if (begins_.size() < vertices) begins_.resize(vertices);
    }
    /// Facets are edges {a, b}; the border is a cycle, so the cell that begins where one ends is its neighbour.
    template <class Facet, class Set>
    void glue(std::span<const Facet> facets, std::span<const std::uint32_t> cells, Set set) {
        for (std::size_t f = 0; f < facets.size(); ++f) begins_[place(facets[f].vertex[0])] = 4 * cells[f] + 2;
        for (std::size_t f = 0; f < facets.size(); ++f) {
            const std::uint32_t next = begins_[place(facets[f].vertex[1])];
            set(4 * cells[f] + 1, next);
            set(next, 4 * cells[f] + 1);
        }
    }

  private:
    static std::size_t place(std::int32_t v) { return static_cast<std::size_t>(v); }
    Default_init_vector<std::uint32_t> begins_;  // by vertex; what is read was written in the same round
};

template <>
class Ridges<3> {
  public:
    void begin(std::size_t vertices) {
        number_.assign(vertices, 0);
        round_ = 0;
        if (few_.empty()) few_.resize(few * few);
    }
    template <class Facet, class Set>
    void glue(std::span<const Facet> facets, std::span<const std::uint32_t> cells, Set set) {
        renumber(facets);
        if (met_ <= few) {
            glue_by(facets, cells, set,
                    [this](std::uint32_t a, std::uint32_t b) -> std::uint32_t& { return few_[a * few + b]; });
            return;
        }
        std::size_t size = 64;
        while (size < 6 * facets.size()) size *= 2;
        many_.assign(size, {nothing, 0});
        glue_by(facets, cells, set, [this, size](std::uint32_t a, std::uint32_t b) -> std::uint32_t& {
            const std::uint64_t key = std::uint64_t{a} << 32 | b;
            std::size_t i = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ULL) >> 32) & (size - 1);
            while (many_[i].key != nothing && many_[i].key != key) i = (i + 1) & (size - 1);
            many_[i].key = key;
            return many_[i].half_facet;
        });
    }

  private:
    static constexpr std::uint32_t few = 64;  // vertices of a border: all but one in a thousand have fewer
    static constexpr std::uint64_t nothing = ~std::uint64_t{0};

    /// Numbers the vertices of the facets from 0 in the order in which they are met.
    template <class Facet>
    void renumber(std::span<const Facet> facets) {
        ++round_;  // one an insertion: a build has fewer than there are vertices
        met_ = 0;
        if (numbers_.size() < facets.size()) numbers_.resize(2 * facets.size());
        for (std::size_t f = 0; f < facets.size(); ++f)
            for (std::size_t k = 0; k < 3; ++k) {
                std::uint64_t& last = number_[static_cast<std::size_t>(facets[f].vertex[k])];
                const bool fresh = static_cast<std::uint32_t>(last >> 32) != round_;
                const std::uint32_t number = fresh ? met_ : static_cast<std::uint32_t>(last);
                last = std::uint64_t{round_} << 32 | number;
                met_ += fresh ? 1U : 0U;
                numbers_[f][k] = number;
            }
    }
    /// Entry (a, b): the half-facet of the cell whose facet has the directed edge a b. A new cell is {v, a, b, c}.
    template <class Facet, class Set, class Entry>
    void glue_by(std::span<const Facet> facets, std::span<const std::uint32_t> cells, Set set, Entry entry) {
        for (std::size_t f = 0; f < facets.size(); ++f) {
            const auto& [a, b, c] = numbers_[f];
            entry(a, b) = 4 * cells[f] + 3;
            entry(b, c) = 4 * cells[f] + 1;
            entry(c, a) = 4 * cells[f] + 2;
        }
        for (std::size_t f = 0; f < facets.size(); ++f) {
            const auto& [a, b, c] = numbers_[f];
            set(4 * cells[f] + 3, entry(b, a));
            set(4 * cells[f] + 1, entry(c, b));
            set(4 * cells[f] + 2, entry(a, c));
        }
    }

    std::vector<std::uint64_t> number_;  // by vertex: the round in which it was met last, and its number then
    std::uint32_t round_ = 0, met_ = 0;
    std::vector<std::array<std::uint32_t, 3>> numbers_;  // by facet
    std::vector<std::uint32_t> few_;                     // what is read was written in the same round
    struct Slot {
        std::uint64_t key;
        std::uint32_t half_facet;
    };
    std::vector<Slot> many_;
};

}  // namespace annulus
