// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/grow.h>
#include <annulus/types.h>

#include <compare>
#include <cstddef>
#include <iterator>
#include <vector>

namespace annulus::inline v1 {

/// The index of one kind of object. Does not convert to the index of another kind, nor to that of a vertex, which is
/// the caller's plain Index. The default is `none`, which names nothing.
template <class Tag>
class Typed_index {
  public:
    constexpr Typed_index() = default;
    explicit constexpr Typed_index(Index i) : value_(i) {}
    [[nodiscard]] static constexpr Typed_index none() { return {}; }

    [[nodiscard]] constexpr Index value() const { return value_; }
    /// The place in an array with an entry for each index. Precondition: it is not `none`.
    [[nodiscard]] constexpr std::size_t offset() const { return static_cast<std::size_t>(value_); }

    friend constexpr auto operator<=>(Typed_index, Typed_index) = default;
    constexpr Typed_index& operator++() {
        ++value_;
        return *this;
    }

  private:
    Index value_ = -1;
};

/// A cell of a Corner_table.
using Cell_index = Typed_index<struct Cell_tag>;
/// A corner of a cell. It also names the facet opposite to it as seen from there, a half-facet. A facet has the index
/// of the lesser of its two half-facets.
using Corner_index = Typed_index<struct Corner_tag>;
inline constexpr Cell_index no_cell;
inline constexpr Corner_index no_corner;
static_assert(sizeof(Cell_index) == sizeof(Index) && sizeof(Corner_index) == sizeof(Index));

/// An array with an entry for each index of one kind below a bound.
template <class I, class T>
class Indexed : public std::vector<T> {
  public:
    using std::vector<T>::vector;
    [[nodiscard]] T& operator[](I i) { return std::vector<T>::operator[](i.offset()); }
    [[nodiscard]] const T& operator[](I i) const { return std::vector<T>::operator[](i.offset()); }
    [[nodiscard]] bool has(I i) const { return i.offset() < this->size(); }
};
template <class T>
using By_cell = Indexed<Cell_index, T>;
template <class T>
using By_corner = Indexed<Corner_index, T>;

template <class I, class T>
void grow(Indexed<I, T>& x, I bound, const T& value = T()) {
    grow(static_cast<std::vector<T>&>(x), bound.offset(), value);
}

/// The indices below a bound for which `exists` returns true, in increasing order. Neither may change during
/// iteration.
template <class I, class Exists>
class Index_range {
  public:
    Index_range(I bound, Exists exists) : bound_(bound), exists_(exists) {}

    class Iterator {
      public:
        Iterator(const Index_range& range, I i) : range_(&range), i_(i) { skip(); }
        [[nodiscard]] I operator*() const { return i_; }
        Iterator& operator++() {
            ++i_;
            skip();
            return *this;
        }
        [[nodiscard]] bool operator==(std::default_sentinel_t) const { return i_ == range_->bound_; }

      private:
        void skip() {
            while (i_ != range_->bound_ && !range_->exists_(i_)) ++i_;
        }
        const Index_range* range_;
        I i_;
    };
    [[nodiscard]] Iterator begin() const { return {*this, I(0)}; }
    [[nodiscard]] std::default_sentinel_t end() const { return {}; }

  private:
    I bound_;
    Exists exists_;
};

}  // namespace annulus::inline v1
