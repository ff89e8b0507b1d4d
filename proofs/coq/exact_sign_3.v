(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* exact_sign_2.v in space: src/annulus/predicate/exact_sign.cpp, by integers and intervals. The determinants are those of the prepared sphere
   (filter_3.v, circumsphere_from, outside_from_3), operation by operation.

   - exact_orientation_sign_3_right, exact_empty_sphere_sign_3_right   of coordinates in the domain the sign is right, 0 included *)
From Coq Require Import Reals Lra ZArith List.
From Flocq Require Import Core.
From Coq Require Import Floats.
From Annulus Require vectors bicell.
From Annulus Require Import operations bridge connect filter_2 filter_3 interval_2 interval_3 float_interval interval_tail integers_2 integers_3 interval_terms_3.
From Annulus Require Import real_terms_3 returned_3 exact_2 exact_3 exact_sign_2 interval_returned_3 exact_returned_3 signs_3.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

(* ---- As the code has it ---- *)

Section over.
Variable o : operations.
Definition volume_sign_of (u v t : vector_3 o) : number o := dot o (cross o u v) t.
(* Of the cell 0, u, v, t and the point w. *)
Definition sphere_of (u v w t : vector_3 o) : number o := outside_from_3 o (circumsphere_from o u u v t) w.
End over.

Definition coordinates_of_3 (l : list (vector_3 integers)) : list Z := flat_map (fun v => [x3 _ v; y3 _ v; z3 _ v]) l.

Definition exact_orientation_sign_3 (a b c d : vector_3 machine) : Z :=
  let s := scale_of (largest_coordinate (pairs_3 b a ++ pairs_3 c a ++ pairs_3 d a)) in
  let to_first v := difference_3 integers (to_integers_3 (common (numbers_3 [a; b; c; d])) v) (to_integers_3 (common (numbers_3 [a; b; c; d])) a) in
  decided (coordinates_of_3 (map (to_integers_3 (common (numbers_3 [a; b; c; d]))) [a; b; c; d]))
    (volume_sign_of intervals (i_vector_3 s b a) (i_vector_3 s c a) (i_vector_3 s d a)) (volume_sign_of integers (to_first b) (to_first c) (to_first d)).
Definition exact_empty_sphere_sign_3 (a b c p q : vector_3 machine) : Z :=
  let s := scale_of (largest_coordinate (pairs_3 b a ++ pairs_3 c a ++ pairs_3 p a ++ pairs_3 q a)) in
  let to_first v := difference_3 integers (to_integers_3 (common (numbers_3 [a; b; c; p; q])) v) (to_integers_3 (common (numbers_3 [a; b; c; p; q])) a) in
  decided (coordinates_of_3 (map (to_integers_3 (common (numbers_3 [a; b; c; p; q]))) [a; b; c; p; q]))
    (sphere_of intervals (i_vector_3 s b a) (i_vector_3 s c a) (i_vector_3 s p a) (i_vector_3 s q a))
    (sphere_of integers (to_first b) (to_first c) (to_first p) (to_first q)).

(* ---- It is right ---- *)

Lemma sphere_encloses u v w t u' v' w' t' : holds_vector_3 u u' -> holds_vector_3 v v' -> holds_vector_3 w w' -> holds_vector_3 t t' ->
  holds (sphere_of intervals u v w t) (sphere_of reals u' v' w' t').
Proof.
  intros U V W T. destruct (h_cross _ _ _ _ U V) as (A1 & A2 & A3), (h_cross _ _ _ _ V T) as (B1 & B2 & B3), (h_cross _ _ _ _ T U) as (C1 & C2 & C3).
  assert (UU := h_square _ _ U). assert (VV := h_square _ _ V). assert (TT := h_square _ _ T).
  apply holds_sub; [apply holds_mul; [now apply h_square|now apply h_dot; [apply h_cross|]]|]. apply h_dot; [exact W|].
  split; [|split]; (apply holds_add; [apply holds_add|]); now apply holds_mul.
Qed.
Lemma sphere_degrees k u v w t u' v' w' t' : degrees k 1 u u' -> degrees k 1 v v' -> degrees k 1 w w' -> degrees k 1 t t' ->
  degree k 5 (sphere_of integers u v w t) (sphere_of reals u' v' w' t').
Proof.
  intros U V W T. destruct (v_cross k 1 1 _ _ _ _ U V) as (A1 & A2 & A3), (v_cross k 1 1 _ _ _ _ V T) as (B1 & B2 & B3),
    (v_cross k 1 1 _ _ _ _ T U) as (C1 & C2 & C3).
  assert (UU := d_square_3 k 1 _ _ U). assert (VV := d_square_3 k 1 _ _ V). assert (TT := d_square_3 k 1 _ _ T).
  apply (d_sub k 5); [apply (d_mul k 2 3); [now apply (d_square_3 k 1)|apply (d_dot k 2 1); [now apply (v_cross k 1 1)|exact T]]|]. apply (d_dot k 1 4); [exact W|].
  split; [|split]; (apply (d_add k 4); [apply (d_add k 4)|]); now apply (d_mul k 2 2).
Qed.

Ltac expand := unfold volume_of, beyond_3, five, bicell.det, bicell.lambda_b, bicell.lambda_c, bicell.lambda_p, bicell.lambda_q, bicell.rel, vectors.sq, vectors.vol;
  unfold vectors.dot, vectors.cross, vectors.sub, vectors.scale, volume_sign_of, sphere_of, to_reals; cbn; ring.
