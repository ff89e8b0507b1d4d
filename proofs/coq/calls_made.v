(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* calls_example.v goes on: the fifth vertex is removed, and all move onto a circle and are evaluated by signs alone.

   - removal        the removal is a call (`inserted`)
   - by_signs        so is the step by signs (`signs_of_all`); of the one certificate of a circle the sign is 0, which integers tell (on_a_circle)
   - example         what program_delaunay_until says of all of them *)
From Coq Require Import Reals ZArith List Bool Lra Lia FunctionalExtensionality.
From Flocq Require Import Core.
From Coq Require Import Floats.
From Annulus Require Import points_2 operations bridge connect filter_2 returned_2 stages predicate_2 exact_sign_2.
From Annulus Require Import algorithm_list algorithm_filter algorithm_check algorithm_step algorithm_run filter_world filter_plane.
From Annulus Require Import plane_mesh plane_triangulation plane_certificates plane_audit filter_delaunay signed_2 plane_listed plane_calls filter_calls calls_example.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

Definition round : doubles := fun v => match v with 1 => at_place 0 (-4) | 3 => at_place 0 4 | _ => low v end%nat%float.
Lemma round_coordinates v : coordinates_2 (round v).
Proof. do 4 (destruct v as [|v]; [split; apply small_coordinate; trivial; reflexivity|]). exact (low_coordinates (S (S (S (S v))))). Qed.

Section calls.
Context {o : options}.
#[local] Existing Instance the_laws.

(* Vertex 4 is removed. *)
Definition fourth : state := stepped third (at_doubles high) [] (numbered level) (verdicts_of high level).
Theorem removal : program_call (removes 4) {| of_filter := third; tracks := true |} with_fifth {| of_filter := fourth; tracks := true |} level.
Proof.
  apply (inserted third high (removes 4) (numbered level) everything_there (verdicts_of high level)).
  - exact high_coordinates.
  - apply stepped_moving.
  - discriminate.
  - apply evaluates_all; [exact level_accepted|]. intros i Q. cbn [placed fold_left]. rewrite third_mesh. now apply (numbered_outside high with_fifth).
  - exact (accepted_glued high level level_accepted).
  - exact (numbered_lists high level level_accepted).
  - intro v. cbn [afterwards]. rewrite with_fifth_keeps. split; [|tauto]. intro I. split; [now left|]. intros ->. now apply (fourth_inserted 4).
  - now left.
Qed.

Lemma winds_on (f : doubles) T n : (forall v, (v < n)%nat -> is_integer unit (Prim2SF (x _ (f v))) = true /\ is_integer unit (Prim2SF (y _ (f v))) = true) ->
  (forall v, In v (border T) -> (v < n)%nat) -> length (filter (enters_z (fun v => point_of unit (read (f v)))) (ridges (border T))) = 1%nat ->
  winds_once (at_doubles f) (border T).
Proof.
  intros I B W. assert (H : forall v, (v < n)%nat -> here (fun v => point_of unit (read (f v))) (at_doubles f) (power unit) v).
  { intros v L. destruct (I v L) as [X Y]. apply integer_value in X, Y. unfold here, at_doubles, at_2. now rewrite (proj2 X), (proj2 Y). }
  unfold winds_once. rewrite (filter_ext_in _ (enters_z (fun v => point_of unit (read (f v))))); [exact W|].
  intros [[u v] w] R. destruct (ridge_in _ u v w R) as (U & V & X). apply B, H in U, V, X. unfold enters, enters_z.
  now rewrite !(up_here (fun v => point_of unit (read (f v))) (at_doubles f) (power unit) (bpow_gt_0 radix2 unit)).
Qed.
Lemma upright_winds : winds_once (at_doubles low) (border upright).
Proof. apply (winds_on low upright 4); [|intros v I; vm_compute in I; lia|reflexivity]. intros v L. do 4 (destruct v as [|v]; [split; reflexivity|]). lia. Qed.
Lemma level_winds : winds_once (at_doubles round) (border level).
Proof. apply (winds_on round level 4); [|intros v I; vm_compute in I; lia|reflexivity]. intros v L. do 4 (destruct v as [|v]; [split; reflexivity|]). lia. Qed.

(* All move, onto a circle: the certificate of that circle has the sign 0, which integers tell. *)
Definition fifth : state := move_to (at_doubles round) (with_mesh fourth (numbered level)).
Lemma on_a_circle : exact_empty_sphere_sign (round 0%nat) (round 2%nat) (round 1%nat) (round 3%nat) = 0%Z.
Proof. vm_compute. reflexivity. Qed.
Lemma level_signed i c : numbered level i = Some c -> signed round c.
Proof.
  intro M. assert (I : In c (certificates level)) by (apply (numbered_lists high level level_accepted); now exists i).
  cbv in I. repeat (destruct I as [<-|I]; [lazymatch goal with
    | |- signed _ (cell _ _ _) => eexists; split; [left; reflexivity|left; vm_compute; reflexivity]
    | |- signed _ (ridge _ _ _) => eexists; split; [left; reflexivity|left; left; vm_compute; reflexivity]
    | |- signed _ (circle _ _ _ _) => left; right; vm_compute; discriminate end|]).
  contradiction.
Qed.
Theorem by_signs : program_call no_event {| of_filter := fourth; tracks := true |} level {| of_filter := fifth; tracks := false |} level.
Proof.
  apply (signs_of_all fourth true round (numbered level)).
  - exact round_coordinates.
  - exact level_signed.
  - exact (accepted_glued high level level_accepted).
  - exact (numbered_lists high level level_accepted).
  - intro v. reflexivity.
  - exact level_winds.
Qed.

Definition event_of (i : nat) : event := match i with 1%nat => inserts 4 | 2%nat => removes 4 | _ => no_event end.
Definition system_of (i : nat) : system := match i with O => recomputed low (numbered upright) (verdicts_of low upright) blank
  | 1%nat => {| of_filter := second; tracks := true |} | 2%nat => {| of_filter := third; tracks := true |} | 3%nat => {| of_filter := fourth; tracks := true |}
  | _ => {| of_filter := fifth; tracks := false |} end.
Definition mesh_after (i : nat) : plane_mesh.mesh := match i with O => upright | 2%nat => with_fifth | _ => level end.

Lemma calls_made i : (i < 4)%nat -> program_call (event_of i) (system_of i) (mesh_after i) (system_of (S i)) (mesh_after (S i)).
Proof. intro L. do 4 (destruct i as [|i]; [first [exact flips|exact insertion|exact removal|exact by_signs]|]). lia. Qed.

Theorem example : (triangulation (at_doubles high) with_fifth /\ delaunay (at_doubles high) with_fifth) /\
  (triangulation (at_doubles round) level /\ delaunay (at_doubles round) level) /\ forall v, vertex_of with_fifth v <-> vertex_of upright v \/ v = 4%nat.
Proof.
  assert (D := program_delaunay_until 4 low (numbered upright) (verdicts_of low upright) blank event_of system_of mesh_after
    (recomputed_right low upright low_coordinates upright_accepted) (Z.le_refl 0) eq_refl (accepted_glued low upright upright_accepted)
    (numbered_lists low upright upright_accepted) upright_winds calls_made).
  destruct (D 2%nat ltac:(lia)) as (A & B & C), (D 4%nat ltac:(lia)) as (E & F & _). unfold places in A, B, E, F. cbn [system_of mesh_after of_filter] in *.
  unfold third in A, B. rewrite stepped_moving in A, B.
  split; [now split|]. split; [now split|exact C].
Qed.
End calls.
