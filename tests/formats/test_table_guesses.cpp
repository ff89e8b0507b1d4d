// SPDX-License-Identifier: GPL-3.0-or-later
// Tables: what is guessed is told, and what may be meant otherwise is refused.
#include "table_cases.h"

#include <apps/formats/printable.h>
#include <apps/formats/read_points.h>
#include <apps/formats/shared_ids.h>
#include <apps/formats/table_names.h>
#include <apps/formats/time_distances.h>

#include <support/catch.h>

#include <string>

using namespace annulus;
using namespace annulus_test;

namespace {

constexpr const char* comma = ", decimal comma";

/// By frame, one row for each id.
std::string table(const Words& times, const Words& ids = {"1", "2"}) {
    std::string text = "time,id,x,y\n";
    for (const std::string& time : times)
        for (std::size_t i = 0; i < ids.size(); ++i) text += time + "," + ids[i] + "," + std::to_string(i) + ",0\n";
    return text;
}

}  // namespace

TEST_CASE("tables: every name that is listed finds its column", "[io][tables]") {
    const auto columns = [](std::string_view frame, std::string_view id, const std::array<std::string_view, 3>& at) {
        std::string header = "q," + std::string(at[2]) + "," + std::string(id) + "," + std::string(at[1]);
        return accept(header + "," + std::string(frame) + "," + std::string(at[0]) + "\n9,3,7,2,0,1\n");
    };
    for (const std::string_view frame : frame_names)
        CHECK(columns(frame, "id", coordinate_names[0]).column("frame").starts_with("column 5 ("));
    for (const std::string_view id : id_names)
        CHECK(columns("t", id, coordinate_names[0]).column("id").starts_with("column 3 ("));
    for (const auto& names : coordinate_names)
        CHECK(columns("t", "id", names).frames[0].position == Points_3{{1, 2, 3}});
    CHECK(accept("Track_ID,Slice N\xb0,X (px),Local-Y,Local-X\n1,2,3,4,5\n").frames[0].position == Points_3{{5, 4, 0}});
}

TEST_CASE("tables: a comment begins with # or, where words follow, with %, * or //", "[io][tables]") {
    const std::string row = "0 1 2 3\n";
    for (const char* marks : {"#", "##", "# ", "%", "%% ", "* ", "// "}) {
        INFO(marks);
        const std::string mark = marks;
        CHECK(accept(mark + "25 fps, of 2023\n" + mark + "frame id x y\n" + row).frames[0].position ==
              Points_3{{2, 3, 0}});
        CHECK(accept(mark + "\nframe id x y\n" + row).frames[0].position == Points_3{{2, 3, 0}});
        const Temporary_directory directory;
        const auto file = directory.file("a.txt", mark + " 1 2\n3 4\n5 6\n");
        if (mark[0] == '#') CHECK(read_points<2>(file).points.size() == 2);
        else CHECK_THROWS_AS(read_points<2>(file), Input_error);  // no row is dropped
    }
    CHECK(accept("# id frame x y\n*a 0 1 2\n%b 0 3 4\n").ids[0] == Words{"*a", "%b"});
    CHECK(accept("/frame id x y\n" + row, "frame=1").column("frame") == "column 1 (/frame)");
    refuse("frame,id,x,y\n0,1,2,3\n% end\n", 3, "has 1 column");
}

TEST_CASE("tables: lines of separators alone are blank in a motion, and points without coordinates in a set",
          "[io][tables]") {
    for (const char* content :
         {"frame;id;x;y;;\n0;1;2;3;;\n;;;;;\n1;1;2;4;;\n;;;;;\n;;;;;\n",
          "frame;id;x;y;;\n;;;;;\n0;1;2;3;;\n1;1;2;4;;\n;;\n", "frame\tid\tx\ty\n\t\t\t\n0\t1\t2\t3\n1\t1\t2\t4\n"})
        CHECK(accept(content).numbers() == Numbers{0, 1});
    CHECK(accept("frame,id,x,y\n0,1,2,3\n,,,\n").notes.empty());
    refuse("frame,id,x,y\n0,1,2,3\n,1,,\n", 3, "the frame is missing");
    refuse("frame,id,x,y\n,,,\n", 1, "has no frames");
}

TEST_CASE("tables: a decimal comma is told", "[io][tables]") {
    CHECK(accept("frame;id;x;y\n0;1;2;3\n1;1;2,5;3\n").column("x") == std::string("column 3 (x)") + comma);
    CHECK(accept("frame;id;x;y\n1;1;2,5;3\n0;1;2;3\n").column("y") == std::string("column 4 (y)") + comma);
    CHECK(accept("frame;id;x;y\n0;1;2;3\n1;1;2.5;3\n").column("x") == "column 3 (x)");
    const Temporary_directory directory;
    const auto points = read_points<2>(directory.file("a.csv", "x;y\n1,500;2\n3;4\n"));
    CHECK(points.points[0] == Coordinates<2>{1.5, 2});
    CHECK(points.columns[1].second == std::string("column 2 (y)") + comma);
}

