// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/degeneracy.h>

#include <annulus/error.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/measure/degeneracy.h>
#include <annulus/measure/periodic_degeneracy.h>
#include <annulus/moving_mesh.h>
#include <annulus/periodic_mesh.h>

namespace annulus::inline v1 {

namespace {

template <int d>
Degeneracy of_mesh(const Moving_mesh<d>& mesh, const Degeneracy_options<d>& options) {
    if (mesh.dimension() < d) throw Error(Error_code::too_few, "the points do not span the space");
    return degeneracy(mesh.mesh().table(), mesh.delaunay_positions(), options);
}

template <int d>
Degeneracy of_mesh(const Periodic_mesh<d>& mesh, const Degeneracy_options<d>& options) {
    if (mesh.number_of_vertices() == 0) throw Error(Error_code::too_few, "there are no points");
    return periodic_degeneracy(mesh.audit_input(), mesh.grid(), options);
}

}  // namespace

Degeneracy degeneracy(const Moving_mesh<2>& mesh, const Degeneracy_options<2>& options) {
    return of_mesh(mesh, options);
}
Degeneracy degeneracy(const Moving_mesh<3>& mesh, const Degeneracy_options<3>& options) {
    return of_mesh(mesh, options);
}
Degeneracy degeneracy(const Periodic_mesh<2>& mesh, const Degeneracy_options<2>& options) {
    return of_mesh(mesh, options);
}
Degeneracy degeneracy(const Periodic_mesh<3>& mesh, const Degeneracy_options<3>& options) {
    return of_mesh(mesh, options);
}

}  // namespace annulus::inline v1
