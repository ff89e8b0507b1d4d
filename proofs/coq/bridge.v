(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Primitive floats compute what rounded reals do, as long as nothing overflows. Coq's floats are specified by SpecFloat; Flocq
   relates these to its binary64 and to rounding of reals. Here: one lemma an operation that carries a bound 2^a along, so
   that absence of overflow is a sum of exponents. *)
From Coq Require Import Reals ZArith Lia Lra.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import operations.
Close Scope float_scope.
Open Scope R_scope.

Notation power := (bpow radix2).
Definition finite (f : float) := BinarySingleNaN.is_finite (Prim2B f).

(* f is finite, stands for r, and |r| <= 2^a. *)
Definition stands (a : Z) (f : float) (r : R) := finite f = true /\ value f = r /\ Rabs r <= power a.

#[export] Instance valid : Valid_exp (FLT_exp (-1074) 53).
Proof. apply FLT_exp_valid. reflexivity. Qed.

Lemma rnd_power : forall a, (-1074 <= a)%Z -> rnd (power a) = power a.
Proof.
  intros a H. apply round_generic; auto with typeclass_instances.
  apply generic_format_bpow. unfold FLT_exp. lia.
Qed.

Lemma rnd_bound : forall a r, (-1074 <= a)%Z -> Rabs r <= power a -> Rabs (rnd r) <= power a.
Proof.
  intros a r Ha H. destruct (Rabs_le_inv _ _ H) as [L U]. apply Rabs_le. split.
  - rewrite <- (rnd_power a Ha), <- round_NE_opp. apply round_le; auto with typeclass_instances.
  - rewrite <- (rnd_power a Ha). apply round_le; auto with typeclass_instances.
Qed.

Lemma no_overflow : forall a r, (-1074 <= a < 1024)%Z -> Rabs r <= power a -> Rlt_bool (Rabs (rnd r)) (power 1024) = true.
Proof.
  intros a r Ha H. apply Rlt_bool_true. apply Rle_lt_trans with (power a).
  - apply rnd_bound; [lia|exact H].
  - apply bpow_lt. lia.
Qed.

Lemma stands_wider : forall a b f r, (a <= b)%Z -> stands a f r -> stands b f r.
Proof. intros a b f r H (F & V & B). repeat split; trivial. apply Rle_trans with (1 := B), bpow_le, H. Qed.

Lemma stands_tighter : forall a b f r, stands a f r -> Rabs r <= power b -> stands b f r.
Proof. intros a b f r (F & V & B) H. repeat split; trivial. Qed.

Lemma power_sum : forall a b r s, Rabs r <= power a -> Rabs s <= power b -> Rabs r + Rabs s <= power (Z.max a b + 1).
Proof.
  intros a b r s R S. rewrite bpow_plus. simpl (power 1).
  assert (power a <= power (Z.max a b)) by (apply bpow_le; lia).
  assert (power b <= power (Z.max a b)) by (apply bpow_le; lia). lra.
Qed.

Lemma stands_add : forall a b f g r s, (-1074 <= Z.max a b + 1 < 1024)%Z ->
  stands a f r -> stands b g s -> stands (Z.max a b + 1) (f + g)%float (rnd (r + s)).
Proof.
  intros a b f g r s H (Ff & Vf & Bf) (Fg & Vg & Bg).
  assert (B : Rabs (r + s) <= power (Z.max a b + 1)) by (apply Rle_trans with (1 := Rabs_triang r s), power_sum; trivial).
  generalize (Bplus_correct prec emax (eq_refl Lt) (eq_refl Lt) mode_NE (Prim2B f) (Prim2B g) Ff Fg).
  unfold value in Vf, Vg. rewrite Vf, Vg.
  change (round radix2 (SpecFloat.fexp prec emax) (round_mode mode_NE)) with (round radix2 (FLT_exp (-1074) 53) ZnearestE).
  change (power emax) with (power 1024).
  rewrite (no_overflow _ _ H B). intros (V & F & _).
  unfold stands, finite, value. rewrite add_equiv. split; [exact F|split; [exact V|]]. apply rnd_bound; [lia|exact B].
Qed.

Lemma stands_sub : forall a b f g r s, (-1074 <= Z.max a b + 1 < 1024)%Z ->
  stands a f r -> stands b g s -> stands (Z.max a b + 1) (f - g)%float (rnd (r - s)).
Proof.
  intros a b f g r s H (Ff & Vf & Bf) (Fg & Vg & Bg).
  assert (B : Rabs (r - s) <= power (Z.max a b + 1)).
  { apply Rle_trans with (Rabs r + Rabs s); [|apply power_sum; trivial].
    unfold Rminus. rewrite <- (Rabs_Ropp s). apply Rabs_triang. }
  generalize (Bminus_correct prec emax (eq_refl Lt) (eq_refl Lt) mode_NE (Prim2B f) (Prim2B g) Ff Fg).
  unfold value in Vf, Vg. rewrite Vf, Vg.
  change (round radix2 (SpecFloat.fexp prec emax) (round_mode mode_NE)) with (round radix2 (FLT_exp (-1074) 53) ZnearestE).
  change (power emax) with (power 1024).
  rewrite (no_overflow _ _ H B). intros (V & F & _).
  unfold stands, finite, value. rewrite sub_equiv. split; [exact F|split; [exact V|]]. apply rnd_bound; [lia|exact B].
