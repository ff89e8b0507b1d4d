// SPDX-License-Identifier: GPL-3.0-or-later
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

TEST_CASE("nothing is to be seen before the commit, everything after it", "[io][output]") {
    const Temporary_directory directory;
    const auto path = directory.path() / "new" / "deep" / "";  // a trailing slash, too
    {
        Output_directory out(path, is_result, nothing);
        out.write("a.json", "first");
        out.write("b.csv", std::string("x\0y\n", 4));
        CHECK(!fs::exists(path));
        CHECK_THROWS_AS(out.write("a.json", "second"), Error);
        out.commit();
        CHECK(content_of(path / "a.json") == "first");
        out.commit();
    }
    CHECK(content_of(path / "b.csv") == std::string("x\0y\n", 4));
    CHECK(entries(path) == 2);
    CHECK(entries(path.parent_path().parent_path()) == 1);
    // The directory, which was private while it was written, has the usual permissions now.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    CHECK(fs::status(path).permissions() == fs::perms(0777 & ~mask));
}

TEST_CASE("without a commit nothing is left, not even the directories", "[io][output]") {
    const Temporary_directory directory;
    try {
        Output_directory out(directory.path() / "new" / "deep", is_result, nothing);
        out.write("a", "content");
        throw std::runtime_error("the run fails midway");
    } catch (const std::runtime_error&) {
    }
    CHECK(directory.entries() == 0);
}

TEST_CASE("runs that begin and end below the same missing directory do not disturb each other", "[io][output]") {
    const Temporary_directory directory;
    const fs::path parent = directory.path() / "new" / "one";
    const auto begin_and_end = [&](const char* name, std::string& said) {
        for (int k = 0; k < repeats(2000) && said.empty(); ++k) {
            try {
                const Output_directory out(parent / name, is_result, nothing);
            } catch (const std::exception& error) {
                said = error.what();
            }
            std::error_code ignored;  // a run that found the parents does not remove them
            fs::remove(parent, ignored);
            fs::remove(parent.parent_path(), ignored);
        }
    };
    std::string first, second;
    std::thread other([&] { begin_and_end("a", first); });
    begin_and_end("b", second);
    other.join();
    CHECK(first == "");
    CHECK(second == "");
}

TEST_CASE("what is written before the commit is in a directory that is new, hidden and closed to others",
          "[io][output]") {
    const Temporary_directory directory;
    std::vector<fs::path> names;
    for (int i = 0; i < 2; ++i) {
        Output_directory out(directory.path() / "out", is_result, nothing);
        out.write("a", "new");
        for (const auto& entry : fs::directory_iterator(directory.path())) {
            names.push_back(entry.path().filename());
            CHECK(fs::status(entry.path()).permissions() == fs::perms::owner_all);
        }
    }
    REQUIRE(names.size() == 2);
    CHECK(names[0] != names[1]);
    CHECK(names[0].string().starts_with(".annulus-"));
}

TEST_CASE("earlier results are replaced as a whole, and stay without a commit", "[io][output]") {
    const Temporary_directory directory;
    const auto path = directory.path() / "out";
    fs::create_directory(path);
    fs::permissions(path, fs::perms::owner_all);
    for (const char* name : {"a", "b"}) directory.file(std::string("out/") + name, "old");
    CHECK(refusal(path).ends_with(
        "holds other files; expected a new or empty directory, or one with results of annulus (or --force)"));
    const ino_t old = identity(path);
    {
        Output_directory out(path, is_result, anything);
        out.write("a", "new");
    }
    CHECK(identity(path) == old);
    CHECK(content_of(path / "a") == "old");
    {
        Output_directory out(path, is_result, anything);
        out.write("a", "new");
        out.commit();
    }
    CHECK(identity(path) != old);  // in one exchange
    CHECK(content_of(path / "a") == "new");
    CHECK(!fs::exists(path / "b"));
    CHECK(entries(path) == 1);
    CHECK(directory.entries() == 1);
    CHECK(fs::status(path).permissions() == fs::perms::owner_all);
}

TEST_CASE("whether results are there is decided after something was found there", "[io][output]") {
    static std::vector<std::size_t> found;
    found.clear();
    const auto accepted = [](const fs::path& path) {
        found.push_back(entries(path));
        return true;
    };
    const Temporary_directory directory;
    const auto path = directory.path() / "out";
    CHECK(refusal(path, accepted) == "");  // it is not there: another run may put its results there right after this
    fs::create_directory(path);
    CHECK(refusal(path, accepted) == "");
    fs::create_directory(path / ".annulus-killed");
    CHECK(refusal(path, accepted) == "");
    CHECK(found.empty());
    for (const char* name : {"a", "b"}) directory.file(std::string("out/") + name, "old");
    CHECK(refusal(path, accepted) == "");
    CHECK(found == std::vector<std::size_t>{3});
}

TEST_CASE("other files stay, and stale results do not", "[io][output]") {
    const Temporary_directory directory;
    directory.file("notes", "mine");
    directory.file("a", "old");
    directory.file("b", "old");
    const ino_t old = identity(directory.path());
    Output_directory out(directory.path(), is_result, anything);
    out.write("a", "new");
    out.write("c", "new");
    CHECK(content_of(directory.path() / "a") == "old");
    out.commit();
    CHECK(identity(directory.path()) == old);
    CHECK(content_of(directory.path() / "notes") == "mine");
    CHECK(content_of(directory.path() / "a") == "new");
    CHECK(directory.entries() == 3);
}

