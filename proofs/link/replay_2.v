(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Rows that the compiled C++ prints (vectors.cpp), and what it means that the model has the same bits. *)
From Coq Require Import List Floats Bool NArith.
From Annulus Require Import operations filter_2.
Import ListNotations.

(* The same bits; NaNs are one. +0 and -0 differ. *)
Definition same := PrimFloat.Leibniz.eqb.

Definition same_answer (a b : answer float) :=
  match a, b with
  | refused, refused => true
  | negative s, negative t | zero s, zero t | positive s, positive t => same s t
  | _, _ => false
  end.

Definition all (l : list bool) := forallb (fun b => b) l.

(* Points; determinant, inner, outer, m, bounds of determinant and norms, sum of roots; answers with certified tolerances, without,
   and with them from a batch (batch.h). *)
Inductive orientation_2_row := Filter_orientation_2 (ax ay bx by' cx cy det inn out m det_error norm_error sum : float)
  (certified plain batch : answer float).
Inductive empty_sphere_2_row := Filter_empty_sphere_2 (ax ay bx by' px py qx qy det inn out m det_error norm_error sum : float)
  (certified plain batch : answer float).

Definition point (a b : float) : vector machine := {| x := a : number machine; y := b : number machine |}.
Definition same_terms (t : width_terms machine) (det inn out : float) :=
  all [same (determinant machine t) det; same (inner machine t) inn; same (outer machine t) out].

Definition agrees_orientation_2 (r : orientation_2_row) :=
  let (ax, ay, bx, by', cx, cy, det, inn, out, m, det_error, norm_error, sum, certified, plain, batch) := r in
  let a := point ax ay in let b := point bx by' in let c := point cx cy in
  let u := difference machine b a in let v := difference machine c a in let w := difference machine c b in
  let m' := orientation_magnitude machine u v in
  let t := orientation_terms machine u v w in
  all [same_terms t det inn out; same (orientation_roots machine t) sum; same m' m;
       same (orientation_error machine m') det_error; same 0%float norm_error;
       same_answer (orientation_filter machine a b c true) certified; same_answer certified batch;
       same_answer (orientation_filter machine a b c false) plain].

Definition agrees_empty_sphere_2 (r : empty_sphere_2_row) :=
  let (ax, ay, bx, by', px, py, qx, qy, det, inn, out, m, det_error, norm_error, sum, certified, plain, batch) := r in
  let a := point ax ay in let b := point bx by' in let p := point px py in let q := point qx qy in
  let b' := difference machine b a in let p' := difference machine p a in
  let q' := difference machine q a in let e := difference machine q p in
  let m' := annulus_magnitude machine b' p' q' e in
  let t := annulus_terms machine b' p' q' e in
  all [same_terms t det inn out; same (annulus_roots machine t) sum; same m' m;
       same (annulus_det_error machine m') det_error; same (annulus_norm_error machine m') norm_error;
       same_answer (empty_sphere_filter machine a b p q true) certified; same_answer certified batch;
       same_answer (empty_sphere_filter machine a b p q false) plain].

(* A prepared circle: its corners, the points p and r; normal, area, m; of each point the determinant and what m is raised to; positive, whether
   p is excluded, contained, and both excluded. *)
Inductive prepared_2_row := Prepared_2 (ax ay bx by' cx cy px py rx ry nx ny area m out_p m_p out_r m_r : float) (pos excluded contained both : bool).

Definition agrees_prepared_2 (row : prepared_2_row) :=
  let (ax, ay, bx, by', cx, cy, px, py, rx, ry, nx, ny, area, m, out_p, m_p, out_r, m_r, pos, excluded, contained, both) := row in
  let k := circumcircle_of machine (point ax ay) (point bx by') (point cx cy) in
  let p := point px py in let r := point rx ry in
  all [same (x machine (normal machine k)) nx; same (y machine (normal machine k)) ny; same (twice_area machine k) area;
       same (extent machine k) m; same (outside_of machine k p) out_p; same (raised machine k (extent machine k) p) m_p;
       same (outside_of machine k r) out_r; same (raised machine k (extent machine k) r) m_r;
       eqb (circle_positive machine k) pos; eqb (excludes machine k p) excluded; eqb (contains machine k p) contained;
       eqb (excludes_all machine k [p; r]) both].

(* Numbers of the rows that differ: what a theorem says is empty. *)
Fixpoint differing {A} (agrees : A -> bool) (i : N) (rows : list A) : list N :=
  match rows with
  | [] => []
  | r :: rows => if agrees r then differing agrees (N.succ i) rows else i :: differing agrees (N.succ i) rows
  end.

Lemma none_differs : forall {A} (agrees : A -> bool) (P : A -> Prop), (forall r, agrees r = true -> P r) ->
  forall rows i, differing agrees i rows = [] -> Forall P rows.
Proof.
  intros A agrees P H rows. induction rows as [|r rows IH]; intros i E; [constructor|].
  simpl in E. destruct (agrees r) eqn:R; [|discriminate]. constructor; [now apply H|]. exact (IH _ E).
Qed.
