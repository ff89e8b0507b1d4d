// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_fault.h"
#include "temporary_directory.h"

#include <apps/formats/read_motion.h>
#include <apps/formats/read_points.h>

#include <support/catch.h>

#include <vector>

using namespace annulus;
using annulus_test::expect_fault;
using annulus_test::Temporary_directory;

namespace {

using Points_3 = std::vector<Coordinates<3>>;
using Numbers = std::vector<std::uint64_t>;

const std::string upright = "ff ff ff\n0 10\n-5 5\n2 4\n";

/// A frame of two atoms, with the words that follow BOX BOUNDS and its three lines.
std::string frame(const std::string& timestep, const std::string& box, const std::string& columns,
                  const std::string& one, const std::string& two) {
    return "ITEM: TIMESTEP\n" + timestep + "\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS " + box + "ITEM: ATOMS " +
           columns + "\n" + one + "\n" + two + "\n";
}

Recorded_motion accept(std::string_view content) {
    const Temporary_directory directory;
    return read_motion(directory.file("a.lammpstrj", content), {.box = {.ignored = true}});
}

void refuse(std::string_view content, std::uint64_t line, const std::string& fault,
            Error_code code = Error_code::bad_input) {
    const Temporary_directory directory;
    expect_fault(
        directory.file("a.dump", content), line, fault, [](const auto& file) { (void)read_motion(file); }, code);
}

}  // namespace

TEST_CASE("LAMMPS: atoms by id, in any order, with columns in any place", "[io][lammps]") {
    const Recorded_motion motion = accept("ITEM: UNITS\nlj\nITEM: TIME\n0.5\n" +
                                          frame("100", upright, "type y x id z vx", "1 2 1 9 3 0", "1 5 4 7 6 0") +
                                          frame("50", upright, "id x y z", "7 4 5 6.5", "9 1 2 3.5"));
    REQUIRE(motion.frames.size() == 2);
    CHECK(motion.has_z);
    CHECK(motion.notes.empty());
    CHECK(motion.frames[0].number == 100);
    CHECK(motion.frames[1].number == 50);  // a run that began again; frames without atoms are there, so no gap is one
    for (const Frame& f : motion.frames) CHECK(f.id == Numbers{7, 9});
    CHECK(motion.frames[0].position == Points_3{{4, 5, 6}, {1, 2, 3}});
    CHECK(motion.frames[0].line == Numbers{15, 14});
    CHECK(motion.frames[1].position == Points_3{{4, 5, 6.5}, {1, 2, 3.5}});
    const Recorded_motion places = accept(frame("0", upright, "x y", "1 2", "3 4"));
    CHECK_FALSE(places.has_z);
    CHECK(places.frames[0].id == Numbers{0, 1});
    const Temporary_directory directory;
    CHECK(
        read_points<3>(directory.file("a.lammpsdump", frame("0", upright, "id x y z", "7 4 5 6", "7 1 2 3"))).points ==
        Points_3{{4, 5, 6}, {1, 2, 3}});
}

TEST_CASE("LAMMPS: of several kinds of positions a motion has the unwrapped ones first, points the plain ones",
          "[io][lammps]") {
    const auto first = [](const std::string& box, const std::string& columns, const std::string& row) {
        return accept(frame("0", box, columns, row, row)).frames[0].position[0];
    };
    const auto point = [](const std::string& columns, const std::string& row) {
        const Temporary_directory directory;
        return read_points<3>(directory.file("a.dump", frame("0", upright, columns, row, row))).points[0];
    };
    CHECK(first(upright, "xs ys zs x y z xu yu zu", "9 9 9 8 8 8 1 2 3") == Coordinates<3>{1, 2, 3});
    CHECK(first(upright, "xsu ysu zsu x y z", "9 9 9 1 2 3") == Coordinates<3>{90, 85, 20});
    CHECK(first(upright, "xs ys zs x y z", "9 9 9 1 2 3") == Coordinates<3>{1, 2, 3});
    CHECK(first(upright, "xs ys zs xu yu zu", "9 9 9 1 2 3") == Coordinates<3>{1, 2, 3});
    CHECK(point("xs ys zs xu yu zu x y z", "9 9 9 8 8 8 1 2 3") == Coordinates<3>{1, 2, 3});
    CHECK(point("xs ys zs xu yu zu", "9 9 9 1 2 3") == Coordinates<3>{1, 2, 3});
    CHECK(first(upright, "xs ys zs", "0.5 0 1") == Coordinates<3>{5, -5, 4});
    CHECK(first(upright, "xsu ysu zsu", "2 0 -1") == Coordinates<3>{20, -5, 0});
    // x without y is not a position.
    CHECK(first(upright, "x xu yu zu", "9 1 2 3") == Coordinates<3>{1, 2, 3});
    // Edges (10, 0, 0), (2, 10, 0) and (-3, 1, 10) from the corner (0, 0, 0): the box around it begins at -3.
    const std::string oblique = "xy xz yz pp pp pp\n-3 12 2\n0 11 -3\n0 10 1\n";
    CHECK(first(oblique, "xs ys zs", "0 0 0") == Coordinates<3>{0, 0, 0});
    CHECK(first(oblique, "xs ys zs", "1 0 0") == Coordinates<3>{10, 0, 0});
    CHECK(first(oblique, "xs ys zs", "0 1 0") == Coordinates<3>{2, 10, 0});
    CHECK(first(oblique, "xs ys zs", "0 0 1") == Coordinates<3>{-3, 1, 10});
    const std::string general = "abc origin pp pp pp\n0 10 0 1\n-10 0 0 2\n0 0 10 3\n";
    CHECK(first(general, "xs ys zs", "0.5 0 0") == Coordinates<3>{1, 7, 3});
    CHECK(first(general, "xs ys zs", "0 0.5 1") == Coordinates<3>{-4, 2, 13});
}

