// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/io/csv_fields.h>
#include <annulus/io/read_motion.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace annulus {

namespace {

/// Where the coordinates stand among the fields of a line.
struct Columns {
    std::size_t first = 0;
    bool has_z = false;
};

/// `Properties=species:S:1:pos:R:3:...` in the comment of extended XYZ: names, types, numbers of columns.
std::optional<Columns> announced(const Line_reader& reader) {
    const std::string_view key = "Properties=";
    std::size_t begin = reader.line().find(key);
    if (begin == std::string_view::npos) return std::nullopt;
    begin += key.size();
    std::string_view list = reader.line().substr(begin, reader.line().find(' ', begin) - begin);
    std::size_t column = 0;
    const auto take = [&] {
        const std::size_t end = list.find(':');
        const std::string_view word = list.substr(0, end);
        list = end == std::string_view::npos ? std::string_view() : list.substr(end + 1);
        return word;
    };
    while (!list.empty()) {
        const std::string_view name = take();
        take();
        const std::uint64_t width = reader.whole(take(), "the number of columns in Properties");
        if (name == "pos") {
            if (width != 2 && width != 3) reader.fail("Properties give pos " + counted(width, "column"), "2 or 3");
            return Columns{column, width == 3};
        }
        column += width;
    }
    reader.fail("Properties have no pos", "pos:R:2 or pos:R:3");
}

/// A name or atomic number may lead the line: up to three columns beginning with a number have none.
Columns guessed(const Line_reader& reader) {
    const auto& fields = reader.fields();
    double unused = 0;
    const bool leads_with_number = parse_double(fields[0], unused) != Number_kind::not_a_number;
    const std::size_t first = leads_with_number && fields.size() <= 3 ? 0 : 1;
    return {first, fields.size() >= first + 3};
}

void read_xyz_frames(Line_reader& reader, Recorded_motion& motion) {
    while (reader.next_record()) {
        if (reader.fields().size() != 1)
            reader.fail("has " + counted(reader.fields().size(), "column"), "a count of points");
        const std::uint64_t count = reader.whole(reader.fields()[0], "the count of points");
        if (count == 0) reader.fail("a frame has no points", "at least one");
        Frame frame;
        frame.position.reserve(reader.room_for(count, 4, "points"));
        if (!reader.next_line()) reader.fail("the file ends after a count", "a comment line and the points");
        std::optional<Columns> columns = announced(reader);
        for (std::uint64_t i = 0; i < count; ++i) {
            reader.require_record(i, count, "points");
            if (!columns) columns = guessed(reader);
            const auto& fields = reader.fields();
            if (fields.size() < columns->first + (columns->has_z ? 3 : 2))
                reader.fail("has " + counted(fields.size(), "column"),
                            columns->has_z ? "[element] x y z" : "[element] x y");
            const auto* at = &fields[columns->first];
            frame.position.push_back(
                {reader.real(at[0], "x"), reader.real(at[1], "y"), columns->has_z ? reader.real(at[2], "z") : 0.0});
            frame.id.push_back(i);
            frame.line.push_back(reader.number());
        }
        if (motion.frames.empty()) motion.has_z = columns->has_z;
        else if (motion.has_z != columns->has_z)
            reader.fail("a frame has " + std::string(columns->has_z ? "a z" : "no z"),
                        "the same columns in every frame");
        motion.frames.push_back(std::move(frame));
    }
}

/// Sorts a frame by id, and refuses equal ones.
void finish(const Line_reader& reader, Frame& frame) {
    std::vector<std::size_t> order(frame.id.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return std::pair(frame.id[a], a) < std::pair(frame.id[b], b); });
    Frame sorted;
    for (const std::size_t i : order) {
        if (!sorted.id.empty() && sorted.id.back() == frame.id[i])
            reader.fail("the frame above has id " + std::to_string(frame.id[i]) + " twice, at line " +
                            std::to_string(frame.line[i]) + " again",
                        "ids that differ");
        sorted.id.push_back(frame.id[i]);
        sorted.position.push_back(frame.position[i]);
        sorted.line.push_back(frame.line[i]);
    }
    frame = std::move(sorted);
}

void read_csv_frames(Line_reader& reader, Recorded_motion& motion) {
    if (!next_csv_row(reader)) return;
    const char separator = csv_separator(reader.line());
    std::vector<std::string_view> fields;
    split_csv(reader.line(), separator, fields);
    const std::size_t all = fields.size();
    const auto column = [&](std::string_view name) -> std::optional<std::size_t> {
        const auto at = std::find(fields.begin(), fields.end(), name);
        if (at == fields.end()) return std::nullopt;
        return static_cast<std::size_t>(at - fields.begin());
    };
    const auto z = column("z");
    std::size_t at[4];
    constexpr std::string_view names[4] = {"frame", "id", "x", "y"};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto found = column(names[i]);
        if (!found) reader.fail("the header names no column " + std::string(names[i]), "frame, id, x, y and perhaps z");
        at[i] = *found;
    }
    motion.has_z = z.has_value();
    std::uint64_t now = 0;
    while (next_csv_row(reader)) {
        split_csv(reader.line(), separator, fields);
        if (fields.size() != all)
            reader.fail("has " + counted(fields.size(), "column"), std::to_string(all) + " as in the header");
        const std::uint64_t number = reader.whole(fields[at[0]], "the frame");
        if (motion.frames.empty() || number > now) {
            if (!motion.frames.empty()) finish(reader, motion.frames.back());
            motion.frames.emplace_back();
        } else if (number < now) {
            reader.fail("frame " + std::to_string(number) + " after frame " + std::to_string(now), "frames in order");
        }
        now = number;
        Frame& frame = motion.frames.back();
        frame.id.push_back(reader.whole(fields[at[1]], "the id"));
        frame.position.push_back(
            {reader.real(fields[at[2]], "x"), reader.real(fields[at[3]], "y"), z ? reader.real(fields[*z], "z") : 0.0});
        frame.line.push_back(reader.number());
    }
    if (!motion.frames.empty()) finish(reader, motion.frames.back());
}

}  // namespace

Recorded_motion read_motion(const std::filesystem::path& file) {
    const Source source = load_file(file);
    Recorded_motion motion;
    motion.name = source.name;
    Line_reader reader(source);
    const std::string extension = file.extension().string();
    if (extension == ".xyz") read_xyz_frames(reader, motion);
    else if (extension == ".csv") read_csv_frames(reader, motion);
    else throw Input_error(Error_code::bad_input, source.name, 0, "has an unknown extension", ".xyz or .csv");
    if (motion.frames.empty())
        throw Input_error(Error_code::bad_input, source.name, 1, "has no frames", "at least one");
    return motion;
}

}  // namespace annulus
