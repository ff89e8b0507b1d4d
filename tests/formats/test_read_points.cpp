// SPDX-License-Identifier: GPL-3.0-or-later
#include "gzip.h"
#include "point_cases.h"

#include <apps/formats/read_points.h>

#include <support/catch.h>

#include <vector>

using namespace annulus;
using namespace annulus_test;

TEST_CASE("xyz: plain lines of two or three columns") {
    const auto flat = accept<2>("a.xyz", "0 1\n-2.5e-3\t+4\n\n# comment\n 5 6 # more\n");
    CHECK(flat.points == Points_2{{0, 1}, {-2.5e-3, 4}, {5, 6}});
    CHECK(flat.lines == Lines{1, 2, 5});
    const auto solid = accept<3>("A.XYZ", "0 1 2\n3 4 5");
    CHECK(solid.points == Points_3{{0, 1, 2}, {3, 4, 5}});
}

TEST_CASE("xyz: count line, comment line, elements") {
    const auto solid = accept<3>("a.xyz", "2\nwater 1 2\nO 0 0 0.5\nH 1 2 3\n");
    CHECK(solid.points == Points_3{{0, 0, 0.5}, {1, 2, 3}});
    CHECK(solid.lines == Lines{3, 4});
    CHECK(accept<3>("a.xyz", "1\n\n6 1.0 2 3\n").points == Points_3{{1, 2, 3}});
    CHECK(accept<3>("a.xyz", "1\n\n1 2 3\n").points == Points_3{{1, 2, 3}});
    CHECK(accept<2>("a.xyz", "1\n\nC 1 2\n").points == Points_2{{1, 2}});
    CHECK(accept<2>("a.xyz", "1\n\n1 2\n").points == Points_2{{1, 2}});
    CHECK(accept<3>("a.xyz", "1\n\nIn 1 2 3 0.5\n").points == Points_3{{1, 2, 3}});
}

TEST_CASE("line ends of Windows, a byte order mark and a missing last line end are accepted in every text format") {
    const std::string mark = "\xef\xbb\xbf";
    CHECK(accept<2>("a.xyz", mark + "1 2\r\n3 4\r\n").points == Points_2{{1, 2}, {3, 4}});
    CHECK(accept<2>("a.csv", mark + "x,y\r\n1,2\r\n3,4").points == Points_2{{1, 2}, {3, 4}});
    CHECK(accept<3>("a.off", mark + "OFF\r\n1 0 0\r\n1 2 3\r\n").points == Points_3{{1, 2, 3}});
    CHECK(accept<2>("a.mesh", mark + "MeshVersionFormatted 1\r\nDimension 2\r\nVertices\r\n1\r\n1 2 0\r\nEnd\r\n")
              .points == Points_2{{1, 2}});
    CHECK(accept<3>("a.ply", mark + "ply\r\nformat ascii 1.0\r\nelement vertex 1\r\nproperty float x\r\n"
                                    "property float y\r\nproperty float z\r\nend_header\r\n1 2 3\r\n")
              .points == Points_3{{1, 2, 3}});
}

TEST_CASE("csv: columns by name or by place, three separators, quotes") {
    CHECK(accept<2>("a.csv", "1,2\n3,4\n").points == Points_2{{1, 2}, {3, 4}});
    CHECK(accept<3>("a.csv", "1;2;3\n").points == Points_3{{1, 2, 3}});
    CHECK(accept<3>("a.csv", "1\t2\t3\n").points == Points_3{{1, 2, 3}});
    const auto named = accept<2>("a.csv", "# made by hand\nid, \"Y\" ,name,X\n7, 2 ,\"a,b\",1\n\n8,\"4\",,3\n");
    CHECK(named.points == Points_2{{1, 2}, {3, 4}});
    CHECK(named.lines == Lines{3, 5});
    CHECK(accept<3>("a.csv", "z,y,x\n3,2,1\n").points == Points_3{{1, 2, 3}});
}

