(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The main theorems: what all other files are for, said in full, each with what it assumes. proofs/README.md has the same text beside words,
   and the definitions that it needs; proofs/claims compares the two.

   machine is Coq's primitive binary64. A sign or a tolerance is that of the filtered predicate, operation by operation: filter_2.v, interval_2.v, exact_2.v and the
   same in space. *)
From Coq Require Import Reals ZArith Lra List Permutation Floats.
From Annulus Require vectors bicell tetrahedron counterexample filter_3.
From Annulus Require sums torus_2 torus_3 torus_degree_3 torus_moving torus_frames torus_powers torus_triangulation torus_delaunay.
From Annulus Require torus_frames_3 torus_powers_3 torus_walk_3 torus_delaunay_3.
From Annulus Require Import operations bridge connect filter_2 filter_doubles returned_2 predicate_2 returned_3 predicate_3 signs_2 signs_3.
From Annulus Require Import algorithm_list algorithm_filter algorithm_check algorithm_run filter_world filter_plane.
From Annulus Require Import space_mesh space_delaunay space_triangulation space_silhouette.
From Annulus Require Import filter_space filter_delaunay_3 signed_3 space_calls.
From Annulus Require Import plane_mesh plane_triangulation plane_delaunay plane_winding plane_audit filter_delaunay plane_listed plane_calls filter_calls.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

(* ---- From doubles to signs and tolerances ---- *)

Theorem orientation_in_the_plane : forall (f : doubles) correctly_rounded a b c, (forall v, In v [a; b; c] -> coordinates_2 (f v)) ->
  match orientation_predicate correctly_rounded (f a) (f b) (f c) with
  | refused => False
  | filter_2.zero _ => turn_at (at_doubles f) a b c = 0
  | negative _ => turn_at (at_doubles f) a b c < 0
  | filter_2.positive t => finite t = true /\ 0 < turn_at (at_doubles f) a b c /\
      forall m : nat -> point_2, (forall v, In v [a; b; c] -> dist_2 (at_doubles f v) (m v) < operations.value t) -> 0 < turn_at m a b c
  end.
Proof.
  intros f correctly_rounded a b c D. destruct (orientation_2_right f correctly_rounded a b c D) as [R N].
  assert (C := fun t m => orientation_2_certifies f correctly_rounded a b c t m D).
  destruct (orientation_predicate correctly_rounded (f a) (f b) (f c)) as [|t|t|t]; [now apply N|exact R|exact R|].
  destruct R as (F & P & _). split; [exact F|]. split; [exact P|]. intros m. now apply C.
Qed.
Print Assumptions orientation_in_the_plane.

Theorem empty_circle : forall (f : doubles) correctly_rounded a b p q, (forall v, In v [a; b; p; q] -> coordinates_2 (f v)) ->
  match empty_sphere_predicate correctly_rounded (f a) (f b) (f p) (f q) with
  | refused => False
  | filter_2.zero _ => incircle_at (at_doubles f) a b p q = 0
  | negative _ => incircle_at (at_doubles f) a b p q < 0
  | filter_2.positive t => finite t = true /\ 0 < incircle_at (at_doubles f) a b p q /\
      forall m : nat -> point_2, 0 < turn_at (at_doubles f) a b q -> 0 < turn_at (at_doubles f) b a p -> 0 < turn_at m a b q -> 0 < turn_at m b a p ->
      (forall v, In v [a; b; p; q] -> dist_2 (at_doubles f v) (m v) < operations.value t) -> 0 < incircle_at m a b p q
  end.
Proof.
  intros f correctly_rounded a b p q D. destruct (empty_sphere_2_right f correctly_rounded a b p q D) as [R N].
  assert (C := fun t m => empty_sphere_2_certifies f correctly_rounded a b p q t m D).
  destruct (empty_sphere_predicate correctly_rounded (f a) (f b) (f p) (f q)) as [|t|t|t]; [now apply N|exact R|exact R|].
  destruct R as (F & P & _). split; [exact F|]. split; [exact P|]. intros m. now apply C.
