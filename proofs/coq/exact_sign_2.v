(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Signs that the filter stage could not decide, where no tolerance is needed: src/annulus/predicate/exact_sign.cpp in the plane, by integers where the
   coordinates have few bits; else by intervals, and where an interval holds 0 by integers. In the code the former have a fixed width, which their
   determinants do not exceed (integer_signs.cpp); here both are Z. Which of the two decides does not matter to the theorems. Intervals, scale and integers are those of interval_2.v and integers_2.v; the formulas are the prepared circle's.

   - exact_orientation_sign_right, exact_empty_sphere_sign_right   of coordinates in the domain the sign is right, 0 included *)
From Coq Require Import Reals Lra ZArith List.
From Flocq Require Import Core.
From Coq Require Import Floats.
From Annulus Require width_2.
From Annulus Require Import points_2 filter_plane operations bridge connect filter_2 interval_2 float_interval interval_tail integers_2 real_terms_2 returned_2.
From Annulus Require Import exact_2 interval_returned_2 exact_returned_2.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

(* ---- As the code has it ---- *)

Section over.
Variable o : operations.
Local Infix "+" := (add o).
Local Infix "-" := (sub o).
Local Infix "*" := (mul o).
(* `orientation` and `empty_sphere`, of vectors to the first point. *)
Definition turn_of (u v : vector o) : number o := x _ u * y _ v - y _ u * x _ v.
Definition circle_of (u w v : vector o) : number o :=
  let uu := squared o (x _ u) + squared o (y _ u) in
  let vv := squared o (x _ v) + squared o (y _ v) in
  let ww := squared o (x _ w) + squared o (y _ w) in
  (x _ w * (y _ u * vv - y _ v * uu) + y _ w * (x _ v * uu - x _ u * vv)) + ww * turn_of u v.
End over.

Definition interval_sign (d : interval) : option Z :=
  if below nought (lower d) then Some 1%Z else if below (upper d) nought then Some (-1)%Z else None.
Definition sign_of (d : interval) (n : Z) : Z := match interval_sign d with Some s => s | None => Z.sgn n end.
Definition decided (coordinates : list Z) (d : interval) (n : Z) : Z :=
  if forallb (fun k => Z.ltb (Z.abs k) (2 ^ 124)) coordinates then Z.sgn n else sign_of d n.
Definition coordinates_of (l : list (vector integers)) : list Z := flat_map (fun v => [x _ v; y _ v]) l.

Definition exact_orientation_sign (a b c : vector machine) : Z :=
  let s := scale_of (largest_coordinate (pairs b a ++ pairs c a)) in
  let integer v := to_integers (common (numbers [a; b; c])) v in
  decided (coordinates_of (map integer [a; b; c])) (turn_of intervals (i_vector s b a) (i_vector s c a))
    (turn_of integers (difference _ (integer b) (integer a)) (difference _ (integer c) (integer a))).
Definition exact_empty_sphere_sign (a b p q : vector machine) : Z :=
  let s := scale_of (largest_coordinate (pairs b a ++ pairs p a ++ pairs q a)) in
  let integer v := to_integers (common (numbers [a; b; p; q])) v in
  decided (coordinates_of (map integer [a; b; p; q])) (circle_of intervals (i_vector s b a) (i_vector s p a) (i_vector s q a))
    (circle_of integers (difference _ (integer b) (integer a)) (difference _ (integer p) (integer a)) (difference _ (integer q) (integer a))).

(* ---- It is right ---- *)

Definition has_sign (s : Z) (det : R) : Prop := match s with Z0 => det = 0 | Zpos _ => 0 < det | Zneg _ => det < 0 end.

Lemma integer_sign_right n c det : 0 < c -> det = IZR n * c -> has_sign (Z.sgn n) det.
Proof.
  intros C E. subst det. destruct n as [|n|n]; simpl; [ring| |]; [assert (0 < IZR (Z.pos n)) by now apply IZR_lt|assert (IZR (Z.neg n) < 0) by now apply IZR_lt]; nra.
