// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <module/arrays.h>

#include <annulus/box.h>
#include <annulus/error.h>

#include <cstddef>
#include <string>

namespace annulus::python {

/// The vectors of a box that is given as lengths, (d,), or as vectors in rows, (d, d).
template <int d>
typename Box<d>::Vectors box_vectors_of(const py::object& object) {
    const Numbers x = numbers_of(object, "box");
    typename Box<d>::Vectors vectors{};
    if (x.ndim() == 1 && x.shape(0) == d) {
        for (std::size_t i = 0; i < d; ++i) vectors[i][i] = x.data()[i];
    } else if (x.ndim() == 2 && x.shape(0) == d && x.shape(1) == d) {
        for (std::size_t i = 0; i < d; ++i)
            for (std::size_t j = 0; j < d; ++j) vectors[i][j] = x.data()[d * i + j];
    } else {
        const std::string n = std::to_string(d);
        throw Error(Error_code::wrong_size, "box must have shape (" + n + ",), lengths, or (" + n + ", " + n +
                                                "), vectors, not " + shape_of(x));
    }
    return vectors;
}

}  // namespace annulus::python
