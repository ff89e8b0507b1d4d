(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Rows of the later stages in space: both are replayed, and judged by the truth. *)
From Coq Require Import List Floats Bool String.
From Annulus Require Import operations filter_2 filter_3 interval_3 exact_3.
From Annulus_link Require Import replay_2 replay_3 truth_2 truth_3.
Import ListNotations.

Inductive orientation_3_later :=
  Later_orientation_3 (ax ay az bx by' bz cx cy cz dx dy dz : float) (interval exact : answer float).
Inductive empty_sphere_3_later :=
  Later_empty_sphere_3 (ax ay az bx by' bz cx cy cz px py pz qx qy qz : float) (interval exact : answer float).
(* The published table: filter, interval and exact stage. *)
Inductive named_3 :=
  Named_3 (name : string) (ax ay az bx by' bz cx cy cz px py pz qx qy qz : float) (filter interval exact : answer float).

(* As in later_2.v: tests are variables here, because a conversion that tried to evaluate them would not end. *)
Section tests.
Let of_points (A : Type) := float -> float -> float -> float -> float -> float -> float -> float -> float -> float -> float -> float -> A.
Let on_four (A : Type) := of_points (answer float -> answer float -> A).
Let on_five (A : Type) := of_points (float -> float -> float -> answer float -> answer float -> A).
Variables f4 g4 : on_four bool.
Variables f g h : on_five bool.
Definition on_orientation_3 (r : orientation_3_later) :=
  let (ax, ay, az, bx, by', bz, cx, cy, cz, dx, dy, dz, i, e) := r in
  f4 ax ay az bx by' bz cx cy cz dx dy dz i e && g4 ax ay az bx by' bz cx cy cz dx dy dz i e.
Definition on_later (r : empty_sphere_3_later) :=
  let (ax, ay, az, bx, by', bz, cx, cy, cz, px, py, pz, qx, qy, qz, i, e) := r in
  f ax ay az bx by' bz cx cy cz px py pz qx qy qz i e && g ax ay az bx by' bz cx cy cz px py pz qx qy qz i e.
Definition on_named_3 (r : named_3) :=
  let (_, ax, ay, az, bx, by', bz, cx, cy, cz, px, py, pz, qx, qy, qz, k, i, e) := r in
  h ax ay az bx by' bz cx cy cz px py pz qx qy qz k i &&
  (g ax ay az bx by' bz cx cy cz px py pz qx qy qz k e && g ax ay az bx by' bz cx cy cz px py pz qx qy qz i e).

Variable P4 : on_four Prop.
Variable P : on_five Prop.
Hypothesis G4 : forall ax ay az bx by' bz cx cy cz dx dy dz i e,
  g4 ax ay az bx by' bz cx cy cz dx dy dz i e = true -> P4 ax ay az bx by' bz cx cy cz dx dy dz i e.
Hypothesis G : forall ax ay az bx by' bz cx cy cz px py pz qx qy qz i e,
  g ax ay az bx by' bz cx cy cz px py pz qx qy qz i e = true -> P ax ay az bx by' bz cx cy cz px py pz qx qy qz i e.
Definition worth_orientation_3 (r : orientation_3_later) : Prop :=
  let (ax, ay, az, bx, by', bz, cx, cy, cz, dx, dy, dz, i, e) := r in P4 ax ay az bx by' bz cx cy cz dx dy dz i e.
Definition worth_later (r : empty_sphere_3_later) : Prop :=
  let (ax, ay, az, bx, by', bz, cx, cy, cz, px, py, pz, qx, qy, qz, i, e) := r in
  P ax ay az bx by' bz cx cy cz px py pz qx qy qz i e.
Definition worth_named_3 (r : named_3) : Prop :=
  let (_, ax, ay, az, bx, by', bz, cx, cy, cz, px, py, pz, qx, qy, qz, k, i, e) := r in
  P ax ay az bx by' bz cx cy cz px py pz qx qy qz k e /\ P ax ay az bx by' bz cx cy cz px py pz qx qy qz i e.

Lemma orientation_3_worth : forall r, on_orientation_3 r = true -> worth_orientation_3 r.
Proof. intros [ax ay az bx by' bz cx cy cz dx dy dz i e] H. apply andb_prop in H. apply G4, H. Qed.
Lemma later_worth : forall r, on_later r = true -> worth_later r.
Proof. intros [ax ay az bx by' bz cx cy cz px py pz qx qy qz i e] H. apply andb_prop in H. apply G, H. Qed.
Lemma named_3_worth : forall r, on_named_3 r = true -> worth_named_3 r.
Proof.
  intros [name ax ay az bx by' bz cx cy cz px py pz qx qy qz k i e] H. apply andb_prop in H. destruct H as [_ H].
  apply andb_prop in H. destruct H. split; apply G; assumption.
Qed.
End tests.

(* The interval and the exact stage, replayed; for the table filter and intervals. *)
Definition both_tetrahedron ax ay az bx by' bz cx cy cz dx dy dz (i e : answer float) : bool :=
  same_answer (orientation_3_interval (point_3 ax ay az) (point_3 bx by' bz) (point_3 cx cy cz) (point_3 dx dy dz)) i &&
  same_answer (orientation_3_exact (point_3 ax ay az) (point_3 bx by' bz) (point_3 cx cy cz) (point_3 dx dy dz)) e.
Definition interval_bicell ax ay az bx by' bz cx cy cz px py pz qx qy qz (i : answer float) : bool :=
  same_answer (empty_sphere_3_interval (point_3 ax ay az) (point_3 bx by' bz) (point_3 cx cy cz) (point_3 px py pz) (point_3 qx qy qz) where_needed) i.
Definition both_bicell ax ay az bx by' bz cx cy cz px py pz qx qy qz (i e : answer float) : bool :=
  interval_bicell ax ay az bx by' bz cx cy cz px py pz qx qy qz i &&
  same_answer (empty_sphere_3_exact (point_3 ax ay az) (point_3 bx by' bz) (point_3 cx cy cz) (point_3 px py pz) (point_3 qx qy qz) where_needed) e.
Definition filter_and_interval_3 ax ay az bx by' bz cx cy cz px py pz qx qy qz (k i : answer float) : bool :=
  same_answer (bicell_filter machine (point_3 ax ay az) (point_3 bx by' bz) (point_3 cx cy cz) (point_3 px py pz) (point_3 qx qy qz)
                 true where_needed) k &&
  interval_bicell ax ay az bx by' bz cx cy cz px py pz qx qy qz i.

Definition agrees_orientation_3_later := on_orientation_3 both_tetrahedron judge_tetrahedron.
Definition agrees_empty_sphere_3_later := on_later both_bicell judge_bicell.
Definition agrees_named_3 := on_named_3 judge_bicell filter_and_interval_3.
Definition orientation_3_later_certified : forall r, agrees_orientation_3_later r = true -> worth_orientation_3 true_tetrahedron r :=
  orientation_3_worth both_tetrahedron judge_tetrahedron true_tetrahedron judge_tetrahedron_spec.
Definition empty_sphere_3_later_certified : forall r, agrees_empty_sphere_3_later r = true -> worth_later true_bicell r :=
  later_worth both_bicell judge_bicell true_bicell judge_bicell_spec.
Definition named_3_certified : forall r, agrees_named_3 r = true -> worth_named_3 true_bicell r :=
  named_3_worth judge_bicell filter_and_interval_3 true_bicell judge_bicell_spec.
