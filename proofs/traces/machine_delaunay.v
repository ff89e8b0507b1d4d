(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* machine_runs.v in the plane and in space: what filter_calls.v and filter_delaunay_3.v prove of reals holds of the program on primitive floats.

   - grounded_2, grounded_3        the operations of machine.v on coordinates are those of the plane and of space
   - machine_delaunay              plane: after each of 2^49 calls of the program on primitive floats the cells triangulate the hull and are Delaunay
   - machine_delaunay_3            space: all certificates hold; hence the same
   - path_ratios               the numbers of limits.h, that the theorems may be used of *)
From Coq Require Import Reals ZArith Lia Lra List Bool.
From Flocq Require Import Core.
From Coq Require Import Floats.
From Annulus Require points_2 vectors plane_mesh plane_certificates space_mesh space_delaunay space_triangulation space_silhouette.
From Annulus Require Import operations bridge filter_2 filter_3 connect returned_2 returned_3.
From Annulus_traces Require Import machine machine_rounds machine_never.
From Annulus Require Import algorithm_list truncated_double filter_doubles filter_world filter_plane filter_space filter_delaunay filter_delaunay_3 space_calls.
From Annulus Require Import algorithm_filter algorithm_run plane_listed plane_calls filter_calls.
From Annulus_traces Require Import machine_state machine_reach machine_steps machine_writes machine_runs.
Import ListNotations.
Notation real := operations.value.
Close Scope float_scope.
Open Scope R_scope.
#[local] Opaque bpow.

(* ---- Points of doubles ---- *)

Lemma coordinate_in_bounds f : coordinate f -> in_bounds f.
Proof. exact (coordinate_stands f). Qed.

Lemma req_dec a b : Req_bool a b = if Req_EM_T a b then true else false.
Proof. case Req_bool_spec; intro; destruct (Req_EM_T a b); trivial; contradiction. Qed.

Definition grounded_2 : grounded metric_2.
Proof.
  refine (@Build_grounded metric_2 (vector operations.machine) (fun v => [x _ v; y _ v]) at_2 coordinates_2 coordinates_valid _ _ _ _).
  - intros p q [[P1 _] [P2 _]] [[Q1 _] [Q2 _]]. unfold same_coordinates. cbn [combine forallb fst snd].
    change (same_site metric_2) with same_point. unfold same_point, at_2. cbn [fst snd].
    rewrite !same_stands, !req_dec, andb_true_r by assumption. destruct (Req_EM_T _ _); [|reflexivity]. now destruct (Req_EM_T _ _).
  - intros a b f p A B [F1 F2] [P1 P2]. apply path_length_stands_2; trivial; now apply coordinate_in_bounds.
  - intros b f p [F1 F2] [P1 P2]. exists (float_displacement.distance_upper_2 (real (x _ p)) (real (y _ p)) (real (x _ f)) (real (y _ f))). split; [|reflexivity].
    destruct (way_stands_2 (x _ f) (y _ f) (x _ p) (y _ p)) as (_ & _ & W); try now apply coordinate_in_bounds. apply Rabs_le_inv in W. split; [|apply W].
    apply Rle_trans with (2 := float_displacement.distance_upper_2_sound _ _ _ _ (value_format _) (value_format _) (value_format _) (value_format _)). apply sqrt_pos.
  - intros f p r R [F1 F2] [P1 P2]. apply below_stands_2; trivial; now apply coordinate_in_bounds.
Defined.

Definition grounded_3 : grounded metric_3.
Proof.
  refine (@Build_grounded metric_3 (vector_3 operations.machine) (fun v => [x3 _ v; y3 _ v; z3 _ v]) at_3 coordinates_3 coordinates_valid_3 _ _ _ _).
  - intros p q ([P1 _] & [P2 _] & [P3 _]) ([Q1 _] & [Q2 _] & [Q3 _]). unfold same_coordinates. cbn [combine forallb fst snd].
    change (same_site metric_3) with same_point_3. unfold same_point_3, at_3. cbn [vectors.X1 vectors.X2 vectors.X3].
    rewrite !same_stands, !req_dec, andb_true_r by assumption.
    destruct (Req_EM_T _ _); [|reflexivity]. destruct (Req_EM_T _ _); [|reflexivity]. now destruct (Req_EM_T _ _).
  - intros a b f p A B (F1 & F2 & F3) (P1 & P2 & P3). apply path_length_stands_3; trivial; now apply coordinate_in_bounds.
  - intros b f p (F1 & F2 & F3) (P1 & P2 & P3).
    exists (float_displacement.distance_upper_3 (real (x3 _ p)) (real (y3 _ p)) (real (z3 _ p)) (real (x3 _ f)) (real (y3 _ f)) (real (z3 _ f))). split; [|reflexivity].
    destruct (way_stands_3 (x3 _ f) (y3 _ f) (z3 _ f) (x3 _ p) (y3 _ p) (z3 _ p)) as (_ & _ & W); try now apply coordinate_in_bounds. apply Rabs_le_inv in W.
    split; [|apply W]. apply Rle_trans with (2 := float_displacement.distance_upper_3_sound _ _ _ _ _ _ (value_format _) (value_format _) (value_format _)
      (value_format _) (value_format _) (value_format _)). apply sqrt_pos.
  - intros f p r R (F1 & F2 & F3) (P1 & P2 & P3). apply below_stands_3; trivial; now apply coordinate_in_bounds.
