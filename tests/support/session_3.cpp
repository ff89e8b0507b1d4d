// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/session_3.h>

#include <support/generators_3.h>

#include <set>

namespace annulus::testing {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

Options options_of(Strategy strategy) {
    Options o;
    o.strategy = strategy;
    return o;
}

}  // namespace

Session_3::Session_3(Strategy strategy, const Points_3& points) : dt_(points, options_of(strategy)) {
    for (const auto& p : points) sites_.emplace_back(p);
    for (std::size_t i = 0; i < sites_.size(); ++i) handles_.push_back(dt_.vertex(i));
}

bool Session_3::refused(const Operation_3& o) const {
    const bool live = o.vertex >= 0 && at(o.vertex) < sites_.size() && sites_[at(o.vertex)];
    if (o.kind == Operation_3::Kind::settle) return false;
    if ((o.kind == Operation_3::Kind::remove || o.kind == Operation_3::Kind::move) && !live) return true;
    if (o.kind == Operation_3::Kind::remove) return false;
    std::multiset<Coordinates<3>> after;
    for (std::size_t i = 0; i < sites_.size(); ++i) {
        if (!sites_[i] || (o.kind == Operation_3::Kind::move && static_cast<Index>(i) == o.vertex)) continue;
        after.insert(o.kind == Operation_3::Kind::move_all ? o.points[i] : *sites_[i]);
    }
    if (o.kind != Operation_3::Kind::move_all) after.insert(o.points[0]);
    return std::adjacent_find(after.begin(), after.end()) != after.end();
}

void Session_3::apply(const Operation_3& o) {
    const bool refusal = refused(o);
    const Cells_3 before = refusal ? cells_of(dt_.triangulation()) : Cells_3{};
    last_ = {};
    const auto point = [&o] { return Moving_delaunay_3::Point(o.points[0][0], o.points[0][1], o.points[0][2]); };
    Moving_delaunay_3::Vertex_handle inserted;
    try {
        switch (o.kind) {
            case Operation_3::Kind::settle: last_ = dt_.settle(); break;
            case Operation_3::Kind::remove:
                dt_.remove(o.vertex < 0 ? Moving_delaunay_3::Vertex_handle() : dt_.vertex(at(o.vertex)), &last_);
                break;
            case Operation_3::Kind::move: last_ = dt_.move(o.vertex, o.points[0]); break;
            case Operation_3::Kind::move_all: last_ = dt_.move_all(o.points); break;
            case Operation_3::Kind::insert: inserted = dt_.insert(point(), &last_); break;
        }
    } catch (const Error& e) {
        if (!refusal) throw Fault{std::string("a legal call threw: ") + e.what()};
        if (before != cells_of(dt_.triangulation())) throw Fault{"a failed call changed the cells"};
        return;
    }
    if (refusal) throw Fault{"a bad call was accepted"};
    switch (o.kind) {
        case Operation_3::Kind::settle: break;
        case Operation_3::Kind::remove:
            sites_[at(o.vertex)].reset();
            handles_[at(o.vertex)] = {};
            vacant_.push_back(o.vertex);
            break;
        case Operation_3::Kind::move: sites_[at(o.vertex)] = o.points[0]; break;
        case Operation_3::Kind::move_all:
            for (std::size_t i = 0; i < sites_.size(); ++i)
                if (sites_[i]) sites_[i] = o.points[i];
            break;
        case Operation_3::Kind::insert: {
            const Index i = vacant_.empty() ? static_cast<Index>(sites_.size()) : vacant_.back();
            if (!vacant_.empty()) vacant_.pop_back();
            sites_.resize(std::max(sites_.size(), at(i) + 1));
            handles_.resize(sites_.size());
            sites_[at(i)] = o.points[0];
            handles_[at(i)] = inserted;
            if (dt_.index(inserted) != i) throw Fault{"an insertion took an unexpected index"};
            break;
        }
    }
    const Move_counts& m = last_.moves;
    if (m.asked != m.within_tolerance + m.kept_in_place + m.flipped + m.reinserted + m.rebuilt)
        throw Fault{"the counts of a report do not add up to asked"};
    if (last_.evaluated != last_.arithmetic.total()) throw Fault{"evaluated is not the sum of the stages"};
}

