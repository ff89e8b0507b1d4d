(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* How a commit ends: rebase and thresholds of all that were anchored (algorithm_filter.v; src/annulus/engine/displacement_budget_commit.cpp).

   - rebase_good             a base of 0, with its length taken off all expiries of the vertex, clipped at 0
   - finished                rebase or not, and thresholds, of all that were anchored: every certificate is good *)
Require Import Reals Lra Lia ZArith List Bool.
From Annulus Require Import algorithm_listed truncated_double algorithm_filter algorithm_keep algorithm_commit.
Import ListNotations.
Open Scope R_scope.

Section commit.
Context {W : world} {L : laws}.
Notation Valid x := (forall v, valid (x v)).

(* ---- Rebase ---- *)

Lemma has_spec s i c v : mesh s i = Some c -> (has s i v = true <-> In v (points c)).
Proof. intro M. unfold has. rewrite M. destruct (in_dec _ _ _); split; intro; trivial; [discriminate|contradiction]. Qed.

Lemma shifted_below e b : in_use e -> number b -> 0 <= b ->
  (value e <= b -> shifted e b = 0%Z) /\ (b <= value e -> value (shifted e b) <= value e - b).
Proof.
  intros U N B. destruct (less_below e b U N B) as [C D]. unfold shifted. split; intro H.
  - apply half_clips. now apply C.
  - specialize (D H). destruct (Rlt_le_dec 0 (less e b)) as [P|P].
    + apply Rle_trans with (2 := D), half_below. lra.
    + rewrite half_clips, value_0; lra.
Qed.

Section rebasing.
Variables (s : state) (v : vertex).
Hypothesis F : forall w, fine s w.
Let b := base (at_ s v).
Let relist l i := if has s i v then put i (shifted (expiry (record s i) v) b) l else l.

Lemma relist_proper ids : forall l, (forall i, In i ids -> is_id i) -> proper capacity l -> proper capacity (fold_left relist ids l).
Proof.
  induction ids as [|i ids IH]; intros l I P; simpl; [exact P|]. apply IH; [intros j J; apply I; now right|]. unfold relist.
  destruct (has s i v); [|exact P]. apply put_proper; [apply I; now left|apply half_range|exact P].
Qed.

Lemma relist_kept i ids : has s i v = true -> (forall j, In j ids -> is_id j) -> forall l,
  In i ids \/ kept l i (shifted (expiry (record s i) v) b) -> kept (fold_left relist ids l) i (shifted (expiry (record s i) v) b).
Proof.
  intro H. induction ids as [|j ids IH]; intros J l K; simpl; [now destruct K|]. apply IH; [intros k Q; apply J; now right|].
  assert (D := J j (or_introl eq_refl)). unfold relist. destruct (Z.eq_dec j i) as [->|N].
  - right. rewrite H. apply put_kept; [exact D|right; split; [reflexivity|lia]].
  - destruct K as [[E|K]|K]; [contradiction|now left|right]. destruct (has s j v); [|exact K].
    apply put_kept; [exact D|left; split; [congruence|exact K]].
Qed.

Lemma rebase_fine w : fine (rebase s v) w.
Proof.
  destruct (F w) as [B P X Q S]. unfold rebase. split; simpl; unfold set; destruct (same_vertex v w) as [<-|_]; simpl; trivial.
  - apply number_zero.
  - rewrite real_zero. lra.
  - apply relist_proper; [intros i H; exact (around_ids _ _ _ H)|apply cleared_proper].
Qed.

