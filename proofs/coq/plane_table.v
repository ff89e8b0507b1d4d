(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The cell table in the plane (src/annulus/mesh/corner_table.h) and its flip.

   A corner is a cell and one of three slots; its vertex is a number, or none at infinity. It stands for the edge opposite to it, and its twin is that edge seen from the
   other side. Of the code's arrays those are left out that find a corner of a vertex, and free cells.

   - sound          twins are twins: each edge has two sides, with the same ends
   - flip           Corner_table::flip, line by line; may_flip is what Flip_repair<2>::flip tests before, but for signs
   - flip_sound     it keeps that
   - flip_far       cells other than the two have the vertices they had *)
From Coq Require Import List Arith Permutation Lia.
From Annulus Require Import plane_mesh.
Import ListNotations.

Inductive slot := first | second | third.
Definition corner : Type := nat * slot.
Definition cell_of (h : corner) : nat := fst h.
Definition ccw (h : corner) : corner := (fst h, match snd h with first => second | second => third | third => first end).
Definition cw (h : corner) : corner := (fst h, match snd h with first => third | second => first | third => second end).
Definition same_corner (h k : corner) : {h = k} + {h <> k}.
Proof. decide equality; decide equality. Defined.

Record table := { vertex : corner -> option nat; twin : corner -> corner; is_cell : nat -> bool }.

Definition sound (t : table) : Prop := forall h, is_cell t (cell_of h) = true ->
  is_cell t (cell_of (twin t h)) = true /\ twin t (twin t h) = h /\ twin t h <> h /\ vertex t (ccw (twin t h)) = vertex t (cw h).

Definition put {A} (f : corner -> A) (h : corner) (a : A) : corner -> A := fun k => if same_corner k h then a else f k.
Definition set_adjacency (h k : corner) (f : corner -> corner) : corner -> corner := put (put f h k) k h.
Definition flip (t : table) (h : corner) : table :=
  let k := twin t h in
  let h_side := twin t (ccw h) in
  let k_side := twin t (ccw k) in
  {| vertex := put (put (vertex t) (cw h) (vertex t k)) (cw k) (vertex t h);
     twin := set_adjacency (ccw h) (ccw k) (set_adjacency k h_side (set_adjacency h k_side (twin t)));
     is_cell := is_cell t |}.
(* No cell would be beside itself. *)
Definition may_flip (t : table) (h : corner) : Prop := is_cell t (cell_of h) = true /\
  forall k, In k [ccw h; cw h; ccw (twin t h); cw (twin t h)] -> cell_of (twin t k) <> cell_of h /\ cell_of (twin t k) <> cell_of (twin t h).

Lemma three h : ccw h <> h /\ cw h <> h /\ ccw h <> cw h /\ ccw (cw h) = h /\ cw (ccw h) = h /\ ccw (ccw h) = cw h /\ cw (cw h) = ccw h /\
  cell_of (ccw h) = cell_of h /\ cell_of (cw h) = cell_of h.
Proof. destruct h as [c []]; repeat split; intro E; discriminate E. Qed.
Lemma in_cell_of h k : cell_of k = cell_of h -> k = h \/ k = ccw h \/ k = cw h.
Proof. destruct h as [c []], k as [d []]; cbn; intros ->; tauto. Qed.

Section flipping.
Variables (t : table) (h : corner).
Hypothesis S : sound t.
Hypothesis M : may_flip t h.
Let k := twin t h.
Let hs := twin t (ccw h).
Let ks := twin t (ccw k).

