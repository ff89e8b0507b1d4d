// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/frame_change.h>
#include <apps/cli/motion_survey.h>
#include <apps/formats/distinct.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace annulus::inline v1::cli {

namespace {

/// Fewer points do not say how long a box is.
constexpr std::size_t points_that_fill_a_box = 8;

void note(Id_events& events, std::uint64_t frame, std::string id, std::string what) {
    ++events.count;
    if (events.first.size() < Id_events::most_named) events.first.push_back({frame, std::move(id), std::move(what)});
}

}  // namespace

void Length_counts::add(double length) {
    ++total_;
    at_rest_ += length == 0;
    below_ += length < histogram_.edges().front();
    histogram_.add(length);
    sum_ += length;
    max_ = std::max(max_, length);
}

void Length_counts::add(const Length_counts& other) {
    counts_.resize(histogram_.counts().size());
    for (std::size_t i = 0; i < counts_.size(); ++i)
        counts_[i] += other.histogram_.counts()[i] + (other.counts_.empty() ? 0 : other.counts_[i]);
    total_ += other.total_;
    at_rest_ += other.at_rest_;
    below_ += other.below_;
    sum_ += other.sum_;
    max_ = std::max(max_, other.max_);
}

Displacement_record Length_counts::record() const {
    Displacement_record r{.total = total_, .at_rest = at_rest_};
    if (total_ == 0) return r;
    r.mean = sum_ / static_cast<double>(total_);
    const auto edges = histogram_.edges();
    std::uint64_t seen = below_;
    std::size_t bin = 0;
    for (std::size_t k = 0; k < r.quantiles.size(); ++k) {
        const double rank = r.probabilities[k] * static_cast<double>(total_);
        while (static_cast<double>(seen) < rank && bin < histogram_.counts().size()) {
            seen += histogram_.counts()[bin] + (counts_.empty() ? 0 : counts_[bin]);
            ++bin;
        }
        if (bin == histogram_.counts().size()) r.quantiles[k] = max_;  // that and above
        else r.quantiles[k] = bin == 0 ? 0.0 : std::min(std::sqrt(edges[bin - 1] * edges[bin]), max_);
    }
    r.quantiles.back() = max_;
    return r;
}

template <int d>
void Motion_survey<d>::add(const Frame& as_read, const Frame_points<d>& frame, const Point_ids& ids) {
    if (record_.frames > 0) {
        const std::uint64_t distance = frame.number - last_.number;
        record_.least_distance = std::min(record_.least_distance, distance);
        record_.most_distance = std::max(record_.most_distance, distance);
    }
    if (record_.spacing == 0 && !frame.x.empty()) start(frame);
    for (const Coordinates<d>& p : frame.x)
        for (std::size_t k = 0; k < d; ++k) {
            record_.low[k] = std::min(record_.low[k], p[k]);
            record_.high[k] = std::max(record_.high[k], p[k]);
        }
    record_.least_vertices = std::min<std::uint64_t>(record_.least_vertices, frame.x.size());
    record_.most_vertices = std::max<std::uint64_t>(record_.most_vertices, frame.x.size());
    if (frame.merged > 0) count_duplicates(as_read, ids);
    if (record_.frames > 0) count_changes(frame, ids);
    ++record_.frames;
    last_ = frame;
}

template <int d>
void Motion_survey<d>::start(const Frame_points<d>& frame) {
    record_.spacing = spacing_of<d>(frame.x);
    for (std::size_t k = 0; k < d; ++k) record_.low[k] = record_.high[k] = frame.x.front()[k];
    for (const Coordinates<d>& p : frame.x)
        for (std::size_t k = 0; k < d; ++k) {
            record_.low[k] = std::min(record_.low[k], p[k]);
            record_.high[k] = std::max(record_.high[k], p[k]);
        }
    if (frame.x.size() < points_that_fill_a_box) return;
    for (std::size_t k = 0; k < d; ++k) side_[k] = record_.high[k] - record_.low[k];
}

template <int d>
void Motion_survey<d>::count_duplicates(const Frame& as_read, const Point_ids& ids) {
    std::vector<Coordinates<d>> x(as_read.position.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t k = 0; k < d; ++k) x[i][k] = as_read.position[i][k] + 0.0;  // -0 equals 0
    const std::vector<std::size_t> first = first_at_place<d>(x);
    for (std::size_t i = 0; i < first.size(); ++i)
        if (first[i] != i)
            note(record_.duplicates, as_read.number, ids.text(as_read.id[i]), ids.text(as_read.id[first[i]]));
    ++record_.duplicates.frames;
}

template <int d>
std::size_t Motion_survey<d>::axis_of_jump(const Coordinates<d>& from, const Coordinates<d>& to) {
    std::size_t axis = d;
    for (std::size_t k = 0; k < d; ++k) {
        const double way = std::abs(to[k] - from[k]);
        if (!(side_[k] > 0) || way < side_[k] / 4) continue;
        if (way < 0.75 * side_[k]) ++half_jumps_;
        else if (axis == d) axis = k;
    }
    return axis;
}

template <int d>
void Motion_survey<d>::count_changes(const Frame_points<d>& frame, const Point_ids& ids) {
    const std::uint64_t traffic = record_.traffic.count, jumps = record_.jumps.count;
    const auto disappears = [&](std::size_t i) {
        note(record_.traffic, frame.number, ids.text(last_.id[i]), "disappears");
        ++record_.disappeared;
    };
    std::size_t p = 0;
    for (std::size_t f = 0; f < frame.id.size(); ++f) {
        while (p < last_.id.size() && last_.id[p] < frame.id[f]) disappears(p++);
        if (p == last_.id.size() || last_.id[p] != frame.id[f]) {
            note(record_.traffic, frame.number, ids.text(frame.id[f]), "appears");
            ++record_.appeared;
            continue;
        }
        double way = 0;
        for (std::size_t k = 0; k < d; ++k) way = std::hypot(way, frame.x[f][k] - last_.x[p][k]);
        const std::size_t axis = axis_of_jump(last_.x[p++], frame.x[f]);
        (axis == d ? steady_ : jumping_).add(way / record_.spacing);
        if (axis != d) note(record_.jumps, frame.number, ids.text(frame.id[f]), std::string(1, "xyz"[axis]));
    }
    while (p < last_.id.size()) disappears(p++);
    record_.traffic.frames += record_.traffic.count > traffic;
    record_.jumps.frames += record_.jumps.count > jumps;
}

template <int d>
Motion_record Motion_survey<d>::record() const {
    Motion_record r = record_;
    r.wrapped = r.jumps.count > half_jumps_;  // of frames that have nothing to do with each other, few are so far apart
    Length_counts all = steady_;
    if (!r.wrapped) all.add(jumping_);
    r.displacement = all.record();
    return r;
}

template class Motion_survey<2>;
template class Motion_survey<3>;

}  // namespace annulus::inline v1::cli
