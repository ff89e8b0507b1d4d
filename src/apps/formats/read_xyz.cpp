// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/frame_readers.h>

namespace annulus::inline v1 {

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
    if (wants_ids()) frame.id.push_back(columns.id ? reader_.whole(fields[*columns.id], "the id") : frame.id.size());
}

/// Advances to the next row. Where the last one is missing or of another shape, and the comment looks like a row, the
/// comment is one.
void Xyz_frames::require_row(std::uint64_t done, std::uint64_t count, const Xyz_columns* columns,
                             const Comment_row& comment) {
    const bool other =
        columns != nullptr && (comment.fields != columns->all || (columns->x == 0 && comment.begins_with_word));
    if (done + 1 < count || comment.fields == 0 || other) return reader_.require_record(done, count, "points");
    if (reader_.next_record() && reader_.fields().size() == comment.fields) return;
    reader_.fail_at(comment.line,
                    "reads like a row of points in the place of the comment, and the last of " + counted(count, "row") +
                        " is missing",
                    "a comment line, which may be blank, between the count and the rows");
}

void Xyz_frames::take(const Xyz_columns& columns) {
    Taken_columns taken;
    const auto add = [&](const char* what, std::size_t at, const char* name) {
        taken.emplace_back(what, column_words(at, columns.announced ? name : ""));
    };
    if (wants_ids() && columns.id) add("id", *columns.id, "id");
    else if (wants_ids()) taken.emplace_back("id", place_as_id);
    add("x", columns.x, "pos");
    add("y", columns.x + 1, "pos");
    if (columns.has_z) add("z", columns.x + 2, "pos");
    take_columns(std::move(taken));
}

void Xyz_frames::read_plain(Raw_frame& frame) {
    Xyz_guess guess = Xyz_guess::of_plain(reader_);
    const std::uint64_t first = reader_.number();
    frame.points.has_z = guess.columns().has_z;
    do {
        guess.examine(reader_);
        read_row(guess.columns(), frame);
    } while (reader_.next_record());
    take(guess.columns());
    if (guess.x_may_be_an_id()) note(first, x_may_be_an_id);
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
    if (!comment.periodic.empty() && options_.box.taken) frame.box = box_of(reader_, comment);
    else if (!comment.periodic.empty()) meet_box(comment.periodic);
    std::vector<std::string_view> words;
    split_at_blanks(reader_.line(), words);
    const Comment_row comment_row{reader_.number(), looks_like_row(words) ? words.size() : 0,
                                  !words.empty() && is_element_name(words[0])};
    std::optional<Xyz_guess> guess;
    for (std::uint64_t i = 0; i < count; ++i) {
        require_row(i, count, comment.columns ? &*comment.columns : nullptr, comment_row);
        if (!comment.columns) comment.columns = guess.emplace(Xyz_guess::of_counted(reader_)).columns();
        if (guess) guess->examine(reader_);
        read_row(*comment.columns, frame);
    }
    if (guess) guess->require_clear(reader_);
    if (!comment.columns) return;
    frame.points.has_z = comment.columns->has_z;
    frame.ids_are_places = !comment.columns->id;
    if (count > 0) take(*comment.columns);
    if (!guess || !notes().empty()) return;
    if (guess->x_may_be_an_id()) note(comment_row.line + 1, x_may_be_an_id);
    if (guess->numbers_elements()) note(comment_row.line + 1, "column 1 is taken for atomic numbers, column 2 for x");
}

void Xyz_frames::refuse_more(const Raw_frame& frame) const {
    reader_.fail("there is more after the " + counted(frame.points.points.size(), "point") + " that the file announces",
                 "the end of the file (one frame)");
}

}  // namespace annulus::inline v1
