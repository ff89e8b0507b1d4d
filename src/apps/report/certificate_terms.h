// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/terms.h>

#include <string>

namespace annulus::inline v1 {

/// Of which points the terms of a page speak.
struct Certificate_terms {
    bool plane = true;   ///< the page has points in 2D
    bool space = false;  ///< and in 3D
    bool open = true;    ///< with open boundaries: with a hull, and the paper's tolerances
    bool boxes = false;  ///< and in periodic boxes
};

/// What bi-cells, certificates, annuli, slabs and tolerances are; the tolerance last. Precondition: `plane` or `space`.
[[nodiscard]] Terms certificate_terms(const Certificate_terms& of);

/// A heading and a list, HTML, for the end of a page on degeneracy. The same precondition.
void append_degeneracy_terms(std::string& out, const Certificate_terms& of);

}  // namespace annulus::inline v1
