(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* plain_2.v in space: without certified tolerances (certified = false, the mode `floating`) the filter stage promises its sign.

   - orientation_3_plain, empty_sphere_3_plain      a sign is right, whatever becomes of the cells' widths
   - orientation_3_floating, empty_sphere_3_floating   and so it is of the whole filtered predicate, whose later stages are the same in this mode *)
From Coq Require Import Reals.
From Coq Require Import Floats.
From Annulus Require float_certifies_3 float_filter_3 float_bicell_3.
From Annulus Require Import vectors bicell tetrahedron sign_tolerance_3.
From Annulus Require Import operations bridge bridge_decide filter_2 filter_3 bridge_3 connect connect_3 stages interval_3 exact_3.
From Annulus Require Import returned_3 interval_returned_3 exact_returned_3.
Import vectors bicell tetrahedron filter_3.
Close Scope float_scope.
Open Scope R_scope.

Section orientation.
Variable f : corner -> vector_3 machine.     (* what the code is given *)
Hypothesis domain : forall k, coordinates_3 (f k).
Let x : corners := fun k => at_3 (f k).      (* where that is *)
Let answer := orientation_filter_3 machine (f o) (f tetrahedron.u) (f v) (f w) false.

Theorem orientation_3_plain : right_sign answer (volume x).
Proof.
  assert (S := orientation_filter_3_stands false _ _ _ _ _ _ _ _ (at_domain_3 _ (domain o)) (at_domain_3 _ (domain tetrahedron.u))
    (at_domain_3 _ (domain v)) (at_domain_3 _ (domain w))).
  rewrite orientation_3_is in S. refine (returned_sign _ _ _ (sound_alone _ _ _ _ _) S).
  apply float_filter_3.orientation_filter_3_sound; apply at_format_3.
Qed.

Theorem orientation_3_floating : right_sign
  (staged false answer (orientation_3_interval (f o) (f tetrahedron.u) (f v) (f w)) (orientation_3_exact (f o) (f tetrahedron.u) (f v) (f w))) (volume x).
Proof.
  eapply stages_sign; [exact orientation_3_plain|now apply orientation_3_interval_returned|apply orientation_3_exact_returned].
Qed.
End orientation.

Section sphere.
Variable f : vertex -> vector_3 machine.
Hypothesis domain : forall k, coordinates_3 (f k).
Let x : placement := fun k => at_3 (f k).
Variable use : cells.
Let answer := bicell_filter machine (f a) (f b) (f c) (f p) (f q) false use.

Theorem empty_sphere_3_plain : right_sign answer (det x).
Proof.
  assert (S := bicell_filter_stands false _ _ _ _ _ _ _ _ _ _ use (at_domain_3 _ (domain a)) (at_domain_3 _ (domain b)) (at_domain_3 _ (domain c))
    (at_domain_3 _ (domain p)) (at_domain_3 _ (domain q))).
  rewrite bicell_filter_is in S. refine (returned_sign _ _ _ _ S). intros s r E.
  assert (Sound := float_bicell_3.bicell_answer_sound _ _ _ _ _ false (use_of use) (at_format_3 (f a)) (at_format_3 (f b)) (at_format_3 (f c))
    (at_format_3 (f p)) (at_format_3 (f q)) _ _ E).
  change (float_certifies_3.numbers (at_3 (f ?k))) with (float_certifies_3.numbers (x k)) in Sound.
  rewrite (float_certifies_3.truth_is x), float_certifies_3.determinant_is in Sound. tauto.
Qed.

Theorem empty_sphere_3_floating : right_sign (staged false answer (empty_sphere_3_interval (f a) (f b) (f c) (f p) (f q) use)
  (empty_sphere_3_exact (f a) (f b) (f c) (f p) (f q) use)) (det x).
Proof.
  eapply stages_sign; [exact empty_sphere_3_plain|now apply empty_sphere_3_interval_returned|apply empty_sphere_3_exact_returned].
Qed.
End sphere.
