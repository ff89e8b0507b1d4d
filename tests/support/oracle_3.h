// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Half widths in 3D from their definitions: slabs from the normals of their own edges, annuli from centres that
// solve a linear system. In rational numbers, exactly, and in MPFI. Nothing is shared with the library.

#include <support/generators_3.h>
#include <support/oracle.h>

#include <vector>

namespace annulus::testing {

/// Two parallel planes or concentric spheres: half the distance between them, by comparison.
class Truth_3 {
  public:
    [[nodiscard]] int sign() const { return sign_; }
    /// y <= the least of the half widths, exactly. y >= 0, sign() > 0.
    [[nodiscard]] bool is_at_least(double y) const;
    /// The least half width, in MPFI with 500 bits.
    [[nodiscard]] Enclosure enclosure() const;

  protected:
    /// (distance of the planes)^2 = square of `height` / `normal`.
    struct Slab {
        mpq_class height_2, normal_2;
    };
    struct Annulus {
        mpq_class r2, R2;  // the lesser, the greater
    };
    void add_slab(const Point_3& from, const Point_3& to, const std::array<Point_3, 2>& u,
                  const std::array<Point_3, 2>& v);

    int sign_ = 0;
    std::vector<Slab> slabs_;
    std::vector<Annulus> annuli_;
};

/// The least of the seven slabs of a tetrahedron.
class Tetrahedron_truth : public Truth_3 {
  public:
    explicit Tetrahedron_truth(const Tetrahedron& t);
};

/// The least of the annuli of a bi-cell, and of its cells if requested.
class Bicell_3_truth : public Truth_3 {
  public:
    Bicell_3_truth(const Bicell_3& c, bool with_cells);
};

/// The annulus of one partition of a bi-cell: 0 to 3 as Partition_3.
class Annulus_truth : public Truth_3 {
  public:
    Annulus_truth(const Bicell_3& c, std::size_t partition);
    /// The points of A are on the inner sphere: sum of lambda over B > 0 if the sphere is empty.
    [[nodiscard]] bool is_forward() const { return forward_; }

  private:
    friend class Bicell_3_truth;
    bool forward_ = false;
};

}  // namespace annulus::testing
