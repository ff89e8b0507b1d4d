(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Any sequence of calls of `filter`: steps of all vertices or of one, calls that fail, insertions and removals, tolerance_recomputations, steps without tolerances.

   - recompute_keeps, place_keeps, pass_keeps, undo_keeps      what algorithm_step.v leaves out
   - call           what one call may be, as a relation: what Repair and the caller may choose is left free
   - filter_is_right   after any calls every certificate of the mesh holds at the moving positions

   With one vertex as mover a step is one of `filter-each` (move_one): the others are where they were. *)
Require Import Reals Lra Lia ZArith List Bool.
From Annulus Require Import algorithm_listed truncated_double algorithm_filter algorithm_keep algorithm_commit algorithm_check algorithm_step.
Import ListNotations.
Open Scope R_scope.

Section run.
Context {W : world} {L : laws}.
Notation Valid x := (forall v, valid (x v)).

(* States that agree point by point. *)
Lemma invariant_same s t : (forall v, at_ t v = at_ s v) -> (forall v, moving t v = moving s v) -> (forall i, mesh t i = mesh s i) ->
  (forall i, record t i = record s i) -> epoch t = epoch s -> invariant s -> invariant t.
Proof.
  intros A M I R E [F V G C]. split.
  - intro v. destruct (F v) as [F1 F2 F3 F4 F5]. split; rewrite ?A, ?E; trivial.
  - intro v. now rewrite M.
  - intros i c H. rewrite I in H. destruct (G i c H) as [[G1 G2 G4 G5 G6] G7 G8 G9].
    split; [split|..]; rewrite ?R; trivial; intros v Hv; rewrite ?R, ?A; auto.
    unfold near, fixed_of. rewrite A, M. exact (G7 v Hv).
  - intros i c d H D. rewrite I in H. destruct (C i c d H D) as [j J]. exists j. now rewrite I.
Qed.

(* All pass: nothing but positions changes. *)
Theorem pass_keeps s x movers : invariant s -> Valid x -> (forall v, In v movers \/ x v = moving s v) -> find_failed s x movers = [] ->
  invariant (move_to x s).
Proof.
  intros V X M N. destruct (V) as [F _ G C]. split; trivial.
  - intro v. destruct (F v). now split.
  - intros i c H. destruct (G i c H) as [S Cl K T]. split; [|clear Cl|exact K|exact T].
    + destruct S. now split.
    + intros v Hv. split; [|exact (proj2 (is_close _ _ _ _ _ (G i c H) v Hv))].
      apply (untested_near s x i c v); trivial; [now apply G|]. destruct (M v) as [Mv|Mv]; [left|now right].
      destruct (passes s x v) eqn:P; [reflexivity|exfalso]. assert (Q : In v (find_failed s x movers)).
      { apply filter_In. now rewrite P. }
      rewrite N in Q. destruct Q.
Qed.

Lemma failed_or_not s x movers : (forall v, In v movers \/ x v = moving s v) ->
  forall v, In v (find_failed s x movers) \/ passes s x v = true \/ x v = moving s v.
Proof.
  intros M v. destruct (M v) as [Mv|Mv]; [|right; now right]. destruct (passes s x v) eqn:P; [right; now left|left].
  apply filter_In. now rewrite P.
Qed.

Theorem undo_keeps s x movers : invariant s -> Valid x -> (forall v, In v movers \/ x v = moving s v) ->
  let failed := find_failed s x movers in
  invariant (undo_anchoring (begin_anchoring s) (fst (find_expired s x failed)) failed).
Proof.
  intros V X M failed. destruct (undone_else s x failed V X) as (E1 & E2 & E3 & E4).
  apply (invariant_same (begin_anchoring s)).
  - apply undone; trivial.
  - intro v. now rewrite E1.
  - intro i. now rewrite E2.
  - intro i. now rewrite E4.
  - exact E3.
  - destruct V as [F Y G C]. split; trivial.
    + intro v. now apply begin_fine.
    + intros i c H. now apply begin_good, G.
Qed.

