(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter in space that is replayed (filter_3.v), over rounded reals, is the one that float_filter_3.v and float_sphere_3.v are about.

   - orientation_3_is, bicell_filter_is   the same answers *)
From Coq Require Import Reals ZArith Lia Lra Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require float_model float_error float_terms_3 float_width_3 float_tail float_filter float_filter_3 float_sphere_3 vectors.
From Annulus Require Import operations bridge bridge_decide filter_2 filter_3 bridge_terms_3 connect.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

Module T := float_terms_3.
Module W := float_width_3.
Module S := float_sphere_3.

Lemma v_orientation_3 : value orientation_3_u = float_error.fmul (IZR 47) float_model.u.
Proof. eapply (v_units _ 47 47); [reflexivity|reflexivity|reflexivity|lia]. Qed.
Lemma v_orientation_3_norms : value orientation_3_norms_u = float_error.fmul (IZR 122) float_model.u.
Proof. eapply (v_units _ 122 46); [reflexivity|reflexivity|reflexivity|lia]. Qed.
Lemma v_insphere : value annulus_3_insphere_u = float_error.fmul (IZR 1105) float_model.u.
Proof. eapply (v_units _ 1105 42); [reflexivity|reflexivity|reflexivity|lia]. Qed.
Lemma v_norms_3 : value annulus_3_norms_u = float_error.fmul (IZR 3246) float_model.u.
Proof. eapply (v_units _ 3246 41); [reflexivity|reflexivity|reflexivity|lia]. Qed.
Lemma v_side : value annulus_3_side_u = float_error.fmul (IZR 169) float_model.u.
Proof. eapply (v_units _ 169 45); [reflexivity|reflexivity|reflexivity|lia]. Qed.

(* A vector of filter_3.v as one of float_terms_3.v, and back. *)
Definition terms_vector (v : vector_3 rounded) : T.vector R := T.Vector (x3 _ v) (y3 _ v) (z3 _ v).
Definition real_3 (v : T.vector R) : vector_3 rounded := {| x3 := T.x v : number rounded; y3 := T.y v : number rounded; z3 := T.z v : number rounded |}.

Lemma largest_3_is : forall v : vector_3 rounded, largest_3 rounded v = float_filter_3.magnitude (terms_vector v).
Proof. intro v. unfold largest_3. rewrite !greater_Rmax. reflexivity. Qed.

Lemma difference_3_is : forall a b, terms_vector (difference_3 rounded (real_3 a) (real_3 b)) = float_filter_3.F_difference a b.
Proof. reflexivity. Qed.

(* The order of the maxima does not matter. *)
Lemma seven : forall a b c d e f g, 0 <= a ->
  Rmax (Rmax (Rmax a b) (Rmax c d)) (Rmax (Rmax e f) g) = Rmax a (Rmax b (Rmax c (Rmax d (Rmax e (Rmax f (Rmax g 0)))))).
Proof.
  intros a b c d e f g H.
  assert (Z : 0 <= Rmax (Rmax (Rmax a b) (Rmax c d)) (Rmax (Rmax e f) g)) by (apply Rle_trans with (1 := H); vectors.leaf).
  apply Rle_antisym; repeat apply Rmax_lub; first [exact Z | vectors.leaf].
Qed.

Lemma slab_is : forall u v w, largest_slab rounded u v w =
  W.largest T.F_square (T.slabs R float_error.fadd (terms_vector u) (terms_vector v) (terms_vector w)).
Proof.
  intros u v w. unfold largest_slab. cbv zeta. rewrite !greater_Rmax. unfold T.slabs, W.largest. cbn [fold_right].
  apply seven. assert (S : forall r, 0 <= rnd (r * r)) by (intro; apply rnd_nonneg, Rle_0_sqr).
  apply rnd_nonneg, Rplus_le_le_0_compat; [|apply S]. apply rnd_nonneg, Rplus_le_le_0_compat; apply S.
Qed.

Lemma width_error_is : forall m, width_error rounded m = float_filter.error_bound 47 (float_filter.power_3 m).
Proof. intro m. unfold width_error. change (constant rounded orientation_3_u) with (value orientation_3_u). now rewrite v_orientation_3. Qed.
Lemma width_norms_is : forall m, width_norms rounded m = float_filter.error_bound 122 (float_filter.power_2 m).
Proof. intro m. unfold width_norms. change (constant rounded orientation_3_norms_u) with (value orientation_3_norms_u). now rewrite v_orientation_3_norms. Qed.
Lemma bicell_error_is : forall m, bicell_error rounded m = float_filter.error_bound 1105 (float_filter.power_5 m).
Proof. intro m. unfold bicell_error. change (constant rounded annulus_3_insphere_u) with (value annulus_3_insphere_u). now rewrite v_insphere. Qed.
Lemma bicell_norms_is : forall m, bicell_norms rounded m = float_filter.error_bound 3246 (float_filter.power_4 m).
Proof. intro m. unfold bicell_norms. change (constant rounded annulus_3_norms_u) with (value annulus_3_norms_u). now rewrite v_norms_3. Qed.
Lemma side_error_is : forall m, side_error rounded m = float_filter.error_bound 169 (float_filter.power_3 m).
Proof. intro m. unfold side_error. change (constant rounded annulus_3_side_u) with (value annulus_3_side_u). now rewrite v_side. Qed.

