// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/run_tracker.h>

#include <apps/report/memory.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1::cli {

namespace {

Moves_record moves_of(const Move_counts& c) {
    return {c.asked, c.within_tolerance, c.kept_in_place, c.flipped, c.reinserted, c.rebuilt};
}

/// Whether a step tested vertices against their tolerances. Strategies that move whole time steps count how they began;
/// they count nothing where no vertex left its tolerance.
bool tests_tolerances(Strategy strategy, const Move_result& step) {
    const Move_counts& m = step.moves;
    const Move_statistics& s = step.statistics;
    if (m.asked == 0 || m.rebuilt == m.asked) return false;
    switch (strategy) {
        case Strategy::automatic:
        case Strategy::tolerances:
            return s.sign_steps + s.rebuild_steps == 0 && (s.tolerance_steps > 0 || m.within_tolerance == m.asked);
        case Strategy::tolerances_each: return m.within_tolerance > 0;
        case Strategy::paper:
        case Strategy::paper_hybrid: return true;
        default: return false;
    }
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
Run_tracker<Moving>::Run_tracker(std::string name, const std::function<Moving()>& make, const Options& options,
                                 double spacing, std::uint64_t iterations, std::uint64_t audit_every, bool measure)
    : threads_(options.threads),
      begun_(threads_),
      dt_(make()),
      spacing_(spacing),
      iterations_(iterations),
      audit_every_(audit_every),
      strategy_(options.strategy),
      measure_(measure) {
    record_.dimension = d;
    record_.strategy = std::move(name);
    record_.tolerance = name_of(options.tolerance);
    record_.threads = static_cast<unsigned>(options.threads);
    record_.vertices = dt_.number_of_vertices();
    record_.mean_spacing = spacing;
    totals_ += dt_.recompute_tolerances();
    record_.seconds.construction = begun_.seconds();
}

template <class Moving>
bool Run_tracker<Moving>::measured_at(std::uint64_t i) const {
    if (!measure_) return false;
    if (i <= 20 || i == iterations_) return true;
    const auto mark = [](std::uint64_t k) { return std::floor(25 * std::log10(static_cast<double>(k))); };
    return mark(i) != mark(i - 1);
}

/// Passes the report to the listener, and clears its lists of cells, which are not added up.
template <class Moving>
void Run_tracker<Moving>::hear(Move_result& report, Index arrived) {
    if (listener_) listener_(report, arrived);
    report.changed.clear();
    report.gone.clear();
}

template <class Moving>
void Run_tracker<Moving>::step(const std::function<Move_result(Moving&)>& call, double motion_seconds,
                               const Displacement& way) {
    const Stopwatch watch(threads_);
    Move_result report = call(dt_);
    const double seconds = watch.seconds();
    hear(report, none);
    record_step(report, seconds, motion_seconds, way);
}

template <class Moving>
void Run_tracker<Moving>::record_step(const Move_result& report, double seconds, double motion_seconds,
                                      const Displacement& way) {
    totals_ += report;
    cells_changed_ = changes_cells(report);
    record_.seconds.triangulation += seconds;
    record_.seconds.motion += motion_seconds;
    Iteration_record it;
    it.iteration = ++record_.iterations;
    it.seconds_triangulation = seconds;
    it.seconds_motion = motion_seconds;
    it.seconds_cumulative = record_.seconds.triangulation;
    it.displacement_mean = way.mean / spacing_;
    it.displacement_max = way.max / spacing_;
    it.moves = moves_of(report.moves);
    it.tested_tolerances = tests_tolerances(strategy_, report);
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
            if (i == 1 || i == 10 || i == 100 || i == 1000 || i == iterations_) {
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
void Run_tracker<Moving>::audit() {
    const Audit_result result = dt_.audit();
    ++record_.audit.checked;
    if (result.delaunay()) return;
    ++record_.audit.failed;
    if (first_fault_.empty()) first_fault_ = "step " + std::to_string(record_.iterations) + ": " + result.first_fault;
}

template <class Moving>
void Run_tracker<Moving>::finish(const std::string& command, std::uint64_t seed, double total_seconds) {
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
double Run_tracker<Moving>::share_within() const {
    return totals_.moves.asked == 0
               ? 0.0
               : static_cast<double>(totals_.moves.within_tolerance) / static_cast<double>(totals_.moves.asked);
}

template <class Moving>
void Run_tracker<Moving>::add_motion(double seconds) {
    record_.seconds.motion += seconds;
    record_.steps.back().seconds_motion += seconds;
}

template class Run_tracker<Moving_mesh_2>;
template class Run_tracker<Moving_mesh_3>;
template class Run_tracker<Boxed_mesh<2>>;
template class Run_tracker<Boxed_mesh<3>>;

}  // namespace annulus::inline v1::cli
