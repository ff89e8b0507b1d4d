// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/reproduction/reproduction.h>

#include <string>
#include <vector>

namespace annulus::inline v1 {

/// The verdict on a claim. `further`: more than the paper claims; `open`: what was measured meets it in part, or it was
/// not run, or not far enough. The rules are in claim_rules.h.
enum class Claim_verdict { agrees, further, differs, wrong, open };
[[nodiscard]] std::string name_of(Claim_verdict verdict);

/// One of the paper's results compared with ours. Texts are plain.
struct Claim {
    std::string figure;                           ///< the page of its subject: "figure-7", "unsound"
    std::string statement;                        ///< in our words
    std::string paper;                            ///< its number
    std::string theirs;                           ///< ours, under the paper's algorithms (published/)
    std::string ours;                             ///< ours, under our strategies and tolerances
    Claim_verdict verdict = Claim_verdict::open;  ///< of `theirs`
    std::string reason;                           ///< of a difference, or a remark
    bool of_long_runs = false;                    ///< whether it does not apply to fewer than 1,000 iterations
};

/// All claims, in the paper's order, whatever was run. A verdict follows from numbers by claim_rules.h; only verdicts
/// on speed depend on a clock.
[[nodiscard]] std::vector<Claim> claims_of(const Reproduction& reproduction);

/// Its parts, which append claims: soundness of tolerances, the cost of relocation, stability of tolerances; Lloyd;
/// meshes: speed, statistics and quality.
void append_soundness_claims(const Reproduction& reproduction, std::vector<Claim>& out);
void append_relocation_claims(const Reproduction& reproduction, std::vector<Claim>& out);
void append_stability_claims(const Reproduction& reproduction, std::vector<Claim>& out);
void append_lloyd_claims(const Reproduction& reproduction, std::vector<Claim>& out);
void append_mesh_speed_claims(const Reproduction& reproduction, std::vector<Claim>& out);
void append_mesh_claims(const Reproduction& reproduction, std::vector<Claim>& out);
void append_quality_claims(const Reproduction& reproduction, std::vector<Claim>& out);

}  // namespace annulus::inline v1
