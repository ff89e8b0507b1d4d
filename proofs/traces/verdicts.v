(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The tolerance of a certificate that was evaluated, from the positions of its points: what the stages of predicate_2.v and predicate_3.v answer, one after
   another, in the mode `lower_bound`. The exact stage is not evaluated, and that of intervals seldom, because they take Coq long; link/check is about them.

   - same_tolerance    a tolerance is that of the filter stage where that is sure, else, if asked, that of the interval stage where that is *)
From Coq Require Import List Floats.
From Annulus Require Import filter_2 filter_3 interval_2 interval_3.
From Annulus Require operations.
From Annulus_traces Require Import machine words.
Import ListNotations.

Definition at_point (a b : float) : filter_2.vector operations.machine := {| filter_2.x := a : operations.number operations.machine; filter_2.y := b |}.
Definition point_3 (a b c : float) : vector_3 operations.machine := {| x3 := a : operations.number operations.machine; y3 := b; z3 := c |}.

(* The later stage is a function, since Coq's machine computes what it is given at once. *)
Definition is_that (intervals : bool) (first : answer float) (later : unit -> answer float) (t : float) : bool :=
  match first with
  | refused => if intervals then match later tt with positive u => words.same u t | _ => true end else true
  | positive u => words.same u t
  | _ => false
  end.
Definition same_tolerance (intervals : bool) (l : list machine.point) (t : float) : bool :=
  match l with
  | [[ax; ay]; [bx; by']; [cx; cy]] =>
      let a := at_point ax ay in let b := at_point bx by' in let c := at_point cx cy in
      is_that intervals (orientation_filter operations.machine a b c true) (fun _ => orientation_interval a b c) t
  | [[ax; ay]; [bx; by']; [px; py]; [qx; qy]] =>
      let a := at_point ax ay in let b := at_point bx by' in let p := at_point px py in let q := at_point qx qy in
      is_that intervals (empty_sphere_filter operations.machine a b p q true) (fun _ => empty_sphere_interval a b p q) t
  | [[ax; ay; az]; [bx; by'; bz]; [cx; cy; cz]; [dx; dy; dz]] =>
      let a := point_3 ax ay az in let b := point_3 bx by' bz in let c := point_3 cx cy cz in let d := point_3 dx dy dz in
      is_that intervals (orientation_filter_3 operations.machine a b c d true) (fun _ => orientation_3_interval a b c d) t
  | [[ax; ay; az]; [bx; by'; bz]; [cx; cy; cz]; [px; py; pz]; [qx; qy; qz]] =>
      let a := point_3 ax ay az in let b := point_3 bx by' bz in let c := point_3 cx cy cz in
      let p := point_3 px py pz in let q := point_3 qx qy qz in
      is_that intervals (bicell_filter operations.machine a b c p q true where_needed) (fun _ => empty_sphere_3_interval a b c p q where_needed) t
  | _ => false
  end.
