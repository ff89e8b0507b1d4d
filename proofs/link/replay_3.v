(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* As replay_2.v, in space. *)
From Coq Require Import List Floats Bool.
From Annulus Require Import operations filter_2 filter_3.
From Annulus_link Require Import replay_2.
Import ListNotations.

(* Points; determinant, inner, outer, m, bounds of determinant and norms, twice the root; answers with certified tolerances, without,
   and with them from a batch. *)
Inductive orientation_3_row := Filter_orientation_3 (ax ay az bx by' bz cx cy cz dx dy dz : float)
  (det inn out m det_error norm_error sum : float) (certified plain batch : answer float).

(* Points; determinant, cells, m, bounds of determinant, norms and sides; inner, outer and side of every partition; answers for cells
   where needed, certified, not, and certified in a batch; certified with the cells always and never. *)
Inductive empty_sphere_3_row := Filter_empty_sphere_3 (ax ay az bx by' bz cx cy cz px py pz qx qy qz : float)
  (det cp cq m det_error norm_error side_error : float)
  (i1 o1 s1 i2 o2 s2 i3 o3 s3 i4 o4 s4 : float) (certified plain batch always never : answer float).

Definition point_3 (a b c : float) : vector_3 machine := {| x3 := a : number machine; y3 := b : number machine; z3 := c : number machine |}.

Definition agrees_orientation_3 (r : orientation_3_row) :=
  let (ax, ay, az, bx, by', bz, cx, cy, cz, dx, dy, dz, det, inn, out, m, det_error, norm_error, sum, certified, plain, batch) := r in
  let a := point_3 ax ay az in let b := point_3 bx by' bz in let c := point_3 cx cy cz in let d := point_3 dx dy dz in
  let u := difference_3 machine b a in let v := difference_3 machine c a in let w := difference_3 machine d a in
  let m' := orientation_magnitude_3 machine u v w in
  let t := orientation_terms_3 machine u v w in
  all [same_terms t det inn out; same (2 * PrimFloat.sqrt (inner machine t))%float sum; same m' m;
       same (width_error machine m') det_error; same (width_norms machine m') norm_error;
       same_answer (orientation_filter_3 machine a b c d true) certified; same_answer certified batch;
       same_answer (orientation_filter_3 machine a b c d false) plain].

Definition same_partition (k : partition machine) (i o s : float) :=
  all [same (inner_3 machine k) i; same (outer_3 machine k) o; same (side machine k) s].

Definition agrees_empty_sphere_3 (r : empty_sphere_3_row) :=
  let (ax, ay, az, bx, by', bz, cx, cy, cz, px, py, pz, qx, qy, qz, det, cp, cq, m, det_error, norm_error, side_error',
       i1, o1, s1, i2, o2, s2, i3, o3, s3, i4, o4, s4, certified, plain, batch, always', never') := r in
  let a := point_3 ax ay az in let b := point_3 bx by' bz in let c := point_3 cx cy cz in
  let p := point_3 px py pz in let q := point_3 qx qy qz in
  let b' := difference_3 machine b a in let c' := difference_3 machine c a in
  let p' := difference_3 machine p a in let q' := difference_3 machine q a in
  let m' := bicell_magnitude machine b' c' p' q' in
  let t := bicell machine b' c' p' q' in
  let filter := bicell_filter machine a b c p q in
  all [same (insphere machine t) det; same (cell_p machine t) cp; same (cell_q machine t) cq; same m' m;
       same (bicell_error machine m') det_error; same (bicell_norms machine m') norm_error; same (side_error machine m') side_error';
       same_partition (abc_pq machine t) i1 o1 s1; same_partition (ab_cpq machine t) i2 o2 s2;
       same_partition (ca_bpq machine t) i3 o3 s3; same_partition (bc_apq machine t) i4 o4 s4;
       same_answer (filter true where_needed) certified; same_answer certified batch; same_answer (filter false where_needed) plain;
       same_answer (filter true always) always'; same_answer (filter true never) never'].

(* A prepared sphere, as in the plane. *)
Inductive prepared_3_row := Prepared_3 (ax ay az bx by' bz cx cy cz dx dy dz px py pz rx ry rz nx ny nz volume m out_p m_p out_r m_r : float)
  (pos excluded contained both : bool).

Definition agrees_prepared_3 (row : prepared_3_row) :=
  let (ax, ay, az, bx, by', bz, cx, cy, cz, dx, dy, dz, px, py, pz, rx, ry, rz, nx, ny, nz, volume, m, out_p, m_p, out_r, m_r,
       pos, excluded, contained, both) := row in
  let k := circumsphere_of machine (point_3 ax ay az) (point_3 bx by' bz) (point_3 cx cy cz) (point_3 dx dy dz) in
  let p := point_3 px py pz in let r := point_3 rx ry rz in
  let n := normal_3 machine k in
  all [same (x3 machine n) nx; same (y3 machine n) ny; same (z3 machine n) nz; same (six_volume machine k) volume;
       same (extent_3 machine k) m; same (outside_of_3 machine k p) out_p; same (raised_3 machine k (extent_3 machine k) p) m_p;
       same (outside_of_3 machine k r) out_r; same (raised_3 machine k (extent_3 machine k) r) m_r;
       eqb (sphere_positive machine k) pos; eqb (excludes_3 machine k p) excluded; eqb (contains_3 machine k p) contained;
       eqb (excludes_all_3 machine k [p; r]) both].