Defined.

(* How much further than its certificates a displacement budget goes: Wide_limits::path_ratio and Tiny_limits::path_ratio can be asked for below. *)
Lemma path_ratios : forall ratio, In ratio [0x1p8; 2]%float -> 1 <= real ratio /\ stands 20 ratio (real ratio).
Proof.
  intros ratio [<-|[<-|[]]].
  - assert (E : real 0x1p8%float = 256) by (rewrite (real_of 0x1p8%float 4503599627370496 (-44) eq_refl); change (power (-44)) with (/ 17592186044416); lra).
    rewrite E. split; [lra|]. split; [reflexivity|split; [exact E|]]. rewrite Rabs_pos_eq by lra. change (power 20) with 1048576. lra.
  - assert (E : real 2%float = 2) by (rewrite (real_of 2%float 4503599627370496 (-51) eq_refl); change (power (-51)) with (/ 2251799813685248); lra).
    rewrite E. split; [lra|]. split; [reflexivity|split; [exact E|]]. rewrite Rabs_pos_eq by lra. change (power 20) with 1048576. lra.
Qed.

(* ---- The plane ---- *)

Section plane.
Variables (capacity : nat) (stamps : Z) (ratio : float).
Hypothesis stamps_pos : (0 < stamps)%Z.
Hypothesis ratio_least : 1 <= real ratio.
Hypothesis ratio_stands : stands 20 ratio (real ratio).
#[local] Instance as_reals : options := Options capacity stamps (worn_real ratio) stamps_pos.
Notation K := (family_2 plane_certificates.no_fold).
Notation floats := (floats capacity stamps ratio metric_2 K grounded_2).
Notation state_of := (state_of capacity stamps ratio metric_2 K grounded_2).
Notation verdict_of := (verdict_of capacity stamps ratio metric_2 K grounded_2).
Notation deed_of := (deed_of capacity stamps ratio metric_2 K grounded_2).
Notation proper_verdict := (proper_verdict capacity stamps ratio metric_2 K grounded_2).
Notation fit := (fit capacity stamps ratio metric_2 K grounded_2).
Notation small := (small capacity stamps ratio metric_2 K grounded_2).

