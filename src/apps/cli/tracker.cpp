// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/stopwatch.h>
#include <apps/cli/tracker.h>

#include <apps/report/memory.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace annulus::inline v1::cli {

namespace {

Moves_record moves_of(const Move_counts& c) {
    return {c.asked, c.within_tolerance, c.kept_in_place, c.flipped, c.reinserted, c.rebuilt};
}

std::optional<double> mean_of_finite(const std::vector<double>& values, double unit) {
    if (values.empty()) return std::nullopt;
    double sum = 0;
    std::size_t count = 0;
    for (const double v : values) {
        if (!std::isfinite(v)) continue;
        sum += v;
        ++count;
    }
    return count == 0 ? 0.0 : sum / static_cast<double>(count) / unit;
}

}  // namespace

template <class Moving>
Tracker<Moving>::Tracker(std::string name, std::span<const Coordinates<d>> points, const Options& options,
                         double spacing, std::uint64_t iterations, std::uint64_t audit_every, bool measure)
    : begun_(Clock::now()),
      dt_(points, options),
      spacing_(spacing),
      iterations_(iterations),
      audit_every_(audit_every),
      measure_(measure) {
    record_.dimension = d;
    record_.strategy = std::move(name);
    record_.tolerance = std::string(name_of(options.tolerance));
    record_.threads = static_cast<unsigned>(options.threads);
    record_.vertices = dt_.number_of_vertices();
    record_.mean_spacing = spacing;
    totals_ += dt_.recompute_tolerances();
    record_.seconds.construction = since(begun_);
}

template <class Moving>
bool Tracker<Moving>::measured_at(std::uint64_t i) const {
    if (!measure_) return false;
    if (i <= 20 || i == iterations_) return true;
    const auto mark = [](std::uint64_t k) { return std::floor(25 * std::log10(static_cast<double>(k))); };
    return mark(i) != mark(i - 1);
}

/// Passes the report to the listener, and clears its lists of cells, which are not added up.
template <class Moving>
void Tracker<Moving>::hear(Move_result& report, Index arrived) {
    if (listener_) listener_(report, arrived);
    report.changed.clear();
    report.gone.clear();
}

template <class Moving>
void Tracker<Moving>::step(std::span<const Coordinates<d>> x, double motion_seconds, double displacement_mean,
                           double displacement_max) {
    const auto start = Clock::now();
    Move_result report = dt_.move_all(x);
    const double seconds = since(start);
    hear(report, none);
    record_step(report, seconds, motion_seconds, displacement_mean, displacement_max);
}

template <class Moving>
std::vector<Index> Tracker<Moving>::follow(std::span<const Index> leave, std::span<const Coordinates<d>> x,
                                           std::span<const Coordinates<d>> arrive, double motion_seconds,
                                           double displacement_mean, double displacement_max) {
    Move_result report;
    double seconds = 0;
    std::vector<Index> indices;
    const auto call = [&](auto change, bool counts) {
        Move_result one;
        const auto start = Clock::now();
        const Index arrived = change(one);
        seconds += since(start);
        hear(one, arrived);
        if (!counts) one.moves = {};  // only the moves of move_all are counted
        report += one;
        return arrived;
    };
    for (const Index i : leave) (void)call([&](Move_result& one) { return dt_.remove(i, &one), none; }, false);
    (void)call([&](Move_result& one) { return one = dt_.move_all(x), none; }, true);
    for (const auto& p : arrive) indices.push_back(call([&](Move_result& one) { return dt_.insert(p, &one); }, false));
    record_step(report, seconds, motion_seconds, displacement_mean, displacement_max);
    cells_changed_ = cells_changed_ || !leave.empty() || !arrive.empty();
    return indices;
}

