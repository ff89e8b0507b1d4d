// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/format.h>
#include <apps/formats/periodic_box.h>
#include <apps/formats/point_formats.h>
#include <apps/formats/taken_columns.h>
#include <apps/formats/xyz_guess.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace annulus::inline v1 {

/// One time step as it is in the file.
struct Raw_frame {
    Raw_points points;
    std::vector<std::uint64_t> id;  ///< of each point, in the order of the file; empty where no ids were requested
    std::uint64_t number = 0;       ///< the frame's number in the file, or its position, from 0
    std::uint64_t line = 0;         ///< where it begins
    bool ids_are_places = false;    ///< the file has no ids

    /// Empties it, and keeps its memory for the next one.
    void clear();
};

/// The content that a reader of frames returns: points of one time step, or a motion, where points have ids.
enum class Frame_contents { points, motion };

/// Frames of a file, one after the other, read on demand. The bytes must outlive the reader.
class Frame_reader {
  public:
    virtual ~Frame_reader() = default;
    Frame_reader(const Frame_reader&) = delete;
    Frame_reader& operator=(const Frame_reader&) = delete;

    /// Whether there is no further frame. Advances to where it begins.
    bool at_end();
    /// False at the end of the file. Frames without points are frames.
    bool next(Raw_frame& frame);
    /// Fails unless the frame just read is the last.
    void require_last(const Raw_frame& frame);

    /// Which columns were taken, decided by the first frame with points.
    [[nodiscard]] const Taken_columns& columns() const noexcept { return columns_; }
    /// Content of the file that is ignored or may have another meaning, each a line with the file's name.
    [[nodiscard]] const std::vector<std::string>& notes() const noexcept { return notes_; }
    /// Whether a periodic box was ignored.
    [[nodiscard]] bool ignored_box() const noexcept { return ignored_box_; }

  protected:
    Frame_reader(File_bytes& bytes, Frame_contents wanted, const Periodic_box& box)
        : reader_(bytes), wanted_(wanted), box_(box) {}

    [[nodiscard]] bool wants_ids() const noexcept { return wanted_ == Frame_contents::motion; }
    /// Reserves memory for as many points as the file announces.
    void make_room(Raw_frame& frame, std::uint64_t count, std::uint64_t bytes_a_point) const;

    /// For a line with `what`, as "Lattice", that declares a periodic box: refuses it, or notes the first one.
    void meet_box(const std::string& what);
    void note(std::uint64_t line, const std::string& text);
    static constexpr const char* x_may_be_an_id = "column 1 has integers as ids are, and is taken for x; z is column 3";
    /// Records once in which columns the coordinates, and an id if needed, are.
    void take_columns(Taken_columns columns) {
        if (columns_.empty()) columns_ = std::move(columns);
    }

    Line_reader reader_;

  private:
    /// Advances to the first line of the next frame; false at the end.
    virtual bool seek() = 0;
    /// Reads the frame that begins here.
    virtual void read(Raw_frame& frame) = 0;
    /// The fault and the expectation where there is more than one frame.
    [[noreturn]] virtual void refuse_more(const Raw_frame& frame) const = 0;

    Frame_contents wanted_;
    Periodic_box box_;
    bool ignored_box_ = false;
    Taken_columns columns_;
    std::vector<std::string> notes_;
    std::optional<bool> found_;  ///< the beginning of another frame, if it was looked for
};

/// XYZ: a count, a comment (extended XYZ is supported: xyz_comment.h), and that many rows. Without `Properties` a row
/// is `[element] x y [z] ...`, where that is unambiguous (xyz_guess.h). A file of points may also be one frame of rows
/// `x y [z]` alone.
class Xyz_frames : public Frame_reader {
  public:
    Xyz_frames(File_bytes& bytes, Frame_contents wanted, const Periodic_box& box) : Frame_reader(bytes, wanted, box) {}

