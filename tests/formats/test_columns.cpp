// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_fault.h"
#include "temporary_directory.h"

#include <apps/formats/motion_reader.h>
#include <apps/formats/read_points.h>

#include <support/catch.h>

#include <vector>

using namespace annulus;
using annulus_test::expect_fault;
using annulus_test::Temporary_directory;

namespace {

using Points_3 = std::vector<Coordinates<3>>;

Points_3 points(const std::string& content) {
    const Temporary_directory directory;
    return read_points<3>(directory.file("a.xyz", content)).points;
}

void refuse(const std::string& content, std::uint64_t line, const std::string& fault,
            const std::string& name = "a.xyz") {
    const Temporary_directory directory;
    const auto file = directory.file(name, content);
    INFO(content);
    expect_fault(file, line, fault, [](const auto& f) { (void)read_points<3>(f); });
}

}  // namespace

TEST_CASE("xyz: rows alone are x, y and perhaps z, and nothing else", "[io][columns]") {
    // As voro++ has them, with an id, and with a radius behind; with normals; with an id in 2D.
    refuse("5 1.25 -3.5 0.5\n2 -1.5 4.5 0.75\n", 1, "has 4 columns, and nothing says which of them are x, y and z");
    refuse("1 2 3 0 0 1\n", 1, "has 6 columns");
    const Temporary_directory directory;
    const auto note = [&](const std::string& content) {
        return read_points<3>(directory.file("a.xyz", content)).notes;
    };
    REQUIRE(note("1 0.5 0.25\n2 1.5 0.25\n3 0.5 1.25\n").size() == 1);
    CHECK(note("1 0.5 0.25\n2 1.5 0.25\n3 0.5 1.25\n")[0].find("a.xyz:1: column 1 has integers as ids are") !=
          std::string::npos);
    CHECK(note("3\n\n0 0.5 0.25\n1 1.5 0.25\n2 0.5 1.25\n").size() == 1);
    CHECK(note("5 1.25 -3.5\n2 -1.5 4.5\n9 0.5 0.25\n").size() == 1);  // ids in any order
    CHECK(note("1 0.5 0.25\n1.5 1.5 0.25\n2 0.5 1.25\n").empty());
    CHECK(note("1 0 0\n2 1 0\n3 0 1\n").empty());
}

TEST_CASE("xyz: after a count the first column is stepped over if it is an element, and only then", "[io][columns]") {
    const std::string two = "2\n\n";
    const Points_3 expected{{0.5, 0.25, 1}, {1.5, 0.25, 2}};
    for (const char* lead : {"C", "H_2", "*", "6", "118", "13C", "Na", "D", "In", "@x"}) {
        INFO(lead);
        const std::string l = std::string(lead) + " ";
        CHECK(points(two + l + "0.5 0.25 1\n" + l + "1.5 0.25 2\n") == expected);
        CHECK(points(two + l + "0.5 0.25 1 -0.75 8\n" + l + "1.5 0.25 2 -0.75 9\n") == expected);
    }
    for (const char* lead : {"0.5", "-1", "0", "119", "1e0", "6.0", "1.5D+01", "1D5", "0,5", "1_000", "+6", "nan",
                             "99999999999999999999999"}) {
        INFO(lead);
        const std::string row = std::string(lead) + " 0.25 0.125 -1.5\n";
        refuse("1\n\n" + row, 3, std::string(lead) == "+6" ? "" : "which is no element");
        refuse("2\n\n6 0.25 0.125 -1.5\n" + row, 4, "");  // every row is checked
    }
    refuse("2\n\nC 0 0 0.5\n6 0 0 0.5\n", 4, "begins with '6', where rows above begin with the name of an element");
    refuse("2\n\n6 0 0 0.5\nC 0 0 0.5\n", 4, "begins with 'C', which is no element");
    // Four integers may be x y z charge, and the first of them no element.
    refuse("2\n\n1 0 0 -1\n2 0 0 1\n", 3, "has 4 columns of integers: the first may be x or an element");
    CHECK(points("2\n\n1 0 0 -1.0\n2 0 0 1.0\n") == Points_3{{0, 0, -1}, {0, 0, 1}});
    // A note says so, since x y z charge looks the same where every x is such a number.
    const Temporary_directory directory;
    const auto notes = read_points<3>(directory.file("a.xyz", two + "6 0.5 0.25 1\n8 1.5 0.25 2\n")).notes;
    REQUIRE(notes.size() == 1);
    CHECK(notes[0].find("a.xyz:3: column 1 is taken for atomic numbers, column 2 for x") != std::string::npos);
    CHECK(read_points<3>(directory.file("b.xyz", two + "C 0.5 0.25 1\nO 1.5 0.25 2\n")).notes.empty());
}

