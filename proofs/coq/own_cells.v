(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Why sign_tolerance_3_own asks for more where Lam < 0 for a partition: the half widths of the four annuli alone, with both cells known to be
   positive at the reference and at the placement, do not certify. Found by a random search; integers. *)
Require Import Reals Lra Psatz.
From Annulus Require Import sign_tolerance_3.
Open Scope R_scope.

Definition reference : placement := fun k => match k with
  | a => V 28 (-8) (-9) | b => V (-74) (-125) (-23) | c => V 131 92 (-1) | p => V 18 34 0 | q => V (-13) (-6) 2 end.
Definition moved_to : placement := fun k => match k with
  | a => V 34 (-14) (-7) | b => V (-78) (-122) (-15) | c => V 125 85 1 | p => V 20 25 3 | q => V (-16) (-7) (-7) end.

Ltac numbers := cbv beta iota delta [det Lam N sum vsum among vamong pq cpq bpq apq lambda lambda_b lambda_c lambda_p lambda_q
  U U_b U_c U_p U_q twice_centre rel reference moved_to vol sq dot cross add sub scale zero X1 X2 X3]; lra.

Ltac side := match goal with |- @eq bool _ _ => reflexivity | |- @eq vec _ _ => apply vec_eq; numbers | _ => numbers end.

Lemma wide B i j L n K1 K2 : B i = false -> B j = true -> Lam reference B = L -> N reference B = n -> 0 <= K1 -> 0 <= K2 ->
  sq (n ⊖ (2 * L) ⊙ rel reference i) <= K1 * K1 -> sq (n ⊖ (2 * L) ⊙ rel reference j) <= K2 * K2 ->
  10 * (K1 + K2) < 1640741984 -> 10 < half_width reference B i j.
Proof.
  intros Hi Hj HL HN P1 P2 S1 S2 H.
  assert (D : det reference = 1640741984) by numbers.
  assert (A := arms_pos reference B i j Hi Hj). rewrite D in A. specialize (A ltac:(lra)).
  unfold half_width. rewrite D. apply Rmult_lt_reg_r with (1 := A).
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. unfold arms, arm. rewrite HL, HN.
  assert (K : forall v t, 0 <= t -> sq v <= t * t -> norm v <= t).
  { intros v t H0 Hv. unfold norm. rewrite <- (sqrt_square t) by exact H0. now apply sqrt_le_1_alt. }
  generalize (K _ _ P1 S1) (K _ _ P2 S2). lra.
Qed.

Theorem own_cells_needed : exists x y s,
  0 < lambda x p /\ 0 < lambda x q /\ 0 < det x /\          (* the reference: cells positive, sphere empty *)
  s < annuli_half_width x /\                                 (* the least of the four half widths *)
  (forall k, norm (y k ⊖ x k) < s) /\                        (* every point closer than that *)
  0 < lambda y p /\ 0 < lambda y q /\ det y < 0.            (* the cells positive again, the sphere not empty *)
Proof.
  exists reference, moved_to, 10. repeat match goal with |- _ /\ _ => split end; try numbers.
  - unfold annuli_half_width. repeat apply Rmin_glb_lt.
    + apply (wide pq a p 14358 (V 28980146 (-24129566) (-34396938)) 51041495 51956379); side.
    + apply (wide cpq a c 53171 (V 16586865 (-16450743) (-75613837)) 79140403 81315208); side.
    + apply (wide bpq a b 47806 (V 37069162 (-28460870) 2032094) 46778984 50020222); side.
    + apply (wide apq b a (-72261) (V 4304265 (-3347519) 4787867) 22954366 7256463); side.
  - intro k. unfold norm. rewrite <- (sqrt_square 10) by lra. apply sqrt_lt_1_alt.
    split; [apply sq_nonneg|]. destruct k; numbers.
Qed.
