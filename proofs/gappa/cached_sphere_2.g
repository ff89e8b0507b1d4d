# SPDX-License-Identifier: GPL-3.0-or-later
# Forward errors of the two terms of the in-circle determinant of src/annulus/kernel/cached_sphere.h, for its order of
# operations.
# Model and notation are those of certificates_2.g.
@mul = mul_rel<53>;
@add = add_rel<53>;
@sub = sub_rel<53>;

# u, v: two corners of the triangle relative to the third; w: the point, relative to it too.
uu = add(mul(ux, ux), mul(uy, uy));
vv = add(mul(vx, vx), mul(vy, vy));
ww = add(mul(wx, wx), mul(wy, wy));
det = sub(mul(ux, vy), mul(uy, vx));
nx = sub(mul(uu, vy), mul(vv, uy));
ny = sub(mul(vv, ux), mul(uu, vx));
square_term = mul(ww, det);
linear_term = add(mul(wx, nx), mul(wy, ny));

Euu = Eux * Eux + Euy * Euy;
Evv = Evx * Evx + Evy * Evy;
Eww = Ewx * Ewx + Ewy * Ewy;
Edet = Eux * Evy - Euy * Evx;
Enx = Euu * Evy - Evv * Euy;
Eny = Evv * Eux - Euu * Evx;
Esquare_term = Eww * Edet;
Elinear_term = Ewx * Enx + Ewy * Eny;

{
     |ux| <= 1 /\ |uy| <= 1 /\ |vx| <= 1 /\ |vy| <= 1 /\ |wx| <= 1 /\ |wy| <= 1
  /\ |ux - Eux| <= 1b-53 /\ |uy - Euy| <= 1b-53 /\ |vx - Evx| <= 1b-53 /\ |vy - Evy| <= 1b-53
  /\ |wx - Ewx| <= 1b-53 /\ |wy - Ewy| <= 1b-53
->
     |square_term - Esquare_term| <= 37b-53    # bounds: cached_sphere_2_square, refused at 35
  /\ |linear_term - Elinear_term| <= 81b-53    # bounds: cached_sphere_2_linear, refused at 79
}
