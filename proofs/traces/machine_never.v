(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* machine_rounds.v for expiries above 2^1000 and for the one that never comes, which an empty list has: infinity in the machine and 2^1024 among the
   reals. Whatever the machine makes of them is far above all that it is compared with, in both.

   - threshold_of_any    set_threshold, of any expiry
   - worn_expiry         whether a displacement budget is to start again, in reals; worn_expiry_of_any
   - same_stands         whether two coordinates are the same *)
From Coq Require Import Reals ZArith Lia Lra List Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require float_model float_error float_displacement.
From Annulus Require Import algorithm_list truncated_double filter_doubles.
From Annulus Require Import operations bridge.
From Annulus_traces Require Import machine machine_rounds.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

(* At least 2^a, or infinity. *)
Definition above (a : Z) (f : float) : Prop := f = infinity \/ finite f = true /\ power a <= real f.

Lemma is_infinity f : B2SF (Prim2B f) = S754_infinity false -> f = infinity.
Proof. intro H. rewrite B2SF_Prim2B in H. rewrite <- (SF2Prim_Prim2SF f), H. reflexivity. Qed.
Lemma of_infinity : Prim2B infinity = B754_infinity false.
Proof. apply B2SF_inj. now rewrite B2SF_Prim2B. Qed.

Lemma real_below f : real f < power 1024.
Proof. apply Rle_lt_trans with (1 := Rle_abs _). exact (abs_B2R_lt_emax prec emax (Prim2B f)). Qed.
Lemma rnd_real f : rnd (real f) = real f.
Proof. apply round_generic; auto with typeclass_instances. exact (generic_format_B2R prec emax (Prim2B f)). Qed.

Lemma above_sub a f b : (-1000 <= a)%Z -> above (a + 1) f -> finite b = true -> 0 <= real b <= power a -> above a (f - b)%float.
Proof.
  intros Low [->|[Fin L]] B [B0 B1].
  - left. apply is_infinity. rewrite sub_equiv, of_infinity. unfold finite in B. now destruct (Prim2B b).
  - right. assert (D : power a <= real f - real b) by (rewrite bpow_plus in L; change (power 1) with 2 in L; generalize (bpow_gt_0 radix2 a); lra).
    assert (U : rnd (real f - real b) <= real f) by (rewrite <- (rnd_real f) at 2; apply round_le; auto with typeclass_instances; lra).
    assert (P : power a <= rnd (real f - real b)) by (rewrite <- (rnd_power a) by lia; apply round_le; auto with typeclass_instances).
    generalize (Bminus_correct prec emax (eq_refl Lt) (eq_refl Lt) mode_NE (Prim2B f) (Prim2B b) Fin B).
    change (round radix2 (SpecFloat.fexp prec emax) (round_mode mode_NE)) with rnd. fold (real f) (real b). change (power emax) with (power 1024).
    rewrite Rlt_bool_true.
    + intros (V & F & _). unfold finite. rewrite sub_equiv. split; [exact F|]. unfold operations.value. rewrite sub_equiv. apply Rle_trans with (1 := P), Req_le. symmetry. exact V.
    + rewrite Rabs_pos_eq by (generalize (bpow_gt_0 radix2 a); lra). apply Rle_lt_trans with (1 := U), real_below.
Qed.

Lemma sign_of_positive f : 0 < real f -> Bsign (Prim2B f) = false.
Proof.
  unfold operations.value. destruct (Prim2B f) as [s|s| |s m e H]; intro P; try (exfalso; simpl in P; lra). destruct s; [|reflexivity].
  exfalso. apply (Rlt_not_le _ _ P). now apply F2R_le_0.
Qed.
Lemma times_commutes f g : (f * g)%float = (g * f)%float.
Proof.
  rewrite <- (SF2Prim_Prim2SF (f * g)), <- (SF2Prim_Prim2SF (g * f)), !mul_spec. f_equal. unfold SF64mul.
  destruct (Prim2SF f) as [[|]|[|]| |s m e], (Prim2SF g) as [[|]|[|]| |t n d]; try reflexivity; try (now destruct s); try (now destruct t).
  cbn [SpecFloat.SFmul]. now rewrite xorb_comm, Pos.mul_comm, Z.add_comm.
Qed.

