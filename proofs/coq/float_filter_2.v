(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter stage of src/annulus/predicate/filtered_2.h, from coordinates to answer: what it accepts as positive or
   negative is so, and its tolerance is at most the exact quotient determinant / (sqrt(inner) + sqrt(outer)).

   The coordinates are any numbers of the format. *)
Require Import Reals Lra Psatz ZArith List.
From Flocq Require Import Core.
From Annulus Require Import float_model float_error_sound float_terms_2 float_tail float_filter.
Import ListNotations.
Open Scope R_scope.

(* ---- Orientation ---- *)

Section orientation.
Variables x0 y0 x1 y1 x2 y2 : R.

(* As the code has it. *)
Definition orientation_filter (certified : bool) : option (Z * R) :=
  let ux := fsub x1 x0 in let uy := fsub y1 y0 in
  let vx := fsub x2 x0 in let vy := fsub y2 y0 in
  let wx := fsub x2 x1 in let wy := fsub y2 y1 in
  let m := Rmax (mag ux uy) (mag vx vy) in
  if in_range_dec 120 m then
    let longest := Rmax (Rmax (F_side ux uy) (F_side vx vy)) (F_side wx wy) in
    decide (F_orientation ux uy vx vy) (fmul 2 (rnd (sqrt longest))) (error_bound 9 (fmul m m)) 0 certified
  else None.

(* As it is meant. *)
Definition orientation_truth : R := R_orientation (x1 - x0) (y1 - y0) (x2 - x0) (y2 - y0).
Definition longest_truth : R :=
  Rmax (Rmax (R_side (x1 - x0) (y1 - y0)) (R_side (x2 - x0) (y2 - y0))) (R_side (x2 - x1) (y2 - y1)).
End orientation.

(* A computed side of a triangle is shorter than the exact one by a factor, and underflow. *)
Lemma side_lower x y x' y' : F x -> F y -> F x' -> F y' ->
  (1 - 3 * u) * sqrt (R_side (x - x') (y - y')) - tiny <= sqrt (F_side (fsub x x') (fsub y y')).
Proof.
  intros Fx Fy Fx' Fy'.
  generalize (rnd_sub_result x x' Fx Fx') (rnd_sub_result y y' Fy Fy') u_bounds tiny_pos.
  fold (fsub x x') (fsub y y'). set (a := fsub x x'). set (b := fsub y y'). set (A := x - x'). set (B := y - y').
  intros HA HB U T. apply Rle_trans with (2 := norm_2_lower a b).
  apply Rplus_le_compat_r.
  assert (S : forall s S, Rabs (s - S) <= u * Rabs s -> (1 - u) * (1 - u) * (S * S) <= s * s).
  { intros s S H. assert (Q : (1 - u) * Rabs S <= Rabs s).
    { generalize (Rabs_triang s (- (s - S))). rewrite Rabs_Ropp. replace (s + - (s - S)) with S by ring.
      generalize (Rabs_pos s). intros P L. assert (Rabs S <= (1 + u) * Rabs s) by lra. nra. }
    rewrite <- (Rabs_pos_eq (S * S)), <- (Rabs_pos_eq (s * s)) by apply Rle_0_sqr. rewrite !Rabs_mult.
    generalize (Rabs_pos S). intro P. replace ((1 - u) * (1 - u) * (Rabs S * Rabs S))
      with (((1 - u) * Rabs S) * ((1 - u) * Rabs S)) by ring.
    assert (0 <= (1 - u) * Rabs S) by (apply Rmult_le_pos; lra). apply Rmult_le_compat; assumption. }
  generalize (S _ _ HA) (S _ _ HB). intros SA SB.
  assert (L : (1 - u) * sqrt (R_side A B) <= sqrt (a * a + b * b)).
  { rewrite <- (sqrt_square (1 - u)) by lra. rewrite <- sqrt_mult_alt by nra. apply sqrt_le_1_alt.
    unfold R_side, side_square, squared. lra. }
  apply Rle_trans with ((1 - u) * ((1 - u) * sqrt (R_side A B))).
  - rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [apply sqrt_pos | nra].
  - apply Rmult_le_compat_l; [lra | exact L].
Qed.

(* ---- From coordinates ---- *)

Lemma relative_small a : u * Rabs a <= / 10 * Rabs a.
Proof. generalize u_bounds. intro. apply Rmult_le_compat_r; [apply Rabs_pos | lra]. Qed.

