(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The program of algorithm_filter.v on primitive floats and on reals does the same, operation after operation, while no displacement budget has gone far: the state
   of the machine stands for a state of the model, and so it is after each operation. Of any dimension.

   - floats        the program with the numbers of machine.v; state_of: the state of the model that a state of the machine stands for
   - tame          what a state of the machine has to be; small: no displacement budget has gone far
   - anchor_same, examined_same, written_same, finished_same ...    operations *)
From Coq Require Import Reals ZArith Lia Lra List Bool FunctionalExtensionality.
From Flocq Require Import Core.
From Coq Require Import Floats.
From Annulus Require float_model float_sums connect.
From Annulus Require Import operations bridge.
From Annulus_traces Require Import machine machine_rounds machine_never.
From Annulus Require Import algorithm_listed truncated_double filter_doubles filter_world algorithm_filter.
Import ListNotations.
Notation real := operations.value.
Close Scope float_scope.
Open Scope R_scope.

(* A dimension: where points of doubles are, and that the operations of machine.v on them are those of the metric. *)
Record grounded (D : metric) := {
  spot : Type;
  coordinates_of : spot -> machine.point;
  place_of : spot -> site D;
  in_bounds_all : spot -> Prop;
  box_right : forall p, in_bounds_all p -> in_box D (place_of p);
  same_right : forall p q, in_bounds_all p -> in_bounds_all q -> same_coordinates (coordinates_of p) (coordinates_of q) = same_site D (place_of p) (place_of q);
  path_length_right : forall a b f p, (505 <= a <= 1000)%Z -> stands a b (real b) -> in_bounds_all f -> in_bounds_all p ->
    stands (a + 2) (path_length_at b (coordinates_of f) (coordinates_of p)) (read D (real b) (place_of f) (place_of p));
  way_right : forall b f p, in_bounds_all f -> in_bounds_all p ->
    exists way, 0 <= way <= power 505 /\ read D b (place_of f) (place_of p) = float_sums.sum_upper b way;
  below_right : forall f p r, finite r = true -> in_bounds_all f -> in_bounds_all p ->
    (squared_distance (coordinates_of p) (coordinates_of f) <? r)%float = is_below D (place_of f) (place_of p) (real r) }.

(* How far a displacement budget may have gone before a call, and after it. *)
Record reach := {
  gone : R;
  going : R;
  gone_bounds : 0 <= gone <= power 900;
  going_bounds : gone <= going <= power 902;
  one_way : forall b way, 0 <= b <= gone -> 0 <= way <= power 505 -> float_sums.sum_upper b way <= going }.

#[local] Opaque bpow.   (* 2^900 is not to be written out *)

Section runs.
Variables (capacity : nat) (stamps : Z) (ratio : float).
Hypothesis ratio_least : 1 <= real ratio.
Hypothesis ratio_stands : stands 20 ratio (real ratio).
Variables (D : metric) (K : family (site D)) (G : grounded D).
Notation spot := (spot D G).
Notation at_place := (place_of D G).
Notation bounded := (in_bounds_all D G).
Notation coordinates := (coordinates_of D G).

(* The arithmetic that the replays run. *)
Let replayed : world := machine {| listed := capacity; last_stamp := stamps; half_mask := half_mask_32; path_ratio := ratio |}.
Definition floats : world := {|
  position := spot; vertex := nat; certificate := kind _ K; same_vertex := Nat.eq_dec;
  same_position := fun p q => @same_position replayed (coordinates p) (coordinates q);
  dist := fun p q => distance D (at_place p) (at_place q); points := points_of _ K;
  holds := fun c m => is_true _ K c (fun v => at_place (m v)); counts_on := relies_on _ K;
  algorithm_filter.capacity := capacity; algorithm_filter.stamps := stamps;
  around := filter_world.around_all (points_of _ K);
  num := float; algorithm_filter.real := operations.value; zero := @zero replayed; valid := bounded; number := fun b => finite b = true;
  path_length_of := fun b f p => @path_length_of replayed b (coordinates f) (coordinates p);
  below := fun f p r => @below replayed (coordinates f) (coordinates p) r;
  threshold := @threshold replayed; sum_lower := @algorithm_filter.sum_lower replayed; less := @less replayed; half := @half replayed;
  worn := @worn replayed |}.

Definition worn_real (b : R) (l : expiry_list) : bool := worn_expiry (latest l) ratio b.
Definition reals : world := numbered capacity stamps worn_real D K.

(* ---- What a state of the machine stands for ---- *)

Definition budget_of (o : @budget floats) : @budget reals :=
  @Build_budget reals (at_place (fixed o)) (real (base o)) (real (room o)) (listing o) (stamp o).
Definition written_of (r : @written floats) : @written reals :=
  @Build_written reals (expiry r) (fun v => at_place (reference r v)) (origin r) (allowance r).
Definition state_of (s : @state floats) : @state reals :=
  @Build_state reals (fun v => at_place (moving s v)) (fun v => budget_of (at_ s v)) (mesh s) (fun i => written_of (record s i)) (epoch s) (anchored s).