Qed.

Lemma stands_add_same : forall a f g r s, (-1074 <= a + 1 < 1024)%Z -> stands a f r -> stands a g s -> stands (a + 1) (f + g)%float (rnd (r + s)).
Proof. intros a f g r s H F G. rewrite <- (Z.max_id a) at 1. apply stands_add; rewrite ?Z.max_id; assumption. Qed.

Lemma stands_sub_same : forall a f g r s, (-1074 <= a + 1 < 1024)%Z -> stands a f r -> stands a g s -> stands (a + 1) (f - g)%float (rnd (r - s)).
Proof. intros a f g r s H F G. rewrite <- (Z.max_id a) at 1. apply stands_sub; rewrite ?Z.max_id; assumption. Qed.

Lemma stands_mul : forall a b f g r s, (-1074 <= a + b < 1024)%Z ->
  stands a f r -> stands b g s -> stands (a + b) (f * g)%float (rnd (r * s)).
Proof.
  intros a b f g r s H (Ff & Vf & Bf) (Fg & Vg & Bg).
  assert (B : Rabs (r * s) <= power (a + b)).
  { rewrite Rabs_mult, bpow_plus. apply Rmult_le_compat; trivial; apply Rabs_pos. }
  generalize (Bmult_correct prec emax (eq_refl Lt) (eq_refl Lt) mode_NE (Prim2B f) (Prim2B g)).
  unfold value in Vf, Vg. rewrite Vf, Vg.
  change (round radix2 (SpecFloat.fexp prec emax) (round_mode mode_NE)) with (round radix2 (FLT_exp (-1074) 53) ZnearestE).
  change (power emax) with (power 1024).
  rewrite (no_overflow _ _ H B). unfold finite in Ff, Fg. rewrite Ff, Fg. intros (V & F & _).
  unfold stands, finite, value. rewrite mul_equiv. split; [exact F|split; [exact V|]]. apply rnd_bound; [lia|exact B].
Qed.

Lemma stands_div : forall a b c f g r s, (-1074 <= c < 1024)%Z ->
  stands a f r -> stands b g s -> s <> 0 -> Rabs (r / s) <= power c -> stands c (f / g)%float (rnd (r / s)).
Proof.
  intros a b c f g r s H (Ff & Vf & Bf) (Fg & Vg & Bg) N B.
  generalize (Bdiv_correct prec emax (eq_refl Lt) (eq_refl Lt) mode_NE (Prim2B f) (Prim2B g)).
  unfold value in Vf, Vg. rewrite Vf, Vg.
  change (round radix2 (SpecFloat.fexp prec emax) (round_mode mode_NE)) with (round radix2 (FLT_exp (-1074) 53) ZnearestE).
  change (power emax) with (power 1024).
  intro D. specialize (D N). rewrite (no_overflow _ _ H B) in D. destruct D as (V & F & _).
  unfold stands, finite, value. rewrite div_equiv. split; [exact (eq_trans F Ff)|split; [exact V|]]. apply rnd_bound; [lia|exact B].
Qed.

Lemma stands_sqrt : forall a f r, (-1074 <= a)%Z -> stands (2 * a) f r -> 0 <= r -> stands a (PrimFloat.sqrt f) (rnd (R_sqrt.sqrt r)).
Proof.
  intros a f r H (Ff & Vf & Bf) P.
  generalize (Bsqrt_correct prec emax (eq_refl Lt) (eq_refl Lt) mode_NE (Prim2B f)).
  unfold value in Vf. rewrite Vf.
  change (round radix2 (SpecFloat.fexp prec emax) (round_mode mode_NE)) with rnd. intros (V & F & _).
  unfold stands, finite, value. rewrite sqrt_equiv. split; [|split; [exact V|]].
  - apply (eq_trans F). unfold finite in Ff. destruct (Prim2B f) as [s|s| |s m e h]; try easy.
    destruct s; [|reflexivity]. exfalso. subst r. revert P. apply Rlt_not_le.
    simpl. apply F2R_lt_0. reflexivity.
  - apply rnd_bound; [exact H|]. rewrite Rabs_pos_eq by apply sqrt_pos.
    replace (power a) with (R_sqrt.sqrt (power (2 * a))).
    + apply sqrt_le_1_alt. apply Rle_trans with (2 := Bf), Rle_abs.
    + replace (2 * a)%Z with (a + a)%Z by lia. rewrite bpow_plus. apply sqrt_square, bpow_ge_0.
