# SPDX-License-Identifier: GPL-3.0-or-later
# Forward error of the in-sphere determinant of src/annulus/predicate/sphere_terms.h, for its order of operations.
# Model and notation are those of certificates_2.g.
@mul = mul_rel<53>;
@add = add_rel<53>;
@sub = sub_rel<53>;

# u, v, t: three corners of the cell relative to the fourth; w: the point, relative to it too.
uu = add(add(mul(ux, ux), mul(uy, uy)), mul(uz, uz));
vv = add(add(mul(vx, vx), mul(vy, vy)), mul(vz, vz));
tt = add(add(mul(tx, tx), mul(ty, ty)), mul(tz, tz));
ww = add(add(mul(wx, wx), mul(wy, wy)), mul(wz, wz));
uvx = sub(mul(uy, vz), mul(uz, vy));
uvy = sub(mul(uz, vx), mul(ux, vz));
uvz = sub(mul(ux, vy), mul(uy, vx));
vtx = sub(mul(vy, tz), mul(vz, ty));
vty = sub(mul(vz, tx), mul(vx, tz));
vtz = sub(mul(vx, ty), mul(vy, tx));
tux = sub(mul(ty, uz), mul(tz, uy));
tuy = sub(mul(tz, ux), mul(tx, uz));
tuz = sub(mul(tx, uy), mul(ty, ux));
det = add(add(mul(uvx, tx), mul(uvy, ty)), mul(uvz, tz));
nx = add(add(mul(uu, vtx), mul(vv, tux)), mul(tt, uvx));
ny = add(add(mul(uu, vty), mul(vv, tuy)), mul(tt, uvy));
nz = add(add(mul(uu, vtz), mul(vv, tuz)), mul(tt, uvz));
outside = sub(mul(ww, det), add(add(mul(wx, nx), mul(wy, ny)), mul(wz, nz)));

Euu = (Eux * Eux + Euy * Euy) + Euz * Euz;
Evv = (Evx * Evx + Evy * Evy) + Evz * Evz;
Ett = (Etx * Etx + Ety * Ety) + Etz * Etz;
Eww = (Ewx * Ewx + Ewy * Ewy) + Ewz * Ewz;
Euvx = Euy * Evz - Euz * Evy;
Euvy = Euz * Evx - Eux * Evz;
Euvz = Eux * Evy - Euy * Evx;
Evtx = Evy * Etz - Evz * Ety;
Evty = Evz * Etx - Evx * Etz;
Evtz = Evx * Ety - Evy * Etx;
Etux = Ety * Euz - Etz * Euy;
Etuy = Etz * Eux - Etx * Euz;
Etuz = Etx * Euy - Ety * Eux;
Edet = (Euvx * Etx + Euvy * Ety) + Euvz * Etz;
Enx = (Euu * Evtx + Evv * Etux) + Ett * Euvx;
Eny = (Euu * Evty + Evv * Etuy) + Ett * Euvy;
Enz = (Euu * Evtz + Evv * Etuz) + Ett * Euvz;
Eoutside = Eww * Edet - ((Ewx * Enx + Ewy * Eny) + Ewz * Enz);

{
     |ux| <= 1 /\ |uy| <= 1 /\ |uz| <= 1
  /\ |ux - Eux| <= 1b-53 /\ |uy - Euy| <= 1b-53 /\ |uz - Euz| <= 1b-53
  /\ |vx| <= 1 /\ |vy| <= 1 /\ |vz| <= 1
  /\ |vx - Evx| <= 1b-53 /\ |vy - Evy| <= 1b-53 /\ |vz - Evz| <= 1b-53
  /\ |tx| <= 1 /\ |ty| <= 1 /\ |tz| <= 1
  /\ |tx - Etx| <= 1b-53 /\ |ty - Ety| <= 1b-53 /\ |tz - Etz| <= 1b-53
  /\ |wx| <= 1 /\ |wy| <= 1 /\ |wz| <= 1
  /\ |wx - Ewx| <= 1b-53 /\ |wy - Ewy| <= 1b-53 /\ |wz - Ewz| <= 1b-53
->
     |outside - Eoutside| <= 1123b-53    # bounds: circumsphere_3, refused at 1122
}
