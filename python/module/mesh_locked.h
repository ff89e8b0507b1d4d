// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <module/finalizing.h>
#include <module/mesh.h>

#include <mutex>
#include <utility>

namespace annulus::python {

/// Makes a call with the lock and without the GIL. The GIL is released first, so that a thread that waits for the lock
/// does not keep other threads from running Python.
template <int d>
template <class Call>
auto Mesh<d>::locked(Call call) const {
    const Without_gil without_gil;
    return locked(without_gil, std::move(call));
}

template <int d>
template <class Call>
auto Mesh<d>::locked(const Without_gil&, Call call) const {
    const std::lock_guard hold(lock_);
    return call();
}

template <int d>
template <class Read>
auto Mesh<d>::read(Read read) const {
    return locked([&] { return read(mesh_); });
}

template <int d>
template <class Read>
auto Mesh<d>::read(const Without_gil& without_gil, Read read) const {
    return locked(without_gil, [&] { return read(mesh_); });
}

}  // namespace annulus::python
