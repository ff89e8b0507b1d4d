(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* How far a displacement budget goes: a call adds one way to it, 2^505 at most, and rounds up by less than one part in 2^50. So 2^49 calls do not take it to 2^560,
   even if it never starts again: what a displacement budget of the machine shows is far from overflow.

   - reach_after    the reach (machine_state.v) of the n-th call, for n up to 2^49 *)
From Coq Require Import Reals ZArith Lia Lra.
From Flocq Require Import Core Relative.
From Annulus Require float_model float_error float_sums.
From Annulus Require Import operations bridge.
From Annulus_traces Require Import machine_state.
Open Scope R_scope.

Definition part : R := power (-50).
Definition way_gone (n : nat) : R := power 505 * INR n * (1 + part) ^ n.

(* A number that is not tiny is rounded up by one part in 2^53 at most. *)
Lemma rounded_up r : 1 <= r -> rnd r <= r * (1 + power (-53)).
Proof.
  intro P. assert (L : power (-1074 + 53 - 1) <= Rabs r).
  { rewrite Rabs_pos_eq by lra. apply Rle_trans with (2 := P). change 1 with (power 0). now apply bpow_le. }
  assert (H : Rabs (rnd r - r) <= / 2 * power (-53 + 1) * Rabs r) by exact (relative_error_N_FLT radix2 (-1074) 53 ltac:(reflexivity) _ r L).
  rewrite (Rabs_pos_eq r) in H by lra.
  replace (/ 2 * power (-53 + 1)) with (power (-53)) in H by (change (/ 2) with (power (-1)); rewrite <- bpow_plus; f_equal; lia).
  apply Rabs_le_inv in H. lra.
Qed.
Lemma rnd_le a b : a <= b -> rnd a <= rnd b.
Proof. intro H. apply round_le; auto with typeclass_instances. Qed.

Lemma one_more b way : 0 <= b -> 0 <= way <= power 505 -> float_sums.sum_upper b way <= (b + power 505) * (1 + part).
Proof.
  intros B W. set (m := b + power 505).
  assert (M : 1 <= m) by (unfold m; generalize (bpow_le radix2 0 505 ltac:(lia)); change (power 0) with 1; lra).
  set (u := power (-53)). assert (U : u = / 9007199254740992) by reflexivity. assert (C : part = 8 * u) by (rewrite U; unfold part; change (power (-50)) with (/ 1125899906842624); lra).
  assert (K : float_sums.ulp52 = 2 * u) by reflexivity.
  assert (S : rnd (b + way) <= m * (1 + u)) by (apply Rle_trans with (1 := rnd_le (b + way) m ltac:(unfold m; lra)); now apply rounded_up).
  assert (S0 : 0 <= rnd (b + way)) by (apply float_model.rnd_pos; lra).
  assert (T : rnd (rnd (b + way) * float_sums.ulp52) <= m * (3 * u)).
  { apply Rle_trans with (rnd (m * (1 + u) * (2 * u))).
    - apply rnd_le. rewrite K. apply Rmult_le_compat_r; [rewrite U; lra|exact S].
    - apply Rle_trans with (m * (1 + u) * (2 * u) * (1 + u)); [apply rounded_up|].
      + apply Rle_trans with (power 505 * (2 * u)).
        * replace (2 * u) with (power (-52)) by (rewrite U; change (power (-52)) with (/ 4503599627370496); lra). rewrite <- bpow_plus. change 1 with (power 0). now apply bpow_le.
        * apply Rmult_le_compat_r; [rewrite U; lra|]. apply Rle_trans with (m * 1); [unfold m; lra|]. apply Rmult_le_compat_l; rewrite ?U; lra.
      + replace (m * (1 + u) * (2 * u) * (1 + u)) with (m * ((1 + u) * (2 * u) * (1 + u))) by ring. apply Rmult_le_compat_l; [lra|]. rewrite U. lra. }
  assert (Sum : rnd (b + way) + rnd (rnd (b + way) * float_sums.ulp52) <= m * (1 + 4 * u)).
  { replace (m * (1 + 4 * u)) with (m * (1 + u) + m * (3 * u)) by ring. lra. }
  change (rnd (rnd (b + way) + rnd (rnd (b + way) * float_sums.ulp52)) <= m * (1 + part)).
  apply Rle_trans with (1 := rnd_le _ _ Sum).
  apply Rle_trans with (m * (1 + 4 * u) * (1 + u)).
  - apply rounded_up. apply Rle_trans with (m * 1); [lra|]. apply Rmult_le_compat_l; [lra|rewrite U; lra].
  - rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|]. rewrite C, U. lra.
