// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/terms.h>

#include <apps/formats/markup.h>

namespace annulus::inline v1 {

void append_terms(std::string& out, const Terms& terms) {
    out += "<h2>Terms</h2>\n<dl class=\"terms\">";
    for (const Term& term : terms) out += "<dt>" + escaped(term.name) + "</dt><dd>" + escaped(term.meaning) + "</dd>\n";
    out += "</dl>\n<p>More in docs/glossary.md and docs/theory.md.</p>\n";
}

}  // namespace annulus::inline v1
