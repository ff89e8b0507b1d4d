// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_fault.h"
#include "gzip.h"
#include "temporary_directory.h"

#include <apps/formats/frame_points.h>
#include <apps/formats/read_motion.h>
#include <apps/formats/read_points.h>
#include <apps/formats/write_frames.h>
#include <apps/motion/generated_motion.h>

#include <support/catch.h>

#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <thread>
#include <vector>

using namespace annulus;
using annulus_test::expect_fault;
using annulus_test::gzip;
using annulus_test::Temporary_directory;

namespace {

/// The frames of a file, read one after the other, and the state of its reader on the way.
std::vector<Frame> all_of(const std::filesystem::path& file, const Motion_options& options = {}) {
    Motion_reader reader(file, options);
    std::vector<Frame> frames;
    Frame frame;  // the same memory for all
    while (true) {
        const bool ends = !frames.empty() && reader.at_end();
        if (!reader.next(frame)) {
            CHECK(ends);
            return frames;
        }
        CHECK_FALSE(ends);
        frames.push_back(frame);
    }
}

bool equal(const std::vector<Frame>& a, const std::vector<Frame>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Frame& f, const Frame& g) {
        return f.number == g.number && f.id == g.id && f.position == g.position && f.line == g.line;
    });
}

/// Frames of up to 200 points, more than a block of 64 KiB, with ends of lines wherever they fall.
std::string long_xyz(std::mt19937& random) {
    std::string text;
    for (int f = 0; f < 40; ++f) {
        const std::size_t n = random() % 200;
        text += std::to_string(n) + "\n" + std::string(random() % 300, 'c') + "\n";
        for (std::size_t i = 0; i < n; ++i) {
            text += "H " + std::to_string(random() % 1000) + "." + std::to_string(random()) + " " + std::to_string(i) +
                    std::string(1 + random() % 20, ' ') + "0.5\n";
            if (random() % 50 == 0) text += std::string(random() % 10, '\n');
        }
    }
    return text;
}

}  // namespace

TEST_CASE("frames come one by one as they come at once, wherever blocks end", "[io][motion]") {
    std::mt19937 random(7);
    const Temporary_directory directory;
    for (int round = 0; round < 20; ++round) {
        const std::string text = long_xyz(random);
        const auto plain = directory.file("a.xyz", text);
        const std::vector<Frame> frames = all_of(plain);
        CHECK(frames.size() == 40);
        const std::size_t cut = random() % text.size();
        CHECK(equal(all_of(directory.file("a.xyz.gz", gzip(text.substr(0, cut)) + gzip(text.substr(cut)))), frames));
        CHECK(equal(all_of(directory.file("a.txt", "\xef\xbb\xbf" + text), {.format = "xyz"}), frames));
        CHECK(equal(read_motion(plain).frames, frames));
        std::string windows;
        for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
        CHECK(equal(all_of(directory.file("b.xyz", windows)), frames));
        // Cut off anywhere, it is refused at its last line or has fewer frames, which are the same.
        const std::string begin = text.substr(0, cut);
        try {
            const auto fewer = all_of(directory.file("c.xyz", begin));
            CHECK(fewer.size() <= frames.size());
        } catch (const Input_error& error) {
            CHECK(error.line() >= static_cast<std::uint64_t>(std::count(begin.begin(), begin.end(), '\n')));
            CHECK(error.line() <= static_cast<std::uint64_t>(std::count(begin.begin(), begin.end(), '\n')) + 1);
        }
    }
}