Lemma above_mul a k f g : (-1000 <= a + k)%Z -> above a f -> finite g = true -> power k <= real g -> above (a + k) (f * g)%float.
Proof.
  intros Low A G K. assert (G0 : 0 < real g) by (generalize (bpow_gt_0 radix2 k); lra).
  assert (Sign := sign_of_positive g G0).
  destruct A as [->|[Fin L]].
  - left. apply is_infinity. rewrite mul_equiv, of_infinity. unfold finite in G. unfold operations.value in G0.
    destruct (Prim2B g) as [s| | |s m e H]; try discriminate G; [simpl in G0; lra|]. simpl in Sign. now subst s.
  - assert (F0 : 0 < real f) by (generalize (bpow_gt_0 radix2 a); lra).
    assert (SignF := sign_of_positive f F0).
    assert (P : power (a + k) <= rnd (real f * real g)).
    { rewrite <- (rnd_power (a + k)) by lia. apply round_le; auto with typeclass_instances. rewrite bpow_plus.
      apply Rmult_le_compat; trivial; apply bpow_ge_0. }
    generalize (Bmult_correct prec emax (eq_refl Lt) (eq_refl Lt) mode_NE (Prim2B f) (Prim2B g)).
    change (round radix2 (SpecFloat.fexp prec emax) (round_mode mode_NE)) with rnd. fold (real f) (real g). unfold finite in Fin, G.
    rewrite Fin, G, SignF, Sign. case Rlt_bool.
    + intros (V & F & _). right. unfold finite. rewrite mul_equiv. split; [exact F|]. unfold operations.value. rewrite mul_equiv. apply Rle_trans with (1 := P), Req_le. symmetry. exact V.
    + intro O. left. apply is_infinity. rewrite mul_equiv. exact O.
Qed.

Lemma above_greater a f g s : above a f -> stands a g s -> s < power a -> (f <? g)%float = false /\ (g <? f)%float = true.
Proof.
  intros [->|[F L]] G S.
  - destruct G as (G & _ & _). unfold finite in G. rewrite !ltb_equiv, of_infinity. now destruct (Prim2B g) as [|[|]| |[|]].
  - rewrite (less_stands _ _ _ _ _ _ (any_stands f F) G), (less_stands _ _ _ _ _ _ G (any_stands f F)).
    split; destruct (Rlt_dec _ _); trivial; lra.
Qed.

Lemma from_never e : (never <= e)%Z -> power 1024 <= truncated_double.value e.
Proof. intro E. rewrite <- value_never. apply value_le. unfold never in *. lia. Qed.
Lemma far_value e : (0 <= e)%Z -> power 1000 < truncated_double.value e -> above 1000 (value_of e).
Proof.
  intros E B. destruct (Z.lt_ge_cases e never) as [L|L]; [right|left].
  - destruct (value_is e ltac:(lia)) as (F & V & _). split; [exact F|]. rewrite V. lra.
  - unfold value_of. now rewrite (proj2 (Z.ltb_ge _ _) L).
Qed.
Lemma near_value e : (0 <= e)%Z -> truncated_double.value e <= power 1000 -> (0 <= e < never)%Z.
Proof.
  intros E B. split; [exact E|]. destruct (Z.lt_ge_cases e never) as [|L]; [assumption|exfalso].
  assert (power 1000 < power 1024) by (apply bpow_lt; lia). generalize (from_never e L). lra.
Qed.

Section base.
Variables (e : Z) (b : float).
Hypothesis E : (0 <= e)%Z.
Hypothesis B : stands 999 b (real b).
Hypothesis smaller : real b < power 999.
Hypothesis B0 : 0 <= real b.

Lemma base_upper : real b <= power 999.
Proof. destruct B as (_ & _ & H). now rewrite Rabs_pos_eq in H. Qed.

Lemma far_rest : power 1000 < truncated_double.value e -> above 999 (value_of e - b)%float.
Proof.
  intro F. apply (above_sub 999); [lia|now apply far_value|apply B|]. split; [exact B0|exact base_upper].
Qed.

