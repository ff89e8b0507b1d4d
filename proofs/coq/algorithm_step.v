(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A step of `filter` (algorithm_filter.v): vertices that failed are anchored and looked at, Repair does what it may, all is written down.

   - examined          what is not pending is good at the new positions
   - no_pending_holds  so Repair may count on it: it holds there, given those it counts on
   - undone            if Repair fails, displacement budgets and lists are what they were
   - committed         after commit the invariant holds at the new positions: all certificates hold *)
Require Import Reals Lra Lia ZArith List Bool.
From Annulus Require Import algorithm_listed truncated_double algorithm_filter algorithm_keep algorithm_commit algorithm_rebase algorithm_check.
Import ListNotations.
Open Scope R_scope.

Section step.
Context {W : world} {L : laws}.
Notation Valid x := (forall v, valid (x v)).

(* ---- find_expired ---- *)

Section finding.
Variables (s : state) (x : placement) (failed : list vertex).
Hypothesis V : invariant s.
Hypothesis X : Valid x.
Hypothesis Others : forall v, In v failed \/ passes s x v = true \/ x v = moving s v.
Let t := fold_left (anchor x) failed (begin_anchoring s).
Let u := fst (find_expired s x failed).
Let pending := snd (find_expired s x failed).

Let F0 v : fine (begin_anchoring s) v := proj1 (begin_fine s (fine_all s V) v).

Lemma anchored_all : advance x (fun _ => False) (begin_anchoring s) t /\ (forall v, In v failed -> touched t v) /\
  (forall v, In v failed \/ at_ t v = at_ (begin_anchoring s) v) /\ at_x t x.
Proof.
  destruct (anchors x failed X (begin_anchoring s) F0) as (A & B & C). split; [exact A|split; [intros v H; apply B; now left|split; [exact C|]]].
  apply (stays_at_x _ _ _ _ A). intros v H. now apply begin_fine in H; [|exact (fine_all s V)].
Qed.

Lemma t_fine v : fine t v. Proof. apply anchored_all. Qed.
Lemma t_mesh : mesh t = mesh s. Proof. destruct anchored_all as [A _]. exact (same_mesh _ _ _ _ A). Qed.
Lemma t_record i : record t i = record s i.
Proof. destruct anchored_all as [A _]. rewrite (same_record _ _ _ _ A i); trivial. intros []. Qed.

Lemma t_sane i c : mesh s i = Some c -> sane t i c.
Proof.
  intro M. destruct anchored_all as [A _]. apply (sane_carried _ _ _ _ A); [intros []|]. apply (begin_good s (moving s) (fun _ => False)).
  now apply good_all.
Qed.

Lemma t_listed i c : mesh s i = Some c -> listed t i c.
Proof.
  intros M v H. destruct anchored_all as [A _]. destruct (begin_good _ _ _ _ _ (good_all s V i c M)) as [S _ K _]. rewrite t_record.
  apply (keeps _ _ _ _ _ _ (follows _ _ _ _ A v) i _ (used _ _ _ S v H)); [intros []|now apply K].
Qed.

Lemma t_ids i c : mesh t i = Some c -> is_id i /\ forall w, In w (points c) -> in_use (expiry (record t i) w).
Proof. rewrite t_mesh. intro M. destruct (t_sane i c M). now split. Qed.

Lemma u_at v : at_ u v = if in_dec same_vertex v failed then set_listing (at_ t v) (fst (examine t v)) else at_ t v.
Proof. reflexivity. Qed.

Theorem u_fine v : fine u v.
Proof.
  destruct (t_fine v) as [B P Y Q S]. split; rewrite u_at; destruct (in_dec same_vertex v failed); trivial.
  exact (proj1 (examine_accounts t v t_ids Q)).
Qed.

Lemma u_same v : fixed (at_ u v) = fixed (at_ t v) /\ base (at_ u v) = base (at_ t v) /\ stamp (at_ u v) = stamp (at_ t v).
Proof. rewrite u_at. now destruct (in_dec same_vertex v failed). Qed.

