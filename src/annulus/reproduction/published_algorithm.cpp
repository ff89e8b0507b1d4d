// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/reproduction/published_algorithm.h>

#include <annulus/arithmetic/error.h>
#include <annulus/engine/displacement.h>
#include <annulus/reproduction/delimiter_side.h>
#include <annulus/reproduction/published_pieces.h>

#include <algorithm>
#include <limits>

namespace annulus {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
std::size_t at(Index i) { return static_cast<std::size_t>(i); }

template <int d>
typename Published_pieces<d>::Triangulation delaunay(std::span<const Coordinates<d>> points) {
    Options options;
    options.strategy = Strategy::rebuild;
    return Moving_of<d>(points, options).triangulation();
}

}  // namespace

template <int d>
class Published_algorithm<d>::Work {
  public:
    using Pieces = Published_pieces<d>;
    using Cell = typename Pieces::Cell;
    using Vertex = typename Pieces::Vertex;

    Work(std::span<const Coordinates<d>> points, const Published_variant& choice)
        : choice_(choice),
          tr_(delaunay<d>(points)),
          handle_(points.size()),
          fixed_(points.begin(), points.end()),
          moving_(fixed_),
          epsilon_(points.size(), unlimited),
          queued_(points.size(), 0) {
        tr_.infinite_vertex()->set_index(infinite);
        Pieces::for_each_cell(tr_, [](Cell c) { c->set_cell(0); });
        for (auto v = tr_.finite_vertices_begin(); v != tr_.finite_vertices_end(); ++v) handle_[at(v->index())] = v;
        if (choice_.tolerances) precompute();
    }

    void precompute() {
        require_cells();
        std::fill(epsilon_.begin(), epsilon_.end(), unlimited);
        fresh_.clear();
        Pieces::for_each_cell(tr_, [this](Cell c) { fresh_.push_back(c); });
        evaluate();
    }

    Move_report move_all(std::span<const Coordinates<d>> target) {
        report_ = {};
        failed_.clear();
        for (std::size_t v = 0; v < target.size(); ++v) {
            moving_[v] = target[v];
            ++report_.moves.asked;
            const auto i = static_cast<Index>(v);
            if (moving_[v] == fixed_[v] || (choice_.tolerances && passes(i))) {
                ++report_.moves.within_tolerance;
                continue;
            }
            failed_.push_back(i);
            process(i, true);
            for (std::size_t k = 0; k < queue_.size(); ++k) {
                queued_[at(queue_[k])] = 0;
                process(queue_[k], false);
            }
            queue_.clear();
        }
        return report_;
    }

    [[nodiscard]] std::span<const Index> failed() const { return failed_; }

    [[nodiscard]] double tolerance(Index v) const {
        std::vector<Cell> star;
        Pieces::append_star(tr_, handle_[at(v)], star);
        double least = unlimited;
        for (const Cell c : star)
            for (int i = 0; i <= d; ++i) least = std::min(least, paper_half_width<d>(certificate(c, i), fixed_));
        return least;
    }

    [[nodiscard]] Audit_input<d> audit_input() const {
        Audit_input<d> in{moving_, {}};
        Pieces::for_each_cell(tr_, [&](Cell c) {
            if (!tr_.is_infinite(c)) in.cells.push_back(vertices(c));
        });
        return in;
    }

  private:
    void require_cells() const {
        if (tr_.dimension() != d) throw Error(Error_code::bad_input, "the points lie in a plane, or on a line");
    }
    [[nodiscard]] bool passes(Index v) const {
        const double e = epsilon_[at(v)];
        return squared_distance<d>(moving_[at(v)], fixed_[at(v)]) < e * e;
    }
    [[nodiscard]] static Cell_vertices<d> vertices(Cell c) {
        Cell_vertices<d> v{};
        for (int i = 0; i <= d; ++i) v[at(i)] = c->vertex(i)->index();
        return v;
    }
    [[nodiscard]] static Cell_sites<d> corners(Cell c) { return sites_of<d>(vertices(c)); }
    /// The tolerance of the facet opposite to vertex i of c. The slab of a border facet is that of its finite cell.
    [[nodiscard]] Facet_certificate<d> certificate(Cell c, int i) const {
        Cell n = c->neighbor(i);
        int j = tr_.mirror_index(c, i);
        Facet_certificate<d> f = facet_certificate<d>(corners(c), at(i), Site<d>(n->vertex(j)->index()));
        if (f.kind == Facet_kind::nothing) {
            if (c->vertex(i)->index() == infinite) {
                std::swap(c, n);
                std::swap(i, j);
            }
            const Cell_sites<d> x = Pieces::slab(corners(c), at(i));
            f.kind = Facet_kind::slab;
            std::copy(x.begin(), x.end(), f.point.begin());
        }
        put_in_order(f);
        return f;
    }

    /// Calls visit(cell, slot) once for every facet of the cells in `fresh_`.
    template <class Visit>
    void for_each_fresh_facet(Visit visit) {
        ++stamp_;
        for (const Cell c : fresh_) c->set_cell(stamp_);
        for (const Cell c : fresh_) {
            if (c->cell() != stamp_) continue;
            c->set_cell(-stamp_);  // skips duplicates in the list, and facets seen from their other side
            for (int i = 0; i <= d; ++i)
                if (c->neighbor(i)->cell() != -stamp_ && !visit(c, i)) return;
        }
    }

