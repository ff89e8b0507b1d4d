// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/file_bytes.h>
#include <apps/formats/frame_readers.h>
#include <apps/motion/recorded_motion.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// How to treat frame numbers that are further apart than others of the file: a frame without points has no row in CSV.
enum class Absent_frames {
    refuse,  ///< an Input_error
    empty,   ///< insert one frame without points for the absent ones: all points disappear and appear again
    skip,    ///< one step covers them
};

struct Motion_options {
    Absent_frames absent = Absent_frames::refuse;
    /// "xyz", "csv", "lammps", "npy": the format of the file in place of that of its extension; standard input has
    /// none.
    std::string format{};
    Periodic_box box{};
    Column_choice columns{};  ///< which columns of a table are taken; the others are found by their names
};

/// A recorded motion, a frame at a time, by the extension of the file (format.h); `-` is standard input. No more than
/// one frame is held in memory, but for tables whose rows are not in the order of frames.
///
/// `.xyz`: frames one after the other, see Xyz_frames; `.lammpstrj`: see Lammps_frames. A point's id is its `id` in
/// Properties or ATOMS, in all frames or none; else its place in the frame, from 0. `.npy`: see Npy_frames. `.csv` and
/// other tables: see Csv_frames; frame numbers have the distance of the first two, or `absent` decides. Points appear
/// and disappear by their id; frames may have no points.
///
/// A reader throws Input_error for every fault of the file when it reaches it. Faults include a file without points,
/// two points with the same id in a frame, and a periodic box unless it is to be ignored.
class Motion_reader {
  public:
    /// Throws Input_error where the file cannot be opened, Error(usage) for an unknown format, and for a choice of
    /// columns where the format is no table. With Absent_frames::empty the distance of frames is the least one of the
    /// file; for standard input, which cannot be read twice, it is that of the first two frames, and frames that are
    /// closer are refused.
    explicit Motion_reader(const std::filesystem::path& file, const Motion_options& options = {});

    /// The next frame, its points by id; false at the end. Linear but for sorting ids that do not ascend.
    bool next(Frame& frame);
    /// Whether there is no further frame. Reads as far as the line where it begins.
    [[nodiscard]] bool at_end();

    [[nodiscard]] const std::string& name() const { return bytes_->name(); }
    /// Whether the points read so far have it: all or none.
    [[nodiscard]] bool has_z() const { return has_z_.value_or(false); }
    /// Content of the file read so far that is ignored or may have another meaning; each a line with the file's name.
    [[nodiscard]] const std::vector<std::string>& notes() const { return frames_->notes(); }
    /// Which columns were taken, decided by the first frame with points.
    [[nodiscard]] const Taken_columns& columns() const { return frames_->columns(); }
    /// How ids are written in the file, as far as it has been read.
    [[nodiscard]] const Point_ids& ids() const { return frames_->ids(); }
    /// Whether a periodic box was ignored so far.
    [[nodiscard]] bool ignored_box() const { return frames_->ignored_box(); }
    /// The fraction of the file that has been read, 0 to 1; none where its length is not known.
    [[nodiscard]] std::optional<double> share_read() const;

  private:
    [[noreturn]] void fail(std::uint64_t line, std::string fault, std::string expected) const;
    void require_same_kind();
    void sort_by_id(Frame& frame);
    bool fills_gap(Frame& frame);

    std::unique_ptr<File_bytes> bytes_;
    std::unique_ptr<Frame_reader> frames_;
    Absent_frames absent_;
    Raw_frame raw_;           ///< the last one read
    bool raw_waits_ = false;  ///< whether a frame without points comes before it
    std::optional<std::uint64_t> last_, stride_;
    std::optional<bool> has_z_, ids_are_places_;
    bool any_ = false;  ///< a frame
};

/// Whether z is the same everywhere or absent. Reads until it differs.
[[nodiscard]] bool is_flat(const std::filesystem::path& file, const Motion_options& options = {});

}  // namespace annulus::inline v1
