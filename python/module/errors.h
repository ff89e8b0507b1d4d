// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/error.h>

#include <pybind11/pybind11.h>

#include <string_view>

namespace annulus::python {

/// What `Error.code` is in Python: the name in error.h.
[[nodiscard]] std::string_view name_of(Error_code code);

/// From now on an annulus::Error that leaves the module is an annulus.Error; bad_alloc is a MemoryError by itself.
void translate_errors();

/// For long work, between two parts of it, without the GIL: what a signal's handler throws, KeyboardInterrupt above
/// all, is thrown here.
void look_for_signals();

}  // namespace annulus::python
