(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Rows of the interval and the exact stage: both are replayed, and judged by the truth. Beside them stands what the filtered predicate of all stages answers of
   the same points in the modes `lower_bound` and `correctly_rounded` (batch.h); it is replayed too, and predicates.v says that it is the filtered predicate of coq/. *)
From Coq Require Import List Floats Bool String.
From Annulus Require Import operations filter_2 stages integers_2 interval_2 exact_2.
From Annulus_link Require Import replay_2 truth_2.
Import ListNotations.

(* A row is judged by two tests; the second one says what it is worth. Tests are variables here: a conversion that tried to
   evaluate them would not end. *)
Inductive orientation_2_later := Later_orientation_2 (ax ay bx by' cx cy : float) (interval exact lower_bound correctly_rounded : answer float).
Inductive empty_sphere_2_later := Later_empty_sphere_2 (ax ay bx by' px py qx qy : float) (interval exact lower_bound correctly_rounded : answer float).
(* The published table: what all three stages and the filtered predicate say of a bi-cell with a name. *)
Inductive named_2 := Named_2 (name : string) (ax ay bx by' px py qx qy : float) (filter interval exact lower_bound correctly_rounded : answer float).

(* What the filtered predicate answers of these answers of its stages. *)
Definition same_staged (f i e lower_bound correctly_rounded : answer float) := same_answer (staged false f i e) lower_bound && same_answer (staged true f i e) correctly_rounded.
(* Replayed answers f, i, e of the stages, of which i', e' and those of the filtered predicate were printed. *)
Definition same_stages (f i e i' e' lower_bound correctly_rounded : answer float) := (same_answer i i' && same_answer e e') && same_staged f i e lower_bound correctly_rounded.

Section tests.
Variable f3 : float -> float -> float -> float -> float -> float -> answer float -> answer float -> answer float -> answer float -> bool.
Variable f4 : float -> float -> float -> float -> float -> float -> float -> float -> answer float -> answer float -> answer float -> answer float -> bool.
Variable g4 : float -> float -> float -> float -> float -> float -> float -> float -> answer float -> answer float -> bool.
Variable h4 : float -> float -> float -> float -> float -> float -> float -> float -> answer float -> answer float -> bool.
Variable g3 : float -> float -> float -> float -> float -> float -> answer float -> answer float -> bool.

Definition on_orientation (r : orientation_2_later) :=
  let (ax, ay, bx, by', cx, cy, i, e, lower_bound, correctly_rounded) := r in f3 ax ay bx by' cx cy i e lower_bound correctly_rounded && g3 ax ay bx by' cx cy i e.
Definition on_empty_sphere (r : empty_sphere_2_later) :=
  let (ax, ay, bx, by', px, py, qx, qy, i, e, lower_bound, correctly_rounded) := r in f4 ax ay bx by' px py qx qy i e lower_bound correctly_rounded && g4 ax ay bx by' px py qx qy i e.
Definition on_named (r : named_2) :=
  let (_, ax, ay, bx, by', px, py, qx, qy, f, i, e, lower_bound, correctly_rounded) := r in
  (h4 ax ay bx by' px py qx qy f i && same_staged f i e lower_bound correctly_rounded) && (g4 ax ay bx by' px py qx qy f e && g4 ax ay bx by' px py qx qy i e).

Variable P3 : float -> float -> float -> float -> float -> float -> answer float -> answer float -> Prop.
Variable P4 : float -> float -> float -> float -> float -> float -> float -> float -> answer float -> answer float -> Prop.
Hypothesis G3 : forall ax ay bx by' cx cy i e, g3 ax ay bx by' cx cy i e = true -> P3 ax ay bx by' cx cy i e.
Hypothesis G4 : forall ax ay bx by' px py qx qy i e, g4 ax ay bx by' px py qx qy i e = true -> P4 ax ay bx by' px py qx qy i e.

Definition worth_orientation (r : orientation_2_later) : Prop := let (ax, ay, bx, by', cx, cy, i, e, _, _) := r in P3 ax ay bx by' cx cy i e.
Definition worth_empty_sphere (r : empty_sphere_2_later) : Prop :=
  let (ax, ay, bx, by', px, py, qx, qy, i, e, _, _) := r in P4 ax ay bx by' px py qx qy i e.
Definition worth_named (r : named_2) : Prop :=
  let (_, ax, ay, bx, by', px, py, qx, qy, f, i, e, _, _) := r in P4 ax ay bx by' px py qx qy f e /\ P4 ax ay bx by' px py qx qy i e.

Lemma orientation_worth : forall r, on_orientation r = true -> worth_orientation r.
Proof. intros [ax ay bx by' cx cy i e lower_bound correctly_rounded] H. apply andb_prop in H. apply G3, H. Qed.
Lemma empty_sphere_worth : forall r, on_empty_sphere r = true -> worth_empty_sphere r.
Proof. intros [ax ay bx by' px py qx qy i e lower_bound correctly_rounded] H. apply andb_prop in H. apply G4, H. Qed.
Lemma named_worth : forall r, on_named r = true -> worth_named r.
Proof.
  intros [name ax ay bx by' px py qx qy f i e lower_bound correctly_rounded] H. apply andb_prop in H. destruct H as [_ H]. apply andb_prop in H.
  destruct H. split; apply G4; assumption.
Qed.
End tests.

(* The interval and the exact stage and the filtered predicate, replayed; for the table filter and intervals. *)
Definition stages_orientation ax ay bx by' cx cy (i e lower_bound correctly_rounded : answer float) :=
  let a := point ax ay in let b := point bx by' in let c := point cx cy in
  same_stages (orientation_filter machine a b c true) (orientation_interval a b c) (orientation_exact a b c) i e lower_bound correctly_rounded.
Definition stages_annulus ax ay bx by' px py qx qy (i e lower_bound correctly_rounded : answer float) :=
  let a := point ax ay in let b := point bx by' in let p := point px py in let q := point qx qy in
  same_stages (empty_sphere_filter machine a b p q true) (empty_sphere_interval a b p q) (empty_sphere_exact a b p q) i e lower_bound correctly_rounded.
Definition filter_and_interval ax ay bx by' px py qx qy (f i : answer float) :=
  same_answer (empty_sphere_filter machine (point ax ay) (point bx by') (point px py) (point qx qy) true) f &&
  same_answer (empty_sphere_interval (point ax ay) (point bx by') (point px py) (point qx qy)) i.

Definition agrees_orientation_2_later := on_orientation stages_orientation judge_orientation.
Definition agrees_empty_sphere_2_later := on_empty_sphere stages_annulus judge_annulus.
Definition agrees_named_2 := on_named judge_annulus filter_and_interval.

(* The first answer is sound, the second sharp: judge_orientation_spec, judge_annulus_spec. *)
Definition true_orientation ax ay bx by' cx cy (i e : answer float) :=
  let t := orientation_of reals (real_point ax ay) (real_point bx by') (real_point cx cy) in soundly t i /\ sharply t e.
Definition true_annulus ax ay bx by' px py qx qy (i e : answer float) :=
  let t := annulus_of reals (real_point ax ay) (real_point bx by') (real_point px py) (real_point qx qy) in soundly t i /\ sharply t e.

Definition orientation_2_later_certified : forall r, agrees_orientation_2_later r = true -> worth_orientation true_orientation r :=
  orientation_worth stages_orientation judge_orientation true_orientation judge_orientation_spec.
Definition empty_sphere_2_later_certified : forall r, agrees_empty_sphere_2_later r = true -> worth_empty_sphere true_annulus r :=
  empty_sphere_worth stages_annulus judge_annulus true_annulus judge_annulus_spec.
Definition named_2_certified : forall r, agrees_named_2 r = true -> worth_named true_annulus r :=
  named_worth judge_annulus filter_and_interval true_annulus judge_annulus_spec.
