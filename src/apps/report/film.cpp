// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/markup.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/film.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace annulus::inline v1 {

/// Drops what is outside the window, except the ends of edges that enter it.
void Film::clip(Picture& picture) {
    if (!window_ && picture.points.size() > most_vertices)
        window_ = window_of(picture.points, most_vertices, most_vertices / 2);
    if (!window_) return;
    const auto inside = [&](Index i) {
        const auto& p = picture.points[static_cast<std::size_t>(i)];
        return std::fabs(p[0] - window_->centre[0]) <= window_->half_side &&
               std::fabs(p[1] - window_->centre[1]) <= window_->half_side;
    };
    Picture rest{{}, {}, std::move(picture.caption)};
    rest.dots = picture.dots;
    rest.outline = std::move(picture.outline);
    std::vector<Index> number(picture.points.size(), none);
    const auto take = [&](Index i) {
        Index& n = number[static_cast<std::size_t>(i)];
        if (n == none) {
            n = static_cast<Index>(rest.points.size());
            rest.points.push_back(picture.points[static_cast<std::size_t>(i)]);
        }
        return n;
    };
    for (Index i = 0; static_cast<std::size_t>(i) < picture.points.size(); ++i)
        if (inside(i)) (void)take(i);
    for (const auto& [a, b] : picture.edges)
        if (inside(a) || inside(b)) rest.edges.push_back({take(a), take(b)});
    picture = std::move(rest);
}

void Film::add(std::uint64_t number, Picture picture, bool last) {
    frames_ = std::max(frames_, number + 1);
    if (!last && !includes(number)) return;
    if (!pictures_.empty() && pictures_.back().number == number) return;
    const std::size_t points = picture.points.size();
    clip(picture);
    pictures_.push_back({number, std::move(picture), points});
    if (last || pictures_.size() < most_pictures) return;
    stride_ *= 2;
    std::erase_if(pictures_, [this](const Shot& shot) { return !includes(shot.number); });
}

std::string Film::html() const {
    if (pictures_.empty()) return {};
    std::vector<Coordinates<2>> all;
    bool parts = false;
    for (const Shot& shot : pictures_) {
        all.insert(all.end(), shot.picture.points.begin(), shot.picture.points.end());
        for (const auto& ring : shot.picture.outline) all.insert(all.end(), ring.begin(), ring.end());
        parts = parts || shot.points > shot.picture.points.size();
    }
    Window window = window_ ? *window_ : window_of(all, all.size(), all.size());
    window.whole = !parts;
    std::string out = "<div class=\"film\">\n";
    for (const Shot& shot : pictures_)
        out += "<figure>" + svg_triangulation(shot.picture, window) + "<figcaption>" + escaped(shot.picture.caption) +
               ", " + counted_dots(shot.points, shot.picture.dots) + "</figcaption></figure>\n";
    out += "<p hidden><label>Frame <input type=\"range\" min=\"0\" max=\"" + std::to_string(pictures_.size() - 1) +
           "\" value=\"0\" step=\"1\"/></label></p>\n</div>\n<figcaption>";
    out += pictures_.size() == frames_
               ? (frames_ == 1 ? "The one frame is shown" : "All " + grouped(frames_) + " frames are shown")
               : grouped(pictures_.size()) + " of " + grouped(frames_) + " frames are shown: one in " +
                     grouped(stride_) + ", and the last";
    if (parts)
        out += "; of each a window in the middle, chosen when there were more than " +
               counted_dots(most_vertices, pictures_.front().picture.dots);
    out += ".</figcaption>\n";
    // Without scripts there is nothing to slide.
    return out + R"js(<script>
for (const film of document.querySelectorAll(".film")) {
  const shots = film.querySelectorAll("figure"), slider = film.querySelector("input");
  const show = () => shots.forEach((shot, i) => { shot.hidden = i !== Number(slider.value); });
  slider.addEventListener("input", show);
  film.querySelector("p").hidden = false;
  show();
}
</script>
)js";
}

}  // namespace annulus::inline v1