TEST_CASE("what goes last is there until all that replaces it is", "[io][output]") {
    const Temporary_directory directory;
    directory.file("notes", "mine");
    directory.file("a", "old");
    directory.file("j", "what a and b can be made from");
    {
        Output_directory out(directory.path(), is_result, anything);
        out.write("a", "new");
        (void)out.path_of("b");  // it is never written: putting it in its place fails
        out.goes_last("j");
        CHECK_THROWS_AS(out.commit(), std::system_error);
    }
    CHECK(fs::exists(directory.path() / "j"));
    Output_directory out(directory.path(), is_result, anything);
    out.write("a", "new");
    out.goes_last("j");
    out.commit();
    CHECK_FALSE(fs::exists(directory.path() / "j"));
}

TEST_CASE("the working directory is not replaced under the feet of a shell", "[io][output]") {
    const Temporary_directory directory;
    const fs::path before = fs::current_path();
    fs::current_path(directory.path());
    const ino_t old = identity(".");
    directory.file("a", "old");
    Output_directory out(".", is_result, anything);
    out.write("b", "new");
    out.commit();
    CHECK(identity(directory.path()) == old);
    fs::current_path(before);
    CHECK(content_of(directory.path() / "b") == "new");
    CHECK(directory.entries() == 1);
}

TEST_CASE("what a run that was killed has left in a directory does not make it another's", "[io][output]") {
    const Temporary_directory directory;
    fs::create_directory(directory.path() / ".annulus-Ab12Cd");
    CHECK(refusal(directory.path()) == "");
    // A name that only begins like that belongs to another program.
    for (const char* name : {".annulus-x", ".annulus-Ab12Cd"}) {
        fs::create_directories(directory.path() / name);
        directory.file(std::string(name) + "/precious", "1");
        CHECK(refusal(directory.path()).find("holds other files") != std::string::npos);
        fs::remove_all(directory.path() / name);
    }
}

TEST_CASE("a directory that another run has made meanwhile is replaced if all in it are results", "[io][output]") {
    const Temporary_directory directory;
    const fs::path target = directory.path() / "new" / "out";
    Output_directory out(target, is_result, nothing);
    Output_directory other(target, is_result, nothing);
    for (Output_directory* o : {&out, &other}) o->write("a", o == &out ? "first" : "second");
    out.commit();
    other.commit();
    CHECK(content_of(target / "a") == "second");
    CHECK(entries(directory.path() / "new") == 1);
}

TEST_CASE("a directory that has come meanwhile is not touched", "[io][output]") {
    const Temporary_directory directory;
    Output_directory out(directory.path() / "out", is_result, nothing);
    out.write("a", "new");
    fs::create_directory(directory.path() / "out");
    directory.file("out/mine", "mine");
    CHECK_THROWS_AS(out.commit(), std::system_error);
    CHECK(content_of(directory.path() / "out" / "mine") == "mine");
}

TEST_CASE("where the disk ends nothing is left of what was begun", "[io][output]") {
    const Temporary_directory directory;
    rlimit old{};
    REQUIRE(::getrlimit(RLIMIT_FSIZE, &old) == 0);
    const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
    {
        Output_directory out(directory.path() / "out", is_result, nothing);
        out.write("a", std::string(1000, 'a'));
        const rlimit small{5000, old.rlim_max};
        REQUIRE(::setrlimit(RLIMIT_FSIZE, &small) == 0);
        try {
            out.write("b", std::string(10000, 'b'));
            FAIL("more was written than there is room for");
        } catch (const std::system_error& error) {
            CHECK(error.code() == std::errc::file_too_large);
        }
        ::setrlimit(RLIMIT_FSIZE, &old);
        out.commit();
    }
    std::signal(SIGXFSZ, ignored);
    CHECK(entries(directory.path() / "out") == 1);
    CHECK(directory.entries() == 1);
}

TEST_CASE("files written bit by bit elsewhere are taken over", "[io][output]") {
    const Temporary_directory directory;
    const fs::path at = directory.path() / "out";
    Output_directory scratch(at, is_result, nothing);
    { std::ofstream(scratch.path_of("a")) << "bit by bit"; }
    scratch.write("b", "at once");
    CHECK_THROWS_AS((void)scratch.path_of("b"), Error);
    CHECK_THROWS_AS((void)scratch.path_of("../c"), Error);
    Output_directory out(at, is_result, nothing);
    out.write("c", "own");
    out.take(scratch);
    CHECK_THROWS_AS(out.write("a", "again"), Error);
    CHECK_FALSE(fs::exists(at));
    out.commit();
    CHECK(entries(at) == 3);
    CHECK(content_of(at / "a") == "bit by bit");
    CHECK(content_of(at / "b") == "at once");
    // Taking over a file where one of that name exists is refused, and nothing is lost on either side.
    Output_directory first(directory.path() / "other", is_result, nothing),
        second(directory.path() / "other", is_result, nothing);
    first.write("a", "first");
    second.write("a", "second");
    CHECK_THROWS_AS(first.take(second), Error);
    first.commit();
    CHECK(content_of(directory.path() / "other" / "a") == "first");
}
