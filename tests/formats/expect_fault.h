// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/input_error.h>

#include <support/catch.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace annulus_test {

/// Runs `read`, which must refuse `file` at `line` for a reason that contains `fault`, in one line of the fixed form.
template <class Read>
void expect_fault(const std::filesystem::path& file, std::uint64_t line, const std::string& fault, Read read,
                  annulus::Error_code code = annulus::Error_code::bad_input) {
    INFO("file " << file << ", fault " << fault);
    try {
        read(file);
        FAIL("was accepted");
    } catch (const annulus::Input_error& error) {
        const std::string what = error.what();
        INFO("what() is " << what);
        CHECK(error.line() == line);
        CHECK(error.code() == code);
        CHECK(error.file() == file.string());
        CHECK(error.fault().find(fault) != std::string::npos);
        CHECK(!error.expected().empty());
        CHECK(what.find('\n') == std::string::npos);
        CHECK(what.find('\r') == std::string::npos);
        CHECK(what == file.string() + (line == 0 ? "" : ":" + std::to_string(line)) + ": " + error.fault() +
                          "; expected " + error.expected());
    }
}

}  // namespace annulus_test
