(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* From local to global in a periodic box of the plane: docs/theory.md 8.3.

   - torus_delaunay    glued, positive, of degree 1, locally Delaunay: no vertex is strictly inside the circle of a cell, ties or not
   - torus_strict      with strict certificates none but the corners of the cell is on it
   - torus_unique      and there is no other such mesh with the same vertices, even with ties: its cells are translates of these *)
Require Import Reals ZArith Lra Lia Psatz List Permutation.
From Annulus Require Import sums width_2 plane_mesh plane_crossings plane_embedding torus_2 torus_powers torus_cover torus_triangulation.
Import ListNotations.
Open Scope R_scope.

Section placed.
Variables (x : nat -> point_2) (L : box_2).
Hypothesis box_positive : 0 < det_2 L.
Notation spot := (spot x L).
Notation in_torus_cell := (in_torus_cell x L).
Notation power_of := (power_of x L).
Notation "'rotated' r k" := (In r (rotations_2 (instance k))) (at level 10, r at level 9, k at level 9).

Lemma strictly_locally T : strictly_delaunay_2 x L T -> locally_delaunay_2 x L T.
Proof. intros S c c' a b q p t I I' R R'. apply Rlt_le. now apply (S c c' a b q p t). Qed.

(* Glued, positive, of degree 1. *)
Definition covers_once (T : list torus_cell_2) : Prop := glued_torus_2 T /\ positive_torus_2 x L T /\ sum (torus_area x L) T = 2 * det_2 L.

Lemma degree_one T : covers_once T -> covers_2 T = 2%Z.
Proof.
  intros (G & _ & A). rewrite (degree_2 T G) in A. apply eq_IZR. apply Rmult_eq_reg_r with (det_2 L); lra.
Qed.

Lemma power_not_negative T k s : covers_once T -> locally_delaunay_2 x L T -> In (fst k) T -> torus_vertex T (fst s) ->
  0 <= power_of (spot s) (instance k).
Proof.
  intros C D I V. assert (O := degree_one T C). destruct C as (G & P & _).
  destruct (least_power x L box_positive T (spot s) (fst k) G P D I) as (c & u & Ic & H & M).
  assert (K := vertex_is_corner x L box_positive T G P O (c, u) s Ic V H). rewrite <- (power_at_corner x L s _ K). now apply M.
Qed.

(* No vertex, wherever a translate of it is, is strictly inside the circle of a cell. *)
Definition circles_empty (T : list torus_cell_2) : Prop := forall c, In c T ->
  exists o r2, (forall s, corner_of_torus s c -> dist2 (spot s) o = r2) /\
  forall s, torus_vertex T (fst s) -> r2 <= dist2 (spot s) o.
(* Nor on it, unless it is a corner of the cell. *)
Definition circles_strictly_empty (T : list torus_cell_2) : Prop := forall c, In c T ->
  exists o r2, (forall s, corner_of_torus s c -> dist2 (spot s) o = r2) /\
  forall s, torus_vertex T (fst s) -> corner_of_torus s c \/ r2 < dist2 (spot s) o.

Theorem torus_delaunay T : covers_once T -> locally_delaunay_2 x L T -> circles_empty T.
Proof.
  intros C D c I. destruct (power_is x L c) as (o & r2 & E); [now apply C|]. exists o, r2. split.
  - intros s H. generalize (E (spot s)). rewrite (power_at_corner x L s c H). unfold dist2. lra.
  - intros s V. generalize (E (spot s)) (power_not_negative T (c, (0, 0)%Z) s C D I V). rewrite instance_zero. unfold dist2. lra.
Qed.

Lemma on_the_circle T k s : covers_once T -> strictly_delaunay_2 x L T -> In (fst k) T -> torus_vertex T (fst s) -> power_of (spot s) (instance k) <= 0 ->
  corner_of_torus s (instance k).