(* A vertex that is in no certificate yet. *)
Theorem place_keeps s v p : invariant s -> valid p -> (forall i c, mesh s i = Some c -> ~ In v (points c)) -> invariant (place s (v, p)).
Proof.
  intros [F Y G C] P N.
  assert (A : forall w, w <> v -> at_ (place s (v, p)) w = at_ s w /\ moving (place s (v, p)) w = moving s w).
  { intros w D. simpl. now rewrite !set_other by congruence. }
  split; trivial.
  - intro w. destruct (F w) as [F1 F2 F3 F4 F5]. destruct (same_vertex v w) as [<-|D].
    + split; simpl; rewrite set_same; simpl; trivial. apply cleared_proper.
    + destruct (A w) as [A1 _]; [congruence|]. split; rewrite ?A1; trivial.
  - intro w. simpl. unfold set. destruct (same_vertex v w); [exact P|apply Y].
  - intros i c H. assert (Q : forall w, In w (points c) -> w <> v) by (intros w Hw ->; exact (N i c H Hw)).
    destruct (G i c H) as [[G1 G2 G4 G5 G6] G7 G8 G9].
    split; [split|..]; trivial; intros w Hw; destruct (A w (Q w Hw)) as [A1 A2]; rewrite ?A1; auto.
    unfold near, fixed_of. rewrite A1, A2. exact (G7 w Hw).
Qed.

Lemma places_keep l : forall s, invariant s -> (forall n, In n l -> valid (snd n)) -> (forall n i c, In n l -> mesh s i = Some c -> ~ In (fst n) (points c)) ->
  invariant (fold_left place l s) /\ mesh (fold_left place l s) = mesh s.
Proof.
  induction l as [|[v p] l IH]; intros s V P N; [now split|]. cbn [fold_left].
  destruct (IH (place s (v, p))) as [A B]; [|intros n H; apply P; now right|intros n i c H; apply (N n i c); now right|now split].
  apply place_keeps; [exact V|exact (P _ (or_introl eq_refl))|]. intros i c. exact (N (v, p) i c (or_introl eq_refl)).
Qed.

(* ---- Everything anew ---- *)

Lemma fresh_points i t l : is_id i -> forall s, (forall v, proper capacity (listing (at_ s v))) ->
  let u := fold_left (fresh_point i t) l s in
  moving u = moving s /\ mesh u = mesh s /\ record u = record s /\ epoch u = epoch s /\
  forall v, fixed (at_ u v) = fixed (at_ s v) /\ base (at_ u v) = base (at_ s v) /\ stamp (at_ u v) = stamp (at_ s v) /\
    proper capacity (listing (at_ u v)) /\
    (forall j own, kept (listing (at_ s v)) j own -> kept (listing (at_ u v)) j own) /\
    (In v l -> kept (listing (at_ u v)) i (half (sum_lower (base (at_ s v)) t))).
Proof.
  intro I. induction l as [|w l IH]; intros s P; cbn [fold_left].
  - split; [reflexivity|split; [reflexivity|split; [reflexivity|split; [reflexivity|]]]]. intro v.
    split; [reflexivity|split; [reflexivity|split; [reflexivity|split; [apply P|split; [trivial|intros []]]]]].
  - assert (One : forall v, let o := at_ (fresh_point i t s w) v in
      fixed o = fixed (at_ s v) /\ base o = base (at_ s v) /\ stamp o = stamp (at_ s v) /\ proper capacity (listing o) /\
      (forall j own, kept (listing (at_ s v)) j own -> kept (listing o) j own) /\
      (w = v -> kept (listing o) i (half (sum_lower (base (at_ s v)) t)))).
    { intro v. simpl. unfold set. destruct (same_vertex w v) as [<-|D]; simpl.
      - split; [reflexivity|split; [reflexivity|split; [reflexivity|split; [|split]]]].
        + apply put_new_proper; [exact I|apply half_range|apply P].
        + intros j own K. apply put_new_kept; [exact I|now left].
        + intros _. apply put_new_kept; [exact I|right]. split; [reflexivity|lia].
      - split; [reflexivity|split; [reflexivity|split; [reflexivity|split; [apply P|split; [trivial|contradiction]]]]]. }
    destruct (IH (fresh_point i t s w)) as (A & B & C & D & E); [intro v; apply One|].
    split; [exact A|split; [exact B|split; [exact C|split; [exact D|]]]]. intro v.
    destruct (One v) as (O1 & O2 & O3 & O4 & O5 & O6). destruct (E v) as (E1 & E2 & E3 & E4 & E5 & E6). rewrite O2 in *.
    split; [congruence|split; [congruence|split; [congruence|split; [exact E4|split]]]].
    + intros j own K. now apply E5, O5.
    + intros [->|H]; [apply E5; now apply O6|now apply E6].