Lemma decide_width_is : forall certified d l slabs m, l = W.largest T.F_square slabs ->
  decide_width rounded d l m certified = convert (W.decide_width d slabs m certified).
Proof.
  intros certified d l slabs m ->. unfold decide_width. rewrite decide_is, width_error_is, width_norms_is.
  change (constant rounded 2%float) with (value 2%float). rewrite v_two. reflexivity.
Qed.

Lemma tetrahedron_is : forall u v w m certified, let t := orientation_terms_3 rounded u v w in
  decide_width rounded (determinant _ t) (inner _ t) m certified =
  convert (W.decide_width (T.F_tetrahedron (terms_vector u) (terms_vector v) (terms_vector w))
    (T.F_slabs (terms_vector u) (terms_vector v) (terms_vector w)) m certified).
Proof. intros. exact (decide_width_is _ _ _ _ _ (slab_is _ _ _)). Qed.

Lemma orientation_3_is : forall certified a b c d, orientation_filter_3 rounded (real_3 a) (real_3 b) (real_3 c) (real_3 d) certified =
  convert (float_filter_3.orientation_filter_3 a b c d certified).
Proof.
  intros certified a b c d. unfold orientation_filter_3, in_range_3. cbv zeta.
  change (less_equal rounded) with Rle_bool. change (constant rounded filter_range_3) with (value filter_range_3).
  rewrite (in_range_is filter_range_3 100) by exact value_range_3.
  unfold orientation_magnitude_3. rewrite !greater_Rmax, !largest_3_is, !difference_3_is.
  unfold float_filter_3.orientation_filter_3. cbv zeta.
  destruct (float_filter.in_range_dec 100 _); [|reflexivity]. rewrite tetrahedron_is, !difference_3_is. reflexivity.
Qed.

(* ---- Empty sphere ---- *)

(* The terms of both transcriptions, over any numbers: nothing of the arithmetic is opened. *)
Section terms.
Variable o : operations.
Hypothesis squares : forall a, square o a = mul o a a.
Definition over_terms (v : vector_3 o) : T.vector (number o) := T.Vector (x3 _ v) (y3 _ v) (z3 _ v).
Variables b c p q : vector_3 o.
Let t := bicell o b c p q.
Let f := T.bicell_terms (number o) (add o) (sub o) (mul o) (opposite o) (over_terms b) (over_terms c) (over_terms p) (over_terms q).

Lemma square_3_is : forall v, square_3 o v = T.square (number o) (add o) (mul o) (over_terms v).
Proof. intro v. unfold square_3. rewrite !squares. reflexivity. Qed.

Definition of_vectors (k : partition o) (inner outer : T.vector (number o)) (sum : number o) :=
  inner_3 _ k = T.square _ (add o) (mul o) inner /\ outer_3 _ k = T.square _ (add o) (mul o) outer /\ side _ k = sum.

Lemma bicell_terms_are : insphere _ t = T.determinant f /\
  of_vectors (abc_pq _ t) (T.n1 f) (T.m1 f) (T.l1 f) /\ of_vectors (ab_cpq _ t) (T.n2 f) (T.m2 f) (T.l2 f) /\
  of_vectors (ca_bpq _ t) (T.n3 f) (T.m3 f) (T.l3 f) /\ of_vectors (bc_apq _ t) (T.m4 f) (T.n4 f) (T.minus_l4 f) /\
  cell_p _ t = T.cell_p f /\ cell_q _ t = T.cell_q f.
Proof.
  unfold t, bicell. cbv zeta. cbn [insphere abc_pq ab_cpq ca_bpq bc_apq cell_p cell_q].
  unfold of_vectors. cbn [inner_3 outer_3 side]. rewrite !square_3_is. repeat split.
Qed.
End terms.

Section bicell.
Variables b c p q : vector_3 rounded.
Let t := bicell rounded b c p q.
Let f := T.F_bicell (terms_vector b) (terms_vector c) (terms_vector p) (terms_vector q).

Definition of_rounded (k : partition rounded) (inner outer : T.vector R) (sum : R) :=
  inner_3 _ k = T.F_square inner /\ outer_3 _ k = T.F_square outer /\ side _ k = sum.