TEST_CASE("csv: lines that begin with # are comments before the first row only, and may be the header") {
    const auto named = accept<2>("a.csv", "# mine\nname,x,y\n#5,1,2\n#6,3,4\n");
    CHECK(named.points == Points_2{{1, 2}, {3, 4}});
    CHECK(accept<2>("a.csv", "# made by savetxt\n# y,x,mass\n2,1,9\n4,3,9\n").points == Points_2{{1, 2}, {3, 4}});
    CHECK(accept<2>("a.csv", "#y;x\n2;1\n").points == Points_2{{1, 2}});
    CHECK(accept<2>("a.csv", "# y,x\nx,y\n1,2\n").points == Points_2{{1, 2}});
    refuse<2>("a.csv", "1,2\n# a word\n3,4\n", 2, "has 1 column");
    refuse<2>("a.csv", "1,2\n#3,4\n", 2, "x is not a number: '#3'");
    refuse<2>("a.csv", "# y,x,mass\n1,2\n", 2, "has 2 columns");
}

TEST_CASE("csv: quotes are those of fields that begin with one, and end in their line") {
    CHECK(accept<2>("a.csv", "name,x,y\n5\",1,2\n \"a \"\"b\"\", c\" ,3,4\n\"\",5,6\n").points ==
          Points_2{{1, 2}, {3, 4}, {5, 6}});
    refuse<2>("a.csv", "x,y,name\n1,2,\"a\n3,4,b\"\n5,6,c\n", 2, "a quoted field does not end");
    refuse<2>("a.csv", "x,y,\"name\n1,2,3\n", 1, "a quoted field does not end");
    CHECK(accept<2>("a.csv", "# 5 \"x\nx,y\n1,2\n").points == Points_2{{1, 2}});
}

TEST_CASE("csv: a column of the header may have no name") {
    CHECK(accept<2>("a.csv", ",x,y\n0,1,2\n1,3,4\n").points == Points_2{{1, 2}, {3, 4}});
    CHECK(accept<2>("a.csv", "\"\";\"x\";\"y\"\n\"0\";1;2\n").points == Points_2{{1, 2}});
    refuse<2>("a.csv", ",1,2\n", 1, "x is missing");
    refuse<2>("a.csv", ",,\n", 1, "x is missing");
}

TEST_CASE("csv: frames of a motion are not points of one set") {
    CHECK(accept<2>("a.csv", "frame,id,x,y\n7,1,1,2\n7,1,3,4\n").points == Points_2{{1, 2}, {3, 4}});
    refuse<2>("a.csv", "frame,id,x,y\n7,1,1,2\n8,1,3,4\n", 3, "a second frame after frame 7");
}

TEST_CASE("off: comments, counts on the first line, variants with more columns, faces") {
    const std::string cube = "OFF # a comment\n# another\n\n3 1 0\n0 0 0\n1 0 0 # x\n0 1 0.5\n3 0 1 2\n";
    const auto file = accept<3>("a.off", cube);
    CHECK(file.points == Points_3{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}});
    CHECK(file.lines == Lines{5, 6, 7});
    CHECK(accept<3>("a.off", "OFF 1 0\n1 2 3\n").points == Points_3{{1, 2, 3}});
    CHECK(accept<3>("a.off", "COFF\n1 0 0\n1 2 3 255 0 0 255\n").points == Points_3{{1, 2, 3}});
    CHECK(accept<3>("a.off", "NOFF\n1 0 0\n1 2 3 0 0 1\n").points == Points_3{{1, 2, 3}});
    CHECK(accept<3>("a.off", "STCNOFF\n1 0 0\n1 2 3 0 0 1 9 9 9 0 0\n").points == Points_3{{1, 2, 3}});
}

TEST_CASE("mesh: dimensions 2 and 3, other sections stepped over") {
    const auto flat = accept<2>("a.mesh",
                                "MeshVersionFormatted\n2\n\nDimension\n2\n# c\nVertices 2\n1 2 0\n3 4 -1\n"
                                "Edges\n1\n1 2 0\nRidges\n1\n1\nStrange\n1 2 3\nEnd\n");
    CHECK(flat.points == Points_2{{1, 2}, {3, 4}});
    CHECK(flat.lines == Lines{8, 9});
    CHECK(accept<3>("a.mesh", "MeshVersionFormatted 1\nDimension 3\nVertices\n1\n1 2 3 0\n").points ==
          Points_3{{1, 2, 3}});
}

