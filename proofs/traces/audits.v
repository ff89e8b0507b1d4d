(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Triangulations of the plane as the engine has them after a call (traces.cpp), judged by the audit that plane_audit.v proves.

   - faithful        a table is accepted, and each of its damaged copies is refused: so each is a triangulation of its points, and Delaunay
   - audited_tables  what `faithful` says of each of them
   - a mesh that winds twice is refused, the same in order is not
   - examples say what damage is, and what is read of words *)
From Coq Require Import PArray Uint63 Floats ZArith Bool List.
From Annulus Require Import operations filter_2 filter_delaunay plane_mesh plane_audit winding_needed.
From Annulus_traces Require Import machine words verdicts replay.
Import ListNotations.
Close Scope float_scope.
Open Scope nat_scope.

Definition point := filter_2.vector operations.machine.
Definition origin : point := at_point 0%float 0%float.
Record table := { points : list point; cells : list (nat * nat * nat) }.
Definition of_list (l : list point) : doubles := fun v => nth v l origin.
Definition accepts (t : table) : bool := audited (length (points t)) (of_list (points t)) (cells t).

Definition index : reader nat := n <- words.number; ret (Z.to_nat n).
Definition point_read : reader point := a <- real_number; b <- real_number; ret (at_point a b).
Definition cell_read : reader (nat * nat * nat) := a <- index; b <- index; c <- index; ret (a, b, c).
Definition table_read : reader table := p <- many point_read; c <- many cell_read; ret {| points := p; cells := c |}.

(* ---- Damage ---- *)

Definition with_cells (t : table) (c : list (nat * nat * nat)) : table := {| points := points t; cells := c |}.
Definition with_points (t : table) (p : list point) : table := {| points := p; cells := cells t |}.
Definition turned_over (k : nat * nat * nat) : nat * nat * nat := let '(a, b, c) := k in (b, a, c).
Definition swapped {A} (l : list A) : list A := match l with a :: b :: l => b :: a :: l | _ => l end.
Definition same_place {A} (l : list A) : list A := match l with a :: _ :: l => a :: a :: l | _ => l end.
(* Two cells have one of their corners exchanged: one that they do not share. *)
Definition crossed (l : list (nat * nat * nat)) : list (nat * nat * nat) :=
  match l with (a, b, c) :: (d, e, f) :: l => if c =? f then (a, e, c) :: (d, b, f) :: l else (a, b, f) :: (d, e, c) :: l | _ => [] end.

Definition damaged (t : table) : list table :=
  [with_cells t (tl (cells t));                                              (* a cell is missing *)
   with_cells t (hd (0, 0, 0) (cells t) :: cells t);                         (* one is there twice *)
   with_cells t (turned_over (hd (0, 0, 0) (cells t)) :: tl (cells t));      (* one is turned over *)
   with_cells t (crossed (cells t));                                         (* two have each other's corner *)
   with_points t (swapped (points t));                                       (* two vertices have each other's place *)
   with_points t (same_place (points t));                                    (* or the same *)
   with_points t (points t ++ [hd origin (points t)])].  (* a point is no vertex *)

Definition faithful (t : table) : bool := accepts t && forallb (fun d => negb (accepts d)) (damaged t).

(* The tables of an array: how many, and these. *)
Definition tables_of (w : array int) : option (list table) := match many table_read w 0%uint63 with Good l _ => Some l | Bad _ _ => None end.
Definition all_faithful (least : nat) (w : array int) : bool :=
  match tables_of w with Some l => (least <=? length l) && forallb faithful l | None => false end.

Theorem audited_tables least w l t : all_faithful least w = true -> tables_of w = Some l -> In t l -> exists T, plane_mesh.cells T = cells t /\
  (forall v, vertex_of T v <-> v < length (points t)) /\ triangulation (at_doubles (of_list (points t))) T /\ delaunay (at_doubles (of_list (points t))) T.
Proof.
  unfold all_faithful. intros H E I. rewrite E in H. apply andb_prop in H. destruct H as [_ H]. rewrite forallb_forall in H. specialize (H t I).
  apply andb_prop in H. destruct H as [H _]. destruct (audited_delaunay _ _ _ H) as (T & A & B & _ & C). now exists T.
Qed.

(* ---- Twice around (winding_needed.v) ---- *)

Definition pentagon_table : table := {| cells := plane_mesh.cells fan;
  points := [at_point 0 10; at_point (-9) 3; at_point (-6) (-8); at_point 6 (-8); at_point 9 3; at_point 0 0]%float |}.
Definition pentagram_table : table := {| cells := plane_mesh.cells fan;
  points := [at_point 0 10; at_point (-6) (-8); at_point 9 3; at_point (-9) 3; at_point 6 (-8); at_point 0 0]%float |}.
Example pentagon_faithful : faithful pentagon_table = true. Proof. vm_compute. reflexivity. Qed.
Example pentagram_refused : accepts pentagram_table = false. Proof. vm_compute. reflexivity. Qed.

(* What damage is, so that none of it is left out or does nothing. *)
Example pentagon_damaged : map cells (damaged pentagon_table) =
  [[(5, 1, 2); (5, 2, 3); (5, 3, 4); (5, 4, 0)]; [(5, 0, 1); (5, 0, 1); (5, 1, 2); (5, 2, 3); (5, 3, 4); (5, 4, 0)];
   [(0, 5, 1); (5, 1, 2); (5, 2, 3); (5, 3, 4); (5, 4, 0)]; [(5, 0, 2); (5, 1, 1); (5, 2, 3); (5, 3, 4); (5, 4, 0)];
   cells pentagon_table; cells pentagon_table; cells pentagon_table] /\
  map points (damaged pentagon_table) = let p := points pentagon_table in
  [p; p; p; p; [at_point (-9) 3; at_point 0 10; at_point (-6) (-8); at_point 6 (-8); at_point 9 3; at_point 0 0];
   [at_point 0 10; at_point 0 10; at_point (-6) (-8); at_point 6 (-8); at_point 9 3; at_point 0 0]; p ++ [at_point 0 10]]%float.
Proof. split; vm_compute; reflexivity. Qed.
Example crossed_last : crossed [(0, 1, 2); (3, 4, 2)] = [(0, 4, 2); (3, 1, 2)]. Proof. reflexivity. Qed.

(* ---- Words ---- *)

Definition words_of (l : list int) : array int := snd (fold_left (fun '(i, w) x => (i + 1, PArray.set w i x))%uint63 l (0%uint63, make 16 0%uint63)).
(* The triangle (0, 0), (2, 0), (-1, 1). *)
Definition triangle_words : array int :=
  words_of [1; 3; 0; 0; 0x4000000000000000; 0; minus; 0x3ff0000000000000; 0x3ff0000000000000; 1; 0; 1; 2]%uint63.
Example triangle_read : tables_of triangle_words = Some [{| points := [at_point 0 0; at_point 2 0; at_point (-1) 1]%float; cells := [(0, 1, 2)] |}].
Proof. vm_compute. reflexivity. Qed.
Example triangle_faithful : map (fun least => all_faithful least triangle_words) [0; 1; 2] = [true; true; false]. Proof. vm_compute. reflexivity. Qed.
Example unreadable : all_faithful 0 (words_of [0x10000%uint63]) = false. Proof. vm_compute. reflexivity. Qed.
