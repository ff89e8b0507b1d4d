// SPDX-License-Identifier: GPL-3.0-or-later
#include "follower.h"

#include <annulus/moving_delaunay_2.h>
#include <annulus/moving_delaunay_3.h>
#include <annulus/moving_mesh.h>

#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace bench {

namespace {

using namespace annulus;

template <int d>
class Mesh_follower final : public Follower<d> {
  public:
    Mesh_follower(const Points<d>& x, const Options& options) : mesh_(std::span<const Coordinates<d>>(x), options) {}

    double follow(const Motion<d>& motion, Stopwatch watch, Move_report& report) override {
        std::vector<Index> arrivals;
        arrivals.reserve(motion.arrive().size());
        Move_report one;
        const double begin = watch.seconds();
        for (const Index i : motion.leave()) mesh_.remove(i, &one);
        report = mesh_.move_all(std::span<const Coordinates<d>>(motion.points()));
        for (const Coordinates<d>& p : motion.arrive()) arrivals.push_back(mesh_.insert(p, &one));
        const double s = watch.seconds() - begin;
        require_numbers(motion, arrivals);
        return s;
    }
    [[nodiscard]] bool is_delaunay() const override { return mesh_.audit().delaunay(); }

    static void require_numbers(const Motion<d>& motion, const std::vector<Index>& arrivals) {
        for (std::size_t k = 0; k < arrivals.size(); ++k)
            if (arrivals[k] != motion.number_of_arrival(k))
                throw std::logic_error("a motion and a triangulation number differently");
    }

  private:
    Moving_mesh<d> mesh_;
};

template <int d>
class Object_follower final : public Follower<d> {
  public:
    Object_follower(const Points<d>& x, const Options& options, bool view)
        : object_(std::span<const Coordinates<d>>(x), options), view_(view) {}

    double follow(const Motion<d>& motion, Stopwatch watch, Move_report& report) override {
        std::vector<Index> arrivals;
        arrivals.reserve(motion.arrive().size());
        Move_report one;
        const double begin = watch.seconds();
        for (const Index i : motion.leave()) object_.remove(object_.vertex(static_cast<std::size_t>(i)), &one);
        report = object_.move_all(std::span<const Coordinates<d>>(motion.points()));
        for (const Coordinates<d>& p : motion.arrive()) {
            if constexpr (d == 2) arrivals.push_back(object_.index(object_.insert({p[0], p[1]}, &one)));
            else arrivals.push_back(object_.index(object_.insert({p[0], p[1], p[2]}, &one)));
        }
        if (view_) (void)object_.triangulation();
        const double s = watch.seconds() - begin;
        Mesh_follower<d>::require_numbers(motion, arrivals);
        return s;
    }
    [[nodiscard]] bool is_delaunay() const override { return object_.audit().delaunay(); }

  private:
    std::conditional_t<d == 2, Moving_delaunay_2, Moving_delaunay_3> object_;
    bool view_;
};

}  // namespace

template <int d>
std::unique_ptr<Follower<d>> follower(const std::string& name, int threads, const Points<d>& x) {
    const std::size_t colon = name.find(':');
    const std::string what = colon == std::string::npos ? "" : name.substr(colon + 1);
    const auto strategy = strategy_named(name.substr(0, colon));
    if (!strategy) throw std::invalid_argument("no strategy " + name);
    Options options;
    options.strategy = *strategy;
    options.threads = threads;
    if (what == "mesh") return std::make_unique<Mesh_follower<d>>(x, options);
    if (!what.empty() && what != "view") throw std::invalid_argument(name + ": there are :mesh and :view");
    return std::make_unique<Object_follower<d>>(x, options, what == "view");
}

template std::unique_ptr<Follower<2>> follower<2>(const std::string&, int, const Points<2>&);
template std::unique_ptr<Follower<3>> follower<3>(const std::string&, int, const Points<3>&);

}  // namespace bench
