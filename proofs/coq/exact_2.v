(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The exact stage in the plane: src/annulus/predicate/filtered_2.cpp and src/annulus/arithmetic/exact.cpp. A sign by integers; a tolerance by MPFR's
   numbers of 128 bits, each operation rounded in the direction that makes the quotient smaller, and where a double may lie between it and the truth
   a comparison by integers. MPFR's numbers are Flocq's of 128 bits: that it rounds correctly is its promise. Exponents go to 2^14, which no
   number of the coordinate domain needs (MPFR's go to 2^62); what is proved does not depend on that, since overflow is rounded like the rest. *)
From Coq Require Import ZArith List Bool Lia.
From Flocq Require Import IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import operations filter_2 interval_2 integers_2.
Import ListNotations.
Close Scope float_scope.

Definition bits : Z := 128.
Definition exponents : Z := 16384.
Notation real := (binary_float bits exponents).
#[export] Instance bits_pos : FLX.Prec_gt_0 bits := eq_refl Lt.
#[export] Instance exponents_large : Prec_lt_emax bits exponents := eq_refl Lt.

Definition of_integer (m : mode) (n e : Z) : real := BinarySingleNaN.binary_normalize bits exponents bits_pos exponents_large m n e false.
(* mpfr_get_d, rounded downward; and back, which is exact. *)
Definition double_below (x : real) : double :=
  match x with
  | B754_finite s m e _ => BinarySingleNaN.binary_normalize prec emax (eq_refl Lt) (eq_refl Lt) mode_DN (if s then Z.neg m else Z.pos m) e false
  | B754_zero s => B754_zero s | B754_infinity s => B754_infinity s | B754_nan => B754_nan
  end.
Definition real_of (y : double) : real :=
  match y with
  | B754_finite s m e _ => of_integer mode_DN (if s then Z.neg m else Z.pos m) e
  | B754_zero s => B754_zero s | B754_infinity s => B754_infinity s | B754_nan => B754_nan
  end.

(* y <= numerator 2^exponent / (sqrt a + sqrt b), for a finite y that is not negative. *)
Definition is_at_least (numerator a b exponent : Z) (y : double) : bool :=
  match y with
  | B754_zero _ => true
  | B754_finite false m of_y _ =>
      let shift := (exponent - of_y)%Z in
      let n := if (0 <=? shift)%Z then (numerator * 2 ^ shift)%Z else numerator in
      let z := if (0 <=? shift)%Z then Z.pos m else (Z.pos m * 2 ^ (- shift))%Z in
      let z2 := (z * z)%Z in
      let r := (n * n - z2 * (a + b))%Z in
      (0 <=? r)%Z && (4 * z2 * z2 * a * b <=? r * r)%Z
  | _ => false
  end.

Definition root_above (a : Z) : real := Bsqrt mode_UP (of_integer mode_UP a 0).
Definition quotient_by_roots_lower (numerator a b exponent : Z) : double :=
  let roots := Bplus mode_UP (root_above a) (root_above b) in
  let result := Bldexp mode_DN (Bdiv mode_DN (of_integer mode_DN numerator 0) roots) exponent in
  let lower := double_below result in
  let next := Bsucc (prec := prec) (emax := emax) (prec_gt_0_ := eq_refl Lt) (prec_lt_emax_ := eq_refl Lt) lower in
  if negb (BinarySingleNaN.is_finite next) then lower
  else if Bltb (Bmult mode_UP result (of_integer mode_UP (2 ^ 120 + 1) (-120))) (real_of next) then lower
  else if is_at_least numerator a b exponent next then next else lower.

Definition exact_verdict (t : width_terms integers) (k : Z) : answer float :=
  let det := determinant _ t : Z in
  if (det <? 0)%Z then negative 0%float else if (det =? 0)%Z then filter_2.zero 0%float
  else positive (to_float (quotient_by_roots_lower det (inner _ t) (outer _ t) k)).

Definition numbers (l : list (vector machine)) : list float := flat_map (fun v : vector machine => [x machine v : float; y machine v : float]) l.
Definition to_integers (k : Z) (v : vector machine) : vector integers := integer_point k (x machine v) (y machine v).
Definition orientation_exact (a b c : vector machine) : answer float :=
  let k := common (numbers [a; b; c]) in exact_verdict (orientation_of integers (to_integers k a) (to_integers k b) (to_integers k c)) k.
Definition empty_sphere_exact (a b p q : vector machine) : answer float :=
  let k := common (numbers [a; b; p; q]) in
  exact_verdict (annulus_of integers (to_integers k a) (to_integers k b) (to_integers k p) (to_integers k q)) k.
