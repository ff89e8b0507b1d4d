(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The formulas of the code over the reals (filter_2.v), of differences of points times a scale: determinant, roots and half width of the geometry,
   times powers of it. The later stages have such a scale; it is 1 in the geometry.

   - triangle_terms, circle_terms    determinant and sum of the roots
   - triangle_half, circle_half      half the width of scaled terms is the scale times half the least altitude, half the width *)
From Coq Require Import Reals Lra ZArith Rgeom.
From Annulus Require float_width_3 float_circle_2 float_certifies_2.
From Annulus Require Import operations vectors width_2 sign_tolerance_2 filter_2 integers_2.
Open Scope R_scope.

Definition scaled_by (k ax ay bx by' : R) : vector reals := {| x := (bx - ax) * k : number reals; y := (by' - ay) * k : number reals |}.

Lemma sqrt_scaled k z : 0 <= k -> 0 <= z -> R_sqrt.sqrt (k * k * z) = k * R_sqrt.sqrt z.
Proof. intros K Z. rewrite sqrt_mult by (trivial; nra). now rewrite sqrt_square. Qed.

Section scale.
Variable k : R.
Hypothesis positive : 0 < k.

Section triangle.
Variables ax ay bx by' cx cy : R.
Let t := orientation_terms reals (scaled_by k ax ay bx by') (scaled_by k ax ay cx cy) (scaled_by k bx by' cx cy).
Let longest := Rmax (Rmax (dist_euc ax ay bx by') (dist_euc ax ay cx cy)) (dist_euc bx by' cx cy).

Lemma side_scaled x y x' y' : R_sqrt.sqrt ((x' - x) * k * ((x' - x) * k) + (y' - y) * k * ((y' - y) * k)) = k * dist_euc x y x' y'.
Proof.
  unfold dist_euc, Rsqr. rewrite <- sqrt_scaled; [f_equal; ring|lra|]. generalize (Rle_0_sqr (x - x')) (Rle_0_sqr (y - y')). unfold Rsqr. lra.
Qed.

Lemma triangle_terms : determinant _ t = k * k * turn ax ay bx by' cx cy /\
  0 <= inner _ t /\ 0 <= outer _ t /\ R_sqrt.sqrt (inner _ t) + R_sqrt.sqrt (outer _ t) = k * (2 * longest).
Proof.
  split; [unfold t, orientation_terms, turn; simpl; ring|].
  assert (I : 0 <= inner _ t) by (simpl; apply Rle_trans with (2 := Rmax_r _ _); match goal with |- 0 <= ?a * ?a + ?b * ?b => generalize (Rle_0_sqr a) (Rle_0_sqr b); unfold Rsqr; lra end).
  split; [exact I|]. split; [exact I|]. change (outer _ t) with (inner _ t). simpl. rewrite !float_width_3.sqrt_max, !side_scaled, !RmaxRmult by lra.
  unfold longest. ring.
Qed.

