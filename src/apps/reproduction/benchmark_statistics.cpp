// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/benchmark_statistics.h>

#include <algorithm>

namespace annulus::inline v1 {

namespace {

template <class Records>
auto find_step(const Records& records, std::uint64_t step) -> decltype(records.data()) {
    const auto found = std::find_if(records.begin(), records.end(), [&](const auto& r) { return r.step == step; });
    return found == records.end() ? nullptr : &*found;
}

double mean_between(const Contender_record& r, std::uint64_t from, std::uint64_t to) {
    double sum = 0, n = 0;
    for (std::size_t k = 0; k < r.step.size(); ++k)
        if (r.step[k] > from && r.step[k] <= to) {
            sum += r.seconds[k];
            ++n;
        }
    return n > 0 ? sum / n : 0;
}

double ratio(double a, double b) { return b > 0 ? a / b : 0; }

/// The sum of one count over a tenth of the steps up to `step`, divided by that of another.
double recent(const Benchmark_record& benchmark, const std::string& name, std::uint64_t step,
              std::vector<std::uint64_t> Contender_record::*part, std::vector<std::uint64_t> Contender_record::*all) {
    const Contender_record* r = contender_of(benchmark, name);
    if (!r) return 0;
    double a = 0, b = 0;
    for (std::size_t k = 0; k < r->step.size(); ++k)
        if (r->step[k] <= step && r->step[k] + step / 10 >= step) {
            a += static_cast<double>((r->*part)[k]);
            b += static_cast<double>((r->*all)[k]);
        }
    return ratio(a, b);
}

}  // namespace

const Contender_record* contender_of(const Benchmark_record& benchmark, const std::string& name) {
    const auto found = std::find_if(benchmark.contenders.begin(), benchmark.contenders.end(),
                                    [&](const Contender_record& r) { return r.name == name; });
    return found == benchmark.contenders.end() ? nullptr : &*found;
}

std::vector<std::pair<std::uint64_t, double>> cumulated(const Contender_record& r) {
    std::vector<std::pair<std::uint64_t, double>> out{{0, r.switched_at > 0 ? 0 : r.precompute_seconds}};
    for (std::size_t k = 0; k < r.step.size(); ++k)
        out.emplace_back(r.step[k],
                         out.back().second + r.seconds[k] * static_cast<double>(r.step[k] - out.back().first));
    return out;
}

double total_seconds(const Benchmark_record& benchmark, const std::string& name) {
    const Contender_record* r = contender_of(benchmark, name);
    if (!r || r->step.empty()) return 0;
    const auto last = cumulated(*r).back();
    return last.second * static_cast<double>(benchmark.steps) / static_cast<double>(last.first);
}

double speed_up(const Benchmark_record& benchmark, const std::string& slow, const std::string& quick) {
    return ratio(total_seconds(benchmark, slow), total_seconds(benchmark, quick));
}

double speed_up_between(const Benchmark_record& benchmark, const std::string& slow, const std::string& quick,
                        std::uint64_t from, std::uint64_t to) {
    const Contender_record *s = contender_of(benchmark, slow), *q = contender_of(benchmark, quick);
    return s && q ? ratio(mean_between(*s, from, to), mean_between(*q, from, to)) : 0;
}

double acceleration(const Benchmark_record& benchmark, const std::string& name) {
    const Contender_record* r = contender_of(benchmark, name);
    const std::size_t n = r ? r->seconds.size() : 0, tenth = std::max<std::size_t>(1, n / 10);
    double early = 0, late = 0;
    for (std::size_t k = 0; k < std::min(tenth, n); ++k) {
        early += r->seconds[k];
        late += r->seconds[n - 1 - k];
    }
    return ratio(early, late);
}

double longest_step(const Benchmark_record& benchmark, const std::string& name, double exceeding) {
    const Contender_record *r = contender_of(benchmark, name), *rebuild = contender_of(benchmark, "rebuild");
    if (!r || !rebuild || r->seconds.empty()) return 0;
    std::vector<double> seconds = r->seconds;
    std::sort(seconds.begin(), seconds.end());
    const auto left_out = static_cast<std::size_t>(exceeding * static_cast<double>(seconds.size()));
    return ratio(seconds[seconds.size() - 1 - left_out], mean_between(*rebuild, 0, benchmark.steps));
}

double slower_steps(const Benchmark_record& benchmark, const std::string& name) {
    const Contender_record *r = contender_of(benchmark, name), *rebuild = contender_of(benchmark, "rebuild");
    if (!r || !rebuild || r->seconds.empty()) return 0;
    const double limit = mean_between(*rebuild, 0, benchmark.steps);
    const auto n = std::count_if(r->seconds.begin(), r->seconds.end(), [&](double s) { return s > limit; });
    return static_cast<double>(n) / static_cast<double>(r->seconds.size());
}

double failed_share(const Benchmark_record& benchmark, const std::string& name) {
    double failed = 0, asked = 0;
    if (const Contender_record* r = contender_of(benchmark, name))
        for (std::size_t k = 0; k < r->step.size(); ++k) {
            failed += static_cast<double>(r->failed[k]);
            asked += static_cast<double>(r->asked[k]);
        }
    return ratio(failed, asked);
}

std::optional<std::uint64_t> first_step_below(const Benchmark_record& benchmark, const std::string& name,
                                              double share) {
    const Contender_record* r = contender_of(benchmark, name);
    for (std::size_t k = 0; r && k < r->step.size(); ++k) {
        double failed = 0, asked = 0;
        for (std::size_t i = k; i < r->step.size() && r->step[i] <= r->step[k] + r->step[k] / 10; ++i) {
            failed += static_cast<double>(r->failed[i]);
            asked += static_cast<double>(r->asked[i]);
        }
        if (asked > 0 && failed <= share * asked) return r->step[k];
    }
    return std::nullopt;
}

double small_angle(const Quality_record& q) {
    double all = 0, below = 0;
    for (const std::uint64_t n : q.dihedral) all += static_cast<double>(n);
    for (std::size_t k = 0; k < q.dihedral.size(); ++k) {
        const auto n = static_cast<double>(q.dihedral[k]);
        if (below + n >= 0.01 * all && n > 0)
            return 180.0 / static_cast<double>(q.dihedral.size()) * (static_cast<double>(k) + (0.01 * all - below) / n);
        below += n;
    }
    return 0;
}

double failures_at(const Benchmark_record& benchmark, const std::string& name, std::uint64_t step) {
    return recent(benchmark, name, step, &Contender_record::failed, &Contender_record::asked);
}

double updates_at(const Benchmark_record& benchmark, const std::string& name, std::uint64_t step) {
    return recent(benchmark, name, step, &Contender_record::evaluated, &Contender_record::failed);
}

double most_renewals(const Benchmark_record& benchmark, const std::string& name) {
    const Contender_record* r = contender_of(benchmark, name);
    std::uint64_t most = 0;
    for (std::size_t k = 0; r && k < r->step.size(); ++k) most = std::max(most, r->failed[k] + r->requeued[k]);
    return ratio(static_cast<double>(most), static_cast<double>(benchmark.vertices));
}

std::optional<double> switch_point(const Benchmark_record& benchmark, const std::string& name) {
    const Contender_record *paper = contender_of(benchmark, name), *rebuild = contender_of(benchmark, "rebuild");
    if (!paper || !rebuild) return std::nullopt;
    const double limit = mean_between(*rebuild, 0, benchmark.steps);
    for (std::size_t k = 0; k < paper->step.size(); ++k) {
        if (paper->seconds[k] > limit || paper->asked[k] == 0) continue;
        if (k == 0) return std::nullopt;
        const auto within = [&](std::size_t i) {
            return 1 - ratio(static_cast<double>(paper->failed[i]), static_cast<double>(paper->asked[i]));
        };
        const double above = paper->seconds[k - 1] - limit, below = limit - paper->seconds[k];
        return within(k - 1) + (within(k) - within(k - 1)) * ratio(above, above + below);
    }
    return std::nullopt;
}

const Certificate_survey_record* survey_at(const Benchmark_record& benchmark, std::uint64_t step) {
    return find_step(benchmark.surveys, step);
}
const Quality_record* quality_at(const Benchmark_record& benchmark, std::uint64_t step) {
    return find_step(benchmark.qualities, step);
}

}  // namespace annulus::inline v1
