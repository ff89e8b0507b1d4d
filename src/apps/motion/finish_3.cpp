// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/finish_3.h>

#include <annulus/error.h>
#include <apps/motion/cells_3.h>
#include <apps/motion/dihedral.h>
#include <apps/motion/kept_cells_3.h>
#include <apps/motion/vectors_3.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

namespace annulus::inline v1 {

namespace {

using Cell = Finish_3::Cell;

constexpr double longest_stride = 0.3;
constexpr int strides = 4;

std::size_t number(Index v) { return static_cast<std::size_t>(v); }

/// From the middle of a cube to its facets, edges and corners, each of length 1.
std::vector<Coordinates<3>> directions() {
    std::vector<Coordinates<3>> all;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                const double length = std::sqrt(static_cast<double>(x * x + y * y + z * z));
                if (length > 0) all.push_back({x / length, y / length, z / length});
            }
    return all;
}

std::vector<Cell> sorted(std::vector<Cell> cells) {
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
}

std::vector<Cell> without(const std::vector<Cell>& cells, const std::vector<Cell>& others) {
    std::vector<Cell> rest;
    std::set_difference(cells.begin(), cells.end(), others.begin(), others.end(), std::back_inserter(rest));
    return rest;
}

std::vector<Cell> together(std::vector<Cell> cells, const std::vector<Cell>& others) {
    cells.insert(cells.end(), others.begin(), others.end());
    return sorted(std::move(cells));
}

Finish_3::Changes in_order(Finish_3::Changes changes) {
    for (auto* cells : {&changes.came, &changes.gone}) {
        for (Cell& c : *cells) c = annulus::in_order(c);
        *cells = sorted(std::move(*cells));
    }
    return changes;
}

}  // namespace

/// What counts of some cells: the least angle of those in the domain, and the triangles around these.
struct Finish_3::Part {
    double least = 180;
    std::vector<std::array<Index, 3>> surface;  // corners in ascending order, sorted
};

Finish_3::Finish_3(const Domain_3& domain, Vertices vertices, std::span<const Cell> cells, Mover mover, double goal)
    : domain_(domain), vertices_(std::move(vertices)), move_(std::move(mover)), goal_(goal) {
    const std::size_t n = vertices_.position.size();
    if (vertices_.on_surface.size() != n || vertices_.held.size() != n)
        throw Error(Error_code::wrong_size, "the finish needs flags for every vertex");
    star_.resize(n);
    for (const Cell& given : cells) {
        const Cell cell = annulus::in_order(given);
        for (const Index v : cell) {
            if (v < 0 || number(v) >= n) throw Error(Error_code::unknown_vertex, "a cell names no vertex");
            star_[number(v)].push_back(cell);
        }
        rank(cell);
    }
}

double Finish_3::angle(const Cell& c) const {
    double most = -1;  // the largest cosine; a facet without area gives an angle of 0
    for (const double cosine : dihedral_cosines(at(c[0]), at(c[1]), at(c[2]), at(c[3])))
        most = std::isnan(cosine) ? 1 : std::max(most, std::min(cosine, 1.0));
    return std::acos(most) * 180 / std::numbers::pi;
}

bool Finish_3::inside(const Cell& c) const {
    return is_inside(domain_, at(c[0]), cell_moment(at(c[0]), at(c[1]), at(c[2]), at(c[3])));
}

Finish_3::Part Finish_3::part(const std::vector<Cell>& cells) const {
    Part part;
    std::vector<std::array<Index, 3>> facets;
    for (const Cell& c : cells) {
        if (!inside(c)) continue;
        part.least = std::min(part.least, angle(c));
        for (const auto& corners : facet_corners) {
            facets.push_back({c[corners[0]], c[corners[1]], c[corners[2]]});
            std::sort(facets.back().begin(), facets.back().end());
        }
    }
    std::sort(facets.begin(), facets.end());
    for (std::size_t i = 0; i < facets.size(); ++i) {
        if (i + 1 < facets.size() && facets[i] == facets[i + 1]) ++i;  // between two of the cells
        else part.surface.push_back(facets[i]);
    }
    return part;
}