template <class Moving>
void Tracker<Moving>::record_step(const Move_result& report, double seconds, double motion_seconds,
                                  double displacement_mean, double displacement_max) {
    totals_ += report;
    cells_changed_ = changes_cells(report);
    record_.seconds.triangulation += seconds;
    record_.seconds.motion += motion_seconds;
    Iteration_record it;
    it.iteration = ++record_.iterations;
    it.seconds_triangulation = seconds;
    it.seconds_motion = motion_seconds;
    it.seconds_cumulative = record_.seconds.triangulation;
    it.displacement_mean = displacement_mean / spacing_;
    it.displacement_max = displacement_max / spacing_;
    it.moves = moves_of(report.moves);
    it.arithmetic = report.statistics.arithmetic;
    it.certificates_evaluated = report.statistics.evaluated;
    it.flips = report.statistics.flips;
    if (measured_at(it.iteration)) {
        const Measures m = dt_.measure();
        it.tolerance_mean = mean_of_finite(m.tolerance, spacing_);
        it.annulus_width_mean = mean_of_finite(m.annulus_width, spacing_);
        if (!m.annulus_width.empty()) {
            it.theta_min = m.theta_min;
            const std::uint64_t i = it.iteration;
            if (i == 1 || i == 10 || i == 100 || i == 1000) {
                Histogram h = Histogram::linear(0.0, 1.5, 75);
                for (const double w : m.annulus_width) h.add(w / spacing_);
                widths_.push_back({i, std::move(h)});
            }
        }
    }
    if (!keeps_steps_) record_.steps.clear();
    record_.steps.push_back(it);
    const bool last = record_.iterations == iterations_;
    if (audit_every_ > 0 && (last || record_.iterations % audit_every_ == 0)) audit();
}

template <class Moving>
void Tracker<Moving>::audit() {
    const Audit_result result = dt_.audit();
    ++record_.audit.checked;
    if (result.delaunay()) return;
    ++record_.audit.failed;
    if (first_fault_.empty()) first_fault_ = "step " + std::to_string(record_.iterations) + ": " + result.first_fault;
}

template <class Moving>
void Tracker<Moving>::finish(const std::string& command, std::uint64_t seed, double total_seconds) {
    if (record_.iterations == 0 && audit_every_ > 0) audit();
    record_.vertices = dt_.number_of_vertices();  // as in the files; a replay may have started with another number
    record_.command = command;
    record_.interrupted = record_.iterations < iterations_;
    record_.seed = seed;
    record_.seconds.total = total_seconds;
    record_.moves = moves_of(totals_.moves);
    record_.arithmetic = totals_.statistics.arithmetic;
    record_.memory_peak_bytes = peak_resident_memory();
}

template <class Moving>
double Tracker<Moving>::share_within() const {
    return totals_.moves.asked == 0
               ? 0.0
               : static_cast<double>(totals_.moves.within_tolerance) / static_cast<double>(totals_.moves.asked);
}

template <class Moving>
std::vector<std::array<Index, static_cast<std::size_t>(Tracker<Moving>::d) + 1>> Tracker<Moving>::canonical_cells()
    const {
    auto cells = dt_.audit_input().cells;
    for (auto& c : cells)
        if constexpr (d == 3) {
            std::sort(c.begin(), c.end());  // the audit has checked the orientation
        } else if (c[2] == none) {
            if (c[0] > c[1]) std::swap(c[0], c[1]);
        } else {
            std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
        }
    std::sort(cells.begin(), cells.end());
    return cells;
}

template <class Moving>
void Tracker<Moving>::add_motion(double seconds) {
    record_.seconds.motion += seconds;
    record_.steps.back().seconds_motion += seconds;
}

template class Tracker<Moving_mesh_2>;
template class Tracker<Moving_mesh_3>;

Picture picture_of(const Moving_mesh_2& dt, std::string caption) {
    Audit_input<2> in = dt.audit_input();
    Picture picture;
    picture.caption = std::move(caption);
    for (const auto& c : in.cells)
        for (std::size_t i = 0; i < 3; ++i) {
            const Index a = c[i];
            const Index b = c[(i + 1) % 3];
            if (a == none || b == none) continue;
            picture.edges.push_back({std::min(a, b), std::max(a, b)});
        }
    std::sort(picture.edges.begin(), picture.edges.end());
    picture.edges.erase(std::unique(picture.edges.begin(), picture.edges.end()), picture.edges.end());
    picture.points = std::move(in.points);
    return picture;
}

}  // namespace annulus::inline v1::cli
