// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/input.h>
#include <apps/formats/decimal.h>
#include <apps/report/page.h>

#include <algorithm>
#include <cstdio>

namespace annulus::inline v1::cli {

void add_open(CLI::App& app, bool& open) {
    app.add_flag("--open", open,
                 "Take the points of a file with a periodic box as they are, with open boundaries;\n"
                 "without this option such a file is refused");
}

Input_record input_of(const Motion_reader& reader, int dimension) {
    Input_record input{reader.columns(), {}, {}, reader.notes()};
    if (dimension == 2) std::erase_if(input.columns, [](const auto& column) { return column.first == "z"; });
    if (reader.ignored_box()) input.ignored = {"box"};
    return input;
}

void print_input(const Input_record& input, int dimension) {
    if (!input.columns.empty()) {
        const std::string why = input.dimension.empty() ? "" : ": " + input.dimension;
        std::printf("dimension      %d%s\n", dimension, why.c_str());
        std::printf("columns        %s\n", listed(input.columns).c_str());
    }
    if (input.box.empty()) return;
    std::string vectors;
    for (const auto& vector : input.box)
        for (std::size_t k = 0; k < vector.size(); ++k) {
            vectors += k > 0 ? " " : vectors.empty() ? "" : ", ";
            append_decimal(vectors, vector[k]);
        }
    std::printf("box            %s: %s\n", input.box_from.c_str(), vectors.c_str());
}

}  // namespace annulus::inline v1::cli
