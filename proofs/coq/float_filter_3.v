(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter of a tetrahedron (orientation_filter of src/annulus/predicate/filtered_3.h), from coordinates to answer: signs are
   right, tolerances at most the exact half width. Also what float_sphere_3.v needs of computed differences. *)
Require Import Reals Lra Psatz ZArith List.
From Flocq Require Import Core.
From Annulus Require Import float_model float_error_sound float_tail float_filter float_terms_3 float_constants_3 float_width_3.
Import ListNotations.
Open Scope R_scope.

Definition F_point (a : vector R) : Prop := F (x a) /\ F (y a) /\ F (z a).
Definition F_difference (a b : vector R) : vector R := Vector (fsub (x a) (x b)) (fsub (y a) (y b)) (fsub (z a) (z b)).
Definition R_difference (a b : vector R) : vector R := Vector (x a - x b) (y a - y b) (z a - z b).
Definition magnitude (v : vector R) : R := Rmax (Rmax (Rabs (x v)) (Rabs (y v))) (Rabs (z v)).

(* ---- As the code has it ---- *)

Definition orientation_filter_3 (a b c d : vector R) (certified : bool) : option (Z * R) :=
  let u := F_difference b a in let v := F_difference c a in let w := F_difference d a in
  let m := Rmax (Rmax (magnitude u) (magnitude v)) (magnitude w) in
  if in_range_dec 100 m then decide_width (F_tetrahedron u v w) (F_slabs u v w) m certified else None.

(* ---- As it is meant ---- *)

Definition tetrahedron_det_truth a b c d := R_tetrahedron (R_difference b a) (R_difference c a) (R_difference d a).
Definition tetrahedron_slab_truth a b c d :=
  sqrt (largest R_square (R_slabs (R_difference b a) (R_difference c a) (R_difference d a))).

(* ---- Differences and what the constants say of them ---- *)

Lemma magnitude_bounds v K : magnitude v <= K -> Rabs (x v) <= K /\ Rabs (y v) <= K /\ Rabs (z v) <= K.
Proof.
  unfold magnitude. intro H. generalize (Rmax_l (Rmax (Rabs (x v)) (Rabs (y v))) (Rabs (z v)))
    (Rmax_r (Rmax (Rabs (x v)) (Rabs (y v))) (Rabs (z v))) (Rmax_l (Rabs (x v)) (Rabs (y v))) (Rmax_r (Rabs (x v)) (Rabs (y v))).
  lra.
Qed.

Lemma F_difference_point a b : F_point (F_difference a b).
Proof. repeat split; apply F_rnd. Qed.

Lemma F_magnitude v : F_point v -> F (magnitude v).
Proof. intros (X & Y & Z). repeat apply F_max; now apply F_abs. Qed.

Lemma difference_close a b m : F_point a -> F_point b -> magnitude (F_difference a b) <= m ->
  near_vector m (u * m) (F_difference a b) (R_difference a b).
Proof.
  intros (Xa & Ya & Za) (Xb & Yb & Zb) H. apply magnitude_bounds in H. destruct H as (HX & HY & HZ). generalize u_bounds. intro U.
  split; [| split]; (split; [assumption |]).
  - apply Rle_trans with (1 := rnd_sub_result _ _ Xa Xb). apply Rmult_le_compat_l; [lra | exact HX].
  - apply Rle_trans with (1 := rnd_sub_result _ _ Ya Yb). apply Rmult_le_compat_l; [lra | exact HY].
  - apply Rle_trans with (1 := rnd_sub_result _ _ Za Zb). apply Rmult_le_compat_l; [lra | exact HZ].
Qed.

Definition flat (l : list (vector R)) : list R := all_coordinates l.

Lemma flat_forall (P : R -> Prop) l : Forall (fun v => P (x v) /\ P (y v) /\ P (z v)) l -> Forall P (flat l).
Proof.
  intro H. induction H as [| v l (X & Y & Z) _ IH]; cbn; [constructor |].
  repeat (apply Forall_cons; [assumption |]). exact IH.
Qed.

Lemma flat_near m e l k : Forall2 (near_vector m e) l k ->
  Forall (fun a => Rabs a <= m) (flat l) /\ Forall2 (fun a b => Rabs (a - b) <= e) (flat l) (flat k).