TEST_CASE("a z coordinate is refused in two dimensions unless ignored, and missed in three") {
    for (const auto& [name, content, line] : std::vector<std::tuple<std::string, std::string, std::uint64_t>>{
             {"a.xyz", "\n1 2 3\n", 2},
             {"a.xyz", "1\n\nC 1 2 0\n", 3},
             {"a.csv", "x,y,z\n1,2,3\n", 2},
             {"a.off", "OFF\n1 0 0\n1 2 3\n", 3},
             {"a.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n1\n1 2 3 0\nEnd\n", 5}}) {
        refuse<2>(name, content, line, "has a z coordinate; pass --ignore-z to drop it");
        CHECK(accept<2>(name, content, {.ignore_z = true}).points == Points_2{{1, 2}});
    }
    refuse<3>("a.xyz", "1 2\n", 1, "has no z coordinate");
    refuse<3>("a.csv", "x,y\n1,2\n", 2, "has no z coordinate");
}

TEST_CASE("files that are not there or say nothing are refused") {
    const Temporary_directory directory;
    const auto read = [](const auto& file) { (void)read_points<2>(file); };
    expect_fault(directory.path() / "none.xyz", 0, "does not exist", read);
    expect_fault(directory.path(), 0, "is a directory", read);
    expect_fault(directory.file("a.pp", "1 2\n"), 0, "unknown extension '.pp'", read);
    expect_fault(directory.file("a", "1 2\n"), 0, "has no extension", read);
    for (const char* name : {"a.xyz", "a.csv", "a.off", "a.ply", "a.mesh"})
        expect_fault(directory.file(name, ""), 1, "is empty", read);
    for (const char* name : {"a.xyz", "a.csv", "a.off", "a.mesh"})
        expect_fault(directory.file(name, "\n# nothing\n\n"), 1, "has no points", read);
    expect_fault(directory.file("a.csv", "x,y\n"), 1, "has no points", read);
    expect_fault(directory.file("a.xyz", "0\n\n"), 1, "has no points", read);
}

TEST_CASE("numbers that are none are refused at their line") {
    refuse<2>("a.xyz", "1 2\n3 four\n", 2, "y is not a number: 'four'");
    refuse<2>("a.xyz", "1 2\n3 4x\n", 2, "y is not a number: '4x'");
    refuse<2>("a.xyz", "1 2\n0x10 4\n", 2, "x is not a number");
    refuse<2>("a.xyz", "1 2\n--3 4\n", 2, "x is not a number");
    refuse<2>("a.xyz", "1 2\n+-3 4\n", 2, "x is not a number");
    refuse<2>("a.xyz", "1 2\n1,5 4\n", 2, "x is not a number");
    refuse<2>("a.xyz", "1 2\n\nnan 4\n", 3, "x is nan", Error_code::not_finite);
    refuse<2>("a.xyz", "1 2\n3 -inf\n", 2, "y is infinite", Error_code::not_finite);
    refuse<2>("a.xyz", "1 2\n3 1e309\n", 2, "too large for a double", Error_code::not_finite);
    refuse<3>("a.xyz", "1 2 3\n1 2 -1e999999999999999999999\n", 2, "z is infinite or too large",
              Error_code::not_finite);
    refuse<2>("a.csv", "x,y\n1,\n", 2, "y is missing");
    refuse<2>("a.csv", "x,y\n1,nan\n", 2, "y is nan", Error_code::not_finite);
    refuse<2>("a.csv", "1,a\n", 1, "y is not a number");
    refuse<3>("a.off", "OFF\n1 0 0\n1 2 inf\n", 3, "z is infinite", Error_code::not_finite);
    refuse<2>("a.mesh", "MeshVersionFormatted 2\nDimension 2\nVertices\n1\n1 nan 0\nEnd\n", 5, "y is nan",
              Error_code::not_finite);
    refuse<2>("a.mesh", "MeshVersionFormatted 2\nDimension 2\nVertices\n1\n1 2 0.5\nEnd\n", 5, "the reference");
}

