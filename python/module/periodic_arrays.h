// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <module/arrays.h>
#include <module/box_vectors.h>

#include <annulus/periodic_mesh.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace annulus::python {

/// Shifts as int8, (m, corners, d). Throws Error(too_large).
template <int d, std::size_t corners>
[[nodiscard]] py::array bytes_of(const std::vector<std::array<Shift<d>, corners>>& shifts) {
    std::vector<std::int8_t> bytes;
    bytes.reserve(shifts.size() * corners * d);
    for (const auto& cell : shifts)
        for (const Shift<d>& s : cell)
            for (const std::int32_t x : s) {
                if (!std::in_range<std::int8_t>(x))
                    throw Error(Error_code::too_large, "an offset of " + std::to_string(x) +
                                                           " boxes does not fit int8: points that are neighbours were "
                                                           "given that many boxes apart");
                bytes.push_back(static_cast<std::int8_t>(x));
            }
    const auto m = static_cast<py::ssize_t>(shifts.size());
    return give(std::move(bytes), {m, static_cast<py::ssize_t>(corners), d});
}

/// What Periodic::state returned. Throws Error(wrong_size), Error(bad_input).
template <int d>
[[nodiscard]] Saved_periodic_mesh<d> saved_of(const py::object& vectors, const py::object& places,
                                              const py::object& images, const py::object& free_indices) {
    const Points_in<d> x(places, "places");
    const auto k = whole_numbers_of(images, "images");
    if (k.ndim() != 2 || k.shape(0) != static_cast<py::ssize_t>(x.span().size()) || k.shape(1) != d)
        throw Error(Error_code::wrong_size, "images must have a row for each place, not the shape " + shape_of(k));
    Saved_periodic_mesh<d> saved{
        box_vectors_of<d>(vectors), {x.span().begin(), x.span().end()}, {}, indices_of(free_indices)};
    saved.images.resize(saved.places.size());
    for (std::size_t i = 0; i < saved.images.size(); ++i)
        for (std::size_t c = 0; c < d; ++c) {
            const std::int64_t image = k.data()[d * i + c];
            if (!std::in_range<std::int32_t>(image))
                throw Error(Error_code::bad_input, "an image of " + std::to_string(image) + " boxes is too far away");
            saved.images[i][c] = static_cast<std::int32_t>(image);
        }
    return saved;
}

}  // namespace annulus::python
