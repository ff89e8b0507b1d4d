// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/frame_files.h>

#include <apps/cli/frame_clip.h>
#include <apps/cli/solid_mesh.h>
#include <apps/formats/decimal.h>
#include <apps/formats/write_csv.h>
#include <apps/formats/write_vtu.h>
#include <apps/report/quantile.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace annulus::inline v1::cli {

namespace {

template <int d>
constexpr const char* volume_name = d == 2 ? "area" : "volume";

template <int d>
constexpr const char* facet_name = d == 2 ? "length" : "area";

/// The columns that name a pair: in a periodic box with the shift of the second point, in vectors of the box.
template <class Moving>
std::string pair_head() {
    std::string head = "frame,first,second,";
    if (!Open_mesh<Moving>) head += Moving::dimension_of_space == 2 ? "s1,s2," : "s1,s2,s3,";
    return head;
}

/// frame-000012.vtu
std::string file_of(std::size_t step) {
    const std::string digits = std::to_string(step);
    return "frame-" + std::string(digits.size() < 6 ? 6 - digits.size() : 0, '0') + digits + ".vtu";
}

/// Statistics of the bounded cells, in a clip of those that reach into it; neighbours are counted of those that it does
/// not cut.
Frame_record::Voronoi summary_of(const Cell_measures& cells, const std::vector<std::size_t>& vertices) {
    Frame_record::Voronoi out;
    std::vector<double> bounded;
    double sum = 0, hexagons = 0;
    for (const std::size_t i : vertices) {
        if (!std::isfinite(cells.volume[i])) {
            ++out.unbounded;
            continue;
        }
        const bool clipped = !cells.whole.empty();
        if (clipped && cells.volume[i] == 0) continue;
        bounded.push_back(cells.volume[i]);
        if (clipped && !cells.whole[i]) continue;
        ++out.whole;
        sum += cells.neighbours[i];
        hexagons += cells.neighbours[i] == 6 ? 1 : 0;
    }
    out.bounded = bounded.size();
    if (bounded.empty()) return out;
    out.volume_low = quantile(bounded, 0.05);
    out.volume_median = quantile(bounded, 0.5);
    out.volume_high = quantile(bounded, 0.95);
    if (out.whole == 0) return out;
    const auto whole = static_cast<double>(out.whole);
    out.neighbours_mean = sum / whole;
    out.hexagons = hexagons / whole;
    return out;
}

}  // namespace

template <class Moving>
Frame_files<Moving>::Frame_files(const Common_arguments& common, const Frame_arguments& frames,
                                 Run_tracker<Moving>& tracker)
    : frames_(frames), dt_(tracker.triangulation()) {
    for (std::size_t i = 0; i < dt_.index_bound(); ++i) name(static_cast<Index>(i), i);
    if (!frames.any()) return;
    if constexpr (Open_mesh<Moving>)
        if (!frames.clip.empty()) {
            const Clip_record clip = parse_clip<d>(frames.clip);
            clip_ = clip_of<d>(clip);
            tracker.clip(clip);
        }
    scratch_ = std::make_unique<Result_files>(common);
    const auto begin = [&](const char* file, const std::string& header) {
        auto out = std::make_unique<Text_output>(scratch_->path_of(file));
        out->write(header + "\n");
        return out;
    };
    if (frames.voronoi)
        voronoi_ = begin("voronoi.csv", std::string("frame,id,") + volume_name<d> + ",neighbours,unbounded");
    if (frames.neighbors) pairs_ = begin("pairs.csv", pair_head<Moving>() + facet_name<d>);
    if (frames.changes) changes_ = begin("changes.csv", pair_head<Moving>() + "change");
    tracker.listen([this](const Move_result& report, Index arrived) { hear(report, arrived); });
}

template <class Moving>
bool Frame_files<Moving>::is_present(std::size_t i) const {
    return dt_.is_vertex(static_cast<Index>(i));
}

template <class Moving>
void Frame_files<Moving>::name(Index v, std::uint64_t id) {
    const auto at = static_cast<std::size_t>(v);
    if (at >= id_.size()) id_.resize(at + 1);
    id_[at] = id;
    if (frames_.changes) events_.name(v, id);
}

template <class Moving>
void Frame_files<Moving>::append_id(std::string& text, std::uint64_t id) const {
    if (ids_ == nullptr) append_decimal(text, id);
    else append_csv_text(text, ids_->text(id));
}

template <class Moving>
void Frame_files<Moving>::hear(const Move_result& report, Index arrived) {
    if (arrived != none && !arriving_.empty()) {
        name(arrived, arriving_.front());
        arriving_.pop_front();
    }
    if (frames_.changes) events_.note(report);
}

template <class Moving>
void Frame_files<Moving>::append_pair(std::string& text, std::uint64_t number, std::uint64_t first,
                                      std::uint64_t second, const Shift<d>& shift) const {
    append_decimal(text, number);
    text += ',';
    append_id(text, first);
    text += ',';
    append_id(text, second);
    text += ',';
    if (Open_mesh<Moving>) return;
    for (const auto s : shift) text += std::to_string(s) + ',';
}

template <class Moving>
void Frame_files<Moving>::measure() {
    if constexpr (Open_mesh<Moving>)
        if (clip_) {
            measures_ = clipped_measures(dt_, *clip_);
            return;
        }
    if (frames_.voronoi) measures_.cells = cell_measures(dt_);
    if (frames_.neighbors || (frames_.changes && !Open_mesh<Moving>)) measures_.pairs = facet_pairs(dt_);
}

