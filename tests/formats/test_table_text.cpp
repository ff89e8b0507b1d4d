// SPDX-License-Identifier: GPL-3.0-or-later
// Tables as text: separators, numbers, lines around the rows.
#include "gzip.h"
#include "table_cases.h"

#include <apps/formats/csv_frames.h>
#include <apps/formats/frame_points.h>
#include <apps/formats/motion_reader.h>
#include <apps/formats/read_points.h>

#include <support/catch.h>

#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <thread>
#include <vector>

using namespace annulus;
using namespace annulus_test;

TEST_CASE("tables: separators, decimal commas, exponents", "[io][tables]") {
    const Points_3 expected{{1.5, -25, 0}, {3, 0.25, 0}};
    for (const char* content :
         {"frame;id;x;y\n0;1;1,5;-2,5e1\n0;2;3;0,25\n", "frame\tid\tx\ty\n0\t1\t1,5\t-25\n0\t2\t3\t0,25\n",
          "frame id x y\n0 1 1,5 -25\n0 2 3 ,25\n", "frame,id,x,y\n0,1,1.5D0,-2.5d+1\n0,2,3,2.5D-001\n",
          "  frame   id x y  \n 0  1 1.5 -25\n\n 0 2\t3 0.25 \n", "# frame id x y\n0 1 1.5 -25\n0 2 3 0.25\n",
          "frame,id,x,y\n0,1,1.5,-25,\n0,2,3,0.25\n", "# frame id x y\n0\t1\t1,5\t-25\n0\t2\t3\t0,25\n",
          "frame, id, x, y\r\n0, 1, 1.5, -25\r\n0, 2, 3, 0.25\r\n", "frame,id,x,y\n0;1;1,5;-25\n0;2;3;0,25\n"}) {
        INFO(content);
        CHECK(accept(content).frames[0].position == expected);
    }
    refuse("frame;id;x;y\n0;1;1,5;0\n0;2;1.5;0\n", 3, "x is '1.5', and numbers above have a decimal comma");
    refuse("frame;id;x;y\n0;1;1.5;0\n0;2;1,234;0\n", 3, "x is '1,234', and numbers above have a decimal point");
    refuse("frame;id;x;y\n0;1;1,234,567;0\n", 2, "x is not a number");
    refuse("frame,id,x,y\n0,1,1,5,0\n", 2, "has 5 columns");
    for (const char* extension : {"a.csv", "a.tsv", "a.txt", "a.dat", "a.TXT"})
        CHECK(accept("frame\tid\tx\ty\n0\t1\t2\t3\n", "", extension).frames.size() == 1);
    const Temporary_directory directory;
    CHECK(read_points<2>(directory.file("a.txt", "1 2\n3 4\n")).points == std::vector<Coordinates<2>>{{1, 2}, {3, 4}});
    CHECK(read_points<3>(directory.file("a.txt", "# x y z\n1 2 3\n")).points == Points_3{{1, 2, 3}});
}

TEST_CASE("tables: lines around the rows", "[io][tables]") {
    // A sentence is no header, unless rows are separated as it is.
    const Temporary_directory directory;
    CHECK(read_points<3>(directory.file("a.csv", "# x and y\n1,2,3\n")).points == Points_3{{1, 2, 3}});
    CHECK(accept("# x y id frame\nframe,id,x,y\n0,1,2,3\n").frames[0].position == Points_3{{2, 3, 0}});
    // Below the header three lines of words at the most, each with all columns.
    const std::string words = "a,b,c,d\n";
    CHECK(accept("frame,id,x,y\n" + words + words + words + "0,1,2,3\n").frames[0].line == Numbers{5});
    refuse("frame,id,x,y\n" + words + words + words + words + "0,1,2,3\n", 5, "the frame is not a number: 'a'");
    refuse("frame,id,x,y\na,b,c\n0,1,2,3\n", 2, "has 3 columns");
    CHECK(accept("frame,id,x,y\n# m, m\n#\n0,1,2,3\n").frames[0].line == Numbers{4});
    // Comments may end a table, and are rows where another row follows.
    CHECK(accept("frame,id,x,y\n0,1,2,3\n# made by hand\n\n#\n").frames.size() == 1);
    refuse("frame,id,x,y\n0,1,2,3\n# by hand\n0,2,3,4\n", 3, "has 1 column");
    refuse("frame,id,x,y\n0,1,2,3\n#0,2,3,4\n", 3, "the frame is not a number: '#0'");
    std::string comments;
    for (int i = 0; i < 1200; ++i) comments += "# a comment\n";
    CHECK(accept(comments + "title\nframe,id,x,y\n0,1,2,3\n").frames[0].line == Numbers{1203});
    // Text without an end is no table.
    refuse(
        [] {
            std::string text;
            for (int i = 0; i < 1002; ++i) text += "word\n";
            return text;
        }(),
        1001, "has 1000 lines without a number");
    refuse("these are words\nand more\n", 1, "the header names no column frame");
}