Lemma rounded_terms_are : insphere _ t = T.determinant f /\
  of_rounded (abc_pq _ t) (T.n1 f) (T.m1 f) (T.l1 f) /\ of_rounded (ab_cpq _ t) (T.n2 f) (T.m2 f) (T.l2 f) /\
  of_rounded (ca_bpq _ t) (T.n3 f) (T.m3 f) (T.l3 f) /\ of_rounded (bc_apq _ t) (T.m4 f) (T.n4 f) (T.minus_l4 f) /\
  cell_p _ t = T.cell_p f /\ cell_q _ t = T.cell_q f.
Proof. exact (bicell_terms_are rounded (fun a => eq_refl) b c p q). Qed.

Lemma norms_of : forall k n m l, of_rounded k n m l -> norms rounded k = S.norm_sum n m.
Proof. intros k n m l (I & O & _). unfold norms. rewrite I, O. unfold S.norm_sum. generalize (T.F_square n) (T.F_square m). reflexivity. Qed.
Lemma norms_are : norms _ (abc_pq _ t) = S.norm_sum (T.n1 f) (T.m1 f) /\ norms _ (ab_cpq _ t) = S.norm_sum (T.n2 f) (T.m2 f) /\
  norms _ (ca_bpq _ t) = S.norm_sum (T.n3 f) (T.m3 f) /\ norms _ (bc_apq _ t) = S.norm_sum (T.n4 f) (T.m4 f).
Proof.
  destruct rounded_terms_are as (_ & P1 & P2 & P3 & P4 & _).
  rewrite (norms_of _ _ _ _ P1), (norms_of _ _ _ _ P2), (norms_of _ _ _ _ P3), (norms_of _ _ _ _ P4). repeat split.
  unfold S.norm_sum, float_tail.root_sum, float_error.fadd. now rewrite Rplus_comm.
Qed.
Lemma cell_p_slab_is : cell_p_slab _ t = W.largest T.F_square (T.slabs_p f).
Proof. exact (slab_is _ _ _). Qed.
Lemma cell_q_slab_is : cell_q_slab _ t = W.largest T.F_square (T.slabs_q f).
Proof. exact (slab_is _ _ _). Qed.
End bicell.

Definition use_of (k : cells) : S.cells := match k with never => S.never | where_needed => S.where_needed | always => S.always end.

Lemma both_is : forall l r, both rounded true (convert l) (convert r) = convert (S.both l r).
Proof.
  intros [[[|[| |]|] s]|] r; try reflexivity. destruct r as [[[|[| |]|] t]|]; try reflexivity.
  simpl. unfold Rmin. case Rlt_bool_spec; destruct (Rle_dec s t); intros; do 2 f_equal; lra.
Qed.
Lemma both_not : forall l r, both rounded false l r = l.
Proof. now intros [|s|s|s] r. Qed.

Lemma unless_is : forall doubt l r, unless rounded doubt (convert l) (convert r) = if doubt && S.lowered l r then refused else convert r.
Proof.
  intros doubt [[[|[| |]|] s]|] [[[|[| |]|] t]|]; simpl; rewrite ?andb_false_r; try reflexivity.
  rewrite less_dec. destruct (Rlt_dec t s); reflexivity.
Qed.
Lemma unless_same : forall doubt l, unless rounded doubt (convert l) (convert l) = convert l.
Proof.
  intros doubt [[[|[| |]|] s]|]; try reflexivity. simpl. rewrite Rlt_bool_false by apply Rle_refl. now rewrite andb_false_r.
Qed.

Lemma refused_if : forall (doubt : bool) r, (if doubt then refused else convert r) = convert (if doubt then None else r).
Proof. now intros [|] r. Qed.

Section filter.
Variable certified : bool.
Variables a b c p q : T.vector R.
Variable k : cells.
Let vb := difference_3 rounded (real_3 b) (real_3 a).
Let vc := difference_3 rounded (real_3 c) (real_3 a).
Let vp := difference_3 rounded (real_3 p) (real_3 a).
Let vq := difference_3 rounded (real_3 q) (real_3 a).
Let m := S.bicell_m a b c p q.
Let t := bicell rounded vb vc vp vq.
Let f := S.bicell_computed a b c p q.

Lemma magnitude_is : bicell_magnitude rounded vb vc vp vq = m.
Proof. unfold bicell_magnitude. rewrite !greater_Rmax, !largest_3_is. reflexivity. Qed.

Lemma sides_are : side _ (ab_cpq _ t) = T.l2 f /\ side _ (ca_bpq _ t) = T.l3 f /\ side _ (bc_apq _ t) = T.minus_l4 f.
Proof. destruct (rounded_terms_are vb vc vp vq) as (_ & _ & (_ & _ & S2) & (_ & _ & S3) & (_ & _ & S4) & _). auto. Qed.

