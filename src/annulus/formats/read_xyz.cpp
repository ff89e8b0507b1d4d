// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/formats/frame_readers.h>

namespace annulus {

namespace {

/// The shape of a file without counts from its first row.
Xyz_columns columns_of_plain(const Line_reader& reader) {
    const std::size_t all = reader.fields().size();
    if (all < 2) reader.fail("has 1 column", "x y [z]");
    return {all, 0, all >= 3, {}, false};
}

/// A name or atomic number may lead the row: up to three columns beginning with a number have none.
Xyz_columns columns_of_counted(const Line_reader& reader) {
    const auto& fields = reader.fields();
    double unused = 0;
    const bool leads_with_number = parse_double(fields[0], unused) != Number_kind::not_a_number;
    const std::size_t first = leads_with_number && fields.size() <= 3 ? 0 : 1;
    if (fields.size() < first + 2) reader.fail("has " + counted(fields.size(), "column"), "[element] x y [z]");
    return {fields.size(), first, fields.size() >= first + 3, {}, false};
}

}  // namespace

void Xyz_frames::read_row(const Xyz_columns& columns, Raw_frame& frame) {
    const auto& fields = reader_.fields();
    if (fields.size() != columns.all)
        reader_.fail(
            "has " + counted(fields.size(), "column"),
            std::to_string(columns.all) + (columns.announced ? " as Properties say" : " as in the lines above"));
    const auto* at = &fields[columns.x];
    frame.points.points.push_back(
        {reader_.real(at[0], "x"), reader_.real(at[1], "y"), columns.has_z ? reader_.real(at[2], "z") : 0.});
    frame.points.lines.push_back(reader_.number());
    if (wants_ids())
        frame.id.push_back(columns.id ? reader_.whole(fields[*columns.id], "the id") : frame.id.size());
}

void Xyz_frames::read_plain(Raw_frame& frame) {
    const Xyz_columns columns = columns_of_plain(reader_);
    frame.points.has_z = columns.has_z;
    do read_row(columns, frame);
    while (reader_.next_record());
}

void Xyz_frames::read(Raw_frame& frame) {
    frame.number = next_number_++;
    if (reader_.fields().size() != 1) {
        if (wants_ids()) reader_.fail("has " + counted(reader_.fields().size(), "column"), "a count of points");
        return read_plain(frame);
    }
    const std::uint64_t count = reader_.whole(reader_.fields()[0], "the count of points");
    make_room(frame, count, 4);
    if (!reader_.next_line()) reader_.fail("the file ends after its count", "a comment line and the points");
    Xyz_comment comment = parse_xyz_comment(reader_);
    if (!comment.periodic.empty())
        frame.points.notes.push_back(reader_.name() + ":" + std::to_string(reader_.number()) + ": " + comment.periodic +
                                     " ignored: periodic boxes are not supported, points are taken as they stand");
    for (std::uint64_t i = 0; i < count; ++i) {
        reader_.require_record(i, count, "points");
        if (!comment.columns) comment.columns = columns_of_counted(reader_);
        read_row(*comment.columns, frame);
    }
    if (comment.columns) {
        frame.points.has_z = comment.columns->has_z;
        frame.ids_are_places = !comment.columns->id;
    }
}

void Xyz_frames::refuse_more(const Raw_frame& frame) const {
    reader_.fail("there is more after the " + counted(frame.points.points.size(), "point") + " that the file announces",
                 "the end of the file (one frame)");
}

}  // namespace annulus
