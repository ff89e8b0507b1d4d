(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Meshes of space: docs/theory.md 1.2. Definitions, and what cancels between neighbours; the plane has plane_mesh.v and plane_crossings.v.

   - glued_3     each side of each cell is a side of one bi-cell or of the border
   - by_facets   a sum over cells is one over bi-cells and the border

   A side is a cell written with a facet first and the corner opposite to it last; facets may be turned. *)
Require Import Reals Lra List Permutation.
From Annulus Require Import vectors sums.
Import ListNotations.
Open Scope R_scope.

Definition four : Type := nat * nat * nat * nat.

(* cells      a, b, c, d with a positive volume
   bicells    a, b, c, p, q for the cells a b c q and b a c p
   outer      sides of cells on the border *)
Record mesh_3 := Mesh_3 { cells : list four; bicells : list (nat * nat * nat * nat * nat); outer : list four }.

Definition sides (t : four) : list four := let '(a, b, c, d) := t in [(b, d, c, a); (a, c, d, b); (a, d, b, c); (a, b, c, d)].
Definition shared_sides (k : nat * nat * nat * nat * nat) : list four := let '(a, b, c, p, q) := k in [(a, b, c, q); (b, a, c, p)].

Inductive turned : four -> four -> Prop :=
  | turned_0 a b c d : turned (a, b, c, d) (a, b, c, d)
  | turned_1 a b c d : turned (a, b, c, d) (b, c, a, d)
  | turned_2 a b c d : turned (a, b, c, d) (c, a, b, d).

Definition glued_3 (T : mesh_3) : Prop :=
  exists l, Forall2 turned (flat_map sides (cells T)) l /\ Permutation l (flat_map shared_sides (bicells T) ++ outer T).

Definition is_corner (v : nat) (t : four) : Prop := let '(a, b, c, d) := t in v = a \/ v = b \/ v = c \/ v = d.
Definition is_vertex (T : mesh_3) (v : nat) : Prop := exists t, In t (cells T) /\ is_corner v t.

(* Six times the signed volume of a b c d. *)
Definition orient (a b c d : vec) : R := vol (b ⊖ a) (c ⊖ a) (d ⊖ a).

Definition placement_3 : Type := nat -> vec.
Definition positive_3 (m : placement_3) (T : mesh_3) : Prop := forall a b c d, In (a, b, c, d) (cells T) -> 0 < orient (m a) (m b) (m c) (m d).

(* What a facet sees of x: positive on the side of its cell. *)
Definition facet_height (m : placement_3) (s : four) (x : vec) : R := let '(a, b, c, _) := s in orient (m a) (m b) (m c) x.
Definition inside_3 (m : placement_3) (x : vec) (t : four) : Prop := forall s, In s (sides t) -> 0 < facet_height m s x.
Definition in_cell_3 (m : placement_3) (x : vec) (t : four) : Prop := forall s, In s (sides t) -> 0 <= facet_height m s x.

Lemma turned_height m s r x : turned s r -> facet_height m r x = facet_height m s x.
Proof. intros []; unfold facet_height, orient; [reflexivity|vector|vector]. Qed.

Lemma orient_swap a b c x : orient b a c x = - orient a b c x.
Proof. unfold orient. vector. Qed.

(* The same cell written otherwise. *)
Definition same_for_cell (w : four -> R) : Prop := forall a b c d, w (b, c, a, d) = w (a, b, c, d) /\ w (a, c, d, b) = w (a, b, c, d).

Lemma same_for_sides w t s : same_for_cell w -> In s (sides t) -> w s = w t.
Proof.
  intro W. assert (W1 := fun a b c d => proj1 (W a b c d)). assert (W2 := fun a b c d => proj2 (W a b c d)).
  destruct t as [[[a b] c] d]. intros [<-|[<-|[<-|[<-|[]]]]].
  - rewrite (W2 b a d c), (W2 b c a d). apply W1.
  - apply W2.
  - rewrite (W2 a c d b). apply W2.
  - reflexivity.
Qed.

Lemma by_facets T (g : four -> R) (w : four -> R) : glued_3 T -> (forall s r, turned s r -> g r = g s) -> same_for_cell w ->
  (forall a b c p q, g (b, a, c, p) = - g (a, b, c, q)) ->
  sum (fun t => w t * sum g (sides t)) (cells T)
  = sum (fun k => let '(a, b, c, p, q) := k in g (a, b, c, q) * (w (a, b, c, q) - w (b, a, c, p))) (bicells T) + sum (fun s => g s * w s) (outer T).
Proof.
  intros (l & F & P) G W S. transitivity (sum (fun s => g s * w s) (flat_map sides (cells T))).
  - rewrite sum_flat_map. apply sum_ext. intros t _. rewrite <- sum_scale. apply sum_ext. intros s I. rewrite (same_for_sides w t s W I). ring.
  - transitivity (sum (fun s => g s * w s) l).
    + clear P. induction F as [|s r k l H F IH]; [reflexivity|]. rewrite !sum_cons, IH, (G s r H). f_equal. f_equal.
      destruct H as [a b c d|a b c d|a b c d]; [reflexivity|now rewrite (proj1 (W a b c d))|now rewrite (proj1 (W b c a d)), (proj1 (W a b c d))].
    + rewrite (sum_permutation _ _ _ P), sum_app, sum_flat_map. f_equal. apply sum_ext. intros [[[[a b] c] p] q] _. cbn. rewrite (S a b c p q). ring.
Qed.
