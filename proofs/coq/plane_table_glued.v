(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The mesh that a cell table is: finite cells, pairs of them, and the border as it is walked around infinity.

   - mesh_of_table    read off the table; whole: infinite cells are triangles with one corner at infinity, and are met by one walk (border_is_whole)
   - table_glued      where twins are twins (`sound` of plane_table.v, which flips keep) it is glued *)
From Coq Require Import List Arith Permutation Lia Bool.
From Annulus Require Import plane_mesh plane_paths plane_table.
Import ListNotations.

Definition name (h : plane_table.corner) : nat := 4 * fst h + match snd h with first => 0 | second => 1 | third => 2 end.
Lemma name_right h k : name h = name k -> h = k.
Proof. destruct h as [c []], k as [d []]; cbn; intro E; (f_equal; lia) || (exfalso; lia). Qed.

Section mesh_of_a_table.
Variable t : table.
Hypothesis S : sound t.
Variable all : list nat.
Hypothesis once : NoDup all.
Hypothesis all_cells : forall c, In c all <-> is_cell t c = true.

Definition corners_of (c : nat) : list plane_table.corner := [(c, third); (c, first); (c, second)].
Definition is_finite (c : nat) : bool := forallb (fun h => match vertex t h with Some _ => true | None => false end) (corners_of c).
Definition number (h : plane_table.corner) : nat := match vertex t h with Some v => v | None => O end.
(* Its edge, and its vertex. *)
Definition side_of (h : plane_table.corner) : nat * nat * nat := (number (ccw h), number (cw h), number h).
Definition triangle (c : nat) : nat * nat * nat := (number (c, first), number (c, second), number (c, third)).
Definition finite_corners : list plane_table.corner := flat_map corners_of (filter is_finite all).
Definition inner (h : plane_table.corner) : bool := is_finite (cell_of (twin t h)).
Definition lesser (h : plane_table.corner) : bool := name h <? name (twin t h).
Definition pair_at (h : plane_table.corner) : nat * nat * nat * nat := (number (ccw h), number (cw h), number (twin t h), number h).

Lemma split {A} (f : A -> bool) l : Permutation l (filter f l ++ filter (fun a => negb (f a)) l).
Proof.
  induction l as [|a l IH]; [constructor|]. cbn [filter]. destruct (f a); cbn [negb app]; [now constructor|].
  rewrite IH at 1. apply Permutation_middle.
Qed.

Lemma sides_of_cells : flat_map sides (map triangle (filter is_finite all)) = map side_of finite_corners.
Proof.
  unfold finite_corners. induction (filter is_finite all) as [|c l IH]; [reflexivity|]. cbn [map flat_map]. rewrite IH, map_app. reflexivity.
Qed.

Lemma in_finite h : In h finite_corners <-> is_cell t (cell_of h) = true /\ is_finite (cell_of h) = true.
Proof.
  unfold finite_corners. rewrite in_flat_map. split.
  - intros (c & I & K). apply filter_In in I. rewrite all_cells in I. destruct K as [<-|[<-|[<-|[]]]]; exact I.
  - intros [A B]. exists (cell_of h). split; [apply filter_In; now rewrite all_cells|]. destruct h as [c []]; cbn; tauto.
Qed.

Lemma finite_once : NoDup finite_corners.
Proof.
  unfold finite_corners. assert (N : NoDup (filter is_finite all)) by now apply NoDup_filter. induction N as [|c l Nc N IH]; [constructor|].
  cbn [flat_map]. assert (K : forall i, ~ In (c, i) (flat_map corners_of l)).
  { intros i I. apply in_flat_map in I. destruct I as (d & I & J). apply Nc. destruct J as [J|[J|[J|[]]]]; injection J as -> _; exact I. }
  cbn [corners_of app]. repeat constructor; trivial; simpl; intuition (try congruence); now apply (K _ H0) || eapply K; eauto.
Qed.

(* ---- Pairs ---- *)

