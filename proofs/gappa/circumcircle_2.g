# SPDX-License-Identifier: GPL-3.0-or-later
# Forward error of the in-circle determinant of src/annulus/predicate/sphere_terms.h, for its order of operations.
# Model and notation are those of certificates_2.g.
@mul = mul_rel<53>;
@add = add_rel<53>;
@sub = sub_rel<53>;

# u, v: two corners of the triangle relative to the third; w: the point, relative to it too.
uu = add(mul(ux, ux), mul(uy, uy));
vv = add(mul(vx, vx), mul(vy, vy));
ww = add(mul(wx, wx), mul(wy, wy));
det = sub(mul(ux, vy), mul(uy, vx));
nx = sub(mul(uy, vv), mul(vy, uu));
ny = sub(mul(vx, uu), mul(ux, vv));
outside = add(add(mul(wx, nx), mul(wy, ny)), mul(ww, det));

Euu = Eux * Eux + Euy * Euy;
Evv = Evx * Evx + Evy * Evy;
Eww = Ewx * Ewx + Ewy * Ewy;
Edet = Eux * Evy - Euy * Evx;
Enx = Euy * Evv - Evy * Euu;
Eny = Evx * Euu - Eux * Evv;
Eoutside = Ewx * Enx + Ewy * Eny + Eww * Edet;

{
     |ux| <= 1 /\ |uy| <= 1 /\ |vx| <= 1 /\ |vy| <= 1 /\ |wx| <= 1 /\ |wy| <= 1
  /\ |ux - Eux| <= 1b-53 /\ |uy - Euy| <= 1b-53 /\ |vx - Evx| <= 1b-53 /\ |vy - Evy| <= 1b-53
  /\ |wx - Ewx| <= 1b-53 /\ |wy - Ewy| <= 1b-53
->
     |outside - Eoutside| <= 129b-53    # bounds: circumcircle_2, refused at 128
}
