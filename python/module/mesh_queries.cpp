// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh: queries.
#include <module/mesh.h>

#include <module/errors.h>
#include <module/mesh_locked.h>

#include <limits>

namespace annulus::python {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

template <int d>
auto Mesh<d>::kept_points() -> std::shared_ptr<const std::vector<Point>> {
    if (!points_) {
        const auto x = mesh_.points();
        auto copy = std::make_shared<std::vector<Point>>(x.begin(), x.end());
        for (const Index i : free_indices_) (*copy)[static_cast<std::size_t>(i)].fill(nan);
        points_ = std::move(copy);
    }
    return points_;
}

template <int d>
py::array Mesh<d>::points() {
    const auto points = locked([this] { return kept_points(); });
    return view_rows(*points, points);
}

template <int d>
std::pair<py::array, std::vector<Index>> Mesh<d>::state() {
    auto [points, free_indices] = locked([this] { return std::pair(kept_points(), free_indices_); });
    return {view_rows(*points, points), std::move(free_indices)};
}

template <int d>
py::array Mesh<d>::is_vertex() const {
    auto flags = locked([this] {
        auto out = std::make_shared<std::vector<char>>(mesh_.index_bound());
        for (std::size_t i = 0; i < out->size(); ++i) (*out)[i] = mesh_.is_vertex(static_cast<Index>(i)) ? 1 : 0;
        return out;
    });
    // NumPy's bool is a byte that is 0 or 1.
    static_assert(sizeof(bool) == 1);
    const auto n = static_cast<py::ssize_t>(flags->size());
    const auto* const data = reinterpret_cast<const bool*>(flags->data());
    return view<bool>(data, {n}, std::shared_ptr<const std::vector<char>>(std::move(flags)));
}

template <int d>
std::vector<Index> Mesh<d>::vertex_of_input() const {
    return locked(
        [this] { return std::vector<Index>(mesh_.vertex_of_input().begin(), mesh_.vertex_of_input().end()); });
}

template <int d>
std::shared_ptr<const Cell_lists<d>> Mesh<d>::cells() const {
    return locked([this] { return mesh_.cell_lists(); });
}

template <int d>
std::shared_ptr<const Vertex_neighbours> Mesh<d>::neighbours() const {
    return locked([this] { return mesh_.vertex_neighbors(); });
}

template <int d>
auto Mesh<d>::hull() const -> std::vector<std::array<Index, static_cast<std::size_t>(d)>> {
    return locked([this] { return mesh_.convex_hull(); });
}

template <int d>
std::vector<Index> Mesh<d>::find(const Points_in<d>& points) const {
    return locked([&] { return mesh_.find_cells(points.span()); });
}

template <int d>
template <class Value>
std::vector<double> Mesh<d>::by_vertex(Value value) const {
    std::vector<double> out(mesh_.index_bound(), nan);
    for (std::size_t i = 0; i < out.size(); ++i)
        if (const auto v = static_cast<Index>(i); mesh_.is_vertex(v)) out[i] = value(v);
    return out;
}

template <int d>
std::vector<double> Mesh<d>::tolerances() const {
    return locked([this] { return by_vertex([this](Index v) { return mesh_.tolerance(v); }); });
}
template <int d>
std::vector<double> Mesh<d>::thetas() const {
    return locked([this] { return by_vertex([this](Index v) { return mesh_.theta(v); }); });
}
template <int d>
std::vector<double> Mesh<d>::displacements() const {
    return locked([this] { return by_vertex([this](Index v) { return mesh_.displacement(v); }); });
}

template <int d>
std::vector<double> Mesh<d>::voronoi_volumes() {
    return locked([this] { return mesh_.voronoi_volumes(); });
}

template <int d>
Audit_result Mesh<d>::audit() const {
    const Without_gil without_gil;
    Audit_input<d> input;
    {
        const std::lock_guard hold(lock_);
        input = mesh_.audit_input();
    }
    // Without the lock, because a signal handler may call this mesh.
    input.between = [calls = 0U]() mutable {
        if (++calls % 16 == 0) look_for_signals();
    };
    return annulus::audit(input);
}
template <int d>
std::pair<std::size_t, Strategy> Mesh<d>::summary() const {
    return locked([this] { return std::pair(mesh_.number_of_vertices(), mesh_.strategy()); });
}
template <int d>
std::size_t Mesh<d>::vertices() const {
    return locked([this] { return mesh_.number_of_vertices(); });
}
template <int d>
std::size_t Mesh<d>::index_bound() const {
    return locked([this] { return mesh_.index_bound(); });
}
template <int d>
int Mesh<d>::dimension() const {
    return locked([this] { return mesh_.dimension(); });
}
template <int d>
Strategy Mesh<d>::strategy() const {
    return locked([this] { return mesh_.strategy(); });
}

#define ANNULUS_INSTANTIATE(d)                                                       \
    template py::array Mesh<d>::points();                                            \
    template auto Mesh<d>::kept_points()->std::shared_ptr<const std::vector<Point>>; \
    template std::pair<py::array, std::vector<Index>> Mesh<d>::state();              \
    template std::pair<std::size_t, Strategy> Mesh<d>::summary() const;              \
    template py::array Mesh<d>::is_vertex() const;                                   \
    template std::vector<Index> Mesh<d>::vertex_of_input() const;                    \
    template std::shared_ptr<const Cell_lists<d>> Mesh<d>::cells() const;            \
    template std::shared_ptr<const Vertex_neighbours> Mesh<d>::neighbours() const;   \
    template auto Mesh<d>::hull() const->std::vector<std::array<Index, d>>;          \
    template std::vector<Index> Mesh<d>::find(const Points_in<d>&) const;            \
    template std::vector<double> Mesh<d>::tolerances() const;                        \
    template std::vector<double> Mesh<d>::thetas() const;                            \
    template std::vector<double> Mesh<d>::displacements() const;                     \
    template std::vector<double> Mesh<d>::voronoi_volumes();                         \
    template Audit_result Mesh<d>::audit() const;                                    \
    template std::size_t Mesh<d>::vertices() const;                                  \
    template std::size_t Mesh<d>::index_bound() const;                               \
    template int Mesh<d>::dimension() const;                                         \
    template Strategy Mesh<d>::strategy() const;
ANNULUS_INSTANTIATE(2)
ANNULUS_INSTANTIATE(3)
#undef ANNULUS_INSTANTIATE

}  // namespace annulus::python
