// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/moving_mesh.h>

#include <annulus/arithmetic/environment.h>
#include <annulus/engine/engine.h>
#include <annulus/error.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/kernel/kept_lists.h>
#include <annulus/measure/voronoi_kept_diagram.h>
#include <annulus/measure/voronoi_kept_gradient.h>
#include <annulus/published/strategies.h>

#include <cstring>
#include <limits>
#include <mutex>

namespace annulus::inline v1 {

template <int d>
struct Moving_mesh<d>::Parts {
    explicit Parts(const Options& options) : engine(mesh, options, make_strategy<d>(mesh, options)) {}
    /// The engine, for a call that may change the mesh.
    Engine<d>& changing() {
        lists.note_call();
        return engine;
    }
    /// The positions of the lists.
    [[nodiscard]] std::span<const Coordinates<d>> listed() const {
        return engine.delaunay_positions().first(engine.index_bound());
    }

    Delaunay_mesh<d> mesh;
    Engine<d> engine;
    Kept_lists<d> lists{mesh};
    std::mutex measuring;
    std::unique_ptr<Kept_voronoi_volumes<d>> volumes;  // null until the first call of voronoi_volumes()
    std::unique_ptr<Kept_voronoi_diagram<d>> diagram;  // null until the first call of voronoi(mesh)
};

namespace {

template <int d>
std::vector<Coordinates<d>> points_of(std::span<const double> coordinates) {
    if (coordinates.size() % d != 0)
        throw Error(Error_code::wrong_size,
                    std::to_string(coordinates.size()) + " numbers are not " + std::to_string(d) + " a point");
    std::vector<Coordinates<d>> points(coordinates.size() / d);
    if (!points.empty()) std::memcpy(points.data(), coordinates.data(), coordinates.size_bytes());
    return points;
}

void hand_over(Move_result& done, Move_result* report) {
    if (report != nullptr) *report = std::move(done);
}

}  // namespace

template <int d>
Moving_mesh<d>::Moving_mesh(std::span<const Point> points, const Options& options)
    : parts_(std::make_unique<Parts>(options)) {
    parts_->changing().build(points);
}
template <int d>
Moving_mesh<d>::Moving_mesh(std::span<const double> coordinates, const Options& options)
    : Moving_mesh(std::span<const Point>(points_of<d>(coordinates)), options) {}
template <int d>
Moving_mesh<d>::~Moving_mesh() = default;
template <int d>
Moving_mesh<d>::Moving_mesh(Moving_mesh&&) noexcept = default;
template <int d>
Moving_mesh<d>& Moving_mesh<d>::operator=(Moving_mesh&&) noexcept = default;

template <int d>
Moving_mesh<d>::Moving_mesh(const Moving_mesh& other) : parts_(std::make_unique<Parts>(other.options())) {
    parts_->changing().build_copy(other.parts_->engine);
}
template <int d>
Moving_mesh<d>& Moving_mesh<d>::operator=(const Moving_mesh& other) {
    return *this = Moving_mesh(other);
}

template <int d>
Move_result Moving_mesh<d>::move(Index i, const Point& p) {
    return parts_->changing().move(i, p);
}
template <int d>
Move_result Moving_mesh<d>::move(std::span<const Index> indices, std::span<const Point> points) {
    return parts_->changing().move(indices, points);
}
template <int d>
Move_result Moving_mesh<d>::move_all(std::span<const Point> points) {
    return parts_->changing().move_all(points);
}
template <int d>
Index Moving_mesh<d>::insert(const Point& p, Move_result* report) {
    Move_result done;
    const Index i = parts_->changing().insert(p, done);
    hand_over(done, report);
    return i;
}
template <int d>
void Moving_mesh<d>::remove(Index i, Move_result* report) {
    parts_->engine.require_vertex(i);
    Move_result done;
    parts_->changing().remove(i, done);
    hand_over(done, report);
}
template <int d>
Move_result Moving_mesh<d>::recompute_tolerances() {
    return parts_->changing().recompute_tolerances();
}

template <int d>
std::size_t Moving_mesh<d>::number_of_vertices() const {
    return parts_->mesh.vertices();
}
template <int d>
int Moving_mesh<d>::dimension() const {
    return parts_->mesh.dimension();
}
template <int d>
std::size_t Moving_mesh<d>::index_bound() const {
    return parts_->engine.index_bound();
}
template <int d>
bool Moving_mesh<d>::is_vertex(Index i) const {
    return parts_->engine.is_vertex(i);
}
template <int d>
std::span<const Index> Moving_mesh<d>::vertex_of_input() const {
    return parts_->engine.vertex_of_input();
}
template <int d>
auto Moving_mesh<d>::points() const -> std::span<const Point> {
    return parts_->engine.positions();
}
template <int d>
auto Moving_mesh<d>::delaunay_positions() const -> std::span<const Point> {
    return parts_->engine.delaunay_positions();
}

template <int d>
Mesh_cells<d> Moving_mesh<d>::cells() const {
    return parts_->engine.cells();
}

template <int d>
auto Moving_mesh<d>::cell_lists() const -> std::shared_ptr<const Cell_lists<d>> {
    return parts_->lists.cells(parts_->listed());
}
template <int d>
std::span<const Index> Moving_mesh<d>::neighbors(Index i) const {
    parts_->engine.require_vertex(i);
    return parts_->lists.neighbours(parts_->listed())->of(i);
}
template <int d>
std::shared_ptr<const Vertex_neighbours> Moving_mesh<d>::vertex_neighbors() const {
    return parts_->lists.neighbours(parts_->listed());
}
template <int d>
auto Moving_mesh<d>::convex_hull() const -> std::vector<std::array<Index, static_cast<std::size_t>(d)>> {
    return *parts_->lists.hull(parts_->listed());
}
template <int d>
Index Moving_mesh<d>::find_cell(const Point& p) const {
    return find_cells(std::span(&p, 1)).front();
}
template <int d>
std::vector<Index> Moving_mesh<d>::find_cells(std::span<const Point> points) const {
    require_sound_environment();
    const auto lists = cell_lists();
    std::vector<Index> found(points.size());
    annulus::find_cells<d>(*lists, this->points(), points, found);
    return found;
}

template <int d>
std::vector<double> Moving_mesh<d>::tolerances() const {
    std::vector<double> out(index_bound(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < out.size(); ++i)
        if (is_vertex(static_cast<Index>(i))) out[i] = parts_->engine.tolerance(static_cast<Index>(i));
    return out;
}
template <int d>
double Moving_mesh<d>::tolerance(Index i) const {
    parts_->engine.require_vertex(i);
    return parts_->engine.tolerance(i);
}
template <int d>
auto Moving_mesh<d>::fixed_position(Index i) const -> Point {
    parts_->engine.require_vertex(i);
    return parts_->engine.fixed_position(i);
}
template <int d>
double Moving_mesh<d>::displacement(Index i) const {
    parts_->engine.require_vertex(i);
    return parts_->engine.displacement(i);
}
template <int d>
double Moving_mesh<d>::theta(Index i) const {
    parts_->engine.require_vertex(i);
    return parts_->mesh.theta(parts_->engine.delaunay_positions(), i);
}
template <int d>
Measures Moving_mesh<d>::measure() const {
    return parts_->mesh.measure(parts_->engine.delaunay_positions());
}
template <int d>
std::vector<double> Moving_mesh<d>::voronoi_volumes() const {
    const std::lock_guard hold(parts_->measuring);
    if (!parts_->volumes) parts_->volumes = std::make_unique<Kept_voronoi_volumes<d>>(parts_->mesh);
    const auto volumes = parts_->volumes->update(parts_->engine.positions());
    return {volumes.begin(), volumes.end()};
}
template <int d>
auto Moving_mesh<d>::voronoi_gradient(std::span<const double> weights) const -> std::vector<Point> {
    if constexpr (d == 2)
        if (dimension() == d) {
            const std::lock_guard hold(parts_->measuring);
            if (!parts_->volumes) parts_->volumes = std::make_unique<Kept_voronoi_volumes<d>>(parts_->mesh);
            return edge_gradient(*parts_->volumes, points(), weights);
        }
    return annulus::voronoi_gradient<d>(points(), cell_lists()->cells, weights);
}
template <int d>
Voronoi_diagram<d> Moving_mesh<d>::voronoi_diagram() const {
    const std::lock_guard hold(parts_->measuring);
    if (!parts_->diagram) parts_->diagram = std::make_unique<Kept_voronoi_diagram<d>>();
    return parts_->diagram->update(parts_->mesh.table(), points(), cell_lists());
}
template <int d>
Audit_input<d> Moving_mesh<d>::audit_input() const {
    return parts_->engine.audit_input();
}
template <int d>
const Delaunay_mesh<d>& Moving_mesh<d>::mesh() const {
    return parts_->mesh;
}
template <int d>
Delaunay_mesh<d>& Moving_mesh<d>::changeable_mesh() {
    return parts_->mesh;
}
template <int d>
const Options& Moving_mesh<d>::options() const {
    return parts_->engine.options();
}
template <int d>
Strategy Moving_mesh<d>::strategy() const {
    return parts_->engine.strategy();
}

template class Moving_mesh<2>;
template class Moving_mesh<3>;

}  // namespace annulus::inline v1
