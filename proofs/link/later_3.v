(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Rows of the later stages in space: both are judged by the truth; the interval stage is not replayed. *)
From Coq Require Import List Floats Bool String.
From Annulus Require Import operations filter_2 filter_3.
From Annulus_link Require Import replay_2 replay_3 truth_3.
Import ListNotations.

Inductive empty_sphere_3_later :=
  Later_empty_sphere_3 (ax ay az bx by' bz cx cy cz px py pz qx qy qz : float) (interval exact : answer float).
(* The published table: filter, interval and exact stage. *)
Inductive named_3 :=
  Named_3 (name : string) (ax ay az bx by' bz cx cy cz px py pz qx qy qz : float) (filter interval exact : answer float).

Section tests.
Let test := float -> float -> float -> float -> float -> float -> float -> float -> float -> float -> float -> float ->
  float -> float -> float -> answer float -> answer float -> bool.
Variables f g : test.
Definition on_later (r : empty_sphere_3_later) :=
  let (ax, ay, az, bx, by', bz, cx, cy, cz, px, py, pz, qx, qy, qz, i, e) := r in
  g ax ay az bx by' bz cx cy cz px py pz qx qy qz i e.
Definition on_named_3 (r : named_3) :=
  let (_, ax, ay, az, bx, by', bz, cx, cy, cz, px, py, pz, qx, qy, qz, k, i, e) := r in
  f ax ay az bx by' bz cx cy cz px py pz qx qy qz k e &&
  (g ax ay az bx by' bz cx cy cz px py pz qx qy qz k e && g ax ay az bx by' bz cx cy cz px py pz qx qy qz i e).

Variable P : float -> float -> float -> float -> float -> float -> float -> float -> float -> float -> float -> float ->
  float -> float -> float -> answer float -> answer float -> Prop.
Hypothesis G : forall ax ay az bx by' bz cx cy cz px py pz qx qy qz i e,
  g ax ay az bx by' bz cx cy cz px py pz qx qy qz i e = true -> P ax ay az bx by' bz cx cy cz px py pz qx qy qz i e.
Definition worth_later (r : empty_sphere_3_later) : Prop :=
  let (ax, ay, az, bx, by', bz, cx, cy, cz, px, py, pz, qx, qy, qz, i, e) := r in
  P ax ay az bx by' bz cx cy cz px py pz qx qy qz i e.
Definition worth_named_3 (r : named_3) : Prop :=
  let (_, ax, ay, az, bx, by', bz, cx, cy, cz, px, py, pz, qx, qy, qz, k, i, e) := r in
  P ax ay az bx by' bz cx cy cz px py pz qx qy qz k e /\ P ax ay az bx by' bz cx cy cz px py pz qx qy qz i e.

Lemma later_worth : forall r, on_later r = true -> worth_later r.
Proof. intros [ax ay az bx by' bz cx cy cz px py pz qx qy qz i e] H. apply G, H. Qed.
Lemma named_3_worth : forall r, on_named_3 r = true -> worth_named_3 r.
Proof.
  intros [name ax ay az bx by' bz cx cy cz px py pz qx qy qz k i e] H. apply andb_prop in H. destruct H as [_ H].
  apply andb_prop in H. destruct H. split; apply G; assumption.
Qed.
End tests.

Definition filter_bicell ax ay az bx by' bz cx cy cz px py pz qx qy qz (k _ : answer float) : bool :=
  same_answer (bicell_filter machine (point_3 ax ay az) (point_3 bx by' bz) (point_3 cx cy cz) (point_3 px py pz) (point_3 qx qy qz)
                 true where_needed) k.

Definition agrees_empty_sphere_3_later := on_later judge_bicell.
Definition agrees_named_3 := on_named_3 filter_bicell judge_bicell.
Definition empty_sphere_3_later_certified : forall r, agrees_empty_sphere_3_later r = true -> worth_later true_bicell r :=
  later_worth judge_bicell true_bicell judge_bicell_spec.
Definition named_3_certified : forall r, agrees_named_3 r = true -> worth_named_3 true_bicell r :=
  named_3_worth filter_bicell judge_bicell true_bicell judge_bicell_spec.
