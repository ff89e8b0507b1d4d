// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_fault.h"
#include "gzip.h"
#include "temporary_directory.h"

#include <apps/formats/frame_points.h>
#include <apps/formats/read_motion.h>
#include <apps/formats/read_points.h>

#include <support/catch.h>

#include <cmath>
#include <vector>

using namespace annulus;
using annulus_test::expect_fault;
using annulus_test::gzip;
using annulus_test::Temporary_directory;

namespace {

using Points_3 = std::vector<Coordinates<3>>;
using Numbers = std::vector<std::uint64_t>;

Recorded_motion accept(const std::string& name, std::string_view content,
                       Absent_frames absent = Absent_frames::refuse) {
    const Temporary_directory directory;
    return read_motion(directory.file(name, content), {.absent = absent});
}

void refuse(const std::string& name, std::string_view content, std::uint64_t line, const std::string& fault,
            Error_code code = Error_code::bad_input) {
    const Temporary_directory directory;
    expect_fault(
        directory.file(name, content), line, fault, [](const auto& file) { (void)read_motion(file); }, code);
}

/// One frame of two points, 1 2 3 and 4 5 6, and the rows that announce them so.
std::string frame(const std::string& comment, const std::string& before, const std::string& after = "") {
    return "2\n" + comment + "\n" + before + "1 2 3" + after + "\n" + before + "4 5 6" + after + "\n";
}

}  // namespace

TEST_CASE("extended XYZ: Properties say where the coordinates are, for points and for motions", "[io][xyz]") {
    const Temporary_directory directory;
    const Points_3 expected{{1, 2, 3}, {4, 5, 6}};
    const std::string mass = "7.5 H ";
    for (const char* comment : {
             "Properties=mass:R:1:species:S:1:pos:R:3:q:I:2",
             "Time=1 Properties=\"mass:R:1:species:S:1:pos:R:3:q:I:2\" more",
             "energy=\"1 Properties=pos:R:3\" properties = mass:R:1:species:S:1:pos:R:3:q:I:2",
             "OtherProperties=pos:R:3 Properties='mass:R:1:species:S:1:pos:I:3:q:I:2'",
             "{a b}\tx=[1 2 Properties=3] Properties={mass:r:1:species:S:1:pos:r:3:q:I:2}",
             "n=\"a \\\"Properties=pos:R:3 \\\\\\\" b\" 'c\\' d' Properties=mass:R:1:species:S:1:pos:R:3:q:I:2",
             "\"a = b\" note=\"no end Properties=mass:R:1:species:S:1:pos:R:3:q:I:2",
         }) {
        INFO(comment);
        const auto file = directory.file("a.xyz", frame(comment, mass, " 8 9"));
        CHECK(read_points<3>(file).points == expected);
        const Recorded_motion motion = read_motion(file);
        REQUIRE(motion.frames.size() == 1);
        CHECK(motion.frames[0].position == expected);
        CHECK(motion.frames[0].id == Numbers{0, 1});
        CHECK(motion.has_z);
    }
    // A number of columns that no guess gets right.
    const auto flat = directory.file("a.xyz", "1\nProperties=pos:R:2:radius:R:1\n4 5 6\n");
    CHECK(read_points<2>(flat).points == std::vector<Coordinates<2>>{{4, 5}});
    CHECK_FALSE(read_motion(flat).has_z);
}

