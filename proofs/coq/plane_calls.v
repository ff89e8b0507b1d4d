(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What one call of the program may be in the plane: what it does to records, certificates and table, and when it walks the border. Definitions only;
   filter_calls.v proves what follows for any number of calls.

   - event          which vertex is inserted or removed; `present`: which vertices there are after so many calls
   - in_doubt       Repair::border_holds: whether the border is walked
   - evaluates      what Repair does: it evaluates all pending certificates that are there, and all certificates of cells that it touched
   - program_call   what one call may be *)
From Coq Require Import Reals ZArith List Bool.
From Annulus Require Import points_2 filter_doubles returned_2 algorithm_list algorithm_filter algorithm_check algorithm_run filter_world filter_plane.
From Annulus Require Import plane_mesh plane_certificates filter_delaunay signed_2 plane_listed.
Import ListNotations.
Open Scope R_scope.

(* ---- Which vertices there are ---- *)

Inductive event := no_event | inserts (v : nat) | removes (v : nat).
Definition afterwards (e : event) (there : nat -> Prop) (v : nat) : Prop :=
  match e with no_event => there v | inserts w => there v \/ v = w | removes w => there v /\ v <> w end.
(* The vertices of the beginning, and those inserted since, without those removed. *)
Fixpoint present (there : nat -> Prop) (e : nat -> event) (i : nat) : nat -> Prop :=
  match i with O => there | S i => afterwards (e i) (present there e i) end.
