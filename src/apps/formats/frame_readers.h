// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/format.h>
#include <apps/formats/periodic_box.h>
#include <apps/formats/point_formats.h>
#include <apps/formats/point_ids.h>
#include <apps/formats/shared_ids.h>
#include <apps/formats/table_columns.h>
#include <apps/formats/taken_columns.h>
#include <apps/formats/xyz_guess.h>
#include <apps/motion/recorded_motion.h>

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
    double time = no_time;          ///< in a table that has times in place of numbers
    std::uint64_t line = 0;         ///< where it begins
    bool ids_are_places = false;    ///< the file has no ids
    std::optional<File_box> box{};  ///< where boxes are taken

    /// Empties it, and keeps its memory for the next one.
    void clear();
};

/// The content that a reader of frames returns: points of one time step, or a motion, where points have ids.
enum class Frame_contents { points, motion };

struct Frame_options {
    Frame_contents wanted = Frame_contents::motion;
    Periodic_box box{};
    Column_choice columns{};    ///< of a table
    bool any_distance = false;  ///< of times: neither refused nor told
    bool in_order = true;  ///< frames ascend; else rows of a table are taken as they come, and a frame may come twice
};

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
    /// Takes the ids of the frame just read, ascending, to find whether frames share any.
    void take_ids(const std::vector<std::uint64_t>& ascending) { shared_ids_.take(ascending); }
    /// Notes after the last frame what can be said of all of them.
    void conclude();
    /// How the ids of the frames read so far are written.
    [[nodiscard]] const Point_ids& ids() const noexcept { return ids_; }
    /// The least difference of the numbers of successive frames, if it was known before they are read.
    [[nodiscard]] virtual std::optional<std::uint64_t> least_distance() const { return std::nullopt; }

  protected:
    Frame_reader(File_bytes& bytes, const Frame_options& options) : reader_(bytes), options_(options) {}

    [[nodiscard]] bool wants_ids() const noexcept { return options_.wanted == Frame_contents::motion; }
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

    /// Appends to what is told of the coordinates.
    void add_to_coordinates(const std::string& words);

    Line_reader reader_;
    Frame_options options_;
    Point_ids ids_;

  private:
    /// Advances to the first line of the next frame; false at the end.
    virtual bool seek() = 0;
    /// Reads the frame that begins here.
    virtual void read(Raw_frame& frame) = 0;
    /// The fault and the expectation where there is more than one frame.
    [[noreturn]] virtual void refuse_more(const Raw_frame& frame) const = 0;

    bool ignored_box_ = false;
    Taken_columns columns_;
    std::vector<std::string> notes_;
    std::optional<bool> found_;  ///< the beginning of another frame, if it was looked for
    Shared_ids shared_ids_;
};

/// XYZ: a count, a comment (extended XYZ is supported: xyz_comment.h), and that many rows. Without `Properties` a row
/// is `[element] x y [z] ...`, where that is unambiguous (xyz_guess.h). A file of points may also be one frame of rows
/// `x y [z]` alone.
class Xyz_frames : public Frame_reader {
  public:
    Xyz_frames(File_bytes& bytes, const Frame_options& options) : Frame_reader(bytes, options) {}

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

/// LAMMPS dumps in text: ITEM: TIMESTEP, NUMBER OF ATOMS, BOX BOUNDS and ATOMS with the names of its columns; UNITS and
/// TIME are skipped. Positions of points are x y z, or xu yu zu unless all three of these are there, then xs ys zs or
/// xsu ysu zsu. Those of a motion are unwrapped if possible, so that atoms which leave the box do not jump: xu yu zu,
/// else x y z with the images ix iy iz, else xsu ysu zsu, else xs ys zs with images, else x y z or xs ys zs alone.
/// Images and shares are multiplied by the box in doubles. A frame is 2D where no column is a z. All frames must have
/// the same kind of columns. A frame's number is its timestep. A box is periodic where one of its sides is p, or where
/// the file does not say how its sides are.
class Lammps_frames : public Frame_reader {
  public:
    Lammps_frames(File_bytes& bytes, const Frame_options& options) : Frame_reader(bytes, options) {}

  private:
    /// The box: a corner, and one edge vector for each direction.
    struct Box {
        std::array<double, 3> corner{};
        std::array<std::array<double, 3>, 3> edge{};
    };
    struct Columns {
        std::size_t all = 0;
        std::array<std::optional<std::size_t>, 3> at, image;
        std::optional<std::size_t> id;
        bool scaled = false, images = false;
        std::string_view suffix{};  ///< of x in its name
    };

    bool seek() override;
    void read(Raw_frame& frame) override;
    void refuse_more(const Raw_frame& frame) const override;
    [[nodiscard]] bool is_item(std::string_view name) const;
    void require_values(std::size_t columns, std::string_view what);
    [[nodiscard]] Box read_box(Raw_frame& frame);
    void read_bounds(Box& box, bool tilted, bool general);
    [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
    [[nodiscard]] Columns find_columns(bool has_box) const;
    [[nodiscard]] std::string not_used(const Columns& taken) const;
    void take(const Columns& at);
    [[nodiscard]] Coordinates<3> position(const Columns& at, const Box& box) const;
    void read_atoms(Raw_frame& frame, std::uint64_t count, const std::optional<Box>& box);

    std::optional<std::string> kind_;  ///< of the columns of earlier frames
};

/// The reader of one of frame_formats. Throws Error(usage) for a choice of columns where the format is no table.
[[nodiscard]] std::unique_ptr<Frame_reader> frames_of(File_bytes& bytes, Format format, const Frame_options& options);

/// The points of a file with one frame; no points for a file without frames.
[[nodiscard]] Raw_points read_only_frame(File_bytes& bytes, Format format, Frame_options options);

}  // namespace annulus::inline v1
