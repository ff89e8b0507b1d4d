(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter stage over rounded reals (filter_2.v, filter_3.v) is what the files float_*.v are about: what the plane and space share. The constants,
   decide, the range; and what an answer in primitive floats says when its real counterpart is sound. *)
From Coq Require Import Reals ZArith Lia Lra Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require float_model float_error float_tail float_filter.
From Annulus Require Import operations bridge bridge_decide filter_2 stages.
Close Scope float_scope.
Open Scope R_scope.

Lemma value_format : forall f, float_model.F (value f).
Proof. intro f. apply (generic_format_B2R prec emax). Qed.

(* The constants. *)
Lemma v_one : value 1%float = 1. Proof. rewrite (value_power 1%float (-52) eq_refl). reflexivity. Qed.
Lemma v_two : value 2%float = 2. Proof. rewrite (value_power 2%float (-51) eq_refl). reflexivity. Qed.
Lemma v_slack : value filter_slack = float_tail.filter_slack.
Proof. rewrite (value_power filter_slack (-62) eq_refl). reflexivity. Qed.
Lemma v_tail : value one_less_tail = float_tail.shrink.
Proof.
  rewrite (value_of one_less_tail _ _ eq_refl). unfold float_tail.shrink, float_model.u.
  change (power (-53)) with (/ 9007199254740992). simpl. lra.
Qed.
(* C u, as a float. *)
Lemma v_units : forall f C k m e, Prim2SF f = S754_finite false m e -> Z.pos m = (C * 2 ^ k)%Z -> e = (-53 - k)%Z -> (0 <= k)%Z ->
  value f = float_error.fmul (IZR C) float_model.u.
Proof.
  intros f C k m e H M E K. assert (V : value f = IZR C * float_model.u).
  { rewrite (value_of f m e H), M, mult_IZR. change 2%Z with (radix_val radix2). rewrite IZR_Zpower by exact K.
    rewrite Rmult_assoc, <- bpow_plus, E. replace (k + (-53 - k))%Z with (-53)%Z by ring. reflexivity. }
  unfold float_error.fmul. rewrite <- V. symmetry. apply float_model.rnd_F, value_format.
Qed.

Lemma less_dec : forall a b, Rlt_bool a b = if Rlt_dec a b then true else false.
Proof. intros a b. case Rlt_bool_spec; destruct (Rlt_dec a b); trivial; lra. Qed.
Lemma greater_Rmax : forall a b, greater rounded a b = Rmax a b.
Proof. intros a b. simpl. unfold Rmax. case Rlt_bool_spec; destruct (Rle_dec a b); intros; trivial; lra. Qed.

(* Answers of float_filter.v are a sign, 1 or -1, with a number. *)
Definition convert (a : option (Z * R)) : answer R :=
  match a with None => refused | Some (1%Z, t) => positive t | Some (_, t) => negative t end.

Lemma decide_is : forall certified d r e n, decide rounded d r e n certified = convert (float_filter.decide d r e n certified).
Proof.
  intros certified d r e n. unfold decide, float_filter.decide. change (less rounded) with Rlt_bool. rewrite !less_dec.
  change (constant rounded filter_slack) with (value filter_slack). change (constant rounded one_less_tail) with (value one_less_tail).
  change (constant rounded 0%float) with (value 0%float). rewrite v_slack, v_tail, value_zero.
  change (opposite rounded e) with (- e).
  destruct (Rlt_dec d (- e)); [reflexivity|].
  change (mul rounded d float_tail.filter_slack) with (float_error.fmul d float_tail.filter_slack).
  change (mul rounded r float_tail.filter_slack) with (float_error.fmul r float_tail.filter_slack).
  destruct (Rlt_dec e _); [|reflexivity]. destruct certified; [|reflexivity]. simpl negb. cbv iota.
  destruct (Rlt_dec n _); reflexivity.
Qed.

Lemma in_range_is : forall range k m A (a b : A), value range = power k ->
  (if negb (Rle_bool m (value range) && Rle_bool (value 1%float) (rnd (m * value range))) then a else b) =
  if float_filter.in_range_dec k m then b else a.
Proof.
  intros range k m A a b E. rewrite E, v_one. change (rnd (m * power k)) with (float_error.fmul m (power k)).
  destruct (float_filter.in_range_dec k m) as [[L M]|N].
  - now rewrite (Rle_bool_true _ _ L), (Rle_bool_true _ _ M).
  - case Rle_bool_spec; intro L; [|reflexivity]. case Rle_bool_spec; intro M; [|reflexivity].
    now destruct N.
Qed.

(* What comes back of an answer in primitive floats. *)
Definition signed (b : option (Z * R)) : Prop := forall s v, b = Some (s, v) -> s = 1%Z \/ s = (-1)%Z.

Lemma sound_signed : forall b certified det truth, float_filter.sound b certified det truth -> signed b.
Proof. intros b certified det truth H s v E. destruct (H s v E) as [(S & _)|(S & _)]; auto. Qed.

Lemma returned_positive : forall b t, signed b -> stands_answer (positive t) (convert b) -> finite t = true /\ b = Some (1%Z, value t).
Proof.
  intros [[s v]|] t H A; [|contradiction]. destruct (H s v eq_refl) as [-> | ->]; [|contradiction].
  destruct A as [F <-]. now split.
Qed.

Lemma returned_negative : forall b t, signed b -> stands_answer (negative t) (convert b) -> exists v, b = Some ((-1)%Z, v).
Proof.
  intros [[s v]|] t H A; [|contradiction]. destruct (H s v eq_refl) as [-> | ->]; [contradiction|]. now exists v.
Qed.

Lemma never_zero : forall b t, ~ stands_answer (zero t) (convert b).
Proof. intros [[[|[| |]|] v]|] t A; exact A. Qed.

(* Signs alone. *)
Definition sound_sign (b : option (Z * R)) (det : R) : Prop := forall s v, b = Some (s, v) -> s = 1%Z /\ 0 < det \/ s = (-1)%Z /\ det < 0.

Lemma sound_alone : forall b certified det truth, float_filter.sound b certified det truth -> sound_sign b det.
Proof. intros b certified det truth H s v E. generalize (H s v E). tauto. Qed.

Lemma returned_sign : forall a b det, sound_sign b det -> stands_sign a (convert b) -> right_sign a det.
Proof.
  intros a [[s v]|] det H A; [|now destruct a]. destruct (H s v eq_refl) as [[-> P]|[-> P]]; destruct a; try contradiction; exact P.
Qed.

(* A coordinate of the domain, |x| <= 2^500. *)
Definition coordinate (f : float) : Prop := finite f = true /\ Rabs (value f) <= power 500.

Lemma coordinate_stands : forall f, coordinate f -> stands 500 f (value f).
Proof. intros f [A B]. repeat split; assumption. Qed.
