// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/trial.h>

#include <apps/experiment/smoothing.h>
#include <apps/experiment/study.h>
#include <apps/formats/distinct.h>
#include <apps/formats/frame_points.h>
#include <apps/formats/given_box.h>
#include <apps/formats/input_error.h>
#include <apps/formats/motion_reader.h>
#include <apps/formats/read_points.h>
#include <apps/motion/boxed_points.h>
#include <apps/report/memory.h>

#include <algorithm>
#include <chrono>
#include <utility>
#include <variant>

namespace annulus::inline v1 {

namespace {

using Json = nlohmann::ordered_json;
const std::string opened = "open = true in its [[grid]]";

/// The lines of one trial.
class Lines {
  public:
    Lines(const Trial& trial, std::size_t hardest, int threads) : trial_(trial), threads_(threads), result_(hardest) {}

    /// One experiment: `where` is {"step": ..} or {"frame": ..}. `merged`: points that are not in x because others have
    /// the same position. In a periodic box the points are rounded, the box is not.
    template <int d>
    void look(const Json& where, std::vector<Coordinates<d>> x, std::size_t merged = 0,
              const std::optional<Box<d>>& box = {}) {
        const std::size_t points = x.size() + merged;
        round_to<d>(trial_.rounding, x);
        const Study found = box ? study_in_box<d>(std::move(x), *box, trial_.seed, result_.hard, threads_)
                                : study<d>(keep_distinct<d>(std::move(x)), trial_.seed, result_.hard, threads_);
        Json line{{"grid", trial_.grid + 1}, {"name", trial_.grid_name}};
        if (trial_.file.empty()) line["kind"] = trial_.kind;
        else line["file"] = trial_.file;
        line.update(input_);
        line["dimension"] = d;
        if (box) line["box"] = box->vectors();
        line["points"] = points;
        line["rounding"] = trial_.rounding.name;
        if (trial_.motion) {
            line["motion"] = trial_.motion->name;
            if (trial_.motion->kind == Trial_motion::Kind::generated) line["pace"] = trial_.motion->pace;
        }
        line.update(where);
        if (trial_.file.empty()) line["seed"] = trial_.seed;
        line["vertices"] = found.vertices;
        line["merged"] = points - found.vertices;
        line["affine_dimension"] = found.affine_dimension;
        line["mean_spacing"] = found.spacing;
        line["resolution"] = found.resolution;
        line.update(tally_json(found.tally));
        result_.lines.push_back(line.dump());
    }
    /// How the file was read.
    void input(const Taken_columns& columns, bool ignored_box) {
        Json& taken = input_["columns"] = Json::object();
        for (const auto& [what, where] : columns) taken[what] = where;
        if (ignored_box) input_["ignored"] = {"box"};
    }
    Trial_result take() { return std::move(result_); }

  private:
    template <int d>
    static std::vector<Coordinates<d>> keep_distinct(std::vector<Coordinates<d>> x) {
        for (auto& p : x)
            for (double& c : p) c += 0.0;  // no -0
        const auto first = first_at_place<d>(x);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < x.size(); ++i)
            if (first[i] == i) x[kept++] = x[i];
        x.resize(kept);
        return x;
    }