TEST_CASE("tables: times that differ by rounding are refused, and uneven ones are told", "[io][tables]") {
    const auto uneven = [](const Words& times) { return accept(table(times)).notes; };
    CHECK(uneven({"0", "0.1", "0.2", "0.30000000000000004", "0.4"}).empty());
    CHECK(uneven({"0.5", "1.9"}).empty());
    CHECK(uneven({"0.5"}).empty());
    CHECK(uneven({"1700000000.02", "1700000000.06", "1700000000.1"}).empty());
    CHECK(uneven({"0.5", "1.5", "2.99"}).empty());  // not quite one and a half times as far
    const Words notes = uneven({"0.5", "1.5", "3.25", "9"});
    REQUIRE(notes.size() == 1);
    CHECK(notes[0].ends_with("a.csv:6: the times of frames are 1 to 1.75 apart, and each is the next frame"));
    CHECK(uneven({"0.5", "9.5", "10.5"}).size() == 1);
    const std::string fault = "the time of this frame is 0.6000000000000001 after 0.6, which differ by rounding";
    refuse(table({"0.5", "0.6", "0.6000000000000001", "0.7"}), 6, fault);
    refuse(table({"0.6", "0.6000000000000001"}), 4, fault);
    refuse("time,id,x,y\n0.6000000000000001,1,0,0\n0.5,1,0,0\n0.6,2,0,0\n", 2, fault);  // sorted
    refuse(table({"0", "1", "1.000000001", "2"}), 6, "1.000000001 after 1, which differ by rounding");
    refuse(table({"0", "1", "1.000005", "3", "4"}), 6, "1.000005 after 1, which differ");  // seen when the next comes
    CHECK(accept(table({"0", "1", "1.00002", "3"})).frames.size() == 4);
    // Pauses: what is close by is as far apart as what is before or after it.
    for (const Words& pause : {Words{"0", "0.04", "5000", "5000.04", "5000.08"},
                               {"0", "0.04", "0.08", "5000"},
                               {"0", "0.000001", "1.5"},
                               {"0", "5000", "5000.04"},
                               {"0", "9000", "9000.04", "9000.08"}})
        CHECK(uneven(pause).size() == 1);
    with_pipe(table({"0.5", "0.6", "0.6000000000000001"}), [](const auto& pipe) {
        expect_fault(pipe, 6, "which differ by rounding", [](const auto& file) { (void)read(file); });
    });
    const Temporary_directory directory;
    const Motion skipped =
        read(directory.file("a.csv", table({"0.6", "0.6000000000000001", "5"})), {.absent = Absent_frames::skip});
    CHECK(skipped.numbers() == Numbers{0, 1, 2});
    CHECK(skipped.notes.empty());
    CHECK(accept(table({"3", "4", "5"})).notes.empty());  // numbers of frames
}

TEST_CASE("tables: ids of which none is in two frames in a row are told", "[io][tables]") {
    const auto notes = [](const std::string& rows) { return accept("frame,ID,x,y\n" + rows).notes; };
    const Words told = notes("0,1,0,0\n0,2,1,0\n1,3,0,0\n1,4,1,0\n2,1,0,0\n");
    REQUIRE(told.size() == 1);
    CHECK(told[0].find("no id is in two frames in a row: column 2 (ID) may not number tracks") != std::string::npos);
    CHECK(notes("0,1,0,0\n0,2,1,0\n1,3,0,0\n1,4,1,0\n2,4,0,0\n").empty());
    CHECK(notes("0,1,0,0\n0,2,1,0\n").empty());
    CHECK(notes("0,1,0,0\n1,1,nan,nan\n2,1,0,0\n").size() == 1);  // frames without points do not count
    Shared_ids shared;
    for (const Numbers& id : {Numbers{5, 9}, Numbers{1, 7}, Numbers{}, Numbers{2, 3, 7}}) shared.take(id);
    CHECK_FALSE(shared.none());
}

TEST_CASE("tables: as points, a motion is one set only if it has one frame", "[io][tables]") {
    const Temporary_directory directory;
    const auto points = [&](const std::string& content, const std::string& columns = {}) {
        return read_points<2>(directory.file("a.csv", content), {.columns = parse_column_choice(columns)})
            .points.size();
    };
    const std::string rows = "1,0,0,0\n2,0,1,0\n";
    for (const char* header : {"id,fr,x,y\n", "track_id,time,x,y\n"}) {
        const auto file = directory.file("b.csv", header + rows + "1,1,5,5\n");
        expect_fault(file, 4, "a second frame after frame 0, by column 2",
                     [](const auto& f) { (void)read_points<2>(f); });
        CHECK(points(header + rows) == 2);
        CHECK(points(header + rows + "1,1,5,5\n", "x=x,y=y") == 3);
    }
    expect_fault(directory.file("b.csv", "id,t,x,y\n1,0.5,0,0\n1,0.75,1,0\n"), 3, "a second frame, by column 2",
                 [](const auto& f) { (void)read_points<2>(f); });
    CHECK(points("name,t,x,y\n" + rows + "1,1,5,5\n") == 3);  // no ids: t may be anything
    CHECK(points("id,id,t,t,x,y\n1,1,0,0,5,5\n1,1,1,1,5,6\n") == 2);
}

TEST_CASE("names of columns are shown as text", "[io][tables]") {
    CHECK(printable("x [\xc2\xb5m]") == "x [\xc2\xb5m]");
    CHECK(printable("\x1b[31m\xb5\t") == "\xef\xbf\xbd[31m\xef\xbf\xbd\xef\xbf\xbd");
    CHECK(accept("frame,id,x [\x1b\xb5],y\n0,1,2,3\n").column("x") == "column 3 (x [\xef\xbf\xbd\xef\xbf\xbd])");
}
