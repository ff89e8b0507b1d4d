// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <vector>

namespace annulus::inline v1 {

/// The kind of certificate, by its determinant.
enum class Certificate_name : std::uint8_t { orientation_2, empty_circle_2, orientation_3, empty_sphere_3 };
[[nodiscard]] std::string_view name_of(Certificate_name name);

/// A certificate's points in the order in which it was evaluated, and how hard it was.
struct Hard_input {
    /// Smaller is harder. Decided by the filter: determinant over error bound. Decided by intervals or integers: width
    /// over the largest difference of coordinates. Neither depends on the unit of length.
    double key = 0;
    std::vector<double> coordinates{};  ///< of point after point
    double tolerance = 0;               ///< half the width, certified lower bound, in the unit of the coordinates
    std::uint64_t seed = 0;             ///< of the experiment that found it

    /// Harder inputs first; a total order of keys, coordinates and seeds.
    friend bool operator<(const Hard_input& l, const Hard_input& r) {
        return std::tie(l.key, l.coordinates, l.seed) < std::tie(r.key, r.coordinates, r.seed);
    }
};

/// The hardest inputs found, for each certificate and each stage that decided; no two have the same set of points.
/// Exactly degenerate inputs, of which grids have any number, are excluded.
///
/// Which inputs are kept does not depend on the order in which they were found, nor on how they were divided and
/// merged.
class Hard_inputs {
  public:
    explicit Hard_inputs(std::size_t most) : most_(most) {}

    /// Whether an input with this key would be kept. A cheap test before `add`; it errs only by false positives.
    [[nodiscard]] bool may_keep(Certificate_name name, Stage stage, double key) const {
        const Class& c = of(name, stage);
        return most_ > 0 && (c.hardest.size() < most_ || key <= c.hardest.rbegin()->key);
    }
    /// True if it is one of the hardest so far.
    bool add(Certificate_name name, Stage stage, Hard_input input);
    /// Adds the listed inputs, returns those that were kept.
    Hard_inputs merge(const Hard_inputs& other);
    [[nodiscard]] bool empty() const;

    /// One object per input, in the order of certificates, stages and hardness: {"certificate", "stage", "key",
    /// "tolerance", "seed", "points"}, coordinates as hexadecimal doubles.
    [[nodiscard]] std::vector<nlohmann::ordered_json> json() const;
    /// Adds one such object.
    void add(const nlohmann::ordered_json& json);

  private:
    using Points = std::vector<double>;  ///< sorted point by point
    struct Class {
        std::set<Hard_input> hardest{};
        std::map<Points, std::set<Hard_input>::const_iterator> by_points{};
        Class() = default;
        Class(const Class&) = delete;
        Class& operator=(const Class&) = delete;
        Class(Class&&) = default;  // iterators stay those of the nodes
        Class& operator=(Class&&) = default;
    };
    [[nodiscard]] static std::size_t at(Certificate_name name, Stage stage) {
        return 3 * static_cast<std::size_t>(name) + static_cast<std::size_t>(stage);
    }
    [[nodiscard]] const Class& of(Certificate_name name, Stage stage) const { return class_[at(name, stage)]; }

    std::size_t most_;
    std::array<Class, 12> class_;
};

}  // namespace annulus::inline v1
