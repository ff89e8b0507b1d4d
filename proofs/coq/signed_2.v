(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Certificates of the plane by signs alone, without tolerances, as src/annulus/engine/sign_evaluator.cpp evaluates them on doubles.

   - turns_left, keeps_out, signed   a sign is that of the prepared circle of a triangle, its corners in whichever order the table has them, or of
                                     the exact stages; an answer 0 stands for a circle, or for a straight piece of the border where coordinates say so
   - signed_holds                    what is signed holds *)
From Coq Require Import Reals Lra ZArith List.
From Coq Require Import Floats.
From Annulus Require width_2.
From Annulus Require Import points_2 operations bridge connect filter_2 returned_2 signs_2 exact_sign_2 filter_doubles filter_plane.
From Annulus Require Import plane_mesh plane_certificates flat_ridges filter_delaunay.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

(* The circle through three vertices, prepared. *)
Definition prepared (f : doubles) (t : nat * nat * nat) : circumcircle machine := let '(a, b, c) := t in circumcircle_of machine (f a) (f b) (f c).
(* Sign_evaluator::test_cell, is_inverted: orientation_sign.h computes what the prepared circle does. *)
Definition turns_left (f : doubles) (t : nat * nat * nat) : Prop :=
  circle_positive machine (prepared f t) = true \/ (let '(a, b, c) := t in exact_orientation_sign (f a) (f b) (f c)) = 1%Z.
Definition straight (f : doubles) (t : nat * nat * nat) : Prop := let '(a, b, c) := t in exact_orientation_sign (f a) (f b) (f c) = 0%Z.
(* test_cell, sphere_sign, is_violated: the cell a b q has p outside of its circle, evaluated alone or with others, or on it. *)
Definition keeps_out (f : doubles) (a b p q : nat) : Prop :=
  (exists t, In t (sides (a, b, q)) /\
    (circle_positive machine (prepared f t) = true /\ excludes machine (prepared f t) (f p) = true \/
     exists others, In p others /\ excludes_all machine (prepared f t) (map f others) = true)) \/
  (0 <= exact_empty_sphere_sign (f a) (f b) (f p) (f q))%Z.

Definition signed (f : doubles) (c : certificate_2) : Prop :=
  match c with
  | cell a b c => exists t, In t (sides (a, b, c)) /\ turns_left f t
  | ridge u v w => exists t, In t (sides (u, v, w)) /\ (turns_left f t \/ straight f t /\ flat_ridge_holds (f u) (f v) (f w) = true)
  | circle a b p q => keeps_out f a b p q \/ keeps_out f b a q p
  end.

(* ---- It holds ---- *)

Section holds.
Variable f : doubles.
Hypothesis domain : forall v, coordinates_2 (f v).
Let m := at_doubles f.

Lemma side_turn a b c t : In t (sides (a, b, c)) -> let '(u, v, w) := t in turn_at m u v w = turn_at m a b c.
Proof. intros [<-|[<-|[<-|[]]]]; unfold turn_at, turning, width_2.turn; ring. Qed.
Lemma side_circle a b q p t : In t (sides (a, b, q)) -> let '(u, v, w) := t in beyond_2 (at_2 (f u)) (at_2 (f v)) (at_2 (f w)) (at_2 (f p)) = incircle_at m a b p q.
Proof. intros [<-|[<-|[<-|[]]]]; unfold beyond_2, incircle_at, width_2.incircle, width_2.turn, m, at_doubles; cbn [fst snd at_2]; ring. Qed.

Lemma turns_left_right t : turns_left f t -> let '(a, b, c) := t in 0 < turn_at m a b c.
Proof.
  destruct t as [[a b] c]. intros [P|S].
  - apply (positive_2 (f a) (f b) (f c)) in P; [exact P|]. repeat split; apply domain.
  - assert (H := exact_orientation_sign_right f a b c (fun v _ => domain v)). now rewrite S in H.
Qed.
Lemma straight_right t : straight f t -> let '(a, b, c) := t in turn_at m a b c = 0.
Proof.
  destruct t as [[a b] c]. unfold straight. intro S. assert (H := exact_orientation_sign_right f a b c (fun v _ => domain v)). now rewrite S in H.
Qed.
Lemma keeps_out_right a b p q : keeps_out f a b p q -> 0 <= incircle_at m a b p q.
Proof.
  intros [(t & I & H)|S].
  - assert (E := side_circle a b q p t I). destruct t as [[u v] w]. rewrite <- E. apply Rlt_le.
    assert (D : coordinates_2 (f u) /\ coordinates_2 (f v) /\ coordinates_2 (f w)) by (repeat split; apply domain).
    destruct H as [[P X]|(others & O & X)].
    + exact (proj1 (sides_of_circle_2 _ _ _ D (f p) (domain p) P) X).
    + apply (excludes_all_2 _ _ _ D (map f others)) in X; [apply X; now apply in_map|]. intros n N. apply in_map_iff in N. destruct N as (z & <- & _). apply domain.
  - assert (H := exact_empty_sphere_sign_right f a b p q (fun v _ => domain v)). revert H. fold m.
    destruct (exact_empty_sphere_sign _ _ _ _) as [|s|s]; simpl; intro H; [now right; symmetry|now left|]. now elim S.
Qed.

Theorem signed_holds c : signed f c -> holds_2 no_fold c m.
Proof.
  destruct c as [a b c|u v w|a b p q]; cbn [signed holds_2].
  - intros (t & I & H). assert (E := side_turn a b c t I). apply turns_left_right in H. destruct t as [[? ?] ?]. now rewrite <- E.
  - intros (t & I & H). assert (E := side_turn u v w t I). destruct H as [H|[H F]].
    + left. apply turns_left_right in H. destruct t as [[? ?] ?]. now rewrite <- E.
    + right. assert (Z : turn_at m u v w = 0) by (apply straight_right in H; destruct t as [[? ?] ?]; now rewrite <- E).
      split; [exact Z|]. now apply flat_ridge_right.
  - intro H. assert (P : 0 <= incircle_at m a b p q).
    { destruct H as [H|H]; apply keeps_out_right in H; [exact H|]. replace (incircle_at m a b p q) with (incircle_at m b a q p); [exact H|].
      unfold incircle_at, width_2.incircle, width_2.turn. ring. }
    destruct P as [P|P]; [now left|right]. split; [now symmetry|exact I].
Qed.
End holds.
