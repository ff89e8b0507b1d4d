(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter of the empty sphere in space, float_sphere_3.v, is right.

   - bicell_filter_sound   signs are right; a certified tolerance is at most the exact half width of each of the four annuli, and of the two
     cells where they are asked for; a partition that is not reported as on the wrong side has a positive sum of lambda
   - bicell_answer_sound   an answer was given in the range of the filter

   In this order: the two cells, the sums of lambda, the norms of one partition, all four annuli, the answer. *)
Require Import Reals Lra Psatz ZArith List Bool.
From Flocq Require Import Core.
From Annulus Require Import float_model float_error float_tail float_filter float_terms_3 float_constants_3 float_width_3
  float_filter_3 float_sphere_3.
Import ListNotations.
Open Scope R_scope.

(* ---- From coordinates ---- *)

Section coordinates.
Variables a b c p q : vector R.
Variables (certified : bool) (use : cells).
Hypotheses (Fa : F_point a) (Fb : F_point b) (Fc : F_point c) (Fp : F_point p) (Fq : F_point q).
Let t := bicell_truth a b c p q.
Let f := bicell_computed a b c p q.
Let m := bicell_m a b c p q.
Hypothesis Range : in_range 100 m.

Let v1 := F_difference b a. Let v2 := F_difference c a. Let v3 := F_difference p a. Let v4 := F_difference q a.
Let w1 := R_difference b a. Let w2 := R_difference c a. Let w3 := R_difference p a. Let w4 := R_difference q a.
Let l := [v1; v2; v3; v4].
Let k := [w1; w2; w3; w4].
Let s := env (flat l).
Let S := env (flat k).

Lemma m_large : bpow radix2 (-120) <= m.
Proof.
  apply (in_range_lower 100); [lia | | exact Range].
  apply F_max; apply F_max; apply F_magnitude, F_difference_point.
Qed.
Lemma m_pos : 0 < m.
Proof. exact (m_positive m m_large). Qed.

Lemma l_format : Forall F_point l.
Proof. unfold l. each; apply F_difference_point. Qed.

Lemma l_close : Forall2 (near_vector m (u * m)) l k.
Proof.
  assert (B1 : magnitude v1 <= m) by (apply Rle_trans with (2 := Rmax_l _ _); apply Rmax_l).
  assert (B2 : magnitude v2 <= m) by (apply Rle_trans with (2 := Rmax_l _ _); apply Rmax_r).
  assert (B3 : magnitude v3 <= m) by (apply Rle_trans with (2 := Rmax_r _ _); apply Rmax_l).
  assert (B4 : magnitude v4 <= m) by (apply Rle_trans with (2 := Rmax_r _ _); apply Rmax_r).
  unfold l, k. each; now apply difference_close.
Qed.

(* A computed number, and the vectors of a list, with the constants of float_constants_3.v. *)
Let number_near := near m m_large l k l_format l_close.
Let vectors_near := near_vectors m m_large l k l_format l_close.

(* ---- The two cells ---- *)

Lemma cells_near : Rabs (cell_p f - cell_p t) <= 93 / 2 * u * m ^ 3 /\ Rabs (cell_q f - cell_q t) <= 93 / 2 * u * m ^ 3.
Proof.
  generalize constants_cells. intro K. rewrite forallb_forall in K. split.
  - exact (proj2 (number_near 3 8 93 (cell_p E_bicell) (K _ (or_intror (or_introl eq_refl))))).
  - exact (proj2 (number_near 3 8 93 (cell_q E_bicell) (K _ (or_intror (or_intror (or_introl eq_refl)))))).
Qed.

Lemma slabs_near es : (forall e, In e es -> In e (E_slabs ++ slabs_p E_bicell ++ slabs_q E_bicell)) ->
  Forall2 (near_vector (16 * m ^ 2) (69 / 2 * u * m ^ 2)) (map (evaluated (rounded s)) es) (map (evaluated (exact S)) es).
