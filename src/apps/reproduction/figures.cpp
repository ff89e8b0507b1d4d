// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/figures.h>

#include <apps/report/axis_ticks.h>
#include <apps/report/page.h>

#include <algorithm>
#include <map>

namespace annulus::inline v1 {

std::vector<Page_content> reproduction_pages(const Reproduction& reproduction) {
    std::vector<Page_content> out;
    append_plane_pages(reproduction, out);
    append_mesh_pages(reproduction, out);
    append_cost_pages(reproduction, out);
    out.push_back(unsound_page(reproduction));
    return out;
}

std::string caption_of(const Picture_record& picture) {
    const std::size_t cut = picture.caption.find(", ");
    return (picture.step == 0 ? "at the start"
                              : "after " + grouped(picture.step) + (picture.step == 1 ? " iteration" : " iterations")) +
           (cut == std::string::npos ? "" : picture.caption.substr(cut));
}

void append_plot(Page_content& page, std::vector<Panel>& panels, const Plot& plot, const std::string& csv,
                 std::string caption) {
    if (plot.series.empty()) return;
    std::map<double, std::vector<Csv_cell>> rows;
    Csv_table table{{plot.x.label}, {}};
    for (std::size_t s = 0; s < plot.series.size(); ++s) {
        const Series& series = plot.series[s];
        table.header.push_back(series.name.empty() ? plot.y.label : series.name);
        for (std::size_t i = 0; i < series.y.size(); ++i) {
            auto& row = rows[series.x[i]];
            row.resize(plot.series.size());
            row[s] = series.y[i];
        }
    }
    for (auto& [x, row] : rows) {
        std::vector<Csv_cell> cells{x};
        cells.insert(cells.end(), row.begin(), row.end());
        table.rows.push_back(std::move(cells));
    }
    panels.push_back({plot.title, plot_html(plot), std::move(caption), {csv}});
    page.tables.emplace_back(csv, std::move(table));
}

Plot convergence_plot(const Benchmark_record& benchmark) {
    Plot plot{benchmark.title,
              {"iteration", Scale::log10, {}, {}, true},
              {"mean (mean spacings)", Scale::log10, {}, {}, false},
              {}};
    const auto add = [&](const char* name, double Certificate_survey_record::*value) {
        Series s{name, {}, {}};
        for (const Certificate_survey_record& r : benchmark.surveys) {
            if (r.step > benchmark.steps) continue;
            s.x.push_back(static_cast<double>(r.step));
            s.y.push_back(r.*value);
        }
        if (!s.x.empty()) plot.series.push_back(std::move(s));
    };
    add("displacement", &Certificate_survey_record::displacement);
    add("annulus width", &Certificate_survey_record::width);
    add("tolerance", &Certificate_survey_record::paper_tolerance);
    if (benchmark.dimension == 3) add("certified", &Certificate_survey_record::certified_tolerance);
    return plot;
}

Plot width_plot(const Benchmark_record& benchmark) {
    Plot plot{"Distribution of the widths",
              {"standard annulus width (mean spacings)", Scale::linear, 0., {}, true},
              {"bi-cells in a bin (%)", Scale::linear, 0., {}, false},
              {}};
    double highest = 0;
    for (const Width_record& w : benchmark.widths) {
        Series s{"iteration " + grouped(w.step), w.edges, {}, true};
        for (const std::uint64_t n : w.counts)
            s.y.push_back(w.total > 0 ? 100 * static_cast<double>(n) / static_cast<double>(w.total) : 0);
        for (const double y : s.y) highest = std::max(highest, y);
        plot.series.push_back(std::move(s));
    }
    if (highest > 0) plot.y.upper = 1.5 * highest;  // names are above the peaks
    return plot;
}

}  // namespace annulus::inline v1
