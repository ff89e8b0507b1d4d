// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <stdexcept>
#include <string>

namespace annulus::inline v1 {

/// What went wrong. Every exception the library throws on purpose is an `annulus::Error` with one of these.
enum class Error_code {
    not_finite,       ///< a coordinate is NaN or infinite
    out_of_domain,    ///< a coordinate is outside the coordinate domain (see domain.h)
    duplicate_point,  ///< two vertices would share a position
    too_few,          ///< an operation needs more points than there are
    wrong_size,       ///< the number of positions in a range is not the number of indices
    unknown_vertex,   ///< an index or handle that names no vertex
    environment,      ///< the floating-point environment is not the one the proofs assume
    usage,            ///< options that do not fit together
    too_large,        ///< more vertices or cells than indices can name (limits.h)
    bad_input,        ///< a file that cannot be read or has invalid contents
};

/// The one exception type of annulus. A failed call leaves its object as it was before.
class Error : public std::runtime_error {
  public:
    Error(Error_code code, const std::string& what) : std::runtime_error(what), code_(code) {}
    /// With the vertices concerned, at most two.
    Error(Error_code code, const std::string& what, std::initializer_list<std::int64_t> vertices)
        : std::runtime_error(what), code_(code) {
        for (const std::int64_t v : vertices)
            if (count_ < vertices_.size()) vertices_[count_++] = v;
    }
    /// The reason as a value; `what()` returns it as text.
    [[nodiscard]] Error_code code() const noexcept { return code_; }
    /// Indices of the vertices concerned, as far as they are known. For a duplicate point: both
    /// vertices, the smaller index first (in a construction the indices of the points in the input); in an insertion
    /// only the vertex that is there already. For other errors: the vertex whose position or index is refused.
    [[nodiscard]] std::span<const std::int64_t> vertices() const noexcept { return {vertices_.data(), count_}; }

  private:
    Error_code code_;
    std::size_t count_ = 0;
    std::array<std::int64_t, 2> vertices_{};
};

}  // namespace annulus::inline v1
