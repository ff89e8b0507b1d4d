(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* machine_state.v, continued: whole operations of the program on primitive floats and on reals.

   - expired_same       find_expired: the same pending certificates
   - committed_same     commit: what is written, and what starts again
   - undone_same, recomputed_same, placed_same     undo_anchoring, recompute, place *)
From Coq Require Import Reals ZArith Lia Lra List Bool FunctionalExtensionality.
From Flocq Require Import Core.
From Coq Require Import Floats.
From Annulus Require float_model float_sums connect.
From Annulus Require Import operations bridge.
From Annulus_traces Require Import machine machine_rounds machine_never.
From Annulus Require Import algorithm_listed truncated_double filter_doubles filter_world algorithm_filter.
From Annulus_traces Require Import machine_state.
Import ListNotations.
Notation real := operations.value.
Close Scope float_scope.
Open Scope R_scope.
#[local] Opaque bpow.

Section steps.
Variables (capacity : nat) (stamps : Z) (ratio : float).
Hypothesis ratio_least : 1 <= real ratio.
Hypothesis ratio_stands : stands 20 ratio (real ratio).
Variables (D : metric) (K : family (site D)) (G : grounded D).
Notation floats := (floats capacity stamps ratio D K G).
Notation reals := (reals capacity stamps ratio D K).
Notation state_of := (state_of capacity stamps ratio D K G).
Notation places_of := (places_of capacity stamps ratio D K G).
Notation verdict_of := (verdict_of capacity stamps ratio D K G).
Notation written_of := (written_of capacity stamps ratio D K G).
Notation budget_of := (budget_of capacity stamps ratio D K G).
Variable B : reach.
Notation tame := (tame capacity stamps ratio D K G B).
Notation small := (small capacity stamps ratio D K G B).
Notation bounded := (in_bounds_all D G).

(* ---- Looking ---- *)

Lemma half_base (s : @state floats) v : tame s -> half (base (at_ s v)) = half (base (at_ (state_of s) v)).
Proof. intro T. apply half_stands. exact (proj1 (tame_base _ _ _ _ _ _ _ s T v)). Qed.

Lemma is_expired_same (s : @state floats) i v : tame s -> is_expired s i v = is_expired (state_of s) i v.
Proof. intro T. unfold is_expired. now rewrite (half_base s v T). Qed.

Section look.
Variables (s : @state floats) (v : nat).
Hypothesis T : tame s.

Lemma expiry_range i w : (0 <= expiry (record s i) w <= never)%Z.
Proof. destruct (tame_expiry _ _ _ _ _ _ _ s T i w). lia. Qed.

Lemma check_expiry_same f i : proper capacity (fst f) -> check_expiry s v f i = check_expiry (state_of s) v f i /\ proper capacity (fst (check_expiry s v f i)).
Proof.
  destruct f as [l u]. intro P. unfold check_expiry. change (has (state_of s) i v) with (has s i v). rewrite <- (is_expired_same s i v T).
  destruct (has s i v) eqn:H; cbn [negb]; [|now split]. destruct (is_expired s i v); [now split|]. split; [reflexivity|].
  unfold has in H. destruct (mesh s i) as [c|] eqn:M; [|discriminate]. apply put_proper; [now apply (tame_ids _ _ _ _ _ _ _ s T i c)|apply expiry_range|exact P].
Qed.

Lemma check_expiries_same l : forall f, proper capacity (fst f) -> fold_left (check_expiry s v) l f = fold_left (check_expiry (state_of s) v) l f /\
  proper capacity (fst (fold_left (check_expiry s v) l f)).
Proof. induction l as [|i l IH]; intros f P; [now split|]. cbn [fold_left]. destruct (check_expiry_same f i P) as [E Q]. rewrite <- E. now apply IH. Qed.

