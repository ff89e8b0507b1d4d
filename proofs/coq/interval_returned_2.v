(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The interval stage in the plane, for finite doubles of the coordinate domain and the very operations that are replayed (interval_2.v), overflow,
   underflow and the scale within the theorem.

   - orientation_interval_returned, empty_sphere_interval_returned   a sign is right; a tolerance is a finite number, at most half the least altitude
                                                                     or half the width *)
From Coq Require Import Reals Lra ZArith List.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Coq Require Import Floats.
From Annulus Require Import points_2 width_2 sign_tolerance_2 filter_plane.
From Annulus Require Import operations bridge connect filter_2 stages float_directed interval_2 float_interval interval_tail integers_2 real_terms_2 returned_2.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

Definition holds_vector (v : vector intervals) (w : vector reals) : Prop := holds (x _ v) (x _ w) /\ holds (y _ v) (y _ w).
Definition holds_terms (t : width_terms intervals) (t' : width_terms reals) : Prop :=
  holds (determinant _ t) (determinant _ t') /\ holds (inner _ t) (inner _ t') /\ holds (outer _ t) (outer _ t').

Ltac enclose := repeat first [assumption|apply holds_add|apply holds_sub|apply holds_mul|apply holds_square|apply holds_max|apply holds_opp].

Lemma orientation_encloses u v w u' v' w' : holds_vector u u' -> holds_vector v v' -> holds_vector w w' ->
  holds_terms (orientation_terms intervals u v w) (orientation_terms reals u' v' w').
Proof.
  intros [U1 U2] [V1 V2] [W1 W2]. unfold orientation_terms, squared, holds_terms.
  cbn [determinant inner outer intervals reals add sub mul square greater]. split; [|split]; enclose.
Qed.
Lemma annulus_encloses b p q e b' p' q' e' : holds_vector b b' -> holds_vector p p' -> holds_vector q q' -> holds_vector e e' ->
  holds_terms (annulus_terms intervals b p q e) (annulus_terms reals b' p' q' e').
Proof.
  intros [B1 B2] [P1 P2] [Q1 Q2] [E1 E2]. unfold annulus_terms, squared, holds_terms.
  cbn [determinant inner outer intervals reals add sub mul square greater]. split; [|split]; enclose.
Qed.

Lemma vector_encloses s (v w : vector machine) : good_scale s -> coordinates_2 v -> coordinates_2 w ->
  holds_vector (i_vector s v w) (scaled_by (scale_factor s) (value (x _ w)) (value (y _ w)) (value (x _ v)) (value (y _ v))).
Proof. intros G [[A _] [B _]] [[C _] [D _]]. split; now apply holds_difference. Qed.

Lemma accept_right s t t' w : good_scale s -> holds_terms t t' -> 0 <= inner _ t' -> 0 <= outer _ t' ->
  (0 < determinant _ t' -> half_width t' = w * scale_factor s /\ 0 < R_sqrt.sqrt (inner _ t') + R_sqrt.sqrt (outer _ t')) ->
  right_answer (accept_interval s t) (determinant _ t') w.
Proof.
  intros G (D & I & O) PI PO W. unfold accept_interval. cbv zeta. destruct (below nought _) eqn:P.
  - destruct (quotient_lower_in_slack _ _ _) as [low|] eqn:T; [|exact Logic.I]. destruct (positive_end _ _ P D) as (_ & L & L').
    assert (P' : 0 < determinant _ t') by lra. destruct (W P') as [W' R].
    destruct (in_slack_lower _ _ _ _ _ _ P D R (sum_of_roots_above _ _ _ _ PI PO (proj2 I) (proj2 O)) T) as (F & H).
    fold (half_width t') in H. rewrite W' in H. destruct (back_lower s low w G F H). simpl. auto.
  - destruct (below (upper _) nought) eqn:N; [|exact Logic.I]. exact (negative_end _ _ N D).
Qed.

Section returned.
Variable f : nat -> vector machine.
Let ref : nat -> point_2 := fun v => at_2 (f v).

(* Of the differences whose largest the scale is made of. *)
Lemma pairs_coordinates v w i j : coordinates_2 v -> coordinates_2 w -> In (i, j) (pairs v w) -> coordinate i /\ coordinate j.
Proof. intros [A B] [C D] [E|[E|[]]]; injection E as <- <-; auto. Qed.

Theorem orientation_interval_returned a b c : (forall v, In v [a; b; c] -> coordinates_2 (f v)) ->
  right_answer (orientation_interval (f a) (f b) (f c)) (turn_at ref a b c) (half_altitude_at ref a b c).
Proof.
  intro Dom. assert (A : coordinates_2 (f a)) by (apply Dom; simpl; tauto). assert (B : coordinates_2 (f b)) by (apply Dom; simpl; tauto).
  assert (C : coordinates_2 (f c)) by (apply Dom; simpl; tauto).
  unfold orientation_interval. cbv zeta. set (s := scale_of _). assert (G : good_scale s).
  { apply scale_good. intros i j I. apply in_app_or in I. destruct I as [I|I]; revert I; now apply pairs_coordinates. }
  assert (K : 0 < scale_factor s) by (apply Rmult_lt_0_compat; apply G). assert (K2 : 0 < scale_factor s * scale_factor s) by now apply Rmult_lt_0_compat.
  assert (E := orientation_encloses _ _ _ _ _ _ (vector_encloses s _ _ G B A) (vector_encloses s _ _ G C A) (vector_encloses s _ _ G C B)).
  generalize (triangle_terms _ K (value (x _ (f a))) (value (y _ (f a))) (value (x _ (f b))) (value (y _ (f b))) (value (x _ (f c))) (value (y _ (f c)))).
  intros (D & I & O & _). apply right_unscaled with (1 := K2). change (turn_at ref a b c) with
    (width_2.turn (value (x _ (f a))) (value (y _ (f a))) (value (x _ (f b))) (value (y _ (f b))) (value (x _ (f c))) (value (y _ (f c)))).
  rewrite <- D. apply accept_right; trivial. rewrite D. intro P. apply triangle_half; [exact K|].
  apply Rmult_lt_reg_l with (1 := K2). now rewrite Rmult_0_r.
Qed.

Theorem empty_sphere_interval_returned a b p q : (forall v, In v [a; b; p; q] -> coordinates_2 (f v)) ->
  right_answer (empty_sphere_interval (f a) (f b) (f p) (f q)) (incircle_at ref a b p q) (half_width_at ref a b p q).
Proof.
  intro Dom. assert (A : coordinates_2 (f a)) by (apply Dom; simpl; tauto). assert (B : coordinates_2 (f b)) by (apply Dom; simpl; tauto).
  assert (C : coordinates_2 (f p)) by (apply Dom; simpl; tauto). assert (Q : coordinates_2 (f q)) by (apply Dom; simpl; tauto).
  unfold empty_sphere_interval. cbv zeta. set (s := scale_of _). assert (G : good_scale s).
  { apply scale_good. intros i j I. apply in_app_or in I. destruct I as [I|I]; [|apply in_app_or in I; destruct I as [I|I]]; revert I; now apply pairs_coordinates. }
  assert (K : 0 < scale_factor s) by (apply Rmult_lt_0_compat; apply G). assert (K2 : 0 < scale_factor s * scale_factor s) by now apply Rmult_lt_0_compat.
  assert (K4 := Rmult_lt_0_compat _ _ K2 K2).
  assert (E := annulus_encloses _ _ _ _ _ _ _ _ (vector_encloses s _ _ G B A) (vector_encloses s _ _ G C A) (vector_encloses s _ _ G Q A) (vector_encloses s _ _ G Q C)).
  generalize (circle_terms _ K (value (x _ (f a))) (value (y _ (f a))) (value (x _ (f b))) (value (y _ (f b))) (value (x _ (f p))) (value (y _ (f p)))
    (value (x _ (f q))) (value (y _ (f q)))).
  intros (D & I & O & _). apply right_unscaled with (1 := K4). change (incircle_at ref a b p q) with
    (width_2.incircle (value (x _ (f a))) (value (y _ (f a))) (value (x _ (f b))) (value (y _ (f b))) (value (x _ (f p))) (value (y _ (f p)))
      (value (x _ (f q))) (value (y _ (f q)))).
  rewrite <- D. apply accept_right; trivial. rewrite D. intro P. apply circle_half; [exact K|].
  apply Rmult_lt_reg_l with (1 := K4). now rewrite Rmult_0_r.
Qed.
End returned.
