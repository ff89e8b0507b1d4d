(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter of the empty sphere in space (empty_sphere_filter of src/annulus/predicate/filtered_3.h) in rounded reals, from coordinates to
   answer, and what it means that an answer is right. That it is: float_bicell_3.v.

   - both_some          when both() answers
   - annuli_positive    where the determinant is positive, so are the norms of each partition *)
Require Import Reals Lra Psatz ZArith List Bool.
From Flocq Require Import Core.
From Annulus Require Import float_model float_error float_tail float_filter float_terms_3 float_constants_3 float_width_3
  float_filter_3.
Import ListNotations.
Open Scope R_scope.

(* ---- As the code has it ---- *)

Inductive cells := never | where_needed | always.

(* The lesser of two tolerances where both signs are certainly positive. *)
Definition both (l r : option (Z * R)) : option (Z * R) :=
  match l with
  | Some (1%Z, t) => match r with Some (1%Z, s) => Some (1%Z, Rmin t s) | _ => None end
  | _ => l
  end.

Section code.
Variables a b c p q : vector R.
Variable certified : bool.
Variable use : cells.
Let vb := F_difference b a.
Let vc := F_difference c a.
Let vp := F_difference p a.
Let vq := F_difference q a.
Definition bicell_m : R := Rmax (Rmax (magnitude vb) (magnitude vc)) (Rmax (magnitude vp) (magnitude vq)).
Definition bicell_computed : bicell R := F_bicell vb vc vp vq.
Let m := bicell_m.
Let t := bicell_computed.

Definition norm_sum (n k : vector R) : R := root_sum (F_square n) (F_square k).

(* Partitions 1, 2, 3: ab|cpq, ca|bpq, bc|apq. *)
Definition on_wrong_side (side : bicell R -> R) : bool :=
  if Rlt_dec (error_bound 169 (power_3 m)) (side t) then false else true.

Definition cells_needed : bool :=
  match use with
  | never => false
  | always => true
  | where_needed => on_wrong_side l2 || on_wrong_side l3 || on_wrong_side minus_l4
  end.

(* A tolerance that the cells lower is no answer where a sum may be positive or not, and none is certainly not. *)
Definition certainly_wrong_side (side : bicell R -> R) : bool :=
  if Rlt_dec (side t) (- error_bound 169 (power_3 m)) then true else false.
Definition lowered (annuli whole : option (Z * R)) : bool :=
  match annuli, whole with
  | Some (1%Z, v), Some (1%Z, w) => if Rlt_dec w v then true else false
  | _, _ => false
  end.
Definition in_doubt (annuli whole : option (Z * R)) : bool :=
  match use with
  | where_needed => certified && negb (certainly_wrong_side l2 || certainly_wrong_side l3 || certainly_wrong_side minus_l4) && lowered annuli whole
  | _ => false
  end.

Definition bicell_filter : option (Z * R) :=
  if in_range_dec 100 m then
    let roots := Rmax (Rmax (norm_sum (n1 t) (m1 t)) (norm_sum (n2 t) (m2 t)))
                      (Rmax (norm_sum (n3 t) (m3 t)) (norm_sum (n4 t) (m4 t))) in
    let annuli := decide (determinant t) roots (error_bound 1105 (power_5 m)) (error_bound 3246 (power_4 m)) certified in
    if cells_needed
    then let whole := both (both annuli (decide_width (cell_p t) (slabs_p t) m certified)) (decide_width (cell_q t) (slabs_q t) m certified) in
         if in_doubt annuli whole then None else whole
    else annuli
  else None.
End code.

(* ---- As it is meant ---- *)

Definition bicell_truth a b c p q := R_bicell (R_difference b a) (R_difference c a) (R_difference p a) (R_difference q a).

(* An answer for the bi-cell, and which partitions are certainly not on the wrong side. *)
Definition bicell_sound (answer : option (Z * R)) (certified needed : bool) (t : bicell R) : Prop :=
  forall sign value, answer = Some (sign, value) ->
  sign = 1%Z /\ 0 < determinant t /\ (needed = true -> 0 < cell_p t /\ 0 < cell_q t) /\
  (certified = true -> 0 <= value /\
    value <= determinant t / (R_norm (n1 t) + R_norm (m1 t)) /\
    value <= determinant t / (R_norm (n2 t) + R_norm (m2 t)) /\
    value <= determinant t / (R_norm (n3 t) + R_norm (m3 t)) /\
    value <= determinant t / (R_norm (n4 t) + R_norm (m4 t)) /\
    (needed = true ->
      value <= cell_p t / (2 * sqrt (largest R_square (slabs_p t))) /\
      value <= cell_q t / (2 * sqrt (largest R_square (slabs_q t)))))
  \/ sign = (-1)%Z /\ determinant t < 0.

