(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Number types over which the certificates are written once, as in C++ they are templates: doubles of the machine (Coq's
   primitive floats), reals rounded after every operation, and expressions. *)
From Coq Require Import Reals ZArith List.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.  (* last: Flocq's Core has a type of the name float too *)
Close Scope float_scope.
Open Scope R_scope.

Record operations := {
  number : Type;
  add : number -> number -> number;
  sub : number -> number -> number;
  mul : number -> number -> number;
  div : number -> number -> number;
  root : number -> number;
  opposite : number -> number;
  magnitude : number -> number;             (* fabs *)
  square : number -> number;                (* squared *)
  greater : number -> number -> number;     (* std::max *)
  less : number -> number -> bool;
  less_equal : number -> number -> bool;
  constant : float -> number
}.

(* std::max(a, b) is b if a < b, else a: which zero and what about NaN is decided by the order. *)
Definition machine : operations := {|
  number := float;
  add a b := (a + b)%float; sub a b := (a - b)%float; mul a b := (a * b)%float; div a b := (a / b)%float;
  root := PrimFloat.sqrt; opposite := PrimFloat.opp; magnitude := PrimFloat.abs;
  square a := (a * a)%float;
  greater a b := if PrimFloat.ltb a b then b else a;
  less := PrimFloat.ltb; less_equal := PrimFloat.leb;
  constant c := c |}.

(* The real number a float stands for; 0 for infinities and NaN. *)
Definition value (x : float) : R := B2R (Prim2B x).

(* Gradual underflow, no overflow, to nearest, ties to even: the model of proofs/coq/float_*.v. *)
Notation rnd := (round radix2 (FLT_exp (-1074) 53) ZnearestE).

Definition rounded : operations := {|
  number := R;
  add x y := rnd (x + y); sub x y := rnd (x - y); mul x y := rnd (x * y); div x y := rnd (x / y);
  root x := rnd (R_sqrt.sqrt x); opposite := Ropp; magnitude := Rabs;
  square x := rnd (x * x);
  greater a b := if Rlt_bool a b then b else a;
  less := Rlt_bool; less_equal := Rle_bool;
  constant := value |}.

(* Without rounding. *)
Definition reals : operations := {|
  number := R; add := Rplus; sub := Rminus; mul := Rmult; div := Rdiv; root := R_sqrt.sqrt; square x := x * x;
  opposite := Ropp; magnitude := Rabs; greater := Rmax; less := Rlt_bool; less_equal := Rle_bool; constant := value |}.

(* What a recording number type of C++ writes down (recording.h). *)
Inductive expression :=
  | Input (i : nat)
  | Add (a b : expression)
  | Sub (a b : expression)
  | Mul (a b : expression)
  | Max (a b : expression)
  | Neg (a : expression)
  | Unrecorded.

Definition recorded : operations := {|
  number := expression;
  add := Add; sub := Sub; mul := Mul; square a := Mul a a; greater := Max;
  div _ _ := Unrecorded; root _ := Unrecorded; opposite := Neg; magnitude _ := Unrecorded;
  less _ _ := false; less_equal _ _ := false; constant _ := Unrecorded |}.