Qed.

Lemma stands_opp : forall a f r, stands a f r -> stands a (- f)%float (- r).
Proof.
  intros a f r (Ff & Vf & Bf). unfold stands, finite, value in *. rewrite opp_equiv, is_finite_Bopp, B2R_Bopp, Vf, Rabs_Ropp.
  auto.
Qed.

Lemma stands_abs : forall a f r, stands a f r -> stands a (PrimFloat.abs f) (Rabs r).
Proof.
  intros a f r (Ff & Vf & Bf). unfold stands, finite, value in *. rewrite abs_equiv, is_finite_Babs, B2R_Babs, Vf, Rabs_Rabsolu.
  auto.
Qed.

Lemma stands_ltb : forall a b f g r s, stands a f r -> stands b g s -> (f <? g)%float = Rlt_bool r s.
Proof. intros a b f g r s (Ff & Vf & _) (Fg & Vg & _). rewrite ltb_equiv, Bltb_correct, <- Vf, <- Vg; trivial. Qed.

Lemma stands_leb : forall a b f g r s, stands a f r -> stands b g s -> (f <=? g)%float = Rle_bool r s.
Proof. intros a b f g r s (Ff & Vf & _) (Fg & Vg & _). rewrite leb_equiv, Bleb_correct, <- Vf, <- Vg; trivial. Qed.

Lemma stands_max : forall a b f g r s, stands a f r -> stands b g s ->
  stands (Z.max a b) (greater machine f g) (greater rounded r s).
Proof.
  intros a b f g r s F G. simpl. rewrite (stands_ltb _ _ _ _ _ _ F G).
  case Rlt_bool; [apply stands_wider with b|apply stands_wider with a]; trivial; lia.
Qed.

Lemma stands_max_same : forall a f g r s, stands a f r -> stands a g s -> stands a (greater machine f g) (greater rounded r s).
Proof. intros a f g r s F G. rewrite <- (Z.max_id a). now apply stands_max. Qed.

Lemma max_ge_l : forall r s, r <= greater rounded r s.
Proof. intros r s. simpl. case Rlt_bool_spec; lra. Qed.
Lemma max_ge_r : forall r s, s <= greater rounded r s.
Proof. intros r s. simpl. case Rlt_bool_spec; lra. Qed.

Lemma less_of_values : forall f g, finite f = true -> finite g = true -> (f <? g)%float = Rlt_bool (value f) (value g).
Proof. intros f g F G. rewrite ltb_equiv. now apply Bltb_correct. Qed.

(* The least of some numbers as std::min keeps it, from infinity on: what is less than it is less than each. *)
Lemma less_infinity : forall f, finite f = true -> (f <? infinity)%float = true.
Proof.
  intros f. rewrite ltb_equiv, infinity_equiv, Prim2B_B2Prim. unfold finite.
  destruct (Prim2B f) as [s|s| |s m e H]; try discriminate; now destruct s.
Qed.

Lemma less_than_least : forall A (out : A -> float) ps e l, finite e = true -> (forall p, List.In p ps -> finite (out p) = true) ->
  (l = infinity \/ finite l = true) -> (e <? List.fold_left (fun l p => if (out p <? l)%float then out p else l) ps l)%float = true ->
  (e <? l)%float = true /\ forall p, List.In p ps -> (e <? out p)%float = true.
Proof.
  intros A out ps e l E. revert l. induction ps as [|p ps IH]; intros l Fin L H; [split; [exact H|easy]|].
  assert (Fp : finite (out p) = true) by (apply Fin; now left). cbn [List.fold_left] in H.
  assert (Fps : forall q, List.In q ps -> finite (out q) = true) by (intros; apply Fin; now right).
  assert (K : (e <? l)%float = true /\ (e <? out p)%float = true /\ forall q, List.In q ps -> (e <? out q)%float = true).
  { destruct L as [-> | L].
    - rewrite less_infinity in H by exact Fp. destruct (IH _ Fps (or_intror Fp) H) as [Ep Eq]. split; [now apply less_infinity|now split].
    - destruct (out p <? l)%float eqn:C; [destruct (IH _ Fps (or_intror Fp) H) as [Ep Eq]|destruct (IH _ Fps (or_intror L) H) as [El Eq]];
        rewrite !less_of_values in * by assumption.
      + split; [|now split]. apply Rlt_bool_true. revert C Ep. case Rlt_bool_spec; [|easy]. case Rlt_bool_spec; [|easy]. lra.
      + split; [exact El|]. split; [|exact Eq]. apply Rlt_bool_true. revert C El. case Rlt_bool_spec; [easy|]. case Rlt_bool_spec; [|easy]. lra. }
  destruct K as (El & Ep & Eq). split; [exact El|]. intros q [<- | I]; [exact Ep|now apply Eq].
Qed.
