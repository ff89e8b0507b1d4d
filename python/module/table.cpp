// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/arrays.h>
#include <module/finalizing.h>
#include <module/parts.h>
#include <module/process_mutex.h>

#include <apps/formats/frame_points.h>
#include <apps/formats/motion_start.h>

#include <pybind11/stl.h>

#include <mutex>
#include <optional>
#include <utility>

namespace annulus::python {

namespace {

/// Text of a file, which need not be UTF-8.
py::str text_of(std::string_view text) {
    auto words = py::reinterpret_steal<py::object>(
        PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "backslashreplace"));
    if (!words) throw py::error_already_set();
    return py::str(words);
}

void replace(std::string& text, std::string_view old, std::string_view fresh) {
    for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + fresh.size()))
        text.replace(at, old.size(), fresh);
}

/// The error of a reader, whose words are those of the tool, with the arguments of `analyze` in place of its options.
Error in_words_of_python(const Error& e) {
    std::string text = e.what();
    replace(text, ", or --coincident merge", "");
    replace(text, "--absent-frames empty or skip", "absent_frames='empty' or 'skip'");
    replace(text, "--absent-frames skip", "absent_frames='skip'");
    replace(text, "--columns", "columns");
    return Error(e.code(), text, {e.vertices().begin(), e.vertices().end()});
}

template <class Call>
auto read(Call call) {
    try {
        const Without_gil without_gil;
        return call();
    } catch (const Error& e) {
        throw in_words_of_python(e);
    }
}

py::list list_of(const std::vector<std::string>& lines) {
    py::list out;
    for (const std::string& line : lines) out.append(text_of(line));
    return out;
}

/// The frames of a table of trajectories, one after the other. A thread that reads holds the lock, and not the GIL.
class Table {
    template <class Call>
    auto locked(Call call) const {
        const Without_gil without_gil;
        const std::lock_guard hold(lock_);
        return call();
    }

  public:
    Table(const std::string& file, Column_choice columns, Absent_frames absent)
        : Table(file, Motion_options{.absent = absent, .format = "csv", .columns = std::move(columns)}) {}

    /// The next frame: its number, its time, the ids of its points, ascending, and their positions; None at the end.
    py::object next() { return start_.dimension == 2 ? next_in<2>() : next_in<3>(); }

    [[nodiscard]] py::dict taken() const {
        py::dict out;
        const Taken_columns columns = locked([&] { return reader_.columns(); });
        for (const auto& [what, where] : columns)
            if (what != "z" || start_.dimension == 3) out[py::str(what)] = text_of(where);
        if (!start_.why.empty()) out["dimension"] = text_of("2: " + start_.why);
        return out;
    }
    /// The notes that were not returned before.
    py::list notes() {
        return list_of(locked([&] {
            const auto& all = reader_.notes();
            const std::size_t from = std::exchange(noted_, all.size());
            return std::vector(all.begin() + static_cast<std::ptrdiff_t>(from), all.end());
        }));
    }
    /// The words that ids number; None where they are integers.
    [[nodiscard]] py::object words() const {
        const auto words = locked([&] {
            const Point_ids& ids = reader_.ids();
            return ids.are_words() ? std::optional(ids.words()) : std::nullopt;
        });
        if (!words) return py::none();
        return list_of(*words);
    }
    [[nodiscard]] bool signs() const {
        return locked([&] { return reader_.ids().have_signs(); });
    }

  private:
    Table(const std::string& file, const Motion_options& options)
        : reader_(read([&] { return Motion_reader(file, options); })),
          start_(read([&] { return start_motion(reader_, file, options, 0); })) {}

    template <int d>
    py::object next_in() {
        double time = no_time;
        std::optional<Frame_points<d>> points = read([&] {
            const std::lock_guard hold(lock_);
            return read_next<d>(time);
        });
        if (!points) return py::none();
        return py::make_tuple(points->number, time, give(std::move(points->id)), give_rows(std::move(points->x)));
    }
    template <int d>
    std::optional<Frame_points<d>> read_next(double& time) {
        if (ended_) return std::nullopt;
        if (empty_ < start_.empty.size()) return Frame_points<d>{.number = start_.empty[empty_++]};
        if (std::exchange(first_waits_, false)) frame_ = std::move(start_.first);
        else if (!reader_.next(frame_)) {
            ended_ = true;
            return std::nullopt;
        }
        time = frame_.time;
        return points_of<d>(reader_.name(), frame_, Coincident::refuse, reader_.ids());
    }

    mutable Process_mutex lock_;
    Motion_reader reader_;
    Motion_start start_;  ///< what is changed of it is the first frame
    Frame frame_;
    std::size_t empty_ = 0;  ///< how many of the frames without points at the start were returned
    std::size_t noted_ = 0;
    bool first_waits_ = true;
    bool ended_ = false;
};

Absent_frames absent_frames_of(const std::string& name) {
    if (name == "refuse") return Absent_frames::refuse;
    return name == "empty" ? Absent_frames::empty : Absent_frames::skip;
}

}  // namespace

void add_table(py::module_& m) {
    py::class_<Table>(m, "Table", not_by_new())
        .def_static("open",
                    [](const std::string& file, const std::array<std::string, 5>& columns, const std::string& absent) {
                        return std::make_unique<Table>(file, columns, absent_frames_of(absent));
                    })
        .def("next", &Table::next)
        .def("taken", &Table::taken)
        .def("notes", &Table::notes)
        .def("words", &Table::words)
        .def("signs", &Table::signs);
}

}  // namespace annulus::python
