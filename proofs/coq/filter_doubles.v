(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The arithmetic of `filter` errs on the right side: what algorithm_filter.v requires of it in `laws`, for the operations of the code in
   binary64, all numbers of the format (src/annulus/engine/tolerance_strategy.h, displacement.h).

   - path_length_above_2, _3     Displacement_budget::path_length is a number and at least base + distance
   - threshold_below_2, _3   Displacement_budget::set_threshold and passes, the threshold rounded down to an upper half: base + distance < earliest
   - sum_lower_down, less_down   what commit_points and rebase write
   - distance_zero_2, distance_zero_3, distance_triangle_2, distance_triangle_3     distances are a metric

   Numbers as in float_model.v: IEEE 754 without overflow; an infinite expiry is 2^1024 (truncated_double.v). *)
Require Import Reals Lra Psatz ZArith Rgeom.
From Flocq Require Import Core.
From Annulus Require Import points_2 float_model float_error float_tail float_sums float_displacement vectors algorithm_list truncated_double.
Open Scope R_scope.

Lemma F_value e : (0 <= e)%Z -> F (value e).
Proof.
  intro E. unfold value, number. assert (M := Z.mod_pos_bound e (2 ^ 20) ltac:(lia)). apply F_int.
  - unfold mantissa. destruct (_ =? _)%Z; lia.
  - unfold exponent. lia.
Qed.

Theorem sum_lower_down b t : F b -> F t -> 0 <= b -> 0 <= t -> sum_lower b t <= b + t.
Proof. apply sum_lower_sound. Qed.

Definition less (e : Z) (b : R) : R := difference_lower (value e) b.
Theorem less_down e b : (0 <= e <= never)%Z -> F b -> 0 <= b -> (value e <= b -> less e b <= 0) /\ (b <= value e -> less e b <= value e - b).
Proof. intros E B _. split; intro H; [now apply difference_lower_clips|]. apply difference_lower_sound; trivial. apply F_value. lia. Qed.

Definition threshold (e : Z) (b : R) : R := value (lower (float_displacement.threshold (value e) b)).

Lemma threshold_half sq A e b : squares_close A sq -> sqrt A <= bpow radix2 510 -> (0 <= e)%Z -> F b -> sq < threshold e b ->
  b + sqrt A < value e.
Proof.
  intros C D E B L. apply (threshold_passes A sq); trivial; [now apply F_value|]. unfold threshold in L.
  destruct (Rlt_le_dec 0 (float_displacement.threshold (value e) b)) as [P|P].
  - apply Rlt_le_trans with (1 := L), lower_below. lra.
  - rewrite lower_clips, value_0 in L by exact P. destruct C as (_ & C & _). lra.
Qed.

Lemma path_length_up b d : F b -> F d -> 0 <= b -> 0 <= d -> F (sum_upper b d) /\ b + d <= sum_upper b d.
Proof. intros. split; [apply F_rnd|now apply sum_upper_sound]. Qed.

Lemma F_distance_upper q r : F (distance_upper q r).
Proof. unfold distance_upper. destruct (Rlt_dec _ _); apply F_rnd. Qed.

(* ---- Plane ---- *)

Definition valid_2 (p : point_2) : Prop := in_domain (fst p) /\ in_domain (snd p).
Definition dist_2 (f p : point_2) : R := distance_2 (fst p) (snd p) (fst f) (snd f).
Definition path_length_2 (b : R) (f p : point_2) : R := sum_upper b (distance_upper_2 (fst p) (snd p) (fst f) (snd f)).
Definition below_2 (f p : point_2) (r : R) : bool := if Rlt_dec (squared_distance_2 (fst p) (snd p) (fst f) (snd f)) r then true else false.

Theorem path_length_above_2 b f p : F b -> 0 <= b -> valid_2 f -> valid_2 p -> F (path_length_2 b f p) /\ b + dist_2 f p <= path_length_2 b f p.
Proof.
  intros B B0 [[F1 _] [F2 _]] [[P1 _] [P2 _]]. assert (D := distance_upper_2_sound _ _ _ _ P1 P2 F1 F2). fold (dist_2 f p) in D.
  assert (D0 : 0 <= dist_2 f p) by apply sqrt_pos.
  destruct (path_length_up b (distance_upper_2 (fst p) (snd p) (fst f) (snd f)) B (F_distance_upper _ _) B0 ltac:(lra)) as [A C].
  split; [exact A|]. unfold path_length_2. lra.
