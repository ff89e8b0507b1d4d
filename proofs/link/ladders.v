(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What rows of the later stages that agree say of the ladder: what the compiled one answered is, in both modes, what the ladder answers that
   coq/ladder_2.v, coq/ladder_3.v and what rests on them are about. *)
From Coq Require Import Floats Bool.
From Annulus Require Import operations filter_2 filter_3 stages ladder_2 ladder_3.
From Annulus_link Require Import replay_2 replay_3 truth_2 truth_3 later_2 later_3.

Lemma same_answer_equal a b : same_answer a b = true -> a = b.
Proof. destruct a, b; simpl; try discriminate; intro H; f_equal; now apply FloatAxioms.Leibniz.eqb_spec. Qed.
Lemma same_stages_ladder f i e i' e' fast tight : same_stages f i e i' e' fast tight = true -> fast = ladder false f i e /\ tight = ladder true f i e.
Proof.
  intro H. apply andb_prop in H. destruct H as [_ H]. apply andb_prop in H.
  split; symmetry; apply same_answer_equal, H.
Qed.

(* Of any tests, as in later_2.v. *)
Lemma orientation_2_stages f g r : on_orientation f g r = true ->
  let (ax, ay, bx, by', cx, cy, i, e, fast, tight) := r in f ax ay bx by' cx cy i e fast tight = true.
Proof. destruct r. intro H. apply andb_prop in H. apply H. Qed.
Lemma empty_sphere_2_stages f g r : on_empty_sphere f g r = true ->
  let (ax, ay, bx, by', px, py, qx, qy, i, e, fast, tight) := r in f ax ay bx by' px py qx qy i e fast tight = true.
Proof. destruct r. intro H. apply andb_prop in H. apply H. Qed.
Lemma orientation_3_stages f g r : on_orientation_3 f g r = true ->
  let (ax, ay, az, bx, by', bz, cx, cy, cz, dx, dy, dz, i, e, fast, tight) := r in f ax ay az bx by' bz cx cy cz dx dy dz i e fast tight = true.
Proof. destruct r. intro H. apply andb_prop in H. apply H. Qed.
Lemma empty_sphere_3_stages f g r : on_later f g r = true ->
  let (ax, ay, az, bx, by', bz, cx, cy, cz, px, py, pz, qx, qy, qz, i, e, fast, tight) := r in f ax ay az bx by' bz cx cy cz px py pz qx qy qz i e fast tight = true.
Proof. destruct r. intro H. apply andb_prop in H. apply H. Qed.

Definition answered_orientation_2 (r : orientation_2_later) : Prop :=
  let (ax, ay, bx, by', cx, cy, _, _, fast, tight) := r in
  let answer mode := orientation_ladder mode (point ax ay) (point bx by') (point cx cy) in
  fast = answer false /\ tight = answer true.
Lemma stages_orientation_ladder ax ay bx by' cx cy i e fast tight : stages_orientation ax ay bx by' cx cy i e fast tight = true ->
  answered_orientation_2 (Later_orientation_2 ax ay bx by' cx cy i e fast tight).
Proof. unfold stages_orientation, answered_orientation_2, orientation_ladder. cbv zeta. intro H. apply same_stages_ladder in H. exact H. Qed.
Theorem orientation_2_answered r : agrees_orientation_2_later r = true -> answered_orientation_2 r.
Proof.
  intro H. generalize (orientation_2_stages stages_orientation judge_orientation r H). destruct r. apply stages_orientation_ladder.
Qed.

Definition answered_empty_sphere_2 (r : empty_sphere_2_later) : Prop :=
  let (ax, ay, bx, by', px, py, qx, qy, _, _, fast, tight) := r in
  let answer mode := empty_sphere_ladder mode (point ax ay) (point bx by') (point px py) (point qx qy) in
  fast = answer false /\ tight = answer true.
Lemma stages_annulus_ladder ax ay bx by' px py qx qy i e fast tight : stages_annulus ax ay bx by' px py qx qy i e fast tight = true ->
  answered_empty_sphere_2 (Later_empty_sphere_2 ax ay bx by' px py qx qy i e fast tight).
Proof. unfold stages_annulus, answered_empty_sphere_2, empty_sphere_ladder. cbv zeta. intro H. apply same_stages_ladder in H. exact H. Qed.
Theorem empty_sphere_2_answered r : agrees_empty_sphere_2_later r = true -> answered_empty_sphere_2 r.
Proof.
  intro H. generalize (empty_sphere_2_stages stages_annulus judge_annulus r H). destruct r. apply stages_annulus_ladder.
Qed.

Definition answered_orientation_3 (r : orientation_3_later) : Prop :=
  let (ax, ay, az, bx, by', bz, cx, cy, cz, dx, dy, dz, _, _, fast, tight) := r in
  let answer mode := orientation_ladder_3 mode (point_3 ax ay az) (point_3 bx by' bz) (point_3 cx cy cz) (point_3 dx dy dz) in
  fast = answer false /\ tight = answer true.
Lemma stages_tetrahedron_ladder ax ay az bx by' bz cx cy cz dx dy dz i e fast tight :
  stages_tetrahedron ax ay az bx by' bz cx cy cz dx dy dz i e fast tight = true ->
  answered_orientation_3 (Later_orientation_3 ax ay az bx by' bz cx cy cz dx dy dz i e fast tight).
Proof. unfold stages_tetrahedron, answered_orientation_3, orientation_ladder_3. cbv zeta. intro H. apply same_stages_ladder in H. exact H. Qed.
Theorem orientation_3_answered r : agrees_orientation_3_later r = true -> answered_orientation_3 r.
Proof.
  intro H. generalize (orientation_3_stages stages_tetrahedron judge_tetrahedron r H). destruct r. apply stages_tetrahedron_ladder.
Qed.

Definition answered_empty_sphere_3 (r : empty_sphere_3_later) : Prop :=
  let (ax, ay, az, bx, by', bz, cx, cy, cz, px, py, pz, qx, qy, qz, _, _, fast, tight) := r in
  let answer mode := empty_sphere_ladder_3 mode (point_3 ax ay az) (point_3 bx by' bz) (point_3 cx cy cz) (point_3 px py pz)
                                             (point_3 qx qy qz) where_needed in
  fast = answer false /\ tight = answer true.
Lemma stages_bicell_ladder ax ay az bx by' bz cx cy cz px py pz qx qy qz i e fast tight :
  stages_bicell ax ay az bx by' bz cx cy cz px py pz qx qy qz i e fast tight = true ->
  answered_empty_sphere_3 (Later_empty_sphere_3 ax ay az bx by' bz cx cy cz px py pz qx qy qz i e fast tight).
Proof. unfold stages_bicell, answered_empty_sphere_3, empty_sphere_ladder_3. cbv zeta. intro H. apply same_stages_ladder in H. exact H. Qed.
Theorem empty_sphere_3_answered r : agrees_empty_sphere_3_later r = true -> answered_empty_sphere_3 r.
Proof.
  intro H. generalize (empty_sphere_3_stages stages_bicell judge_bicell r H). destruct r. apply stages_bicell_ladder.
Qed.
