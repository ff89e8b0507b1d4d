// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/c/changes_of_call.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1::c {

void Changes_of_call::assign(std::vector<Index> came, std::vector<Index> gone) noexcept {
    came_ = std::move(came);
    gone_ = std::move(gone);
    begins_.clear();
    edges_.reset();
    t1_.reset();
}

void Changes_of_call::add(std::span<const Index> came, std::span<const Index> gone) {
    if (came.empty() && gone.empty()) return;
    const Begin begin{came_.size(), gone_.size()};
    begins_.push_back(begin);
    try {
        came_.insert(came_.end(), came.begin(), came.end());
        gone_.insert(gone_.end(), gone.begin(), gone.end());
    } catch (...) {
        came_.resize(begin.came);
        begins_.pop_back();
        throw;
    }
    edges_.reset();
    t1_.reset();
}

template <int d>
Edge_changes Changes_of_call::compute() const {
    struct Change {
        std::pair<Index, Index> edge;
        int sign;
    };
    std::vector<Change> all;
    Begin from;
    const auto read_until = [&](const Begin& to) {
        const Edge_changes one = edge_changes<d>(std::span(came_).subspan(from.came, to.came - from.came),
                                                 std::span(gone_).subspan(from.gone, to.gone - from.gone));
        for (const auto& edge : one.made) all.push_back({edge, 1});
        for (const auto& edge : one.broken) all.push_back({edge, -1});
        from = to;
    };
    for (const Begin& begin : begins_) read_until(begin);
    read_until({came_.size(), gone_.size()});

    // What is made and broken by turns sums up to what is left.
    std::sort(all.begin(), all.end(), [](const Change& a, const Change& b) { return a.edge < b.edge; });
    Edge_changes out;
    for (std::size_t i = 0; i < all.size();) {
        const auto edge = all[i].edge;
        int sum = 0;
        for (; i < all.size() && all[i].edge == edge; ++i) sum += all[i].sign;
        if (sum != 0) (sum > 0 ? out.made : out.broken).push_back(edge);
    }
    return out;
}

const Edge_changes& Changes_of_call::edges(int d) const {
    const std::lock_guard lock(computing_);
    if (!edges_) edges_ = d == 2 ? compute<2>() : compute<3>();
    return *edges_;
}

const T1_transitions& Changes_of_call::t1() const {
    const std::lock_guard lock(computing_);
    if (!t1_) t1_ = t1_transitions(came_, gone_);
    return *t1_;
}

}  // namespace annulus::inline v1::c
