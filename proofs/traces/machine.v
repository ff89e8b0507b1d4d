(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The program of algorithm_filter.v with the numbers of the machine: Coq's primitive floats, so that it can be run. Nothing of the program is written
   again here, only the arithmetic that a `world` requires, as displacement.h, truncated_double.h and displacement budgets*.cpp have it, in any
   dimension; machine_rounds.v ties it to that of filter_plane.v. Positions are lists of coordinates, vertices are numbers and a
   certificate is its points.

   What a star walk goes round, cells and facets in the order of the mesh, is not the filter's to decide: the replay enters it in the mesh, under
   -1 and below (`around`), where no certificate has its number. *)
From Coq Require Import Uint63 Reals ZArith List Bool Floats.
From Annulus Require Import algorithm_list truncated_double algorithm_filter.
Import ListNotations.
Open Scope Z_scope.

(* What limits.h sets. *)
Record limits := { listed : nat; last_stamp : Z; half_mask : Z; path_ratio : float }.

Definition point := list float.
Open Scope float_scope.

(* ---- displacement.h ---- *)

Definition terms (f : float -> float) (a b : point) : float := fold_left (fun sum c => sum + f (fst c - snd c)) (combine a b) 0.
Definition squared_distance : point -> point -> float := terms (fun c => c * c).
Definition grow : float := 0x1.0000000000008p0.           (* 1 + 2^-49 *)
Definition distance_upper (a b : point) : float :=
  let squares := squared_distance a b in
  if 0x1p-900 <? squares then sqrt squares * grow else terms abs a b * grow.
Definition squared_threshold_lower (radius : float) : float :=
  if negb (0x1p-450 <? radius) then 0 else if 0x1p510 <? radius then 0x1p1020 else radius * radius * 0x1.ffffffffffff0p-1.
Definition ulp52 : float := 0x1p-52.
Definition sum_lower (a b : float) : float := let s := a + b in s - s * ulp52.
Definition sum_upper (a b : float) : float := let s := a + b in s + s * ulp52.

(* ---- truncated_double.h ---- *)

(* The upper half of the bits of a positive number, be it subnormal or not: its mantissa and exponent, by operations of the machine. Those of
   Prim2SF say the same and take Coq eight times as long (half_of_bits, machine_bits.v). *)
Definition half_of (mask : Z) (x : float) : Z :=
  if 0 <? x then
    if x <? infinity then
      let (f, e) := frshiftexp x in
      let m := normfr_mantissa f in
      Z.land (Uint63.to_Z (if (1080 <=? e)%uint63 then ((e - 1080) << 20 + (m >> 32))%uint63 else (m >> (1112 - e))%uint63)) mask
    else never
  else 0%Z.
(* Mantissa and exponent of truncated_double.v, by bits: a division of that size takes Coq twenty times as long (value_of_bits, machine_bits.v). *)
Definition value_of (b : Z) : float :=
  if (b <? never)%Z then
    let upper := Z.shiftr b 20 in
    let lower := Z.land b 0xfffff in
    ldshiftexp (of_uint63 (Uint63.of_Z (if (upper =? 0)%Z then lower else 0x100000 + lower))) (Uint63.of_Z (Z.max 1 upper - 1 + -1042 + shift))
  else infinity.

(* ---- displacement_budget.h, displacement_budget_commit.cpp ---- *)

Definition path_length_at (b : float) (f p : point) : float := sum_upper b (distance_upper p f).
Definition slack (e : Z) (b : float) : float := (value_of e - b) * 0x1.ffffffffffff8p-1.    (* 1 - 2^-50 *)
Definition left_of (e : Z) (b : float) : float := let s := value_of e - b in s - s * ulp52.
Definition same_coordinates (p q : point) : bool := forallb (fun c => fst c =? snd c) (combine p q).

(* Expiry_list::latest *)
Definition latest (l : expiry_list) : Z :=
  fold_left (fun found e => if (e =? empty_entry)%Z then found else expiry_of e) (entries l) (rest l).

Close Scope float_scope.

Section machine.
Variable h : limits.

Definition machine : world := {|
  position := point; vertex := Z; certificate := list Z; same_vertex := Z.eq_dec; same_position := same_coordinates;
  dist := fun _ _ => 0%R; points := fun c => c; holds := fun _ _ => True; counts_on := fun _ _ => False;
  capacity := listed h; stamps := last_stamp h;
  around := fun mesh v => match mesh (-1 - v) with Some ids => ids | None => [] end;
  num := float; real := fun _ => 0%R; zero := 0%float; valid := fun _ => True; number := fun _ => True;
  path_length_of := path_length_at; below := fun f p r => (squared_distance p f <? r)%float;
  threshold := fun e b => value_of (half_of (half_mask h) (squared_threshold_lower (slack e b)));
  algorithm_filter.sum_lower := sum_lower; less := left_of; half := half_of (half_mask h);
  worn := fun b l => (path_ratio h * (value_of (latest l) - b) <? b)%float |}.
End machine.