Proof.
  intro H. induction H as [| v V l k ((X & X') & (Y & Y') & (Z & Z')) _ [IH IH']]; cbn; [split; constructor |].
  split.
  - repeat (apply Forall_cons; [assumption |]). exact IH.
  - repeat (apply Forall2_cons; [assumption |]). exact IH'.
Qed.

Section environment.
Variable m : R.
Hypothesis M : bpow radix2 (-120) <= m.
Variables l k : list (vector R).
Hypothesis l_format : Forall F_point l.
Hypothesis l_close : Forall2 (near_vector m (u * m)) l k.
Let s := env (flat l).
Let S := env (flat k).

Lemma env_format n : F (s n).
Proof. apply (env_all F); [exact F_0 |]. now apply flat_forall. Qed.

Lemma env_small n : Rabs (s n) <= m.
Proof.
  generalize (m_positive m M). intro M0.
  apply (env_all (fun a => Rabs a <= m)); [rewrite Rabs_R0; lra |]. exact (proj1 (flat_near _ _ _ _ l_close)).
Qed.

Lemma env_close n : Rabs (s n - S n) <= u * m.
Proof.
  generalize (m_positive m M) u_bounds. intros M0 U.
  apply (env_all_2 (fun a b => Rabs (a - b) <= u * m)); [rewrite Rminus_0_r, Rabs_R0; apply Rmult_le_pos; lra |].
  exact (proj2 (flat_near _ _ _ _ l_close)).
Qed.

Lemma env_hints : hints_hold m S hints_3.
Proof.
  apply hints_3_hold; [exact M |]. intro n. unfold exact_one. rewrite plus_IZR, Rmult_plus_distr_r, scale_one, scale_u.
  generalize (Rabs_triang (s n) (- (s n - S n))) (env_small n) (env_close n). rewrite Rabs_Ropp.
  replace (s n + - (s n - S n)) with (S n) by ring. lra.
Qed.

Lemma near d C E e : within d C E e = true ->
  Rabs (rounded s e) <= IZR C * m ^ d /\ Rabs (rounded s e - exact S e) <= IZR E / 2 * u * m ^ d.
Proof.
  intro W. generalize (error_below_sound m M S s env_format env_small env_close hints_3 e d _ _ _ env_hints W).
  rewrite units, half_units. tauto.
Qed.

Definition evaluated (f : expr -> R) (v : vector expr) : vector R := Vector (f (x v)) (f (y v)) (f (z v)).

Lemma near_vectors d C E vs : forallb (within d C E) (all_coordinates vs) = true ->
  Forall2 (near_vector (IZR C * m ^ d) (IZR E / 2 * u * m ^ d)) (map (evaluated (rounded s)) vs) (map (evaluated (exact S)) vs).
Proof.
  intro H. rewrite forallb_forall in H. induction vs as [| v vs IH]; [constructor |]. cbn [map]. apply Forall2_cons.
  - split; [| split]; apply near, H; cbn; auto.
  - apply IH. intros e I. apply H. cbn. auto.
Qed.
End environment.

(* A determinant that is positive has a norm that is. *)
Lemma largest_positive v slabs det : In v slabs -> (x v = 0 /\ y v = 0 /\ z v = 0 -> det <= 0) -> 0 < det ->
  0 < sqrt (largest R_square slabs).
Proof.
  intros I H P. apply Rlt_le_trans with (R_norm v); [| now apply sqrt_le_1_alt, largest_in].
  destruct (Rle_lt_or_eq_dec _ _ (sqrt_pos (R_square v))) as [L | Z]; [exact L | exfalso].
  symmetry in Z. apply R_norm_zero in Z. specialize (H Z). lra.
Qed.

Theorem orientation_filter_3_sound a b c d certified : F_point a -> F_point b -> F_point c -> F_point d ->
  sound (orientation_filter_3 a b c d certified) certified (tetrahedron_det_truth a b c d)
    (2 * tetrahedron_slab_truth a b c d).
Proof.
  intros Fa Fb Fc Fd. unfold orientation_filter_3. cbv zeta.
  set (v1 := F_difference b a). set (v2 := F_difference c a). set (v3 := F_difference d a).
  set (m := Rmax (Rmax (magnitude v1) (magnitude v2)) (magnitude v3)).
  destruct (in_range_dec 100 m) as [Range |]; [| discriminate].
  assert (M : bpow radix2 (-120) <= m).
  { apply (in_range_lower 100); [lia | | exact Range]. apply F_max; [apply F_max |]; apply F_magnitude, F_difference_point. }
  assert (B1 : magnitude v1 <= m) by (apply Rle_trans with (2 := Rmax_l _ _); apply Rmax_l).
  assert (B2 : magnitude v2 <= m) by (apply Rle_trans with (2 := Rmax_l _ _); apply Rmax_r).
  assert (B3 : magnitude v3 <= m) by apply Rmax_r.
  set (l := [v1; v2; v3]). set (k := [R_difference b a; R_difference c a; R_difference d a]).
  assert (lF : Forall F_point l) by (unfold l; each; apply F_difference_point).
  assert (lk : Forall2 (near_vector m (u * m)) l k) by (unfold l, k; each; now apply difference_close).
  apply decide_width_sound.
  - exact M.
  - apply F_rnd.
  - generalize constants_cells. intro K. rewrite forallb_forall in K.
    exact (proj2 (near m M l k lF lk 3 8 93 E_tetrahedron (K _ (or_introl eq_refl)))).
  - assert (K : forallb (within 2 16 69) (all_coordinates E_slabs) = true).
    { apply forallb_forall. intros e I. generalize constants_slabs. rewrite forallb_forall. intro K. apply K.
      unfold all_coordinates. rewrite map_app, concat_app. apply in_or_app. now left. }
    exact (near_vectors m M l k lF lk 2 16 69 E_slabs K).
  - apply largest_positive with (v := cross R Rminus Rmult (R_difference b a) (R_difference c a)); [now left |].
    intros (X & Y & Z). unfold tetrahedron_det_truth, R_tetrahedron, tetrahedron_det, dot. rewrite X, Y, Z. lra.
Qed.
