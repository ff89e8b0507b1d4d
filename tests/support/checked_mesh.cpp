// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/checked_mesh.h>

#include <common/program.h>
#include <support/viewed.h>

namespace annulus::testing {

template <int d>
Checked_mesh<d>::Checked_mesh(const oracle::Program_of<d>& program)
    : session_(std::make_unique<oracle::Session_of<d>>(program)), dt_(std::make_unique<Viewed<d>>(&session_->dt())) {}
template <int d>
Checked_mesh<d>::~Checked_mesh() = default;

template <int d>
const oracle::Sites_of<d>& Checked_mesh<d>::sites() const {
    return session_->sites();
}
template <int d>
const Move_result& Checked_mesh<d>::last() const {
    return session_->last();
}
template <int d>
void Checked_mesh<d>::apply(const oracle::Operation_of<d>& o) {
    session_->apply(o);
}
template <int d>
void Checked_mesh<d>::check() const {
    session_->check();
}
template <int d>
void Checked_mesh<d>::check_recomputed_tolerances() const {
    session_->check_recomputed_tolerances();
}

template class Checked_mesh<2>;
template class Checked_mesh<3>;

}  // namespace annulus::testing
