// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/csv_frames.h>
#include <apps/formats/decimal.h>
#include <apps/formats/formatted.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace annulus::inline v1 {

namespace {

std::string text_of(const Frame_value& value) {
    return value.is_number ? std::to_string(value.number) : decimal(value.time);
}

}  // namespace

Csv_frames::Csv_frames(File_bytes& bytes, const Frame_options& options)
    : Frame_reader(bytes, options), bytes_(bytes), rows_(reader_, options_.columns, wants_ids()) {}

/// Reads the file once before the rows are read, if that is possible.
void Csv_frames::take_survey() {
    if (!options_.in_order) ids_.use_words();  // what ids are does not matter then, nor do numbers of frames
    if (!options_.in_order || !wants_ids()) has_times_ = true;
    if (has_times_) return;
    const std::unique_ptr<File_bytes> again = bytes_.again();
    if (!again) return;
    survey_ = survey_table(*again, options_.columns);
    has_times_ = !survey_.numbers_frames;
    if (!survey_.has_integer_ids) ids_.use_words();
    if (*has_times_) survey_.least_distance = 1;
}

void Csv_frames::take_header() {
    const Table_header& header = rows_.header();
    Taken_columns taken = header.taken;
    for (auto& [what, words] : taken)
        if (what == table_column_names[frame_column])
            words += std::string(survey_.in_order ? "" : ", rows sorted by it") +
                     (survey_.numbers_frames ? "" : ", times numbered from 0");
    take_columns(std::move(taken));
    if (header.continued > 0)
        note(header.continued_at, counted(header.continued, "line") + " without numbers below the header passed over");
}

/// Finds the columns; afterwards the first row, if any, is next.
void Csv_frames::begin() {
    begun_ = true;
    take_survey();
    if (!next_row()) return;
    const bool decides = wants_ids() && survey_.rows == 0 && !ids_.are_words() && !rows_.is_absent();
    if (decides && !rows_.has_integer_id()) ids_.use_words();
    if (!survey_.in_order) sort_rows();
}

bool Csv_frames::next_row() {
    const bool first = rows_.header().columns.all == 0;
    has_row_ = rows_.next();
    if (first && rows_.header().columns.all > 0) take_header();
    if (has_row_ && rows_.has(frame_column)) value_ = rows_.frame();
    return has_row_;
}

/// The row that the reader is at.
Csv_frames::Row Csv_frames::row() {
    Row result{value_, reader_.number()};
    result.is_absent = rows_.is_absent();
    if (result.is_absent) return result;
    if (wants_ids()) result.id = rows_.id(ids_);
    result.position = rows_.position();
    if (rows_.has_decimal_comma() && !std::exchange(told_comma_, true)) add_to_coordinates(", decimal comma");
    return result;
}

void Csv_frames::sort_rows() {
    if (survey_.rows > most_sorted_rows)
        reader_.fail("has " + std::to_string(survey_.rows) + " rows, and their frames are in no order",
                     "rows in the order of frames, or at most " + std::to_string(most_sorted_rows) +
                         ", which are sorted in memory");
    sorted_.reserve(static_cast<std::size_t>(survey_.rows));
    do sorted_.push_back(row());
    while (next_row());
    std::sort(sorted_.begin(), sorted_.end(),
              [](const Row& a, const Row& b) { return a.frame == b.frame ? a.line < b.line : a.frame < b.frame; });
    for (std::size_t i = 1; i < sorted_.size(); ++i) {
        const Frame_value &before = sorted_[i - 1].frame, &after = sorted_[i].frame;
        if (before == after) continue;
        const std::uint64_t distance = has_times_.value_or(false) ? 1 : after.number - before.number;
        survey_.least_distance = std::min(survey_.least_distance.value_or(distance), distance);
    }
    has_row_ = true;
}

bool Csv_frames::seek() {
    if (!begun_) begin();
    return has_row_;
}

void Csv_frames::append(const Row& row, Raw_frame& frame) {
    if (row.is_absent) {
        if (!std::exchange(noted_absent_, true))
            note(row.line, "has no coordinates: where a row has none, its point is absent from the frame");
        return;
    }
    if (wants_ids()) frame.id.push_back(row.id);
    frame.points.points.push_back(row.position);
    frame.points.lines.push_back(row.line);
}

/// Looks at how far the times of frames are apart.
void Csv_frames::take_time(double time, std::uint64_t line) {
    distances_.take(time, line);
    if (distances_.by_rounding())
        reader_.fail_at(distances_.line(),
                        "the time of this frame is " + distances_.closest() +
                            ", which differ by rounding: rows of one frame would be in two",
                        "the same time in all rows of a frame, or numbers of frames, or --absent-frames skip");
    if (!distances_.are_uneven() || std::exchange(noted_distance_, true)) return;
    note(line, formatted("the times of frames are %.6g to %.6g apart, and each is the next frame", distances_.least(),
                         distances_.most()));
}

/// The number of a frame. The next row has been read.
std::uint64_t Csv_frames::number_of(const Frame_value& value, std::uint64_t line) {
    if (!has_times_) has_times_ = !value.is_number || (has_row_ && !value_.is_number);
    if (*has_times_ && wants_ids() && options_.in_order && !options_.any_distance) take_time(value.time, line);
    if (*has_times_) return wants_ids() ? next_number_++ : value.number;
    if (!value.is_number)
        reader_.fail_at(line, "the frame is " + text_of(value) + ", and those before are whole numbers",
                        "whole numbers of 0 or more, or a regular file, which is read twice");
    return value.number;
}

void Csv_frames::read_in_order(Raw_frame& frame) {
    const Frame_value value = value_;
    const bool unnamed = !rows_.header().named && rows_.header().columns.all == 3;
    std::array<bool, 3> integers{unnamed, true, true};  // of x, y, z
    do {
        append(row(), frame);
        for (std::size_t k = 0; k < 3 && integers[0]; ++k) integers[k] = integers[k] && is_integer(rows_.fields()[k]);
    } while (next_row() && value_ == value);
    if (has_row_ && value_ < value && options_.in_order)
        reader_.fail("frame " + text_of(value_) + " after frame " + text_of(value), "frames in order");
    frame.number = number_of(value, frame.line);
    if (*has_times_) frame.time = value.time;
    if (frame.points.points.size() >= 3 && integers[0] && !integers[1] && !integers[2])
        note(frame.line, x_may_be_an_id);
}

void Csv_frames::read_sorted(Raw_frame& frame) {
    const Row& first = sorted_[next_sorted_];
    frame.line = first.line;
    frame.number = number_of(first.frame, first.line);
    if (*has_times_) frame.time = first.frame.time;
    while (next_sorted_ < sorted_.size() && sorted_[next_sorted_].frame == first.frame)
        append(sorted_[next_sorted_++], frame);
    has_row_ = next_sorted_ < sorted_.size();
}

void Csv_frames::read(Raw_frame& frame) {
    frame.points.has_z = rows_.has(z_column);
    if (sorted_.empty()) read_in_order(frame);
    else read_sorted(frame);
}

void Csv_frames::refuse_more(const Raw_frame& frame) const {
    const std::string after = value_.is_number ? " after frame " + std::to_string(frame.number) : "";
    reader_.fail("a second frame" + after + ", by " + column_words(*rows_.header().columns.at[frame_column]),
                 "one frame, or no column frame");
}

}  // namespace annulus::inline v1