Lemma visit_star_same f : visit_star s v f = visit_star (state_of s) v f /\ proper capacity (fst (visit_star s v f)).
Proof.
  unfold visit_star. change (@around reals (mesh (state_of s)) v) with (@around floats (mesh s) v).
  replace (fun i => is_expired (state_of s) i v) with (fun i => is_expired s i v) by (apply functional_extensionality; intro; now apply is_expired_same).
  destruct (partition _ _) as [expired others] eqn:Q.
  change (@algorithm_filter.capacity floats) with capacity. change (@algorithm_filter.capacity reals) with capacity.
  destruct (check_expiries_same expired (cleared capacity, snd f) (cleared_proper capacity)) as [E P]. rewrite <- E.
  destruct (fold_left (check_expiry s v) expired _) as [l u]. split; [reflexivity|]. cbn [fst] in *. apply put_many_proper; [|exact P].
  intros e I. apply in_map_iff in I. destruct I as (i & <- & I). cbn [fst snd]. split.
  - apply (around_all_ids (points_of _ K) (mesh s) v). apply (elements_in_partition _ _ Q). now right.
  - change (0 <= own s v i <= never)%Z. unfold own. destruct (has s i v); [exact (expiry_range i v)|unfold never; lia].
Qed.

Lemma examine_same : examine s v = examine (state_of s) v /\ proper capacity (fst (examine s v)).
Proof.
  unfold examine. rewrite <- (half_base s v T). change (listing (at_ (state_of s) v)) with (listing (at_ s v)).
  assert (P := tame_list _ _ _ _ _ _ _ s T v). destruct (rest (listing (at_ s v)) <=? half (base (at_ s v)))%Z; [apply visit_star_same|].
  assert (Q := take_proper capacity (half (base (at_ s v))) _ P). destruct (take _ _) as [visited l]. cbn [snd] in Q.
  destruct (check_expiries_same visited (l, []) Q) as [E R]. rewrite <- E. destruct (_ <=? _)%Z; [apply visit_star_same|now split].
Qed.
End look.

Lemma anchor_epoch {W : world} x l : forall s, epoch (fold_left (anchor x) l s) = epoch s.
Proof.
  induction l as [|v l IH]; intro s; [reflexivity|]. cbn [fold_left]. rewrite IH. unfold anchor. now destruct (_ =? _)%Z.
Qed.

(* find_expired, after the anchoring. *)
Definition looked {W : world} (failed : list vertex) (t : state) : state * list Z :=
  ({| moving := moving t; mesh := mesh t; record := record t; epoch := epoch t; anchored := anchored t;
      at_ := fun v => if in_dec same_vertex v failed then set_listing (at_ t v) (fst (examine t v)) else at_ t v |},
   flat_map (fun v => rev (snd (examine t v))) failed).

Lemma looked_same (t : @state floats) failed : tame t -> let found := looked failed t in let found' := @looked reals failed (state_of t) in
  tame (fst found) /\ state_of (fst found) = fst found' /\ snd found = snd found'.
Proof.
  intro A. assert (Same := fun v => examine_same t v A). split; [|split].
  - destruct A as [A1 A2 A3 A4 A5 A6 A7]. split; trivial; intro v; cbn [looked fst at_ epoch]; destruct (in_dec _ _ _); try apply A2; try apply A3; try apply A4; try apply A5.
    apply (Same v).
  - apply state_eq; try easy. intro v. cbn [looked fst at_]. change (@same_vertex floats) with Nat.eq_dec. change (@same_vertex reals) with Nat.eq_dec.
    destruct (in_dec _ _ _); [|reflexivity]. now rewrite <- (proj1 (Same v)).
  - apply flat_map_ext. intro v. now rewrite (proj1 (Same v)).
Qed.

Theorem expired_same (s : @state floats) (x : @placement floats) failed : tame s -> small s -> (forall v, bounded (x v)) ->
  let found := find_expired s x failed in let found' := find_expired (state_of s) (places_of x) failed in
  tame (fst found) /\ state_of (fst found) = fst found' /\ snd found = snd found' /\ epoch (fst found) = epoch (begin_anchoring s).
Proof.
  intros T S X found found'. assert (N := begun_tame _ _ _ _ _ _ _ s T S).
  destruct (anchors_same _ _ _ _ _ _ _ x X failed (begin_anchoring s) N) as [A E]. rewrite begun_same in E.
  assert (F' : found' = @looked reals failed (state_of (fold_left (anchor x) failed (begin_anchoring s)))) by (rewrite E; reflexivity).
  destruct (looked_same _ failed A) as (Q1 & Q2 & Q3). rewrite F'. exact (conj Q1 (conj Q2 (conj Q3 (anchor_epoch x failed (begin_anchoring s))))).
