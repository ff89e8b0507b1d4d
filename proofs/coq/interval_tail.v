(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the interval stages of both dimensions share, around the formulas: src/annulus/predicate/interval_stage.h as interval_2.v has it.

   - scale_good            of coordinates in the domain the factors of the scale are finite and positive, whatever the differences
   - holds_difference      the interval of a scaled difference holds it
   - in_slack_lower           what quotient_lower_in_slack gives is at most determinant over roots, and finite
   - back_lower            the scale undone: still at most the truth, and finite *)
From Coq Require Import Reals Lra Lia Psatz ZArith Bool List.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import operations bridge bridge_decide float_directed filter_2 connect interval_2 float_interval.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.
Notation is_finite := BinarySingleNaN.is_finite.

(* ---- The scale ---- *)

Definition good (e : double) : Prop := is_finite e = true /\ 0 < B2R e.
Definition first_of (s : option (double * double)) : double := match s with None => of_float 1%float | Some (f, _) => f end.
Definition second_of (s : option (double * double)) : double := match s with None => of_float 1%float | Some (_, g) => g end.
Definition scale_factor (s : option (double * double)) : R := B2R (first_of s) * B2R (second_of s).
Definition good_scale (s : option (double * double)) : Prop := good (first_of s) /\ good (second_of s).

Lemma one_is : is_finite (of_float 1%float) = true /\ B2R (of_float 1%float) = 1.
Proof. split; [reflexivity|]. change (value 1%float = 1). rewrite (value_power 1%float (-52) eq_refl). reflexivity. Qed.

Lemma power_of_two_good h : (-1074 <= h <= 1023)%Z -> good (power_of_two h).
Proof.
  intro H. unfold good, power_of_two, of_float. rewrite ldexp_equiv.
  match goal with |- context [@Bldexp _ _ ?p ?q _ _ _] => generalize (Bldexp_correct prec emax p q mode_NE (Prim2B 1%float) h) end.
  change (B2R (Prim2B 1%float)) with (B2R (of_float 1%float)). rewrite (proj2 one_is), Rmult_1_l.
  change (round radix2 (SpecFloat.fexp prec emax) (round_mode mode_NE)) with (round radix2 (FLT_exp (-1074) 53) ZnearestE).
  rewrite rnd_power by lia. rewrite Rabs_pos_eq by apply bpow_ge_0. rewrite Rlt_bool_true by (apply bpow_lt; unfold emax; lia).
  intros (V & F & _). rewrite V, F. split; [reflexivity|apply bpow_gt_0].
Qed.

Definition moderate (m : double) : Prop := is_finite m = true /\ 0 <= B2R m <= power 501.