Definition inner_corners : list plane_table.corner := filter inner finite_corners.
Definition firsts : list plane_table.corner := filter lesser inner_corners.
Definition both (h : plane_table.corner) : list plane_table.corner := [h; twin t h].

Lemma inner_twin h : In h inner_corners -> In (twin t h) inner_corners /\ twin t (twin t h) = h /\ twin t h <> h.
Proof.
  unfold inner_corners, inner. rewrite !filter_In, !in_finite. intros [[A B] C]. destruct (S h A) as (D & E & F & _). rewrite E. tauto.
Qed.

Lemma nodup_map {A B} (f : A -> B) l : (forall a b, In a l -> In b l -> f a = f b -> a = b) -> NoDup l -> NoDup (map f l).
Proof.
  intros I N. induction N as [|a l Na N IH]; [constructor|]. cbn [map]. constructor.
  - intro K. apply in_map_iff in K. destruct K as (b & E & K). apply Na. rewrite (I a b); trivial; [now left|now right|now symmetry].
  - apply IH. intros x y X Y. apply I; now right.
Qed.

Lemma both_sides l : Permutation (flat_map both l) (l ++ map (twin t) l).
Proof.
  induction l as [|h l IH]; [constructor|]. cbn [flat_map both app map]. constructor. rewrite IH. apply Permutation_middle.
Qed.

Lemma in_pairs : Permutation inner_corners (flat_map both firsts).
Proof.
  rewrite both_sides, (split lesser inner_corners) at 1. apply Permutation_app_head. apply NoDup_Permutation.
  - apply NoDup_filter, NoDup_filter, finite_once.
  - apply nodup_map; [|apply NoDup_filter, NoDup_filter, finite_once]. intros a b A B E. apply filter_In in A, B.
    destruct (inner_twin a (proj1 A)) as (_ & <- & _), (inner_twin b (proj1 B)) as (_ & <- & _). now rewrite E.
  - intro h. rewrite filter_In, negb_true_iff, in_map_iff. unfold lesser. rewrite Nat.ltb_ge. split.
    + intros [I L]. destruct (inner_twin h I) as (J & E & D). exists (twin t h). split; [exact E|]. apply filter_In. split; [exact J|].
      unfold lesser. rewrite E. apply Nat.ltb_lt. assert (name (twin t h) <> name h) by (intro Q; apply D; now apply name_right). lia.
    + intros (k & <- & I). apply filter_In in I. destruct I as [I L]. apply Nat.ltb_lt in L. destruct (inner_twin k I) as (J & E & _). rewrite E. split; [exact J|lia].
Qed.

