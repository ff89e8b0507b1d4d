(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* src/annulus/engine/displacement.h and the test that uses it: upper bounds of distances, and the comparison of a squared
   distance with a threshold that stands for a tolerance (docs/theory.md 4.1, 5.2).

   - distance_upper_2_sound, _3_sound      at least the distance, also where squares underflow
   - threshold_2_sound, threshold_3_sound  squared_distance < squared_threshold_lower(r) implies distance < r
   - passes_2_sound, passes_3_sound        what Displacement_budget::passes and set_threshold conclude from it *)
Require Import Reals Lra Psatz ZArith.
From Flocq Require Import Core.
From Annulus Require Import float_model float_error float_tail float_sums.
Open Scope R_scope.

(* ---- Distances ---- *)

Definition squared_distance_2 ax ay bx by' : R :=
  let c := fsub ax bx in let d := fsub ay by' in fadd (fadd 0 (fmul c c)) (fmul d d).
Definition squared_distance_3 ax ay az bx by' bz : R :=
  let c := fsub ax bx in let d := fsub ay by' in let e := fsub az bz in
  fadd (fadd (fadd 0 (fmul c c)) (fmul d d)) (fmul e e).
Definition distance_upper (squares sum : R) : R :=
  if Rlt_dec (bpow radix2 (-900)) squares then fmul (rnd (sqrt squares)) grow else fmul sum grow.
Definition distance_upper_2 ax ay bx by' : R :=
  distance_upper (squared_distance_2 ax ay bx by') (fadd (fadd 0 (Rabs (fsub ax bx))) (Rabs (fsub ay by'))).
