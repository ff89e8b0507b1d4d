// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

#include <iosfwd>
#include <string>

namespace annulus {

/// What the processor is called, for people: what the system says in /proc/cpuinfo (Linux), else the architecture,
/// else "unknown processor".
[[nodiscard]] std::string processor_name();

/// The same from the text of a /proc/cpuinfo and the name of the architecture, as `uname -m` prints it; either may be
/// empty. Where the text has no name of the processor but numbers of its maker and design, as on arm64, these are
/// given.
[[nodiscard]] std::string processor_name(std::istream& cpuinfo, const std::string& architecture);

}  // namespace annulus
