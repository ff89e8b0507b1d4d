// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/claim_words.h>

namespace annulus::inline v1 {

std::string name_of(Claim_verdict verdict) {
    switch (verdict) {
        case Claim_verdict::agrees: return "agrees";
        case Claim_verdict::further: return "goes further";
        case Claim_verdict::differs: return "differs";
        case Claim_verdict::wrong: return "is wrong";
        case Claim_verdict::open: return "open";
    }
    return "";
}

std::vector<Claim> claims_of(const Reproduction& reproduction) {
    std::vector<Claim> out;
    append_soundness_claims(reproduction, out);
    append_relocation_claims(reproduction, out);
    append_stability_claims(reproduction, out);
    append_lloyd_claims(reproduction, out);
    append_mesh_speed_claims(reproduction, out);
    append_mesh_claims(reproduction, out);
    append_quality_claims(reproduction, out);
    // Movers are random points with their own pace, for some steps; the paper's claims for 1,000 iterations do not
    // concern them.
    const bool brief =
        std::any_of(reproduction.benchmarks.begin(), reproduction.benchmarks.end(),
                    [](const auto& entry) { return !entry.first.starts_with("movers-") && entry.second.steps < 1000; });
    for (Claim& c : out) {
        if (c.theirs.empty() && c.reason.empty()) c.reason = "Not run.";
        if (!brief || !c.of_long_runs || c.theirs.empty()) continue;
        c.verdict = Claim_verdict::open;
        c.reason = "The paper says it of 1,000 iterations.";
    }
    return out;
}

}  // namespace annulus::inline v1
