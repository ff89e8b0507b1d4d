(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter stage in the plane, operation by operation: src/annulus/predicate/width_terms.h, decide.h, filtered_2.h and circumcircle_2.h, with
   the names there. Over any number type of operations.v. Where C++ selects without a branch there is one here. *)
From Coq Require Import List Floats Bool.
From Annulus Require Import operations.
Import ListNotations.

(* bounds.h. *)
Definition u := (0x1p-53)%float.
Definition orientation_2 := 9%float.
Definition annulus_2_incircle := 177%float.
Definition annulus_2_norms := 273%float.
Definition tail := 16%float.
Definition filter_slack := (0x1p-10)%float.
Definition filter_range := (0x1p120)%float.
Definition circumcircle_2 := 129%float.
Definition constants := [u; orientation_2; annulus_2_incircle; annulus_2_norms; tail; filter_slack; filter_range; circumcircle_2].

(* Folded by the compiler, and exact: small integers times powers of two. *)
Definition orientation_2_u := Eval vm_compute in (orientation_2 * u)%float.
Definition annulus_2_incircle_u := Eval vm_compute in (annulus_2_incircle * u)%float.
Definition annulus_2_norms_u := Eval vm_compute in (annulus_2_norms * u)%float.
Definition circumcircle_2_u := Eval vm_compute in (circumcircle_2 * u)%float.
Definition one_less_tail := Eval vm_compute in (1 - tail * u)%float.

(* What a stage says: it passes the question on, or a sign with a tolerance. *)
Inductive answer (T : Type) := refused | negative (tolerance : T) | zero (tolerance : T) | positive (tolerance : T).
Arguments refused {T}.
Arguments negative {T}.
Arguments zero {T}.
Arguments positive {T}.

Section over.
Variable o : operations.
Let T := number o.
Local Infix "+" := (add o).
Local Infix "-" := (sub o).
Local Infix "*" := (mul o).
Local Infix "/" := (div o).

Record vector := { x : T; y : T }.
Record width_terms := { determinant : T; inner : T; outer : T }.

Definition difference (a b : vector) := {| x := x a - x b; y := y a - y b |}.
Definition largest (v : vector) := greater o (magnitude o (x v)) (magnitude o (y v)).
Definition squared (a : T) := square o a.

Definition orientation_terms (u v w : vector) : width_terms :=
  let det := x u * y v - y u * x v in
  let uu := squared (x u) + squared (y u) in
  let vv := squared (x v) + squared (y v) in
  let ww := squared (x w) + squared (y w) in
  let longest := greater o (greater o uu vv) ww in
  {| determinant := det; inner := longest; outer := longest |}.

Definition annulus_terms (b p q e : vector) : width_terms :=
  let ob := x b * y q - y b * x q in
  let oa := y b * x p - x b * y p in
  let D := ob + oa in
  let gx := (x q + x p) - x b in
  let gy := (y q + y p) - y b in
  let s := x e * gx + y e * gy in
  let nx := D * x b - s * y b in
  let ny := D * y b + s * x b in
  let twice_D := D + D in
  let mx := nx - twice_D * x p in
  let my := ny - twice_D * y p in
  let kp := x p * (x p - x b) + y p * (y p - y b) in
  let kq := x q * (x q - x b) + y q * (y q - y b) in
  let incircle := kp * ob + kq * oa in
  let inner := squared nx + squared ny in
  let outer := squared mx + squared my in
  {| determinant := incircle; inner := inner; outer := outer |}.

Definition decide (determinant roots det_error norm_error : T) (certified : bool) : answer T :=
  if less o determinant (opposite o det_error) then negative (constant o 0%float)
  else if negb (less o det_error (determinant * constant o filter_slack)) then refused
  else if negb certified then positive (determinant / roots)
  else if negb (less o norm_error (roots * constant o filter_slack)) then refused
  else positive ((determinant - det_error) / (roots + norm_error) * constant o one_less_tail).

Definition in_range (m : T) :=
  less_equal o m (constant o filter_range) && less_equal o (constant o 1%float) (m * constant o filter_range).

