(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* From real numbers of the format to IEEE 754 binary64 data, Flocq's binary_float 53 1024 with infinities and NaN: no operation of
   the filter stage overflows inside its range, so it computes the very numbers of the model (float_model.v). *)
Require Import Reals Lra Psatz ZArith.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Annulus Require Import float_model float_error float_tail float_filter.
Open Scope R_scope.

Notation bin := (binary_float 53 1024).
Global Instance prec_emax : Prec_lt_emax 53 1024 := eq_refl.

Definition badd : bin -> bin -> bin := Bplus mode_NE.
Definition bsub : bin -> bin -> bin := Bminus mode_NE.
Definition bmul : bin -> bin -> bin := Bmult mode_NE.
Definition bdiv : bin -> bin -> bin := Bdiv mode_NE.
Definition bsqrt : bin -> bin := Bsqrt mode_NE.
(* z 2^e *)
Definition constant (z e : Z) : bin := binary_normalize 53 1024 _ _ mode_NE z e false.
(* std::max *)
Definition bmax (x y : bin) : bin := if Bltb x y then y else x.

(* x is a finite number, it is r, and |r| <= 2^k. *)
Definition rep (x : bin) (r : R) (k : Z) : Prop := is_finite x = true /\ B2R x = r /\ Rabs r <= bpow radix2 k.

Lemma rep_F x r k : rep x r k -> F r.
Proof. intros (_ & <- & _). exact (generic_format_B2R 53 1024 x). Qed.

Lemma rep_wider x r k l : (k <= l)%Z -> rep x r k -> rep x r l.
Proof. intros L (A & B & C). repeat split; try assumption. apply Rle_trans with (1 := C). now apply bpow_le. Qed.

Lemma rnd_bpow x k : (-1074 <= k)%Z -> Rabs x <= bpow radix2 k -> Rabs (rnd x) <= bpow radix2 k.
Proof. intros K H. apply abs_round_le_generic; auto with typeclass_instances. now apply F_bpow. Qed.

Lemma no_overflow x k : (-1074 <= k <= 1023)%Z -> Rabs x <= bpow radix2 k ->
  Rlt_bool (Rabs (rnd x)) (bpow radix2 1024) = true.
Proof.
  intros K H. apply Rlt_bool_true. apply Rle_lt_trans with (bpow radix2 k); [apply rnd_bpow; [lia | exact H] | apply bpow_lt; lia].
Qed.

Lemma constant_rep z e k : (Z.abs z < 2 ^ 53)%Z -> (-1074 <= e)%Z -> (-1074 <= k <= 1023)%Z ->
  Rabs (IZR z * bpow radix2 e) <= bpow radix2 k -> rep (constant z e) (IZR z * bpow radix2 e) k.
Proof.
  intros Z E K H. generalize (binary_normalize_correct 53 1024 _ _ mode_NE z e false). cbv zeta.
  change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE) (F2R (Float radix2 z e))) with (rnd (IZR z * bpow radix2 e)).
  rewrite (no_overflow _ k K H), rnd_F by now apply F_int. intros (A & B & _). now repeat split.
Qed.

Lemma rep_add x y a b k : (-1075 <= k <= 1022)%Z -> rep x a k -> rep y b k -> rep (badd x y) (fadd a b) (k + 1).
Proof.
  intros K (Fx & <- & X) (Fy & <- & Y).
  assert (S : Rabs (B2R x + B2R y) <= bpow radix2 (k + 1)).
  { apply Rle_trans with (1 := Rabs_triang _ _). rewrite bpow_plus. change (bpow radix2 1) with 2. lra. }
  generalize (Bplus_correct 53 1024 _ _ mode_NE x y Fx Fy).
  change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE) (B2R x + B2R y)) with (rnd (B2R x + B2R y)).
  rewrite (no_overflow _ (k + 1) ltac:(lia) S). intros (A & B & _).
  split; [exact B |]. split; [exact A |]. apply rnd_bpow; [lia | exact S].
Qed.

Lemma rep_sub x y a b k : (-1075 <= k <= 1022)%Z -> rep x a k -> rep y b k -> rep (bsub x y) (fsub a b) (k + 1).
Proof.
  intros K (Fx & <- & X) (Fy & <- & Y).
  assert (S : Rabs (B2R x - B2R y) <= bpow radix2 (k + 1)).
  { unfold Rminus. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp, bpow_plus. change (bpow radix2 1) with 2. lra. }
  generalize (Bminus_correct 53 1024 _ _ mode_NE x y Fx Fy).
  change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE) (B2R x - B2R y)) with (rnd (B2R x - B2R y)).
  rewrite (no_overflow _ (k + 1) ltac:(lia) S). intros (A & B & _).
  split; [exact B |]. split; [exact A |]. apply rnd_bpow; [lia | exact S].
Qed.

