// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/frame_readers.h>
#include <apps/formats/table_rows.h>
#include <apps/formats/table_survey.h>
#include <apps/formats/time_distances.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace annulus::inline v1 {

/// The most rows that are sorted in memory, 72 bytes each.
inline constexpr std::uint64_t most_sorted_rows = std::uint64_t{1} << 24;

/// Tables in text: rows with a frame, an id, x, y and perhaps z, whose columns are named by a header (table_header.h,
/// table_columns.h). In a file of points frame and id may be missing.
///
/// The rows of a motion may be in any order. A regular file is read twice: if its frames do not decrease, rows are read
/// frame by frame, else all of them are held and sorted, at most most_sorted_rows. What is no regular file has to be in
/// order. Values of the column frame that are whole numbers of 0 or more are the numbers of frames; if one is not, they
/// are times, and frames are numbered from 0 in their order; times that differ by rounding only are refused, since they
/// would tear a frame in two, and uneven ones are told, unless any distance is accepted. Where a file is read once, the
/// first two frames decide this, and the first row whether ids are integers or words. A row without coordinates belongs
/// to its frame, but its point is absent from it.
class Csv_frames : public Frame_reader {
  public:
    Csv_frames(File_bytes& bytes, const Frame_options& options);
    [[nodiscard]] std::optional<std::uint64_t> least_distance() const override { return survey_.least_distance; }

  private:
    struct Row {
        Frame_value frame;
        std::uint64_t line = 0, id = 0;
        Coordinates<3> position{};
        bool is_absent = false;
    };

    bool seek() override;
    void read(Raw_frame& frame) override;
    void refuse_more(const Raw_frame& frame) const override;
    void begin();
    void take_time(double time, std::uint64_t line);
    void take_survey();
    void take_header();
    void sort_rows();
    bool next_row();
    [[nodiscard]] Row row();
    void read_in_order(Raw_frame& frame);
    void read_sorted(Raw_frame& frame);
    void append(const Row& row, Raw_frame& frame);
    [[nodiscard]] std::uint64_t number_of(const Frame_value& value, std::uint64_t line);

    File_bytes& bytes_;
    Table_rows rows_;
    Table_survey survey_{};
    std::optional<bool> has_times_;  ///< whether frames are numbered from 0, once that is decided
    std::uint64_t next_number_ = 0;  ///< then that of the next frame
    Time_distances distances_;
    bool begun_ = false;
    bool has_row_ = false;         ///< whether there is a next row
    Frame_value value_;            ///< of the next row
    std::vector<Row> sorted_;      ///< all rows, if they are sorted
    std::size_t next_sorted_ = 0;  ///< the next of these
    bool noted_absent_ = false, noted_distance_ = false, told_comma_ = false;
};

}  // namespace annulus::inline v1
