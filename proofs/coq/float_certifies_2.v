(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Floating point and geometry together in the plane: what the filter stage returns is a tolerance of sign_tolerance_2.v. Over rounded reals;
   returned_2.v says of primitive floats that it certifies.

   - triangle_bound   an answer 1: the triangle is positive, and the number at most half its least altitude; -1: it is negative
   - circle_bound     an answer 1: the circle is empty, and the number at most half the width; -1: it is not *)
Require Import Reals Lra ZArith Rgeom.
From Annulus Require Import float_model float_filter float_terms_2 float_filter_2 float_circle_2 vectors width_2 sign_tolerance_2.
From Annulus Require float_width_3.
Open Scope R_scope.

Lemma side_is x y x' y' : sqrt (R_side (x' - x) (y' - y)) = dist_euc x y x' y'.
Proof. unfold dist_euc, R_side, side_square, squared, Rsqr. f_equal. ring. Qed.

Theorem triangle_bound ax ay bx by' cx cy sign v : F ax -> F ay -> F bx -> F by' -> F cx -> F cy ->
  orientation_filter ax ay bx by' cx cy true = Some (sign, v) ->
  sign = 1%Z /\ 0 < turn ax ay bx by' cx cy /\ 0 <= v <= half_altitude ax ay bx by' cx cy \/ sign = (-1)%Z /\ turn ax ay bx by' cx cy < 0.
Proof.
  intros F1 F2 F3 F4 F5 F6 A. generalize (orientation_filter_sound ax ay bx by' cx cy true F1 F2 F3 F4 F5 F6 sign v A).
  change (orientation_truth ax ay bx by' cx cy) with (turn ax ay bx by' cx cy).
  assert (E : sqrt (longest_truth ax ay bx by' cx cy) = Rmax (Rmax (dist_euc ax ay bx by') (dist_euc ax ay cx cy)) (dist_euc bx by' cx cy))
    by (unfold longest_truth; now rewrite !float_width_3.sqrt_max, !side_is).
  rewrite E. unfold half_altitude. replace (2 * Rmax _ _) with (Rmax (Rmax (dist_euc ax ay bx by') (dist_euc ax ay cx cy)) (dist_euc bx by' cx cy) +
    Rmax (Rmax (dist_euc ax ay bx by') (dist_euc ax ay cx cy)) (dist_euc bx by' cx cy)) by ring.
  tauto.
Qed.

Section circle.
Variables ax ay bx by' px py qx qy : R.
Let t := circle_truth ax ay bx by' px py qx qy.

Lemma circle_determinant : float_terms_2.incircle t = width_2.incircle ax ay bx by' px py qx qy.
Proof. unfold t, circle_truth, R_annulus, annulus_terms, width_2.incircle, turn. cbn [float_terms_2.incircle]. ring. Qed.

Lemma circle_norms : sqrt (inner t) = norm (annulus_N ax ay bx by' px py qx qy) /\ sqrt (outer t) = norm (annulus_M ax ay bx by' px py qx qy).
Proof.
  unfold norm, sq, dot, annulus_M, annulus_N, annulus_D, annulus_s, sub, scale. cbn [X1 X2 X3].
  unfold t, circle_truth, R_annulus, annulus_terms, squared. cbn [inner outer]. split; f_equal; ring.
Qed.

Theorem circle_bound sign v : F ax -> F ay -> F bx -> F by' -> F px -> F py -> F qx -> F qy ->
  circle_filter ax ay bx by' px py qx qy true = Some (sign, v) ->
  sign = 1%Z /\ 0 < width_2.incircle ax ay bx by' px py qx qy /\ 0 <= v <= half_width_2 ax ay bx by' px py qx qy \/
  sign = (-1)%Z /\ width_2.incircle ax ay bx by' px py qx qy < 0.
Proof.
  intros F1 F2 F3 F4 F5 F6 F7 F8 A. generalize (circle_filter_sound ax ay bx by' px py qx qy true F1 F2 F3 F4 F5 F6 F7 F8 sign v A).
  fold t. rewrite circle_determinant, (proj1 circle_norms), (proj2 circle_norms). unfold half_width_2.
  rewrite (Rplus_comm (norm (annulus_M _ _ _ _ _ _ _ _))). tauto.
Qed.
End circle.
