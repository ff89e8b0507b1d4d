(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The hypotheses of space_silhouette.v hold somewhere: two tetrahedra with a common facet.

   - two_cells_silhouette   their border falls into two sheets, and the silhouette winds once
   - two_cells_delaunay     they are Delaunay *)
Require Import Reals Lra List Permutation.
From Annulus Require bicell plane_mesh.
From Annulus Require Import vectors space_line space_mesh space_crossings space_delaunay space_silhouette.
Import ListNotations.
Open Scope R_scope.

Definition two_cells : mesh_3 := {|
  cells := [(0, 1, 2, 3); (1, 0, 2, 4)];
  bicells := [(0, 1, 2, 4, 3)];
  outer := [(1, 3, 2, 0); (0, 2, 3, 1); (0, 3, 1, 2); (0, 4, 2, 1); (1, 2, 4, 0); (1, 4, 0, 2)] |}%nat.

Definition places : placement_3 := fun n => nth n [V 0 0 0; V 4 0 0; V 0 4 0; V 1 1 3; V 1 1 (-3)] zero.

Ltac compute_signs := unfold facet_height, orient; coordinates; simpl; lra.

Lemma two_cells_glued : glued_3 two_cells.
Proof.
  exists (flat_map sides (cells two_cells)). split.
  - simpl. repeat (constructor; [constructor|]). constructor.
  - plane_mesh.same_elements.
Qed.

Lemma two_cells_positive : positive_3 places two_cells.
Proof. intros a b c d [E|[E|[]]]; injection E as <- <- <- <-; compute_signs. Qed.

(* From above and from below. *)
Definition upper_sheet : plane_mesh.mesh := {|
  plane_mesh.cells := [(3, 1, 2); (2, 0, 3); (3, 0, 1)];
  plane_mesh.bicells := [(3, 1, 0, 2); (2, 3, 0, 1); (0, 3, 1, 2)];
  plane_mesh.outer := [(0, 1, 3); (1, 2, 3); (2, 0, 3)];
  plane_mesh.border := [0; 1; 2] |}%nat.
Definition lower_sheet : plane_mesh.mesh := {|
  plane_mesh.cells := [(0, 4, 2); (1, 2, 4); (1, 4, 0)];
  plane_mesh.bicells := [(0, 4, 1, 2); (4, 2, 1, 0); (4, 1, 0, 2)];
  plane_mesh.outer := [(0, 1, 4); (1, 2, 4); (2, 0, 4)];
  plane_mesh.border := [0; 1; 2] |}%nat.

Lemma two_cells_ridges : ridges_convex places upper_sheet lower_sheet.
Proof. split; intros a b x y S; simpl in S; repeat destruct S as [S|S]; try contradiction; injection S as <- <- <- <-; compute_signs. Qed.

Theorem two_cells_silhouette : silhouette_once places two_cells upper_sheet lower_sheet.
Proof.
  split.
  - split; plane_mesh.same_elements.
  - split; plane_mesh.same_elements.
  - reflexivity.
  - apply Permutation_refl.
  - intros a b c S. left. simpl in S. repeat destruct S as [S|S]; try contradiction; injection S as <- <- <-; unfold normal_of; coordinates; simpl; lra.
  - intros u v w S. left. left. simpl in S. repeat destruct S as [S|S]; try contradiction; injection S as <- <- <-; unfold normal_of; coordinates; simpl; lra.
  - unfold enters_3, points_up_3. simpl. decide_order.
Qed.

Theorem two_cells_delaunay : delaunay_3 places two_cells.
Proof.
  apply (silhouette_delaunay two_cells places upper_sheet lower_sheet two_cells_glued two_cells_positive two_cells_silhouette two_cells_ridges).
  intros a b c p q [E|[]]. injection E as <- <- <- <- <-. unfold insphere_at, bicell.det, bicell.lambda_b, bicell.lambda_c, bicell.lambda_p, bicell.lambda_q, bicell.rel.
  coordinates. simpl. lra.
Qed.
