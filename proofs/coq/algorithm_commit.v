(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What commit() writes: renewals, certificates that were evaluated, thresholds (algorithm_filter.v; src/annulus/engine/odometers_commit.cpp).

   - set_room_protects       a threshold from the earliest expiry of a list protects all that the list knows
   - commit_renewal_good     what a second look found out, written down
   - renewals_committed, verdicts_committed    all of them: every certificate is good but for thresholds *)
Require Import Reals Lra Lia ZArith List Bool.
From Annulus Require Import algorithm_listed high_word algorithm_filter algorithm_keep.
Import ListNotations.
Open Scope R_scope.

Section commit.
Context {W : world} {L : laws}.
Notation Valid x := (forall v, valid (x v)).

(* ---- Thresholds, and renewals ---- *)

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

Section renewing.
Variables (x : placement) (i : Z) (new : vertex -> num).
Hypothesis I : is_id i.

Definition renewed_at (s : state) (w : vertex) : Prop :=
  kept (listing (at_ s w)) i (half (new w)) /\ (touched s w \/ protects (at_ s w) (half (new w))).

Lemma renew_point_advance s v : (forall w, fine s w) -> advance x (eq i) s (renew_point i new s v).
Proof.
  intro F. unfold renew_point. assert (A := put_at_advance x i (half (new v)) v s F I (half_range (new v))).
  destruct (_ =? _)%Z; [exact A|]. apply advance_trans with (1 := A). apply set_room_advance, A.
Qed.

Lemma renew_point_done s v : (forall w, fine s w) -> renewed_at (renew_point i new s v) v.
Proof.
  intro F. assert (K := put_at_kept i (half (new v)) v s _ I (Z.le_refl _)). unfold renew_point.
  set (t := put_at i (half (new v)) v s) in *.
  assert (G : fine t v) by apply (put_at_advance (fun w => fixed (at_ s w)) i _ v s F I (half_range (new v))).
  destruct (stamp (at_ t v) =? epoch t)%Z eqn:E; split; trivial.
  - left. now apply Z.eqb_eq.
  - simpl. now rewrite set_same.
  - right. change (protects (set same_vertex (at_ t) v (set_room (at_ t v)) v) (half (new v))). rewrite set_same.
    apply set_room_protects with i; [exact G|apply half_range|exact K].
Qed.

Lemma renew_point_stays s v w : (forall w, fine s w) -> renewed_at s w -> renewed_at (renew_point i new s v) w.
Proof.
  intros F R. destruct (same_vertex v w) as [<-|N]; [now apply renew_point_done|].
  assert (E : at_ (renew_point i new s v) w = at_ s w).
  { unfold renew_point. destruct (_ =? _)%Z; simpl; rewrite !set_other by congruence; reflexivity. }
  unfold renewed_at, touched. rewrite E. destruct R as [K T]. split; [exact K|].
  unfold renew_point. destruct (_ =? _)%Z; exact T.
Qed.

Lemma renew_points l : forall s, (forall w, fine s w) -> let t := fold_left (renew_point i new) l s in
  advance x (eq i) s t /\ forall w, In w l \/ renewed_at s w -> renewed_at t w.
Proof.
  induction l as [|v l IH]; intros s F; simpl.
  - split; [now apply advance_refl|]. intros w [[]|H]. exact H.
  - assert (A := renew_point_advance s v F). destruct (IH _ (all_fine _ _ _ _ A)) as [B C]. split; [now apply advance_trans with (1 := A)|].
    intros w H. apply C. destruct H as [[<-|H]|H]; [right; now apply renew_point_done|now left|right; now apply renew_point_stays].
Qed.
End renewing.

(* What a second look found out, as long as it is not written down. *)
Definition promised (s : state) (x : placement) (n : Z * certificate * renewal) : Prop :=
  let '(i, c, k) := n in
  two_sided c = true /\
  match k with
  | unequal new allowed => sound c (reference (record s i)) allowed /\ forall v, In v (points c) ->
      value (half (new v)) <= origin (record s i) v + allowed v /\
      dist (reference (record s i) v) (fixed (at_ s v)) <= base (at_ s v) - origin (record s i) v /\
      near x (reference (record s i)) allowed v /\ near (fixed_of s) (reference (record s i)) allowed v
  | safe far => chosen <> unequal_moves /\ sound c x (fun v => far v) /\ forall v, In v (points c) -> 0 <= far v /\ number (far v)
  end.

