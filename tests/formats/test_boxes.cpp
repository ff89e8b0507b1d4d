// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_fault.h"
#include "temporary_directory.h"

#include <apps/formats/read_motion.h>

#include <support/catch.h>

#include <array>
#include <string>
#include <vector>

using namespace annulus;
using annulus_test::expect_fault;
using annulus_test::Temporary_directory;

namespace {

using Vectors = std::array<Coordinates<3>, 3>;
using Directions = std::array<bool, 3>;

/// The boxes of the frames of a file whose boxes are taken.
std::vector<std::optional<File_box>> boxes(const std::string& name, const std::string& content) {
    const Temporary_directory directory;
    std::vector<std::optional<File_box>> result;
    for (const Frame& frame : read_motion(directory.file(name, content), {.box = {.taken = true}}).frames)
        result.push_back(frame.box);
    return result;
}

std::string xyz(const std::string& comment) { return "1\n" + comment + " Properties=pos:R:3\n1 2 3\n"; }

std::string dump(const std::string& sides, const std::string& bounds) {
    return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS" + sides + "\n" + bounds +
           "ITEM: ATOMS id x y z\n1 1 2 3\n";
}

File_box xyz_box(const std::string& comment) { return boxes("a.xyz", xyz(comment)).at(0).value(); }
File_box dump_box(const std::string& sides, const std::string& bounds) {
    return boxes("a.dump", dump(sides, bounds)).at(0).value();
}

void refuse(const std::string& comment, const std::string& fault) {
    const Temporary_directory directory;
    expect_fault(directory.file("a.xyz", xyz(comment)), 2, fault,
                 [](const auto& file) { (void)read_motion(file, {.box = {.taken = true}}); });
}

}  // namespace

TEST_CASE("Boxes of extended XYZ: vectors one after the other, directions", "[io][box]") {
    const File_box box = xyz_box("Lattice=\"1 2 3 4 5 6 7 8 10\" pbc=\"T F 1\"");
    CHECK(box.vectors == Vectors{{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}});
    CHECK(box.periodic == Directions{true, false, true});
    CHECK(box.what == "Lattice and pbc");
    CHECK(box.line == 2);
    CHECK(xyz_box("Lattice=\"1 0 0 0 1 0 0 0 1\"").periodic == Directions{true, true, true});
    CHECK(xyz_box("Lattice=\"1 0 0 0 1 0 0 0 1\" pbc=T").periodic == Directions{true, true, true});
    CHECK(xyz_box("cell=\"2 3 4\"").vectors == Vectors{{{2, 0, 0}, {0, 3, 0}, {0, 0, 4}}});
    CHECK(xyz_box("box=\"1, 2, 3, 4, 5, 6, 7, 8, 10\"").vectors == box.vectors);
    // Each frame has its own, or none.
    const auto both = boxes(
        "a.xyz", xyz("Lattice=\"1 0 0 0 1 0 0 0 1\"") + xyz("pbc=\"F F F\"") + xyz("Lattice=\"2 0 0 0 2 0 0 0 2\""));
    REQUIRE(both.size() == 3);
    CHECK(both[0]->vectors[0][0] == 1);
    CHECK_FALSE(both[1]);
    CHECK(both[2]->vectors[0][0] == 2);
    CHECK(both[2]->line == 8);
    refuse("pbc=\"T T T\"", "pbc: a periodic box of 0 numbers");
    refuse("Lattice=\"1 2 3\"", "Lattice: a periodic box of 3 numbers");
    refuse("cell=\"9 9 9 90 90 90\"", "cell: a periodic box of 6 numbers");
    refuse("Lattice=\"1 0 0 0 1 0 0 0 1\" pbc=\"T F\"", "pbc has 2 values");
}

TEST_CASE("Boxes of LAMMPS: upright, in the bounds of a tilted one, by vectors", "[io][lammps][box]") {
    const File_box upright = dump_box(" pp pp ff", "-1 3\n0 5\n2 4\n");
    CHECK(upright.vectors == Vectors{{{4, 0, 0}, {0, 5, 0}, {0, 0, 2}}});
    CHECK(upright.periodic == Directions{true, true, false});
    CHECK(upright.what == "BOX BOUNDS pp pp ff");
    CHECK(upright.line == 5);
    // Lengths 4, 3, 5 from (-1, 0.5, 2); xy = 1, xz = -0.5, yz = 0.75, and the bounds around it.
    const Vectors tilted{{{4, 0, 0}, {1, 3, 0}, {-0.5, 0.75, 5}}};
    CHECK(dump_box(" xy xz yz pp pp pp", "-1.5 4 1\n0.5 4.25 -0.5\n2 7 0.75\n").vectors == tilted);
    CHECK(dump_box(" abc origin pp pp pp", "4 0 0 -1\n1 3 0 0.5\n-0.5 0.75 5 2\n").vectors == tilted);
    CHECK(dump_box("", "0 1\n0 1\n0 1\n").periodic == Directions{true, true, true});  // of early versions
    CHECK_FALSE(boxes("a.dump", dump(" ff ss mm", "0 1\n0 1\n0 1\n")).at(0));
}

TEST_CASE("Boxes that are replaced are not looked at", "[io][box]") {
    const Temporary_directory directory;
    for (const char* const comment : {"Lattice=\"1 2\"", "pbc=\"T F\"", "Lattice=\"1 0 0 0 1 0 0 0 1\""}) {
        const Recorded_motion motion = read_motion(directory.file("a.xyz", xyz(comment)), {.box = {.replaced = true}});
        CHECK(motion.notes.empty());
        CHECK_FALSE(motion.frames.at(0).box);
    }
}