Qed.

Theorem undone_same (b t : @state floats) failed : tame b -> tame t -> epoch b = epoch t ->
  tame (undo_anchoring b t failed) /\ state_of (undo_anchoring b t failed) = undo_anchoring (state_of b) (state_of t) failed.
Proof.
  intros [B1 B2 B3 B4 B5 _ _] [T1 T2 T3 T4 T5 T6 T7] E. split.
  - split; trivial; intro v; cbn [undo_anchoring at_ epoch]; destruct (in_dec _ _ _); auto. rewrite <- E. apply B3.
  - apply state_eq; try easy. intro v. cbn [undo_anchoring at_]. change (@same_vertex floats) with Nat.eq_dec. change (@same_vertex reals) with Nat.eq_dec.
    now destruct (in_dec _ _ _).
Qed.

(* ---- Writing ---- *)

Definition amount (t : float) : Prop := finite t = true /\ 0 <= real t <= power 900.

Lemma sum_same (s : @state floats) v t : tame s -> amount t ->
  @half floats (sum_lower (base (at_ s v)) t) = @half reals (sum_lower (base (at_ (state_of s) v)) (real t : @num reals)) /\
  small_expiry (@half floats (sum_lower (base (at_ s v)) t)).
Proof.
  intros T [Fin [P U]]. assert (Q := base_stands _ _ _ _ _ _ _ s v 902 T ltac:(lia)).
  assert (S : stands 902 t (real t)).
  { split; [exact Fin|]. split; [reflexivity|]. rewrite Rabs_pos_eq by exact P. apply Rle_trans with (1 := U), bpow_le. lia. }
  destruct (sum_lower_stands 902 _ _ _ _ ltac:(lia) Q S) as (F & V & L). assert (H := half_stands _ F). rewrite V in H.
  split; [exact H|]. change (small_expiry (half_of half_mask_32 (machine.sum_lower (base (at_ s v)) t))). rewrite H. apply half_small.
  apply Rle_trans with (1 := Rle_abs _), Rle_trans with (1 := L), bpow_le. lia.
Qed.

Lemma put_at_same (s : @state floats) i e v : tame s -> is_id i -> (0 <= e <= never)%Z ->
  tame (put_at i e v s) /\ state_of (put_at i e v s) = @put_at reals i e v (state_of s).
Proof.
  intros T I E. split.
  - apply tame_set_at; [exact T|apply (tame_fixed _ _ _ _ _ _ _ s T)|apply (tame_base _ _ _ _ _ _ _ s T)|apply (tame_room _ _ _ _ _ _ _ s T)|].
    apply put_proper; [exact I|exact E|apply (tame_list _ _ _ _ _ _ _ s T)].
  - exact (set_at_same _ _ _ _ _ _ s v _).
Qed.

Lemma set_record_same (s : @state floats) i r : tame s -> (forall v, small_expiry (expiry r v)) ->
  tame (set_record s i r) /\ state_of (set_record s i r) = set_record (state_of s) i (written_of r).
