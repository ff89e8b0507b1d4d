// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/reproduction/reproduction.h>

#include <string>
#include <vector>

namespace annulus {

/// What came of a claim. `further`: more than the paper says; `open`: it was not run, or too little of it.
enum class Claim_verdict { agrees, further, differs, wrong, open };
[[nodiscard]] std::string name_of(Claim_verdict verdict);

/// One of the paper's results beside ours. Texts are plain.
struct Claim {
    std::string figure;     ///< the page with what it is about: "figure-7", "unsound"
    std::string statement;  ///< in our words
    std::string paper;      ///< its number
    std::string theirs;     ///< ours, under the paper's algorithm as printed (Published_algorithm)
    std::string ours;       ///< ours, under our strategies and tolerances
    Claim_verdict verdict = Claim_verdict::open;  ///< of `theirs`
    std::string reason;                           ///< for a difference, or what to know
    bool of_long_runs = false;                    ///< it says nothing of fewer than 1,000 iterations
};

/// All of them, in the paper's order, whatever was run. A verdict follows from numbers by the rule that stands beside
/// it in the code; none depends on a clock but those of speed.
[[nodiscard]] std::vector<Claim> claims_of(const Reproduction& reproduction);

/// Its parts, appended: whether tolerances are right, what relocating costs, how stable tolerances are; Lloyd;
/// meshes, how fast, their statistics, and what becomes of them.
void append_soundness_claims(const Reproduction& reproduction, std::vector<Claim>& out);
void append_relocation_claims(const Reproduction& reproduction, std::vector<Claim>& out);
void append_stability_claims(const Reproduction& reproduction, std::vector<Claim>& out);
void append_lloyd_claims(const Reproduction& reproduction, std::vector<Claim>& out);
void append_mesh_speed_claims(const Reproduction& reproduction, std::vector<Claim>& out);
void append_mesh_claims(const Reproduction& reproduction, std::vector<Claim>& out);
void append_quality_claims(const Reproduction& reproduction, std::vector<Claim>& out);

}  // namespace annulus
