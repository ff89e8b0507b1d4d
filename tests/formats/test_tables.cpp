// SPDX-License-Identifier: GPL-3.0-or-later
#include "gzip.h"
#include "table_cases.h"

#include <apps/formats/csv_frames.h>
#include <apps/formats/frame_points.h>
#include <apps/formats/motion_reader.h>
#include <apps/formats/read_points.h>

#include <support/catch.h>

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <thread>
#include <vector>

using namespace annulus;
using namespace annulus_test;

TEST_CASE("tables: what tracking programs write is read, and the columns taken are reported", "[io][tables]") {
    const Motion petrack = accept(
        "# PeTrack project: a.pet\n# framerate: 25 fps\n# id frame x/m y/m\n1\t0\t0\t0\n1\t1\t0.5\t0\n2\t0\t1\t0\n"
        "2\t1\t1\t0.5\n3\t0\t0\t1\n3\t1\t0\t1\n4\t0\t1\t1.25\n4\t1\t1\t1.5\n",
        "", "a.txt");
    check_walk(petrack);
    CHECK(petrack.columns == Taken_columns{{"frame", "column 2 (frame), rows sorted by it"},
                                           {"id", "column 1 (id)"},
                                           {"x", "column 3 (x/m)"},
                                           {"y", "column 4 (y/m)"}});
    CHECK(petrack.notes.empty());
    const Motion jupedsim = accept(
        "#framerate: 8.00\n#geometry: a.xml\n#ID\tFR\tX\tY\tA\n1\t0\t0\t0\t9\n2\t0\t1\t0\t9\n3\t0\t0\t1\t9\n"
        "4\t0\t1\t1.25\t9\n1\t1\t0.5\t0\t9\n2\t1\t1\t0.5\t9\n3\t1\t0\t1\t9\n4\t1\t1\t1.5\t9\n");
    check_walk(jupedsim);
    CHECK(jupedsim.column("frame") == "column 2 (FR)");
    const Motion trackmate = accept(
        "LABEL,ID,TRACK_ID,POSITION_X,POSITION_Y,POSITION_T,FRAME\nLabel,Spot ID,Track ID,X,Y,T,Frame\n"
        "Label,Spot ID,Track ID,X,Y,T,Frame\n,,,(pixel),(pixel),(sec),\nID100,100,1,0,0,0.0,0\nID101,101,2,1,0,0.0,0\n"
        "ID102,102,3,0,1,0.0,0\nID103,103,4,1,1.25,0.0,0\nID104,104,1,0.5,0,0.1,1\nID105,105,2,1,0.5,0.1,1\n"
        "ID106,106,3,0,1,0.1,1\nID107,107,4,1,1.5,0.1,1\n");
    check_walk(trackmate);
    CHECK(trackmate.column("id") == "column 3 (TRACK_ID)");
    CHECK(trackmate.column("frame") == "column 7 (FRAME)");
    REQUIRE(trackmate.notes.size() == 1);
    CHECK(trackmate.notes[0].ends_with("a.csv:2: 3 lines without numbers below the header passed over"));
    const Motion pathfinder = accept(
        "\"t\",\"id\",\"name\",\"x\",\"y\"\n\"s\",\"\",\"\",\"m\",\"m\"\n0.0,1,\"A\",0,0\n0.0,2,\"B\",1,0\n0.0,3,\"C\","
        "0,1\n"
        "0.0,4,\"D\",1,1.25\n0.25,1,\"A\",0.5,0\n0.25,2,\"B\",1,0.5\n0.25,3,\"C\",0,1\n0.25,4,\"D\",1,1.5\n");
    check_walk(pathfinder);
    CHECK(pathfinder.column("frame") == "column 1 (t), times numbered from 0");
    const Motion trackpy = accept(
        ",y,x,mass,frame,particle\n0,0,0,9,0,1\n1,0,1,9,0,2\n2,1,0,9,0,3\n3,1.25,1,9,0,4\n4,0,0.5,9,1,1\n5,0.5,1,9,1,"
        "2\n"
        "6,1,0,9,1,3\n7,1.5,1,9,1,4\n");
    check_walk(trackpy);
    const Motion napari =
        accept("track_id,t,y,x\n1,0,0,0\n1,1,0,0.5\n2,0,0,1\n2,1,0.5,1\n3,0,1,0\n3,1,1,0\n4,0,1.25,1\n4,1,1.5,1\n");
    check_walk(napari);
    const Motion crowd_it = accept(
        "time,pedID,posX,posY\n0.0,1,0,0\n0.0,2,1,0\n0.0,3,0,1\n0.0,4,1,1.25\n0.4,1,0.5,0\n0.4,2,1,0.5\n0.4,3,0,1\n"
        "0.4,4,1,1.5\n");
    check_walk(crowd_it);
    // Imaris has text before the header, and an id of each position beside that of the track.
    const Motion imaris = accept(
        "Position\n====================\n\nPosition X,Position "
        "Y,Unit,Time,TrackID,ID,\n0,0,um,0,1,90,\n1,0,um,0,2,91,\n"
        "0,1,um,0,3,92,\n1,1.25,um,0,4,93,\n0.5,0,um,1,1,94,\n1,0.5,um,1,2,95,\n0,1,um,1,3,96,\n1,1.5,um,1,4,97,\n");
    check_walk(imaris);
    CHECK(imaris.column("id") == "column 5 (TrackID)");
}

