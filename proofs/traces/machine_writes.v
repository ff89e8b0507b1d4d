(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* machine_steps.v, continued: what operations leave behind.

   - finished_same, committed_same      rebase, set_threshold, commit
   - stepped_same       a step
   - recomputed_same, places_same          recompute, place *)
From Coq Require Import Reals ZArith Lia Lra List Bool FunctionalExtensionality.
From Flocq Require Import Core.
From Coq Require Import Floats.
From Annulus Require float_model float_sums bridge_decide.
From Annulus Require Import operations bridge.
From Annulus_traces Require Import machine machine_rounds machine_never.
From Annulus Require Import algorithm_listed truncated_double filter_doubles filter_world algorithm_filter algorithm_run.
From Annulus_traces Require Import machine_state machine_steps.
Import ListNotations.
Notation real := operations.value.
Close Scope float_scope.
Open Scope R_scope.
#[local] Opaque bpow.

Section runs.
Variables (capacity : nat) (stamps : Z) (ratio : float).
Hypothesis ratio_least : 1 <= real ratio.
Hypothesis ratio_stands : stands 20 ratio (real ratio).
Variables (D : metric) (K : family (site D)) (G : grounded D).
Notation floats := (floats capacity stamps ratio D K G).
Notation reals := (reals capacity stamps ratio D K).
Notation state_of := (state_of capacity stamps ratio D K G).
Notation places_of := (places_of capacity stamps ratio D K G).
Notation verdict_of := (verdict_of capacity stamps ratio D K G).
Variable B : reach.
Notation tame := (tame capacity stamps ratio D K G B).
Notation small := (small capacity stamps ratio D K G B).
Notation proper_verdict := (proper_verdict capacity stamps ratio D K G).
Notation bounded := (in_bounds_all D G).

(* ---- The end of a step ---- *)

Lemma latest_range l : proper capacity l -> (0 <= latest l)%Z.
Proof.
  intros [_ [R E]]. unfold latest. assert (H : forall m found, (0 <= found)%Z -> (forall e, In e m -> (0 <= e)%Z) ->
    (0 <= fold_left (fun found e => if (e =? empty_entry)%Z then found else expiry_of e) m found)%Z).
  { induction m as [|e m IH]; intros found F A; [exact F|]. cbn [fold_left]. apply IH; [|intros f I; apply A; now right].
    destruct (e =? empty_entry)%Z; [exact F|]. rewrite upper_half. apply Z.div_pos; [apply A; now left|lia]. }
  apply H; [exact R|]. intros e I. now apply E.
Qed.

Lemma worn_same (s : @state floats) v : tame s ->
  @worn floats (base (at_ s v)) (listing (at_ s v)) = @worn reals (base (at_ (state_of s) v)) (listing (at_ (state_of s) v)).
Proof.
  intro T. apply (worn_expiry_of_any (latest (listing (at_ s v))) (base (at_ s v))); trivial.
  - now apply latest_range, (tame_list _ _ _ _ _ _ _ s T).
  - apply (base_stands _ _ _ _ _ _ _ s v 999 T). lia.
  - exact (base_smaller _ _ _ _ _ _ _ s v T).
  - exact (proj2 (base_902 _ _ _ _ _ _ _ s v T)).
Qed.

Lemma room_same (s : @state floats) v : tame s -> tame (set_at s v (set_room (at_ s v))) /\
  state_of (set_at s v (set_room (at_ s v))) = @set_at reals (state_of s) v (set_room (at_ (state_of s) v)).
Proof.
  intro T. destruct (threshold_of_any (earliest (listing (at_ s v))) (base (at_ s v))) as (F & V & _).
  - apply (earliest_range capacity), (tame_list _ _ _ _ _ _ _ s T).
  - apply (base_stands _ _ _ _ _ _ _ s v 999 T). lia.
  - exact (base_smaller _ _ _ _ _ _ _ s v T).
  - exact (proj2 (base_902 _ _ _ _ _ _ _ s v T)).
  - split.
    + apply tame_set_at; [exact T|apply (tame_fixed _ _ _ _ _ _ _ s T)|apply (tame_base _ _ _ _ _ _ _ s T)|exact F|apply (tame_list _ _ _ _ _ _ _ s T)].
    + rewrite set_at_same. f_equal. unfold budget_of, set_room. cbn [fixed base room listing stamp]. f_equal. exact V.
