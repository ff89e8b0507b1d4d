(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter stage in space, operation by operation: src/annulus/predicate/width_terms_3.h, decide.h, filtered_3.h and circumsphere_3.h,
   with the names there. *)
From Coq Require Import List Floats Bool.
From Annulus Require Import operations filter_2.
Import ListNotations.

(* bounds.h. *)
Definition orientation_3 := 47%float.
Definition orientation_3_norms := 122%float.
Definition annulus_3_insphere := 1105%float.
Definition annulus_3_norms := 3246%float.
Definition annulus_3_side := 169%float.
Definition filter_range_3 := (0x1p100)%float.
Definition circumsphere_3 := 1123%float.
Definition constants_3 := [orientation_3; orientation_3_norms; annulus_3_insphere; annulus_3_norms; annulus_3_side; filter_range_3; circumsphere_3].

Definition orientation_3_u := Eval vm_compute in (orientation_3 * u)%float.
Definition orientation_3_norms_u := Eval vm_compute in (orientation_3_norms * u)%float.
Definition annulus_3_insphere_u := Eval vm_compute in (annulus_3_insphere * u)%float.
Definition annulus_3_norms_u := Eval vm_compute in (annulus_3_norms * u)%float.
Definition circumsphere_3_u := Eval vm_compute in (circumsphere_3 * u)%float.
Definition annulus_3_side_u := Eval vm_compute in (annulus_3_side * u)%float.

(* Whether the widths of the cells enter. *)
Inductive cells := never | where_needed | always.

Section over.
Variable o : operations.
Let T := number o.
Local Infix "+" := (add o).
Local Infix "-" := (sub o).
Local Infix "*" := (mul o).

Record vector_3 := { x3 : T; y3 : T; z3 : T }.
Definition each (f : T -> T -> T) (u v : vector_3) := {| x3 := f (x3 u) (x3 v); y3 := f (y3 u) (y3 v); z3 := f (z3 u) (z3 v) |}.
Definition plus_3 := each (add o).
Definition difference_3 := each (sub o).
Definition minus_3 (u : vector_3) := {| x3 := opposite o (x3 u); y3 := opposite o (y3 u); z3 := opposite o (z3 u) |}.
Definition largest_3 (v : vector_3) := greater o (greater o (magnitude o (x3 v)) (magnitude o (y3 v))) (magnitude o (z3 v)).

Definition cross (u v : vector_3) :=
  {| x3 := y3 u * z3 v - z3 u * y3 v; y3 := z3 u * x3 v - x3 u * z3 v; z3 := x3 u * y3 v - y3 u * x3 v |}.
Definition dot (u v : vector_3) := (x3 u * x3 v + y3 u * y3 v) + z3 u * z3 v.
Definition square_3 (u : vector_3) := (square o (x3 u) + square o (y3 u)) + square o (z3 u).
Definition combination (r : T) (u : vector_3) (s : T) (v : vector_3) (t : T) (w : vector_3) :=
  {| x3 := (r * x3 u - s * x3 v) + t * x3 w; y3 := (r * y3 u - s * y3 v) + t * y3 w; z3 := (r * z3 u - s * z3 v) + t * z3 w |}.
Definition minus_twice (n : vector_3) (l : T) (a : vector_3) :=
  let twice := l + l in {| x3 := x3 n - twice * x3 a; y3 := y3 n - twice * y3 a; z3 := z3 n - twice * z3 a |}.

Definition largest_slab (uv vw wu : vector_3) :=
  let v_pair := plus_3 uv vw in
  let w_pair := plus_3 vw wu in
  let u_pair := plus_3 wu uv in
  let facet := plus_3 v_pair wu in
  let facets := greater o (greater o (square_3 uv) (square_3 vw)) (greater o (square_3 wu) (square_3 facet)) in
  let pairs := greater o (greater o (square_3 u_pair) (square_3 v_pair)) (square_3 w_pair) in
  greater o facets pairs.

Definition orientation_terms_3 (u v w : vector_3) : width_terms o :=
  let uv := cross u v in
  let largest := largest_slab uv (cross v w) (cross w u) in
  {| determinant := dot uv w; inner := largest; outer := largest |}.

(* inner, outer, side of one partition A | B. *)
Record partition := { inner_3 : T; outer_3 : T; side : T }.
Record bicell_terms := {
  insphere : T;
  abc_pq : partition; ab_cpq : partition; ca_bpq : partition; bc_apq : partition;
  cell_p : T; cell_q : T;
  cell_p_slab : T; cell_q_slab : T }.   (* the squared area vectors that cell_p_terms and cell_q_terms compute *)

