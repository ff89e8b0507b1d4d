// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/csv_frames.h>
#include <apps/formats/frame_readers.h>
#include <apps/formats/npy_frames.h>

#include <utility>

namespace annulus::inline v1 {

void Raw_frame::clear() {
    points.points.clear();
    points.lines.clear();
    points.has_z = false;
    id.clear();
    number = line = 0;
    time = no_time;
    ids_are_places = false;
    box.reset();
}

bool Frame_reader::at_end() {
    if (!found_) found_ = seek();
    return !*found_;
}

bool Frame_reader::next(Raw_frame& frame) {
    frame.clear();
    if (at_end()) return false;
    found_.reset();
    reader_.begin_piece();
    frame.line = reader_.number();
    read(frame);
    return true;
}

void Frame_reader::require_last(const Raw_frame& frame) {
    if (!at_end()) refuse_more(frame);
}

void Frame_reader::make_room(Raw_frame& frame, std::uint64_t count, std::uint64_t bytes_a_point) const {
    const std::size_t room = reader_.room_for(count, bytes_a_point, "points");
    frame.points.points.reserve(room);
    frame.points.lines.reserve(room);
    if (wants_ids()) frame.id.reserve(room);
}

void Frame_reader::note(std::uint64_t line, const std::string& text) {
    notes_.push_back(reader_.name() + ":" + std::to_string(line) + ": " + text);
}

void Frame_reader::add_to_coordinates(const std::string& words) {
    for (auto& [what, where] : columns_)
        if (what == "x" || what == "y" || what == "z") where += words;
}

void Frame_reader::conclude() {
    if (!shared_ids_.none()) return;
    std::string column = "ids";
    for (const auto& [what, where] : columns_)
        if (what == "id") column = where;
    note(1, "no id is in two frames in a row: " + column + " may not number tracks");
    shared_ids_ = {};
}

void Frame_reader::meet_box(const std::string& what) {
    if (options_.box.replaced) return;
    if (!options_.box.ignored)
        reader_.fail(what + ": a periodic box, and these are not supported here",
                     std::string(options_.box.how) + ", by which points are taken as they stand, with open boundaries");
    if (std::exchange(ignored_box_, true)) return;
    note(reader_.number(), what + " ignored: points are taken as they stand, with open boundaries");
}

std::unique_ptr<Frame_reader> frames_of(File_bytes& bytes, Format format, const Frame_options& options) {
    require_table(format, options.columns);
    switch (format) {
        case Format::csv: return std::make_unique<Csv_frames>(bytes, options);
        case Format::lammps: return std::make_unique<Lammps_frames>(bytes, options);
        case Format::npy: return std::make_unique<Npy_frames>(bytes, options);
        default: return std::make_unique<Xyz_frames>(bytes, options);
    }
}

Raw_points read_only_frame(File_bytes& bytes, Format format, Frame_options options) {
    options.wanted = Frame_contents::points;
    const std::unique_ptr<Frame_reader> frames = frames_of(bytes, format, options);
    Raw_frame frame;
    if (frames->next(frame)) frames->require_last(frame);
    frame.points.columns = frames->columns();
    frame.points.notes = frames->notes();
    frame.points.ignored_box = frames->ignored_box();
    frame.points.box = std::move(frame.box);
    return std::move(frame.points);
}

}  // namespace annulus::inline v1
