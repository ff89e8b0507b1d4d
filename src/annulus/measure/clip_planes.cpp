// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/clip_planes.h>

#include <annulus/error.h>

#include <algorithm>
#include <string>

namespace annulus::inline v1 {

template <int d>
std::vector<Clip_plane<d>> clip_planes(std::span<const Half_space<d>> half_spaces) {
    std::vector<Clip_plane<d>> out;
    for (std::size_t h = 0; h < half_spaces.size(); ++h) {
        const auto& [normal, offset] = half_spaces[h];
        bool finite = std::isfinite(offset);
        double largest = 0;
        for (const double c : normal) {
            finite = finite && std::isfinite(c);
            largest = std::max(largest, std::fabs(c));
        }
        if (!finite)
            throw Error(Error_code::not_finite, "half-space " + std::to_string(h) + " of the clip is not finite");
        if (largest == 0)
            throw Error(Error_code::bad_input, "half-space " + std::to_string(h) + " of the clip has no normal");
        const int exponent = std::ilogb(largest);
        auto& plane = out.emplace_back();
        for (std::size_t k = 0; k < d; ++k) plane.normal[k] = std::ldexp(normal[k], -exponent);
        plane.offset = std::ldexp(static_cast<long double>(offset), -exponent);
    }
    return out;
}

template std::vector<Clip_plane<2>> clip_planes<2>(std::span<const Half_space<2>>);
template std::vector<Clip_plane<3>> clip_planes<3>(std::span<const Half_space<3>>);

}  // namespace annulus::inline v1
