(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Signs alone do not suffice: docs/theory.md 1.1. Five cells around a vertex, the corners once in their order and once every other one.

   - pentagon_delaunay      in their order all conditions of plane_delaunay hold
   - winding_needed         every other one: all cells are positive, the border turns left, all circles are empty, and the mesh is not Delaunay.
                            So it winds twice, which a comparison of signs alone cannot show *)
Require Import Reals Lra List Permutation Bool Arith.
From Annulus Require Import width_2 plane_mesh plane_heights plane_triangulation plane_delaunay.
Import ListNotations.
Open Scope R_scope.

(* The middle is 5. *)
Definition fan : mesh := {|
  cells := [(5, 0, 1); (5, 1, 2); (5, 2, 3); (5, 3, 4); (5, 4, 0)];
  bicells := [(5, 0, 4, 1); (5, 1, 0, 2); (5, 2, 1, 3); (5, 3, 2, 4); (5, 4, 3, 0)];
  outer := [(0, 1, 5); (1, 2, 5); (2, 3, 5); (3, 4, 5); (4, 0, 5)];
  border := [0; 1; 2; 3; 4] |}%nat.

Definition pentagon : placement := fun v => nth v [(0, 10); (-9, 3); (-6, -8); (6, -8); (9, 3)] (0, 0).
Definition pentagram : placement := fun v => nth v [(0, 10); (-6, -8); (9, 3); (-9, 3); (6, -8)] (0, 0).

Lemma fan_glued : glued fan.
Proof. split; [same_elements|apply Permutation_refl]. Qed.

Ltac each_of_fan H := simpl in H; repeat match type of H with _ \/ _ => destruct H as [H|H] end; try contradiction; injection H; intros; subst.

Lemma pentagon_positive : positive pentagon fan.
Proof. intros a b c H. each_of_fan H; unfold turn_at, turning, turn; simpl; lra. Qed.

Lemma pentagon_convex : convex pentagon (border fan).
Proof. intros a b c H. each_of_fan H; left; unfold turn_at, turning, turn; simpl; lra. Qed.

Lemma pentagon_circles a b p q : In (a, b, p, q) (bicells fan) -> 0 < incircle_at pentagon a b p q.
Proof. intro H. each_of_fan H; unfold incircle_at, incircle, turn; simpl; lra. Qed.

Ltac decide_up := unfold points_up; simpl; repeat match goal with
  | |- context [Rlt_dec ?x ?y] => destruct (Rlt_dec x y); try (exfalso; lra)
  | |- context [Req_EM_T ?x ?y] => destruct (Req_EM_T x y); try (exfalso; lra) end; reflexivity.

Lemma pentagon_once : winds_once pentagon (border fan).
Proof.
  unfold winds_once, ridges, enters. simpl.
  replace (points_up (pentagon 0%nat) (pentagon 1%nat)) with false by decide_up.
  replace (points_up (pentagon 1%nat) (pentagon 2%nat)) with false by decide_up.
  replace (points_up (pentagon 2%nat) (pentagon 3%nat)) with true by decide_up.
  replace (points_up (pentagon 3%nat) (pentagon 4%nat)) with true by decide_up.
  replace (points_up (pentagon 4%nat) (pentagon 0%nat)) with true by decide_up. reflexivity.
Qed.

Theorem pentagon_delaunay : glued fan /\ triangulation pentagon fan /\ delaunay pentagon fan.
Proof.
  split; [exact fan_glued|]. split.
  - exact (plane_triangulation fan pentagon fan_glued pentagon_positive pentagon_convex pentagon_once).
  - apply (plane_delaunay fan pentagon fan_glued pentagon_positive pentagon_convex pentagon_once).
    intros a b p q H. apply Rlt_le. now apply pentagon_circles.
Qed.

Theorem winding_needed : positive pentagram fan /\ convex pentagram (border fan) /\
  (forall a b p q, In (a, b, p, q) (bicells fan) -> 0 < incircle_at pentagram a b p q) /\ ~ delaunay pentagram fan /\ ~ triangulation pentagram fan.
Proof.
  repeat split.
  - intros a b c H. each_of_fan H; unfold turn_at, turning, turn; simpl; lra.
  - intros a b c H. each_of_fan H; left; unfold turn_at, turning, turn; simpl; lra.
  - intros a b p q H. each_of_fan H; unfold incircle_at, incircle, turn; simpl; lra.
  - (* 3 is inside the circle of 5, 0, 1 *)
    intro D. destruct (D 5%nat 0%nat 1%nat) as ([x y] & r2 & A & B & C & E); [now left|].
    specialize (E 3%nat). unfold dist2, d2 in *. simpl in *.
    assert (V : vertex_of fan 3%nat) by (exists (5, 2, 3)%nat; simpl; tauto). specialize (E V). lra.
  - (* a point near the middle is in two cells *)
    intro G. apply (disjoint _ _ G (5, 0, 1)%nat [(5, 1, 2); (5, 2, 3); (5, 3, 4); (5, 4, 0)]%nat (5, 2, 3)%nat (-1, 1)).
    + apply Permutation_refl.
    + simpl. tauto.
    + unfold inside_cell, strictly_in, turning, turn. simpl. repeat split; lra.
    + unfold in_cell, within, turning, turn. simpl. repeat split; lra.
Qed.
