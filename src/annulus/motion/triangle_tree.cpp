// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/motion/triangle_tree.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace annulus {

namespace {

constexpr std::size_t leaf = 4;

Coordinates<3> minus(const Coordinates<3>& a, const Coordinates<3>& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Coordinates<3>& a, const Coordinates<3>& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double square(const Coordinates<3>& a) { return dot(a, a); }

/// a + s (b - a) with s forced into [0, 1]; a where s is no number.
Coordinates<3> between(const Coordinates<3>& a, const Coordinates<3>& ab, double s) {
    if (!(s > 0)) return a;
    s = std::min(s, 1.0);
    return {a[0] + s * ab[0], a[1] + s * ab[1], a[2] + s * ab[2]};
}

template <class Node>
double square_distance(const Node& box, const Coordinates<3>& p) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double out = std::max({box.lower[k] - p[k], p[k] - box.upper[k], 0.0});
        sum += out * out;
    }
    return sum;
}

}  // namespace

/// By the regions of the triangle's plane (Ericson, Real-Time Collision Detection, 5.1.5).
Coordinates<3> nearest_in_triangle(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c,
                                   const Coordinates<3>& p) {
    const Coordinates<3> ab = minus(b, a), ac = minus(c, a), bc = minus(c, b), ap = minus(p, a), bp = minus(p, b), cp = minus(p, c);
    const double ab_a = dot(ab, ap), ac_a = dot(ac, ap);
    if (ab_a <= 0 && ac_a <= 0) return a;
    const double ab_b = dot(ab, bp), ac_b = dot(ac, bp);
    if (ab_b >= 0 && ac_b <= ab_b) return b;
    const double ab_c = dot(ab, cp), ac_c = dot(ac, cp);
    if (ac_c >= 0 && ab_c <= ac_c) return c;
    const double of_c = ab_a * ac_b - ab_b * ac_a;
    if (of_c <= 0 && ab_a >= 0 && ab_b <= 0) return between(a, ab, ab_a / (ab_a - ab_b));
    const double of_b = ab_c * ac_a - ab_a * ac_c;
    if (of_b <= 0 && ac_a >= 0 && ac_c <= 0) return between(a, ac, ac_a / (ac_a - ac_c));
    const double of_a = ab_b * ac_c - ab_c * ac_b, to_c = ac_b - ab_b, to_b = ab_c - ac_c;
    if (of_a <= 0 && to_c >= 0 && to_b >= 0) return between(b, bc, to_c / (to_c + to_b));
    const double all = of_a + of_b + of_c, v = of_b / all, w = of_c / all;
    // Where the triangle is so thin that its weights are noise, its longest side is all there is.
    if (v >= 0 && w >= 0 && v + w <= 1)
        return {a[0] + v * ab[0] + w * ac[0], a[1] + v * ab[1] + w * ac[1], a[2] + v * ab[2] + w * ac[2]};
    const Coordinates<3> on[3] = {between(a, ab, ab_a / square(ab)), between(a, ac, ac_a / square(ac)), between(b, bc, dot(bc, bp) / square(bc))};
    return *std::min_element(std::begin(on), std::end(on),
                             [&](const auto& q, const auto& r) { return square(minus(q, p)) < square(minus(r, p)); });
}

Triangle_tree::Triangle_tree(const Triangle_surface& surface) {
    std::vector<std::array<double, 4>> middle;  // and the triangle's number, so that equal ones have an order
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
        const auto& t = surface.triangles[i];
        Triangle x;
        for (std::size_t k = 0; k < 3; ++k) x[k] = surface.points[static_cast<std::size_t>(t[k])];
        std::array<double, 4> m{0, 0, 0, static_cast<double>(i)};
        for (std::size_t k = 0; k < 3; ++k) m[k] = x[0][k] + x[1][k] + x[2][k];
        triangle_.push_back(x);
        middle.push_back(m);
    }
    node_.reserve(middle.size());
    build(0, middle.size(), middle);
    std::vector<Triangle> ordered;
    ordered.reserve(triangle_.size());
    for (const auto& m : middle) ordered.push_back(triangle_[static_cast<std::size_t>(m[3])]);
    triangle_ = std::move(ordered);
}

/// The node of [first, last) of `middle`, which it puts in order; halves along the longest side of the box of the middles.
std::size_t Triangle_tree::build(std::size_t first, std::size_t last, std::vector<std::array<double, 4>>& middle) {
    const std::size_t here = node_.size();
    node_.emplace_back();
    constexpr double limit = std::numeric_limits<double>::infinity();
    Coordinates<3> low{limit, limit, limit}, high{-limit, -limit, -limit}, lower = low, upper = high;
    for (std::size_t i = first; i < last; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], middle[i][k]);
            high[k] = std::max(high[k], middle[i][k]);
            for (const auto& x : triangle_[static_cast<std::size_t>(middle[i][3])]) {
                lower[k] = std::min(lower[k], x[k]);
                upper[k] = std::max(upper[k], x[k]);
            }
        }
    node_[here].lower = lower;
    node_[here].upper = upper;
    if (last - first <= leaf) {
        node_[here].first = first;
        node_[here].count = last - first;
        return here;
    }
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
    const std::size_t half = first + (last - first) / 2;
    const auto at = [&](std::size_t i) { return middle.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(half), at(last), [axis](const auto& p, const auto& q) {
        return p[axis] < q[axis] || (p[axis] == q[axis] && p[3] < q[3]);
    });
    build(first, half, middle);
    const std::size_t second = build(half, last, middle);
    node_[here].first = second;
    return here;
}

/// The nearest point whose squared distance is below the bound, if there is one.
bool Triangle_tree::search(const Coordinates<3>& p, double bound, Coordinates<3>& found) const {
    struct Waiting {
        std::size_t node;
        double distance;
    };
    std::array<Waiting, 128> stack;  // deeper than halving any number of triangles goes
    std::size_t waiting = 0;
    stack[waiting++] = {0, square_distance(node_[0], p)};
    bool any = false;
    while (waiting > 0) {
        const Waiting next = stack[--waiting];
        if (!(next.distance < bound)) continue;
        const Node& node = node_[next.node];
        for (std::size_t i = node.first; i < node.first + node.count; ++i) {
            const Triangle& t = triangle_[i];
            const Coordinates<3> q = nearest_in_triangle(t[0], t[1], t[2], p);
            const double distance = square(minus(q, p));
            if (!(distance < bound)) continue;
            bound = distance;
            found = q;
            any = true;
        }
        if (node.count > 0) continue;
        Waiting near{next.node + 1, square_distance(node_[next.node + 1], p)}, far{node.first, square_distance(node_[node.first], p)};
        if (far.distance < near.distance) std::swap(near, far);
        stack[waiting++] = far;
        stack[waiting++] = near;
    }
    return any;
}

Coordinates<3> Triangle_tree::nearest(const Coordinates<3>& p) const {
    Coordinates<3> found = triangle_[0][0];
    (void)search(p, std::numeric_limits<double>::infinity(), found);
    return found;
}

Coordinates<3> Triangle_tree::nearest(const Coordinates<3>& p, const Coordinates<3>& near) const {
    // The slack is for a point that is off the surface by a rounding.
    Coordinates<3> found;
    return search(p, 1.0001 * square(minus(near, p)), found) ? found : nearest(p);
}

}  // namespace annulus
