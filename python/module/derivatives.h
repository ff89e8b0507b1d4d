// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <module/arrays.h>

#include <annulus/error.h>
#include <annulus/voronoi.h>

#include <utility>

namespace annulus::python {

/// What voronoi_vjp takes.
inline Numbers weights_of(const py::object& weights) {
    Numbers g = numbers_of(weights, "g");
    if (g.ndim() != 1) throw Error(Error_code::wrong_size, "g must have shape (npoints,), not " + shape_of(g));
    return g;
}

/// What voronoi_jacobian returns.
template <int d>
py::tuple jacobian_tuple(Voronoi_jacobian<d> j) {
    return py::make_tuple(give(std::move(j.begin)), give(std::move(j.index)), give_rows(std::move(j.value)));
}

}  // namespace annulus::python
