(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The whole filtered predicate in the plane: the filter in doubles, then intervals, then integers (src/annulus/predicate/batch.cpp, `all_stages`). Whichever stage
   answers, of finite doubles of the coordinate domain:

   - orientation_2_right, empty_sphere_2_right    there is an answer, and it is right: a sign, 0 included; a tolerance that is at most half the least
                                                altitude or half the width
   - orientation_2_certifies, empty_sphere_2_certifies   the certificate holds in every placement in which each point is closer than that to where it was
   - triangle_answered, circle_answered         it is a verdict that filter_plane.v takes *)
From Coq Require Import Reals Lra ZArith List.
From Coq Require Import Floats.
From Annulus Require Import points_2 width_2 sign_tolerance_2 algorithm_filter filter_doubles filter_plane.
From Annulus Require Import operations bridge connect filter_2 stages interval_2 exact_2 returned_2 interval_returned_2 exact_returned_2.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

Definition orientation_predicate (correctly_rounded : bool) (a b c : vector machine) : answer float :=
  staged correctly_rounded (orientation_filter machine a b c true) (orientation_interval a b c) (orientation_exact a b c).
Definition empty_sphere_predicate (correctly_rounded : bool) (a b p q : vector machine) : answer float :=
  staged correctly_rounded (empty_sphere_filter machine a b p q true) (empty_sphere_interval a b p q) (empty_sphere_exact a b p q).

Section staged.
Variable f : nat -> vector machine.                   (* what the code is given *)
Let ref : nat -> point_2 := fun v => at_2 (f v).      (* where that is *)
Variable correctly_rounded : bool.

Theorem orientation_2_right a b c : (forall v, In v [a; b; c] -> coordinates_2 (f v)) ->
  right_answer (orientation_predicate correctly_rounded (f a) (f b) (f c)) (turn_at ref a b c) (half_altitude_at ref a b c) /\
  orientation_predicate correctly_rounded (f a) (f b) (f c) <> refused.
Proof.
  intro D. destruct (orientation_exact_returned f a b c) as [E N]. apply stages_right; trivial; [|now apply orientation_interval_returned].
  generalize (orientation_2_returned f a b c D). destruct (orientation_filter machine _ _ _ true); simpl; tauto.
Qed.

Theorem empty_sphere_2_right a b p q : (forall v, In v [a; b; p; q] -> coordinates_2 (f v)) ->
  right_answer (empty_sphere_predicate correctly_rounded (f a) (f b) (f p) (f q)) (incircle_at ref a b p q) (half_width_at ref a b p q) /\
  empty_sphere_predicate correctly_rounded (f a) (f b) (f p) (f q) <> refused.
Proof.
  intro D. destruct (empty_sphere_exact_returned f a b p q) as [E N]. apply stages_right; trivial; [|now apply empty_sphere_interval_returned].
  generalize (empty_sphere_2_returned f a b p q D). destruct (empty_sphere_filter machine _ _ _ _ true); simpl; tauto.
Qed.

Theorem orientation_2_certifies a b c t (m : nat -> point_2) : (forall v, In v [a; b; c] -> coordinates_2 (f v)) ->
  orientation_predicate correctly_rounded (f a) (f b) (f c) = positive t -> (forall v, In v [a; b; c] -> dist_2 (ref v) (m v) < value t) -> 0 < turn_at m a b c.
Proof.
  intros D A Near. destruct (orientation_2_right a b c D) as [R _]. rewrite A in R. destruct R as (_ & P & _ & H).
  apply (orientation_tolerance_2 _ _ _ _ _ _ P _ _ _ _ _ _ (value t) H); [apply (Near a)|apply (Near b)|apply (Near c)]; simpl; tauto.
Qed.

Theorem empty_sphere_2_certifies a b p q t (m : nat -> point_2) : (forall v, In v [a; b; p; q] -> coordinates_2 (f v)) ->
  empty_sphere_predicate correctly_rounded (f a) (f b) (f p) (f q) = positive t ->
  0 < turn_at ref a b q -> 0 < turn_at ref b a p -> 0 < turn_at m a b q -> 0 < turn_at m b a p ->
  (forall v, In v [a; b; p; q] -> dist_2 (ref v) (m v) < value t) -> 0 < incircle_at m a b p q.