  private:
    bool seek() override { return reader_.next_record(); }
    void read(Raw_frame& frame) override;
    void refuse_more(const Raw_frame& frame) const override;
    void read_plain(Raw_frame& frame);
    void read_row(const Xyz_columns& columns, Raw_frame& frame);
    struct Comment_row {
        std::uint64_t line = 0;
        std::size_t fields = 0;  ///< if it looks like a row, else 0
        bool begins_with_word = false;
    };
    void require_row(std::uint64_t done, std::uint64_t count, const Xyz_columns* columns, const Comment_row& comment);
    void take(const Xyz_columns& columns);

    std::uint64_t next_number_ = 0;
};

/// CSV: a header that names the columns frame, id, x, y and perhaps z, in either case and any order, and rows whose
/// frame does not decrease. In a file of points frame and id may be missing; without a header the columns are x, y and
/// z, and no others are allowed. Lines that begin with # are comments before the first row, and rows after it; the
/// header may be such a comment, as NumPy writes it.
class Csv_frames : public Frame_reader {
  public:
    Csv_frames(File_bytes& bytes, Frame_contents wanted, const Periodic_box& box) : Frame_reader(bytes, wanted, box) {}

  private:
    enum Column { frame_column, id_column, x_column, y_column, z_column };
    struct Header {
        std::array<std::optional<std::size_t>, 5> at;  ///< by Column
        std::size_t all = 0;                           ///< columns
        char separator = ',';
        Taken_columns taken{};
    };

    bool seek() override;
    void read(Raw_frame& frame) override;
    void refuse_more(const Raw_frame& frame) const override;
    void begin();
    void split(std::string_view text);
    bool next_row();
    [[nodiscard]] Header header() const;

    std::vector<std::string_view> fields_;  ///< of the next row
    bool begun_ = false;
    bool row_is_due_ = false;
    bool has_header_ = false;
    char separator_ = ',';
    Header columns_;
};

/// LAMMPS dumps in text: ITEM: TIMESTEP, NUMBER OF ATOMS, BOX BOUNDS and ATOMS with the names of its columns; UNITS and
/// TIME are skipped. Positions are x y z, or xu yu zu unless all three of these are there, then xs ys zs or xsu ysu
/// zsu, which are converted in doubles; a frame is 2D where no column is a z. All frames must have the same kind of
/// columns. A frame's number is its timestep. A box is periodic where one of its sides is p, or where the file does not
/// say how its sides are.
class Lammps_frames : public Frame_reader {
  public:
    Lammps_frames(File_bytes& bytes, Frame_contents wanted, const Periodic_box& box)
        : Frame_reader(bytes, wanted, box) {}

  private:
    /// The box: a corner, and one edge vector for each direction.
    struct Box {
        std::array<double, 3> corner{};
        std::array<std::array<double, 3>, 3> edge{};
    };
    struct Columns {
        std::size_t all = 0;
        std::array<std::optional<std::size_t>, 3> at;
        std::optional<std::size_t> id;
        bool scaled = false;
        std::string_view kind;  ///< the suffix of x in its name
        std::string unused;     ///< columns of unwrapped positions and of images that are there but not used
    };

    bool seek() override;
    void read(Raw_frame& frame) override;
    void refuse_more(const Raw_frame& frame) const override;
    [[nodiscard]] bool is_item(std::string_view name) const;
    void require_values(std::size_t columns, std::string_view what);
    [[nodiscard]] Box read_box();
    [[nodiscard]] Columns find_columns() const;
    [[nodiscard]] std::string unwrapping(std::string_view taken) const;
    void take(const Columns& at);
    void read_atoms(Raw_frame& frame, std::uint64_t count, const std::optional<Box>& box);

    std::optional<std::string_view> kind_;  ///< of the columns of earlier frames
};

/// The reader of one of frame_formats.
[[nodiscard]] std::unique_ptr<Frame_reader> frames_of(File_bytes& bytes, Format format, Frame_contents wanted,
                                                      const Periodic_box& box);

/// The points of a file with one frame; no points for a file without frames.
[[nodiscard]] Raw_points read_only_frame(File_bytes& bytes, Format format, const Periodic_box& box);

}  // namespace annulus::inline v1