TEST_CASE("tables: --columns says which column is what, by name or by number", "[io][tables]") {
    const std::string rows = "7,0,1,2,90\n8,0,3,4,91\n7,1,5,6,92\n";
    const Motion named = accept("cell,when,east,north,x\n" + rows, "id=cell,frame=when,x=east,y=north");
    CHECK(named.frames[0].position == Points_3{{1, 2, 0}, {3, 4, 0}});
    CHECK(named.columns == Taken_columns{{"frame", "column 2 (when)"},
                                         {"id", "column 1 (cell)"},
                                         {"x", "column 3 (east)"},
                                         {"y", "column 4 (north)"}});
    CHECK(accept("cell,when,east,north,x\n" + rows, "id=Cell,frame=WHEN,x=3,y=North").columns == named.columns);
    CHECK(accept(rows, "id=1,frame=2,x=3,y=4").frames[0].position == named.frames[0].position);
    CHECK(accept(rows, "id=1,frame=2,x=3,y=4,z=5").frames[0].position == Points_3{{1, 2, 90}, {3, 4, 91}});
    // Names of one kind of coordinates do not mix with those of another: z is taken only where it is given.
    const std::string both = "id,frame,x_um,y_um,z,x,y\n1,0,1,2,3,4,5\n";
    CHECK(accept(both).frames[0].position == Points_3{{4, 5, 3}});
    CHECK_FALSE(accept(both, "x=x_um,y=y_um").has_z);
    CHECK(accept(both, "x=x_um,y=y_um,z=z").frames[0].position == Points_3{{1, 2, 3}});
    refuse("id,frame,x,y\n1,0,1,2\n", 1, "the header names no column 'cell', which --columns gives for id", "id=cell");
    refuse("id,frame,x,y\n1,0,1,2\n", 1, "names no column '5'", "id=5");
    refuse("a,a,frame,x,y\n1,0,1,2,3\n", 1, "names two columns a", "id=a");
    refuse(rows, 1, "has 5 columns", "id=1,frame=2,x=3,y=2000000000");
    refuse(rows, 1, "has no header", "id=1,x=3,y=4");
    refuse(rows, 1, "has no header", "id=cell,frame=2,x=3,y=4");
    const Temporary_directory directory;
    const auto points = directory.file("a.csv", "lon,lat,x,y\n1,2,3,4\n");
    CHECK(read_points<2>(points, {.columns = parse_column_choice("x=lon,y=lat")}).points ==
          std::vector<Coordinates<2>>{{1, 2}});
    const auto four = directory.file("b.csv", "7,1,2,9\n");
    CHECK(read_points<2>(four, {.columns = parse_column_choice("x=2,y=3")}).points ==
          std::vector<Coordinates<2>>{{1, 2}});
    const auto usage = [](const auto& call) {
        try {
            call();
            FAIL("was accepted");
        } catch (const Error& error) {
            CHECK(error.code() == Error_code::usage);
        }
    };
    for (const char* text :
         {"id", "id=", "=a", "id=a,id=b", "q=a", "id=a,,x=b,y=c", "x=a", "y=a", "z=a", "x=a,z=b", ","})
        usage([&] { (void)parse_column_choice(text); });
    CHECK(is_empty(parse_column_choice("")));
    const Column_choice choice = parse_column_choice("id=a");
    usage([&] { (void)read(directory.file("a.xyz", "1\n\n1 2\n"), {.columns = choice}); });
    usage([&] { (void)read_points<3>(directory.file("a.off", "OFF\n1 0 0\n1 2 3\n"), {.columns = choice}); });
}

