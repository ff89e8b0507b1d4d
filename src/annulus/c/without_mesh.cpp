// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of annulus.h that need no mesh: predicates, and the audit of any triangulation.
#include <annulus/annulus.h>
#include <annulus/audit.h>
#include <annulus/c/structs.h>
#include <annulus/predicates.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

using namespace annulus;
using namespace annulus::c;

namespace {

/// Calls a predicate for rows of k points.
template <int d, std::size_t k, class Predicate>
int signs_of(size_t count, const double* x, annulus_sign* signs, Predicate predicate) {
    return guarded(error_of_thread(), [&] {
        using Row = std::array<Coordinates<d>, k>;
        static_assert(sizeof(Row) == k * d * sizeof(double));
        if (count > PTRDIFF_MAX / (sizeof(Row) + sizeof(Certified_sign)))
            throw Refused(ANNULUS_WRONG_SIZE, std::to_string(count) + " rows are more than memory can hold");
        require(x, count, "coordinates");
        require(signs, count, "signs");
        std::vector<Certified_sign> out(count);
        predicate(std::span<const Row>(reinterpret_cast<const Row*>(x), count), std::span<Certified_sign>(out));
        std::transform(out.begin(), out.end(), signs, [](const Certified_sign& s) {
            return annulus_sign{s.tolerance, s.width_lower, s.width_upper,
                                s.theta,     s.sign,        static_cast<std::int32_t>(s.stage)};
        });
    });
}

template <int d>
Audit_result audit_of(const double* x, std::size_t points, const std::int32_t* vertices, std::size_t cells,
                      std::size_t most) {
    using Cell = std::array<Index, static_cast<std::size_t>(d) + 1>;
    static_assert(sizeof(Cell) == (d + 1) * sizeof(std::int32_t) && sizeof(Coordinates<d>) == d * sizeof(double));
    return annulus::audit(std::span(reinterpret_cast<const Coordinates<d>*>(x), points),
                          std::span(reinterpret_cast<const Cell*>(vertices), cells), most);
}

annulus_fault fault_of(const Audit_fault& f) {
    annulus_fault out{};
    std::copy(f.cells.begin(), f.cells.end(), out.cells);
    std::copy(f.vertices.begin(), f.vertices.end(), out.vertices);
    out.kind = static_cast<std::int32_t>(f.kind);
    return out;
}

}  // namespace

int annulus_orient_2d(size_t count, const double* coordinates, annulus_sign* signs) {
    return signs_of<2, 3>(count, coordinates, signs, [](auto x, auto out) { orient_2d(x, out); });
}
int annulus_orient_3d(size_t count, const double* coordinates, annulus_sign* signs) {
    return signs_of<3, 4>(count, coordinates, signs, [](auto x, auto out) { orient_3d(x, out); });
}
int annulus_in_circle(size_t count, const double* coordinates, annulus_sign* signs) {
    return signs_of<2, 4>(count, coordinates, signs, [](auto x, auto out) { in_circle(x, out); });
}
int annulus_in_sphere(size_t count, const double* coordinates, annulus_sign* signs) {
    return signs_of<3, 5>(count, coordinates, signs, [](auto x, auto out) { in_sphere(x, out); });
}

int annulus_audit_cells(int dimension, size_t points, const double* coordinates, size_t cells, const int32_t* vertices,
                        annulus_audit_result* result, size_t capacity, annulus_fault* faults, size_t* count) {
    return guarded(error_of_thread(), [&] {
        require(result, "result");
        require_struct(result->size, sizeof(result->size), "annulus_audit_result");
        if (dimension != 2 && dimension != 3)
            throw Refused(ANNULUS_USAGE, "dimension is " + std::to_string(dimension) + ", not 2 or 3");
        require_count(points, "points");
        require_count(cells, "cells");
        require(coordinates, points, "coordinates");
        require(vertices, cells, "vertices");
        require(faults, capacity, "faults");
        require(count, capacity, "count");
        const Audit_result verdict = dimension == 2 ? audit_of<2>(coordinates, points, vertices, cells, capacity)
                                                    : audit_of<3>(coordinates, points, vertices, cells, capacity);
        write_audit(result, verdict);
        if (count != nullptr) *count = verdict.faults.size();
        std::transform(verdict.faults.begin(), verdict.faults.end(), faults, fault_of);
    });
}
