// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/hard_inputs.h>
#include <apps/formats/formatted.h>

#include <annulus/error.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <string>

namespace annulus::inline v1 {

namespace {

constexpr std::array names{Certificate_name::orientation_2, Certificate_name::empty_circle_2,
                           Certificate_name::orientation_3, Certificate_name::empty_sphere_3};
constexpr std::array stages{Stage::filter, Stage::interval, Stage::exact};

std::size_t dimension_of(Certificate_name name) {
    return name == Certificate_name::orientation_2 || name == Certificate_name::empty_circle_2 ? 2 : 3;
}

std::vector<double> in_order(const std::vector<double>& coordinates, std::size_t d) {
    std::vector<std::array<double, 3>> points(coordinates.size() / d);
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t k = 0; k < d; ++k) points[i][k] = coordinates[d * i + k];
    std::sort(points.begin(), points.end());
    std::vector<double> sorted;
    for (const auto& p : points) sorted.insert(sorted.end(), p.begin(), p.begin() + static_cast<std::ptrdiff_t>(d));
    return sorted;
}

std::string hexadecimal(double x) { return formatted("%a", x); }
double number(const nlohmann::ordered_json& json) {
    const std::string text = json.get<std::string>();
    char* end = nullptr;
    const double x = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0') throw Error(Error_code::bad_input, "'" + text + "' is no hexadecimal number");
    return x;
}

template <class T, std::size_t n>
T named(const std::array<T, n>& all, const std::string& word) {
    for (const T one : all)
        if (name_of(one) == word) return one;
    throw Error(Error_code::bad_input, "'" + word + "' is no certificate and no stage");
}

}  // namespace

std::string_view name_of(Certificate_name name) {
    switch (name) {
        case Certificate_name::orientation_2: return "orientation_2";
        case Certificate_name::empty_circle_2: return "empty_circle_2";
        case Certificate_name::orientation_3: return "orientation_3";
        case Certificate_name::empty_sphere_3: return "empty_sphere_3";
    }
    return "";
}

bool Hard_inputs::add(Certificate_name name, Stage stage, Hard_input input) {
    Class& c = class_[at(name, stage)];
    if (!may_keep(name, stage, input.key)) return false;
    std::vector<double> points = in_order(input.coordinates, dimension_of(name));
    const auto same = c.by_points.find(points);
    if (same != c.by_points.end()) {
        if (!(input < *same->second)) return false;
        c.hardest.erase(same->second);
        same->second = c.hardest.insert(std::move(input)).first;
        return true;
    }
    if (c.hardest.size() == most_) {
        const auto last = std::prev(c.hardest.end());
        if (!(input < *last)) return false;
        c.by_points.erase(in_order(last->coordinates, dimension_of(name)));
        c.hardest.erase(last);
    }
    c.by_points.emplace(std::move(points), c.hardest.insert(std::move(input)).first);
    return true;
}

Hard_inputs Hard_inputs::merge(const Hard_inputs& other) {
    Hard_inputs kept(most_);
    for (const Certificate_name name : names)
        for (const Stage stage : stages)
            for (const Hard_input& input : other.of(name, stage).hardest)
                if (add(name, stage, input)) kept.add(name, stage, input);
    return kept;
}

bool Hard_inputs::empty() const {
    return std::all_of(class_.begin(), class_.end(), [](const Class& c) { return c.hardest.empty(); });
}

std::vector<nlohmann::ordered_json> Hard_inputs::json() const {
    std::vector<nlohmann::ordered_json> all;
    for (const Certificate_name name : names)
        for (const Stage stage : stages)
            for (const Hard_input& input : of(name, stage).hardest) {
                nlohmann::ordered_json points = nlohmann::ordered_json::array();
                const std::size_t d = dimension_of(name);
                for (std::size_t i = 0; i < input.coordinates.size(); i += d) {
                    nlohmann::ordered_json& p = points.emplace_back(nlohmann::ordered_json::array());
                    for (std::size_t k = 0; k < d; ++k) p.push_back(hexadecimal(input.coordinates[i + k]));
                }
                all.push_back({{"certificate", name_of(name)},
                               {"stage", name_of(stage)},
                               {"key", hexadecimal(input.key)},
                               {"tolerance", hexadecimal(input.tolerance)},
                               {"seed", input.seed},
                               {"points", std::move(points)}});
            }
    return all;
}

void Hard_inputs::add(const nlohmann::ordered_json& json) {
    Hard_input input{number(json.at("key")), {}, number(json.at("tolerance")), json.at("seed").get<std::uint64_t>()};
    for (const auto& point : json.at("points"))
        for (const auto& x : point) input.coordinates.push_back(number(x));
    add(named(names, json.at("certificate").get<std::string>()), named(stages, json.at("stage").get<std::string>()),
        std::move(input));
}

}  // namespace annulus::inline v1
