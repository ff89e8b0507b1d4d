// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/annulus.h>
#include <annulus/c/structs.h>
#include <annulus/periodic_mesh.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <mutex>
#include <optional>
#include <string>
#include <variant>

namespace annulus::inline v1::c {

/// A Periodic_mesh and its lists, which are made on request and kept until it changes. Const members may run
/// concurrently.
template <int d>
class Boxed {
  public:
    static constexpr int dimension = d;

    Boxed(std::span<const Coordinates<d>> points, const Box<d>& box, const Periodic_options& options)
        : mesh_(points, box, options) {}

    [[nodiscard]] const Periodic_mesh<d>& mesh() const { return mesh_; }
    /// For a call that may change the mesh.
    [[nodiscard]] Periodic_mesh<d>& changing() {
        cells_.reset();
        neighbours_.reset();
        voronoi_.reset();
        return mesh_;
    }
    [[nodiscard]] const Periodic_cells<d>& cells() const {
        const std::lock_guard lock(listing_);
        if (!cells_) cells_ = mesh_.cells();
        return *cells_;
    }
    [[nodiscard]] const Periodic_neighbours<d>& neighbours() const {
        const std::lock_guard lock(listing_);
        if (!neighbours_) neighbours_ = mesh_.neighbours();
        return *neighbours_;
    }
    [[nodiscard]] const Periodic_voronoi_diagram<d>& voronoi() const {
        const std::lock_guard lock(listing_);
        if (!voronoi_) voronoi_ = mesh_.voronoi();
        return *voronoi_;
    }

  private:
    Periodic_mesh<d> mesh_;
    mutable std::mutex listing_;
    mutable std::optional<Periodic_cells<d>> cells_;
    mutable std::optional<Periodic_neighbours<d>> neighbours_;
    mutable std::optional<Periodic_voronoi_diagram<d>> voronoi_;
};

}  // namespace annulus::inline v1::c

/// The handle.
struct annulus_periodic {
    std::variant<std::monostate, annulus::c::Boxed<2>, annulus::c::Boxed<3>> mesh;
    mutable annulus::c::Last_error error;
};

namespace annulus::inline v1::c {

/// Calls `call` with the Boxed of the handle.
template <class Mesh, class Call>
int on(Mesh* mesh, Call call) noexcept {
    return guarded(mesh, [&](Mesh& m) {
        std::visit(
            [&](auto& boxed) {
                if constexpr (requires { boxed.mesh(); }) call(boxed);
            },
            m.mesh);
    });
}

inline void require_room(std::size_t capacity, std::size_t needed, const char* of) {
    if (capacity < needed)
        throw Refused(ANNULUS_WRONG_SIZE,
                      "there is room for " + std::to_string(capacity) + " of " + std::to_string(needed) + ' ' + of);
}
/// Of a list: the count, which is needed if any array is there.
inline void count_list(std::size_t capacity, std::initializer_list<const void*> arrays, std::size_t needed,
                       const char* of, std::size_t* count) {
    *count = needed;
    const bool any = std::any_of(arrays.begin(), arrays.end(), [](const void* array) { return array != nullptr; });
    if (any || capacity > 0) require_room(capacity, needed, of);
    if (!any && capacity > 0) throw Refused(ANNULUS_NULL_POINTER, "every array is NULL");
}

/// Copies numbers, or arrays of arrays of them, one after another.
template <class From, class To>
void flatten(const From& from, To*& to) {
    if constexpr (requires { from.begin(); })
        for (const auto& part : from) flatten(part, to);
    else *to++ = from;
}
template <class From, class To>
void copy_flat(const From& from, To* to) {
    if (to != nullptr) flatten(from, to);
}

}  // namespace annulus::inline v1::c
