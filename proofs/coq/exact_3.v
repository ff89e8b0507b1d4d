(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* exact_2.v in space: src/annulus/predicate/filtered_3.cpp. *)
From Coq Require Import ZArith List Bool.
From Coq Require Import Floats.
From Annulus Require Import operations filter_2 filter_3 interval_2 integers_2 integers_3 exact_2.
Import ListNotations.
Close Scope float_scope.

Definition numbers_3 (l : list (vector_3 machine)) : list float := flat_map (fun v : vector_3 machine => [x3 machine v : float; y3 machine v : float; z3 machine v : float]) l.
Definition to_integers_3 (k : Z) (v : vector_3 machine) : vector_3 integers := integer_point_3 k (x3 _ v) (y3 _ v) (z3 _ v).

Definition orientation_3_exact (a b c d : vector_3 machine) : answer float :=
  let k := common (numbers_3 [a; b; c; d]) in
  exact_verdict (tetrahedron_of integers (to_integers_3 k a) (to_integers_3 k b) (to_integers_3 k c) (to_integers_3 k d)) k.

(* 0 where the determinant is not positive. *)
Definition half_width_lower (t : width_terms integers) (k : Z) : double :=
  let det := determinant _ t : Z in
  if (0 <? det)%Z then quotient_by_roots_lower det (inner _ t) (outer _ t) k else nought.
Definition least_of (k : Z) (first : width_terms integers) (l : list (width_terms integers)) : double :=
  fold_left (fun m t => least m (half_width_lower t k)) l (half_width_lower first k).

Definition exact_bicell (t : bicell_terms integers) (k : Z) (use : cells) : answer float :=
  let det := insphere _ t : Z in
  let sides := [side _ (ab_cpq _ t) : Z; side _ (ca_bpq _ t) : Z; side _ (bc_apq _ t) : Z] in
  let wrong_side := existsb (fun l => negb (0 <? l)%Z) sides in
  let needed := match use with never => false | where_needed => wrong_side | always => true end in
  if (det <? 0)%Z then negative 0%float else if (det =? 0)%Z then filter_2.zero 0%float
  else positive (to_float (least_of k (of_partition _ t (abc_pq _ t))
    ([of_partition _ t (ab_cpq _ t); of_partition _ t (ca_bpq _ t); of_partition _ t (bc_apq _ t)] ++ if needed then two_cells _ t else []))).

Definition empty_sphere_3_exact (a b c p q : vector_3 machine) (use : cells) : answer float :=
  let k := common (numbers_3 [a; b; c; p; q]) in
  exact_bicell (bicell_of integers (to_integers_3 k a) (to_integers_3 k b) (to_integers_3 k c) (to_integers_3 k p) (to_integers_3 k q)) k use.
