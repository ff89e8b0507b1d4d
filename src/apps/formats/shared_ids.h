// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

/// Whether any two successive frames with points share an id. If none do, ids number rows or detections, not tracks.
class Shared_ids {
  public:
    /// Takes the ids of the next frame, ascending. Linear until two frames share one, then constant.
    void take(const std::vector<std::uint64_t>& id) {
        if (found_ || id.empty()) return;
        std::size_t a = 0, b = 0;
        while (a < last_.size() && b < id.size() && last_[a] != id[b]) ++(last_[a] < id[b] ? a : b);
        found_ = a < last_.size() && b < id.size();
        ++frames_;
        if (found_) last_ = {};
        else last_ = id;
    }
    [[nodiscard]] bool none() const { return frames_ > 1 && !found_; }

  private:
    std::vector<std::uint64_t> last_;
    std::uint64_t frames_ = 0;
    bool found_ = false;
};

}  // namespace annulus::inline v1
