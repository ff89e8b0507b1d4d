(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The interval stage in the plane, with Flocq's binary64 operations rounded up and down: src/annulus/predicate/filtered_2.cpp and
   interval_stage.h over Boost.Interval with the policy of src/annulus/arithmetic/interval.h. Coq's primitive floats round to nearest only. *)
From Coq Require Import ZArith List Bool.
From Flocq Require Import IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import operations filter_2.
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

(* One mode, upward: a lower end is the opposite of an upper one (rounded_arith_opp). *)
Definition add_down (a b : double) := Bopp (minus mode_UP (Bopp a) b).
Definition sub_down (a b : double) := Bopp (minus mode_UP b a).
Definition mul_down (a b : double) := Bopp (times mode_UP a (Bopp b)).
Definition quotient_lower (a b : double) := Bopp (over mode_UP (Bopp a) b).

Definition i_add (a b : interval) := {| lower := add_down (lower a) (lower b); upper := plus mode_UP (upper a) (upper b) |}.
Definition i_sub (a b : interval) := {| lower := sub_down (lower a) (upper b); upper := minus mode_UP (upper a) (lower b) |}.
Definition i_opp (a : interval) := {| lower := Bopp (upper a); upper := Bopp (lower a) |}.
(* The cases of boost/numeric/interval/arith.hpp. *)
Definition i_mul (a b : interval) :=
  let xl := lower a in let xu := upper a in let yl := lower b in let yu := upper b in
  let nothing := exactly nought in
  let ends l u := {| lower := l; upper := u |} in
  if below xl nought then
    if below nought xu then
      if below yl nought then
        if below nought yu then ends (least (mul_down xl yu) (mul_down xu yl)) (most (times mode_UP xl yl) (times mode_UP xu yu))
        else ends (mul_down xu yl) (times mode_UP xl yl)
      else if below nought yu then ends (mul_down xl yu) (times mode_UP xu yu) else nothing
    else
      if below yl nought then
        if below nought yu then ends (mul_down xl yu) (times mode_UP xl yl) else ends (mul_down xu yu) (times mode_UP xl yl)
      else if below nought yu then ends (mul_down xl yu) (times mode_UP xu yl) else nothing
  else if below nought xu then
    if below yl nought then
      if below nought yu then ends (mul_down xu yl) (times mode_UP xu yu) else ends (mul_down xu yl) (times mode_UP xl yu)
    else if below nought yu then ends (mul_down xl yl) (times mode_UP xu yu) else nothing
  else nothing.
Definition i_square (a : interval) :=
  let xl := lower a in let xu := upper a in
  if below xu nought then {| lower := mul_down xu xu; upper := times mode_UP xl xl |}
  else if below nought xl then {| lower := mul_down xl xl; upper := times mode_UP xu xu |}
  else {| lower := nought; upper := if below xu (Bopp xl) then times mode_UP xl xl else times mode_UP xu xu |}.
Definition i_max (a b : interval) := {| lower := most (lower a) (lower b); upper := most (upper a) (upper b) |}.

Definition intervals : operations := {|
  number := interval;
  add := i_add; sub := i_sub; mul := i_mul; div a _ := a; root a := a; square := i_square; greater := i_max;
  opposite := i_opp; magnitude a := a;
  less _ _ := false; less_equal _ _ := false;  (* like div, root, magnitude: not used *)
  constant c := exactly (of_float c) |}.

(* with_scale: nothing between 2^-100 and 2^100, else 2^first and 2^second with first + second = - ilogb(m) - 1; C++ divides
   towards zero. *)
Definition unscaled_range := (0x1p100)%float.
Definition power_of_two (k : Z) : double := of_float (Z.ldexp 1%float k).
Definition unscaled (m : double) : bool :=
  Bleb m (of_float unscaled_range) && Bleb (of_float 1%float) (times mode_UP m (of_float unscaled_range)).
Definition split_scale (m : double) : double * double :=
  let k := if below nought m then Z.opp (snd (Z.frexp (to_float m))) else 0%Z in
  let half := Z.quot k 2 in
  (power_of_two half, power_of_two (k - half)).

(* Differences to the first point, rounded up as everything here. *)
Definition largest_coordinate (l : list (float * float)) : double :=
  fold_left (fun m '(i, j) => most m (Babs (minus mode_UP (of_float i) (of_float j)))) l nought.

Definition i_difference (s : option (double * double)) (i j : float) : interval :=
  let d := i_sub (exactly (of_float i)) (exactly (of_float j)) in
  match s with None => d | Some (first, second) => i_mul (i_mul d (exactly first)) (exactly second) end.
Definition scale_of (m : double) : option (double * double) := if unscaled m then None else Some (split_scale m).
Definition back (s : option (double * double)) (y : double) : double :=
  let (first, second) := match s with None => (of_float 1%float, of_float 1%float) | Some f => f end in
  quotient_lower (quotient_lower y first) second.

Definition interval_slack := (0x1p-10)%float.
Definition sum_of_roots (a b : double) := plus mode_UP (root_of mode_UP a) (root_of mode_UP b).

(* quotient_lower_in_slack, None where it is not within slack; det is positive. *)
Definition quotient_lower_in_slack (det : interval) (roots_most roots_least : double) : option double :=
  let low := quotient_lower (lower det) roots_most in
  if Bleb (minus mode_UP (over mode_UP (upper det) roots_least) low) (Bopp (times mode_UP (Bopp (of_float interval_slack)) low))
  then Some low else None.

Definition accept_interval (s : option (double * double)) (t : width_terms intervals) : answer float :=
  let det := determinant _ t : interval in
  if below nought (lower det) then
    match quotient_lower_in_slack det (sum_of_roots (upper (inner _ t)) (upper (outer _ t)))
                                   (sum_of_roots (lower (inner _ t)) (lower (outer _ t))) with
    | Some low => positive (to_float (back s low))
    | None => refused
    end
  else if below (upper det) nought then negative 0%float else refused.

Definition pairs (v w : vector machine) : list (float * float) := [(x _ v, x _ w); (y _ v, y _ w)].
Definition i_vector (s : option (double * double)) (v w : vector machine) : vector intervals :=
  {| x := i_difference s (x _ v) (x _ w) : number intervals; y := i_difference s (y _ v) (y _ w) : number intervals |}.

Definition orientation_interval (a b c : vector machine) : answer float :=
  let s := scale_of (largest_coordinate (pairs b a ++ pairs c a)) in
  accept_interval s (orientation_terms intervals (i_vector s b a) (i_vector s c a) (i_vector s c b)).

Definition empty_sphere_interval (a b p q : vector machine) : answer float :=
  let s := scale_of (largest_coordinate (pairs b a ++ pairs p a ++ pairs q a)) in
  accept_interval s (annulus_terms intervals (i_vector s b a) (i_vector s p a) (i_vector s q a) (i_vector s q p)).
