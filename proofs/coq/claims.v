(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The theorems on the tin: what all other files are for, said in full, each with what it assumes. proofs/README.md has the same text beside words,
   and the definitions that it needs; proofs/claims compares the two.

   machine is Coq's primitive binary64. A sign or a tolerance is that of the filter stage of the ladder, operation by operation (filter_2.v, filter_3.v). *)
From Coq Require Import Reals ZArith Lra List Permutation Floats.
From Annulus Require vectors bicell tetrahedron counterexample filter_3.
From Annulus Require Import operations bridge connect filter_2 filter_doubles returned_2 returned_3 signs_2 signs_3.
From Annulus Require Import algorithm_list algorithm_filter algorithm_look algorithm_run filter_plane.
From Annulus Require Import space_mesh space_embedding space_delaunay.
From Annulus Require Import plane_mesh plane_triangulation plane_delaunay plane_winding plane_motion filter_delaunay.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

(* ---- From doubles to signs and tolerances ---- *)

Theorem orientation_in_the_plane : forall (f : doubles) a b c, (forall v, In v [a; b; c] -> coordinates_2 (f v)) ->
  match orientation_filter machine (f a) (f b) (f c) true with
  | refused => True
  | filter_2.zero _ => False
  | negative _ => turn_at (at_doubles f) a b c < 0
  | filter_2.positive t => finite t = true /\ 0 < turn_at (at_doubles f) a b c /\
      forall m : nat -> point_2, (forall v, In v [a; b; c] -> dist_2 (at_doubles f v) (m v) < operations.value t) -> 0 < turn_at m a b c
  end.
Proof.
  intros f a b c D. assert (R := orientation_2_returned f a b c D). assert (C := orientation_2_returned_certifies f a b c D).
  destruct (orientation_filter machine (f a) (f b) (f c) true) as [|t|t|t]; trivial.
  destruct R as (F & P & _). split; [exact F|]. split; [exact P|]. intros m. now apply C.
Qed.
Print Assumptions orientation_in_the_plane.

Theorem empty_circle : forall (f : doubles) a b p q, (forall v, In v [a; b; p; q] -> coordinates_2 (f v)) ->
  match empty_sphere_filter machine (f a) (f b) (f p) (f q) true with
  | refused => True
  | filter_2.zero _ => False
  | negative _ => incircle_at (at_doubles f) a b p q < 0
  | filter_2.positive t => finite t = true /\ 0 < incircle_at (at_doubles f) a b p q /\
      forall m : nat -> point_2, 0 < turn_at (at_doubles f) a b q -> 0 < turn_at (at_doubles f) b a p -> 0 < turn_at m a b q -> 0 < turn_at m b a p ->
      (forall v, In v [a; b; p; q] -> dist_2 (at_doubles f v) (m v) < operations.value t) -> 0 < incircle_at m a b p q
  end.
Proof.
  intros f a b p q D. assert (R := empty_sphere_2_returned f a b p q D). assert (C := empty_sphere_2_returned_certifies f a b p q D).
  destruct (empty_sphere_filter machine (f a) (f b) (f p) (f q) true) as [|t|t|t]; trivial.
  destruct R as (F & P & _). split; [exact F|]. split; [exact P|]. intros m. now apply C.
Qed.
Print Assumptions empty_circle.

Theorem orientation_in_space : forall f : tetrahedron.corner -> filter_3.vector_3 machine, (forall k, coordinates_3 (f k)) ->
  match filter_3.orientation_filter_3 machine (f tetrahedron.o) (f tetrahedron.u) (f tetrahedron.v) (f tetrahedron.w) true with
  | refused => True
  | filter_2.zero _ => False
  | negative _ => tetrahedron.volume (fun k => at_3 (f k)) < 0
  | filter_2.positive t => finite t = true /\ 0 < tetrahedron.volume (fun k => at_3 (f k)) /\
      forall y, (forall k, vectors.norm (vectors.sub (y k) (at_3 (f k))) < operations.value t) -> 0 < tetrahedron.volume y
  end.
Proof.
  intros f D. assert (R := orientation_3_returned f D). assert (C := orientation_3_returned_certifies f D).
  destruct (filter_3.orientation_filter_3 machine _ _ _ _ true) as [|t|t|t]; trivial.
  destruct R as (F & P & _). split; [exact F|]. split; [exact P|]. intros y. now apply C.
Qed.
Print Assumptions orientation_in_space.

Theorem empty_sphere : forall f : bicell.vertex -> filter_3.vector_3 machine, (forall k, coordinates_3 (f k)) ->
  match sphere_answer f filter_3.where_needed with
  | refused => True
  | filter_2.zero _ => False
  | negative _ => bicell.det (fun k => at_3 (f k)) < 0
  | filter_2.positive t => finite t = true /\ 0 < bicell.det (fun k => at_3 (f k)) /\
      forall y, 0 < bicell.lambda (fun k => at_3 (f k)) bicell.p -> 0 < bicell.lambda (fun k => at_3 (f k)) bicell.q ->
      0 < bicell.lambda y bicell.p -> 0 < bicell.lambda y bicell.q ->
      (forall k, vectors.norm (vectors.sub (y k) (at_3 (f k))) < operations.value t) -> 0 < bicell.det y
  end.
Proof.
  intros f D. assert (R := empty_sphere_3_returned f D filter_3.where_needed). assert (C := empty_sphere_3_returned_certifies f D).
  destruct (sphere_answer f filter_3.where_needed) as [|t|t|t]; trivial.
  destruct R as (F & P & _). split; [exact F|]. split; [exact P|]. intros y. now apply C.
Qed.
Print Assumptions empty_sphere.

Theorem circle_signs : forall a b c ps, coordinates_2 a /\ coordinates_2 b /\ coordinates_2 c -> (forall p, In p ps -> coordinates_2 p) ->
  let k := circumcircle_of machine a b c in
  (circle_positive machine k = true -> 0 < turn_2 (at_2 a) (at_2 b) (at_2 c) /\ forall p, In p ps ->
    (excludes machine k p = true -> 0 < beyond_2 (at_2 a) (at_2 b) (at_2 c) (at_2 p)) /\
    (contains machine k p = true -> beyond_2 (at_2 a) (at_2 b) (at_2 c) (at_2 p) < 0)) /\
  (excludes_all machine k ps = true -> 0 < turn_2 (at_2 a) (at_2 b) (at_2 c) /\ forall p, In p ps -> 0 < beyond_2 (at_2 a) (at_2 b) (at_2 c) (at_2 p)).
Proof.
  intros a b c ps D E k. split; [|now apply excludes_all_2]. intro P. split; [now apply signs_2.positive_2|]. intros p I. now apply sides_of_circle_2; [|apply E|].
Qed.
Print Assumptions circle_signs.

Theorem sphere_signs : forall a b c d ps, coordinates_3 a /\ coordinates_3 b /\ coordinates_3 c /\ coordinates_3 d ->
  (forall p, In p ps -> coordinates_3 p) -> let k := filter_3.circumsphere_of machine a b c d in
  (filter_3.sphere_positive machine k = true -> 0 < volume_of (at_3 a) (at_3 b) (at_3 c) (at_3 d) /\ forall p, In p ps ->
    (filter_3.excludes_3 machine k p = true -> 0 < beyond_3 (at_3 a) (at_3 b) (at_3 c) (at_3 d) (at_3 p)) /\
    (filter_3.contains_3 machine k p = true -> beyond_3 (at_3 a) (at_3 b) (at_3 c) (at_3 d) (at_3 p) < 0)) /\
  (filter_3.excludes_all_3 machine k ps = true -> 0 < volume_of (at_3 a) (at_3 b) (at_3 c) (at_3 d) /\
    forall p, In p ps -> 0 < beyond_3 (at_3 a) (at_3 b) (at_3 c) (at_3 d) (at_3 p)).
Proof.
  intros a b c d ps D E k. split; [|now apply excludes_all_3_sound]. intro P. split; [now apply signs_3.positive_3|]. intros p I.
  now apply sides_of_sphere_3; [|apply E|].
Qed.
Print Assumptions sphere_signs.

(* ---- From signs to Delaunay ---- *)

Theorem mesh_in_the_plane : forall T m, glued T -> positive m T -> convex m (border T) -> winds_once m (border T) ->
  triangulation m T /\ (locally_delaunay m T -> delaunay m T).
Proof. intros T m G P C W. split; [now apply plane_triangulation|now apply plane_delaunay]. Qed.
Print Assumptions mesh_in_the_plane.

Theorem border_in_motion : forall (m : R -> placement) l, continuous_motion m -> (forall t, 0 <= t <= 1 -> convex (m t) l) ->
  winds_once (m 0) l -> winds_once (m 1) l.
Proof. exact winding_kept. Qed.
Print Assumptions border_in_motion.

Theorem mesh_in_space : forall T m, glued_3 T -> positive_3 m T ->
  (forall s v, In s (space_mesh.outer T) -> is_vertex T v -> 0 <= facet_height m s (m v)) ->
  (exists x t rest, Permutation (space_mesh.cells T) (t :: rest) /\ inside_3 m x t /\ forall r, In r rest -> ~ in_cell_3 m x r) ->
  (forall x, (exists t, In t (space_mesh.cells T) /\ in_cell_3 m x t) <-> forall s, In s (space_mesh.outer T) -> 0 <= facet_height m s x) /\
  (forall x t r rest, Permutation (space_mesh.cells T) (t :: rest) -> In r rest -> inside_3 m x t -> ~ in_cell_3 m x r) /\
  (locally_delaunay_3 m T -> delaunay_3 m T).
Proof.
  intros T m G P C O. split; [intro x; now apply cover_3|]. split; [|now apply space_delaunay].
  intros x t r rest. now apply (disjoint_3 T m G P C O).
Qed.
Print Assumptions mesh_in_space.

(* ---- From doubles to Delaunay, step by step ---- *)

Theorem verdicts_of_doubles : forall (o : options) f k, (forall v, coordinates_2 (f v)) ->
  match of k with circle a b p q => 0 < turn_at (at_doubles f) a b q /\ 0 < turn_at (at_doubles f) b a p | _ => True end ->
  told f k -> evaluated (at_doubles f) k.
Proof. exact @told_evaluated. Qed.
Print Assumptions verdicts_of_doubles.

Theorem ridge_left_alone : forall (o : options) (y z : system) i u v w, right y -> right z -> tracks y = true -> tracks z = true ->
  algorithm_filter.mesh (of_filter y) i = Some (ridge u v w) -> algorithm_filter.mesh (of_filter z) i = Some (ridge u v w) ->
  reference (record (of_filter z) i) = reference (record (of_filter y) i) -> allowance (record (of_filter z) i) = allowance (record (of_filter y) i) ->
  certified_ridge (places y) (places z) u v w.
Proof. exact @same_record_certifies. Qed.
Print Assumptions ridge_left_alone.

Theorem filter_in_the_plane : forall (o : options) second_look, second_look_right second_look ->
  forall f m verdicts s (y : nat -> system) (T : nat -> plane_mesh.mesh),
  start f m verdicts -> (0 <= epoch s)%Z -> y O = settled f m verdicts s -> (forall i, calls second_look (y i) (y (S i))) ->
  (forall i, glued (T i) /\ watches (y i) (T i)) ->
  winds_once (places (y O)) (border (T O)) -> (forall i, border_known (places (y i)) (places (y (S i))) (T i) (T (S i))) ->
  forall i, triangulation (places (y i)) (T i) /\ delaunay (places (y i)) (T i).
Proof. exact @filter_steps_delaunay. Qed.
Print Assumptions filter_in_the_plane.

(* ---- The paper's tolerance ---- *)

(* The figure is in counterexample.v: five points, three cells around an edge before, two at a facet after. *)
Theorem tolerance_of_the_paper_fails :
  let before := counterexample.before in let after := counterexample.after in
  (forall k, 0 < tetrahedron.volume (counterexample.tetrahedra before k)) /\ (forall k, 0 < bicell.det (counterexample.around before k)) /\
  (forall k, 74 / 10000 < bicell.half_width (counterexample.around before k) bicell.pq bicell.a bicell.p) /\
  (forall k, 74 / 10000 < tetrahedron.half_width_simplex (counterexample.tetrahedra before k)) /\
  (forall point, In point [counterexample.North; counterexample.South; counterexample.P1; counterexample.P2; counterexample.P3] ->
    vectors.norm (vectors.sub (point after) (point before)) = 70 / 10000) /\
  (forall k, bicell.det (counterexample.around after k) < 0) /\
  (forall k, 0 < tetrahedron.volume (counterexample.tetrahedra after k)) /\ 0 < bicell.det (counterexample.middle after).
Proof.
  destruct counterexample.proposition_1_fails as (A & B & C & D & E & F). split; [exact A|]. split; [exact B|]. split; [exact C|]. split; [exact D|].
  split; [|exact F]. intros point I. apply E. simpl in I. intuition congruence.
Qed.
Print Assumptions tolerance_of_the_paper_fails.
