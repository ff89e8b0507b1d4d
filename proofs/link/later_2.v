(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Rows of the interval and the exact stage: the interval stage is replayed, both are judged by the truth. *)
From Coq Require Import List Floats Bool String.
From Annulus_link Require Import operations filter_2 replay_2 interval_2 truth_2.
Import ListNotations.

Inductive orientation_2_later := Later_orientation_2 (ax ay bx by' cx cy : float) (interval exact : answer float).
Inductive empty_sphere_2_later := Later_empty_sphere_2 (ax ay bx by' px py qx qy : float) (interval exact : answer float).

Definition agrees_orientation_2_later (r : orientation_2_later) :=
  let (ax, ay, bx, by', cx, cy, i, e) := r in
  same_answer (orientation_interval (point ax ay) (point bx by') (point cx cy)) i && judge_orientation ax ay bx by' cx cy i e.

Definition agrees_empty_sphere_2_later (r : empty_sphere_2_later) :=
  let (ax, ay, bx, by', px, py, qx, qy, i, e) := r in
  same_answer (empty_sphere_interval (point ax ay) (point bx by') (point px py) (point qx qy)) i &&
  judge_annulus ax ay bx by' px py qx qy i e.

(* What a row is worth: the interval stage is sound, the exact one sharp. *)
Definition certified_orientation_2_later (r : orientation_2_later) : Prop :=
  let (ax, ay, bx, by', cx, cy, i, e) := r in
  let t := orientation_of reals (real_point ax ay) (real_point bx by') (real_point cx cy) in soundly t i /\ sharply t e.
Definition certified_empty_sphere_2_later (r : empty_sphere_2_later) : Prop :=
  let (ax, ay, bx, by', px, py, qx, qy, i, e) := r in
  let t := annulus_of reals (real_point ax ay) (real_point bx by') (real_point px py) (real_point qx qy) in
  soundly t i /\ sharply t e.

Lemma orientation_2_later_certified : forall r, agrees_orientation_2_later r = true -> certified_orientation_2_later r.
Proof. intros [ax ay bx by' cx cy i e] H. apply andb_prop in H. apply judge_orientation_spec, H. Qed.
Lemma empty_sphere_2_later_certified : forall r, agrees_empty_sphere_2_later r = true -> certified_empty_sphere_2_later r.
Proof. intros [ax ay bx by' px py qx qy i e] H. apply andb_prop in H. apply judge_annulus_spec, H. Qed.

(* The published table: what all three stages say of a bi-cell with a name. *)
Inductive named_2 := Named_2 (name : string) (ax ay bx by' px py qx qy : float) (filter interval exact : answer float).
Definition agrees_named_2 (r : named_2) :=
  let (_, ax, ay, bx, by', px, py, qx, qy, f, i, e) := r in
  same_answer (empty_sphere_filter machine (point ax ay) (point bx by') (point px py) (point qx qy) true) f &&
  same_answer (empty_sphere_interval (point ax ay) (point bx by') (point px py) (point qx qy)) i &&
  judge_annulus ax ay bx by' px py qx qy f e && judge_annulus ax ay bx by' px py qx qy i e.

(* Filter and interval stage are sound and the exact stage is sharp. *)
Definition certified_named_2 (r : named_2) : Prop :=
  let (_, ax, ay, bx, by', px, py, qx, qy, f, i, e) := r in
  let t := annulus_of reals (real_point ax ay) (real_point bx by') (real_point px py) (real_point qx qy) in
  soundly t f /\ soundly t i /\ sharply t e.

Lemma named_2_certified : forall r, agrees_named_2 r = true -> certified_named_2 r.
Proof.
  intros [name ax ay bx by' px py qx qy f i e] H. unfold agrees_named_2 in H. rewrite !andb_true_iff in H.
  destruct H as [[[_ _] F] I]. apply judge_annulus_spec in F, I.
  destruct F as [F E], I as [I _]. split; [exact F|split; [exact I|exact E]].
Qed.
