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
Index insert(Moving_mesh<d>& mesh, const Coordinates<d>& p, Move_result& report) {
    return mesh.insert(p, &report);
}
Index insert(Moving_delaunay_2& object, const Coordinates<2>& p, Move_result& report) {
    return object.index(object.insert({p[0], p[1]}, &report));
}
Index insert(Moving_delaunay_3& object, const Coordinates<3>& p, Move_result& report) {
    return object.index(object.insert({p[0], p[1], p[2]}, &report));
}

template <int d>
void remove(Moving_mesh<d>& mesh, Index i, Move_result& report) {
    mesh.remove(i, &report);
}
template <class Object>
void remove(Object& object, Index i, Move_result& report) {
    object.remove(object.vertex(static_cast<std::size_t>(i)), &report);
}

template <int d, class Object>
class Object_follower final : public Follower<d> {
  public:
    Object_follower(const Points<d>& x, const Options& options, bool view)
        : object_(std::span<const Coordinates<d>>(x), options), view_(view) {}

    double follow(const Motion<d>& motion, Stopwatch watch, Move_result& report) override {
        std::vector<Index> arrivals;
        arrivals.reserve(motion.arrive().size());
        Move_result one;
        const double begin = watch.seconds();
        for (const Index i : motion.leave()) remove(object_, i, one);
        report = object_.move_all(std::span<const Coordinates<d>>(motion.points()));
        for (const Coordinates<d>& p : motion.arrive()) arrivals.push_back(insert(object_, p, one));
        if constexpr (!std::is_same_v<Object, Moving_mesh<d>>)
            if (view_) (void)object_.triangulation();
        const double s = watch.seconds() - begin;
        for (std::size_t k = 0; k < arrivals.size(); ++k)
            if (arrivals[k] != motion.number_of_arrival(k))
                throw std::logic_error("a motion and a triangulation number differently");
        return s;
    }
    [[nodiscard]] bool is_delaunay() const override { return object_.audit().delaunay(); }

  private:
    Object object_;
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
    if (what == "mesh") return std::make_unique<Object_follower<d, Moving_mesh<d>>>(x, options, false);
    if (!what.empty() && what != "view") throw std::invalid_argument(name + ": there are :mesh and :view");
    using Object = std::conditional_t<d == 2, Moving_delaunay_2, Moving_delaunay_3>;
    return std::make_unique<Object_follower<d, Object>>(x, options, what == "view");
}

template std::unique_ptr<Follower<2>> follower<2>(const std::string&, int, const Points<2>&);
template std::unique_ptr<Follower<3>> follower<3>(const std::string&, int, const Points<3>&);

}  // namespace bench
