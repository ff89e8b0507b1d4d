// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/axis_ticks.h>
#include <apps/reproduction/claim_findings.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// How the claim begins that a page is about, where it is not the first of the page that was run.
constexpr std::pair<std::string_view, std::string_view> subjects[] = {
    {"figure-7", "Filtering Lloyd iterations is up to"},
    {"figure-10", "Widths and tolerances converge"},
    {"figure-11", "Share of moves that fail at the 1,000th"},
    {"figure-12", "The filter outperforms rebuilding"}};

/// The first parts of a text whose parts are separated by "; ": all that fit into a sentence, and one at least.
std::string first_parts(const std::string& text) {
    constexpr std::size_t sentence = 260;
    if (text.size() <= sentence) return text;
    const std::size_t cut = text.rfind("; ", sentence);
    return text.substr(0, cut == std::string::npos ? text.find("; ") : cut);
}

const char* conclusion(Claim_verdict verdict) {
    switch (verdict) {
        case Claim_verdict::agrees: return "The claim agrees with that.";
        case Claim_verdict::further: return "The claim falls short of that.";
        case Claim_verdict::differs: return "The claim differs from that.";
        case Claim_verdict::wrong: return "The claim is wrong.";
        case Claim_verdict::open: return "The claim stays open.";
    }
    return "";
}

}  // namespace

std::string counts_of_verdicts(const std::vector<Claim>& claims, const std::string& where) {
    std::string text;
    for (const auto& [verdict, words] : {std::pair{Claim_verdict::agrees, " agreed with what was measured here"},
                                         {Claim_verdict::further, " fell short of it"},
                                         {Claim_verdict::differs, " differed from it"},
                                         {Claim_verdict::wrong, " proved to be wrong"},
                                         {Claim_verdict::open, " stayed open"}}) {
        const auto count = std::count_if(claims.begin(), claims.end(),
                                         [verdict = verdict](const Claim& c) { return c.verdict == verdict; });
        if (count > 0) text += (text.empty() ? "" : ", ") + grouped(static_cast<std::uint64_t>(count)) + words;
    }
    return "Of " + grouped(claims.size()) + " claims of the paper" + where + " " + text + ".";
}

std::vector<std::string> findings_of_page(const std::string& page, const std::vector<Claim>& claims) {
    std::vector<Claim> here;
    std::copy_if(claims.begin(), claims.end(), std::back_inserter(here),
                 [&](const Claim& c) { return c.figure == page; });
    const auto was_run = [](const Claim& c) { return !c.theirs.empty(); };
    auto main = std::find_if(here.begin(), here.end(), [&](const Claim& c) {
        return was_run(c) && std::any_of(std::begin(subjects), std::end(subjects), [&](const auto& subject) {
                   return subject.first == page && c.statement.starts_with(subject.second);
               });
    });
    if (main == here.end()) main = std::find_if(here.begin(), here.end(), was_run);
    if (main == here.end()) return {};
    std::vector<std::string> out{"The paper: " + main->statement.substr(0, main->statement.size() - 1) + " (" +
                                 main->paper + "). Here: " + first_parts(main->theirs) + ". " +
                                 conclusion(main->verdict)};
    if (here.size() > 1) out.push_back(counts_of_verdicts(here, " on this page"));
    return out;
}

}  // namespace annulus::inline v1
