// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/motion_reader.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

namespace annulus::inline v1 {

Motion_reader::Motion_reader(const std::filesystem::path& file, const Motion_options& options)
    : bytes_(std::make_unique<File_bytes>(file)), absent_(options.absent) {
    const Format format = format_of(file, frame_formats, options.format);
    if (format != Format::csv) absent_ = Absent_frames::skip;  // these formats have frames without points
    frames_ = frames_of(
        *bytes_, format,
        {.box = options.box, .columns = options.columns, .any_distance = options.absent == Absent_frames::skip});
}

void Motion_reader::fail(std::uint64_t line, std::string fault, std::string expected) const {
    throw Input_error(Error_code::bad_input, name(), line, std::move(fault), std::move(expected));
}

void Motion_reader::require_same_kind() {
    const std::uint64_t line = raw_.points.lines.front();
    if (has_z_.value_or(raw_.points.has_z) != raw_.points.has_z)
        fail(line, "a frame has " + std::string(raw_.points.has_z ? "a z" : "no z"), "the same columns in every frame");
    if (ids_are_places_.value_or(raw_.ids_are_places) != raw_.ids_are_places)
        fail(line, "a frame has " + std::string(raw_.ids_are_places ? "no id" : "an id"),
             "an id in every frame, or in none");
    has_z_ = raw_.points.has_z;
    ids_are_places_ = raw_.ids_are_places;
}

/// Sorts the frame just read by id; equal ids are refused. The frames exchange their memory, so that in the long run
/// none is allocated.
void Motion_reader::sort_by_id(Frame& frame) {
    frame.number = raw_.number;
    frame.time = raw_.time;
    frame.box = raw_.box;
    if (std::adjacent_find(raw_.id.begin(), raw_.id.end(), std::greater_equal<>()) == raw_.id.end()) {
        frame.id.swap(raw_.id);
        frame.position.swap(raw_.points.points);
        frame.line.swap(raw_.points.lines);
        return;
    }
    std::vector<std::size_t> order(raw_.id.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
        return raw_.id[a] != raw_.id[b] ? raw_.id[a] < raw_.id[b] : a < b;
    });
    frame.id.clear();
    frame.position.clear();
    frame.line.clear();
    for (const std::size_t i : order) {
        if (!frame.id.empty() && frame.id.back() == raw_.id[i])
            fail(raw_.points.lines[i],
                 "has the id " + ids().text(raw_.id[i]) + " of line " + std::to_string(frame.line.back()) +
                     ", in the same frame",
                 "ids that differ");
        frame.id.push_back(raw_.id[i]);
        frame.position.push_back(raw_.points.points[i]);
        frame.line.push_back(raw_.points.lines[i]);
    }
}

/// Whether there is a gap before the frame just read; then `frame`, which has no points, fills it.
bool Motion_reader::fills_gap(Frame& frame) {
    if (absent_ == Absent_frames::skip || !last_) return false;
    const std::uint64_t distance = raw_.number - *last_;
    if (!stride_) stride_ = absent_ == Absent_frames::empty ? frames_->least_distance().value_or(distance) : distance;
    if (distance == *stride_) return false;
    if (absent_ == Absent_frames::refuse || distance < *stride_)
        fail(raw_.line,
             "frame " + std::to_string(raw_.number) + " after frame " + std::to_string(*last_) + ", where others are " +
                 std::to_string(*stride_) + " apart",
             absent_ == Absent_frames::refuse
                 ? "frame " + std::to_string(*last_ + *stride_) + ", or --absent-frames empty or skip"
                 : "the first two frames of standard input to be no further apart, or --absent-frames skip");
    frame.number = *last_ + *stride_;
    frame.time = no_time;
    frame.box.reset();
    frame.id.clear();
    frame.position.clear();
    frame.line.clear();
    return true;
}

bool Motion_reader::at_end() { return !raw_waits_ && frames_->at_end(); }

bool Motion_reader::next(Frame& frame) {
    if (!raw_waits_) {
        if (!frames_->next(raw_)) {
            if (!any_) fail(1, "has no frames", "at least one");
            if (!has_z_) fail(1, "has no points in any frame", "at least one");
            frames_->conclude();
            return false;
        }
        any_ = true;
        if (!raw_.points.points.empty()) require_same_kind();
        if (fills_gap(frame)) return raw_waits_ = true;
    }
    raw_waits_ = false;
    last_ = raw_.number;
    sort_by_id(frame);
    frames_->take_ids(frame.id);
    return true;
}

std::optional<double> Motion_reader::share_read() const {
    const auto size = bytes_->size();
    if (!size || *size == 0) return std::nullopt;
    return std::min(1., static_cast<double>(bytes_->taken()) / static_cast<double>(*size));
}

bool is_flat(const std::filesystem::path& file, const Motion_options& options) {
    File_bytes bytes(file);
    const auto frames = frames_of(bytes, format_of(file, frame_formats, options.format),
                                  {.box = {.ignored = true}, .columns = options.columns, .in_order = false});
    std::optional<double> z;
    Raw_frame raw;
    while (frames->next(raw)) {
        if (!raw.points.points.empty() && !raw.points.has_z) return true;
        for (const auto& p : raw.points.points)
            if (std::exchange(z, p[2]).value_or(p[2]) != p[2]) return false;
    }
    return true;
}

}  // namespace annulus::inline v1
