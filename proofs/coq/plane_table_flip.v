(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A flip of two finite cells of the cell table: the mesh stays glued, and its border is what it was.

   - good_table     what a table is between two calls: twins are twins, infinite cells are simple, one walk meets all of them
   - good_glued     such a table is a glued mesh
   - flip_vertices  no flip loses a vertex, at the border neither, where the table is good after it
   - inner_flip     a flip inside keeps all of it, the border and the vertices: `changed inside` of plane_calls.v *)
From Coq Require Import List Arith Permutation Lia Bool.
From Annulus Require Import plane_mesh plane_table plane_table_glued.
Import ListNotations.

Record good_table (t : table) (all rim : list nat) : Prop := {
  twins : sound t;
  all_once : NoDup all;
  all_there : forall c, In c all <-> is_cell t c = true;
  infinite_simple : forall h, is_cell t (cell_of h) = true -> vertex t h = None ->
    vertex t (ccw h) <> None /\ vertex t (cw h) <> None /\ is_finite t (cell_of (twin t h)) = true;
  walk_once : NoDup rim;
  walk_all : forall c, In c rim <-> is_cell t c = true /\ is_finite t c = false;
  walk_on : forall c d, In (c, d) (ring rim) -> at_infinity t d = ccw (twin t (ccw (at_infinity t c))) }.

Theorem good_glued t all rim : good_table t all rim -> glued (mesh_of_table t all rim).
Proof. intros [A B C D E F G]. now apply table_glued. Qed.

(* ---- Vertices ---- *)

Definition in_table (t : table) (v : nat) : Prop := exists x, is_cell t (cell_of x) = true /\ vertex t x = Some v.

