// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace annulus::inline v1 {

/// A word of a page, and what it means there: plain text.
struct Term {
    std::string name;
    std::string meaning;
};
using Terms = std::vector<Term>;

/// A heading, the terms as a list, and where more is said, HTML: the end of a page.
void append_terms(std::string& out, const Terms& terms);

}  // namespace annulus::inline v1
