(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A placement in space times k > 0, and which half widths certify.

   - det_scaled, Lam_scaled, volume_scaled      determinants: k^5 and k^3 times
   - half_width_scaled, simplex_scaled          half widths: k times
   - certified_width, certified_width_is        what the filtered predicate takes of them, by Cell_widths (filtered_3.h) *)
From Coq Require Import Reals Lra.
From Annulus Require Import vectors bicell tetrahedron sign_tolerance_3 filter_3 returned_3.
Import vectors bicell tetrahedron.
Open Scope R_scope.

Section scale.
Variable k : R.
Hypothesis positive : 0 < k.
Definition scaled {I} (x : I -> vec) : I -> vec := fun i => k ⊙ x i.
Let k3 := k * k * k.
Let k4 := k * k * k * k.

Lemma powers_positive : 0 < k * k /\ 0 < k3 /\ 0 < k4.
Proof. unfold k3, k4. repeat split; repeat apply Rmult_lt_0_compat; exact positive. Qed.

Lemma ratio K d e : 0 < K -> k * K * d / (K * e) = k * (d / e).
Proof. intro P. unfold Rdiv. rewrite Rinv_mult. replace (k * K * d * (/ K * / e)) with (k * (d * / e) * (K * / K)) by ring. rewrite Rinv_r by lra. ring. Qed.
Lemma norm_longer K v : 0 < K -> norm (K ⊙ v) = K * norm v.
Proof. intro P. now rewrite norm_scale, Rabs_pos_eq by lra. Qed.

Section bicell.
Variable x : placement.

Lemma rel_scaled i : rel (scaled x) i = k ⊙ rel x i.
Proof. unfold rel, scaled. vector. Qed.
Lemma vol_scaled r s t : vol (k ⊙ r) (k ⊙ s) (k ⊙ t) = k3 * vol r s t.
Proof. unfold k3. vector. Qed.
Lemma sq_scaled r : sq (k ⊙ r) = k * k * sq r.
Proof. vector. Qed.
Lemma cross_longer r s : (k ⊙ r) ✕ (k ⊙ s) = (k * k) ⊙ (r ✕ s).
Proof. vector. Qed.
Lemma lambda_scaled i : lambda (scaled x) i = k3 * lambda x i.
Proof. destruct i; unfold lambda, lambda_b, lambda_c, lambda_p, lambda_q; rewrite !rel_scaled, !vol_scaled; ring. Qed.
Lemma det_scaled : det (scaled x) = k * k4 * det x.
Proof. unfold k4, det, lambda_b, lambda_c, lambda_p, lambda_q. rewrite !rel_scaled, !vol_scaled, !sq_scaled. unfold k3. ring. Qed.
Lemma twice_centre_scaled r s t : twice_centre (k ⊙ r) (k ⊙ s) (k ⊙ t) = k4 ⊙ twice_centre r s t.
Proof. unfold twice_centre, k4. rewrite !sq_scaled, !cross_longer. generalize (sq r) (sq s) (sq t) (s ✕ t) (t ✕ r) (r ✕ s). vector. Qed.
Lemma U_scaled i : U (scaled x) i = k4 ⊙ U x i.
Proof.
  destruct i; unfold U, U_b, U_c, U_p, U_q; rewrite !rel_scaled, !twice_centre_scaled; generalize k4 (twice_centre (rel x c) (rel x p) (rel x q))
    (twice_centre (rel x b) (rel x p) (rel x q)) (twice_centre (rel x b) (rel x c) (rel x q)) (twice_centre (rel x b) (rel x c) (rel x p)); vector.
Qed.
Lemma Lam_scaled B : Lam (scaled x) B = k3 * Lam x B.
Proof.
  unfold Lam, sum, among. rewrite !lambda_scaled. assert (I : forall i, (if B i then k3 * lambda x i else 0) = k3 * (if B i then lambda x i else 0))
    by (intro; destruct (B i); ring). rewrite !I. ring.