TEST_CASE("extended XYZ: Properties that say what cannot be are refused at their line", "[io][xyz]") {
    const Temporary_directory directory;
    for (const auto& [list, fault] : std::vector<std::pair<std::string, std::string>>{
             {"a:S:18446744073709551615:pos:R:3", "'a' 18446744073709551615 columns"},
             {"a:S:9223372036854775808:b:S:9223372036854775808:pos:R:3", "columns"},
             {"a:S:1048576:pos:R:3", "'pos' 3 columns"},
             {"a:S:99999999999999999999:pos:R:3", "is too large"},
             {"a:S:0:pos:R:3", "'a' 0 columns"},
             {"a:S:-1:pos:R:3", "not an integer of 0 or more"},
             {"a:S:one:pos:R:3", "not an integer of 0 or more"},
             {"species:S:1", "no pos"},
             {"pos:R:4", "pos 4 columns"},
             {"pos:R:1", "pos 1 column"},
             {"pos:S:3", "pos the type 'S'"},
             {"pos:R", "end within 'pos'"},
             {"pos", "end within 'pos'"},
             {"pos:R:3:a", "end within 'a'"},
             {"pos:R:3:pos:R:3", "pos twice"},
             {"pos:R:3:id:I:1:id:I:1", "id twice"},
             {"pos:R:3 Properties=pos:R:3", "a second Properties"},
             {":", "end within ''"},
         }) {
        INFO(list);
        const auto file = directory.file("a.xyz", frame("Properties=" + list, ""));
        expect_fault(file, 2, fault, [](const auto& f) { (void)read_motion(f); });
        expect_fault(file, 2, fault, [](const auto& f) { (void)read_points<3>(f); });
    }
    const auto wide = directory.file("a.xyz", frame("Properties=a:S:1000000:pos:R:3", "H "));
    expect_fault(wide, 3, "has 4 columns", [](const auto& f) { (void)read_motion(f); });
    expect_fault(wide, 3, "has 4 columns", [](const auto& f) { (void)read_points<3>(f); });
    const auto narrow = directory.file("a.xyz", frame("Properties=pos:R:3", "H "));
    expect_fault(narrow, 3, "has 4 columns", [](const auto& f) { (void)read_motion(f); });
}

TEST_CASE("extended XYZ: a point is known by its id, in any row", "[io][xyz]") {
    const std::string list = "Properties=id:I:1:mass:R:1:pos:R:3\n";
    const Recorded_motion motion = accept("a.xyz", "3\n" + list + "5 1 0 0 0\n9 1 1 0 0\n7 1 0 1 0\n" +  //
                                                       "3\n" + list + "9 1 1 0 1\n11 1 4 4 4\n5 1 0 0 1\n");
    REQUIRE(motion.frames.size() == 2);
    CHECK(motion.frames[0].id == Numbers{5, 7, 9});
    CHECK(motion.frames[0].position == Points_3{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}});
    CHECK(motion.frames[0].line == Numbers{3, 5, 4});
    CHECK(motion.frames[1].id == Numbers{5, 9, 11});
    CHECK(motion.frames[1].position == Points_3{{0, 0, 1}, {1, 0, 1}, {4, 4, 4}});
    refuse("a.xyz", "3\n" + list + "5 1 0 0 0\n9 1 1 0 0\n5 1 0 1 0\n", 5, "has the id 5 of line 3");
    refuse("a.xyz", "1\n" + list + "-5 1 0 0 0\n", 3, "the id is not an integer of 0 or more");
    refuse("a.xyz", "1\n" + list + "5 1 0 0 0\n1\n\n0 0 0\n", 6, "has no id");
    refuse("a.xyz", "1\n\n0 0 0\n1\n" + list + "5 1 0 0 0\n", 6, "has an id");
    // An id that is no whole number is a column like others.
    CHECK(accept("a.xyz", "1\nProperties=id:S:1:pos:R:3\nabc 0 0 0\n").frames[0].id == Numbers{0});
}

TEST_CASE("a periodic box is refused, or announced and not obeyed", "[io][xyz]") {
    const Temporary_directory directory;
    const std::string box = "Lattice=\"10 0 0 0 10 0 0 0 10\"";
    for (const auto& [comment, words] : std::vector<std::pair<std::string, std::string>>{
             {box, "Lattice ignored"},
             {box + " pbc=\"T F F\"", "Lattice and pbc ignored"},
             {"pbc=\"F F T\"", "pbc ignored"},
             {"pbc=[false, true, false]", "pbc ignored"},
             {"PBC=\"0 0 1\" " + box, "Lattice and pbc ignored"},
             {"cell=\"10 10 10\"", "cell ignored"},
             {"# CELL(abcABC):  10  10  10  90 90 90  Step: 0", "CELL(abcABC) ignored"},
             {"Box = [9, 9, 9, 90, 90, 90]", "Box ignored"},
             {"box=\"10 10 10\" pbc=\"F F F\"", ""},
             {"box=3 cell=water", ""},
             {box + " pbc=\"F F F\"", ""},  // then it is a box without a meaning for triangulations
             {"pbc=F", ""},
             {"Lattices=3 in words: Lattice and pbc", ""},
             {"title=\"Lattice=1 pbc=T\"", ""},
         }) {
        INFO(comment);
        const auto file = directory.file("a.xyz", frame(comment, "") + frame(comment, ""));
        const Periodic_box ignored{.ignored = true};
        const std::vector<std::string> notes = read_motion(file, {.box = ignored}).notes;
        REQUIRE(notes.size() == (words.empty() ? 0 : 1));
        if (!words.empty()) CHECK(notes[0].starts_with(file.string() + ":2: " + words));
        const auto one = directory.file("b.xyz", frame(comment, ""));
        const auto points = read_points<3>(one, {.box = ignored});
        CHECK(points.notes.size() == notes.size());
        CHECK(points.ignored_box == !words.empty());
        if (words.empty()) {
            CHECK(read_motion(file).notes.empty());
            continue;
        }
        expect_fault(file, 2, ": a periodic box", [](const auto& f) { (void)read_motion(f); });
        expect_fault(one, 2, ": a periodic box", [](const auto& f) { (void)read_points<3>(f); });
    }
}

