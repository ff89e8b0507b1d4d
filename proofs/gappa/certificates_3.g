# SPDX-License-Identifier: GPL-3.0-or-later
# Forward errors of the filter stage in space (src/annulus/predicate/bounds.h), for the order of operations of
# src/annulus/predicate/width_terms_3.h. Line by line the same names; the model is that of certificates_2.g.
#
# All that is assumed of the coordinates x, y and z is symmetric in them, and cross, combination and minus_twice go
# round cyclically. So a bound of the x coordinate of a vector is one of every coordinate; what only leads to y and z
# is left out. One constant serves all four partitions; the largest error of its kind is the marked one.
#
# A capital E marks what is exact. The differences themselves are rounded: |b~ - b| <= u |b~|.
@mul = mul_rel<53>;
@add = add_rel<53>;
@sub = sub_rel<53>;

# orientation_terms: u, v, w relative to the first point
uvx = sub(mul(uy, vz), mul(uz, vy));
uvy = sub(mul(uz, vx), mul(ux, vz));
uvz = sub(mul(ux, vy), mul(uy, vx));
vwx = sub(mul(vy, wz), mul(vz, wy));
wux = sub(mul(wy, uz), mul(wz, uy));
det = add(add(mul(uvx, wx), mul(uvy, wy)), mul(uvz, wz));
v_pairx = add(uvx, vwx);
facetx = add(v_pairx, wux);

Euvx = Euy * Evz - Euz * Evy;
Euvy = Euz * Evx - Eux * Evz;
Euvz = Eux * Evy - Euy * Evx;
Evwx = Evy * Ewz - Evz * Ewy;
Ewux = Ewy * Euz - Ewz * Euy;
Edet = (Euvx * Ewx + Euvy * Ewy) + Euvz * Ewz;
Ev_pairx = Euvx + Evwx;
Efacetx = Ev_pairx + Ewux;

# annulus_terms: b, c, p, q relative to a
bcx = sub(mul(by, cz), mul(bz, cy));
bcy = sub(mul(bz, cx), mul(bx, cz));
bcz = sub(mul(bx, cy), mul(by, cx));
bpx = sub(mul(by, pz), mul(bz, py));
bqx = sub(mul(by, qz), mul(bz, qy));
bqy = sub(mul(bz, qx), mul(bx, qz));
bqz = sub(mul(bx, qy), mul(by, qx));
cpx = sub(mul(cy, pz), mul(cz, py));
cpy = sub(mul(cz, px), mul(cx, pz));
cpz = sub(mul(cx, py), mul(cy, px));
cqx = sub(mul(cy, qz), mul(cz, qy));
pqx = sub(mul(py, qz), mul(pz, qy));
bb = add(add(mul(bx, bx), mul(by, by)), mul(bz, bz));
cc = add(add(mul(cx, cx), mul(cy, cy)), mul(cz, cz));
pp = add(add(mul(px, px), mul(py, py)), mul(pz, pz));
qq = add(add(mul(qx, qx), mul(qy, qy)), mul(qz, qz));
lb = add(add(mul(cpx, qx), mul(cpy, qy)), mul(cpz, qz));
lc = add(add(mul(bqx, px), mul(bqy, py)), mul(bqz, pz));
lp = add(add(mul(bcx, qx), mul(bcy, qy)), mul(bcz, qz));
nq = add(add(mul(bcx, px), mul(bcy, py)), mul(bcz, pz));
determinant = add(add(mul(lb, bb), mul(lc, cc)), sub(mul(lp, pp), mul(nq, qq)));
upx = add(sub(mul(bb, cqx), mul(cc, bqx)), mul(qq, bcx));
vqx = add(sub(mul(bb, cpx), mul(cc, bpx)), mul(pp, bcx));
ubx = add(sub(mul(cc, pqx), mul(pp, cqx)), mul(qq, cpx));
vcx = add(sub(mul(bb, pqx), mul(pp, bqx)), mul(qq, bpx));
l1 = sub(lp, nq);
n1x = sub(upx, vqx);
m1x = sub(n1x, mul(2 * l1, px));
l2 = add(l1, lc);
n2x = sub(n1x, vcx);
m2x = sub(n2x, mul(2 * l2, cx));
l3 = add(l1, lb);
n3x = add(n1x, ubx);
m3x = sub(n3x, mul(2 * l3, bx));
l4 = add(lb, lc);
n4x = sub(ubx, vcx);
m4x = sub(n4x, mul(2 * l4, bx));

