// SPDX-License-Identifier: GPL-3.0-or-later
// Draws plots with the library's svg_plot, each as a self-contained SVG file.
//
// usage: example-plots [PLOTS.json DIRECTORY]
//
// PLOTS.json is a list of {"file", "title", "x": {"label", "log", "lower", "upper"}, "y": likewise, "series":
// [{"name", "x", "y", "steps", "error"}]}; everything but labels and numbers may be absent. Without arguments, a plot
// of square roots is written to roots.svg.
#include <apps/report/report_style.h>
#include <apps/report/svg_plot.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

using Json = nlohmann::json;

annulus::Axis axis_of(const Json& json) {
    annulus::Axis axis{json.at("label"), json.value("log", false) ? annulus::Scale::log10 : annulus::Scale::linear};
    if (json.contains("lower")) axis.lower = json["lower"].get<double>();
    if (json.contains("upper")) axis.upper = json["upper"].get<double>();
    return axis;
}

annulus::Plot plot_of(const Json& json) {
    annulus::Plot plot{json.at("title"), axis_of(json.at("x")), axis_of(json.at("y")), {}};
    for (const Json& s : json.at("series"))
        plot.series.push_back({s.at("name"), s.at("x").get<std::vector<double>>(), s.at("y").get<std::vector<double>>(),
                               s.value("steps", false), s.value("error", std::vector<double>{})});
    return plot;
}

/// Adds the style and the background, which a page has once for all its plots.
std::string standing_alone(const std::string& svg) {
    const std::size_t end = svg.find('>') + 1;
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"780\" height=\"540\"" + svg.substr(4, end - 4) +
           "<style>" + annulus::report_style +
           "svg{font-family:system-ui,-apple-system,\"Segoe UI\",Roboto,Arial,sans-serif}</style><rect width=\"520\" "
           "height=\"360\" "
           "style=\"fill:var(--bg)\"/>" +
           svg.substr(end) + "\n";
}

void write(const std::filesystem::path& path, const Json& json) {
    std::ofstream file(path, std::ios::binary);
    file << standing_alone(annulus::svg_plot(plot_of(json)));
    if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc == 1) {
        Json plot{{"title", "Square roots"},
                  {"x", {{"label", "x"}, {"log", true}}},
                  {"y", {{"label", "square root of x"}, {"log", true}}}};
        Json& curve = plot["series"][0] = {{"name", "√x"}};
        for (double x = 1; x <= 1000; x *= 10) {
            curve["x"].push_back(x);
            curve["y"].push_back(std::sqrt(x));
        }
        write("roots.svg", plot);
        return 0;
    }
    if (argc != 3) return std::fprintf(stderr, "usage: example-plots [PLOTS.json DIRECTORY]\n"), 2;
    std::ifstream file(argv[1]);
    for (const Json& plot : Json::parse(file))
        write(std::filesystem::path(argv[2]) / plot.at("file").get<std::string>(), plot);
} catch (const std::exception& e) {
    return std::fprintf(stderr, "example-plots: %s\n", e.what()), 3;
}
