# SPDX-License-Identifier: GPL-3.0-or-later
# Errors of numerator and denominator of src/annulus/measure/circumcentre.cpp in space, for its order of operations.
# Model and notation are those of circumcentre_2.g.
@mul = mul_rel<53>;

# b, c, e: three corners relative to the fourth, rounded differences.
# A term of the numerator, bx bx cy ez: the square, in two sums, times a product that is in a difference, in two sums.
# The magnitudes of nine such products are added up.
square = mul(mul(mul(bx, bx), one), one);
minor = mul(mul(cy, ez), one);
numerator = mul(mul(mul(square, minor), one), one) * one * one * one * one * one * one;
size_n = mul(mul(mul(mul(mul(mul(mul(mul(mul(square, minor), one), one), one), one), one), one), one), one);
Enumerator = (Ebx * Ebx * one * one * (Ecy * Eez * one)) * one * one * one * one * one * one * one * one;

# A term of the denominator, bx cy ez; the magnitudes of three such products are added up.
denominator = mul(mul(mul(bx, minor), one), one);
Edenominator = Ebx * (Ecy * Eez * one) * one * one;

{
     bx -/ Ebx in [-1b-53, 1b-53] /\ cy -/ Ecy in [-1b-53, 1b-53] /\ ez -/ Eez in [-1b-53, 1b-53] /\ one in [1, 1]
  /\ Enumerator <> 0 /\ size_n <> 0 /\ Edenominator <> 0 /\ denominator <> 0
->
     |(numerator - Enumerator) / size_n| <= 16b-53    # bounds: circumcentre_3_numerator, refused at 12
  /\ |(denominator - Edenominator) / denominator| <= 10b-53    # bounds: circumcentre_3_denominator, refused at 8
}

(numerator - Enumerator) / size_n -> ((numerator - Enumerator) / Enumerator) / (1 + (size_n - Enumerator) / Enumerator) { Enumerator <> 0, size_n <> 0 };
(denominator - Edenominator) / denominator -> ((denominator - Edenominator) / Edenominator) / (1 + (denominator - Edenominator) / Edenominator) { Edenominator <> 0, denominator <> 0 };
