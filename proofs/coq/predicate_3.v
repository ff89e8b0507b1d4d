(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The whole filtered predicate in space, as predicate_2.v: whichever stage answers, of finite doubles of the coordinate domain.

   - orientation_3_right, empty_sphere_3_right        there is an answer, and it is right: a sign, 0 included; a tolerance that is at most the half widths
   - orientation_3_certifies, empty_sphere_3_certifies   the certificate holds in every placement in which each point is closer than that to where it
                                                         was; of an empty sphere: while its cells are positive
   - bicell_3_certifies                             with the cells' widths always in it: nothing is required of the cells at the placement *)
From Coq Require Import Reals Lra.
From Coq Require Import Floats.
From Annulus Require Import vectors bicell tetrahedron sign_tolerance_3.
From Annulus Require Import operations bridge filter_2 stages interval_3 exact_3 scaled_3 returned_3 interval_returned_3 exact_returned_3.
Import vectors bicell tetrahedron filter_3.
Close Scope float_scope.
Open Scope R_scope.

Definition orientation_predicate_3 (correctly_rounded : bool) (a b c d : vector_3 machine) : answer float :=
  staged correctly_rounded (orientation_filter_3 machine a b c d true) (orientation_3_interval a b c d) (orientation_3_exact a b c d).
Definition empty_sphere_predicate_3 (correctly_rounded : bool) (a b c p q : vector_3 machine) (use : cells) : answer float :=
  staged correctly_rounded (bicell_filter machine a b c p q true use) (empty_sphere_3_interval a b c p q use) (empty_sphere_3_exact a b c p q use).

Section orientation.
Variable f : corner -> vector_3 machine.     (* what the code is given *)
Hypothesis domain : forall k, coordinates_3 (f k).
Let x : corners := fun k => at_3 (f k).      (* where that is *)
Variable correctly_rounded : bool.
Let answer := orientation_predicate_3 correctly_rounded (f o) (f tetrahedron.u) (f v) (f w).

Theorem orientation_3_right : right_answer answer (volume x) (half_width_simplex x) /\ answer <> refused.
Proof.
  destruct (orientation_3_exact_returned f) as [E N]. apply stages_right; trivial; [|now apply orientation_3_interval_returned].
  generalize (orientation_3_returned f domain). destruct (orientation_filter_3 machine _ _ _ _ true); simpl; tauto.
Qed.

Theorem orientation_3_certifies tolerance (y : corners) : answer = positive tolerance -> (forall k, norm (y k ⊖ x k) < value tolerance) -> 0 < volume y.
Proof.
  intros A Near. destruct orientation_3_right as [R _]. rewrite A in R. destruct R as (_ & P & _ & H). exact (orientation_tolerance x y (value tolerance) P H Near).
Qed.
End orientation.

Section sphere.
Variable f : vertex -> vector_3 machine.
Hypothesis domain : forall k, coordinates_3 (f k).
Let x : placement := fun k => at_3 (f k).
Variable correctly_rounded : bool.
Definition sphere_predicate (use : cells) := empty_sphere_predicate_3 correctly_rounded (f a) (f b) (f c) (f p) (f q) use.

Lemma right_weaker r det' w : right_answer r det' w -> right_answer r det' (Rmax 0 w).
Proof. destruct r; simpl; trivial. intros (F & P & L & U). repeat split; trivial. apply Rle_trans with (1 := U), Rmax_r. Qed.

Theorem empty_sphere_3_right use : right_answer (sphere_predicate use) (det x) (Rmax 0 (certified_width use x)) /\ sphere_predicate use <> refused.
Proof.
  destruct (empty_sphere_3_exact_returned f use) as [E N]. apply stages_right; trivial; apply right_weaker; [|now apply empty_sphere_3_interval_returned].
  generalize (empty_sphere_3_returned f domain use). fold (sphere_answer f use). destruct (sphere_answer f use); simpl; try tauto.
Qed.

(* A placement that is closer than the tolerance: the tolerance is not 0. *)
Lemma taken_width use tolerance (y : placement) : sphere_predicate use = positive tolerance -> (forall k, norm (y k ⊖ x k) < value tolerance) ->
  0 < det x /\ value tolerance <= certified_width use x.
Proof.
  intros A Near. destruct (empty_sphere_3_right use) as [R _]. rewrite A in R. destruct R as (_ & P & _ & H). split; [exact P|].
  generalize (Near a) (norm_nonneg (y a ⊖ x a)). revert H. unfold Rmax. destruct (Rle_dec 0 _); lra.
Qed.

Theorem empty_sphere_3_certifies tolerance (y : placement) : sphere_predicate where_needed = positive tolerance ->
  0 < lambda x p -> 0 < lambda x q -> 0 < lambda y p -> 0 < lambda y q -> (forall k, norm (y k ⊖ x k) < value tolerance) -> 0 < det y.
Proof.
  intros A Xp Xq Yp Yq Near. destruct (taken_width _ _ y A Near) as [P H]. exact (sign_tolerance_3_own x y (value tolerance) Near Xp Xq P Yp Yq H).
Qed.

Theorem bicell_3_certifies tolerance (y : placement) : sphere_predicate always = positive tolerance ->
  0 < lambda x p -> 0 < lambda x q -> (forall k, norm (y k ⊖ x k) < value tolerance) -> 0 < det y /\ 0 < lambda y p /\ 0 < lambda y q.
Proof.
  intros A Xp Xq Near. destruct (taken_width _ _ y A Near) as [P H]. exact (sign_tolerance_3 x y (value tolerance) Near Xp Xq P H).
Qed.
End sphere.