Definition bicell (b c p q : vector_3) : bicell_terms :=
  let bc := cross b c in let bp := cross b p in let bq := cross b q in
  let cp := cross c p in let cq := cross c q in let pq := cross p q in
  let bb := square_3 b in let cc := square_3 c in let pp := square_3 p in let qq := square_3 q in
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
  let n1 := difference_3 up vq in
  let m1 := minus_twice n1 l1 p in
  let l2 := l1 + lc in
  let n2 := difference_3 n1 vc in
  let m2 := minus_twice n2 l2 c in
  let l3 := l1 + lb in
  let n3 := plus_3 n1 ub in
  let m3 := minus_twice n3 l3 b in
  let l4 := lb + lc in
  let n4 := difference_3 ub vc in
  let m4 := minus_twice n4 l4 b in
  {| insphere := determinant;
     abc_pq := {| inner_3 := square_3 n1; outer_3 := square_3 m1; side := l1 |};
     ab_cpq := {| inner_3 := square_3 n2; outer_3 := square_3 m2; side := l2 |};
     ca_bpq := {| inner_3 := square_3 n3; outer_3 := square_3 m3; side := l3 |};
     bc_apq := {| inner_3 := square_3 m4; outer_3 := square_3 n4; side := opposite o l4 |};
     cell_p := opposite o nq; cell_q := lp;
     cell_p_slab := largest_slab (minus_3 bc) bp (minus_3 cp);
     cell_q_slab := largest_slab bc cq (minus_3 bq) |}.

Definition in_range_3 (m : T) :=
  less_equal o m (constant o filter_range_3) && less_equal o (constant o 1%float) (m * constant o filter_range_3).

Definition width_error (m : T) := let m2 := m * m in constant o orientation_3_u * (m2 * m).
Definition width_norms (m : T) := let m2 := m * m in constant o orientation_3_norms_u * m2.
Definition decide_width (determinant largest m : T) (certified : bool) : answer T :=
  decide o determinant (constant o 2%float * root o largest) (width_error m) (width_norms m) certified.

Definition orientation_magnitude_3 (u v w : vector_3) := greater o (greater o (largest_3 u) (largest_3 v)) (largest_3 w).

Definition orientation_filter_3 (a b c d : vector_3) (certified : bool) : answer T :=
  let u := difference_3 b a in let v := difference_3 c a in let w := difference_3 d a in
  let m := orientation_magnitude_3 u v w in
  if negb (in_range_3 m) then refused
  else let t := orientation_terms_3 u v w in decide_width (determinant o t) (inner o t) m certified.

(* both(): std::min(a, b) is b if b < a, else a. *)
Definition both (needed : bool) (l r : answer T) : answer T :=
  match l with
  | positive s => if needed then match r with positive t => positive (if less o t s then t else s) | _ => refused end else l
  | _ => l
  end.

Definition norms (k : partition) := root o (inner_3 k) + root o (outer_3 k).
Definition bicell_magnitude (b c p q : vector_3) :=
  greater o (greater o (largest_3 b) (largest_3 c)) (greater o (largest_3 p) (largest_3 q)).
Definition bicell_error (m : T) := let m2 := m * m in constant o annulus_3_insphere_u * (m2 * m2 * m).
Definition bicell_norms (m : T) := let m2 := m * m in constant o annulus_3_norms_u * (m2 * m2).
Definition side_error (m : T) := let m2 := m * m in constant o annulus_3_side_u * (m2 * m).
Definition wrong_side (m : T) (k : partition) := negb (less o (side_error m) (side k)).

(* unless(): a tolerance that the cells lower is no answer where one of the sums may be positive or not, and none is certainly not. *)
Definition unless (doubt : bool) (alone whole : answer T) : answer T :=
  match alone, whole with
  | positive s, positive t => if doubt && less o t s then refused else whole
  | _, _ => whole
  end.
Definition certainly_wrong_side (m : T) (k : partition) := less o (side k) (opposite o (side_error m)).

