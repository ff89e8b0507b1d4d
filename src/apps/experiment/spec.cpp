// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/spec.h>

#include <apps/experiment/spec_boxes.h>
#include <apps/experiment/spec_reader.h>
#include <apps/formats/decimal.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>

namespace annulus::inline v1 {

namespace {

constexpr std::uint64_t json_seeds = std::uint64_t{1} << 53;
constexpr std::uint64_t no_limit = std::numeric_limits<std::int64_t>::max();

std::uint32_t crc(std::uint32_t so_far, const char* bytes, std::size_t size) {
    return static_cast<std::uint32_t>(::crc32_z(so_far, reinterpret_cast<const unsigned char*>(bytes), size));
}

void enter(std::uint32_t& identity, std::string_view text) { identity = crc(identity, text.data(), text.size()); }

/// Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014.
std::uint64_t mixed(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

template <class Families>
std::string names_of(const Families& families) {
    std::string all;
    for (const auto& family : families) all += (all.empty() ? "" : ", ") + std::string(family.first);
    return all;
}

/// One [[grid]].
class Grid_reader {
  public:
    Grid_reader(const std::string& name, const toml::table& table, std::size_t number,
                const std::filesystem::path& directory, Spec& spec)
        : t_(name, table), number_(number), directory_(directory), spec_(spec) {}

    void read() {
        t_.allow({"name", "points", "dimension", "box", "kind", "rounding", "motion", "seeds", "file", "frames",
                  "every", "open"},
                 "[[grid]]");
        common_.grid = number_;
        common_.grid_name = t_.text("name", "grid " + std::to_string(number_ + 1));
        for (const std::string& word : t_.texts("rounding", {"double"})) {
            const std::optional<Rounding> rounding = rounding_named(word);
            if (!rounding)
                t_.fail("rounding", "'rounding' is " + shown(word),
                        "double, float, decimal:DIGITS (0 to " + std::to_string(Rounding::most_digits) +
                            ") or grid:SPACING");
            roundings_.push_back(*rounding);
        }
        if (t_.has("box")) forbid({"dimension", "open"}, "and 'box' exclude each other");
        if (t_.has("file")) read_file();
        else read_generated();
    }

  private:
    void forbid(std::initializer_list<std::string_view> keys, const std::string& why) const {
        for (const std::string_view key : keys)
            if (t_.has(key)) t_.fail(key, "'" + std::string(key) + "' " + why, "one of the two");
    }

    void read_generated() {
        forbid({"frames", "every", "open"}, "needs a 'file'");
        t_.require("points", "how many, a list or one; or a 'file'");
        const auto points = t_.wholes("points", {}, 1, Spec::most_points);
        std::vector<Spec_space> spaces = boxes_of(t_);
        if (spaces.empty())
            for (const std::uint64_t dimension : t_.wholes("dimension", {2}, 2, 3))
                spaces.push_back({static_cast<int>(dimension)});
        const std::vector<Kind> kinds = read_kinds(spaces, points);
        const std::vector<Trial_motion> motions = read_motions(kinds, spaces, points);
        const auto [repetitions, literal] = read_seeds();
        for (const Kind& kind : kinds)
            for (const Spec_space& space : spaces)
                for (const std::uint64_t n : points)
                    for (std::size_t m = 0; m < std::max<std::size_t>(1, motions.size()); ++m)
                        for (const Rounding& rounding : roundings_)
                            for (const std::uint64_t r : repetitions) {
                                Trial t = common_;
                                t.dimension = space.dimension;
                                t.box = space.box;
                                t.kind = kind.word;
                                t.family = kind.family;
                                t.crystal = kind.crystal;
                                t.points = n;
                                if (!motions.empty()) t.motion = motions[m];
                                t.rounding = rounding;
                                t.steps = steps_;
                                t.seed = literal ? r : seed_of(spec_.seed, t, r);
                                estimate(t, n, t.dimension);
                                add(std::move(t));
                            }
    }

    /// Of generated points.
    struct Kind {
        std::string word;
        Point_family family = Point_family::uniform;
        std::optional<Crystal> crystal{};
    };
    std::vector<Kind> read_kinds(const std::vector<Spec_space>& spaces,
                                 const std::vector<std::uint64_t>& points) const {
        std::vector<Kind> kinds;
        for (const std::string& word : t_.texts("kind", {"uniform"})) {
            const auto family = family_named(point_families, word);
            const auto crystal = family_named(crystals, word);
            if (!family && !crystal)
                t_.fail("kind", "'kind' is " + shown(word),
                        "one of " + names_of(point_families) + ", in a 'box' also " + names_of(crystals));
            if (crystal) require_crystal_fits(t_, {word, *crystal}, spaces, points);
            kinds.push_back({word, family.value_or(Point_family::uniform), crystal});
        }
        return kinds;
    }

    std::pair<std::vector<std::uint64_t>, bool> read_seeds() const {
        const toml::node* const node = t_.find("seeds");
        if (node != nullptr && node->is_array()) return {t_.wholes("seeds", {}, 0, json_seeds - 1), true};
        std::vector<std::uint64_t> repetitions(t_.whole("seeds", 1, 1, Spec::most_trials));
        for (std::size_t i = 0; i < repetitions.size(); ++i) repetitions[i] = i;
        return {repetitions, false};
    }

    std::vector<Trial_motion> read_motions(const std::vector<Kind>& kinds, const std::vector<Spec_space>& spaces,
                                           const std::vector<std::uint64_t>& points) {
        const toml::node* const node = t_.find("motion");
        if (node == nullptr) return {};
        if (!node->is_table())
            t_.fail(node, "'motion' is " + shown_value(*node),
                    "a table: { kind = \"walk\", pace = 0.01, steps = [0, 10] }");
        const std::string& file = t_.name();
        const Spec_table m(file, *node->as_table());
        m.allow({"kind", "pace", "steps"}, "motion");
        m.require("kind", "one of " + names_of(motion_families) + ", lloyd, nodt");
        m.require("steps", "after how many steps to look, a list or one");
        steps_ = m.wholes("steps", {}, 0, Spec::most_steps);
        std::sort(steps_.begin(), steps_.end());
        std::vector<double> paces = m.numbers("pace", 0, Spec::most_pace);
        std::vector<Trial_motion> motions;
        bool any_generated = false;
        for (const std::string& word : m.texts("kind", {})) {
            if (word == "lloyd" || word == "nodt") {
                const bool lloyd = word == "lloyd";
                if (t_.has("box"))
                    m.fail("kind", word + " moves points with open boundaries",
                           "one of " + names_of(motion_families) + ", or no 'box'");
                for (const Spec_space& space : spaces)
                    if (space.dimension != (lloyd ? 2 : 3))
                        m.fail("kind", word + " moves points in " + (lloyd ? "2D" : "3D"),
                               lloyd ? "dimension = 2" : "dimension = 3");
                for (const Kind& kind : kinds)
                    if (!lloyd && kind.word != "uniform")
                        m.fail("kind", "nodt begins with uniform points of the ball", "kind = \"uniform\"");
                if (const std::uint64_t least = lloyd ? 3 : 4; *std::min_element(points.begin(), points.end()) < least)
                    t_.fail("points", "'points' has fewer than " + word + " moves", std::to_string(least) + " or more");
                motions.push_back({word, lloyd ? Trial_motion::Kind::lloyd : Trial_motion::Kind::nodt, {}, 0});
                continue;
            }
            const auto family = family_named(motion_families, word);
            if (!family)
                m.fail("kind", "'kind' is " + shown(word), "one of " + names_of(motion_families) + ", lloyd, nodt");
            any_generated = true;
            if (paces.empty()) paces = {0.01};
            for (const double pace : paces) motions.push_back({word, Trial_motion::Kind::generated, *family, pace});
        }
        if (!any_generated && m.has("pace"))
            m.fail("pace", "'pace' is of no motion here", "it with " + names_of(motion_families));
        return motions;
    }

    void read_file() {
        forbid({"points", "kind", "motion", "seeds"}, "is of generated points, not of a 'file'");
        if (t_.has("frames")) forbid({"every"}, "and 'frames' exclude each other");
        std::vector<Spec_space> spaces = boxes_of(t_);
        if (spaces.empty()) spaces.push_back({static_cast<int>(t_.whole("dimension", 0, 2, 3))});
        const auto frames = t_.wholes("frames", {}, 0, no_limit);
        const auto every = t_.whole("every", 0, 1, no_limit);
        for (const std::string& file : t_.texts("file", {})) {
            const std::filesystem::path path = directory_ / file;
            const std::uint64_t size = note(path);
            for (const Spec_space& space : spaces)
                for (const Rounding& rounding : roundings_) {
                    Trial t = common_;
                    t.dimension = space.dimension;
                    t.box = space.box;
                    t.rounding = rounding;
                    t.file = file;
                    t.path = path.string();
                    t.frames = frames;
                    t.every = every;
                    t.open = t_.flag("open");
                    estimate(t, size / 40, 3);  // about forty bytes per point; it has not been read yet
                    add(std::move(t));
                }
        }
    }

    /// Adds the bytes of a file to the identity of the sweep.
    std::uint64_t note(const std::filesystem::path& path) {
        std::error_code ignored;
        // The file is read twice, and reading a pipe again would block for ever.
        const bool regular = std::filesystem::is_regular_file(path, ignored);
        std::ifstream in;
        if (regular) in.open(path, std::ios::binary);
        std::array<char, 1 << 16> block{};
        std::uint64_t size = 0;
        if (!regular || !in) t_.fail("file", "'file' is " + shown(path.string()), "a file that can be read");
        while (in.read(block.data(), block.size()) || in.gcount() > 0) {
            spec_.identity = crc(spec_.identity, block.data(), static_cast<std::size_t>(in.gcount()));
            size += static_cast<std::uint64_t>(in.gcount());
        }
        enter(spec_.identity, std::to_string(size));  // two files are not one
        return size;
    }

    void add(Trial t) {
        if (spec_.trials.size() == Spec::most_trials)
            t_.fail(nullptr, "more than " + std::to_string(Spec::most_trials) + " experiments", "fewer");
        spec_.trials.push_back(std::move(t));
    }

    Spec_table t_;
    std::size_t number_;
    const std::filesystem::path& directory_;
    Spec& spec_;
    Trial common_{};
    std::vector<Rounding> roundings_{};
    std::vector<std::uint64_t> steps_{0};
};

/// The TOML parser recurses into every part of a key, and its stack is limited.
void require_shallow_keys(const std::string& name, std::string_view text) {
    constexpr std::size_t most = 1000;
    std::size_t line = 1, dots = 0;
    for (const char c : text) {
        line += c == '\n' ? 1 : 0;
        if (c == '.') ++dots;
        else if (c == '\n' || c == ',') dots = 0;
        if (dots > most)
            throw Input_error(Error_code::bad_input, name, line,
                              "more than " + std::to_string(most) + " dots in one key", "a key");
    }
}

toml::table parsed(const std::string& name, std::string_view text) {
    require_shallow_keys(name, text);
    try {
        return toml::parse(text, name);
    } catch (const toml::parse_error& e) {
        throw Input_error(Error_code::bad_input, name, e.source().begin.line,
                          "no TOML: " + std::string(e.description()), "TOML 1.0");
    }
}

}  // namespace

std::uint64_t seed_of(std::uint64_t spec_seed, const Trial& t, std::uint64_t repetition) {
    std::string place = t.kind + "," + std::to_string(t.dimension) + "," + std::to_string(t.points);
    if (t.motion) place += "," + t.motion->name + "," + decimal(t.motion->pace);
    for (const double x : t.box) place += " box " + decimal(x);
    std::uint64_t z = mixed(spec_seed);
    for (const char c : place) z = mixed(z ^ static_cast<unsigned char>(c));
    return mixed(z ^ repetition) % json_seeds;
}

Spec read_spec(const std::string& name, std::string_view text, const std::filesystem::path& directory) {
    const toml::table root = parsed(name, text);
    const Spec_table t(name, root);
    t.allow({"title", "seed", "hardest", "grid"}, "the file");
    Spec spec;
    spec.title = t.text("title", name.substr(name.find_last_of('/') + 1));
    spec.seed = t.whole("seed", 1, 0, no_limit);
    spec.hardest = static_cast<std::size_t>(t.whole("hardest", 0, 0, Spec::most_hardest));
    enter(spec.identity, text);
    enter(spec.identity, spec.title);  // which may be the name of the file
    t.require("grid", "a [[grid]] or more");
    const toml::array* const grids = t.find("grid")->as_array();
    if (grids == nullptr || grids->empty() || !grids->is_homogeneous(toml::node_type::table))
        t.fail("grid", "'grid' is " + shown_value(*t.find("grid")), "tables: [[grid]]");
    for (std::size_t i = 0; i < grids->size(); ++i)
        Grid_reader(name, *(*grids)[i].as_table(), i, directory, spec).read();
    return spec;
}

}  // namespace annulus::inline v1