Qed.
Print Assumptions empty_circle.

Theorem orientation_in_space : forall (f : tetrahedron.corner -> filter_3.vector_3 machine) correctly_rounded, (forall k, coordinates_3 (f k)) ->
  match orientation_predicate_3 correctly_rounded (f tetrahedron.o) (f tetrahedron.u) (f tetrahedron.v) (f tetrahedron.w) with
  | refused => False
  | filter_2.zero _ => tetrahedron.volume (fun k => at_3 (f k)) = 0
  | negative _ => tetrahedron.volume (fun k => at_3 (f k)) < 0
  | filter_2.positive t => finite t = true /\ 0 < tetrahedron.volume (fun k => at_3 (f k)) /\
      forall y, (forall k, vectors.norm (vectors.sub (y k) (at_3 (f k))) < operations.value t) -> 0 < tetrahedron.volume y
  end.
Proof.
  intros f correctly_rounded D. destruct (orientation_3_right f D correctly_rounded) as [R N]. assert (C := orientation_3_certifies f D correctly_rounded).
  destruct (orientation_predicate_3 correctly_rounded _ _ _ _) as [|t|t|t]; [now apply N|exact R|exact R|].
  destruct R as (F & P & _). split; [exact F|]. split; [exact P|]. intros y. now apply C.
Qed.
Print Assumptions orientation_in_space.

Theorem empty_sphere : forall (f : bicell.vertex -> filter_3.vector_3 machine) correctly_rounded, (forall k, coordinates_3 (f k)) ->
  match sphere_predicate f correctly_rounded filter_3.where_needed with
  | refused => False
  | filter_2.zero _ => bicell.det (fun k => at_3 (f k)) = 0
  | negative _ => bicell.det (fun k => at_3 (f k)) < 0
  | filter_2.positive t => finite t = true /\ 0 < bicell.det (fun k => at_3 (f k)) /\
      forall y, 0 < bicell.lambda (fun k => at_3 (f k)) bicell.p -> 0 < bicell.lambda (fun k => at_3 (f k)) bicell.q ->
      0 < bicell.lambda y bicell.p -> 0 < bicell.lambda y bicell.q ->
      (forall k, vectors.norm (vectors.sub (y k) (at_3 (f k))) < operations.value t) -> 0 < bicell.det y
  end.
Proof.
  intros f correctly_rounded D. destruct (empty_sphere_3_right f D correctly_rounded filter_3.where_needed) as [R N]. assert (C := empty_sphere_3_certifies f D correctly_rounded).
  destruct (sphere_predicate f correctly_rounded filter_3.where_needed) as [|t|t|t]; [now apply N|exact R|exact R|].
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

Theorem audit_in_the_plane : forall n (f : doubles) cells, audited n f cells = true -> exists T, plane_mesh.cells T = cells /\
  (forall v, vertex_of T v <-> (v < n)%nat) /\ (forall v, (v < n)%nat -> finite (x _ (f v)) = true /\ finite (y _ (f v)) = true) /\
  triangulation (at_doubles f) T /\ delaunay (at_doubles f) T.
Proof. exact audited_delaunay. Qed.
Print Assumptions audit_in_the_plane.

Theorem mesh_in_space : forall T U L m, glued_3 T -> positive_3 m T -> ridges_convex m U L -> silhouette_once m T U L ->
  triangulation_3 m T /\ (locally_delaunay_3 m T -> delaunay_3 m T).
Proof. intros T U L m G P R S. split; [now apply (silhouette_triangulation T m U L)|now apply (silhouette_delaunay T m U L)]. Qed.
Print Assumptions mesh_in_space.

(* ---- From doubles to Delaunay, step by step ---- *)

Theorem filter_in_the_plane : forall (o : options) n f m verdicts s (e : nat -> event) (y : nat -> system) (T : nat -> plane_mesh.mesh),
  start f m verdicts -> (0 <= epoch s)%Z -> y O = recomputed f m verdicts s ->
  glued (T O) -> lists m (T O) -> winds_once (at_doubles f) (border (T O)) ->
  (forall i, (i < n)%nat -> program_call (e i) (y i) (T i) (y (S i)) (T (S i))) ->
  forall i, (i <= n)%nat ->
  triangulation (places (y i)) (T i) /\ delaunay (places (y i)) (T i) /\ forall v, vertex_of (T i) v <-> present (vertex_of (T O)) e i v.