Ebcx = Eby * Ecz - Ebz * Ecy;
Ebcy = Ebz * Ecx - Ebx * Ecz;
Ebcz = Ebx * Ecy - Eby * Ecx;
Ebpx = Eby * Epz - Ebz * Epy;
Ebqx = Eby * Eqz - Ebz * Eqy;
Ebqy = Ebz * Eqx - Ebx * Eqz;
Ebqz = Ebx * Eqy - Eby * Eqx;
Ecpx = Ecy * Epz - Ecz * Epy;
Ecpy = Ecz * Epx - Ecx * Epz;
Ecpz = Ecx * Epy - Ecy * Epx;
Ecqx = Ecy * Eqz - Ecz * Eqy;
Epqx = Epy * Eqz - Epz * Eqy;
Ebb = (Ebx * Ebx + Eby * Eby) + Ebz * Ebz;
Ecc = (Ecx * Ecx + Ecy * Ecy) + Ecz * Ecz;
Epp = (Epx * Epx + Epy * Epy) + Epz * Epz;
Eqq = (Eqx * Eqx + Eqy * Eqy) + Eqz * Eqz;
Elb = (Ecpx * Eqx + Ecpy * Eqy) + Ecpz * Eqz;
Elc = (Ebqx * Epx + Ebqy * Epy) + Ebqz * Epz;
Elp = (Ebcx * Eqx + Ebcy * Eqy) + Ebcz * Eqz;
Enq = (Ebcx * Epx + Ebcy * Epy) + Ebcz * Epz;
Edeterminant = (Elb * Ebb + Elc * Ecc) + (Elp * Epp - Enq * Eqq);
Eupx = (Ebb * Ecqx - Ecc * Ebqx) + Eqq * Ebcx;
Evqx = (Ebb * Ecpx - Ecc * Ebpx) + Epp * Ebcx;
Eubx = (Ecc * Epqx - Epp * Ecqx) + Eqq * Ecpx;
Evcx = (Ebb * Epqx - Epp * Ebqx) + Eqq * Ebpx;
El1 = Elp - Enq;
En1x = Eupx - Evqx;
Em1x = En1x - (2 * El1) * Epx;
El2 = El1 + Elc;
En2x = En1x - Evcx;
Em2x = En2x - (2 * El2) * Ecx;
El3 = El1 + Elb;
En3x = En1x + Eubx;
Em3x = En3x - (2 * El3) * Ebx;
El4 = Elb + Elc;
En4x = Eubx - Evcx;
Em4x = En4x - (2 * El4) * Ebx;

{
     |ux| <= 1 /\ |uy| <= 1 /\ |uz| <= 1
  /\ |ux - Eux| <= 1b-53 /\ |uy - Euy| <= 1b-53 /\ |uz - Euz| <= 1b-53
  /\ |vx| <= 1 /\ |vy| <= 1 /\ |vz| <= 1
  /\ |vx - Evx| <= 1b-53 /\ |vy - Evy| <= 1b-53 /\ |vz - Evz| <= 1b-53
  /\ |wx| <= 1 /\ |wy| <= 1 /\ |wz| <= 1
  /\ |wx - Ewx| <= 1b-53 /\ |wy - Ewy| <= 1b-53 /\ |wz - Ewz| <= 1b-53
  /\ |bx| <= 1 /\ |by| <= 1 /\ |bz| <= 1
  /\ |bx - Ebx| <= 1b-53 /\ |by - Eby| <= 1b-53 /\ |bz - Ebz| <= 1b-53
  /\ |cx| <= 1 /\ |cy| <= 1 /\ |cz| <= 1
  /\ |cx - Ecx| <= 1b-53 /\ |cy - Ecy| <= 1b-53 /\ |cz - Ecz| <= 1b-53
  /\ |px| <= 1 /\ |py| <= 1 /\ |pz| <= 1
  /\ |px - Epx| <= 1b-53 /\ |py - Epy| <= 1b-53 /\ |pz - Epz| <= 1b-53
  /\ |qx| <= 1 /\ |qy| <= 1 /\ |qz| <= 1
  /\ |qx - Eqx| <= 1b-53 /\ |qy - Eqy| <= 1b-53 /\ |qz - Eqz| <= 1b-53
->
     |det - Edet| <= 47b-53                        # bounds: orientation_3, refused at 46
  /\ |facetx - Efacetx| <= 35b-53                  # bounds: orientation_3_slab, refused at 34
  /\ |determinant - Edeterminant| <= 1105b-53      # bounds: annulus_3_insphere, refused at 1104
  /\ |n1x - En1x| <= 691b-53
  /\ |n2x - En2x| <= 691b-53                       # bounds: annulus_3_n, refused at 690
  /\ |n3x - En3x| <= 691b-53
  /\ |n4x - En4x| <= 691b-53
  /\ |m1x - Em1x| <= 1183b-53
  /\ |m2x - Em2x| <= 1183b-53                      # bounds: annulus_3_m, refused at 1182
  /\ |m3x - Em3x| <= 1183b-53
  /\ |m4x - Em4x| <= 1183b-53
  /\ |l1 - El1| <= 169b-53
  /\ |l2 - El2| <= 169b-53                         # bounds: annulus_3_side, refused at 168
  /\ |l3 - El3| <= 169b-53
  /\ |l4 - El4| <= 169b-53
}
