(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the model of the filter uses of the plane and of space alike: vertices are numbers, arithmetic is that of the code (filter_doubles.v), lists
   and stamps are left open. A dimension adds its points (`metric`) and its certificates (`family`): filter_plane.v, filter_space.v.

   - around_all_right        of all ids there can be, those of certificates that contain a vertex
   - numbered, numbered_laws   the world, and that nothing of `laws` is left to believe
   - near_or_same            within a tolerance: all points are closer than it, or it is 0 and all are at their references
   - evaluated_holds         after any calls every certificate holds, if verdicts promise what `evaluated` says *)
Require Import Reals Lra Lia ZArith List Bool Arith.
From Annulus Require Import float_model float_sums truncated_double filter_doubles.
From Annulus Require Import algorithm_list algorithm_filter algorithm_check algorithm_run.
Import ListNotations.
Open Scope R_scope.

(* ---- Certificates around a vertex ---- *)

Section around.
Context {certificate : Type}.
Variable points_of : certificate -> list nat.

(* All ids there can be, of which the mesh has some. *)
Definition around_all (m : Z -> option certificate) (v : nat) : list Z :=
  filter (fun i => match m i with Some c => if in_dec Nat.eq_dec v (points_of c) then true else false | None => false end)
    (map Z.of_nat (seq 0 (Z.to_nat none))).

Lemma around_all_right m v i c : (forall j d, m j = Some d -> is_id j) -> m i = Some c -> In v (points_of c) -> In i (around_all m v).
Proof.
  intros I M V. apply filter_In. split.
  - apply in_map_iff. exists (Z.to_nat i). assert (H := I i c M). unfold is_id in H.
    split; [apply Z2Nat.id; apply H|]. apply in_seq. split; [apply Nat.le_0_l|]. rewrite Nat.add_0_l. apply Z2Nat.inj_lt; lia.
  - rewrite M. destruct (in_dec _ _ _); [reflexivity|contradiction].
Qed.

Lemma around_all_ids m v i : In i (around_all m v) -> is_id i.
Proof.
  intro H. apply filter_In in H. destruct H as [H _]. apply in_map_iff in H. destruct H as (n & <- & H). apply in_seq in H.
  unfold is_id. split; [lia|]. rewrite Nat.add_0_l in H. assert (N := proj2 H). apply Nat2Z.inj_lt in N. rewrite Z2Nat.id in N; [exact N|]. unfold none. lia.
Qed.
End around.

(* ---- The world ---- *)

Record metric := {
  site : Type;
  same_site : site -> site -> bool;
  distance : site -> site -> R;
  in_box : site -> Prop;                  (* in the coordinate domain *)
  read : R -> site -> site -> R;         (* base, fixed, moving *)
  is_below : site -> site -> R -> bool;  (* the comparison of squares with a threshold *)
  same_site_right : forall p q, same_site p q = true -> p = q;
  distance_nonneg : forall p q, 0 <= distance p q;
  distance_zero : forall p, distance p p = 0;
  distance_triangle : forall p q r, distance p r <= distance p q + distance q r;
  read_above : forall b f p, F b -> 0 <= b -> in_box f -> in_box p -> F (read b f p) /\ b + distance f p <= read b f p;
  threshold_holds : forall e b f p, (0 <= e <= never)%Z -> F b -> 0 <= b -> in_box f -> in_box p ->
    is_below f p (filter_doubles.threshold e b) = true -> b + distance f p < value e }.

Record family (P : Type) := {
  kind : Type;
  points_of : kind -> list nat;
  is_true : kind -> (nat -> P) -> Prop;
  relies_on : kind -> kind -> Prop }.      (* relies_on d c: c is certified given d *)

(* What is left open: the length of lists, after how many steps stamps wrap, when a displacement budget starts again. *)
Class options := Options {
  list_length : nat; stamps_there_are : Z; worn_out : R -> expiry_list -> bool; stamps_positive : (0 < stamps_there_are)%Z }.

