(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Sums of numbers that are not negative, in binary64: sum_upper and sum_lower of src/annulus/engine/displacement.h are
   above and below the exact sum (sum_upper_sound, sum_lower_sound), for all numbers of the format, subnormal ones too; and sums
   of magnitudes of differences times 1 + 2^-49 are above theirs (grow_sum). *)
Require Import Reals Lra Psatz ZArith.
From Flocq Require Import Core Plus_error.
From Annulus Require Import float_model float_error float_tail.
Open Scope R_scope.

(* ---- Sums of numbers that are not negative ---- *)

Definition ulp52 : R := 2 * u.   (* 2^-52 *)
Definition sum_upper (a b : R) : R := let s := fadd a b in fadd s (fmul s ulp52).
Definition sum_lower (a b : R) : R := let s := fadd a b in fsub s (fmul s ulp52).

Notation ulp64 := (ulp radix2 fexp64).

Lemma F_ulp x : F (ulp64 x).
Proof. apply generic_format_ulp; auto with typeclass_instances. Qed.

Lemma F_add_ulp s : F s -> 0 <= s -> F (s + ulp64 s).
Proof. intros Fs P. rewrite <- succ_eq_pos by exact P. apply generic_format_succ; auto with typeclass_instances. Qed.

Lemma F_sub_ulp s : F s -> 0 < s -> F (s - ulp64 s).
Proof.
  intros Fs P. rewrite ulp_neq_0 by lra. set (c := cexp radix2 fexp64 s).
  assert (C : (-1074 <= c)%Z) by (unfold c, cexp, FLT_exp; lia).
  unfold F, generic_format in Fs. fold c in Fs. set (n := Ztrunc (scaled_mantissa radix2 fexp64 s)) in *.
  assert (E : s = IZR n * bpow radix2 c) by exact Fs.
  assert (N : (0 < n)%Z).
  { apply lt_IZR. apply Rmult_lt_reg_r with (bpow radix2 c); [apply bpow_gt_0 |]. rewrite <- E, Rmult_0_l. exact P. }
  assert (N' : (n < 2 ^ 53)%Z).
  { apply lt_IZR. change (IZR (2 ^ 53)) with (bpow radix2 53). apply Rmult_lt_reg_r with (bpow radix2 c); [apply bpow_gt_0 |].
    rewrite <- E, <- bpow_plus. apply Rlt_le_trans with (bpow radix2 (mag radix2 s)).
    - rewrite <- (Rabs_pos_eq s) at 1 by lra. apply bpow_mag_gt.
    - apply bpow_le. unfold c, cexp, FLT_exp. lia. }
  rewrite E. replace (IZR n * bpow radix2 c - bpow radix2 c) with (IZR (n - 1) * bpow radix2 c) by (rewrite minus_IZR; ring).
  apply F_int; lia.
Qed.

Lemma sum_half_ulp a b : Rabs (fadd a b - (a + b)) <= / 2 * ulp64 (fadd a b).
Proof. apply error_le_half_ulp_round; auto with typeclass_instances. Qed.

(* Below 2^-1022 a sum is exact. *)
Lemma small_sum a b : F a -> F b -> 0 <= a -> 0 <= b -> fadd a b < bpow radix2 (-1022) -> fadd a b = a + b.
Proof.
  intros Fa Fb A B S. apply rnd_F. apply FLT_format_plus_small; auto with typeclass_instances.
  rewrite Rabs_pos_eq by lra. generalize (rnd_add_le a b Fa Fb ltac:(lra)) u_bounds. unfold fadd in S. intros [L _] U.
  apply Rle_trans with (2 * bpow radix2 (-1022)).
  - apply Rmult_le_reg_r with (1 - u); [lra |]. generalize (bpow_gt_0 radix2 (-1022)). nra.
  - change 2 with (bpow radix2 1). rewrite <- bpow_plus. apply bpow_le. lia.
Qed.

(* s 2^-52, rounded, is at least an ulp of a normal s. *)
Lemma ulp_le_product s : bpow radix2 (-1022) <= s -> ulp64 s <= fmul s ulp52.
Proof.
  intro N. rewrite <- (rnd_F (ulp64 s)) by apply F_ulp. apply rnd_le.
  generalize (bpow_gt_0 radix2 (-1022)). intro P. rewrite <- (Rabs_pos_eq s) at 2 by lra.
  replace ulp52 with (bpow radix2 (1 - 53)).
  - apply ulp_FLT_le. rewrite Rabs_pos_eq by lra. exact N.
  - unfold ulp52, u. change (bpow radix2 (1 - 53)) with (/ 4503599627370496). lra.
Qed.

Lemma ulp52_pos : 0 < ulp52.
Proof. unfold ulp52, u. lra. Qed.

Theorem sum_upper_sound a b : F a -> F b -> 0 <= a -> 0 <= b -> a + b <= sum_upper a b.
Proof.
  intros Fa Fb A B. unfold sum_upper. cbv zeta. set (s := fadd a b).
  assert (S0 : 0 <= s) by (apply rnd_pos; lra). assert (Fs : F s) by apply F_rnd.
  assert (T0 : 0 <= fmul s ulp52) by (apply fmul_pos; [exact S0 | left; apply ulp52_pos]).
  destruct (Rlt_le_dec s (bpow radix2 (-1022))) as [L | L].
  - unfold s in L. apply small_sum in L; try assumption. fold s in L. rewrite <- L.
    apply Rle_trans with (rnd s); [rewrite rnd_F by exact Fs; apply Rle_refl | apply rnd_le; lra].
  - apply Rle_trans with (s + ulp64 s).
    + generalize (abs_le_both _ _ _ (sum_half_ulp a b)). fold s. generalize (ulp_ge_0 radix2 fexp64 s). lra.
    + rewrite <- (rnd_F (s + ulp64 s)) by now apply F_add_ulp. apply rnd_le. generalize (ulp_le_product s L). lra.
Qed.

Theorem sum_lower_sound a b : F a -> F b -> 0 <= a -> 0 <= b -> sum_lower a b <= a + b.
Proof.
  intros Fa Fb A B. unfold sum_lower. cbv zeta. set (s := fadd a b).
  assert (S0 : 0 <= s) by (apply rnd_pos; lra). assert (Fs : F s) by apply F_rnd.
  assert (T0 : 0 <= fmul s ulp52) by (apply fmul_pos; [exact S0 | left; apply ulp52_pos]).
  destruct (Rlt_le_dec s (bpow radix2 (-1022))) as [L | L].
  - unfold s in L. apply small_sum in L; try assumption. fold s in L. rewrite <- L.
    apply Rle_trans with (rnd s); [apply rnd_le; lra | rewrite rnd_F by exact Fs; apply Rle_refl].
  - generalize (bpow_gt_0 radix2 (-1022)). intro P. apply Rle_trans with (s - ulp64 s).
    + rewrite <- (rnd_F (s - ulp64 s)) by (apply F_sub_ulp; [exact Fs | lra]). apply rnd_le.
      generalize (ulp_le_product s L). lra.
    + generalize (abs_le_both _ _ _ (sum_half_ulp a b)). fold s. generalize (ulp_ge_0 radix2 fexp64 s). lra.
Qed.

(* Displacement_budget::rebase: a difference that is not negative, rounded down; none that is negative becomes positive. *)
Definition difference_lower (a b : R) : R := let s := fsub a b in fsub s (fmul s ulp52).

Theorem difference_lower_sound a b : F a -> F b -> b <= a -> difference_lower a b <= a - b.
Proof.
  intros Fa Fb D. unfold difference_lower. cbv zeta. set (s := fsub a b).
  assert (S0 : 0 <= s) by (apply rnd_pos; lra). assert (Fs : F s) by apply F_rnd.
  assert (T0 : 0 <= fmul s ulp52) by (apply fmul_pos; [exact S0 | left; apply ulp52_pos]). generalize u_bounds. intro U.
  destruct (Rlt_le_dec s (bpow radix2 (-1022))) as [L | L].
  - assert (E : s = a - b).
    { unfold s, fsub. apply rnd_F. unfold Rminus. apply FLT_format_plus_small; auto with typeclass_instances; [now apply F_opp |].
      fold (a - b). rewrite Rabs_pos_eq by lra. generalize (rnd_sub_result a b Fa Fb). fold (fsub a b). fold s. intro H.
      apply abs_le_both in H. rewrite Rabs_pos_eq in H by exact S0. apply Rle_trans with (2 * bpow radix2 (-1022)).
      - assert (u * s <= 1 * s) by (apply Rmult_le_compat_r; lra). lra.
      - change 2 with (bpow radix2 1). rewrite <- bpow_plus. apply bpow_le. lia. }
    rewrite <- E. apply Rle_trans with (rnd s); [apply rnd_le; lra | rewrite rnd_F by exact Fs; apply Rle_refl].
  - generalize (bpow_gt_0 radix2 (-1022)). intro P. apply Rle_trans with (s - ulp64 s).
    + rewrite <- (rnd_F (s - ulp64 s)) by (apply F_sub_ulp; [exact Fs | lra]). apply rnd_le. generalize (ulp_le_product s L). lra.
    + assert (H : Rabs (fadd a (- b) - (a + - b)) <= / 2 * ulp64 (fadd a (- b))) by apply sum_half_ulp.
      change (fadd a (- b)) with s in H. apply abs_le_both in H. generalize (ulp_ge_0 radix2 fexp64 s). lra.
Qed.

Theorem difference_lower_clips a b : a <= b -> difference_lower a b <= 0.
Proof.
  intro D. unfold difference_lower. cbv zeta. set (s := fsub a b). generalize u_bounds. intro U.
  assert (S0 : s <= 0) by (rewrite <- rnd_0; apply rnd_le; lra). assert (Fs : F s) by apply F_rnd.
  assert (T : s <= fmul s ulp52).
  { rewrite <- (rnd_F s Fs) at 1. apply rnd_le. unfold ulp52. assert (0 <= - s * (1 - 2 * u)) by (apply Rmult_le_pos; lra). lra. }
  rewrite <- rnd_0. apply rnd_le. lra.
Qed.

(* ---- Sums of magnitudes ---- *)

Definition grow : R := 1 + 16 * u.   (* 1 + 2^-49 *)

(* Sums of magnitudes, which are exact where subnormal: x computed, X exact. *)
Definition near_sum (k x X : R) : Prop :=
  F x /\ 0 <= x /\ 0 <= X /\ X <= (1 + k * u) * x /\ (x < bpow radix2 (-1022) -> X = x).

Lemma near_difference a b : F a -> F b -> near_sum 1 (Rabs (fsub a b)) (Rabs (a - b)).
Proof.
  intros Fa Fb. generalize (rnd_sub_result a b Fa Fb) u_bounds. fold (fsub a b). intros H U.
  assert (A : Rabs (a - b) <= (1 + u) * Rabs (fsub a b)).
  { generalize (Rabs_triang (fsub a b) (- (fsub a b - (a - b)))). rewrite Rabs_Ropp.
    replace (fsub a b + - (fsub a b - (a - b))) with (a - b) by ring. lra. }
  split; [apply F_abs, F_rnd |]. split; [apply Rabs_pos |]. split; [apply Rabs_pos |]. split; [lra |].
  intro S. f_equal. unfold fsub. symmetry. apply rnd_F. unfold Rminus. apply FLT_format_plus_small; auto with typeclass_instances.
  { now apply F_opp. }
  apply Rle_trans with (2 * bpow radix2 (-1022)).
  - fold (a - b). apply Rle_trans with (1 := A). generalize (Rabs_pos (fsub a b)). intro. apply mul_below; lra.
  - change 2 with (bpow radix2 1). rewrite <- bpow_plus. apply bpow_le. lia.
Qed.

Lemma near_add j k x X y Y : 0 <= j <= k -> k <= 10 -> near_sum j x X -> near_sum k y Y -> near_sum (k + 2) (fadd x y) (X + Y).
Proof.
  intros J K (Fx & x0 & X0 & Hx & Ex) (Fy & y0 & Y0 & Hy & Ey). generalize u_bounds. intro U.
  assert (S : x + y <= (1 + u) * fadd x y).
  { generalize (rnd_sub_result x (- y) Fx (F_opp _ Fy)). replace (x - - y) with (x + y) by ring. fold (fadd x y).
    intro H. apply abs_le_both in H. rewrite Rabs_pos_eq in H by (apply rnd_pos; lra). lra. }
  assert (s0 : 0 <= fadd x y) by (apply rnd_pos; lra).
  split; [apply F_rnd |]. split; [exact s0 |]. split; [lra |]. split.
  - assert (j * u <= k * u) by (apply Rmult_le_compat_r; lra).
    assert (j * u * x <= k * u * x) by (apply Rmult_le_compat_r; lra).
    assert (0 <= k * u) by (apply Rmult_le_pos; lra).
    apply Rle_trans with ((1 + k * u) * (x + y)); [lra |].
    apply Rle_trans with ((1 + k * u) * ((1 + u) * fadd x y)); [apply Rmult_le_compat_l; lra |].
    rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [exact s0 |].
    assert (k * u <= 10 * u) by (apply Rmult_le_compat_r; lra).
    assert (k * u * u <= 1 * u) by (apply Rmult_le_compat_r; lra). lra.
  - intro L. generalize (small_sum x y Fx Fy x0 y0 L). intro Z. rewrite Z in *. rewrite Ex, Ey by lra. reflexivity.
Qed.

Lemma grow_sum k x X : 0 <= k <= 12 -> near_sum k x X -> X <= fmul x grow.
Proof.
  intros K (Fx & x0 & X0 & H & E). generalize u_bounds. intro U.
  assert (G : 1 <= grow) by (unfold grow; lra).
  assert (M : x * 1 <= x * grow) by (apply Rmult_le_compat_l; lra). rewrite Rmult_1_r in M.
  destruct (Rlt_le_dec x (bpow radix2 (-1022))) as [S | S].
  - rewrite (E S). rewrite <- (rnd_F x Fx) at 1. now apply rnd_le.
  - apply Rle_trans with (x * grow * (1 - u)); [| apply rnd_normal_le; lra].
    apply Rle_trans with (1 := H). rewrite (Rmult_comm (1 + k * u)), Rmult_assoc. apply Rmult_le_compat_l; [exact x0 |].
    assert (k * u <= 12 * u) by (apply Rmult_le_compat_r; lra).
    apply Rle_trans with (1 + 12 * u); [lra | unfold grow, u; lra].
Qed.

Lemma norm_sum_2 a b : sqrt (a * a + b * b) <= Rabs a + Rabs b.
Proof.
  generalize (Rabs_pos a) (Rabs_pos b). intros. rewrite <- (sqrt_square (Rabs a + Rabs b)) by lra. apply sqrt_le_1_alt.
  assert (Q : forall t, t * t = Rabs t * Rabs t) by (intro; rewrite <- Rabs_mult, Rabs_pos_eq; [reflexivity | apply Rle_0_sqr]).
  rewrite (Q a), (Q b). assert (0 <= Rabs a * Rabs b) by now apply Rmult_le_pos. lra.
Qed.

Lemma norm_sum_3 a b c : sqrt (a * a + b * b + c * c) <= Rabs a + Rabs b + Rabs c.
Proof.
  generalize (norm_sum_2 (sqrt (a * a + b * b)) c) (norm_sum_2 a b).
  rewrite sqrt_sqrt by (generalize (Rle_0_sqr a) (Rle_0_sqr b); unfold Rsqr; lra).
  rewrite (Rabs_pos_eq (sqrt _)) by apply sqrt_pos. lra.
Qed.
