// SPDX-License-Identifier: GPL-3.0-or-later
// The calendar of a prediction beside a plain list of terms, and its unit of velocities at both ends of the domain.

#include <support/arbitrary.h>

#include <annulus/relocation/prediction.h>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

using Time = Prediction<2>::Time;

TEST_CASE("a certificate is looked at in the first step that ends after its term", "[relocation][prediction]") {
    REQUIRE(rc::check("whatever the lengths of steps and terms", [](const Seed& seed) {
        Random random = seed.random();
        std::vector<Vertex_record<2>> vertices(2);
        Prediction<2> prediction;
        prediction.adopt(std::vector<Point>{{0, 0}, {1, 0}}, vertices, 1.0);
        std::map<Index, Time> until;  // the term of every certificate; those before it are void
        Index next = 0;
        const auto some_term = [&] {
            const double length = 0.5 * std::ldexp(1.0 + unit(random), integer(random, 0, 19));
            Time end = prediction.now() + static_cast<Time>(length);
            if (random() % 2 == 0) end = end / 256 * 256 - static_cast<Time>(random() % 2);  // about midnight
            return std::max(end, prediction.now());
        };
        const auto evaluate = [&](Index id) { prediction.schedule(id, until[id] = some_term()); };
        for (int step = 0; step < 60; ++step) {
            for (int i = 0; i < 5; ++i) evaluate(next++);
            // Up to four ordinary steps, sometimes as much as ends just at the end of some term, or just after.
            Time ticks = static_cast<Time>(random() % 4097);
            const Time end = until[static_cast<Index>(random() % static_cast<std::uint64_t>(next))];
            if (random() % 2 == 0 && end >= prediction.now() && end - prediction.now() < 4096)
                ticks = end - prediction.now() + static_cast<Time>(random() % 2);
            prediction.advance(ticks);
            if (random() % 8 == 0) {  // a step that fails
                prediction.retreat();
                continue;
            }
            std::set<Index> due;
            prediction.for_each_due([&](Index id, Time t) {
                if (until[id] == t) due.insert(id);
            });
            RC_ASSERT(due.empty() || prediction.any_due());
            prediction.forget_due();
            for (const auto& [id, t] : until) RC_ASSERT((t < prediction.now()) == (due.count(id) == 1));
            for (const Index id : due) evaluate(id);
        }
    }));
}

TEST_CASE("a prediction repeats the motion it was made of, of whatever magnitude", "[relocation][prediction]") {
    REQUIRE(rc::check("to the precision of its velocities", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 100; ++i) {
            const double scale = std::ldexp(1.0 + unit(random), integer(random, -880, 480));
            const std::vector<Point> moves{{scale, 0.0}, {-0.3 * scale, scale * unit(random)}, {0.0, 0.0}};
            std::vector<Vertex_record<2>> vertices(3);
            Prediction<2> prediction;
            prediction.adopt(moves, vertices, scale);
            std::vector<Point> from(3);
            prediction.advance(prediction.ticks_of_step(from, moves, vertices));
            for (std::size_t v = 0; v < 3; ++v) {
                const Point p = vertices[v].expected(prediction.now(), prediction.speed());
                for (std::size_t k = 0; k < 2; ++k) RC_ASSERT(std::fabs(p[k] - moves[v][k]) <= 0x1p-20 * scale);
            }
            RC_ASSERT(vertices[2].rests());
        }
    }));
    for (const double tiny : {0.0, 0x1p-1074, 0x1p-1022, 0x1p-950}) {
        INFO("a motion of " << as_code(tiny));
        std::vector<Vertex_record<2>> vertices(2);
        vertices[1].fixed = {1.0, -1.0};
        Prediction<2> prediction;
        prediction.adopt(std::vector<Point>{{0.0, 0.0}, {tiny, tiny}}, vertices, 1.0);
        prediction.advance(4096);
        CHECK(prediction.speed() > 0.0);
        const Point p = vertices[1].expected(prediction.now(), prediction.speed());
        CHECK(p == vertices[1].fixed);
        CHECK(vertices[0].rests());
    }
}