Proof. intros o. exact program_delaunay_until. Qed.
Print Assumptions filter_in_the_plane.

Theorem verdicts_of_doubles_in_space : forall (o : options) f k, (forall v, coordinates_3 (f v)) -> its_cells_positive (at_doubles_3 f) k ->
  is_answer_in_space f k -> evaluated (W := the_space) (at_doubles_3 f) k.
Proof. exact @answer_evaluated_3. Qed.
Print Assumptions verdicts_of_doubles_in_space.

Theorem filter_in_space : forall (o : options) f m verdicts s z,
  start_in_space f m verdicts -> (0 <= epoch s)%Z -> space_calls (recomputed_in_space f m verdicts s) z ->
  (forall i c, algorithm_filter.mesh (of_filter z) i = Some c -> holds_3 no_fold_3 c (places_3 z)) /\
  forall T U L, glued_3 T -> watches_3 z T U L -> silhouette_once (places_3 z) T U L -> triangulation_3 (places_3 z) T /\ delaunay_3 (places_3 z) T.
Proof.
  intros o f m verdicts s z S E R. apply space_calls_are_calls in R; trivial. split; [exact (filter_holds_3 f m verdicts s z S E R)|].
  intros T U L. exact (filter_delaunay_3 f m verdicts s z T U L S E R).
Qed.
Print Assumptions filter_in_space.

(* ---- Periodic boxes ---- *)

Theorem periodic_degree_in_the_plane : forall T, torus_2.glued_torus_2 T ->
  (forall x L, sums.sum (torus_2.torus_area x L) T = IZR (torus_2.covers_2 T) * torus_2.det_2 L) /\
  (exists N, torus_2.covers_2 T = (2 * N)%Z) /\
  (forall v k, torus_2.covers_2 (map (torus_2.wrapped_2 v k) T) = torus_2.covers_2 T) /\
  (forall m, torus_2.basis_det m = 1%Z -> torus_2.covers_2 (map (torus_2.rebased_2 m) T) = torus_2.covers_2 T) /\
  (forall A B rest, torus_2.same_border_2 A B -> T = A ++ rest -> torus_2.covers_2 (B ++ rest) = torus_2.covers_2 T).
Proof.
  intros T G. split; [now apply torus_2.degree_2|]. split; [now apply torus_2.covers_even|]. split; [intros; now apply torus_2.covers_wrapped|].
  split; [intros; now apply torus_2.covers_in_basis|]. intros A B rest S ->. symmetry. now apply torus_2.covers_replaced.
Qed.
Print Assumptions periodic_degree_in_the_plane.

Theorem periodic_degree_in_space : forall T, torus_3.glued_torus_3 T ->
  (forall x L, sums.sum (torus_3.torus_volume x L) T = IZR (torus_3.covers_3 T) * torus_3.det_3 L) /\
  (exists N, torus_3.covers_3 T = (6 * N)%Z) /\
  (forall v k, torus_3.covers_3 (map (torus_3.wrapped_3 v k) T) = torus_3.covers_3 T) /\
  (forall m, torus_3.offset_det (torus_3.m1 m) (torus_3.m2 m) (torus_3.m3 m) = 1%Z ->
    torus_3.covers_3 (map (torus_3.rebased_3 m) T) = torus_3.covers_3 T) /\
  (forall A B rest, torus_3.same_border_3 A B -> T = A ++ rest -> torus_3.covers_3 (B ++ rest) = torus_3.covers_3 T).
Proof.
  intros T G. split; [now apply torus_3.degree_3|]. split; [now apply torus_degree_3.covers_six|]. split; [intros; now apply torus_3.covers_wrapped_3|].
  split; [intros; now apply torus_3.covers_in_basis_3|]. intros A B rest S ->. symmetry. now apply torus_3.covers_replaced_3.
