// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/experiment/journal.h>

#include <formats/temporary_directory.h>

#include <support/catch.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace annulus;
using annulus_test::Temporary_directory;

namespace {

std::string content(const std::filesystem::path& file) { return annulus_test::content_of(file); }
void write(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

std::vector<std::string> entries(const std::filesystem::path& file) {
    const Journal j(file, "head", false);
    std::vector<std::string> all;
    for (std::size_t i = 0; i < j.size(); ++i) all.push_back(j.entry(i));
    return all;
}

const std::vector<std::string> three{"first", "", "{\"third\": [1, 2]}"};

}  // namespace

TEST_CASE("A journal cut off anywhere, or damaged in any byte, keeps all other entries") {
    const Temporary_directory scratch;
    const auto file = scratch.path() / "journal";
    {
        Journal j(file, "head", false);
        for (const std::string& text : three) j.append(text);
        CHECK_THROWS_AS(Journal(file, "head", true), Error);  // while another has it
    }
    const std::string whole = content(file);
    CHECK(entries(file) == three);
    for (std::size_t cut = 0; cut < whole.size(); ++cut) {
        CAPTURE(cut);
        std::size_t lines = 0;
        for (std::size_t i = 0; i < cut; ++i) lines += whole[i] == '\n' ? 1 : 0;
        const std::size_t kept = lines == 0 ? 0 : lines - 1;
        write(file, whole.substr(0, cut));
        REQUIRE(entries(file) ==
                std::vector<std::string>(three.begin(), three.begin() + static_cast<std::ptrdiff_t>(kept)));
        {
            Journal j(file, "head", false);  // and it goes on
            j.append("next");
            REQUIRE(j.entry(kept) == "next");
        }
        REQUIRE(entries(file).size() == kept + 1);
        std::string damaged = whole;
        damaged[cut] = static_cast<char>(damaged[cut] ^ 4);
        write(file, damaged);
        if (lines == 0) {  // whose it is cannot be known
            REQUIRE_THROWS_AS(entries(file), Error);
            REQUIRE(content(file) == damaged);
            continue;
        }
        std::vector<std::string> left = three;  // all but the line of that byte, or but two that have become one
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(kept));
        if (whole[cut] == '\n' && kept < left.size()) left.erase(left.begin() + static_cast<std::ptrdiff_t>(kept));
        REQUIRE(entries(file) == left);
        Journal(file, "head", false).append("next");
        left.emplace_back("next");
        REQUIRE(entries(file) == left);
    }
}

TEST_CASE("A journal of another head is refused, or begun anew") {
    const Temporary_directory scratch;
    const auto file = scratch.path() / "journal";
    Journal(file, "other", false).append("old");
    CHECK_THROWS_AS(Journal(file, "head", false), Error);
    CHECK(Journal(file, "other", false).size() == 1);
    CHECK(Journal(file, "head", true).size() == 0);
    CHECK(entries(file).empty());
    Journal(file, "head", false).append("done");
    CHECK(Journal(file, "head", true).size() == 0);
    CHECK(entries(file).empty());
}
