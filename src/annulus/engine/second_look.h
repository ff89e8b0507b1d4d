// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/certificate/delimiter.h>
#include <annulus/engine/options.h>
#include <annulus/engine/step.h>
#include <annulus/mesh/certificates.h>

#include <array>
#include <span>

namespace annulus {

/// The second looks after a failed tolerance: cheap proofs that a facet's certificate holds although it expired. In the plane only: in
/// space all are off. What they need is kept by facet: the tolerance that was found, and the delimiter.
template <int d>
class Second_looks {
  public:
    using Facet_numbers = std::array<double, static_cast<std::size_t>(d + 2)>;  ///< by point of a facet's certificate

    explicit Second_looks(Second_look kind) : kind_(d == 2 ? kind : Second_look::off) {}
    [[nodiscard]] bool on() const { return kind_ != Second_look::off; }
    /// What a renewal holds: the distance every point may go from where it is now, not odometer readings.
    [[nodiscard]] bool gives_room() const { return kind_ == Second_look::safe_region; }

    void resize(Corner_index facets) {
        if (on()) grow(tolerance_, facets);
    }
    void free() noexcept {
        release(tolerance_);
        release(delimiter_);
    }
    /// Facet f was evaluated at x, with these points and this tolerance. Precondition: on().
    void keep(Corner_index f, Facet_kind kind, const Facet_points<d>& point, double tolerance, std::span<const Coordinates<d>> x);
    /// No second look at f before it is evaluated again.
    void forget(Corner_index f) {
        if (on()) tolerance_[f] = 0.0;
    }
    /// After a renewal by unequal moves: the next failure is an evaluation.
    void note_renewed(Corner_index f) {
        if (kind_ == Second_look::unequal_moves) tolerance_[f] = 0.0;
    }

    /// Whether the certificate of facet f, of kind empty_sphere, is proved at x. Its points read `reading` there and expire at `expiry`;
    /// `renewal` receives what is to be written down.
    [[nodiscard]] bool proves(Corner_index f, const Facet_points<d>& point, const Facet_numbers& expiry, const Facet_numbers& reading,
                              std::span<const Coordinates<d>> x, Renewal<d>& renewal) const;

  private:
    friend struct Trace;  // trace.h
    [[nodiscard]] bool unequal_moves(double tolerance, const Facet_numbers& expiry, const Facet_numbers& reading,
                                     Facet_numbers& renewed) const;
    [[nodiscard]] bool safe_region(Corner_index f, const Facet_points<d>& point, const Facet_numbers& reading,
                                   std::span<const Coordinates<d>> x, Facet_numbers& room) const;

    Second_look kind_;
    By_corner<double> tolerance_;       // of facets; 0: no second look
    By_corner<Delimiter_2> delimiter_;  // of facets, for safe regions
};

extern template class Second_looks<2>;
extern template class Second_looks<3>;

}  // namespace annulus
