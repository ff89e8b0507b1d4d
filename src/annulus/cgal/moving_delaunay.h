// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/domain.h>
#include <annulus/arithmetic/environment.h>
#include <annulus/arithmetic/error.h>
#include <annulus/engine/filter.h>
#include <annulus/engine/filter_each.h>
#include <annulus/engine/options.h>
#include <annulus/mesh/audit.h>
#include <annulus/mesh/measures.h>

#include <iterator>
#include <map>
#include <random>
#include <type_traits>

namespace annulus {

/// A Delaunay triangulation that is kept right while its vertices move.
///
/// Cgal is the embedding of one dimension (Cgal_embedding_2<Info>); everything here is the same in every dimension.
/// Positions are in the caller's unit of length. With Tolerance_kind::certified the triangulation is Delaunay at the
/// positions of its vertices after every call, proved. Not thread-safe; const members may run concurrently.
///
/// Vertices have an index in input order and a CGAL handle; no move, whatever the strategy, invalidates either.
/// Removing a vertex leaves its index vacant; the next insertion takes the index vacated last.
///
/// Errors are annulus::Error; the object is as it was before the call that threw, except that after a collision
/// tolerances may have been computed anew and measured from other fixed positions. Every function
/// that takes a handle throws unknown_vertex for a null one, the vertex at infinity, and a vertex of another triangulation.
/// The handle of a vertex that was removed dangles and must not be used. too_large: the triangulation would have, or had for a
/// while on the way, more cells or vertices than indices can name (horizons.h).
///
/// When memory runs out (std::bad_alloc) positions, indices and handles are as they were, but for `remove`, which says what
/// holds, and the triangulation is built anew there before the exception goes on. Should even that fail, there are no
/// cells (an audit says so) until a later call that changes something, settle() for one, has built them. GMP's allocation
/// functions abort the process when they get nothing unless the program sets others (mp_set_memory_functions).
template <class Cgal>
class Moving_delaunay {
  public:
    static constexpr int dimension_of_space = Cgal::dimension_of_space;
    static constexpr int d = dimension_of_space;
    using Triangulation = typename Cgal::Triangulation;  ///< CGAL's
    using Point = typename Cgal::Point;
    using Vertex_handle = typename Cgal::Vertex_handle;

    explicit Moving_delaunay(const Options& options = {})
        : Moving_delaunay(std::span<const Coordinates<d>>{}, options) {}

    /// Builds from CGAL points; vertex(i) is the i-th. O(n log n).
    /// Throws not_finite, out_of_domain, collision (unless options.merge_duplicates), environment.
    template <std::input_iterator It>
    requires std::is_convertible_v<typename std::iterator_traits<It>::value_type, Point> Moving_delaunay(
        It first, It last, const Options& options = {})
        : Moving_delaunay(std::span<const Coordinates<d>>(coordinates(first, last)), options) {}
    /// The same from plain coordinates.
    /// Throws too_large besides.
    explicit Moving_delaunay(std::span<const Coordinates<d>> points, const Options& options = {});

    Moving_delaunay(const Moving_delaunay&) = delete;
    Moving_delaunay& operator=(const Moving_delaunay&) = delete;

    /// Moves one vertex. Expected O(degree) for a short way. Throws not_finite, out_of_domain, collision,
    /// unknown_vertex.
    Move_report move(Vertex_handle v, const Point& p) { return move(index(v), Cgal::coordinates(p)); }
    Move_report move(Index i, const Coordinates<d>& p);

    /// Moves every vertex: points[i] is the new position of vertex i; what stands at a vacant index is ignored.
    /// O(n) with a small constant when few tolerances fail. Throws wrong_size unless there are index_bound() points,
    /// not_finite, out_of_domain, collision.
    Move_report move_all(std::span<const Coordinates<d>> points);
    template <class Range>
    requires std::is_convertible_v<decltype(*std::begin(std::declval<const Range&>())), Point> Move_report
    move_all(const Range& points) {
        return move_all(std::span<const Coordinates<d>>(coordinates(std::begin(points), std::end(points))));
    }

    /// Inserts a vertex. Throws not_finite, out_of_domain, collision.
    Vertex_handle insert(const Point& p, Move_report* report = nullptr);
    /// Removes a vertex; its handle dies, its index is vacant. Throws unknown_vertex. When memory runs out the vertex may be gone:
    /// then vertex(i) is null at its index, the last one vacated, and everything else is right.
    void remove(Vertex_handle v, Move_report* report = nullptr);
    /// Makes every fixed position the moving one and every tolerance fresh. O(n). With tolerances that are not certified two vertices
    /// may have come to one place unnoticed; then it throws collision, as insert and remove do, until one of them has moved away.
    Move_report settle();

    /// CGAL's object; with certified tolerances its points are the positions and it is Delaunay. With `paper` and
    /// `floating` under filter-each its points are the fixed positions.
    [[nodiscard]] const Triangulation& triangulation() const { return embedding_.triangulation(); }
    [[nodiscard]] std::size_t number_of_vertices() const { return embedding_.vertices(); }
    /// One more than the largest index in use or vacant: the number of points move_all takes.
    [[nodiscard]] std::size_t index_bound() const { return position_count(); }
    /// Null for a vacant index. Throws unknown_vertex beyond index_bound().
    [[nodiscard]] Vertex_handle vertex(std::size_t i) const;
    /// O(1). Throws unknown_vertex.
    [[nodiscard]] Index index(Vertex_handle v) const {
        const Index i = v == Vertex_handle() ? none : v->index();
        if (i < 0 || at(i) >= index_bound() || embedding_.handle(i) != v) refuse_handle();
        return i;
    }
    /// Vertex index of every input point; differs from 0, 1, 2 ... only where duplicates were merged.
    [[nodiscard]] std::span<const Index> index_of_input() const { return index_of_input_; }

