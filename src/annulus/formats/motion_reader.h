// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/formats/file_bytes.h>
#include <annulus/formats/frame_readers.h>
#include <annulus/motion/recorded_motion.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace annulus {

/// What to do where numbers of frames are further apart than others of the file: a frame without points has no row in
/// CSV.
enum class Absent_frames {
    refuse,  ///< an Input_error
    empty,   ///< one frame without points stands for those that are absent: all points disappear and appear again
    skip,    ///< one step leads over them
};

struct Motion_options {
    Absent_frames absent = Absent_frames::refuse;
    /// "xyz", "csv", "lammps": what the file is, whatever its extension says; standard input has none.
    std::string format{};
    Periodic_box box{};
};

/// A recorded motion, a frame at a time, by the extension of the file (format.h); `-` is standard input. No more than
/// a frame is held, however many there are.
///
/// `.xyz`: frames one after the other, see Xyz_frames; `.lammpstrj`: see Lammps_frames. A point's id is its `id` in
/// Properties or ATOMS, in all frames or none; else its place in the frame, from 0. `.csv`: see Csv_frames; frames
/// are numbered evenly, as far apart as the first two, or `absent` says what to do. Points appear and disappear by
/// their id; frames may have no points.
///
/// A reader throws Input_error for everything that is wrong with the file, when it comes to it; that includes
/// having no point at all, two of one id in a frame, and a periodic box unless it is to be ignored.
class Motion_reader {
  public:
    /// Throws Input_error where the file cannot be opened, Error(usage) for what is no format. With
    /// Absent_frames::empty the distance of frames is the least there is, for which a CSV file is read once more;
    /// what cannot be read twice (standard input) has that of its first two frames, and frames that are closer are
    /// refused.
    explicit Motion_reader(const std::filesystem::path& file, const Motion_options& options = {});

    /// The next frame, its points by id; false at the end. Linear but for sorting ids that do not ascend.
    bool next(Frame& frame);
    /// Is there no further frame? Reads as far as the line where it begins.
    [[nodiscard]] bool at_end();

    [[nodiscard]] const std::string& name() const { return bytes_->name(); }
    /// Of the points read so far: all or none.
    [[nodiscard]] bool has_z() const { return has_z_.value_or(false); }
    /// What the file says and is not obeyed, or may mean something else, as far as it is read; each a line with the
    /// file's name.
    [[nodiscard]] const std::vector<std::string>& notes() const { return frames_->notes(); }
    /// What was taken for what, by the first frame with points.
    [[nodiscard]] const Taken_columns& columns() const { return frames_->columns(); }
    /// Was a periodic box ignored, as far as the file is read?
    [[nodiscard]] bool ignored_box() const { return frames_->ignored_box(); }
    /// How much of the file is read, 0 to 1; none where its length is not known.
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
    bool raw_waits_ = false;  ///< for a frame without points that comes before it
    std::optional<std::uint64_t> last_, stride_;
    std::optional<bool> has_z_, ids_are_places_;
    bool any_ = false;  ///< a frame
};

/// Is z the same everywhere, or not there at all? Reads until it differs.
[[nodiscard]] bool is_flat(const std::filesystem::path& file, const Motion_options& options = {});

}  // namespace annulus