Proof.
  intros D A Tq Tp Mq Mp Near. destruct (empty_sphere_2_right a b p q D) as [R _]. rewrite A in R. destruct R as (_ & P & _ & H).
  apply (circle_tolerance_2 _ _ _ _ _ _ _ _ Tq Tp P _ _ _ _ _ _ _ _ Mq Mp (value t) H);
    [apply (Near a)|apply (Near b)|apply (Near p)|apply (Near q)]; simpl; tauto.
Qed.
End staged.

(* Whatever the lists of filter_plane.v. *)
Section answered.
Variables (capacity : nat) (stamps : Z) (worn : R -> algorithm_list.expiry_list -> bool).
Variable tie : certificate_2 -> (nat -> point_2) -> Prop.
Let Plane := plane capacity stamps worn tie.
Notation answered := (answered capacity stamps worn tie).
Variables (f : nat -> vector machine) (i : Z) (correctly_rounded : bool).
Let ref : nat -> point_2 := fun v => at_2 (f v).

Lemma triangle_says a b c rule r : (forall v, In v [a; b; c] -> coordinates_2 (f v)) -> says (orientation_predicate correctly_rounded (f a) (f b) (f c)) rule r ->
  0 <= r /\ float_model.F r /\ 0 < turn_at ref a b c /\ r <= half_altitude_at ref a b c \/ r = 0 /\ turn_at ref a b c = 0 /\ rule.
Proof.
  intros D S. destruct (orientation_2_right f correctly_rounded a b c D) as [R _]. revert R S. destruct (orientation_predicate _ _ _ _) as [|t|t|t]; simpl; try contradiction.
  - intros Z [Q ->]. right. auto.
  - intros (_ & P & H0 & H) ->. left. split; [exact H0|]. split; [apply value_format|auto].
Qed.

Theorem triangle_answered a b c r : (forall v, In v [a; b; c] -> coordinates_2 (f v)) ->
  (says (orientation_predicate correctly_rounded (f a) (f b) (f c)) False r -> answered ref (@Build_verdict Plane i (cell a b c) r)) /\
  (says (orientation_predicate correctly_rounded (f a) (f b) (f c)) (tie (ridge a b c) ref) r -> answered ref (@Build_verdict Plane i (ridge a b c) r)).
Proof.
  intro D. split; intro S; destruct (triangle_says _ _ _ _ _ D S) as [(R0 & Fr & P & H)|(-> & Z & Q)]; try contradiction.
  - left. split; [exact R0|]. split; [exact Fr|]. split; [exact P|]. split; [exact P|exact H].
  - left. split; [exact R0|]. split; [exact Fr|]. split; [left; exact P|]. split; [exact P|exact H].
  - right. split; [reflexivity|]. right. now split.
Qed.

Theorem circle_answered a b p q r : (forall v, In v [a; b; p; q] -> coordinates_2 (f v)) ->
  0 < turn_at ref a b q -> 0 < turn_at ref b a p ->
  says (empty_sphere_predicate correctly_rounded (f a) (f b) (f p) (f q)) (tie (circle a b p q) ref) r -> answered ref (@Build_verdict Plane i (circle a b p q) r).
Proof.
  intros D Tq Tp S. destruct (empty_sphere_2_right f correctly_rounded a b p q D) as [R _]. revert R S.
  destruct (empty_sphere_predicate _ _ _ _ _) as [|t|t|t]; simpl; try contradiction.
  - intros Z [Q ->]. right. split; [reflexivity|]. right. now split.
  - intros (_ & P & H0 & H) ->. left. split; [exact H0|]. split; [apply value_format|]. split; [left; exact P|].
    split; [exact Tq|]. split; [exact Tp|]. split; [exact P|exact H].
Qed.
End answered.