TEST_CASE("xyz: numbers beyond x, y and z are passed over only where x is no id and no type", "[io][columns]") {
    refuse("2\n\nC 1 0.5 0.5 0.5\nC 2 1.5 0.5 0.5\n", 3,
           "column 2, where x is to be, holds integers as ids and types do");
    refuse("2\n\n1 6 0.5 0.5 0.5\n2 6 1.5 0.5 0.5\n", 3, "column 2, where x is to be");
    refuse("3\n\nC 1 0 0 0\nC 2 1 0 0\nC 3 0 1 0\n", 3, "column 2, where x is to be");  // counts the rows
    refuse("2\n\n6 0 0 0 1\n6 1 0 0 1\n", 3, "has 5 columns of integers");
    CHECK(points("2\n\nC 0 0 0 1\nC 1 0 0 -1\n") ==
          Points_3{{0, 0, 0}, {1, 0, 0}});  // as all write elements and charges
    CHECK(points("2\n\nC 1 0.5 0.5\nC 2 1.5 0.5\n") == Points_3{{1, 0.5, 0.5}, {2, 1.5, 0.5}});
    // Announced columns need no guess.
    CHECK(points("2\nProperties=id:I:1:pos:R:3\n1 0.5 0.25 1\n2 1.5 0.25 2\n") ==
          Points_3{{0.5, 0.25, 1}, {1.5, 0.25, 2}});
    CHECK(points("1\nProperties=pos:R:3:charge:R:1\n0.5 0.25 1 -1.5\n") == Points_3{{0.5, 0.25, 1}});
}

TEST_CASE("xyz: a comment line that is missing is missed, and not the last point", "[io][columns]") {
    const std::string fault = "reads like a row of points in the place of the comment";
    refuse("4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n", 2, fault);
    refuse("2\nC 0 0 0\nC 1 0 0\n2\nC 0 0 0\nC 1 0 0\n", 2, fault);
    refuse("1\n0 0 0\n", 2, fault);
    CHECK(points("1\n0 0 0\n1 2 3\n") == Points_3{{1, 2, 3}});  // a comment may be numbers
    refuse("3\nbox 1 2\n0 0 0\n0 0 1\n", 4, "the file ends after 2 of 3 points");
    refuse("3\n\n0 0 0\n0 0 1\n", 4, "the file ends after 2 of 3 points");
}

TEST_CASE("csv: without a header there are x, y and z and nothing else", "[io][columns]") {
    refuse("1,0.5,0.25,2\n", 1, "has 4 columns and no header", "a.csv");
    refuse("7;1;2;3;4\n", 1, "has 5 columns and no header, so nothing says", "a.csv");
    refuse("# id q x/m y/m\n7;1;2;3\n", 2,
           "has 4 columns and no header but a comment, '# id q x/m y/m', so nothing says", "a.csv");
}

TEST_CASE("every format reports which column was taken for what", "[io][columns]") {
    const Temporary_directory directory;
    const auto taken = [&](const std::string& name, const std::string& content) {
        return read_points<3>(directory.file(name, content)).columns;
    };
    using T = Taken_columns;
    CHECK(taken("a.xyz", "1 2 3\n") == T{{"x", "column 1"}, {"y", "column 2"}, {"z", "column 3"}});
    CHECK(taken("a.xyz", "1\n\nC 1 2 3\n") == T{{"x", "column 2"}, {"y", "column 3"}, {"z", "column 4"}});
    CHECK(taken("a.xyz", "1\nProperties=m:R:1:pos:R:3\n5 1 2 3\n") ==
          T{{"x", "column 2 (pos)"}, {"y", "column 3 (pos)"}, {"z", "column 4 (pos)"}});
    CHECK(taken("a.csv", "z,name,Y,x\n1,2,3,4\n") ==
          T{{"x", "column 4 (x)"}, {"y", "column 3 (Y)"}, {"z", "column 1 (z)"}});
    CHECK(taken("a.csv", "1,2,3\n") == T{{"x", "column 1"}, {"y", "column 2"}, {"z", "column 3"}});
    CHECK(taken("a.off", "OFF\n1 0 0\n1 2 3\n") == T{{"x", "vertex x"}, {"y", "vertex y"}, {"z", "vertex z"}});
    CHECK(read_points<2>(directory.file("a.xyz", "1 2 3\n"), {.ignore_z = true}).columns ==
          T{{"x", "column 1"}, {"y", "column 2"}});
    const auto followed = [&](const std::string& name, const std::string& content) {
        Motion_reader reader(directory.file(name, content));
        for (Frame frame; reader.next(frame);) continue;
        return reader.columns();
    };
    CHECK(followed("a.csv", "id,frame,x,y\n1,0,2,3\n") ==
          T{{"frame", "column 2 (frame)"}, {"id", "column 1 (id)"}, {"x", "column 3 (x)"}, {"y", "column 4 (y)"}});
    CHECK(followed("a.xyz", "0\n\n1\n\nC 2 3\n") == T{{"id", place_as_id}, {"x", "column 2"}, {"y", "column 3"}});
}
