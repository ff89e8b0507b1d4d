(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The formulas of src/annulus/predicate/width_terms_3.h over any number type, as they are written there, line by line. *)
Require Import Reals ZArith List.
From Annulus Require Import float_model float_error.

Section terms.
Variable T : Type.
Variables add sub mul : T -> T -> T.
Variable opp : T -> T.
Declare Scope number_scope.
Infix "+" := add : number_scope.
Infix "-" := sub : number_scope.
Infix "*" := mul : number_scope.
Open Scope number_scope.

Record vector := Vector { x : T; y : T; z : T }.

Definition squared a := a * a.
Definition cross u v :=
  Vector (y u * z v - z u * y v) (z u * x v - x u * z v) (x u * y v - y u * x v).
Definition dot u v := (x u * x v + y u * y v) + z u * z v.
Definition square u := (squared (x u) + squared (y u)) + squared (z u).
Definition vadd u v := Vector (x u + x v) (y u + y v) (z u + z v).
Definition vsub u v := Vector (x u - x v) (y u - y v) (z u - z v).
Definition vopp u := Vector (opp (x u)) (opp (y u)) (opp (z u)).
Definition combination r u s v t w :=
  Vector ((r * x u - s * x v) + t * x w) ((r * y u - s * y v) + t * y w) ((r * z u - s * z v) + t * z w).
Definition minus_twice n l a :=
  let twice := l + l in Vector (x n - twice * x a) (y n - twice * y a) (z n - twice * z a).

(* The seven area vectors of largest_slab, in the order uv, vw, wu, facet, u_pair, v_pair, w_pair. *)
Definition slabs uv vw wu : list vector :=
  let v_pair := vadd uv vw in
  let w_pair := vadd vw wu in
  let u_pair := vadd wu uv in
  let facet := vadd v_pair wu in
  uv :: vw :: wu :: facet :: u_pair :: v_pair :: w_pair :: nil.

(* orientation_terms *)
Definition tetrahedron_det u v w := dot (cross u v) w.
Definition tetrahedron_slabs u v w := slabs (cross u v) (cross v w) (cross w u).

(* annulus_terms: for each partition the two vectors whose norms are added, `outer` at the point that is not a, and the sum of
   lambda over the side of p, q and so on. *)
Record bicell := Bicell {
  determinant : T;
  n1 : vector; m1 : vector; n2 : vector; m2 : vector; n3 : vector; m3 : vector; n4 : vector; m4 : vector;
  l1 : T; l2 : T; l3 : T; minus_l4 : T;
  cell_p : T; cell_q : T;
  slabs_p : list vector; slabs_q : list vector }.

Definition bicell_terms b c p q :=
  let bc := cross b c in
  let bp := cross b p in
  let bq := cross b q in
  let cp := cross c p in
  let cq := cross c q in
  let pq := cross p q in
  let bb := square b in
  let cc := square c in
  let pp := square p in
  let qq := square q in
  let lb := dot cp q in
  let lc := dot bq p in
  let lp := dot bc q in
  let nq := dot bc p in
  let determinant := (lb * bb + lc * cc) + (lp * pp - nq * qq) in
  let up := combination bb cq cc bq qq bc in
  let vq := combination bb cp cc bp pp bc in
  let ub := combination cc pq pp cq qq cp in
  let vc := combination bb pq pp bq qq bp in
  let l1 := lp - nq in
  let n1 := vsub up vq in
  let m1 := minus_twice n1 l1 p in
  let l2 := l1 + lc in
  let n2 := vsub n1 vc in
  let m2 := minus_twice n2 l2 c in
  let l3 := l1 + lb in
  let n3 := vadd n1 ub in
  let m3 := minus_twice n3 l3 b in
  let l4 := lb + lc in
  let n4 := vsub ub vc in
  let m4 := minus_twice n4 l4 b in
  Bicell determinant n1 m1 n2 m2 n3 m3 n4 m4 l1 l2 l3 (opp l4) (opp nq) lp
    (slabs (vopp bc) bp (vopp cp)) (slabs bc cq (vopp bq)).
End terms.
Arguments Vector {T}. Arguments x {T}. Arguments y {T}. Arguments z {T}.
Arguments determinant {T}. Arguments n1 {T}. Arguments m1 {T}. Arguments n2 {T}. Arguments m2 {T}.
Arguments n3 {T}. Arguments m3 {T}. Arguments n4 {T}. Arguments m4 {T}.
Arguments l1 {T}. Arguments l2 {T}. Arguments l3 {T}. Arguments minus_l4 {T}.
Arguments cell_p {T}. Arguments cell_q {T}. Arguments slabs_p {T}. Arguments slabs_q {T}.

Definition R_bicell := bicell_terms R Rplus Rminus Rmult Ropp.
Definition F_bicell := bicell_terms R fadd fsub fmul Ropp.
Definition R_tetrahedron := tetrahedron_det R Rplus Rminus Rmult.
Definition F_tetrahedron := tetrahedron_det R fadd fsub fmul.
Definition R_slabs := tetrahedron_slabs R Rplus Rminus Rmult.
Definition F_slabs := tetrahedron_slabs R fadd fsub fmul.
Definition R_square := square R Rplus Rmult.
Definition F_square := square R fadd fmul.

Definition E_vector k := Vector (Var k) (Var (S k)) (Var (S (S k))).
Definition E_bicell := bicell_terms expr Plus Minus Times Opp (E_vector 0) (E_vector 3) (E_vector 6) (E_vector 9).
Definition E_tetrahedron := tetrahedron_det expr Plus Minus Times (E_vector 0) (E_vector 3) (E_vector 6).
Definition E_slabs := tetrahedron_slabs expr Plus Minus Times (E_vector 0) (E_vector 3) (E_vector 6).
