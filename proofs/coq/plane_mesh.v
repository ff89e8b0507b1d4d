(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Meshes of the plane and what the program certifies of them: docs/theory.md 1.1 and 1.2. Definitions only.

   A mesh has no positions: vertices are numbers, cells are triples of them. A placement gives each vertex its point.

   - glued           each side of each cell is a side of one bi-cell or of the border, which is one closed path
   - positive, convex, winds_once, locally_delaunay     the conditions (a) to (d) of 1.2; (b) and (d) accept 0
   - triangulation   what follows from (a), (b), (c): the cells cover the convex hull of the vertices once, and meet in the hull of common corners
   - delaunay        what follows with (d): no vertex is strictly inside the circle through the corners of a cell *)
Require Import Reals List Permutation Bool.
From Annulus Require Export points_2.
From Annulus Require Import width_2.
Import ListNotations.
Open Scope R_scope.

(* ---- Combinatorics ---- *)

(* cells     a, b, c counterclockwise
   bicells   a, b, p, q for the cells a b q and b a p: q is on the left of ab and p on the right
   outer     sides of cells on the border: a, b, c for the side ab of the cell a b c
   border    its vertices in order, the mesh on the left *)
Record mesh := Mesh {
  cells : list (nat * nat * nat);
  bicells : list (nat * nat * nat * nat);
  outer : list (nat * nat * nat);
  border : list nat }.

(* The sides of a cell, each with the corner opposite to it. *)
Definition sides (t : nat * nat * nat) : list (nat * nat * nat) := let '(a, b, c) := t in [(a, b, c); (b, c, a); (c, a, b)].
Definition shared_sides (k : nat * nat * nat * nat) : list (nat * nat * nat) := let '(a, b, p, q) := k in [(a, b, q); (b, a, p)].
Definition edge (s : nat * nat * nat) : nat * nat := let '(a, b, _) := s in (a, b).

(* Pairs and triples of consecutive elements. *)
Fixpoint steps (l : list nat) : list (nat * nat) := match l with u :: ((v :: _) as l') => (u, v) :: steps l' | _ => [] end.
Fixpoint bends (l : list nat) : list (nat * nat * nat) := match l with u :: ((v :: w :: _) as l') => (u, v, w) :: bends l' | _ => [] end.
(* The same where the last is followed by the first. *)
Definition ring (l : list nat) := steps (l ++ firstn 1 l).
Definition ridges (l : list nat) := bends (l ++ firstn 2 l).

Definition glued (T : mesh) : Prop :=
  Permutation (flat_map sides (cells T)) (flat_map shared_sides (bicells T) ++ outer T) /\
  Permutation (map edge (outer T)) (ring (border T)).

(* Two lists that are written out have the same elements, none of them twice. *)
Ltac is_among := first [left; reflexivity|right; is_among].
Ltac all_different := let H := fresh in repeat (constructor; [intro H; repeat (destruct H as [H|H]; [discriminate|]); exact H|]); constructor.
Ltac same_elements := let s := fresh in let H := fresh in apply NoDup_Permutation_bis; [simpl; all_different|apply le_n|
  intros s H; simpl in H; repeat (destruct H as [H|H]; [subst s; simpl; is_among|]); destruct H].

Definition corner (v : nat) (t : nat * nat * nat) : Prop := let '(a, b, c) := t in v = a \/ v = b \/ v = c.
Definition vertex_of (T : mesh) (v : nat) : Prop := exists t, In t (cells T) /\ corner v t.

(* ---- Geometry ---- *)

Definition placement : Type := nat -> point_2.

Definition dist2 (u v : point_2) : R := d2 (fst u) (snd u) (fst v) (snd v).
Definition vector (u v : point_2) : point_2 := (fst v - fst u, snd v - snd u).
Definition cross (e f : point_2) : R := fst e * snd f - snd e * fst f.
Definition dot (e f : point_2) : R := fst e * fst f + snd e * snd f.

Definition positive (m : placement) (T : mesh) : Prop := forall a b c, In (a, b, c) (cells T) -> 0 < turn_at m a b c.

(* Left, or straight on: no fold. *)
Definition convex_at (m : placement) u v w : Prop :=
  0 < turn_at m u v w \/ (turn_at m u v w = 0 /\ 0 < dot (vector (m u) (m v)) (vector (m v) (m w))).
Definition convex (m : placement) (l : list nat) : Prop := forall u v w, In (u, v, w) (ridges l) -> convex_at m u v w.

(* border_winds_once of the code: how often the direction of the border enters the half-plane of what points up, or right when level. *)
Definition points_up (u v : point_2) : bool :=
  if Rlt_dec (snd u) (snd v) then true else if Req_EM_T (snd u) (snd v) then if Rlt_dec (fst u) (fst v) then true else false else false.
Definition enters (m : placement) (r : nat * nat * nat) : bool :=
  let '(u, v, w) := r in negb (points_up (m u) (m v)) && points_up (m v) (m w).
Definition winds_once (m : placement) (l : list nat) : Prop := length (filter (enters m) (ridges l)) = 1%nat.

Definition locally_delaunay (m : placement) (T : mesh) : Prop := forall a b p q, In (a, b, p, q) (bicells T) -> 0 <= incircle_at m a b p q.

(* ---- What follows ---- *)

Definition within (x a b c : point_2) : Prop := 0 <= turning a b x /\ 0 <= turning b c x /\ 0 <= turning c a x.
Definition strictly_in (x a b c : point_2) : Prop := 0 < turning a b x /\ 0 < turning b c x /\ 0 < turning c a x.
Definition in_cell (m : placement) (x : point_2) (t : nat * nat * nat) : Prop := let '(a, b, c) := t in within x (m a) (m b) (m c).
Definition inside_cell (m : placement) (x : point_2) (t : nat * nat * nat) : Prop := let '(a, b, c) := t in strictly_in x (m a) (m b) (m c).

(* The point that divides xy as e to 1 - e. *)
Definition mix (e : R) (x y : point_2) : point_2 := ((1 - e) * fst x + e * fst y, (1 - e) * snd x + e * snd y).
Definition convex_set (C : point_2 -> Prop) : Prop := forall e x y, 0 <= e <= 1 -> C x -> C y -> C (mix e x y).
Definition in_hull (m : placement) (vertex : nat -> Prop) (x : point_2) : Prop :=
  forall C, convex_set C -> (forall v, vertex v -> C (m v)) -> C x.

Record triangulation (m : placement) (T : mesh) : Prop := {
  disjoint : forall t rest u x, Permutation (cells T) (t :: rest) -> In u rest -> inside_cell m x t -> ~ in_cell m x u;
  covering : forall x, in_hull m (vertex_of T) x <-> exists t, In t (cells T) /\ in_cell m x t;
  face_to_face : forall t u x, In t (cells T) -> In u (cells T) -> in_cell m x t -> in_cell m x u -> in_hull m (fun v => corner v t /\ corner v u) x;
  distinct : forall v w, vertex_of T v -> vertex_of T w -> m v = m w -> v = w }.

Definition delaunay (m : placement) (T : mesh) : Prop := forall a b c, In (a, b, c) (cells T) -> exists o r2,
  dist2 (m a) o = r2 /\ dist2 (m b) o = r2 /\ dist2 (m c) o = r2 /\ forall z, vertex_of T z -> r2 <= dist2 (m z) o.
