# SPDX-License-Identifier: GPL-3.0-or-later
# Forward errors of the products of src/annulus/measure/voronoi_terms.h in space, for its order of operations.
# Model and notation are those of certificates_2.g.
@mul = mul_rel<53>;
@add = add_rel<53>;
@sub = sub_rel<53>;

# e, f: two edges of the facet; d: from one circumcentre to the other, rounded differences all of them; x: the first
# circumcentre. What x is off itself, and the two that d is of, is not in here: voronoi_terms.h adds it.
wx = sub(mul(xy, dz), mul(xz, dy));
wy = sub(mul(xz, dx), mul(xx, dz));
wz = sub(mul(xx, dy), mul(xy, dx));
e_w = add(add(mul(ex, wx), mul(ey, wy)), mul(ez, wz));
nx = sub(mul(ey, fz), mul(ez, fy));
ny = sub(mul(ez, fx), mul(ex, fz));
nz = sub(mul(ex, fy), mul(ey, fx));
g = add(add(mul(dx, nx), mul(dy, ny)), mul(dz, nz));

Ewx = xy * Edz - xz * Edy;
Ewy = xz * Edx - xx * Edz;
Ewz = xx * Edy - xy * Edx;
Ee_w = (Eex * Ewx + Eey * Ewy) + Eez * Ewz;
Enx = Eey * Efz - Eez * Efy;
Eny = Eez * Efx - Eex * Efz;
Enz = Eex * Efy - Eey * Efx;
Eg = (Edx * Enx + Edy * Eny) + Edz * Enz;

{
     |xx| <= 1 /\ |xy| <= 1 /\ |xz| <= 1
  /\ |dx| <= 1 /\ |dy| <= 1 /\ |dz| <= 1
  /\ |dx - Edx| <= 1b-53 /\ |dy - Edy| <= 1b-53 /\ |dz - Edz| <= 1b-53
  /\ |ex| <= 1 /\ |ey| <= 1 /\ |ez| <= 1
  /\ |ex - Eex| <= 1b-53 /\ |ey - Eey| <= 1b-53 /\ |ez - Eez| <= 1b-53
  /\ |fx| <= 1 /\ |fy| <= 1 /\ |fz| <= 1
  /\ |fx - Efx| <= 1b-53 /\ |fy - Efy| <= 1b-53 /\ |fz - Efz| <= 1b-53
->
     |e_w - Ee_w| <= 41b-53    # bounds: voronoi_3_edge, refused at 40
  /\ |g - Eg| <= 47b-53        # bounds: voronoi_3_facet, refused at 46
}
