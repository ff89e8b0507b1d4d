(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Between steps, and the first half of a step (algorithm_filter.v; src/annulus/engine/displacement_budget_expired.cpp).

   - invariant, holds_everywhere   every certificate is good, hence holds
   - unreached_near    a point whose path length has not reached its expiry is near the reference of the record; overdue and clipped expiries
                       are reached by any path length
   - untested_near     a point that passes the test of a step is near
   - anchors           vertices that failed are anchored
   - examine_accounts   of a vertex that was looked at every certificate is pending, or not reached and listed *)
Require Import Reals Lra Lia ZArith List Bool.
From Annulus Require Import algorithm_listed truncated_double algorithm_filter algorithm_keep algorithm_commit algorithm_rebase.
Import ListNotations.
Open Scope R_scope.

Section look.
Context {W : world} {L : laws}.
Notation Valid x := (forall v, valid (x v)).

(* ---- Between steps ---- *)

Record invariant (s : state) : Prop := {
  fine_all : forall v, fine s v;
  valid_all : forall v, valid (moving s v);
  good_all : forall i c, mesh s i = Some c -> good s (moving s) (fun _ => False) i c;
  closed : forall i c d, mesh s i = Some c -> counts_on d c -> exists j, mesh s j = Some d }.

Theorem holds_everywhere s : invariant s -> forall i c, mesh s i = Some c -> holds c (moving s).
Proof.
  intros V i c. revert i. induction c as [c IH] using (well_founded_ind counts_on_wf). intros i M.
  destruct (good_all s V i c M) as [S C _ _]. apply (promise _ _ _ S).
  - intros v H. now apply C.
  - intros d D. destruct (closed s V i c d M D) as [j J]. now apply (IH d D j).
Qed.

(* A point whose path length has not reached its expiry: clipped and overdue expiries are reached by any path length. *)
Theorem unreached_near s x i c v : fine s v -> valid (x v) -> sane s i c -> In v (points c) ->
  (half (path_length s v (x v)) < expiry (record s i) v)%Z -> near x (reference (record s i)) (allowance (record s i)) v.
Proof.
  intros [B P X Q _] Y S H R. destruct (path_length_above _ _ _ B P X Y) as [_ A]. fold (path_length s v (x v)) in A.
  assert (D := dist_nonneg (fixed (at_ s v)) (x v)). assert (U := used _ _ _ S v H).
  assert (E := half_not_reached (path_length s v (x v)) _ ltac:(lra) (proj2 U) R).
  left. destruct (expires _ _ _ S v H) as [T|T]; [|lra].
  generalize (path _ _ _ S v H) (dist_triangle (reference (record s i) v) (fixed (at_ s v)) (x v)). lra.
Qed.

(* The same after anchoring, where the base is the path length. *)
Lemma unreached_here s x i c v : fine s v -> sane s i c -> In v (points c) -> fixed (at_ s v) = x v ->
  (half (base (at_ s v)) < expiry (record s i) v)%Z -> near x (reference (record s i)) (allowance (record s i)) v.
Proof.
  intros [B P X Q _] S H E R. assert (U := used _ _ _ S v H). assert (D := half_not_reached _ _ P (proj2 U) R).
  left. destruct (expires _ _ _ S v H) as [T|T]; [|lra]. rewrite <- E. generalize (path _ _ _ S v H). lra.
Qed.

(* A point that passes, or did not move. *)
Lemma untested_near s x i c v : fine s v -> good s (moving s) (fun _ => False) i c -> In v (points c) -> valid (x v) ->
  passes s x v = true \/ x v = moving s v -> near x (reference (record s i)) (allowance (record s i)) v.
Proof.
  intros F [S C _ T] H X [P|P].
  - unfold passes in P. apply orb_true_iff in P. destruct P as [P|P].
    + destruct (T v H) as [[]|K]. specialize (K (x v) X P). left.
      assert (D := dist_nonneg (fixed (at_ s v)) (x v)). destruct (expires _ _ _ S v H) as [E|E]; [|lra].
      generalize (path _ _ _ S v H) (dist_triangle (reference (record s i) v) (fixed (at_ s v)) (x v)). lra.
    + apply same_position_right in P. unfold near. rewrite P. exact (proj2 (C v H)).
  - unfold near. rewrite P. exact (proj1 (C v H)).
Qed.

(* ---- Anchoring ---- *)

Lemma begin_same s v : let o := at_ (begin_anchoring s) v in
  fixed o = fixed (at_ s v) /\ base o = base (at_ s v) /\ room o = room (at_ s v) /\ listing o = listing (at_ s v).
Proof. unfold begin_anchoring. simpl. now destruct (epoch s =? stamps)%Z. Qed.

