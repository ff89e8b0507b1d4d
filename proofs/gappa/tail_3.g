# SPDX-License-Identifier: GPL-3.0-or-later
# The last operations of the filter stage in space, as tail_2.g in the plane: squares are sums of three. Given what
# certificates_3.g proves of the terms, the tolerance returned is not above the truth. `tail` of bounds.h.
#
# P: computed determinant, e: its error bound, n: what the two norms together may be short by. The claim is
#     computed <= (P - e) / (|M~| + |N~| + n)
# for one partition; the code divides by the largest of four such sums, which only makes the result smaller. For a
# tetrahedron both norms are the largest of the seven slabs; the code takes the largest of seven computed squares. The
# ranges hold inside filter_range_3 (m between 2^-100 and 2^100) wherever the filter answers: P >= 2^10 e >= 2^10
# 2^-53 m^5 (or m^3), roots >= 2^10 n >= 2^10 2^-53 m^4 (or m^2), and all vectors are below 2^7 m^4. A square below
# 2^-980 has a root below 2^-490 beside a sum of roots above 2^-443; a partial square below 2^-1060 is less than 2^-80
# of one above 2^-980. What is between the tail accepted here and the one used covers both.
@rnd = float<ieee_64, ne>;

P = rnd(P_); e = rnd(e_); n = rnd(n_);
nx = rnd(nx_); ny = rnd(ny_); nz = rnd(nz_); mx = rnd(mx_); my = rnd(my_); mz = rnd(mz_);
inner_xy = add_rel<53>(mul_rel<53>(nx, nx), mul_rel<53>(ny, ny));
inner = add_rel<53>(inner_xy, mul_rel<53>(nz, nz));
outer_xy = add_rel<53>(mul_rel<53>(mx, mx), mul_rel<53>(my, my));
outer = add_rel<53>(outer_xy, mul_rel<53>(mz, mz));
roots rnd= sqrt(inner) + sqrt(outer);
numerator rnd= P - e;
denominator rnd= roots + n;
quotient rnd= numerator / denominator;
c = 1 - 16b-53;                                  # bounds: tail, refused at 7
tolerance rnd= quotient * c;
Einner_xy = nx * nx + ny * ny;
Einner = Einner_xy + nz * nz;
Eouter_xy = mx * mx + my * my;
Eouter = Eouter_xy + mz * mz;
truth = (P - e) / (sqrt(Einner) + sqrt(Eouter) + n);

{
     P - e in [1b-543, 1b510] /\ n in [0, 1b360]
  /\ nx * nx in [0, 1b814] /\ ny * ny in [0, 1b814] /\ nz * nz in [0, 1b814]
  /\ mx * mx in [0, 1b814] /\ my * my in [0, 1b814] /\ mz * mz in [0, 1b814]
  /\ Einner_xy in [1b-1060, 1b815] /\ Eouter_xy in [1b-1060, 1b815]
  /\ Einner in [1b-980, 1b816] /\ Eouter in [1b-980, 1b816]
->
     (tolerance - truth) / truth in [-30b-53, 0]
}

# tolerance = (1 + d) * quotient * c and quotient = (1 + d') * truth.
(tolerance - truth) / truth -> (1 + (tolerance - quotient * c) / (quotient * c)) * (1 + (quotient - truth) / truth) * c - 1 { quotient * c <> 0, truth <> 0 };