    const Trial& trial_;
    int threads_;
    Json input_ = Json::object();
    Trial_result result_;
};

/// Examines a motion after each of the steps that the trial names.
template <int d, class Motion>
void examine_steps(const Trial& t, Motion& motion, Lines& lines) {
    std::uint64_t step = 0;
    for (const std::uint64_t wanted : t.steps) {
        for (; step < wanted; ++step) motion.step();
        std::optional<Box<d>> box;
        if constexpr (requires { motion.box(); }) box = motion.box();
        lines.look<d>({{"step", wanted}}, {motion.points().begin(), motion.points().end()}, 0, box);
    }
}

template <int d>
void run_in_box(const Trial& t, Lines& lines) {
    const auto n = static_cast<std::size_t>(t.points);
    const Box<d> box = box_of<d>(t.box, "'box'");
    std::vector<Coordinates<d>> x = t.crystal
                                        ? crystal_in<d>(box, *t.crystal, unit_cells<d>(box, *t.crystal, n).value())
                                        : generate_in<d>(box, t.family, n, t.seed);
    if (!t.motion) return lines.look<d>({{"step", 0}}, std::move(x), 0, box);
    Generated_motion<d> motion(box, std::move(x), t.motion->family, t.motion->pace, t.seed);
    examine_steps<d>(t, motion, lines);
}

template <int d>
void run_generated(const Trial& t, Lines& lines, int threads) {
    if (!t.box.empty()) return run_in_box<d>(t, lines);
    const auto n = static_cast<std::size_t>(t.points);
    if (!t.motion) return lines.look<d>({{"step", 0}}, generate<d>(t.family, n, t.seed));
    if constexpr (d == 2) {
        if (t.motion->kind == Trial_motion::Kind::lloyd) {
            Lloyd_motion motion(generate<2>(t.family, n, t.seed), threads);
            return examine_steps<2>(t, motion, lines);
        }
    } else if (t.motion->kind == Trial_motion::Kind::nodt) {
        Nodt_motion motion(n, t.seed, threads);
        return examine_steps<3>(t, motion, lines);
    }
    Generated_motion<d> motion(generate<d>(t.family, n, t.seed), t.motion->family, t.motion->pace, t.seed);
    examine_steps<d>(t, motion, lines);
}

/// The box of the trial, else that of the file, if it is periodic in all directions.
template <int d>
std::optional<Box<d>> box_of_file(const Trial& t, const std::optional<File_box>& of_file, const std::string& name) {
    if (!t.box.empty()) return box_of<d>(t.box, "'box'");
    if (!of_file || !is_periodic(*of_file, d, name, opened)) return {};
    return box_of<d>(*of_file, name, opened);
}

template <int d>
void run_frames(const Trial& t, Motion_reader& reader, Frame& frame, Lines& lines) {
    std::uint64_t at = 0;
    std::size_t found = 0;
    do {
        const bool named = std::find(t.frames.begin(), t.frames.end(), frame.number) != t.frames.end();
        found += named ? 1 : 0;
        if (named || (t.every > 0 && at % t.every == 0)) {
            lines.input(reader.columns(), reader.ignored_box());
            Frame_points<d> points = points_of<d>(reader.name(), frame, Coincident::merge);
            lines.look<d>({{"frame", frame.number}}, std::move(points.x), points.merged,
                          box_of_file<d>(t, frame.box, reader.name()));
        }
        ++at;
    } while ((t.every > 0 || found < t.frames.size()) && reader.next(frame));
    if (found < t.frames.size())
        throw Input_error(Error_code::bad_input, reader.name(), 0, "does not have all of the frames that are requested",
                          "frames that the file has (in .xyz they are counted from 0)");
}

void run_file(const Trial& t, Lines& lines) {
    const Periodic_box box{
        .taken = !t.open && t.box.empty(), .replaced = !t.box.empty(), .ignored = t.open, .how = opened.c_str()};
    if (!t.frames.empty() || t.every > 0) {
        Motion_reader reader(t.path, {Absent_frames::skip, "", box});
        Frame frame;
        if (!reader.next(frame)) return;
        const int dimension = t.dimension > 0 ? t.dimension : reader.has_z() ? 3 : 2;
        return dimension == 2 ? run_frames<2>(t, reader, frame, lines) : run_frames<3>(t, reader, frame, lines);
    }
    const Read_options options{.ignore_z = t.dimension == 2, .box = box};
    const auto look = [&]<int d>(const Point_file<d>& file) {
        const std::optional<Box<d>> of_points = box_of_file<d>(t, file.box, file.name);
        std::vector<Coordinates<d>> x = distinct_points(file, of_points ? 1 : 2).x;
        const std::size_t merged = file.points.size() - x.size();
        lines.input(file.columns, file.ignored_box);
        lines.look<d>(Json::object(), std::move(x), merged, of_points);
    };
    if (t.dimension == 2) look(read_points<2>(t.path, options));
    else if (t.dimension == 3) look(read_points<3>(t.path, options));
    else std::visit(look, read_points_of_any_dimension(t.path, options));
}

}  // namespace

Trial_result run(const Trial& t, std::size_t hardest, int threads) {
    const auto begin = std::chrono::steady_clock::now();
    Lines lines(t, hardest, threads);
    if (!t.file.empty()) run_file(t, lines);
    else if (t.dimension == 2) run_generated<2>(t, lines, threads);
    else run_generated<3>(t, lines, threads);
    Trial_result result = lines.take();
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    result.peak_bytes = peak_resident_memory();
    return result;
}

// Measured for ten million uniform points in 2D and a million in 3D, one thread, with a small margin.
void estimate(Trial& t, std::uint64_t points, int dimension) {
    const double look = dimension == 2 ? 7e-6 : 40e-6, step = dimension == 2 ? 1e-6 : 8e-6;
    const std::uint64_t each = dimension == 2 ? 700 : 2600;
    const double generated = t.motion && t.motion->kind == Trial_motion::Kind::generated ? 0.1 : 1;
    const double looks =
        static_cast<double>(std::max<std::size_t>(1, t.file.empty() ? t.steps.size() : t.frames.size()));
    const double steps = t.file.empty() ? static_cast<double>(t.steps.back()) : 0;
    t.seconds = static_cast<double>(points) * (look * looks + step * generated * steps);
    t.bytes = points * each + (std::uint64_t{1} << 20);
}

}  // namespace annulus::inline v1
