(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The strategy `tolerances`, here `filter` (docs/theory.md 5.1 and 5.2; src/annulus/engine/tolerance_strategy*.cpp, displacement_budget*.cpp), as a
   program: displacement budgets (displacement budgets), expiries, lists, what is looked at, what is written, rebase, undoing. Definitions only:
   algorithm_step.v proves what they keep, algorithm_run.v what follows for any sequence of calls.

   Functions do what those of the code do, one after another. Expiries are the 32 bits of the code (truncated_double.v), lists those of
   algorithm_list.v. What the program is given is in the classes below: positions of any metric space, arithmetic that errs on the side that is named
   (`laws`; filter_doubles.v shows that of the code), certificates and what a tolerance promises (`evaluated`), and Repair, which
   may do anything to the mesh that `repaired` allows. Of a record `reference`, `origin` and `allowance` are not in the code: they say what
   its expiries mean, and nothing is computed from them. *)
Require Import Reals ZArith List Bool.
From Annulus Require Import algorithm_list truncated_double.
From Annulus Require Export updated.
Import ListNotations.
Open Scope R_scope.

Class world := {
  position : Type;
  vertex : Type;
  certificate : Type;
  same_vertex : forall v w : vertex, {v = w} + {v <> w};
  same_position : position -> position -> bool;
  dist : position -> position -> R;
  points : certificate -> list vertex;
  holds : certificate -> (vertex -> position) -> Prop;
  counts_on : certificate -> certificate -> Prop;    (* counts_on d c: c is certified given that d holds *)
  capacity : nat;                                    (* of lists *)
  stamps : Z;                                        (* that tell steps apart: Limits *)
  around : (Z -> option certificate) -> vertex -> list Z;   (* for_each_certificate *)
  (* arithmetic *)
  num : Type;                                        (* what the program computes with *)
  real : num -> R;                                   (* and what that means *)
  zero : num;
  valid : position -> Prop;                          (* in the coordinate domain *)
  number : num -> Prop;                              (* a double *)
  path_length_of : num -> position -> position -> num;   (* base, fixed, moving *)
  below : position -> position -> num -> bool;       (* the comparison of squares with a threshold *)
  threshold : Z -> num -> num;                       (* earliest, base *)
  sum_lower : num -> num -> num;
  less : Z -> num -> num;                            (* what is left of an expiry, rounded down *)
  half : num -> Z;                                   (* Expiry::lower *)
  worn : num -> expiry_list -> bool }.               (* whether a displacement budget is to start again: commit() *)
Coercion real : num >-> R.

Section program.
Context {W : world}.
Definition placement := vertex -> position.

Class laws := {
  dist_nonneg : forall a b, 0 <= dist a b;
  dist_zero : forall a, dist a a = 0;
  dist_triangle : forall a b c, dist a c <= dist a b + dist b c;
  counts_on_wf : well_founded counts_on;
  local : forall c m m', (forall v, In v (points c) -> m v = m' v) -> holds c m -> holds c m';
  stamps_pos : (0 < stamps)%Z;
  around_all : forall mesh v i c, (forall j d, mesh j = Some d -> is_id j) -> mesh i = Some c -> In v (points c) -> In i (around mesh v);
  around_ids : forall mesh v i, In i (around mesh v) -> is_id i;
  same_position_right : forall p q, same_position p q = true -> p = q;
  real_zero : real zero = 0;
  number_zero : number zero;
  half_lower : forall b : num, half b = lower b;
  path_length_above : forall b f p, number b -> 0 <= b -> valid f -> valid p ->
    number (path_length_of b f p) /\ b + dist f p <= path_length_of b f p;
  threshold_below : forall e b f p, (0 <= e <= never)%Z -> number b -> 0 <= b -> valid f -> valid p ->
    below f p (threshold e b) = true -> b + dist f p < value e;
  sum_lower_below : forall b t, number b -> number t -> 0 <= b -> 0 <= t -> sum_lower b t <= b + t;
  less_below : forall e b, (0 <= e <= never)%Z -> number b -> 0 <= b ->
    (value e <= b -> less e b <= 0) /\ (b <= value e -> less e b <= value e - b) }.

(* ---- What a record may promise ---- *)

(* Near its reference, or at it (tolerance 0: only at it). *)
Definition near (m reference : placement) (allowance : R) (v : vertex) : Prop := dist (reference v) (m v) < allowance \/ m v = reference v.
Definition sound (c : certificate) (reference : placement) (allowance : R) : Prop :=
  forall m, (forall v, In v (points c) -> near m reference allowance v) -> (forall d, counts_on d c -> holds d m) -> holds c m.

(* ---- State ---- *)

Record budget := {
  fixed : position;
  base : num;                 (* length of the path of fixed positions since it was 0, or more *)
  room : num;                 (* threshold of the step test *)
  listing : expiry_list;
  stamp : Z }.
