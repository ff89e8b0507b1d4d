// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_fault.h"
#include "gzip.h"
#include "temporary_directory.h"

#include <apps/formats/file_bytes.h>
#include <apps/formats/motion_reader.h>
#include <apps/formats/read_gray_image.h>
#include <apps/formats/read_image.h>
#include <apps/formats/read_mesh.h>
#include <apps/formats/read_points.h>
#include <apps/formats/read_surface.h>
#include <apps/formats/read_tetrahedra.h>
#include <apps/formats/text_input.h>

#include <support/catch.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <limits>
#include <vector>

using namespace annulus;
using annulus_test::expect_fault;
using annulus_test::gzip;
using annulus_test::Temporary_directory;

namespace {

/// Every character in `width` bytes, the ASCII byte first or last.
std::string widened(const std::string& text, std::size_t width, bool first) {
    std::string out;
    for (const char c : text) {
        std::string unit(width, '\0');
        unit[first ? 0 : width - 1] = c;
        out += unit;
    }
    return out;
}

/// Reads a file with the reader of its extension.
void read_any(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    if (extension == ".png" || extension == ".jpg" || extension == ".pgm") (void)read_gray_image(file);
    else if (extension == ".obj" || extension == ".stl") (void)read_surface(file);
    else if (extension == ".inr") (void)read_image(file);
    else if (extension == ".dump" || extension == ".csv") {
        Motion_reader reader(file);
        for (Frame frame; reader.next(frame);) continue;
    } else (void)read_points<2>(file);
}

const std::vector<std::string> readers{"a.xyz", "a.csv", "a.dump", "a.off", "a.ply", "a.mesh",
                                       "a.obj", "a.stl", "a.png",  "a.jpg", "a.pgm", "a.inr"};

}  // namespace

TEST_CASE("text in UTF-16 and what others have packed is called by its name, whatever reads it", "[io][kind]") {
    const std::string csv = "frame,id,x,y\n0,1,0,0\n";
    const Temporary_directory directory;
    for (const auto& [content, fault] : std::vector<std::pair<std::string, std::string>>{
             {"\xff\xfe" + widened(csv, 2, true), "is text in UTF-16"},
             {"\xfe\xff" + widened(csv, 2, false), "is text in UTF-16"},
             {widened(csv, 2, true), "is text in UTF-16"},
             {widened(csv, 2, false), "is text in UTF-16"},
             {widened(csv, 4, true), "is text in UTF-32"},
             {std::string("\0\0\xfe\xff", 4) + widened(csv, 4, false), "is text in UTF-32"},
             {"BZh91AY&SY....", "is packed by bzip2"},
             {std::string("\xfd\x37zXZ\0...", 9), "is packed by xz"},
             {"\x28\xb5\x2f\xfd....", "is packed by zstd"},
             {"PK\x03\x04....", "is a zip archive"},
             {gzip("BZh91AY&SY...."), "is packed by bzip2"},
             {"\x93NUMPY\x01", "is an array of NumPy"},
         })
        for (const std::string& name : readers) {
            const bool lines = name == "a.xyz" || name == "a.csv" || name == "a.dump";
            if (lines && fault == "is text in UTF-16") continue;  // which is read
            const auto file = directory.file(name, content);
            INFO(name);
            try {
                read_any(file);
                FAIL("was accepted");
            } catch (const Input_error& error) {
                INFO(error.what());
                CHECK(error.fault().starts_with(fault));
                CHECK(error.line() <= 1);
                CHECK(!error.expected().empty());
            }
        }
}

