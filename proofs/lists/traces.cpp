// SPDX-License-Identifier: GPL-3.0-or-later
// usage: traces SEED ROWS
//
// Random operations on Expiry_list of several capacities, and what became of the list, as rows of the list of replay in
// proofs/lists/check: capacity, operations, rest, earliest, ids in order, ids that take_reached visited.
#include <annulus/engine/expiry_list.h>

#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace {
using namespace annulus;
std::mt19937 generator;  // NOLINT(cert-msc32-c,cert-msc51-cpp): seeded in main
bool first = true;

std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(generator() % n); }

template <class T>
void list_of(const std::vector<T>& numbers) {
    std::printf("[");
    for (std::size_t i = 0; i < numbers.size(); ++i)
        std::printf("%s%ld", i > 0 ? "; " : "", static_cast<long>(numbers[i]));
    std::printf("]");
}

template <std::size_t capacity>
void row() {
    Expiry_list<capacity> list;
    std::vector<std::uint32_t> visited;
    const auto visit = [&](std::uint32_t id) { visited.push_back(id); };
    const std::uint32_t scale = below(2) == 0 ? 12 : 1000000;  // many ties, or none
    const auto bits = [&] { return 1 + below(scale) * (below(2) == 0 ? 1 : 7); };
    std::printf("%s(%zu%%nat, [", first ? "" : ";\n", capacity);
    first = false;
    const std::uint32_t operations = 1 + below(10);
    for (std::uint32_t k = 0; k < operations; ++k) {
        if (k > 0) std::printf("; ");
        const std::uint32_t b = bits();
        switch (below(10)) {
            case 0:
                std::printf("Clear");
                list.clear();
                break;
            case 1:
            case 2:
                std::printf("Take %u", b);
                list.take_reached(Expiry::of_bits(b).path_length(), visit);
                break;
            case 3: {
                std::vector<Expiry> expiry(below(30));
                std::vector<std::uint32_t> id;
                std::printf("Put_many [");
                for (Expiry& e : expiry) {
                    e = Expiry::of_bits(bits());
                    id.push_back(100 + 100 * k + static_cast<std::uint32_t>(id.size()));
                    std::printf("%s(%u, %u)", id.size() > 1 ? "; " : "", e.bits(), id.back());
                }
                std::printf("]");
                list.put_new(expiry, id);
                break;
            }
            case 4: {
                const std::uint32_t id = 50 + k;
                std::printf("Put_new %u %u", id, b);
                list.put_new(id, Expiry::of_bits(b));
                break;
            }
            default: {
                const std::uint32_t id = below(9);
                std::printf("Put %u %u", id, b);
                list.put(id, Expiry::of_bits(b));
            }
        }
    }
    std::printf("], (%u, %u, ", list.rest().bits(), list.earliest().bits());
    std::vector<std::uint32_t> ids;
    list.take_reached(1e308, [&](std::uint32_t id) { ids.push_back(id); });
    list_of(ids);
    std::printf(", ");
    list_of(visited);
    std::printf("))");
}
}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    generator.seed(static_cast<std::uint32_t>(std::atol(argv[1])));
    for (long i = 0; i < std::atol(argv[2]); i += 4) {
        row<1>();
        row<2>();
        row<6>();
        row<10>();
    }
}