Qed.

Lemma part_pos : 0 < part. Proof. apply bpow_gt_0. Qed.
Lemma growth_pos n : 0 < (1 + part) ^ n. Proof. apply pow_lt. generalize part_pos. lra. Qed.
Lemma growth n : (1 + part) ^ n * (1 - INR n * part) <= 1.
Proof.
  induction n as [|n IH]; [simpl; lra|]. rewrite S_INR. simpl pow. generalize part_pos (growth_pos n) (pos_INR n). intros P G N.
  apply Rle_trans with (2 := IH). replace ((1 + part) * (1 + part) ^ n * (1 - (INR n + 1) * part)) with
    ((1 + part) ^ n * (1 - INR n * part - (INR n + 1) * (part * part))) by ring.
  apply Rmult_le_compat_l; [lra|]. assert (0 <= (INR n + 1) * (part * part)) by (apply Rmult_le_pos; [lra|]; apply Rmult_le_pos; lra). lra.
Qed.

Lemma way_pos n : 0 <= way_gone n.
Proof. apply Rmult_le_pos; [|apply Rlt_le, growth_pos]. apply Rmult_le_pos; [apply bpow_ge_0|apply pos_INR]. Qed.

Lemma way_next n : (way_gone n + power 505) * (1 + part) <= way_gone (S n).
Proof.
  unfold way_gone. rewrite S_INR. simpl pow. generalize part_pos (bpow_gt_0 radix2 505). intros P Q.
  replace (power 505 * (INR n + 1) * ((1 + part) * (1 + part) ^ n)) with ((power 505 * INR n * (1 + part) ^ n + power 505 * (1 + part) ^ n) * (1 + part)) by ring.
  apply Rmult_le_compat_r; [lra|]. apply Rplus_le_compat_l. rewrite <- (Rmult_1_r (power 505)) at 1. apply Rmult_le_compat_l; [lra|].
  apply pow_R1_Rle. lra.
Qed.

Definition within_reach (n : nat) : Prop := INR n <= power 49.
Lemma within_reach_of n : (Z.of_nat n <= 2 ^ 49)%Z -> within_reach n.
Proof. intro H. unfold within_reach. rewrite INR_IZR_INZ. change (power 49) with (IZR (2 ^ 49)). now apply IZR_le. Qed.
Lemma way_bound n : within_reach n -> way_gone n <= power 555.
Proof.
  unfold within_reach, way_gone. intro H. assert (G := growth n). assert (F : (1 + part) ^ n <= 2).
  { assert (INR n * part <= / 2).
    { apply Rle_trans with (power 49 * part); [apply Rmult_le_compat_r; [apply Rlt_le, part_pos|exact H]|]. unfold part. rewrite <- bpow_plus.
      change (/ 2) with (power (-1)). apply bpow_le. lia. }
    generalize (growth_pos n). intro P. assert ((1 + part) ^ n * / 2 <= (1 + part) ^ n * (1 - INR n * part)) by (apply Rmult_le_compat_l; lra). lra. }
  replace (power 555) with (power 505 * power 49 * 2) by (change 2 with (power 1); now rewrite <- !bpow_plus).
  apply Rmult_le_compat; trivial; [apply Rmult_le_pos; [apply bpow_ge_0|apply pos_INR]|apply Rlt_le, growth_pos|].
  apply Rmult_le_compat_l; [apply bpow_ge_0|exact H].
Qed.

Definition reach_after (n : nat) (H : within_reach n) (H' : within_reach (S n)) : reach.
Proof.
  refine {| gone := way_gone n; going := way_gone (S n) |}.
  - split; [apply way_pos|]. apply Rle_trans with (1 := way_bound n H), bpow_le. lia.
  - split.
    + apply Rle_trans with (2 := way_next n). generalize (way_pos n) (bpow_ge_0 radix2 505) part_pos. intros.
      apply Rle_trans with ((way_gone n + power 505) * 1); [lra|]. apply Rmult_le_compat_l; lra.
    + apply Rle_trans with (1 := way_bound _ H'), bpow_le. lia.
  - intros b way B W. apply Rle_trans with (1 := one_more b way (proj1 B) W). apply Rle_trans with (2 := way_next n).
    apply Rmult_le_compat_r; [generalize part_pos; lra|]. lra.
Defined.
Definition first_reach : reach := reach_after 0 (within_reach_of 0 ltac:(easy)) (within_reach_of 1 ltac:(easy)).
