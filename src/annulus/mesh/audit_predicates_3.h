// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/audit_points.h>

namespace annulus::inline v1::auditing {

using Cell = std::array<Index, 4>;
using Triple = std::array<Index, 3>;

/// Exact predicates with their own temporaries.
class Audit_predicates_3 {
  public:
    explicit Audit_predicates_3(const std::vector<Integer_point<3>>& s) : s_(s) {}

    /// Sign of ((b - a) x (c - a)) . (e - a).
    int orientation(Index a, Index b, Index c, Index e) {
        return orientation(s_[at(a)], s_[at(b)], s_[at(c)], s_[at(e)]);
    }

    /// Positive when e is strictly inside the sphere of the positive cell a b c d: the lifted 4 x 4 determinant,
    /// expanded by its last column.
    int inside(const Cell& v, Index e) {
        for (std::size_t i = 0; i < 4; ++i) {
            mpz_set_ui(lift_[i], 0);
            for (std::size_t k = 0; k < 3; ++k) {
                mpz_sub(row_[i][k], s_[at(v[i])][k], s_[at(e)][k]);
                mpz_addmul(lift_[i], row_[i][k], row_[i][k]);
            }
        }
        mpz_set_ui(sum_, 0);
        for (std::size_t i = 0; i < 4; ++i) {
            determinant(row_[(i + 1) % 4], row_[(i + 2) % 4], row_[(i + 3) % 4]);
            mpz_mul(t_[0], det_, lift_[i]);
            if (i % 2 == 0) mpz_sub(sum_, sum_, t_[0]);
            else mpz_add(sum_, sum_, t_[0]);
        }
        // Negative inside: with all lifts 1, as for e in the middle of a regular cell, it is minus the orientation.
        return -sign(sum_);
    }

    /// Sets o to the sum of the corners of a cell: four times its middle.
    void take_middle(const Cell& c) {
        for (std::size_t k = 0; k < 3; ++k) {
            mpz_set_ui(o_[k], 0);
            for (const Index v : c) mpz_add(o_[k], o_[k], s_[at(v)][k]);
        }
    }
    /// Sign of the cell a b c o.
    int orientation_of_middle(const Triple& f) {
        for (std::size_t i = 0; i < 3; ++i) from_middle(f[i], row_[i]);
        determinant(row_[0], row_[1], row_[2]);
        return -sign(det_);
    }
    /// The ray from o through the middle of triangle g meets the closed triangle f, whose inner side faces o.
    bool meets(const Triple& f, const Triple& g) {
        for (std::size_t k = 0; k < 3; ++k) mpz_set_ui(row_[3][k], 0);
        for (const Index v : g) {
            from_middle(v, row_[0]);
            for (std::size_t k = 0; k < 3; ++k) mpz_add(row_[3][k], row_[3][k], row_[0][k]);
        }
        for (std::size_t i = 0; i < 3; ++i) from_middle(f[i], row_[i]);
        // The ray meets f if its direction is a combination of the corners of f without negative coefficients
        // (Cramer's rule).
        determinant(row_[0], row_[1], row_[2]);
        const int whole = sign(det_);
        for (std::size_t i = 0; i < 3; ++i) {
            determinant(row_[3], row_[(i + 1) % 3], row_[(i + 2) % 3]);
            if (sign(det_) * whole < 0) return false;
        }
        return true;
    }

    /// c and e are on different sides of the line a b; all four are in one plane.
    bool opposite(Index a, Index b, Index c, Index e) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int one = turn(a, b, c, k);
            if (one != 0) return turn(a, b, e, k) == -one;
        }
        return false;
    }
    /// Sign of component k of (b - a) x (c - a).
    int turn(Index a, Index b, Index c, std::size_t k) {
        const std::size_t i = (k + 1) % 3;
        const std::size_t j = (k + 2) % 3;
        const Integer_point<3>& A = s_[at(a)];
        mpz_sub(t_[0], s_[at(b)][i], A[i]);
        mpz_sub(t_[1], s_[at(c)][j], A[j]);
        mpz_sub(t_[2], s_[at(b)][j], A[j]);
        mpz_sub(t_[3], s_[at(c)][i], A[i]);
        mpz_mul(t_[4], t_[0], t_[1]);
        mpz_submul(t_[4], t_[2], t_[3]);
        return sign(t_[4]);
    }
    bool collinear(Index a, Index b, Index c) {
        return turn(a, b, c, 0) == 0 && turn(a, b, c, 1) == 0 && turn(a, b, c, 2) == 0;
    }

  private:
    using Row = std::array<Integer, 3>;
    int orientation(const Integer_point<3>& a, const Integer_point<3>& b, const Integer_point<3>& c,
                    const Integer_point<3>& e) {
        for (std::size_t k = 0; k < 3; ++k) {
            mpz_sub(row_[0][k], b[k], a[k]);
            mpz_sub(row_[1][k], c[k], a[k]);
            mpz_sub(row_[2][k], e[k], a[k]);
        }
        determinant(row_[0], row_[1], row_[2]);
        return sign(det_);
    }
    /// Four times the vector from the middle to v.
    void from_middle(Index v, Row& row) {
        for (std::size_t k = 0; k < 3; ++k) {
            mpz_mul_2exp(row[k], s_[at(v)][k], 2);
            mpz_sub(row[k], row[k], o_[k]);
        }
    }
    /// det_ = (u x v) . w.
    void determinant(const Row& u, const Row& v, const Row& w) {
        mpz_set_ui(det_, 0);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t i = (k + 1) % 3;
            const std::size_t j = (k + 2) % 3;
            mpz_mul(t_[5], u[i], v[j]);
            mpz_submul(t_[5], u[j], v[i]);
            mpz_addmul(det_, t_[5], w[k]);
        }
    }

    const std::vector<Integer_point<3>>& s_;
    Integer_point<3> o_;
    std::array<Row, 4> row_;
    std::array<Integer, 4> lift_;
    std::array<Integer, 6> t_;
    Integer det_;
    Integer sum_;
};

}  // namespace annulus::inline v1::auditing