Section numbered.
Variables (capacity : nat) (stamps : Z) (worn : R -> expiry_list -> bool).
Variables (D : metric) (K : family (site D)).

#[local] Instance numbered : world := {|
  position := site D; vertex := nat; certificate := kind _ K; same_vertex := Nat.eq_dec; same_position := same_site D;
  dist := distance D; points := points_of _ K; holds := is_true _ K; counts_on := relies_on _ K;
  algorithm_filter.capacity := capacity; algorithm_filter.stamps := stamps; algorithm_filter.worn := worn;
  around := around_all (points_of _ K);
  num := R; real := fun b => b; zero := 0; valid := in_box D; number := F; path_length_of := read D; below := is_below D;
  algorithm_filter.threshold := filter_doubles.threshold;
  sum_lower := float_sums.sum_lower; less := filter_doubles.less;
  half := lower |}.

Hypothesis stamps_pos : (0 < stamps)%Z.
Hypothesis relies_on_wf : well_founded (relies_on _ K).
Hypothesis is_local : forall c m m', (forall v, In v (points_of _ K c) -> m v = m' v) -> is_true _ K c m -> is_true _ K c m'.

#[local] Instance numbered_laws : laws.
Proof.
  split.
  - exact (distance_nonneg D).
  - exact (distance_zero D).
  - exact (distance_triangle D).
  - exact relies_on_wf.
  - exact is_local.
  - exact stamps_pos.
  - exact (around_all_right (points_of _ K)).
  - exact (around_all_ids (points_of _ K)).
  - exact (same_site_right D).
  - reflexivity.
  - exact F_0.
  - reflexivity.
  - exact (read_above D).
  - exact (threshold_holds D).
  - exact sum_lower_down.
  - exact less_down.
Qed.

(* ---- Tolerances ---- *)

Lemma near_or_same (c : certificate) m x t : 0 <= t -> (forall v, In v (points c) -> near m x t v) ->
  (forall v, In v (points c) -> dist (x v) (m v) < t) \/ forall v, In v (points c) -> x v = m v.
Proof.
  intros T N. destruct (Rle_lt_or_eq_dec 0 t T) as [P|E]; [left|right]; intros v I; destruct (N v I) as [H|H].
  - exact H.
  - rewrite H. change (distance D (x v) (x v) < t). now rewrite distance_zero.
  - exfalso. generalize (distance_nonneg D (x v) (m v)). change (distance D (x v) (m v) < t) in H. lra.
  - now symmetry.
Qed.

(* A certificate that holds, with nothing to spare. *)
Lemma holds_sound c x : holds c x -> sound c x 0.
Proof.
  intros H m N _. apply (is_local c x); [|exact H]. destruct (near_or_same c m x 0 (Rle_refl 0) N) as [L|S]; [|exact S].
  intros v I. generalize (distance_nonneg D (x v) (m v)). assert (L' := L v I). change (distance D (x v) (m v) < 0) in L'. lra.
Qed.

(* Whatever is repaired, inserted, recomputed in between. *)
Theorem evaluated_holds s x m verdicts z :
  (nat -> (0 <= epoch s)%Z) -> (forall v, valid (x v)) ->
  (forall k, In k verdicts -> m (id k) = Some (of k) /\ evaluated x k) -> (forall i c, m i = Some c -> In i (map id verdicts)) ->
  (forall i c, m i = Some c -> is_id i) -> (forall i c d, m i = Some c -> counts_on d c -> exists j, m j = Some d) ->
  calls {| of_filter := recompute x s m verdicts; tracks := true |} z ->
  forall i c, mesh (of_filter z) i = Some c -> holds c (moving (of_filter z)).
Proof.
  intros E X V A I C R. apply (from_the_start s x m verdicts z E X); [|exact R]. split; trivial.
  intros i c H. left. now apply A with c.
Qed.
End numbered.
