(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* bridge.v for what the filters of the plane and of space share: constants, the range of the largest difference, and decide.

   - decide_stands   decide says the same in primitive floats and in rounded reals, and its tolerance stands for the real one
   - decide_said     the same of signs alone where no certified tolerance is requested *)
From Coq Require Import Reals ZArith Lia Lra Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import operations bridge filter_2.
Close Scope float_scope.
Open Scope R_scope.

(* A constant: read off its mantissa and exponent. *)
Lemma stands_constant : forall a f m e, Prim2SF f = S754_finite false m e -> (e <= a)%Z -> (Z.pos m <= 2 ^ (a - e))%Z ->
  stands a f (value f).
Proof.
  intros a f m e H E M. unfold stands, finite, value, Prim2B.
  rewrite is_finite_SF2B, B2R_SF2B, H. repeat split. simpl.
  rewrite Rabs_pos_eq by (apply F2R_ge_0; easy).
  unfold F2R. simpl. replace (power a) with (power (a - e) * power e) by (rewrite <- bpow_plus; f_equal; lia).
  apply Rmult_le_compat_r; [apply bpow_ge_0|].
  rewrite <- IZR_Zpower by lia. apply IZR_le, M.
Qed.

Lemma stands_zero : forall a, stands a 0%float (value 0%float).
Proof.
  intro a. unfold stands, finite, value, Prim2B. rewrite is_finite_SF2B, B2R_SF2B. simpl.
  repeat split. rewrite Rabs_R0. apply bpow_ge_0.
Qed.

Lemma value_of : forall f m e, Prim2SF f = S754_finite false m e -> value f = IZR (Z.pos m) * power e.
Proof. intros f m e H. unfold value, Prim2B. rewrite B2R_SF2B, H. reflexivity. Qed.

Lemma value_power : forall f e, Prim2SF f = S754_finite false 4503599627370496 e -> value f = power (52 + e).
Proof.
  intros f e H. unfold value, Prim2B. rewrite B2R_SF2B, H. rewrite bpow_plus. reflexivity.
Qed.

Lemma value_zero : value 0%float = 0.
Proof. unfold value, Prim2B. rewrite B2R_SF2B. reflexivity. Qed.

Definition stands_answer (a : answer float) (b : answer R) :=
  match a, b with
  | refused, refused => True
  | negative s, negative t | zero s, zero t | positive s, positive t => finite s = true /\ value s = t
  | _, _ => False
  end.

(* The same sign; and with certified tolerances the same number. *)
Definition stands_sign (a : answer float) (b : answer R) :=
  match a, b with refused, refused | negative _, negative _ | zero _, zero _ | positive _, positive _ => True | _, _ => False end.
Definition stands_said (certified : bool) (a : answer float) (b : answer R) := if certified then stands_answer a b else stands_sign a b.

(* Signs and least positive numbers. *)
Lemma rnd_nonneg : forall r, 0 <= r -> 0 <= rnd r.
Proof. intros r H. rewrite <- (round_0 radix2 (FLT_exp (-1074) 53) ZnearestE). apply round_le; auto with typeclass_instances. Qed.

Lemma rnd_positive : forall r, 0 < rnd r -> 0 < r.
Proof.
  intros r H. apply Rnot_le_lt. intro N. apply (Rlt_not_le _ _ H).
  rewrite <- (round_0 radix2 (FLT_exp (-1074) 53) ZnearestE). apply round_le; auto with typeclass_instances.
Qed.

Lemma rnd_at_least : forall a r, (-1074 <= a)%Z -> power a <= r -> power a <= rnd r.
Proof. intros a r H L. rewrite <- (rnd_power a H). apply round_le; auto with typeclass_instances. Qed.

Lemma root_at_least : forall a f r, stands a f r -> 0 < r -> power (-537) <= rnd (R_sqrt.sqrt r).
Proof.
  intros a f r (_ & V & _) P. apply rnd_at_least; [lia|].
  replace (power (-537)) with (R_sqrt.sqrt (power (-1074))).
  - apply sqrt_le_1_alt. apply generic_format_ge_bpow with (FLT_exp (-1074) 53); trivial.
    + intro e. unfold FLT_exp. lia.
    + rewrite <- V. apply (generic_format_B2R prec emax).
  - change (-1074)%Z with (-537 + -537)%Z. rewrite bpow_plus. apply sqrt_square, bpow_ge_0.
Qed.

(* The range of the largest difference: a power of two. *)
Lemma stands_in_range : forall range k m r, stands k range (value range) -> (0 <= k <= 120)%Z -> stands 501 m r ->
  (PrimFloat.leb m range && PrimFloat.leb 1%float (m * range)%float)%bool = (Rle_bool r (value range) && Rle_bool (value 1%float) (rnd (r * value range)))%bool.
Proof.
  intros range k m r C K H.
  assert (O : stands 0 1%float (value 1%float)) by (eapply stands_constant; [reflexivity| |]; vm_compute; easy).
  rewrite (stands_leb _ _ _ _ _ _ H C).
  now rewrite (stands_leb _ _ _ _ _ _ O (stands_mul 501 k _ _ _ _ ltac:(lia) H C)).
