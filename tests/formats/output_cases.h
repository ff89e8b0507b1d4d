// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Output directories and what is in them.
#include <annulus/error.h>
#include <apps/formats/output_directory.h>

#include <support/catch.h>

#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace annulus_test {

using namespace annulus;
namespace fs = std::filesystem;

/// Earlier results have names of one letter.
inline bool is_result(std::string_view name) { return name.size() == 1; }

// What a directory may hold.
inline bool anything(const fs::path&) { return true; }
inline bool nothing(const fs::path&) { return false; }

inline std::string refusal(const fs::path& path, Output_directory::Accepted accepted = nothing) {
    try {
        Output_directory out(path, is_result, accepted);
    } catch (const Error& error) {
        CHECK(error.code() == Error_code::bad_input);
        return error.what();
    }
    return "";
}

inline std::size_t entries(const fs::path& path) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), {}));
}

inline ino_t identity(const fs::path& path) {
    struct stat s {};
    REQUIRE(::stat(path.c_str(), &s) == 0);
    return s.st_ino;
}

}  // namespace annulus_test
