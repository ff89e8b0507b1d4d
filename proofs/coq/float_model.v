(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Binary64 as the filter stage uses it: real numbers of the format, rounded to nearest even after every operation, with
   gradual underflow (Flocq's FLT_exp (-1074) 53). Overflow is not in this model: bridge_2.v and bridge_3.v exclude it.

   Every lemma is about one operation; the error analyses use nothing else of the arithmetic. *)
Require Import Reals Lra Psatz ZArith.
From Flocq Require Import Core Relative Plus_error.
Open Scope R_scope.

Notation fexp64 := (FLT_exp (-1074) 53).
Definition F (x : R) : Prop := generic_format radix2 fexp64 x.
Definition rnd (x : R) : R := round radix2 fexp64 ZnearestE x.

(* Unit roundoff 2^-53 and half the least positive number, 2^-1075. *)
Definition u : R := / 9007199254740992.
Definition eta : R := bpow radix2 (-1075).

Global Instance prec_53 : Prec_gt_0 53 := eq_refl.

Lemma u_bounds : 0 < u < / 1000000000.
Proof. unfold u. split; lra. Qed.

Lemma u_ro_is_u : u_ro radix2 53 = u.
Proof. unfold u_ro, u. change (bpow radix2 (- (53) + 1)) with (/ 4503599627370496). field. Qed.

Lemma eta_pos : 0 < eta.
Proof. apply bpow_gt_0. Qed.

Lemma F_rnd x : F (rnd x).
Proof. apply generic_format_round; auto with typeclass_instances. Qed.

Lemma F_0 : F 0.
Proof. apply generic_format_0. Qed.

Lemma F_opp x : F x -> F (- x).
Proof. apply generic_format_opp. Qed.

Lemma F_abs x : F x -> F (Rabs x).
Proof. apply generic_format_abs. Qed.

Lemma F_max x y : F x -> F y -> F (Rmax x y).
Proof. intros. unfold Rmax. destruct (Rle_dec x y); assumption. Qed.

Lemma F_bpow e : (-1074 <= e)%Z -> F (bpow radix2 e).
Proof. intro. apply generic_format_FLT_bpow; auto with typeclass_instances. Qed.

Lemma F_int z e : (Z.abs z < 2 ^ 53)%Z -> (-1074 <= e)%Z -> F (IZR z * bpow radix2 e).
Proof. intros A B. apply generic_format_FLT. exists (Float radix2 z e); [reflexivity | exact A | exact B]. Qed.

Lemma rnd_F x : F x -> rnd x = x.
Proof. apply round_generic; auto with typeclass_instances. Qed.

Lemma rnd_le x y : x <= y -> rnd x <= rnd y.
Proof. apply round_le; auto with typeclass_instances. Qed.

Lemma rnd_0 : rnd 0 = 0.
Proof. apply rnd_F, F_0. Qed.

Lemma rnd_pos x : 0 <= x -> 0 <= rnd x.
Proof. intro. rewrite <- rnd_0. now apply rnd_le. Qed.

(* A rounded value above a number of the format was above it before; in particular comparisons with rounded products. *)
Lemma rnd_gt x y : F y -> y < rnd x -> y < x.
Proof.
  intros Fy H. destruct (Rlt_le_dec y x) as [L | L]; [exact L | exfalso].
  apply rnd_le in L. rewrite (rnd_F y) in L by exact Fy. lra.
Qed.

Lemma F_double x : F x -> F (2 * x).
Proof.
  intro H. apply FLT_format_generic in H; auto with typeclass_instances.
  destruct H as [f V M E]. apply generic_format_FLT.
  exists (Float radix2 (Fnum f) (Fexp f + 1)).
  - rewrite V. unfold F2R. simpl. rewrite bpow_plus. change (bpow radix2 1) with 2. ring.
  - exact M.
  - simpl. lia.
Qed.

Lemma rnd_double x : F x -> rnd (x + x) = 2 * x.
Proof. intro. replace (x + x) with (2 * x) by ring. apply rnd_F, F_double. assumption. Qed.

(* The three ways to bound the error of an operation. *)
Lemma rnd_normal x : bpow radix2 (-1022) <= Rabs x -> Rabs (rnd x - x) <= u * Rabs x.
Proof.
  intro H. generalize (relative_error_N_FLT radix2 (-1074) 53 eq_refl (fun z => negb (Z.even z)) x H).
  fold (u_ro radix2 53). rewrite u_ro_is_u. auto.
Qed.

Lemma rnd_any x : Rabs (rnd x - x) <= u * Rabs x + eta.
Proof.
  destruct (relative_error_N_FLT'_ex radix2 (-1074) 53 eq_refl (fun z => negb (Z.even z)) x)
    as (eps & et & He & Ht & _ & E).
  change (rnd x = x * (1 + eps) + et) in E. rewrite E.
  replace (x * (1 + eps) + et - x) with (x * eps + et) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_mult.
  apply Rplus_le_compat.
  - rewrite Rmult_comm. apply Rmult_le_compat_r; [apply Rabs_pos |].
    rewrite u_ro_is_u in He. apply Rle_trans with (1 := He).
    generalize u_bounds. intro. apply Rmult_le_reg_r with (1 + u); [lra |].
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. nra.
  - apply Rle_trans with (1 := Ht). right. unfold eta.
    change (/ 2) with (bpow radix2 (-1)). rewrite <- bpow_plus. reflexivity.
Qed.

Lemma rnd_add x y : F x -> F y -> Rabs (rnd (x + y) - (x + y)) <= u * Rabs (x + y).
Proof.
  intros Fx Fy.
  destruct (FLT_plus_error_N_ex radix2 (-1074) 53 (fun z => negb (Z.even z)) x y Fx Fy) as (eps & He & E).
  change (rnd (x + y) = (x + y) * (1 + eps)) in E. rewrite E.
  replace ((x + y) * (1 + eps) - (x + y)) with (eps * (x + y)) by ring. rewrite Rabs_mult.
  apply Rmult_le_compat_r; [apply Rabs_pos |].
  rewrite u_ro_is_u in He. apply Rle_trans with (1 := He).
  generalize u_bounds. intro. apply Rmult_le_reg_r with (1 + u); [lra |].
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. nra.
Qed.

Lemma rnd_sub x y : F x -> F y -> Rabs (rnd (x - y) - (x - y)) <= u * Rabs (x - y).
Proof. intros. change (x - y) with (x + - y). apply rnd_add; [assumption | now apply F_opp]. Qed.

(* Relative to the result: what the differences of coordinates are known by. *)
Lemma rnd_sub_result x y : F x -> F y -> Rabs (rnd (x - y) - (x - y)) <= u * Rabs (rnd (x - y)).
Proof.
  intros Fx Fy.
  destruct (FLT_plus_error_N_round_ex radix2 (-1074) 53 (fun z => negb (Z.even z)) x (- y) Fx (F_opp _ Fy))
    as (eps & He & E).
  change (x - y) with (x + - y). change (x + - y = rnd (x + - y) * (1 + eps)) in E.
  set (r := rnd (x + - y)) in *. rewrite E. replace (r - r * (1 + eps)) with (- eps * r) by ring.
  rewrite Rabs_mult, Rabs_Ropp. apply Rmult_le_compat_r; [apply Rabs_pos |].
  now rewrite <- u_ro_is_u.
Qed.

(* Square roots do not underflow. *)
Lemma rnd_sqrt x : F x -> Rabs (rnd (sqrt x) - sqrt x) <= u * sqrt x.
Proof.
  intro Fx. destruct (Rle_or_lt x 0) as [N | P].
  - rewrite sqrt_neg_0 by exact N. rewrite rnd_0. rewrite Rminus_0_r, Rabs_R0. lra.
  - rewrite <- (Rabs_pos_eq (sqrt x)) at 3 by apply sqrt_pos. apply rnd_normal.
    rewrite Rabs_pos_eq by apply sqrt_pos.
    apply Rle_trans with (bpow radix2 (-537)); [apply bpow_le; lia |].
    rewrite <- (sqrt_square (bpow radix2 (-537))) by apply bpow_ge_0.
    apply sqrt_le_1_alt. rewrite <- bpow_plus.
    assert (G : generic_format radix2 fexp64 x) by exact Fx.
    apply FLT_format_generic in G; auto with typeclass_instances. destruct G as [f V M E].
    assert (Z : (0 < Fnum f)%Z) by (apply gt_0_F2R with radix2 (Fexp f); destruct f; simpl in *; now rewrite <- V).
    rewrite V. unfold F2R. apply Rle_trans with (1 * bpow radix2 (Fexp f)).
    + rewrite Rmult_1_l. apply bpow_le. lia.
    + apply Rmult_le_compat_r; [apply bpow_ge_0 |]. apply IZR_le. lia.
Qed.

(* The same as inequalities for results that are not negative. *)
Lemma abs_le_both e v x : Rabs (v - x) <= e -> x - e <= v <= x + e.
Proof. intro H. apply Rabs_le_inv in H. lra. Qed.

Lemma rnd_any_le x : 0 <= x -> x * (1 - u) - eta <= rnd x <= x * (1 + u) + eta.
Proof. intro P. generalize (abs_le_both _ _ _ (rnd_any x)). rewrite Rabs_pos_eq by exact P. lra. Qed.

Lemma rnd_normal_le x : bpow radix2 (-1022) <= x -> x * (1 - u) <= rnd x <= x * (1 + u).
Proof.
  intro P. assert (Q : 0 <= x) by (generalize (bpow_ge_0 radix2 (-1022)); lra).
  rewrite <- (Rabs_pos_eq x) in P by exact Q.
  generalize (abs_le_both _ _ _ (rnd_normal x P)). rewrite Rabs_pos_eq by exact Q. lra.
Qed.

Lemma rnd_add_le x y : F x -> F y -> 0 <= x + y -> (x + y) * (1 - u) <= rnd (x + y) <= (x + y) * (1 + u).
Proof. intros A B P. generalize (abs_le_both _ _ _ (rnd_add x y A B)). rewrite Rabs_pos_eq by exact P. lra. Qed.

Lemma rnd_sqrt_le x : F x -> sqrt x * (1 - u) <= rnd (sqrt x) <= sqrt x * (1 + u).
Proof. intro A. generalize (abs_le_both _ _ _ (rnd_sqrt x A)). lra. Qed.
