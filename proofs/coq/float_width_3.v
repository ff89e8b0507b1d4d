(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* decide_width of src/annulus/predicate/filtered_3.h: the half width of a tetrahedron from its computed terms. *)
Require Import Reals Lra Psatz ZArith List.
From Flocq Require Import Core.
From Annulus Require Import float_model float_error float_tail float_filter float_terms_3.
Import ListNotations.
Open Scope R_scope.

(* Norms of vectors, exact and computed. *)
Definition R_norm (v : vector R) : R := sqrt (R_square v).
Definition F_norm (v : vector R) : R := sqrt (F_square v).

Definition near_vector (K E : R) (v V : vector R) : Prop :=
  (Rabs (x v) <= K /\ Rabs (x v - x V) <= E) /\ (Rabs (y v) <= K /\ Rabs (y v - y V) <= E) /\
  (Rabs (z v) <= K /\ Rabs (z v - z V) <= E).

Lemma F_norm_lower K E v V : 0 <= E -> near_vector K E v V ->
  (1 - 2 * u) * (R_norm V - 17321 / 10000 * E) - tiny <= F_norm v.
Proof.
  intros E0 ((_ & HX) & (_ & HY) & (_ & HZ)).
  apply Rle_trans with (2 := norm_3_lower (x v) (y v) (z v)). apply Rplus_le_compat_r.
  apply Rmult_le_compat_l; [generalize u_bounds; lra |].
  exact (norm_3_close _ _ _ _ _ _ _ HX HY HZ).
Qed.

Lemma F_norm_upper K E v V : bpow radix2 (-500) <= K -> near_vector K E v V -> F_norm v <= 4 * K.
Proof. intros N ((HX & _) & (HY & _) & (HZ & _)). exact (norm_3_upper _ _ _ _ HX HY HZ N). Qed.

Lemma R_norm_zero v : R_norm v = 0 -> x v = 0 /\ y v = 0 /\ z v = 0.
Proof.
  unfold R_norm, R_square, square, squared. intro H.
  generalize (Rle_0_sqr (x v)) (Rle_0_sqr (y v)) (Rle_0_sqr (z v)). unfold Rsqr. intros.
  apply sqrt_eq_0 in H; [| lra]. repeat split; nra.
Qed.

(* The largest of the squares; the order in which maxima are taken does not matter. *)
Definition largest (square : vector R -> R) (l : list (vector R)) : R := fold_right (fun v r => Rmax (square v) r) 0 l.

Lemma largest_in s l v : In v l -> s v <= largest s l.
Proof.
  induction l as [| w l IH]; [contradiction |]. intros [-> | I]; cbn; [apply Rmax_l |].
  apply Rle_trans with (1 := IH I). apply Rmax_r.
Qed.

Lemma F_largest l : F (largest F_square l).
Proof. induction l; [exact F_0 |]. cbn. apply F_max; [apply F_rnd | exact IHl]. Qed.

Lemma sqrt_max a b : sqrt (Rmax a b) = Rmax (sqrt a) (sqrt b).
Proof.
  unfold Rmax at 1. destruct (Rle_dec a b) as [L | L].
  - rewrite Rmax_right; [reflexivity | now apply sqrt_le_1_alt].
  - rewrite Rmax_left; [reflexivity | apply sqrt_le_1_alt; lra].
Qed.

Lemma largest_lower K E l k : 0 <= E -> Forall2 (near_vector K E) l k ->
  (1 - 2 * u) * (sqrt (largest R_square k) - 17321 / 10000 * E) - tiny <= sqrt (largest F_square l).
Proof.
  intros E0 H. generalize u_bounds tiny_pos. intros U T. induction H as [| v V l k N H IH]; cbn [largest fold_right].
  - rewrite sqrt_0. assert (0 <= (1 - 2 * u) * (17321 / 10000 * E)) by (apply Rmult_le_pos; lra). lra.
  - rewrite !sqrt_max. fold (largest R_square k) (largest F_square l). fold (R_norm V) (F_norm v).
    generalize (F_norm_lower _ _ _ _ E0 N). intro M.
    unfold Rmax at 1. destruct (Rle_dec (R_norm V) (sqrt (largest R_square k))).
    + apply Rle_trans with (1 := IH). apply Rmax_r.
    + apply Rle_trans with (1 := M). apply Rmax_l.
Qed.

Lemma largest_upper K E l k : bpow radix2 (-500) <= K -> Forall2 (near_vector K E) l k ->
  sqrt (largest F_square l) <= 4 * K.
Proof.
  intros N H. induction H as [| v V l k Q H IH]; cbn [largest fold_right].
  - rewrite sqrt_0. generalize (bpow_ge_0 radix2 (-500)). lra.
  - rewrite sqrt_max. apply Rmax_lub; [now apply F_norm_upper with (2 := Q) | exact IH].
Qed.

(* As the code has it: t.determinant, 2 sqrt(t.inner), C u m^k. *)
Definition decide_width (det : R) (slabs : list (vector R)) (m : R) (certified : bool) : option (Z * R) :=
  decide det (fmul 2 (rnd (sqrt (largest F_square slabs)))) (error_bound 47 (power_3 m)) (error_bound 122 (power_2 m))
    certified.

