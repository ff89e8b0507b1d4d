// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/reproduction/claims.h>

#include <string>
#include <vector>

namespace annulus::inline v1 {

/// How many claims have which verdict: "Of 4 claims of the paper 3 agreed with what was measured here, 1 stayed open.";
/// `where` follows "paper": " on this page".
[[nodiscard]] std::string counts_of_verdicts(const std::vector<Claim>& claims, const std::string& where = "");

/// What the head of a page says: the claim that the page is about, beside what was measured, and its verdict; then, if
/// there are more, how many claims of the page have which verdict. Nothing where none of them was run.
[[nodiscard]] std::vector<std::string> findings_of_page(const std::string& page, const std::vector<Claim>& claims);

}  // namespace annulus::inline v1