Lemma rep_mul x y a b k l : (-1074 <= k + l <= 1023)%Z -> rep x a k -> rep y b l -> rep (bmul x y) (fmul a b) (k + l).
Proof.
  intros K (Fx & <- & X) (Fy & <- & Y).
  assert (S : Rabs (B2R x * B2R y) <= bpow radix2 (k + l)).
  { rewrite Rabs_mult, bpow_plus. apply Rmult_le_compat; try apply Rabs_pos; assumption. }
  generalize (Bmult_correct 53 1024 _ _ mode_NE x y).
  change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE) (B2R x * B2R y)) with (rnd (B2R x * B2R y)).
  rewrite (no_overflow _ (k + l) K S). rewrite Fx, Fy. intros (A & B & _).
  split; [exact B |]. split; [exact A |]. apply rnd_bpow; [lia | exact S].
Qed.

Lemma rep_div x y a b k l : (-1074 <= k - l <= 1023)%Z -> rep x a k -> is_finite y = true -> B2R y = b -> bpow radix2 l <= b ->
  rep (bdiv x y) (rnd (a / b)) (k - l).
Proof.
  intros K (Fx & <- & X) Fy <- L. generalize (bpow_gt_0 radix2 l). intro P.
  assert (S : Rabs (B2R x / B2R y) <= bpow radix2 (k - l)).
  { unfold Rdiv, Zminus. rewrite Rabs_mult, bpow_plus, bpow_opp. apply Rmult_le_compat; try apply Rabs_pos; [exact X |].
    rewrite Rabs_pos_eq by (left; apply Rinv_0_lt_compat; lra). apply Rinv_le; assumption. }
  generalize (Bdiv_correct 53 1024 _ _ mode_NE x y ltac:(lra)).
  change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE) (B2R x / B2R y)) with (rnd (B2R x / B2R y)).
  rewrite (no_overflow _ (k - l) K S), Fx. intros (A & B & _).
  split; [exact B |]. split; [exact A |]. apply rnd_bpow; [lia | exact S].
Qed.

(* Roots of sums of squares: never NaN. *)
Lemma rep_sqrt x a k : (0 <= k)%Z -> 0 <= a -> rep x a (k + k) -> rep (bsqrt x) (rnd (sqrt a)) k.
Proof.
  intros K P (Fx & <- & X). generalize (Bsqrt_correct 53 1024 _ _ mode_NE x). intros (A & B & _).
  split; [| split].
  - unfold bsqrt. rewrite B. destruct x as [s | s | | [|] mx ex Hx]; try reflexivity; try discriminate.
    exfalso. cbn in P. assert (F2R (Float radix2 (Zneg mx) ex) < 0) by now apply F2R_lt_0. lra.
  - exact A.
  - apply rnd_bpow; [lia |]. rewrite Rabs_pos_eq by apply sqrt_pos.
    rewrite <- (sqrt_square (bpow radix2 k)) by apply bpow_ge_0. apply sqrt_le_1_alt. rewrite <- bpow_plus.
    now rewrite Rabs_pos_eq in X.
Qed.

Lemma rep_opp x a k : rep x a k -> rep (Bopp x) (- a) k.
Proof. intros (Fx & <- & X). split; [now rewrite is_finite_Bopp |]. split; [apply B2R_Bopp | now rewrite Rabs_Ropp]. Qed.

Lemma rep_abs x a k : rep x a k -> rep (Babs x) (Rabs a) k.
Proof. intros (Fx & <- & X). split; [now rewrite is_finite_Babs |]. split; [apply B2R_Babs | now rewrite Rabs_Rabsolu]. Qed.

Lemma rep_lt x y a b k l : rep x a k -> rep y b l -> Bltb x y = Rlt_bool a b.
Proof. intros (Fx & <- & _) (Fy & <- & _). now apply Bltb_correct. Qed.

Lemma rep_le x y a b k l : rep x a k -> rep y b l -> Bleb x y = Rle_bool a b.
Proof. intros (Fx & <- & _) (Fy & <- & _). now apply Bleb_correct. Qed.

Lemma rep_max x y a b k : rep x a k -> rep y b k -> rep (bmax x y) (Rmax a b) k.
Proof.
  intros X Y. unfold bmax. rewrite (rep_lt _ _ _ _ _ _ X Y).
  destruct (Rlt_bool_spec a b); [rewrite Rmax_right by lra | rewrite Rmax_left by lra]; assumption.
Qed.

(* ---- Terms ---- *)

Fixpoint ieee (x : nat -> bin) (e : expr) : bin :=
  match e with
  | Var n => x n
  | Plus a b => badd (ieee x a) (ieee x b)
  | Minus a b => bsub (ieee x a) (ieee x b)
  | Times a b => bmul (ieee x a) (ieee x b)
  | Opp a => Bopp (ieee x a)
  end.

(* An exponent no value exceeds, when differences are at most 2^k. *)
Fixpoint exponent (k : Z) (e : expr) : Z :=
  match e with
  | Var _ => k
  | Plus a b | Minus a b => Z.max (exponent k a) (exponent k b) + 1
  | Times a b => exponent k a + exponent k b
  | Opp a => exponent k a
  end.

