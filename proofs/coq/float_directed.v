(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Tails with directed rounding: the exact stage (quotient_by_roots_lower and is_at_least of src/annulus/arithmetic/exact.cpp) and
   the interval stage (roots_upper, quotient_lower, unscaled_lower). They hold for any formats: nothing of a rounding is used but
   that it goes down or up. The inequalities do not depend on the absence of underflow. *)
Require Import Reals Lra Psatz ZArith.
From Flocq Require Import Core.
Open Scope R_scope.

Section directed.
Variable beta : radix.
Variable fexp : Z -> Z.
Context { valid : Valid_exp fexp }.
Definition RD x := round beta fexp Zfloor x.
Definition RU x := round beta fexp Zceil x.

Lemma RD_le x : RD x <= x.
Proof. now apply round_DN_pt. Qed.
Lemma RU_ge x : x <= RU x.
Proof. now apply round_UP_pt. Qed.

Lemma RD_pos x : 0 <= x -> 0 <= RD x.
Proof. intro. unfold RD. rewrite <- (round_0 beta fexp Zfloor). apply round_le; auto with typeclass_instances. Qed.

(* The interval stage has one mode, upward: x / y rounded down is - RU(- x / y). *)
Lemma quotient_lower x y : - RU (- x / y) <= x / y.
Proof. generalize (RU_ge (- x / y)). unfold Rdiv. lra. Qed.

