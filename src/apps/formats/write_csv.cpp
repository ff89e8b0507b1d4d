// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/formats/decimal.h>
#include <apps/formats/write_csv.h>

#include <cmath>

namespace annulus::inline v1 {

void append_csv_text(std::string& out, std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
        out += text;
        return;
    }
    out += '"';
    for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    out += '"';
}

namespace {

struct Append_cell {
    std::string& out;

    void operator()(std::monostate) const {}
    void operator()(double value) const {
        if (!std::isnan(value)) append_decimal(out, value);
    }
    void operator()(std::uint64_t value) const { append_decimal(out, value); }
    void operator()(std::int64_t value) const { append_decimal(out, value); }
    void operator()(const std::string& text) const { append_csv_text(out, text); }
};

}  // namespace

std::string write_csv(const Csv_table& table) {
    std::string out;
    for (std::size_t i = 0; i < table.header.size(); ++i) {
        if (i > 0) out += ',';
        append_csv_text(out, table.header[i]);
    }
    out += '\n';
    for (const auto& row : table.rows) {
        if (row.size() != table.header.size())
            throw Error(Error_code::wrong_size, "write_csv: a row has another length than the header");
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i > 0) out += ',';
            std::visit(Append_cell{out}, row[i]);
        }
        out += '\n';
    }
    return out;
}

}  // namespace annulus::inline v1
