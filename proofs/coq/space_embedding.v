(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 1 of docs/theory.md 1.2 in space. Positive cells, glued along their facets; no vertex beyond a border facet; and some point in one cell only.

   - disjoint_3   then a point strictly inside a cell is in no other
   - cover_3      and what is strictly on the inner side of every border facet is in a cell

   That signs and the winding of the border's silhouette imply the last two of these hypotheses (lemma 3) is proved in docs/theory.md, and not here. *)
Require Import Reals Lra Psatz List Permutation.
From Annulus Require Import tetrahedron sums small general_position space_line space_mesh space_crossings.
Import ListNotations.
Open Scope R_scope.

Section placed.
Variables (T : mesh_3) (m : placement_3).
Hypothesis gluing : glued_3 T.
Hypothesis cells_positive : positive_3 m T.
Hypothesis border_convex : forall s v, In s (outer T) -> is_vertex T v -> 0 <= facet_height m s (m v).
Hypothesis once : exists x t rest, Permutation (cells T) (t :: rest) /\ inside_3 m x t /\ forall r, In r rest -> ~ in_cell_3 m x r.

Lemma inside_bary x t : inside_3 m x t <-> all_positive (bary m t x).
Proof.
  split; [intros H i; apply H, side_in|]. intros H s I. destruct (in_sides s t I) as (i & ->). apply H.
Qed.

Lemma in_bary x t : in_cell_3 m x t <-> forall i, 0 <= bary m t x i.
Proof.
  split; [intros H i; apply H, side_in|]. intros H s I. destruct (in_sides s t I) as (i & ->). apply H.
Qed.

Lemma outside_bary x t : ~ in_cell_3 m x t -> exists i, bary m t x i < 0.
Proof.
  rewrite in_bary. intro N. destruct (Rlt_dec (bary m t x o) 0); [now exists o|]. destruct (Rlt_dec (bary m t x u) 0); [now exists u|].
  destruct (Rlt_dec (bary m t x v) 0); [now exists v|]. destruct (Rlt_dec (bary m t x w) 0); [now exists w|].
  exfalso. apply N. intros []; lra.
Qed.

Definition centre_3 (t : four) : vec := let '(a, b, c, d) := t in / 4 ⊙ (m a ⊕ m b ⊕ m c ⊕ m d).

Lemma centre_inside t : In t (cells T) -> all_positive (bary m t (centre_3 t)).
Proof.
  intros I i. generalize (size_pos T m cells_positive t I). destruct t as [[[a b] c] d]. unfold bary, facet_height, size, centre_3.
  assert (E : forall p q r, orient p q r (/ 4 ⊙ (m a ⊕ m b ⊕ m c ⊕ m d)) = (orient p q r (m a) + orient p q r (m b) + orient p q r (m c) + orient p q r (m d)) / 4).
  { intros. unfold orient. coordinates. field. }
  destruct i; cbn [side_of]; rewrite E; unfold orient; coordinates; lra.
Qed.

Lemma corner_vertex t i : In t (cells T) -> is_vertex T (point_of t i).
Proof. intro I. exists t. split; [exact I|]. destruct t as [[[a b] c] d], i; simpl; tauto. Qed.

Lemma inside_inner x t : In t (cells T) -> all_positive (bary m t x) -> inner T m x.
Proof.
  intros I P s S. assert (A := height_affine m s). assert (V := size_pos T m cells_positive t I).
  assert (N := fun i => border_convex s _ S (corner_vertex t i I)).
  assert (K := affine_bary m _ t x A).
  assert (L : 0 <= facet_height m s x).
  { apply (Rmult_le_reg_l (size m t)); [exact V|]. rewrite Rmult_0_r, K. repeat apply Rplus_le_le_0_compat; (apply Rmult_le_pos; [apply Rlt_le, P|apply N]). }
  destruct L as [L|L]; [exact L|exfalso]. rewrite <- L, Rmult_0_r in K.
  assert (M := fun i => Rmult_le_pos _ _ (Rlt_le _ _ (P i)) (N i)).
  assert (Z : forall i, facet_height m s (m (point_of t i)) = 0).
  { intro i. generalize (M o) (M u) (M v) (M w). intros. assert (Q : bary m t x i * facet_height m s (m (point_of t i)) = 0) by (destruct i; lra).
    apply Rmult_integral in Q. destruct Q as [Q|Q]; [generalize (P i); lra|exact Q]. }
  (* the height would be 0 everywhere, also at the fourth corner of its own cell *)
  assert (Zero : forall y, facet_height m s y = 0).
  { intro y. apply (Rmult_eq_reg_l (size m t)); [|lra]. rewrite (affine_bary m _ t y A), !Z. ring. }
  destruct (outer_cell s S) as (p & r & Ir & i & ->). generalize (centre_inside r Ir i). unfold bary. rewrite Zero. lra.
Qed.
End placed.
