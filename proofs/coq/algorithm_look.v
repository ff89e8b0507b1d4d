(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Between steps, and the first half of a step (algorithm_filter.v; src/annulus/engine/odometers_expired.cpp).

   - invariant, holds_everywhere   every certificate is good, hence holds
   - unreached_near    a point whose reading has not reached its expiry is near the reference of the record; overdue and clipped expiries
                       are reached by any reading
   - untested_near     a point that passes the test of a step is near
   - anchors           vertices that failed are anchored
   - second_look_right, second_look_promised    what second looks have to find out, and what follows
   - examine_settles   of a vertex that was looked at every certificate is a suspect, renewed, or not reached and listed *)
Require Import Reals Lra Lia ZArith List Bool.
From Annulus Require Import algorithm_listed high_word algorithm_filter algorithm_keep algorithm_commit algorithm_rebase.
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

(* A point whose reading has not reached its expiry: clipped and overdue expiries are reached by any reading. *)
Theorem unreached_near s x i c v : fine s v -> valid (x v) -> sane s i c -> In v (points c) ->
  (half (reading s v (x v)) < expiry (record s i) v)%Z -> near x (reference (record s i)) (allowance (record s i)) v.
Proof.
  intros [B P X Q _] Y S H R. destruct (reading_above _ _ _ B P X Y) as [_ A]. fold (reading s v (x v)) in A.
  assert (D := dist_nonneg (fixed (at_ s v)) (x v)). assert (U := used _ _ _ S v H).
  assert (E := half_not_reached (reading s v (x v)) _ ltac:(lra) (proj2 U) R).
  left. destruct (expires _ _ _ S v H) as [T|T]; [|lra].
  generalize (path _ _ _ S v H) (dist_triangle (reference (record s i) v) (fixed (at_ s v)) (x v)). lra.
Qed.

(* The same after anchoring, where the base is the reading. *)
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
  intros [[I S U E P X] C K T]. assert (B := begin_same s). cbv zeta in B.
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

Variable second_look : state -> placement -> Z -> option renewal.
Definition second_look_right : Prop := forall s x i c k, (forall v, fine s v) -> Valid x -> mesh s i = Some c -> second_look s x i = Some k ->
  two_sided c = true /\
  match k with
  | unequal new allowed => chosen = unequal_moves /\ 0 < tolerance (record s i) /\
      (forall v, In v (points c) -> reading s v (x v) < value (half (new v)) /\
         new v <= value (expiry (record s i) v) - tolerance (record s i) + allowed v) /\
      (forall v w, In v (points c) -> In w (points c) -> inside c v = true -> inside c w = false ->
         allowed v + allowed w <= 2 * tolerance (record s i))
  | safe far => chosen = safe_region /\ sound c x (fun v => far v) /\ forall v, In v (points c) -> 0 <= far v /\ number (far v)
  end.
(* Unequal moves (docs/theory.md 5.3): the sides have come `inner` and `outer` from where the expiries say the points were, and share what is left
   of the width. That new expiries are not reached is asked of each point, so soundness does not hang on how these two were computed. *)
Definition shares (c : certificate) (t inner outer : R) (v : vertex) : R :=
  (if inside c v then inner else outer) + (2 * t - (inner + outer)) / 2.
Theorem unequal_moves_right s x i c t new inner outer : t = real (tolerance (record s i)) ->
  (forall v, In v (points c) -> reading s v (x v) < value (half (new v))) ->
  (forall v, In v (points c) -> new v <= value (expiry (record s i) v) - t + shares c t inner outer v) ->
  (forall v, In v (points c) -> reading s v (x v) < value (half (new v)) /\
    new v <= value (expiry (record s i) v) - tolerance (record s i) + shares c t inner outer v) /\
  (forall v w, In v (points c) -> In w (points c) -> inside c v = true -> inside c w = false ->
    shares c t inner outer v + shares c t inner outer w <= 2 * tolerance (record s i)).
Proof.
  intros -> P Q. split; [intros v V; split; [now apply P|now apply Q]|]. intros v w _ _ I I'. unfold shares. rewrite I, I'. lra.
Qed.

Hypothesis second_look_sound : second_look_right.

Lemma second_look_promised s x i c k : (forall v, fine s v) -> Valid x -> mesh s i = Some c -> sane s i c -> second_look s x i = Some k ->
  promised s x (i, c, k).