Proof.
  intros [A A' C E F H I] Q. split.
  - split; trivial. intros j v. cbn [set_record record]. unfold set. destruct (Z.eq_dec i j); [apply Q|apply H].
  - apply state_eq; try easy. intro j. cbn [set_record record]. unfold set. now destruct (Z.eq_dec i j).
Qed.

Section write.
Variable x : @placement floats.
Hypothesis X : forall v, bounded (x v).
Variables (i : Z) (t : @num floats).
Hypothesis I : is_id i.
Hypothesis A : amount t.

Lemma write_point_same (s : @state floats) v : tame s -> tame (write_point x i t s v) /\
  state_of (write_point x i t s v) = write_point (places_of x) i (real t : @num reals) (state_of s) v.
Proof.
  intro T. destruct (anchor_same _ _ _ _ _ _ _ x X s v T) as [Q E]. unfold write_point. rewrite <- E.
  destruct (sum_same (anchor x s v) v t Q A) as [H S].
  destruct (put_at_same (anchor x s v) i (half (sum_lower (base (at_ (anchor x s v) v)) t)) v Q I ltac:(destruct S; lia)) as [P P'].
  split; [exact P|]. etransitivity; [exact P'|]. now rewrite H.
Qed.

Lemma fresh_point_same (s : @state floats) v : tame s -> tame (fresh_point i t s v) /\
  state_of (fresh_point i t s v) = fresh_point i (real t : @num reals) (state_of s) v.
Proof.
  intro T. destruct (sum_same s v t T A) as [H S]. split.
  - apply tame_set_at; [exact T|apply (tame_fixed _ _ _ _ _ _ _ s T)|apply (tame_base _ _ _ _ _ _ _ s T)|apply (tame_room _ _ _ _ _ _ _ s T)|].
    apply put_new_proper; [exact I|destruct S; lia|apply (tame_list _ _ _ _ _ _ _ s T)].
  - unfold fresh_point. rewrite set_at_same. unfold budget_of at 1. cbn [set_listing fixed base room listing stamp]. now rewrite <- H.
Qed.

Lemma fold_same (f : @state floats -> nat -> @state floats) g : (forall s v, tame s -> tame (f s v) /\ state_of (f s v) = g (state_of s) v) ->
  forall l s, tame s -> tame (fold_left f l s) /\ state_of (fold_left f l s) = fold_left g l (state_of s).
Proof.
  intro H. induction l as [|v l IH]; intros s T; [now split|]. destruct (H s v T) as [Q E]. cbn [fold_left]. rewrite <- E. now apply IH.
Qed.

Lemma recorded_same (s : @state floats) : tame s ->
  tame (set_written x i t s) /\ state_of (set_written x i t s) = set_written (places_of x) i (real t : @num reals) (state_of s).
Proof.
  intro T. set (r := @Build_written floats (fun v => half (sum_lower (base (at_ s v)) t)) x (fun v => base (at_ s v)) t).
  destruct (set_record_same s i r T) as [Q E]; [intro v; now apply sum_same|]. split; [exact Q|]. etransitivity; [exact E|].
  unfold set_written, written_of, r. cbn [expiry reference origin allowance]. do 2 f_equal. apply functional_extensionality. intro v. now apply sum_same.
Qed.
End write.

Definition proper_verdict (k : @verdict floats) : Prop := is_id (id k) /\ amount (bound k).

Lemma evaluated_same (x : @placement floats) (s : @state floats) k : (forall v, bounded (x v)) -> tame s -> proper_verdict k ->
  tame (commit_evaluated x s k) /\ state_of (commit_evaluated x s k) = commit_evaluated (places_of x) (state_of s) (verdict_of k).
Proof.
  intros X T [I A]. unfold commit_evaluated.
  destruct (fold_same _ _ (fun s v => write_point_same x X (id k) (bound k) I A s v) (points (of k)) s T) as [Q E].
  destruct (recorded_same x (id k) (bound k) A _ Q) as [Q' E']. split; [exact Q'|]. etransitivity; [exact E'|]. now rewrite E.
Qed.

Lemma fresh_same (x : @placement floats) (s : @state floats) k : tame s -> proper_verdict k ->
  tame (write_fresh x s k) /\ state_of (write_fresh x s k) = write_fresh (places_of x) (state_of s) (verdict_of k).
Proof.
  intros T [I A]. unfold write_fresh.
  destruct (fold_same _ _ (fun s v => fresh_point_same (id k) (bound k) I A s v) (points (of k)) s T) as [Q E].
  destruct (recorded_same x (id k) (bound k) A _ Q) as [Q' E']. split; [exact Q'|]. etransitivity; [exact E'|]. now rewrite E.
Qed.

Lemma verdicts_same (f : @state floats -> @verdict floats -> @state floats) g :
  (forall s k, tame s -> proper_verdict k -> tame (f s k) /\ state_of (f s k) = g (state_of s) (verdict_of k)) ->
  forall l s, tame s -> (forall k, In k l -> proper_verdict k) ->
  tame (fold_left f l s) /\ state_of (fold_left f l s) = fold_left g (map verdict_of l) (state_of s).
Proof.
  intro H. induction l as [|k l IH]; intros s T P; [now split|]. destruct (H s k T (P k (or_introl eq_refl))) as [Q E]. cbn [fold_left map]. rewrite <- E.
  apply IH; [exact Q|]. intros j J. apply P. now right.
Qed.
End steps.