Lemma volume_of_scaled r (a b c d : vectors.vec) :
  volume_sign_of reals (to_reals (vectors.scale r (vectors.sub b a))) (to_reals (vectors.scale r (vectors.sub c a))) (to_reals (vectors.scale r (vectors.sub d a))) =
  r * r * r * volume_of a b c d.
Proof. expand. Qed.
Lemma sphere_of_scaled r (a b c p q : vectors.vec) :
  sphere_of reals (to_reals (vectors.scale r (vectors.sub b a))) (to_reals (vectors.scale r (vectors.sub c a)))
    (to_reals (vectors.scale r (vectors.sub p a))) (to_reals (vectors.scale r (vectors.sub q a))) = r * r * r * (r * r) * beyond_3 a b c q p.
Proof.
  unfold beyond_3, five, bicell.det, bicell.lambda_b, bicell.lambda_c, bicell.lambda_p, bicell.lambda_q, bicell.rel.
  generalize (vectors.sub b a) (vectors.sub c a) (vectors.sub p a) (vectors.sub q a). intros [] [] [] []. expand.
Qed.
Lemma scaled_by_one (u : vectors.vec) : vectors.scale 1 u = u.
Proof. destruct u. unfold vectors.scale. cbn. f_equal; ring. Qed.

Theorem exact_orientation_sign_3_right a b c d : (forall v, In v [a; b; c; d] -> coordinates_3 v) ->
  has_sign (exact_orientation_sign_3 a b c d) (volume_of (at_3 a) (at_3 b) (at_3 c) (at_3 d)).
Proof.
  intro Dom. assert (A : coordinates_3 a) by (apply Dom; simpl; tauto). assert (B : coordinates_3 b) by (apply Dom; simpl; tauto).
  assert (C : coordinates_3 c) by (apply Dom; simpl; tauto). assert (D : coordinates_3 d) by (apply Dom; simpl; tauto).
  unfold exact_orientation_sign_3. cbv zeta. set (s := scale_of _). assert (G : good_scale s).
  { apply scale_good. intros i j I. rewrite !in_app_iff in I. destruct I as [I|[I|I]]; revert I; now apply pairs_3_coordinates. }
  assert (K : 0 < scale_factor s) by (apply Rmult_lt_0_compat; apply G). set (r := scale_factor s) in *.
  set (l := [a; b; c; d]). set (k := common (numbers_3 l)).
  assert (S : forall v, In v l -> degrees k 1 _ _) by (intros v I; exact (integers_stand_3 l v a I ltac:(simpl; tauto))).
  apply decided_right with (r * r * r) (bpow radix2 k ^ 3).
  - apply Rmult_lt_0_compat; [now apply Rmult_lt_0_compat|exact K].
  - apply pow_lt, bpow_gt_0.
  - rewrite <- volume_of_scaled. apply h_dot; [apply h_cross|]; now apply vector_3_encloses.
  - replace (volume_of _ _ _ _) with (1 * 1 * 1 * volume_of (at_3 a) (at_3 b) (at_3 c) (at_3 d)) by ring. rewrite <- volume_of_scaled, !scaled_by_one.
    apply (d_dot k 2 1); [apply (v_cross k 1 1)|]; apply S; simpl; tauto.
Qed.

Theorem exact_empty_sphere_sign_3_right a b c p q : (forall v, In v [a; b; c; p; q] -> coordinates_3 v) ->
  has_sign (exact_empty_sphere_sign_3 a b c p q) (beyond_3 (at_3 a) (at_3 b) (at_3 c) (at_3 q) (at_3 p)).
Proof.
  intro Dom. assert (A : coordinates_3 a) by (apply Dom; simpl; tauto). assert (B : coordinates_3 b) by (apply Dom; simpl; tauto).
  assert (C : coordinates_3 c) by (apply Dom; simpl; tauto). assert (P : coordinates_3 p) by (apply Dom; simpl; tauto).
  assert (Q : coordinates_3 q) by (apply Dom; simpl; tauto).
  unfold exact_empty_sphere_sign_3. cbv zeta. set (s := scale_of _). assert (G : good_scale s).
  { apply scale_good. intros i j I. rewrite !in_app_iff in I. destruct I as [I|[I|[I|I]]]; revert I; now apply pairs_3_coordinates. }
  assert (K : 0 < scale_factor s) by (apply Rmult_lt_0_compat; apply G). set (r := scale_factor s) in *.
  set (l := [a; b; c; p; q]). set (k := common (numbers_3 l)).
  assert (S : forall v, In v l -> degrees k 1 _ _) by (intros v I; exact (integers_stand_3 l v a I ltac:(simpl; tauto))).
  apply decided_right with (r * r * r * (r * r)) (bpow radix2 k ^ 5).
  - assert (K2 := Rmult_lt_0_compat _ _ K K). exact (Rmult_lt_0_compat _ _ (Rmult_lt_0_compat _ _ K2 K) K2).
  - apply pow_lt, bpow_gt_0.
  - rewrite <- sphere_of_scaled. apply sphere_encloses; now apply vector_3_encloses.
  - replace (beyond_3 _ _ _ _ _) with (1 * 1 * 1 * (1 * 1) * beyond_3 (at_3 a) (at_3 b) (at_3 c) (at_3 q) (at_3 p)) by ring.
    rewrite <- sphere_of_scaled, !scaled_by_one. apply sphere_degrees; apply S; simpl; tauto.
Qed.