TEST_CASE("LAMMPS: a motion is unwrapped by images, points are not", "[io][lammps]") {
    const auto first = [](const std::string& box, const std::string& columns, const std::string& row) {
        return accept(frame("0", box, columns, row, row)).frames[0].position[0];
    };
    CHECK(first(upright, "x y z ix iy iz", "1 2 3 1 -2 0") == Coordinates<3>{11, -18, 3});
    CHECK(first(upright, "iz iy ix z y x", "0 -2 1 3 2 1") == Coordinates<3>{11, -18, 3});
    CHECK(first(upright, "xs ys zs ix iy iz", "0.5 0 1 1 0 -1") == Coordinates<3>{15, -5, 2});
    CHECK(first(upright, "x y ix iy", "1 2 1 -2") == Coordinates<3>{11, -18, 0});
    CHECK(first(upright, "x y z xu yu zu ix iy iz", "9 9 9 1 2 3 7 7 7") == Coordinates<3>{1, 2, 3});
    CHECK(first(upright, "xsu ysu zsu x y z ix iy iz", "9 9 9 1 2 3 1 0 0") == Coordinates<3>{11, 2, 3});
    // Edges (10, 0, 0), (2, 10, 0) and (-3, 1, 10).
    const std::string oblique = "xy xz yz pp pp pp\n-3 12 2\n0 11 -3\n0 10 1\n";
    CHECK(first(oblique, "x y z ix iy iz", "1 1 1 0 2 0") == Coordinates<3>{5, 21, 1});
    CHECK(first(oblique, "x y z ix iy iz", "1 1 1 1 0 -1") == Coordinates<3>{14, 0, -9});
    // Images are those of each axis that there is, and of a box.
    const auto notes = [](const std::string& content) { return accept(content).notes; };
    REQUIRE(notes(frame("0", upright, "x y z ix iy", "1 2 3 1 1", "2 2 2 1 1")).size() == 1);
    CHECK(notes(frame("0", upright, "x y z ix iy iz", "1 2 3 1 1 1", "2 2 2 1 1 1")).empty());
    const std::string boxless = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS x y ix iy\n1 2 3 4\n";
    CHECK(accept(boxless).frames[0].position == Points_3{{1, 2, 0}});
    CHECK(notes(boxless)[0].find("not used: ix iy; positions are as written") != std::string::npos);
    refuse(frame("0", upright, "x y ix iy", "1 2 0 0.5", "2 2 0 0"), 10, "iy is not an integer: '0.5'");
    refuse(frame("0", upright, "x y ix iy", "1 2 1e308 0", "2 2 0 0"), 10,
           "x is too large for a double once multiplied", Error_code::not_finite);
    refuse(frame("0", upright, "x y ix iy", "1 2 0 0", "2 2 0 0") + frame("1", upright, "x y", "1 2", "2 2"), 20,
           "positions are x .. here, and x with ix .. in frames before");
    const Temporary_directory directory;
    const auto file = directory.file("a.dump", frame("0", upright, "x y z ix iy iz", "1 2 3 1 0 0", "2 2 2 0 0 0"));
    const auto points = read_points<3>(file);
    CHECK(points.points[0] == Coordinates<3>{1, 2, 3});
    REQUIRE(points.notes.size() == 1);
    CHECK(points.notes[0].find("not used: ix iy iz") != std::string::npos);
    Motion_reader reader(file);
    Frame frame_0;
    CHECK(reader.next(frame_0));
    CHECK(reader.columns() == Taken_columns{{"id", place_as_id},
                                            {"x", "column 1 (x) and column 4 (ix)"},
                                            {"y", "column 2 (y) and column 5 (iy)"},
                                            {"z", "column 3 (z) and column 6 (iz)"}});
}