Lemma root_upper a a' : a <= a' -> sqrt a <= RU (sqrt a').
Proof. intro H. apply Rle_trans with (2 := RU_ge _). now apply sqrt_le_1_alt. Qed.

(* Lower bounds of the determinant and upper bounds of the squares, whatever they come from. *)
Lemma quotient_le det det' a a' b b' roots : 0 <= det' <= det -> 0 < sqrt a + sqrt b -> a <= a' -> b <= b' ->
  RU (sqrt a') + RU (sqrt b') <= roots -> det' / roots <= det / (sqrt a + sqrt b).
Proof.
  intros D P A B R. generalize (root_upper _ _ A) (root_upper _ _ B). intros.
  unfold Rdiv. apply Rmult_le_compat; try lra; [left; apply Rinv_0_lt_compat; lra | apply Rinv_le; lra].
Qed.

Theorem interval_tail det lower a upper_a b upper_b : 0 <= lower <= det -> 0 < sqrt a + sqrt b -> a <= upper_a -> b <= upper_b ->
  - RU (- lower / RU (RU (sqrt upper_a) + RU (sqrt upper_b))) <= det / (sqrt a + sqrt b).
Proof.
  intros D P A B. apply Rle_trans with (1 := quotient_lower _ _).
  apply quotient_le with upper_a upper_b; try assumption. apply RU_ge.
Qed.

(* The scale is undone by two divisions by powers of two. *)
Theorem interval_unscaled x truth s1 s2 : 0 < s1 -> 0 < s2 -> x <= truth * (s1 * s2) ->
  - RU (- - RU (- x / s1) / s2) <= truth.
Proof.
  intros P1 P2 H. apply Rle_trans with (1 := quotient_lower _ _). apply Rmult_le_reg_r with s2; [exact P2 |].
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. apply Rle_trans with (1 := quotient_lower _ _).
  apply Rmult_le_reg_r with s1; [exact P1 |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. lra.
Qed.

(* The exact stage: numbers of 128 bits, then a double (another format). *)
Variable fexp' : Z -> Z.
Context { valid' : Valid_exp fexp' }.
Theorem exact_tail numerator a b exponent : 0 <= numerator -> 0 < sqrt a + sqrt b ->
  round beta fexp' Zfloor
    (RD (RD (RD numerator / RU (RU (sqrt (RU a)) + RU (sqrt (RU b)))) * bpow beta exponent))
  <= numerator * bpow beta exponent / (sqrt a + sqrt b).
Proof.
  intros N P. apply Rle_trans with (RD (RD (RD numerator / RU (RU (sqrt (RU a)) + RU (sqrt (RU b)))) * bpow beta exponent)).
  { exact (proj1 (proj2 (round_DN_pt beta fexp' _))). }
  apply Rle_trans with (1 := RD_le _).
  replace (numerator * bpow beta exponent / (sqrt a + sqrt b)) with (numerator / (sqrt a + sqrt b) * bpow beta exponent)
    by (field; lra).
  apply Rmult_le_compat_r; [apply bpow_ge_0 |]. apply Rle_trans with (1 := RD_le _).
  apply quotient_le with (RU a) (RU b); try apply RU_ge; [| exact P].
  split; [now apply RD_pos | apply RD_le].
Qed.
End directed.

(* The comparison of a double y = z 2^k with x 2^k / (sqrt a + sqrt b), in integers only. *)
Theorem is_at_least_sound x z a b : 0 <= x -> 0 <= z -> 0 <= a -> 0 <= b ->
  let r := x * x - z * z * (a + b) in
  0 <= r -> 4 * (z * z) * (z * z) * a * b <= r * r -> z * (sqrt a + sqrt b) <= x.
Proof.
  intros X Z A B r R H.
  generalize (sqrt_sqrt a A) (sqrt_sqrt b B) (sqrt_pos a) (sqrt_pos b). set (s := sqrt a). set (t := sqrt b). intros S T S0 T0.
  assert (zz : 0 <= z * z) by (apply Rle_0_sqr). assert (st : 0 <= s * t) by now apply Rmult_le_pos.
  assert (C : 2 * (z * z) * (s * t) <= r).
  { apply Rsqr_incr_0_var; [| exact R]. unfold Rsqr.
    replace (2 * (z * z) * (s * t) * (2 * (z * z) * (s * t))) with (4 * (z * z) * (z * z) * (s * s) * (t * t)) by ring.
    now rewrite S, T. }
  apply Rsqr_incr_0_var; [| exact X]. unfold Rsqr.
  replace (z * (s + t) * (z * (s + t))) with (z * z * (s * s + t * t) + 2 * (z * z) * (s * t)) by ring.
  rewrite S, T. unfold r in C. lra.
Qed.

(* And the other way: it says no only where z is too large. *)
Theorem is_at_least_complete x z a b : 0 <= x -> 0 <= z -> 0 <= a -> 0 <= b ->
  let r := x * x - z * z * (a + b) in
  z * (sqrt a + sqrt b) <= x -> 0 <= r /\ 4 * (z * z) * (z * z) * a * b <= r * r.
Proof.
  intros X Z A B r H.
  generalize (sqrt_sqrt a A) (sqrt_sqrt b B) (sqrt_pos a) (sqrt_pos b). set (s := sqrt a) in *. set (t := sqrt b) in *.
  intros S T S0 T0.
  assert (zz : 0 <= z * z) by (apply Rle_0_sqr). assert (st : 0 <= s * t) by now apply Rmult_le_pos.
  assert (Q : z * (s + t) * (z * (s + t)) <= x * x).
  { apply Rmult_le_compat; try assumption; apply Rmult_le_pos; lra. }
  assert (C : 2 * (z * z) * (s * t) <= r).
  { unfold r. rewrite <- S, <- T. replace (z * (s + t) * (z * (s + t)))
      with (z * z * (s * s + t * t) + 2 * (z * z) * (s * t)) in Q by ring. lra. }
  assert (C0 : 0 <= 2 * (z * z) * (s * t)) by (apply Rmult_le_pos; lra).
  split; [lra |].
  rewrite <- S, <- T. replace (4 * (z * z) * (z * z) * (s * s) * (t * t))
    with (2 * (z * z) * (s * t) * (2 * (z * z) * (s * t))) by ring.
  apply Rmult_le_compat; assumption.
Qed.