Qed.

Lemma shifted_same (s : @state floats) v e : tame s -> small_expiry e ->
  @shifted floats e (base (at_ s v)) = @shifted reals e (base (at_ (state_of s) v)) /\ small_expiry (@shifted floats e (base (at_ s v))).
Proof.
  intros T [E U]. destruct (left_stands e (base (at_ s v)) E U (base_stands _ _ _ _ _ _ _ s v 1000 T ltac:(lia))) as (F & V & _).
  assert (H := half_stands _ F). rewrite V in H. split; [exact H|].
  change (small_expiry (half_of half_mask_32 (left_of e (base (at_ s v))))). rewrite H. apply half_small.
  destruct (base_902 _ _ _ _ _ _ _ s v T) as [_ P].
  destruct (less_down e (real (base (at_ s v))) ltac:(lia) (connect.value_format _) P) as [L1 L2].
  destruct (Rle_lt_dec (truncated_double.value e) (real (base (at_ s v)))) as [Q|Q].
  - generalize (L1 Q) (bpow_ge_0 radix2 1000). lra.
  - generalize (L2 (Rlt_le _ _ Q)). lra.
Qed.

Lemma rebase_same (s : @state floats) v : tame s -> tame (rebase s v) /\ state_of (rebase s v) = @rebase reals (state_of s) v.
Proof.
  intro T. assert (Sh := fun i => shifted_same s v _ T (tame_expiry _ _ _ _ _ _ _ s T i v)).
  assert (Zero : real (@zero floats) = 0) by exact bridge_decide.value_zero.
  set (relist := fun (l : expiry_list) i => if has s i v then put i (shifted (expiry (record s i) v) (base (at_ s v))) l else l).
  assert (Proper : forall l m, (forall i, In i l -> is_id i) -> proper capacity m -> proper capacity (fold_left relist l m)).
  { induction l as [|i l IH]; intros m A P; [exact P|]. cbn [fold_left]. apply IH; [intros j J; apply A; now right|]. unfold relist.
    destruct (has s i v); [|exact P]. apply put_proper; [apply A; now left| |exact P]. destruct (Sh i) as [_ [Q _]]. lia. }
  split.
  - destruct T as [A A' C E F H I]. split; trivial.
    + intro w. unfold rebase. cbn [at_]. unfold set. destruct (same_vertex v w); [exact (A' v)|apply A'].
    + intro w. unfold rebase. cbn [at_ epoch]. unfold set. destruct (same_vertex v w); [|apply C]. unfold moderate. cbn [base stamp]. rewrite Zero.
      split; [reflexivity|]. split; [apply Rle_refl|]. apply reach_pos.
    + intro w. unfold rebase. cbn [at_]. unfold set. destruct (same_vertex v w); [exact (E v)|apply E].
    + intro w. unfold rebase. cbn [at_]. unfold set. destruct (same_vertex v w); [|apply F]. apply Proper; [|apply cleared_proper].
      intros i J. exact (around_all_ids (points_of _ K) (mesh s) v i J).
    + intros i w. unfold rebase. cbn [record]. destruct (has s i v); [|apply H]. cbn [expiry]. unfold set. destruct (same_vertex v w); [apply Sh|apply H].
  - unfold rebase. apply state_eq; try reflexivity.
    + intro w. cbn [at_]. change (@same_vertex floats) with Nat.eq_dec. change (@same_vertex reals) with Nat.eq_dec. unfold set.
      destruct (Nat.eq_dec v w); [|reflexivity]. unfold budget_of. cbn [fixed base room listing stamp]. f_equal.
      apply (f_equal (fun f => fold_left f (around (mesh s) v) (cleared capacity))). apply functional_extensionality. intro l. apply functional_extensionality. intro i.
      change (has (state_of s) i v) with (has s i v). destruct (has s i v); [|reflexivity]. now rewrite (proj1 (Sh i)).
    + intro i. cbn [record]. change (has (state_of s) i v) with (has s i v). destruct (has s i v); [|reflexivity].
      unfold written_of. cbn [expiry reference origin allowance]. now rewrite (proj1 (Sh i)).
Qed.

Lemma finished_same (s : @state floats) v : tame s -> tame (finish s v) /\ state_of (finish s v) = @finish reals (state_of s) v.
Proof.
  intro T. unfold finish. rewrite <- (worn_same s v T). destruct (worn _ _); [|now apply room_same].
  destruct (rebase_same s v T) as [Q E]. rewrite <- E. now apply room_same.
Qed.

Lemma moved_same (x : @placement floats) (s : @state floats) : (forall v, bounded (x v)) -> tame s ->
  tame (move_to x s) /\ state_of (move_to x s) = move_to (places_of x) (state_of s).
Proof. intros X [A A' C E F H I]. split; [split|]; trivial. Qed.
Lemma mesh_same (s : @state floats) m : tame s -> (forall i c, m i = Some c -> is_id i) -> tame (with_mesh s m).
Proof. intros [A A' C E F H I] M. split; trivial. Qed.

Theorem committed_same (x : @placement floats) (s : @state floats) m verdicts : (forall v, bounded (x v)) -> tame s ->
  (forall i c, m i = Some c -> is_id i) -> (forall k, In k verdicts -> proper_verdict k) ->
  tame (commit x s m verdicts) /\ state_of (commit x s m verdicts) = commit (places_of x) (state_of s) m (map verdict_of verdicts).
Proof.
  intros X T M V. unfold commit.
  destruct (verdicts_same _ _ _ _ _ _ _ _ _ (fun s k => evaluated_same _ _ _ _ _ _ _ x s k X) verdicts (with_mesh s m) (mesh_same s m T M) V) as [A E].
  change (with_mesh (state_of s) m) with (state_of (with_mesh s m)). rewrite <- E. set (t := fold_left (commit_evaluated x) verdicts (with_mesh s m)) in *.
  destruct (fold_same _ _ _ _ _ _ _ _ _ (fun s v => finished_same s v) (anchored t) t A) as [N F].
  destruct (moved_same x _ X N) as [P Q]. split; [exact P|]. etransitivity; [exact Q|]. exact (f_equal (move_to (places_of x)) F).
Qed.

Theorem stepped_same (x : @placement floats) (s : @state floats) failed m verdicts : (forall v, bounded (x v)) -> tame s -> small s ->
  (forall i c, m i = Some c -> is_id i) -> (forall k, In k verdicts -> proper_verdict k) ->
  tame (stepped s x failed m verdicts) /\
  state_of (stepped s x failed m verdicts) = @stepped reals (state_of s) (places_of x) failed m (map verdict_of verdicts).
Proof.
  intros X T S M V. destruct (expired_same _ _ _ _ _ _ _ s x failed T S X) as (A & E & _). unfold stepped. rewrite <- E. now apply committed_same.
Qed.

(* ---- Everything anew; vertices come ---- *)

Lemma zero_tame : finite (@zero floats) = true /\ real (@zero floats) = 0.
Proof. split; [reflexivity|exact bridge_decide.value_zero]. Qed.

Theorem recomputed_same (x : @placement floats) (s : @state floats) m verdicts : (forall v, bounded (x v)) -> (forall i v, small_expiry (expiry (record s i) v)) ->
  (forall i c, m i = Some c -> is_id i) -> (forall k, In k verdicts -> proper_verdict k) ->
  tame (recompute x s m verdicts) /\ state_of (recompute x s m verdicts) = recompute (places_of x) (state_of s) m (map verdict_of verdicts).
Proof.
  intros X H M V. unfold recompute.
  set (s0 := @Build_state floats x (fun v => @Build_budget floats (x v) zero zero (cleared capacity) 0) m (record s) (epoch s) []).
  assert (T : tame s0).
  { destruct zero_tame as [F Z]. split; trivial; intro v.
    - split; [exact F|]. cbn [s0 at_ base stamp]. rewrite Z. split; [apply Rle_refl|]. apply reach_pos.
    - apply cleared_proper. }
  destruct (verdicts_same _ _ _ _ _ _ _ _ _ (fun s k => fresh_same _ _ _ _ _ _ _ x s k) verdicts s0 T V) as [A E].
  assert (Z : state_of s0 = @Build_state reals (places_of x) (fun v => @Build_budget reals (places_of x v) zero zero (cleared capacity) 0) m
    (record (state_of s)) (epoch s) []).
  { now apply state_eq. }
  rewrite Z in E. clear Z. cbv zeta.
  set (t := fold_left (write_fresh x) verdicts s0) in A, E. change (fold_left (write_fresh x) verdicts _) with t.
  set (u := fold_left (write_fresh (places_of x)) (map verdict_of verdicts) _) in E. change (fold_left (write_fresh (places_of x)) (map verdict_of verdicts) _) with u.
  rewrite <- E. clearbody t. clear E s0 T.
  assert (R := fun v => threshold_of_any (earliest (listing (at_ t v))) (base (at_ t v)) (earliest_range capacity _ (tame_list _ _ _ _ _ _ _ t A v))
    (base_stands _ _ _ _ _ _ _ t v 999 A ltac:(lia)) (base_smaller _ _ _ _ _ _ _ t v A) (proj2 (base_902 _ _ _ _ _ _ _ t v A))).
  destruct A as [A1 A2 A3 A4 A5 A6 A7]. split.
  - split; trivial. exact (fun v => proj1 (R v)).
  - apply state_eq; try easy. intro v. cbn [at_]. unfold budget_of, set_room. cbn [fixed base room listing stamp]. f_equal. exact (proj1 (proj2 (R v))).
Qed.

Definition placed_of (n : @vertex floats * @position floats) : @vertex reals * @position reals := (fst n, place_of D G (snd n)).
Lemma place_same (s : @state floats) n : tame s -> bounded (snd n) -> tame (place s n) /\ state_of (place s n) = @place reals (state_of s) (placed_of n).
Proof.
  destruct n as [v p]. intros T P. unfold place, placed_of. cbn [fst snd].
  set (o := @Build_budget floats p (base (at_ s v)) zero (cleared capacity) (stamp (at_ s v))).
  assert (Q : tame (set_at s v o)).
  { apply tame_set_at; [exact T|exact P|apply (tame_base _ _ _ _ _ _ _ s T)|exact (proj1 zero_tame)|apply cleared_proper]. }
  split.
  - apply (moved_same (set same_vertex (moving s) v p)); [|exact Q]. intro w. unfold set. destruct (same_vertex v w); [exact P|apply (tame_moving _ _ _ _ _ _ _ s T)].
  - apply state_eq; try easy; intro w; cbn [move_to moving set_at at_]; unfold set; change (@same_vertex floats) with Nat.eq_dec;
      change (@same_vertex reals) with Nat.eq_dec; destruct (Nat.eq_dec v w); reflexivity.
Qed.
Lemma places_same (l : list (@vertex floats * @position floats)) : forall s : @state floats, tame s -> small s -> (forall n, In n l -> bounded (snd n)) ->
  tame (fold_left (@place floats) l s) /\ small (fold_left (@place floats) l s) /\ state_of (fold_left (@place floats) l s) = fold_left (@place reals) (map placed_of l) (state_of s).
Proof.
  induction l as [|n l IH]; intros s T S P; [split; [exact T|split; [exact S|reflexivity]]|]. destruct (place_same s n T (P n (or_introl eq_refl))) as [Q E]. cbn [fold_left map].
  rewrite <- E. apply IH; [exact Q| |intros k I; apply P; now right]. intro w. destruct n as [v p]. cbn [place move_to set_at at_]. unfold set.
  destruct (same_vertex v w) as [<-|]; apply S.
Qed.
End runs.
