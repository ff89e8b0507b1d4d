# SPDX-License-Identifier: GPL-3.0-or-later
# Forward errors of the filter stage in 2D (src/annulus/predicate/bounds.h), for the order of operations of
# src/annulus/predicate/width_terms.h. Line by line the same names.
#
# Model. Every operation is rounded with relative error at most u = 2^-53 and nothing else is known of it (mul_rel and
# its kin). So the set of computations is closed under scaling of the differences by any positive number m, and an error
# of C u for differences of magnitude at most 1 is an error of C u m^k, k the degree, for differences of magnitude at
# most m. This would not follow from float<ieee_64,ne>: there the error of a result just below a power of two is half of
# what it is just above, the unit box gets smaller constants (7, 121, 65, 121), and these hold when m is a power of two
# but not for m in between. Underflow of products is outside the model; see proofs/README.md.
#
# A capital E marks what is exact. The differences themselves are rounded: |b~ - b| <= u |b~|.
@mul = mul_rel<53>;
@add = add_rel<53>;
@sub = sub_rel<53>;

# orientation_terms: u = x1 - x0, v = x2 - x0
det = sub(mul(ux, vy), mul(uy, vx));
Edet = Eux * Evy - Euy * Evx;

# annulus_terms: b, p, q relative to a; e = q - p, a difference of input coordinates
ob = sub(mul(bx, qy), mul(by, qx));
oa = sub(mul(by, px), mul(bx, py));
D = add(ob, oa);
gx = sub(add(qx, px), bx);
gy = sub(add(qy, py), by);
s = add(mul(ex, gx), mul(ey, gy));
nx = sub(mul(D, bx), mul(s, by));
ny = add(mul(D, by), mul(s, bx));
twice_D = 2 * D;
mx = sub(nx, mul(twice_D, px));
my = sub(ny, mul(twice_D, py));
kp = add(mul(px, sub(px, bx)), mul(py, sub(py, by)));
kq = add(mul(qx, sub(qx, bx)), mul(qy, sub(qy, by)));
incircle = add(mul(kp, ob), mul(kq, oa));

Eob = Ebx * Eqy - Eby * Eqx;
Eoa = Eby * Epx - Ebx * Epy;
ED = Eob + Eoa;
Es = (Eqx - Epx) * ((Eqx + Epx) - Ebx) + (Eqy - Epy) * ((Eqy + Epy) - Eby);
Enx = ED * Ebx - Es * Eby;
Eny = ED * Eby + Es * Ebx;
Emx = Enx - (2 * ED) * Epx;
Emy = Eny - (2 * ED) * Epy;
Ekp = Epx * (Epx - Ebx) + Epy * (Epy - Eby);
Ekq = Eqx * (Eqx - Ebx) + Eqy * (Eqy - Eby);
Eincircle = Ekp * Eob + Ekq * Eoa;

{
     |ux| <= 1 /\ |uy| <= 1 /\ |vx| <= 1 /\ |vy| <= 1
  /\ |ux - Eux| <= 1b-53 /\ |uy - Euy| <= 1b-53 /\ |vx - Evx| <= 1b-53 /\ |vy - Evy| <= 1b-53
  /\ |bx| <= 1 /\ |by| <= 1 /\ |px| <= 1 /\ |py| <= 1 /\ |qx| <= 1 /\ |qy| <= 1 /\ |ex| <= 1 /\ |ey| <= 1
  /\ |bx - Ebx| <= 1b-53 /\ |by - Eby| <= 1b-53 /\ |px - Epx| <= 1b-53 /\ |py - Epy| <= 1b-53
  /\ |qx - Eqx| <= 1b-53 /\ |qy - Eqy| <= 1b-53
  /\ |ex - (Eqx - Epx)| <= 1b-53 /\ |ey - (Eqy - Epy)| <= 1b-53
->
     |det - Edet| <= 9b-53                # bounds: orientation_2, refused at 8
  /\ |incircle - Eincircle| <= 177b-53    # bounds: annulus_2_incircle, refused at 176
  /\ |nx - Enx| <= 69b-53                 # bounds: annulus_2_inner, refused at 68
  /\ |ny - Eny| <= 69b-53                 # bounds: annulus_2_inner, refused at 68
  /\ |mx - Emx| <= 123b-53                # bounds: annulus_2_outer, refused at 122
  /\ |my - Emy| <= 123b-53                # bounds: annulus_2_outer, refused at 122
}

# Identities that keep the magnitudes small: D = b x e, and s = |q|^2 - |p|^2 - b.e.
ED -> Ebx * (Eqy - Epy) - Eby * (Eqx - Epx);
Es -> ((Eqx * Eqx - Epx * Epx) - Ebx * (Eqx - Epx)) + ((Eqy * Eqy - Epy * Epy) - Eby * (Eqy - Epy));
