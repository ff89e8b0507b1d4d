// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <module/arrays.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace annulus::python {

/// What is interpolated: an array of numbers for each vertex, (npoints, ..).
class Values_in {
  public:
    /// Throws Error(wrong_size) for a single number.
    explicit Values_in(const py::object& object) : numbers_(numbers_of(object, "values")) {
        if (numbers_.ndim() == 0) throw Error(Error_code::wrong_size, "values must have shape (npoints, ..), not ()");
        for (py::ssize_t k = 1; k < numbers_.ndim(); ++k) width_ *= static_cast<std::size_t>(numbers_.shape(k));
        data_ = numbers_.data();
        rows_ = static_cast<std::size_t>(numbers_.shape(0));
    }
    /// The shape of values at positions of this shape.
    [[nodiscard]] std::vector<py::ssize_t> shape_at(std::vector<py::ssize_t> positions) const {
        positions.insert(positions.end(), numbers_.shape() + 1, numbers_.shape() + numbers_.ndim());
        return positions;
    }
    // The rest needs no GIL.
    void require_rows(std::size_t points) const {
        if (rows_ != points)
            throw Error(Error_code::wrong_size, "values must have " + std::to_string(points) +
                                                    " rows, one for each point, not " + std::to_string(rows_));
    }
    /// Adds sum_k weight[k] * value of vertex[k] to the list; NaN where there are no weights.
    template <class Vertex>
    void append(std::vector<double>& out, std::size_t weights, Vertex vertex, const double* weight) const {
        const std::size_t begin = out.size();
        out.resize(begin + width_, weights == 0 ? std::numeric_limits<double>::quiet_NaN() : 0.0);
        for (std::size_t k = 0; k < weights; ++k) {
            const double* const from = data_ + at(vertex(k)) * width_;
            for (std::size_t i = 0; i < width_; ++i) out[begin + i] += weight[k] * from[i];
        }
    }

  private:
    Numbers numbers_;
    const double* data_;
    std::size_t rows_;
    std::size_t width_ = 1;
};

}  // namespace annulus::python