Theorem threshold_of_any : stands 1021 (value_of (half_of half_mask_32 (squared_threshold_lower (slack e b)))) (threshold e (real b)).
Proof.
  destruct (Rle_lt_dec (truncated_double.value e) (power 1000)) as [N|F].
  { apply threshold_stands; [now apply near_value|exact N|]. apply stands_wider with 999%Z; [lia|exact B]. }
  apply kept_stands. assert (S : above 998 (slack e b)).
  { apply (above_mul 999 (-1)); [lia|now apply far_rest|reflexivity|]. rewrite (real_of 0x1.ffffffffffff8p-1%float 9007199254740984 (-53) eq_refl).
    change (power (-1)) with (/ 2). change (power (-53)) with (/ 9007199254740992). simpl. lra. }
  assert (Big : stands 998 0x1p510%float (power 510)) by (apply stands_wider with 510%Z; [lia|exact (power_stands 0x1p510%float 458 510 eq_refl eq_refl)]).
  assert (Small : stands 998 0x1p-450%float (power (-450))) by (apply stands_wider with (-450)%Z; [lia|exact (power_stands 0x1p-450%float (-502) (-450) eq_refl eq_refl)]).
  unfold squared_threshold_lower. rewrite (proj2 (above_greater _ _ _ _ S Small (bpow_lt radix2 (-450) 998 ltac:(lia)))).
  rewrite (proj2 (above_greater _ _ _ _ S Big (bpow_lt radix2 510 998 ltac:(lia)))). cbn [negb].
  replace (float_displacement.threshold (truncated_double.value e) (real b)) with (power 1020).
  { apply stands_wider with 1020%Z; [lia|]. exact (power_stands 0x1p1020%float 968 1020 eq_refl eq_refl). }
  unfold float_displacement.threshold, float_displacement.squared_threshold_lower.
  assert (L : power 998 <= float_error.fmul (float_error.fsub (truncated_double.value e) (real b)) (1 - 8 * float_model.u)).
  { change (power 998 <= rnd (rnd (truncated_double.value e - real b) * (1 - 8 * float_model.u))).
    assert (D : power 999 <= rnd (truncated_double.value e - real b)).
    { rewrite <- (rnd_power 999) by lia. apply round_le; auto with typeclass_instances. generalize base_upper.
      change 1000%Z with (999 + 1)%Z in F. rewrite bpow_plus in F. change (power 1) with 2 in F. lra. }
    rewrite <- (rnd_power 998) by lia. apply round_le; auto with typeclass_instances.
    change 999%Z with (998 + 1)%Z in D. rewrite bpow_plus in D. change (power 1) with 2 in D. generalize (bpow_gt_0 radix2 998). intro P.
    assert (U : / 2 <= 1 - 8 * float_model.u) by (unfold float_model.u; change (power (-53)) with (/ 9007199254740992); lra).
    apply Rle_trans with (power 998 * 2 * / 2); [lra|]. apply Rmult_le_compat; lra. }
  set (d := float_error.fmul _ _) in *.
  assert (power (-450) < power 998) by (apply bpow_lt; lia). assert (power 510 < power 998) by (apply bpow_lt; lia).
  destruct (Rlt_dec _ d) as [_|N]; [|lra]. destruct (Rlt_dec _ d) as [_|N]; [reflexivity|lra].
Qed.

Variable ratio : float.
Hypothesis R1 : 1 <= real ratio.
Hypothesis R2 : stands 20 ratio (real ratio).
Definition worn_expiry (b : R) : bool :=
  if Rle_dec (truncated_double.value e) (power 1000) then if Rlt_dec (rnd (real ratio * rnd (truncated_double.value e - b))) b then true else false else false.
Theorem worn_expiry_of_any : (ratio * (value_of e - b) <? b)%float = worn_expiry (real b).
Proof.
  unfold worn_expiry. destruct (Rle_dec _ _) as [N|F].
  - assert (S := stands_sub 1000 999 _ _ _ _ ltac:(lia) (value_stands e 1000 (near_value e E N) N) B).
    exact (less_stands _ _ _ _ _ _ (stands_mul 20 1001 _ _ _ _ ltac:(lia) R2 S) B).
  - apply Rnot_le_lt in F. assert (Q := far_rest F).
    assert (M : above (999 + 0) (ratio * (value_of e - b))%float) by (rewrite times_commutes; apply above_mul; [lia|exact Q|apply R2|exact R1]).
    apply (proj1 (above_greater _ _ _ _ M B smaller)).
Qed.
End base.

Theorem same_stands a b : finite a = true -> finite b = true -> (a =? b)%float = Req_bool (real a) (real b).
Proof. intros A B. rewrite eqb_equiv. exact (Beqb_correct prec emax (Prim2B a) (Prim2B b) A B). Qed.