Theorem decide_width_sound m det DET slabs SLABS certified :
  bpow radix2 (-120) <= m -> F det ->
  Rabs (det - DET) <= 93 / 2 * u * m ^ 3 ->
  Forall2 (near_vector (16 * m ^ 2) (69 / 2 * u * m ^ 2)) slabs SLABS ->
  (0 < DET -> 0 < sqrt (largest R_square SLABS)) ->
  sound (decide_width det slabs m certified) certified DET (2 * sqrt (largest R_square SLABS)).
Proof.
  intros M Fd HD HS HP. generalize u_bounds (m_positive m M). intros U M0.
  assert (P2 : bpow radix2 (-240) <= m ^ 2) by exact (pow_large m M 2).
  assert (P3 : bpow radix2 (-360) <= m ^ 3) by exact (pow_large m M 3).
  generalize (bpow_gt_0 radix2 (-240)) (bpow_gt_0 radix2 (-360)). intros B240 B360.
  generalize (error_bound_range m M 47 _ 3 ltac:(lia) ltac:(lia) (widen m M _ _ 4 4 ltac:(lra) ltac:(lra) (power_3_range m M))).
  generalize (error_bound_range m M 122 _ 2 ltac:(lia) ltac:(lia) (power_2_range_6 m M)).
  unfold decide_width. set (e := error_bound 47 (power_3 m)). set (n := error_bound 122 (power_2 m)). intros [NL NH] [EL EH].
  assert (um : 0 <= u * m ^ 2) by (apply Rmult_le_pos; lra).
  assert (E0 : u * m ^ 3 <= e) by (apply Rle_trans with (2 := EL); apply Rmult_le_compat_r; [lra | unfold u; lra]).
  assert (N0 : 1219 / 10 * (u * m ^ 2) <= n).
  { rewrite <- Rmult_assoc. apply Rle_trans with (2 := NL). apply Rmult_le_compat_r; [lra | unfold u; lra]. }
  assert (N1 : n <= 1 * m ^ 2) by (apply Rle_trans with (1 := NH); apply Rmult_le_compat_r; [lra | unfold u; lra]).
  assert (tiny_small : tiny <= / 10 * (u * m ^ 2)).
  { apply Rle_trans with (bpow radix2 (-4) * (u * bpow radix2 (-240))).
    - change u with (bpow radix2 (-53)). rewrite <- !bpow_plus. apply bpow_le. lia.
    - apply mul_below; [apply bpow_ge_0 | apply Rmult_le_pos; lra | change (bpow radix2 (-4)) with (/ 16); lra |].
      apply Rmult_le_compat_l; lra. }
  assert (big : bpow radix2 (-500) <= 16 * m ^ 2).
  { apply Rle_trans with (bpow radix2 (-240)); [apply bpow_le; lia | lra]. }
  generalize (largest_lower (16 * m ^ 2) (69 / 2 * u * m ^ 2) slabs SLABS ltac:(lra) HS) (largest_upper _ _ slabs SLABS big HS).
  set (l := sqrt (largest F_square slabs)). set (L := sqrt (largest R_square SLABS)) in *. intros low high.
  generalize (rnd_sqrt_le _ (F_largest slabs)). fold l. intros [RL RH].
  assert (l0 : 0 <= l) by apply sqrt_pos. assert (L0 : 0 <= L) by apply sqrt_pos.
  assert (RH' : l * (1 + u) <= l * 2) by (apply Rmult_le_compat_l; lra).
  assert (double : fmul 2 (rnd l) = 2 * rnd l) by (apply rnd_F, F_double, F_rnd).
  apply decide_sound.
  - exact Fd.
  - apply F_rnd.
  - apply F_error_bound.
  - apply F_error_bound.
  - apply Rlt_le_trans with (2 := E0). apply Rmult_lt_0_compat; lra.
  - lra.
  - apply fmul_pos; [lra | now apply rnd_pos].
  - intro P. specialize (HP P). lra.
  - apply Rle_trans with (1 := HD). apply Rle_trans with (2 := EL). apply Rmult_le_compat_r; [lra | unfold u; lra].
  - rewrite double. apply (Rmult_le_compat_r (1 - u)) in low; [| lra].
    set (w := u * m ^ 2) in *.
    assert (low' : (1 - u) * (1 - 2 * u) * L - 1196 / 10 / 2 * w - tiny <= l * (1 - u)).
    { replace (69 / 2 * u * m ^ 2) with (69 / 2 * w) in low by (unfold w; ring).
      apply Rle_trans with (2 := low).
      assert (0 <= u * w) by (apply Rmult_le_pos; lra). assert (0 <= u * (u * w)) by (apply Rmult_le_pos; lra).
      assert (u * (u * w) <= 1 * (u * w)) by (apply Rmult_le_compat_r; lra).
      assert (0 <= u * tiny) by (apply Rmult_le_pos; [lra | left; apply tiny_pos]). lra. }
    assert (0 <= u * L) by (apply Rmult_le_pos; lra). assert (0 <= u * (u * L)) by (apply Rmult_le_pos; lra). lra.
  - rewrite double. apply Rle_trans with (2 := E0). apply Rle_trans with (bpow radix2 (-900) * (512 * m ^ 2)).
    + apply Rmult_le_compat_l; [apply bpow_ge_0 | lra].
    + replace (u * m ^ 3) with (u * m * m ^ 2) by ring. rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [lra |].
      apply Rle_trans with (u * bpow radix2 (-120)).
      * change u with (bpow radix2 (-53)). change 512 with (bpow radix2 9). rewrite <- !bpow_plus. apply bpow_le. lia.
      * apply Rmult_le_compat_l; lra.
Qed.
