// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/frame_readers.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr std::string_view item = "ITEM: ";
constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
constexpr std::array<std::string_view, 3> image_names{"ix", "iy", "iz"};

/// A way to write positions: the suffix of x, y and z in the names of columns (plain, u unwrapped, s and su the same in
/// shares of the box), and whether images are added.
struct Position_kind {
    std::string_view suffix;
    bool images = false;
};
/// In the order of preference: positions as written; for a motion those that do not jump where an atom leaves the box.
constexpr std::array<Position_kind, 4> of_points{{{""}, {"u"}, {"s"}, {"su"}}};
constexpr std::array<Position_kind, 6> of_motions{{{"u"}, {"", true}, {"su"}, {"s", true}, {""}, {"s"}}};

/// Whether this is a side of the box: two of p, f, s and m, of which p is periodic.
bool is_boundary(std::string_view word) {
    return word.size() == 2 && word.find_first_not_of("pfsm") == std::string_view::npos;
}

}  // namespace

bool Lammps_frames::seek() { return reader_.next_record(); }

void Lammps_frames::refuse_more(const Raw_frame& frame) const {
    reader_.fail("a second frame after that of timestep " + std::to_string(frame.number), "one frame");
}

bool Lammps_frames::is_item(std::string_view name) const {
    std::string_view text = reader_.line();
    if (!text.starts_with(item)) return false;
    text.remove_prefix(item.size());
    return text.starts_with(name) && (text.size() == name.size() || text[name.size()] == ' ');
}

/// Advances to the line of values after an ITEM.
void Lammps_frames::require_values(std::size_t columns, std::string_view what) {
    if (!reader_.next_record()) reader_.fail("the file ends before " + std::string(what), std::string(what));
    if (reader_.fields().size() != columns)
        reader_.fail("has " + counted(reader_.fields().size(), "column"),
                     std::string(what) + ": " + std::to_string(columns));
}

/// `BOX BOUNDS`, with the words `xy xz yz` or `abc origin` where it is oblique: the edge vector of each direction.
Lammps_frames::Box Lammps_frames::read_box(Raw_frame& frame) {
    Box box;
    bool tilted = false, general = false;
    std::string sides;
    std::vector<bool> periodic;
    const std::uint64_t line = reader_.number();
    for (const std::string_view word : reader_.fields()) {
        tilted = tilted || word == "xy";
        general = general || word == "abc";
        if (!is_boundary(word)) continue;
        sides += " " + std::string(word);
        periodic.push_back(word.find('p') != std::string_view::npos);
    }
    // All sides are periodic by default in LAMMPS, and early versions did not write how they are.
    periodic.resize(3, sides.empty());
    const std::string what = "BOX BOUNDS" + (sides.empty() ? ", without a word on its sides" : sides);
    const bool is_periodic = std::find(periodic.begin(), periodic.end(), true) != periodic.end();
    if (is_periodic && !options_.box.taken) meet_box(what);
    read_bounds(box, tilted, general);
    if (is_periodic && options_.box.taken)
        frame.box = File_box{box.edge, {periodic[0], periodic[1], periodic[2]}, what, line};
    return box;
}

/// The three lines after `BOX BOUNDS`.
void Lammps_frames::read_bounds(Box& box, bool tilted, bool general) {
    std::array<std::array<double, 4>, 3> row{};
    const std::size_t columns = general ? 4 : tilted ? 3 : 2;
    for (auto& values : row) {
        require_values(columns, "bounds of the box");
        for (std::size_t i = 0; i < columns; ++i) values[i] = reader_.real(reader_.fields()[i], "a bound of the box");
    }
    if (general) {
        for (std::size_t i = 0; i < 3; ++i) {
            std::copy_n(row[i].begin(), 3, box.edge[i].begin());
            box.corner[i] = row[i][3];
        }
        return;
    }
    // The bounds of an oblique box are those of the upright box around it.
    const double xy = row[0][2], xz = row[1][2], yz = row[2][2];
    const std::array<double, 3> before{std::min({0., xy, xz, xy + xz}), std::min(0., yz), 0.};
    const std::array<double, 3> after{std::max({0., xy, xz, xy + xz}), std::max(0., yz), 0.};
    for (std::size_t i = 0; i < 3; ++i) {
        box.corner[i] = row[i][0] - before[i];
        box.edge[i][i] = row[i][1] - after[i] - box.corner[i];
    }
    box.edge[1][0] = xy;
    box.edge[2][0] = xz;
    box.edge[2][1] = yz;
}