Lemma table_vertices t all rim v : good_table t all rim -> vertex_of (mesh_of_table t all rim) v <-> in_table t v.
Proof.
  intro G. assert (C : forall x, is_cell t (cell_of x) = true -> is_finite t (cell_of x) = true -> vertex t x = Some v ->
    vertex_of (mesh_of_table t all rim) v).
  { intros x Cx F V. exists (triangle t (cell_of x)). split.
    - apply in_map, filter_In. split; [now apply (all_there _ _ _ G)|exact F].
    - destruct x as [c []]; cbn [triangle plane_mesh.corner]; unfold number; cbn [cell_of fst] in *; rewrite V; tauto. }
  split.
  - intros (k & I & K). apply in_map_iff in I. destruct I as (c & <- & I). apply filter_In in I. destruct I as [I F]. apply (all_there _ _ _ G) in I.
    assert (N : forall x, cell_of x = c -> v = number t x -> in_table t v).
    { intros x <- ->. exists x. split; [exact I|]. assert (A := finite_vertex t x F). unfold number. destruct (vertex t x); [reflexivity|contradiction]. }
    destruct K as [K|[K|K]]; exact (N (c, _) eq_refl K).
  - intros (x & I & V). destruct (is_finite t (cell_of x)) eqn:F; [now apply (C x)|].
    (* the other cell of the edge that an infinite cell has is finite *)
    destruct (infinite_corner t _ F) as [E Vi]. set (i := at_infinity t (cell_of x)) in *. assert (Ci : is_cell t (cell_of i) = true) by now rewrite E.
    destruct (infinite_simple _ _ _ G i Ci Vi) as (_ & _ & Fk). destruct (twins _ _ _ G i Ci) as (Ck & Bk & _ & Vk).
    destruct (twins _ _ _ G _ Ck) as (_ & _ & _ & Vk'). rewrite Bk in Vk'.
    destruct (three (twin t i)) as (_ & _ & _ & _ & _ & _ & _ & K8 & K9).
    destruct (in_cell_of i x (eq_sym E)) as [D|[D|D]]; rewrite D in V; [congruence| |].
    + apply (C (cw (twin t i))); [now rewrite K9|now rewrite K9|congruence].
    + apply (C (ccw (twin t i))); [now rewrite K8|now rewrite K8|congruence].
Qed.

Theorem flip_vertices t h all rim rim' : good_table t all rim -> may_flip t h -> good_table (flip t h) all rim' ->
  forall v, vertex_of (mesh_of_table (flip t h) all rim') v <-> vertex_of (mesh_of_table t all rim) v.
Proof.
  intros G M G' v. rewrite (table_vertices _ _ _ _ G), (table_vertices _ _ _ _ G'). unfold in_table. change (is_cell (flip t h)) with (is_cell t).
  assert (Ch := proj1 M). destruct (twins _ _ _ G h Ch) as (Ck & Bk & _ & Vk). destruct (twins _ _ _ G _ Ck) as (_ & _ & _ & Vh). rewrite Bk in Vh.
  set (k := twin t h) in *. destruct (three h) as (_ & _ & H3 & _ & _ & _ & _ & H8 & _), (three k) as (_ & _ & K3 & _ & _ & _ & _ & K8 & _).
  destruct (far t h (twins _ _ _ G) M) as (A & _). fold k in A.
  split; intros (x & C & V).
  - rewrite flipped_vertex in V. fold k in V. destruct (same_corner x (cw k)); [now exists h|]. destruct (same_corner x (cw h)); [now exists k|now exists x].
  - destruct (same_corner x (cw k)) as [->|N]; [|destruct (same_corner x (cw h)) as [->|N']].
    + exists (ccw h). split; [now rewrite H8|]. rewrite flipped_vertex. fold k. destruct (same_corner _ (cw k)) as [E|_].
      * exfalso. apply (f_equal cell_of) in E. destruct (three k) as (_ & _ & _ & _ & _ & _ & _ & _ & K9). congruence.
      * destruct (same_corner _ _); [contradiction|congruence].
    + exists (ccw k). split; [now rewrite K8|]. rewrite flipped_vertex. fold k. destruct (same_corner _ _); [contradiction|]. destruct (same_corner _ (cw h)) as [E|_].
      * exfalso. apply (f_equal cell_of) in E. destruct (three h) as (_ & _ & _ & _ & _ & _ & _ & _ & H9). congruence.
      * congruence.
    + exists x. split; [exact C|]. rewrite flipped_vertex. fold k. destruct (same_corner _ _); [contradiction|]. now destruct (same_corner _ _).
Qed.

Lemma finite_iff t c : is_finite t c = true <-> forall x, cell_of x = c -> vertex t x <> None.
Proof.
  split.
  - intros F x <-. now apply finite_vertex.
  - intro V. unfold is_finite, corners_of. cbn [forallb].
    assert (A := V (c, first) eq_refl). assert (B := V (c, second) eq_refl). assert (C := V (c, third) eq_refl).
    destruct (vertex t (c, first)), (vertex t (c, second)), (vertex t (c, third)); trivial; contradiction.
Qed.

Section inside.
Variables (t : table) (all rim : list nat) (h : plane_table.corner).
Hypothesis G : good_table t all rim.
Hypothesis M : may_flip t h.
Let k := twin t h.
Hypothesis finite_h : is_finite t (cell_of h) = true.
Hypothesis finite_k : is_finite t (cell_of k) = true.

Lemma some_vertex x : vertex t x <> None -> vertex (flip t h) x <> None.
Proof.
  intro V. rewrite flipped_vertex. assert (A := finite_vertex t h finite_h). assert (B := finite_vertex t k finite_k).
  destruct (same_corner _ _); [exact A|]. now destruct (same_corner _ _).
Qed.

Lemma finite_kept c : is_finite (flip t h) c = is_finite t c.
Proof.
  apply eq_true_iff_eq. rewrite !finite_iff. split; intros F x X; [|now apply some_vertex, F].
  destruct (Nat.eq_dec c (cell_of h)) as [Eh|Eh]; [apply finite_vertex; now rewrite X, Eh|].
  destruct (Nat.eq_dec c (cell_of k)) as [Ek|Ek]; [apply finite_vertex; now rewrite X, Ek|].
  rewrite <- (flip_far t h x); [now apply F|congruence|unfold k in Ek; congruence].
Qed.

(* A cell with infinity is neither of the two. *)
Lemma infinite_far c : is_finite t c = false -> c <> cell_of h /\ c <> cell_of k.
Proof. intro F. split; intros ->; congruence. Qed.

Lemma vertex_kept x : is_finite t (cell_of x) = false -> vertex (flip t h) x = vertex t x.
Proof. intro F. destruct (infinite_far _ F) as [A B]. apply flip_far; trivial. Qed.

Lemma at_infinity_kept c : is_finite t c = false -> at_infinity (flip t h) c = at_infinity t c.
Proof. intro F. unfold at_infinity. now rewrite !vertex_kept by exact F. Qed.

(* The vertex across an edge of a cell with infinity, if infinity is an end of the edge, stays there. *)
Lemma twin_kept x : is_cell t (cell_of x) = true -> is_finite t (cell_of x) = false -> is_finite t (cell_of (twin t x)) = false -> twin (flip t h) x = twin t x.
Proof.
  intros C F F'. destruct (infinite_far _ F) as [A B], (infinite_far _ F') as [A' B'].
  destruct (three h) as (_ & _ & _ & _ & _ & _ & _ & H8 & _), (three k) as (_ & _ & _ & _ & _ & _ & _ & K8 & _).
  assert (Ch := proj1 M). destruct (twins _ _ _ G h Ch) as (Ck & _). fold k in Ck.
  destruct (twins _ _ _ G (ccw h)) as (_ & Bh & _); [now rewrite H8|]. destruct (twins _ _ _ G (ccw k)) as (_ & Bk & _); [now rewrite K8|].
  assert (N : x <> ccw k /\ x <> ccw h /\ x <> twin t (ccw h) /\ x <> k /\ x <> twin t (ccw k) /\ x <> h).
  { repeat split; intros ->; congruence. }
  destruct N as (N1 & N2 & N3 & N4 & N5 & N6). rewrite flipped_twin. fold k.
  repeat match goal with |- context [same_corner x ?y] => destruct (same_corner x y); [contradiction|] end. reflexivity.
Qed.

(* What is across from a finite edge at infinity is finite, still. *)
Lemma twin_finite x : is_finite t (cell_of (twin t x)) = true -> is_finite t (cell_of (twin (flip t h) x)) = true \/ cell_of x = cell_of h \/ cell_of x = cell_of k.
Proof.
  intro F. destruct (three h) as (_ & _ & _ & _ & _ & _ & _ & H8 & _), (three k) as (_ & _ & _ & _ & _ & _ & _ & K8 & _).
  rewrite flipped_twin. fold k. repeat match goal with |- context [same_corner x ?y] => destruct (same_corner x y) as [->|] end; rewrite ?H8, ?K8; tauto.
Qed.

Lemma walks c d : In (c, d) (ring rim) -> is_cell t c = true /\ is_finite t c = false /\ is_cell t d = true /\ is_finite t d = false.
Proof.
  intro I. unfold ring in I. apply plane_paths.steps_in in I.
  assert (Q : forall x, In x (rim ++ firstn 1 rim) -> is_cell t x = true /\ is_finite t x = false).
  { intros x X. apply (walk_all _ _ _ G). apply in_app_or in X. destruct X as [X|X]; [exact X|]. rewrite <- (firstn_skipn 1). apply in_or_app. now left. }
  destruct I as [A B]. apply Q in A, B. tauto.
Qed.

Lemma inner_good : good_table (flip t h) all rim.
Proof.
  split.
  - apply flip_sound; [exact (twins _ _ _ G)|exact M].
  - exact (all_once _ _ _ G).
  - exact (all_there _ _ _ G).
  - change (is_cell (flip t h)) with (is_cell t). intros x C V. assert (F : is_finite t (cell_of x) = false).
    { destruct (is_finite t (cell_of x)) eqn:F; [exfalso|reflexivity]. apply finite_iff with (x := x) in F; [|reflexivity]. now apply (some_vertex x F). }
    rewrite finite_kept. rewrite vertex_kept in V by exact F. destruct (three x) as (_ & _ & _ & _ & _ & _ & _ & X8 & X9).
    rewrite !vertex_kept by now rewrite ?X8, ?X9. destruct (infinite_simple _ _ _ G x C V) as (A & B & D). repeat split; trivial.
    destruct (infinite_far _ F). destruct (twin_finite x D) as [E|[E|E]]; [exact E|contradiction|contradiction].
  - exact (walk_once _ _ _ G).
  - intro c. rewrite finite_kept. exact (walk_all _ _ _ G c).
  - intros c d I. destruct (walks c d I) as (C & F & D & F'). rewrite !at_infinity_kept by assumption. rewrite (walk_on _ _ _ G c d I). f_equal.
    destruct (infinite_corner t c F) as [E _]. destruct (infinite_corner t d F') as [E' _].
    destruct (three (at_infinity t c)) as (_ & _ & _ & _ & _ & _ & _ & X8 & _). symmetry. apply twin_kept.
    + now rewrite X8, E.
    + now rewrite X8, E.
    + assert (W := f_equal cell_of (walk_on _ _ _ G c d I)). destruct (three (twin t (ccw (at_infinity t c)))) as (_ & _ & _ & _ & _ & _ & _ & Y8 & _).
      rewrite Y8, E' in W. now rewrite <- W.
Qed.

Theorem inner_flip : good_table (flip t h) all rim /\ border (mesh_of_table (flip t h) all rim) = border (mesh_of_table t all rim) /\
  forall v, vertex_of (mesh_of_table (flip t h) all rim) v <-> vertex_of (mesh_of_table t all rim) v.
Proof.
  split; [exact inner_good|]. split; [|exact (flip_vertices t h all rim rim G M inner_good)].
  unfold mesh_of_table. cbn [border]. f_equal. apply map_ext_in. intros c I. apply (walk_all _ _ _ G) in I. destruct I as [C F].
  rewrite at_infinity_kept by exact F. unfold number. rewrite vertex_kept; [reflexivity|].
  destruct (infinite_corner t c F) as [E _], (three (at_infinity t c)) as (_ & _ & _ & _ & _ & _ & _ & X8 & _). now rewrite X8, E.
Qed.
End inside.
