(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* interval_2.v in space: src/annulus/predicate/filtered_3.cpp, with Flocq's binary64 operations rounded up and down. *)
From Coq Require Import ZArith List Bool.
From Flocq Require Import IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import operations filter_2 filter_3 interval_2.
Import ListNotations.
Close Scope float_scope.

Definition pairs_3 (v w : vector_3 machine) : list (float * float) := [(x3 _ v, x3 _ w); (y3 _ v, y3 _ w); (z3 _ v, z3 _ w)].
Definition i_vector_3 (s : option (double * double)) (v w : vector_3 machine) : vector_3 intervals :=
  {| x3 := i_difference s (x3 _ v) (x3 _ w) : number intervals; y3 := i_difference s (y3 _ v) (y3 _ w) : number intervals;
     z3 := i_difference s (z3 _ v) (z3 _ w) : number intervals |}.

Definition orientation_3_interval (a b c d : vector_3 machine) : answer float :=
  let s := scale_of (largest_coordinate (pairs_3 b a ++ pairs_3 c a ++ pairs_3 d a)) in
  accept_interval s (orientation_terms_3 intervals (i_vector_3 s b a) (i_vector_3 s c a) (i_vector_3 s d a)).

(* width_lower: None where the cell is not certainly positive or its width not within slack. *)
Definition width_lower (det slab : interval) : option double :=
  if below nought (lower det) then
    quotient_lower_in_slack det (sum_of_roots (upper slab) (upper slab)) (sum_of_roots (lower slab) (lower slab))
  else None.

(* The greatest, from 0 on, of a number of each partition. *)
Definition greatest (f : partition intervals -> double) (t : bicell_terms intervals) : double :=
  fold_left (fun m k => most m (f k)) [abc_pq _ t; ab_cpq _ t; ca_bpq _ t; bc_apq _ t] nought.
Definition roots (bound : interval -> double) (k : partition intervals) : double :=
  sum_of_roots (bound (inner_3 intervals k)) (bound (outer_3 intervals k)).

Definition accept_bicell (s : option (double * double)) (t : bicell_terms intervals) (use : cells) : answer float :=
  let det := insphere _ t : interval in
  let sides := [side _ (ab_cpq _ t) : interval; side _ (ca_bpq _ t) : interval; side _ (bc_apq _ t) : interval] in
  let wrong_side := existsb (fun l => negb (below nought (lower l))) sides in
  let certainly := existsb (fun l => Bleb (upper l) nought) sides in
  if below nought (lower det) then
    match quotient_lower_in_slack det (greatest (roots upper) t) (greatest (roots lower) t) with
    | None => refused
    | Some annuli =>
        if match use with never => false | where_needed => wrong_side | always => true end then
          match width_lower (cell_p _ t) (cell_p_slab _ t), width_lower (cell_q _ t) (cell_q_slab _ t) with
          | Some p, Some q =>
              if match use with where_needed => negb certainly && below (least p q) annuli | _ => false end
              then refused else positive (to_float (back s (least annuli (least p q))))
          | _, _ => refused
          end
        else positive (to_float (back s annuli))
    end
  else if below (upper det) nought then negative 0%float else refused.

Definition empty_sphere_3_interval (a b c p q : vector_3 machine) (use : cells) : answer float :=
  let s := scale_of (largest_coordinate (pairs_3 b a ++ pairs_3 c a ++ pairs_3 p a ++ pairs_3 q a)) in
  accept_bicell s (bicell intervals (i_vector_3 s b a) (i_vector_3 s c a) (i_vector_3 s p a) (i_vector_3 s q a)) use.
