// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/internal/mesh_access.h>

#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/moving_mesh.h>

namespace annulus::inline v1 {

template <int d>
Mesh_access<d>::Mesh_access(Moving_mesh<d>& mesh) : mesh_(&mesh.changeable_mesh()) {}

template <int d>
int Mesh_access<d>::dimension() const {
    return mesh_->dimension();
}
template <int d>
std::size_t Mesh_access<d>::vertices() const {
    return mesh_->vertices();
}
template <int d>
bool Mesh_access<d>::has(Index v) const {
    return mesh_->has(v);
}
template <int d>
Flat_cells Mesh_access<d>::flat_cells(std::span<const Coordinates<d>> positions) const {
    return mesh_->flat_cells(positions);
}
template <int d>
Table_cells<d> Mesh_access<d>::cells() const {
    return {mesh_->table().vertex_array(), mesh_->table().twin_array()};
}
template <int d>
void Mesh_access<d>::set_dirty_cells(Dirty_cells& log) noexcept {
    mesh_->table().set_dirty_cells(log);
}

template class Mesh_access<2>;
template class Mesh_access<3>;

}  // namespace annulus::inline v1
