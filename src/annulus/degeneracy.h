// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

template <int d>
class Moving_mesh;
template <int d>
class Periodic_mesh;

/// Counts of samples in bins, and the smallest and largest sample, in the unit of the samples.
///
/// Bins are half open, [edge(i), edge(i+1)), but the last one, which is closed. Samples below and above
/// are counted apart; NaN is no sample. A bin holds exactly the samples between the doubles that `edges()` shows.
class Histogram {
  public:
    /// Bins of equal width over [lower, upper]. Throws Error(usage) unless lower < upper, both finite, bins > 0.
    [[nodiscard]] static Histogram linear(double lower, double upper, std::size_t bins);

    /// Bins of equal ratio over [lower, upper]; zero and negative samples are underflow. Throws Error(usage) unless
    /// 0 < lower < upper < infinity, bins > 0.
    [[nodiscard]] static Histogram log10(double lower, double upper, std::size_t bins);

    /// Counts one sample. O(log bins).
    void add(double sample);
    void add(std::span<const double> samples);

    /// Both are valid until the object is assigned to or destroyed.
    [[nodiscard]] std::span<const double> edges() const noexcept { return edges_; }
    /// Valid as long; the numbers change with add().
    [[nodiscard]] std::span<const std::uint64_t> counts() const noexcept { return counts_; }
    [[nodiscard]] bool logarithmic() const noexcept { return logarithmic_; }
    [[nodiscard]] std::uint64_t underflow() const noexcept { return underflow_; }
    [[nodiscard]] std::uint64_t overflow() const noexcept { return overflow_; }

    /// Number of samples, those outside the bins included.
    [[nodiscard]] std::uint64_t total() const noexcept { return total_; }
    /// Share of `total()` in bin i; 0 when there are no samples.
    [[nodiscard]] double share(std::size_t i) const;
    /// NaN when there are no samples.
    [[nodiscard]] double min() const noexcept { return min_; }
    [[nodiscard]] double max() const noexcept { return max_; }

  private:
    Histogram(std::vector<double> edges, bool logarithmic);

    std::vector<double> edges_;
    std::vector<std::uint64_t> counts_;
    bool logarithmic_;
    std::uint64_t underflow_ = 0;
    std::uint64_t overflow_ = 0;
    std::uint64_t total_ = 0;
    double min_;
    double max_;
};

/// Quantiles of samples by linear interpolation between order statistics (Hyndman and Fan's type 7): one answer for
/// each probability. Samples are taken by value and sorted, O(n log n). Throws Error(usage) when a probability is
/// outside [0, 1], Error(too_few) without samples, Error(not_finite) when a sample is NaN.
[[nodiscard]] std::vector<double> quantiles(std::vector<double> samples, std::span<const double> probabilities);

/// A width below which a certificate counts as nearly degenerate.
struct Threshold {
    std::string name;     ///< "1e-6", or "ulp" for the resolution of the input's doubles
    double width = 0;     ///< in the unit of the points; the counts are exact for this number
    double relative = 0;  ///< in mean spacings
};

/// The distribution of samples. Certified numbers enter with their lower ends, which are within 2^-10 of the truth.
struct Distribution {
    static constexpr std::array<double, 10> probabilities{0, 0.001, 0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99, 1};

    Histogram histogram = Histogram::log10(1e-18, 1e4, 88);
    std::vector<double> quantiles{};  ///< at `probabilities`; empty without samples, or where they are not requested
};

/// How many widths are 0 or nearly 0. Every count is certified: a width is a real number, compared exactly.
struct Width_counts {
    std::uint64_t total = 0;
    std::uint64_t zero = 0;            ///< exactly degenerate
    std::vector<std::uint64_t> below;  ///< by threshold; including those that are 0
    Distribution width;                ///< in mean spacings
};

/// One kind of certificate.
struct Certificate_counts {
    Width_counts least;                 ///< twice the distance to the nearest placement at which the certificate is 0
    Stage_counts arithmetic;            ///< the stages that decided sign and tolerance, as in a run
    std::uint64_t decided_exactly = 0;  ///< widths for which counting needed integers
};

/// How far vertices may move.
struct Vertex_counts {
    std::uint64_t total = 0;
    std::uint64_t zero = 0;
    std::vector<std::uint64_t> below;  ///< tolerance below the threshold, counted exactly
    Distribution certified;            ///< tolerances in mean spacings, as at the start of a run
    Distribution paper;                ///< least half width of the paper's annuli and slabs