/// The column of this name after ATOMS.
std::optional<std::size_t> Lammps_frames::find(std::string_view name) const {
    const auto& words = reader_.fields();
    const auto first = words.begin() + 2, at = std::find(first, words.end(), name);
    if (at == words.end()) return std::nullopt;
    if (std::find(at + 1, words.end(), name) != words.end())
        reader_.fail("names two columns " + std::string(name), "one");
    return static_cast<std::size_t>(at - first);
}

/// Parses the names after ATOMS: takes the first kind of position that is complete. One without z is taken where there
/// is no z.
Lammps_frames::Columns Lammps_frames::find_columns(bool has_box) const {
    Columns base;
    base.all = reader_.fields().size() - 2;
    if (wants_ids()) base.id = find("id");
    std::optional<Columns> flat;
    std::string z;  // of a kind that is incomplete
    const std::span<const Position_kind> kinds = wants_ids() ? std::span<const Position_kind>(of_motions) : of_points;
    for (const auto& [suffix, images] : kinds) {
        Columns found = base;
        found.suffix = suffix;
        found.scaled = suffix.starts_with('s');
        for (std::size_t i = 0; i < 3; ++i) found.at[i] = find(std::string(axes[i]) + std::string(suffix));
        const bool plane = found.at[0] && found.at[1];
        if (found.at[2] && !plane && z.empty()) z = std::string(axes[2]) + std::string(suffix);
        for (std::size_t i = 0; i < 3 && images; ++i)
            if (found.at[i]) found.image[i] = find(image_names[i]);
        found.images = images && has_box;
        for (std::size_t i = 0; i < 3; ++i)
            found.images = found.images && found.at[i].has_value() == found.image[i].has_value();
        if (!plane || (flat && !found.at[2]) || found.images != images) continue;
        if (found.at[2]) return found;
        flat = found;
    }
    if (flat && !z.empty())
        reader_.fail("ITEM: ATOMS names x" + std::string(flat->suffix) + " and y" + std::string(flat->suffix) +
                         ", and of z only " + z,
                     "all three in one way: x y z, xu yu zu, xs ys zs or xsu ysu zsu");
    if (flat) return *flat;
    reader_.fail("ITEM: ATOMS names no columns of positions", "x y [z], xu yu [zu], xs ys [zs] or xsu ysu [zsu]");
}

/// Columns of the header that would unwrap positions, and are not used.
std::string Lammps_frames::not_used(const Columns& taken) const {
    std::string result;
    if (taken.images || taken.suffix.ends_with('u')) return result;
    const auto& words = reader_.fields();
    for (auto word = words.begin() + 2; word != words.end(); ++word)
        for (const std::string_view name : {"xu", "yu", "zu", "xsu", "ysu", "zsu", "ix", "iy", "iz"})
            if (*word == name) result += (result.empty() ? "" : " ") + std::string(name);
    return result;
}

void Lammps_frames::take(const Columns& at) {
    const std::string kind = "x" + std::string(at.suffix) + (at.images ? " with ix" : "") + " ..";
    if (kind_.value_or(kind) != kind)
        reader_.fail("positions are " + kind + " here, and " + *kind_ + " in frames before", "the same in every frame");
    if (std::exchange(kind_, kind)) return;
    const std::string unused = not_used(at);
    if (!unused.empty()) note(reader_.number(), "not used: " + unused + "; positions are as written, not unwrapped");
    Taken_columns taken;
    if (wants_ids() && at.id) taken.emplace_back("id", column_words(*at.id, "id"));
    else if (wants_ids()) taken.emplace_back("id", place_as_id);
    for (std::size_t i = 0; i < 3; ++i) {
        if (!at.at[i]) continue;
        std::string words = column_words(*at.at[i], std::string(axes[i]) + std::string(at.suffix));
        if (at.images)
            words += " and column " + std::to_string(*at.image[i] + 1) + " (" + std::string(image_names[i]) + ")";
        taken.emplace_back(axes[i], std::move(words));
    }
    take_columns(std::move(taken));
}

