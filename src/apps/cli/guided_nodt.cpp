// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/guided_nodt.h>
#include <apps/cli/stopwatch.h>

#include <utility>

namespace annulus::inline v1::cli {

Guided_nodt::Guided_nodt(const Nodt_arguments& arguments, const Common_arguments& common)
    : threads_(common.threads),
      scene_(make_scene(arguments, common.seed)),
      guide_(scene_.points),
      nodt_(scene_.motion(arguments, common.threads)) {
    mesh_.read(guide_, true, *scene_.domain, threads_);
    scene_.require_cells(arguments, mesh_.inside());
    cut_ = mesh_.middle();
}

bool Guided_nodt::next(Time_step<3>& t) {
    const Stopwatch watch(threads_);
    t.x.resize(scene_.points.size());
    read_mesh();
    last_ = nodt_.step(mesh_.kept(), mesh_.points(), t.x, memory_);
    cells_changed_ = changes_cells(guide_.move_all(std::span<const Coordinates<3>>(t.x)));
    read_ = false;
    t.way = {last_.mean_displacement, last_.max_displacement};
    t.seconds = watch.seconds();
    return true;
}

void Guided_nodt::read_mesh() {
    if (!read_) mesh_.read(guide_, cells_changed_, *scene_.domain, threads_);
    read_ = true;
}

Mesh_step Guided_nodt::quality() {
    read_mesh();
    return measured(mesh_, last_);
}

Picture Guided_nodt::picture(const Moving& dt, std::string caption) const {
    Mesh_3 mesh;
    mesh.read(dt, true, *scene_.domain, threads_);
    return mesh.cut(std::move(caption), cut_);
}

}  // namespace annulus::inline v1::cli