Definition orientation_roots (t : width_terms) := constant o 2%float * root o (inner t).
Definition orientation_magnitude (u v : vector) := greater o (largest u) (largest v).
Definition orientation_error (m : T) := constant o orientation_2_u * (m * m).

Definition orientation_filter (a b c : vector) (certified : bool) : answer T :=
  let u := difference b a in
  let v := difference c a in
  let w := difference c b in
  let m := orientation_magnitude u v in
  if negb (in_range m) then refused
  else let t := orientation_terms u v w in
       decide (determinant t) (orientation_roots t) (orientation_error m) (constant o 0%float) certified.

Definition annulus_roots (t : width_terms) := root o (inner t) + root o (outer t).
Definition annulus_magnitude (b p q e : vector) :=
  greater o (greater o (largest b) (largest p)) (greater o (largest q) (largest e)).
Definition annulus_det_error (m : T) := let m2 := m * m in constant o annulus_2_incircle_u * (m2 * m2).
Definition annulus_norm_error (m : T) := let m2 := m * m in constant o annulus_2_norms_u * (m2 * m).

Definition empty_sphere_filter (a b p q : vector) (certified : bool) : answer T :=
  let b' := difference b a in
  let p' := difference p a in
  let q' := difference q a in
  let e := difference q p in
  let m := annulus_magnitude b' p' q' e in
  if negb (in_range m) then refused
  else let t := annulus_terms b' p' q' e in
       decide (determinant t) (annulus_roots t) (annulus_det_error m) (annulus_norm_error m) certified.

(* circumcircle_2.h, signs and nothing else: the circle through the corners of a triangle, from the differences of two of them to the third. *)
Record circumcircle := { origin : vector; normal : vector; twice_area : T; extent : T }.
Definition circumcircle_from (a u v : vector) : circumcircle :=
  let uu := x u * x u + y u * y u in
  let vv := x v * x v + y v * y v in
  {| origin := a; normal := {| x := y u * vv - y v * uu; y := x v * uu - x u * vv |};
     twice_area := x u * y v - y u * x v; extent := greater o (largest u) (largest v) |}.
Definition circumcircle_of (a b c : vector) := circumcircle_from a (difference b a) (difference c a).

(* outside_of, from the difference w of the point to the third corner; and what m is raised to. *)
Definition outside_from (k : circumcircle) (w : vector) : T :=
  let ww := x w * x w + y w * y w in (x w * x (normal k) + y w * y (normal k)) + ww * twice_area k.
Definition outside_of (k : circumcircle) (p : vector) : T := outside_from k (difference p (origin k)).
Definition raised (k : circumcircle) (m : T) (p : vector) : T := greater o m (largest (difference p (origin k))).

Definition circle_positive (k : circumcircle) : bool :=
  less o (orientation_error (extent k)) (twice_area k) && in_range (extent k).
Definition circle_error (m : T) := let m2 := m * m in constant o circumcircle_2_u * (m2 * m2).
Definition clear (determinant m : T) : bool := less o (circle_error m) determinant && less_equal o m (constant o filter_range).
Definition excludes (k : circumcircle) (p : vector) : bool := clear (outside_of k p) (raised k (extent k) p).
Definition contains (k : circumcircle) (p : vector) : bool := clear (opposite o (outside_of k p)) (raised k (extent k) p).
(* std::min(a, b) is b if b < a, else a. *)
Definition excludes_all (k : circumcircle) (ps : list vector) : bool :=
  let least l p := if less o (outside_of k p) l then outside_of k p else l in
  clear (fold_left least ps (constant o infinity)) (fold_left (raised k) ps (extent k)) && circle_positive k.
End over.

(* The expressions of the terms, to be compared with those the C++ templates record. *)
Definition terms_of (t : width_terms recorded) : list expression :=
  [determinant recorded t; inner recorded t; outer recorded t].
Definition input (i : nat) : vector recorded := {| x := Input (2 * i) : number recorded; y := Input (S (2 * i)) : number recorded |}.
Definition orientation_2_expressions := terms_of (orientation_terms recorded (input 0) (input 1) (input 2)).
Definition annulus_2_expressions := terms_of (annulus_terms recorded (input 0) (input 1) (input 2) (input 3)).
