// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace annulus_test {

/// Value of the first attribute of this name; empty when there is none.
inline std::string attribute(const std::string& xml, const std::string& name) {
    const std::size_t at = xml.find(" " + name + "=\"");
    if (at == std::string::npos) return {};
    const std::size_t begin = at + name.size() + 3;
    return xml.substr(begin, xml.find('"', begin) - begin);
}

/// Text of the first element whose start tag contains `mark`.
inline std::string element_content(const std::string& xml, const std::string& mark) {
    const std::size_t at = xml.find(mark);
    if (at == std::string::npos) return {};
    const std::size_t begin = xml.find('>', at) + 1;
    return xml.substr(begin, xml.find('<', begin) - begin);
}

/// True when tags nest, attributes are quoted, and & begins one of the entities we write. HTML's doctype and the
/// elements without an end that we use (meta) are accepted, and so is the style element.
inline bool well_formed(std::string_view text) {
    std::vector<std::string> open;
    const auto entities_good = [](std::string_view piece) {
        for (std::size_t i = piece.find('&'); i != std::string_view::npos; i = piece.find('&', i + 1)) {
            const std::string_view rest = piece.substr(i);
            const auto is = [&](std::string_view e) { return rest.starts_with(e); };
            if (!is("&amp;") && !is("&lt;") && !is("&gt;") && !is("&quot;") && !is("&#39;")) return false;
        }
        return true;
    };
    while (!text.empty()) {
        const std::size_t tag = text.find('<');
        if (!entities_good(text.substr(0, tag))) return false;
        if (tag == std::string_view::npos) break;
        text.remove_prefix(tag + 1);
        const std::size_t end = text.find('>');
        if (end == std::string_view::npos) return false;
        std::string_view inside = text.substr(0, end);
        text.remove_prefix(end + 1);
        if (inside.starts_with("?xml") || inside == "!DOCTYPE html") continue;
        if (inside.find('<') != std::string_view::npos || !entities_good(inside)) return false;
        if (inside.starts_with("/")) {
            if (open.empty() || open.back() != inside.substr(1)) return false;
            open.pop_back();
            continue;
        }
        const std::string name(inside.substr(0, inside.find(' ')));
        if (name.empty() || std::count(inside.begin(), inside.end(), '"') % 2 != 0) return false;
        if (name == "style") {
            const std::size_t close = text.find("</style>");
            if (close == std::string_view::npos) return false;
            text.remove_prefix(close + 8);
            continue;
        }
        if (!inside.ends_with("/") && name != "meta") open.push_back(name);
    }
    return open.empty();
}

}  // namespace annulus_test
