(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* From local certificates to a Delaunay triangulation, in space.

   Cells are tetrahedra with their circumspheres, their corners in positive order. The sites are the points of which none may be strictly inside a sphere.

   delaunay   if every facet of every cell either has all sites on the cell's side (hull), or is shared with a cell whose opposite corner
              lies beyond the facet and strictly outside the sphere (the certificate of the bi-cell), and if no site lies in a cell of
              which it is not a corner (embedding), then every site is outside every sphere, strictly unless it is a corner.

   The proof is the visibility walk: across a facet towards a site z the power of z strictly decreases, so a cell in which it is least
   contains z. No topology enters beyond the two hypotheses. Whether signs alone, with what further checks, imply the embedding is
   another matter, which docs/theory.md 1.2 answers with pen and paper. Facets with cospherical cells
   on both sides (a certificate that is 0) are not covered. *)
Require Import Reals Lra Psatz List.
From Annulus Require Import vectors tetrahedron bicell.
Open Scope R_scope.

(* What the walk needs of cells, whatever they are. *)
Section walk.
Variable C K : Type.
Variable cells : list C.
Variable power : C -> R.               (* of a fixed site *)
Variable beyond : C -> K -> Prop.      (* the site is beyond a facet *)
Hypothesis progress : forall t k, In t cells -> beyond t k -> exists t', In t' cells /\ power t' < power t.

Lemma least : cells <> nil -> exists t, In t cells /\ forall t', In t' cells -> power t <= power t'.
Proof.
  clear progress. induction cells as [|t l IH]; intro H; [now elim H|]. clear H.
  destruct l as [|t1 l].
  - exists t. split; [now left|]. intros t' [ -> | [] ]. lra.
  - destruct IH as (m & Hm & Lm); [discriminate|].
    destruct (Rle_dec (power t) (power m)) as [L|L].
    + exists t. split; [now left|]. intros t' [ -> | H' ]; [lra | generalize (Lm t' H'); lra].
    + exists m. split; [now right|]. intros t' [ -> | H' ]; [lra | now apply Lm].
Qed.