Lemma exponent_nonneg k e : (0 <= k)%Z -> (0 <= exponent k e)%Z.
Proof. intro. induction e; cbn [exponent]; lia. Qed.

Theorem ieee_terms k x r : (0 <= k)%Z -> (forall n, rep (x n) (r n) k) ->
  forall e, (exponent k e <= 1023)%Z -> rep (ieee x e) (rounded r e) (exponent k e).
Proof.
  intros K H. induction e as [n | a IHa b IHb | a IHa b IHb | a IHa b IHb | a IHa]; cbn [exponent ieee rounded]; intro L.
  - apply H.
  - generalize (exponent_nonneg k a K) (exponent_nonneg k b K). intros A B.
    apply rep_add; [lia | |]; (eapply rep_wider; [| first [apply IHa | apply IHb]; lia]); lia.
  - generalize (exponent_nonneg k a K) (exponent_nonneg k b K). intros A B.
    apply rep_sub; [lia | |]; (eapply rep_wider; [| first [apply IHa | apply IHb]; lia]); lia.
  - generalize (exponent_nonneg k a K) (exponent_nonneg k b K). intros A B.
    apply rep_mul; [lia | apply IHa; lia | apply IHb; lia].
  - apply rep_opp, IHa. exact L.
Qed.

(* ---- The last operations ---- *)

Definition slack_b : bin := constant 1 (-10).
Definition shrink_b : bin := constant (2 ^ 53 - 16) (-53).

(* decide with certified = true *)
Definition decide_b (det roots det_error norm_error : bin) : option (Z * bin) :=
  if Bltb det (Bopp det_error) then Some ((-1)%Z, constant 0 0)
  else if Bltb det_error (bmul det slack_b) then
    if Bltb norm_error (bmul roots slack_b)
    then Some (1%Z, bmul (bdiv (bsub det det_error) (badd roots norm_error)) shrink_b)
    else None
  else None.

Lemma slack_rep : rep slack_b filter_slack 0.
Proof.
  replace filter_slack with (IZR 1 * bpow radix2 (-10)) by (unfold filter_slack; change (bpow radix2 (-10)) with (/ 1024); lra).
  apply constant_rep; try lia. rewrite Rmult_1_l, Rabs_pos_eq by apply bpow_ge_0. apply bpow_le. lia.
Qed.

Lemma shrink_rep : rep shrink_b shrink 0.
Proof.
  assert (E : shrink = IZR (2 ^ 53 - 16) * bpow radix2 (-53)).
  { unfold shrink, u. change (IZR (2 ^ 53 - 16)) with 9007199254740976. change (bpow radix2 (-53)) with (/ 9007199254740992). lra. }
  rewrite E. apply constant_rep; try (cbn; lia). rewrite <- E. change (bpow radix2 0) with 1.
  rewrite Rabs_pos_eq; unfold shrink, u; lra.
Qed.

(* 500 and -430 are far from what the filters need; what matters is that their sum stays below 1024. *)
Theorem decide_ieee det roots e n DET ROOTS E N :
  rep det DET 500 -> rep roots ROOTS 500 -> rep e E 500 -> rep n N 500 -> 0 <= ROOTS -> bpow radix2 (-480) <= N ->
  decide DET ROOTS E N true =
  match decide_b det roots e n with Some (s, v) => Some (s, B2R v) | None => None end.
Proof.
  intros D R e' n' R0 N0. unfold decide, decide_b.
  rewrite (rep_lt _ _ _ _ _ _ D (rep_opp _ _ _ e')).
  rewrite (rep_lt _ _ _ _ _ _ e' (rep_mul _ _ _ _ 500 0 ltac:(lia) D slack_rep)).
  rewrite (rep_lt _ _ _ _ _ _ n' (rep_mul _ _ _ _ 500 0 ltac:(lia) R slack_rep)).
  destruct (Rlt_dec DET (- E)) as [L | L]; [rewrite Rlt_bool_true by exact L | rewrite Rlt_bool_false by lra].
  { reflexivity. }
  clear L. destruct (Rlt_dec E (fmul DET filter_slack)) as [L | L]; [rewrite Rlt_bool_true by exact L | now rewrite Rlt_bool_false by lra].
  clear L. destruct (Rlt_dec N (fmul ROOTS filter_slack)) as [L | L]; [rewrite Rlt_bool_true by exact L | now rewrite Rlt_bool_false by lra].
  f_equal. f_equal. symmetry. unfold tolerance.
  generalize (rep_sub _ _ _ _ 500 ltac:(lia) D e') (rep_add _ _ _ _ 500 ltac:(lia) R n'). intros Q (Fd & Vd & _).
  assert (B : bpow radix2 (-480) <= fadd ROOTS N).
  { rewrite <- (rnd_F (bpow radix2 (-480))) by (apply F_bpow; lia). apply rnd_le. lra. }
  generalize (rep_mul _ _ _ _ (500 + 1 - -480) 0 ltac:(lia) (rep_div _ _ _ _ (500 + 1) (-480) ltac:(lia) Q Fd Vd B) shrink_rep).
  intros (_ & V & _). exact V.
Qed.
