(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the filters of the plane and of space share: `detail::decide` of src/annulus/predicate/decide.h, the range of m, and
   error bounds C u m^k that are themselves computed in floating point. *)
Require Import Reals Lra Psatz ZArith List.
From Flocq Require Import Core Mult_error.
From Annulus Require Import float_model float_error_sound float_tail.
Import ListNotations.
Open Scope R_scope.

(* Sign and tolerance, or no answer. With certified = false the tolerance is the plain quotient. *)
Definition decide (det roots det_error norm_error : R) (certified : bool) : option (Z * R) :=
  if Rlt_dec det (- det_error) then Some ((-1)%Z, 0)
  else if Rlt_dec det_error (fmul det filter_slack) then
    if certified then
      if Rlt_dec norm_error (fmul roots filter_slack)
      then Some (1%Z, tolerance det roots det_error norm_error)
      else None
    else Some (1%Z, rnd (det / roots))
  else None.

(* What is claimed of an answer: the sign is that of the exact determinant, and a certified tolerance is at most the
   exact quotient. *)
Definition sound (answer : option (Z * R)) (certified : bool) (det truth : R) : Prop :=
  forall sign value, answer = Some (sign, value) ->
  sign = 1%Z /\ 0 < det /\ (certified = true -> 0 <= value <= det / truth) \/ sign = (-1)%Z /\ det < 0.

Theorem decide_sound det truth computed roots det_error norm_error certified :
  F computed -> F roots -> F det_error -> F norm_error ->
  0 < det_error -> 0 <= norm_error -> 0 <= roots -> (0 < det -> 0 < truth) ->
  Rabs (computed - det) <= det_error ->
  (1 - 10 * u) * truth <= roots + norm_error ->
  bpow radix2 (-900) * (roots + norm_error) <= det_error ->
  sound (decide computed roots det_error norm_error certified) certified det truth.
Proof.
  intros Fc Fr Fe Fn He Hn Hr Ht HE HR HU sign value A. unfold decide in A.
  destruct (Rlt_dec computed (- det_error)) as [N | _].
  - right. injection A as <- _. split; [reflexivity |]. now apply negative_sound with (1 := HE).
  - destruct (Rlt_dec det_error (fmul computed filter_slack)) as [S | _]; [| discriminate].
    destruct (tolerance_sound det truth computed roots det_error norm_error) as [P T]; try assumption.
    left. destruct certified.
    + destruct (Rlt_dec norm_error (fmul roots filter_slack)); [| discriminate].
      injection A as <- <-. auto.
    + injection A as <- _. split; [reflexivity |]. split; [exact P | discriminate].
Qed.

(* Halves of u: the constants of bounds.h less what rounding the error bounds themselves can take off. *)
Definition half_u : Z := 2 ^ 46.

(* Environments: the differences of the code, and those they stand for. *)
Definition env (l : list R) (n : nat) : R := nth n l 0.

Lemma env_all (P : R -> Prop) l : P 0 -> Forall P l -> forall n, P (env l n).
Proof.
  intros H A n. unfold env. destruct (nth_in_or_default n l 0) as [I | ->]; [| exact H].
  rewrite Forall_forall in A. now apply A.
Qed.

Lemma env_all_2 (P : R -> R -> Prop) l k : P 0 0 -> Forall2 P l k -> forall n, P (env l n) (env k n).
Proof.
  intros H A. induction A as [| a b l k Q A IH]; intro n.
  - unfold env. destruct n; exact H.
  - destruct n; [exact Q | apply IH].
Qed.

Ltac each := repeat (apply Forall_nil || apply Forall_cons || apply Forall2_nil || apply Forall2_cons).

Lemma half_units m c k : IZR (c * half_u) * scale m k = IZR c / 2 * u * m ^ k.
Proof.
  rewrite mult_IZR. replace (IZR half_u) with (IZR unit_roundoff / 2).
  - unfold scale. generalize unit_u. intro E.
    replace (IZR c * (IZR unit_roundoff / 2) * (unit * m ^ k)) with (IZR c / 2 * (IZR unit_roundoff * unit) * m ^ k) by field.
    rewrite E. ring.
  - unfold half_u, unit_roundoff. change (2 ^ 47)%Z with (2 * 2 ^ 46)%Z. rewrite mult_IZR. field.
Qed.

