(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What rows of the later stages that agree say of the filtered predicate: what the compiled one answered is, in both modes, what the filtered predicate answers that
   coq/predicate_2.v, coq/predicate_3.v and what rests on them are about. *)
From Coq Require Import Floats Bool.
From Annulus Require Import operations filter_2 filter_3 stages predicate_2 predicate_3.
From Annulus_link Require Import replay_2 replay_3 truth_2 truth_3 later_2 later_3.

Lemma same_answer_equal a b : same_answer a b = true -> a = b.
Proof. destruct a, b; simpl; try discriminate; intro H; f_equal; now apply FloatAxioms.Leibniz.eqb_spec. Qed.
Lemma same_stages_predicate f i e i' e' lower_bound correctly_rounded : same_stages f i e i' e' lower_bound correctly_rounded = true -> lower_bound = staged false f i e /\ correctly_rounded = staged true f i e.
Proof.
  intro H. apply andb_prop in H. destruct H as [_ H]. apply andb_prop in H.
  split; symmetry; apply same_answer_equal, H.
Qed.

(* Of any tests, as in later_2.v. *)
Lemma orientation_2_stages f g r : on_orientation f g r = true ->
  let (ax, ay, bx, by', cx, cy, i, e, lower_bound, correctly_rounded) := r in f ax ay bx by' cx cy i e lower_bound correctly_rounded = true.
Proof. destruct r. intro H. apply andb_prop in H. apply H. Qed.
Lemma empty_sphere_2_stages f g r : on_empty_sphere f g r = true ->
  let (ax, ay, bx, by', px, py, qx, qy, i, e, lower_bound, correctly_rounded) := r in f ax ay bx by' px py qx qy i e lower_bound correctly_rounded = true.
Proof. destruct r. intro H. apply andb_prop in H. apply H. Qed.
Lemma orientation_3_stages f g r : on_orientation_3 f g r = true ->
  let (ax, ay, az, bx, by', bz, cx, cy, cz, dx, dy, dz, i, e, lower_bound, correctly_rounded) := r in f ax ay az bx by' bz cx cy cz dx dy dz i e lower_bound correctly_rounded = true.
Proof. destruct r. intro H. apply andb_prop in H. apply H. Qed.
Lemma empty_sphere_3_stages f g r : on_later f g r = true ->
  let (ax, ay, az, bx, by', bz, cx, cy, cz, px, py, pz, qx, qy, qz, i, e, lower_bound, correctly_rounded) := r in f ax ay az bx by' bz cx cy cz px py pz qx qy qz i e lower_bound correctly_rounded = true.
Proof. destruct r. intro H. apply andb_prop in H. apply H. Qed.

Definition answered_orientation_2 (r : orientation_2_later) : Prop :=
  let (ax, ay, bx, by', cx, cy, _, _, lower_bound, correctly_rounded) := r in
  let answer mode := orientation_predicate mode (point ax ay) (point bx by') (point cx cy) in
  lower_bound = answer false /\ correctly_rounded = answer true.
Lemma stages_orientation_predicate ax ay bx by' cx cy i e lower_bound correctly_rounded : stages_orientation ax ay bx by' cx cy i e lower_bound correctly_rounded = true ->
  answered_orientation_2 (Later_orientation_2 ax ay bx by' cx cy i e lower_bound correctly_rounded).
Proof. unfold stages_orientation, answered_orientation_2, orientation_predicate. cbv zeta. intro H. apply same_stages_predicate in H. exact H. Qed.
Theorem orientation_2_answered r : agrees_orientation_2_later r = true -> answered_orientation_2 r.
Proof.
  intro H. generalize (orientation_2_stages stages_orientation judge_orientation r H). destruct r. apply stages_orientation_predicate.
Qed.

Definition answered_empty_sphere_2 (r : empty_sphere_2_later) : Prop :=
  let (ax, ay, bx, by', px, py, qx, qy, _, _, lower_bound, correctly_rounded) := r in
  let answer mode := empty_sphere_predicate mode (point ax ay) (point bx by') (point px py) (point qx qy) in
  lower_bound = answer false /\ correctly_rounded = answer true.
Lemma stages_annulus_predicate ax ay bx by' px py qx qy i e lower_bound correctly_rounded : stages_annulus ax ay bx by' px py qx qy i e lower_bound correctly_rounded = true ->
  answered_empty_sphere_2 (Later_empty_sphere_2 ax ay bx by' px py qx qy i e lower_bound correctly_rounded).
Proof. unfold stages_annulus, answered_empty_sphere_2, empty_sphere_predicate. cbv zeta. intro H. apply same_stages_predicate in H. exact H. Qed.
Theorem empty_sphere_2_answered r : agrees_empty_sphere_2_later r = true -> answered_empty_sphere_2 r.
Proof.
  intro H. generalize (empty_sphere_2_stages stages_annulus judge_annulus r H). destruct r. apply stages_annulus_predicate.
Qed.

Definition answered_orientation_3 (r : orientation_3_later) : Prop :=
  let (ax, ay, az, bx, by', bz, cx, cy, cz, dx, dy, dz, _, _, lower_bound, correctly_rounded) := r in
  let answer mode := orientation_predicate_3 mode (point_3 ax ay az) (point_3 bx by' bz) (point_3 cx cy cz) (point_3 dx dy dz) in
  lower_bound = answer false /\ correctly_rounded = answer true.
Lemma stages_tetrahedron_predicate ax ay az bx by' bz cx cy cz dx dy dz i e lower_bound correctly_rounded :
  stages_tetrahedron ax ay az bx by' bz cx cy cz dx dy dz i e lower_bound correctly_rounded = true ->
  answered_orientation_3 (Later_orientation_3 ax ay az bx by' bz cx cy cz dx dy dz i e lower_bound correctly_rounded).
Proof. unfold stages_tetrahedron, answered_orientation_3, orientation_predicate_3. cbv zeta. intro H. apply same_stages_predicate in H. exact H. Qed.
Theorem orientation_3_answered r : agrees_orientation_3_later r = true -> answered_orientation_3 r.
Proof.
  intro H. generalize (orientation_3_stages stages_tetrahedron judge_tetrahedron r H). destruct r. apply stages_tetrahedron_predicate.
Qed.

Definition answered_empty_sphere_3 (r : empty_sphere_3_later) : Prop :=
  let (ax, ay, az, bx, by', bz, cx, cy, cz, px, py, pz, qx, qy, qz, _, _, lower_bound, correctly_rounded) := r in
  let answer mode := empty_sphere_predicate_3 mode (point_3 ax ay az) (point_3 bx by' bz) (point_3 cx cy cz) (point_3 px py pz)
                                             (point_3 qx qy qz) where_needed in
  lower_bound = answer false /\ correctly_rounded = answer true.
Lemma stages_bicell_predicate ax ay az bx by' bz cx cy cz px py pz qx qy qz i e lower_bound correctly_rounded :
  stages_bicell ax ay az bx by' bz cx cy cz px py pz qx qy qz i e lower_bound correctly_rounded = true ->
  answered_empty_sphere_3 (Later_empty_sphere_3 ax ay az bx by' bz cx cy cz px py pz qx qy qz i e lower_bound correctly_rounded).
Proof. unfold stages_bicell, answered_empty_sphere_3, empty_sphere_predicate_3. cbv zeta. intro H. apply same_stages_predicate in H. exact H. Qed.
Theorem empty_sphere_3_answered r : agrees_empty_sphere_3_later r = true -> answered_empty_sphere_3 r.
Proof.
  intro H. generalize (empty_sphere_3_stages stages_bicell judge_bicell r H). destruct r. apply stages_bicell_predicate.
Qed.
