(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The true half width of a bi-cell or triangle whose coordinates are doubles, and a decision of y <= half width by integers: it
   judges what the interval and the exact stage return. *)
From Coq Require Import Reals ZArith List Bool Lra Psatz.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import operations filter_2 integers_2.
From Annulus_link Require Import truth.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

(* y = Y c is at most the half width of the terms. *)
Definition below_half_width (t : width_terms integers) (Y : Z) : bool := at_most Y (determinant _ t) (inner _ t) (outer _ t).

Lemma below_half_width_spec : forall c g t t' Y, 0 < c -> 0 < g -> scaled_terms c g t t' ->
  (0 < determinant _ t)%Z -> (0 <= inner _ t)%Z -> (0 <= outer _ t)%Z -> (0 < inner _ t + outer _ t)%Z -> (0 <= Y)%Z ->
  (below_half_width t Y = true <-> IZR Y * c <= half_width t').
Proof.
  intros c g t t' Y Hc Hg (D & I & O) PD PI PO PS PY. unfold below_half_width.
  rewrite at_most_spec by (trivial; apply Z.lt_le_incl, PD).
  unfold half_width. rewrite D, I, O.
  apply IZR_le in PI, PO. apply IZR_lt in PD, PS. rewrite plus_IZR in PS.
  assert (RG : forall X, 0 <= X -> R_sqrt.sqrt (X * (g * g)) = R_sqrt.sqrt X * g)
    by (intros X HX; rewrite sqrt_mult, sqrt_square; try lra; nra).
  rewrite !RG by assumption.
  set (P := IZR (determinant _ t)) in *. set (A := IZR (inner _ t)) in *. set (B := IZR (outer _ t)) in *.
  assert (0 < R_sqrt.sqrt A + R_sqrt.sqrt B).
  { generalize (sqrt_pos A) (sqrt_pos B). intros. destruct (Rle_lt_or_eq_dec _ _ PI) as [L|L].
    - generalize (sqrt_lt_R0 A L). lra.
    - assert (L' : 0 < B) by lra. generalize (sqrt_lt_R0 B L'). lra. }
  set (S := R_sqrt.sqrt A + R_sqrt.sqrt B) in *.
  replace (P * (c * g) / (R_sqrt.sqrt A * g + R_sqrt.sqrt B * g)) with (P / S * c) by (unfold S in *; field; split; nra).
  split; intro H1.
  - apply Rmult_le_compat_r; [lra|]. apply Rmult_le_reg_r with S; [assumption|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
  - apply Rmult_le_reg_r in H1; [|assumption]. apply Rmult_le_compat_r with (r := S) in H1; [|lra].
    unfold Rdiv in H1. rewrite Rmult_assoc, Rinv_l in H1; lra.
Qed.

(* Judgement of answers: `sound` of a stage that may refuse, `sharp` of one that returns the
   largest double not above the truth. *)
Definition plain_float (f : float) : bool := match Prim2SF f with S754_zero false | S754_finite false _ _ => true | _ => false end.
Definition proper (t : width_terms integers) : bool :=
  ((0 <=? inner _ t) && (0 <=? outer _ t) && (0 <? inner _ t + outer _ t))%Z.
Definition is_zero (f : float) : bool := match Prim2SF f with S754_zero false => true | _ => false end.

Definition sound (t : width_terms integers) (k : Z) (a : answer float) : bool :=
  match a with
  | refused => true
  | negative y => (determinant _ t <? 0)%Z && is_zero y
  | zero y => (determinant _ t =? 0)%Z && is_zero y
  | positive y => (0 <? determinant _ t)%Z && proper t && plain_float y && (k <=? exponent y)%Z && below_half_width t (integer k y)
  end.
Definition sharp (t : width_terms integers) (k : Z) (a : answer float) : bool :=
  sound t k a &&
  match a with
  | refused => false
  | positive y => plain_float (PrimFloat.next_up y) && (k <=? exponent (PrimFloat.next_up y))%Z && negb (below_half_width t (integer k (PrimFloat.next_up y)))
  | _ => true
  end.

(* What the judgements say of real numbers. *)
Definition soundly (t : width_terms reals) (a : answer float) : Prop :=
  match a with
  | refused => True
  | negative y => determinant _ t < 0 /\ value y = 0
  | zero y => determinant _ t = 0 /\ value y = 0
  | positive y => 0 < determinant _ t /\ 0 <= value y <= half_width t
  end.
Definition sharply (t : width_terms reals) (a : answer float) : Prop :=
  soundly t a /\ match a with refused => False | positive y => half_width t < value (PrimFloat.next_up y) | _ => True end.

Lemma plain_integer : forall k f, plain_float f = true -> (k <= exponent f)%Z -> (0 <= integer k f)%Z.
Proof.
  intros k f. unfold plain_float, integer, exponent. destruct (Prim2SF f) as [[|]|s| |[|] m e]; intros H K; try easy.
  apply Z.mul_nonneg_nonneg; [easy|]. apply Z.pow_nonneg. easy.
Qed.

Lemma is_zero_value : forall f, is_zero f = true -> value f = 0.
Proof. intros f. unfold is_zero, value, Prim2B. rewrite B2R_SF2B. now destruct (Prim2SF f) as [[|]|s| |[|] m e]. Qed.

Section judgement.
Variables (k : Z) (g : R) (t : width_terms integers) (t' : width_terms reals).
Hypothesis Hg : 0 < g.
Hypothesis H : scaled_terms (bpow radix2 k) g t t'.

Lemma positive_factor : 0 < bpow radix2 k * g.
Proof. apply Rmult_lt_0_compat; [apply bpow_gt_0|exact Hg]. Qed.

Theorem sound_spec : forall a, sound t k a = true -> soundly t' a.
Proof.
  destruct H as (D & I & O). generalize positive_factor. intro F.
  intros [|f|f|f]; simpl; trivial; rewrite ?andb_true_iff, ?Z.ltb_lt, ?Z.eqb_eq.
  - intros [N Z]. split; [|apply is_zero_value, Z]. rewrite D. apply IZR_lt in N. nra.
  - intros [N Z]. split; [|apply is_zero_value, Z]. rewrite D, N. ring.
  - intros [[[[P Q] N] K] L]. apply Z.leb_le in K. unfold proper in Q. rewrite !andb_true_iff in Q.
    destruct Q as [[Q1 Q2] Q3]. apply Z.leb_le in Q1, Q2. apply Z.ltb_lt in Q3.
    assert (Y := plain_integer k f N K).
    split; [|split].
    + rewrite D. apply IZR_lt in P. nra.
    + rewrite (value_integer k f K). apply Rmult_le_pos; [apply IZR_le, Y|apply bpow_ge_0].
    + rewrite (value_integer k f K). apply (below_half_width_spec (bpow radix2 k) g t t'); trivial. apply bpow_gt_0.
Qed.

Theorem sharp_spec : forall a, sharp t k a = true -> sharply t' a.
Proof.
  intros a S. unfold sharp in S. apply andb_prop in S. destruct S as [S T]. split; [apply sound_spec, S|].
  destruct a as [|f|f|f]; trivial; [easy|].
  rewrite !andb_true_iff in T. destruct T as [[N K] L]. apply Z.leb_le in K. apply negb_true_iff in L.
  simpl in S. rewrite !andb_true_iff in S. destruct S as [[[[P Q] _] _] _]. apply Z.ltb_lt in P.
  unfold proper in Q. rewrite !andb_true_iff in Q. destruct Q as [[Q1 Q2] Q3]. apply Z.leb_le in Q1, Q2. apply Z.ltb_lt in Q3.
  apply Rnot_le_lt. intro M. rewrite (value_integer k _ K) in M.
  apply (below_half_width_spec (bpow radix2 k) g t t') in M; trivial; try congruence.
  - apply bpow_gt_0.
  - apply plain_integer; trivial.
Qed.
End judgement.

(* Tolerances of a row join the exponents, so that they are integers too; of each the next two doubles lie on the same grid. *)
Definition numbers_of (a : answer float) : list float :=
  match a with refused => [] | negative y | zero y | positive y => [y; PrimFloat.next_up y] end.

Definition judge_orientation (ax ay bx by' cx cy : float) (interval exact : answer float) : bool :=
  let k := common ([ax; ay; bx; by'; cx; cy] ++ numbers_of interval ++ numbers_of exact) in
  let t := orientation_of integers (integer_point k ax ay) (integer_point k bx by') (integer_point k cx cy) in
  sound t k interval && sharp t k exact.
Definition judge_annulus (ax ay bx by' px py qx qy : float) (interval exact : answer float) : bool :=
  let k := common ([ax; ay; bx; by'; px; py; qx; qy] ++ numbers_of interval ++ numbers_of exact) in
  let t := annulus_of integers (integer_point k ax ay) (integer_point k bx by') (integer_point k px py) (integer_point k qx qy) in
  sound t k interval && sharp t k exact.

Ltac member := apply common_le, in_or_app; left; simpl; tauto.

Theorem judge_orientation_spec : forall ax ay bx by' cx cy i e, judge_orientation ax ay bx by' cx cy i e = true ->
  let t := orientation_of reals (real_point ax ay) (real_point bx by') (real_point cx cy) in soundly t i /\ sharply t e.
Proof.
  intros ax ay bx by' cx cy i e J. unfold judge_orientation in J. apply andb_prop in J. destruct J as [I E].
  set (k := common _) in *. cbv zeta.
  assert (A : scaled_vector (bpow radix2 k) (integer_point k ax ay) (real_point ax ay)) by (apply scaled_point; member).
  assert (B : scaled_vector (bpow radix2 k) (integer_point k bx by') (real_point bx by')) by (apply scaled_point; member).
  assert (C : scaled_vector (bpow radix2 k) (integer_point k cx cy) (real_point cx cy)) by (apply scaled_point; member).
  assert (T := orientation_scaled _ _ _ _ _ _ _ (scaled_difference _ _ _ _ _ B A) (scaled_difference _ _ _ _ _ C A)
                                  (scaled_difference _ _ _ _ _ C B)).
  split; [eapply sound_spec|eapply sharp_spec]; try exact T; try eassumption; apply bpow_gt_0.
Qed.

Theorem judge_annulus_spec : forall ax ay bx by' px py qx qy i e, judge_annulus ax ay bx by' px py qx qy i e = true ->
  let t := annulus_of reals (real_point ax ay) (real_point bx by') (real_point px py) (real_point qx qy) in
  soundly t i /\ sharply t e.
Proof.
  intros ax ay bx by' px py qx qy i e J. unfold judge_annulus in J. apply andb_prop in J. destruct J as [I E].
  set (k := common _) in *. cbv zeta.
  assert (A : scaled_vector (bpow radix2 k) (integer_point k ax ay) (real_point ax ay)) by (apply scaled_point; member).
  assert (B : scaled_vector (bpow radix2 k) (integer_point k bx by') (real_point bx by')) by (apply scaled_point; member).
  assert (P : scaled_vector (bpow radix2 k) (integer_point k px py) (real_point px py)) by (apply scaled_point; member).
  assert (Q : scaled_vector (bpow radix2 k) (integer_point k qx qy) (real_point qx qy)) by (apply scaled_point; member).
  assert (T := annulus_scaled _ _ _ _ _ _ _ _ _ (scaled_difference _ _ _ _ _ B A) (scaled_difference _ _ _ _ _ P A)
                              (scaled_difference _ _ _ _ _ Q A) (scaled_difference _ _ _ _ _ Q P)).
  assert (0 < bpow radix2 k * bpow radix2 k * bpow radix2 k) by (rewrite <- !bpow_plus; apply bpow_gt_0).
  split; [eapply sound_spec|eapply sharp_spec]; try exact T; eassumption.
Qed.
