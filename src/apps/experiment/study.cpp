// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/study.h>

#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/measure/spacing.h>
#include <annulus/predicate/margin.h>

#include <cmath>
#include <span>

namespace annulus::inline v1 {

namespace {

template <int k, int d, std::size_t n>
Tuple<d, k> tuple_of(const std::array<Index, n>& point, std::span<const Coordinates<d>> x) {
    Tuple<d, k> t{};
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = &x[static_cast<std::size_t>(point[i])];
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
    Certificate_collector(std::span<const Coordinates<d>> x, double resolution, std::uint64_t seed, Hard_inputs& hard)
        : x_(x), tally_(resolution), seed_(seed), hard_(hard) {}

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
        const Tuple<d, k> t = tuple_of<k, d>(c.point, x_);
        const double key = hardness(t, extent<d>(t), c.width_lower, c.stage);
        if (!std::isfinite(key) || !hard_.may_keep(name, c.stage, key)) return;
        Hard_input input{key, {}, c.tolerance, seed_};
        for (const Coordinates<d>* p : t) input.coordinates.insert(input.coordinates.end(), p->begin(), p->end());
        hard_.add(name, c.stage, std::move(input));
    }

    std::span<const Coordinates<d>> x_;
    Certificate_tally tally_;
    std::uint64_t seed_;
    Hard_inputs& hard_;
};

}  // namespace

template <int d>
Study study(std::vector<Coordinates<d>> x, std::uint64_t seed, Hard_inputs& hard, int threads) {
    Study s;
    s.vertices = x.size();
    Delaunay_mesh<d> mesh;
    mesh.build(x);
    s.affine_dimension = mesh.dimension();
    s.resolution = resolution(x);
    if (s.affine_dimension < d) {
        s.tally.counts["experiments"] = s.tally.counts["flat"] = 1;
        return s;
    }
    Certificate_collector<d> collector(x, s.resolution, seed, hard);
    Degeneracy_options<d> options;
    options.quantiles = false;
    options.threads = threads;
    options.raw = [&collector](const Raw_certificate<d>& c) { collector(c); };
    const Degeneracy found = degeneracy(mesh.table(), x, options);
    s.spacing = found.spacing;
    s.tally = tally_of(found);
    collector.tally().add_to(s.tally, s.spacing);
    return s;
}

template Study study<2>(std::vector<Coordinates<2>>, std::uint64_t, Hard_inputs&, int);
template Study study<3>(std::vector<Coordinates<3>>, std::uint64_t, Hard_inputs&, int);

}  // namespace annulus::inline v1
