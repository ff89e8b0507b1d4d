(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Running error analysis of polynomial expressions in binary64, proved once and then computed.

   An expression is a tree of additions, subtractions and multiplications over computed differences of coordinates.
   `bound` computes, in integers, how large its exact and its rounded value can be and how far apart they are, and
   `bound_sound` says that it is right: for every magnitude m >= 2^-120 of the differences, as multiples of m^k where k is
   the degree. Only the relative error of an operation is used, and of products that they may underflow; so nothing here
   depends on where m lies between two powers of two (docs/theory.md 4.1).

   All bounds are integers in units of 2^-100 m^k. That is so small that one unit pays for the underflow of a product of
   degree up to 8: 2^-1075 <= 2^-100 (2^-120)^8. *)
Require Import Reals Lra Psatz ZArith List.
From Flocq Require Import Core.
From Annulus Require Import float_model.
Import ListNotations.
Open Scope R_scope.

Inductive expr :=
  | Var (n : nat)
  | Plus (a b : expr)
  | Minus (a b : expr)
  | Times (a b : expr)
  | Opp (a : expr).

Definition expr_dec (a b : expr) : {a = b} + {a <> b}.
Proof. decide equality. decide equality. Defined.

Fixpoint exact (X : nat -> R) (e : expr) : R :=
  match e with
  | Var n => X n
  | Plus a b => exact X a + exact X b
  | Minus a b => exact X a - exact X b
  | Times a b => exact X a * exact X b
  | Opp a => - exact X a
  end.

Definition fadd x y := rnd (x + y).
Definition fsub x y := rnd (x - y).
Definition fmul x y := rnd (x * y).

Fixpoint rounded (x : nat -> R) (e : expr) : R :=
  match e with
  | Var n => x n
  | Plus a b => fadd (rounded x a) (rounded x b)
  | Minus a b => fsub (rounded x a) (rounded x b)
  | Times a b => fmul (rounded x a) (rounded x b)
  | Opp a => - rounded x a
  end.

(* deg: the degree k. In units of 2^-100 m^k: ex bounds the exact value, co the computed one, er their difference. *)
Record bnd := Bnd { deg : nat; ex : Z; co : Z; er : Z }.

Definition one : Z := 2 ^ 100.
Definition unit_roundoff : Z := 2 ^ 47.

(* a / 2^k rounded up. *)
Definition up (a k : Z) : Z := (- Z.shiftr (- a) k)%Z.
Definition prod (a b : Z) : Z := up (a * b) 100.
(* An exact difference, and two products of such. *)
Definition exact_one : Z := one + unit_roundoff.
Definition two_products : Z := 2 * prod exact_one exact_one.

(* A hint gives an expression a smaller bound for its exact value, proved by other means (a cancellation, say). *)
Definition hints := list (expr * Z).
Fixpoint tighten (h : hints) (e : expr) (z : Z) : Z :=
  match h with
  | [] => z
  | (e', z') :: h' => if expr_dec e e' then Z.min z' (tighten h' e z) else tighten h' e z
  end.

(* X: exact value, S: what is rounded, E: its error before rounding, t: units lost to underflow. *)
Definition round_off (k : nat) (X S E t : Z) : bnd :=
  let S' := Z.min S (X + E) in
  let r := (up S' 53 + t)%Z in
  Bnd k X (Z.min (S' + r) (X + (E + r))) (E + r).

Definition sum (h : hints) (e : expr) (a b : bnd) : option bnd :=
  if Nat.eqb (deg a) (deg b)
  then Some (round_off (deg a) (tighten h e (ex a + ex b)) (co a + co b) (er a + er b) 0)
  else None.

Fixpoint bound (h : hints) (e : expr) : option bnd :=
  match e with
  | Var _ => Some (Bnd 1 (tighten h e (one + unit_roundoff)) one unit_roundoff)
  | Plus a b =>
    match bound h a with
    | None => None
    | Some x =>
      if expr_dec a b  (* x + x is exact *)
      then Some (Bnd (deg x) (tighten h e (2 * ex x)) (2 * co x) (2 * er x))
      else match bound h b with Some y => sum h e x y | None => None end
    end
  | Minus a b =>
    match bound h a, bound h b with Some x, Some y => sum h e x y | _, _ => None end
  | Times a b =>
    match bound h a, bound h b with
    | Some x, Some y =>
      if Nat.leb (deg x + deg y) 8
      then Some (round_off (deg x + deg y) (tighten h e (prod (ex x) (ex y))) (prod (co x) (co y))
                           (Z.min (prod (co x) (er y) + prod (er x) (ex y)) (prod (ex x) (er y) + prod (er x) (co y))) 1)
      else None
    | _, _ => None
    end
  | Opp a => bound h a
  end.

(* The worst of a list of expressions of one degree: what all of them are bounded by. *)
Definition error_below (h : hints) (e : expr) (k : nat) (X C E : Z) : bool :=
  match bound h e with
  | Some b => (Nat.eqb (deg b) k && Z.leb (ex b) X && Z.leb (co b) C && Z.leb (er b) E)%bool
  | None => false
  end.

(* The least integer that the error is proved to be below, times the unit roundoff. *)
Definition least_error (h : hints) (e : expr) : option Z := option_map (fun b => up (er b) 47) (bound h e).
