// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/sampling_2.h>

#include <annulus/error.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <random>
#include <unordered_set>
#include <utility>

namespace annulus::inline v1 {

namespace {

class Bits {
  public:
    explicit Bits(std::uint64_t seed) : bits_(seed) {}
    /// In [0, 1), a multiple of 2^-53.
    double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

  private:
    std::mt19937_64 bits_;
};

/// Uniform points of a domain.
class Uniform {
  public:
    explicit Uniform(const Region_2& domain) : domain_(domain) {
        const auto corners = domain.hull().corners();
        if (domain.convex())
            for (std::size_t i = 1; i + 1 < corners.size(); ++i) add(corners[0], corners[i], corners[i + 1]);
        else
            for (const Triangle_2& t : domain.triangles().all()) add(t.corner[0], t.corner[1], t.corner[2]);
    }

    /// A point that is in the domain up to rounding; for a disc it may be outside.
    Coordinates<2> point(Bits& bits) const {
        double s = bits.unit(), t = bits.unit();
        if (domain_.hull().kind() == Domain_2::Kind::disc)
            return {(2 * s - 1) * domain_.hull().radius(), (2 * t - 1) * domain_.hull().radius()};
        const auto found = std::upper_bound(area_up_to_.begin(), area_up_to_.end(), bits.unit() * area_up_to_.back());
        const auto at = std::min(static_cast<std::size_t>(found - area_up_to_.begin()), area_up_to_.size() - 1);
        if (s + t > 1) s = 1 - s, t = 1 - t;  // fold the parallelogram onto the triangle
        const auto& [p, a, b] = triangle_[at];
        return {p[0] + s * a[0] + t * b[0], p[1] + s * a[1] + t * b[1]};
    }

  private:
    void add(const Coordinates<2>& p, const Coordinates<2>& q, const Coordinates<2>& r) {
        const Coordinates<2> a{q[0] - p[0], q[1] - p[1]}, b{r[0] - p[0], r[1] - p[1]};
        triangle_.push_back({p, a, b});
        area_up_to_.push_back((area_up_to_.empty() ? 0 : area_up_to_.back()) + (a[0] * b[1] - a[1] * b[0]));
    }

    const Region_2& domain_;
    std::vector<std::array<Coordinates<2>, 3>> triangle_;  ///< a corner, and two sides from there
    std::vector<double> area_up_to_;
};

struct Hash {
    std::size_t operator()(const Coordinates<2>& p) const {
        const std::uint64_t a = std::bit_cast<std::uint64_t>(p[0]), b = std::bit_cast<std::uint64_t>(p[1]);
        return static_cast<std::size_t>((a ^ std::rotl(b, 29)) * 0x9E3779B97F4A7C15u);
    }
};

/// Neighbours along Hilbert's curve are near each other in 2D.
void sort_along_curve(std::vector<Coordinates<2>>& points) {
    using Kernel = CGAL::Simple_cartesian<double>;
    using Place = std::pair<Kernel::Point_2, std::size_t>;
    std::vector<Place> order;
    order.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) order.emplace_back(Kernel::Point_2(points[i][0], points[i][1]), i);
    const CGAL::Spatial_sort_traits_adapter_2<Kernel, CGAL::First_of_pair_property_map<Place>> traits;
    CGAL::hilbert_sort(order.begin(), order.end(), traits, CGAL::Hilbert_sort_median_policy());
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = {order[i].first.x(), order[i].first.y()};
}

/// Points of an image in proportion to its density. The density is the sum over pixels of weight times a tent that is
/// two pixels wide; the part of a tent outside the image is mirrored to the inside, into the half pixel where the
/// density is constant.
class Of_image {
  public:
    explicit Of_image(const Image_density& image) : image_(image) {
        up_to_.reserve(image.width() * image.height());
        std::uint64_t sum = 0;
        for (std::size_t row = 1; row <= image.height(); ++row)
            for (std::size_t column = 1; column <= image.width(); ++column)
                up_to_.push_back(sum += static_cast<std::uint64_t>(image.node(column, row).weight));
    }

    Coordinates<2> point(Bits& bits) const {
        const auto at = static_cast<std::uint64_t>(bits.unit() * static_cast<double>(image_.total()));
        const auto pixel =
            static_cast<std::size_t>(std::upper_bound(up_to_.begin(), up_to_.end(), at) - up_to_.begin());
        const double x = place(pixel % image_.width(), image_.width(), bits);
        return {x, place(pixel / image_.width(), image_.height(), bits)};
    }

  private:
    static double place(std::size_t pixel, std::size_t size, Bits& bits) {
        const double a = bits.unit(), b = bits.unit(), x = std::abs(static_cast<double>(pixel) + (a + b - 0.5));
        const auto end = static_cast<double>(size);
        return x > end ? 2 * end - x : x;
    }

    const Image_density& image_;
    std::vector<std::uint64_t> up_to_;  ///< weights of the pixels so far, row by row from below
};

}  // namespace

std::vector<Coordinates<2>> sample(const Region_2& domain, const Density_2& density, std::size_t n,
                                   std::uint64_t seed) {
    require_density(density, domain.hull());
    const double bound = density_upper_bound(density, domain.hull().extent());
    const Uniform uniform(domain);
    std::optional<Of_image> of_image;
    if (const Image_density* image = image_of(density)) of_image.emplace(*image);
    const auto* placed = std::get_if<Placed_image>(&density);
    Bits bits(seed);
    std::vector<Coordinates<2>> points;
    points.reserve(n);
    std::unordered_set<Coordinates<2>, Hash> seen(2 * n);
    int failures = 0;
    while (points.size() < n) {
        Coordinates<2> p = of_image ? of_image->point(bits) : uniform.point(bits);
        if (placed != nullptr) p = placed->from_image(p);
        p = {p[0] + 0.0, p[1] + 0.0};  // -0 equals 0 but hashes apart
        const bool kept = (of_image || bits.unit() * bound < density_at(density, p)) && domain.contains(p);
        if (kept && seen.insert(p).second) {
            points.push_back(p);
            failures = 0;
        } else if (++failures == 1'000'000) {
            throw Error(Error_code::bad_input, "the domain has not that many different points");
        }
    }
    sort_along_curve(points);
    return points;
}

}  // namespace annulus::inline v1