Theorem walk t : In t cells -> exists t', In t' cells /\ (forall k, ~ beyond t' k) /\ power t' <= power t.
Proof.
  intro H. destruct least as (m & Hm & Lm); [intro E; now rewrite E in H|].
  exists m. split; [exact Hm|]. split; [|now apply Lm].
  intros k B. destruct (progress m k Hm B) as (t' & Ht' & D). generalize (Lm t' Ht'). lra.
Qed.
End walk.

(* The difference of the powers of two spheres through u, v, w is a multiple of the height above their plane. *)
Definition power o r2 z := sq (z ⊖ o) - r2.

Lemma radical o1 r1 o2 r2 u v w : power o1 r1 u = power o2 r2 u -> power o1 r1 v = power o2 r2 v -> power o1 r1 w = power o2 r2 w ->
  let n := (v ⊖ u) ✕ (w ⊖ u) in exists k, forall z, sq n * (power o1 r1 z - power o2 r2 z) = k * (n · (z ⊖ u)).
Proof.
  intros Eu Ev Ew n. pose (g := 2 ⊙ (o2 ⊖ o1)). exists (g · n). intro z.
  assert (A : forall y, power o1 r1 y - power o2 r2 y = g · (y ⊖ u) + (power o1 r1 u - power o2 r2 u))
    by (intro; unfold power, g; vector).
  assert (Gv : g · (v ⊖ u) = 0) by (generalize (A v); lra).
  assert (Gw : g · (w ⊖ u) = 0) by (generalize (A w); lra).
  rewrite A, Eu.
  assert (I : forall s t y, sq (s ✕ t) * (g · y) = (g · (s ✕ t)) * ((s ✕ t) · y)
      - (g · t) * (s · ((s ✕ t) ✕ y)) + (g · s) * (t · ((s ✕ t) ✕ y))) by (generalize g; vector).
  rewrite Rminus_diag_eq, Rplus_0_r by reflexivity. unfold n. rewrite I, Gv, Gw. ring.
Qed.

Record cell := Cell { at_ : corners; origin : vec; radius2 : R }.

(* The cell with corner k replaced by z: its volume is negative exactly if z is beyond the facet opposite to k. *)
Definition corner_eq (i k : corner) := match i, k with o, o | u, u | v, v | w, w => true | _, _ => false end.
Definition put (x : corners) k z : corners := fun i => if corner_eq i k then z else x i.
Definition height t k z := volume (put (at_ t) k z).

Section delaunay.
Variable cells : list cell.
Variable site : vec -> Prop.

Definition neighbours t k t' :=
  (forall i, i <> k -> exists j, at_ t' j = at_ t i) /\
  exists j, height t k (at_ t' j) < 0 /\ radius2 t < sq (at_ t' j ⊖ origin t).

Hypothesis spheres : forall t k, In t cells -> sq (at_ t k ⊖ origin t) = radius2 t.
Hypothesis facets : forall t k, In t cells ->
  (forall z, site z -> 0 <= height t k z) \/ (exists t', In t' cells /\ neighbours t k t').
Hypothesis embedded : forall t z, In t cells -> site z -> (forall k, 0 <= height t k z) -> exists k, z = at_ t k.

Definition power_of z t := power (origin t) (radius2 t) z.

(* A height is an affine function that vanishes on the facet. *)
Lemma height_normal t k : exists u v w sgn, (sgn = 1 \/ sgn = -1) /\ (forall s, s = u \/ s = v \/ s = w -> exists i, i <> k /\ s = at_ t i) /\
  forall z, height t k z = sgn * (((v ⊖ u) ✕ (w ⊖ u)) · (z ⊖ u)).
Proof.
  destruct k.
  - exists (at_ t u), (at_ t v), (at_ t w), (-1). split; [now right|]. split.
    + intros s [ -> | [ -> | -> ]]; eexists; (split; [|reflexivity]); discriminate.
    + intro z. unfold height, volume, put, corner_eq. generalize (at_ t u) (at_ t v) (at_ t w). vector.
  - exists (at_ t o), (at_ t v), (at_ t w), 1. split; [now left|]. split.
    + intros s [ -> | [ -> | -> ]]; eexists; (split; [|reflexivity]); discriminate.
    + intro z. unfold height, volume, put, corner_eq. generalize (at_ t o) (at_ t v) (at_ t w). vector.
  - exists (at_ t o), (at_ t u), (at_ t w), (-1). split; [now right|]. split.
    + intros s [ -> | [ -> | -> ]]; eexists; (split; [|reflexivity]); discriminate.
    + intro z. unfold height, volume, put, corner_eq. generalize (at_ t o) (at_ t u) (at_ t w). vector.
  - exists (at_ t o), (at_ t u), (at_ t v), 1. split; [now left|]. split.
    + intros s [ -> | [ -> | -> ]]; eexists; (split; [|reflexivity]); discriminate.
    + intro z. unfold height, volume, put, corner_eq. generalize (at_ t o) (at_ t u) (at_ t v). vector.
Qed.

Lemma across t k t' z : In t cells -> In t' cells -> neighbours t k t' -> height t k z < 0 -> power_of z t' < power_of z t.
Proof.
  intros Ht Ht' (Shared & j & Hj & Out) Hz.
  destruct (height_normal t k) as (f1 & f2 & f3 & sgn & Hs & Hf & Hh).
  assert (Both : forall s, s = f1 \/ s = f2 \/ s = f3 -> power (origin t) (radius2 t) s = power (origin t') (radius2 t') s).
  { intros s E. destruct (Hf s E) as (i & Hi & ->). destruct (Shared i Hi) as (m & Em).
    unfold power. rewrite (spheres t i Ht), <- Em, (spheres t' m Ht'). ring. }
  destruct (radical _ _ _ _ f1 f2 f3 (Both f1 ltac:(tauto)) (Both f2 ltac:(tauto)) (Both f3 ltac:(tauto))) as (kappa & R1).
  set (n := (f2 ⊖ f1) ✕ (f3 ⊖ f1)) in *.
  assert (Q : 0 < sq n).
  { apply sq_pos. intro E. rewrite Hh in Hz. rewrite E in Hz. replace (zero · (z ⊖ f1)) with 0 in Hz by vector. lra. }
  assert (Pj : 0 < power (origin t) (radius2 t) (at_ t' j) - power (origin t') (radius2 t') (at_ t' j)).
  { unfold power. rewrite (spheres t' j Ht'). lra. }
  generalize (R1 (at_ t' j)) (R1 z). rewrite Hh in Hj, Hz. unfold power_of.
  set (hj := n · (at_ t' j ⊖ f1)) in *. set (hz := n · (z ⊖ f1)) in *. intros Rj Rz.
  assert (Kj : 0 < kappa * hj) by (rewrite <- Rj; now apply Rmult_lt_0_compat).
  assert (S : 0 < hj * hz) by (destruct Hs as [ -> | -> ]; nra).
  assert (Kz : 0 < kappa * hz).
  { apply Rmult_lt_reg_r with (hj * hj); [nra|]. replace (kappa * hz * (hj * hj)) with ((kappa * hj) * (hj * hz)) by ring.
    rewrite Rmult_0_l. now apply Rmult_lt_0_compat. }
  rewrite <- Rz in Kz. apply Rminus_gt_0_lt. apply Rmult_lt_reg_l with (sq n); [exact Q|]. now rewrite Rmult_0_r.
Qed.

Theorem delaunay t z : In t cells -> site z ->
  radius2 t <= sq (z ⊖ origin t) /\ ((forall k, z <> at_ t k) -> radius2 t < sq (z ⊖ origin t)).
Proof.
  intros Ht Hz.
  assert (Progress : forall t1 k, In t1 cells -> height t1 k z < 0 -> exists t', In t' cells /\ power_of z t' < power_of z t1).
  { intros t1 k H1 B. destruct (facets t1 k H1) as [Hull | (t' & Ht' & Nb)]; [generalize (Hull z Hz); lra|].
    exists t'. split; [exact Ht' | now apply across with k]. }
  assert (All : forall t1, In t1 cells -> 0 <= power_of z t1).
  { intros t1 H1. destruct (walk cell corner cells (power_of z) (fun t1 k => height t1 k z < 0) Progress t1 H1) as (m & Hm & Nm & Lm).
    destruct (embedded m z Hm Hz) as (k & Ek); [intro k; apply Rnot_lt_le, Nm|].
    assert (power_of z m = 0); [|lra]. unfold power_of, power. rewrite Ek, (spheres m k Hm). ring. }
  split; [generalize (All t Ht); unfold power_of, power; lra|]. intro Not.
  assert (B : exists k, height t k z < 0).
  { destruct (Rlt_dec (height t o z) 0) as [L|L0]; [now exists o|]. destruct (Rlt_dec (height t u z) 0) as [L|L1]; [now exists u|].
    destruct (Rlt_dec (height t v z) 0) as [L|L2]; [now exists v|]. destruct (Rlt_dec (height t w z) 0) as [L|L3]; [now exists w|].
    exfalso. destruct (embedded t z Ht Hz) as (k & Ek); [|now apply (Not k)]. intro k. destruct k; lra. }
  destruct B as (k & B). destruct (Progress t k Ht B) as (t' & Ht' & D). generalize (All t' Ht'). unfold power_of, power in *. lra.
Qed.
End delaunay.

(* The hypotheses are those of the code: a positive cell has a circumsphere, and the certificate says that the opposite corner is
   outside it. *)
Lemma circumsphere x : 0 < volume x -> exists c r2, forall k, sq (x k ⊖ c) = r2.
Proof.
  intro H. pose (d k := x k ⊖ x o). pose (h := twice_centre (d u) (d v) (d w)).
  exists (x o ⊕ / (2 * volume x) ⊙ h), (sq (/ (2 * volume x) ⊙ h)). intro k.
  assert (E : 2 * (h · d k) = 2 * volume x * sq (d k)).
  { unfold h, volume, twice_centre. fold (d u) (d v) (d w). destruct k.
    - replace (d o) with zero by (unfold d; vector). generalize (d u) (d v) (d w). vector.
    - generalize (d u) (d v) (d w). vector.
    - generalize (d u) (d v) (d w). vector.
    - generalize (d u) (d v) (d w). vector. }
  replace (x k ⊖ (x o ⊕ / (2 * volume x) ⊙ h)) with (d k ⊖ / (2 * volume x) ⊙ h) by (unfold d; generalize h (/ (2 * volume x)); vector).
  replace (sq (d k ⊖ / (2 * volume x) ⊙ h)) with (sq (d k) - / (2 * volume x) * (2 * (h · d k)) + sq (/ (2 * volume x) ⊙ h))
    by (generalize h (d k) (/ (2 * volume x)); vector).
  rewrite E. field. lra.
Qed.

Lemma opposite_outside x c r2 : 0 < lambda x q -> 0 < det x -> sq (x a ⊖ c) = r2 -> sq (x b ⊖ c) = r2 -> sq (x bicell.c ⊖ c) = r2 ->
  sq (x p ⊖ c) = r2 -> r2 < sq (x q ⊖ c).
Proof.
  intros Hq D Ea Eb Ec Ep. generalize (empty_sphere x c r2 Ea Eb Ec Ep). intro E.
  apply Rnot_le_lt. intro N. generalize (Rmult_le_pos (lambda x q) (r2 - sq (x q ⊖ c))). lra.
Qed.
