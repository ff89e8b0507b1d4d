# SPDX-License-Identifier: GPL-3.0-or-later
# Error of the area of a Voronoi facet in src/annulus/measure/voronoi_facets.h in space, for its order of operations.
# Model and notation are those of circumcentre_2.g.
@mul = mul_rel<53>;

# e: the edge, f: another coordinate of it, rounded differences; p, r: two corners of the facet relative to another.
# What these are off themselves is not in here: voronoi_facets.h adds it. A term of e . (p x r) / |e|, over the
# magnitudes |p| |r| of all of them, of which |e| is not a factor. Squares are positive, so that their sum is as good as
# they are.
minor = mul(mul(py, rz), one);
twice = mul(mul(mul(ex, minor), one), one);
square = mul(mul(mul(fx, fx), one), one);
length = mul(sqrt(square), one);
area = mul(twice / length, one);
Etwice = Eex * (py * rz * one) * one * one;
Esquare = Efx * Efx * one * one;
Elength = sqrt(Esquare) * one;
Earea = Etwice / Elength * one;

{
     ex -/ Eex in [-1b-53, 1b-53] /\ fx -/ Efx in [-1b-53, 1b-53] /\ one in [1, 1]
  /\ fx * fx in [1b-800, 16] /\ Esquare in [1b-800, 16] /\ Elength <> 0 /\ length <> 0 /\ Earea <> 0
->
     |(area - Earea) / Earea| <= 11b-53    # bounds: facet_area_3, refused at 10
}
