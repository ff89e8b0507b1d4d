// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/error.h>
#include <annulus/internal/originals.h>
#include <annulus/internal/view.h>
#include <annulus/moving_mesh.h>

#include <iterator>
#include <memory>
#include <type_traits>

namespace annulus::inline v1 {

/// A Delaunay triangulation that is kept right while its vertices move.
///
/// Dt is CGAL::Delaunay_triangulation_2 or _3 over CGAL's kernel Epick
/// (Exact_predicates_inexact_constructions_kernel), with any triangulation data structure, so that vertices and cells
/// may have bases of the caller's, whose default constructors must not throw. Everything here is the same in every
/// dimension. Data at vertices live as long as their vertex. Data at cells have their defaults in every cell that a
/// call has written; a rebuild writes all. Positions are in the caller's unit of length. With
/// Tolerance_kind::certified the triangulation is Delaunay at the positions of its vertices after every call; this is
/// proved. Not thread-safe; const members may run concurrently.
///
/// Vertices have an index in input order and a CGAL handle; no move, whatever the strategy, invalidates either.
/// Removing a vertex leaves its index free; the next insertion takes the index freed last.
///
/// The strategies work on arrays. CGAL's object is a copy of them. triangulation(), vertex() and audit() first bring
/// it up to date for what has changed since; a program that never calls them pays nothing for it. So call
/// triangulation() after a change, also before reading the points of handles: an older reference shows the state of
/// the last such call.
///
/// Errors are annulus::Error; the object is then as it was before the call, except that after a duplicate point
/// tolerances may have been recomputed and be measured from other fixed positions. Every function that takes a handle
/// throws unknown_vertex for a null handle, for the vertex at infinity, and for a vertex of another triangulation.
/// The handle of a removed vertex dangles and must not be used. too_large: the triangulation would have, or had in
/// between, more cells or vertices than indices can name (limits.h).
///
/// When memory runs out (std::bad_alloc), positions, indices and handles are as they were (for `remove` see its
/// comment), and the triangulation is rebuilt at these positions before the exception is passed on. If even that
/// fails, there are no cells (an audit says so) until a later call that changes something, recompute_tolerances() for
/// example, has rebuilt them. GMP's allocation functions abort the process when they get no memory, unless the
/// program sets others (mp_set_memory_functions); so may CGAL's Mpzf, in predicates of coordinates that are hundreds
/// of bits apart.
template <class Dt>
class Moving_delaunay {
    using View = Cgal_view<Cgal_traits<Dt>>;

  public:
    static constexpr int dimension_of_space = View::dimension_of_space;
    static constexpr int d = dimension_of_space;
    using Triangulation = Dt;  ///< CGAL's
    using Point = typename View::Point;
    using Vertex_handle = typename View::Vertex_handle;

    explicit Moving_delaunay(const Options& options = {})
        : Moving_delaunay(std::span<const Coordinates<d>>{}, options) {}