TEST_CASE("a pipe gives what a file gives, however its bytes come", "[io][motion]") {
    std::mt19937 random(3);
    const std::string text = long_xyz(random);
    const Temporary_directory directory;
    const std::vector<Frame> frames = all_of(directory.file("a.xyz", text));
    for (const std::size_t most : {std::size_t{1}, std::size_t{100}, std::size_t{100'000}}) {
        const auto pipe = directory.path() / "pipe.xyz";
        REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
        std::thread writer([&] {
            std::ofstream out(pipe, std::ios::binary);
            const std::size_t bytewise = std::min<std::size_t>(text.size(), 2000);
            for (std::size_t i = 0; i < text.size();) {
                const std::size_t n = i < bytewise ? most : text.size();
                out << std::string_view(text).substr(i, n) << std::flush;
                i += n;
            }
        });
        const auto read = all_of(pipe);
        writer.join();
        CHECK(equal(read, frames));
        CHECK(std::filesystem::remove(pipe));
    }
}

TEST_CASE("frames that came before a fault are there", "[io][motion]") {
    const Temporary_directory directory;
    Motion_reader reader(directory.file("a.xyz", "1\n\n1 2\n1\n\n3 4\n1\n\n5\n"));
    Frame frame;
    CHECK(reader.next(frame));
    CHECK(reader.next(frame));
    CHECK(frame.position == std::vector<Coordinates<3>>{{3, 4, 0}});
    CHECK_FALSE(reader.at_end());
    CHECK_THROWS_AS(reader.next(frame), Input_error);
}

TEST_CASE("the distance of frames is that of the first two where a file is read once", "[io][motion]") {
    const Temporary_directory directory;
    const std::string text = "frame,id,x,y\n0,1,0,0\n4,1,1,0\n6,1,2,0\n8,1,3,0\n";
    // A file is read twice, so that the reader finds that 2 is absent.
    CHECK(all_of(directory.file("a.csv", text), {.absent = Absent_frames::empty}).size() == 5);
    // The frame that waits behind an empty one may be the last.
    CHECK(all_of(directory.file("b.csv", "frame,id,x,y\n0,1,0,0\n1,1,1,0\n3,1,2,0\n"), {.absent = Absent_frames::empty})
              .size() == 4);
    const auto pipe = directory.path() / "pipe.csv";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    std::thread writer([&] { std::ofstream(pipe) << text; });
    expect_fault(pipe, 4, "frame 6 after frame 4, where others are 4 apart",
                 [](const auto& file) { (void)all_of(file, {.absent = Absent_frames::empty}); });
    writer.join();
}

TEST_CASE("a motion is flat where z is the same everywhere", "[io][motion]") {
    const Temporary_directory directory;
    const auto flat = [&](const std::string& text) { return is_flat(directory.file("a.xyz", text)); };
    CHECK(flat("1\n\n0 0\n1\n\n1 1\n"));
    CHECK(flat("0\n\n1\n\n0 0 7\n2\n\n1 1 7\n2 2 7.0\n"));
    CHECK(flat("1\n\n0 0 0\n1\n\n1 1 -0\n"));
    CHECK_FALSE(flat("1\n\n0 0 7\n2\n\n1 1 7\n2 2 7.5\n"));
    CHECK_FALSE(flat("2\n\n0 0 7\n1 1 8\n1\n\nthis is not read\n"));
}

TEST_CASE("formats are taken from extensions, or from the caller", "[io][formats]") {
    const Temporary_directory directory;
    const auto rows = directory.file("a.txt", "1 2\n3 4\n");
    CHECK(read_points<2>(rows, {.format = "xyz"}).points.size() == 2);
    CHECK(read_points<2>(directory.file("b.xyz", "1,2\n3,4\n"), {.format = "csv"}).points.size() == 2);
    CHECK(read_points<2>(directory.file("c.extxyz", "1 2\n")).points.size() == 1);
    const auto usage = [](const std::filesystem::path& file, const std::string& format) {
        try {
            (void)read_points<2>(file, {.format = format});
            FAIL("was accepted");
        } catch (const Error& error) {
            CHECK(error.code() == Error_code::usage);
        }
    };
    usage(rows, "stl");  // it has faces, and no points alone
    usage(rows, "XYZ");
    usage("-", "");  // standard input has no extension
    for (const Format format : point_formats) CHECK(format_of("-", point_formats, name_of(format)) == format);
    CHECK(is_packed("A.XYZ.GZ"));
    CHECK_FALSE(is_packed("gz"));
}

TEST_CASE("long lines and many empty ones", "[io][motion][deep]") {
    const Temporary_directory directory;
    const std::string wide(300'000, ' ');
    CHECK(
        all_of(directory.file("a.xyz", "1\n" + std::string(300'000, 'c') + "\n" + wide + "1" + wide + "2\n")).size() ==
        1);
    const auto empty = directory.file("b.xyz", "1\n\n1 2\n" + std::string(1'000'000, '\n') + "1\n\n3 4\n");
    const auto frames = all_of(empty);
    REQUIRE(frames.size() == 2);
    CHECK(frames[1].line == std::vector<std::uint64_t>{1'000'006});
    expect_fault(directory.file("c.xyz", "1\n\n" + std::string(70'000'000, '1')), 3, "is longer than 64 MiB",
                 [](const auto& file) { (void)all_of(file); });
}

TEMPLATE_TEST_CASE_SIG("boxes that are written are read back, bit for bit", "[io][motion][periodic]", ((int d), d), 2,
                       3) {
    const Temporary_directory directory;
    typename Box<d>::Vectors skewed{};
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t k = 0; k < d; ++k)
            skewed[i][k] = i == k ? (i == 1 ? -1.1 : 0.7) : 0.1 / static_cast<double>(3 + i + 2 * k);
    typename Box<d>::Vectors upright{}, left{};
    for (std::size_t i = 0; i < d; ++i) {
        upright[i][i] = 0.1 + static_cast<double>(i);
        left[i][d - 1 - i] = 0.3;
    }
    for (const Format format : {Format::xyz, Format::lammps})
        for (const auto& vectors : {skewed, upright, left}) {
            Generated_motion<d> motion(Box<d>(vectors), generate<d>(Point_family::uniform, 20, 3), Motion_family::shear,
                                       0.3, 3);
            std::vector<Box<d>> expected;
            std::string text;
            for (std::uint64_t i = 0; i < 4; ++i, motion.step()) {
                expected.push_back(*motion.box());
                append_frame<d>(text, format, i, motion.points(), motion.box());
            }
            Motion_options options;
            options.format = name_of(format);
            options.box.taken = true;
            const Recorded_motion read = read_motion(directory.file("a", text), options);
            REQUIRE(read.frames.size() == 4);
            for (std::size_t i = 0; i < 4; ++i) {
                REQUIRE(read.frames[i].box);
                for (std::size_t k = 0; k < 3; ++k) {
                    Coordinates<3> vector{0, 0, 1};
                    if (k < d) {
                        vector = {};
                        std::copy_n(expected[i].vectors()[k].begin(), d, vector.begin());
                    }
                    CHECK(read.frames[i].box->vectors[k] == vector);
                    CHECK((k >= d || read.frames[i].box->periodic[k]));
                }
            }
        }
}

TEMPLATE_TEST_CASE_SIG("frames that are written are read back, bit for bit", "[io][motion]", ((int d), d), 2, 3) {
    const Temporary_directory directory;
    for (const Format format : written_formats)
        for (const Motion_family family : {Motion_family::walk, Motion_family::shear, Motion_family::orbit}) {
            Generated_motion<d> motion(generate<d>(Point_family::clusters, 50, 3), family, 0.1, 3);
            std::vector<std::vector<Coordinates<d>>> expected;
            std::string text;
            for (std::uint64_t i = 0; i < 4; ++i, motion.step()) {
                expected.emplace_back(motion.points().begin(), motion.points().end());
                append_frame<d>(text, format, i, motion.points());
            }
            Motion_options options;
            options.format = name_of(format);
            const Recorded_motion read = read_motion(directory.file("a", text), options);
            CHECK(read.has_z == (d == 3));
            CHECK(read.notes.empty());
            REQUIRE(read.frames.size() == 4);
            for (std::size_t i = 0; i < 4; ++i) {
                CHECK(read.frames[i].number == i);
                CHECK(points_of<d>(read.name, read.frames[i], Coincident::refuse).x == expected[i]);
                if (i > 0) CHECK(expected[i] != expected[i - 1]);
            }
        }
}
