// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/viewed_mesh.h>

#include <annulus/kernel/delaunay_mesh.h>
#include <support/viewed.h>

namespace annulus::testing {

namespace {

// In the order in which CGAL lists facets.
std::vector<Bicell_indices<2>> bicells_of(const Moving_delaunay_2::Triangulation& tr) {
    std::vector<Bicell_indices<2>> all;
    if (tr.dimension() != 2) return all;
    for (auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e) {
        const auto [f, i] = *e;
        if (tr.is_infinite(f) || tr.is_infinite(f->neighbor(i))) continue;
        all.push_back({f->vertex(tr.ccw(i))->index(), f->vertex(tr.cw(i))->index(),
                       tr.tds().mirror_vertex(f, i)->index(), f->vertex(i)->index()});
    }
    return all;
}
std::vector<Bicell_indices<3>> bicells_of(const Moving_delaunay_3::Triangulation& tr) {
    std::vector<Bicell_indices<3>> all;
    if (tr.dimension() != 3) return all;
    for (auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f) {
        const auto c = f->first;
        const int i = f->second;
        if (tr.is_infinite(c) || tr.is_infinite(c->neighbor(i))) continue;
        all.push_back({c->vertex((i + 1) & 3)->index(), c->vertex((i + 2) & 3)->index(),
                       c->vertex((i + 3) & 3)->index(), tr.mirror_vertex(c, i)->index(), c->vertex(i)->index()});
    }
    return all;
}

}  // namespace

template <int d>
Viewed_mesh<d>::Viewed_mesh(const Options& options)
    : viewed_(std::make_unique<Viewed<d>>(typename oracle::Space<d>::Moving(options))) {}
template <int d>
Viewed_mesh<d>::Viewed_mesh(std::span<const Point> points, const Options& options)
    : viewed_(std::make_unique<Viewed<d>>(typename oracle::Space<d>::Moving(points, options))) {}
template <int d>
Viewed_mesh<d>::Viewed_mesh(std::unique_ptr<Viewed<d>> viewed) : viewed_(std::move(viewed)) {}
template <int d>
Viewed_mesh<d>::~Viewed_mesh() = default;
template <int d>
Viewed_mesh<d>::Viewed_mesh(Viewed_mesh&&) noexcept = default;
template <int d>
Viewed_mesh<d>& Viewed_mesh<d>::operator=(Viewed_mesh&&) noexcept = default;

template <int d>
Move_result Viewed_mesh<d>::move(Index i, const Point& p) {
    return viewed_->dt.move(i, p);
}
template <int d>
Move_result Viewed_mesh<d>::move(std::span<const Index> indices, std::span<const Point> points) {
    return viewed_->dt.move(indices, points);
}
template <int d>
Move_result Viewed_mesh<d>::move_all(std::span<const Point> points) {
    return viewed_->dt.move_all(points);
}
template <int d>
Index Viewed_mesh<d>::insert(const Point& p, Move_result* report) {
    return viewed_->dt.index(viewed_->dt.insert(oracle::Space<d>::point(p), report));
}
template <int d>
void Viewed_mesh<d>::remove(Index i, Move_result* report) {
    viewed_->dt.remove(viewed_->vertex(i), report);
}
template <int d>
Move_result Viewed_mesh<d>::recompute_tolerances() {
    return viewed_->dt.recompute_tolerances();
}

template <int d>
std::size_t Viewed_mesh<d>::number_of_vertices() const {
    return viewed_->dt.number_of_vertices();
}
template <int d>
std::size_t Viewed_mesh<d>::index_bound() const {
    return viewed_->dt.index_bound();
}
template <int d>
bool Viewed_mesh<d>::is_vertex(Index i) const {
    return viewed_->vertex(i) != typename oracle::Space<d>::Moving::Vertex_handle();
}
template <int d>
std::span<const Index> Viewed_mesh<d>::vertex_of_input() const {
    return viewed_->dt.vertex_of_input();
}
template <int d>
std::span<const Coordinates<d>> Viewed_mesh<d>::points() const {
    return viewed_->dt.positions();
}
template <int d>
Mesh_cells<d> Viewed_mesh<d>::cells() const {
    return viewed_->dt.cells();
}
template <int d>
double Viewed_mesh<d>::tolerance(Index i) const {
    return viewed_->dt.tolerance(viewed_->vertex(i));
}
template <int d>
Coordinates<d> Viewed_mesh<d>::fixed_position(Index i) const {
    return oracle::Space<d>::coordinates(viewed_->dt.fixed_position(viewed_->vertex(i)));
}
template <int d>
double Viewed_mesh<d>::displacement(Index i) const {
    return viewed_->dt.displacement(viewed_->vertex(i));
}
template <int d>
double Viewed_mesh<d>::theta(Index i) const {
    return viewed_->dt.theta(viewed_->vertex(i));
}
template <int d>
Measures Viewed_mesh<d>::measure() const {
    return viewed_->dt.measure();
}
template <int d>
Audit_result Viewed_mesh<d>::audit() const {
    return viewed_->dt.audit();
}
template <int d>
Audit_input<d> Viewed_mesh<d>::audit_input() const {
    return viewed_->dt.audit_input();
}
template <int d>
const Delaunay_mesh<d>& Viewed_mesh<d>::mesh() const {
    return viewed_->dt.mesh();
}
template <int d>
const Options& Viewed_mesh<d>::options() const {
    return viewed_->dt.options();
}
template <int d>
Strategy Viewed_mesh<d>::strategy() const {
    return viewed_->dt.strategy();
}

template <int d>
oracle::Cells_of<d> Viewed_mesh<d>::view_cells() const {
    return oracle::cells_of(viewed_->dt.triangulation());
}
template <int d>
std::vector<Bicell_indices<d>> Viewed_mesh<d>::view_bicells() const {
    return bicells_of(viewed_->dt.triangulation());
}
template <int d>
int Viewed_mesh<d>::view_dimension() const {
    return viewed_->dt.triangulation().dimension();
}
template <int d>
bool Viewed_mesh<d>::view_is_valid() const {
    return viewed_->dt.triangulation().tds().is_valid();
}
template <int d>
Coordinates<d> Viewed_mesh<d>::view_point(Index i) const {
    return oracle::Space<d>::coordinates(viewed_->vertex(i)->point());
}
template <int d>
std::vector<Coordinates<d>> Viewed_mesh<d>::view_points() const {
    const auto& tr = viewed_->dt.triangulation();
    std::vector<Coordinates<d>> all;
    for (auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
        all.push_back(oracle::Space<d>::coordinates(v->point()));
    return all;
}
template <int d>
Coordinates<d> Viewed_mesh<d>::position(Index i) const {
    return oracle::Space<d>::coordinates(viewed_->dt.position(viewed_->vertex(i)));
}
template <int d>
const void* Viewed_mesh<d>::handle(Index i) const {
    const auto v = viewed_->vertex(i);
    return v == typename oracle::Space<d>::Moving::Vertex_handle() ? nullptr : static_cast<const void*>(&*v);
}
template <int d>
Index Viewed_mesh<d>::handle_index(Index i) const {
    return viewed_->dt.index(viewed_->vertex(i));
}

template class Viewed_mesh<2>;
template class Viewed_mesh<3>;

}  // namespace annulus::testing