TEST_CASE("LAMMPS: of several kinds of positions one that is there in full, and the same in every frame",
          "[io][lammps]") {
    const Recorded_motion motion = accept(frame("0", upright, "id x y xs ys zs", "1 9 9 0.5 0 1", "2 9 9 1 1 1"));
    CHECK(motion.has_z);
    CHECK(motion.frames[0].position[0] == Coordinates<3>{5, -5, 4});
    CHECK(accept(frame("0", upright, "zu x y yu xu", "3 9 9 2 1", "3 9 9 2 1")).frames[0].position[0] ==
          Coordinates<3>{1, 2, 3});
    CHECK_FALSE(accept(frame("0", upright, "x y xs ys", "1 2 0 0", "3 4 0 0")).has_z);
    CHECK(accept(frame("0", upright, "x y xs ys", "1 2 0 0", "3 4 0 0")).frames[0].position[0] ==
          Coordinates<3>{1, 2, 0});
    for (const char* columns : {"x y zs", "x y zu", "xu yu z", "zsu xs ys"})
        refuse(frame("0", upright, columns, "0 0 0", "1 1 1"), 9, "and of z only z");
    refuse(frame("0", upright, "x y z", "0 0 0", "1 1 1") + frame("1", upright, "xu yu zu", "0 0 0", "1 1 1"), 20,
           "positions are xu .. here, and x .. in frames before");
    const Temporary_directory directory;
    const auto points =
        read_points<3>(directory.file("a.dump", frame("0", upright, "id x y zs ys xs", "1 0 0 0 0 0", "2 0 0 1 1 1")));
    CHECK(points.columns == Taken_columns{{"x", "column 6 (xs)"}, {"y", "column 5 (ys)"}, {"z", "column 4 (zs)"}});
    CHECK_FALSE(points.ignored_box);
}

TEST_CASE("LAMMPS: a periodic box is refused, or announced and not obeyed", "[io][lammps]") {
    for (const char* sides : {"pp pp pp", "ff ff pf", "xy xz yz sm ff pp"}) {
        const std::string tilt = sides[0] == 'x' ? " 0" : "";
        const std::string box = std::string(sides) + "\n0 1" + tilt + "\n0 1" + tilt + "\n0 1" + tilt + "\n";
        const auto notes = accept(frame("0", box, "x y", "0 0", "1 1")).notes;
        refuse(frame("0", box, "x y", "0 0", "1 1"), 5, "a periodic box");
        REQUIRE(notes.size() == 1);
        CHECK(notes[0].find(":5: BOX BOUNDS ") != std::string::npos);
        CHECK(notes[0].find("ignored") != std::string::npos);
    }
    CHECK(accept(frame("0", "ff ss mm\n0 1\n0 1\n0 1\n", "x y", "0 0", "1 1")).notes.empty());
    // Columns that would unwrap them are used in motions; a note says where they are not.
    CHECK(accept(frame("0", upright, "x y ix iy xu yu", "0 0 0 0 0 0", "1 1 0 0 1 1")).notes.empty());
    CHECK(accept(frame("0", upright, "xu yu ix iy", "0 0 0 0", "1 1 0 0")).notes.empty());
    // Early versions did not write how the sides are: then they are as by default.
    refuse(frame("0", "\n0 1\n0 1\n0 1\n", "x y", "0 0", "1 1"), 5, "without a word on its sides");
    // A later frame decides, too, and so does the only one of a set of points.
    const std::string open = frame("0", upright, "x y", "0 0", "1 1"),
                      closed = frame("1", "pp ff ff\n0 1\n0 1\n0 1\n", "x y", "0 0", "1 1");
    refuse(open + closed, 16, "BOX BOUNDS pp ff ff: a periodic box");
    const Temporary_directory directory;
    const auto file = directory.file("a.dump", closed);
    expect_fault(file, 5, "a periodic box", [](const auto& f) { (void)read_points<2>(f); });
    CHECK(read_points<2>(file, {.box = {.ignored = true}}).ignored_box);
}