Lemma far : cell_of k <> cell_of h /\ (cell_of hs <> cell_of h /\ cell_of hs <> cell_of k) /\ (cell_of ks <> cell_of h /\ cell_of ks <> cell_of k).
Proof.
  destruct M as [C N]. destruct (S h C) as (Ck & B & D & _). fold k in Ck, B, D, N. split; [|split; [apply N; now left|apply N; simpl; tauto]].
  intro E. assert (K : cell_of (twin t k) = cell_of h) by now rewrite B. destruct (in_cell_of h k E) as [F|[F|F]]; [congruence| |].
  - destruct (N (ccw h)) as [F' _]; [simpl; tauto|]. now rewrite <- F in F'.
  - destruct (N (cw h)) as [F' _]; [simpl; tauto|]. now rewrite <- F in F'.
Qed.

Lemma apart : hs <> ks.
Proof.
  destruct far as (A & _). destruct M as [C _]. intro E. destruct (three h) as (_ & _ & _ & _ & _ & _ & _ & Ch & _). destruct (three k) as (_ & _ & _ & _ & _ & _ & _ & Ck & _).
  destruct (S h C) as (C' & _). fold k in C'.
  destruct (S (ccw h)) as (_ & B & _); [now rewrite Ch|]. destruct (S (ccw k)) as (_ & B' & _); [now rewrite Ck|]. fold hs in B. fold ks in B'.
  assert (ccw h = ccw k) by congruence. apply A. congruence.
Qed.

(* What the flip writes. *)
Lemma flipped_vertex c : vertex (flip t h) c = if same_corner c (cw k) then vertex t h else if same_corner c (cw h) then vertex t k else vertex t c.
Proof. reflexivity. Qed.
Lemma flipped_twin c : twin (flip t h) c =
  if same_corner c (ccw k) then ccw h else if same_corner c (ccw h) then ccw k else
  if same_corner c hs then k else if same_corner c k then hs else if same_corner c ks then h else if same_corner c h then ks else twin t c.
Proof. reflexivity. Qed.

Ltac cells_differ := match goal with |- ?x <> ?y => let E := fresh in intro E; apply (f_equal cell_of) in E;
  destruct (three h) as (_ & _ & _ & _ & _ & _ & _ & ? & ?), (three k) as (_ & _ & _ & _ & _ & _ & _ & ? & ?), far as (? & (? & ?) & (? & ?)); congruence end.

Lemma no_other : k <> h /\ ccw k <> h /\ cw k <> h /\ ccw h <> k /\ cw h <> k /\ ccw h <> ccw k /\ cw h <> cw k /\ ccw h <> cw k /\ cw h <> ccw k /\
  hs <> h /\ hs <> ccw h /\ hs <> cw h /\ hs <> k /\ hs <> ccw k /\ hs <> cw k /\ ks <> h /\ ks <> ccw h /\ ks <> cw h /\ ks <> k /\ ks <> ccw k /\ ks <> cw k.
Proof. repeat split; cells_differ. Qed.

Ltac look := repeat (rewrite flipped_vertex || rewrite flipped_twin);
  repeat match goal with |- context [same_corner ?x ?y] => destruct (same_corner x y); try (exfalso; congruence) end; congruence.

Theorem flip_sound : sound (flip t h).
Proof.
  destruct M as [Ch _]. destruct (S h Ch) as (Ck & Bk & Dk & Vk). fold k in Ck, Bk, Dk, Vk.
  destruct (three h) as (H1 & H2 & H3 & H4 & H5 & H6 & H7 & H8 & H9). destruct (three k) as (K1 & K2 & K3 & K4 & K5 & K6 & K7 & K8 & K9).
  destruct (S k Ck) as (_ & _ & _ & Vh). rewrite Bk in Vh.
  destruct (S (ccw h)) as (Chs & Bhs & Dhs & Vhs); [now rewrite H8|]. destruct (S (ccw k)) as (Cks & Bks & Dks & Vks); [now rewrite K8|].
  fold hs in Chs, Bhs, Dhs, Vhs. fold ks in Cks, Bks, Dks, Vks. rewrite H5 in Vhs. rewrite K5 in Vks.
  destruct (S hs Chs) as (_ & _ & _ & Vhs'). destruct (S ks Cks) as (_ & _ & _ & Vks'). rewrite Bhs, H6 in Vhs'. rewrite Bks, K6 in Vks'.
  assert (Ek : twin t h = k) by reflexivity. assert (Ehs : twin t (ccw h) = hs) by reflexivity. assert (Eks : twin t (ccw k) = ks) by reflexivity.
  assert (A := apart). destruct no_other as (N1 & N2 & N3 & N4 & N5 & N6 & N7 & N8 & N9 & N10 & N11 & N12 & N13 & N14 & N15 & N16 & N17 & N18 & N19 & N20 & N21).
  intros c Cc. change (is_cell (flip t h)) with (is_cell t) in *.
  assert (far_hs : ccw hs <> cw h /\ ccw hs <> cw k /\ ccw ks <> cw h /\ ccw ks <> cw k /\ cw hs <> cw h /\ cw hs <> cw k /\ cw ks <> cw h /\ cw ks <> cw k)
    by (destruct (three hs) as (_ & _ & _ & _ & _ & _ & _ & ? & ?), (three ks) as (_ & _ & _ & _ & _ & _ & _ & ? & ?); repeat split; cells_differ).
  destruct far_hs as (P1 & P2 & P3 & P4 & P5 & P6 & P7 & P8).
  destruct (same_corner c (ccw k)) as [->|C1]; [|destruct (same_corner c (ccw h)) as [->|C2]; [|destruct (same_corner c hs) as [->|C3];
    [|destruct (same_corner c k) as [->|C4]; [|destruct (same_corner c ks) as [->|C5]; [|destruct (same_corner c h) as [->|C6]]]]]].
  7: { destruct (S c Cc) as (Cd & Bd & Dd & Vd). remember (twin t c) as d eqn:Ed.
       assert (D : d <> ccw k /\ d <> ccw h /\ d <> hs /\ d <> k /\ d <> ks /\ d <> h) by (repeat split; intro E; rewrite E in Bd; congruence).
       destruct D as (D1 & D2 & D3 & D4 & D5 & D6). destruct (three c) as (_ & _ & _ & X1 & X2 & X3 & X4 & _), (three d) as (_ & _ & _ & Y1 & Y2 & Y3 & Y4 & _).
       assert (E : twin (flip t h) c = d) by look. rewrite E. split; [exact Cd|]. split; [look|]. split; [exact Dd|]. look. }
  - assert (E : twin (flip t h) (ccw k) = ccw h) by look. rewrite E. split; [now rewrite H8|]. split; [look|]. split; [congruence|]. rewrite H6, K5. look.
  - assert (E : twin (flip t h) (ccw h) = ccw k) by look. rewrite E. split; [now rewrite K8|]. split; [look|]. split; [congruence|]. rewrite K6, H5. look.
  - assert (E : twin (flip t h) hs = k) by look. rewrite E. split; [exact Ck|]. split; [look|]. split; [congruence|]. look.
  - assert (E : twin (flip t h) k = hs) by look. rewrite E. split; [exact Chs|]. split; [look|]. split; [congruence|]. look.
  - assert (E : twin (flip t h) ks = h) by look. rewrite E. split; [exact Ch|]. split; [look|]. split; [congruence|]. look.
  - assert (E : twin (flip t h) h = ks) by look. rewrite E. split; [exact Cks|]. split; [look|]. split; [congruence|]. look.
Qed.
Theorem flip_far c : cell_of c <> cell_of h -> cell_of c <> cell_of k -> vertex (flip t h) c = vertex t c.
Proof.
  intros A B. destruct (three h) as (_ & _ & _ & _ & _ & _ & _ & _ & H9), (three k) as (_ & _ & _ & _ & _ & _ & _ & _ & K9).
  rewrite flipped_vertex. destruct (same_corner c (cw k)); [exfalso; congruence|]. destruct (same_corner c (cw h)); [exfalso; congruence|reflexivity].
Qed.
End flipping.
