// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/arithmetic/domain.h>
#include <apps/formats/distinct.h>
#include <apps/formats/frame_points.h>
#include <apps/formats/input_error.h>

#include <utility>
#include <vector>

namespace annulus::inline v1 {

template <int d>
Frame_points<d> points_of(const std::string& name, const Frame& frame, Coincident coincident, const Point_ids& ids) {
    const auto fail = [&](Error_code code, std::size_t i, std::string what, std::string expected) {
        throw Input_error(code, name, frame.line[i], std::move(what), std::move(expected));
    };
    Frame_points<d> result{.number = frame.number};
    result.x.reserve(frame.position.size());
    for (std::size_t i = 0; i < frame.position.size(); ++i) {
        Coordinates<d> p;
        for (std::size_t k = 0; k < p.size(); ++k) p[k] = frame.position[i][k] + 0.0;  // -0 equals 0
        if (!in_domain(p))
            fail(Error_code::out_of_domain, i, "coordinate out of domain", "magnitudes of at most 2^500");
        result.x.push_back(p);
    }
    const std::vector<std::size_t> first = first_at_place<d>(result.x);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (first[i] != i) {
            if (coincident == Coincident::refuse)
                fail(Error_code::duplicate_point, i,
                     "in frame " + std::to_string(frame.number) + " the point of id " + ids.text(frame.id[i]) +
                         " is where that of id " + ids.text(frame.id[first[i]]) + " is (line " +
                         std::to_string(frame.line[first[i]]) + ")",
                     "points that differ, or --coincident merge");
            ++result.merged;
            continue;
        }
        result.id.push_back(frame.id[i]);
        result.x[kept++] = result.x[i];
    }
    result.x.resize(kept);
    return result;
}

template <int d>
void merge_images(Frame_points<d>& points, const Box<d>& box) {
    const std::vector<std::size_t> first = first_at_place<d>(points.x, box);
    keep_first(first, points.id);
    keep_first(first, points.x);
    points.merged += first.size() - points.x.size();
}

template void merge_images(Frame_points<2>&, const Box<2>&);
template void merge_images(Frame_points<3>&, const Box<3>&);
template Frame_points<2> points_of<2>(const std::string&, const Frame&, Coincident, const Point_ids&);
template Frame_points<3> points_of<3>(const std::string&, const Frame&, Coincident, const Point_ids&);

}  // namespace annulus::inline v1
