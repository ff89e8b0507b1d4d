// SPDX-License-Identifier: GPL-3.0-or-later
// The list of expiries of a vertex compared with a table of all of them.

#include <support/arbitrary.h>
#include <support/catch.h>

#include <annulus/engine/expiry_list.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

TEST_CASE("An expiry is reached by the path lengths that are not below it", "[relocation]") {
    REQUIRE(for_all([](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 1000; ++i) {
            const Expiry e =
                Expiry::lower(std::ldexp(1.0 + static_cast<double>(random() % 16) / 8, static_cast<int>(random() % 4)));
            double path_length = e.path_length();
            for (std::uint64_t k = random() % 3; k > 0; --k)
                path_length = std::nextafter(path_length, random() % 2 == 0 ? 0.0 : 100.0);
            RC_ASSERT(e.reached(path_length) == (path_length >= e.path_length()));
        }
    }));
    CHECK(!Expiry::never().reached(1e300));
    CHECK(Expiry::lower(0.0).reached(0.0));
}

TEMPLATE_TEST_CASE_SIG("No certificate expires that its vertex' list does not name or announce", "[relocation]",
                       ((std::size_t capacity), capacity), 6, 14) {
    REQUIRE(for_all([](const Seed& seed) {
        Random random = seed.random();
        Expiry_list<capacity> list;
        std::map<std::uint32_t, Expiry> truth;  // every certificate of the vertex
        double path_length = 0.0;
        const auto some_expiry = [&] {  // ties are frequent
            return random() % 16 == 0 ? Expiry::never()
                                      : Expiry::lower(path_length + static_cast<double>(random() % 32) / 4);
        };
        const std::uint32_t certificates = 1 + static_cast<std::uint32_t>(random() % 40);
        int dry = 0;
        for (int step = 0; step < 200; ++step) {
            if (truth.size() < static_cast<std::size_t>(certificates) && random() % 2 == 0) {
                const auto id = static_cast<std::uint32_t>(truth.size());
                list.put_new(id, truth[id] = some_expiry());
            } else if (!truth.empty()) {
                const auto id = static_cast<std::uint32_t>(random() % truth.size());
                list.put(id, truth[id] = some_expiry());
            }
            Expiry first = Expiry::never();
            for (const auto& [id, e] : truth) first = std::min(first, e);
            RC_ASSERT(!(first < list.earliest()));
            if (random() % 3 != 0) continue;
            path_length += static_cast<double>(random() % 8) / 8;
            std::set<std::uint32_t> taken;
            list.take_reached(path_length, [&](std::uint32_t id) { RC_ASSERT(taken.insert(id).second); });
            const bool enough = !list.rest().reached(path_length);
            if (enough)
                for (const auto& [id, e] : truth) RC_ASSERT(!e.reached(path_length) || taken.count(id) == 1);
            for (const std::uint32_t id : taken)  // re-evaluated, or not expired by its own record
                list.put(id, truth[id] = truth[id].reached(path_length)
                                             ? Expiry::lower(path_length + 1.0 + static_cast<double>(random() % 8))
                                             : truth[id]);
            if (!enough) {  // a star walk
                ++dry;
                list.clear();
                std::vector<Expiry> expiry;
                std::vector<std::uint32_t> ids;
                for (auto& [id, e] : truth) {
                    if (e.reached(path_length)) e = Expiry::lower(path_length + 1.0);
                    expiry.push_back(e);
                    ids.push_back(id);
                }
                list.put_new(expiry, ids);
            }
        }
        RC_TAG(dry > 0 ? "star_walks" : "no star walk");
    }));
}

TEST_CASE("Many certificates at once: those listed come first, the others announce themselves", "[relocation]") {
    REQUIRE(for_all([](const Seed& seed) {
        Random random = seed.random();
        Expiry_list<14> list;
        std::vector<Expiry> expiry;
        std::vector<std::uint32_t> id;
        const double base = std::ldexp(1.0, static_cast<int>(random() % 40) - 20);
        const bool ties = random() % 4 == 0;
        for (std::uint64_t n = random() % 200; n > 0; --n) {
            id.push_back(static_cast<std::uint32_t>(id.size()));
            const double way = ties ? static_cast<double>(random() % 3) : static_cast<double>(random() >> 11) * 0x1p-53;
            expiry.push_back(random() % 16 == 0 ? Expiry::never() : Expiry::lower(base + way));
        }
        list.put_new(expiry, id);
        RC_ASSERT(list.earliest() ==
                  (expiry.empty() ? Expiry::never() : *std::min_element(expiry.begin(), expiry.end())));
        std::set<std::uint32_t> listed;
        list.take_reached(1e300, [&](std::uint32_t i) { listed.insert(i); });
        for (std::size_t i = 0; i < id.size(); ++i) RC_ASSERT(listed.contains(id[i]) || !(expiry[i] < list.rest()));
        // At least half of the list, unless equal ones leave no bound between them.
        std::erase(expiry, Expiry::never());
        std::sort(expiry.begin(), expiry.end());
        const std::size_t most = std::min<std::size_t>(expiry.size(), 15);
        const auto first = expiry.begin(), last = first + static_cast<std::ptrdiff_t>(most);
        if (std::adjacent_find(first, last) == last)
            RC_ASSERT(listed.size() >= std::min<std::size_t>(static_cast<std::size_t>(last - first), 7));
    }));
}

TEST_CASE("A list of expiries names the six that come first", "[relocation]") {
    Expiry_list<6> list;
    for (std::uint32_t id = 0; id < 10; ++id) list.put_new(id, Expiry::lower(20.0 - id));
    CHECK(list.earliest() == Expiry::lower(11.0));
    CHECK(list.latest() == Expiry::lower(16.0));
    CHECK(list.rest() == Expiry::lower(17.0));
    list.put(9, Expiry::lower(30.0));
    CHECK(list.earliest() == Expiry::lower(12.0));
    std::vector<std::uint32_t> taken;
    list.take_reached(13.5, [&](std::uint32_t id) { taken.push_back(id); });
    CHECK(taken == std::vector<std::uint32_t>{8, 7});
    list.clear();
    CHECK(list.earliest() == Expiry::never());
    list.take_reached(1e300, [&](std::uint32_t) { FAIL("nothing is listed"); });
}