    /// Builds from CGAL points; vertex(i) is the i-th. O(n log n). Throws not_finite, out_of_domain, duplicate_point
    /// (unless options.merge_duplicates), environment.
    template <std::input_iterator It>
    requires std::is_convertible_v<typename std::iterator_traits<It>::value_type, Point> Moving_delaunay(
        It first, It last, const Options& options = {})
        : Moving_delaunay(std::span<const Coordinates<d>>(coordinates_of<View>(first, last)), options) {}
    /// The same from plain coordinates. Throws too_large as well.
    explicit Moving_delaunay(std::span<const Coordinates<d>> points, const Options& options = {})
        : mesh_(points, options), view_(std::make_unique<View>(Mesh_access<d>(mesh_), mesh_.points())) {}
    /// The same from pairs of a point and the info of its vertex, as CGAL's insert() takes them. Where duplicate points
    /// are merged, the info of the first one counts.
    template <std::input_iterator It>
    requires requires(std::iter_value_t<It> pair, typename Triangulation::Vertex& v) {
        Point(pair.first);
        v.info() = pair.second;
    }
    Moving_delaunay(It first, It last, const Options& options = {})
        : Moving_delaunay(Pairs<std::iter_value_t<It>>{std::vector<std::iter_value_t<It>>(first, last)}, options) {}
    /// From a triangulation of CGAL's, of any type: vertex(i) is the i-th of its finite vertices. Of a triangulation of
    /// this type, vertices are copied with all their data; of another one their info(), if both have it. O(n log n).
    template <Similar_triangulation<Dt> Other>
    explicit Moving_delaunay(const Other& other, const Options& options = {})
        : Moving_delaunay(Originals<Other>(other), options) {}
    /// A copy with the same indices and data at vertices, and handles of its own. It is built from the positions, so
    /// that it has the same cells under other numbers, and recomputes its tolerances. O(n log n). Throws what a
    /// construction throws: duplicate_point where tolerances that are not certified have let two positions coincide.
    Moving_delaunay(const Moving_delaunay& o)
        : mesh_(o.mesh_), view_(std::make_unique<View>(Mesh_access<d>(mesh_), mesh_.points(), [&o](Index v) {
              return o.view_->handle(v);
          })) {}
    Moving_delaunay& operator=(const Moving_delaunay& o) { return *this = Moving_delaunay(o); }

    /// Handles, and pointers to CGAL's object, stay valid and belong to the object that was moved to. The object that
    /// was moved from can only be destroyed or assigned to. O(1).
    Moving_delaunay(Moving_delaunay&&) noexcept = default;
    Moving_delaunay& operator=(Moving_delaunay&&) noexcept = default;

    /// Moves one vertex. Expected O(degree) for a short way. Throws not_finite, out_of_domain, duplicate_point,
    /// unknown_vertex.
    Move_result move(Vertex_handle v, const Point& p) { return move(index(v), View::coordinates(p)); }
    Move_result move(Index i, const Coordinates<d>& p) {
        invalidate({&i, 1});
        return mesh_.move(i, p);
    }
    /// As CGAL's: moves one vertex and returns it, unless another vertex is at p; then returns that one, and nothing
    /// has changed. Throws what move throws but duplicate_point.
    Vertex_handle move_if_no_collision(Vertex_handle v, const Point& p) {
        const Index i = index(v);
        try {
            (void)move(i, View::coordinates(p));
        } catch (const Error& e) {
            if (e.code() != Error_code::duplicate_point) throw;
            for (const std::int64_t other : e.vertices())
                if (other != i) return view_->handle(static_cast<Index>(other));
            throw;
        }
        return v;
    }
    /// Moves some vertices: indices[k] to points[k], all at once (a vertex may go where another one was). If an index
    /// is named twice, its last point counts. Under a strategy that repairs the mesh, at most one vertex in 64 costs
    /// as much as single moves; otherwise the call costs as much as move_all. Throws wrong_size, and what move
    /// throws.
    Move_result move(std::span<const Index> indices, std::span<const Coordinates<d>> points) {
        invalidate(indices);
        return mesh_.move(indices, points);
    }
    template <class Range>
    requires std::is_convertible_v<decltype(*std::begin(std::declval<const Range&>())), Point> Move_result
    move(std::span<const Index> indices, const Range& points) {
        return move(indices,
                    std::span<const Coordinates<d>>(coordinates_of<View>(std::begin(points), std::end(points))));
    }
    /// The same for a range of pairs (vertex handle, point).
    template <std::input_iterator It>
    requires requires(It pair) {
        Point(pair->second);
        Vertex_handle(pair->first);
    }
    Move_result move(It first, It last) {
        std::vector<Index> indices;
        std::vector<Coordinates<d>> points;
        for (; first != last; ++first) {
            indices.push_back(index(first->first));
            points.push_back(View::coordinates(first->second));
        }
        return move(indices, points);
    }