Definition distance_upper_3 ax ay az bx by' bz : R :=
  distance_upper (squared_distance_3 ax ay az bx by' bz)
    (fadd (fadd (fadd 0 (Rabs (fsub ax bx))) (Rabs (fsub ay by'))) (Rabs (fsub az bz))).
Definition distance_2 ax ay bx by' : R := sqrt ((ax - bx) * (ax - bx) + (ay - by') * (ay - by')).
Definition distance_3 ax ay az bx by' bz : R :=
  sqrt ((ax - bx) * (ax - bx) + (ay - by') * (ay - by') + (az - bz) * (az - bz)).

Lemma fadd_0 x : F x -> fadd 0 x = x.
Proof. intro Fx. unfold fadd. rewrite Rplus_0_l. now apply rnd_F. Qed.

(* A computed difference against the exact one. *)
Lemma difference_square x y : F x -> F y ->
  (x - y) * (x - y) <= (1 + u) * (1 + u) * (fsub x y * fsub x y).
Proof.
  intros Fx Fy. generalize (rnd_sub_result x y Fx Fy) u_bounds. fold (fsub x y). set (c := fsub x y). intros H U.
  assert (A : Rabs (x - y) <= (1 + u) * Rabs c).
  { generalize (Rabs_triang c (- (c - (x - y)))). rewrite Rabs_Ropp. replace (c + - (c - (x - y))) with (x - y) by ring. lra. }
  rewrite <- (Rabs_pos_eq ((x - y) * (x - y))), <- (Rabs_pos_eq (c * c)) by apply Rle_0_sqr. rewrite !Rabs_mult.
  replace ((1 + u) * (1 + u) * (Rabs c * Rabs c)) with (((1 + u) * Rabs c) * ((1 + u) * Rabs c)) by ring.
  apply mul_below; try apply Rabs_pos; exact A.
Qed.

(* What both dimensions need of squared_distance: A the exact square, C that of the computed differences. *)
Definition squares_close (A sq : R) : Prop :=
  F sq /\ 0 <= sq /\ 0 <= A /\ A * ((1 - u) * (1 - u) * (1 - u)) <= (1 + u) * (1 + u) * (sq + 3 * eta).

Lemma squares_2 ax ay bx by' : F ax -> F ay -> F bx -> F by' ->
  squares_close ((ax - bx) * (ax - bx) + (ay - by') * (ay - by')) (squared_distance_2 ax ay bx by').
Proof.
  intros Fax Fay Fbx Fby. unfold squared_distance_2. cbv zeta. rewrite fadd_0 by apply F_rnd.
  generalize (difference_square ax bx Fax Fbx) (difference_square ay by' Fay Fby).
  set (c := fsub ax bx). set (d := fsub ay by'). intros Hc Hd.
  generalize (square_lower c) (square_lower d) (fmul_square_pos c) (fmul_square_pos d) u_bounds eta_pos.
  intros [C _] [D _] C0 D0 U E.
  assert (S : (fmul c c + fmul d d) * (1 - u) <= fadd (fmul c c) (fmul d d))
    by (apply rnd_add_le; [apply F_rnd | apply F_rnd | lra]).
  generalize (Rle_0_sqr (ax - bx)) (Rle_0_sqr (ay - by')) (Rle_0_sqr c) (Rle_0_sqr d). unfold Rsqr. intros.
  split; [apply F_rnd |]. split; [apply rnd_pos; lra |]. split; [lra |].
  set (A := (ax - bx) * (ax - bx) + (ay - by') * (ay - by')) in *. set (Q := c * c + d * d).
  assert (AQ : A <= (1 + u) * (1 + u) * Q) by (unfold A, Q; lra).
  apply Rle_trans with ((1 + u) * (1 + u) * Q * ((1 - u) * (1 - u) * (1 - u))).
  { apply Rmult_le_compat_r; [unfold u; lra | exact AQ]. }
  rewrite Rmult_assoc. apply Rmult_le_compat_l; [unfold u; lra |].
  assert (W : (1 - u) * (Q * (1 - u) - 2 * eta) <= fadd (fmul c c) (fmul d d)).
  { apply Rle_trans with ((1 - u) * (fmul c c + fmul d d)); [apply Rmult_le_compat_l; [lra | unfold Q; lra] | lra]. }
  assert (Q * ((1 - u) * (1 - u)) * (1 - u) <= Q * ((1 - u) * (1 - u)) * 1).
  { apply Rmult_le_compat_l; [apply Rmult_le_pos; [unfold Q; lra | unfold u; lra] | lra]. }
  assert (0 <= u * eta) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma squares_3 ax ay az bx by' bz : F ax -> F ay -> F az -> F bx -> F by' -> F bz ->
  squares_close ((ax - bx) * (ax - bx) + (ay - by') * (ay - by') + (az - bz) * (az - bz))
    (squared_distance_3 ax ay az bx by' bz).
Proof.
  intros Fax Fay Faz Fbx Fby Fbz. unfold squared_distance_3. cbv zeta. rewrite fadd_0 by apply F_rnd.
  generalize (difference_square ax bx Fax Fbx) (difference_square ay by' Fay Fby) (difference_square az bz Faz Fbz).
  set (c := fsub ax bx). set (d := fsub ay by'). set (e := fsub az bz). intros Hc Hd He.
  generalize (square_lower c) (square_lower d) (square_lower e) (fmul_square_pos c) (fmul_square_pos d) (fmul_square_pos e)
    u_bounds eta_pos.
  intros [C _] [D _] [E _] C0 D0 E0 U H.
  assert (S : (fmul c c + fmul d d) * (1 - u) <= fadd (fmul c c) (fmul d d))
    by (apply rnd_add_le; [apply F_rnd | apply F_rnd | lra]).
  assert (S0 : 0 <= fadd (fmul c c) (fmul d d)) by (apply rnd_pos; lra).
  assert (T : (fadd (fmul c c) (fmul d d) + fmul e e) * (1 - u) <= fadd (fadd (fmul c c) (fmul d d)) (fmul e e))
    by (apply rnd_add_le; [apply F_rnd | apply F_rnd | lra]).
  generalize (Rle_0_sqr (ax - bx)) (Rle_0_sqr (ay - by')) (Rle_0_sqr (az - bz)) (Rle_0_sqr c) (Rle_0_sqr d) (Rle_0_sqr e).
  unfold Rsqr. intros.
  split; [apply F_rnd |]. split; [apply rnd_pos; lra |]. split; [lra |].
  set (A := (ax - bx) * (ax - bx) + (ay - by') * (ay - by') + (az - bz) * (az - bz)) in *.
  set (Q := c * c + d * d + e * e).
  assert (AQ : A <= (1 + u) * (1 + u) * Q) by (unfold A, Q; lra).
  apply Rle_trans with ((1 + u) * (1 + u) * Q * ((1 - u) * (1 - u) * (1 - u))).
  { apply Rmult_le_compat_r; [unfold u; lra | exact AQ]. }
  rewrite Rmult_assoc. apply Rmult_le_compat_l; [unfold u; lra |].
  assert (W1 : (fmul c c + fmul d d + fmul e e) * (1 - u) <= fadd (fmul c c) (fmul d d) + fmul e e).
  { assert (0 <= u * fmul e e) by (apply Rmult_le_pos; lra). lra. }
  assert (W : (1 - u) * ((1 - u) * (Q * (1 - u) - 3 * eta)) <= fadd (fadd (fmul c c) (fmul d d)) (fmul e e)).
  { apply Rle_trans with ((1 - u) * (fadd (fmul c c) (fmul d d) + fmul e e)); [| lra].
    apply Rmult_le_compat_l; [lra |]. apply Rle_trans with ((1 - u) * (fmul c c + fmul d d + fmul e e)); [| lra].
    apply Rmult_le_compat_l; [lra | unfold Q; lra]. }
  assert (0 <= u * eta) by (apply Rmult_le_pos; lra).
  assert ((1 - u) * ((1 - u) * (3 * eta)) <= 3 * eta).
  { replace ((1 - u) * ((1 - u) * (3 * eta))) with ((1 - u) * (1 - u) * (3 * eta)) by ring.
    rewrite <- (Rmult_1_l (3 * eta)) at 2. apply Rmult_le_compat_r; [lra | unfold u; lra]. }
  lra.
Qed.

Lemma eta_small r : bpow radix2 (-950) <= r -> 3 * eta <= u * r.
Proof.
  intro H. apply Rle_trans with (u * bpow radix2 (-950)).
  - apply Rle_trans with (bpow radix2 2 * eta).
    + apply Rmult_le_compat_r; [left; apply eta_pos | change (bpow radix2 2) with 4; lra].
    + unfold eta. change u with (bpow radix2 (-53)). rewrite <- !bpow_plus. apply bpow_le. lia.
  - apply Rmult_le_compat_l; [generalize u_bounds; lra | exact H].
Qed.

(* The root of the squares, where they do not underflow. *)
Lemma root_upper A sq : squares_close A sq -> bpow radix2 (-900) < sq -> sqrt A <= fmul (rnd (sqrt sq)) grow.
Proof.
  intros (Fs & S0 & A0 & C) N. generalize u_bounds. intro U.
  assert (L : 3 * eta <= u * sq) by (apply eta_small; apply Rle_trans with (bpow radix2 (-900)); [apply bpow_le; lia | lra]).
  assert (B : A <= ((1 + 5 * u) * sqrt sq) * ((1 + 5 * u) * sqrt sq)).
  { replace ((1 + 5 * u) * sqrt sq * ((1 + 5 * u) * sqrt sq)) with ((1 + 5 * u) * (1 + 5 * u) * (sqrt sq * sqrt sq)) by ring.
    rewrite sqrt_sqrt by exact S0.
    apply Rmult_le_reg_r with ((1 - u) * (1 - u) * (1 - u)); [unfold u; lra |].
    apply Rle_trans with (1 := C). apply Rle_trans with ((1 + u) * (1 + u) * (sq * (1 + u))).
    - apply Rmult_le_compat_l; [unfold u; lra | lra].
    - replace ((1 + u) * (1 + u) * (sq * (1 + u))) with ((1 + u) * (1 + u) * (1 + u) * sq) by ring.
      replace ((1 + 5 * u) * (1 + 5 * u) * sq * ((1 - u) * (1 - u) * (1 - u)))
        with ((1 + 5 * u) * (1 + 5 * u) * ((1 - u) * (1 - u) * (1 - u)) * sq) by ring.
      apply Rmult_le_compat_r; [exact S0 | unfold u; lra]. }
  assert (P : bpow radix2 (-450) <= sqrt sq).
  { rewrite <- (sqrt_square (bpow radix2 (-450))) by apply bpow_ge_0. apply sqrt_le_1_alt. rewrite <- bpow_plus.
    change (-450 + -450)%Z with (-900)%Z. lra. }
  generalize (bpow_gt_0 radix2 (-450)). intro B0.
  assert (R : sqrt A <= (1 + 5 * u) * sqrt sq).
  { rewrite <- (sqrt_square ((1 + 5 * u) * sqrt sq)) by (apply Rmult_le_pos; lra). now apply sqrt_le_1_alt. }
  apply Rle_trans with (1 := R). destruct (rnd_sqrt_le _ Fs) as [RL _].
  assert (big : bpow radix2 (-1022) <= bpow radix2 (-450) / 2).
  { unfold Rdiv. change (/ 2) with (bpow radix2 (-1)). rewrite <- bpow_plus. apply bpow_le. lia. }
  assert (RL' : sqrt sq * / 2 <= rnd (sqrt sq)) by (apply Rle_trans with (2 := RL); apply Rmult_le_compat_l; lra).
  assert (G : 1 <= grow) by (unfold grow; lra).
  assert (RG : rnd (sqrt sq) * 1 <= rnd (sqrt sq) * grow) by (apply Rmult_le_compat_l; lra).
  apply Rle_trans with (rnd (sqrt sq) * grow * (1 - u)).
  - apply Rle_trans with (sqrt sq * (1 - u) * grow * (1 - u)).
    + rewrite (Rmult_comm (1 + 5 * u)). rewrite !Rmult_assoc. apply Rmult_le_compat_l; [lra | unfold grow, u; lra].
    + apply Rmult_le_compat_r; [lra |]. apply Rmult_le_compat_r; [lra | exact RL].
  - apply rnd_normal_le. lra.
Qed.

Theorem distance_upper_2_sound ax ay bx by' : F ax -> F ay -> F bx -> F by' ->
  distance_2 ax ay bx by' <= distance_upper_2 ax ay bx by'.
Proof.
  intros Fax Fay Fbx Fby. unfold distance_upper_2, distance_upper. destruct Rlt_dec as [L |].
  - apply root_upper; [now apply squares_2 | exact L].
  - apply Rle_trans with (1 := norm_sum_2 _ _). apply grow_sum with 3; [lra |].
    rewrite fadd_0 by apply F_abs, F_rnd. replace 3 with (1 + 2) by ring.
    apply (near_add 1); try lra; now apply near_difference.
Qed.

Theorem distance_upper_3_sound ax ay az bx by' bz : F ax -> F ay -> F az -> F bx -> F by' -> F bz ->
  distance_3 ax ay az bx by' bz <= distance_upper_3 ax ay az bx by' bz.
Proof.
  intros Fax Fay Faz Fbx Fby Fbz. unfold distance_upper_3, distance_upper. destruct Rlt_dec as [L |].
  - apply root_upper; [now apply squares_3 | exact L].
  - apply Rle_trans with (1 := norm_sum_3 _ _ _). apply grow_sum with 5; [lra |].
    rewrite fadd_0 by apply F_abs, F_rnd.
    assert (near_sum 3 (fadd (Rabs (fsub ax bx)) (Rabs (fsub ay by'))) (Rabs (ax - bx) + Rabs (ay - by'))).
    { replace 3 with (1 + 2) by ring. apply (near_add 1); try lra; now apply near_difference. }
    generalize (near_difference az bz Faz Fbz). intros (Fz & z0 & Z0 & Hz & Ez).
    replace 5 with (3 + 2) by ring. apply (near_add 3); try lra; [assumption |].
    split; [exact Fz |]. split; [exact z0 |]. split; [exact Z0 |]. split; [| exact Ez].
    apply Rle_trans with (1 := Hz). apply Rmult_le_compat_r; [exact z0 | generalize u_bounds; lra].
Qed.

(* ---- Comparison of squares ---- *)

Definition shrink_squares : R := 1 - 16 * u.   (* 1 - 2^-49 *)
Definition squared_threshold_lower (r : R) : R :=
  if Rlt_dec (bpow radix2 (-450)) r then
    if Rlt_dec (bpow radix2 510) r then bpow radix2 1020 else fmul (fmul r r) shrink_squares
  else 0.

Lemma threshold_sound A sq r : squares_close A sq -> sqrt A <= bpow radix2 510 ->
  sq < squared_threshold_lower r -> sqrt A < r.
Proof.
  intros (Fs & S0 & A0 & C) D L. unfold squared_threshold_lower in L. generalize u_bounds. intro U.
  destruct (Rlt_dec (bpow radix2 (-450)) r) as [N |]; [| lra].
  destruct (Rlt_dec (bpow radix2 510) r) as [G |]; [lra |].
  generalize (bpow_gt_0 radix2 (-450)). intro B.
  assert (R2 : bpow radix2 (-900) <= r * r).
  { change (-900)%Z with (-450 + -450)%Z. rewrite bpow_plus. apply mul_below; lra. }
  assert (big : bpow radix2 (-1022) <= bpow radix2 (-900) / 4).
  { unfold Rdiv. change 4 with (bpow radix2 2). rewrite <- bpow_opp, <- bpow_plus. apply bpow_le. lia. }
  generalize (bpow_gt_0 radix2 (-900)). intro B9.
  generalize (rnd_normal_le (r * r) ltac:(lra)). fold (fmul r r). intros [HL HH].
  assert (lo : r * r * / 2 <= fmul r r) by (apply Rle_trans with (2 := HL); apply Rmult_le_compat_l; lra).
  assert (lo' : fmul r r * / 2 <= fmul r r * shrink_squares) by (apply Rmult_le_compat_l; [lra | unfold shrink_squares; lra]).
  generalize (rnd_normal_le (fmul r r * shrink_squares) ltac:(lra)). fold (fmul (fmul r r) shrink_squares). intros [_ TH].
  assert (S : sq < r * r * ((1 + u) * shrink_squares * (1 + u))).
  { apply Rlt_le_trans with (1 := L). apply Rle_trans with (1 := TH). rewrite <- !Rmult_assoc.
    do 2 (apply Rmult_le_compat_r; [unfold shrink_squares, u; lra |]). exact HH. }
  assert (E : 3 * eta <= u * (r * r)).
  { apply eta_small. apply Rle_trans with (bpow radix2 (-900)); [apply bpow_le; lia | lra]. }
  assert (Q : A < r * r).
  { apply Rmult_lt_reg_r with ((1 - u) * (1 - u) * (1 - u)); [unfold u; lra |].
    apply Rle_lt_trans with (1 := C).
    apply Rlt_le_trans with ((1 + u) * (1 + u) * (r * r * ((1 + u) * shrink_squares * (1 + u) + u))).
    - apply Rmult_lt_compat_l; [unfold u; lra | lra].
    - replace ((1 + u) * (1 + u) * (r * r * ((1 + u) * shrink_squares * (1 + u) + u)))
        with (r * r * ((1 + u) * (1 + u) * ((1 + u) * shrink_squares * (1 + u) + u))) by ring.
      apply Rmult_le_compat_l; [lra | unfold shrink_squares, u; lra]. }
  rewrite <- (sqrt_square r) by lra. apply sqrt_lt_1_alt. lra.
Qed.

(* Displacement_budget::set_threshold and passes: earliest - base, less a margin, as the radius. *)
Definition threshold (earliest base : R) : R := squared_threshold_lower (fmul (fsub earliest base) (1 - 8 * u)).

Lemma threshold_passes A sq earliest base : squares_close A sq -> sqrt A <= bpow radix2 510 -> F earliest -> F base ->
  sq < threshold earliest base -> base + sqrt A < earliest.
Proof.
  intros C D Fe Fb L. generalize (threshold_sound _ _ _ C D L). intro R. generalize u_bounds. intro U.
  assert (P : 0 < fmul (fsub earliest base) (1 - 8 * u)) by (generalize (sqrt_pos A); lra).
  destruct (Rlt_le_dec (bpow radix2 (-450)) (fmul (fsub earliest base) (1 - 8 * u))) as [N | N].
  - assert (x0 : 0 < fsub earliest base).
    { destruct (Rlt_le_dec 0 (fsub earliest base)) as [? | X]; [assumption | exfalso].
      assert (fmul (fsub earliest base) (1 - 8 * u) <= 0); [| lra]. rewrite <- rnd_0. apply rnd_le.
      assert (0 <= - fsub earliest base * (1 - 8 * u)) by (apply Rmult_le_pos; lra). lra. }
    assert (y0 : 0 < earliest - base).
    { apply rnd_gt; [exact F_0 | exact x0]. }
    assert (X : fsub earliest base <= (earliest - base) * (1 + u)).
    { unfold fsub, Rminus. apply rnd_add_le; [exact Fe | now apply F_opp |]. fold (earliest - base). lra. }
    assert (N' : bpow radix2 (-450) <= fsub earliest base * (1 - 8 * u)).
    { left. apply rnd_gt; [apply F_bpow; lia | exact N]. }
    assert (Y : fmul (fsub earliest base) (1 - 8 * u) <= fsub earliest base * (1 - 8 * u) * (1 + u)).
    { apply rnd_normal_le. apply Rle_trans with (2 := N'). apply bpow_le. lia. }
    assert (Z : fsub earliest base * (1 - 8 * u) * (1 + u) <= (earliest - base) * (1 + u) * (1 - 8 * u) * (1 + u)).
    { apply Rmult_le_compat_r; [lra |]. apply Rmult_le_compat_r; lra. }
    assert (W : (earliest - base) * ((1 + u) * (1 - 8 * u) * (1 + u)) <= (earliest - base) * 1).
    { apply Rmult_le_compat_l; [lra | unfold u; lra]. }
    lra.
  - exfalso. unfold threshold, squared_threshold_lower in L.
    destruct Rlt_dec; [lra |]. destruct C as (_ & ? & _). lra.
Qed.

(* Inside the coordinate domain no distance reaches 2^510. *)
Lemma domain_3 a b c : Rabs a <= bpow radix2 501 -> Rabs b <= bpow radix2 501 -> Rabs c <= bpow radix2 501 ->
  sqrt (a * a + b * b + c * c) <= bpow radix2 510.
Proof.
  intros A B C. apply Rle_trans with (1 := norm_sum_3 a b c). apply Rle_trans with (bpow radix2 2 * bpow radix2 501).
  - change (bpow radix2 2) with 4. generalize (bpow_gt_0 radix2 501). lra.
  - rewrite <- bpow_plus. apply bpow_le. lia.
Qed.

Definition in_domain (x : R) : Prop := F x /\ Rabs x <= bpow radix2 500.

Lemma domain_difference x y : in_domain x -> in_domain y -> Rabs (x - y) <= bpow radix2 501.
Proof.
  intros [_ X] [_ Y]. generalize (Rabs_triang x (- y)). rewrite Rabs_Ropp.
  replace (bpow radix2 501) with (2 * bpow radix2 500); [unfold Rminus; lra |].
  change 2 with (bpow radix2 1). rewrite <- bpow_plus. reflexivity.
Qed.

Theorem threshold_2_sound ax ay bx by' r : in_domain ax -> in_domain ay -> in_domain bx -> in_domain by' ->
  squared_distance_2 ax ay bx by' < squared_threshold_lower r -> distance_2 ax ay bx by' < r.
Proof.
  intros A B C D. apply threshold_sound; [apply squares_2; unfold in_domain in *; tauto |].
  generalize (domain_3 (ax - bx) (ay - by') 0). rewrite Rmult_0_l, Rplus_0_r, Rabs_R0. intro H.
  apply H; try (now apply domain_difference). apply bpow_ge_0.
Qed.

Theorem threshold_3_sound ax ay az bx by' bz r :
  in_domain ax -> in_domain ay -> in_domain az -> in_domain bx -> in_domain by' -> in_domain bz ->
  squared_distance_3 ax ay az bx by' bz < squared_threshold_lower r -> distance_3 ax ay az bx by' bz < r.
Proof.
  intros A B C D E G. apply threshold_sound; [apply squares_3; unfold in_domain in *; tauto |].
  apply domain_3; now apply domain_difference.
Qed.

Theorem passes_2_sound ax ay bx by' earliest base : in_domain ax -> in_domain ay -> in_domain bx -> in_domain by' ->
  F earliest -> F base -> squared_distance_2 ax ay bx by' < threshold earliest base -> base + distance_2 ax ay bx by' < earliest.
Proof.
  intros A B C D Fe Fb. apply threshold_passes; try assumption; [apply squares_2; unfold in_domain in *; tauto |].
  generalize (domain_3 (ax - bx) (ay - by') 0). rewrite Rmult_0_l, Rplus_0_r, Rabs_R0. intro H.
  apply H; try (now apply domain_difference). apply bpow_ge_0.
Qed.

Theorem passes_3_sound ax ay az bx by' bz earliest base :
  in_domain ax -> in_domain ay -> in_domain az -> in_domain bx -> in_domain by' -> in_domain bz ->
  F earliest -> F base -> squared_distance_3 ax ay az bx by' bz < threshold earliest base ->
  base + distance_3 ax ay az bx by' bz < earliest.
Proof.
  intros A B C D E G Fe Fb. apply threshold_passes; try assumption; [apply squares_3; unfold in_domain in *; tauto |].
  apply domain_3; now apply domain_difference.
Qed.
