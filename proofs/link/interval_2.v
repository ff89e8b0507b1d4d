(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The interval stage in the plane, with Flocq's binary64 operations rounded up and down: src/annulus/certificate/ladder_2.cpp over
   Boost.Interval with the policy of src/annulus/arithmetic/interval.h. Coq's primitive floats round to nearest only. *)
From Coq Require Import ZArith List Bool.
From Flocq Require Import IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus_link Require Import operations filter_2.
Import ListNotations.
Close Scope float_scope.

Notation double := (binary_float prec emax).
Definition of_float (f : float) : double := Prim2B f.
Definition to_float (x : double) : float := B2Prim x.

Definition plus := Bplus (prec := prec) (emax := emax) (prec_gt_0_ := eq_refl Lt) (prec_lt_emax_ := eq_refl Lt).
Definition minus := Bminus (prec := prec) (emax := emax) (prec_gt_0_ := eq_refl Lt) (prec_lt_emax_ := eq_refl Lt).
Definition times := Bmult (prec := prec) (emax := emax) (prec_gt_0_ := eq_refl Lt) (prec_lt_emax_ := eq_refl Lt).
Definition over := Bdiv (prec := prec) (emax := emax) (prec_gt_0_ := eq_refl Lt) (prec_lt_emax_ := eq_refl Lt).
Definition root_of := Bsqrt (prec := prec) (emax := emax) (prec_gt_0_ := eq_refl Lt) (prec_lt_emax_ := eq_refl Lt).
Definition below (a b : double) := Bltb a b.
Definition nought : double := B754_zero false.
Definition least (a b : double) := if below b a then b else a.
Definition most (a b : double) := if below a b then b else a.

Record interval := { lower : double; upper : double }.
Definition exactly (a : double) := {| lower := a; upper := a |}.

Definition i_add (a b : interval) := {| lower := plus mode_DN (lower a) (lower b); upper := plus mode_UP (upper a) (upper b) |}.
Definition i_sub (a b : interval) := {| lower := minus mode_DN (lower a) (upper b); upper := minus mode_UP (upper a) (lower b) |}.
(* Boost tells nine cases apart; each is the least and the greatest of four products, by monotony of rounding. *)
Definition i_mul (a b : interval) :=
  let products m := (times m (lower a) (lower b), times m (lower a) (upper b), times m (upper a) (lower b), times m (upper a) (upper b)) in
  let '(p, q, r, s) := products mode_DN in
  let '(p', q', r', s') := products mode_UP in
  {| lower := least (least p q) (least r s); upper := most (most p' q') (most r' s') |}.
Definition i_square (a : interval) :=
  if below (upper a) nought then {| lower := times mode_DN (upper a) (upper a); upper := times mode_UP (lower a) (lower a) |}
  else if below nought (lower a) then {| lower := times mode_DN (lower a) (lower a); upper := times mode_UP (upper a) (upper a) |}
  else {| lower := nought; upper := most (times mode_UP (lower a) (lower a)) (times mode_UP (upper a) (upper a)) |}.
Definition i_sqrt (a : interval) :=
  {| lower := if below nought (lower a) then root_of mode_DN (lower a) else nought; upper := root_of mode_UP (upper a) |}.
(* Of a positive one by one that is positive or has no upper bound for its quotient. *)
Definition i_div (a b : interval) :=
  {| lower := over mode_DN (lower a) (upper b);
     upper := if below nought (lower b) then over mode_UP (upper a) (lower b) else B754_infinity false |}.
Definition i_max (a b : interval) := {| lower := most (lower a) (lower b); upper := most (upper a) (upper b) |}.

Definition intervals : operations := {|
  number := interval;
  add := i_add; sub := i_sub; mul := i_mul; div := i_div; root := i_sqrt; square := i_square; greater := i_max;
  opposite a := a; magnitude a := a; less _ _ := false; less_equal _ _ := false;  (* not used *)
  constant c := exactly (of_float c) |}.

(* split_scale: 2^first and 2^second with first + second = - ilogb(m) - 1; C++ divides towards zero. *)
Definition power_of_two (k : Z) : double := of_float (Z.ldexp 1%float k).
Definition split_scale (m : double) : double * double :=
  let k := if below nought m then Z.opp (snd (Z.frexp (to_float m))) else 0%Z in
  let half := Z.quot k 2 in
  (power_of_two half, power_of_two (k - half)).

(* Differences of all pairs, rounded up as everything here. *)
Definition up_difference (a b : vector machine) : double :=
  let d i j := Babs (minus mode_UP (of_float i) (of_float j)) in most (d (x _ a) (x _ b)) (d (y _ a) (y _ b)).
Fixpoint largest_difference (l : list (vector machine)) : double :=
  match l with
  | [] => nought
  | a :: l => fold_left (fun m b => most m (up_difference a b)) l (largest_difference l)
  end.

Definition scaled (s : double * double) (a b : vector machine) : vector intervals :=
  let d i j := i_mul (i_mul (i_sub (exactly (of_float i)) (exactly (of_float j))) (exactly (fst s))) (exactly (snd s)) in
  {| x := d (x _ a) (x _ b) : number intervals; y := d (y _ a) (y _ b) : number intervals |}.

Definition accept_interval (s : double * double) (t : width_terms intervals) : answer float :=
  let det := determinant _ t : interval in
  if below (upper det) nought then negative 0%float
  else if negb (below nought (lower det)) then refused
  else
    let half_width := i_div det (i_add (i_sqrt (inner _ t)) (i_sqrt (outer _ t))) in
    let slack := minus mode_UP (upper half_width) (lower half_width) in
    if negb (Bleb slack (times mode_UP (of_float filter_slack) (lower half_width))) then refused
    else positive (to_float (most nought (over mode_DN (over mode_DN (lower half_width) (fst s)) (snd s)))).

Definition orientation_interval (a b c : vector machine) : answer float :=
  let s := split_scale (largest_difference [a; b; c]) in
  accept_interval s (orientation_terms intervals (scaled s b a) (scaled s c a) (scaled s c b)).

Definition empty_sphere_interval (a b p q : vector machine) : answer float :=
  let s := split_scale (largest_difference [a; b; p; q]) in
  accept_interval s (annulus_terms intervals (scaled s b a) (scaled s p a) (scaled s q a) (scaled s q p)).