Definition verdict_of (k : @verdict floats) : @verdict reals := @Build_verdict reals (id k) (of k) (real (bound k)).
Definition places_of (x : @placement floats) : @placement reals := fun v => at_place (x v).

Variable B : reach.
Definition small_expiry (e : Z) : Prop := (0 <= e < never)%Z /\ truncated_double.value e <= power 1000.
Definition moderate (o : @budget floats) (limit : R) : Prop := finite (base o) = true /\ 0 <= real (base o) <= limit.
(* In a step a displacement budget goes on once, and has the step's stamp then. *)
Record tame (s : @state floats) : Prop := {
  tame_moving : forall v, bounded (moving s v);
  tame_fixed : forall v, bounded (fixed (at_ s v));
  tame_base : forall v, moderate (at_ s v) (if (stamp (at_ s v) =? epoch s)%Z then going B else gone B);
  tame_room : forall v, finite (room (at_ s v)) = true;
  tame_list : forall v, proper capacity (listing (at_ s v));
  tame_expiry : forall i v, small_expiry (expiry (record s i) v);
  tame_ids : forall i c, mesh s i = Some c -> is_id i }.
Definition small (s : @state floats) : Prop := forall v, real (base (at_ s v)) <= gone B.

Lemma reach_pos (b : bool) : 0 <= if b then going B else gone B.
Proof. destruct (gone_bounds B), (going_bounds B). destruct b; lra. Qed.

Lemma base_902 s v : tame s -> stands 902 (base (at_ s v)) (real (base (at_ s v))) /\ 0 <= real (base (at_ s v)).
Proof.
  intro T. destruct (tame_base s T v) as [F [P U]]. split; [|exact P]. split; [exact F|]. split; [reflexivity|]. rewrite Rabs_pos_eq by exact P.
  apply Rle_trans with (1 := U). destruct (going_bounds B). destruct (_ =? _)%Z; lra.
Qed.
Lemma base_stands s v a : tame s -> (902 <= a)%Z -> stands a (base (at_ s v)) (real (base (at_ s v))).
Proof. intros T A. apply stands_wider with 902%Z; [exact A|]. now apply base_902. Qed.
Lemma base_smaller s v : tame s -> real (base (at_ s v)) < power 999.
Proof.
  intro T. destruct (base_902 s v T) as [(_ & _ & U) P]. rewrite Rabs_pos_eq in U by exact P. apply Rle_lt_trans with (1 := U), bpow_lt. lia.
Qed.

Lemma half_small r : r <= power 1000 -> small_expiry (lower r).
Proof.
  intro U. assert (L := lower_range r). destruct (Rlt_le_dec 0 r) as [P|P].
  - assert (V := lower_below r ltac:(lra)). split; [|lra]. apply near_value; [apply L|lra].
  - rewrite lower_clips by exact P. split; [unfold never; lia|]. rewrite value_0. apply bpow_ge_0.
Qed.

(* ---- Changing one vertex, or one record ---- *)

Lemma state_eq m a i r e n m' a' i' r' e' n' : (forall v, m v = m' v) -> (forall v, a v = a' v) -> i = i' -> (forall j, r j = r' j) -> e = e' -> n = n' ->
  @Build_state reals m a i r e n = @Build_state reals m' a' i' r' e' n'.
Proof. intros M A -> R -> ->. f_equal; apply functional_extensionality; assumption. Qed.

Lemma set_at_same s v o : state_of (set_at s v o) = set_at (state_of s) v (budget_of o).
Proof. apply state_eq; try easy. intro w. simpl. unfold set. now destruct (Nat.eq_dec v w). Qed.

Lemma tame_set_at s v (o : @budget floats) : tame s -> bounded (fixed o) -> moderate o (if (stamp o =? epoch s)%Z then going B else gone B) ->
  finite (room o) = true -> proper capacity (listing o) -> tame (set_at s v o).