    [[nodiscard]] Point position(Vertex_handle v) const { return Cgal::point(positions()[at(index(v))]); }
    /// Positions by index; vacant entries are unspecified.
    [[nodiscard]] std::span<const Coordinates<d>> positions() const;
    /// Where D is measured from; the position itself for strategies without tolerances.
    [[nodiscard]] Point fixed_position(Vertex_handle v) const { return Cgal::point(fixed_coordinates(index(v))); }
    /// How far v may be from its fixed position while every other vertex is within its own tolerance of its own: a
    /// certified lower bound with Tolerance_kind::certified. After settle() (and always for strategies that keep no
    /// tolerances) the least tolerance of the certificates of v.
    [[nodiscard]] double tolerance(Vertex_handle v) const;
    /// Upper bound of |position - fixed position|.
    [[nodiscard]] double displacement(Vertex_handle v) const {
        const Index i = index(v);
        return distance_upper<d>(positions()[at(i)], fixed_coordinates(i));
    }
    /// Least theta of the finite bi-cells of v in radians (theory 4); pi/2 when it has none.
    [[nodiscard]] double theta(Vertex_handle v) const { return embedding_.theta(index(v)); }

    /// Fresh tolerances, annulus widths and theta of everything at CGAL's points, whatever the strategy. O(n).
    [[nodiscard]] Measures measure() const { return embedding_.measure(); }

    /// Exact verdict at the present positions; see audit.h. O(n).
    [[nodiscard]] Audit_result audit() const { return annulus::audit(audit_input()); }
    /// The finite cells and the present positions, vacant indices squeezed out.
    [[nodiscard]] Audit_input<d> audit_input() const;

    [[nodiscard]] const Options& options() const { return options_; }
    /// The strategy in force: that of the options, except that `hybrid` becomes `filter` when it switches.
    [[nodiscard]] Strategy strategy() const { return strategy_; }
    [[nodiscard]] const Cgal& embedding() const { return embedding_; }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    template <class It>
    static std::vector<Coordinates<d>> coordinates(It first, It last) {
        std::vector<Coordinates<d>> x;
        for (; first != last; ++first) x.push_back(Cgal::coordinates(*first));
        return x;
    }
    /// One of the filters is at work, and which: a certified one has the expiries of Filter, for single moves too.
    [[nodiscard]] bool filters() const {
        return strategy_ == Strategy::filter || strategy_ == Strategy::automatic ||
               (strategy_ == Strategy::filter_each && options_.tolerance == Tolerance_kind::certified);
    }
    [[nodiscard]] bool filters_each() const { return strategy_ == Strategy::filter_each && !filters(); }
    [[nodiscard]] std::size_t position_count() const { return positions().size(); }
    [[nodiscard]] Coordinates<d> fixed_coordinates(Index v) const {
        return filters() ? filter_.fixed_position(v) : filters_each() ? filter_each_.fixed_position(v) : plain_[at(v)];
    }
    [[noreturn]] static void refuse_handle();
    void require_vertex(Index i) const;
    /// Makes a call that changes something. Whatever it throws but an Error that is thrown before any change, the triangulation
    /// is built anew at the positions of before; `fresh` is the index that the call inserts, if any.
    template <class Call>
    void guarded(Call call, Index fresh = none);
    void recover(std::size_t bound, Index fresh) noexcept;
    void require_whole();
    void settle_into(Move_report& report);
    void rebuild_all(std::span<const Coordinates<d>> x, Move_report& report);
    void move_plain(Index i, const Coordinates<d>& p, Move_report& report);
    void move_all_unguarded(std::span<const Coordinates<d>> points, Move_report& report);
    void move_unguarded(Index i, const Coordinates<d>& p, Move_report& report);
    void insert_unguarded(Index i, const Coordinates<d>& x, Move_report& report);
    void move_each(std::span<const Coordinates<d>> x, Move_report& report);
    void try_move_each(std::span<const Coordinates<d>> x, Move_report& report);
    void order_by_blockers(std::span<const Coordinates<d>> x, std::vector<Index>& waiting) const;
    void make_trusted(Move_report& report);
    void consider_switch(std::span<const Coordinates<d>> x, Move_report& report);
    [[nodiscard]] double star_tolerance(Index i) const;
    void list_changes(Move_report& report, std::span<const Index> cells) const;
    void list_everything(Move_report& report) const;

    Options options_;
    Strategy strategy_;
    Cgal embedding_;
    Filter<d> filter_;                   // of `filter`, and of `filter-each` when certified
    Filter_each<d> filter_each_;         // of `filter-each` otherwise
    std::vector<Coordinates<d>> plain_;  // positions, for strategies that keep no tolerances
    std::vector<Index> vacant_;
    std::vector<Index> index_of_input_;
    std::mt19937_64 random_;
    std::uint64_t steps_ = 0;
    bool whole_ = true;  // false: there are positions but no cells, because memory ran out twice
};

}  // namespace annulus

#include <annulus/cgal/moving_delaunay_impl.h>
#include <annulus/cgal/moving_delaunay_moves.h>
