// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The object and the model of program.h, for tests that are compiled without CGAL.

#include <common/motion.h>
#include <common/operation.h>
#include <support/viewed_mesh.h>

#include <memory>
#include <vector>

namespace annulus::oracle {

template <int d>
class Session_of;

}  // namespace annulus::oracle

namespace annulus::testing {

/// An oracle::Session_of; see its members of the same names. They throw oracle::Session_fault.
template <int d>
class Checked_mesh {
  public:
    explicit Checked_mesh(const oracle::Program_of<d>& program);
    Checked_mesh(Strategy strategy, const std::vector<Coordinates<d>>& points)
        : Checked_mesh(oracle::Program_of<d>{strategy, points, {}}) {}
    ~Checked_mesh();
    Checked_mesh(const Checked_mesh&) = delete;
    Checked_mesh& operator=(const Checked_mesh&) = delete;

    [[nodiscard]] const Viewed_mesh<d>& dt() const { return dt_; }
    [[nodiscard]] const oracle::Sites_of<d>& sites() const;
    [[nodiscard]] const Move_result& last() const;

    void apply(const oracle::Operation_of<d>& o);
    void check() const;
    void check_recomputed_tolerances() const;

  private:
    std::unique_ptr<oracle::Session_of<d>> session_;
    Viewed_mesh<d> dt_;
};

extern template class Checked_mesh<2>;
extern template class Checked_mesh<3>;

}  // namespace annulus::testing
