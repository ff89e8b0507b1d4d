// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/c/any_mesh.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/moving_mesh.h>
#include <annulus/voronoi.h>

#include <algorithm>
#include <limits>

namespace annulus::inline v1::c {

namespace {

/// Views interleaved numbers as points. A point is an array of d doubles and nothing else.
template <int d>
std::span<const Coordinates<d>> as_points(const double* x, std::size_t points) {
    static_assert(sizeof(Coordinates<d>) == d * sizeof(double) && alignof(Coordinates<d>) == alignof(double));
    return {reinterpret_cast<const Coordinates<d>*>(x), points};
}

template <int d>
class Mesh_of final : public Any_mesh {
  public:
    Mesh_of(const double* x, std::size_t points, const Options& options) : mesh_(as_points<d>(x, points), options) {}

    int dimension() const override { return d; }
    int affine_dimension() const override { return mesh_.dimension(); }
    std::size_t vertices() const override { return mesh_.number_of_vertices(); }
    std::size_t index_bound() const override { return mesh_.index_bound(); }
    bool is_vertex(Index i) const override { return mesh_.is_vertex(i); }
    Strategy strategy() const override { return mesh_.strategy(); }
    const Options& options() const override { return mesh_.options(); }
    std::span<const Index> vertex_of_input() const override { return mesh_.vertex_of_input(); }

    Move_result move_all(const double* x, std::size_t points) override {
        return mesh_.move_all(as_points<d>(x, points));
    }
    Move_result move(std::span<const Index> indices, const double* x) override {
        return mesh_.move(indices, as_points<d>(x, indices.size()));
    }
    void require_positions(const double* x, std::size_t points) const override {
        require_in_domain(as_points<d>(x, points), "point");
    }
    Index insert(const double* x, Move_result& report) override { return mesh_.insert(as_points<d>(x, 1)[0], &report); }
    void remove(Index i, Move_result& report) override { mesh_.remove(i, &report); }
    Move_result recompute_tolerances() override { return mesh_.recompute_tolerances(); }

    void points(double* x) const override {
        const auto now = mesh_.points();
        for (std::size_t i = 0; i < now.size(); ++i)
            for (std::size_t k = 0; k < d; ++k)
                x[i * d + k] = is_vertex(static_cast<Index>(i)) ? now[i][k] : std::numeric_limits<double>::quiet_NaN();
    }
    void tolerances(double* lengths) const override {
        const std::vector<double> t = mesh_.tolerances();
        std::copy(t.begin(), t.end(), lengths);
    }
    void displacements(double* lengths) const override {
        for (std::size_t i = 0; i < index_bound(); ++i)
            lengths[i] = is_vertex(static_cast<Index>(i)) ? mesh_.displacement(static_cast<Index>(i))
                                                          : std::numeric_limits<double>::quiet_NaN();
    }
    void voronoi(double* volumes, Index* neighbour_counts) const override {
        std::vector<double> v;
        std::vector<Index> n;
        if (volumes != nullptr) v = mesh_.voronoi_volumes();
        if (neighbour_counts != nullptr) n = voronoi_neighbour_counts<d>(index_bound(), mesh_.cell_lists()->cells);
        std::copy(v.begin(), v.end(), volumes);
        std::copy(n.begin(), n.end(), neighbour_counts);
    }
    void voronoi_cells(const double* box, double* volumes, double* centroids) const override {
        Voronoi_clip<d> clip;
        if (box != nullptr) {
            std::copy_n(box, d, clip.lower.begin());
            std::copy_n(box + d, d, clip.upper.begin());
        }
        const Voronoi_diagram<d> v = box != nullptr ? annulus::voronoi(mesh_, clip) : annulus::voronoi(mesh_);
        if (volumes != nullptr) std::copy(v.volume.begin(), v.volume.end(), volumes);
        if (centroids != nullptr) put(v.cell_centroid, centroids);
    }
    void voronoi_gradient(const double* weights, double* gradient) const override {
        put(mesh_.voronoi_gradient({weights, index_bound()}), gradient);
    }
    void voronoi_facets(double* measures, double* centroids) const override {
        const Voronoi_diagram<d> v = annulus::voronoi(mesh_);
        const std::vector<Index>& begin = mesh_.vertex_neighbors()->begin;
        std::vector<std::size_t> next(begin.begin(), begin.end());
        const auto write = [&](Index vertex, std::size_t k) {
            const std::size_t to = next[static_cast<std::size_t>(vertex)]++;
            if (measures != nullptr) measures[to] = v.measure[k];
            if (centroids != nullptr) std::copy(v.centroid[k].begin(), v.centroid[k].end(), centroids + d * to);
        };
        // Pairs are ascending: first the smaller neighbours of each vertex, then the larger ones.
        for (std::size_t k = 0; k < v.pair.size(); ++k) write(v.pair[k][1], k);
        for (std::size_t k = 0; k < v.pair.size(); ++k) write(v.pair[k][0], k);
    }
    Cells cells() const override {
        const auto lists = mesh_.cell_lists();
        Cells out{lists, nullptr, nullptr, lists->cells.vertices.size()};
        if (out.count > 0) {
            out.vertices = lists->cells.vertices.front().data();
            out.neighbours = lists->cells.neighbours.front().data();
        }
        return out;
    }
    std::span<const Index> neighbours(Index v) const override { return mesh_.neighbors(v); }
    std::shared_ptr<const Vertex_neighbours> neighbour_lists() const override { return mesh_.vertex_neighbors(); }
    std::vector<Index> hull() const override {
        std::vector<Index> vertices;
        for (const auto& facet : mesh_.convex_hull()) vertices.insert(vertices.end(), facet.begin(), facet.end());
        return vertices;
    }
    void find_cells(const double* x, std::size_t points, Index* cells) const override {
        const std::vector<Index> found = mesh_.find_cells(as_points<d>(x, points));
        std::copy(found.begin(), found.end(), cells);
    }
    Audit_result audit() const override { return mesh_.audit(); }

  private:
    static void put(const std::vector<Coordinates<d>>& from, double* to) {
        for (const auto& x : from) to = std::copy(x.begin(), x.end(), to);
    }

    Moving_mesh<d> mesh_;
};

}  // namespace

std::unique_ptr<Any_mesh> make_mesh(int dimension, const double* x, std::size_t points, const Options& options) {
    if (dimension == 2) return std::make_unique<Mesh_of<2>>(x, points, options);
    return std::make_unique<Mesh_of<3>>(x, points, options);
}

}  // namespace annulus::inline v1::c