Lemma square_of_difference a A S : Rabs (a - A) <= u * Rabs a -> A * A <= S -> Rabs a ^ 2 <= 2 * S.
Proof.
  intros H L. generalize (Rabs_triang (a - A) A). replace (a - A + A) with a by ring. intro Q.
  assert (R : Rabs a <= 5 / 4 * Rabs A) by (generalize (relative_small a) (Rabs_pos a); lra).
  generalize (mul_below _ _ _ _ (Rabs_pos a) (Rabs_pos a) R R) (Rle_0_sqr (Rabs A)). unfold Rsqr.
  replace (5 / 4 * Rabs A * (5 / 4 * Rabs A)) with (25 / 16 * (Rabs A * Rabs A)) by field.
  rewrite <- (Rabs_mult A A), (Rabs_pos_eq (A * A)) by apply Rle_0_sqr. simpl pow. rewrite Rmult_1_r. lra.
Qed.

(* The third side, from the other two. *)
Lemma third_side m p q w a b : Rabs (p - a) <= u * Rabs p -> Rabs (q - b) <= u * Rabs q -> Rabs p <= m -> Rabs q <= m ->
  Rabs (w - (b - a)) <= u * Rabs w -> Rabs w <= 4 * m.
Proof.
  intros H1 H2 B1 B2. replace (b - a) with (q + (- p) + (p - a) + (- (q - b))) by ring. intro H3.
  set (s := q + (- p) + (p - a) + (- (q - b))) in *.
  assert (Rabs s <= 3 * m).
  { unfold s. generalize (Rabs_triang (q + - p + (p - a)) (- (q - b))) (Rabs_triang (q + - p) (p - a)) (Rabs_triang q (- p)).
    rewrite !Rabs_Ropp. generalize (relative_small p) (relative_small q) (Rabs_pos p). lra. }
  generalize (Rabs_triang (w - s) s). replace (w - s + s) with w by ring.
  generalize (Rabs_pos w) (Rabs_pos p) (relative_small w). lra.
Qed.

Section coordinates.
Variables x0 y0 x1 y1 x2 y2 : R.
Hypotheses (Fx0 : F x0) (Fy0 : F y0) (Fx1 : F x1) (Fy1 : F y1) (Fx2 : F x2) (Fy2 : F y2).
Let ux := fsub x1 x0. Let uy := fsub y1 y0.
Let vx := fsub x2 x0. Let vy := fsub y2 y0.
Let wx := fsub x2 x1. Let wy := fsub y2 y1.
Let m := Rmax (mag ux uy) (mag vx vy).
Hypothesis Range : in_range 120 m.
Let e := error_bound 9 (power_2 m).
Let longest := Rmax (Rmax (F_side ux uy) (F_side vx vy)) (F_side wx wy).
Let T := longest_truth x0 y0 x1 y1 x2 y2.

Let Hux : Rabs (ux - (x1 - x0)) <= u * Rabs ux := rnd_sub_result x1 x0 Fx1 Fx0.
Let Huy : Rabs (uy - (y1 - y0)) <= u * Rabs uy := rnd_sub_result y1 y0 Fy1 Fy0.
Let Hvx : Rabs (vx - (x2 - x0)) <= u * Rabs vx := rnd_sub_result x2 x0 Fx2 Fx0.
Let Hvy : Rabs (vy - (y2 - y0)) <= u * Rabs vy := rnd_sub_result y2 y0 Fy2 Fy0.
Let Hwx : Rabs (wx - (x2 - x1)) <= u * Rabs wx := rnd_sub_result x2 x1 Fx2 Fx1.
Let Hwy : Rabs (wy - (y2 - y1)) <= u * Rabs wy := rnd_sub_result y2 y1 Fy2 Fy1.

Lemma m_large : bpow radix2 (-120) <= m.
Proof. apply (in_range_lower 120); [lia | | exact Range]. apply F_max; apply F_mag; apply F_rnd. Qed.
Lemma m_pos : 0 < m.
Proof. exact (m_positive m m_large). Qed.

Lemma sides_small : Rabs ux <= m /\ Rabs uy <= m /\ Rabs vx <= m /\ Rabs vy <= m.
Proof.
  destruct (Rabs_le_mag ux uy) as [A B]. destruct (Rabs_le_mag vx vy) as [C D]. generalize (Rmax_l (mag ux uy) (mag vx vy)) (Rmax_r (mag ux uy) (mag vx vy)).
  fold m. intros. repeat split; lra.
Qed.

(* ---- The determinant ---- *)