Proof.
  intro I. apply (vectors_near 2 16 69). apply forallb_forall. intros e J.
  generalize constants_slabs. rewrite forallb_forall. intro K. apply K.
  unfold all_coordinates in *. apply in_concat in J. destruct J as (d & J & J'). apply in_concat.
  apply in_map_iff in J. destruct J as (v & <- & J). exists (coordinates v). split; [| exact J']. apply in_map. now apply I.
Qed.

Lemma slabs_p_positive : 0 < cell_p t -> 0 < sqrt (largest R_square (slabs_p t)).
Proof.
  apply largest_positive with (v := vopp R Ropp (cross R Rminus Rmult w1 w2)); [now left |].
  intros (X & Y & Z). cbn [x y z vopp] in X, Y, Z.
  change (cell_p t) with (- dot R Rplus Rmult (cross R Rminus Rmult w1 w2) w3).
  set (n := cross R Rminus Rmult w1 w2) in *. unfold dot.
  replace (x n) with 0 by lra. replace (y n) with 0 by lra. replace (z n) with 0 by lra. lra.
Qed.
Lemma slabs_q_positive : 0 < cell_q t -> 0 < sqrt (largest R_square (slabs_q t)).
Proof.
  apply largest_positive with (v := cross R Rminus Rmult w1 w2); [now left |].
  intros (X & Y & Z). change (cell_q t) with (dot R Rplus Rmult (cross R Rminus Rmult w1 w2) w4).
  unfold dot. rewrite X, Y, Z. lra.
Qed.

Lemma cell_p_right : sound (decide_width (cell_p f) (slabs_p f) m certified) certified (cell_p t) (2 * sqrt (largest R_square (slabs_p t))).
Proof.
  apply decide_width_sound; [exact m_large | apply F_opp, F_rnd | exact (proj1 cells_near) | | exact slabs_p_positive].
  apply (slabs_near (slabs_p E_bicell)). intros. apply in_or_app. right. apply in_or_app. now left.
Qed.
Lemma cell_q_right : sound (decide_width (cell_q f) (slabs_q f) m certified) certified (cell_q t) (2 * sqrt (largest R_square (slabs_q t))).
Proof.
  apply decide_width_sound; [exact m_large | apply F_rnd | exact (proj2 cells_near) | | exact slabs_q_positive].
  apply (slabs_near (slabs_q E_bicell)). intros. apply in_or_app. right. apply in_or_app. now right.
Qed.

(* ---- The sums of lambda ---- *)

Lemma sum_positive e C : In e [l1 E_bicell; l2 E_bicell; l3 E_bicell; minus_l4 E_bicell] ->
  rounded s e = C -> error_bound 169 (power_3 m) < C -> 0 < exact S e.
Proof.
  intros I E L. generalize constants_sides. intro K. rewrite forallb_forall in K.
  destruct (number_near 3 32 337 e (K _ I)) as [_ H]. fold s S in H. rewrite E in H. apply Rabs_le_inv in H.
  generalize m_large m_pos u_bounds. intros M M0 U. assert (P3 : bpow radix2 (-360) <= m ^ 3) by exact (pow_large m M 3).
  generalize (bpow_gt_0 radix2 (-360)). intro B.
  destruct (error_bound_range m M 169 _ 3 ltac:(lia) ltac:(lia) (widen m M _ _ 4 4 ltac:(lra) ltac:(lra) (power_3_range m M))) as [SL _].
  assert (337 / 2 * u * m ^ 3 <= 169 * u * (1 - 8 * u) * m ^ 3) by (apply Rmult_le_compat_r; [lra | unfold u; lra]).
  lra.
Qed.

Lemma sides_right :
  (on_wrong_side a b c p q l2 = false -> 0 < l2 t) /\
  (on_wrong_side a b c p q l3 = false -> 0 < l3 t) /\
  (on_wrong_side a b c p q minus_l4 = false -> 0 < minus_l4 t).
Proof.
  unfold on_wrong_side. split; [| split]; destruct Rlt_dec as [L |]; try discriminate; intros _.
  - exact (sum_positive (l2 E_bicell) _ (or_intror (or_introl eq_refl)) eq_refl L).
  - exact (sum_positive (l3 E_bicell) _ (or_intror (or_intror (or_introl eq_refl))) eq_refl L).
  - exact (sum_positive (minus_l4 E_bicell) _ (or_intror (or_intror (or_intror (or_introl eq_refl)))) eq_refl L).
Qed.

(* ---- The norms of one partition ---- *)

Let w := u * m ^ 4.
Let e := error_bound 1105 (power_5 m).
Let n := error_bound 3246 (power_4 m).

Lemma m4_large : bpow radix2 (-480) <= m ^ 4.
Proof. exact (pow_large m m_large 4). Qed.
Lemma m4_pos : 0 < m ^ 4.
Proof. generalize m4_large (bpow_gt_0 radix2 (-480)). lra. Qed.
Lemma w_pos : 0 <= w.
Proof. generalize m4_pos u_bounds. intros. apply Rmult_le_pos; lra. Qed.
Lemma tiny_small : tiny <= / 5 * w.
Proof.
  generalize m4_large u_bounds (bpow_gt_0 radix2 (-480)). intros P U B.
  apply Rle_trans with (bpow radix2 (-3) * (u * bpow radix2 (-480))).
  - change u with (bpow radix2 (-53)). rewrite <- !bpow_plus. apply bpow_le. lia.
  - apply mul_below; [apply bpow_ge_0 | apply Rmult_le_pos; lra | change (bpow radix2 (-3)) with (/ 8); lra |].
    apply Rmult_le_compat_l; lra.
Qed.

Lemma n_range : 32455 / 10 * w <= n <= 1 * m ^ 4.
Proof.
  generalize m_large m4_pos u_bounds. intros M M4 U.
  destruct (error_bound_range m M 3246 _ 4 ltac:(lia) ltac:(lia) (widen m M _ _ 4 4 ltac:(lra) ltac:(lra) (power_4_range m M))) as [L H].
  split.
  - unfold w. rewrite <- Rmult_assoc. apply Rle_trans with (2 := L). apply Rmult_le_compat_r; [lra | unfold u; lra].
  - apply Rle_trans with (1 := H). apply Rmult_le_compat_r; [lra | unfold u; lra].
Qed.

(* Computed norms against exact ones, from the errors of both: (L - 3244.25 w) (1 - 2 u)^2, less what underflows. *)
Lemma partition_arithmetic G r : 0 <= G -> (1 - 2 * u) * ((1 - 2 * u) * (G - 324425 / 100 * w) - 2 * tiny) <= r -> (1 - 10 * u) * G <= r + n.
Proof.
  intros G0 D. generalize w_pos tiny_small tiny_pos (proj1 n_range) u_bounds. intros W T T0 N U.
  assert (0 <= u * w) by (apply Rmult_le_pos; lra). assert (0 <= u * (u * w)) by (apply Rmult_le_pos; lra).
  assert (u * w <= / 100000 * w) by (apply Rmult_le_compat_r; lra).
  assert (u * (u * w) <= 1 * (u * w)) by (apply Rmult_le_compat_r; lra).
  assert (0 <= u * G) by (apply Rmult_le_pos; lra). assert (0 <= u * (u * G)) by (apply Rmult_le_pos; lra).
  assert (u * (u * G) <= 1 * (u * G)) by (apply Rmult_le_compat_r; lra).
  assert (0 <= u * tiny) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma partition_norms g h G H : near_vector (64 * m ^ 4) (1381 / 2 * u * m ^ 4) g G -> near_vector (128 * m ^ 4) (2365 / 2 * u * m ^ 4) h H ->
  (1 - 10 * u) * (R_norm G + R_norm H) <= norm_sum g h + n /\ 0 <= norm_sum g h <= 2048 * m ^ 4.
Proof.
  intros HG HH. generalize m4_large m4_pos w_pos tiny_small u_bounds (bpow_gt_0 radix2 (-480)). intros P4 M4 W T U B.
  assert (big : bpow radix2 (-500) <= 64 * m ^ 4) by (apply Rle_trans with (bpow radix2 (-480)); [apply bpow_le; lia | lra]).
  assert (E1 : 0 <= 1381 / 2 * u * m ^ 4) by (apply Rmult_le_pos; lra).
  assert (E2 : 0 <= 2365 / 2 * u * m ^ 4) by (apply Rmult_le_pos; lra).
  assert (big' : bpow radix2 (-500) <= 128 * m ^ 4) by lra.
  generalize (F_norm_lower _ _ _ _ E1 HG) (F_norm_lower _ _ _ _ E2 HH) (F_norm_upper _ _ _ _ big HG) (F_norm_upper _ _ _ _ big' HH).
  generalize (root_sum_range (F_square g) (F_square h) (F_rnd _) (F_rnd _)).
  fold (F_norm g) (F_norm h). fold (norm_sum g h). intros [RL RH] LG LH UG UH.
  assert (0 <= F_norm g) by apply sqrt_pos. assert (0 <= F_norm h) by apply sqrt_pos.
  split; [| split; [apply Rle_trans with (2 := RL); apply Rmult_le_pos |]; lra].
  apply partition_arithmetic; [apply Rplus_le_le_0_compat; apply sqrt_pos |]. apply Rle_trans with (2 := RL).
  apply Rmult_le_compat_l; [lra |].
  replace (1381 / 2 * u * m ^ 4) with (1381 / 2 * w) in LG by (unfold w; ring).
  replace (2365 / 2 * u * m ^ 4) with (2365 / 2 * w) in LH by (unfold w; ring).
  assert (0 <= u * w) by (apply Rmult_le_pos; lra). assert (u * w <= / 1000 * w) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(* ---- All four ---- *)

Let roots := Rmax (Rmax (norm_sum (n1 f) (m1 f)) (norm_sum (n2 f) (m2 f))) (Rmax (norm_sum (n3 f) (m3 f)) (norm_sum (n4 f) (m4 f))).

(* Each partition: its computed norms bound the exact ones, and roots is not below them. *)
Let covers (T : R) : Prop := (1 - 10 * u) * T <= roots + n.

Lemma roots_cover :
  (covers (R_norm (n1 t) + R_norm (m1 t)) /\ covers (R_norm (n2 t) + R_norm (m2 t)) /\
   covers (R_norm (n3 t) + R_norm (m3 t)) /\ covers (R_norm (n4 t) + R_norm (m4 t))) /\
  F roots /\ 0 <= roots <= 2048 * m ^ 4.
Proof.
  assert (HN : Forall2 (near_vector (64 * m ^ 4) (1381 / 2 * u * m ^ 4)) [n1 f; n2 f; n3 f; n4 f] [n1 t; n2 t; n3 t; n4 t])
    by exact (vectors_near 4 64 1381 _ constants_n).
  assert (HM : Forall2 (near_vector (128 * m ^ 4) (2365 / 2 * u * m ^ 4)) [m1 f; m2 f; m3 f; m4 f] [m1 t; m2 t; m3 t; m4 t])
    by exact (vectors_near 4 128 2365 _ constants_m).
  apply forall2_4 in HN, HM. destruct HN as (N1 & N2 & N3 & N4). destruct HM as (M1 & M2 & M3 & M4).
  generalize (partition_norms _ _ _ _ N1 M1) (partition_norms _ _ _ _ N2 M2) (partition_norms _ _ _ _ N3 M3) (partition_norms _ _ _ _ N4 M4).
  intros [A1 R1] [A2 R2] [A3 R3] [A4 R4]. unfold covers.
  assert (Q1 : norm_sum (n1 f) (m1 f) <= roots) by (apply Rle_trans with (2 := Rmax_l _ _); apply Rmax_l).
  assert (Q2 : norm_sum (n2 f) (m2 f) <= roots) by (apply Rle_trans with (2 := Rmax_l _ _); apply Rmax_r).
  assert (Q3 : norm_sum (n3 f) (m3 f) <= roots) by (apply Rle_trans with (2 := Rmax_r _ _); apply Rmax_l).
  assert (Q4 : norm_sum (n4 f) (m4 f) <= roots) by (apply Rle_trans with (2 := Rmax_r _ _); apply Rmax_r).
  assert (Qm : roots <= 2048 * m ^ 4) by (repeat apply Rmax_lub; tauto).
  split; [repeat split; lra |]. split; [apply F_max; apply F_max; apply F_rnd | lra].
Qed.

Lemma annulus_right T : (0 < determinant t -> 0 < T) -> covers T -> sound (decide (determinant f) roots e n certified) certified (determinant t) T.
Proof.
  intros HT HR. destruct roots_cover as (_ & FR & R0 & RH). generalize m_large m_pos m4_pos u_bounds n_range w_pos. intros M M0 M4 U [NL NH] W.
  assert (P5 : bpow radix2 (-600) <= m ^ 5) by exact (pow_large m M 5). generalize (bpow_gt_0 radix2 (-600)). intro B.
  destruct (error_bound_range m M 1105 _ 5 ltac:(lia) ltac:(lia) (widen m M _ _ 5 6 ltac:(lra) ltac:(lra) (power_5_range m M))) as [EL _].
  fold e in EL.
  assert (E0 : u * m ^ 5 <= e) by (apply Rle_trans with (2 := EL); apply Rmult_le_compat_r; [lra | unfold u; lra]).
  assert (HD : Rabs (determinant f - determinant t) <= 2209 / 2 * u * m ^ 5)
    by exact (proj2 (number_near 5 128 2209 (determinant E_bicell) constants_determinant)).
  apply decide_sound; try assumption.
  - apply F_rnd.
  - apply F_error_bound.
  - apply F_error_bound.
  - apply Rlt_le_trans with (2 := E0). apply Rmult_lt_0_compat; lra.
  - lra.
  - apply Rle_trans with (1 := HD). apply Rle_trans with (2 := EL). apply Rmult_le_compat_r; [lra | unfold u; lra].
  - apply Rle_trans with (2 := E0). apply Rle_trans with (bpow radix2 (-900) * (4096 * m ^ 4)).
    + apply Rmult_le_compat_l; [apply bpow_ge_0 | lra].
    + replace (u * m ^ 5) with (u * m * m ^ 4) by ring. rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [lra |].
      apply Rle_trans with (u * bpow radix2 (-120)).
      * change u with (bpow radix2 (-53)). change 4096 with (bpow radix2 12). rewrite <- !bpow_plus. apply bpow_le. lia.
      * apply Rmult_le_compat_l; lra.
Qed.

Lemma annuli_right sign value : decide (determinant f) roots e n certified = Some (sign, value) ->
  sign = 1%Z /\ 0 < determinant t /\ (certified = true -> 0 <= value /\
    value <= determinant t / (R_norm (n1 t) + R_norm (m1 t)) /\
    value <= determinant t / (R_norm (n2 t) + R_norm (m2 t)) /\
    value <= determinant t / (R_norm (n3 t) + R_norm (m3 t)) /\
    value <= determinant t / (R_norm (n4 t) + R_norm (m4 t)))
  \/ sign = (-1)%Z /\ determinant t < 0.
Proof.
  intro A. generalize (annuli_positive w1 w2 w3 w4). change (R_bicell w1 w2 w3 w4) with t. intros (T1 & T2 & T3 & T4).
  destruct roots_cover as ((C1 & C2 & C3 & C4) & _).
  generalize (annulus_right _ T1 C1 _ _ A) (annulus_right _ T2 C2 _ _ A) (annulus_right _ T3 C3 _ _ A) (annulus_right _ T4 C4 _ _ A).
  intros [(? & ? & Y1) | N] [(? & ? & Y2) | ?] [(? & ? & Y3) | ?] [(? & ? & Y4) | ?]; try (right; assumption).
  left. split; [assumption |]. split; [assumption |]. intro C.
  specialize (Y1 C). specialize (Y2 C). specialize (Y3 C). specialize (Y4 C). tauto.
Qed.

(* ---- The answer ---- *)

Theorem bicell_filter_sound :
  bicell_sound (bicell_filter a b c p q certified use) certified (cells_needed a b c p q use) t /\
  (on_wrong_side a b c p q l2 = false -> 0 < l2 t) /\
  (on_wrong_side a b c p q l3 = false -> 0 < l3 t) /\
  (on_wrong_side a b c p q minus_l4 = false -> 0 < minus_l4 t).
Proof.
  split; [| exact sides_right]. intros sign value A. unfold bicell_filter in A. fold m f e n roots in A.
  destruct (in_range_dec 100 m) as [_ |]; [| discriminate].
  destruct (cells_needed a b c p q use).
  - destruct in_doubt; [discriminate |]. apply both_some in A. destruct A as [(A & N) | (-> & v & w' & A & A' & ->)].
    + apply both_some in A. destruct A as [(A & _) | (-> & _)]; [| congruence].
      destruct (annuli_right _ _ A) as [(? & _) | ?]; [congruence | now right].
    + apply both_some in A. destruct A as [(_ & N) | (_ & v' & w'' & A & A'' & ->)]; [congruence |].
      destruct (annuli_right _ _ A) as [(_ & D & C) | (? & _)]; [| discriminate].
      destruct (cell_p_right _ _ A'') as [(_ & Dp & Cp) | (? & _)]; [| discriminate].
      destruct (cell_q_right _ _ A') as [(_ & Dq & Cq) | (? & _)]; [| discriminate].
      left. split; [reflexivity |]. split; [exact D |]. split; [tauto |]. intro CC.
      specialize (C CC). specialize (Cp CC). specialize (Cq CC).
      generalize (Rmin_l (Rmin v' w'') w') (Rmin_r (Rmin v' w'') w') (Rmin_l v' w'') (Rmin_r v' w''). intros.
      assert (0 <= Rmin (Rmin v' w'') w') by (repeat apply Rmin_glb; tauto).
      repeat split; try lra; try assumption.
  - destruct (annuli_right _ _ A) as [(-> & D & C) | ?]; [| now right].
    left. split; [reflexivity |]. split; [exact D |]. split; [discriminate |]. intro CC. specialize (C CC).
    destruct C as (C0 & C1 & C2 & C3 & C4). repeat (split; [assumption |]). discriminate.
Qed.
End coordinates.

Theorem bicell_answer_sound a b c p q certified use :
  F_point a -> F_point b -> F_point c -> F_point p -> F_point q ->
  bicell_sound (bicell_filter a b c p q certified use) certified (cells_needed a b c p q use) (bicell_truth a b c p q).
Proof.
  intros Fa Fb Fc Fp Fq sign value A. generalize A. intro A'. unfold bicell_filter in A'.
  destruct (in_range_dec 100 (bicell_m a b c p q)) as [I |]; [clear A' | discriminate].
  exact (proj1 (bicell_filter_sound a b c p q certified use Fa Fb Fc Fp Fq I) sign value A).
Qed.
