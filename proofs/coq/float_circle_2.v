(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter of the empty circle in the plane (empty_sphere_filter of src/annulus/predicate/filtered_2.h), from coordinates to
   answer: a sign it answers with is right, and a certified tolerance is at most the exact half width
   incircle / (|N| + |M|), for all coordinates of the format. *)
Require Import Reals Lra Psatz ZArith List.
From Flocq Require Import Core.
From Annulus Require Import float_model float_error_sound float_terms_2 float_tail float_filter.
Import ListNotations.
Open Scope R_scope.

(* ---- Error bounds of the terms ---- *)

(* Magnitudes that the tree of operations does not show: D = b x e, and e.x ((q.x + p.x) - b.x) = q.x^2 - p.x^2 - b.x e.x. *)
Definition E_D : expr :=
  Plus (Minus (Times (Var 0) (Var 5)) (Times (Var 1) (Var 4))) (Minus (Times (Var 1) (Var 2)) (Times (Var 0) (Var 3))).
Definition E_eg_x : expr := Times (Var 6) (Minus (Plus (Var 4) (Var 2)) (Var 0)).
Definition E_eg_y : expr := Times (Var 7) (Minus (Plus (Var 5) (Var 3)) (Var 1)).
Definition hints_2 : hints := [(E_D, two_products); (E_eg_x, two_products); (E_eg_y, two_products)].

(* The constants of bounds.h, in halves of u: 177 less a half, for the rounding of the error bound itself; 69 and 123 are
   more than this analysis needs. *)
Definition within (e : expr) (k : nat) (C E : Z) : bool := error_below hints_2 e k (C * one) (C * one) (E * half_u).

Lemma constants_2 :
  within (incircle E_annulus) 4 17 353 = true /\
  within (nx E_annulus) 3 8 138 = true /\ within (ny E_annulus) 3 8 138 = true /\
  within (mx E_annulus) 3 12 246 = true /\ within (my E_annulus) 3 12 246 = true.
Proof. do 4 (apply conj; [vm_compute; reflexivity |]). vm_compute. reflexivity. Qed.

(* The least integers that this analysis proves, in u. *)
Lemma constants_2_least :
  map (least_error hints_2) [E_orientation; incircle E_annulus; nx E_annulus; ny E_annulus; mx E_annulus; my E_annulus]
  = map Some [9; 177; 67; 67; 121; 121]%Z.
Proof. vm_compute. reflexivity. Qed.

Section hints.
Variable m : R.
Hypothesis m_large : bpow radix2 (-120) <= m.
Variable X : nat -> R.
Hypothesis X_small : forall n, Rabs (X n) <= IZR exact_one * scale m 1.
Hypothesis X_e : X 6%nat = X 4%nat - X 2%nat /\ X 7%nat = X 5%nat - X 3%nat.