(* What a call of the program decides is judged where the machine's numbers are (program_call); what it does to them is computed with floats (done). *)
Definition machine_call (e : event) (s : @state floats) (b : bool) (T : plane_mesh.mesh) (d : @deed floats) (s' : @state floats) (b' : bool) (T' : plane_mesh.mesh) : Prop :=
  s' = done s d /\ fit d /\
  program_call e {| of_filter := state_of s; tracks := b |} T {| of_filter := done (state_of s) (deed_of d); tracks := b' |} T'.

Theorem machine_delaunay n (f : doubles) m (verdicts : list (@verdict floats)) (before : @state floats) (e : nat -> event) (s : nat -> @state floats)
    (b : nat -> bool) (d : nat -> @deed floats) (T : nat -> plane_mesh.mesh) : (Z.of_nat n < 2 ^ 49)%Z ->
  start f m (map verdict_of verdicts) -> (forall k, In k verdicts -> proper_verdict k) ->
  (0 <= epoch before)%Z -> (forall i v, small_expiry (expiry (record before i) v)) ->
  s O = recompute (f : @placement floats) before m verdicts -> b O = true ->
  plane_mesh.glued (T O) -> lists m (T O) -> plane_mesh.winds_once (at_doubles f) (plane_mesh.border (T O)) ->
  (forall i, (i < n)%nat -> machine_call (e i) (s i) (b i) (T i) (d i) (s (S i)) (b (S i)) (T (S i))) ->
  forall i, (i <= n)%nat -> let places := fun v => at_2 (moving (s i) v) in plane_mesh.triangulation places (T i) /\ plane_mesh.delaunay places (T i) /\
    forall v, plane_mesh.vertex_of (T i) v <-> present (plane_mesh.vertex_of (T O)) e i v.
Proof.
  intros N St V E Old S0 B0 Gl Li Wi C.
  assert (Z0 := fun B => recomputed_same capacity stamps ratio metric_2 K grounded_2 B (f : @placement floats) before m verdicts (in_domain _ _ _ St) Old (ids _ _ _ St) V).
  assert (R : forall i, (i < n)%nat -> state_of (s (S i)) = done (state_of (s i)) (deed_of (d i))).
  { intros i L. apply (runs_same _ _ _ ratio_least ratio_stands _ _ grounded_2 s d n); trivial.
    - intro B. rewrite S0. apply Z0.
    - intros j J. now destruct (C j J) as (E' & F & _).
    - apply within_reach_of. lia. }
  set (y := fun i => {| of_filter := state_of (s i); tracks := b i |}).
  assert (Q : y O = recomputed f m (map verdict_of verdicts) (state_of before)) by (unfold y; rewrite B0, S0; unfold recomputed; now rewrite (proj2 (Z0 (first_reach)))).
  exact (program_delaunay_until n f m (map verdict_of verdicts) (state_of before) e y T St E Q Gl Li Wi
    (fun i L => eq_ind_r (fun z => program_call _ {| of_filter := _; tracks := _ |} _ {| of_filter := z; tracks := _ |} _) (proj2 (proj2 (C i L))) (R i L))).
Qed.
End plane.

(* ---- Space ---- *)

Section space.
Variables (capacity : nat) (stamps : Z) (ratio : float).
Hypothesis stamps_pos : (0 < stamps)%Z.
Hypothesis ratio_least : 1 <= real ratio.
Hypothesis ratio_stands : stands 20 ratio (real ratio).
#[local] Instance as_reals_3 : options := Options capacity stamps (worn_real ratio) stamps_pos.
Notation K := (family_3 no_fold_3).
Notation floats := (floats capacity stamps ratio metric_3 K grounded_3).
Notation state_of := (state_of capacity stamps ratio metric_3 K grounded_3).
Notation verdict_of := (verdict_of capacity stamps ratio metric_3 K grounded_3).
Notation deed_of := (deed_of capacity stamps ratio metric_3 K grounded_3).
Notation proper_verdict := (proper_verdict capacity stamps ratio metric_3 K grounded_3).
Notation fit := (fit capacity stamps ratio metric_3 K grounded_3).

Definition machine_call_3 (s : @state floats) (b : bool) (d : @deed floats) (s' : @state floats) (b' : bool) : Prop :=
  s' = done s d /\ fit d /\ space_call {| of_filter := state_of s; tracks := b |} {| of_filter := done (state_of s) (deed_of d); tracks := b' |}.

Theorem machine_delaunay_3 n (f : doubles_3) m (verdicts : list (@verdict floats)) (before : @state floats) (s : nat -> @state floats) (b : nat -> bool)
    (d : nat -> @deed floats) : (Z.of_nat n < 2 ^ 49)%Z ->
  start_in_space f m (map verdict_of verdicts) -> (forall k, In k verdicts -> proper_verdict k) ->
  (0 <= epoch before)%Z -> (forall i v, small_expiry (expiry (record before i) v)) ->
  s O = recompute (f : @placement floats) before m verdicts -> b O = true ->
  (forall i, (i < n)%nat -> machine_call_3 (s i) (b i) (d i) (s (S i)) (b (S i))) ->
  forall i, (i <= n)%nat -> let places := fun v => at_3 (moving (s i) v) in
    (forall j c, mesh (s i) j = Some c -> holds_3 no_fold_3 c places) /\
    forall T U L, space_mesh.glued_3 T -> (forall c, In c (certificates_3 T U L) -> exists j, mesh (s i) j = Some c) ->
      space_silhouette.silhouette_once places T U L -> space_triangulation.triangulation_3 places T /\ space_delaunay.delaunay_3 places T.
Proof.
  intros N St V E Old S0 B0 C.
  assert (Z0 := fun B => recomputed_same capacity stamps ratio metric_3 K grounded_3 B (f : @placement floats) before m verdicts (in_domain_3 _ _ _ St) Old (ids_3 _ _ _ St) V).
  assert (R : forall i, (i < n)%nat -> state_of (s (S i)) = done (state_of (s i)) (deed_of (d i))).
  { intros i L. apply (runs_same _ _ _ ratio_least ratio_stands _ _ grounded_3 s d n); trivial.
    - intro B. rewrite S0. apply Z0.
    - intros j J. now destruct (C j J) as (E' & F & _).
    - apply within_reach_of. lia. }
  assert (A : forall i, (i <= n)%nat -> space_calls (recomputed_in_space f m (map verdict_of verdicts) (state_of before)) {| of_filter := state_of (s i); tracks := b i |}).
  { induction i as [|i IH]; intro L.
    - rewrite S0, B0, (proj2 (Z0 first_reach)). apply at_first.
    - apply and_then with {| of_filter := state_of (s i); tracks := b i |}; [apply IH; lia|]. rewrite (R i ltac:(lia)). exact (proj2 (proj2 (C i ltac:(lia)))). }
  assert (Q := fun i L => space_calls_are_calls f m (map verdict_of verdicts) (state_of before) _ St E (A i L)). intros i L places. split.
  - intros j c M. exact (filter_holds_3 f m (map verdict_of verdicts) (state_of before) _ St E (Q i L) j c M).
  - intros T U W G P Si. exact (filter_delaunay_3 f m (map verdict_of verdicts) (state_of before) _ T U W St E (Q i L) G P Si).
Qed.
End space.
