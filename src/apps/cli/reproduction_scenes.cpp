// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/guided_nodt.h>
#include <apps/cli/reproduction_scenes.h>
#include <apps/reproduction/partial_motion.h>

#include <filesystem>
#include <utility>

namespace annulus::inline v1::cli {

namespace {

/// A scene from one of the motions of `compare`.
template <class Guided>
class Guided_scene : public Scene<Guided::Moving::dimension_of_space> {
  public:
    static constexpr int d = Guided::Moving::dimension_of_space;

    template <class Arguments>
    Guided_scene(const Arguments& arguments, const Common_arguments& common) : motion_(arguments, common) {}
    [[nodiscard]] const std::vector<Coordinates<d>>& points() const override { return motion_.points(); }
    [[nodiscard]] double spacing() const override { return motion_.spacing(); }
    [[nodiscard]] double next(std::vector<Coordinates<d>>& target) override {
        (void)motion_.next(time_step_);
        target = time_step_.x;
        return time_step_.way.mean;
    }
    [[nodiscard]] Picture picture(std::string caption) const override {
        Picture p = motion_.picture(motion_.guide(), std::move(caption));
        if constexpr (d == 2) p.edges.clear();  // the paper shows points
        return p;
    }
    [[nodiscard]] std::optional<Mesh_step> quality() override {
        if constexpr (d == 3) return motion_.quality();
        else return std::nullopt;
    }
    [[nodiscard]] std::vector<std::string> notes() const override { return motion_.notes(); }

  private:
    Guided motion_;
    Time_step<d> time_step_;
};

}  // namespace

std::unique_ptr<Scene<2>> plane_scene(const Motion_plan& motion, const Common_arguments& common) {
    if (motion.movers > 0)
        return std::make_unique<Partial_motion_scene<2>>(motion.vertices, motion.movers, motion.pace, common.seed);
    Lloyd_arguments a;
    a.points = motion.vertices;
    a.density = motion.density;
    return std::make_unique<Guided_scene<Guided_lloyd>>(a, common);
}

std::unique_ptr<Scene<3>> space_scene(const Motion_plan& motion, const std::string& surfaces,
                                      const Common_arguments& common) {
    if (motion.movers > 0)
        return std::make_unique<Partial_motion_scene<3>>(motion.vertices, motion.movers, motion.pace, common.seed);
    Nodt_arguments a;
    a.vertices = motion.vertices;
    a.sphere = motion.surface.empty();
    if (!a.sphere) a.surface = (std::filesystem::path(surfaces) / motion.surface).string();
    a.allow_crossing = motion.crossing;
    if (motion.graded) a.sizing = "graded";
    if (motion.lock_degrees > 0) a.lock = motion.lock_degrees;
    return std::make_unique<Guided_scene<Guided_nodt>>(a, common);
}

}  // namespace annulus::inline v1::cli
