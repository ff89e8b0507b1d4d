(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The hypotheses of space_delaunay.v hold somewhere: two tetrahedra with a common facet.

   - two_cells_delaunay   they are Delaunay *)
Require Import Reals Lra List Permutation.
From Annulus Require bicell.
From Annulus Require Import vectors space_line space_mesh space_crossings space_embedding space_delaunay.
Import ListNotations.
Open Scope R_scope.

Definition two_cells : mesh_3 := {|
  cells := [(0, 1, 2, 3); (1, 0, 2, 4)];
  bicells := [(0, 1, 2, 4, 3)];
  outer := [(1, 3, 2, 0); (0, 2, 3, 1); (0, 3, 1, 2); (0, 4, 2, 1); (1, 2, 4, 0); (1, 4, 0, 2)] |}%nat.

Definition places : placement_3 := fun n => nth n [V 0 0 0; V 4 0 0; V 0 4 0; V 1 1 3; V 1 1 (-3)] zero.

Ltac each_of S := simpl in S; repeat match type of S with _ \/ _ => destruct S as [<-|S] end; try contradiction.
Ltac compute_signs := unfold facet_height, orient; coordinates; simpl; lra.

Lemma two_cells_glued : glued_3 two_cells.
Proof.
  exists (flat_map sides (cells two_cells)). split.
  - simpl. repeat (constructor; [constructor|]). constructor.
  - apply NoDup_Permutation_bis; [|apply le_n|].
    + repeat (constructor; [simpl; intuition congruence|]). constructor.
    + intros s. simpl. tauto.
Qed.

Lemma two_cells_positive : positive_3 places two_cells.
Proof. intros a b c d [E|[E|[]]]; injection E as <- <- <- <-; compute_signs. Qed.

Lemma two_cells_convex s n : In s (outer two_cells) -> is_vertex two_cells n -> 0 <= facet_height places s (places n).
Proof.
  intros S (t & I & C).
  assert (N : (n = 0 \/ n = 1 \/ n = 2 \/ n = 3 \/ n = 4)%nat) by (destruct I as [<-|[<-|[]]]; simpl in C; tauto). clear I C.
  each_of S; destruct N as [->|[->|[->|[->| ->]]]]; compute_signs.
Qed.

Lemma two_cells_once : exists x t rest, Permutation (cells two_cells) (t :: rest) /\ inside_3 places x t /\
  forall r, In r rest -> ~ in_cell_3 places x r.
Proof.
  exists (V 1 1 1), (0, 1, 2, 3)%nat, [(1, 0, 2, 4)%nat]. split; [apply Permutation_refl|]. split.
  - intros s S. each_of S; compute_signs.
  - intros r [<-|[]] H. assert (K : 0 <= facet_height places (1, 0, 2, 4)%nat (V 1 1 1)) by (apply H; simpl; tauto).
    revert K. apply Rlt_not_le. compute_signs.
Qed.

Theorem two_cells_delaunay : delaunay_3 places two_cells.
Proof.
  apply (space_delaunay two_cells places two_cells_glued two_cells_positive two_cells_convex two_cells_once).
  intros a b c p q [E|[]]. injection E as <- <- <- <- <-. unfold insphere_at, bicell.det, bicell.lambda_b, bicell.lambda_c, bicell.lambda_p, bicell.lambda_q, bicell.rel.
  coordinates. simpl. lra.
Qed.
