// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/default_init_vector.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

/// Finds neighbours among the new cells {v, facet of the border} in 3D: two of them share a facet when their border
/// facets share an edge, in opposite directions. The vertices are renumbered for each insertion, so that a directed
/// edge is an entry of a small table.
class Cavity_edges {
  public:
    static constexpr std::uint32_t few = 64;  ///< vertices of a border: only one border in a thousand has more

    /// To be called before the first border. At most `vertices` borders may follow, of vertices below that number.
    void begin(std::size_t vertices) {
        constexpr std::uint32_t many_rounds = std::uint32_t{1} << 31;
        if (number_.size() != vertices || round_ > many_rounds) {
            number_.assign(vertices, 0);
            round_ = 0;
        }
        if (few_.empty()) few_.resize(few * few);
    }
    /// Calls work(number) for a new border. number(v) numbers v, from 0 in the order in which vertices are first met.
    /// No processor predicts which of the calls meets a new vertex: so there is no branch, and no `?:`, of which
    /// compilers make one.
    template <class Work>
    void with_numbers(Work work) {
        ++round_;
        std::uint32_t met = 0;  // in a register
        work([last = number_.data(), round = round_, &met](std::int32_t v) {
            std::uint64_t& mine = last[static_cast<std::size_t>(v)];
            const auto before = static_cast<std::uint32_t>(mine);
            const auto fresh = static_cast<std::uint32_t>(static_cast<std::uint32_t>(mine >> 32) != round);
            const std::uint32_t number = before ^ ((before ^ met) & (0U - fresh));
            mine = std::uint64_t{round} << 32 | number;
            met += fresh;
        });
        met_ = met;
    }
    /// The number of a vertex that was numbered for this border.
    [[nodiscard]] std::uint32_t number(std::int32_t v) const {
        return static_cast<std::uint32_t>(number_[static_cast<std::size_t>(v)]);
    }

    /// Calls work(entry). entry(a, b) is what is stored for the directed edge between two numbers; undefined until it
    /// is written.
    template <class Work>
    void with_edges(std::size_t facets, Work work) {
        if (met_ <= few) {
            work([edges = few_.data()](std::uint32_t a, std::uint32_t b) -> std::uint32_t& {
                return edges[a * few + b];
            });
            return;
        }
        std::size_t size = 64;
        while (size < 6 * facets) size *= 2;
        many_.assign(size, {nothing, 0});
        work([this, size](std::uint32_t a, std::uint32_t b) -> std::uint32_t& {
            const std::uint64_t key = std::uint64_t{a} << 32 | b;
            std::size_t i = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ULL) >> 32) & (size - 1);
            while (many_[i].key != nothing && many_[i].key != key) i = (i + 1) & (size - 1);
            many_[i].key = key;
            return many_[i].half_facet;
        });
    }

  private:
    static constexpr std::uint64_t nothing = ~std::uint64_t{0};

    std::vector<std::uint64_t> number_;  // by vertex: the border in which it was met last, and its number there
    std::uint32_t round_ = 0, met_ = 0;
    std::vector<std::uint32_t> few_;  // entries that are read were written for the same border
    struct Slot {
        std::uint64_t key;
        std::uint32_t half_facet;
    };
    std::vector<Slot> many_;
};

/// The same in 2D, where the border is a polygon: two new triangles share an edge when the border's edge of one ends at
/// the vertex where that of the other begins.
class Cavity_vertices {
  public:
    void begin(std::size_t vertices) { after_.resize(vertices); }
    /// Vertices keep their numbers.
    template <class Work>
    void with_numbers(Work work) {
        work([](std::int32_t) {});
    }
    [[nodiscard]] std::uint32_t number(std::int32_t v) const { return static_cast<std::uint32_t>(v); }
    /// What is stored for the edge that begins at a vertex; undefined until it is written.
    [[nodiscard]] std::uint32_t& after(std::uint32_t number) { return after_[number]; }

  private:
    Default_init_vector<std::uint32_t> after_;  // entries that are read were written for the same border
};

}  // namespace annulus::inline v1
