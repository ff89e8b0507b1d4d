// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cli/arguments.h>
#include <annulus/cli/result_files.h>
#include <annulus/cli/tracker.h>
#include <annulus/formats/text_output.h>
#include <annulus/formats/write_pvd.h>
#include <annulus/report/frame_record.h>
#include <annulus/statistics/neighbour_changes.h>

#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace annulus::cli {

/// What is to be written of the frames of a run.
struct Frame_arguments {
    std::uint64_t every = 0;  ///< 0: no frames
    bool voronoi = false;
    bool changes = false;

    [[nodiscard]] bool any() const { return every > 0 || voronoi || changes; }
};

void add_frames(CLI::App& app, Frame_arguments& arguments);
/// Throws Error(usage) for what does not go together; `options` are told what to report.
void prepare(const Frame_arguments& frames, const Common_arguments& common, Options& options);

/// What --every, --voronoi and --changes write: frames.pvd and its frames, voronoi.csv, changes.csv. They are written
/// while the run goes on, beside the place of --output, and taken over at its end; memory does not depend on how many
/// frames there are, but for what the curves of the page are made of.
template <class Moving>
class Frame_files {
  public:
    static constexpr int d = Moving::dimension_of_space;

    /// Listens to the tracker, and outlives its steps. Vertices have their indices for ids until they are named.
    Frame_files(const Common_arguments& common, const Frame_arguments& frames, Tracker<Moving>& tracker);
    Frame_files(const Frame_files&) = delete;
    Frame_files& operator=(const Frame_files&) = delete;

    void name(Index v, std::uint64_t id);
    /// The ids of the points that the next step inserts, in its order.
    void arriving(const std::vector<std::uint64_t>& ids) { arriving_.assign(ids.begin(), ids.end()); }
    /// A frame is complete: before the first step, and after each.
    void frame(std::uint64_t number);

    [[nodiscard]] const std::vector<Frame_record>& records() const { return records_; }
    /// Ends the files and hands them over.
    void write(Result_files& out);

  private:
    void hear(const Move_report& report, Index arrived);
    void write_voronoi(std::uint64_t number, const Mesh_cells<d>& cells, Frame_record& record);
    void write_changes(std::uint64_t number, Frame_record& record);
    void write_vtu(std::uint64_t number, const Mesh_cells<d>& cells);
    [[nodiscard]] bool is_present(std::size_t i) const;

    Frame_arguments frames_;
    const Moving& dt_;
    std::unique_ptr<Result_files> scratch_;
    std::unique_ptr<Text_output> voronoi_, changes_;
    std::vector<std::uint64_t> id_;
    std::deque<std::uint64_t> arriving_;
    Neighbour_changes<d> pairs_;
    std::vector<Frame_record> records_;
    std::vector<Pvd_entry> series_;
    std::vector<double> volume_;  // of this frame, where they are asked for
    std::vector<Index> neighbours_;
};

extern template class Frame_files<Moving_mesh_2>;
extern template class Frame_files<Moving_mesh_3>;

}  // namespace annulus::cli
