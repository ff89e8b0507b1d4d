(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The end-to-end theorem of proofs/coq/float_filter_2.v, for the very computation that is replayed: what the orientation filter of the
   plane answers in primitive floats, with certified tolerances, for points of the coordinate domain. *)
From Coq Require Import Reals ZArith Lia Lra Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require float_model float_error float_terms_2 float_tail float_filter float_filter_2.
From Annulus_link Require Import operations bridge filter_2 bridge_2.
Close Scope float_scope.
Open Scope R_scope.

Lemma value_of : forall f m e, Prim2SF f = S754_finite false m e -> value f = IZR (Z.pos m) * power e.
Proof. intros f m e H. unfold value, Prim2B. rewrite B2R_SF2B, H. reflexivity. Qed.

Lemma value_format : forall f, float_model.F (value f).
Proof. intro f. apply (generic_format_B2R prec emax). Qed.

(* The constants. *)
Lemma v_range : value filter_range = power 120. Proof. exact (value_power filter_range 68 eq_refl). Qed.
Lemma v_one : value 1%float = 1. Proof. rewrite (value_power 1%float (-52) eq_refl). reflexivity. Qed.
Lemma v_two : value 2%float = 2. Proof. rewrite (value_power 2%float (-51) eq_refl). reflexivity. Qed.
Lemma v_slack : value filter_slack = float_tail.filter_slack.
Proof. rewrite (value_power filter_slack (-62) eq_refl). reflexivity. Qed.
Lemma v_tail : value one_less_tail = float_tail.shrink.
Proof.
  rewrite (value_of one_less_tail _ _ eq_refl). unfold float_tail.shrink, float_model.u.
  change (power (-53)) with (/ 9007199254740992). simpl. lra.
Qed.
Lemma v_units : forall f C m e, Prim2SF f = S754_finite false m e -> IZR (Z.pos m) * power e = IZR C * float_model.u ->
  value f = float_error.fmul (IZR C) float_model.u.
Proof.
  intros f C m e H E. unfold float_error.fmul. rewrite <- E, <- (value_of f m e H).
  symmetry. apply float_model.rnd_F, value_format.
Qed.

Ltac unit :=
  eapply v_units; [reflexivity|];
  match goal with |- _ * power ?e = _ => let n := eval vm_compute in e in change e with n end;
  unfold float_model.u; change (power (-102)) with (/ 5070602400912917605986812821504);
  change (power (-98)) with (/ 316912650057057350374175801344); change (power (-97)) with (/ 158456325028528675187087900672); lra.
Lemma v_orientation : value orientation_2_u = float_error.fmul (IZR 9) float_model.u. Proof. unit. Qed.
Lemma v_incircle : value annulus_2_incircle_u = float_error.fmul (IZR 177) float_model.u. Proof. unit. Qed.
Lemma v_norms : value annulus_2_norms_u = float_error.fmul (IZR 273) float_model.u. Proof. unit. Qed.

Lemma less_dec : forall a b, Rlt_bool a b = if Rlt_dec a b then true else false.
Proof. intros a b. case Rlt_bool_spec; destruct (Rlt_dec a b); trivial; lra. Qed.
Lemma greater_Rmax : forall a b, greater rounded a b = Rmax a b.
Proof. intros a b. simpl. unfold Rmax. case Rlt_bool_spec; destruct (Rle_dec a b); intros; trivial; lra. Qed.

Definition convert (a : option (Z * R)) : answer R :=
  match a with None => refused | Some (s, t) => if Z.ltb 0 s then positive t else negative t end.

Lemma decide_is : forall d r e n, decide rounded d r e n true = convert (float_filter.decide d r e n true).
Proof.
  intros d r e n. unfold decide, float_filter.decide. change (less rounded) with Rlt_bool. rewrite !less_dec.
  change (constant rounded filter_slack) with (value filter_slack). change (constant rounded one_less_tail) with (value one_less_tail).
  change (constant rounded 0%float) with (value 0%float). rewrite v_slack, v_tail, value_zero.
  change (opposite rounded e) with (- e).
  destruct (Rlt_dec d (- e)); [reflexivity|].
  change (mul rounded d float_tail.filter_slack) with (float_error.fmul d float_tail.filter_slack).
  change (mul rounded r float_tail.filter_slack) with (float_error.fmul r float_tail.filter_slack).
  destruct (Rlt_dec e _); [|reflexivity]. simpl negb. cbv iota.
  destruct (Rlt_dec n _); reflexivity.
