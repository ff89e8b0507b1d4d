(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Reading the words of a trace (trace.h): numbers, lists, positions, and where something is not as it has to be. *)
From Coq Require Import PArray Uint63 Floats Reals ZArith Bool List.
Import ListNotations.
Open Scope Z_scope.

Inductive outcome (A : Type) := Good (a : A) (at_word : int) | Bad (at_word : int) (event : Z).
Arguments Good {A}. Arguments Bad {A}.
Definition reader A := array int -> int -> outcome A.
Definition ret {A} (a : A) : reader A := fun _ i => Good a i.
Definition bind {A B} (m : reader A) (f : A -> reader B) : reader B :=
  fun w i => match m w i with Good a j => f a w j | Bad j e => Bad j e end.
Notation "x <- m ; k" := (bind m (fun x => k)) (at level 60, m at level 59, right associativity).
Notation "' p <- m ; k" := (bind m (fun x => let p := x in k)) (at level 60, p pattern, m at level 59, right associativity).
Definition must {B} (e : Z) (b : bool) (k : reader B) : reader B := fun w i => if b then k w i else Bad i e.

Definition word : reader int := fun w i => Good w.[i]%uint63 (i + 1)%uint63.
Definition number : reader Z := n <- word; ret (to_Z n).
Fixpoint times {A} (n : nat) (m : reader A) : reader (list A) :=
  match n with O => ret [] | S n => a <- m; l <- times n m; ret (a :: l) end.
Definition many {A} (m : reader A) : reader (list A) :=
  fun w i => let n := w.[i]%uint63 in if (n <? 0x10000)%uint63 then times (Z.to_nat (to_Z n)) m w (i + 1)%uint63 else Bad i 0.
Definition pair {A B} (m : reader A) (k : reader B) : reader (A * B) := a <- m; b <- k; ret (a, b).

Definition float_of (w : int) : float :=
  let m := (w land 0xfffffffffffff)%uint63 in
  let e := (w >> 52)%uint63 in
  if (e =? 2047)%uint63 then (if (m =? 0)%uint63 then infinity else nan)
  else if (e =? 0)%uint63 then ldshiftexp (of_uint63 m) 1027%uint63                          (* 2^-1074: shift is 2101 *)
  else ldshiftexp (of_uint63 (m lor 0x10000000000000)%uint63) (e + 1026)%uint63.
Definition minus : int := 0x7fffffffffffffff%uint63.
Definition real_number : reader float := w <- word; if (w =? minus)%uint63 then v <- word; ret (- float_of v)%float else ret (float_of w).

Definition same (a b : float) : bool := PrimFloat.Leibniz.eqb a b.
Fixpoint all2 {A B} (f : A -> B -> bool) (a : list A) (b : list B) : bool :=
  match a, b with [], [] => true | x :: a, y :: b => f x y && all2 f a b | _, _ => false end.
