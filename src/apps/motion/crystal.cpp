// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/boxed_points.h>
#include <apps/motion/crystal.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

namespace {

/// A place in the unit cell, in quarters of its edges.
using Quarters = std::array<int, 3>;

constexpr std::array<Quarters, 1> simple{{{0, 0, 0}}};
constexpr std::array<Quarters, 2> of_triangular{{{0, 0, 0}, {2, 2, 0}}};
constexpr std::array<Quarters, 2> of_bcc{{{0, 0, 0}, {2, 2, 2}}};
constexpr std::array<Quarters, 8> of_diamond{
    {{0, 0, 0}, {0, 2, 2}, {2, 0, 2}, {2, 2, 0}, {1, 1, 1}, {1, 3, 3}, {3, 1, 3}, {3, 3, 1}}};

std::span<const Quarters> basis(Crystal c) {
    switch (c) {
        case Crystal::triangular: return of_triangular;
        case Crystal::bcc: return of_bcc;
        case Crystal::fcc: return std::span<const Quarters>(of_diamond).first(4);
        case Crystal::diamond: return of_diamond;
        default: return simple;
    }
}

constexpr std::size_t most_points = 100'000'000;

/// The number of unit cells along each vector for edges of cells that would fill the box with `cells` cells.
template <int d>
std::array<std::size_t, static_cast<std::size_t>(d)> rounded_cells(const Box<d>& box, Crystal c, std::size_t cells) {
    std::array<double, static_cast<std::size_t>(d)> length;
    double all = 1;
    for (std::size_t i = 0; i < d; ++i) {
        double square = 0;
        for (const double x : box.vectors()[i]) square += x * x;
        length[i] = std::sqrt(square);
        if (c == Crystal::triangular && i == 1) length[i] /= std::sqrt(3.0);
        all *= length[i];
    }
    const double edge = root_of<d>(all / static_cast<double>(cells));
    std::array<std::size_t, static_cast<std::size_t>(d)> result;
    for (std::size_t i = 0; i < d; ++i)
        result[i] = static_cast<std::size_t>(std::clamp(std::round(length[i] / edge), 1.0, 1e8));
    return result;
}

template <int d>
bool have(const std::array<std::size_t, static_cast<std::size_t>(d)>& along, std::size_t cells) {
    double all = 1;
    for (const std::size_t k : along) all *= static_cast<double>(k);
    return all == static_cast<double>(cells);
}

}  // namespace

std::size_t points_of_unit_cell(Crystal c) { return basis(c).size(); }

template <int d>
std::optional<std::array<std::size_t, static_cast<std::size_t>(d)>> unit_cells(const Box<d>& box, Crystal c,
                                                                               std::size_t n) {
    const std::size_t cells = n / basis(c).size();
    if (cells == 0 || n % basis(c).size() != 0) return std::nullopt;
    const auto along = rounded_cells<d>(box, c, cells);
    if (!have<d>(along, cells)) return std::nullopt;
    return along;
}

template <int d>
std::vector<std::size_t> numbers_that_fit(const Box<d>& box, Crystal c, std::size_t n) {
    const std::size_t a_cell = basis(c).size();
    const auto fits = [&](std::size_t cells) { return have<d>(rounded_cells<d>(box, c, cells), cells); };
    std::vector<std::size_t> numbers;
    std::size_t cells = n / a_cell;
    while (cells > 0 && !fits(cells)) --cells;
    if (cells > 0) numbers.push_back(cells * a_cell);
    cells = n / a_cell + 1;
    const std::size_t limit = std::min(most_points / a_cell, 8 * cells + 8);
    while (cells <= limit && !fits(cells)) ++cells;
    if (cells <= limit) numbers.push_back(cells * a_cell);
    return numbers;
}

template <int d>
std::vector<Coordinates<d>> crystal_in(const Box<d>& box, Crystal c,
                                       const std::array<std::size_t, static_cast<std::size_t>(d)>& cells) {
    std::size_t all = 1;
    for (const std::size_t k : cells) all *= k;
    std::vector<Coordinates<d>> points;
    points.reserve(all * basis(c).size());
    for (std::size_t cell = 0; cell < all; ++cell)
        for (const Quarters& place : basis(c)) {
            Coordinates<d> p{};
            std::size_t rest = cell;
            for (std::size_t i = 0; i < d; ++i) {
                const double quarters = static_cast<double>(4 * (rest % cells[i])) + place[i];
                rest /= cells[i];
                const double share = quarters / (4 * static_cast<double>(cells[i]));
                for (std::size_t k = 0; k < d; ++k) p[k] += share * box.vectors()[i][k];
            }
            points.push_back(p);
        }
    return points;
}

template <int d>
void vibrate(std::span<Coordinates<d>> points, double deviation, std::uint64_t seed) {
    Portable_random random(seed);
    for (auto& p : points)
        for (double& x : p) x += deviation * random.bell();
}

template std::optional<std::array<std::size_t, 2>> unit_cells<2>(const Box<2>&, Crystal, std::size_t);
template std::optional<std::array<std::size_t, 3>> unit_cells<3>(const Box<3>&, Crystal, std::size_t);
template std::vector<std::size_t> numbers_that_fit<2>(const Box<2>&, Crystal, std::size_t);
template std::vector<std::size_t> numbers_that_fit<3>(const Box<3>&, Crystal, std::size_t);
template std::vector<Coordinates<2>> crystal_in<2>(const Box<2>&, Crystal, const std::array<std::size_t, 2>&);
template std::vector<Coordinates<3>> crystal_in<3>(const Box<3>&, Crystal, const std::array<std::size_t, 3>&);
template void vibrate<2>(std::span<Coordinates<2>>, double, std::uint64_t);
template void vibrate<3>(std::span<Coordinates<3>>, double, std::uint64_t);

}  // namespace annulus::inline v1