void Finish_3::replace_stars(const Changes& changes) {
    for (const Cell& c : changes.gone)
        for (const Index v : c) std::erase(star_[number(v)], c);
    for (const Cell& c : changes.came)
        for (const Index v : c) star_[number(v)].push_back(c);
}

void Finish_3::rank(const Cell& cell) {
    const double least = angle(cell);
    if (least < goal_ && inside(cell)) below_[0].insert({least, cell});
}

void Finish_3::forget(const Cell& cell) {
    const std::pair<double, Cell> entry{angle(cell), cell};
    below_[0].erase(entry);
    below_[1].erase(entry);
}

/// By how much the least angle would rise; nothing is changed.
double Finish_3::gain_of(Index v, const Coordinates<3>& p) {
    const Coordinates<3> home = at(v);
    std::optional<Changes> made = move_(v, p);
    if (!made) return 0;
    ++counts_.tried;
    const Changes there = in_order(std::move(*made));
    const std::vector<Cell> star = sorted(star_[number(v)]);
    const Part before = part(together(star, there.gone));
    vertices_.position[number(v)] = p;
    const Part after = part(together(without(star, there.gone), there.came));
    vertices_.position[number(v)] = home;
    const Changes back = in_order(move_(v, home).value());
    // Where points are cospherical, other cells may be back.
    const Changes lasting{together(without(there.came, back.gone), without(back.came, there.gone)),
                          together(without(there.gone, back.came), without(back.gone, there.came))};
    for (const Cell& c : lasting.gone) forget(c);
    replace_stars(lasting);
    for (const Cell& c : lasting.came) rank(c);
    return after.surface == before.surface ? after.least - before.least : 0;
}

/// Longer strides first; of the first one with a gain, the best direction.
void Finish_3::try_moves(Index v, Best& best) {
    static const std::vector<Coordinates<3>> all = directions();
    const Coordinates<3> home = at(v);
    double stride = std::numeric_limits<double>::infinity();
    for (const Cell& c : star_[number(v)])
        for (const Index w : c)
            if (w != v) stride = std::min(stride, longest_stride * distance(home, at(w)));
    for (int i = 0; i < strides; ++i, stride /= 2) {
        bool better = false;
        for (const Coordinates<3>& d : all) {
            Coordinates<3> p{home[0] + stride * d[0], home[1] + stride * d[1], home[2] + stride * d[2]};
            if (vertices_.on_surface[number(v)] != 0) p = domain_.project(p);
            else if (!domain_.contains(p)) continue;
            if (p == home) continue;
            const double gain = gain_of(v, p);
            if (!(gain > best.gain)) continue;
            best = {v, p, gain};
            better = true;
        }
        if (better) return;
    }
}

void Finish_3::keep(const Best& best) {
    const Changes made = in_order(move_(best.vertex, best.position).value());
    const std::vector<Cell> star = sorted(star_[number(best.vertex)]);
    for (const Cell& c : together(star, made.gone)) forget(c);
    vertices_.position[number(best.vertex)] = best.position;
    replace_stars(made);
    for (const Cell& c : together(without(star, made.gone), made.came)) rank(c);
    ++counts_.kept;
}

bool Finish_3::step() {
    auto& [open, tried] = below_;
    if (open.empty()) {
        if (++passes_.done == most_passes || counts_.kept == passes_.kept_before) return false;
        passes_.kept_before = counts_.kept;
        open.swap(tried);
        if (open.empty()) return false;
    }
    const std::pair<double, Cell> worst = *open.begin();
    Best best;
    for (const Index v : worst.second)
        if (vertices_.held[number(v)] == 0) try_moves(v, best);
    if (best.vertex != none) {
        keep(best);
    } else if (open.erase(worst) > 0) {
        tried.insert(worst);
    }
    return true;
}

}  // namespace annulus::inline v1
