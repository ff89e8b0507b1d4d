(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Rows of the later stages in space, and of the filtered predicate: as later_2.v. *)
From Coq Require Import List Floats Bool String.
From Annulus Require Import operations filter_2 filter_3 interval_3 exact_3.
From Annulus_link Require Import replay_2 replay_3 truth_2 later_2 truth_3.
Import ListNotations.

Inductive orientation_3_later :=
  Later_orientation_3 (ax ay az bx by' bz cx cy cz dx dy dz : float) (interval exact lower_bound correctly_rounded : answer float).
Inductive empty_sphere_3_later :=
  Later_empty_sphere_3 (ax ay az bx by' bz cx cy cz px py pz qx qy qz : float) (interval exact lower_bound correctly_rounded : answer float).
(* The published table: filter, interval and exact stage, and the filtered predicate. *)
Inductive named_3 :=
  Named_3 (name : string) (ax ay az bx by' bz cx cy cz px py pz qx qy qz : float) (filter interval exact lower_bound correctly_rounded : answer float).

(* As in later_2.v: tests are variables here, because a conversion that tried to evaluate them would not end. *)
Section tests.
Let of_points (A : Type) := float -> float -> float -> float -> float -> float -> float -> float -> float -> float -> float -> float -> A.
Let on_four (A : Type) := of_points (answer float -> answer float -> A).
Let on_five (A : Type) := of_points (float -> float -> float -> answer float -> answer float -> A).
Variable f4 : of_points (answer float -> answer float -> answer float -> answer float -> bool).
Variable g4 : on_four bool.
Variable f : of_points (float -> float -> float -> answer float -> answer float -> answer float -> answer float -> bool).
Variables g h : on_five bool.
Definition on_orientation_3 (r : orientation_3_later) :=
  let (ax, ay, az, bx, by', bz, cx, cy, cz, dx, dy, dz, i, e, lower_bound, correctly_rounded) := r in
  f4 ax ay az bx by' bz cx cy cz dx dy dz i e lower_bound correctly_rounded && g4 ax ay az bx by' bz cx cy cz dx dy dz i e.
Definition on_later (r : empty_sphere_3_later) :=
  let (ax, ay, az, bx, by', bz, cx, cy, cz, px, py, pz, qx, qy, qz, i, e, lower_bound, correctly_rounded) := r in
  f ax ay az bx by' bz cx cy cz px py pz qx qy qz i e lower_bound correctly_rounded && g ax ay az bx by' bz cx cy cz px py pz qx qy qz i e.
Definition on_named_3 (r : named_3) :=
  let (_, ax, ay, az, bx, by', bz, cx, cy, cz, px, py, pz, qx, qy, qz, k, i, e, lower_bound, correctly_rounded) := r in
  (h ax ay az bx by' bz cx cy cz px py pz qx qy qz k i && same_staged k i e lower_bound correctly_rounded) &&
  (g ax ay az bx by' bz cx cy cz px py pz qx qy qz k e && g ax ay az bx by' bz cx cy cz px py pz qx qy qz i e).

Variable P4 : on_four Prop.
Variable P : on_five Prop.
Hypothesis G4 : forall ax ay az bx by' bz cx cy cz dx dy dz i e,
  g4 ax ay az bx by' bz cx cy cz dx dy dz i e = true -> P4 ax ay az bx by' bz cx cy cz dx dy dz i e.
Hypothesis G : forall ax ay az bx by' bz cx cy cz px py pz qx qy qz i e,
  g ax ay az bx by' bz cx cy cz px py pz qx qy qz i e = true -> P ax ay az bx by' bz cx cy cz px py pz qx qy qz i e.
Definition worth_orientation_3 (r : orientation_3_later) : Prop :=
  let (ax, ay, az, bx, by', bz, cx, cy, cz, dx, dy, dz, i, e, _, _) := r in P4 ax ay az bx by' bz cx cy cz dx dy dz i e.
Definition worth_later (r : empty_sphere_3_later) : Prop :=
  let (ax, ay, az, bx, by', bz, cx, cy, cz, px, py, pz, qx, qy, qz, i, e, _, _) := r in
  P ax ay az bx by' bz cx cy cz px py pz qx qy qz i e.
Definition worth_named_3 (r : named_3) : Prop :=
  let (_, ax, ay, az, bx, by', bz, cx, cy, cz, px, py, pz, qx, qy, qz, k, i, e, _, _) := r in
  P ax ay az bx by' bz cx cy cz px py pz qx qy qz k e /\ P ax ay az bx by' bz cx cy cz px py pz qx qy qz i e.

Lemma orientation_3_worth : forall r, on_orientation_3 r = true -> worth_orientation_3 r.
Proof. intros [ax ay az bx by' bz cx cy cz dx dy dz i e lower_bound correctly_rounded] H. apply andb_prop in H. apply G4, H. Qed.
Lemma later_worth : forall r, on_later r = true -> worth_later r.
Proof. intros [ax ay az bx by' bz cx cy cz px py pz qx qy qz i e lower_bound correctly_rounded] H. apply andb_prop in H. apply G, H. Qed.
Lemma named_3_worth : forall r, on_named_3 r = true -> worth_named_3 r.
Proof.
  intros [name ax ay az bx by' bz cx cy cz px py pz qx qy qz k i e lower_bound correctly_rounded] H. apply andb_prop in H. destruct H as [_ H].
  apply andb_prop in H. destruct H. split; apply G; assumption.
Qed.
End tests.

(* The interval and the exact stage and the filtered predicate, replayed; for the table filter and intervals. *)
Definition stages_tetrahedron ax ay az bx by' bz cx cy cz dx dy dz (i e lower_bound correctly_rounded : answer float) : bool :=
  let a := point_3 ax ay az in let b := point_3 bx by' bz in let c := point_3 cx cy cz in let d := point_3 dx dy dz in
  same_stages (orientation_filter_3 machine a b c d true) (orientation_3_interval a b c d) (orientation_3_exact a b c d) i e lower_bound correctly_rounded.
Definition stages_bicell ax ay az bx by' bz cx cy cz px py pz qx qy qz (i e lower_bound correctly_rounded : answer float) : bool :=
  let a := point_3 ax ay az in let b := point_3 bx by' bz in let c := point_3 cx cy cz in let p := point_3 px py pz in let q := point_3 qx qy qz in
  same_stages (bicell_filter machine a b c p q true where_needed) (empty_sphere_3_interval a b c p q where_needed)
    (empty_sphere_3_exact a b c p q where_needed) i e lower_bound correctly_rounded.
Definition filter_and_interval_3 ax ay az bx by' bz cx cy cz px py pz qx qy qz (k i : answer float) : bool :=
  same_answer (bicell_filter machine (point_3 ax ay az) (point_3 bx by' bz) (point_3 cx cy cz) (point_3 px py pz) (point_3 qx qy qz)
                 true where_needed) k &&
  same_answer (empty_sphere_3_interval (point_3 ax ay az) (point_3 bx by' bz) (point_3 cx cy cz) (point_3 px py pz) (point_3 qx qy qz) where_needed) i.

Definition agrees_orientation_3_later := on_orientation_3 stages_tetrahedron judge_tetrahedron.
Definition agrees_empty_sphere_3_later := on_later stages_bicell judge_bicell.
Definition agrees_named_3 := on_named_3 judge_bicell filter_and_interval_3.
Definition orientation_3_later_certified : forall r, agrees_orientation_3_later r = true -> worth_orientation_3 true_tetrahedron r :=
  orientation_3_worth stages_tetrahedron judge_tetrahedron true_tetrahedron judge_tetrahedron_spec.
Definition empty_sphere_3_later_certified : forall r, agrees_empty_sphere_3_later r = true -> worth_later true_bicell r :=
  later_worth stages_bicell judge_bicell true_bicell judge_bicell_spec.
Definition named_3_certified : forall r, agrees_named_3 r = true -> worth_named_3 true_bicell r :=
  named_3_worth judge_bicell filter_and_interval_3 true_bicell judge_bicell_spec.