Qed.

Lemma in_range_is : forall m A (a b : A),
  (if negb (in_range rounded m) then a else b) = if float_filter.in_range_dec 120 m then b else a.
Proof.
  intros m A a b. unfold in_range. change (less_equal rounded) with Rle_bool.
  change (constant rounded filter_range) with (value filter_range). change (constant rounded 1%float) with (value 1%float).
  rewrite v_range, v_one. change (mul rounded m (power 120)) with (float_error.fmul m (power 120)).
  destruct (float_filter.in_range_dec 120 m) as [[L M]|N].
  - now rewrite (Rle_bool_true _ _ L), (Rle_bool_true _ _ M).
  - case Rle_bool_spec; intro L; [|reflexivity]. case Rle_bool_spec; intro M; [|reflexivity].
    now destruct N.
Qed.

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

Lemma orientation_is : forall ax ay bx by' cx cy,
  orientation_filter rounded (real ax ay) (real bx by') (real cx cy) true =
  convert (float_filter_2.orientation_filter ax ay bx by' cx cy true).
Proof.
  intros ax ay bx by' cx cy. unfold orientation_filter. cbv zeta. rewrite in_range_is.
  unfold orientation_magnitude. rewrite greater_Rmax, !largest_is, decide_is.
  unfold orientation_error. change (constant rounded orientation_2_u) with (value orientation_2_u). rewrite v_orientation.
  unfold orientation_roots. change (constant rounded 2%float) with (value 2%float). rewrite v_two.
  change (constant rounded 0%float) with (value 0%float). rewrite value_zero, longest_is.
  unfold float_filter_2.orientation_filter. cbv zeta.
  match goal with |- (if ?c then _ else _) = convert (if ?d then _ else _) => change c with d; destruct d; reflexivity end.
Qed.

(* What an answer in primitive floats says of the exact determinant and the exact quotient. *)
Definition says (a : answer float) (det truth : R) : Prop :=
  match a with
  | refused => True
  | negative _ => det < 0
  | zero _ => False
  | positive y => finite y = true /\ 0 < det /\ 0 <= value y <= det / truth
  end.

Lemma says_sound : forall a b det truth, stands_answer a (convert b) -> float_filter.sound b true det truth -> says a det truth.
Proof.
  intros a [[s t]|] det truth H S; [|now destruct a].
  destruct (S s t eq_refl) as [(-> & D & T)|[-> D]]; simpl in H; destruct a as [|y|y|y]; try contradiction.
  - destruct H as [F V]. simpl. rewrite V. split; [exact F|split; [exact D|exact (T eq_refl)]].
  - exact D.
Qed.

(* A coordinate of the domain. *)
Definition coordinate (f : float) : Prop := finite f = true /\ Rabs (value f) <= power 500.
Definition at_point (a b : float) : vector machine := {| x := a : number machine; y := b : number machine |}.

Lemma point_in_domain : forall a b, coordinate a -> coordinate b -> in_domain (at_point a b) (real (value a) (value b)).
Proof. intros a b [A A'] [B B']. split; (split; [assumption|split; [reflexivity|assumption]]). Qed.

Theorem orientation_filter_says : forall ax ay bx by' cx cy,
  coordinate ax -> coordinate ay -> coordinate bx -> coordinate by' -> coordinate cx -> coordinate cy ->
  let longest := float_filter_2.longest_truth (value ax) (value ay) (value bx) (value by') (value cx) (value cy) in
  says (orientation_filter machine (at_point ax ay) (at_point bx by') (at_point cx cy) true)
    (float_filter_2.orientation_truth (value ax) (value ay) (value bx) (value by') (value cx) (value cy))
    (R_sqrt.sqrt longest + R_sqrt.sqrt longest).
Proof.
  intros ax ay bx by' cx cy A A' B B' C C' longest.
  apply says_sound with (float_filter_2.orientation_filter (value ax) (value ay) (value bx) (value by') (value cx) (value cy) true).
  - rewrite <- orientation_is. apply orientation_filter_stands; apply point_in_domain; assumption.
  - apply float_filter_2.orientation_filter_sound; apply value_format.
Qed.
