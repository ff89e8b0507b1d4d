// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/formats/csv_fields.h>
#include <apps/formats/input_error.h>
#include <apps/formats/table_columns.h>
#include <apps/formats/table_names.h>

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

namespace {

constexpr const char* how_to_say = ", or names given by --columns";

/// A name as in the lists of table_names.h.
std::string plain_name(std::string_view field) {
    const std::size_t unit = field.find_first_of("/[(");
    if (unit != std::string_view::npos && unit > 0) field = field.substr(0, unit);
    std::string name;
    for (const char c : field)
        if (c != ' ' && c != '_' && c != '-') name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return name;
}

/// The number from 1 that a text is.
std::optional<std::size_t> number_of(std::string_view text) {
    std::size_t value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc() || end != text.data() + text.size() || value == 0) return std::nullopt;
    return value;
}

/// Looks for columns in one header; the first fault is kept.
class Search {
  public:
    Search(std::span<const std::string_view> header, Table_columns& found) : header_(header), found_(found) {
        for (const std::string_view field : header) plain_.push_back(plain_name(field));
    }

    /// The column of a known name: as it is, else without its unit and the like.
    std::optional<std::size_t> known(std::string_view name) {
        const auto exact = only(name, [&](std::size_t i) { return equals_lower(header_[i], name); });
        return exact ? exact : only(name, [&](std::size_t i) { return plain_[i] == name; });
    }
    std::optional<std::size_t> known(std::span<const std::string_view> names) {
        for (const std::string_view name : names)
            if (const auto at = known(name)) return at;
        return std::nullopt;
    }
    /// The column that the choice names: as written, else in either case, else by its number.
    void chosen(Table_column column, const std::string& name) {
        auto at = only(name, [&](std::size_t i) { return header_[i] == name; });
        if (!at) at = only(name, [&](std::size_t i) { return plain_[i] == plain_name(name); });
        const auto number = number_of(name);
        if (!at && number && *number <= header_.size()) at = *number - 1;
        found_.at[column] = at;
        if (at) return;
        std::string names;
        for (const std::string_view field : header_) names += (names.empty() ? "" : ",") + std::string(field);
        fault(
            "names no column " + shown(name) + ", which --columns gives for " + std::string(table_column_names[column]),
            "one of " + shown(names));
    }
    void fault(std::string what, std::string expected) {
        if (!found_.fault.empty()) return;
        found_.fault = std::move(what);
        found_.expected = std::move(expected);
    }

  private:
    template <class Is>
    std::optional<std::size_t> only(std::string_view name, Is is) {
        std::optional<std::size_t> at;
        for (std::size_t i = 0; i < header_.size(); ++i) {
            if (!is(i)) continue;
            if (at) fault("names two columns " + std::string(name), "one");
            at = i;
        }
        return at;
    }

    std::span<const std::string_view> header_;
    Table_columns& found_;
    std::vector<std::string> plain_;
};

/// The column of frames in a table of points: one of this name, or where there are ids, so that this is a motion, one
/// of any name for frames.
std::optional<std::size_t> frame_of_points(std::span<const std::string_view> header, const Column_choice& choice,
                                           Search& search) {
    const auto frame = search.known("frame");
    if (frame || !choice[x_column].empty()) return frame;
    Table_columns ignored;  // two columns of a name are no fault, and none of these
    Search motion(header, ignored);
    const auto at = motion.known(id_names) ? motion.known(frame_names) : std::nullopt;
    return ignored.complete() ? at : std::nullopt;
}

void require_needed(Table_columns& found, Search& search, bool motion) {
    for (const Table_column column : {frame_column, id_column, x_column, y_column}) {
        if (found.at[column] || (column < x_column && !motion)) continue;
        search.fault("names no column " + std::string(table_column_names[column]),
                     motion ? std::string("frame, id, x, y and perhaps z") + how_to_say : "columns x, y and perhaps z");
    }
}

}  // namespace

Column_choice parse_column_choice(std::string_view text) {
    const auto fail = [](const std::string& what) { throw Error(Error_code::usage, "--columns: " + what); };
    Column_choice choice;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(','), text.size());
        const std::string_view pair = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t equals = std::min(pair.find('='), pair.size());
        const std::string_view key = pair.substr(0, equals), name = pair.substr(std::min(equals + 1, pair.size()));
        const auto column = std::find(table_column_names.begin(), table_column_names.end(), key);
        if (column == table_column_names.end() || name.empty())
            fail(shown(pair) + " is not KEY=NAME with one of the keys frame, id, x, y, z");
        std::string& chosen = choice[static_cast<std::size_t>(column - table_column_names.begin())];
        if (!chosen.empty()) fail(std::string(key) + " is given twice");
        chosen = name;
    }
    if (choice[x_column].empty() != choice[y_column].empty()) fail("x and y are given together");
    if (!choice[z_column].empty() && choice[x_column].empty()) fail("z is given with x and y");
    return choice;
}

bool is_empty(const Column_choice& choice) {
    return std::all_of(choice.begin(), choice.end(), [](const std::string& name) { return name.empty(); });
}

void require_table(Format format, const Column_choice& choice) {
    if (format != Format::csv && !is_empty(choice))
        throw Error(Error_code::usage, "--columns is for tables (.csv, .tsv, .txt, .dat)");
}

Table_columns find_columns(std::span<const std::string_view> header, const Column_choice& choice, bool motion) {
    Table_columns found;
    found.all = header.size();
    Search search(header, found);
    for (std::size_t k = 0; k < choice.size(); ++k)
        if (!choice[k].empty() && (motion || k != id_column)) search.chosen(static_cast<Table_column>(k), choice[k]);
    if (choice[frame_column].empty())
        found.at[frame_column] = motion ? search.known(frame_names) : frame_of_points(header, choice, search);
    if (motion && choice[id_column].empty()) found.at[id_column] = search.known(id_names);
    for (const auto& family : coordinate_names) {
        if (!choice[x_column].empty() || (found.at[x_column] && found.at[y_column])) break;
        const auto x = search.known(family[0]), y = search.known(family[1]);
        if (found.at[x_column] && !(x && y)) continue;
        found.at[x_column] = x;
        found.at[y_column] = y;
        found.at[z_column] = search.known(family[2]);
    }
    require_needed(found, search, motion);
    return found;
}

std::optional<Table_columns> numbered_columns(const Column_choice& choice, std::size_t all, bool motion) {
    Table_columns found;
    found.all = all;
    for (std::size_t k = 0; k < choice.size(); ++k) {
        if (choice[k].empty() && (k == z_column || (k < x_column && !motion))) continue;
        const auto number = number_of(choice[k]);
        if (!number) return std::nullopt;
        found.at[k] = *number - 1;
        if (*number <= all || !found.complete()) continue;
        found.fault = "has " + counted(all, "column");
        found.expected = "a column " + choice[k] + ", which --columns gives for " + std::string(table_column_names[k]);
    }
    if (!motion) found.at[id_column].reset();
    return found;
}

}  // namespace annulus::inline v1
