// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/benchmark.h>

#include <apps/report/processor_time.h>
#include <apps/reproduction/certificate_attack.h>
#include <apps/reproduction/cgal_costs.h>
#include <apps/reproduction/stability.h>

#include <chrono>
#include <cstdlib>
#include <deque>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// The number of steps that are recorded at a time. With fewer, caches are cold more often.
constexpr std::uint64_t block_size = 25;

Quality_record quality_record(std::uint64_t step, const Mesh_step& m) {
    return {step, m.vertices, m.locked, m.cells, m.slivers, m.dihedral_min, m.dihedral_max, m.dihedral};
}

template <int d>
class Benchmark {
  public:
    using Points = std::vector<Coordinates<d>>;

    Benchmark(Scene<d>& scene, const Benchmark_plan& plan, const Benchmark_listener& listener)
        : scene_(scene), plan_(plan), listener_(listener) {
        record_.name = plan.name;
        record_.title = plan.title;
        record_.dimension = d;
        record_.vertices = scene.points().size();
        record_.steps = plan.steps;
        record_.spacing = scene.spacing();
        record_.notes = scene.notes();
    }

    Benchmark_record run() {
        const auto begin = std::chrono::steady_clock::now();
        tell(0, "construction");
        std::deque<Contender<d>> contenders;
        for (const Contender_plan& r : plan_.contenders)
            contenders.emplace_back(r, std::span<const Coordinates<d>>(scene_.points()), plan_.seed);
        before_ = scene_.points();
        draw(0);
        judge(0);
        for (std::uint64_t done = 0; done < plan_.steps;) {
            const std::uint64_t now = std::min(block_size, plan_.steps - done);
            make_block(done, now);
            for (std::size_t k = 0; k < contenders.size(); ++k) {
                Contender<d>& contender = contenders[(k + done / block_size) % contenders.size()];
                for (std::uint64_t i = 0; i < now; ++i) {
                    contender.follow(done + i + 1, i == 0 ? before_ : block_[i - 1], block_[i]);
                    tell(done + (k * now + i) / contenders.size(),
                         plan_.contenders[(k + done / block_size) % contenders.size()].name);
                }
            }
            for (std::uint64_t i = 0; i < now; ++i) look(done + i + 1, i == 0 ? before_ : block_[i - 1], block_[i]);
            before_ = block_[now - 1];
            done += now;
        }
        look(plan_.steps + 1, before_, {});
        for (Contender<d>& contender : contenders) record_.contenders.push_back(contender.finish());
        record_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        if (getloadavg(&record_.load, 1) != 1) record_.load = 0;
        return std::move(record_);
    }

  private:
    void tell(std::uint64_t step, const std::string& news) {
        if (listener_ && !listener_(step, news)) throw Benchmark_stopped();
    }

    void make_block(std::uint64_t done, std::uint64_t now) {
        block_.resize(static_cast<std::size_t>(now));
        for (std::uint64_t i = 0; i < now; ++i) {
            Points& target = block_[static_cast<std::size_t>(i)];
            target.resize(before_.size());
            const double begin = process_seconds();
            record_.displacement.push_back(scene_.next(target) / record_.spacing);
            record_.motion_seconds += process_seconds() - begin;
            draw(done + i + 1);
            judge(done + i + 1);
            tell(done, "motion");
        }
    }

    void draw(std::uint64_t step) {
        if (!plan_.pictures.contains(step)) return;
        const Picture p = scene_.picture("after " + std::to_string(step) + (step == 1 ? " iteration" : " iterations"));
        if (!window_) window_ = window_of(p.points);
        record_.pictures.push_back({step, p.caption, svg_triangulation(p, *window_), {}, {}});
        if constexpr (d == 2)
            for (const auto& point : p.points) {
                record_.pictures.back().x.push_back(point[0]);
                record_.pictures.back().y.push_back(point[1]);
            }
    }

    void judge(std::uint64_t step) {
        if (plan_.quality_every == 0 || (step % plan_.quality_every != 0 && step != 1 && step != plan_.steps)) return;
        if (const auto q = scene_.quality()) record_.qualities.push_back(quality_record(step, *q));
    }

    /// Measurements at the positions before a step.
    void look(std::uint64_t step, std::span<const Coordinates<d>> x, std::span<const Coordinates<d>> next) {
        const bool distribution = plan_.distributions.contains(step), counts = plan_.degeneracies.contains(step),
                   adversary = plan_.adversaries.contains(step), stability = plan_.stabilities.contains(step),
                   operations = plan_.operations.contains(step);
        if (!plan_.surveys.contains(step) && !distribution && !counts && !adversary && !stability && !operations)
            return;
        tell(std::min(step, plan_.steps), "looking at step " + std::to_string(step));
        Moving_of<d> dt = paper_triangulation<d>(x);
        Width_record widths;
        Certificate_survey_record s = survey<d>(dt, next, record_.spacing, distribution ? &widths : nullptr);
        s.step = widths.step = step;
        record_.surveys.push_back(s);
        if (distribution) record_.widths.push_back(std::move(widths));
        if (stability) {
            record_.stabilities.push_back(measure_stability<d>(dt));
            record_.stabilities.back().step = step;
        }
        if (operations) {
            record_.operations.push_back(time_operations<d>(dt));
            record_.operations.back().step = step;
        }
        if (!counts && !adversary) return;
        std::vector<std::vector<Index>> unsound;
        record_.degeneracies.push_back(
            count_degeneracy<d>(dt, [&](std::span<const Index> v) { unsound.emplace_back(v.begin(), v.end()); }));
        record_.degeneracies.back().step = step;
        if constexpr (d == 3)
            if (adversary) {
                record_.adversaries.push_back(attack(dt, unsound, plan_.attacks, 20));
                record_.adversaries.back().step = step;
            }
    }

    Scene<d>& scene_;
    const Benchmark_plan& plan_;
    const Benchmark_listener& listener_;
    Benchmark_record record_;
    std::optional<Window> window_;
    Points before_;
    std::vector<Points> block_;
};

}  // namespace

template <int d>
Benchmark_record benchmark(Scene<d>& scene, const Benchmark_plan& plan, const Benchmark_listener& listener) {
    return Benchmark<d>(scene, plan, listener).run();
}

template Benchmark_record benchmark<2>(Scene<2>&, const Benchmark_plan&, const Benchmark_listener&);
template Benchmark_record benchmark<3>(Scene<3>&, const Benchmark_plan&, const Benchmark_listener&);

}  // namespace annulus::inline v1