Qed.
Lemma sign_of_right d n k c det : 0 < k -> 0 < c -> holds d (k * det) -> det = IZR n * c -> has_sign (sign_of d n) det.
Proof.
  intros K C H E. unfold sign_of, interval_sign. destruct (below nought (lower d)) eqn:P.
  - destruct (positive_end _ _ P H) as (_ & L & L'). simpl. nra.
  - destruct (below (upper d) nought) eqn:N.
    + assert (L := negative_end _ _ N H). simpl. nra.
    + now apply integer_sign_right with c.
Qed.
Lemma decided_right l d n k c det : 0 < k -> 0 < c -> holds d (k * det) -> det = IZR n * c -> has_sign (decided l d n) det.
Proof.
  intros K C H E. unfold decided. destruct (forallb _ l); [now apply integer_sign_right with c|now apply sign_of_right with k c].
Qed.

Lemma circle_encloses u w v u' w' v' : holds_vector u u' -> holds_vector w w' -> holds_vector v v' ->
  holds (circle_of intervals u w v) (circle_of reals u' w' v').
Proof.
  intros [U1 U2] [W1 W2] [V1 V2]. unfold circle_of, turn_of, squared. cbn [intervals reals add sub mul square]. cbv zeta. enclose.
Qed.
Lemma circle_scaled c u w v u' w' v' : scaled_vector c u u' -> scaled_vector c w w' -> scaled_vector c v v' ->
  circle_of reals u' w' v' = IZR (circle_of integers u w v) * (c * c * (c * c)).
Proof.
  intros [Ux Uy] [Wx Wy] [Vx Vy]. unfold circle_of, turn_of, squared. cbn [integers reals add sub mul square number] in *. cbv zeta. rewrite Ux, Uy, Wx, Wy, Vx, Vy.
  repeat rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR. ring.
Qed.

Section right.
Variable f : nat -> vector machine.
Let ref : nat -> point_2 := fun v => at_2 (f v).

Theorem exact_orientation_sign_right a b c : (forall v, In v [a; b; c] -> coordinates_2 (f v)) ->
  has_sign (exact_orientation_sign (f a) (f b) (f c)) (turn_at ref a b c).
Proof.
  intro Dom. assert (A : coordinates_2 (f a)) by (apply Dom; simpl; tauto). assert (B : coordinates_2 (f b)) by (apply Dom; simpl; tauto).
  assert (C : coordinates_2 (f c)) by (apply Dom; simpl; tauto).
  unfold exact_orientation_sign. cbv zeta. set (s := scale_of _). assert (G : good_scale s).
  { apply scale_good. intros i j I. apply in_app_or in I. destruct I as [I|I]; revert I; now apply pairs_coordinates. }
  assert (K : 0 < scale_factor s) by (apply Rmult_lt_0_compat; apply G).
  set (l := [f a; f b; f c]). set (k := common (numbers l)). assert (P := bpow_gt_0 radix2 k).
  assert (la : In (f a) l) by (simpl; tauto). assert (lb : In (f b) l) by (simpl; tauto). assert (lc : In (f c) l) by (simpl; tauto).
  destruct (vector_encloses s _ _ G B A) as [U1 U2], (vector_encloses s _ _ G C A) as [V1 V2].
  destruct (integers_stand l _ _ lb la) as [X1 X2], (integers_stand l _ _ lc la) as [Y1 Y2].
  apply decided_right with (scale_factor s * scale_factor s) (bpow radix2 k * bpow radix2 k); [now apply Rmult_lt_0_compat|now apply Rmult_lt_0_compat| |].
  - replace (_ * turn_at ref a b c) with (turn_of reals (scaled_by (scale_factor s) (value (x _ (f a))) (value (y _ (f a))) (value (x _ (f b))) (value (y _ (f b))))
      (scaled_by (scale_factor s) (value (x _ (f a))) (value (y _ (f a))) (value (x _ (f c))) (value (y _ (f c)))))
      by (unfold turn_at, turning, width_2.turn, turn_of, scaled_by; simpl; ring).
    unfold turn_of. cbn [intervals reals sub mul]. enclose.
  - replace (turn_at ref a b c) with (turn_of reals (scaled_by 1 (value (x _ (f a))) (value (y _ (f a))) (value (x _ (f b))) (value (y _ (f b))))
      (scaled_by 1 (value (x _ (f a))) (value (y _ (f a))) (value (x _ (f c))) (value (y _ (f c)))))
      by (unfold turn_at, turning, width_2.turn, turn_of, scaled_by; simpl; ring).
    unfold turn_of. cbn [integers reals sub mul number] in *. rewrite X1, X2, Y1, Y2, minus_IZR, !mult_IZR. fold k. ring.
Qed.

Theorem exact_empty_sphere_sign_right a b p q : (forall v, In v [a; b; p; q] -> coordinates_2 (f v)) ->
  has_sign (exact_empty_sphere_sign (f a) (f b) (f p) (f q)) (incircle_at ref a b p q).
Proof.
  intro Dom. assert (A : coordinates_2 (f a)) by (apply Dom; simpl; tauto). assert (B : coordinates_2 (f b)) by (apply Dom; simpl; tauto).
  assert (C : coordinates_2 (f p)) by (apply Dom; simpl; tauto). assert (Q : coordinates_2 (f q)) by (apply Dom; simpl; tauto).
  unfold exact_empty_sphere_sign. cbv zeta. set (s := scale_of _). assert (G : good_scale s).
  { apply scale_good. intros i j I. apply in_app_or in I. destruct I as [I|I]; [|apply in_app_or in I; destruct I as [I|I]]; revert I; now apply pairs_coordinates. }
  assert (K : 0 < scale_factor s) by (apply Rmult_lt_0_compat; apply G). assert (K2 := Rmult_lt_0_compat _ _ K K).
  set (l := [f a; f b; f p; f q]). set (k := common (numbers l)). assert (P := bpow_gt_0 radix2 k). assert (P2 := Rmult_lt_0_compat _ _ P P).
  assert (la : In (f a) l) by (simpl; tauto). assert (lb : In (f b) l) by (simpl; tauto). assert (lp : In (f p) l) by (simpl; tauto).
  assert (lq : In (f q) l) by (simpl; tauto).
  set (to_first r v := scaled_by r (value (x _ (f a))) (value (y _ (f a))) (value (x _ (f v))) (value (y _ (f v)))).
  assert (E : forall r, circle_of reals (to_first r b) (to_first r p) (to_first r q) = r * r * (r * r) * incircle_at ref a b p q)
    by (intro r; unfold incircle_at, width_2.incircle, width_2.turn, circle_of, turn_of, squared, to_first, scaled_by; simpl; ring).
  apply decided_right with (scale_factor s * scale_factor s * (scale_factor s * scale_factor s)) (bpow radix2 k * bpow radix2 k * (bpow radix2 k * bpow radix2 k));
    [now apply Rmult_lt_0_compat|now apply Rmult_lt_0_compat| |].
  - rewrite <- E. apply circle_encloses; now apply vector_encloses.
  - transitivity (circle_of reals (to_first 1 b) (to_first 1 p) (to_first 1 q)); [rewrite E; ring|].
    now apply circle_scaled; apply integers_stand.
Qed.
End right.