Lemma hints_2_hold : hints_hold m X hints_2.
Proof.
  destruct X_e as [E6 E7].
  assert (V0 : 0 <= IZR exact_one * scale m 1) by (apply Rle_trans with (2 := X_small 0); apply Rabs_pos).
  assert (VV : (IZR exact_one * scale m 1) * (IZR exact_one * scale m 1) <= IZR (prod exact_one exact_one) * scale m 2).
  { apply (prod_le m m_large exact_one exact_one 1 1); split; auto using Rle_refl. }
  set (V := IZR exact_one * scale m 1) in *.
  assert (B : forall n, - V <= X n <= V) by (intro n; generalize (Rabs_le_inv _ _ (X_small n)); auto).
  assert (S : forall n, 0 <= X n * X n <= V * V).
  { intro n. split; [apply Rle_0_sqr |]. specialize (B n). nra. }
  assert (P : forall i j, - (V * V) <= X i * X j <= V * V).
  { intros i j. apply Rabs_le_inv. rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. }
  assert (two_V : IZR two_products * scale m 2 >= 2 * (V * V)).
  { unfold two_products. rewrite mult_IZR. lra. }
  assert (degree : forall e k, (match bound hints_2 e with Some b => deg b = k | None => False end) ->
    forall b, bound hints_2 e = Some b -> deg b = k) by (intros e k H b Q; now rewrite Q in H).
  assert (plain : forall e, Rabs (exact X e) <= IZR two_products * scale m 2 ->
    (match bound hints_2 e with Some b => deg b = 2%nat | None => False end) ->
    forall b, bound hints_2 e = Some b -> Rabs (exact X e) <= IZR two_products * scale m (deg b)).
  { intros e H D b Q. now rewrite (degree e 2%nat D b Q). }
  unfold hints_hold, hints_2. each; cbn [fst snd]; (apply plain; [| vm_compute; reflexivity]); apply Rabs_le;
    cbn [exact E_D E_eg_x E_eg_y].
  - replace (X 0%nat * X 5%nat - X 1%nat * X 4%nat + (X 1%nat * X 2%nat - X 0%nat * X 3%nat))
      with (X 0%nat * X 7%nat - X 1%nat * X 6%nat) by (rewrite E6, E7; ring).
    generalize (P 0%nat 7%nat) (P 1%nat 6%nat). lra.
  - replace (X 6%nat * (X 4%nat + X 2%nat - X 0%nat))
      with (X 4%nat * X 4%nat - X 2%nat * X 2%nat - X 6%nat * X 0%nat) by (rewrite E6; ring).
    generalize (S 4%nat) (S 2%nat) (P 6%nat 0%nat). lra.
  - replace (X 7%nat * (X 5%nat + X 3%nat - X 1%nat))
      with (X 5%nat * X 5%nat - X 3%nat * X 3%nat - X 7%nat * X 1%nat) by (rewrite E7; ring).
    generalize (S 5%nat) (S 3%nat) (P 7%nat 1%nat). lra.
Qed.
End hints.

(* ---- The filter ---- *)

Section circle.
Variables ax ay bx by' px py qx qy : R.

(* As the code has it. *)
Definition circle_filter (certified : bool) : option (Z * R) :=
  let b_x := fsub bx ax in let b_y := fsub by' ay in
  let p_x := fsub px ax in let p_y := fsub py ay in
  let q_x := fsub qx ax in let q_y := fsub qy ay in
  let e_x := fsub qx px in let e_y := fsub qy py in
  let m := Rmax (Rmax (mag b_x b_y) (mag p_x p_y)) (Rmax (mag q_x q_y) (mag e_x e_y)) in
  if in_range_dec 120 m then
    let t := F_annulus b_x b_y p_x p_y q_x q_y e_x e_y in
    let m2 := fmul m m in
    decide (incircle t) (root_sum (inner t) (outer t)) (error_bound 177 (fmul m2 m2)) (error_bound 273 (fmul m2 m)) certified
  else None.