Record written := {
  expiry : vertex -> Z;
  reference : placement;
  origin : vertex -> R;       (* base of the point right after the record was made *)
  allowance : R }.
Record state := {
  moving : placement;
  at_ : vertex -> budget;
  mesh : Z -> option certificate;
  record : Z -> written;
  epoch : Z;                  (* the stamp of this step: stamp_ *)
  anchored : list vertex }.   (* in this step *)

Definition set_at (s : state) v o : state :=
  {| moving := moving s; at_ := set same_vertex (at_ s) v o; mesh := mesh s; record := record s; epoch := epoch s; anchored := anchored s |}.
Definition set_record (s : state) i r : state :=
  {| moving := moving s; at_ := at_ s; mesh := mesh s; record := set Z.eq_dec (record s) i r; epoch := epoch s; anchored := anchored s |}.
Definition set_listing (o : budget) l : budget :=
  {| fixed := fixed o; base := base o; room := room o; listing := l; stamp := stamp o |}.
Definition set_stamp (o : budget) e : budget :=
  {| fixed := fixed o; base := base o; room := room o; listing := listing o; stamp := e |}.
Definition set_room (o : budget) : budget :=   (* set_threshold *)
  {| fixed := fixed o; base := base o; room := threshold (earliest (listing o)) (base o); listing := listing o; stamp := stamp o |}.

Definition path_length (s : state) (v : vertex) (p : position) : num := path_length_of (base (at_ s v)) (fixed (at_ s v)) p.
Definition has (s : state) (i : Z) (v : vertex) : bool :=
  match mesh s i with Some c => if in_dec same_vertex v (points c) then true else false | None => false end.

(* ---- A step to x ---- *)

Definition passes (s : state) (x : placement) (v : vertex) : bool :=
  below (fixed (at_ s v)) (x v) (room (at_ s v)) || same_position (x v) (fixed (at_ s v)).
Definition find_failed (s : state) (x : placement) (movers : list vertex) : list vertex := filter (fun v => negb (passes s x v)) movers.

Definition begin_anchoring (s : state) : state :=
  {| moving := moving s; mesh := mesh s; record := record s; anchored := [];
     at_ := if (epoch s =? stamps)%Z then fun v => set_stamp (at_ s v) 0 else at_ s;
     epoch := if (epoch s =? stamps)%Z then 1 else epoch s + 1 |}.

Definition anchor (x : placement) (s : state) (v : vertex) : state :=
  let o := at_ s v in
  if (stamp o =? epoch s)%Z then s
  else
    let t := set_at s v (if same_position (x v) (fixed o) then set_stamp o (epoch s)
                         else {| fixed := x v; base := path_length s v (x v); room := room o; listing := listing o; stamp := epoch s |}) in
    {| moving := moving t; at_ := at_ t; mesh := mesh t; record := record t; epoch := epoch t; anchored := v :: anchored t |}.

Definition is_expired (s : state) (i : Z) (v : vertex) : bool := has s i v && (expiry (record s i) v <=? half (base (at_ s v)))%Z.
(* The list so far, pending certificates. *)
Definition check_expiry s v (found : expiry_list * list Z) (i : Z) : expiry_list * list Z :=
  let (l, pending) := found in
  if negb (has s i v) then found
  else if is_expired s i v then (l, i :: pending)
  else (put i (expiry (record s i) v) l, pending).
Definition own (s : state) (v : vertex) (i : Z) : Z := if has s i v then expiry (record s i) v else never.
Definition visit_star s v (found : expiry_list * list Z) : expiry_list * list Z :=
  let (expired, others) := partition (fun i => is_expired s i v) (around (mesh s) v) in
  let (l, pending) := fold_left (check_expiry s v) expired (cleared capacity, snd found) in
  (put_many capacity (map (fun i => (own s v i, i)) others) l, pending).
Definition examine (s : state) (v : vertex) : expiry_list * list Z :=
  let now := half (base (at_ s v)) in
  if (rest (listing (at_ s v)) <=? now)%Z then visit_star s v (listing (at_ s v), []) else
  let (visited, l) := take now (listing (at_ s v)) in
  let found := fold_left (check_expiry s v) visited (l, []) in
  if (rest (fst found) <=? now)%Z then visit_star s v found else found.

(* Those that failed are anchored, then looked at: which depends on no other list. *)
Definition find_expired (s : state) (x : placement) (failed : list vertex) : state * list Z :=
  let t := fold_left (anchor x) failed (begin_anchoring s) in
  ({| moving := moving t; mesh := mesh t; record := record t; epoch := epoch t; anchored := anchored t;
      at_ := fun v => if in_dec same_vertex v failed then set_listing (at_ t v) (fst (examine t v)) else at_ t v |},
   flat_map (fun v => rev (snd (examine t v))) failed).