Lemma determinant_near : Rabs (F_orientation ux uy vx vy - orientation_truth x0 y0 x1 y1 x2 y2) <= 17 / 2 * u * m ^ 2.
Proof.
  destruct sides_small as (Bux & Buy & Bvx & Bvy). generalize m_large m_pos u_bounds. intros M M0 U.
  set (x := env [ux; uy; vx; vy]). set (X := env [x1 - x0; y1 - y0; x2 - x0; y2 - y0]).
  destruct (error_below_sound m M X x) with (h := @nil (expr * Z)) (e := E_orientation) (k := 2%nat)
    (bX := (3 * one)%Z) (bC := (3 * one)%Z) (bE := (17 * half_u)%Z) as (_ & _ & De).
  { apply (env_all F); [exact F_0 |]. each; apply F_rnd. }
  { apply (env_all (fun a => Rabs a <= m)); [rewrite Rabs_R0; lra |]. each; assumption. }
  { apply (env_all_2 (fun a b => Rabs (a - b) <= u * m)); [rewrite Rminus_0_r, Rabs_R0; apply Rmult_le_pos; lra |].
    each; (eapply Rle_trans; [eassumption |]); apply Rmult_le_compat_l; lra. }
  { constructor. }
  { vm_compute. reflexivity. }
  rewrite half_units in De. exact De.
Qed.

Lemma error_covers : u * m ^ 2 <= e /\ Rabs (F_orientation ux uy vx vy - orientation_truth x0 y0 x1 y1 x2 y2) <= e.
Proof.
  generalize m_large m_pos u_bounds determinant_near. intros M M0 U De.
  assert (P2 : bpow radix2 (-240) <= m ^ 2) by exact (pow_large m M 2). generalize (bpow_gt_0 radix2 (-240)). intro B.
  destruct (error_bound_range m M 9 (power_2 m) 2 ltac:(lia) ltac:(lia) (power_2_range_6 m M)) as [EL _]. fold e in EL.
  split; [|apply Rle_trans with (1 := De)]; apply Rle_trans with (2 := EL); (apply Rmult_le_compat_r; [lra |]); unfold u; lra.
Qed.

(* ---- The longest side ---- *)

Lemma longest_truth_large : m ^ 2 <= 2 * T.
Proof.
  assert (N : forall a, 0 <= a * a) by (intro; apply Rle_0_sqr).
  assert (Tu : R_side (x1 - x0) (y1 - y0) <= T) by (apply Rle_trans with (2 := Rmax_l _ _); apply Rmax_l).
  assert (Tv : R_side (x2 - x0) (y2 - y0) <= T) by (apply Rle_trans with (2 := Rmax_l _ _); apply Rmax_r).
  unfold R_side, side_square, squared in Tu, Tv. unfold m, mag, Rmax.
  destruct (Rle_dec (Rabs ux) (Rabs uy)); destruct (Rle_dec (Rabs vx) (Rabs vy));
    match goal with |- context [if ?d then _ else _] => destruct d end.
  all: first [ apply (square_of_difference _ _ _ Hux); generalize (N (y1 - y0)); lra
             | apply (square_of_difference _ _ _ Huy); generalize (N (x1 - x0)); lra
             | apply (square_of_difference _ _ _ Hvx); generalize (N (y2 - y0)); lra
             | apply (square_of_difference _ _ _ Hvy); generalize (N (x2 - x0)); lra ].
Qed.

Lemma root_truth_large : bpow radix2 (-122) <= sqrt T.
Proof.
  assert (P2 : bpow radix2 (-240) <= m ^ 2) by exact (pow_large m m_large 2).
  rewrite <- (sqrt_square (bpow radix2 (-122))) by apply bpow_ge_0. apply sqrt_le_1_alt. rewrite <- bpow_plus.
  apply Rle_trans with (bpow radix2 (-1) * bpow radix2 (-240)).
  - rewrite <- bpow_plus. apply bpow_le. lia.
  - change (bpow radix2 (-1)) with (/ 2). generalize longest_truth_large. lra.
Qed.

Lemma longest_low : (1 - 4 * u) * sqrt T <= sqrt longest.
Proof.
  generalize (side_lower x1 y1 x0 y0 Fx1 Fy1 Fx0 Fy0) (side_lower x2 y2 x0 y0 Fx2 Fy2 Fx0 Fy0) (side_lower x2 y2 x1 y1 Fx2 Fy2 Fx1 Fy1).
  fold ux uy vx vy wx wy. intros Su Sv Sw.
  assert (Nu : sqrt (F_side ux uy) <= sqrt longest) by (apply sqrt_le_1_alt, Rle_trans with (2 := Rmax_l _ _), Rmax_l).
  assert (Nv : sqrt (F_side vx vy) <= sqrt longest) by (apply sqrt_le_1_alt, Rle_trans with (2 := Rmax_l _ _), Rmax_r).
  assert (Nw : sqrt (F_side wx wy) <= sqrt longest) by (apply sqrt_le_1_alt, Rmax_r).
  assert (low : (1 - 3 * u) * sqrt T - tiny <= sqrt longest).
  { unfold T, longest_truth, Rmax. destruct (Rle_dec (R_side (x1 - x0) (y1 - y0)) (R_side (x2 - x0) (y2 - y0)));
      match goal with |- context [if ?d then _ else _] => destruct d end; lra. }
  assert (tiny <= u * sqrt T).
  { apply Rle_trans with (u * bpow radix2 (-122)).
    - change u with (bpow radix2 (-53)). rewrite <- bpow_plus. apply bpow_le. lia.
    - apply Rmult_le_compat_l; [generalize u_bounds; lra | exact root_truth_large]. }
  lra.
