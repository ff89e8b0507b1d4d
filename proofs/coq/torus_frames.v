(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Cells of a periodic box of the plane at their places, and their translates: docs/theory.md 8.3.

   - locally_delaunay_2   what is tested: no corner of a neighbour is strictly inside the circle of a cell; strictly_delaunay_2, nor on it
   - neighbour            a translate of a cell has a translate of a cell beyond each of its sides
   - certified            what is tested of cells in their own frames holds of all such translates *)
Require Import Reals ZArith Lra Lia List Permutation.
From Annulus Require Import width_2 torus_2.
Import ListNotations.
Open Scope R_scope.

Section placed.
Variables (x : nat -> point_2) (L : box_2).

Definition spot (s : site_2) : point_2 := site_at x L s.
(* Positive for z outside of the circle of a, b, q. *)
Definition beyond (a b q z : point_2) : R := incircle (fst a) (snd a) (fst b) (snd b) (fst z) (snd z) (fst q) (snd q).
Definition rotations_2 (c : torus_cell_2) : list torus_cell_2 := let '(a, b, c) := c in [(a, b, c); (b, c, a); (c, a, b)].
Definition moved_cell_2 (t : offset_2) (c : torus_cell_2) : torus_cell_2 := let '(a, b, c) := c in (moved_2 t a, moved_2 t b, moved_2 t c).
Definition area_of (c : torus_cell_2) : R := torus_area x L c.
Definition in_torus_cell (z : point_2) (c : torus_cell_2) : Prop := let '(a, b, q) := c in
  0 <= turning (spot a) (spot b) z /\ 0 <= turning (spot b) (spot q) z /\ 0 <= turning (spot q) (spot a) z.

