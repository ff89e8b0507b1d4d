# SPDX-License-Identifier: GPL-3.0-or-later
# Forward error of the term of src/annulus/measure/voronoi_terms.h in the plane, for its order of operations.
# Model and notation are those of certificates_2.g.
@mul = mul_rel<53>;
@sub = sub_rel<53>;

# e: the edge; d: from one circumcentre to the other, rounded differences both. What the circumcentres are off
# themselves is not in here: voronoi_terms.h adds it.
term = sub(mul(dx, ey), mul(dy, ex));
Eterm = Edx * Eey - Edy * Eex;

{
     |dx| <= 1 /\ |dy| <= 1 /\ |ex| <= 1 /\ |ey| <= 1
  /\ |dx - Edx| <= 1b-53 /\ |dy - Edy| <= 1b-53 /\ |ex - Eex| <= 1b-53 /\ |ey - Eey| <= 1b-53
->
     |term - Eterm| <= 9b-53    # bounds: voronoi_2, refused at 8
}