    /// Moves every vertex: points[i] is the new position of vertex i; points at free indices are ignored. O(n) with a
    /// small constant when few tolerances fail. Throws wrong_size unless there are index_bound() points, not_finite,
    /// out_of_domain, duplicate_point.
    Move_result move_all(std::span<const Coordinates<d>> points) {
        view_->invalidate();
        return mesh_.move_all(points);
    }
    template <class Range>
    requires std::is_convertible_v<decltype(*std::begin(std::declval<const Range&>())), Point> Move_result
    move_all(const Range& points) {
        return move_all(std::span<const Coordinates<d>>(coordinates_of<View>(std::begin(points), std::end(points))));
    }

    /// Inserts a vertex. Throws not_finite, out_of_domain, duplicate_point, too_large. Costs as in Moving_mesh.
    Vertex_handle insert(const Point& p, Move_result* report = nullptr) {
        invalidate({});
        view_->reserve_vertex();
        Index i = none;
        try {
            i = mesh_.insert(View::coordinates(p), report);
        } catch (...) {
            view_->drop_reserved();
            throw;
        }
        return view_->adopt(i, positions()[at(i)]);
    }
    /// Removes a vertex. Its handle becomes invalid, its index free. Throws unknown_vertex. When memory runs out, the
    /// vertex may be gone: then vertex(i) is null at its index, which is the one freed last, and everything else is
    /// right.
    void remove(Vertex_handle v, Move_result* report = nullptr) {
        const Index i = index(v);
        invalidate({});
        try {
            mesh_.remove(i, report);
        } catch (...) {
            if (!mesh_.is_vertex(i)) view_->forget(i);
            throw;
        }
        view_->forget(i);
    }
    /// Makes every moving position the fixed one and recomputes every tolerance. O(n). With tolerances that are not
    /// certified, two vertices may have come to one position unnoticed; then it throws duplicate_point, as do insert
    /// and remove, until one of them has moved away.
    Move_result recompute_tolerances() {
        view_->invalidate();
        return mesh_.recompute_tolerances();
    }

    /// CGAL's object; its points are the positions, and it is Delaunay. With tolerances that are not certified, its
    /// points are the fixed positions, at which it is Delaunay. O(k) for the k cells that have changed and vertices
    /// that have moved since the last call. Throws bad_alloc.
    [[nodiscard]] const Triangulation& triangulation() const { return view_->update(mesh_.delaunay_positions()); }
    [[nodiscard]] std::size_t number_of_vertices() const { return mesh_.number_of_vertices(); }
    /// One more than the largest index in use or free: the number of points that move_all takes.
    [[nodiscard]] std::size_t index_bound() const { return mesh_.index_bound(); }
    /// Null for a free index. O(1) after triangulation(). Throws unknown_vertex beyond index_bound().
    [[nodiscard]] Vertex_handle vertex(std::size_t i) const {
        if (i >= index_bound())
            throw Error(Error_code::unknown_vertex, "no vertex has index " + std::to_string(i),
                        {static_cast<std::int64_t>(i)});
        (void)triangulation();
        return view_->handle(static_cast<Index>(i));
    }
    /// O(1). Throws unknown_vertex.
    [[nodiscard]] Index index(Vertex_handle v) const {
        const Index i = v == Vertex_handle() ? none : view_->index(v);
        if (i < 0) throw Error(Error_code::unknown_vertex, "the handle names no vertex of this triangulation");
        return i;
    }
    /// The vertex index of every input point; differs from 0, 1, 2 ... only where duplicates were merged. Valid as long
    /// as this object, also if it is moved, and until it is assigned to.
    [[nodiscard]] std::span<const Index> vertex_of_input() const { return mesh_.vertex_of_input(); }

    [[nodiscard]] Point position(Vertex_handle v) const { return View::point(positions()[at(index(v))]); }
    /// Positions by index, NaN at free indices. Valid until the next call of a member that is not const; it may be an
    /// argument of that call.
    [[nodiscard]] std::span<const Coordinates<d>> positions() const { return mesh_.points(); }
    /// The position from which D is measured; for strategies without tolerances the position itself.
    [[nodiscard]] Point fixed_position(Vertex_handle v) const { return View::point(mesh_.fixed_position(index(v))); }
    /// How far v may be from its fixed position while every other vertex is within its own tolerance: a certified
    /// lower bound with Tolerance_kind::certified. After recompute_tolerances() (and always for strategies that keep
    /// no tolerances) the least tolerance of the certificates of v.
    [[nodiscard]] double tolerance(Vertex_handle v) const { return mesh_.tolerance(index(v)); }
    /// Upper bound of |position - fixed position|.
    [[nodiscard]] double displacement(Vertex_handle v) const { return mesh_.displacement(index(v)); }
    /// The least theta of the finite bi-cells of v in radians (theory 4); pi/2 when v has none.
    [[nodiscard]] double theta(Vertex_handle v) const { return mesh_.theta(index(v)); }