TEST_CASE("frames without points are frames", "[io][motion]") {
    const Recorded_motion motion = accept("a.xyz", "0\nProperties=pos:R:3\n1\n\n1 2\n0\n\n\n2\n\n1 2\n3 4\n0\n\n");
    REQUIRE(motion.frames.size() == 5);
    CHECK_FALSE(motion.has_z);
    const std::size_t counts[] = {0, 1, 0, 2, 0};
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK(motion.frames[i].position.size() == counts[i]);
        CHECK(motion.frames[i].number == i);
    }
    CHECK(points_of<2>(motion.name, motion.frames[0], Coincident::refuse).x.empty());
    refuse("a.xyz", "0\n\n0\n\n", 1, "has no points in any frame");
    refuse("a.xyz", "\n# nothing\n", 1, "has no frames");
    refuse("a.csv", "frame,id,x,y\n", 1, "has no frames");
    refuse("a.xyz", "0", 1, "ends after its count");
    refuse("a.xyz", "0 0\n1 1\n", 1, "has 2 columns");
}

TEST_CASE("frames that are absent from CSV are refused, empty or skipped", "[io][motion]") {
    const std::string even = "frame,id,x,y\n10,1,0,0\n20,1,1,0\n20,2,5,5\n30,1,2,0\n";
    CHECK(accept("a.csv", even).frames.size() == 3);
    CHECK(accept("a.csv", "frame,id,x,y\n4,1,0,0\n90,1,1,0\n").frames.size() == 2);
    const std::string gap = even + "60,7,3,0\n70,1,3,0\n1000000000000000000,1,3,0\n";
    refuse("a.csv", gap, 6, "frame 60 after frame 30, where others are 10 apart");
    refuse("a.csv", "frame,id,x,y\n0,1,0,0\n2,1,0,0\n3,1,0,0\n", 4, "frame 3 after frame 2, where others are 2 apart");
    const auto numbers = [](const Recorded_motion& motion) {
        Numbers n;
        for (const Frame& f : motion.frames) n.push_back(f.number);
        return n;
    };
    CHECK(numbers(accept("a.csv", gap, Absent_frames::skip)) == Numbers{10, 20, 30, 60, 70, 1'000'000'000'000'000'000});
    const Recorded_motion filled = accept("a.csv", gap, Absent_frames::empty);
    CHECK(numbers(filled) == Numbers{10, 20, 30, 40, 60, 70, 80, 1'000'000'000'000'000'000});
    CHECK(filled.frames[3].id.empty());
    CHECK(filled.frames[4].id == Numbers{7});
    CHECK(filled.frames[6].id.empty());
}