Proof.
  intros F X M S K. assert (H := second_look_sound s x i c k F X M K). destruct H as [Two H]. split; [exact Two|]. destruct k as [new allowed|far].
  - destruct H as (Mode & T & P & Q). destruct (shared _ _ _ S Mode Two T) as [Wide Infer].
    assert (N : forall v, In v (points c) -> value (half (new v)) <= origin (record s i) v + allowed v /\
      dist (reference (record s i) v) (x v) < allowed v /\ dist (reference (record s i) v) (fixed (at_ s v)) < allowed v).
    { intros v V. destruct (P v V) as [P1 P2]. destruct (F v) as [B B0 Y _ _]. destruct (reading_above _ _ _ B B0 Y (X v)) as [_ A].
      fold (reading s v (x v)) in A. assert (D := dist_nonneg (fixed (at_ s v)) (x v)).
      assert (Z : value (half (new v)) <= new v).
      { destruct (Rlt_le_dec 0 (new v)) as [Pos|Neg]; [apply half_below; lra|]. rewrite half_clips, value_0 in P1 by exact Neg. lra. }
      generalize (Infer v V) (path _ _ _ S v V) (dist_triangle (reference (record s i) v) (fixed (at_ s v)) (x v)). lra. }
    split.
    + apply Wide; [|exact Q]. intros v V. destruct (N v V) as (_ & N1 & _). generalize (dist_nonneg (reference (record s i) v) (x v)). lra.
    + intros v V. destruct (N v V) as (N1 & N2 & N3). split; [exact N1|]. split; [exact (path _ _ _ S v V)|]. split; now left.
  - destruct H as (Mode & H). split; [now rewrite Mode|exact H].
Qed.

Section looking.
Variables (t : state) (x : placement) (v : vertex).
Hypothesis T : forall i c, mesh t i = Some c -> is_id i /\ forall w, In w (points c) -> in_use (expiry (record t i) w).
Let now := half (base (at_ t v)).

Definition settled (found : expiry_list * list Z * renewals) (i : Z) (c : certificate) : Prop :=
  In i (snd (fst found)) \/ (exists k, In (i, c, k) (snd found)) \/
  ((now < expiry (record t i) v)%Z /\ kept (fst (fst found)) i (expiry (record t i) v)).
Definition in_form (found : expiry_list * list Z * renewals) : Prop :=
  proper capacity (fst (fst found)) /\ forall i c k, In (i, c, k) (snd found) -> mesh t i = Some c /\ second_look t x i = Some k.

Lemma look_at_form found i : in_form found -> in_form (look_at second_look t x v found i) /\
  (rest (fst (fst (look_at second_look t x v found i))) <= rest (fst (fst found)))%Z.
Proof.
  destruct found as [[l S] N]. intros [P Q]. unfold look_at.
  assert (Rest : forall e, (rest (put i e l) <= rest l)%Z).
  { intro e. unfold put. destruct (orb _ _); [unfold put_new; destruct (exchange _ _); simpl; lia|lia]. }
  destruct (mesh t i) as [c|] eqn:M; [|now split]. destruct (has t i v) eqn:H; simpl; [|now split].
  destruct (T i c M) as [I U]. assert (V : In v (points c)) by (now apply (has_spec t i c v M)).
  destruct (is_expired t i v); simpl.
  - destruct (second_look t x i) as [k|] eqn:K; [|split; [now split|simpl; lia]]. split; [split|apply Rest]; simpl.
    + apply put_proper; [exact I| |exact P]. destruct k; apply half_range.
    + intros j d h [E|E]; [|now apply Q]. inversion E; subst. now split.
  - split; [split; [|exact Q]|apply Rest]. simpl. apply put_proper; [exact I|now apply U|exact P].
Qed.

Lemma look_at_settles found i j c : mesh t j = Some c -> In v (points c) -> i = j \/ settled found j c ->
  settled (look_at second_look t x v found i) j c.
Proof.
  intros M V. destruct found as [[l S] N]. unfold look_at. intros [->|K].
  - rewrite M. destruct (has_spec t j c v M) as [_ Hs]. rewrite (Hs V). cbn [negb]. destruct (T j c M) as [I U].
    destruct (is_expired t j v) eqn:E; cbn [negb].
    + destruct (second_look t x j) as [k|]; [right; left; exists k; now left|left; now left].
    + right. right. unfold is_expired in E. rewrite (Hs V) in E. apply Z.leb_gt in E. split; [exact E|].
      apply put_kept; [exact I|right; split; [reflexivity|lia]].
  - destruct (mesh t i) as [d|] eqn:Mi; [|exact K]. destruct (has t i v) eqn:H; cbn [negb]; [|exact K]. destruct (T i d Mi) as [I U].
    destruct (Z.eq_dec i j) as [->|D].
    + (* looked at again *)
      rewrite M in Mi. inversion Mi; subst d. destruct (is_expired t j v) eqn:E; cbn [negb].
      * destruct (second_look t x j) as [k|]; [right; left; exists k; now left|left; now left].
      * right. right. unfold is_expired in E. rewrite H in E. apply Z.leb_gt in E. split; [exact E|].
        apply put_kept; [exact I|right; split; [reflexivity|lia]].
    + assert (P : forall e, kept l j (expiry (record t j) v) -> kept (put i e l) j (expiry (record t j) v)).
      { intros e Q. apply put_kept; [exact I|left; split; [congruence|exact Q]]. }
      destruct K as [K|[(k & K)|[K Q]]]; destruct (is_expired t i v); cbn [negb]; try destruct (second_look t x i) as [h|];
        unfold settled; simpl; simpl in K; try (left; tauto); try (right; left; exists k; tauto); right; right; (split; [exact K|]); try apply P; exact Q.
Qed.

