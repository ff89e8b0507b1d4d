// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/frame_arguments.h>
#include <apps/cli/pair_changes.h>
#include <apps/cli/result_files.h>
#include <apps/cli/run_tracker.h>
#include <apps/formats/point_ids.h>
#include <apps/formats/text_output.h>
#include <apps/formats/write_pvd.h>
#include <apps/report/frame_record.h>

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1::cli {

/// The files of --every, --voronoi, --neighbors and --changes: frames.pvd and its frames, voronoi.csv, pairs.csv,
/// changes.csv; ids.csv where the frames have numbers for ids that are words. They are written during the run, next to
/// the directory of --output, and moved there at its end. Memory does not depend on the number of frames, except for
/// the data of the curves on the page.
template <class Moving>
class Frame_files {
  public:
    static constexpr int d = Moving::dimension_of_space;

    /// Becomes the listener of the tracker. This object must exist as long as the tracker makes steps. The id of a
    /// vertex is its index until `name` sets another.
    Frame_files(const Common_arguments& common, const Frame_arguments& frames, Run_tracker<Moving>& tracker);
    Frame_files(const Frame_files&) = delete;
    Frame_files& operator=(const Frame_files&) = delete;

    void name(Index v, std::uint64_t id);
    /// From now on ids are written as these are; they must exist as long as this object.
    void write_ids_as(const Point_ids& ids) { ids_ = &ids; }
    /// The ids of the points that the next step inserts, in the order of insertion.
    void arriving(const std::vector<std::uint64_t>& ids) { arriving_.assign(ids.begin(), ids.end()); }
    /// To be called for each complete frame: before the first step, and after each step.
    void frame(std::uint64_t number);

    [[nodiscard]] const std::vector<Frame_record>& records() const { return records_; }
    /// Completes the files and moves them to `out`.
    void write(Result_files& out);

  private:
    void hear(const Move_result& report, Index arrived);
    void append_id(std::string& text, std::uint64_t id) const;
    /// "12,7,9,0,-1,0," with the shift in a periodic box: the columns of pair_head.
    void append_pair(std::string& text, std::uint64_t number, std::uint64_t first, std::uint64_t second,
                     const Shift<d>& shift) const;
    void measure();
    void write_voronoi(std::uint64_t number, Frame_record& record);
    void write_pairs(std::uint64_t number);
    void write_changes(std::uint64_t number, Frame_record& record);
    void write_vtu(std::uint64_t number);
    [[nodiscard]] bool is_present(std::size_t i) const;

    Frame_arguments frames_;
    const Moving& dt_;
    std::unique_ptr<Result_files> scratch_;
    std::unique_ptr<Text_output> voronoi_, pairs_, changes_;
    std::vector<std::uint64_t> id_;
    const Point_ids* ids_ = nullptr;  ///< null: they are numbers
    std::deque<std::uint64_t> arriving_;
    Pair_changes<Moving> events_;
    std::vector<Frame_record> records_;
    std::vector<Pvd_entry> series_;
    std::optional<Voronoi_clip<d>> clip_;
    Frame_measures<d> measures_;  // of this frame
};

extern template class Frame_files<Moving_mesh_2>;
extern template class Frame_files<Moving_mesh_3>;
extern template class Frame_files<Boxed_mesh<2>>;
extern template class Frame_files<Boxed_mesh<3>>;

}  // namespace annulus::inline v1::cli