Qed.

Lemma longest_high : sqrt longest <= 16 * m.
Proof.
  destruct sides_small as (Bux & Buy & Bvx & Bvy). generalize m_large m_pos (bpow_gt_0 radix2 (-120)). intros M M0 B.
  assert (Bwx : Rabs wx <= 4 * m).
  { apply (third_side m ux vx wx (x1 - x0) (x2 - x0)); try assumption. replace (x2 - x0 - (x1 - x0)) with (x2 - x1) by ring. exact Hwx. }
  assert (Bwy : Rabs wy <= 4 * m).
  { apply (third_side m uy vy wy (y1 - y0) (y2 - y0)); try assumption. replace (y2 - y0 - (y1 - y0)) with (y2 - y1) by ring. exact Hwy. }
  assert (N : bpow radix2 (-500) <= 4 * m) by (apply Rle_trans with (bpow radix2 (-120)); [apply bpow_le; lia | lra]).
  replace (16 * m) with (4 * (4 * m)) by ring. unfold longest, Rmax. repeat destruct Rle_dec; apply norm_2_upper; lra.
Qed.

(* ---- The answer ---- *)

Lemma decided certified : sound (decide (F_orientation ux uy vx vy) (fmul 2 (rnd (sqrt longest))) e 0 certified) certified
  (orientation_truth x0 y0 x1 y1 x2 y2) (sqrt T + sqrt T).
Proof.
  generalize m_large m_pos u_bounds longest_low longest_high root_truth_large. intros M M0 U low high large. destruct error_covers as [E0 De].
  assert (double : fmul 2 (rnd (sqrt longest)) = 2 * rnd (sqrt longest)) by (apply rnd_F, F_double, F_rnd).
  assert (Fl : F longest) by (apply F_max; [apply F_max |]; apply F_rnd).
  generalize (rnd_sqrt_le _ Fl) (sqrt_pos longest). intros [RL RH] l0.
  assert (RH' : sqrt longest * (1 + u) <= sqrt longest * 2) by (apply Rmult_le_compat_l; lra).
  assert (0 < m ^ 2) by (apply pow_lt; lra).
  apply decide_sound.
  - apply F_rnd.
  - apply F_rnd.
  - apply F_error_bound.
  - exact F_0.
  - apply Rlt_le_trans with (2 := E0). apply Rmult_lt_0_compat; lra.
  - lra.
  - apply fmul_pos; [lra | now apply rnd_pos].
  - intros _. generalize (bpow_gt_0 radix2 (-122)). lra.
  - exact De.
  - rewrite double, Rplus_0_r.
    assert ((1 - 4 * u) * sqrt T * (1 - u) <= sqrt longest * (1 - u)) by (apply Rmult_le_compat_r; lra).
    assert (0 <= u * sqrt T) by (apply Rmult_le_pos; [lra | apply sqrt_pos]).
    assert (0 <= u * (u * sqrt T)) by (apply Rmult_le_pos; lra). lra.
  - rewrite double, Rplus_0_r. apply Rle_trans with (2 := E0).
    apply Rle_trans with (bpow radix2 (-900) * (64 * m)).
    + apply Rmult_le_compat_l; [apply bpow_ge_0 | lra].
    + simpl pow. rewrite Rmult_1_r. rewrite <- !Rmult_assoc. apply Rmult_le_compat_r; [lra |].
      apply Rle_trans with (u * bpow radix2 (-120)).
      * change u with (bpow radix2 (-53)). change 64 with (bpow radix2 6). rewrite <- !bpow_plus. apply bpow_le. lia.
      * apply Rmult_le_compat_l; lra.
Qed.
End coordinates.

Theorem orientation_filter_sound x0 y0 x1 y1 x2 y2 certified :
  F x0 -> F y0 -> F x1 -> F y1 -> F x2 -> F y2 ->
  sound (orientation_filter x0 y0 x1 y1 x2 y2 certified) certified
    (orientation_truth x0 y0 x1 y1 x2 y2)
    (sqrt (longest_truth x0 y0 x1 y1 x2 y2) + sqrt (longest_truth x0 y0 x1 y1 x2 y2)).
Proof.
  intros Fx0 Fy0 Fx1 Fy1 Fx2 Fy2. unfold orientation_filter. cbv zeta.
  destruct in_range_dec as [Range |]; [| discriminate]. now apply decided.
Qed.