Theorem u_at_x : at_x u x.
Proof.
  intros v H. destruct (u_same v) as (A & _ & C). unfold touched in H. rewrite C in H. rewrite A.
  destruct anchored_all as (_ & _ & _ & D). exact (D v H).
Qed.

(* After anchoring a point is near, unless it failed and has found the certificate expired. *)
Lemma point_near i c v : mesh s i = Some c -> In v (points c) -> (In v failed -> (half (base (at_ t v)) < expiry (record s i) v)%Z) ->
  near x (reference (record s i)) (allowance (record s i)) v /\ near (fixed_of t) (reference (record s i)) (allowance (record s i)) v.
Proof.
  intros M H N. destruct (in_dec same_vertex v failed) as [Y|Y].
  - assert (E : fixed (at_ t v) = x v) by (destruct anchored_all as (_ & B & _ & D); exact (proj1 (D v (B v Y)))).
    assert (K : near x (reference (record s i)) (allowance (record s i)) v).
    { rewrite <- t_record. apply (unreached_here t x i c); trivial; [apply t_fine|now apply t_sane|]. rewrite t_record. now apply N. }
    split; [exact K|]. unfold near, fixed_of. rewrite E. exact K.
  - assert (G := good_all s V i c M). split.
    + apply untested_near with c; trivial; [now apply fine_all|]. destruct (Others v) as [O|O]; [contradiction|exact O].
    + destruct anchored_all as (_ & _ & C & _). destruct (C v) as [C'|C']; [contradiction|]. unfold near, fixed_of. rewrite C'.
      destruct (begin_same s v) as (-> & _). apply (is_close _ _ _ _ _ G v H).
Qed.

Theorem examined i c : mesh u i = Some c -> In i pending \/ good u x (touched u) i c.
Proof.
  change (mesh u) with (mesh t). rewrite t_mesh. intro M.
  (* at every point that failed it was pending, or not reached *)
  assert (D : forall l, (forall v, In v l -> In v failed) -> In i pending \/ forall v, In v l -> In v (points c) ->
    (half (base (at_ t v)) < expiry (record t i) v)%Z /\ kept (fst (examine t v)) i (expiry (record t i) v)).
  { induction l as [|v l IH]; intro Inc; [right; intros v []|]. assert (Fv := Inc v (or_introl eq_refl)).
    destruct (IH (fun w H => Inc w (or_intror H))) as [Q|Q]; [now left|].
    destruct (in_dec same_vertex v (points c)) as [Y|Y].
    - assert (Mt : mesh t i = Some c) by now rewrite t_mesh.
      destruct (proj2 (examine_accounts t v t_ids (list_proper _ _ (t_fine v))) i c Mt Y (t_listed i c M v Y)) as [H|H].
      + left. apply in_flat_map. exists v. split; [exact Fv|now apply in_rev in H].
      + right. intros w [<-|Hw] Hp; [exact H|now apply Q].
    - right. intros w [<-|Hw] Hp; [contradiction|now apply Q]. }
  destruct (D failed (fun v H => H)) as [Q|Q]; [now left|right]. clear D.
  destruct (t_sane i c M) as [I S E P Ex]. assert (R : record u i = record t i) by reflexivity.
  split; [split|..]; rewrite ?R; trivial.
  - intros v H. destruct (u_same v) as (-> & -> & _). now apply P.
  - intros v H. destruct (u_same v) as (_ & -> & _). now apply Ex.
  - intros v H. rewrite R, t_record. destruct (point_near i c v M H) as [N1 N2].
    { intro Y. rewrite <- t_record. now apply Q. }
    split; [exact N1|]. unfold near, fixed_of. destruct (u_same v) as (-> & _). exact N2.
  - intros v H. rewrite R, u_at. destruct (in_dec same_vertex v failed) as [Y|Y]; [now apply Q|now apply t_listed with c].
  - intros v H. rewrite R. unfold touched. rewrite u_at. destruct anchored_all as (_ & B & C & _).
    destruct (in_dec same_vertex v failed) as [Y|Y]; [left; now apply B|]. destruct (C v) as [C'|C']; [contradiction|].
    right. rewrite C', t_record. destruct (begin_good _ _ _ _ _ (good_all s V i c M)) as [_ _ _ T]. destruct (T v H) as [[]|T']. exact T'.