(* ---- Answers, annuli that are not empty ---- *)

Lemma both_some l r sign value : both l r = Some (sign, value) ->
  l = Some (sign, value) /\ sign <> 1%Z \/
  sign = 1%Z /\ exists v w, l = Some (1%Z, v) /\ r = Some (1%Z, w) /\ value = Rmin v w.
Proof.
  unfold both. intro H. destruct l as [[s v] |]; [| discriminate].
  destruct (Z.eq_dec s 1) as [-> | N].
  - right. destruct r as [[s' w] |]; [| discriminate].
    destruct (Z.eq_dec s' 1) as [-> | N'].
    + injection H as <- <-. split; [reflexivity |]. exists v, w. auto.
    + exfalso. destruct s' as [| [ | | ] |]; congruence.
  - left. assert (E : Some (s, v) = Some (sign, value)) by (destruct s as [| [ | | ] |]; congruence).
    split; [exact E |]. congruence.
Qed.

(* The determinant of a partition vanishes with its norms: 2 P = -+ (N + M).x, x the point that is not a. *)
Lemma norms_positive n k v det s : 2 * det = s * (x n * x v + y n * y v + z n * z v + (x k * x v + y k * y v + z k * z v)) ->
  0 < det -> 0 < R_norm n + R_norm k.
Proof.
  intros E P. generalize (sqrt_pos (R_square n)) (sqrt_pos (R_square k)). fold (R_norm n) (R_norm k). intros N K.
  destruct (Rle_lt_or_eq_dec _ _ (Rplus_le_le_0_compat _ _ N K)) as [L | Z]; [exact L | exfalso].
  destruct (R_norm_zero n) as (X1 & Y1 & Z1); [lra |]. destruct (R_norm_zero k) as (X2 & Y2 & Z2); [lra |].
  rewrite X1, Y1, Z1, X2, Y2, Z2 in E. replace (s * _) with 0 in E by ring. lra.
Qed.

Lemma annuli_positive b c p q : let t := R_bicell b c p q in
  (0 < determinant t -> 0 < R_norm (n1 t) + R_norm (m1 t)) /\
  (0 < determinant t -> 0 < R_norm (n2 t) + R_norm (m2 t)) /\
  (0 < determinant t -> 0 < R_norm (n3 t) + R_norm (m3 t)) /\
  (0 < determinant t -> 0 < R_norm (n4 t) + R_norm (m4 t)).
Proof.
  intro t. assert (K : forall v n l, determinant t = l * square R Rplus Rmult v - dot R Rplus Rmult n v ->
    0 < determinant t -> 0 < R_norm n + R_norm (minus_twice R Rplus Rminus Rmult n l v)).
  { intros v n l E. apply (norms_positive _ _ v _ (-1)). rewrite E. cbv [minus_twice square squared dot x y z]. ring. }
  split; [apply (K p (n1 t) (l1 t))|split; [apply (K c (n2 t) (l2 t))|split; [apply (K b (n3 t) (l3 t))|]]].
  4: change (m4 t) with (minus_twice R Rplus Rminus Rmult (n4 t) (dot R Rplus Rmult (cross R Rminus Rmult c p) q +
    dot R Rplus Rmult (cross R Rminus Rmult b q) p) b); apply K.
  all: unfold t, R_bicell, bicell_terms; cbv [determinant n1 n2 n3 n4 l1 l2 l3];
    generalize (square R Rplus Rmult b) (square R Rplus Rmult c) (square R Rplus Rmult p) (square R Rplus Rmult q);
    destruct b as [b1 b2 b3], c as [c1 c2 c3], p as [p1 p2 p3], q as [q1 q2 q3]; intros; cbv [x y z vadd vsub cross dot combination]; ring.
Qed.

Lemma forall2_4 {A B} (Q : A -> B -> Prop) a b c d a' b' c' d' :
  Forall2 Q [a; b; c; d] [a'; b'; c'; d'] -> Q a a' /\ Q b b' /\ Q c c' /\ Q d d'.
Proof.
  intro H. inversion_clear H as [| ? ? ? ? H1 H']. inversion_clear H' as [| ? ? ? ? H2 H'']. inversion_clear H'' as [| ? ? ? ? H3 H'].
  inversion_clear H' as [| ? ? ? ? H4 _]. auto.
Qed.