Theorem rebase_good x (open : vertex -> Prop) i c : (forall j d, mesh s j = Some d -> is_id j) -> mesh s i = Some c -> open v -> good s x open i c -> good (rebase s v) x open i c.
Proof.
  intros Ids M O [[I S E P X] C K T]. assert (H := has_spec s i c v M). destruct (F v) as [Nb Pb _ _ _]. fold b in Nb, Pb.
  assert (Fixed : forall w, fixed (at_ (rebase s v) w) = fixed (at_ s w)).
  { intro w. unfold rebase. simpl. unfold set. destruct (same_vertex v w) as [<-|_]; reflexivity. }
  assert (Far : forall w, w <> v -> at_ (rebase s v) w = at_ s w) by (intros w N; unfold rebase; simpl; now apply set_other).
  assert (Near : real (base (at_ (rebase s v) v)) = 0) by (unfold rebase; simpl; rewrite set_same; exact real_zero).
  destruct (has s i v) eqn:D.
  - (* v is a point of it *)
    assert (V : In v (points c)) by now apply H.
    assert (Record : record (rebase s v) i = {| expiry := set same_vertex (expiry (record s i)) v (shifted (expiry (record s i) v) b);
      reference := reference (record s i); origin := set same_vertex (origin (record s i)) v (origin (record s i) v - b);
      allowance := allowance (record s i) |}) by (unfold rebase; simpl; now rewrite D).
    destruct (shifted_below (expiry (record s i) v) b (E v V) Nb Pb) as [Cut Left].
    split; [split|..]; rewrite ?Record; cbn [expiry reference origin allowance]; trivial.
    + intros w Q. unfold set. destruct (same_vertex v w) as [<-|N]; [apply half_range|now apply E].
    + intros w Q. rewrite Fixed. unfold set. destruct (same_vertex v w) as [<-|N].
      * rewrite Near. generalize (P v Q). fold b. lra.
      * rewrite Far by congruence. now apply P.
    + intros w Q. unfold set. destruct (same_vertex v w) as [<-|N]; [|rewrite Far by congruence; now apply X].
      destruct (Rle_lt_dec (value (expiry (record s i) v)) b) as [Lt|Lt].
      * right. rewrite Near, (Cut Lt), value_0. lra.
      * left. destruct (X v Q) as [X1|X1]; [|fold b in X1; lra]. generalize (Left ltac:(lra)). lra.
    + intros w Q. rewrite Record. cbn [expiry reference origin allowance]. destruct (C w Q) as [C1 C2]. split; [exact C1|]. unfold near, fixed_of. rewrite Fixed. exact C2.
    + intros w Q. rewrite Record. cbn [expiry reference origin allowance]. unfold set. destruct (same_vertex v w) as [<-|N]; [|rewrite Far by congruence; now apply K].
      unfold rebase. simpl. rewrite set_same. simpl. apply relist_kept; [exact D|intros j J; exact (around_ids _ _ _ J)|].
      left. exact (around_all _ _ _ _ Ids M V).
    + intros w Q. rewrite Record. cbn [expiry reference origin allowance]. destruct (same_vertex v w) as [<-|N]; [now left|]. rewrite Far, set_other by congruence. now apply T.
  - (* nothing of it changes *)
    assert (V : forall w, In w (points c) -> w <> v) by (intros w Q ->; apply H in Q; congruence).
    assert (Record : record (rebase s v) i = record s i) by (unfold rebase; simpl; now rewrite D).
    split; [split|..]; rewrite ?Record; trivial; intros w Q; rewrite ?Record, ?(Far w (V w Q)).
    + now apply P.
    + now apply X.
    + destruct (C w Q) as [C1 C2]. split; [exact C1|]. unfold near, fixed_of. rewrite Fixed. exact C2.
    + now apply K.
    + now apply T.
Qed.
End rebasing.

(* set_threshold closes what rebase or anchoring opened. *)
Lemma set_room_good s v x (open open' : vertex -> Prop) i c : (forall w, fine s w) -> (forall w, open w -> open' w \/ w = v) ->
  good s x open i c -> good (set_at s v (set_room (at_ s v))) x open' i c.
Proof.
  intros F O [S C K T]. assert (A := set_room_advance x (fun _ => False) s v F).
  split; [now apply (sane_carried _ _ _ _ A)|now apply (close_carried _ _ _ _ A)| |]; intros w Q; simpl; unfold set;
    destruct (same_vertex v w) as [<-|N]; simpl.
  - now apply K.
  - now apply K.
  - right. apply set_room_protects with i; [apply F|now apply (used _ _ _ S)|now apply K].
  - destruct (T w Q) as [H|H]; [|now right]. destruct (O w H) as [H'|H']; [now left|congruence].
Qed.

Lemma finish_good s v x (open open' : vertex -> Prop) : (forall w, fine s w) -> (forall w, open w -> open' w \/ w = v) -> open v ->
  (forall i c, mesh s i = Some c -> good s x open i c) -> let t := finish s v in
  (forall w, fine t w) /\ mesh t = mesh s /\ moving t = moving s /\ forall i c, mesh t i = Some c -> good t x open' i c.
Proof.
  intros F O V G. unfold finish. destruct (worn _ _); cbn.
  - split; [|split; [reflexivity|split; [reflexivity|]]].
    + intro w. apply set_room_fine. apply rebase_fine. exact F.
    + intros i c M. apply set_room_good with open; trivial; [apply rebase_fine; exact F|]. apply rebase_good; trivial; [|now apply G].
      intros j d Mj. exact (an_id _ _ _ (is_sane _ _ _ _ _ (G j d Mj))).
  - split; [|split; [reflexivity|split; [reflexivity|]]].
    + intro w. now apply set_room_fine.
    + intros i c M. apply set_room_good with open; trivial. now apply G.
Qed.

Lemma finished x l : forall s, (forall w, fine s w) -> (forall i c, mesh s i = Some c -> good s x (fun w => In w l) i c) ->
  let t := fold_left finish l s in
  (forall w, fine t w) /\ mesh t = mesh s /\ moving t = moving s /\ forall i c, mesh t i = Some c -> good t x (fun _ => False) i c.
Proof.
  induction l as [|v l IH]; intros s F G; simpl; [split; [exact F|split; [reflexivity|split; [reflexivity|exact G]]]|].
  destruct (finish_good s v x (fun w => v = w \/ In w l) (fun w => In w l) F) as (F' & M' & P' & G'); [|now left|exact G|].
  { intros w [<-|H]; [now right|now left]. }
  rewrite <- M', <- P'. now apply IH.
Qed.
End commit.