TEST_CASE("text in UTF-16 is read where lines are", "[io][kind]") {
    const Temporary_directory directory;
    const std::string csv = "frame,id,x,y\n0,1,2,3\n", xyz = "1\n\nC 1 2 3\n";
    const auto marked = [](const std::string& text, bool first) {
        return (first ? "\xff\xfe" : "\xfe\xff") + widened(text, 2, first);
    };
    for (const bool first : {true, false})
        for (const std::string& content : {marked(csv, first), widened(csv, 2, first), gzip(marked(csv, first))}) {
            Motion_reader reader(directory.file("a.csv", content));
            Frame frame;
            REQUIRE(reader.next(frame));
            CHECK(frame.position == std::vector<Coordinates<3>>{{2, 3, 0}});
            CHECK(frame.line == std::vector<std::uint64_t>{2});
            CHECK_FALSE(reader.next(frame));
        }
    CHECK(read_points<3>(directory.file("a.xyz", marked(xyz, true))).points == std::vector<Coordinates<3>>{{1, 2, 3}});
    // Characters of one to four bytes, wherever pieces end: e with an accent, the euro, a clef.
    const std::string wide("\xe9\0\xac\x20\x34\xd8\x1e\xdd", 8);
    for (std::size_t cut = 0; cut <= wide.size(); ++cut) {
        Utf16_decoder decoder(std::string_view("x\0", 2));
        std::string text;
        CHECK(decoder.append(std::string_view(wide).substr(0, cut), text));
        CHECK(decoder.complete() == (cut % 2 == 0 && cut != 6));
        CHECK(decoder.append(std::string_view(wide).substr(cut), text));
        CHECK(text == "\xc3\xa9\xe2\x82\xac\xf0\x9d\x84\x9e");
        CHECK(decoder.complete());
    }
    const auto read = [](const auto& f) { (void)read_points<2>(f); };
    const std::string rows = marked("x,y\n1,2\n", true);
    expect_fault(directory.file("b.csv", rows + "1"), 3, "ends within a character", read);
    expect_fault(directory.file("b.csv", rows + std::string("\x34\xd8", 2)), 3, "ends within a character", read);
    expect_fault(directory.file("b.csv", rows + std::string("\x34\xd8\x31\0", 4)), 1, "half of a pair of surrogates",
                 read);
    expect_fault(directory.file("b.csv", rows + std::string("\x1e\xdd", 2)), 1, "half of a pair of surrogates", read);
    // A table that is larger than a block.
    std::string many = "x,y\n";
    for (int i = 0; i < 20'000; ++i) many += std::to_string(i) + ",0\n";
    CHECK(read_points<2>(directory.file("c.csv", marked(many, true))).points.size() == 20'000);
}

TEST_CASE("what gzip packed is read under any name", "[io][kind]") {
    const Temporary_directory directory;
    CHECK(read_points<2>(directory.file("a.csv", gzip("x,y\n1,2\n"))).points == std::vector<Coordinates<2>>{{1, 2}});
    CHECK(read_points<3>(directory.file("a.off", gzip("OFF\n1 0 0\n1 2 3\n"))).points ==
          std::vector<Coordinates<3>>{{1, 2, 3}});
    Motion_reader reader(directory.file("b.csv", gzip("frame,id,x,y\n0,1,2,3\n")));
    Frame frame;
    CHECK(reader.next(frame));
    CHECK(read_gray_image(directory.file("a.pgm", gzip("P2 2 1 9 3 4"))).value == std::vector<std::uint16_t>{3, 4});
    expect_fault(directory.file("c.csv", gzip("x,y\n1,2\n").substr(0, 12)), 1, "is cut off",
                 [](const auto& f) { (void)read_points<2>(f); });
}

TEST_CASE("lines that end by CR alone are lines, in every text format", "[io][kind]") {
    const Temporary_directory directory;
    const auto cr = [](std::string text) {
        for (char& c : text)
            if (c == '\n') c = '\r';
        return text;
    };
    using Points_2 = std::vector<Coordinates<2>>;
    const auto points = [&](const std::string& name, const std::string& content) {
        return read_points<2>(directory.file(name, content), {.ignore_z = true});
    };
    CHECK(points("a.xyz", cr("1 2\n\n3 4\n")).points == Points_2{{1, 2}, {3, 4}});
    CHECK(points("a.xyz", cr("1 2\n\n3 4\n")).lines == std::vector<std::uint64_t>{1, 3});
    CHECK(points("a.xyz", cr("1 2\n3 4")).points == Points_2{{1, 2}, {3, 4}});
    CHECK(points("a.xyz", "1 2\r").points == Points_2{{1, 2}});
    CHECK(points("a.csv", "\xef\xbb\xbf" + cr("x,y\n1,2\n3,4\n")).points == Points_2{{1, 2}, {3, 4}});
    CHECK(points("a.csv.gz", gzip(cr("x,y\n1,2\n3,4\n"))).points == Points_2{{1, 2}, {3, 4}});
    CHECK(points("a.off", cr("OFF\n2 0 0\n1 2 3\n3 4 5\n")).points == Points_2{{1, 2}, {3, 4}});
    CHECK(points("a.mesh", cr("MeshVersionFormatted 1\nDimension 2\nVertices\n1\n1 2 0\nEnd\n")).points ==
          Points_2{{1, 2}});
    CHECK(points("a.ply",
                 cr("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n"))
              .points == Points_2{{1, 2}});
    CHECK(read_gray_image(directory.file("a.pgm", cr("P2\n# a comment\n2 1\n9\n3 4\n"))).value ==
          std::vector<std::uint16_t>{3, 4});
    // A block ends between the CR of the first line and what comes next.
    const std::string first((1 << 16) - 5, ' ');
    CHECK(points("a.xyz", first + "1  2\r3 4\r").points == Points_2{{1, 2}, {3, 4}});
    CHECK(points("a.xyz", first + "1  2\r\n3 4\r\n").points == Points_2{{1, 2}, {3, 4}});
    // The first line decides, and others have to end as it does.
    const auto mixed = [](const auto& f) { (void)read_points<2>(f); };
    expect_fault(directory.file("a.xyz", "1 2\r3 4\n5 6\n"), 2, "lines end by CR, and here by LF", mixed);
    expect_fault(directory.file("a.xyz", "1 2\n3 4\r5\n"), 2, "y is not a number: '4\\x0d5'", mixed);
}

TEST_CASE("a device is no file, and what has no end is not held in memory", "[io][kind]") {
    const Temporary_directory directory;
    for (const std::string& name : readers) {
        const auto link = directory.path() / name;
        std::filesystem::create_symlink("/dev/zero", link);
        expect_fault(link, 0, "is a device", read_any);
    }
    for (const auto& read : {+[](const std::filesystem::path& f) { (void)read_mesh(f); },
                             +[](const std::filesystem::path& f) { (void)read_tetrahedra(f); },
                             +[](const std::filesystem::path& f) { (void)load_file(f); }})
        expect_fault(directory.path() / "a.mesh", 0, "is a device", read);
    const auto file = directory.file("a.toml", std::string(1000, '#'));
    CHECK(load_file(file, 1000).content.size() == 1000);
    expect_fault(file, 0, "has more than 999 bytes", [](const auto& f) { (void)load_file(f, 999); });
    expect_fault(directory.file("b.toml", gzip(std::string(1000, '#'))), 0, "has more than 999 bytes",
                 [](const auto& f) { (void)load_file(f, 999); });
    // The size of a pipe is not known beforehand.
    const auto pipe = directory.path() / "pipe";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    const int end = ::open(pipe.c_str(), O_RDWR | O_CLOEXEC);
    REQUIRE(end >= 0);
    const std::string text(1000, '#');
    CHECK(::write(end, text.data(), text.size()) == 1000);
    expect_fault(pipe, 0, "has more than 999 bytes", [](const auto& f) { (void)load_file(f, 999); });
    // Defaults of load_file: a GiB of a pipe, which no test reads, and all of a file.
    constexpr std::uint64_t gib = 1'073'741'824, all = std::numeric_limits<std::uint64_t>::max();
    CHECK(bound_of(File_bytes(pipe), all) == gib);
    CHECK(bound_of(File_bytes(pipe), gib + 1) == gib);
    CHECK(bound_of(File_bytes(pipe), gib - 1) == gib - 1);
    CHECK(bound_of(File_bytes(file), all) == all);
    ::close(end);
}