Qed.
Lemma N_scaled B : N (scaled x) B = k4 ⊙ N x B.
Proof.
  unfold N, vsum, vamong. rewrite !U_scaled. assert (I : forall i, (if B i then k4 ⊙ U x i else zero) = k4 ⊙ (if B i then U x i else zero))
    by (intro i; destruct (B i); [reflexivity|vector]). rewrite !I.
  generalize k4 (if B a then U x a else zero) (if B b then U x b else zero) (if B c then U x c else zero) (if B p then U x p else zero)
    (if B q then U x q else zero). vector.
Qed.
Lemma arm_scaled B i : arm (scaled x) B i = k4 ⊙ arm x B i.
Proof. unfold arm. rewrite N_scaled, Lam_scaled, rel_scaled. unfold k3, k4. generalize (N x B) (Lam x B) (rel x i). vector. Qed.
Theorem half_width_scaled B i j : half_width (scaled x) B i j = k * half_width x B i j.
Proof.
  destruct powers_positive as (_ & _ & P). unfold half_width, arms. rewrite det_scaled, !arm_scaled, !norm_longer, <- Rmult_plus_distr_l by exact P. now apply ratio.
Qed.
End bicell.

Section simplex.
Variable y : corners.
Let k2 := k * k.
Lemma volume_scaled : volume (scaled y) = k3 * volume y.
Proof. unfold volume, scaled, k3. generalize (y o) (y u) (y v) (y w). vector. Qed.
Lemma cross_scaled i j h : (scaled y i ⊖ scaled y h) ✕ (scaled y j ⊖ scaled y h) = k2 ⊙ ((y i ⊖ y h) ✕ (y j ⊖ y h)).
Proof. unfold k2. rewrite <- cross_longer. unfold scaled. f_equal; vector. Qed.
Lemma largest_scaled : largest (scaled y) = k2 * largest y.
Proof.
  destruct powers_positive as (P & _ & _). unfold largest. rewrite !cross_scaled.
  assert (A : forall m n, k2 ⊙ m ⊕ k2 ⊙ n = k2 ⊙ (m ⊕ n)) by vector. rewrite !A, !norm_longer by exact P. rewrite !RmaxRmult by (unfold k2; lra). reflexivity.
Qed.
Theorem simplex_scaled : half_width_simplex (scaled y) = k * half_width_simplex y.
Proof.
  destruct powers_positive as (P & _ & _). unfold half_width_simplex. rewrite volume_scaled, largest_scaled.
  replace (2 * (k2 * largest y)) with (k2 * (2 * largest y)) by ring. replace k3 with (k * k2) by (unfold k2, k3; ring). now apply ratio.
Qed.
End simplex.
End scale.

(* ---- Which half widths are taken ---- *)

Definition certified_width (use : cells) (x : placement) : R :=
  match use with never => annuli_half_width x | where_needed => own_tolerance_3 x | always => tolerance_3 x end.

(* With the cells wherever they are requested, and where one of three sides is not certainly positive. *)
Theorem certified_width_is (use : cells) (taken : bool) x s : (use = always -> taken = true) ->
  (use = where_needed -> taken = false -> 0 < Lam x cpq /\ 0 < Lam x bpq /\ 0 < Lam x apq) ->
  s <= annuli_half_width x -> (taken = true -> s <= cells_half_width x) -> s <= certified_width use x.
Proof.
  intros Al Wh An Ce. assert (T : taken = true -> s <= tolerance_3 x) by (intro E; apply Rmin_glb; auto).
  destruct use; simpl; auto. unfold own_tolerance_3. destruct Rle_dec as [L|L]; [exact An|]. destruct taken; [auto|]. exfalso. apply L.
  destruct (Wh eq_refl eq_refl) as (? & ? & ?). repeat apply Rmin_glb; lra.
Qed.
