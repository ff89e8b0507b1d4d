// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/spec_boxes.h>

#include <annulus/error.h>
#include <apps/formats/given_box.h>
#include <apps/formats/number_list.h>

namespace annulus::inline v1 {

namespace {

template <int d>
void require_whole_cells(const Spec_table& t, const std::pair<std::string, Crystal>& crystal, const Spec_space& space,
                         std::uint64_t points) {
    const Box<d> box = box_of<d>(space.box, "'box'");
    const auto n = static_cast<std::size_t>(points);
    if (unit_cells<d>(box, crystal.second, n)) return;
    std::string fitting;
    for (const std::size_t m : numbers_that_fit<d>(box, crystal.second, n))
        fitting += (fitting.empty() ? "" : " or ") + std::to_string(m);
    t.fail("points",
           "'points' is " + std::to_string(points) + ", which whole unit cells of " + crystal.first +
               " in the box do not have",
           fitting.empty() ? "another number" : fitting);
}

}  // namespace

std::vector<Spec_space> boxes_of(const Spec_table& t) {
    std::vector<Spec_space> spaces;
    for (const std::string& words : t.texts("box", {})) {
        try {
            Spec_space space{2, parse_numbers("'box'", words)};
            space.dimension = dimension_of_box(space.box, "'box'");
            if (space.dimension == 2) (void)box_of<2>(space.box, "'box'");
            else (void)box_of<3>(space.box, "'box'");
            spaces.push_back(std::move(space));
        } catch (const Error& error) {
            t.fail("box", error.what(), "the lengths of its edges, as in \"2,1\", or its vectors, 4 or 9 numbers");
        }
    }
    return spaces;
}

void require_crystal_fits(const Spec_table& t, const std::pair<std::string, Crystal>& crystal,
                          const std::vector<Spec_space>& spaces, const std::vector<std::uint64_t>& points) {
    const int dimension = dimension_of(crystal.second);
    for (const Spec_space& space : spaces) {
        if (space.box.empty()) t.fail("kind", crystal.first + " is a crystal, which fills a periodic box", "a 'box'");
        if (space.dimension != dimension)
            t.fail("box", crystal.first + " is a crystal in " + std::to_string(dimension) + "D",
                   "a box in " + std::to_string(dimension) + "D");
        for (const std::uint64_t n : points)
            if (dimension == 2) require_whole_cells<2>(t, crystal, space, n);
            else require_whole_cells<3>(t, crystal, space, n);
    }
}

}  // namespace annulus::inline v1
