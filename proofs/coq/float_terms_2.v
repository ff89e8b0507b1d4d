(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The formulas of src/annulus/predicate/width_terms.h over any number type, as they are written there, line by line.
   Used with real numbers (what is meant), with rounded ones (what is computed) and with expressions (what is
   analysed). *)
Require Import Reals ZArith List.
From Annulus Require Import float_model float_error.
Import ListNotations.

Section terms.
Variable T : Type.
Variables add sub mul : T -> T -> T.
Declare Scope number_scope.
Infix "+" := add : number_scope.
Infix "-" := sub : number_scope.
Infix "*" := mul : number_scope.
Open Scope number_scope.

Definition squared x := x * x.

(* orientation_terms: the determinant, and the square of one side. *)
Definition orientation_det ux uy vx vy := ux * vy - uy * vx.
Definition side_square kx ky := squared kx + squared ky.

Record annulus := Annulus { incircle : T; nx : T; ny : T; mx : T; my : T; inner : T; outer : T }.

Definition annulus_terms bx by' px py qx qy ex ey :=
  let ob := bx * qy - by' * qx in
  let oa := by' * px - bx * py in
  let D := ob + oa in
  let gx := (qx + px) - bx in
  let gy := (qy + py) - by' in
  let s := ex * gx + ey * gy in
  let nx := D * bx - s * by' in
  let ny := D * by' + s * bx in
  let twice_D := D + D in
  let mx := nx - twice_D * px in
  let my := ny - twice_D * py in
  let kp := px * (px - bx) + py * (py - by') in
  let kq := qx * (qx - bx) + qy * (qy - by') in
  let incircle := kp * ob + kq * oa in
  let inner := squared nx + squared ny in
  let outer := squared mx + squared my in
  Annulus incircle nx ny mx my inner outer.
End terms.
Arguments incircle {T}. Arguments nx {T}. Arguments ny {T}. Arguments mx {T}. Arguments my {T}.
Arguments inner {T}. Arguments outer {T}.

Definition R_annulus := annulus_terms R Rplus Rminus Rmult.
Definition F_annulus := annulus_terms R fadd fsub fmul.
Definition R_orientation := orientation_det R Rminus Rmult.
Definition F_orientation := orientation_det R fsub fmul.
Definition R_side := side_square R Rplus Rmult.
Definition F_side := side_square R fadd fmul.

Definition E_orientation := orientation_det expr Minus Times (Var 0) (Var 1) (Var 2) (Var 3).
Definition E_annulus :=
  annulus_terms expr Plus Minus Times (Var 0) (Var 1) (Var 2) (Var 3) (Var 4) (Var 5) (Var 6) (Var 7).