Lemma begin_fine s : (forall v, fine s v) -> forall v, fine (begin_anchoring s) v /\ ~ touched (begin_anchoring s) v.
Proof.
  intros F v. destruct (F v) as [B P X Q S]. generalize stamps_pos. intro E. unfold touched, begin_anchoring.
  split; [split|]; simpl; destruct (epoch s =? stamps)%Z; simpl; trivial; lia.
Qed.

Lemma begin_good s x open i c : good s x open i c -> good (begin_anchoring s) x open i c.
Proof.
  intros [[I S E P X] C K T]. assert (B := begin_same s). cbv zeta in B.
  split; [split|..]; trivial; try (intros v H; destruct (B v) as (B1 & B2 & B3 & B4)); change (record (begin_anchoring s)) with (record s).
  - rewrite B1, B2. now apply P.
  - rewrite B2. now apply X.
  - unfold near, fixed_of. rewrite B1. now apply C.
  - rewrite B4. now apply K.
  - unfold protects. rewrite B1, B2, B3. now apply T.
Qed.

Lemma anchors x l : Valid x -> forall s, (forall v, fine s v) -> let t := fold_left (anchor x) l s in
  advance x (fun _ => False) s t /\ (forall v, In v l \/ touched s v -> touched t v) /\ forall v, In v l \/ at_ t v = at_ s v.
Proof.
  intro X. induction l as [|v l IH]; intros s F; simpl.
  - split; [now apply advance_refl|]. split; [intros v [[]|H]; exact H|now right].
  - assert (A := anchor_advance x s v F X). destruct (IH _ (all_fine _ _ _ _ A)) as (B & C & D).
    split; [now apply advance_trans with (1 := A)|split].
    + intros w [[<-|H]|H]; apply C; [right; apply anchor_touched|now left|right]. now apply advance_touched with (1 := A).
    + intro w. destruct (D w) as [H|H]; [left; now right|]. destruct (same_vertex v w) as [<-|N]; [left; now left|right].
      rewrite H. unfold anchor. destruct (_ =? _)%Z; [reflexivity|]. simpl. now rewrite set_other by congruence.
Qed.

(* ---- Looking ---- *)

Section looking.
Variables (t : state) (v : vertex).
Hypothesis T : forall i c, mesh t i = Some c -> is_id i /\ forall w, In w (points c) -> in_use (expiry (record t i) w).
Let now := half (base (at_ t v)).

Definition accounted (found : expiry_list * list Z) (i : Z) : Prop :=
  In i (snd found) \/ ((now < expiry (record t i) v)%Z /\ kept (fst found) i (expiry (record t i) v)).

Lemma check_expiry_form found i : proper capacity (fst found) -> proper capacity (fst (check_expiry t v found i)) /\
  (rest (fst (check_expiry t v found i)) <= rest (fst found))%Z.
Proof.
  destruct found as [l S]. intro P. unfold check_expiry. destruct (has t i v) eqn:H; cbn [negb]; [|split; [exact P|lia]].
  destruct (is_expired t i v); cbn [fst]; [split; [exact P|lia]|]. unfold has in H. destruct (mesh t i) as [c|] eqn:M; [|discriminate].
  destruct (in_dec _ _ _) as [V|]; [|discriminate]. destruct (T i c M) as [I U]. split.
  - apply put_proper; [exact I|now apply U|exact P].
  - unfold put. destruct (orb _ _); [unfold put_new; destruct (exchange _ _); simpl; lia|lia].
Qed.

Lemma check_expiry_accounts found i j c : mesh t j = Some c -> In v (points c) -> i = j \/ accounted found j -> accounted (check_expiry t v found i) j.
Proof.
  intros M V. destruct found as [l S]. destruct (has_spec t j c v M) as [_ Hs]. specialize (Hs V). destruct (T j c M) as [I U].
  unfold check_expiry. intro K. destruct (Z.eq_dec i j) as [->|D].
  - rewrite Hs. cbn [negb]. destruct (is_expired t j v) eqn:E; [left; now left|right].
    unfold is_expired in E. rewrite Hs in E. apply Z.leb_gt in E. split; [exact E|]. apply put_kept; [exact I|right; split; [reflexivity|lia]].
  - destruct K as [K|K]; [contradiction|]. destruct (has t i v) eqn:H; cbn [negb]; [|exact K].
    destruct (is_expired t i v); destruct K as [K|[K Q]]; [left; now right|right; now split|now left|right]. split; [exact K|].
    unfold has in H. destruct (mesh t i) as [d|] eqn:Mi; [|discriminate]. apply put_kept; [exact (proj1 (T i d Mi))|left; split; [congruence|exact Q]].
Qed.

Lemma check_expiries ids : forall found, proper capacity (fst found) -> let f := fold_left (check_expiry t v) ids found in
  proper capacity (fst f) /\ (rest (fst f) <= rest (fst found))%Z /\
  forall j c, mesh t j = Some c -> In v (points c) -> In j ids \/ accounted found j -> accounted f j.
