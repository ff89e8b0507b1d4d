(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The exact stage in space: exact_3.v is right, for all finite doubles.

   - orientation_3_exact_returned, empty_sphere_3_exact_returned   a sign is right, 0 included; a tolerance is at most the half widths; there is always
                                                                   an answer *)
From Coq Require Import Reals Lra Lia ZArith List Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import vectors bicell tetrahedron sign_tolerance_3.
From Annulus Require Import operations bridge connect filter_2 stages interval_2 integers_2 integers_3 exact_2 exact_3.
From Annulus Require Import real_terms_3 scaled_3 returned_2 returned_3 exact_returned_2 interval_returned_3.
Import ListNotations vectors bicell tetrahedron filter_3.
Close Scope float_scope.
Open Scope R_scope.

Lemma common_numbers_3 l v' : In v' l -> (common (numbers_3 l) <= exponent (x3 _ v'))%Z /\ (common (numbers_3 l) <= exponent (y3 _ v'))%Z /\
  (common (numbers_3 l) <= exponent (z3 _ v'))%Z.
Proof. intro I. split; [|split]; apply common_le, in_flat_map; exists v'; simpl; auto. Qed.

Lemma integers_stand_3 l v' w' : In v' l -> In w' l -> degrees (common (numbers_3 l)) 1
  (difference_3 integers (to_integers_3 (common (numbers_3 l)) v') (to_integers_3 (common (numbers_3 l)) w')) (to_reals (at_3 v' ⊖ at_3 w')).
Proof.
  intros V W. destruct (common_numbers_3 l v' V) as (A & B & C), (common_numbers_3 l w' W) as (D & E & F).
  exact (v_difference _ _ _ _ _ _ (degrees_point _ _ _ _ A B C) (degrees_point _ _ _ _ D E F)).
Qed.

Section orientation.
Variable f : corner -> vector_3 machine.
Let x : corners := fun k => at_3 (f k).

Theorem orientation_3_exact_returned :
  right_answer (orientation_3_exact (f o) (f tetrahedron.u) (f v) (f w)) (volume x) (half_width_simplex x) /\
  orientation_3_exact (f o) (f tetrahedron.u) (f v) (f w) <> refused.
Proof.
  unfold orientation_3_exact. cbv zeta. set (l := [f o; f tetrahedron.u; f v; f w]). set (k := common (numbers_3 l)).
  assert (I : forall c, In (f c) l) by (intros []; simpl; tauto).
  assert (D := degree_scaled k 2 _ _ (tetrahedron_degrees k _ _ _ _ _ _ (integers_stand_3 l _ _ (I tetrahedron.u) (I o)) (integers_stand_3 l _ _ (I v) (I o))
    (integers_stand_3 l _ _ (I w) (I o)))).
  destruct (tetrahedron_half x) as (V & In & Out & H). rewrite <- V. apply (verdict_right _ _ k _ _ _ eq_refl (pow_lt _ 2 (bpow_gt_0 radix2 k)) D In Out).
  intro P. apply H. rewrite <- V. exact P.
Qed.
End orientation.

(* A half width of a bi-cell: 0 where its determinant is not positive. *)
Lemma half_width_lower_right k g t t' h : 0 < g -> scaled_terms (bpow radix2 k) g t t' -> 0 <= inner _ t' -> 0 <= outer _ t' ->
  (0 < determinant _ t' -> half t' = h /\ 0 < R_sqrt.sqrt (inner _ t') + R_sqrt.sqrt (outer _ t')) ->
  is_finite (half_width_lower t k) = true /\ 0 <= B2R (half_width_lower t k) /\ (0 < determinant _ t' -> B2R (half_width_lower t k) <= h).
Proof.
  intros G D I O H. destruct (verdict_right _ g k t t' h eq_refl G D I O H) as [R _]. revert R. unfold exact_verdict, half_width_lower. cbv zeta.
  destruct D as (D & _). assert (P : 0 < bpow radix2 k * g) by (apply Rmult_lt_0_compat; [apply bpow_gt_0|exact G]).
  destruct (Z.ltb_spec 0 (determinant _ t)) as [L|L].
  - replace (determinant integers t <? 0)%Z with false by (symmetry; apply Z.ltb_ge; lia).
    replace (determinant integers t =? 0)%Z with false by (symmetry; apply Z.eqb_neq; lia).
    unfold right_answer, finite, value, to_float. rewrite Prim2B_B2Prim. intros (F & _ & Q). split; [exact F|]. split; [apply Q|]. intros _. apply Q.
  - intros _. split; [reflexivity|]. split; [apply Rle_refl|]. intro Q. exfalso. rewrite D in Q. apply IZR_le in L. nra.
Qed.

Section bicell.
Variable f : vertex -> vector_3 machine.
Let x : placement := fun k => at_3 (f k).
Variable k : Z.
Variables (t : bicell_terms integers) (t' : bicell_terms reals).
Hypothesis is_real : real_bicell x = t'.
Let s := bpow radix2 k.
Hypothesis degrees_are :
  (degree_terms k 5 8 (of_partition _ t (abc_pq _ t)) (of_partition _ t' (abc_pq _ t')) /\
   degree_terms k 5 8 (of_partition _ t (ab_cpq _ t)) (of_partition _ t' (ab_cpq _ t')) /\
   degree_terms k 5 8 (of_partition _ t (ca_bpq _ t)) (of_partition _ t' (ca_bpq _ t')) /\
   degree_terms k 5 8 (of_partition _ t (bc_apq _ t)) (of_partition _ t' (bc_apq _ t'))) /\
  (degree_terms k 3 4 (of_cell _ (cell_p _ t) (cell_p_slab _ t)) (of_cell _ (cell_p _ t') (cell_p_slab _ t')) /\
   degree_terms k 3 4 (of_cell _ (cell_q _ t) (cell_q_slab _ t)) (of_cell _ (cell_q _ t') (cell_q_slab _ t'))) /\
  (degree k 3 (side _ (ab_cpq _ t)) (side _ (ab_cpq _ t')) /\ degree k 3 (side _ (ca_bpq _ t)) (side _ (ca_bpq _ t')) /\
   degree k 3 (side _ (bc_apq _ t)) (side _ (bc_apq _ t'))).

Lemma power_pos n : 0 < s ^ n.
Proof. apply pow_lt, bpow_gt_0. Qed.
Lemma det_is : det x = IZR (insphere _ t) * s ^ 5.
Proof. destruct degrees_are as (((D & _) & _) & _). rewrite <- (proj1 (terms_are_numbers x)), is_real. exact D. Qed.

(* What stands for a half width, taken where its determinant is positive. *)
Definition lower_bound (m : double) (r : R) : Prop := is_finite m = true /\ 0 <= B2R m <= r.
Lemma lower_least g h r e : lower_bound g r -> lower_bound h e -> lower_bound (least g h) (Rmin r e).
Proof. intros [F G] [E H]. now apply least_of_two. Qed.

Lemma annulus_lower kk kk' : degree_terms k 5 8 (of_partition _ t kk) (of_partition _ t' kk') -> 0 < det x ->
  0 <= inner_3 _ kk' -> 0 <= outer_3 _ kk' -> 0 < R_sqrt.sqrt (inner_3 _ kk') + R_sqrt.sqrt (outer_3 _ kk') ->
  lower_bound (half_width_lower (of_partition _ t kk) k) (half (of_partition reals t' kk')).
Proof.
  intros D P I O R. assert (E := proj1 (terms_are_numbers x)). rewrite is_real in E.
  destruct (half_width_lower_right k _ _ _ (half (of_partition reals t' kk')) (power_pos 4) (degree_scaled k 4 _ _ D) I O) as (F & L & U); [auto|].
  split; [exact F|]. split; [exact L|]. apply U. cbn [of_partition determinant]. rewrite E. exact P.
Qed.

Lemma annuli_lower_bound : 0 < det x -> lower_bound (least_of k (of_partition _ t (abc_pq _ t))
  [of_partition _ t (ab_cpq _ t); of_partition _ t (ca_bpq _ t); of_partition _ t (bc_apq _ t)]) (annuli_half_width x).
Proof.
  intro P. destruct degrees_are as ((D1 & D2 & D3 & D4) & _). assert (A := annuli_half x P). rewrite is_real in A. rewrite (annuli_are x P), is_real.
  assert (B : forall kk kk', degree_terms k 5 8 (of_partition _ t kk) (of_partition _ t' kk') -> In kk' [abc_pq _ t'; ab_cpq _ t'; ca_bpq _ t'; bc_apq _ t'] ->
    lower_bound (half_width_lower (of_partition _ t kk) k) (half (of_partition reals t' kk'))).
  { intros kk kk' D I. destruct (A kk' I) as (I0 & O0 & R0). now apply annulus_lower. }
  unfold least_of. cbn [fold_left]. rewrite Rmin_assoc. repeat apply lower_least; apply B; trivial; simpl; tauto.
Qed.

(* A cell that is not positive has the tolerance 0. *)
Lemma cell_lower_bound (y : corners) d l v l' : degree_terms k 3 4 (of_cell _ d l) (of_cell reals v l') -> v = volume y -> 0 <= l' -> R_sqrt.sqrt l' = largest y ->
  is_finite (half_width_lower (of_cell _ d l) k) = true /\ 0 <= B2R (half_width_lower (of_cell _ d l) k) /\
  (0 < volume y -> B2R (half_width_lower (of_cell _ d l) k) <= half_width_simplex y) /\ (volume y <= 0 -> B2R (half_width_lower (of_cell _ d l) k) = 0).
Proof.
  intros D V L E. destruct (half_width_lower_right k _ _ _ (half_width_simplex y) (power_pos 2) (degree_scaled k 2 _ _ D) L L) as (F & B & U).
  { cbn [of_cell determinant inner outer]. intro P. exact (cell_half y v l' V E P). }
  split; [exact F|]. split; [exact B|]. split; [intro P; apply U; cbn [of_cell determinant]; now rewrite V|].
  intro N. unfold half_width_lower. cbv zeta. cbn [of_cell determinant]. destruct D as (D & _). unfold degree in D. cbn [of_cell determinant] in D.
  destruct (Z.ltb_spec 0 d) as [Q|Q]; [|reflexivity]. exfalso. apply IZR_lt in Q. assert (W := power_pos 3). fold s in D. rewrite <- V, D in N. nra.
Qed.

Lemma least_below (g h : double) : is_finite g = true -> is_finite h = true -> 0 <= B2R g -> 0 <= B2R h ->
  is_finite (least g h) = true /\ 0 <= B2R (least g h) /\ B2R (least g h) <= B2R g /\ B2R (least g h) <= B2R h.
Proof. intros G H Pg Ph. unfold least, below. rewrite Bltb_correct by assumption. case Rlt_bool_spec; intro L; repeat split; trivial; lra. Qed.

(* With the cells: where they are positive at most their half widths, else 0. *)
Lemma with_cells (m : double) : lower_bound m (annuli_half_width x) ->
  let r := least (least m (half_width_lower (of_cell _ (cell_p _ t) (cell_p_slab _ t)) k)) (half_width_lower (of_cell _ (cell_q _ t) (cell_q_slab _ t)) k) in
  is_finite r = true /\ 0 <= B2R r /\ (B2R r <= annuli_half_width x /\ B2R r <= cells_half_width x \/ B2R r = 0).
Proof.
  intros (Fm & M0 & M1). destruct degrees_are as (_ & (Dp & Dq) & _). assert (H := cells_half x). rewrite is_real in H. destruct H as (Vp & Vq & Lp & Lq & Rp & Rq).
  destruct (cell_lower_bound _ _ _ _ _ Dp Vp Lp Rp) as (Fp & P0 & P1 & P2). destruct (cell_lower_bound _ _ _ _ _ Dq Vq Lq Rq) as (Fq & Q0 & Q1 & Q2).
  set (lp := half_width_lower (of_cell _ (cell_p _ t) _) k) in *. set (lq := half_width_lower (of_cell _ (cell_q _ t) _) k) in *.
  destruct (least_below m lp Fm Fp M0 P0) as (F1 & A0 & A1 & A2). destruct (least_below (least m lp) lq F1 Fq A0 Q0) as (F2 & B0 & B1 & B2).
  split; [exact F2|]. split; [exact B0|]. unfold cells_half_width.
  set (vp := volume (sign_tolerance_3.cell_p x)) in *. set (vq := volume (sign_tolerance_3.cell_q x)) in *.
  set (hp := half_width_simplex (sign_tolerance_3.cell_p x)) in *. set (hq := half_width_simplex (sign_tolerance_3.cell_q x)) in *.
  destruct (Rlt_or_le 0 vp) as [Sp|Sp]; [|right; specialize (P2 Sp); lra]. destruct (Rlt_or_le 0 vq) as [Sq|Sq]; [|right; specialize (Q2 Sq); lra].
  left. specialize (P1 Sp). specialize (Q1 Sq). split; [lra|]. apply Rmin_glb; lra.
Qed.

(* Where a needed cell is not positive the tolerance is 0; no half width is negative otherwise. *)
Theorem exact_bicell_right use : right_answer (exact_bicell t k use) (det x) (Rmax 0 (certified_width use x)) /\ exact_bicell t k use <> refused.
Proof.
  assert (S5 := power_pos 5). assert (S3 := power_pos 3). unfold exact_bicell. cbv zeta. set (behind := existsb _ _).
  destruct (Z.ltb_spec (insphere _ t) 0) as [L|L]; [split; [|discriminate]; simpl; rewrite det_is; apply IZR_lt in L; nra|].
  destruct (Z.eqb_spec (insphere _ t) 0) as [E|E]; [split; [|discriminate]; simpl; rewrite det_is, E; ring|]. split; [|discriminate].
  assert (D : 0 < det x). { rewrite det_is. apply Rmult_lt_0_compat; [apply IZR_lt; lia|exact S5]. }
  assert (Back : behind = false -> 0 < Lam x cpq /\ 0 < Lam x bpq /\ 0 < Lam x apq).
  { destruct degrees_are as (_ & _ & (D2 & D3 & D4)). assert (H := terms_are_numbers x). rewrite is_real in H. destruct H as (_ & <- & <- & <-).
    unfold degree in D2, D3, D4. fold s in D2, D3, D4. rewrite D2, D3, D4. unfold behind. simpl. intro B.
    apply orb_false_elim in B. destruct B as [B2 B]. apply orb_false_elim in B. destruct B as [B3 B]. apply orb_false_elim in B. destruct B as [B4 _].
    apply negb_false_iff, Z.ltb_lt, IZR_lt in B2. apply negb_false_iff, Z.ltb_lt, IZR_lt in B3. apply negb_false_iff, Z.ltb_lt, IZR_lt in B4.
    assert (Pos : forall r, 0 < r -> 0 < r * s ^ 3) by (intros; now apply Rmult_lt_0_compat). auto. }
  set (taken := match use with never => false | where_needed => behind | always => true end).
  assert (Al : use = always -> taken = true) by (now intros ->).
  assert (Wh : use = where_needed -> taken = false -> 0 < Lam x cpq /\ 0 < Lam x bpq /\ 0 < Lam x apq) by (intros -> N; now apply Back).
  assert (A := annuli_lower_bound D). revert A. unfold least_of. rewrite fold_left_app. set (m := fold_left _ _ _). intro A.
  unfold right_answer, finite, value, to_float. rewrite Prim2B_B2Prim. clearbody taken. destruct taken.
  - destruct (with_cells m A) as (F & P & H). unfold two_cells. cbn [fold_left]. split; [exact F|]. split; [exact D|]. split; [exact P|].
    destruct H as [[H1 H2]|H]; [|rewrite H; apply Rmax_l]. apply Rle_trans with (2 := Rmax_r _ _). now apply certified_width_is with true.
  - destruct A as (F & P & H). cbn [fold_left]. split; [exact F|]. split; [exact D|]. split; [exact P|]. apply Rle_trans with (2 := Rmax_r _ _).
    apply certified_width_is with false; trivial. discriminate.
Qed.
End bicell.

Theorem empty_sphere_3_exact_returned (f : vertex -> vector_3 machine) use :
  right_answer (empty_sphere_3_exact (f a) (f b) (f c) (f p) (f q) use) (det (fun k => at_3 (f k))) (Rmax 0 (certified_width use (fun k => at_3 (f k)))) /\
  empty_sphere_3_exact (f a) (f b) (f c) (f p) (f q) use <> refused.
Proof.
  unfold empty_sphere_3_exact. cbv zeta. set (l := [f a; f b; f c; f p; f q]). set (k := common (numbers_3 l)).
  assert (I : forall i, In (f i) l) by (intros []; simpl; tauto).
  apply (exact_bicell_right f k _ _ eq_refl).
  exact (bicell_degrees k _ _ _ _ _ _ _ _ (integers_stand_3 l _ _ (I b) (I a)) (integers_stand_3 l _ _ (I c) (I a)) (integers_stand_3 l _ _ (I p) (I a))
    (integers_stand_3 l _ _ (I q) (I a))).
Qed.