Proof.
  intros C D I V Z. assert (O := degree_one T C). assert (C' := C). destruct C as (G & P & _).
  apply (vertex_is_corner x L box_positive T G P O k s I V).
  assert (Left : forall a b q, rotated (a, b, q) k -> 0 <= turning (spot a) (spot b) (spot s)).
  { intros a b q R. apply Rnot_lt_le. intro N. destruct (neighbour T k a b q G I R) as (k' & p & I' & R').
    assert (A := instance_positive x L T k _ P I R). assert (A' := instance_positive x L T k' _ P I' R').
    assert (B := certified x L (Rlt 0) T k k' a b q p D I I' R R'). assert (F := ratio_across x L a b q p (spot s) A A' N).
    assert (E := power_differs x L a b q p (spot s) A A'). assert (K := power_not_negative T k' s C' (strictly_locally T D) I' V).
    rewrite <- (rotated_power x L _ _ (spot s) R') in K. rewrite <- (rotated_power x L _ _ (spot s) R) in Z. assert (M := Rmult_lt_0_compat _ _ B F).
    lra. }
  destruct (instance k) as ((a, b), q). repeat split; eapply Left; simpl; eauto.
Qed.

Theorem torus_strict T : covers_once T -> strictly_delaunay_2 x L T -> circles_strictly_empty T.
Proof.
  intros C D c I. destruct (power_is x L c) as (o & r2 & E); [now apply C|]. exists o, r2. split.
  - intros s H. generalize (E (spot s)). rewrite (power_at_corner x L s c H). unfold dist2. lra.
  - intros s V. destruct (Rle_dec (power_of (spot s) c) 0) as [Z|Z]; [left|right; generalize (E (spot s)); unfold dist2; lra].
    assert (K := on_the_circle T (c, (0, 0)%Z) s C D I V). rewrite instance_zero in K. now apply K.
Qed.

(* ---- One mesh only ---- *)

(* Each cell is one of the others, in some frame and with some corner first. *)
Definition among (T T' : list torus_cell_2) : Prop := forall c, In c T -> exists c' u, In c' T' /\ In c (rotations_2 (moved_cell_2 u c')).
Definition same_cells (T T' : list torus_cell_2) : Prop := among T T' /\ among T' T.

Lemma power_weights c c' a b q z : 0 < area_of x L c -> 0 < area_of x L c' -> turning a b q * (power_of z c - power_of z c')
  = turning b q z * (power_of a c - power_of a c') + turning q a z * (power_of b c - power_of b c') + turning a b z * (power_of q c - power_of q c').
Proof.
  intros P P'. destruct (power_is x L c P) as (o & r & E), (power_is x L c' P') as (o' & r' & E'). rewrite !E, !E'. unfold d2, turning, turn. ring.
Qed.

Lemma same_triangle (a b q a' b' q' : site_2) : 0 < turning (spot a) (spot b) (spot q) -> 0 < turning (spot a') (spot b') (spot q') ->
  corner_of_torus a' (a, b, q) -> corner_of_torus b' (a, b, q) -> corner_of_torus q' (a, b, q) -> In (a', b', q') (rotations_2 (a, b, q)).
Proof.
  intros P P' [->|[->| ->]] [->|[->| ->]] [->|[->| ->]]; try (simpl; tauto); exfalso; unfold turning, turn in *; lra.
Qed.

Lemma cells_of_other T T' : covers_once T -> strictly_delaunay_2 x L T -> covers_once T' -> locally_delaunay_2 x L T' ->
  (forall v, torus_vertex T v <-> torus_vertex T' v) -> among T' T.
Proof.
  intros C D C' D' V c' I'. destruct c' as ((a', b'), q') eqn:Ec. set (z := centre (spot a') (spot b') (spot q')).
  assert (Pc' : 0 < turning (spot a') (spot b') (spot q')) by exact (proj1 (proj2 C') _ I').
  destruct (centre_strictly _ _ _ Pc') as (W1 & W2 & W3). fold z in W1, W2, W3.
  destruct (torus_covered x L box_positive T (proj1 C) (proj1 (proj2 C)) (degree_one T C) z) as (c & u & I & H). exists c, u. split; [exact I|].
  assert (V' : forall s, corner_of_torus s (a', b', q') -> torus_vertex T (fst s)) by (intros s K; apply V; exists (a', b', q'), s; now repeat split).
  assert (W : forall s, corner_of_torus s (moved_cell_2 u c) -> torus_vertex T' (fst s)).
  { intros s K. apply V. destruct (rotation_at s _ K) as (b0 & q0 & R). destruct (rotation_of_moved u _ c R) as (((s1, b1), q1) & R1 & [=-> -> ->]).
    exists c, s1. split; [exact I|]. split; [|destruct s1 as (v, (i, j)); reflexivity]. rewrite <- (instance_zero c) in R1 |- *.
    now apply (corner_of_rotation _ b1 q1). }
  assert (Up := fun s K => power_not_negative T (c, u) s C (strictly_locally T D) I (V' s K)).
  assert (Down := fun s K => power_not_negative T' ((a', b', q'), (0, 0)%Z) s C' D' I' (W s K)). rewrite instance_zero in Down.
  unfold instance in Up. cbn [fst snd] in Up.
  assert (On : forall s, torus_vertex T (fst s) -> power_of (spot s) (moved_cell_2 u c) <= 0 -> corner_of_torus s (moved_cell_2 u c)) by (intros s;
  now apply (on_the_circle T (c, u))).
  assert (Pc : 0 < area_of x L (moved_cell_2 u c)) by (rewrite area_moved; now apply C).
  destruct (moved_cell_2 u c) as ((a, b), q). assert (Za := power_at_corner x L a (a, b, q)). assert (Zb := power_at_corner x L b (a, b, q)).
  assert (Zq := power_at_corner x L q (a, b, q)). assert (Za' := power_at_corner x L a' (a', b', q')). assert (Zb' := power_at_corner x L b' (a', b', q')).
  assert (Zq' := power_at_corner x L q' (a', b', q')). cbn [corner_of_torus] in *.
  specialize (Za ltac:(tauto)). specialize (Zb ltac:(tauto)). specialize (Zq ltac:(tauto)).
  specialize (Za' ltac:(tauto)). specialize (Zb' ltac:(tauto)). specialize (Zq' ltac:(tauto)).
  assert (E := power_weights (a, b, q) (a', b', q') (spot a') (spot b') (spot q') z Pc Pc').
  assert (E' := power_weights (a, b, q) (a', b', q') (spot a) (spot b) (spot q) z Pc Pc').
  assert (Ua := Up a'). assert (Ub := Up b'). assert (Uq := Up q'). assert (Da := Down a). assert (Db := Down b). assert (Dq := Down q).
  assert (Ka := On a'). assert (Kb := On b'). assert (Kq := On q').
  assert (Va := V' a'). assert (Vb := V' b'). assert (Vq := V' q'). destruct H as (H1 & H2 & H3). change (0 < turning (spot a) (spot b) (spot q)) in Pc.
  specialize (Ua ltac:(tauto)). specialize (Ub ltac:(tauto)). specialize (Uq ltac:(tauto)). specialize (Da ltac:(tauto)).
  specialize (Db ltac:(tauto)). specialize (Dq ltac:(tauto)).
  rewrite Za', Zb', Zq' in E. rewrite Za, Zb, Zq in E'.
  assert (F : power_of z (a, b, q) - power_of z (a', b', q') <= 0) by nra.
  assert (A1 : 0 <= turning (spot b') (spot q') z * power_of (spot a') (a, b, q)) by (apply Rmult_le_pos; lra).
  assert (B1 : 0 <= turning (spot q') (spot a') z * power_of (spot b') (a, b, q)) by (apply Rmult_le_pos; lra).
  assert (Q1 : 0 <= turning (spot a') (spot b') z * power_of (spot q') (a, b, q)) by (apply Rmult_le_pos; lra).
  assert (S : turning (spot a') (spot b') (spot q') * (power_of z (a, b, q) - power_of z (a', b', q')) <= 0) by nra.
  apply same_triangle; trivial; [apply Ka|apply Kb|apply Kq]; try tauto; apply Rnot_lt_le; intro N; nra.
Qed.

Lemma rotated_back r c : In r (rotations_2 c) -> In c (rotations_2 r).
Proof. destruct c as ((a, b), q). intros [<-|[<-|[<-|[]]]]; simpl; tauto. Qed.

Theorem torus_unique T T' : covers_once T -> strictly_delaunay_2 x L T -> covers_once T' -> locally_delaunay_2 x L T' ->
  (forall v, torus_vertex T v <-> torus_vertex T' v) -> same_cells T T'.
Proof.
  intros C D C' D' V. assert (Other := cells_of_other T T' C D C' D' V). split; [|exact Other]. intros c I.
  assert (M := middle_is_inside x L T (proj1 (proj2 C)) (c, (0, 0)%Z) I). set (z := torus_middle x L (instance (c, (0, 0)%Z))) in M.
  destruct (torus_covered x L box_positive T' (proj1 C') (proj1 (proj2 C')) (degree_one T' C') z) as (c' & u & I' & H).
  destruct (Other c' I') as (c1 & u1 & I1 & R1). exists c', u. split; [exact I'|]. assert (R := rotation_moved u _ _ R1). rewrite cell_moved_twice in R.
  set (k := (c1, (fst u + fst u1, snd u + snd u1)%Z)). change (rotated (moved_cell_2 u c') k) in R.
  assert (E := torus_disjoint x L box_positive T (proj1 C) (proj1 (proj2 C)) (degree_one T C) z (c, (0, 0)%Z) k I I1 M (in_rotated x L z _ _ R H)).
  rewrite <- E, instance_zero in R. now apply rotated_back.
Qed.
End placed.

(* One vertex, two cells: of a square lattice, where the circles of both are one circle, and of a lattice of acute triangles. *)
Ltac whole i := first [replace i with (-1)%Z by lia|replace i with 0%Z by lia|replace i with 1%Z by lia|replace i with 2%Z by lia].
Ltac judge_lattice :=
  intros c c' a b q (v, (i, j)) (t, u) I I' R R'; destruct I as [<-|[<-|[]]]; destruct R as [[=<- <- <-]|[[=<- <- <-]|[[=<- <- <-]|[]]]];
  (destruct I' as [<-|[<-|[]]]; destruct R' as [R'|[R'|[R'|[]]]]); cbn in R'; injection R'; intros; try lia;
  whole i; whole j; unfold spot, beyond, incircle, turn, site_at; cbn [fst snd]; lra.
Ltac once_covered :=
  split; [apply square_once|]; split; [intros c [<-|[<-|[]]]; unfold area_of, torus_area, turning, turn; simpl;
  lra|unfold torus_area, turning, turn, det_2; simpl; lra].

Example square_lattice : let x := fun _ : nat => (0, 0) in let L := ((1, 0), (0, 1)) in covers_once x L square_2 /\ locally_delaunay_2 x L square_2.
Proof. cbv zeta. split; [once_covered|judge_lattice]. Qed.

Example acute_lattice : let x := fun _ : nat => (0, 0) in let L := ((2, 0), (-1, 2)) in covers_once x L square_2 /\ strictly_delaunay_2 x L square_2.
Proof. cbv zeta. split; [once_covered|judge_lattice]. Qed.
