// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Motions read from tables.
#include "expect_fault.h"
#include "temporary_directory.h"

#include <apps/formats/motion_reader.h>

#include <support/catch.h>

#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace annulus_test {

using namespace annulus;

using Points_3 = std::vector<Coordinates<3>>;
using Numbers = std::vector<std::uint64_t>;
using Words = std::vector<std::string>;

/// All of a motion.
struct Motion {
    std::vector<Frame> frames;
    std::vector<Words> ids;  ///< by frame, as they are written
    Taken_columns columns;
    Words notes;
    bool has_z = false;

    [[nodiscard]] Numbers numbers() const {
        Numbers result;
        for (const Frame& f : frames) result.push_back(f.number);
        return result;
    }
    [[nodiscard]] std::string column(const std::string& what) const {
        for (const auto& [name, words] : columns)
            if (name == what) return words;
        return "";
    }
};

inline Motion read(const std::filesystem::path& file, const Motion_options& options = {}) {
    Motion_reader reader(file, options);
    Motion motion;
    for (Frame frame; reader.next(frame);) {
        motion.frames.push_back(frame);
        motion.ids.emplace_back();
        for (const std::uint64_t id : frame.id) motion.ids.back().push_back(reader.ids().text(id));
    }
    motion.columns = reader.columns();
    motion.notes = reader.notes();
    motion.has_z = reader.has_z();
    return motion;
}

inline Motion accept(std::string_view content, const std::string& columns = {}, const std::string& name = "a.csv") {
    const Temporary_directory directory;
    return read(directory.file(name, content), {.columns = parse_column_choice(columns)});
}

inline void refuse(std::string_view content, std::uint64_t line, const std::string& fault,
                   const std::string& columns = {}, Error_code code = Error_code::bad_input) {
    const Temporary_directory directory;
    expect_fault(
        directory.file("a.csv", content), line, fault,
        [&](const auto& file) { (void)read(file, {.columns = parse_column_choice(columns)}); }, code);
}

/// The same through a pipe.
template <class Use>
void with_pipe(const std::string& content, Use use) {
    const Temporary_directory directory;
    const auto pipe = directory.path() / "pipe.csv";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << content; });
    use(pipe);
    writer.join();
}

/// Four points, two frames: by frame, the id and position of each.
inline const std::vector<Points_3> walk{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1.25, 0}},
                                        {{0.5, 0, 0}, {1, 0.5, 0}, {0, 1, 0}, {1, 1.5, 0}}};

inline void check_walk(const Motion& motion) {
    REQUIRE(motion.frames.size() == 2);
    for (std::size_t f = 0; f < 2; ++f) {
        CHECK(motion.frames[f].number == f);
        CHECK(motion.ids[f] == Words{"1", "2", "3", "4"});
        CHECK(motion.frames[f].position == walk[f]);
    }
}

}  // namespace annulus_test
