// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/formats/file_bytes.h>
#include <annulus/formats/frame_readers.h>
#include <annulus/formats/read_motion.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace annulus {

namespace {

class Collector {
  public:
    Collector(Recorded_motion& motion, Absent_frames absent) : motion_(motion), absent_(absent) {}

    template <class Frames>
    void read(Frames frames) {
        Raw_frame raw;
        while (frames.next(raw)) {
            if (!raw.points.points.empty()) require_same_kind(raw);
            if (motion_.notes.empty()) motion_.notes = std::move(raw.points.notes);
            first_line_.push_back(raw.line);
            motion_.frames.push_back(sorted(std::move(raw)));
        }
        if (motion_.frames.empty()) fail(1, "has no frames", "at least one");
        if (!has_z_) fail(1, "has no points in any frame", "at least one");
        motion_.has_z = *has_z_;
        treat_absent_frames();
    }

  private:
    [[noreturn]] void fail(std::uint64_t line, std::string fault, std::string expected) const {
        throw Input_error(Error_code::bad_input, motion_.name, line, std::move(fault), std::move(expected));
    }

    void require_same_kind(const Raw_frame& raw) {
        const std::uint64_t line = raw.points.lines.front();
        if (has_z_.value_or(raw.points.has_z) != raw.points.has_z)
            fail(line, "a frame has " + std::string(raw.points.has_z ? "a z" : "no z"),
                 "the same columns in every frame");
        if (ids_are_places_.value_or(raw.ids_are_places) != raw.ids_are_places)
            fail(line, "a frame has " + std::string(raw.ids_are_places ? "no id" : "an id"),
                 "an id in every frame, or in none");
        has_z_ = raw.points.has_z;
        ids_are_places_ = raw.ids_are_places;
    }

    /// By id; equal ones are refused.
    Frame sorted(Raw_frame&& raw) const {
        Frame frame;
        frame.number = raw.number;
        if (std::adjacent_find(raw.id.begin(), raw.id.end(), std::greater_equal<>()) == raw.id.end()) {
            frame.id = std::move(raw.id);
            frame.position = std::move(raw.points.points);
            frame.line = std::move(raw.points.lines);
            return frame;
        }
        std::vector<std::size_t> order(raw.id.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(),
                  [&](std::size_t a, std::size_t b) { return raw.id[a] != raw.id[b] ? raw.id[a] < raw.id[b] : a < b; });
        for (const std::size_t i : order) {
            if (!frame.id.empty() && frame.id.back() == raw.id[i])
                fail(raw.points.lines[i],
                     "has the id " + std::to_string(raw.id[i]) + " of line " + std::to_string(frame.line.back()) +
                         ", in the same frame",
                     "ids that differ");
            frame.id.push_back(raw.id[i]);
            frame.position.push_back(raw.points.points[i]);
            frame.line.push_back(raw.points.lines[i]);
        }
        return frame;
    }

    /// The least difference between numbers of successive frames is their stride; more is a gap.
    void treat_absent_frames() {
        auto& frames = motion_.frames;
        if (absent_ == Absent_frames::skip) return;
        std::uint64_t stride = std::numeric_limits<std::uint64_t>::max();
        for (std::size_t i = 1; i < frames.size(); ++i)
            stride = std::min(stride, frames[i].number - frames[i - 1].number);
        std::vector<Frame> filled;
        for (std::size_t i = 0; i < frames.size(); ++i) {
            if (i > 0 && frames[i].number - frames[i - 1].number > stride) {
                const std::uint64_t missing = frames[i - 1].number + stride;
                if (absent_ == Absent_frames::refuse)
                    fail(first_line_[i],
                         "frame " + std::to_string(frames[i].number) + " after frame " +
                             std::to_string(frames[i - 1].number) + ", where others are " + std::to_string(stride) +
                             " apart",
                         "frame " + std::to_string(missing) + ", or --absent-frames empty or skip");
                filled.emplace_back();
                filled.back().number = missing;
            }
            filled.push_back(std::move(frames[i]));
        }
        frames = std::move(filled);
    }

    Recorded_motion& motion_;
    Absent_frames absent_;
    std::vector<std::uint64_t> first_line_;  ///< of each frame
    std::optional<bool> has_z_, ids_are_places_;
};

}  // namespace

Recorded_motion read_motion(const std::filesystem::path& file, Absent_frames absent) {
    const Source source = load_file(file);
    Recorded_motion motion;
    motion.name = source.name;
    Collector collector(motion, absent);
    const std::string extension = format_extension(file);
    if (extension == ".xyz") collector.read(Xyz_frames(source, Wanted::motion));
    else if (extension == ".csv") collector.read(Csv_frames(source, Wanted::motion));
    else
        throw Input_error(Error_code::bad_input, source.name, 0,
                          extension.empty() ? "has no extension" : "has the unknown extension " + shown(extension),
                          ".xyz or .csv");
    return motion;
}

}  // namespace annulus
