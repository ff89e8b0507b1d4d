(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the engine reported of a history (trace.h), replayed: the program of algorithm_filter.v, run on the numbers of the machine (machine.v), has to
   decide the same, bit for bit. What is given is where vertices go, which certificates Repair evaluated or took away,
   and what a star walk goes round. What is computed and compared:

   - test       which vertices pass the test of a step, and which fail                  find_failed, passes
   - stamp      the stamp of the step, and that all are cleared where they wrap                 begin_anchoring
   - anchor     the bases of those that failed                                                  anchor
   - examine    of each of these: what is taken from its list, whether there is a star walk, pending certificates, the list that is left     examine
   - undo       what a call that fails takes back                                               undo_anchoring
   - write      the tolerance of a certificate that was evaluated                               same_tolerance (verdicts.v)
                and expiries and bases of its points                                           commit_evaluated, write_fresh
   - finish     whether a vertex is rebased, its base, threshold and list                       finish
   - recompute, place  thresholds and lists after a recomputation; a new vertex                         set_room, place
   - over       every pending certificate was evaluated or is gone; no certificate is without a record
   - requested  vertices are where they were tested

   A step that was begun has come to an end, and every vertex that failed was examined, before the next is tested or begun (`progress`); a call that
   failed has left no vertex anchored. While no tolerances are kept, nothing is tested.

   The state is the replay's own: nothing of it is read from the trace. *)
From Coq Require Import PArray Uint63 Floats Reals ZArith Bool FMapPositive List.
From Annulus Require Import algorithm_list truncated_double algorithm_filter.
From Annulus_traces Require Import machine words verdicts.
Import ListNotations.
Open Scope Z_scope.

(* ---- The state ---- *)

Section history.
Variables (dimension : nat) (h : limits).
#[local] Instance W : world := machine h.

Definition place_of : reader machine.point := times dimension real_number.

Record known := { of_points : list Z; expiries : list (Z * Z) }.
(* Where a step is. open: vertices failed, or cells changed, and what became of it is not reported; unexamined: anchored, to be looked at; keeps_tolerances: there are tolerances. *)
Record progress := { open : bool; unexamined : list Z; tracks : bool }.
Definition at_rest : progress := {| open := false; unexamined := []; tracks := true |}.
Record system := {
  vertices : PositiveMap.t budget;
  certificates : PositiveMap.t known;
  targets : PositiveMap.t machine.point;
  lives : list Z;
  stamped : Z;
  recomputing : bool;
  failed : list Z;                       (* of the last test *)
  before : PositiveMap.t budget;       (* when the step began *)
  waiting : list Z;                      (* anchored in this step and not finished *)
  pending : list Z;
  course : progress;
  decisions : Z }.
Definition nothing : system := {| vertices := PositiveMap.empty _; certificates := PositiveMap.empty _; targets := PositiveMap.empty _; lives := [];
  stamped := 0; recomputing := false; failed := []; before := PositiveMap.empty _; waiting := []; pending := []; course := at_rest; decisions := 0 |}.

Definition key (i : Z) : positive := Z.to_pos (i + 1).
Definition find {A} (i : Z) (m : PositiveMap.t A) : option A := PositiveMap.find (key i) m.
Definition add {A} (i : Z) (a : A) (m : PositiveMap.t A) : PositiveMap.t A := PositiveMap.add (key i) a m.

Definition x_of (y : system) (v : Z) : machine.point := match find v (targets y) with Some p => p | None => [] end.
Definition new_budget (p : machine.point) : budget := {| fixed := p; base := zero; room := zero; listing := cleared capacity; stamp := 0 |}.
Definition budget_in (m : PositiveMap.t budget) (y : system) (v : Z) : budget := match find v m with Some o => o | None => new_budget (x_of y v) end.
Definition lookup (l : list (Z * Z)) (v : Z) : Z := match List.find (fun p => fst p =? v) l with Some p => snd p | None => never end.
Definition written_of (k : known) : written :=
  {| expiry := lookup (expiries k); reference := fun _ => []; origin := fun _ => 0%R; allowance := 0%R |}.
Definition unknown : known := {| of_points := []; expiries := [] |}.

(* As the model has it; `round` is what a star walk of v goes round. *)
Definition state_of (y : system) (v : Z) (round : list Z) : state := {|
  moving := x_of y;
  at_ := budget_in (vertices y) y;
  mesh := fun i => if i <? 0 then (if i =? -1 - v then Some round else None)
                   else match find i (certificates y) with Some k => Some (of_points k) | None => None end;
  record := fun i => written_of (match find i (certificates y) with Some k => k | None => unknown end);
  epoch := stamped y; anchored := [] |}.
Definition now (y : system) : state := state_of y 0 [].

(* What an operation did to these vertices. *)
Definition keep (t : state) (vs : list Z) (m : PositiveMap.t budget) : PositiveMap.t budget := fold_left (fun m v => add v (at_ t v) m) vs m.
Definition with_vertices (y : system) m w n : system := {| vertices := m; certificates := certificates y; targets := targets y; lives := lives y;
  stamped := stamped y; recomputing := recomputing y; failed := failed y; before := before y; waiting := w; pending := pending y; course := course y;
  decisions := decisions y + n |}.
Definition with_certificates (y : system) c : system := {| vertices := vertices y; certificates := c; targets := targets y; lives := lives y;
  stamped := stamped y; recomputing := recomputing y; failed := failed y; before := before y; waiting := waiting y; pending := pending y; course := course y;
  decisions := decisions y |}.
Definition with_open (y : system) s : system := {| vertices := vertices y; certificates := certificates y; targets := targets y; lives := lives y;
  stamped := stamped y; recomputing := recomputing y; failed := failed y; before := before y; waiting := waiting y; pending := s; course := course y;
  decisions := decisions y |}.
Definition with_course (y : system) c : system := {| vertices := vertices y; certificates := certificates y; targets := targets y; lives := lives y;
  stamped := stamped y; recomputing := recomputing y; failed := failed y; before := before y; waiting := waiting y; pending := pending y; course := c;
  decisions := decisions y |}.
Definition to_examine (y : system) (l : list Z) : system := with_course y {| open := open (course y); unexamined := l; tracks := tracks (course y) |}.
Definition is_nil (l : list Z) : bool := match l with [] => true | _ => false end.
Definition with_targets (y : system) g l : system := {| vertices := vertices y; certificates := certificates y; targets := g; lives := l;
  stamped := stamped y; recomputing := recomputing y; failed := failed y; before := before y; waiting := waiting y; pending := pending y; course := course y;
  decisions := decisions y |}.
Definition with_step (y : system) e f b n : system := {| vertices := vertices y; certificates := certificates y; targets := targets y; lives := lives y;
  stamped := e; recomputing := recomputing y; failed := f; before := b; waiting := waiting y; pending := pending y; course := course y;
  decisions := decisions y + n |}.
Definition beginning (y : system) (b : bool) : system := {| vertices := if b then PositiveMap.empty _ else vertices y;
  certificates := if b then PositiveMap.empty _ else certificates y; targets := if b then PositiveMap.empty _ else targets y; lives := if b then [] else lives y;
  stamped := stamped y; recomputing := b; failed := []; before := PositiveMap.empty _; waiting := []; pending := []; course := at_rest;
  decisions := decisions y |}.

Definition same_expiries (l : expiry_list) (r : Z) (es : list Z) : bool :=
  (rest l =? r) && all2 Z.eqb (filter (fun e => negb (e =? empty_entry)) (entries l)) es.
Definition expiries_read : reader (Z * list Z) := pair number (many number).
Definition size {A} (l : list A) : Z := Z.of_nat (length l).
Fixpoint insert (v : Z) (l : list Z) : list Z :=
  match l with [] => [v] | w :: l' => if v <? w then v :: l else if v =? w then l else w :: insert v l' end.
Definition without (l gone : list Z) : list Z := filter (fun i => negb (existsb (Z.eqb i) gone)) l.

(* ---- Events ---- *)

Definition places (y : system) : reader system :=
  l <- many (pair number place_of);
  ret (with_targets y (fold_left (fun g p => add (fst p) (snd p) g) l (targets y)) (fold_left (fun l p => insert (fst p) l) l (lives y))).
Definition gone (y : system) : reader system := l <- many number; ret (with_targets y (targets y) (without (lives y) l)).

Definition recompute_ (y : system) : reader system :=
  l <- many (pair number (pair number expiries_read));
  let judged v t r es := let o := set_room (at_ (now y) v) in same (room o) (value_of t) && same_expiries (listing o) r es in
  must 5 (all2 Z.eqb (map fst l) (lives y) && forallb (fun '(v, (t, (r, es))) => judged v t r es) l)
  (let m := fold_left (fun m '(v, _) => add v (set_room (at_ (now y) v)) m) l (vertices y) in
   ret (beginning (with_vertices y m [] (2 * size l)) false)).

Definition test (y : system) : reader system :=
  mover <- number; reported <- many number;
  let movers := if mover =? 0 then lives y else [mover - 1] in
  must 6 (tracks (course y) && negb (open (course y)) && all2 Z.eqb (find_failed (now y) (x_of y) movers) reported)
  (ret (with_course (with_step y (stamped y) reported (before y) (size movers)) {| open := negb (is_nil reported); unexamined := []; tracks := true |})).

Definition stamp_ (y : system) : reader system :=
  e <- number;
  let t := begin_anchoring (now y) in
  let m := if stamped y =? stamps then PositiveMap.mapi (fun k _ => at_ t (Zpos k - 1)) (vertices y) else vertices y in
  must 7 ((epoch t =? e) && is_nil (waiting y) && is_nil (pending y) && is_nil (unexamined (course y)))
  (ret (with_course (with_open (with_step (with_vertices y m [] 1) e (failed y) m 0) []) {| open := true; unexamined := []; tracks := true |})).

Definition anchor_one (y : option system) (reported : Z * float) : option system :=
  match y with
  | None => None
  | Some y =>
      let '(v, b) := reported in
      let t := anchor (x_of y) (now y) v in
      if same (base (at_ t v)) b then Some (with_vertices y (keep t [v] (vertices y)) (waiting y ++ anchored t) 1) else None
  end.
Definition anchor_ (y : system) : reader system :=
  l <- many (pair number real_number);
  must 8 (all2 Z.eqb (map fst l) (failed y))
  (match fold_left anchor_one l (Some y) with Some z => ret (to_examine z (map fst l)) | None => must 8 false (ret y) end).

Definition examine_ (y : system) : reader system :=
  v <- number; walked <- number; round <- many number; named <- many number; '(r, es) <- expiries_read;
  let s := state_of y v round in
  let l0 := listing (at_ s v) in
  let path_length := half (base (at_ s v)) in
  let visited := if rest l0 <=? path_length then [] else fst (take path_length l0) in
  let (l, named') := examine s v in
  must 9 (match unexamined (course y) with w :: _ => w =? v | [] => false end && same_expiries l r es && all2 Z.eqb (rev named') named)
  (let m := add v (set_listing (at_ s v) l) (vertices y) in
   ret (with_open (with_vertices (to_examine y (tl (unexamined (course y)))) m (waiting y) (1 + size visited + size round)) (pending y ++ named))).

Definition undo_ (y : system) : reader system :=
  let t := undo_anchoring {| moving := x_of y; at_ := budget_in (before y) y; mesh := mesh (now y); record := record (now y); epoch := stamped y; anchored := [] |}
    (now y) (failed y) in
  ret (with_course (with_open (with_vertices y (keep t (failed y) (vertices y)) [] 1) []) at_rest).

Definition mend_ (y : system) : reader system :=
  l <- many number;
  must 11 (is_nil (unexamined (course y))) (ret (with_open (with_certificates y (fold_left (fun m i => PositiveMap.remove (key i) m) l (certificates y))) (without (pending y) l))).

(* The record of certificate i as an operation left it. *)
Definition kept_record (t : state) (i : Z) (points : list Z) : known := {| of_points := points; expiries := map (fun v => (v, expiry (record t i) v)) points |}.
Definition after (y : system) (t : state) (i : Z) (k : known) : system :=
  with_certificates (with_vertices y (keep t (of_points k) (vertices y)) (waiting y ++ rev (anchored t)) (size (of_points k))) (add i k (certificates y)).

Definition write (y : system) : reader system :=
  i <- number; tol <- real_number; l <- many (pair number (pair real_number number));
  let points := map fst l in
  let k := {| id := i; of := points : certificate; bound := tol |} in
  let y := with_certificates y (add i {| of_points := points; expiries := [] |} (certificates y)) in
  let t := if recomputing y then write_fresh (x_of y) (now y) k else commit_evaluated (x_of y) (now y) k in
  let kept := kept_record t i points in
  must 12 (same_tolerance (decisions y mod 97 =? 0) (map (x_of y) points) tol && all2 (fun '(v, (b, e)) '(_, e') => same (base (at_ t v)) b && (e' =? e)) l (expiries kept))
  (let z := after y t i kept in ret (with_open z (without (pending z) [i]))).

Definition finish_ (y : system) : reader system :=
  v <- number; rebased <- number; round <- many number; b <- real_number; t <- number; '(r, es) <- expiries_read;
  let s := state_of y v round in let o := at_ s v in
  let u := finish s v in let o' := at_ u v in
  must 13 (match waiting y with w :: _ => w =? v | [] => false end &&
           Bool.eqb (worn (base o) (listing o)) (rebased =? 1) && same (base o') b && same (room o') (value_of t) && same_expiries (listing o') r es)
  (let its := filter (fun i => has s i v) round in
   let c := fold_left (fun m i => add i (kept_record u i (match mesh s i with Some ps => ps | None => [] end)) m) its (certificates y) in
   ret (with_certificates (with_vertices y (add v o' (vertices y)) (tl (waiting y)) (3 + size its)) c)).

Definition over (y : system) : reader system :=
  n <- number;
  must 14 (match waiting y, pending y with [], [] => true | _, _ => false end && (Z.of_nat (PositiveMap.cardinal (certificates y)) =? n))
  (ret (with_course (with_open y []) at_rest)).

(* No tolerances any longer, so none is tested until all is evaluated anew; a call that ended in an error, which left no vertex anchored. *)
Definition untracked_ (y : system) : reader system :=
  ret (with_course (with_open (with_vertices y (vertices y) [] 0) []) {| open := false; unexamined := []; tracks := false |}).
Definition failed_ (y : system) : reader system :=
  let c := course y in
  must 17 (is_nil (waiting y) && is_nil (unexamined c)) (ret (with_course y {| open := false; unexamined := []; tracks := tracks c |})).
(* A call that succeeded: vertices are where they were to go, and that is where they were tested. *)
Definition asked_ (y : system) : reader system :=
  l <- many (pair number place_of);
  must 18 (negb (tracks (course y)) || forallb (fun '(v, p) => all2 same (x_of y v) p) l) (ret y).

Definition place_ (y : system) : reader system :=
  v <- number; p <- place_of;
  let t := place (now y) (v, p) in
  ret (with_vertices (with_targets y (add v p (targets y)) (lives y)) (keep t [v] (vertices y)) (waiting y) 1).

Definition event (e : Z) (y : system) : reader system :=
  match e with
  | 2 => places y | 3 => gone y | 4 => ret (beginning y true) | 5 => recompute_ y | 6 => test y | 7 => stamp_ y | 8 => anchor_ y
  | 9 => examine_ y | 10 => undo_ y | 11 => mend_ y | 12 => write y | 13 => finish_ y | 14 => over y | 15 => place_ y
  | 16 => untracked_ y | 17 => failed_ y | 18 => asked_ y
  | _ => must e false (ret y)
  end.
Fixpoint events (fuel : nat) (y : system) : reader system :=
  match fuel with O => ret y | S fuel => e <- number; if e =? 0 then ret y else z <- event e y; events fuel z end.
End history.

(* A history: dimension, limits, events to the end. Decisions. *)
Definition history (fuel : nat) : reader Z :=
  d <- number; l <- number; s <- number; m <- number; o <- real_number; e <- number; d' <- number;
  must 1 ((e =? 1) && (d =? d'))
  (let h := {| listed := Z.to_nat l; last_stamp := s; half_mask := m; path_ratio := o |} in
   y <- events (Z.to_nat d) h fuel (nothing h); ret (decisions h y)).

Fixpoint histories (fuel : nat) (n : Z) (w : array int) (i : int) : outcome Z :=
  match fuel with
  | O => Bad i (-1)
  | S fuel' => if (i =? PArray.length w)%uint63 then Good n i
               else match history fuel w i with Good m j => histories fuel' (n + m) w j | Bad j e => Bad j e end
  end.
(* How many decisions were recomputed, or the first that is another one. *)
Definition replay (w : array int) : outcome Z := histories (Z.to_nat (to_Z (PArray.length w))) 0 w 0%uint63.
(* What a theorem says of a trace: all of it is as the model decides, and so many decisions are in it at least. *)
Definition decides (least : Z) (w : array int) : bool := match replay w with Good n _ => least <=? n | Bad _ _ => false end.