(* From table to table no other vertex is lost or new. *)
Definition keeps (e : event) (T T' : plane_mesh.mesh) : Prop := forall v, vertex_of T' v <-> afterwards e (vertex_of T) v.

(* ---- What a call does to the table ---- *)

(* Nothing; cells inside are others now; cells at the border are, too (holds_after_flips: a cell with infinity was touched). *)
Inductive change := nothing | inside | at_border.
Definition changed (w : change) (T T' : plane_mesh.mesh) : Prop :=
  match w with
  | nothing => T' = T
  | inside => glued T' /\ keeps no_event T T' /\ border T' = border T
  | at_border => glued T' /\ keeps no_event T T'
  end.

Section calls.
Context {o : options}.

(* place: an inserted vertex is put where the doubles say. *)
Definition placed (f : doubles) (e : event) : list (vertex * position) := match e with inserts v => [(v, at_doubles f v)] | _ => [] end.

(* Repair::border_holds, with `many` as holds_after_flips leaves it: a cell or a ridge was evaluated, as after flips always. *)
Definition many (movers : list nat) : bool := match movers with [_] => false | _ => true end.
Definition turns (k : verdict) : bool := match of k with circle _ _ _ _ => false | _ => true end.
Definition in_doubt (movers : list nat) (w : change) (verdicts : list verdict) : bool :=
  match w with nothing => many movers && existsb turns verdicts | inside => many movers | at_border => true end.

(* Repair::evaluate and holds_after_flips, when they say yes. `touched`: the numbers of cells that were made or changed, and of their facets. *)
Record evaluates (f : doubles) (old new : Z -> option certificate_2) (pending touched : list Z) (verdicts : list verdict) : Prop := {
  each_answered : forall k, In k verdicts -> new (id k) = Some (of k) /\ is_answer f k;
  none_left : forall i c, In i pending \/ In i touched -> new i = Some c -> In i (map id verdicts);
  others_same : forall i, ~ In i touched -> new i = old i }.

Inductive program_call : event -> system -> plane_mesh.mesh -> system -> plane_mesh.mesh -> Prop :=
  (* move, move_all: all vertices pass *)
  | all_pass s f movers T : (forall v, coordinates_2 (f v)) -> covered s (at_doubles f) movers -> find_failed s (at_doubles f) movers = [] ->
      program_call no_event {| of_filter := s; tracks := true |} T {| of_filter := move_to (at_doubles f) s; tracks := true |} T
  (* some vertex fails: evaluated, flipped or rebuilt, and evaluated again; the border is walked where it is in doubt *)
  | step s f movers m touched verdicts w T T' : (forall v, coordinates_2 (f v)) -> covered s (at_doubles f) movers ->
      (let (u, pending) := find_expired s (at_doubles f) (find_failed s (at_doubles f) movers) in
       evaluates f (algorithm_filter.mesh u) m pending touched verdicts) ->
      changed w T T' -> lists m T' -> (in_doubt movers w verdicts = true -> winds_once (at_doubles f) (border T')) ->
      program_call no_event {| of_filter := s; tracks := true |} T
        {| of_filter := stepped s (at_doubles f) (find_failed s (at_doubles f) movers) m verdicts; tracks := true |} T'
  (* the call is refused *)
  | step_fails s f movers T : (forall v, coordinates_2 (f v)) -> covered s (at_doubles f) movers ->
      let failed := find_failed s (at_doubles f) movers in
      program_call no_event {| of_filter := s; tracks := true |} T
        {| of_filter := undo_anchoring (begin_anchoring s) (fst (find_expired s (at_doubles f) failed)) failed; tracks := true |} T
  (* insertion and removal, while tolerances are kept: that the border winds once, where it is another, is the word of the code that inserts; or cells have other numbers *)
  | inserted s f e m touched verdicts T T' : (forall v, coordinates_2 (f v)) -> let t := fold_left place (placed f e) s in moving t = at_doubles f ->
      (forall v, e = inserts v -> ~ vertex_of T v) ->
      evaluates f (algorithm_filter.mesh t) m [] touched verdicts -> glued T' -> lists m T' -> keeps e T T' ->
      border T' = border T \/ winds_once (at_doubles f) (border T') ->
      program_call e {| of_filter := s; tracks := true |} T {| of_filter := stepped t (at_doubles f) [] m verdicts; tracks := true |} T'
  (* all is evaluated: where it was right already, or after a rebuild, which has CGAL's word for the border *)
  | recomputes_all s b f e m verdicts T T' : start f m verdicts -> glued T' -> lists m T' -> keeps e T T' ->
      (T' = T /\ moving s = at_doubles f) \/ winds_once (at_doubles f) (border T') ->
      program_call e {| of_filter := s; tracks := b |} T (recomputed f m verdicts s) T'
  (* by signs alone (signed_2.v): of everything, when many moved, and then the border is walked each time *)
  | signs_of_all s b f m T T' : (forall v, coordinates_2 (f v)) -> (forall i c, m i = Some c -> signed f c) ->
      glued T' -> lists m T' -> keeps no_event T T' -> winds_once (at_doubles f) (border T') ->
      program_call no_event {| of_filter := s; tracks := b |} T {| of_filter := move_to (at_doubles f) (with_mesh s m); tracks := false |} T'
  (* a rebuild, and insertion and removal without tolerances: CGAL's word for all of it *)
  | rebuilt s b f e m T T' : (forall v, coordinates_2 (f v)) -> (forall i c, m i = Some c -> holds_2 no_fold c (at_doubles f)) ->
      glued T' -> lists m T' -> keeps e T T' -> winds_once (at_doubles f) (border T') ->
      program_call e {| of_filter := s; tracks := b |} T {| of_filter := move_to (at_doubles f) (with_mesh s m); tracks := false |} T'
  (* or of what contains the one vertex that moves *)
  | signs_of_one s f v m w T T' : (forall n, coordinates_2 (f n)) -> covered s (at_doubles f) [v] ->
      (forall i c, m i = Some c -> signed f c \/ (algorithm_filter.mesh s i = Some c /\ ~ In v (points_2 c))) ->
      changed w T T' -> lists m T' -> (w = at_border -> winds_once (at_doubles f) (border T')) ->
      program_call no_event {| of_filter := s; tracks := false |} T {| of_filter := move_to (at_doubles f) (with_mesh s m); tracks := false |} T'
  | stops_tracking s T : program_call no_event {| of_filter := s; tracks := true |} T {| of_filter := s; tracks := false |} T.
End calls.
