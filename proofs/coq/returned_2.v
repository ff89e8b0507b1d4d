(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Returned implies certifies, in the plane: for finite doubles of the coordinate domain, |x|, |y| <= 2^500, and the very operations that the
   compiled code carries out (filter_2.v in Coq's primitive floats, replayed by link/check), overflow and underflow within the theorem.

   - orientation_2_returned, empty_sphere_2_returned   a sign is right; a tolerance is a finite number, at most half the least altitude or half the width
   - orientation_2_returned_certifies    every placement in which each point is closer than the tolerance to where it was is positive
   - empty_sphere_2_returned_certifies   the same of an empty circle whose triangles are positive at the reference and at the placement
   Of the stages after it: interval_returned_2.v, exact_returned_2.v; of all together: predicate_2.v. *)
From Coq Require Import Reals ZArith Lra Rgeom List.
From Flocq Require Import Core.
From Coq Require Import Floats.
From Annulus Require float_model float_filter_2 float_circle_2 float_filter float_certifies_2.
From Annulus Require Import points_2 width_2 sign_tolerance_2 filter_doubles algorithm_filter filter_plane.
From Annulus Require Import operations bridge bridge_decide filter_2 bridge_2 connect connect_2.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

Definition at_2 (v : vector machine) : point_2 := (value (x _ v), value (y _ v)).
Definition coordinates_2 (v : vector machine) : Prop := coordinate (x _ v) /\ coordinate (y _ v).

Lemma at_domain_2 : forall v, coordinates_2 v -> in_domain v (real (fst (at_2 v)) (snd (at_2 v))).
Proof. intros v [A B]. split; now apply coordinate_stands. Qed.

Section returned.
Variable f : nat -> vector machine.                   (* what the code is given *)
Let at_reference : nat -> point_2 := fun v => at_2 (f v).   (* where that is *)
Notation ref := at_reference.

Section orientation.
Variables a b c : nat.
Hypothesis domain : forall v, In v [a; b; c] -> coordinates_2 (f v).
Let answer := orientation_filter machine (f a) (f b) (f c) true.

Let stage := float_filter_2.orientation_filter (fst (ref a)) (snd (ref a)) (fst (ref b)) (snd (ref b)) (fst (ref c)) (snd (ref c)) true.

Lemma orientation_stage : stands_answer answer (convert stage) /\ signed stage /\ forall s v, stage = Some (s, v) ->
  s = 1%Z /\ 0 < turn_at ref a b c /\ 0 <= v <= half_altitude_at ref a b c \/ s = (-1)%Z /\ turn_at ref a b c < 0.
Proof.
  assert (B : forall s v, stage = Some (s, v) ->
    s = 1%Z /\ 0 < turn_at ref a b c /\ 0 <= v <= half_altitude_at ref a b c \/ s = (-1)%Z /\ turn_at ref a b c < 0).
  { intros s v A. exact (float_certifies_2.triangle_bound _ _ _ _ _ _ s v (value_format _) (value_format _) (value_format _) (value_format _)
      (value_format _) (value_format _) A). }
  split; [|split; [|exact B]].
  - unfold stage. rewrite <- orientation_is. apply (orientation_filter_stands true); apply at_domain_2, domain; simpl; tauto.
  - intros s v A. destruct (B s v A) as [[-> _]|[-> _]]; auto.
Qed.

Theorem orientation_2_returned :
  match answer with
  | refused => True
  | positive t => finite t = true /\ 0 < turn_at ref a b c /\ 0 <= value t <= half_altitude_at ref a b c
  | negative _ => turn_at ref a b c < 0
  | zero _ => False
  end.
Proof.
  destruct orientation_stage as (A & S & B). revert A. destruct answer as [|t|t|t]; intro A; [trivial| | |].
  - destruct (returned_negative _ t S A) as [v E]. destruct (B _ _ E) as [[N _]|[_ N]]; [discriminate|exact N].
  - exact (never_zero _ t A).
  - destruct (returned_positive _ t S A) as [F E]. destruct (B _ _ E) as [[_ P]|[N _]]; [now split|discriminate].
Qed.

Theorem orientation_2_returned_certifies : forall tolerance (m : nat -> point_2), answer = positive tolerance ->
  (forall v, In v [a; b; c] -> dist_2 (ref v) (m v) < value tolerance) -> 0 < turn_at m a b c.
Proof.
  intros tolerance m A Near. generalize orientation_2_returned. rewrite A. intros (_ & P & _ & H).
  apply (orientation_tolerance_2 _ _ _ _ _ _ P _ _ _ _ _ _ (value tolerance) H);
    [apply (Near a)|apply (Near b)|apply (Near c)]; simpl; tauto.
Qed.
End orientation.

Section circle.
Variables a b p q : nat.
Hypothesis domain : forall v, In v [a; b; p; q] -> coordinates_2 (f v).
Let answer := empty_sphere_filter machine (f a) (f b) (f p) (f q) true.

Let stage := float_circle_2.circle_filter (fst (ref a)) (snd (ref a)) (fst (ref b)) (snd (ref b))
  (fst (ref p)) (snd (ref p)) (fst (ref q)) (snd (ref q)) true.

Lemma circle_stage : stands_answer answer (convert stage) /\ signed stage /\ forall s v, stage = Some (s, v) ->
  s = 1%Z /\ 0 < incircle_at ref a b p q /\ 0 <= v <= half_width_at ref a b p q \/ s = (-1)%Z /\ incircle_at ref a b p q < 0.
Proof.
  assert (B : forall s v, stage = Some (s, v) ->
    s = 1%Z /\ 0 < incircle_at ref a b p q /\ 0 <= v <= half_width_at ref a b p q \/ s = (-1)%Z /\ incircle_at ref a b p q < 0).
  { intros s v A. exact (float_certifies_2.circle_bound _ _ _ _ _ _ _ _ s v (value_format _) (value_format _) (value_format _) (value_format _)
      (value_format _) (value_format _) (value_format _) (value_format _) A). }
  split; [|split; [|exact B]].
  - unfold stage. rewrite <- empty_sphere_is. apply (empty_sphere_filter_stands true); apply at_domain_2, domain; simpl; tauto.
  - intros s v A. destruct (B s v A) as [[-> _]|[-> _]]; auto.
Qed.

Theorem empty_sphere_2_returned :
  match answer with
  | refused => True
  | positive t => finite t = true /\ 0 < incircle_at ref a b p q /\ 0 <= value t <= half_width_at ref a b p q
  | negative _ => incircle_at ref a b p q < 0
  | zero _ => False
  end.
Proof.
  destruct circle_stage as (A & S & B). revert A. destruct answer as [|t|t|t]; intro A; [trivial| | |].
  - destruct (returned_negative _ t S A) as [v E]. destruct (B _ _ E) as [[N _]|[_ N]]; [discriminate|exact N].
  - exact (never_zero _ t A).
  - destruct (returned_positive _ t S A) as [F E]. destruct (B _ _ E) as [[_ P]|[N _]]; [now split|discriminate].
Qed.

Theorem empty_sphere_2_returned_certifies : forall tolerance (m : nat -> point_2), answer = positive tolerance ->
  0 < turn_at ref a b q -> 0 < turn_at ref b a p -> 0 < turn_at m a b q -> 0 < turn_at m b a p ->
  (forall v, In v [a; b; p; q] -> dist_2 (ref v) (m v) < value tolerance) -> 0 < incircle_at m a b p q.
Proof.
  intros tolerance m A Tq Tp Mq Mp Near. generalize empty_sphere_2_returned. rewrite A. intros (_ & P & _ & H).
  apply (circle_tolerance_2 _ _ _ _ _ _ _ _ Tq Tp P _ _ _ _ _ _ _ _ Mq Mp (value tolerance) H);
    [apply (Near a)|apply (Near b)|apply (Near p)|apply (Near q)]; simpl; tauto.
Qed.
End circle.
End returned.