    /// Each new bi-cell lowers the tolerance of its points; a point that is no longer within its tolerance enters the
    /// queue.
    void evaluate() {
        const std::size_t first = queue_.size();
        for_each_fresh_facet([&](Cell c, int i) {
            const Facet_certificate<d> f = certificate(c, i);
            const double e = paper_half_width<d>(f, fixed_);
            ++report_.evaluated;
            for (const auto& [w, label] : f.point) {
                if (w == none) continue;
                const bool lowered = e < epsilon_[at(w)];
                if (lowered) epsilon_[at(w)] = e;
                if (!(lowered || choice_.safe_region) || queued_[at(w)] != 0) continue;
                if (passes(w) || moving_[at(w)] == fixed_[at(w)]) continue;
                queued_[at(w)] = 1;
                queue_.push_back(w);
            }
            return true;
        });
        std::sort(queue_.begin() + static_cast<std::ptrdiff_t>(first), queue_.end());
    }

    void process(Index h, bool first) {
        if (choice_.safe_region && stays_in_safe_region(h)) {
            if (first) ++report_.moves.kept_in_place;
            return;
        }
        fresh_.clear();
        const bool kept = choice_.in_place && stays_in_place(h);
        if (kept) Pieces::append_star(tr_, handle_[at(h)], fresh_);
        else relocate(h);
        fixed_[at(h)] = moving_[at(h)];
        epsilon_[at(h)] = unlimited;
        if (first) ++(kept ? report_.moves.kept_in_place : report_.moves.reinserted);
        else ++report_.requeued;
        if (choice_.tolerances) evaluate();
    }

    void relocate(Index h) {
        const Vertex old = handle_[at(h)];
        if constexpr (d == 2)
            if (choice_.flips) {
                if (tr_.move_if_no_collision(old, Pieces::point(moving_[at(h)])) != old)
                    throw Error(Error_code::duplicate_point, "another vertex is at that position");
                return;
            }
        const Vertex made = tr_.insert(Pieces::point(moving_[at(h)]), Pieces::cell_of(old));
        if (made->index() != none) throw Error(Error_code::duplicate_point, "another vertex is at that position");
        made->set_index(h);
        handle_[at(h)] = made;
        Pieces::remove(tr_, old, fresh_);
        require_cells();
        Pieces::append_star(tr_, made, fresh_);
    }

    /// Writes the new position if no certificate around the vertex fails there.
    [[nodiscard]] bool stays_in_place(Index h) {
        const Vertex v = handle_[at(h)];
        const auto home = v->point();
        v->set_point(Pieces::point(moving_[at(h)]));
        fresh_.clear();
        Pieces::append_star(tr_, v, fresh_);
        bool holds = true;
        for (const Cell c : fresh_) holds = holds && Pieces::is_positive(tr_, c);
        if (holds)
            for_each_fresh_facet([&](Cell c, int i) {
                const Cell n = c->neighbor(i);
                const Vertex beyond = n->vertex(tr_.mirror_index(c, i));
                if (c->vertex(i)->index() == infinite || beyond->index() == infinite) return true;
                return holds = !Pieces::sphere_holds(tr_, c, beyond);
            });
        fresh_.clear();
        if (!holds) v->set_point(home);
        return holds;
    }

    /// Whether the moving position is on its side of every delimiter of the fixed positions.
    [[nodiscard]] bool stays_in_safe_region(Index h) {
        fresh_.clear();
        Pieces::append_star(tr_, handle_[at(h)], fresh_);
        bool holds = true;
        if constexpr (d == 2)
            for_each_fresh_facet(
                [&](Cell c, int i) { return holds = keeps_its_side(certificate(c, i), fixed_, h, moving_[at(h)]); });
        else holds = false;
        return holds;
    }

    Published_variant choice_;
    typename Pieces::Triangulation tr_;  // at the fixed positions
    std::vector<Vertex> handle_;
    std::vector<Coordinates<d>> fixed_, moving_;
    std::vector<double> epsilon_;
    std::vector<char> queued_;
    std::vector<Index> queue_, failed_;
    std::vector<Cell> fresh_;
    Index stamp_ = 9;  // neither this nor its negative is a value that CGAL gives a cell
    Move_report report_;
};

template <int d>
Published_algorithm<d>::Published_algorithm(std::span<const Coordinates<d>> points, const Published_variant& choice)
    : work_(std::make_unique<Work>(points, choice)) {}
template <int d>
Published_algorithm<d>::~Published_algorithm() = default;
template <int d>
void Published_algorithm<d>::precompute() {
    work_->precompute();
}
template <int d>
Move_report Published_algorithm<d>::move_all(std::span<const Coordinates<d>> target) {
    return work_->move_all(target);
}
template <int d>
std::span<const Index> Published_algorithm<d>::failed() const {
    return work_->failed();
}
template <int d>
double Published_algorithm<d>::tolerance(Index v) const {
    return work_->tolerance(v);
}
template <int d>
Audit_result Published_algorithm<d>::audit() const {
    return annulus::audit(work_->audit_input());
}

template class Published_algorithm<2>;
template class Published_algorithm<3>;

}  // namespace annulus