Qed.

(* decide, given exponents: a of the determinant and its error, b of the roots and theirs, and l below the denominator where it divides. *)
Section decide.
Variables (a b l : Z) (d r e n : float) (d' r' e' n' : R).
Hypothesis exponents : (-1000 <= a <= 1000)%Z /\ (-1000 <= b <= 1000)%Z /\ (-1074 <= l)%Z /\ (0 <= a + 1 - l <= 1023)%Z.
Hypothesis Hd : stands a d d'.
Hypothesis Hr : stands b r r'.
Hypothesis He : stands a e e'.
Hypothesis Hn : stands b n n'.
Hypothesis denominator : n' < rnd (r' * value filter_slack) -> power l <= r' + n'.

Lemma decide_stands : stands_answer (decide machine d r e n true) (decide rounded d' r' e' n' true).
Proof.
  assert (slack : stands (-10) filter_slack (value filter_slack)) by (eapply stands_constant; [reflexivity| |]; vm_compute; easy).
  assert (tail : stands 0 one_less_tail (value one_less_tail)) by (eapply stands_constant; [reflexivity| |]; vm_compute; easy).
  unfold decide. change (less machine) with PrimFloat.ltb. change (less rounded) with Rlt_bool.
  change (opposite machine e) with (- e)%float. change (opposite rounded e') with (- e').
  rewrite (stands_ltb _ _ _ _ _ _ Hd (stands_opp _ _ _ He)).
  case Rlt_bool. { split; reflexivity. }
  pose proof (stands_mul a (-10) _ _ _ _ ltac:(lia) Hd slack) as dm.
  change (mul machine d (constant machine filter_slack)) with (d * filter_slack)%float.
  change (mul rounded d' (constant rounded filter_slack)) with (rnd (d' * value filter_slack)).
  rewrite (stands_ltb _ _ _ _ _ _ He dm).
  case Rlt_bool; [|exact I]. cbv iota beta delta [negb].
  pose proof (stands_mul b (-10) _ _ _ _ ltac:(lia) Hr slack) as rm.
  change (mul machine r (constant machine filter_slack)) with (r * filter_slack)%float.
  change (mul rounded r' (constant rounded filter_slack)) with (rnd (r' * value filter_slack)).
  rewrite (stands_ltb _ _ _ _ _ _ Hn rm).
  case Rlt_bool_spec; [|intros; exact I]. intro K. cbv iota beta delta [negb].
  assert (num : stands (a + 1) (sub machine d e) (sub rounded d' e')) by (apply stands_sub_same; trivial; lia).
  assert (den : stands (b + 1) (add machine r n) (add rounded r' n')) by (apply stands_add_same; trivial; lia).
  assert (D : power l <= add rounded r' n') by (apply rnd_at_least; [lia|exact (denominator K)]).
  assert (P := bpow_gt_0 radix2 l).
  assert (quo : stands (a + 1 - l) (div machine (sub machine d e) (add machine r n)) (div rounded (sub rounded d' e') (add rounded r' n'))).
  { apply (stands_div (a + 1) (b + 1) (a + 1 - l) _ _ _ _ ltac:(lia) num den); [lra|].
    destruct num as (_ & _ & B). unfold Rdiv. rewrite Rabs_mult.
    unfold Z.sub at 1. rewrite bpow_plus, bpow_opp.
    apply Rmult_le_compat; [apply Rabs_pos|apply Rabs_pos|exact B|].
    rewrite Rabs_inv, Rabs_pos_eq by lra. apply Rinv_le; [exact P|exact D]. }
  destruct (stands_mul (a + 1 - l) 0 _ _ _ _ ltac:(lia) quo tail) as (F & V & _). split; [exact F|exact V].
Qed.

(* Without certified tolerances: the same sign. *)
Lemma decide_sign_stands : stands_sign (decide machine d r e n false) (decide rounded d' r' e' n' false).
Proof.
  assert (slack : stands (-10) filter_slack (value filter_slack)) by (eapply stands_constant; [reflexivity| |]; vm_compute; easy).
  unfold decide. change (less machine) with PrimFloat.ltb. change (less rounded) with Rlt_bool.
  change (opposite machine e) with (- e)%float. change (opposite rounded e') with (- e').
  rewrite (stands_ltb _ _ _ _ _ _ Hd (stands_opp _ _ _ He)). case Rlt_bool; [exact I|].
  pose proof (stands_mul a (-10) _ _ _ _ ltac:(lia) Hd slack) as dm.
  change (mul machine d (constant machine filter_slack)) with (d * filter_slack)%float.
  change (mul rounded d' (constant rounded filter_slack)) with (rnd (d' * value filter_slack)).
  rewrite (stands_ltb _ _ _ _ _ _ He dm). case Rlt_bool; exact I.
Qed.

Lemma decide_said certified : stands_said certified (decide machine d r e n certified) (decide rounded d' r' e' n' certified).
Proof. destruct certified; [exact decide_stands|exact decide_sign_stands]. Qed.
End decide.