(* After a failure: what was kept of those that failed. *)
Definition undo_anchoring (before t : state) (failed : list vertex) : state :=
  {| moving := moving t; mesh := mesh t; record := record t; epoch := epoch t; anchored := anchored t;
     at_ := fun v => if in_dec same_vertex v failed then at_ before v else at_ t v |}.

(* ---- Repair: what it promises ---- *)

Record verdict := { id : Z; of : certificate; bound : num }.
Record evaluated (x : placement) (k : verdict) : Prop := {
  bound_sound : sound (of k) x (bound k);
  bound_pos : 0 <= bound k;
  bound_number : number (bound k) }.
(* From mesh to mesh': what is neither evaluated nor changed was not pending. *)
Record repaired (x : placement) (old new : Z -> option certificate) (pending : list Z) (verdicts : list verdict) : Prop := {
  verdicts_right : forall k, In k verdicts -> new (id k) = Some (of k) /\ evaluated x k;
  others_untouched : forall i c, new i = Some c -> In i (map id verdicts) \/
    (old i = Some c /\ ~ In i pending);
  all_ids : forall i c, new i = Some c -> is_id i;
  all_counted_on : forall i c d, new i = Some c -> counts_on d c -> exists j, new j = Some d }.

(* ---- What is written down ---- *)

Definition put_at (i e : Z) (v : vertex) (s : state) : state := set_at s v (set_listing (at_ s v) (put i e (listing (at_ s v)))).

(* A certificate that was evaluated at x: commit_points. *)
Definition write_point x i (t : num) (s : state) (v : vertex) : state :=
  let s := anchor x s v in put_at i (half (sum_lower (base (at_ s v)) t)) v s.
Definition set_written x i (t : num) (s : state) : state :=
  set_record s i {| expiry := fun v => half (sum_lower (base (at_ s v)) t); reference := x; origin := fun v => base (at_ s v); allowance := t |}.
Definition commit_evaluated x (s : state) (k : verdict) : state :=
  set_written x (id k) (bound k) (fold_left (write_point x (id k) (bound k)) (points (of k)) s).

Definition shifted (e : Z) (b : num) : Z := half (less e b).
Definition rebase (s : state) (v : vertex) : state :=
  let o := at_ s v in
  let b := base o in
  let shift i := let r := record s i in
    if has s i v then
      {| expiry := set same_vertex (expiry r) v (shifted (expiry r v) b);
         reference := reference r; origin := set same_vertex (origin r) v (origin r v - b); allowance := allowance r |}
    else r in
  let relist l i := if has s i v then put i (shifted (expiry (record s i) v) b) l else l in
  {| moving := moving s; mesh := mesh s; epoch := epoch s; anchored := anchored s; record := shift;
     at_ := set same_vertex (at_ s) v {| fixed := fixed o; base := zero; room := room o; stamp := stamp o;
                                         listing := fold_left relist (around (mesh s) v) (cleared capacity) |} |}.
Definition finish (s : state) (v : vertex) : state :=
  let s := if worn (base (at_ s v)) (listing (at_ s v)) then rebase s v else s in set_at s v (set_room (at_ s v)).

Definition with_mesh (s : state) (m : Z -> option certificate) : state :=
  {| moving := moving s; at_ := at_ s; mesh := m; record := record s; epoch := epoch s; anchored := anchored s |}.
Definition move_to (x : placement) (s : state) : state :=
  {| moving := x; at_ := at_ s; mesh := mesh s; record := record s; epoch := epoch s; anchored := anchored s |}.
Definition commit x (s : state) (m : Z -> option certificate) (verdicts : list verdict) : state :=
  let s := fold_left (commit_evaluated x) verdicts (with_mesh s m) in
  move_to x (fold_left finish (anchored s) s).

(* ---- Everything anew, insertion ---- *)

Definition fresh_point (i : Z) (t : num) (s : state) (v : vertex) : state :=
  set_at s v (set_listing (at_ s v) (put_new i (half (sum_lower (base (at_ s v)) t)) (listing (at_ s v)))).
Definition write_fresh x (s : state) (k : verdict) : state :=
  set_written x (id k) (bound k) (fold_left (fresh_point (id k) (bound k)) (points (of k)) s).
Definition recompute (x : placement) (s : state) (m : Z -> option certificate) (verdicts : list verdict) : state :=
  let t := fold_left (write_fresh x) verdicts
    {| moving := x; mesh := m; record := record s; epoch := epoch s; anchored := [];
       at_ := fun v => {| fixed := x v; base := zero; room := zero; listing := cleared capacity; stamp := 0 |} |} in
  {| moving := x; mesh := mesh t; record := record t; epoch := epoch t; anchored := []; at_ := fun v => set_room (at_ t v) |}.
Definition place (s : state) (n : vertex * position) : state :=
  let (v, p) := n in
  move_to (set same_vertex (moving s) v p)
    (set_at s v {| fixed := p; base := base (at_ s v); room := zero; listing := cleared capacity; stamp := stamp (at_ s v) |}).
End program.