Lemma units m c k : IZR (c * one) * scale m k = IZR c * m ^ k.
Proof.
  rewrite mult_IZR. unfold scale. generalize unit_one. intro E.
  replace (IZR c * IZR one * (unit * m ^ k)) with (IZR c * (IZR one * unit) * m ^ k) by ring. rewrite E. ring.
Qed.

(* The magnitude of the differences. *)
Definition mag (x y : R) : R := Rmax (Rabs x) (Rabs y).

Lemma Rabs_le_mag x y : Rabs x <= mag x y /\ Rabs y <= mag x y.
Proof. unfold mag. split; [apply Rmax_l | apply Rmax_r]. Qed.

Lemma F_mag x y : F x -> F y -> F (mag x y).
Proof. intros. apply F_max; now apply F_abs. Qed.

Definition in_range (r : Z) (m : R) : Prop := m <= bpow radix2 r /\ 1 <= fmul m (bpow radix2 r).

Lemma in_range_dec r m : {in_range r m} + {~ in_range r m}.
Proof.
  unfold in_range. destruct (Rle_dec m (bpow radix2 r)); destruct (Rle_dec 1 (fmul m (bpow radix2 r)));
  (left; tauto) || (right; tauto).
Qed.

(* filter_range is 2^120 in the plane and filter_range_3 is 2^100. *)
Lemma in_range_lower r m : (0 <= r <= 120)%Z -> F m -> in_range r m -> bpow radix2 (-120) <= m.
Proof.
  intros R Fm [_ L]. unfold fmul in L. rewrite rnd_F in L.
  - apply Rle_trans with (bpow radix2 (- r)); [apply bpow_le; lia |].
    apply Rmult_le_reg_r with (bpow radix2 r); [apply bpow_gt_0 |].
    rewrite <- bpow_plus, Z.add_opp_diag_l. exact L.
  - apply mult_bpow_pos_exact_FLT; [exact Fm | lia].
Qed.

Section powers.
Variable m : R.
Hypothesis m_large : bpow radix2 (-120) <= m.

Lemma m_positive : 0 < m.
Proof. apply Rlt_le_trans with (2 := m_large). apply bpow_gt_0. Qed.

Lemma pow_large k : bpow radix2 (-120 * Z.of_nat k) <= m ^ k.
Proof.
  induction k as [| k IH]; [simpl; lra |].
  replace (-120 * Z.of_nat (S k))%Z with (-120 + -120 * Z.of_nat k)%Z by lia. rewrite bpow_plus. cbn [pow].
  apply mul_below; try apply bpow_ge_0; assumption.
Qed.

Lemma pow_normal k : (k <= 8)%nat -> bpow radix2 (-960) <= m ^ k.
Proof. intro K. apply Rle_trans with (2 := pow_large k). apply bpow_le. lia. Qed.

(* Products of powers of m: a factor 1 - u or 1 + u for each rounding. *)
Lemma fmul_pow_lower a b c d i j : (i + j <= 8)%nat -> c * m ^ i <= a -> d * m ^ j <= b ->
  0 <= c -> 0 <= d -> bpow radix2 (-60) <= c * d -> c * d * (1 - u) * m ^ (i + j) <= fmul a b.
Proof.
  intros K A B C D L. rewrite pow_add.
  replace (c * d * (1 - u) * (m ^ i * m ^ j)) with (c * m ^ i * (d * m ^ j) * (1 - u)) by ring.
  assert (P : forall k, 0 <= m ^ k) by (intro; apply pow_le; left; apply m_positive).
  apply fmul_lower; [split; [now apply Rmult_le_pos | exact A] | split; [now apply Rmult_le_pos | exact B] |].
  replace (c * m ^ i * (d * m ^ j)) with (c * d * m ^ (i + j)) by (rewrite pow_add; ring).
  apply Rle_trans with (bpow radix2 (-60) * bpow radix2 (-960)).
  - rewrite <- bpow_plus. apply bpow_le. lia.
  - apply mul_below; try apply bpow_ge_0; [exact L | now apply pow_normal].
Qed.

Lemma fmul_pow_upper a b c d i j : (i + j <= 8)%nat -> 0 <= a <= c * m ^ i -> 0 <= b <= d * m ^ j ->
  bpow radix2 (-60) <= c * d -> fmul a b <= c * d * (1 + u) * m ^ (i + j).
