// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/motion_reader.h>
#include <apps/formats/read_points.h>
#include <apps/report/run_record.h>

#include <CLI/CLI.hpp>

namespace annulus::inline v1::cli {

/// --open: files with a periodic box are read nevertheless.
void add_open(CLI::App& app, bool& open);

/// How a file was interpreted, up to where it has been read: for summaries, pages and standard output.
[[nodiscard]] Input_record input_of(const Motion_reader& reader, int dimension);
template <int d>
[[nodiscard]] Input_record input_of(const Point_file<d>& file) {
    Input_record input{file.columns, {}, {}, file.notes};
    if (file.ignored_box) input.ignored = {"box"};
    return input;
}

/// Prints the lines `dimension`, `columns` and, in a periodic box, `box` on standard output, if there is an input.
void print_input(const Input_record& input, int dimension);

}  // namespace annulus::inline v1::cli
