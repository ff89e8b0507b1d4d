// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace annulus::inline v1 {

/// What the terms of a page on degeneracy mean.
struct Degeneracy_terms {
    bool plane = true;      ///< the page has points in 2D
    bool space = false;     ///< and in 3D
    bool periodic = false;  ///< in a periodic box: without a hull, and without the paper's tolerances
};

/// A heading and a paragraph, HTML, for the end of the page. Precondition: `plane` or `space`.
void append_terms(std::string& out, const Degeneracy_terms& of);

}  // namespace annulus::inline v1