Qed.

(* Good, but for the thresholds, which come last. *)
Definition open : vertex -> Prop := fun _ => True.

Lemma write_fresh_good x s k : (forall v, fine s v) -> (forall v, fixed (at_ s v) = x v) -> is_id (id k) -> evaluated x k ->
  let t := write_fresh x s k in
  moving t = moving s /\ mesh t = mesh s /\ epoch t = epoch s /\ (forall v, fine t v) /\ (forall v, fixed (at_ t v) = x v) /\
  good t x open (id k) (of k) /\ forall i c, i <> id k -> good s x open i c -> good t x open i c.
Proof.
  intros F X I [B1 B3 B4]. unfold write_fresh, set_written.
  destruct (fresh_points (id k) (bound k) (points (of k)) I s (fun v => list_proper _ _ (F v))) as (E1 & E2 & E3 & E4 & P).
  set (u := fold_left _ _ s) in *. set (r := {| expiry := _ |}).
  assert (Rec : record (set_record u (id k) r) (id k) = r) by (simpl; apply set_same).
  split; [exact E1|split; [exact E2|split; [exact E4|]]]. split; [|split; [intro v; destruct (P v) as (P1 & _); simpl; now rewrite P1|split]].
  - intro v. destruct (P v) as (P1 & P2 & P3 & P4 & _), (F v) as [F1 F2 F3 F4 F5].
    split; simpl; rewrite ?P1, ?P2, ?P3, ?E4; trivial.
  - assert (V : forall v, value (expiry r v) <= base (at_ u v) + bound k).
    { intro v. simpl. destruct (P v) as (_ & -> & _), (F v). now apply half_of_sum. }
    split; [split|..]; rewrite ?Rec; trivial.
    + intros v _. apply half_range.
    + intros v _. simpl. destruct (P v) as (-> & _). rewrite X, dist_zero. lra.
    + intros v _. left. exact (V v).
    + intros v _. rewrite Rec. split; right; [reflexivity|]. unfold fixed_of. simpl. destruct (P v) as (-> & _). now rewrite X.
    + intros v H. rewrite Rec. simpl. destruct (P v) as (_ & -> & _ & _ & _ & K). now apply K.
    + intros v _. now left.
  - intros i c N [[G1 G2 G4 G5 G6] G7 G8 G9].
    assert (R : record (set_record u (id k) r) i = record s i) by (simpl; rewrite set_other, E3 by congruence; reflexivity).
    split; [split|..]; rewrite ?R; trivial.
    + intros v H. simpl. destruct (P v) as (-> & -> & _). now apply G5.
    + intros v H. simpl. destruct (P v) as (_ & -> & _). now apply G6.
    + intros v H. rewrite R. unfold near, fixed_of. simpl. destruct (P v) as (-> & _). now apply G7.
    + intros v H. rewrite R. simpl. destruct (P v) as (_ & _ & _ & _ & K & _). now apply K, G8.
    + intros v _. now left.
Qed.

Lemma write_all x l : forall s, (forall v, fine s v) -> (forall v, fixed (at_ s v) = x v) ->
  (forall k, In k l -> is_id (id k) /\ mesh s (id k) = Some (of k) /\ evaluated x k) ->
  (forall i c, mesh s i = Some c -> In i (map id l) \/ good s x open i c) ->
  let t := fold_left (write_fresh x) l s in
  mesh t = mesh s /\ epoch t = epoch s /\ (forall v, fine t v) /\ forall i c, mesh t i = Some c -> good t x open i c.