    /// The paper's tolerance is greater than the distance to degeneracy of a certificate that contains the vertex.
    std::uint64_t paper_above_exact = 0;
    /// At all points of some such certificate the paper's tolerance is greater: its points may move to where it fails
    /// while all of them stay within their tolerances.
    std::uint64_t paper_unsound = 0;
    std::uint64_t unsound_certificates = 0;
    /// The paper's tolerance divided by the least half width of our certificates that contain the vertex: above 1 it is
    /// not a tolerance of that certificate. Both from lower ends, so accurate to 2^-9. Overflow where only the latter
    /// is 0; no sample where both are 0.
    Histogram paper_ratio = Histogram::log10(1e-2, 1e6, 320);
};

/// How degenerate a Delaunay triangulation is.
struct Degeneracy {
    int dimension = 2;
    /// In a periodic box: there are no ridges, and the paper's tolerances are not computed (`vertices` has none).
    bool periodic = false;
    double spacing = 0;  ///< mean spacing: square root of the hull's (box's) area per vertex, cube root of the volume
    double resolution = 0;  ///< the distance of doubles at the largest coordinate; in a box the grid's largest spacing
    std::vector<Threshold> thresholds;

    Certificate_counts bicells;  ///< finite ones: empty circles and spheres
    Width_counts standard;       ///< in 3D: the paper's annulus of the same bi-cells; in 2D it is the only one
    Certificate_counts cells;    ///< finite ones
    Certificate_counts ridges;   ///< of the hull; in 2D its vertices

    std::uint64_t non_convex = 0;  ///< bi-cells with a reflex edge (in 2D: vertex), by exact signs
    std::uint64_t flat = 0;        ///< other bi-cells with four coplanar points (2D: three collinear ones) at the facet
    Stage_counts convexity;        ///< stages of these signs
    Distribution theta;            ///< of bi-cells, in radians

    Vertex_counts vertices;
};

/// One certificate with its results.
template <int d>
struct Raw_certificate {
    enum class Kind { bicell, cell, ridge };
    Kind kind = Kind::bicell;
    std::array<Index, static_cast<std::size_t>(d) + 2>
        point{};  ///< vertices; the last one `none` where there are d + 1
    double width_lower = 0,
           width_upper =
               0;          ///< ends of an enclosure of its width (Certificate_counts::least), in the unit of the points
    double tolerance = 0;  ///< of each of its points, certified
    Stage stage = Stage::filter;  ///< that decided sign and tolerance
    double theta = 0;             ///< of a bi-cell, in radians
    /// Where its points are, as many: in a periodic box the images of which it is, with the last one at the place of
    /// its vertex.
    std::array<Coordinates<d>, static_cast<std::size_t>(d) + 2> place{};
};

template <int d>
struct Degeneracy_options {
    /// Thresholds in mean spacings, by name; "ulp" comes after them.
    std::vector<std::pair<std::string, double>> thresholds{
        {"1e-3", 1e-3}, {"1e-6", 1e-6}, {"1e-9", 1e-9}, {"1e-12", 1e-12}};
    static constexpr std::size_t most_thresholds = 30;
    /// Distributions have quantiles, for which all samples are kept until the end: eight bytes each.
    bool quantiles = true;
    /// The number that work at once (TBB), 1 or more, else Error(usage). Neither the results nor the order of the calls
    /// of `raw` depend on it.
    int threads = 1;
    /// Called for every certificate, unless empty: for one at a time, by any of the threads.
    std::function<void(const Raw_certificate<d>&)> raw{};
    /// Called for every unsound certificate (Vertex_counts), unless empty, with its points in the order of the
    /// predicates.
    std::function<void(std::span<const Index>)> unsound{};
};

/// How degenerate a mesh is at the positions at which it is Delaunay. Throws too_few unless its points span the space,
/// usage. A bi-cell costs a microsecond, a degenerate one ten or more.
[[nodiscard]] Degeneracy degeneracy(const Moving_mesh<2>& mesh, const Degeneracy_options<2>& options = {});
[[nodiscard]] Degeneracy degeneracy(const Moving_mesh<3>& mesh, const Degeneracy_options<3>& options = {});

/// How degenerate a periodic mesh is, its cells counted once each, at places(). Where a certificate has several images
/// of a vertex, they count as points that move apart from one another: widths and tolerances are then lower bounds of
/// those of vertices whose images move together, and 0 where these are. Throws too_few without vertices, usage. Costs
/// what it does with open boundaries.
[[nodiscard]] Degeneracy degeneracy(const Periodic_mesh<2>& mesh, const Degeneracy_options<2>& options = {});
[[nodiscard]] Degeneracy degeneracy(const Periodic_mesh<3>& mesh, const Degeneracy_options<3>& options = {});

}  // namespace annulus::inline v1