Definition positive_torus_2 (T : list torus_cell_2) : Prop := forall c, In c T -> 0 < area_of c.
(* Cells on both sides of a b, the second one in its own frame, which is t away. *)
Definition locally_delaunay_2 (T : list torus_cell_2) : Prop := forall c c' a b q p t, In c T -> In c' T ->
  In (a, b, q) (rotations_2 c) -> In (moved_2 t b, moved_2 t a, moved_2 t p) (rotations_2 c') -> 0 <= beyond (spot a) (spot b) (spot q) (spot p).
Definition strictly_delaunay_2 (T : list torus_cell_2) : Prop := forall c c' a b q p t, In c T -> In c' T ->
  In (a, b, q) (rotations_2 c) -> In (moved_2 t b, moved_2 t a, moved_2 t p) (rotations_2 c') -> 0 < beyond (spot a) (spot b) (spot q) (spot p).

(* Translates of cells. *)
Definition instance (k : torus_cell_2 * offset_2) : torus_cell_2 := moved_cell_2 (snd k) (fst k).
Definition corner_of_torus (s : site_2) (c : torus_cell_2) : Prop := let '(a, b, q) := c in s = a \/ s = b \/ s = q.
Definition torus_vertex (T : list torus_cell_2) (v : nat) : Prop := exists c s, In c T /\ corner_of_torus s c /\ fst s = v.

(* ---- Frames ---- *)

Definition lattice_2 (t : offset_2) : point_2 := (IZR (fst t) * fst (fst L) + IZR (snd t) * fst (snd L), IZR (fst t) * snd (fst L) + IZR (snd t) *
  snd (snd L)).
Definition less_2 (z w : point_2) : point_2 := (fst z - fst w, snd z - snd w).

Lemma spot_moved t s : spot (moved_2 t s) = (fst (lattice_2 t) + fst (spot s), snd (lattice_2 t) + snd (spot s)).
Proof. destruct s as (v, (i, j)). unfold spot, lattice_2. simpl. rewrite !plus_IZR. f_equal; ring. Qed.

Lemma moved_twice t u s : moved_2 t (moved_2 u s) = moved_2 (fst t + fst u, snd t + snd u)%Z s.
Proof. destruct s as (v, (i, j)). simpl. f_equal. f_equal; ring. Qed.

Lemma moved_zero s : moved_2 (0, 0)%Z s = s.
Proof. destruct s as (v, (i, j)). reflexivity. Qed.

Lemma moved_back t s : moved_2 t (moved_2 (- fst t, - snd t)%Z s) = s.
Proof. rewrite moved_twice. simpl. replace (fst t + - fst t)%Z with 0%Z by ring. replace (snd t + - snd t)%Z with 0%Z by ring. apply moved_zero. Qed.

Lemma area_moved t c : area_of (moved_cell_2 t c) = area_of c.
Proof.
  destruct c as ((a, b), q). unfold area_of, torus_area, moved_cell_2.
  fold (spot (moved_2 t a)) (spot (moved_2 t b)) (spot (moved_2 t q)) (spot a) (spot b) (spot q).
  rewrite !spot_moved. unfold turning, turn. cbn [fst snd]. ring.
Qed.

Lemma rotated_area r c : In r (rotations_2 c) -> area_of r = area_of c.
Proof. destruct c as ((a, b), q). intros [<-|[<-|[<-|[]]]]; unfold area_of, torus_area, turning, turn; ring. Qed.

Lemma rotation_turns r c : In r (rotations_2 c) -> let '(a, b, q) := r in In (b, q, a) (rotations_2 c).
Proof. destruct c as ((a, b), q). intros [<-|[<-|[<-|[]]]]; simpl; tauto. Qed.

Lemma in_rotated z r c : In r (rotations_2 c) -> in_torus_cell z r -> in_torus_cell z c.
Proof. destruct c as ((a, b), q). intros [<-|[<-|[<-|[]]]]; simpl; tauto. Qed.

(* ---- Across a side ---- *)

Lemma side_of_rotation a b c : In (a, b) (sides_2 c) -> exists q, In (a, b, q) (rotations_2 c).
Proof. destruct c as ((u, v), w). intros [[=<- <-]|[[=<- <-]|[[=<- <-]|[]]]]; [exists w|exists u|exists v]; simpl; tauto. Qed.

Lemma other_side T a b q c : glued_torus_2 T -> In c T -> In (a, b, q) (rotations_2 c) ->
  exists c' p t, In c' T /\ In (moved_2 t b, moved_2 t a, moved_2 t p) (rotations_2 c').
Proof.
  intros (pairs & P) Ic Ir.
  assert (S : In (a, b) (flat_map sides_2 T)).
  { apply in_flat_map. exists c. split; [exact Ic|]. destruct c as ((u, v), w).
    destruct Ir as [[=<- <- <-]|[[=<- <- <-]|[[=<- <- <-]|[]]]]; simpl; tauto. }
  assert (O : forall side, In side (flat_map sides_2 T) -> exists c', In c' T /\ exists p, In (fst side, snd side, p) (rotations_2 c')).
  { intros (u, v) I. apply in_flat_map in I. destruct I as (c' & I & J). exists c'. split; [exact I|]. now apply side_of_rotation. }
  assert (S' := Permutation_in _ P S). apply in_flat_map in S'. destruct S' as (((u, v), t) & Ik & [[=-> ->]|[[=<- <-]|[]]]).
  - destruct (O (moved_2 t b, moved_2 t a)) as (c' & Ic' & p & Ip).
    { apply Permutation_in with (1 := Permutation_sym P). apply in_flat_map. exists ((a, b), t). simpl. tauto. }
    exists c', (moved_2 (- fst t, - snd t)%Z p), t. split; [exact Ic'|]. rewrite moved_back. exact Ip.
  - destruct (O (u, v)) as (c' & Ic' & p & Ip).
    { apply Permutation_in with (1 := Permutation_sym P). apply in_flat_map. exists ((u, v), t). simpl. tauto. }
    exists c', (moved_2 t p), (- fst t, - snd t)%Z. split; [exact Ic'|].
    assert (B : forall s, moved_2 (- fst t, - snd t)%Z (moved_2 t s) = s).
    { intro s. rewrite moved_twice. simpl. replace (- fst t + fst t)%Z with 0%Z by ring. replace (- snd t + snd t)%Z with 0%Z by ring. apply moved_zero. }
    rewrite !B. exact Ip.
Qed.

Lemma rotation_of_moved t r c : In r (rotations_2 (moved_cell_2 t c)) -> exists r0, In r0 (rotations_2 c) /\ r = moved_cell_2 t r0.
Proof.
  destruct c as ((a, b), q). intros [<-|[<-|[<-|[]]]]; [exists (a, b, q)|exists (b, q, a)|exists (q, a, b)]; (split; [|reflexivity]); simpl; tauto.
Qed.

Lemma rotation_moved t r c : In r (rotations_2 c) -> In (moved_cell_2 t r) (rotations_2 (moved_cell_2 t c)).
Proof. destruct c as ((a, b), q). intros [<-|[<-|[<-|[]]]]; simpl; tauto. Qed.

Lemma cell_moved_twice t u c : moved_cell_2 t (moved_cell_2 u c) = moved_cell_2 (fst t + fst u, snd t + snd u)%Z c.
Proof. destruct c as ((a, b), q). cbn [moved_cell_2]. now rewrite !moved_twice. Qed.

Lemma instance_zero c : instance (c, (0, 0)%Z) = c.
Proof. destruct c as ((a, b), q). unfold instance. cbn [fst snd moved_cell_2]. now rewrite !moved_zero. Qed.

Lemma neighbour T k a b q : glued_torus_2 T -> In (fst k) T -> In (a, b, q) (rotations_2 (instance k)) ->
  exists k' p, In (fst k') T /\ In (b, a, p) (rotations_2 (instance k')).
Proof.
  destruct k as (c, u). intros G Ic Ir. destruct (rotation_of_moved _ _ _ Ir) as (((a0, b0), q0) & I0 & [=-> -> ->]).
  destruct (other_side T a0 b0 q0 c G Ic I0) as (c' & p & t & Ic' & Ip). exists (c', (fst u - fst t, snd u - snd t)%Z), (moved_2 u p). split; [exact Ic'|].
  assert (E : forall s, moved_2 (fst u - fst t, snd u - snd t)%Z (moved_2 t s) = moved_2 u s).
  { intro s. rewrite moved_twice. cbn [fst snd]. rewrite !Z.sub_add. now rewrite <- surjective_pairing. }
  rewrite <- !E. exact (rotation_moved _ _ _ Ip).
Qed.

(* What is said of cells in their own frames holds in any other. *)
Lemma certified (Q : R -> Prop) T k k' a b q p : (forall c c' a b q p t, In c T -> In c' T -> In (a, b, q) (rotations_2 c) ->
    In (moved_2 t b, moved_2 t a, moved_2 t p) (rotations_2 c') -> Q (beyond (spot a) (spot b) (spot q) (spot p))) ->
  In (fst k) T -> In (fst k') T -> In (a, b, q) (rotations_2 (instance k)) -> In (b, a, p) (rotations_2 (instance k')) ->
  Q (beyond (spot a) (spot b) (spot q) (spot p)).
Proof.
  destruct k as (c, u), k' as (c', u'). intros C Ic Ic' Ir Ir'. destruct (rotation_of_moved _ _ _ Ir) as (((a0, b0), q0) & I0 & [=-> -> ->]).
  assert (B : forall s, spot s = spot (moved_2 u (moved_2 (- fst u, - snd u)%Z s))) by (intro; now rewrite moved_back).
  rewrite (B p). set (p0 := moved_2 (- fst u, - snd u)%Z p).
  replace (beyond _ _ _ _) with (beyond (spot a0) (spot b0) (spot q0) (spot p0)) by (rewrite !spot_moved; unfold beyond, incircle, turn;
  cbn [fst snd]; ring).
  apply (C c c' a0 b0 q0 p0 (- fst u' + fst u, - snd u' + snd u)%Z Ic Ic' I0).
  assert (I := rotation_moved (- fst u', - snd u')%Z _ _ Ir'). unfold instance in I. cbn [fst snd] in I. rewrite cell_moved_twice in I.
  cbn [fst snd moved_cell_2] in I.
  rewrite !Z.add_opp_diag_l in I. rewrite !moved_twice in I. cbn [fst snd] in I.
  replace (moved_cell_2 (0, 0)%Z c') with c' in I by (destruct c' as ((v, w), y); cbn [moved_cell_2]; now rewrite !moved_zero).
  unfold p0. rewrite moved_twice. cbn [fst snd]. replace (- fst u' + fst u + - fst u)%Z with (- fst u')%Z by ring.
  replace (- snd u' + snd u + - snd u)%Z with (- snd u')%Z by ring.
  exact I.
Qed.

Lemma instance_positive T k r : positive_torus_2 T -> In (fst k) T -> In r (rotations_2 (instance k)) -> 0 < area_of r.
Proof. intros P I H. rewrite (rotated_area r _ H). unfold instance. rewrite area_moved. now apply P. Qed.

Lemma corner_of_rotation a b q k : In (a, b, q) (rotations_2 (instance k)) -> corner_of_torus a (instance k) /\ corner_of_torus b (instance k) /\
  corner_of_torus q (instance k).
Proof. destruct (instance k) as ((u, v), w). intros [[=<- <- <-]|[[=<- <- <-]|[[=<- <- <-]|[]]]]; simpl; tauto. Qed.

Lemma rotation_at s c : corner_of_torus s c -> exists b q, In (s, b, q) (rotations_2 c).
Proof. destruct c as ((a, b), q). intros [->|[->| ->]]; [exists b, q|exists q, a|exists a, b]; simpl; tauto. Qed.
End placed.