TEST_CASE("LAMMPS: frames without atoms are frames", "[io][lammps]") {
    const std::string empty =
        "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n0\nITEM: BOX BOUNDS " + upright + "ITEM: ATOMS id x y z\n";
    const Recorded_motion motion = accept(empty + frame("8", upright, "id x y", "1 0 0", "2 1 1") + empty);
    REQUIRE(motion.frames.size() == 3);
    CHECK(motion.frames[0].id.empty());
    CHECK(motion.frames[1].id.size() == 2);
    CHECK(motion.frames[2].id.empty());
    refuse(empty, 1, "has no points in any frame");
}

TEST_CASE("LAMMPS: what is no dump is refused at its line", "[io][lammps]") {
    const std::string good = frame("0", upright, "id x y z", "1 0 0 0", "2 1 1 1");
    for (const auto& [content, line, fault] : std::vector<std::tuple<std::string, std::uint64_t, std::string>>{
             {"", 1, "is empty"},
             {"\n\n", 1, "has no frames"},
             {"2\n\nH 0 0 0\nH 1 1 1\n", 1, "is '2'"},
             {"ITEM: ENTRIES index\n", 1, "is 'ITEM: ENTRIES index'"},
             {"ITEM: TIMESTEPS\n0\n", 1, "is 'ITEM: TIMESTEPS'"},
             {"ITEM: TIMESTEP", 1, "ends before the timestep"},
             {"ITEM: TIMESTEP\n-1\n", 2, "not an integer of 0 or more"},
             {"ITEM: TIMESTEP\n0 1\n", 2, "has 2 columns"},
             {"ITEM: TIMESTEP\n0\n", 2, "ends within a frame"},
             {"ITEM: TIMESTEP\n0\nITEM: TIMESTEP\n0\n", 3, "a second TIMESTEP"},
             {"ITEM: TIMESTEP\n0\nITEM: ATOMS id x y z\n", 3, "without ITEM: NUMBER OF ATOMS"},
             {"ITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS id x y z\n1 0 0 0\n", 3, "without ITEM: TIMESTEP"},
             {"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n9000000000000000000\n", 4, "says 9000000000000000000 points"},
             {"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2000000000\nITEM: ATOMS x y\n1 2\n", 6,
              "after 1 of 2000000000"},
             {"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS xs ys\n0 0\n", 5, "a box that is not there"},
             {"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS\n0 0\n", 5, "names no columns of positions"},
             {frame("0", upright, "id x z", "1 0 0", "2 1 1"), 9, "names no columns of positions"},
             {frame("0", upright, "id x y x", "1 0 0 0", "2 1 1 1"), 9, "two columns x"},
             {frame("0", upright, "id id x y", "1 1 0 0", "2 2 1 1"), 9, "two columns id"},
             {frame("0", upright, "id x y z", "1 0 0 0", "2 1 1"), 11, "has 3 columns"},
             {frame("0", upright, "id x y z", "1 0 0 0", "2 1 1 one"), 11, "z is not a number"},
             {frame("0", upright, "id x y z", "1 0 0 0", "1 1 1 1"), 11, "has the id 1 of line 10"},
             {frame("0", upright, "id x y z", "-1 0 0 0", "1 1 1 1"), 10, "the id is not an integer of 0 or more"},
             {frame("0", "ff ff ff\n0 1\n0 1 0\n0 1\n", "id x y z", "1 0 0 0", "1 1 1 1"), 7, "has 3 columns"},
             {frame("0", "ff ff ff\n0 1\n0 up\n0 1\n", "id x y z", "1 0 0 0", "1 1 1 1"), 7, "is not a number"},
             {good + frame("1", upright, "x y z", "0 0 0", "1 1 1"), 21, "has no id"},
             {good + frame("1", upright, "id x y", "1 0 0", "2 1 1"), 21, "has no z"},
             {good + good.substr(0, good.size() - 8), 21, "ends after 1 of 2 atoms"},
             {good + "3 2 2 2\n", 12, "is '3 2 2 2'"},
         }) {
        INFO(content);
        refuse(content, line, fault);
    }
    refuse(frame("0", upright, "id x y z", "1 0 nan 0", "2 1 1 1"), 10, "y is nan", Error_code::not_finite);
    refuse(frame("0", "ff ff ff\n0 1e300\n0 1\n0 1\n", "id xs ys zs", "1 0 0 0", "2 1e300 1 1"), 11,
           "x is too large for a double once multiplied", Error_code::not_finite);
    const Temporary_directory directory;
    expect_fault(directory.file("a.dump", good + good), 12, "a second frame after that of timestep 0",
                 [](const auto& file) { (void)read_points<3>(file); });
}
