(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What commit() writes: certificates that were evaluated, thresholds (algorithm_filter.v; src/annulus/engine/displacement_budget_commit.cpp).

   - set_room_protects       a threshold from the earliest expiry of a list protects all that the list contains
   - verdicts_committed      all that was evaluated: every certificate is good but for thresholds *)
Require Import Reals Lra Lia ZArith List Bool.
From Annulus Require Import algorithm_listed truncated_double algorithm_filter algorithm_keep.
Import ListNotations.
Open Scope R_scope.

Section commit.
Context {W : world} {L : laws}.
Notation Valid x := (forall v, valid (x v)).

(* ---- Thresholds ---- *)

Lemma set_room_protects s v j own : fine s v -> in_use own -> kept (listing (at_ s v)) j own -> protects (set_room (at_ s v)) own.
Proof.
  intros [B P X Q _] U K p V H. simpl in *. assert (E := earliest_below _ _ _ _ Q K). assert (E0 := earliest_range _ _ Q).
  unfold in_use in U. apply Rlt_le_trans with (value (earliest (listing (at_ s v)))); [|apply value_le; lia].
  apply threshold_below; trivial. lia.
Qed.

Lemma set_room_fine s v w : (forall w, fine s w) -> fine (set_at s v (set_room (at_ s v))) w.
Proof. intro F. destruct (F w) as [B P X Q S]. split; simpl; unfold set; destruct (same_vertex v w) as [<-|_]; trivial. Qed.

Lemma set_room_advance x ids s v : (forall w, fine s w) -> advance x ids s (set_at s v (set_room (at_ s v))).
Proof.
  intro F. split; trivial; simpl.
  - intro w. unfold set. destruct (same_vertex v w) as [<-|_]; [|apply follow_refl]. split; simpl; [left; easy|easy|].
    intros j own U _ K. split; [exact K|right]. intros _. now apply set_room_protects with j.
  - intro w. now apply set_room_fine.
  - intros A w. unfold touched. simpl. unfold set. destruct (same_vertex v w) as [<-|_]; [exact (A v)|exact (A w)].
Qed.

(* ---- All that was evaluated ---- *)

Lemma verdicts_committed x l : Valid x -> forall s, (forall w, fine s w) -> at_x s x ->
  (forall k, In k l -> is_id (id k) /\ mesh s (id k) = Some (of k) /\ evaluated x k) ->
  (forall i c, mesh s i = Some c -> In i (map id l) \/ good s x (touched s) i c) ->
  let t := fold_left (commit_evaluated x) l s in
  (forall w, fine t w) /\ at_x t x /\ mesh t = mesh s /\ moving t = moving s /\ forall i c, mesh t i = Some c -> good t x (touched t) i c.
Proof.
  intro X. induction l as [|k l IH]; intros s F A P G; cbn [fold_left].
  - split; [exact F|split; [exact A|split; [reflexivity|split; [reflexivity|]]]]. intros j d M. destruct (G j d M) as [[]|Q]. exact Q.
  - destruct (P k (or_introl eq_refl)) as (I & M & B). destruct (evaluated_good x s k X I B F A) as [V Q]. cbv zeta in V, Q. assert (M' := same_mesh _ _ _ _ V). rewrite <- M', <- (same_moving _ _ _ _ V).
    apply IH; [apply V|now apply (stays_at_x _ _ _ _ V)| |].
    + intros h H. rewrite M'. apply P. now right.
    + intros i c H. rewrite M' in H. destruct (Z.eq_dec (id k) i) as [<-|N].
      * right. rewrite M in H. inversion H. now subst.
      * destruct (G i c H) as [[E|E]|E]; [contradiction|now left|right]. now apply good_carried with (eq (id k)) s.
Qed.
End commit.
