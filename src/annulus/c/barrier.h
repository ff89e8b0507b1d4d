// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/annulus.h>
#include <annulus/c/any_mesh.h>
#include <annulus/c/changes_of_call.h>

#include <array>
#include <cfenv>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace annulus::inline v1::c {

/// Thrown for a call that this interface refuses, before anything has changed.
class Refused : public std::runtime_error {
  public:
    Refused(annulus_status status, const std::string& why) : std::runtime_error(why), status_(status) {}
    [[nodiscard]] annulus_status status() const noexcept { return status_; }

  private:
    annulus_status status_;
};

/// The last error of a mesh or a thread. Allocates for three vertices and more only, and keeps two where memory has run
/// out.
class Last_error {
  public:
    /// Records an error and returns its status.
    int note(annulus_status status, const char* why, std::span<const std::int64_t> vertices = {}) noexcept;
    /// As annulus_message.
    std::size_t copy(char* buffer, std::size_t capacity) const noexcept;
    /// As annulus_error_vertices.
    std::size_t copy_vertices(std::size_t capacity, std::int32_t* vertices) const noexcept;

  private:
    mutable std::mutex writing_;  // functions that only read a mesh may run concurrently, and can fail, too
    std::array<char, 512> text_{};
    std::array<std::int32_t, 2> first_{};
    std::size_t vertex_count_ = 0;
    std::vector<std::int32_t> more_;  // all of them, if they are more than two
};

/// The last error of the calling thread, for calls that have no mesh.
Last_error& error_of_thread() noexcept;

/// While an object of this class exists, no floating-point exception traps in this thread. Its destructor restores
/// flags and traps. The rounding mode is not changed.
class Quiet_arithmetic {
  public:
    Quiet_arithmetic() noexcept { std::feholdexcept(&before_); }
    ~Quiet_arithmetic() { std::fesetenv(&before_); }
    Quiet_arithmetic(const Quiet_arithmetic&) = delete;
    Quiet_arithmetic& operator=(const Quiet_arithmetic&) = delete;

  private:
    std::fenv_t before_;
};

/// Records the exception that is being handled and returns its status. Precondition: called in a catch handler.
int note_exception(Last_error& error) noexcept;

/// Runs `call`, and turns every exception into a status.
template <class Call>
int guarded(Last_error& error, const Call& call) noexcept {
    const Quiet_arithmetic quiet;
    try {
        call();
        return ANNULUS_OK;
    } catch (...) {
        return note_exception(error);
    }
}

inline void require(const void* pointer, const char* name) {
    if (pointer == nullptr) throw Refused(ANNULUS_NULL_POINTER, std::string(name) + " is NULL");
}
/// An array may be NULL if its count is 0.
inline void require(const void* array, std::size_t count, const char* name) {
    if (count > 0) require(array, name);
}
/// Throws Refused for a count of points, vertices or cells that cannot fit in memory, so that products of sizes do not
/// overflow.
void require_count(std::size_t count, const char* of);

}  // namespace annulus::inline v1::c

/// The handle.
struct annulus_mesh {
    std::unique_ptr<annulus::c::Any_mesh> mesh;
    annulus::c::Changes_of_call changes;
    mutable annulus::c::Last_error error;
};

namespace annulus::inline v1::c {

/// The same for a call on a mesh; refuses a NULL mesh.
template <class Mesh, class Call>
int guarded(Mesh* mesh, const Call& call) noexcept {
    if (mesh == nullptr) return error_of_thread().note(ANNULUS_NULL_POINTER, "mesh is NULL");
    return guarded(mesh->error, [&] { call(*mesh); });
}

}  // namespace annulus::inline v1::c