Qed.

(* What Repair may count on: whatever is not pending holds at x, if what it counts on does. *)
Theorem no_pending_holds i c : mesh u i = Some c -> ~ In i pending -> (forall d, counts_on d c -> holds d x) -> holds c x.
Proof.
  intros M N K. destruct (examined i c M) as [Q|Q]; [contradiction|].
  apply (promise _ _ _ (is_sane _ _ _ _ _ Q)); [|exact K]. intros v H. apply (is_close _ _ _ _ _ Q v H).
Qed.

(* A failure: everything is as it was when the step began. *)
Theorem undone v : at_ (undo_anchoring (begin_anchoring s) u failed) v = at_ (begin_anchoring s) v.
Proof.
  simpl. fold t. destruct (in_dec same_vertex v failed) as [Y|Y]; [reflexivity|].
  destruct anchored_all as (_ & _ & C & _). destruct (C v) as [C'|C']; [contradiction|exact C'].
Qed.
Theorem undone_else : let r := undo_anchoring (begin_anchoring s) u failed in
  moving r = moving s /\ mesh r = mesh s /\ epoch r = epoch (begin_anchoring s) /\ forall i, record r i = record s i.
Proof.
  destruct anchored_all as [A _]. simpl. fold t. split; [exact (same_moving _ _ _ _ A)|split; [exact t_mesh|split; [exact (same_epoch _ _ _ _ A)|exact t_record]]].
Qed.

(* ---- commit ---- *)

Variables (m : Z -> option certificate) (verdicts : list verdict).
Hypothesis Mended : repaired x (mesh u) m pending verdicts.
Let w0 := with_mesh u m.

Lemma w0_fine v : fine w0 v.
Proof. destruct (u_fine v). now split. Qed.

Lemma w0_good i c : good u x (touched u) i c -> good w0 x (touched w0) i c.
Proof. intros [[I S E P Ex] C K T]. split; trivial. now split. Qed.

Theorem committed : let r := commit x u m verdicts in invariant r /\ mesh r = m /\ moving r = x.
Proof.
  destruct Mended as [Right Rest Ids Counted].
  destruct (verdicts_committed x verdicts X w0 w0_fine u_at_x) as (F2 & A2 & M2 & P2 & G2).
  - intros k H. destruct (Right k H) as [R1 R2]. split; [exact (Ids _ _ R1)|now split].
  - intros i c H. destruct (Rest i c H) as [Q|[Q1 Q2]]; [now left|right]. apply w0_good. destruct (examined i c Q1) as [Q|Q]; [contradiction|exact Q].
  - set (w2 := fold_left (commit_evaluated x) verdicts w0) in *.
    destruct (finished x (anchored w2) w2 F2) as (F3 & M3 & P3 & G3).
    { intros i c H. destruct (G2 i c H) as [S C K T]. split; trivial. intros v Hv. destruct (T v Hv) as [H1|H1]; [left; now apply A2|now right]. }
    assert (E : mesh (commit x u m verdicts) = m).
    { unfold commit. fold w0. fold w2. simpl. rewrite M3, M2. reflexivity. }
    split; [|now split]. split.
    + intro v. destruct (F3 v). now split.
    + exact X.
    + intros i c H. destruct (G3 i c H) as [[I S Us P Ex] C K T]. split; [now split|..]; trivial.
    + rewrite E. exact Counted.
Qed.
End finding.
End step.
