// SPDX-License-Identifier: GPL-3.0-or-later
// Invariants between calls, and runs of whole programs.
#include "program.h"
#include "shrink.h"

namespace annulus::oracle {

namespace {

/// CGAL's is_valid throws on failure where its assertions are compiled in. In 3D only the combinatorics are checked.
template <class Triangulation>
bool cgal_agrees(const Triangulation& tr) {
    try {
        if constexpr (std::is_same_v<Triangulation, Moving_delaunay_2::Triangulation>) return tr.is_valid();
        else return tr.tds().is_valid();
    } catch (const CGAL::Failure_exception&) {
        return false;
    }
}

}  // namespace

template <int d>
void Session_of<d>::check() const {
    const auto& tr = dt_->triangulation();
    if (!certified()) {
        if (!cgal_agrees(tr)) throw Fault{"CGAL's object is not valid at the fixed positions"};
        return;
    }
    if (dt_->index_bound() != sites_.size()) throw Fault{"index_bound()"};
    std::size_t count = 0;
    const bool kept = keeps_tolerances(*dt_);
    for (std::size_t i = 0; i < sites_.size(); ++i) {
        const auto v = dt_->vertex(i);
        if (v != handles_[i]) throw Fault{"a handle changed"};
        if (!sites_[i]) continue;
        ++count;
        if (dt_->index(v) != static_cast<Index>(i)) throw Fault{"index(vertex(i)) != i"};
        const auto p = Space<d>::point(*sites_[i]);
        if (dt_->position(v) != p) throw Fault{"a position is not the requested one"};
        if (v->point() != p) throw Fault{"CGAL's point is not the position"};
        if ((kept || coverage_.calls % sites_.size() == i) && !(dt_->tolerance(v) >= 0.0))
            throw Fault{"a tolerance is negative or NaN"};
    }
    if (dt_->number_of_vertices() != count) throw Fault{"number_of_vertices()"};
    const Audit_result audit = dt_->audit();
    if (!audit.delaunay()) throw Fault{"audit: " + audit.first_fault};
    if (!cgal_agrees(tr)) throw Fault{"CGAL's object is not valid"};
    const Cells_of<d> cells = cells_of(tr);
    // Where the points do not make the triangulation unique, CGAL's perturbation does.
    if (cells != rebuilt_cells(sites_))
        throw Fault{audit.degenerate_facets == 0 ? "the cells are not those of a rebuild"
                                                 : "the cells are not those of a rebuild (degenerate)"};
    if (const std::string words = twin_->fault(sites_, cells); !words.empty()) throw Fault{words};
    if constexpr (d == 3)
        if (const std::string words = view_fault(*dt_); !words.empty()) throw Fault{words};
}

template <int d>
void Session_of<d>::check_recomputed_tolerances() const {
    if constexpr (d == 3) {
        if (sites_.size() > 8) return;  // rational numbers are slow
        if (const std::string words = tolerance_fault(*dt_); !words.empty()) throw Fault{words};
    } else {
        const auto truth = vertex_tolerances(dt_->triangulation(), sites_);
        for (std::size_t i = 0; i < sites_.size(); ++i) {
            if (!sites_[i]) continue;
            const mpf_class found(dt_->tolerance(dt_->vertex(i)), precision);
            if (found > truth[i] * (1 + mpf_class(0x1p-200, precision)))
                throw Fault{"the tolerance of vertex " + std::to_string(i) + " is above the truth"};
            // Rounding to subnormal numbers may lose all accuracy.
            if (truth[i] > mpf_class(0x1p-1000, precision) &&
                found < truth[i] * mpf_class(0.998 * Limits::kept, precision))
                throw Fault{"the tolerance of vertex " + std::to_string(i) + " is far below the truth"};
        }
    }
}

template class Session_of<2>;
template class Session_of<3>;

namespace {

template <int d>
std::string run_program(const Program_of<d>& program, int rational, Coverage* coverage) {
    std::size_t step = 0;
    std::optional<Session_of<d>> session;
    std::string fault;
    try {
        session.emplace(program);
        session->check();
        for (const Operation_of<d>& o : program.operations) {
            ++step;
            session->apply(o);
            if (!session->refused()) session->check();
            if (o.kind == Operation_kind::recompute_tolerances && session->certified() && rational-- > 0)
                session->check_recomputed_tolerances();
        }
    } catch (const typename Session_of<d>::Fault& f) {
        fault = "operation " + std::to_string(step) + ": " + f.words;
    } catch (const std::exception& e) {
        fault = "operation " + std::to_string(step) + " threw " + e.what();
    }
    if (coverage && session) *coverage += session->coverage();
    return fault;
}

template <int d>
std::string run_and_shrink_program(const Program_of<d>& program, int rational, Coverage* coverage) {
    const std::string fault = run_program(program, rational, coverage);
    if (fault.empty()) return fault;
    const Program_of<d> small =
        shrunk(program, [rational](const Program_of<d>& p) { return !run_program<d>(p, rational, nullptr).empty(); });
    return run_program<d>(small, rational, nullptr) + "\n" + as_code(small);
}

}  // namespace

std::string run(const Program& program, int rational, Coverage* coverage) {
    return run_program(program, rational, coverage);
}
std::string run(const Program_3& program, int rational, Coverage* coverage) {
    return run_program(program, rational, coverage);
}

std::string run_and_shrink(const Program& program, int rational, Coverage* coverage) {
    return run_and_shrink_program(program, rational, coverage);
}
std::string run_and_shrink(const Program_3& program, int rational, Coverage* coverage) {
    return run_and_shrink_program(program, rational, coverage);
}

}  // namespace annulus::oracle
