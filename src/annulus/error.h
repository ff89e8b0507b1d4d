// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

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
    /// With the vertices concerned.
    Error(Error_code code, const std::string& what, std::vector<std::int64_t> vertices)
        : std::runtime_error(what),
          code_(code),
          vertices_(std::make_shared<const std::vector<std::int64_t>>(std::move(vertices))) {}
    /// The reason as a value; `what()` returns it as text.
    [[nodiscard]] Error_code code() const noexcept { return code_; }
    /// All vertices concerned, by the caller's numbers, ascending. Valid as long as this object or a copy of it.
    /// - duplicate_point: the vertices that would share a position, two or more; where several positions would be
    ///   shared, those of one of them. In a construction they are numbers of points in the input; in an insertion the
    ///   one vertex that is there already.
    /// - not_finite, out_of_domain: the vertices (in a construction points, in rows of points rows) whose coordinates
    ///   are refused, for either reason. None if a single point has no number, as in an insertion.
    /// - unknown_vertex: every index that names no vertex. None for a handle.
    /// - bad_input of Voronoi measures: the corners of the cell that is not positive.
    /// Other errors concern no vertices.
    [[nodiscard]] std::span<const std::int64_t> vertices() const noexcept {
        return vertices_ ? std::span<const std::int64_t>(*vertices_) : std::span<const std::int64_t>();
    }

  private:
    Error_code code_;
    std::shared_ptr<const std::vector<std::int64_t>> vertices_;  // shared: copying an exception must not throw
};

}  // namespace annulus::inline v1