Qed.

Theorem threshold_below_2 e b f p : (0 <= e <= never)%Z -> F b -> 0 <= b -> valid_2 f -> valid_2 p ->
  below_2 f p (threshold e b) = true -> b + dist_2 f p < value e.
Proof.
  intros E B _ [F1 F2] [P1 P2]. unfold below_2. destruct (Rlt_dec _ _) as [L|]; [|discriminate]. intros _.
  apply (threshold_half _ _ e b (squares_2 _ _ _ _ (proj1 P1) (proj1 P2) (proj1 F1) (proj1 F2))); trivial; [|lia].
  generalize (domain_3 (fst p - fst f) (snd p - snd f) 0). rewrite Rmult_0_l, Rplus_0_r, Rabs_R0. intro H.
  apply H; try (now apply domain_difference). apply bpow_ge_0.
Qed.

Lemma dist_2_euc f p : dist_2 f p = dist_euc (fst p) (snd p) (fst f) (snd f).
Proof. reflexivity. Qed.

Theorem distance_triangle_2 a b c : dist_2 a c <= dist_2 a b + dist_2 b c.
Proof. rewrite !dist_2_euc, (Rplus_comm (dist_euc _ _ _ _)). apply triangle. Qed.

Theorem distance_zero_2 a : dist_2 a a = 0.
Proof. rewrite dist_2_euc. apply distance_refl. Qed.

(* ---- Space ---- *)

Definition valid_3 (p : vec) : Prop := in_domain (X1 p) /\ in_domain (X2 p) /\ in_domain (X3 p).
Definition dist_3 (f p : vec) : R := distance_3 (X1 p) (X2 p) (X3 p) (X1 f) (X2 f) (X3 f).
Definition path_length_3 (b : R) (f p : vec) : R := sum_upper b (distance_upper_3 (X1 p) (X2 p) (X3 p) (X1 f) (X2 f) (X3 f)).
Definition below_3 (f p : vec) (r : R) : bool :=
  if Rlt_dec (squared_distance_3 (X1 p) (X2 p) (X3 p) (X1 f) (X2 f) (X3 f)) r then true else false.

Theorem path_length_above_3 b f p : F b -> 0 <= b -> valid_3 f -> valid_3 p -> F (path_length_3 b f p) /\ b + dist_3 f p <= path_length_3 b f p.
Proof.
  intros B B0 ([F1 _] & [F2 _] & [F3 _]) ([P1 _] & [P2 _] & [P3 _]).
  assert (D := distance_upper_3_sound _ _ _ _ _ _ P1 P2 P3 F1 F2 F3). fold (dist_3 f p) in D.
  assert (D0 : 0 <= dist_3 f p) by apply sqrt_pos.
  destruct (path_length_up b (distance_upper_3 (X1 p) (X2 p) (X3 p) (X1 f) (X2 f) (X3 f)) B (F_distance_upper _ _) B0 ltac:(lra)) as [A C].
  split; [exact A|]. unfold path_length_3. lra.
Qed.

Theorem threshold_below_3 e b f p : (0 <= e <= never)%Z -> F b -> 0 <= b -> valid_3 f -> valid_3 p ->
  below_3 f p (threshold e b) = true -> b + dist_3 f p < value e.
Proof.
  intros E B _ (F1 & F2 & F3) (P1 & P2 & P3). unfold below_3. destruct (Rlt_dec _ _) as [L|]; [|discriminate]. intros _.
  apply (threshold_half _ _ e b (squares_3 _ _ _ _ _ _ (proj1 P1) (proj1 P2) (proj1 P3) (proj1 F1) (proj1 F2) (proj1 F3))); trivial; [|lia].
  apply domain_3; now apply domain_difference.
Qed.

Lemma dist_3_norm f p : dist_3 f p = norm (p ⊖ f).
Proof. unfold dist_3, distance_3, norm, sq, dot. reflexivity. Qed.

Theorem distance_triangle_3 a b c : dist_3 a c <= dist_3 a b + dist_3 b c.
Proof. rewrite !dist_3_norm. replace (c ⊖ a) with ((b ⊖ a) ⊕ (c ⊖ b)) by vector. apply norm_add. Qed.

Theorem distance_zero_3 a : dist_3 a a = 0.
Proof. rewrite dist_3_norm. unfold norm. replace (sq (a ⊖ a)) with 0 by vector. apply sqrt_0. Qed.