/// The position of the atom whose record the reader is at: unwrapped by its images, and multiplied by the box.
Coordinates<3> Lammps_frames::position(const Columns& at, const Box& box) const {
    const auto& fields = reader_.fields();
    Coordinates<3> p{}, image{};
    for (std::size_t i = 0; i < 3; ++i) {
        if (at.at[i]) p[i] = reader_.real(fields[*at.at[i]], axes[i]);
        if (!at.images || !at.image[i]) continue;
        image[i] = reader_.real(fields[*at.image[i]], image_names[i]);
        if (image[i] != std::floor(image[i]))
            reader_.fail(std::string(image_names[i]) + " is not an integer: " + shown(fields[*at.image[i]]),
                         "an integer");
    }
    if (!at.scaled && !at.images) return p;
    Coordinates<3> q = at.scaled ? box.corner : p;
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 3; ++i) q[i] += (at.scaled ? p[k] + image[k] : image[k]) * box.edge[k][i];
    for (std::size_t i = 0; i < 3; ++i)
        if (!std::isfinite(q[i]))
            reader_.fail(std::string(axes[i]) + " is too large for a double once multiplied by the box",
                         "a finite number", Error_code::not_finite);
    if (!at.at[2]) q[2] = 0;
    return q;
}

void Lammps_frames::read_atoms(Raw_frame& frame, std::uint64_t count, const std::optional<Box>& box) {
    if (count == 0) return;
    const Columns at = find_columns(box.has_value());
    take(at);
    if (at.scaled && !box) reader_.fail("positions in shares of a box that is not there", "ITEM: BOX BOUNDS before");
    frame.points.has_z = at.at[2].has_value();
    frame.ids_are_places = !at.id;
    for (std::uint64_t n = 0; n < count; ++n) {
        reader_.require_record(n, count, "atoms");
        const auto& fields = reader_.fields();
        if (fields.size() != at.all)
            reader_.fail("has " + counted(fields.size(), "column"), std::to_string(at.all) + " as ITEM: ATOMS says");
        frame.points.points.push_back(position(at, box.value_or(Box{})));
        frame.points.lines.push_back(reader_.number());
        if (wants_ids()) frame.id.push_back(at.id ? reader_.whole(fields[*at.id], "the id") : n);
    }
}

void Lammps_frames::read(Raw_frame& frame) {
    std::optional<std::uint64_t> timestep, count;
    std::optional<Box> box;
    while (!is_item("ATOMS")) {
        if (is_item("TIMESTEP")) {
            if (timestep) reader_.fail("a second TIMESTEP before ITEM: ATOMS", "the rest of the frame");
            require_values(1, "the timestep");
            timestep = reader_.whole(reader_.fields()[0], "the timestep");
        } else if (is_item("NUMBER OF ATOMS")) {
            require_values(1, "the number of atoms");
            count = reader_.whole(reader_.fields()[0], "the number of atoms");
            make_room(frame, *count, 4);
        } else if (is_item("BOX BOUNDS")) {
            box = read_box(frame);
        } else if (is_item("UNITS") || is_item("TIME")) {
            if (!reader_.next_line()) reader_.fail("the file ends before its value", "a line");
        } else {
            reader_.fail("is " + shown(reader_.line()), "ITEM: TIMESTEP, NUMBER OF ATOMS, BOX BOUNDS or ATOMS");
        }
        if (!reader_.next_record()) reader_.fail("the file ends within a frame", "ITEM: ATOMS and the atoms");
    }
    if (!timestep) reader_.fail("a frame without ITEM: TIMESTEP", "it before the atoms");
    if (!count) reader_.fail("a frame without ITEM: NUMBER OF ATOMS", "it before the atoms");
    frame.number = *timestep;
    read_atoms(frame, *count, box);
}

}  // namespace annulus::inline v1
