// SPDX-License-Identifier: GPL-3.0-or-later
// A call of the C interface that runs out of memory returns a status; the mesh is unchanged and remains usable.
#include <annulus/annulus.h>

#include <support/catch.h>
#include <support/failing_new.h>
#include <support/meshes.h>

#include <functional>
#include <string>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
std::vector<double> numbers(const Points_d<d>& x) {
    std::vector<double> out;
    for (const auto& p : x) out.insert(out.end(), p.begin(), p.end());
    return out;
}

std::vector<double> points_of(const annulus_mesh* mesh, int d) {
    std::size_t bound = 0;
    REQUIRE(annulus_index_bound(mesh, &bound) == ANNULUS_OK);
    std::vector<double> x(bound * static_cast<std::size_t>(d));
    REQUIRE(annulus_points(mesh, bound, x.data()) == ANNULUS_OK);
    return x;
}

bool is_delaunay(const annulus_mesh* mesh) {
    annulus_audit_result audit{};
    audit.size = sizeof audit;
    return annulus_audit(mesh, &audit) == ANNULUS_OK && audit.delaunay == 1;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("A call of the C interface that runs out of memory says so, and the mesh goes on, dimension",
                       "[c]", ((int d), d), 2, 3) {
    struct Call {
        std::string name;
        std::function<int(annulus_mesh*)> make;
    };
    const std::vector<double> x = numbers<d>(grid<d>());
    const std::vector<double> far = numbers<d>(sheared<d>(grid<d>(), 0.7));
    const std::vector<double> there(2 * d, 1.3);
    const std::size_t n = x.size() / d;
    std::vector<double> lengths(n);
    std::vector<Index> some{3, 5};
    std::vector<double> two(there);
    two[0] = 1.2;
    std::vector<Index> fresh(2);
    std::size_t count = 0;
    annulus_audit_result audit{};
    audit.size = sizeof audit;
    const std::vector<Call> calls{
        {"move_all", [&](auto* m) { return annulus_move_all(m, n, far.data(), nullptr); }},
        {"move", [&](auto* m) { return annulus_move(m, 2, some.data(), two.data(), nullptr); }},
        {"insert", [&](auto* m) { return annulus_insert(m, 2, two.data(), fresh.data(), &count, nullptr); }},
        {"remove", [&](auto* m) { return annulus_remove(m, 2, some.data(), &count, nullptr); }},
        {"recompute_tolerances", [&](auto* m) { return annulus_recompute_tolerances(m, nullptr); }},
        {"tolerances", [&](auto* m) { return annulus_tolerances(m, n, lengths.data()); }},
        {"voronoi", [&](auto* m) { return annulus_voronoi(m, n, lengths.data(), nullptr); }},
        {"cells", [&](auto* m) { return annulus_cells(m, 0, nullptr, nullptr, &count); }},
        {"edges_made", [&](auto* m) { return annulus_edges_made(m, 0, nullptr, &count); }},
        {"t1", [&](auto* m) { return d == 2 ? annulus_t1(m, 0, nullptr, &count) : int{ANNULUS_OK}; }},
        {"audit", [&](auto* m) { return annulus_audit(m, &audit); }}};
    for (const Call& call : calls)
        for (const Memory memory : {Memory::short_once, Memory::short_for_good}) {
            bool done = false;
            for (std::uint64_t k = 0; !done && k < 100000; k += 1 + k / 2) {
                CAPTURE(call.name, static_cast<int>(memory), k);
                annulus_options options{};
                options.size = sizeof options;
                options.report_changes = 1;
                annulus_mesh* mesh = nullptr;
                REQUIRE(annulus_create(&mesh, d, n, x.data(), &options) == ANNULUS_OK);
                int status = ANNULUS_INTERNAL;
                bool failed = false;
                {
                    const Failing_new armed(k, memory);
                    status = call.make(mesh);
                    failed = Failing_new::failed();
                }
                done = !failed;
                if (!failed) REQUIRE(status == ANNULUS_OK);
                else REQUIRE((status == ANNULUS_OK || status == ANNULUS_NO_MEMORY));
                if (status == ANNULUS_NO_MEMORY) {
                    char text[40];
                    (void)annulus_message(mesh, text, sizeof text);
                    REQUIRE(std::string(text) == "memory ran out");
                    if (call.name != "insert" && call.name != "remove") REQUIRE(points_of(mesh, d) == x);
                    if (memory == Memory::short_for_good)
                        REQUIRE(annulus_recompute_tolerances(mesh, nullptr) ==
                                ANNULUS_OK);  // there may have been no cells
                }
                REQUIRE(is_delaunay(mesh));
                annulus_destroy(&mesh);
            }
            REQUIRE(done);
        }
    // Construction leaves no handle.
    bool done = false;
    for (std::uint64_t k = 0; !done && k < 100000; k += 1 + k / 2) {
        annulus_mesh* mesh = nullptr;
        int status = ANNULUS_INTERNAL;
        {
            const Failing_new armed(k);
            status = annulus_create(&mesh, d, n, x.data(), nullptr);
            done = !Failing_new::failed();
        }
        CAPTURE(k, status);
        REQUIRE((status == ANNULUS_OK) == (mesh != nullptr));
        REQUIRE((status == ANNULUS_OK || status == ANNULUS_NO_MEMORY));
        annulus_destroy(&mesh);
    }
    REQUIRE(done);
}