Lemma longest_positive : turn ax ay bx by' cx cy <> 0 -> 0 < longest.
Proof.
  intro T. assert (P : forall u v u' v', 0 <= dist_euc u v u' v') by (intros; apply sqrt_pos).
  destruct (Rle_lt_or_eq_dec 0 (dist_euc ax ay bx by') (P _ _ _ _)) as [L|L].
  - apply Rlt_le_trans with (1 := L). unfold longest. apply Rle_trans with (2 := Rmax_l _ _), Rmax_l.
  - exfalso. apply T. symmetry in L. generalize (Rle_0_sqr (ax - bx)) (Rle_0_sqr (ay - by')). intros Q Q'. apply sqrt_eq_0 in L; [|lra].
    assert (ax = bx) as -> by (apply Rminus_diag_uniq, Rsqr_0_uniq; lra). assert (ay = by') as -> by (apply Rminus_diag_uniq, Rsqr_0_uniq; lra).
    unfold turn. ring.
Qed.

Theorem triangle_half : 0 < turn ax ay bx by' cx cy -> half_width t = half_altitude ax ay bx by' cx cy * k /\
  0 < R_sqrt.sqrt (inner _ t) + R_sqrt.sqrt (outer _ t).
Proof.
  intro T. assert (L := longest_positive ltac:(lra)). unfold half_width, half_altitude. fold longest.
  destruct triangle_terms as (-> & _ & _ & ->). split; [field; lra|]. apply Rmult_lt_0_compat; lra.
Qed.
End triangle.

Section circle.
Variables ax ay bx by' px py qx qy : R.
Let t := annulus_terms reals (scaled_by k ax ay bx by') (scaled_by k ax ay px py) (scaled_by k ax ay qx qy) (scaled_by k px py qx qy).
Let M := annulus_M ax ay bx by' px py qx qy.
Let N := annulus_N ax ay bx by' px py qx qy.

Lemma circle_terms : determinant _ t = k * k * (k * k) * width_2.incircle ax ay bx by' px py qx qy /\
  0 <= inner _ t /\ 0 <= outer _ t /\ R_sqrt.sqrt (inner _ t) + R_sqrt.sqrt (outer _ t) = k * k * k * (norm M + norm N).
Proof.
  assert (K3 : 0 <= k * k * k) by (repeat apply Rmult_le_pos; lra).
  assert (I : inner _ t = k * k * k * (k * k * k) * sq N).
  { unfold t, annulus_terms, scaled_by, squared, N, annulus_N, annulus_D, annulus_s, sq, dot. cbn [inner X1 X2 X3]. simpl. ring. }
  assert (O : outer _ t = k * k * k * (k * k * k) * sq M).
  { unfold t, annulus_terms, scaled_by, squared, M, annulus_M, annulus_N, annulus_D, annulus_s, sub, scale, sq, dot. cbn [outer X1 X2 X3]. simpl. ring. }
  split; [unfold t, annulus_terms, scaled_by, width_2.incircle, turn; cbn [determinant]; simpl; ring|].
  rewrite I, O, !sqrt_scaled by (trivial; apply sq_nonneg). fold (norm N) (norm M).
  assert (0 <= k * k * k * (k * k * k)) by now apply Rmult_le_pos.
  split; [apply Rmult_le_pos; [assumption|apply sq_nonneg]|]. split; [apply Rmult_le_pos; [assumption|apply sq_nonneg]|ring].
Qed.

Lemma norms_together : 0 < width_2.incircle ax ay bx by' px py qx qy -> 0 < norm M + norm N.
Proof.
  rewrite <- float_certifies_2.circle_determinant. intro H.
  assert (P := float_circle_2.norms_positive (bx - ax) (by' - ay) (px - ax) (py - ay) (qx - ax) (qy - ay)). cbv zeta in P.
  replace (qx - ax - (px - ax)) with (qx - px) in P by ring. replace (qy - ay - (py - ay)) with (qy - py) in P by ring.
  specialize (P H). change (float_terms_2.R_annulus _ _ _ _ _ _ _ _) with (float_circle_2.circle_truth ax ay bx by' px py qx qy) in P.
  rewrite (proj1 (float_certifies_2.circle_norms _ _ _ _ _ _ _ _)), (proj2 (float_certifies_2.circle_norms _ _ _ _ _ _ _ _)) in P.
  unfold M, N. lra.
Qed.

Theorem circle_half : 0 < width_2.incircle ax ay bx by' px py qx qy -> half_width t = half_width_2 ax ay bx by' px py qx qy * k /\
  0 < R_sqrt.sqrt (inner _ t) + R_sqrt.sqrt (outer _ t).
Proof.
  intro H. assert (L := norms_together H). unfold half_width, half_width_2. fold M N. destruct circle_terms as (-> & _ & _ & ->).
  assert (K3 : 0 < k * k * k) by (repeat apply Rmult_lt_0_compat; lra). split; [field; lra|]. now apply Rmult_lt_0_compat.
Qed.
End circle.
End scale.
