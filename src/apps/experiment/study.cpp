// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/study.h>

#include <annulus/engine/periodic_state.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/kernel/periodic_builder.h>
#include <annulus/measure/periodic_degeneracy.h>
#include <annulus/measure/spacing.h>
#include <annulus/predicate/margin.h>
#include <apps/formats/distinct.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace annulus::inline v1 {

namespace {

template <int k, int d>
Tuple<d, k> tuple_of(const Raw_certificate<d>& c) {
    Tuple<d, k> t{};
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = &c.place[i];
    return t;
}

template <class T>
double hardness(const T& x, double extent, double width, Stage stage) {
    return stage == Stage::filter ? filter_margin(x) : width / extent;
}

/// Receives certificates; adds up statistics and keeps the hardest inputs.
template <int d>
class Certificate_collector {
  public:
    using Raw = Raw_certificate<d>;
    Certificate_collector(double resolution, std::uint64_t seed, Hard_inputs& hard)
        : tally_(resolution), seed_(seed), hard_(hard) {}

    void operator()(const Raw& c) {
        if (c.kind == Raw::Kind::bicell) {
            tally_.add_bicell(c.theta, c.width_lower, c.stage);
            keep<d + 2>(d == 2 ? Certificate_name::empty_circle_2 : Certificate_name::empty_sphere_3, c);
        } else {
            if (c.kind == Raw::Kind::cell) tally_.add_cell(c.width_lower, c.stage);
            keep<d + 1>(d == 2 ? Certificate_name::orientation_2 : Certificate_name::orientation_3, c);
        }
    }
    [[nodiscard]] const Certificate_tally& tally() const { return tally_; }

  private:
    template <int k>
    void keep(Certificate_name name, const Raw& c) {
        if (c.width_upper == 0) return;
        const Tuple<d, k> t = tuple_of<k, d>(c);
        const double key = hardness(t, extent<d>(t), c.width_lower, c.stage);
        if (!std::isfinite(key) || !hard_.may_keep(name, c.stage, key)) return;
        Hard_input input{key, {}, c.tolerance, seed_};
        for (const Coordinates<d>* p : t) input.coordinates.insert(input.coordinates.end(), p->begin(), p->end());
        hard_.add(name, c.stage, std::move(input));
    }

    Certificate_tally tally_;
    std::uint64_t seed_;
    Hard_inputs& hard_;
};

/// Fills in what `measure` finds with these options.
template <int d, class Measure>
void examine(Study& s, std::uint64_t seed, Hard_inputs& hard, int threads, const Measure& measure) {
    Certificate_collector<d> collector(s.resolution, seed, hard);
    Degeneracy_options<d> options;
    options.quantiles = false;
    options.threads = threads;
    options.raw = [&collector](const Raw_certificate<d>& c) { collector(c); };
    const Degeneracy found = measure(options);
    s.spacing = found.spacing;
    s.tally = tally_of(found);
    collector.tally().add_to(s.tally, s.spacing);
}

Study flat(Study s) {
    s.tally.counts["experiments"] = s.tally.counts["flat"] = 1;
    return s;
}

}  // namespace

template <int d>
Study study(std::vector<Coordinates<d>> x, std::uint64_t seed, Hard_inputs& hard, int threads) {
    Study s;
    s.vertices = x.size();
    Delaunay_mesh<d> mesh;
    mesh.build(x);
    s.affine_dimension = mesh.dimension();
    s.resolution = resolution(x);
    if (s.affine_dimension < d) return flat(std::move(s));
    examine<d>(s, seed, hard, threads,
               [&](const Degeneracy_options<d>& options) { return degeneracy(mesh.table(), x, options); });
    return s;
}

template <int d>
Study study_in_box(std::vector<Coordinates<d>> x, const Box<d>& box, std::uint64_t seed, Hard_inputs& hard,
                   int threads) {
    keep_first(first_at_place<d>(x, box), x);
    Study s;
    s.vertices = x.size();
    Periodic_state<d> state(x, box);
    const Coordinates<d>& grid = state.lattice.grid();
    s.resolution = *std::max_element(grid.begin(), grid.end());
    if (x.empty()) return flat(std::move(s));
    s.affine_dimension = d;
    Periodic_builder<d>().build(state.lattice, state.place, threads, state.table);
    const Periodic_audit_input<d> mesh{state.place, state.lattice.box(), state.cells(false)};
    examine<d>(s, seed, hard, threads,
               [&](const Degeneracy_options<d>& options) { return periodic_degeneracy<d>(mesh, grid, options); });
    return s;
}

template Study study<2>(std::vector<Coordinates<2>>, std::uint64_t, Hard_inputs&, int);
template Study study<3>(std::vector<Coordinates<3>>, std::uint64_t, Hard_inputs&, int);
template Study study_in_box<2>(std::vector<Coordinates<2>>, const Box<2>&, std::uint64_t, Hard_inputs&, int);
template Study study_in_box<3>(std::vector<Coordinates<3>>, const Box<3>&, std::uint64_t, Hard_inputs&, int);

}  // namespace annulus::inline v1
