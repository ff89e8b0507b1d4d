// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_fault.h"
#include "gzip.h"
#include "temporary_directory.h"

#include <apps/formats/read_image.h>

#include <support/catch.h>

#include <algorithm>

using namespace annulus;
using annulus_test::expect_fault;
using annulus_test::gzip;
using annulus_test::Temporary_directory;

namespace {

std::string inr(const std::string& fields, const std::string& data) {
    std::string out = "#INRIMAGE-4#{\n" + fields;
    out.resize(252, '\n');
    return out + "##}\n" + data;
}

const std::string fields =
    "XDIM=3\nYDIM=2\nZDIM=2\nVDIM=1\nTYPE=unsigned fixed\nPIXSIZE=8 bits\nCPU=decm\nVX=0.5\nVY=1\nVZ=2\n";
const std::string data{"\0\1\2\3\4\5\6\7\10\11\12\13", 12};

/// The line on which the header ends.
std::uint64_t last(const std::string& text) {
    return static_cast<std::uint64_t>(std::count(text.begin(), text.begin() + 256, '\n'));
}

void refuse(const std::string& name, const std::string& content, std::uint64_t line, const std::string& fault) {
    const Temporary_directory directory;
    expect_fault(directory.file(name, content), line, fault, [](const auto& file) { (void)read_image(file); });
}

}  // namespace

TEST_CASE("a labelled image, plain and packed, in one gzip member or two", "[io][image]") {
    const Temporary_directory directory;
    const std::string text = inr(fields, data);
    for (const auto& file :
         {directory.file("a.inr", text), directory.file("A.Inr", text), directory.file("b.inr.gz", gzip(text)),
          directory.file("C.INR.GZ", gzip(text.substr(0, 100)) + gzip(text.substr(100)))}) {
        const Labelled_image image = read_image(file);
        CHECK(image.size == std::array<std::size_t, 3>{3, 2, 2});
        CHECK(image.spacing == Coordinates<3>{0.5, 1, 2});
        CHECK(image.at(0, 0, 0) == 0);
        CHECK(image.at(1, 0, 0) == 1);
        CHECK(image.at(0, 1, 0) == 3);
        CHECK(image.at(2, 1, 1) == 11);
    }
}

TEST_CASE("images that are not what they say are refused", "[io][image]") {
    const std::string text = inr(fields, data);
    const std::uint64_t end = last(text);
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string f = fields;
        return inr(f.replace(f.find(from), from.size(), to), data);
    };
    refuse("a.inr", text.substr(0, text.size() - 1), end, "11 bytes after its header");
    refuse("a.inr", text + "x", end, "more than 12 bytes after its header");
    refuse("a.inr", text + std::string(1 << 20, 'x'), end, "more than 12 bytes after its header");
    refuse("a.inr", text.substr(0, 60), 6, "ends within its header");
    refuse("a.inr", "P5\n", 1, "begins with 'P5'");
    refuse("a.inr", changed("8 bits", "16 bits"), 7, "PIXSIZE is '16 bits'");
    refuse("a.inr", changed("unsigned fixed", "float"), 6, "TYPE is 'float'");
    refuse("a.inr", changed("VDIM=1", "VDIM=3"), 5, "VDIM is '3'");
    refuse("a.inr", changed("XDIM=3\n", ""), last(changed("XDIM=3\n", "")), "no XDIM");
    refuse("a.inr", changed("XDIM=3", "XDIM=0"), last(changed("XDIM=3", "XDIM=0")), "XDIM is 0");
    refuse("a.inr", changed("XDIM=3", "XDIM=1048576"), last(changed("XDIM=3", "XDIM=1048576")),
           "bytes after its header");
    refuse("a.inr", changed("YDIM=2\nZDIM=2", "YDIM=1000000\nZDIM=1000000"),
           last(changed("YDIM=2\nZDIM=2", "YDIM=1000000\nZDIM=1000000")), "2^32");
    refuse("a.inr", changed("VX=0.5", "VX=-1"), last(changed("VX=0.5", "VX=-1")), "VX is -1");
    const std::string packed = gzip(text);
    refuse("a.inr.gz", packed.substr(0, packed.size() - 9), 0, "cut off");
    refuse("a.inr.gz", text, 0, "no gzip file");
    std::string damaged = packed;
    damaged[packed.size() - 6] = static_cast<char>(damaged[packed.size() - 6] ^ 1);  // of the checksum
    refuse("a.inr.gz", damaged, 0, "damaged");
    refuse("a.vtk", text, 0, "unknown extension");
    refuse("a.gz", packed, 0, "unknown extension");
    refuse("a.inr", "", 1, "is empty");
    refuse("a.inr", "#INRIMAGE-4#{\n" + std::string(1 << 20, '\n'), (1 << 16) - 13, "longer than 64 KiB");
}

TEST_CASE("nothing is unpacked beyond what the header announces", "[io][image]") {
    // The checksum at the end is wrong: a reader that unpacks all of the file would report that, one that stops at the
    // announced length does not.
    std::string bomb = gzip(inr(fields, data) + std::string(1 << 22, '\0'));
    bomb[bomb.size() - 6] = static_cast<char>(bomb[bomb.size() - 6] ^ 1);
    refuse("bomb.inr.gz", bomb, last(inr(fields, data)), "more than 12 bytes after its header");
    std::string no_header = gzip(std::string(1 << 22, '\0'));
    no_header[no_header.size() - 6] = static_cast<char>(no_header[no_header.size() - 6] ^ 1);
    refuse("bomb.inr.gz", no_header, 1, "begins with");
}
