// SPDX-License-Identifier: GPL-3.0-or-later
#include "temporary_directory.h"

#include <annulus/arithmetic/error.h>
#include <annulus/io/output_directory.h>

#include <catch2/catch.hpp>

#include <stdexcept>

using namespace annulus;
using annulus_test::content_of;
using annulus_test::Temporary_directory;
namespace fs = std::filesystem;

TEST_CASE("nothing is to be seen before the commit, everything after it") {
    const Temporary_directory directory;
    const auto path = directory.path() / "new" / "deep" / "";  // a trailing slash, too
    {
        Output_directory out(path);
        out.write("a.json", "first");
        out.write("b.csv", std::string("x\0y\n", 4));
        out.write("a.json", "second");
        CHECK(!fs::exists(path / "a.json"));
        CHECK(!fs::exists(path / "b.csv"));
        out.commit();
        CHECK(content_of(path / "a.json") == "second");
        out.commit();
    }
    CHECK(content_of(path / "a.json") == "second");
    CHECK(content_of(path / "b.csv") == std::string("x\0y\n", 4));
    CHECK(std::distance(fs::directory_iterator(path), {}) == 2);
}

TEST_CASE("without a commit nothing is left, not even the directories") {
    const Temporary_directory directory;
    try {
        Output_directory out(directory.path() / "new" / "deep");
        out.write("a", "content");
        throw std::runtime_error("the run fails midway");
    } catch (const std::runtime_error&) {
    }
    CHECK(directory.entries() == 0);
}

TEST_CASE("a directory that was there stays, with its files as they were") {
    const Temporary_directory directory;
    directory.file("a", "old");
    {
        Output_directory out(directory.path());
        out.write("a", "new");
        out.write("b", "new");
    }
    CHECK(content_of(directory.path() / "a") == "old");
    CHECK(directory.entries() == 1);
    {
        Output_directory out(directory.path());
        out.write("a", "new");
        out.commit();
    }
    CHECK(content_of(directory.path() / "a") == "new");
    CHECK(directory.entries() == 1);
}

TEST_CASE("a commit that fails midway takes back what it did") {
    const Temporary_directory directory;
    directory.file("a", "old");
    fs::create_directory(directory.path() / "c");  // in the way of a file
    {
        Output_directory out(directory.path());
        out.write("a", "new");
        out.write("b", "new");
        out.write("c", "new");
        try {
            out.commit();
            FAIL("the commit went through");
        } catch (const Error& error) {
            CHECK(error.code() == Error_code::bad_input);
            CHECK(std::string(error.what()) ==
                  (directory.path() / "c").string() + ": is a directory; expected a file or nothing");
        }
        CHECK(content_of(directory.path() / "a") == "old");
        CHECK(directory.entries() == 2);
    }
    CHECK(content_of(directory.path() / "a") == "old");
    CHECK(directory.entries() == 2);
}

TEST_CASE("a symbolic link is replaced, and what it points to is left alone") {
    const Temporary_directory directory;
    const auto target = directory.file("target", "old");
    fs::create_symlink(target, directory.path() / "a");
    Output_directory out(directory.path());
    out.write("a", "new");
    out.commit();
    CHECK(content_of(directory.path() / "a") == "new");
    CHECK(content_of(target) == "old");
}

TEST_CASE("paths and names that cannot be are refused") {
    const Temporary_directory directory;
    const auto file = directory.file("file", "content");
    CHECK_THROWS_AS(Output_directory(file), Error);
    CHECK_THROWS_AS(Output_directory(file / "below" / "deep"), Error);
    CHECK_THROWS_AS(Output_directory(""), Error);
    CHECK(directory.entries() == 1);
    CHECK(content_of(file) == "content");
    Output_directory out(directory.path());
    for (const char* name : {"", ".", "..", "../a", "a/b", "/a"}) CHECK_THROWS_AS(out.write(name, "x"), Error);
    try {
        out.write(std::string(300, 'a'), "x");
        FAIL("a name of 300 bytes was accepted");
    } catch (const Error& error) {
        CHECK(error.code() == Error_code::bad_input);
        CHECK(std::string(error.what()).starts_with(directory.path().string()));
    }
    out.write("good", "x");
    out.commit();  // what could not be written is not half there
    CHECK(directory.entries() == 2);
}
