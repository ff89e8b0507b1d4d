// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace annulus::inline v1 {

/// The buffers of builds, and when they are freed. They are larger than the mesh, and a build in new memory costs up to
/// twice as much as one in memory that was used before. So they are kept while time steps are rebuilt, and for a few
/// more time steps: that memory is new costs a small share of these at most. No clock is read.
template <class Buffers>
class Kept_buffers {
  public:
    /// For a build that is about to begin. Throws bad_alloc.
    [[nodiscard]] Buffers& get() {
        if (!buffers_) buffers_ = std::make_unique<Buffers>();
        ended_ = 0;
        return *buffers_;
    }
    /// A time step has ended, whether it was rebuilt or not.
    void end_step() noexcept {
        constexpr int most = 8;  // since the last build; the first one that ends is that of the build
        if (buffers_ && ++ended_ > most) release();
    }
    void release() noexcept { buffers_.reset(); }
    /// Whether there are any.
    [[nodiscard]] bool hold_memory() const { return buffers_ != nullptr; }

  private:
    std::unique_ptr<Buffers> buffers_;  // null: none
    int ended_ = 0;                     // time steps since the last build
};

}  // namespace annulus::inline v1