Qed.
Print Assumptions periodic_degree_in_space.

Theorem periodic_powers_in_the_plane : forall (x : nat -> point_2) L, 0 < torus_2.det_2 L -> forall T, torus_2.glued_torus_2 T ->
  torus_frames.positive_torus_2 x L T -> torus_frames.locally_delaunay_2 x L T ->
  forall z c0, In c0 T -> exists c u, In c T /\ torus_frames.in_torus_cell x L z (torus_frames.moved_cell_2 u c) /\
    forall c' u', In c' T ->
    torus_powers.power_of x L z (torus_frames.moved_cell_2 u c) <= torus_powers.power_of x L z (torus_frames.moved_cell_2 u' c').
Proof. intros x L D T G P S z c0. now apply torus_powers.least_power. Qed.
Print Assumptions periodic_powers_in_the_plane.

Theorem periodic_mesh_in_the_plane : forall (x : nat -> point_2) L, 0 < torus_2.det_2 L -> forall T, torus_delaunay.covers_once x L T ->
  torus_triangulation.triangulates x L T /\
  (torus_frames.locally_delaunay_2 x L T -> torus_delaunay.circles_empty x L T) /\
  (torus_frames.strictly_delaunay_2 x L T -> torus_delaunay.circles_strictly_empty x L T /\
    forall T', torus_delaunay.covers_once x L T' -> torus_frames.locally_delaunay_2 x L T' ->
    (forall v, torus_frames.torus_vertex T v <-> torus_frames.torus_vertex T' v) -> torus_delaunay.same_cells T T').
Proof.
  intros x L D T C. split; [|split].
  - apply torus_triangulation.torus_triangulates; trivial; [apply C|apply C|now apply (torus_delaunay.degree_one x L)].
  - now apply torus_delaunay.torus_delaunay.
  - intro S. split; [now apply torus_delaunay.torus_strict|]. intros T' C' S' V. now apply (torus_delaunay.torus_unique x L).
Qed.
Print Assumptions periodic_mesh_in_the_plane.

Theorem periodic_powers_in_space : forall (x : nat -> vectors.vec) L, 0 < torus_3.det_3 L -> forall T, torus_3.glued_torus_3 T ->
  torus_frames_3.positive_torus_3 x L T -> torus_frames_3.locally_delaunay_torus_3 x L T ->
  forall y c0, In c0 T -> exists k, In (fst k) T /\ torus_powers_3.in_torus_cell_3 x L y (torus_frames_3.instance_3 k) /\
    forall j, In (fst j) T -> torus_powers_3.power_3 x L y (torus_frames_3.instance_3 k) <= torus_powers_3.power_3 x L y (torus_frames_3.instance_3 j).
Proof. intros x L D T G P S y c0. now apply torus_walk_3.least_power_3. Qed.
Print Assumptions periodic_powers_in_space.

Theorem periodic_mesh_in_space : forall (x : nat -> vectors.vec) L, 0 < torus_3.det_3 L -> forall T, torus_delaunay_3.covers_once_3 x L T ->
  (forall y, exists k, In (fst k) T /\ torus_powers_3.in_torus_cell_3 x L y (torus_frames_3.instance_3 k)) /\
  (forall y k k', In (fst k) T -> In (fst k') T -> torus_powers_3.inside_torus_cell_3 x L y (torus_frames_3.instance_3 k) ->
    torus_powers_3.in_torus_cell_3 x L y (torus_frames_3.instance_3 k') -> k = k') /\
  (torus_frames_3.locally_delaunay_torus_3 x L T -> torus_delaunay_3.spheres_empty x L T).
Proof.
  intros x L D T C. split; [|split].
  - intro y. now apply torus_delaunay_3.torus_covered_3.
  - intros y k k'. now apply torus_delaunay_3.torus_disjoint_3.
  - now apply torus_delaunay_3.torus_delaunay_3.
Qed.
Print Assumptions periodic_mesh_in_space.

Theorem circle_in_a_moving_box : forall m E e (x0 x d : nat -> point_2) L0 L (site : nat -> torus_2.site_2) c r s,
  m <> (0, 0) -> 0 <= e -> torus_moving.small_2 e E ->
  torus_moving.box_follows_2 (torus_moving.nearly_similar_2 m E) L0 L ->
  torus_moving.vertices_follow_2 (torus_moving.nearly_similar_2 m E) d x0 x ->
  let y i := torus_2.site_at x0 L0 (site i) in
  (forall i, (i < 4)%nat -> torus_moving.length_2 (torus_moving.minus_2 (y i) c) <= r) ->
  (forall i, (i < 4)%nat -> (1 + e) * torus_moving.length_2 (d (fst (site i))) + e * r < s) ->
  (forall z, (forall i, (i < 4)%nat -> torus_moving.length_2 (torus_moving.minus_2 (z i) (y i)) < s) -> torus_moving.circle_holds z) ->
  torus_moving.circle_holds (fun i => torus_2.site_at x L (site i)).
Proof. exact torus_moving.circle_in_moving_box_2. Qed.
Print Assumptions circle_in_a_moving_box.

Theorem sphere_in_a_moving_box : forall rho Q E e (x0 x d : nat -> vectors.vec) L0 L (site : bicell.vertex -> torus_3.site_3) c r s,
  0 < rho -> torus_moving.rotation_3 Q -> 0 <= e -> torus_moving.small_3 e E ->
  torus_moving.box_follows_3 (torus_moving.nearly_similar_3 rho Q E) L0 L ->
  torus_moving.vertices_follow_3 (torus_moving.nearly_similar_3 rho Q E) d x0 x ->
  let y i := torus_3.site_at_3 x0 L0 (site i) in
  (forall i, vectors.norm (vectors.sub (y i) c) <= r) -> (forall i, (1 + e) * vectors.norm (d (fst (site i))) + e * r < s) ->
  (forall z, (forall i, vectors.norm (vectors.sub (z i) (y i)) < s) -> torus_moving.sphere_holds z) ->
  torus_moving.sphere_holds (fun i => torus_3.site_at_3 x L (site i)).
Proof. exact torus_moving.sphere_in_moving_box_3. Qed.
Print Assumptions sphere_in_a_moving_box.

Theorem triangle_in_a_moving_box : forall A (x0 x d : nat -> point_2) L0 L (site : nat -> torus_2.site_2) s,
  torus_moving.linear_2 A -> torus_moving.box_follows_2 A L0 L -> torus_moving.vertices_follow_2 A d x0 x ->
  0 < torus_2.det_2 L0 -> 0 < torus_2.det_2 L -> (forall i, (i < 3)%nat -> torus_moving.length_2 (d (fst (site i))) < s) ->
  (forall z, (forall i, (i < 3)%nat -> torus_moving.length_2 (torus_moving.minus_2 (z i) (torus_2.site_at x0 L0 (site i))) < s) -> 0 < turn_at z 0 1 2) ->
  0 < turn_at (fun i => torus_2.site_at x L (site i)) 0 1 2.
Proof. exact torus_moving.orientation_in_moving_box_2. Qed.
Print Assumptions triangle_in_a_moving_box.

Theorem tetrahedron_in_a_moving_box : forall A (x0 x d : nat -> vectors.vec) L0 L (site : tetrahedron.corner -> torus_3.site_3) s,
  torus_moving.linear_3 A -> torus_moving.box_follows_3 A L0 L -> torus_moving.vertices_follow_3 A d x0 x ->
  0 < torus_3.det_3 L0 -> 0 < torus_3.det_3 L -> (forall i, vectors.norm (d (fst (site i))) < s) ->
  (forall z, (forall i, vectors.norm (vectors.sub (z i) (torus_3.site_at_3 x0 L0 (site i))) < s) -> 0 < tetrahedron.volume z) ->
  0 < tetrahedron.volume (fun i => torus_3.site_at_3 x L (site i)).
Proof. exact torus_moving.orientation_in_moving_box_3. Qed.
Print Assumptions tetrahedron_in_a_moving_box.

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