Proof.
  induction l as [|k l IH]; intros s F X P G; cbn [fold_left].
  - split; [reflexivity|split; [reflexivity|split; [exact F|]]]. intros i c H. destruct (G i c H) as [[]|Q]. exact Q.
  - destruct (P k (or_introl eq_refl)) as (I & M & B). destruct (write_fresh_good x s k F X I B) as (_ & E2 & E3 & F' & X' & Gk & Go).
    rewrite <- E2, <- E3. apply IH; trivial.
    + intros h H. rewrite E2. apply P. now right.
    + intros i c H. rewrite E2 in H. destruct (Z.eq_dec i (id k)) as [->|N].
      * right. rewrite M in H. inversion H. now subst.
      * destruct (G i c H) as [[E|E]|E]; [congruence|now left|right; now apply Go].
Qed.

Definition recomputed_by (x : placement) (m : Z -> option certificate) (verdicts : list verdict) : Prop :=
  repaired x (fun _ => None) m [] verdicts.

Theorem recompute_keeps x s m verdicts : (forall v : vertex, (0 <= epoch s)%Z) -> Valid x -> recomputed_by x m verdicts ->
  invariant (recompute x s m verdicts) /\ mesh (recompute x s m verdicts) = m.
Proof.
  intros E X [Right Rest Ids Counted]. unfold recompute.
  set (s0 := {| moving := x; mesh := m; record := record s; epoch := epoch s; anchored := []; at_ := _ |}).
  destruct (write_all x verdicts s0) as (M & E' & F & G).
  - intro v. split; simpl; [apply number_zero|rewrite real_zero; lra|apply X|apply cleared_proper|]. generalize (E v). lia.
  - reflexivity.
  - intros k H. destruct (Right k H) as [R1 R2]. split; [exact (Ids _ _ R1)|now split].
  - intros i c H. left. destruct (Rest i c H) as [Q|(Q & _)]; [exact Q|discriminate].
  - set (t := fold_left _ verdicts s0) in *. cbv zeta. split; [|exact M].
    split; trivial.
    + intro v. destruct (F v). now split.
    + intros i c H. destruct (G i c H) as [[G1 G2 G4 G5 G6] G7 G8 G9]. split; [now split|exact G7|exact G8|].
      intros v Hv. right. simpl. apply set_room_protects with i; [apply F|now apply G4|now apply G8].
    + intros i c d H. simpl in *. rewrite M in *. now apply (Counted i c d).
Qed.

(* ---- Calls ---- *)

(* With tolerances or without. *)
Record system := { of_filter : state; tracks : bool }.

Definition untracked_right (s : state) : Prop :=
  Valid (moving s) /\ (forall v : vertex, (0 <= epoch s)%Z) /\
  (forall i c d, mesh s i = Some c -> counts_on d c -> exists j, mesh s j = Some d) /\ forall i c, mesh s i = Some c -> holds c (moving s).
Definition right (y : system) : Prop := if tracks y then invariant (of_filter y) else untracked_right (of_filter y).

Definition covered (s : state) (x : placement) (movers : list vertex) : Prop := forall v, In v movers \/ x v = moving s v.
Definition stepped s x failed m verdicts : state :=
  commit x (fst (find_expired s x failed)) m verdicts.

Inductive call : system -> system -> Prop :=
  (* move_all, move: all vertices pass; some vertex fails; Repair fails *)
  | passed s x movers : Valid x -> covered s x movers -> find_failed s x movers = [] ->
      call {| of_filter := s; tracks := true |} {| of_filter := move_to x s; tracks := true |}
  | processed s x movers m verdicts : Valid x -> covered s x movers ->
      (let (u, pending) := find_expired s x (find_failed s x movers) in repaired x (mesh u) m pending verdicts) ->
      call {| of_filter := s; tracks := true |}
        {| of_filter := stepped s x (find_failed s x movers) m verdicts; tracks := true |}
  | failing s x movers : Valid x -> covered s x movers ->
      call {| of_filter := s; tracks := true |}
        {| of_filter := undo_anchoring (begin_anchoring s) (fst (find_expired s x (find_failed s x movers))) (find_failed s x movers);
           tracks := true |}
  (* place, refresh: vertices are inserted or removed, or cells came back under other numbers; evaluated at the positions of all *)
  | refreshed s placed m verdicts : (forall n, In n placed -> valid (snd n)) ->
      (forall n i c, In n placed -> mesh s i = Some c -> ~ In (fst n) (points c)) ->
      (let t := fold_left place placed s in repaired (moving t) (mesh t) m [] verdicts) ->
      call {| of_filter := s; tracks := true |}
        {| of_filter := (let t := fold_left place placed s in stepped t (moving t) [] m verdicts); tracks := true |}
  | recomputes s b x m verdicts : Valid x -> recomputed_by x m verdicts ->
      call {| of_filter := s; tracks := b |} {| of_filter := recompute x s m verdicts; tracks := true |}
  (* Without tolerances: all certificates are evaluated, or those of the one vertex that moves *)
  | everything s b x m : Valid x -> (forall i c, m i = Some c -> holds c x) ->
      (forall i c d, m i = Some c -> counts_on d c -> exists j, m j = Some d) ->
      call {| of_filter := s; tracks := b |}
        {| of_filter := move_to x (with_mesh s m); tracks := false |}
  | star s x v m : Valid x -> (forall w, w = v \/ x w = moving s w) ->
      (forall i c, m i = Some c -> holds c x \/ (mesh s i = Some c /\ ~ In v (points c))) ->
      (forall i c d, m i = Some c -> counts_on d c -> exists j, m j = Some d) ->
      call {| of_filter := s; tracks := false |} {| of_filter := move_to x (with_mesh s m); tracks := false |}
  | stops s : call {| of_filter := s; tracks := true |} {| of_filter := s; tracks := false |}.

Lemma stepped_right s x failed m verdicts : invariant s -> Valid x ->
  (forall v, In v failed \/ passes s x v = true \/ x v = moving s v) ->
  (let (u, pending) := find_expired s x failed in repaired x (mesh u) m pending verdicts) ->
  invariant (stepped s x failed m verdicts).
Proof. intros V X O R. exact (proj1 (committed s x failed V X O m verdicts R)). Qed.

Theorem call_keeps y z : right y -> call y z -> right z.
Proof.
  unfold right. intros V C. destruct C; cbn [of_filter tracks] in *.
  - now apply pass_keeps with movers.
  - apply stepped_right; trivial. now apply failed_or_not.
  - now apply undo_keeps.
  - destruct (places_keep placed s V H H0) as [P _]. apply stepped_right; trivial; [apply P|]. intro v. right. now right.
  - apply recompute_keeps; trivial. intro v. destruct b; [generalize (stamp_range _ _ (fine_all s V v)); lia|]. now apply V.
  - split; [exact H|split; [|now split]]. intro v. destruct b; [generalize (stamp_range _ _ (fine_all s V v)); simpl; lia|]. now apply V.
  - destruct V as (V1 & V2 & V3 & V4). split; [exact H|split; [exact V2|split; [exact H2|]]]. intros i c M.
    destruct (H1 i c M) as [Q|[Q Q']]; [exact Q|]. apply local with (moving s); [|now apply V4 with i].
    intros w Hw. symmetry. destruct (H0 w) as [->|Hx]; [contradiction|exact Hx].
  - split; [now apply valid_all|split; [|split; [now apply closed|now apply holds_everywhere]]].
    intro v. generalize (stamp_range _ _ (fine_all s V v)). lia.
Qed.

Inductive calls (y : system) : system -> Prop :=
  | here : calls y y
  | further z u : calls y z -> call z u -> calls y u.

Theorem filter_is_right y z : right y -> calls y z -> right z /\ forall i c, mesh (of_filter z) i = Some c -> holds c (moving (of_filter z)).
Proof.
  intros V R. assert (Q : right z) by (induction R as [|z u R IH C]; [exact V|now apply call_keeps with z]).
  split; [exact Q|]. unfold right in Q. destruct (tracks z).
  - now apply holds_everywhere.
  - apply Q.
Qed.

(* It begins with a recomputation, from anything. *)
Corollary from_the_start s x m verdicts z : (forall v : vertex, (0 <= epoch s)%Z) -> Valid x -> recomputed_by x m verdicts ->
  calls {| of_filter := recompute x s m verdicts; tracks := true |} z ->
  forall i c, mesh (of_filter z) i = Some c -> holds c (moving (of_filter z)).
Proof.
  intros E X S R. refine (proj2 (filter_is_right {| of_filter := recompute x s m verdicts; tracks := true |} z _ R)).
  exact (proj1 (recompute_keeps x s m verdicts E X S)).
Qed.
End run.
