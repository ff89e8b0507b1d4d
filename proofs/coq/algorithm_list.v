(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The expiry list of a vertex (docs/theory.md 5.2, (I3); src/annulus/engine/expiry_list.h) as the program has it: an array of
   `capacity` integers, each an expiry of 32 bits above an id of 32, in order, empty places at the end, and `rest`, a bound for all
   others.

   algorithm_listed.v says what is true of it.

   - run         a sequence of operations, with the numbers of the code, for traces

   Expiries are compared as their bits; truncated_double.v shows that this is the order of the numbers. *)
Require Import ZArith List Sorting.Sorted Bool Lia.
Import ListNotations.
Open Scope Z_scope.

Definition never : Z := 2047 * 2 ^ 20.   (* the upper half of infinity *)
Definition none : Z := 2 ^ 32 - 1.       (* no id *)
Definition entry (expiry id : Z) : Z := expiry * 2 ^ 32 + id.
Definition expiry_of (e : Z) : Z := Z.shiftr e 32.
Definition id_of (e : Z) : Z := Z.land e none.
Definition empty_entry : Z := entry never none.
Definition is_id (i : Z) : Prop := 0 <= i < none.

Record expiry_list := { entries : list Z; rest : Z }.

(* ---- The program ---- *)

Section program.
Variable capacity : nat.

Definition cleared : expiry_list := {| entries := repeat empty_entry capacity; rest := never |}.

Definition earliest (l : expiry_list) : Z := Z.min (rest l) (expiry_of (hd empty_entry (entries l))).

(* put_new: the entry goes through the array and is exchanged with whatever is above it. *)
Fixpoint exchange (moving : Z) (l : list Z) : list Z * Z :=
  match l with
  | [] => ([], moving)
  | e :: l => if moving <? e then let (m, out) := exchange e l in (moving :: m, out)
              else let (m, out) := exchange moving l in (e :: m, out)
  end.
Definition put_new (id expiry : Z) (l : expiry_list) : expiry_list :=
  let (m, out) := exchange (entry expiry id) (entries l) in {| entries := m; rest := Z.min (rest l) (expiry_of out) |}.

(* put: nothing when `id` is not listed and `rest` speaks for it; else, from where the entry of `id` is, each place takes what is in the
   next one. *)
Fixpoint close_gap (id : Z) (found : bool) (l : list Z) : list Z :=
  match l with
  | [] => []
  | e :: l' => let found := found || (id_of e =? id) in (if found then hd empty_entry l' else e) :: close_gap id found l'
  end.
Definition is_listed (id : Z) (l : expiry_list) : bool := existsb (fun e => id_of e =? id) (entries l).
Definition put (id expiry : Z) (l : expiry_list) : expiry_list :=
  if is_listed id l || (expiry <? rest l) then put_new id expiry {| entries := close_gap id false (entries l); rest := rest l |} else l.

(* put_new of many: expiries not below the bound are left to `rest`. *)
Definition put_below (bound : Z) (l : expiry_list) (x : Z * Z) : expiry_list :=
  if fst x <? bound then put_new (snd x) (fst x) l else {| entries := entries l; rest := Z.min (rest l) (fst x) |}.
(* The bound: no more than `capacity` are below low; more are below high, or it is never. *)
Fixpoint search (rounds : nat) (expiries : list Z) (low high step : Z) : Z :=
  match rounds with
  | O => low
  | S rounds =>
      if 1 <? high - low then
        let bound := low + Z.min step ((high - low) / 2) in
        let below := length (filter (fun e => e <? bound) expiries) in
        if Nat.ltb capacity below then search rounds expiries low bound (Z.min (4 * step) (2 ^ 28))
        else if Nat.ltb (Nat.div2 capacity) below then bound
        else search rounds expiries bound high (Z.min (4 * step) (2 ^ 28))
      else low
  end.
Definition bound_of (expiries : list Z) : Z :=
  if Nat.leb (length expiries) capacity then never
  else search 64 expiries (fold_left Z.min expiries never) never (2 ^ 12).
Definition put_many (new : list (Z * Z)) (l : expiry_list) : expiry_list :=
  fold_left (put_below (bound_of (map fst new))) new l.

(* take_reached, for a path length whose bits are `path_length`: the ids it visits, and what stays. *)
Definition is_reached (path_length e : Z) : bool := (e <? (path_length + 1) * 2 ^ 32) && (e <? empty_entry).
Definition take (path_length : Z) (l : expiry_list) : list Z * expiry_list :=
  let count := length (filter (is_reached path_length) (entries l)) in
  (map id_of (firstn count (entries l)), {| entries := skipn count (entries l) ++ repeat empty_entry count; rest := rest l |}).
End program.

(* ---- It can be run: ids and expiries (bits) in, bits out ---- *)

Inductive operation := Clear | Put (id expiry : Z) | Put_new (id expiry : Z) | Put_many (new : list (Z * Z)) | Take (path_length : Z).
Definition apply_operation (capacity : nat) (l : expiry_list) (o : operation) : expiry_list :=
  match o with
  | Clear => cleared capacity
  | Put id expiry => put id expiry l
  | Put_new id expiry => put_new id expiry l
  | Put_many new => put_many capacity new l
  | Take path_length => snd (take path_length l)
  end.
(* rest, then the entries in use: (expiry, id). *)
Definition shown (l : expiry_list) : Z * list (Z * Z) :=
  (rest l, map (fun e => (expiry_of e, id_of e)) (filter (fun e => negb (e =? empty_entry)) (entries l))).
Definition run (capacity : nat) (os : list operation) : Z * list (Z * Z) := shown (fold_left (apply_operation capacity) os (cleared capacity)).
