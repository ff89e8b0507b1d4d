# SPDX-License-Identifier: GPL-3.0-or-later
# Errors of numerator and denominator of src/annulus/measure/circumcentre.cpp in the plane, for its order of operations,
# term by term: what is computed is the sum of the terms below, each as it stands here, because the rounding of a sum
# multiplies each of its terms by the same 1 + d, |d| <= 2^-53. So `mul(t, one)` is how a sum rounds its term t, and the
# sum is off by the bound below times the sum of the magnitudes of its terms. The code adds these up in doubles, too;
# `size` is what becomes of a term there. Underflow is not in the model: `lost` in the code.
@mul = mul_rel<53>;

# b, c: two corners relative to the third, rounded differences.
# A term of the numerator, bx bx cy: the square, in a sum of two squares, times a coordinate, in a difference of two
# products. `* one` is exact; it makes both true terms the same polynomial.
square = mul(mul(bx, bx), one);
numerator = mul(mul(square, cy), one) * one;
size_n = mul(mul(square, mul(cy, one)), one);
Enumerator = Ebx * Ebx * one * Ecy * one * one;
Esize_n = Ebx * Ebx * one * (Ecy * one) * one;

# A term of the denominator, bx cy.
denominator = mul(mul(bx, cy), one);
Edenominator = Ebx * Ecy * one;

{
     bx -/ Ebx in [-1b-53, 1b-53] /\ cy -/ Ecy in [-1b-53, 1b-53] /\ one in [1, 1]
  /\ Enumerator <> 0 /\ Esize_n <> 0 /\ size_n <> 0 /\ Edenominator <> 0 /\ denominator <> 0
->
     |(numerator - Enumerator) / size_n| <= 8b-53    # bounds: circumcentre_2_numerator, refused at 7
  /\ |(denominator - Edenominator) / denominator| <= 6b-53    # bounds: circumcentre_2_denominator, refused at 4
}

(numerator - Enumerator) / size_n -> ((numerator - Enumerator) / Enumerator) / (1 + (size_n - Esize_n) / Esize_n) { Enumerator <> 0, Esize_n <> 0, size_n <> 0 };
(denominator - Edenominator) / denominator -> ((denominator - Edenominator) / Edenominator) / (1 + (denominator - Edenominator) / Edenominator) { Edenominator <> 0, denominator <> 0 };
