// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/degeneracy.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// Counts of samples in the bins of a Histogram.
struct Bins {
    std::uint64_t below = 0, above = 0;  ///< samples below the first edge, above the last
    std::vector<std::uint64_t> in{};     ///< by bin
    friend bool operator==(const Bins&, const Bins&) = default;
};

/// The results of experiments, as numbers that add exactly: counts, histograms with fixed edges, and least values. A
/// sum does not depend on the order or grouping: integers are added, and minima are taken.
///
/// An empty tally is neutral.
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
/// All histograms; their edges never change.
[[nodiscard]] const std::vector<Scale_of>& scales();
/// The scale with that name. Throws std::out_of_range.
[[nodiscard]] const Histogram& scale(const std::string& name);
[[nodiscard]] Bins bins_of(const Histogram& histogram);

/// The count with that name, 0 where there is none.
[[nodiscard]] std::uint64_t count(const Tally& tally, const std::string& name);

/// The value below which a share p of the samples is, by linear interpolation in its bin (of the logarithms on a
/// logarithmic scale); the first or the last edge where it is beyond. NaN without samples.
[[nodiscard]] double quantile(const Bins& bins, const Histogram& scale, double p);

/// The counts of `degeneracy`, in a periodic box without ridges and the paper's tolerances; without the data of single
/// certificates (theta and width by stage), see Certificate_tally.
[[nodiscard]] Tally tally_of(const Degeneracy& found);

/// Theta and width of certificates by the stage that decided them.
class Certificate_tally {
  public:
    /// `resolution`: the unit of widths.
    explicit Certificate_tally(double resolution);
    void add_bicell(double theta, double width, Stage stage);
    void add_cell(double width, Stage stage);
    /// Adds what was collected. `spacing` is the unit of the least widths.
    void add_to(Tally& tally, double spacing) const;

  private:
    double resolution_;
    std::vector<Histogram> theta_, width_, cell_width_;  // by stage
    double least_, least_positive_;
};

/// {"counts": {..}, "least": {..}, "histograms": {NAME: {"below", "above", "first", "in"}}}: the bins of a histogram
/// from the first to the last that is not 0.
[[nodiscard]] nlohmann::ordered_json tally_json(const Tally& tally);
/// The inverse. Throws nlohmann's exceptions for JSON that tally_json does not write.
[[nodiscard]] Tally tally_of(const nlohmann::ordered_json& json);

}  // namespace annulus::inline v1
