(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter stage of src/annulus/certificate/ladder_2.h, from coordinates to answer: what it accepts as positive or
   negative is so, and its tolerance is at most the exact quotient determinant / (sqrt(inner) + sqrt(outer)).

   The coordinates are any numbers of the format. *)
Require Import Reals Lra Psatz ZArith List.
From Flocq Require Import Core.
From Annulus Require Import float_model float_error float_terms_2 float_tail float_filter.
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

Theorem orientation_filter_sound x0 y0 x1 y1 x2 y2 certified :
  F x0 -> F y0 -> F x1 -> F y1 -> F x2 -> F y2 ->
  sound (orientation_filter x0 y0 x1 y1 x2 y2 certified) certified
    (orientation_truth x0 y0 x1 y1 x2 y2)
    (sqrt (longest_truth x0 y0 x1 y1 x2 y2) + sqrt (longest_truth x0 y0 x1 y1 x2 y2)).
Proof.
  intros Fx0 Fy0 Fx1 Fy1 Fx2 Fy2. unfold orientation_filter. cbv zeta.
  assert (Fu1 : F (fsub x1 x0)) by apply F_rnd. assert (Fu2 : F (fsub y1 y0)) by apply F_rnd.
  assert (Fv1 : F (fsub x2 x0)) by apply F_rnd. assert (Fv2 : F (fsub y2 y0)) by apply F_rnd.
  generalize (side_lower x1 y1 x0 y0 Fx1 Fy1 Fx0 Fy0) (side_lower x2 y2 x0 y0 Fx2 Fy2 Fx0 Fy0)
    (side_lower x2 y2 x1 y1 Fx2 Fy2 Fx1 Fy1).
  generalize (rnd_sub_result x1 x0 Fx1 Fx0) (rnd_sub_result y1 y0 Fy1 Fy0) (rnd_sub_result x2 x0 Fx2 Fx0)
    (rnd_sub_result y2 y0 Fy2 Fy0) (rnd_sub_result x2 x1 Fx2 Fx1) (rnd_sub_result y2 y1 Fy2 Fy1).
  fold (fsub x1 x0) (fsub y1 y0) (fsub x2 x0) (fsub y2 y0) (fsub x2 x1) (fsub y2 y1).
  set (ux := fsub x1 x0) in *. set (uy := fsub y1 y0) in *. set (vx := fsub x2 x0) in *. set (vy := fsub y2 y0) in *.
  set (wx := fsub x2 x1) in *. set (wy := fsub y2 y1) in *.
  intros Hux Huy Hvx Hvy Hwx Hwy Su Sv Sw.
  set (m := Rmax (mag ux uy) (mag vx vy)). destruct (in_range_dec 120 m) as [Range |]; [| discriminate].
  assert (M : bpow radix2 (-120) <= m).
  { apply (in_range_lower 120); [lia | | exact Range]. apply F_max; now apply F_mag. }
  generalize u_bounds (m_positive m M). intros U M0.
  assert (Bux : Rabs ux <= m) by (apply Rle_trans with (1 := proj1 (Rabs_le_mag ux uy)); apply Rmax_l).
  assert (Buy : Rabs uy <= m) by (apply Rle_trans with (1 := proj2 (Rabs_le_mag ux uy)); apply Rmax_l).
  assert (Bvx : Rabs vx <= m) by (apply Rle_trans with (1 := proj1 (Rabs_le_mag vx vy)); apply Rmax_r).
  assert (Bvy : Rabs vy <= m) by (apply Rle_trans with (1 := proj2 (Rabs_le_mag vx vy)); apply Rmax_r).
  (* the determinant *)
  set (x := env [ux; uy; vx; vy]). set (X := env [x1 - x0; y1 - y0; x2 - x0; y2 - y0]).
  destruct (error_below_sound m M X x) with (h := @nil (expr * Z)) (e := E_orientation) (k := 2%nat)
    (bX := (3 * one)%Z) (bC := (3 * one)%Z) (bE := (17 * half_u)%Z) as (_ & _ & De).
  { apply (env_all F); [exact F_0 |]. each; assumption. }
  { apply (env_all (fun a => Rabs a <= m)); [rewrite Rabs_R0; lra |]. each; assumption. }
  { apply (env_all_2 (fun a b => Rabs (a - b) <= u * m)); [rewrite Rminus_0_r, Rabs_R0; apply Rmult_le_pos; lra |].
    each; (eapply Rle_trans; [eassumption |]); apply Rmult_le_compat_l; lra. }
  { constructor. }
  { vm_compute. reflexivity. }
  rewrite half_units in De.
  change (rounded x E_orientation) with (F_orientation ux uy vx vy) in De.
  change (exact X E_orientation) with (orientation_truth x0 y0 x1 y1 x2 y2) in De.
  (* its error bound *)
  assert (P2 : bpow radix2 (-240) <= m ^ 2) by exact (pow_large m M 2).
  generalize (bpow_gt_0 radix2 (-240)). intro B240.
  generalize (error_bound_range m M 9 (power_2 m) 2 ltac:(lia) ltac:(lia) (power_2_range_6 m M)). intros [EL EH].
  set (e := error_bound 9 (power_2 m)) in *. replace (IZR 9) with 9 in EL, EH by reflexivity.
  assert (E0 : u * m ^ 2 <= e).
  { apply Rle_trans with (2 := EL). apply Rmult_le_compat_r; [lra |]. unfold u. lra. }
  (* the longest side *)
  set (longest := Rmax (Rmax (F_side ux uy) (F_side vx vy)) (F_side wx wy)).
  set (T := longest_truth x0 y0 x1 y1 x2 y2).
  assert (T1 : R_side (x1 - x0) (y1 - y0) <= T /\ R_side (x2 - x0) (y2 - y0) <= T).
  { unfold T, longest_truth. split; apply Rle_trans with (2 := Rmax_l _ _); [apply Rmax_l | apply Rmax_r]. }
  assert (small : forall a, u * Rabs a <= / 10 * Rabs a)
    by (intro; apply Rmult_le_compat_r; [apply Rabs_pos | lra]).
  assert (coordinate : forall a A, Rabs (a - A) <= u * Rabs a -> a * a <= 2 * (A * A)).
  { intros a A H. generalize (Rabs_triang (a - A) A). replace (a - A + A) with a by ring. intro Q.
    assert (R : Rabs a <= 5 / 4 * Rabs A).
    { generalize (small a) (Rabs_pos a). lra. }
    rewrite <- (Rabs_pos_eq (a * a)), <- (Rabs_pos_eq (A * A)) by apply Rle_0_sqr. rewrite !Rabs_mult.
    generalize (mul_below _ _ _ _ (Rabs_pos a) (Rabs_pos a) R R) (Rle_0_sqr (Rabs A)). unfold Rsqr. lra. }
  assert (Tm : m ^ 2 <= 2 * T).
  { assert (C : forall a A S, Rabs (a - A) <= u * Rabs a -> A * A <= S -> S <= T -> Rabs a ^ 2 <= 2 * T).
    { intros a A S H1 HS HT. generalize (coordinate a A H1). rewrite pow2_abs. simpl. lra. }
    assert (N : forall a, 0 <= a * a) by (intro; apply Rle_0_sqr).
    unfold m, mag, Rmax. destruct T1 as [Tu Tv]. unfold R_side, side_square, squared in Tu, Tv.
    destruct (Rle_dec (Rabs ux) (Rabs uy)); destruct (Rle_dec (Rabs vx) (Rabs vy));
      match goal with |- context [if ?d then _ else _] => destruct d end.
    all: first [ refine (C _ _ _ Hux _ Tu); generalize (N (y1 - y0)); lra
               | refine (C _ _ _ Huy _ Tu); generalize (N (x1 - x0)); lra
               | refine (C _ _ _ Hvx _ Tv); generalize (N (y2 - y0)); lra
               | refine (C _ _ _ Hvy _ Tv); generalize (N (x2 - x0)); lra ]. }
  assert (Tpos : bpow radix2 (-122) <= sqrt T).
  { rewrite <- (sqrt_square (bpow radix2 (-122))) by apply bpow_ge_0. apply sqrt_le_1_alt. rewrite <- bpow_plus.
    apply Rle_trans with (bpow radix2 (-1) * bpow radix2 (-240)).
    - rewrite <- bpow_plus. apply bpow_le. lia.
    - change (bpow radix2 (-1)) with (/ 2). lra. }
  assert (low : (1 - 3 * u) * sqrt T - tiny <= sqrt longest).
  { assert (N : sqrt (F_side ux uy) <= sqrt longest /\ sqrt (F_side vx vy) <= sqrt longest /\
                sqrt (F_side wx wy) <= sqrt longest).
    { unfold longest. repeat split; apply sqrt_le_1_alt.
      - apply Rle_trans with (2 := Rmax_l _ _). apply Rmax_l.
      - apply Rle_trans with (2 := Rmax_l _ _). apply Rmax_r.
      - apply Rmax_r. }
    destruct N as (Nu & Nv & Nw). unfold T, longest_truth, Rmax.
    destruct (Rle_dec (R_side (x1 - x0) (y1 - y0)) (R_side (x2 - x0) (y2 - y0)));
      match goal with |- context [if ?d then _ else _] => destruct d end; lra. }
  assert (tiny_small : tiny <= u * sqrt T).
  { apply Rle_trans with (u * bpow radix2 (-122)).
    - change u with (bpow radix2 (-53)). rewrite <- bpow_plus. apply bpow_le. lia.
    - apply Rmult_le_compat_l; lra. }
  assert (Bwx : Rabs wx <= 4 * m /\ Rabs wy <= 4 * m).
  { assert (third : forall p q w a b, Rabs (p - a) <= u * Rabs p -> Rabs (q - b) <= u * Rabs q -> Rabs p <= m ->
      Rabs q <= m -> Rabs (w - (q - p + (p - a) - (q - b))) <= u * Rabs w -> Rabs w <= 4 * m).
    { intros p q w a b H1 H2' B1 B2 H3.
      set (s := q - p + (p - a) - (q - b)) in *.
      assert (Rabs s <= 3 * m).
      { unfold s. replace (q - p + (p - a) - (q - b)) with (q + (- p) + (p - a) + (- (q - b))) by ring.
        generalize (Rabs_triang (q + - p + (p - a)) (- (q - b))) (Rabs_triang (q + - p) (p - a)) (Rabs_triang q (- p)).
        rewrite !Rabs_Ropp. generalize (small p) (small q). lra. }
      generalize (Rabs_triang (w - s) s). replace (w - s + s) with w by ring.
      generalize (Rabs_pos w) (small w). lra. }
    split.
    - apply (third ux vx wx (x1 - x0) (x2 - x0) Hux Hvx Bux Bvx).
      replace (vx - ux + (ux - (x1 - x0)) - (vx - (x2 - x0))) with (x2 - x1) by ring. exact Hwx.
    - apply (third uy vy wy (y1 - y0) (y2 - y0) Huy Hvy Buy Bvy).
      replace (vy - uy + (uy - (y1 - y0)) - (vy - (y2 - y0))) with (y2 - y1) by ring. exact Hwy. }
  assert (high : sqrt longest <= 16 * m).
  { assert (N : bpow radix2 (-500) <= 4 * m).
    { apply Rle_trans with (bpow radix2 (-120)); [apply bpow_le; lia | lra]. }
    assert (S : sqrt (F_side ux uy) <= 16 * m /\ sqrt (F_side vx vy) <= 16 * m /\ sqrt (F_side wx wy) <= 16 * m).
    { repeat split; replace (16 * m) with (4 * (4 * m)) by ring; apply norm_2_upper; lra. }
    unfold longest, Rmax. repeat destruct Rle_dec; apply S. }
  change (fmul m m) with (power_2 m). fold e.
  assert (double : fmul 2 (rnd (sqrt longest)) = 2 * rnd (sqrt longest)) by (apply rnd_F, F_double, F_rnd).
  assert (Fl : F longest) by (apply F_max; [apply F_max |]; apply F_rnd).
  generalize (rnd_sqrt_le _ Fl) (sqrt_pos longest). intros [RL RH] l0.
  assert (RH' : sqrt longest * (1 + u) <= sqrt longest * 2) by (apply Rmult_le_compat_l; lra).
  apply decide_sound.
  - apply F_rnd.
  - apply F_rnd.
  - apply F_error_bound.
  - exact F_0.
  - apply Rlt_le_trans with (2 := E0). apply Rmult_lt_0_compat; lra.
  - lra.
  - apply fmul_pos; [lra | now apply rnd_pos].
  - intros _. generalize (bpow_gt_0 radix2 (-122)). lra.
  - apply Rle_trans with (1 := De). apply Rle_trans with (2 := EL).
    apply Rmult_le_compat_r; [lra |]. unfold u. lra.
  - rewrite double, Rplus_0_r.
    assert (low' : (1 - 4 * u) * sqrt T <= sqrt longest) by lra.
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
