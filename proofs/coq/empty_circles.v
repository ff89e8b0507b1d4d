(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* empty_spheres.v in the plane: with strict certificates, a convex hull and an embedding every circle is empty. That signs and
   winding of the border give the embedding is proved in docs/theory.md, 1.2, and not here. *)
Require Import Reals Lra Psatz List.
From Annulus Require Import width_2 empty_spheres.
Open Scope R_scope.

Record point := At { abscissa : R; ordinate : R }.
Definition turn_of u v w := turn (abscissa u) (ordinate u) (abscissa v) (ordinate v) (abscissa w) (ordinate w).
Definition dist2 u v := d2 (abscissa u) (ordinate u) (abscissa v) (ordinate v).

Inductive index := i0 | i1 | i2.
Record triangle := Triangle { corner_at : index -> point; middle : point; radius_sq : R }.

(* Positive exactly if z is on the inner side of the edge opposite to corner k. *)
Definition above t k z := match k with
  | i0 => turn_of (corner_at t i1) (corner_at t i2) z
  | i1 => turn_of (corner_at t i2) (corner_at t i0) z
  | i2 => turn_of (corner_at t i0) (corner_at t i1) z
  end.

Definition power_2 c r2 z := dist2 z c - r2.

Lemma radical_2 c1 r1 c2 r2 u v : power_2 c1 r1 u = power_2 c2 r2 u -> power_2 c1 r1 v = power_2 c2 r2 v ->
  exists k, forall z, dist2 u v * (power_2 c1 r1 z - power_2 c2 r2 z) = k * turn_of u v z.
Proof.
  intros Eu Ev. destruct c1 as [x1 y1], c2 as [x2 y2], u as [ux uy], v as [vx vy].
  exists (2 * ((y2 - y1) * (vx - ux) - (x2 - x1) * (vy - uy))). intros [zx zy].
  unfold power_2, dist2, turn_of, turn, d2 in *. cbn [abscissa ordinate] in *.
  assert (G : (x2 - x1) * (vx - ux) + (y2 - y1) * (vy - uy) = 0) by lra.
  assert (D : r1 = r2 + ((ux - x1) * (ux - x1) + (uy - y1) * (uy - y1)) - ((ux - x2) * (ux - x2) + (uy - y2) * (uy - y2))) by lra.
  rewrite D. apply Rminus_diag_uniq.
  match goal with |- ?e = 0 =>
    replace e with (2 * ((x2 - x1) * (vx - ux) + (y2 - y1) * (vy - uy)) * ((vx - ux) * (zx - ux) + (vy - uy) * (zy - uy))) by ring end.
  rewrite G. ring.
Qed.

Section delaunay.
Variable cells : list triangle.
Variable site : point -> Prop.

