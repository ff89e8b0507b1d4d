(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Why sign_tolerance_3_own requires more where Lam < 0 for a partition: the half widths of the four annuli alone, with both cells known to be
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

(* Its parts, each from smaller ones. *)
Lemma reference_rel : rel reference b = V (-102) (-117) (-14) /\ rel reference c = V 103 100 8 /\
  rel reference p = V (-10) 42 9 /\ rel reference q = V (-41) 2 11.
Proof. repeat split; side. Qed.
Lemma reference_lambda : lambda_b reference = 33448 /\ lambda_c reference = 38813 /\ lambda_p reference = 85 /\ lambda_q reference = 14273.
Proof.
  destruct reference_rel as (B & C & P & Q). unfold lambda_b, lambda_c, lambda_p, lambda_q. rewrite B, C, P, Q. repeat split; numbers.
Qed.
Lemma reference_U : U_b reference = V 8089016 (-4331304) 36429032 /\
  U_c reference = V (-12393281) 7678823 (-41216899) /\
  U_p reference = V 53194567 (-71678193) 211317013 /\
  U_q reference = V (-24214421) 47548627 (-245713951).
Proof.
  destruct reference_rel as (B & C & P & Q). unfold U_b, U_c, U_p, U_q. rewrite B, C, P, Q. repeat split; side.
Qed.

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
  - destruct reference_rel as (Rb & Rc & Rp & Rq). destruct reference_lambda as (Lb & Lc & Lp & Lq). destruct reference_U as (Ub & Uc & Up & Uq).
    assert (Ra := rel_a reference). unfold annuli_half_width.
    repeat apply Rmin_glb_lt;
      [apply (wide pq a p 14358 (V 28980146 (-24129566) (-34396938)) 51041495 51956379); [reflexivity|reflexivity|rewrite (proj1 (abc_pq _))|rewrite (proj2 (abc_pq _))|..]
      |apply (wide cpq a c 53171 (V 16586865 (-16450743) (-75613837)) 79140403 81315208); [reflexivity|reflexivity|rewrite (proj1 (ab_cpq _))|rewrite (proj2 (ab_cpq _))|..]
      |apply (wide bpq a b 47806 (V 37069162 (-28460870) 2032094) 46778984 50020222); [reflexivity|reflexivity|rewrite (proj1 (ca_bpq _))|rewrite (proj2 (ca_bpq _))|..]
      |apply (wide apq b a (-72261) (V 4304265 (-3347519) 4787867) 22954366 7256463); [reflexivity|reflexivity|rewrite (proj1 (bc_apq _))|rewrite (proj2 (bc_apq _))|..]];
      rewrite ?Lb, ?Lc, ?Lp, ?Lq, ?Ub, ?Uc, ?Up, ?Uq; try apply vec_eq; rewrite ?Ra, ?Rb, ?Rc, ?Rp, ?Rq; numbers.
  - intro k. unfold norm. rewrite <- (sqrt_square 10) by lra. apply sqrt_lt_1_alt.
    split; [apply sq_nonneg|]. destruct k; numbers.
Qed.