Proof.
  intros K A B L. rewrite pow_add.
  replace (c * d * (1 + u) * (m ^ i * m ^ j)) with (c * m ^ i * (d * m ^ j) * (1 + u)) by ring.
  apply fmul_upper; [exact A | exact B |].
  replace (c * m ^ i * (d * m ^ j)) with (c * d * m ^ (i + j)) by (rewrite pow_add; ring).
  apply Rle_trans with (bpow radix2 (-60) * bpow radix2 (-960)).
  - rewrite <- bpow_plus. apply bpow_le. lia.
  - apply mul_below; try apply bpow_ge_0; [exact L | now apply pow_normal].
Qed.

(* C u p, where p stands for m^k and has been rounded a few times. *)
Definition error_bound (C : Z) (p : R) : R := fmul (fmul (IZR C) u) p.

Lemma error_bound_range C p k : (k <= 8)%nat -> (1 <= C < 2 ^ 20)%Z ->
  (1 - 6 * u) * m ^ k <= p <= (1 + 6 * u) * m ^ k ->
  IZR C * u * (1 - 8 * u) * m ^ k <= error_bound C p <= IZR C * u * (1 + 8 * u) * m ^ k.
Proof.
  intros K HC [L H]. unfold error_bound.
  assert (E : fmul (IZR C) u = IZR C * u).
  { unfold fmul. apply rnd_F. replace u with (bpow radix2 (-53)) by reflexivity. apply F_int; lia. }
  rewrite E. generalize u_bounds. intro U.
  assert (C1 : 1 <= IZR C <= 1048576) by (split; apply IZR_le; lia).
  assert (P : 0 <= m ^ k) by (apply pow_le; left; apply m_positive).
  assert (Q : 0 <= IZR C * u) by (apply Rmult_le_pos; lra).
  assert (S : u * (1 - 6 * u) <= IZR C * u * (1 - 6 * u)) by (apply Rmult_le_compat_r; nra).
  assert (S' : IZR C * u * (1 - 6 * u) <= IZR C * u * (1 + 6 * u)) by (apply Rmult_le_compat_l; lra).
  assert (W : bpow radix2 (-60) <= u * (1 - 6 * u)).
  { change (bpow radix2 (-60)) with (/ 1152921504606846976). unfold u. lra. }
  split.
  - replace k with (0 + k)%nat by reflexivity.
    apply Rle_trans with (IZR C * u * (1 - 6 * u) * (1 - u) * m ^ (0 + k)).
    + apply Rmult_le_compat_r; [exact P |]. rewrite (Rmult_assoc _ (1 - 6 * u)). apply Rmult_le_compat_l; nra.
    + apply fmul_pow_lower; [exact K | rewrite pow_O; lra | exact L | exact Q | lra | lra].
  - replace k with (0 + k)%nat by reflexivity.
    apply Rle_trans with (IZR C * u * (1 + 6 * u) * (1 + u) * m ^ (0 + k)).
    + apply fmul_pow_upper; [exact K | rewrite pow_O; lra | | lra].
      split; [| exact H]. apply Rle_trans with (2 := L). apply Rmult_le_pos; [lra | exact P].
    + apply Rmult_le_compat_r; [exact P |]. rewrite (Rmult_assoc _ (1 + 6 * u)). apply Rmult_le_compat_l; nra.
Qed.

Lemma F_error_bound C p : F (error_bound C p).
Proof. apply F_rnd. Qed.

(* The powers themselves, as the code forms them. *)
Definition power_2 := fmul m m.
Definition power_3 := fmul power_2 m.
Definition power_4 := fmul power_2 power_2.
Definition power_5 := fmul power_4 m.

Lemma power_2_range : (1 - u) * m ^ 2 <= power_2 <= (1 + u) * m ^ 2.
Proof.
  generalize u_bounds m_positive. intros U M.
  assert (W : bpow radix2 (-60) <= 1 * 1) by (rewrite Rmult_1_l; change 1 with (bpow radix2 0); apply bpow_le; lia).
  split; unfold power_2.
  - generalize (fmul_pow_lower m m 1 1 1 1 ltac:(lia) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) W). cbn [Nat.add]. lra.
  - generalize (fmul_pow_upper m m 1 1 1 1 ltac:(lia) ltac:(lra) ltac:(lra) W). cbn [Nat.add]. lra.
Qed.

(* In the form that error_bound_range takes. *)
Lemma widen p k c d : 0 <= c <= 6 -> 0 <= d <= 6 -> (1 - c * u) * m ^ k <= p <= (1 + d * u) * m ^ k ->
  (1 - 6 * u) * m ^ k <= p <= (1 + 6 * u) * m ^ k.
