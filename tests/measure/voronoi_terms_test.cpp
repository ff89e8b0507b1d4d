// SPDX-License-Identifier: GPL-3.0-or-later
// The error bounds of a facet's terms, compared with the terms in rational numbers: circumcentres are off by as much as
// their bounds allow.
#include <annulus/measure/voronoi_terms.h>
#include <support/cases.h>
#include <support/catch.h>
#include <support/repeats.h>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
using Exact = std::array<mpq_class, static_cast<std::size_t>(d)>;

template <int d>
Exact<d> less(const Exact<d>& a, const Exact<d>& b) {
    Exact<d> out;
    for (std::size_t k = 0; k < d; ++k) out[k] = a[k] - b[k];
    return out;
}

mpq_class determinant(const Exact<3>& a, const Exact<3>& b, const Exact<3>& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Two cells with a common facet, as for_each_inner_facet reads them: the first has the vertices 0 to d, the other one
/// is beyond the facet opposite to `opposite`, and its first corner is vertex d + 1. Whether they are positive does not
/// matter to their terms.
template <int d>
struct Two_cells {
    std::size_t opposite;

    static Index corner(Index c, std::size_t i) { return c == 0 ? static_cast<Index>(i) : i == 0 ? d + 1 : 0; }
    [[nodiscard]] Index beyond(Index c, std::size_t i) const { return c == 0 && i == opposite ? 1 : -1; }
    static bool is_finite(Index) { return true; }
    static bool owns(Index c, Index n) { return n > c; }
};

template <int d>
struct Scene {
    std::vector<Coordinates<d>> x;
    std::vector<Circumcentre<d>> centre;  // as computed
    std::vector<Exact<d>> truth;          // where they are, seen from the first corner of their cells
    Two_cells<d> cells;
    double scale = 1;  // circumcentres have the unit 1/scale

    [[nodiscard]] Exact<d> at(std::size_t v) const {
        Exact<d> out;
        for (std::size_t k = 0; k < d; ++k) out[k] = mpq_class(x[v][k]) * scale;
        return out;
    }
    /// Of cell c, seen from vertex v.
    [[nodiscard]] Exact<d> seen(std::size_t c, std::size_t v) const {
        const Exact<d> base = at(c == 0 ? 0 : d + 1);
        Exact<d> out = less<d>(base, at(v));
        for (std::size_t k = 0; k < d; ++k) out[k] += truth[c][k];
        return out;
    }
    /// The terms that the facet adds to the vertices: by edge, as at the beginning of voronoi_terms.h.
    [[nodiscard]] std::vector<mpq_class> terms() const {
        std::vector<mpq_class> out(x.size());
        const auto& facet = facet_corners<d>[cells.opposite];
        for (std::size_t e = 0; e < (d == 2 ? 1 : 3); ++e) {
            const std::size_t p = facet[e], q = facet[(e + 1) % d];
            const Exact<d> n = less<d>(at(q), at(p));
            mpq_class term;
            if constexpr (d == 2) {
                const Exact<2> dual = less<2>(seen(1, p), seen(0, p));
                term = dual[0] * n[1] - dual[1] * n[0];
            } else term = determinant(n, seen(0, p), seen(1, p));
            out[p] += term;
            out[q] += term;
        }
        return out;
    }
};

/// Numbers below 1 of few magnitudes, some of them 0 or equal.
template <int d>
Coordinates<d> vector(Random& random, double size) {
    Coordinates<d> out;
    for (double& c : out)
        c = random() % 6 == 0 ? 0 : between(random, -1, 1) * size * (random() % 4 == 0 ? std::ldexp(1.0, -20) : 1);
    return out;
}

/// `off`: the relative error of circumcentres, in one coordinate or spread over several.
template <int d>
Scene<d> scene(Random& random, std::size_t opposite, double reach, double off, double size) {
    Scene<d> s{{}, {}, {}, {opposite}, 1};
    const Coordinates<d> middle = vector<d>(random, 0.5 - size / 2);
    for (int v = 0; v < d + 2; ++v) {
        s.x.push_back(vector<d>(random, size / 2));
        for (std::size_t k = 0; k < d; ++k) s.x.back()[k] += middle[k];
    }
    const Coordinates<d> where = vector<d>(random, reach);
    for (int c = 0; c < 2; ++c) {
        Circumcentre<d> computed;
        const Coordinates<d> apart = vector<d>(random, reach * (random() % 2 == 0 ? 1 : size));
        for (std::size_t k = 0; k < d; ++k) computed.offset[k] = where[k] + apart[k];
        computed.error = off * reach;
        Exact<d> exactly;
        const std::size_t whole = random() % (2 * d);
        for (std::size_t k = 0; k < d; ++k) {
            const double share = whole == k ? 1 : whole < d ? 0 : 1.0 / 4;
            exactly[k] = mpq_class(computed.offset[k]) +
                         mpq_class(random() % 2 == 0 ? 1 : -1) * mpq_class(share) * mpq_class(computed.error);
        }
        s.centre.push_back(computed);
        s.truth.push_back(exactly);
    }
    return s;
}

/// The largest share of its bound that an error has.
template <int d>
double check(const Scene<d>& s) {
    std::vector<Voronoi_sum> sum(s.x.size());
    Voronoi_terms<d>(s.x, s.centre, s.scale, sum).add_facets(s.cells, std::array{Index{0}});
    const std::vector<mpq_class> truth = s.terms();
    double most = 0;
    for (std::size_t v = 0; v < s.x.size(); ++v) {
        const mpq_class off = abs(mpq_class(sum[v].volume) - truth[v]);
        CAPTURE(v, sum[v].volume, sum[v].error, truth[v].get_d(), off.get_d());
        // The rest that the bound leaves to is_good().
        REQUIRE(off <= mpq_class(sum[v].error) * mpq_class(1 + 0x1p-40));
        if (sum[v].error > 0) most = std::max(most, mpq_class(off / mpq_class(sum[v].error)).get_d());
    }
    return most;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Terms of a facet are no further off than they say, and not far below, dimension",
                       "[measure][voronoi]", ((int d), d), 2, 3) {
    double by_rounding = 0, by_centres = 0;
    for (int round = 0; round < repeats(4000); ++round) {
        Random random(static_cast<std::uint64_t>(round));
        const std::size_t opposite = random() % (d + 1);
        const double size = std::ldexp(1.0, -static_cast<int>(random() % 12));
        const double reach = std::ldexp(1.0, static_cast<int>(random() % 24) - 12);
        INFO("round " << round);
        by_rounding = std::max(by_rounding, check<d>(scene<d>(random, opposite, reach, 0, size)));
        by_centres = std::max(by_centres, check<d>(scene<d>(random, opposite, reach, 0x1p-30, size)));
        (void)check<d>(scene<d>(random, opposite, reach, std::ldexp(1.0, -static_cast<int>(random() % 52)), size));
    }
    CAPTURE(by_rounding, by_centres);
    CHECK(by_rounding > (d == 2 ? 0.3 : 0.1));
    CHECK(by_centres > (d == 2 ? 0.9 : 0.4));
}

TEMPLATE_TEST_CASE_SIG(
    "Terms that underflow are no further off than they say, however far circumcentres are, dimension",
    "[measure][voronoi]", ((int d), d), 2, 3) {
    for (int round = 0; round < repeats(1000); ++round) {
        Random random(static_cast<std::uint64_t>(round));
        const std::size_t opposite = random() % (d + 1);
        // Edges that have few bits left in the unit, and circumcentres that make their products large again.
        Scene<d> s = scene<d>(random, opposite, std::ldexp(1.0, static_cast<int>(random() % 480)), 0, 1);
        s.scale = std::ldexp(1.0, -100 - static_cast<int>(random() % 400));
        const double size = std::ldexp(1.0, -1000 - static_cast<int>(random() % 74)) / s.scale;
        for (auto& p : s.x)
            for (double& c : p) c *= size;
        INFO("round " << round);
        (void)check<d>(s);
    }
}