void Session_3::check() const {
    const auto& tr = dt_.triangulation();
    Delaunay_3<No_info> fresh;
    if (dt_.index_bound() != sites_.size()) throw Fault{"index_bound()"};
    for (std::size_t i = 0; i < sites_.size(); ++i) {
        const auto v = dt_.vertex(i);
        if (v != handles_[i]) throw Fault{"a handle changed"};
        if (!sites_[i]) continue;
        const Moving_delaunay_3::Point p((*sites_[i])[0], (*sites_[i])[1], (*sites_[i])[2]);
        if (dt_.position(v) != p) throw Fault{"a position is not what was asked for"};
        if (v->point() != p) throw Fault{"CGAL's point is not the position"};
        if (!(dt_.tolerance(v) >= 0.0)) throw Fault{"a tolerance is negative or NaN"};
        fresh.insert(p)->set_index(static_cast<Index>(i));
    }
    const Audit_result audit = dt_.audit();
    if (!audit.delaunay()) throw Fault{"audit: " + audit.first_fault};
    if (!tr.tds().is_valid()) throw Fault{"CGAL's data structure is not valid"};
    // CGAL's perturbation makes the triangulation unique where the points do not.
    if (cells_of(tr) != cells_of(fresh))
        throw Fault{audit.degenerate_facets == 0 ? "the cells are not those of a rebuild"
                                                 : "the cells are not those of a rebuild (degenerate)"};
    if (tr.dimension() == 3 && dt_.embedding().mirrored()) check_mirror();
}

/// Corner for corner what CGAL has.
void Session_3::check_mirror() const {
    const auto& tr = dt_.triangulation();
    const auto& t = dt_.embedding().table();
    std::size_t cells = 0;
    for (Index c = 0; c < t.cell_bound(); ++c) cells += t.is_cell(c) ? 1U : 0U;
    if (cells != tr.number_of_cells()) throw Fault{"the mirror has another number of cells"};
    std::set<Index> facets;
    for (auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c) {
        if (!t.is_cell(c->cell()) ||
            dt_.embedding().cell(c->cell()) != Moving_delaunay_3::Triangulation::Cell_handle(c))
            throw Fault{"a cell has no mirror"};
        for (int i = 0; i <= 3; ++i) {
            const Index h = t.corner(c->cell(), i);
            const Index v = tr.is_infinite(c->vertex(i)) ? infinite : c->vertex(i)->index();
            if (t.vertex(h) != v) throw Fault{"a corner of the mirror has another vertex"};
            if (t.twin(h) != t.corner(c->neighbor(i)->cell(), tr.tds().mirror_index(c, i)))
                throw Fault{"a corner of the mirror has another neighbour"};
            if (t.facet(h) != t.facet(t.twin(h)) || !t.is_facet(t.facet(h)))
                throw Fault{"a facet of the mirror is wrong"};
            if (t.half(t.facet(h)) != h && t.half(t.facet(h)) != t.twin(h)) throw Fault{"a facet has a foreign half"};
            facets.insert(t.facet(h));
            if (v != infinite && t.vertex(t.corner_of(v)) != v) throw Fault{"a vertex has a foreign corner"};
        }
    }
    if (facets.size() != 2 * cells) throw Fault{"two facets share a number"};
    std::size_t counted = 0;
    for (Index f = 0; f < t.facet_bound(); ++f) counted += t.is_facet(f) ? 1U : 0U;
    if (counted != facets.size()) throw Fault{"a facet was not freed"};
}

std::string as_code(const Program_3& program) {
    std::string s = "const Program_3 program{Strategy::";
    for (const char c : name_of(program.strategy)) s += c == '-' ? '_' : c;
    s += ",\n    " + as_code(program.points) + ",\n    {";
    for (const Operation_3& o : program.operations) {
        constexpr std::array names{"move", "move_all", "insert", "remove", "settle"};
        s += std::string("{Operation_3::Kind::") + names[static_cast<std::size_t>(o.kind)] + ", " +
             std::to_string(o.vertex) + ", " + as_code(o.points) + "},\n     ";
    }
    return s + "}};\n";
}

std::string run(const Program_3& program) {
    std::size_t step = 0;
    try {
        Session_3 session(program.strategy, program.points);
        session.check();
        for (const Operation_3& o : program.operations) {
            ++step;
            session.apply(o);
            session.check();
        }
    } catch (const Session_3::Fault& fault) {
        return "operation " + std::to_string(step) + ": " + fault.words;
    } catch (const std::exception& e) {
        return "operation " + std::to_string(step) + " threw " + e.what();
    }
    return {};
}

}  // namespace annulus::testing
