(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter of the plane that is replayed (filter_2.v), over rounded reals, is the one that float_filter_2.v and float_circle_2.v are about.

   - orientation_is, empty_sphere_is   the same answers *)
From Coq Require Import Reals ZArith Lia Lra Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require float_model float_error float_terms_2 float_tail float_filter float_filter_2 float_circle_2.
From Annulus Require Import operations bridge bridge_decide filter_2 connect.
Close Scope float_scope.
Open Scope R_scope.

Lemma v_range : value filter_range = power 120. Proof. exact (value_power filter_range 68 eq_refl). Qed.
Lemma v_orientation : value orientation_2_u = float_error.fmul (IZR 9) float_model.u.
Proof. eapply (v_units _ 9 49); [reflexivity|reflexivity|reflexivity|lia]. Qed.
Lemma v_incircle : value annulus_2_incircle_u = float_error.fmul (IZR 177) float_model.u.
Proof. eapply (v_units _ 177 45); [reflexivity|reflexivity|reflexivity|lia]. Qed.
Lemma v_norms : value annulus_2_norms_u = float_error.fmul (IZR 273) float_model.u.
Proof. eapply (v_units _ 273 44); [reflexivity|reflexivity|reflexivity|lia]. Qed.

Definition real (a b : R) : vector rounded := {| x := a : number rounded; y := b : number rounded |}.

Lemma largest_is : forall v : vector rounded, largest rounded v = float_filter.mag (x _ v) (y _ v).
Proof. intro v. apply greater_Rmax. Qed.

Lemma longest_is : forall u v w : vector rounded, inner rounded (orientation_terms rounded u v w) =
  Rmax (Rmax (float_terms_2.F_side (x _ u) (y _ u)) (float_terms_2.F_side (x _ v) (y _ v))) (float_terms_2.F_side (x _ w) (y _ w)).
Proof.
  intros u v w.
  change (inner rounded (orientation_terms rounded u v w)) with
    (greater rounded (greater rounded (float_terms_2.F_side (x _ u) (y _ u)) (float_terms_2.F_side (x _ v) (y _ v)))
                     (float_terms_2.F_side (x _ w) (y _ w))).
  now rewrite !greater_Rmax.
Qed.

Lemma orientation_is : forall certified ax ay bx by' cx cy,
  orientation_filter rounded (real ax ay) (real bx by') (real cx cy) certified =
  convert (float_filter_2.orientation_filter ax ay bx by' cx cy certified).
Proof.
  intros certified ax ay bx by' cx cy. unfold orientation_filter, in_range. cbv zeta.
  change (less_equal rounded) with Rle_bool. change (constant rounded filter_range) with (value filter_range).
  rewrite (in_range_is filter_range 120) by exact v_range.
  unfold orientation_magnitude. rewrite greater_Rmax, !largest_is, decide_is.
  unfold orientation_error. change (constant rounded orientation_2_u) with (value orientation_2_u). rewrite v_orientation.
  unfold orientation_roots. change (constant rounded 2%float) with (value 2%float). rewrite v_two.
  change (constant rounded 0%float) with (value 0%float). rewrite value_zero, longest_is.
  unfold float_filter_2.orientation_filter. cbv zeta.
  match goal with |- (if ?c then _ else _) = convert (if ?d then _ else _) => change c with d; destruct d; reflexivity end.
Qed.

(* The terms of both transcriptions, over any numbers: nothing of the arithmetic is opened. *)
Section terms.
Variable o : operations.
Hypothesis squares : forall a, square o a = mul o a a.
Variables b p q e : vector o.
Let t := annulus_terms o b p q e.
Let f := float_terms_2.annulus_terms (number o) (add o) (sub o) (mul o) (x _ b) (y _ b) (x _ p) (y _ p) (x _ q) (y _ q) (x _ e) (y _ e).

Lemma annulus_terms_are : determinant _ t = float_terms_2.incircle f /\ inner _ t = float_terms_2.inner f /\ outer _ t = float_terms_2.outer f.
Proof. repeat split; unfold t, annulus_terms, squared; cbn [inner outer]; rewrite !squares; reflexivity. Qed.
End terms.

Section circle.
Variables b p q e : vector rounded.
Let t := annulus_terms rounded b p q e.
Let f := float_terms_2.F_annulus (x _ b) (y _ b) (x _ p) (y _ p) (x _ q) (y _ q) (x _ e) (y _ e).

Lemma circle_terms_are : determinant _ t = float_terms_2.incircle f /\ inner _ t = float_terms_2.inner f /\ outer _ t = float_terms_2.outer f.
Proof. exact (annulus_terms_are rounded (fun a => eq_refl) b p q e). Qed.
Lemma roots_are : annulus_roots _ t = float_tail.root_sum (float_terms_2.inner f) (float_terms_2.outer f).
Proof.
  destruct circle_terms_are as (_ & I & O). unfold annulus_roots. rewrite I, O.
  generalize (float_terms_2.inner f) (float_terms_2.outer f). reflexivity.
Qed.
End circle.

Lemma annulus_magnitude_is : forall b p q e : vector rounded, annulus_magnitude rounded b p q e =
  Rmax (Rmax (float_filter.mag (x _ b) (y _ b)) (float_filter.mag (x _ p) (y _ p)))
       (Rmax (float_filter.mag (x _ q) (y _ q)) (float_filter.mag (x _ e) (y _ e))).
Proof. intros. unfold annulus_magnitude. now rewrite !greater_Rmax, !largest_is. Qed.

Lemma annulus_errors_are : forall m, annulus_det_error rounded m = float_filter.error_bound 177 (float_filter.power_4 m) /\
  annulus_norm_error rounded m = float_filter.error_bound 273 (float_filter.power_3 m).
Proof.
  intro m. unfold annulus_det_error, annulus_norm_error. cbv zeta.
  change (constant rounded annulus_2_incircle_u) with (value annulus_2_incircle_u). rewrite v_incircle.
  change (constant rounded annulus_2_norms_u) with (value annulus_2_norms_u). rewrite v_norms. split; reflexivity.
Qed.

Lemma empty_sphere_is : forall certified ax ay bx by' px py qx qy,
  empty_sphere_filter rounded (real ax ay) (real bx by') (real px py) (real qx qy) certified =
  convert (float_circle_2.circle_filter ax ay bx by' px py qx qy certified).
Proof.
  intros certified ax ay bx by' px py qx qy. unfold empty_sphere_filter, in_range. cbv zeta.
  change (less_equal rounded) with Rle_bool. change (constant rounded filter_range) with (value filter_range).
  rewrite (in_range_is filter_range 120) by exact v_range. rewrite annulus_magnitude_is, decide_is, roots_are, (proj1 (circle_terms_are _ _ _ _)).
  rewrite (proj1 (annulus_errors_are _)), (proj2 (annulus_errors_are _)).
  unfold float_circle_2.circle_filter. cbv zeta. unfold float_filter.power_4, float_filter.power_3, float_filter.power_2.
  cbn [difference x y real sub rounded]. fold (float_error.fsub bx ax) (float_error.fsub by' ay) (float_error.fsub px ax)
    (float_error.fsub py ay) (float_error.fsub qx ax) (float_error.fsub qy ay) (float_error.fsub qx px) (float_error.fsub qy py).
  destruct (float_filter.in_range_dec 120 _); reflexivity.
Qed.