Lemma split_good m : moderate m -> good (fst (split_scale m)) /\ good (snd (split_scale m)).
Proof.
  intros [F [P U]]. unfold split_scale. cbv zeta. cbn [fst snd].
  assert (K : let k := if below nought m then Z.opp (snd (Z.frexp (to_float m))) else 0%Z in (-502 <= k <= 1073)%Z).
  { cbv zeta. unfold below. rewrite Bltb_correct by (trivial; reflexivity). change (B2R nought) with 0. case Rlt_bool_spec; intro L; [|lia].
    generalize (frexp_equiv (to_float m)). destruct (Z.frexp (to_float m)) as [z e]. unfold to_float. rewrite Prim2B_B2Prim. intro E. cbn [snd].
    assert (S : BinarySingleNaN.is_finite_strict m = true) by (destruct m; simpl in *; try easy; lra).
    match type of E with _ = @Bfrexp _ _ ?p _ => generalize (Bfrexp_correct prec emax p m S) end. rewrite <- E. intros [_ M]. destruct (M eq_refl) as [_ ->].
    assert (A : Rabs (B2R m) = B2R m) by (apply Rabs_pos_eq; lra).
    assert (L1 : (mag radix2 (B2R m) <= 502)%Z).
    { apply mag_le_bpow; [lra|]. rewrite A. apply Rle_lt_trans with (1 := U). apply bpow_lt. lia. }
    assert (L2 : (-1073 <= mag radix2 (B2R m))%Z).
    { apply mag_ge_bpow. rewrite A. apply generic_format_ge_bpow with (FLT_exp (-1074) 53); trivial.
      - intro x. unfold FLT_exp. lia.
      - apply (generic_format_B2R prec emax). }
    lia. }
  cbv zeta in K. set (k := if below nought m then _ else _) in *. clearbody k.
  assert (Q : (-1074 <= Z.quot k 2 <= 1023 /\ -1074 <= k - Z.quot k 2 <= 1023)%Z).
  { generalize (Z.quot_rem' k 2). generalize (Z.rem_bound_abs k 2 ltac:(lia)). lia. }
  split; apply power_of_two_good; apply Q.
Qed.

Lemma difference_moderate i j : coordinate i -> coordinate j -> moderate (Babs (minus mode_UP (of_float i) (of_float j))).
Proof.
  intros [Fi Bi] [Fj Bj]. generalize (Bminus_correct prec emax (eq_refl Lt) (eq_refl Lt) mode_UP (Prim2B i) (Prim2B j) Fi Fj).
  assert (B : Rabs (round radix2 (SpecFloat.fexp prec emax) (round_mode mode_UP) (B2R (Prim2B i) - B2R (Prim2B j))) <= power 501).
  { assert (V : Valid_exp (SpecFloat.fexp prec emax)) by (apply (fexp_correct prec emax); reflexivity). apply abs_round_le_generic; auto with typeclass_instances.
    - apply generic_format_bpow. unfold SpecFloat.fexp, SpecFloat.emin, prec, emax. lia.
    - change 501%Z with (1 + 500)%Z. rewrite bpow_plus. change (power 1) with 2. unfold Rminus. apply Rle_trans with (1 := Rabs_triang _ _).
      rewrite Rabs_Ropp. unfold value in Bi, Bj. lra. }
  rewrite Rlt_bool_true by (apply Rle_lt_trans with (1 := B), bpow_lt; unfold emax; lia).
  intros (V & F & _). unfold moderate, minus, of_float. rewrite is_finite_Babs, B2R_Babs, V. split; [exact F|]. split; [apply Rabs_pos|exact B].
Qed.

Lemma most_moderate a b : moderate a -> moderate b -> moderate (most a b).
Proof. intros A B. unfold most. now destruct (below a b). Qed.

Lemma scale_good l : (forall i j, In (i, j) l -> coordinate i /\ coordinate j) -> good_scale (scale_of (largest_coordinate l)).
Proof.
  intro D. assert (M : moderate (largest_coordinate l)).
  { unfold largest_coordinate. assert (Z : moderate nought) by (split; [reflexivity|change (B2R nought) with 0; split; [lra|apply bpow_ge_0]]).
    revert D Z. generalize nought. induction l as [|[i j] l IH]; intros m D Z; [exact Z|]. simpl. apply IH.
    - intros i' j' I. apply D. now right.
    - apply most_moderate; [exact Z|]. destruct (D i j (or_introl eq_refl)). now apply difference_moderate. }
  unfold scale_of. assert (O : good (of_float 1%float)) by (split; [apply one_is|rewrite (proj2 one_is); lra]).
  destruct (unscaled _); [now split|]. assert (S := split_good _ M). unfold good_scale, first_of, second_of. now destruct (split_scale _).
Qed.

Lemma holds_difference s i j : good_scale s -> finite i = true -> finite j = true ->
  holds (i_difference s i j) ((value i - value j) * scale_factor s).
Proof.
  intros [[A A'] [B B']] Fi Fj. assert (H : holds (i_sub (exactly (of_float i)) (exactly (of_float j))) (value i - value j)).
  { apply holds_sub; now apply holds_exactly. }
  unfold i_difference, scale_factor. destruct s as [[f g]|]; cbn [first_of second_of] in *.
  - rewrite <- Rmult_assoc. apply holds_mul; [apply holds_mul; trivial; now apply holds_exactly|now apply holds_exactly].
  - rewrite (proj2 one_is), !Rmult_1_r. exact H.
Qed.

(* ---- The tail ---- *)

Lemma sum_of_roots_above a b x y : 0 <= x -> 0 <= y -> above a x -> above b y -> above (sum_of_roots a b) (R_sqrt.sqrt x + R_sqrt.sqrt y).
Proof. intros X Y A B. apply above_plus; now apply above_root. Qed.

Lemma positive_end a x : below nought (lower a) = true -> holds a x -> is_finite (lower a) = true /\ 0 < B2R (lower a) <= x.
Proof.
  intros P [[[F L]|E] _]; [|rewrite E in P; discriminate P]. unfold below in P. rewrite Bltb_correct in P by (trivial; reflexivity).
  revert P. case Rlt_bool_spec; intros; [|discriminate]. change (B2R nought) with 0 in *. auto.
Qed.
Lemma negative_end a x : below (upper a) nought = true -> holds a x -> x < 0.
Proof.
  intros P [_ [[F L]|E]]; [|rewrite E in P; discriminate P]. unfold below in P. rewrite Bltb_correct in P by (trivial; reflexivity).
  revert P. case Rlt_bool_spec; intros; [|discriminate]. change (B2R nought) with 0 in *. lra.
Qed.

Lemma in_slack_lower det most_roots least_roots low x roots : below nought (lower det) = true -> holds det x -> 0 < roots -> above most_roots roots ->
  quotient_lower_in_slack det most_roots least_roots = Some low -> is_finite low = true /\ 0 <= B2R low <= x / roots.
Proof.
  intros P H Y A T. unfold quotient_lower_in_slack in T. destruct (positive_end _ _ P H) as (F & L).
  destruct (Bleb _ _); [|discriminate]. injection T as <-.
  destruct (quotient_down prec emax (eq_refl Lt) (eq_refl Lt) (lower det) most_roots roots F ltac:(lra) A Y) as (Q & Q0 & Q1).
  split; [exact Q|]. split; [exact Q0|]. apply Rle_trans with (1 := Q1). apply quotient_le; lra.
Qed.

Lemma good_quotient a b t : is_finite a = true -> 0 <= B2R a <= t * B2R b -> good b ->
  is_finite (quotient_lower a b) = true /\ 0 <= B2R (quotient_lower a b) <= t.
Proof.
  intros F H [G P]. assert (A : above b (B2R b)) by (left; split; [exact G|apply Rle_refl]).
  destruct (quotient_down prec emax (eq_refl Lt) (eq_refl Lt) a b (B2R b) F (proj1 H) A P) as (Q & Q0 & Q1).
  split; [exact Q|]. split; [exact Q0|]. apply Rle_trans with (1 := Q1). apply Rmult_le_reg_r with (B2R b); [exact P|].
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.

Lemma back_lower s low t : good_scale s -> is_finite low = true -> 0 <= B2R low <= t * scale_factor s ->
  finite (to_float (back s low)) = true /\ 0 <= value (to_float (back s low)) <= t.
Proof.
  intros [A B] F H. unfold finite, value, to_float. rewrite Prim2B_B2Prim.
  assert (E : back s low = quotient_lower (quotient_lower low (first_of s)) (second_of s)) by (unfold back; now destruct s as [[f g]|]).
  rewrite E. unfold scale_factor in H. destruct (good_quotient low (first_of s) (t * B2R (second_of s)) F) as (F' & H'); [split; [apply H|]|exact A|].
  - apply Rle_trans with (1 := proj2 H). right. ring.
  - now apply good_quotient.
Qed.
