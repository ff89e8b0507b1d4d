// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/formats/point_formats.h>
#include <annulus/formats/xyz_comment.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace annulus {

/// One timestamp as a file has it.
struct Raw_frame {
    Raw_points points;
    std::vector<std::uint64_t> id;  ///< of each point, in the order of the file; empty where nobody asked for ids
    std::uint64_t number = 0;       ///< what the file calls the frame, or its place from 0
    std::uint64_t line = 0;         ///< where it begins
    bool ids_are_places = false;    ///< the file has no ids
};

/// What a reader of frames is asked for: points of one timestamp, or a motion, where points have ids.
enum class Wanted { points, motion };

/// Frames of XYZ, one after the other: a count, a comment (extended XYZ is obeyed: xyz_comment.h), and that many rows.
/// Without `Properties` a row is `[element] x y [z] ...`. Where points are wanted a file may also be one frame of rows
/// `x y [z] ...` alone. The source must outlive the reader.
class Xyz_frames {
  public:
    Xyz_frames(const Source& source, Wanted wanted) : reader_(source), wanted_(wanted) {}

    /// False at the end of the file. Frames without points are frames.
    bool next(Raw_frame& frame);
    /// Fails unless the frame just read is the last.
    void require_last(const Raw_frame& frame);

  private:
    void read_plain(Raw_frame& frame);
    void read_row(const Xyz_columns& columns, Raw_frame& frame);

    Line_reader reader_;
    Wanted wanted_;
    std::uint64_t next_number_ = 0;
};

/// Frames of CSV: a header that names the columns frame, id, x, y and perhaps z, in either case and any order, and rows
/// whose frame does not decrease. Where points are wanted, frame and id may be missing, and without a header the first
/// columns are x, y and z. Lines that begin with # are comments before the first row, and rows after it; the header may be
/// such a comment, as NumPy writes it. The source must outlive the reader.
class Csv_frames {
  public:
    Csv_frames(const Source& source, Wanted wanted) : reader_(source), wanted_(wanted) {}

    /// False at the end of the file.
    bool next(Raw_frame& frame);
    /// Fails unless the frame just read is the last.
    void require_last(const Raw_frame& frame);

  private:
    enum Column { frame_column, id_column, x_column, y_column, z_column };
    struct Header {
        std::array<std::optional<std::size_t>, 5> at;  ///< by Column
        std::size_t all = 0;                           ///< columns
        char separator = ',';
    };

    void begin();
    void split(std::string_view text);
    bool next_row();
    [[nodiscard]] Header header() const;

    Line_reader reader_;
    Wanted wanted_;
    std::vector<std::string_view> fields_;  ///< of the row that is due
    bool begun_ = false;
    bool row_is_due_ = false;
    bool has_header_ = false;
    char separator_ = ',';
    Header columns_;
};

}  // namespace annulus