Lemma looks ids : forall found, in_form found -> let f := fold_left (look_at second_look t x v) ids found in
  in_form f /\ (rest (fst (fst f)) <= rest (fst (fst found)))%Z /\
  forall j c, mesh t j = Some c -> In v (points c) -> In j ids \/ settled found j c -> settled f j c.
Proof.
  induction ids as [|i ids IH]; intros found P; simpl.
  - split; [exact P|split; [lia|]]. intros j c _ _ [[]|H]. exact H.
  - destruct (look_at_form found i P) as [Q R]. destruct (IH _ Q) as (A & B & C). split; [exact A|split; [lia|]].
    intros j c M V H. apply C; trivial. destruct H as [[<-|H]|H]; [right; apply look_at_settles; trivial; now left|now left|right].
    apply look_at_settles; trivial. now right.
Qed.

Lemma partition_filter {A} (f : A -> bool) l : partition f l = (filter f l, filter (fun a => negb (f a)) l).
Proof. induction l as [|a l IH]; simpl; [reflexivity|]. rewrite IH. now destruct (f a). Qed.

Lemma tour_settles found : in_form found -> in_form (tour second_look t x v found) /\
  forall j c, mesh t j = Some c -> In v (points c) -> settled (tour second_look t x v found) j c.
Proof.
  destruct found as [[l S] N]. intros [P Q]. unfold tour. rewrite partition_filter.
  set (expired := filter _ _). set (others := filter (fun i => negb _) _).
  destruct (looks expired (cleared capacity, S, N)) as (A & _ & B); [split; [apply cleared_proper|exact Q]|].
  destruct (fold_left _ expired _) as [[l' S'] N']. destruct A as [A1 A2]. simpl in A1, A2.
  assert (Ids : forall y, In y (map (fun i => (own t v i, i)) others) -> is_id (snd y) /\ (0 <= fst y <= never)%Z).
  { intros y H. apply in_map_iff in H. destruct H as (i & <- & H). apply filter_In in H. destruct H as [H _]. simpl.
    split; [exact (around_ids _ _ _ H)|]. unfold own, has. destruct (mesh t i) as [c|] eqn:M; [|unfold never; lia].
    destruct (in_dec _ _ _) as [V|]; [|unfold never; lia]. now apply (T i c M). }
  split; [split|].
  - simpl. now apply put_many_proper.
  - exact A2.
  - intros j c M V. assert (R := around_all _ _ _ _ (fun i d Mi => proj1 (T i d Mi)) M V). destruct (has_spec t j c v M) as [_ Hs]. destruct (is_expired t j v) eqn:E.
    + destruct (B j c M V) as [K|[K|[K K']]]; [left; now apply filter_In|now left|right; now left|]. right. right. split; [exact K|].
      simpl. apply put_many_kept; [intros y H; now apply Ids|now left].
    + right. right. split; [unfold is_expired in E; rewrite (Hs V) in E; now apply Z.leb_gt in E|].
      simpl. apply put_many_kept; [intros y H; now apply Ids|right]. exists (own t v j, j). split; [|split; [reflexivity|]].
      * apply in_map_iff. exists j. split; [reflexivity|]. apply filter_In. now rewrite E.
      * unfold own. rewrite (Hs V). simpl. lia.
Qed.

Theorem examine_settles : proper capacity (listing (at_ t v)) -> in_form (examine second_look t x v) /\
  forall j c, mesh t j = Some c -> In v (points c) -> kept (listing (at_ t v)) j (expiry (record t j) v) ->
    settled (examine second_look t x v) j c.
Proof.
  intro P. unfold examine. fold now. destruct (rest (listing (at_ t v)) <=? now)%Z eqn:R0.
  { destruct (tour_settles (listing (at_ t v), [], [])) as [D1 D2]; [split; [exact P|intros i c k []]|].
    split; [exact D1|]. intros j c M V _. now apply D2. }
  assert (Tp := take_proper capacity now _ P).
  assert (K := fun j own => take_kept capacity now (listing (at_ t v)) j own P).
  assert (Fd := fun j own => take_finds capacity now (listing (at_ t v)) j own P).
  destruct (take now (listing (at_ t v))) as [visited l] eqn:E. cbn [fst snd] in *.
  assert (Re : rest l = rest (listing (at_ t v))) by (unfold take in E; inversion E; reflexivity).
  destruct (looks visited (l, [], [])) as (A & B & C); [split; [exact Tp|intros i c k []]|].
  set (found := fold_left _ visited _) in *. cbn [fst] in B. destruct (rest (fst (fst found)) <=? now)%Z eqn:R.
  - destruct (tour_settles found A) as [D1 D2]. split; [exact D1|]. intros j c M V _. now apply D2.
  - apply Z.leb_gt in R. split; [exact A|]. intros j c M V H. apply C; trivial. destruct (T j c M) as [I U].
    destruct (Z.le_gt_cases (expiry (record t j) v) now) as [L'|G].
    + destruct (Fd j _ I (proj2 (U v V)) H L') as [Q|Q]; [now left|lia].
    + destruct (K j _ H) as [Q|Q]; [now left|]. right. right. right. split; [lia|exact Q].
Qed.
End looking.
End look.