TEST_CASE("lines with a wrong number of columns are refused") {
    refuse<2>("a.xyz", "1 2\n3\n", 2, "has 1 column");
    refuse<2>("a.xyz", "1 2\n3 4 5\n", 2, "has 3 columns");
    refuse<2>("a.xyz", "1\n\nC 1\n", 3, "has 2 columns");
    refuse<2>("a.csv", "x,y\n1,2\n1\n", 3, "has 1 column");
    refuse<2>("a.csv", "7\n", 1, "has 1 column");
    refuse<2>("a.csv", "lon,lat\n1,2\n", 1, "no column x");
    refuse<2>("a.csv", "x,lat\n1,2\n", 1, "no column y");
    refuse<2>("a.csv", "x,y,X\n1,2,3\n", 1, "two columns x");
    refuse<3>("a.off", "OFF\n1 0 0\n1 2\n", 3, "has 2 columns");
    refuse<3>("a.off", "OFF\n1 0 0\n1 2 3 4\n", 3, "has 4 columns");
    refuse<2>("a.mesh", "MeshVersionFormatted 2\nDimension 2\nVertices\n1\n1 2\nEnd\n", 5, "has 2 columns");
}

TEST_CASE("files that end early or hold more than they announce are refused") {
    refuse<3>("a.xyz", "3\nc\nC 1 2 3\nC 4 5 6\n", 4, "the file ends after 2 of 3 points");
    refuse<3>("a.xyz", "1\nc\nC 1 2 3\nC 4 5 6\n", 4, "more after the 1 point");
    refuse<3>("a.xyz", "3", 1, "ends after its count");
    refuse<3>("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0.25\n", 4, "ends after 2 of 3 vertices");
    refuse<3>("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n", 5, "ends after 0 of 1 faces");
    refuse<3>("a.off", "OFF\n2 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 5, "");
    refuse<3>("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", 6, "2 indices for a face of 3");
    refuse<3>("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n0\n", 6, "0 indices for a face of 0");
    refuse<3>("a.off", "OFF\n1 0 0\n0 0 0\n1 0 0\n", 4, "there is more");
    refuse<3>("a.off", "OFF\n", 1, "ends after its keyword");
    const std::string mesh = "MeshVersionFormatted 2\nDimension 2\nVertices\n";
    refuse<2>("a.mesh", mesh + "3\n1 2 0\n3 4 0\n", 6, "ends after 2 of 3 Vertices");
    refuse<2>("a.mesh", mesh + "2\n1 2 0\nTriangles\n1\n1 2 1 0\nEnd\n", 6, "only 1 of 2 Vertices");
    refuse<2>("a.mesh", mesh + "1\n1 2 0\n3 4 0\nEnd\n", 6, "where a keyword should be");
    refuse<2>("a.mesh", mesh, 3, "ends after Vertices");
    refuse<2>("a.mesh", "MeshVersionFormatted 2\n", 1, "without Dimension");
    refuse<2>("a.mesh", "MeshVersionFormatted 2\nDimension 2\nEnd\n1\n", 4, "more after End");
}

TEST_CASE("counts beyond the size of the file are refused before memory is allocated") {
    refuse<3>("a.xyz", "2000000000\n\nC 1 2 3\n", 3, "the file ends after 1 of 2000000000 points");
    refuse<3>("a.xyz", "9000000000000000000\n\nC 1 2 3\n", 1, "says 9000000000000000000 points");
    refuse<3>("a.xyz", "99999999999999999999\n\nC 1 2 3\n", 1, "is too large");
    refuse<3>("a.xyz", "-3\n\nC 1 2 3\n", 1, "is not an integer of 0 or more");
    refuse<3>("a.xyz", "2.0\n\nC 1 2 3\n", 1, "is not an integer of 0 or more");
    refuse<3>("a.off", "OFF\n2000000000 0 0\n1 2 3\n", 3, "ends after 1 of 2000000000 vertices");
    refuse<3>("a.off", "OFF\n4000000000 0 0\n1 2 3\n", 2, "says 4000000000 vertices");
    refuse<3>("a.off", "OFF\n1 9000000000000000000 0\n1 2 3\n", 3, "ends after 0 of 9000000000000000000 faces");
    const std::string mesh = "MeshVersionFormatted 2\nDimension 2\nVertices\n";
    refuse<2>("a.mesh", mesh + "2000000000\n1 2 0\n", 5, "ends after 1 of 2000000000 Vertices");
    refuse<2>("a.mesh", mesh + "4000000000\n1 2 0\n", 4, "says 4000000000 vertices");
    refuse<2>("a.mesh", mesh + "1\n1 2 0\nQuadrilaterals\n9000000000000000000\n1 2 0\n", 8,
              "ends after 1 of 9000000000000000000");
    refuse<2>("a.mesh", mesh + "1\n1 2 0\nEdges\n9000000000000000000\n1 2 0\n", 7, "says 9000000000000000000 Edges");
    const auto ply = [](const std::string& count) {
        return "ply\nformat ascii 1.0\nelement vertex " + count +
               "\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 2 3\n";
    };
    refuse<3>("a.ply", ply("2000000000"), 8, "ends after 1 of 2000000000");
    refuse<3>("a.ply", ply("4000000000"), 7, "says 4000000000 vertices");
}

TEST_CASE("files of another kind are refused") {
    const std::string garbage("\x89PNG\r\n\x1a\n\0\0\x1b[31m\xff\xfe", 16);
    for (const char* name : {"a.xyz", "a.csv", "a.off", "a.ply", "a.mesh"}) refuse<2>(name, garbage, 1, "");
    refuse<2>("a.xyz", "<html> <body>\n", 1, "x is not a number: '<html>'");
    refuse<3>("a.off", "4OFF\n1 0 0\n1 2 3 4\n", 1, "begins with '4OFF'");
    refuse<3>("a.off", "ply\n", 1, "begins with 'ply'");
    refuse<2>("a.mesh", "$MeshFormat\n", 1, "begins with '$MeshFormat'");
    refuse<2>("a.mesh", "MeshVersionFormatted 9\n", 1, "has version 9");
    refuse<2>("a.mesh", "MeshVersionFormatted 2\nDimension 4\n", 2, "has dimension 4");
    refuse<2>("a.mesh", "MeshVersionFormatted 2\nVertices\n1\n1 2 0\n", 2, "before Dimension");
    refuse<2>("a.mesh", "MeshVersionFormatted 2\nDimension 2\nDimension 2\n", 3, "a second Dimension");
}

TEST_CASE("a message stays on one line whatever the file and its name hold") {
    const Temporary_directory directory;
    const auto file = directory.file("a\nb\x1b.xyz", std::string("1 2\n\x1b[2J\a 2\n"));
    try {
        (void)read_points<2>(file);
        FAIL("was accepted");
    } catch (const Input_error& error) {
        const std::string what = error.what();
        CHECK(what.find('\n') == std::string::npos);
        CHECK(what.find('\x1b') == std::string::npos);
        CHECK(what.find("a\\x0ab\\x1b.xyz:2: x is not a number: '\\x1b[2J\\x07'") != std::string::npos);
    }
    CHECK(shown(std::string(100, 'a')) == "'" + std::string(40, 'a') + "...'");
}

TEST_CASE("faults found later name the line of the point") {
    const auto file = accept<2>("a.xyz", "1 2\n\n3 4\n");
    const Input_error error =
        file.fault(1, Error_code::duplicate_point, "lies where another point lies", "distinct points");
    CHECK(error.line() == 3);
    CHECK(error.code() == Error_code::duplicate_point);
    CHECK(std::string(error.what()) == file.name + ":3: lies where another point lies; expected distinct points");
}
