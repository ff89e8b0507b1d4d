# SPDX-License-Identifier: GPL-3.0-or-later
# The last operations of the filter stage (detail::decide in src/annulus/predicate/decide.h): given what
# certificates_2.g proves of the terms, the tolerance returned is not above the truth. `tail` of bounds.h.
#
# P: computed determinant, e: its error bound, n: what the norms may be short by (0 for the orientation), all of them
# doubles. Truth: determinant >= P - e, and the two norms add up to at most |M~| + |N~| + n. So the claim is
#     computed <= (P - e) / (|M~| + |N~| + n).
# The ranges hold inside filter_range (m between 2^-120 and 2^120) wherever the filter answers: P >= 2^10 e >=
# 2^10 2^-53 m^4, and m^8 stays below 2^960. A product that underflows adds less than 2^-1074 to `inner`, which is then
# at least 2^-910 (roots >= 2^10 n): below 2^-150 relative, absorbed by the rounding up of `tail`.
@rnd = float<ieee_64, ne>;

P = rnd(P_); e = rnd(e_); n = rnd(n_);
nx = rnd(nx_); ny = rnd(ny_); mx = rnd(mx_); my = rnd(my_);
inner = add_rel<53>(mul_rel<53>(nx, nx), mul_rel<53>(ny, ny));
outer = add_rel<53>(mul_rel<53>(mx, mx), mul_rel<53>(my, my));
roots rnd= sqrt(inner) + sqrt(outer);
numerator rnd= P - e;
denominator rnd= roots + n;
quotient rnd= numerator / denominator;
c = 1 - 16b-53;                                  # bounds: tail, refused at 7
tolerance rnd= quotient * c;
Einner = nx * nx + ny * ny;
Eouter = mx * mx + my * my;
truth = (P - e) / (sqrt(Einner) + sqrt(Eouter) + n);

# One side k of a triangle, each coordinate of it a rounded difference. The code takes the longest of three computed
# squares, which is at least that of the truly longest side, so this side stands for all; both roots are the same one.
kx = rnd(kx_); ky = rnd(ky_);
square = add_rel<53>(mul_rel<53>(kx, kx), mul_rel<53>(ky, ky));
root rnd= sqrt(square);
quotient_1 rnd= numerator / (2 * root);
tolerance_1 rnd= quotient_1 * c;
Esquare = Ekx * Ekx + Eky * Eky;
truth_1 = (P - e) / (2 * sqrt(Esquare));

{
     P - e in [1b-516, 1b490] /\ n in [0, 1b320]
  /\ nx * nx in [0, 1b740] /\ ny * ny in [0, 1b740] /\ mx * mx in [0, 1b740] /\ my * my in [0, 1b740]
  /\ Einner in [1b-910, 1b740] /\ Eouter in [1b-910, 1b740]
  /\ kx * kx in [0, 1b500] /\ ky * ky in [0, 1b500] /\ Ekx * Ekx in [0, 1b500] /\ Eky * Eky in [0, 1b500]
  /\ Esquare in [1b-300, 1b500]
  /\ kx -/ Ekx in [-1b-53, 1b-53] /\ ky -/ Eky in [-1b-53, 1b-53]
->
     (tolerance - truth) / truth in [-30b-53, 0]
  /\ (tolerance_1 - truth_1) / truth_1 in [-30b-53, 0]
}

# tolerance = (1 + d) * quotient * c and quotient = (1 + d') * truth.
(tolerance - truth) / truth -> (1 + (tolerance - quotient * c) / (quotient * c)) * (1 + (quotient - truth) / truth) * c - 1 { quotient * c <> 0, truth <> 0 };
(tolerance_1 - truth_1) / truth_1 -> (1 + (tolerance_1 - quotient_1 * c) / (quotient_1 * c)) * (1 + (quotient_1 - truth_1) / truth_1) * c - 1 { quotient_1 * c <> 0, truth_1 <> 0 };