Lemma ends_of_twin h : is_cell t (cell_of h) = true -> number (ccw (twin t h)) = number (cw h) /\ number (cw (twin t h)) = number (ccw h).
Proof.
  intro C. destruct (S h C) as (D & E & _ & V). destruct (S _ D) as (_ & _ & _ & V'). rewrite E in V'. unfold number. now rewrite V, V'.
Qed.

Lemma shared_pairs l : (forall h, In h l -> is_cell t (cell_of h) = true) -> flat_map shared_sides (map pair_at l) = map side_of (flat_map both l).
Proof.
  induction l as [|h l IH]; [reflexivity|]. intro C. cbn [map flat_map both app]. rewrite <- IH by (intros; apply C; now right).
  destruct (ends_of_twin h (C h (or_introl eq_refl))) as [A B]. unfold pair_at, side_of at 1 2. cbn [shared_sides app]. now rewrite A, B.
Qed.

(* ---- The border ---- *)

(* Corners at infinity are alone in their cells, and look at a finite one. *)
Hypothesis simple : forall h, is_cell t (cell_of h) = true -> vertex t h = None ->
  vertex t (ccw h) <> None /\ vertex t (cw h) <> None /\ is_finite (cell_of (twin t h)) = true.
Definition at_infinity (c : nat) : plane_table.corner :=
  match vertex t (c, first), vertex t (c, second) with None, _ => (c, first) | _, None => (c, second) | _, _ => (c, third) end.
(* The walk of border_2.cpp meets all cells with infinity (border_is_whole). *)
Variable rim : list nat.
Hypothesis rim_once : NoDup rim.
Hypothesis rim_all : forall c, In c rim <-> is_cell t c = true /\ is_finite c = false.
Hypothesis rim_walk : forall c d, In (c, d) (ring rim) -> at_infinity d = ccw (twin t (ccw (at_infinity c))).

Definition mesh_of_table : mesh := {|
  cells := map triangle (filter is_finite all);
  bicells := map pair_at firsts;
  outer := map side_of (filter (fun h => negb (inner h)) finite_corners);
  border := rev (map (fun c => number (ccw (at_infinity c))) rim) |}.

Lemma infinite_corner c : is_finite c = false -> cell_of (at_infinity c) = c /\ vertex t (at_infinity c) = None.
Proof.
  unfold is_finite, corners_of, at_infinity. cbn [forallb]. destruct (vertex t (c, first)) eqn:A, (vertex t (c, second)) eqn:B, (vertex t (c, third)) eqn:C;
    intro F; try discriminate; now split.
Qed.

Lemma only_infinite h : is_cell t (cell_of h) = true -> vertex t (ccw h) <> None -> vertex t (cw h) <> None -> is_finite (cell_of h) = false -> h = at_infinity (cell_of h).
Proof.
  intros C A B F. destruct (infinite_corner _ F) as [E V]. destruct (in_cell_of h (at_infinity (cell_of h)) E) as [D|[D|D]]; [now symmetry| |];
    rewrite D in V; contradiction.
Qed.

Lemma finite_vertex h : is_finite (cell_of h) = true -> vertex t h <> None.
Proof.
  unfold is_finite, corners_of. cbn [forallb]. rewrite !andb_true_iff. intros (A & B & C & _) E. destruct h as [c []]; cbn in *; now rewrite E in *.
Qed.

Lemma outer_corners : Permutation (filter (fun h => negb (inner h)) finite_corners) (map (fun c => twin t (at_infinity c)) rim).
Proof.
  apply NoDup_Permutation.
  - apply NoDup_filter, finite_once.
  - apply nodup_map; [|exact rim_once]. intros a b A B E. apply rim_all in A, B. destruct A as [A A'], B as [B B'].
    destruct (infinite_corner a A') as [Ia _], (infinite_corner b B') as [Ib _].
    destruct (S (at_infinity a)) as (_ & Ta & _); [now rewrite Ia|]. destruct (S (at_infinity b)) as (_ & Tb & _); [now rewrite Ib|].
    rewrite <- Ia, <- Ib, <- Ta, <- Tb. now rewrite E.
  - intro h. rewrite filter_In, negb_true_iff, in_map_iff, in_finite. unfold inner. split.
    + intros [[C F] I]. destruct (S h C) as (D & E & _ & V). destruct (S _ D) as (_ & _ & _ & V'). rewrite E in V'.
      destruct (three h) as (_ & _ & _ & _ & _ & _ & _ & H8 & H9).
      exists (cell_of (twin t h)). split; [|now apply rim_all]. rewrite <- (only_infinite (twin t h)); trivial.
      * rewrite V. apply finite_vertex. now rewrite H9.
      * rewrite <- V'. apply finite_vertex. now rewrite H8.
    + intros (c & <- & I). apply rim_all in I. destruct I as [C F]. destruct (infinite_corner c F) as [E V].
      destruct (simple (at_infinity c)) as (_ & _ & K); [now rewrite E|exact V|]. destruct (S (at_infinity c)) as (D & B & _); [now rewrite E|].
      rewrite B, E. now repeat split.
Qed.

Lemma ring_map (f : nat -> nat) l : ring (map f l) = map (fun s => (f (fst s), f (snd s))) (ring l).
Proof.
  assert (Q : forall p, steps (map f p) = map (fun s => (f (fst s), f (snd s))) (steps p)).
  { induction p as [|a p IH]; [reflexivity|]. destruct p as [|b p]; [reflexivity|]. cbn [map] in *. rewrite !steps_cons, IH. reflexivity. }
  unfold ring. now rewrite firstn_map, <- map_app, Q.
Qed.

Lemma ring_begins l : map fst (ring l) = l.
Proof.
  assert (Q : forall p x, map fst (steps (p ++ [x])) = p).
  { induction p as [|a p IH]; intro x; [reflexivity|]. specialize (IH x). destruct p as [|b p]; [reflexivity|]. cbn [app] in *. rewrite steps_cons. cbn [map fst]. now rewrite IH. }
  destruct l as [|a l]; [reflexivity|]. unfold ring. cbn [firstn]. apply Q.
Qed.

Definition swap (s : nat * nat) : nat * nat := (snd s, fst s).
Lemma ring_rev l : Permutation (ring (rev l)) (map swap (ring l)).
Proof.
  assert (Q : forall p, steps (rev p) = map swap (rev (steps p))).
  { induction p as [|a p IH]; [reflexivity|]. destruct p as [|b p]; [reflexivity|]. rewrite steps_cons. cbn [rev] in *. rewrite map_app, <- IH, <- app_assoc.
    cbn [app]. now rewrite steps_app. }
  destruct l as [|a r]; [constructor|]. transitivity (ring (a :: rev r)).
  - cbn [rev]. destruct (rev r) as [|b k]; [reflexivity|]. unfold ring. cbn [app firstn]. rewrite steps_cons, <- app_assoc. cbn [app].
    change (b :: k ++ [a; b]) with ((b :: k) ++ a :: [b]). rewrite steps_app. symmetry. apply Permutation_cons_append.
  - unfold ring. cbn [firstn app]. transitivity (map swap (rev (steps (a :: r ++ [a])))).
    + rewrite <- Q. cbn [rev]. rewrite rev_app_distr. reflexivity.
    + apply Permutation_map, Permutation_sym, Permutation_rev.
Qed.

Theorem table_glued : glued mesh_of_table.
Proof.
  split; unfold mesh_of_table; cbn [cells bicells outer border].
  - rewrite sides_of_cells. transitivity (map side_of (inner_corners ++ filter (fun h => negb (inner h)) finite_corners)); [apply Permutation_map, split|].
    rewrite map_app. apply Permutation_app_tail. rewrite in_pairs, shared_pairs; [reflexivity|]. intros h I. apply filter_In in I. destruct I as [I _]. apply filter_In in I. now apply in_finite.
  - rewrite map_map, outer_corners, map_map, ring_rev, ring_map, map_map. rewrite <- (ring_begins rim) at 1. rewrite map_map.
    apply Permutation_refl'. apply map_ext_in. intros [c d] I. cbn [fst snd swap].
    assert (Ic : In c rim) by (rewrite <- (ring_begins rim); now apply (in_map fst _ (c, d))). apply rim_all in Ic. destruct Ic as [C F].
    destruct (infinite_corner c F) as [E V]. assert (C' : is_cell t (cell_of (at_infinity c)) = true) by now rewrite E.
    destruct (ends_of_twin _ C') as [A B]. unfold side_of, edge. rewrite A, B. unfold swap. cbn [fst snd]. f_equal.
    rewrite (rim_walk c d I). destruct (three (at_infinity c)) as (_ & _ & _ & _ & H5 & H6 & _ & H8 & _).
    assert (C2 : is_cell t (cell_of (ccw (at_infinity c))) = true) by now rewrite H8. destruct (ends_of_twin _ C2) as [_ B2].
    destruct (three (twin t (ccw (at_infinity c)))) as (_ & _ & _ & _ & _ & G6 & _). now rewrite G6, B2, H6.
Qed.
End mesh_of_a_table.