Proof.
  intros [A A' C E F H I] P Q R L. split; trivial; intro w; simpl; unfold set; destruct (Nat.eq_dec v w) as [<-|]; trivial.
Qed.

(* ---- The test of a step ---- *)

Lemma passes_same s x v : tame s -> bounded (x v) -> passes s x v = passes (state_of s) (places_of x) v.
Proof.
  intros T X. unfold passes. f_equal.
  - exact (below_right D G _ _ _ (tame_room s T v) (tame_fixed s T v) X).
  - exact (same_right D G _ _ X (tame_fixed s T v)).
Qed.

Theorem failed_same s x movers : tame s -> (forall v, bounded (x v)) -> find_failed s x movers = find_failed (state_of s) (places_of x) movers.
Proof. intros T X. unfold find_failed. apply filter_ext. intro v. f_equal. now apply passes_same. Qed.

Lemma begun_same s : state_of (begin_anchoring s) = begin_anchoring (state_of s).
Proof. apply state_eq; try easy. intro v. simpl. now destruct (_ =? _)%Z. Qed.
Lemma begun_tame s : tame s -> small s -> tame (begin_anchoring s).
Proof.
  intros [A A' C E F H I] S.
  assert (Q : forall v, moderate (at_ s v) (gone B)) by (intro v; destruct (C v) as [C1 [C2 _]]; split; [exact C1|split; [exact C2|apply S]]).
  assert (W : forall o b, moderate o (gone B) -> moderate o (if b : bool then going B else gone B)).
  { intros o [|] [O1 [O2 O3]]; [|split; auto]. split; [exact O1|split; [exact O2|]]. destruct (going_bounds B). lra. }
  split; trivial; intro v; simpl; destruct (epoch s =? stamps)%Z; simpl; auto; first [exact (Q v)|apply (W _ _ (Q v))].
Qed.

(* ---- Anchoring ---- *)

Section step.
Variable x : @placement floats.
Hypothesis X : forall v, bounded (x v).

Lemma path_length_moderate s v : tame s -> (stamp (at_ s v) =? epoch s)%Z = false ->
  stands 902 (path_length s v (x v)) (path_length (state_of s) v (places_of x v)) /\ 0 <= path_length (state_of s) v (places_of x v) <= going B.
Proof.
  intros T E. destruct (tame_base s T v) as [F [P U]]. rewrite E in U. split; [|split].
  - apply (path_length_right D G 900); [lia| |apply (tame_fixed s T)|apply X]. split; [exact F|]. split; [reflexivity|]. rewrite Rabs_pos_eq by exact P.
    destruct (gone_bounds B). lra.
  - destruct (read_above D (real (base (at_ s v))) (at_place (fixed (at_ s v))) (at_place (x v)) (connect.value_format _) P
      (box_right D G _ (tame_fixed s T v)) (box_right D G _ (X v))) as [_ H].
    generalize (distance_nonneg D (at_place (fixed (at_ s v))) (at_place (x v))). intro. apply Rle_trans with (2 := H). lra.
  - destruct (way_right D G (real (base (at_ s v))) _ _ (tame_fixed s T v) (X v)) as (way & Q & R).
    change (read D (real (base (at_ s v))) (at_place (fixed (at_ s v))) (at_place (x v)) <= going B). rewrite R. now apply (one_way B).
Qed.

Definition with_anchored (s : @state reals) (l : list nat) : @state reals := @Build_state reals (moving s) (at_ s) (mesh s) (record s) (epoch s) l.

Theorem anchor_same (s : @state floats) v : tame s -> tame (anchor x s v) /\ state_of (anchor x s v) = anchor (places_of x) (state_of s) v.
Proof.
  intro T. unfold anchor. change (stamp (at_ (state_of s) v)) with (stamp (at_ s v)). change (epoch (state_of s)) with (epoch s).
  destruct (stamp (at_ s v) =? epoch s)%Z eqn:E; [now split|].
  destruct (path_length_moderate s v T E) as [(RF & RV & _) RP].
  set (o := if @same_position floats (x v) (fixed (at_ s v)) then set_stamp (at_ s v) (epoch s) else _).
  set (o' := if @same_position reals _ _ then _ else _).
  assert (O : budget_of o = o').
  { unfold o, o'. change (@same_position reals) with (same_site D). change (fixed (at_ (state_of s) v)) with (at_place (fixed (at_ s v))).
    change (places_of x v) with (at_place (x v)). rewrite <- (same_right D G _ _ (X v) (tame_fixed s T v)).
    change (@same_position floats (x v) (fixed (at_ s v))) with (same_coordinates (coordinates (x v)) (coordinates (fixed (at_ s v)))).
    destruct (same_coordinates _ _); [reflexivity|]. unfold budget_of. cbn [fixed base room listing stamp]. f_equal. exact RV. }
  assert (Ok : tame (set_at s v o)).
  { destruct (tame_base s T v) as [BF [BP BU]]. rewrite E in BU. apply tame_set_at; trivial; unfold o; destruct (same_position _ _); simpl.
    - apply (tame_fixed s T).
    - apply X.
    - rewrite Z.eqb_refl. split; [exact BF|split; [exact BP|]]. apply Rle_trans with (1 := BU), (going_bounds B).
    - rewrite Z.eqb_refl. split; [exact RF|]. change (0 <= real (path_length s v (x v)) <= going B). rewrite RV. exact RP.
    - apply (tame_room s T).
    - apply (tame_room s T).
    - apply (tame_list s T).
    - apply (tame_list s T). }
  split.
  - destruct Ok. now split.
  - assert (Q := set_at_same s v o). rewrite O in Q. exact (f_equal (fun t => with_anchored t (v :: anchored s)) Q).
Qed.

Lemma anchors_same l : forall s : @state floats, tame s -> tame (fold_left (anchor x) l s) /\
  state_of (fold_left (anchor x) l s) = fold_left (anchor (places_of x)) l (state_of s).
Proof.
  induction l as [|v l IH]; intros s T; [now split|]. destruct (anchor_same s v T) as [A E]. cbn [fold_left]. rewrite <- E. now apply IH.
Qed.
End step.
End runs.
