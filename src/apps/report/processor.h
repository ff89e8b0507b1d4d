// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>

namespace annulus::inline v1 {

/// The processor's name for display: from /proc/cpuinfo (Linux), else the architecture, else "unknown processor".
[[nodiscard]] std::string processor_name();

/// The same from the text of a /proc/cpuinfo and the name of the architecture, as `uname -m` prints it; either may be
/// empty. Where the text has no name of the processor but numbers of its maker and design, as on arm64, the result
/// consists of these.
[[nodiscard]] std::string processor_name(std::istream& cpuinfo, const std::string& architecture);

}  // namespace annulus::inline v1