(* As it is meant. *)
Definition circle_truth : annulus R :=
  R_annulus (bx - ax) (by' - ay) (px - ax) (py - ay) (qx - ax) (qy - ay) (qx - px) (qy - py).
End circle.

(* The determinant vanishes with both norms: P = D |p|^2 - N.p = - (N + M).p / 2. *)
Lemma norms_positive bx by' px py qx qy :
  let t := R_annulus bx by' px py qx qy (qx - px) (qy - py) in
  0 < incircle t -> 0 < sqrt (inner t) + sqrt (outer t).
Proof.
  intros t P. generalize (sqrt_pos (inner t)) (sqrt_pos (outer t)). intros I O.
  destruct (Rle_lt_or_eq_dec _ _ (Rplus_le_le_0_compat _ _ I O)) as [L | Z]; [exact L | exfalso].
  assert (nonneg : forall x y, 0 <= x * x + y * y) by (intros; generalize (Rle_0_sqr x) (Rle_0_sqr y); unfold Rsqr; lra).
  assert (zero : forall x y, sqrt (x * x + y * y) = 0 -> x = 0 /\ y = 0).
  { intros x y H. apply sqrt_eq_0 in H; [| apply nonneg]. split; nra. }
  change (inner t) with (nx t * nx t + ny t * ny t) in *. change (outer t) with (mx t * mx t + my t * my t) in *.
  destruct (zero (nx t) (ny t)) as [N1 N2]; [lra |]. destruct (zero (mx t) (my t)) as [M1 M2]; [lra |].
  assert (E : 2 * incircle t = - ((nx t + mx t) * px + (ny t + my t) * py)).
  { unfold t, R_annulus, annulus_terms. cbn [incircle nx ny mx my]. ring. }
  rewrite N1, N2, M1, M2 in E. lra.
Qed.

(* ---- From coordinates ---- *)

Section coordinates.
Variables ax ay bx by' px py qx qy : R.
Hypotheses (Fax : F ax) (Fay : F ay) (Fbx : F bx) (Fby : F by') (Fpx : F px) (Fpy : F py) (Fqx : F qx) (Fqy : F qy).
Let b_x := fsub bx ax. Let b_y := fsub by' ay.
Let p_x := fsub px ax. Let p_y := fsub py ay.
Let q_x := fsub qx ax. Let q_y := fsub qy ay.
Let e_x := fsub qx px. Let e_y := fsub qy py.
Let m := Rmax (Rmax (mag b_x b_y) (mag p_x p_y)) (Rmax (mag q_x q_y) (mag e_x e_y)).
Hypothesis Range : in_range 120 m.
Let t := circle_truth ax ay bx by' px py qx qy.
Let c := F_annulus b_x b_y p_x p_y q_x q_y e_x e_y.
Let x := env [b_x; b_y; p_x; p_y; q_x; q_y; e_x; e_y].
Let X := env [bx - ax; by' - ay; px - ax; py - ay; qx - ax; qy - ay; qx - px; qy - py].

Lemma m_large : bpow radix2 (-120) <= m.
Proof. apply (in_range_lower 120); [lia | | exact Range]. apply F_max; apply F_max; apply F_mag; apply F_rnd. Qed.
Lemma m_pos : 0 < m.
Proof. exact (m_positive m m_large). Qed.

Lemma differences_small : Forall (fun a => Rabs a <= m) [b_x; b_y; p_x; p_y; q_x; q_y; e_x; e_y].
Proof.
  assert (mag b_x b_y <= m) by (apply Rle_trans with (2 := Rmax_l _ _); apply Rmax_l).
  assert (mag p_x p_y <= m) by (apply Rle_trans with (2 := Rmax_l _ _); apply Rmax_r).
  assert (mag q_x q_y <= m) by (apply Rle_trans with (2 := Rmax_r _ _); apply Rmax_l).
  assert (mag e_x e_y <= m) by (apply Rle_trans with (2 := Rmax_r _ _); apply Rmax_r).
  generalize (Rabs_le_mag b_x b_y) (Rabs_le_mag p_x p_y) (Rabs_le_mag q_x q_y) (Rabs_le_mag e_x e_y). intros [] [] [] []. each; lra.
Qed.

Lemma differences_near : Forall2 (fun a b => Rabs (a - b) <= u * Rabs a) [b_x; b_y; p_x; p_y; q_x; q_y; e_x; e_y]
  [bx - ax; by' - ay; px - ax; py - ay; qx - ax; qy - ay; qx - px; qy - py].
Proof. each; now apply rnd_sub_result. Qed.

Lemma inputs : (forall n, F (x n)) /\ (forall n, Rabs (x n) <= m) /\ (forall n, Rabs (x n - X n) <= u * m).
Proof.
  generalize m_pos u_bounds. intros M0 U.
  assert (xm : forall n, Rabs (x n) <= m) by (apply (env_all (fun a => Rabs a <= m)); [rewrite Rabs_R0; lra | exact differences_small]).
  split; [| split; [exact xm |]].
  - apply (env_all F); [exact F_0 |]. each; apply F_rnd.
  - intro n. apply Rle_trans with (u * Rabs (x n)); [| apply Rmult_le_compat_l; [lra | apply xm]].
    revert n. apply (env_all_2 (fun a b => Rabs (a - b) <= u * Rabs a)); [rewrite Rminus_0_r, Rabs_R0; lra | exact differences_near].
Qed.

Lemma terms_near e k C E : within e k C E = true ->
  Rabs (rounded x e) <= IZR C * m ^ k /\ Rabs (rounded x e - exact X e) <= IZR E / 2 * u * m ^ k.
Proof.
  intro W. destruct inputs as (xF & xm & xX). generalize m_large m_pos u_bounds. intros M M0 U.
  assert (HH : hints_hold m X hints_2).
  { apply hints_2_hold; [exact M | |].
    - intro n. unfold exact_one. rewrite plus_IZR, Rmult_plus_distr_r, scale_one, scale_u.
      generalize (Rabs_triang (x n) (- (x n - X n))) (xm n) (xX n). rewrite Rabs_Ropp.
      replace (x n + - (x n - X n)) with (X n) by ring. lra.
    - unfold X, env. cbn [nth]. split; ring. }
  generalize (error_below_sound m M X x xF xm xX hints_2 e k _ _ _ HH W).
  rewrite units, half_units. tauto.
Qed.

(* ---- The errors ---- *)

Let um := u * m ^ 3.
Let e := error_bound 177 (power_4 m).
Let n := error_bound 273 (power_3 m).

Lemma m3_large : bpow radix2 (-360) <= m ^ 3.
Proof. exact (pow_large m m_large 3). Qed.
Lemma m3_pos : 0 < m ^ 3.
Proof. generalize m3_large (bpow_gt_0 radix2 (-360)). lra. Qed.
Lemma um_pos : 0 <= um.
Proof. generalize m3_pos u_bounds. intros. apply Rmult_le_pos; lra. Qed.

Lemma tiny_small : tiny <= / 10 * um.
Proof.
  generalize m3_large u_bounds um_pos (bpow_gt_0 radix2 (-360)). intros P U W B. apply Rle_trans with (bpow radix2 (-4) * (u * bpow radix2 (-360))).
  - change u with (bpow radix2 (-53)). rewrite <- !bpow_plus. apply bpow_le. lia.
  - apply mul_below; [apply bpow_ge_0 | apply Rmult_le_pos; lra | change (bpow radix2 (-4)) with (/ 16); lra |].
    apply Rmult_le_compat_l; lra.
Qed.

Lemma n_range : 2725 / 10 * um <= n <= 1 * m ^ 3.
Proof.
  generalize m_large m3_pos u_bounds. intros M M3 U.
  destruct (error_bound_range m M 273 (power_3 m) 3 ltac:(lia) ltac:(lia) (widen m M _ _ 4 4 ltac:(lra) ltac:(lra) (power_3_range m M))) as [NL NH].
  split.
  - unfold um. rewrite <- Rmult_assoc. apply Rle_trans with (2 := NL). apply Rmult_le_compat_r; [lra |]. unfold u. lra.
  - apply Rle_trans with (1 := NH). apply Rmult_le_compat_r; [lra |]. unfold u. lra.
Qed.

Lemma error_covers : u * m ^ 4 <= e /\ Rabs (incircle c - incircle t) <= e.
Proof.
  generalize m_large m_pos u_bounds. intros M M0 U. destruct constants_2 as (K & _). destruct (terms_near _ _ _ _ K) as [_ De].
  assert (P4 : bpow radix2 (-480) <= m ^ 4) by exact (pow_large m M 4). generalize (bpow_gt_0 radix2 (-480)). intro B.
  destruct (error_bound_range m M 177 (power_4 m) 4 ltac:(lia) ltac:(lia) (widen m M _ _ 4 4 ltac:(lra) ltac:(lra) (power_4_range m M))) as [EL _].
  fold e in EL. split; [| apply Rle_trans with (1 := De)]; apply Rle_trans with (2 := EL); (apply Rmult_le_compat_r; [lra |]); unfold u; lra.
Qed.

(* ---- The norms ---- *)

Let r := root_sum (inner c) (outer c).

Lemma r_high : 0 <= r <= 512 * m ^ 3.
Proof.
  destruct constants_2 as (_ & K2 & K3 & K4 & K5). generalize m3_large m3_pos u_bounds (bpow_gt_0 radix2 (-360)). intros P M3 U B.
  destruct (terms_near _ _ _ _ K2) as [Nx _]. destruct (terms_near _ _ _ _ K3) as [Ny _].
  destruct (terms_near _ _ _ _ K4) as [Mx _]. destruct (terms_near _ _ _ _ K5) as [My _].
  assert (big : bpow radix2 (-500) <= 16 * m ^ 3) by (apply Rle_trans with (bpow radix2 (-360)); [apply bpow_le; lia | lra]).
  assert (HI := norm_2_upper (nx c) (ny c) (16 * m ^ 3) ltac:(change (nx c) with (rounded x (nx E_annulus)); lra) ltac:(change (ny c) with (rounded x (ny E_annulus)); lra) big).
  assert (HO := norm_2_upper (mx c) (my c) (16 * m ^ 3) ltac:(change (mx c) with (rounded x (mx E_annulus)); lra) ltac:(change (my c) with (rounded x (my E_annulus)); lra) big).
  generalize (root_sum_range (inner c) (outer c) (F_rnd _) (F_rnd _)). fold r. intros [RL RH].
  generalize (sqrt_pos (inner c)) (sqrt_pos (outer c)). intros.
  change (fadd (fmul (nx c) (nx c)) (fmul (ny c) (ny c))) with (inner c) in HI.
  change (fadd (fmul (mx c) (mx c)) (fmul (my c) (my c))) with (outer c) in HO.
  split; [apply Rle_trans with (2 := RL); apply Rmult_le_pos |]; lra.
Qed.

(* |N| + |M| less errors <= computed norms; then three factors 1 - u. *)
Lemma r_low : (1 - 10 * u) * (sqrt (inner t) + sqrt (outer t)) <= r + n.
Proof.
  destruct constants_2 as (_ & K2 & K3 & K4 & K5). generalize m3_pos um_pos u_bounds tiny_small tiny_pos (proj1 n_range). intros M3 W U T T0 N0.
  destruct (terms_near _ _ _ _ K2) as [_ Nx]. destruct (terms_near _ _ _ _ K3) as [_ Ny].
  destruct (terms_near _ _ _ _ K4) as [_ Mx]. destruct (terms_near _ _ _ _ K5) as [_ My].
  generalize (norm_2_lower (nx c) (ny c)) (norm_2_lower (mx c) (my c)) (norm_2_close _ _ _ _ _ Nx Ny) (norm_2_close _ _ _ _ _ Mx My).
  change (fadd (fmul (nx c) (nx c)) (fmul (ny c) (ny c))) with (inner c). change (fadd (fmul (mx c) (mx c)) (fmul (my c) (my c))) with (outer c).
  change (rounded x (nx E_annulus)) with (nx c). change (rounded x (ny E_annulus)) with (ny c).
  change (rounded x (mx E_annulus)) with (mx c). change (rounded x (my E_annulus)) with (my c).
  change (sqrt (exact X (nx E_annulus) * exact X (nx E_annulus) + exact X (ny E_annulus) * exact X (ny E_annulus))) with (sqrt (inner t)).
  change (sqrt (exact X (mx E_annulus) * exact X (mx E_annulus) + exact X (my E_annulus) * exact X (my E_annulus))) with (sqrt (outer t)).
  intros LI LO CI CO.
  generalize (root_sum_range (inner c) (outer c) (F_rnd _) (F_rnd _)). fold r. intros [RL RH].
  generalize (sqrt_pos (inner c)) (sqrt_pos (outer c)) (sqrt_pos (inner t)) (sqrt_pos (outer t)). intros ci co ti to.
  set (L := sqrt (inner t) + sqrt (outer t)).
  assert (C : L - 27157 / 100 * um <= sqrt (nx c * nx c + ny c * ny c) + sqrt (mx c * mx c + my c * my c))
    by (unfold L; unfold um in *; lra).
  assert (D : (1 - u) * (L - 27157 / 100 * um) - 2 * tiny <= sqrt (inner c) + sqrt (outer c)).
  { apply Rle_trans with ((1 - u) * (sqrt (nx c * nx c + ny c * ny c) + sqrt (mx c * mx c + my c * my c)) - 2 * tiny); [| lra].
    apply Rplus_le_compat_r. apply Rmult_le_compat_l; lra. }
  apply (Rmult_le_compat_l (1 - 2 * u)) in D; [| lra].
  assert (0 <= u * um) by (apply Rmult_le_pos; lra). assert (0 <= u * (u * um)) by (apply Rmult_le_pos; lra).
  assert (0 <= L) by (unfold L; lra).
  assert (0 <= u * L) by (apply Rmult_le_pos; lra). assert (0 <= u * (u * L)) by (apply Rmult_le_pos; lra).
  assert (0 <= u * tiny) by (apply Rmult_le_pos; lra).
  assert (u * um <= / 1000 * um) by (apply Rmult_le_compat_r; lra).
  assert (u * (u * um) <= 1 * (u * um)) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(* ---- The answer ---- *)

Lemma decided certified : sound (decide (incircle c) r e n certified) certified (incircle t) (sqrt (inner t) + sqrt (outer t)).
Proof.
  generalize m_large m_pos m3_pos um_pos u_bounds n_range r_high. intros M M0 M3 W U [NL NH] [R0 RH]. destruct error_covers as [E0 De].
  assert (0 < m ^ 4) by (apply pow_lt; lra).
  apply decide_sound; try (apply F_rnd || apply F_error_bound || assumption || exact r_low).
  - apply Rlt_le_trans with (2 := E0). apply Rmult_lt_0_compat; lra.
  - lra.
  - replace t with (R_annulus (bx - ax) (by' - ay) (px - ax) (py - ay) (qx - ax) (qy - ay)
      ((qx - ax) - (px - ax)) ((qy - ay) - (py - ay))).
    + apply norms_positive.
    + unfold t, circle_truth. f_equal; ring.
  - apply Rle_trans with (2 := E0). apply Rle_trans with (bpow radix2 (-900) * (1024 * m ^ 3)).
    + apply Rmult_le_compat_l; [apply bpow_ge_0 | lra].
    + replace (u * m ^ 4) with (u * m * m ^ 3) by ring. rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [lra |].
      apply Rle_trans with (u * bpow radix2 (-120)).
      * change u with (bpow radix2 (-53)). change 1024 with (bpow radix2 10). rewrite <- !bpow_plus. apply bpow_le. lia.
      * apply Rmult_le_compat_l; lra.
Qed.
End coordinates.

Theorem circle_filter_sound ax ay bx by' px py qx qy certified :
  F ax -> F ay -> F bx -> F by' -> F px -> F py -> F qx -> F qy ->
  let t := circle_truth ax ay bx by' px py qx qy in
  sound (circle_filter ax ay bx by' px py qx qy certified) certified (incircle t) (sqrt (inner t) + sqrt (outer t)).
Proof.
  intros Fax Fay Fbx Fby Fpx Fpy Fqx Fqy t. unfold circle_filter. cbv zeta.
  destruct in_range_dec as [Range |]; [| discriminate]. now apply decided.
Qed.