Lemma wrong_side_of : forall (k : partition rounded) (h : T.bicell R -> R), side rounded k = h f ->
  wrong_side rounded m k = S.on_wrong_side a b c p q h.
Proof.
  intros part h E. unfold wrong_side, S.on_wrong_side. rewrite side_error_is, E. change (less rounded) with Rlt_bool. rewrite less_dec.
  fold m f. now destruct (Rlt_dec _ (h f)).
Qed.
Lemma certainly_wrong_side_of : forall (k : partition rounded) (h : T.bicell R -> R), side rounded k = h f ->
  certainly_wrong_side rounded m k = S.certainly_wrong_side a b c p q h.
Proof.
  intros part h E. unfold certainly_wrong_side, S.certainly_wrong_side. rewrite side_error_is, E.
  change (less rounded) with Rlt_bool. rewrite less_dec.
  reflexivity.
Qed.

Let annuli := float_filter.decide (T.determinant f)
  (Rmax (Rmax (S.norm_sum (T.n1 f) (T.m1 f)) (S.norm_sum (T.n2 f) (T.m2 f))) (Rmax (S.norm_sum (T.n3 f) (T.m3 f)) (S.norm_sum (T.n4 f) (T.m4 f))))
  (float_filter.error_bound 1105 (float_filter.power_5 m)) (float_filter.error_bound 3246 (float_filter.power_4 m)) certified.

Lemma annuli_are : decide rounded (insphere _ t)
    (greater rounded (greater rounded (norms _ (abc_pq _ t)) (norms _ (ab_cpq _ t))) (greater rounded (norms _ (ca_bpq _ t)) (norms _ (bc_apq _ t))))
    (bicell_error rounded m) (bicell_norms rounded m) certified = convert annuli.
Proof.
  rewrite decide_is, bicell_error_is, bicell_norms_is, !greater_Rmax. unfold t.
  destruct (norms_are vb vc vp vq) as (N1 & N2 & N3 & N4). rewrite N1, N2, N3, N4, (proj1 (rounded_terms_are vb vc vp vq)). unfold vb, vc, vp, vq.
  rewrite !difference_3_is. reflexivity.
Qed.

Theorem bicell_filter_is : bicell_filter rounded (real_3 a) (real_3 b) (real_3 c) (real_3 p) (real_3 q) certified k =
  convert (S.bicell_filter a b c p q certified (use_of k)).
Proof.
  unfold bicell_filter, in_range_3. cbv zeta. fold vb vc vp vq. rewrite magnitude_is. fold t.
  change (less_equal rounded) with Rle_bool. change (constant rounded filter_range_3) with (value filter_range_3).
  rewrite (in_range_is filter_range_3 100) by exact value_range_3.
  unfold S.bicell_filter. fold m f. cbv zeta. fold annuli. destruct (float_filter.in_range_dec 100 m); [|reflexivity].
  rewrite annuli_are.
  rewrite (decide_width_is _ _ _ _ m (cell_p_slab_is vb vc vp vq)), (decide_width_is _ _ _ _ m (cell_q_slab_is vb vc vp vq)).
  destruct sides_are as (S2 & S3 & S4). destruct (rounded_terms_are vb vc vp vq) as (_ & _ & _ & _ & _ & Cp & Cq). fold t in Cp, Cq.
  rewrite (wrong_side_of _ T.l2 S2), (wrong_side_of _ T.l3 S3), (wrong_side_of _ T.minus_l4 S4).
  rewrite (certainly_wrong_side_of _ T.l2 S2), (certainly_wrong_side_of _ T.l3 S3), (certainly_wrong_side_of _ T.minus_l4 S4). rewrite Cp, Cq.
  set (wp := W.decide_width _ (T.slabs_p _) m certified). set (wq := W.decide_width _ (T.slabs_q _) m certified).
  change (W.decide_width (T.cell_p f) (T.slabs_p f) m certified) with wp. change (W.decide_width (T.cell_q f) (T.slabs_q f) m certified) with wq.
  destruct k; unfold S.cells_needed, S.in_doubt, use_of.
  - rewrite !both_not. apply unless_same.
  - destruct (S.on_wrong_side _ _ _ _ _ T.l2 || S.on_wrong_side _ _ _ _ _ T.l3 || S.on_wrong_side _ _ _ _ _ T.minus_l4)%bool.
    + rewrite !both_is, unless_is. apply refused_if.
    + rewrite !both_not. apply unless_same.
  - rewrite !both_is, unless_is. apply (refused_if false).
Qed.
End filter.