Proof.
  induction ids as [|i ids IH]; intros found P; simpl.
  - split; [exact P|split; [lia|]]. intros j c _ _ [[]|H]. exact H.
  - destruct (check_expiry_form found i P) as [Q R]. destruct (IH _ Q) as (A & B & C). split; [exact A|split; [lia|]].
    intros j c M V H. apply C with c; trivial. destruct H as [[<-|H]|H]; [right; apply check_expiry_accounts with c; trivial; now left|now left|right].
    apply check_expiry_accounts with c; trivial. now right.
Qed.

Lemma partition_filter {A} (f : A -> bool) l : partition f l = (filter f l, filter (fun a => negb (f a)) l).
Proof. induction l as [|a l IH]; simpl; [reflexivity|]. rewrite IH. now destruct (f a). Qed.

Lemma visit_star_accounts found : proper capacity (fst (visit_star t v found)) /\
  forall j c, mesh t j = Some c -> In v (points c) -> accounted (visit_star t v found) j.
Proof.
  unfold visit_star. rewrite partition_filter.
  set (expired := filter _ _). set (others := filter (fun i => negb _) _).
  destruct (check_expiries expired (cleared capacity, snd found)) as (A & _ & B); [apply cleared_proper|].
  destruct (fold_left _ expired _) as [l' S']. cbn [fst] in A.
  assert (Ids : forall y, In y (map (fun i => (own t v i, i)) others) -> is_id (snd y) /\ (0 <= fst y <= never)%Z).
  { intros y H. apply in_map_iff in H. destruct H as (i & <- & H). apply filter_In in H. destruct H as [H _]. simpl.
    split; [exact (around_ids _ _ _ H)|]. unfold own, has. destruct (mesh t i) as [c|] eqn:M; [|unfold never; lia].
    destruct (in_dec _ _ _) as [V|]; [|unfold never; lia]. now apply (T i c M). }
  split.
  - simpl. now apply put_many_proper.
  - intros j c M V. assert (R := around_all _ _ _ _ (fun i d Mi => proj1 (T i d Mi)) M V). destruct (has_spec t j c v M) as [_ Hs]. destruct (is_expired t j v) eqn:E.
    + destruct (B j c M V) as [K|[K K']]; [left; now apply filter_In|now left|]. right. split; [exact K|].
      simpl. apply put_many_kept; [intros y H; now apply Ids|now left].
    + right. split; [unfold is_expired in E; rewrite (Hs V) in E; now apply Z.leb_gt in E|].
      simpl. apply put_many_kept; [intros y H; now apply Ids|right]. exists (own t v j, j). split; [|split; [reflexivity|]].
      * apply in_map_iff. exists j. split; [reflexivity|]. apply filter_In. now rewrite E.
      * unfold own. rewrite (Hs V). simpl. lia.
Qed.

Theorem examine_accounts : proper capacity (listing (at_ t v)) -> proper capacity (fst (examine t v)) /\
  forall j c, mesh t j = Some c -> In v (points c) -> kept (listing (at_ t v)) j (expiry (record t j) v) -> accounted (examine t v) j.
Proof.
  intro P. unfold examine. fold now. destruct (rest (listing (at_ t v)) <=? now)%Z eqn:R0.
  { destruct (visit_star_accounts (listing (at_ t v), [])) as [D1 D2]. split; [exact D1|]. intros j c M V _. now apply D2 with c. }
  assert (Tp := take_proper capacity now _ P).
  assert (K := fun j own => take_kept capacity now (listing (at_ t v)) j own P).
  assert (Fd := fun j own => take_finds capacity now (listing (at_ t v)) j own P).
  destruct (take now (listing (at_ t v))) as [visited l] eqn:E. cbn [fst snd] in *.
  assert (Re : rest l = rest (listing (at_ t v))) by (unfold take in E; inversion E; reflexivity).
  destruct (check_expiries visited (l, []) Tp) as (A & B & C).
  set (found := fold_left _ visited _) in *. cbn [fst] in B. destruct (rest (fst found) <=? now)%Z eqn:R.
  - destruct (visit_star_accounts found) as [D1 D2]. split; [exact D1|]. intros j c M V _. now apply D2 with c.
  - apply Z.leb_gt in R. split; [exact A|]. intros j c M V H. apply C with c; trivial. destruct (T j c M) as [I U].
    destruct (Z.le_gt_cases (expiry (record t j) v) now) as [L'|G].
    + destruct (Fd j _ I (proj2 (U v V)) H L') as [Q|Q]; [now left|lia].
    + destruct (K j _ H) as [Q|Q]; [now left|]. right. right. split; [lia|exact Q].
Qed.
End looking.
End look.
