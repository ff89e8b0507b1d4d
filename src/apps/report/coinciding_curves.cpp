// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/coinciding_curves.h>

#include <apps/report/axis_ticks.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

namespace {

/// Of the height of a plot, some 290 units: two lines, which are 2 thick, nearly touch.
constexpr double line_share = 0.0125;

bool coincide(const Series& a, const Series& b, const Axis_range& ys) {
    if (a.x != b.x || a.y.size() != b.y.size()) return false;
    for (std::size_t i = 0; i < a.y.size(); ++i) {
        if (ys.can_show(a.y[i]) != ys.can_show(b.y[i])) return false;
        if (ys.can_show(a.y[i]) && std::fabs(ys.place(a.y[i]) - ys.place(b.y[i])) > line_share) return false;
    }
    return true;
}

/// "a, b and c", of each group, separated by semicolons; names in quotes if one has a comma.
std::string names_of(const Plot& plot, const std::vector<std::vector<std::size_t>>& groups) {
    const std::string quote = std::any_of(plot.series.begin(), plot.series.end(),
                                          [](const Series& s) { return s.name.find(',') != std::string::npos; })
                                  ? "\""
                                  : "";
    std::string text;
    for (const auto& group : groups) {
        if (!text.empty()) text += "; of ";
        for (std::size_t k = 0; k < group.size(); ++k)
            text += (k == 0 ? "" : k + 1 == group.size() ? " and " : ", ") + quote + plot.series[group[k]].name + quote;
    }
    return text;
}

}  // namespace

std::vector<std::vector<std::size_t>> coinciding_curves(const Plot& plot) {
    std::vector<double> all;
    for (const Series& s : plot.series) all.insert(all.end(), s.y.begin(), s.y.end());
    const Axis_range ys(plot.y, all);
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const std::vector<double>& y = plot.series[i].y;
        if (std::none_of(y.begin(), y.end(), [&](double value) { return ys.can_show(value); })) continue;
        const auto like = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
            return coincide(plot.series[group.front()], plot.series[i], ys);
        });
        if (like == groups.end()) groups.push_back({i});
        else like->push_back(i);
    }
    std::erase_if(groups, [](const auto& group) { return group.size() < 2; });
    return groups;
}

std::string on_coinciding_curves(const Plot& plot) {
    const std::string names = names_of(plot, coinciding_curves(plot));
    return names.empty() ? "" : "The curves of " + names + " lie upon one another.";
}

}  // namespace annulus::inline v1