    /// Tolerances, annulus widths and theta of everything, computed for this call, whatever the strategy. O(n).
    [[nodiscard]] Measures measure() const { return mesh_.measure(); }

    /// Every finite cell, as vertex indices. O(n).
    [[nodiscard]] Mesh_cells<d> cells() const { return mesh_.cells(); }

    /// Exact verdict on the cells at the present positions; see audit.h. Faults of CGAL's object itself count as
    /// topological ones: handles allow a caller to write in it (`vertex(i)->set_point(p)`), which the strategy does
    /// not see. So the points of its vertices must be those that triangulation() promises, and its cells must fit
    /// together and be those of the mesh. O(n).
    [[nodiscard]] Audit_result audit() const {
        Audit_result object;
        (void)triangulation();
        if (!view_->audit(mesh_.delaunay_positions(), object)) return object;
        Audit_result result = mesh_.audit();
        result.topological_faults += object.topological_faults;
        if (!object.first_fault.empty()) result.first_fault = std::move(object.first_fault);
        return result;
    }
    /// The finite cells and the present positions, renumbered without the free indices.
    [[nodiscard]] Audit_input<d> audit_input() const { return mesh_.audit_input(); }

    [[nodiscard]] const Options& options() const { return mesh_.options(); }
    /// The strategy in force: that of the options, except that `paper-hybrid` becomes `paper` when it switches.
    [[nodiscard]] Strategy strategy() const { return mesh_.strategy(); }
    /// The mesh that the strategies work on.
    [[nodiscard]] const Delaunay_mesh<d>& mesh() const { return mesh_.mesh(); }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    template <class Pair>
    Moving_delaunay(const Pairs<Pair>& pairs, const Options& options)
        : Moving_delaunay(std::span<const Coordinates<d>>(coordinates_of<View>(
                              pairs.all.begin(), pairs.all.end(), [](const Pair& pair) { return Point(pair.first); })),
                          options) {
        for (std::size_t k = pairs.all.size(); k-- > 0;)
            view_->handle(vertex_of_input()[k])->info() = pairs.all[k].second;
    }
    template <class Other>
    Moving_delaunay(const Originals<Other>& of, const Options& options)
        : mesh_(std::span<const Coordinates<d>>(coordinates_of<View>(of.vertices.begin(), of.vertices.end(),
                                                                     [](const auto& v) { return Point(v->point()); })),
                options) {
        const auto original = [&of](Index v) { return of.vertices[at(v)]; };
        if constexpr (std::is_same_v<typename Other::Vertex, typename Triangulation::Vertex>) {
            view_ = std::make_unique<View>(Mesh_access<d>(mesh_), mesh_.points(), original);
        } else {
            view_ = std::make_unique<View>(Mesh_access<d>(mesh_), mesh_.points());
            if constexpr (Has_info<typename Other::Vertex> && Has_info<typename Triangulation::Vertex>)
                for (Index v = 0; at(v) < index_bound(); ++v) view_->handle(v)->info() = original(v)->info();
        }
    }
    /// These vertices are about to move. Under the paper's algorithm the triangulation is at other positions than
    /// these, of which others may change, too.
    void invalidate(std::span<const Index> indices) noexcept {
        if (strategy() == Strategy::paper) return view_->invalidate();
        view_->invalidate_cells();
        for (const Index i : indices) view_->invalidate(i);
    }

    Moving_mesh<d> mesh_;
    std::unique_ptr<View> view_;
};

}  // namespace annulus::inline v1
