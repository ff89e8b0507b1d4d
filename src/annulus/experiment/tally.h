// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/statistics/degeneracy.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace annulus {

/// Counts of samples in the bins of a Histogram.
struct Bins {
    std::uint64_t below = 0, above = 0;  ///< of the first edge, of the last
    std::vector<std::uint64_t> in{};     ///< by bin
    friend bool operator==(const Bins&, const Bins&) = default;
};

/// What experiments have found, as numbers that add exactly: counts, histograms with fixed edges, and least values.
/// The sum of some of them does not depend on their order, nor on which were added first: integers are added, and a
/// minimum is a minimum.
///
/// An empty one is neutral.
struct Tally {
    std::map<std::string, std::uint64_t> counts{};
    std::map<std::string, Bins> histograms{};
    std::map<std::string, double> least{};

    /// Throws Error(bad_input) where two histograms of one name have different numbers of bins.
    Tally& operator+=(const Tally& other);
    friend bool operator==(const Tally&, const Tally&) = default;
};

/// One of Tally's histograms: its name, and its edges as an empty Histogram.
struct Scale_of {
    std::string name;
    std::string unit;
    Histogram empty;
};
/// All there are; their edges never change.
[[nodiscard]] const std::vector<Scale_of>& scales();
/// The scale of that name. Throws std::out_of_range.
[[nodiscard]] const Histogram& scale(const std::string& name);
[[nodiscard]] Bins bins_of(const Histogram& histogram);

/// Below which value a share p of the samples is, by linear interpolation in its bin (of the logarithms on a
/// logarithmic scale); the first or the last edge where it is beyond. NaN without samples.
[[nodiscard]] double quantile(const Bins& bins, const Histogram& scale, double p);

/// What `degeneracy` counted. What is told of every certificate (theta and width against the stage) is not in it:
/// Certificate_tally.
[[nodiscard]] Tally tally_of(const Degeneracy& found);

/// Theta and width of certificates against the stage that decided them.
class Certificate_tally {
  public:
    /// `resolution`: the unit of widths.
    explicit Certificate_tally(double resolution);
    void add_bicell(double theta, double width, Stage stage);
    void add_cell(double width, Stage stage);
    /// Adds what was told. `spacing` is the unit of the least widths.
    void add_to(Tally& tally, double spacing) const;

  private:
    double resolution_;
    std::vector<Histogram> theta_, width_, cell_width_;  // by stage
    double least_, least_positive_;
};

/// {"counts": {..}, "least": {..}, "histograms": {NAME: {"below", "above", "first", "in"}}}: of a histogram the bins
/// from the first to the last that is not 0.
[[nodiscard]] nlohmann::ordered_json tally_json(const Tally& tally);
/// The same back. Throws nlohmann's exceptions for what tally_json does not write.
[[nodiscard]] Tally tally_of(const nlohmann::ordered_json& json);

}  // namespace annulus