TEST_CASE("points of a frame at one place are refused or merged", "[io][motion]") {
    const Recorded_motion motion =
        accept("a.csv", "frame,id,x,y,z\n3,8,0,0,1\n3,5,1,1,0\n3,2,-0,0,1\n3,9,0,0,1\n3,1,0,0,2\n");
    const Frame& frame = motion.frames[0];
    const auto space = points_of<3>(motion.name, frame, Coincident::merge);
    CHECK(space.id == Numbers{1, 2, 5});
    CHECK(space.x == Points_3{{0, 0, 2}, {0, 0, 1}, {1, 1, 0}});
    CHECK_FALSE(std::signbit(space.x[1][0]));
    CHECK(space.merged == 2);
    const auto plane = points_of<2>(motion.name, frame, Coincident::merge);
    CHECK(plane.id == Numbers{1, 5});
    CHECK(plane.merged == 3);
    expect_fault(
        motion.name, 2, "in frame 3 the point of id 8 is where that of id 2 is (line 4)",
        [&](const auto&) { (void)points_of<3>(motion.name, frame, Coincident::refuse); }, Error_code::duplicate_point);
    const Recorded_motion far = accept("a.csv", "frame,id,x,y\n3,8,0,0\n3,5,1e200,1\n");
    expect_fault(
        far.name, 3, "out of domain",
        [&](const auto&) { (void)points_of<2>(far.name, far.frames[0], Coincident::merge); },
        Error_code::out_of_domain);
}

TEST_CASE("images of one another in a frame are merged in its box", "[io][motion]") {
    const Box<2> box({{{1, 0}, {0.25, 2}}});
    Frame_points<2> frame{
        .id = {1, 4, 5, 7, 8}, .x = {{0.5, 0.5}, {0.75, 2.5}, {1e9, 0}, {-0.5, 0.5}, {0.5, 1}}, .merged = 2};
    const Frame_points<2> before = frame;
    try {
        merge_images(frame, box);
        FAIL("a point far from the box");
    } catch (const Error& error) {
        CHECK(error.code() == Error_code::out_of_domain);
        CHECK((error.vertices().size() == 1 && error.vertices()[0] == 2));
    }
    CHECK((frame.id == before.id && frame.x == before.x && frame.merged == before.merged));
    frame.x[2] = {0.5 + 0x1p-53, 0.5 - 0x1p-54};  // the same after rounding
    merge_images(frame, box);
    CHECK(frame.id == Numbers{1, 8});
    CHECK(frame.x == std::vector<Coordinates<2>>{{0.5, 0.5}, {0.5, 1}});
    CHECK(frame.merged == 5);
}

TEST_CASE("motions are read in capitals, packed, and with their header behind a #", "[io][motion]") {
    CHECK(accept("A.XYZ", "1\n\n1 2\n").frames.size() == 1);
    CHECK(accept("A.CSV.gz", gzip("Frame,ID,X,Y\n1,2,3,4\n")).frames[0].position == Points_3{{3, 4, 0}});
    CHECK(accept("a.csv", "# id,x,y,frame\n2,3,4,1\n").frames[0].position == Points_3{{3, 4, 0}});
    refuse("a.csv", "# x,y\n3,4\n", 2, "the header in the comment '# x,y' names no column frame");
    refuse("a.csv", "frame,id,x\n0,1,2\n", 1, "the header names no column y");
    refuse("a.csv", "frame,id,x,y\n#1,2,3,4\n", 2, "the frame is not a number: '#1'");
    refuse("a.csv", "frame,id,id,x,y\n1,2,3,4,5\n", 1, "two columns id");
    refuse("a.pp", "0 0\n", 0, "unknown extension '.pp'");
}

TEST_CASE("a header in a comment that is none is shown, not looked for among the numbers", "[io][motion]") {
    refuse("a.csv", "# PeTrack project: a.pet\n# id frame q/m y/m z/m\n1\t0\t0\t0\t1.76\n", 3,
           "has no header but a comment, '# id frame q/m y/m z/m'");
    refuse("a.csv", "#framerate: 8.00\n#ID\tQ\tX\tY\tZ\n1\t0\t0\t0\t0\n", 3,
           "the header in the comment '#ID\\x09Q\\x09X\\x09Y\\x09Z' names no column frame");
    refuse("a.csv", "#ID\tQ\tX\tY\n# made today\n1\t0\t0\t0\n", 3, "in the comment '#ID\\x09Q\\x09X\\x09Y' names no");
    refuse("a.csv", "# ids by row\n\n0,1,2,3\n", 3, "has no header but a comment, '# ids by row'");
    refuse("a.csv", "0,1,2,3\n", 1, "has no header");
    refuse("a.csv", "0 1 2 3\n", 1, "has no header");
    CHECK(accept("a.csv", "# a,b\nframe,id,x,y\n1,2,3,4\n").frames[0].position == Points_3{{3, 4, 0}});
}