Lemma promised_carried x ids s t i c k : advance x ids s t ->
  match k with unequal _ _ => reference (record t i) = reference (record s i) /\ origin (record t i) = origin (record s i) | safe _ => True end ->
  promised s x (i, c, k) -> promised t x (i, c, k).
Proof.
  intros A E [Two P]. split; [exact Two|revert P]. destruct k as [new allowed|far]; [|trivial]. destruct E as [E1 E2]. rewrite E1, E2. intros [S P]. split; [exact S|].
  intros v H. destruct (P v H) as (P1 & P2 & P3 & P4). repeat split; trivial.
  - now apply (path_carried x ids s t A).
  - now apply (near_fixed_carried x ids s t A).
Qed.

Lemma commit_renewal_advance s x i c k : (forall w, fine s w) -> Valid x -> is_id i -> promised s x (i, c, k) \/ mesh s i = None \/ True ->
  advance x (eq i) s (commit_renewal x s (i, c, k)).
Proof.
  intros F X I _. simpl. destruct (mesh s i) as [c'|]; [|now apply advance_refl]. destruct (two_sided c'); [|now apply advance_refl].
  destruct k as [new allowed|far].
  - destruct (renew_points x i new I (points c') s F) as [A _]. apply advance_trans with (1 := A). apply set_record_advance, A.
  - unfold write_at. destruct (write_points x i far X I (points c') s F) as [A _]. apply advance_trans with (1 := A). apply set_record_advance, A.
Qed.

Lemma commit_renewal_good s x i c k : (forall w, fine s w) -> at_x s x -> Valid x -> is_id i -> mesh s i = Some c ->
  promised s x (i, c, k) ->
  let t := commit_renewal x s (i, c, k) in good t x (touched t) i c /\ promised t x (i, c, k).
Proof.
  intros F A X I M P. assert (V := commit_renewal_advance s x i c k F X I (or_introl P)). destruct (P) as [Two _].
  cbn [commit_renewal] in V |- *. rewrite M, Two in V |- *. destruct k as [new allowed|far].
  - destruct (renew_points x i new I (points c) s F) as [B R]. set (t := fold_left _ _ _) in *. set (r := {| expiry := _ |}) in *.
    assert (E : record (set_record t i r) i = r) by (simpl; apply set_same).
    assert (Q : promised (set_record t i r) x (i, c, unequal new allowed)).
    { apply promised_carried with (eq i) s; [exact V|rewrite E; now split|exact P]. }
    split; [|exact Q]. unfold promised in Q. rewrite E in Q. destruct Q as (_ & S & Q).
    split; [split|..]; rewrite ?E; trivial; simpl.
    + intros _ _ H. rewrite real_zero in H. lra.
    + intros v _. apply half_range.
    + intros v H. apply (Q v H).
    + intros v H. left. apply (Q v H).
    + intros v H. rewrite E. simpl. split; apply (Q v H).
    + intros v H. rewrite E. apply (R v (or_introl H)).
    + intros v H. rewrite E. apply (R v (or_introl H)).
  - destruct P as (_ & N & S & P). split; [|now split]. apply write_at_good; trivial. split; [exact S|split; [exact P|]].
    intro E. contradiction.
Qed.

(* ---- Folds: all that is renewed, all that is evaluated ---- *)

Definition id_of_renewal (n : Z * certificate * renewal) : Z := fst (fst n).

Lemma renewals_committed x (pending : Z -> Prop) l : Valid x -> forall s, (forall w, fine s w) -> at_x s x ->
  (forall n n', In n l -> In n' l -> id_of_renewal n = id_of_renewal n' -> n = n') ->
  (forall i c k, In (i, c, k) l -> is_id i /\ (pending i \/ mesh s i = None \/ (mesh s i = Some c /\ promised s x (i, c, k)))) ->
  (forall i c, mesh s i = Some c -> pending i \/ good s x (touched s) i c \/ exists k, In (i, c, k) l) ->
  let t := fold_left (commit_renewal x) l s in
  (forall w, fine t w) /\ at_x t x /\ mesh t = mesh s /\ moving t = moving s /\
  forall i c, mesh t i = Some c -> pending i \/ good t x (touched t) i c.
Proof.
  intro X. induction l as [|[[i c] k] l IH]; intros s F A U P G; cbn [fold_left].
  - split; [exact F|split; [exact A|split; [reflexivity|split; [reflexivity|]]]]. intros j d M. destruct (G j d M) as [H|[H|(k & [])]]; [now left|now right].
  - destruct (P i c k (or_introl eq_refl)) as [I Q].
    assert (V := commit_renewal_advance s x i c k F X I (or_intror (or_intror Logic.I))). set (t := commit_renewal x s (i, c, k)) in *.
    assert (M' := same_mesh _ _ _ _ V). rewrite <- M', <- (same_moving _ _ _ _ V).
    apply IH; [apply V|now apply (stays_at_x _ _ _ _ V)|intros n n' N N'; apply U; now right| |].
    + intros j d h H. destruct (P j d h (or_intror H)) as [J R]. split; [exact J|]. rewrite M'. destruct R as [R|[R|[R R']]]; [tauto|tauto|].
      right. right. split; [exact R|]. destruct (Z.eq_dec i j) as [<-|N].
      * assert (E := U (i, c, k) (i, d, h) (or_introl eq_refl) (or_intror H) eq_refl). inversion E; subst.
        now apply (commit_renewal_good s x i d h F A X I R).
      * apply promised_carried with (eq i) s; [exact V| |exact R']. destruct h; [|trivial].
        rewrite (same_record _ _ _ _ V j N). now split.
    + intros j d M. rewrite M' in M. destruct (G j d M) as [H|[H|(h & [H|H])]]; [now left| | |right; right; now exists h].
      * destruct (Z.eq_dec i j) as [<-|N]; [|right; left; now apply good_carried with (eq i) s].
        destruct Q as [Q|[Q|[Q Q']]]; [now left|congruence|]. rewrite Q in M. inversion M; subst. right. left.
        now apply commit_renewal_good.
      * inversion H; subst. destruct Q as [Q|[Q|[Q Q']]]; [now left|congruence|]. right. left. now apply commit_renewal_good.
Qed.

Lemma verdicts_committed x l : Valid x -> forall s, (forall w, fine s w) -> at_x s x ->
  (forall k, In k l -> is_id (id k) /\ mesh s (id k) = Some (of k) /\ evaluated x k) ->
  (forall i c, mesh s i = Some c -> In i (map id l) \/ good s x (touched s) i c) ->
  let t := fold_left (commit_evaluated x) l s in
  (forall w, fine t w) /\ at_x t x /\ mesh t = mesh s /\ moving t = moving s /\ forall i c, mesh t i = Some c -> good t x (touched t) i c.
Proof.
  intro X. induction l as [|k l IH]; intros s F A P G; cbn [fold_left].
  - split; [exact F|split; [exact A|split; [reflexivity|split; [reflexivity|]]]]. intros j d M. destruct (G j d M) as [[]|Q]. exact Q.
  - destruct (P k (or_introl eq_refl)) as (I & M & [B1 B2 B3 B4]).
    destruct (write_at_good x (id k) (fun _ => bound k) X I s (of k) (bound k) F A) as [V Q].
    { split; [exact B1|split; [now split|]]. intros _ T. split; [now apply B2|reflexivity]. }
    fold (commit_evaluated x s k) in V, Q. assert (M' := same_mesh _ _ _ _ V). rewrite <- M', <- (same_moving _ _ _ _ V).
    apply IH; [apply V|now apply (stays_at_x _ _ _ _ V)| |].
    + intros h H. rewrite M'. apply P. now right.
    + intros i c H. rewrite M' in H. destruct (Z.eq_dec (id k) i) as [<-|N].
      * right. rewrite M in H. inversion H. now subst.
      * destruct (G i c H) as [[E|E]|E]; [contradiction|now left|right]. now apply good_carried with (eq (id k)) s.
Qed.
End commit.