Definition neighbours_2 t k t' :=
  (forall i, i <> k -> exists j, corner_at t' j = corner_at t i) /\
  exists j, above t k (corner_at t' j) < 0 /\ radius_sq t < dist2 (corner_at t' j) (middle t).

Hypothesis circles : forall t k, In t cells -> dist2 (corner_at t k) (middle t) = radius_sq t.
Hypothesis edges : forall t k, In t cells ->
  (forall z, site z -> 0 <= above t k z) \/ (exists t', In t' cells /\ neighbours_2 t k t').
Hypothesis embedded : forall t z, In t cells -> site z -> (forall k, 0 <= above t k z) -> exists k, z = corner_at t k.

Definition power_of_2 z t := power_2 (middle t) (radius_sq t) z.

Lemma edge_of t k : exists i j, i <> k /\ j <> k /\ forall z, above t k z = turn_of (corner_at t i) (corner_at t j) z.
Proof. destruct k; [exists i1, i2 | exists i2, i0 | exists i0, i1]; repeat split; discriminate. Qed.

Lemma across_2 t k t' z : In t cells -> In t' cells -> neighbours_2 t k t' -> above t k z < 0 -> power_of_2 z t' < power_of_2 z t.
Proof.
  intros Ht Ht' (Shared & j & Hj & Out) Hz. destruct (edge_of t k) as (m & n & Hm & Hn & E). rewrite E in Hj, Hz.
  assert (Both : forall i, i <> k -> power_2 (middle t) (radius_sq t) (corner_at t i) = power_2 (middle t') (radius_sq t') (corner_at t i)).
  { intros i Hi. destruct (Shared i Hi) as (l & El). unfold power_2. rewrite (circles t i Ht), <- El, (circles t' l Ht'). ring. }
  destruct (radical_2 _ _ _ _ _ _ (Both m Hm) (Both n Hn)) as (kappa & K).
  set (u := corner_at t m) in *. set (v := corner_at t n) in *.
  assert (Q : 0 < dist2 u v).
  { unfold dist2, d2. apply Rnot_le_lt. intro N.
    assert (abscissa u = abscissa v /\ ordinate u = ordinate v) as (E1 & E2).
    { generalize (Rle_0_sqr (abscissa u - abscissa v)) (Rle_0_sqr (ordinate u - ordinate v)). unfold Rsqr. intros.
      split; apply Rminus_diag_uniq, Rsqr_0_uniq; unfold Rsqr; lra. }
    unfold turn_of, turn in Hz. rewrite E1, E2 in Hz. lra. }
  generalize (K (corner_at t' j)) (K z). unfold power_of_2. intros Kj Kz.
  assert (Pj : 0 < power_2 (middle t) (radius_sq t) (corner_at t' j) - power_2 (middle t') (radius_sq t') (corner_at t' j)).
  { unfold power_2. rewrite (circles t' j Ht'). lra. }
  assert (Sj : 0 < kappa * turn_of u v (corner_at t' j)) by (rewrite <- Kj; now apply Rmult_lt_0_compat).
  assert (kappa < 0) by nra.
  assert (Sz : 0 < kappa * turn_of u v z) by nra.
  rewrite <- Kz in Sz. apply Rminus_gt_0_lt. apply Rmult_lt_reg_l with (dist2 u v); [exact Q|]. now rewrite Rmult_0_r.
Qed.

Theorem delaunay_2 t z : In t cells -> site z ->
  radius_sq t <= dist2 z (middle t) /\ ((forall k, z <> corner_at t k) -> radius_sq t < dist2 z (middle t)).
Proof.
  intros Ht Hz.
  assert (Progress : forall t1 k, In t1 cells -> above t1 k z < 0 -> exists t', In t' cells /\ power_of_2 z t' < power_of_2 z t1).
  { intros t1 k H1 B. destruct (edges t1 k H1) as [Hull | (t' & Ht' & Nb)]; [generalize (Hull z Hz); lra|].
    exists t'. split; [exact Ht' | now apply across_2 with k]. }
  assert (All : forall t1, In t1 cells -> 0 <= power_of_2 z t1).
  { intros t1 H1. destruct (walk triangle index cells (power_of_2 z) (fun t1 k => above t1 k z < 0) Progress t1 H1) as (m & Hm & Nm & Lm).
    destruct (embedded m z Hm Hz) as (k & Ek); [intro k; apply Rnot_lt_le, Nm|].
    assert (power_of_2 z m = 0); [|lra]. unfold power_of_2, power_2. rewrite Ek, (circles m k Hm). ring. }
  split; [generalize (All t Ht); unfold power_of_2, power_2; lra|]. intro Not.
  assert (B : exists k, above t k z < 0).
  { destruct (Rlt_dec (above t i0 z) 0) as [L|L0]; [now exists i0|]. destruct (Rlt_dec (above t i1 z) 0) as [L|L1]; [now exists i1|].
    destruct (Rlt_dec (above t i2 z) 0) as [L|L2]; [now exists i2|].
    exfalso. destruct (embedded t z Ht Hz) as (k & Ek); [|now apply (Not k)]. intro k. destruct k; lra. }
  destruct B as (k & B). destruct (Progress t k Ht B) as (t' & Ht' & D). generalize (All t' Ht'). unfold power_of_2, power_2 in *. lra.
Qed.
End delaunay.