TEST_CASE("tables: of several columns that may be the same one is taken, the same every time", "[io][tables]") {
    const auto column = [](const std::string& names, const std::string& what) {
        return accept(names + "\n1,1,1,1,1,1\n").column(what);
    };
    CHECK(column("id,track_id,frame,x,y,q", "id") == "column 2 (track_id)");
    CHECK(column("particle,id,frame,x,y,q", "id") == "column 1 (particle)");
    CHECK(column("t,time,frame,id,x,y", "frame") == "column 3 (frame)");
    CHECK(column("time,t,id,x,y,q", "frame") == "column 2 (t)");
    CHECK(column("id,t,POSITION_X,POSITION_Y,x,q", "x") == "column 3 (POSITION_X)");  // x without y
    CHECK(column("id,t,POSITION_X,POSITION_Y,x,y", "x") == "column 5 (x)");
    CHECK(column("id,t,x (px),y [px],q,r", "y") == "column 4 (y [px])");
    CHECK(column("id,t,x,y,x/m,y/m", "x") == "column 3 (x)");
    refuse("id,t,x/m,x/cm,y\n1,1,1,1,1\n", 1, "names two columns x");
    refuse("id,t,x,q\n1,1,1,1\n", 1, "the header names no column y");
    refuse("name,t,x,y\n1,1,1,1\n", 1, "the header names no column id");
}

TEST_CASE("tables: rows in any order are read frame by frame, and as they are where frames ascend", "[io][tables]") {
    std::mt19937 random(5);
    const Temporary_directory directory;
    Words rows;
    for (int f = 0; f < 30; ++f)
        for (int i = 0; i < 40; ++i)
            if (random() % 5 > 0)
                rows.push_back(std::to_string(f) + "," + std::to_string(i) + "," + std::to_string(random() % 1000) +
                               "," + std::to_string(random() % 1000) + "\n");
    const auto table = [&](const Words& lines) {
        std::string text = "frame,id,x,y\n";
        for (const auto& line : lines) text += line;
        return text;
    };
    const Motion expected = read(directory.file("a.csv", table(rows)));
    CHECK(expected.column("frame") == "column 1 (frame)");
    for (int round = 0; round < 5; ++round) {
        std::shuffle(rows.begin(), rows.end(), random);
        const std::string text = table(rows);
        const auto file = directory.file("a.csv", text);
        const Motion motion = read(file);
        CHECK(motion.column("frame") == "column 1 (frame), rows sorted by it");
        REQUIRE(motion.numbers() == expected.numbers());
        for (std::size_t f = 0; f < motion.frames.size(); ++f) {
            CHECK(motion.frames[f].id == expected.frames[f].id);
            CHECK(motion.frames[f].position == expected.frames[f].position);
            CHECK(std::all_of(motion.frames[f].line.begin(), motion.frames[f].line.end(), [&](std::uint64_t line) {
                return rows[line - 2].starts_with(std::to_string(motion.frames[f].number) + ",");
            }));
        }
        CHECK(read(directory.file("a.csv.gz", gzip(text))).numbers() == expected.numbers());
        CHECK(is_flat(file));
    }
    with_pipe("frame,id,x,y\n1,1,0,0\n0,1,0,0\n", [](const auto& pipe) {
        expect_fault(pipe, 3, "frame 0 after frame 1", [](const auto& file) { (void)read(file); });
    });
    refuse("frame,id,x,y\n1,1,0,0\n0,1,0,0\n1,1,2,2\n", 4, "has the id 1 of line 2, in the same frame");
    refuse("frame,id,x,y\n1,1,0,0\n0,1,0,0\n1,2,2\n", 4, "has 3 columns");
    // Gaps are those of the sorted frames.
    const std::string gap = "frame,id,x,y\n6,1,0,0\n2,1,0,0\n4,1,0,0\n10,1,0,0\n";
    refuse(gap, 5, "frame 10 after frame 6, where others are 2 apart");
    const auto file = directory.file("a.csv", gap);
    CHECK(read(file, {.absent = Absent_frames::empty}).numbers() == Numbers{2, 4, 6, 8, 10});
    CHECK(read(file, {.absent = Absent_frames::skip}).numbers() == Numbers{2, 4, 6, 10});
}