Proof.
  generalize u_bounds (pow_lt m k m_positive). intros U P C D [L H]. split.
  - apply Rle_trans with (2 := L). apply Rmult_le_compat_r; [lra |]. assert (c * u <= 6 * u) by (apply Rmult_le_compat_r; lra). lra.
  - apply Rle_trans with (1 := H). apply Rmult_le_compat_r; [lra |]. assert (d * u <= 6 * u) by (apply Rmult_le_compat_r; lra). lra.
Qed.

Lemma power_2_range_6 : (1 - 6 * u) * m ^ 2 <= power_2 <= (1 + 6 * u) * m ^ 2.
Proof. apply (widen _ _ 1 1); try lra. rewrite !Rmult_1_l. exact power_2_range. Qed.

Lemma power_3_range : (1 - 4 * u) * m ^ 3 <= power_3 <= (1 + 4 * u) * m ^ 3.
Proof.
  generalize u_bounds m_positive power_2_range. intros U M [L H].
  assert (P : forall k, 0 < m ^ k) by (intro; apply pow_lt, M).
  assert (W : bpow radix2 (-60) <= / 2) by (change (/ 2) with (bpow radix2 (-1)); apply bpow_le; lia).
  split; unfold power_3.
  - apply Rle_trans with ((1 - u) * 1 * (1 - u) * m ^ (2 + 1)).
    + cbn [Nat.add]. apply Rmult_le_compat_r; [left; apply P | nra].
    + apply fmul_pow_lower; lia || lra.
  - apply Rle_trans with ((1 + u) * 1 * (1 + u) * m ^ (2 + 1)).
    + apply fmul_pow_upper; lia || lra || idtac. split; [| exact H]. apply Rle_trans with (2 := L).
      apply Rmult_le_pos; [lra | left; apply P].
    + cbn [Nat.add]. apply Rmult_le_compat_r; [left; apply P | nra].
Qed.

Lemma power_4_range : (1 - 4 * u) * m ^ 4 <= power_4 <= (1 + 4 * u) * m ^ 4.
Proof.
  generalize u_bounds m_positive power_2_range. intros U M [L H].
  assert (P : forall k, 0 < m ^ k) by (intro; apply pow_lt, M).
  assert (W : bpow radix2 (-60) <= / 2) by (change (/ 2) with (bpow radix2 (-1)); apply bpow_le; lia).
  assert (power_2_pos : 0 <= power_2) by (apply Rle_trans with (2 := L); apply Rmult_le_pos; [lra | left; apply P]).
  split; unfold power_4.
  - apply Rle_trans with ((1 - u) * (1 - u) * (1 - u) * m ^ (2 + 2)).
    + cbn [Nat.add]. apply Rmult_le_compat_r; [left; apply P | nra].
    + apply fmul_pow_lower; lia || lra || nra.
  - apply Rle_trans with ((1 + u) * (1 + u) * (1 + u) * m ^ (2 + 2)).
    + apply fmul_pow_upper; lia || lra || nra.
    + cbn [Nat.add]. apply Rmult_le_compat_r; [left; apply P | nra].
Qed.

Lemma power_5_range : (1 - 5 * u) * m ^ 5 <= power_5 <= (1 + 6 * u) * m ^ 5.
Proof.
  generalize u_bounds m_positive power_4_range. intros U M [L H].
  assert (P : forall k, 0 < m ^ k) by (intro; apply pow_lt, M).
  assert (W : bpow radix2 (-60) <= / 2) by (change (/ 2) with (bpow radix2 (-1)); apply bpow_le; lia).
  assert (power_4_pos : 0 <= power_4) by (apply Rle_trans with (2 := L); apply Rmult_le_pos; [lra | left; apply P]).
  split; unfold power_5.
  - apply Rle_trans with ((1 - 4 * u) * 1 * (1 - u) * m ^ (4 + 1)).
    + cbn [Nat.add]. apply Rmult_le_compat_r; [left; apply P | unfold u; lra].
    + apply fmul_pow_lower; lia || lra.
  - apply Rle_trans with ((1 + 4 * u) * 1 * (1 + u) * m ^ (4 + 1)).
    + apply fmul_pow_upper; lia || lra.
    + cbn [Nat.add]. apply Rmult_le_compat_r; [left; apply P | unfold u; lra].
Qed.
End powers.
