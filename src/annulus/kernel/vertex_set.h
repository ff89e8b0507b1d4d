// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/index.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace annulus::inline v1 {

/// The set of indices that are vertices. The other indices below the bound are free.
class Vertex_set {
  public:
    /// One more than the largest index so far.
    [[nodiscard]] std::size_t bound() const { return has_.size(); }
    [[nodiscard]] std::size_t size() const { return size_; }
    /// Precondition: v is below the bound.
    [[nodiscard]] bool has(Index v) const { return has_[at(v)] != 0; }

    /// Makes all indices below n vertices, and no others.
    void assign(std::size_t n) {
        has_.assign(n, 1);
        size_ = n;
    }
    /// New indices are free; vertices at or above the bound are removed.
    void set_bound(std::size_t n) {
        has_.resize(n, 0);
        size_ = static_cast<std::size_t>(std::count(has_.begin(), has_.end(), char{1}));
    }
    /// Precondition: v is not a vertex.
    void insert(Index v) {
        if (at(v) >= has_.size()) has_.resize(at(v) + 1, 0);
        has_[at(v)] = 1;
        ++size_;
    }
    /// Precondition: v is a vertex.
    void erase(Index v) {
        has_[at(v)] = 0;
        --size_;
    }
    /// The vertices in ascending order.
    [[nodiscard]] std::vector<Index> list() const {
        std::vector<Index> vertices;
        if (size_ == has_.size()) {
            vertices.resize(size_);
            std::iota(vertices.begin(), vertices.end(), Index{0});
            return vertices;
        }
        vertices.reserve(size_);
        for (std::size_t v = 0; v < has_.size(); ++v)
            if (has_[v] != 0) vertices.push_back(static_cast<Index>(v));
        return vertices;
    }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }

    std::vector<char> has_;
    std::size_t size_ = 0;
};

}  // namespace annulus::inline v1