TEST_CASE("tables: frames that came before a fault are there, though the file was read before", "[io][tables]") {
    const Temporary_directory directory;
    for (const char* fault : {"2,1,0", "2,1,0,y", "x,1,0,0", "2,1.5,0,0", "2,,0,0", "2,one,0,0", "2,1,\"0,0"}) {
        Motion_reader reader(directory.file("a.csv", "frame,id,x,y\n0,1,0,0\n1,1,1,0\n" + std::string(fault) + "\n"));
        Frame frame;
        INFO(fault);
        CHECK(reader.next(frame));
        if (std::string(fault) == "2,one,0,0") {  // then all ids are words
            CHECK(reader.ids().are_words());
            continue;
        }
        CHECK_THROWS_AS((reader.next(frame), reader.next(frame), reader.next(frame)), Input_error);
    }
}

TEST_CASE("tables: frames may be written as fractions, and be times", "[io][tables]") {
    const auto numbers = [](const std::string& rows) { return accept("frame,id,x,y\n" + rows).numbers(); };
    CHECK(numbers("0.0,1,0,0\n1.0,1,0,0\n2e0,1,0,0\n") == Numbers{0, 1, 2});
    CHECK(numbers("18446744073709551615,1,0,0\n") == Numbers{18446744073709551615u});
    CHECK(numbers("0,1,0,0\n0.04,1,0,0\n1,1,0,0\n7,1,0,0\n") == Numbers{0, 1, 2, 3});
    CHECK(numbers("-1,1,0,0\n0,1,0,0\n1,1,0,0\n") == Numbers{0, 1, 2});
    CHECK(numbers("0.04,1,0,0\n0,1,0,0\n-0.0,2,0,1\n") == Numbers{0, 1});
    CHECK(numbers("1e300,1,0,0\n") == Numbers{0});
    for (const char* rows : {"0,1,0,0\n0.5,1,0,0\n2,1,0,0\n", "0.5,1,0,0\n2,1,0,0\n-0.0,2,0,1\n"}) {
        std::vector<double> times;
        for (const Frame& frame : accept(std::string("frame,id,x,y\n") + rows).frames) times.push_back(frame.time);
        CHECK(times == std::vector<double>{0, 0.5, 2});
    }
    CHECK(std::isnan(accept("frame,id,x,y\n0.0,1,0,0\n").frames[0].time));
    CHECK(accept("frame,id,x,y\n0.04,1,0,0\n0,1,0,0\n").column("frame") ==
          "column 1 (frame), rows sorted by it, times numbered from 0");
    refuse("frame,id,x,y\n18446744073709551616,1,0,0\n", 2, "the frame is too large");
    refuse("frame,id,x,y\none,1,0,0\n", 2, "the frame is not a number");
    refuse("frame,id,x,y\n,1,0,0\n", 2, "the frame is missing");
    refuse("frame,id,x,y\nnan,1,0,0\n", 2, "the frame is nan", "", Error_code::not_finite);
    // Where a file is read once, its first two frames decide.
    with_pipe("t,id,x,y\n5,1,0,0\n5.5,1,0,0\n6,1,0,0\n", [](const auto& pipe) {
        CHECK(read(pipe).numbers() == Numbers{0, 1, 2});
    });
    with_pipe("t,id,x,y\n5,1,0,0\n6,1,0,0\n7,1,0,0\n", [](const auto& pipe) {
        CHECK(read(pipe).numbers() == Numbers{5, 6, 7});
    });
    with_pipe("t,id,x,y\n5,1,0,0\n6,1,0,0\n6.5,1,0,0\n", [](const auto& pipe) {
        expect_fault(pipe, 4, "the frame is 6.5, and those before are whole numbers",
                     [](const auto& file) { (void)read(file); });
    });
}