Definition bicell_filter (a b c p q : vector_3) (certified : bool) (cells : cells) : answer T :=
  let b := difference_3 b a in let c := difference_3 c a in let p := difference_3 p a in let q := difference_3 q a in
  let m := bicell_magnitude b c p q in
  if negb (in_range_3 m) then refused
  else
    let t := bicell b c p q in
    let largest := greater o (greater o (norms (abc_pq t)) (norms (ab_cpq t))) (greater o (norms (ca_bpq t)) (norms (bc_apq t))) in
    let needed := match cells with
                  | never => false
                  | where_needed => wrong_side m (ab_cpq t) || wrong_side m (ca_bpq t) || wrong_side m (bc_apq t)
                  | always => true
                  end in
    let annuli := decide o (insphere t) largest (bicell_error m) (bicell_norms m) certified in
    let doubt := match cells with
                 | where_needed => certified && negb (certainly_wrong_side m (ab_cpq t) || certainly_wrong_side m (ca_bpq t) ||
                                                      certainly_wrong_side m (bc_apq t))
                 | _ => false
                 end in
    unless doubt annuli
      (both needed (both needed annuli (decide_width (cell_p t) (cell_p_slab t) m certified))
                   (decide_width (cell_q t) (cell_q_slab t) m certified)).

(* circumsphere_3.h, signs and nothing else. *)
Record circumsphere := { origin_3 : vector_3; normal_3 : vector_3; six_volume : T; extent_3 : T }.
Definition circumsphere_from (a u v t : vector_3) : circumsphere :=
  let uv := cross u v in let vt := cross v t in let tu := cross t u in
  let uu := square_3 u in let vv := square_3 v in let tt := square_3 t in
  {| origin_3 := a;
     normal_3 := {| x3 := (uu * x3 vt + vv * x3 tu) + tt * x3 uv; y3 := (uu * y3 vt + vv * y3 tu) + tt * y3 uv;
                    z3 := (uu * z3 vt + vv * z3 tu) + tt * z3 uv |};
     six_volume := dot uv t; extent_3 := greater o (largest_3 u) (greater o (largest_3 v) (largest_3 t)) |}.
Definition circumsphere_of (a b c d : vector_3) := circumsphere_from a (difference_3 b a) (difference_3 c a) (difference_3 d a).

Definition outside_from_3 (k : circumsphere) (w : vector_3) : T := square_3 w * six_volume k - dot w (normal_3 k).
Definition outside_of_3 (k : circumsphere) (p : vector_3) : T := outside_from_3 k (difference_3 p (origin_3 k)).
Definition raised_3 (k : circumsphere) (m : T) (p : vector_3) : T := greater o m (largest_3 (difference_3 p (origin_3 k))).

Definition cell_error (m : T) := constant o orientation_3_u * (m * m * m).
Definition sphere_positive (k : circumsphere) : bool := less o (cell_error (extent_3 k)) (six_volume k) && in_range_3 (extent_3 k).
Definition sphere_error (m : T) := let m2 := m * m in constant o circumsphere_3_u * (m2 * m2 * m).
Definition clear_3 (determinant m : T) : bool := less o (sphere_error m) determinant && less_equal o m (constant o filter_range_3).
Definition excludes_3 (k : circumsphere) (p : vector_3) : bool := clear_3 (outside_of_3 k p) (raised_3 k (extent_3 k) p).
Definition contains_3 (k : circumsphere) (p : vector_3) : bool := clear_3 (opposite o (outside_of_3 k p)) (raised_3 k (extent_3 k) p).
Definition excludes_all_3 (k : circumsphere) (ps : list vector_3) : bool :=
  let least l p := if less o (outside_of_3 k p) l then outside_of_3 k p else l in
  clear_3 (fold_left least ps (constant o infinity)) (fold_left (raised_3 k) ps (extent_3 k)) && sphere_positive k.
End over.

(* The expressions, to be compared with those the C++ templates record. *)
Definition input_3 (i : nat) : vector_3 recorded :=
  {| x3 := Input (3 * i) : number recorded; y3 := Input (3 * i + 1) : number recorded; z3 := Input (3 * i + 2) : number recorded |}.
Definition orientation_3_expressions := terms_of (orientation_terms_3 recorded (input_3 0) (input_3 1) (input_3 2)).
Definition bicell_3_terms := bicell recorded (input_3 0) (input_3 1) (input_3 2) (input_3 3).
Definition partitions (t : bicell_terms recorded) := [abc_pq _ t; ab_cpq _ t; ca_bpq _ t; bc_apq _ t].
Definition bicell_3_expressions : list expression :=
  let t := bicell_3_terms in
  ((insphere _ t :: map (inner_3 _) (partitions t)) ++ map (outer_3 _) (partitions t) ++ map (side _) (partitions t) ++
   [cell_p _ t; cell_q _ t])%list.
Definition cell_p_expressions : list expression := let t := bicell_3_terms in [cell_p _ t; cell_p_slab _ t; cell_p_slab _ t].
Definition cell_q_expressions : list expression := let t := bicell_3_terms in [cell_q _ t; cell_q_slab _ t; cell_q_slab _ t].
