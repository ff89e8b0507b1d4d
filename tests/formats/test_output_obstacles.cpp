// SPDX-License-Identifier: GPL-3.0-or-later
// Output_directory where links, devices, other files or the names themselves are in its way.
#include "output_cases.h"
#include "temporary_directory.h"

#include <annulus/error.h>
#include <apps/formats/output_directory.h>
#include <apps/formats/text_output.h>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <support/catch.h>
#include <support/repeats.h>

#include <csignal>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <thread>

using namespace annulus;
using namespace annulus_test;

TEST_CASE("a directory in the way of a file is an error before anything is replaced", "[io][output]") {
    const Temporary_directory directory;
    directory.file("a", "old");
    fs::create_directory(directory.path() / "c");
    {
        Output_directory out(directory.path(), is_result, anything);
        out.write("a", "new");
        out.write("c", "new");
        CHECK_THROWS_WITH(out.commit(),
                          (directory.path() / "c").string() + ": is a directory; expected a file or nothing");
    }
    CHECK(content_of(directory.path() / "a") == "old");
    CHECK(directory.entries() == 2);
}

TEST_CASE("links: one to a directory is followed and stays, one among the results is replaced", "[io][output]") {
    const Temporary_directory directory;
    fs::create_directory(directory.path() / "real");
    fs::create_directory_symlink("real", directory.path() / "link");
    const auto target = directory.file("target", "old");
    fs::create_symlink(target, directory.path() / "real" / "a");
    Output_directory out(directory.path() / "link", is_result, anything);
    out.write("a", "new");
    out.commit();
    CHECK(fs::is_symlink(directory.path() / "link"));
    CHECK(content_of(directory.path() / "real" / "a") == "new");
    CHECK(content_of(target) == "old");
    CHECK(directory.entries() == 3);
}

TEST_CASE("paths and names that cannot be are refused", "[io][output]") {
    const Temporary_directory directory;
    const auto file = directory.file("file", "content");
    fs::create_symlink("nowhere", directory.path() / "dangling");
    for (const fs::path& path :
         {file, file / "below" / "deep", directory.path() / "dangling", fs::path(), directory.path() / "new" / ".."})
        CHECK(refusal(path, anything) != "");
    CHECK(directory.entries() == 2);
    CHECK(content_of(file) == "content");
    Output_directory out(directory.path() / "out", is_result, nothing);
    for (const char* name : {"", ".", "..", "../a", "a/b", "/a"}) CHECK_THROWS_AS(out.write(name, "x"), Error);
    try {
        out.write(std::string(300, 'a'), "x");
        FAIL("a name of 300 bytes was accepted");
    } catch (const std::system_error& error) {
        CHECK(error.code() == std::errc::filename_too_long);
        CHECK(std::string(error.what()).starts_with((directory.path() / "out" / "aaa").string()));
    }
    out.write("good", "x");
    out.commit();  // a file that could not be written is not there in part
    CHECK(entries(directory.path() / "out") == 1);
}

TEST_CASE("devices, pipes and sockets are replaced by no file, nor are links to them", "[io][output]") {
    const Temporary_directory directory;
    const auto pipe = directory.path() / "pipe";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    const auto link = [&](const char* name, const fs::path& to) {
        fs::create_symlink(to, directory.path() / name);
        return directory.path() / name;
    };
    for (const auto& [path, kind] :
         std::vector<std::pair<fs::path, std::string>>{{pipe, "a pipe"},
                                                       {link("to-pipe", "pipe"), "a pipe"},
                                                       {link("to-link", "to-pipe"), "a pipe"},
                                                       {"/dev/null", "a device"},
                                                       {link("to-null", "/dev/null"), "a device"}}) {
        INFO(path);
        CHECK(special_kind(path) == kind);
        try {
            Text_output out(path);
            FAIL("was accepted");
        } catch (const Error& error) {
            CHECK(error.code() == Error_code::bad_input);
            CHECK(std::string(error.what()).starts_with(path.string() + ": is " + kind));
        }
    }
    CHECK(fs::is_fifo(fs::symlink_status(pipe)));
    CHECK(directory.entries() == 4);
    // A link to a file, and one to nothing, may go.
    (void)directory.file("file", "old");
    for (const auto& path : {link("to-file", "file"), link("to-nothing", "nothing"), directory.path() / "new"}) {
        CHECK(special_kind(path).empty());
        Text_output out(path);
        out.write("new");
        out.commit();
        CHECK(content_of(path) == "new");
    }
    CHECK(content_of(directory.path() / "file") == "old");
    // A pipe made while the text is written stays.
    const auto late = directory.path() / "late";
    Text_output out(late);
    REQUIRE(::mkfifo(late.c_str(), 0600) == 0);
    CHECK_THROWS_AS(out.commit(), Error);
    CHECK(fs::is_fifo(fs::symlink_status(late)));
}

TEST_CASE("a directory with a pipe in the place of a result stays as it is", "[io][output]") {
    const Temporary_directory directory;
    const auto path = directory.path() / "out";
    fs::create_directory(path);
    const auto pipe = path / "a";  // named as a result is
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    CHECK(refusal(path, anything).starts_with(pipe.string() + ": is a pipe"));
    fs::rename(pipe, path / "long-name");
    {
        Output_directory out(path, is_result, anything);
        out.write("long-name", "mine");
        CHECK_THROWS_AS(out.commit(), Error);
    }
    CHECK(fs::is_fifo(fs::symlink_status(path / "long-name")));
    CHECK(entries(path) == 1);
}