TEST_CASE("tables: ids are integers of either sign, or words", "[io][tables]") {
    const Motion negative = accept("frame,id,x,y\n0,-1,0,0\n0,3,1,0\n0,-7.0,2,0\n0,2.000e+00,3,0\n0,+4,4,0\n");
    CHECK(negative.ids[0] == Words{"2", "3", "4", "-7", "-1"});
    CHECK(negative.frames[0].position == Points_3{{3, 0, 0}, {1, 0, 0}, {4, 0, 0}, {2, 0, 0}, {0, 0, 0}});
    const Motion words = accept("frame,id,x,y\n0,cell_2,0,0\n0,cell_1,1,0\n1,cell_1,2,0\n1,\"a,b\",3,0\n1,7,4,0\n");
    CHECK(words.ids == std::vector<Words>{{"cell_2", "cell_1"}, {"cell_1", "a,b", "7"}});
    CHECK(words.frames[1].id == Numbers{1, 2, 3});
    CHECK(accept("frame,id,x,y\n0,18446744073709551615,0,0\n0,9223372036854775808,1,0\n").ids[0] ==
          Words{"9223372036854775808", "18446744073709551615"});
    refuse("frame,id,x,y\n0,-1,0,0\n0,9223372036854775808,1,0\n", 3, "ids below 0 and ids of 2^63 or more");
    refuse("frame,id,x,y\n0,9223372036854775808,0,0\n0,-9223372036854775808,1,0\n", 3, "ids below 0 and");
    CHECK(accept("frame,id,x,y\n0,18446744073709551616,0,0\n").ids[0] == Words{"18446744073709551616"});  // a word
    // A word anywhere makes all of them words; a number that only looks like one is one.
    CHECK(accept("frame,id,x,y\n0,1,0,0\n0,1.0,1,0\n0,1e5,2,0\n0,5D2,3,0\n").ids[0] == Words{"1", "1.0", "1e5", "5D2"});
    refuse("frame,id,x,y\n0,1,0,0\n0,1.0,1,0\n", 3, "has the id 1 of line 2");
    refuse("frame,id,x,y\n0,a,0,0\n0,a,1,0\n", 3, "has the id a of line 2");
    refuse("frame,id,x,y\n0,1.5,0,0\n", 2, "the id is not an integer: '1.5'");
    for (const char* missing : {"", "nan", "None", "NA", "-"})
        refuse("frame,id,x,y\n0,1,0,0\n0," + std::string(missing) + ",1,1\n", 3, "the id is missing");
    refuse("frame,id,x,y\n0,a,0,0\n0,,1,1\n", 3, "the id is missing");
    with_pipe("frame,id,x,y\n0,a,0,0\n0,1,1,1\n", [](const auto& pipe) {
        CHECK(read(pipe).ids[0] == Words{"a", "1"});
    });
    with_pipe("frame,id,x,y\n0,1,0,0\n0,a,1,1\n", [](const auto& pipe) {
        expect_fault(pipe, 3, "the id is not an integer: 'a'", [](const auto& file) { (void)read(file); });
    });
    const Temporary_directory directory;
    const auto file = directory.file("a.csv", "frame,id,x,y\n0,-1,0,0\n0,2,0,0\n");
    Motion_reader reader(file);
    Frame frame;
    CHECK(reader.next(frame));
    expect_fault(
        file, 2, "the point of id -1 is where that of id 2 is (line 3)",
        [&](const auto& f) { (void)points_of<2>(f.string(), frame, Coincident::refuse, reader.ids()); },
        Error_code::duplicate_point);
}

TEST_CASE("tables: a row without coordinates is a point that is absent", "[io][tables]") {
    const Motion motion =
        accept("frame,id,x,y,z\n0,1,0,0,0\n0,2,1,0,0\n1,1,nan,NaN,\n1,2,1,1,0\n2,1,,,\n2,2,NA,null,None\n3,1,3,0,0\n");
    REQUIRE(motion.numbers() == Numbers{0, 1, 2, 3});
    CHECK(motion.frames[1].id == Numbers{2});
    CHECK(motion.frames[2].id.empty());
    REQUIRE(motion.notes.size() == 1);
    CHECK(motion.notes[0].find("a.csv:4: has no coordinates") != std::string::npos);
    CHECK(accept("frame,id,x,y\na,b,c,d\n0,1,2,3\n0,2,,\n").notes.size() == 2);  // the header has a line more
    CHECK(accept("frame,id,x,y\n1,,,\n0,1,2,3\n").numbers() == Numbers{0, 1});   // without an id, too, and sorted
    refuse("frame,id,x,y\n0,1,0,\n", 2, "y is missing");
    refuse("frame,id,x,y\n0,1,nan,0\n", 2, "x is nan", "", Error_code::not_finite);
    refuse("frame,id,x,y,z\n0,1,1,0,\n", 2, "z is missing");
    refuse("frame,id,x,y\n0,1,inf,inf\n", 2, "x is infinite", "", Error_code::not_finite);
    refuse("frame,id,x,y\n0,1,,\n", 1, "has no points in any frame");
    const Temporary_directory directory;
    expect_fault(directory.file("a.csv", "x,y\n1,2\n,\n"), 3, "x is missing",
                 [](const auto& file) { (void)read_points<2>(file); });
}

TEST_CASE("tables: how many rows are sorted in memory is bounded", "[io][tables]") {
    CHECK(most_sorted_rows == 16'777'216);
}