template <class Moving>
void Frame_files<Moving>::write_voronoi(std::uint64_t number, Frame_record& record) {
    const Cell_measures& cells = measures_.cells;
    std::vector<std::size_t> vertices;
    for (std::size_t i = 0; i < dt_.index_bound(); ++i)
        if (is_present(i)) vertices.push_back(i);
    std::sort(vertices.begin(), vertices.end(), [this](std::size_t a, std::size_t b) { return id_[a] < id_[b]; });
    const std::string frame = std::to_string(number) + ",";
    std::string text;
    for (const std::size_t i : vertices) {
        text += frame;
        append_id(text, id_[i]);
        text += ',';
        if (std::isfinite(cells.volume[i])) append_decimal(text, cells.volume[i]);
        text += ',';
        append_decimal(text, cells.neighbours[i]);
        text += std::isfinite(cells.volume[i]) ? ",0\n" : ",1\n";
    }
    voronoi_->write(text);
    record.voronoi = summary_of(cells, vertices);
}

template <class Moving>
void Frame_files<Moving>::write_pairs(std::uint64_t number) {
    struct Row {
        std::uint64_t first, second;
        const Facet_pair<d>* pair;
    };
    std::vector<Row> rows;
    for (const Facet_pair<d>& p : measures_.pairs) {
        const std::uint64_t i = id_[static_cast<std::size_t>(p.first)], j = id_[static_cast<std::size_t>(p.second)];
        rows.push_back({std::min(i, j), std::max(i, j), &p});  // only an open mesh has indices in another order
    }
    std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
        return std::tie(a.first, a.second, a.pair->shift) < std::tie(b.first, b.second, b.pair->shift);
    });
    std::string text;
    for (const Row& row : rows) {
        append_pair(text, number, row.first, row.second, row.pair->shift);
        if (std::isfinite(row.pair->measure)) append_decimal(text, row.pair->measure);
        text += '\n';
    }
    pairs_->write(text);
}

template <class Moving>
void Frame_files<Moving>::write_changes(std::uint64_t number, Frame_record& record) {
    Frame_record::Neighbour_pairs count;
    const auto changes = events_.take(dt_, measures_.pairs);
    std::string text;
    const bool is_first = records_.empty();  // there is no frame before it
    for (const Pair_change<d>& c : changes) {
        if (is_first) break;
        ++(c.made ? count.made : count.broken);
        append_pair(text, number, c.first, c.second, c.shift);
        text += c.made ? "made\n" : "broken\n";
    }
    changes_->write(text);
    if (!is_first) record.pairs = count;
}

template <class Moving>
void Frame_files<Moving>::write_vtu(std::uint64_t number) {
    const Solid_mesh<d> mesh = solid_mesh(dt_);
    std::vector<std::uint64_t> ids;
    std::vector<std::int64_t> neighbours;
    std::vector<double> volume;
    for (const Index v : mesh.vertex) {
        const auto i = static_cast<std::size_t>(v);
        ids.push_back(id_[i]);
        if (!frames_.voronoi) continue;
        volume.push_back(measures_.cells.volume[i]);
        neighbours.push_back(measures_.cells.neighbours[i]);
    }
    std::vector<Vtu_field> fields;
    if (ids_ != nullptr && ids_->have_signs())
        fields.push_back({"id", std::vector<std::int64_t>(ids.begin(), ids.end())});
    else fields.push_back({"id", std::move(ids)});
    if (frames_.voronoi) {
        fields.push_back({std::string("voronoi_") + volume_name<d>, std::move(volume)});
        fields.push_back({"neighbours", std::move(neighbours)});
    }
    series_.push_back({file_of(records_.size()), number});
    scratch_->write(series_.back().file, annulus::write_vtu<d>(mesh.points, mesh.cells, fields));
}

template <class Moving>
void Frame_files<Moving>::frame(std::uint64_t number) {
    Frame_record record{number, dt_.number_of_vertices()};
    const bool pictured = frames_.every > 0 && records_.size() % frames_.every == 0;
    measure();
    if (frames_.voronoi) write_voronoi(number, record);
    if (frames_.neighbors) write_pairs(number);
    if (frames_.changes) write_changes(number, record);
    if (pictured) write_vtu(number);
    records_.push_back(record);
}

template <class Moving>
void Frame_files<Moving>::write(Result_files& out) {
    if (!scratch_) return;
    if (voronoi_) voronoi_->commit();
    if (pairs_) pairs_->commit();
    if (changes_) changes_->commit();
    if (frames_.every > 0) scratch_->write("frames.pvd", write_pvd(series_));
    if (frames_.every > 0 && ids_ != nullptr && ids_->are_words()) {
        std::string text = "number,id\n";
        for (std::size_t i = 0; i < ids_->words().size(); ++i) {
            text += std::to_string(i) + ",";
            append_csv_text(text, ids_->words()[i]);
            text += '\n';
        }
        scratch_->write("ids.csv", text);
    }
    out.take(*scratch_);
}

template class Frame_files<Moving_mesh_2>;
template class Frame_files<Moving_mesh_3>;
template class Frame_files<Boxed_mesh<2>>;
template class Frame_files<Boxed_mesh<3>>;

}  // namespace annulus::inline v1::cli
