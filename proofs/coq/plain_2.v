(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter stage of the plane without certified tolerances (certified = false, the mode `floating`): what it promises is its sign.

   - orientation_2_plain, empty_sphere_2_plain      a sign is right
   - orientation_2_floating, empty_sphere_2_floating   and so it is of the whole filtered predicate, whose later stages are the same in this mode *)
From Coq Require Import Reals Lra ZArith List.
From Coq Require Import Floats.
From Annulus Require float_model float_filter_2 float_circle_2 float_certifies_2.
From Annulus Require Import points_2 width_2 filter_doubles algorithm_filter filter_plane.
From Annulus Require Import operations bridge bridge_decide filter_2 bridge_2 connect connect_2 stages interval_2 exact_2.
From Annulus Require Import returned_2 interval_returned_2 exact_returned_2.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

Section plain.
Variable f : nat -> vector machine.
Let ref : nat -> point_2 := fun v => at_2 (f v).

Theorem orientation_2_plain a b c : (forall v, In v [a; b; c] -> coordinates_2 (f v)) ->
  right_sign (orientation_filter machine (f a) (f b) (f c) false) (turn_at ref a b c).
Proof.
  intro D. assert (S := orientation_filter_stands false _ _ _ _ _ _ (at_domain_2 _ (D a ltac:(simpl; tauto))) (at_domain_2 _ (D b ltac:(simpl; tauto)))
    (at_domain_2 _ (D c ltac:(simpl; tauto)))).
  rewrite orientation_is in S. refine (returned_sign _ _ _ (sound_alone _ _ _ _ _) S).
  apply (float_filter_2.orientation_filter_sound (fst (ref a)) (snd (ref a)) (fst (ref b)) (snd (ref b)) (fst (ref c)) (snd (ref c)));
    apply value_format.
Qed.

Theorem empty_sphere_2_plain a b p q : (forall v, In v [a; b; p; q] -> coordinates_2 (f v)) ->
  right_sign (empty_sphere_filter machine (f a) (f b) (f p) (f q) false) (incircle_at ref a b p q).
Proof.
  intro D. assert (S := empty_sphere_filter_stands false _ _ _ _ _ _ _ _ (at_domain_2 _ (D a ltac:(simpl; tauto))) (at_domain_2 _ (D b ltac:(simpl; tauto)))
    (at_domain_2 _ (D p ltac:(simpl; tauto))) (at_domain_2 _ (D q ltac:(simpl; tauto)))).
  assert (Sound := float_circle_2.circle_filter_sound (fst (ref a)) (snd (ref a)) (fst (ref b)) (snd (ref b)) (fst (ref p)) (snd (ref p))
    (fst (ref q)) (snd (ref q)) false (value_format _) (value_format _) (value_format _) (value_format _) (value_format _) (value_format _)
    (value_format _) (value_format _)). cbv zeta in Sound. rewrite float_certifies_2.circle_determinant in Sound.
  rewrite empty_sphere_is in S. exact (returned_sign _ _ _ (sound_alone _ _ _ _ Sound) S).
Qed.

Theorem orientation_2_floating a b c : (forall v, In v [a; b; c] -> coordinates_2 (f v)) ->
  right_sign (staged false (orientation_filter machine (f a) (f b) (f c) false) (orientation_interval (f a) (f b) (f c)) (orientation_exact (f a) (f b) (f c)))
    (turn_at ref a b c).
Proof.
  intro D. eapply stages_sign; [now apply orientation_2_plain|now apply orientation_interval_returned|apply orientation_exact_returned].
Qed.
Theorem empty_sphere_2_floating a b p q : (forall v, In v [a; b; p; q] -> coordinates_2 (f v)) ->
  right_sign (staged false (empty_sphere_filter machine (f a) (f b) (f p) (f q) false) (empty_sphere_interval (f a) (f b) (f p) (f q))
    (empty_sphere_exact (f a) (f b) (f p) (f q))) (incircle_at ref a b p q).
Proof.
  intro D. eapply stages_sign; [now apply empty_sphere_2_plain|now apply empty_sphere_interval_returned|apply empty_sphere_exact_returned].
Qed.
End plain.
