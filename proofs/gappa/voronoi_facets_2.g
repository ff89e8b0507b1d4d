# SPDX-License-Identifier: GPL-3.0-or-later
# Error of the length of a Voronoi facet in src/annulus/measure/voronoi_facets.h in the plane, for its order of
# operations. Model and notation are those of circumcentre_2.g.
@mul = mul_rel<53>;

# x: a coordinate of the rounded difference of the two circumcentres. What these are off themselves is not in here:
# voronoi_facets.h adds it. Squares are positive, so that their sum is as good as they are.
square = mul(mul(x, x), one);
length = mul(sqrt(square), one);
Esquare = Ex * Ex * one;
Elength = sqrt(Esquare) * one;

{
     x -/ Ex in [-1b-53, 1b-53] /\ one in [1, 1]
  /\ x * x in [1b-1000, 1b1000] /\ Esquare in [1b-1000, 1b1000] /\ Elength <> 0
->
     |(length - Elength) / Elength| <= 4b-53    # bounds: facet_length_2, refused at 3
}
