// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cli/guided_motion.h>

#include <utility>

namespace annulus::cli {

Guided_lloyd::Guided_lloyd(const Lloyd_arguments& arguments, const Common_arguments& common)
    : scene_(make_scene(arguments, common.seed)),
      guide_(scene_.points),
      lloyd_(scene_.domain, scene_.density, common.threads) {
    common.say_merged(arguments.input, scene_.merged);
    common.say_notes(scene_.notes);
}

Way Guided_lloyd::next(std::span<Coordinates<2>> target) {
    if (cells_changed_) read_stars(guide_, stars_);
    const Lloyd_step step = lloyd_.step(stars_, guide_.positions(), target, memory_);
    cells_changed_ = changes_cells(guide_.move_all(std::span<const Coordinates<2>>(target)));
    return {step.mean_displacement, step.max_displacement};
}

Picture Guided_lloyd::picture(const Moving& dt, std::string caption) const {
    return picture_of(dt, std::move(caption));
}

Guided_nodt::Guided_nodt(const Nodt_arguments& arguments, const Common_arguments& common)
    : threads_(common.threads),
      scene_(make_scene(arguments, common.seed)),
      guide_(scene_.points),
      nodt_(scene_.motion(arguments, common.threads)) {
    mesh_.read(guide_, true, *scene_.domain, threads_);
    scene_.require_cells(arguments, mesh_.inside());
}

Way Guided_nodt::next(std::span<Coordinates<3>> target) {
    mesh_.read(guide_, cells_changed_, *scene_.domain, threads_);
    const Nodt_step step = nodt_.step(mesh_.kept(), mesh_.points(), target, memory_);
    cells_changed_ = changes_cells(guide_.move_all(std::span<const Coordinates<3>>(target)));
    return {step.mean_displacement, step.max_displacement};
}

Picture Guided_nodt::picture(const Moving& dt, std::string caption) const {
    Mesh_3 mesh;
    mesh.read(dt, true, *scene_.domain, threads_);
    return mesh.cut(std::move(caption));
}

}  // namespace annulus::cli
