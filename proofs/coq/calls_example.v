(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* That there are calls: what `start` and `program_call` require can be satisfied. Four doubles that are a kite, two triangles of it, and all that the filtered predicate
   answers of them, computed; one vertex moves, and the diagonal is flipped; a fifth vertex is inserted. What follows is in calls_made.v.

   - recomputed_right   where the filtered predicate says yes to all certificates of a mesh, the filter can start
   - flips           the move is a call (`step`, `inside`)
   - insertion        and so is the insertion (`inserted`) *)
From Coq Require Import Reals ZArith List Bool Lra Lia FunctionalExtensionality.
From Flocq Require Import Core.
From Coq Require Import Floats.
From Annulus Require Import points_2 operations bridge connect filter_2 returned_2 stages predicate_2.
From Annulus Require Import algorithm_list algorithm_filter algorithm_check algorithm_step algorithm_run filter_world filter_plane.
From Annulus Require Import plane_mesh plane_triangulation plane_certificates plane_audit filter_delaunay plane_listed plane_calls filter_calls.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

(* ---- Points, meshes ---- *)

Definition at_place (a b : float) : filter_2.vector machine := filter_2.Build_vector machine a b.
(* The vertex 3 is at (0, top). *)
Definition kite (top : float) : doubles := fun v =>
  match v with
  | 0 => at_place (-4) 0 | 1 => at_place 0 (-2) | 2 => at_place 4 0 | 3 => at_place 0 top | _ => at_place 0 10
  end%nat%float.
Definition low := kite 3.
Definition high := kite 20.
Definition upright := mesh_of [(0, 1, 3); (1, 2, 3)]%nat.
Definition level := mesh_of [(0, 1, 2); (0, 2, 3)]%nat.
Definition with_fifth := mesh_of [(0, 1, 2); (0, 2, 4); (2, 3, 4); (3, 0, 4)]%nat.

(* As integers. *)
Definition unit : Z := (-60)%Z.
Lemma small_coordinate a : is_integer unit (Prim2SF a) = true -> (Z.abs (integer unit (Prim2SF a)) <=? 2 ^ 67)%Z = true -> coordinate a.
Proof.
  intros I L. destruct (integer_value unit a I) as [F V]. split; [exact F|]. apply Z.leb_le, IZR_le in L. rewrite abs_IZR, (IZR_Zpower radix2) in L by lia.
  rewrite V, Rabs_mult, (Rabs_pos_eq (power unit)) by apply bpow_ge_0. apply Rle_trans with (power unit * power 67).
  - apply Rmult_le_compat_l; [apply bpow_ge_0|exact L].
  - rewrite <- bpow_plus. now apply bpow_le.
Qed.
Lemma kite_coordinates top : is_integer unit (Prim2SF top) = true -> (Z.abs (integer unit (Prim2SF top)) <=? 2 ^ 67)%Z = true -> forall v, coordinates_2 (kite top v).
Proof. intros I L v. do 4 (destruct v as [|v]; [split; apply small_coordinate; trivial; reflexivity|]). split; apply small_coordinate; reflexivity. Qed.
Lemma low_coordinates v : coordinates_2 (low v).
Proof. now apply kite_coordinates. Qed.
Lemma high_coordinates v : coordinates_2 (high v).
Proof. now apply kite_coordinates. Qed.
(* ---- What the filtered predicate says of a mesh ---- *)

Definition numbered (T : plane_mesh.mesh) (i : Z) : option certificate_2 := if (i <? 0)%Z then None else nth_error (certificates T) (Z.to_nat i).
Definition answer_of (f : doubles) (c : certificate_2) : answer float :=
  match c with
  | cell a b c | ridge a b c => orientation_predicate false (f a) (f b) (f c)
  | circle a b p q => empty_sphere_predicate false (f a) (f b) (f p) (f q)
  end.
Definition says_yes (f : doubles) (c : certificate_2) : bool :=
  all_differ Nat.eqb (points_2 c) && match answer_of f c with filter_2.positive _ => true | _ => false end.
Definition accepted (f : doubles) (T : plane_mesh.mesh) : bool :=
  even T && forallb (says_yes f) (certificates T) && (length (certificates T) <=? 100)%nat.

Section calls.
Context {o : options}.
#[local] Existing Instance the_laws.

Definition verdict_of (f : doubles) (T : plane_mesh.mesh) (n : nat) : verdict :=
  let c := nth n (certificates T) (cell 0 0 0) in
  {| id := Z.of_nat n; of := c; bound := match answer_of f c with filter_2.positive t => operations.value t | _ => 0 end |}.
Definition verdicts_of (f : doubles) (T : plane_mesh.mesh) : list verdict := map (verdict_of f T) (seq 0 (length (certificates T))).

Lemma numbered_lists f T : accepted f T = true -> lists (numbered T) T.
Proof.
  unfold accepted. rewrite !andb_true_iff, Nat.leb_le. intros [_ L]. split.
  - intro c. split.
    + intro I. apply In_nth_error in I. destruct I as (n & N). exists (Z.of_nat n). unfold numbered.
      replace (Z.of_nat n <? 0)%Z with false by (symmetry; apply Z.ltb_ge; lia). now rewrite Nat2Z.id.
    + intros (i & M). unfold numbered in M. destruct (i <? 0)%Z; [discriminate|]. now apply nth_error_In in M.
  - intros i c M. unfold numbered in M. destruct (Z.ltb_spec i 0); [discriminate|]. assert (N : (Z.to_nat i < length (certificates T))%nat) by (apply nth_error_Some; congruence).
    unfold is_id, none. lia.
Qed.
Lemma accepted_glued f T : accepted f T = true -> glued T.
Proof. unfold accepted. rewrite !andb_true_iff. intros [[E _] _]. now apply glued_by_edges. Qed.
Lemma all_verdicts T f i c : numbered T i = Some c -> In i (map id (verdicts_of f T)).
Proof.
  unfold numbered. destruct (Z.ltb_spec i 0); [discriminate|]. intro N. unfold verdicts_of. rewrite map_map. apply in_map_iff. exists (Z.to_nat i).
  split; [cbn [id verdict_of]; lia|]. apply in_seq. split; [lia|]. apply nth_error_Some. congruence.
Qed.
Lemma verdicts_answered f T : accepted f T = true -> forall k, In k (verdicts_of f T) -> numbered T (id k) = Some (of k) /\ is_answer f k.
Proof.
  unfold accepted. rewrite !andb_true_iff, forallb_forall. intros [[_ A] _] k K. apply in_map_iff in K. destruct K as (n & <- & K). apply in_seq in K.
  assert (N : nth_error (certificates T) n = Some (nth n (certificates T) (cell 0 0 0))) by (apply nth_error_nth'; lia). split.
  - unfold numbered. cbn [id of verdict_of]. replace (Z.of_nat n <? 0)%Z with false by (symmetry; apply Z.ltb_ge; lia). now rewrite Nat2Z.id.
  - specialize (A _ (nth_error_In _ _ N)). unfold says_yes in A. rewrite andb_true_iff in A. destruct A as [_ A]. exists false. cbn [of bound verdict_of].
    destruct (nth n (certificates T) (cell 0 0 0)) as [a b c|a b c|a b p q]; cbn [answer_of] in *;
      match goal with |- says ?x _ _ => destruct x; try discriminate A; reflexivity end.
Qed.

Theorem recomputed_right f T : (forall v, coordinates_2 (f v)) -> accepted f T = true -> start f (numbered T) (verdicts_of f T).
Proof.
  intros D A. split; trivial.
  - now apply verdicts_answered.
  - intros i c. apply all_verdicts.
  - intros i c M. now apply (numbered_lists f T A) in M.
  - apply (circles_counted (numbered T) T (numbered_lists f T A) (accepted_glued f T A)). intros [[a b] c] I.
    assert (N := cell_listed T _ I). cbn beta iota in N. unfold accepted in A. rewrite !andb_true_iff, forallb_forall in A. destruct A as [[_ A] _].
    specialize (A _ N). unfold says_yes in A. rewrite andb_true_iff in A. destruct A as [K _]. apply (all_differ_right Nat.eqb) in K; [|intro; apply Nat.eqb_refl].
    revert K. unfold least_first. destruct (_ && _)%bool; [|destruct (_ && _)%bool]; cbn [points_2]; intro K; inversion K as [|? ? N1 K1]; subst;
      inversion K1 as [|? ? N2 K2]; subst; simpl in *; repeat split; intro E; subst; tauto.
Qed.

(* Repair evaluates everything that there is. *)
Lemma evaluates_all f T old pending : accepted f T = true -> (forall i, (i < 0 \/ 100 <= i)%Z -> old i = None) ->
  evaluates f old (numbered T) pending (map Z.of_nat (seq 0 100)) (verdicts_of f T).
Proof.
  intros A O. split; [now apply verdicts_answered|intros i c _; apply all_verdicts|]. intros i N.
  assert (Q : (i < 0 \/ 100 <= i)%Z).
  { destruct (Z.ltb_spec i 0); [now left|]. destruct (Z.ltb_spec i 100) as [L|]; [|now right]. exfalso. apply N, in_map_iff. exists (Z.to_nat i). rewrite in_seq. lia. }
  rewrite (O i Q). unfold accepted in A. rewrite !andb_true_iff, Nat.leb_le in A. destruct A as [_ A]. unfold numbered. destruct (Z.ltb_spec i 0); [reflexivity|].
  apply nth_error_None. lia.
Qed.
Lemma numbered_outside f T i : accepted f T = true -> (i < 0 \/ 100 <= i)%Z -> numbered T i = None.
Proof.
  intros A Q. unfold accepted in A. rewrite !andb_true_iff, Nat.leb_le in A. destruct A as [_ A]. unfold numbered. destruct (Z.ltb_spec i 0); [reflexivity|].
  apply nth_error_None. lia.
Qed.

(* ---- The calls ---- *)

(* The filter before it starts, when nothing is in it. *)
Definition blank : state := {|
  moving := at_doubles low; algorithm_filter.mesh := fun _ => None; epoch := 0; anchored := [];
  at_ := fun v => {| fixed := at_doubles low v; base := 0; room := 0; listing := cleared capacity; stamp := 0 |};
  record := fun _ => {| expiry := fun _ => 0%Z; reference := at_doubles low; origin := fun _ => 0; allowance := 0 |} |}.
Definition first : state := recompute (at_doubles low) blank (numbered upright) (verdicts_of low upright).
(* Vertex 3 moves. *)
Definition second : state := stepped first (at_doubles high) (find_failed first (at_doubles high) [3%nat]) (numbered level) (verdicts_of high level).
(* Vertex 4 is inserted. *)
Definition third : state :=
  stepped (fold_left place (placed high (inserts 4)) second) (at_doubles high) [] (numbered with_fifth) (verdicts_of high with_fifth).

Lemma upright_accepted : accepted low upright = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma level_accepted : accepted high level = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma fifth_accepted : accepted high with_fifth = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Lemma moved_alone : covered first (at_doubles high) [3%nat].
Proof.
  intro v. change (moving first) with (at_doubles low). do 3 (destruct v as [|v]; [now right|]). destruct v as [|v]; [left; now left|now right].
Qed.
Lemma stepped_moving s x failed m verdicts : moving (stepped s x failed m verdicts) = x.
Proof. reflexivity. Qed.

Lemma started : right {| of_filter := first; tracks := true |} /\ algorithm_filter.mesh first = numbered upright.
Proof.
  assert (St := recomputed_right low upright low_coordinates upright_accepted).
  apply (@algorithm_run.recompute_keeps the_plane (the_laws) (at_doubles low) blank (numbered upright) (verdicts_of low upright)).
  - intros _. apply Z.le_refl.
  - intro v. apply coordinates_valid, low_coordinates.
  - now apply start_recomputes.
Qed.

Definition everything_there : list Z := map Z.of_nat (seq 0 100).
Lemma second_evaluated : let (u, pending) := find_expired first (at_doubles high) (find_failed first (at_doubles high) [3%nat]) in
  evaluates high (algorithm_filter.mesh u) (numbered level) pending everything_there (verdicts_of high level).
Proof.
  unfold find_expired. apply evaluates_all; [exact level_accepted|]. intros i Q. cbn [algorithm_filter.mesh].
  rewrite (t_mesh first (at_doubles high) _ (proj1 started) (fun v => coordinates_valid _ (high_coordinates v))), (proj2 started).
  now apply (numbered_outside low upright).
Qed.

Theorem flips : program_call no_event {| of_filter := first; tracks := true |} upright {| of_filter := second; tracks := true |} level.
Proof.
  apply (step first high [3%nat] (numbered level) everything_there (verdicts_of high level) inside).
  - exact high_coordinates.
  - exact moved_alone.
  - exact second_evaluated.
  - split; [exact (accepted_glued high level level_accepted)|]. split; [|reflexivity]. intro v. split; intros (t & I & C); cbn in I.
    + destruct I as [<-|[<-|[]]]; destruct C as [->|[->| ->]]; [exists (0, 1, 3)%nat|exists (0, 1, 3)%nat|exists (1, 2, 3)%nat|exists (0, 1, 3)%nat|exists (1, 2, 3)%nat|
        exists (0, 1, 3)%nat]; cbn; tauto.
    + destruct I as [<-|[<-|[]]]; destruct C as [->|[->| ->]]; [exists (0, 1, 2)%nat|exists (0, 1, 2)%nat|exists (0, 2, 3)%nat|exists (0, 1, 2)%nat|exists (0, 1, 2)%nat|
        exists (0, 2, 3)%nat]; cbn; tauto.
  - exact (numbered_lists high level level_accepted).
  - discriminate.
Qed.

Lemma second_mesh : algorithm_filter.mesh second = numbered level.
Proof.
  exact (proj1 (step_ends first high [3%nat] (numbered level) everything_there (verdicts_of high level) level (proj1 started)
    high_coordinates moved_alone (accepted_glued high level level_accepted) (numbered_lists high level level_accepted) second_evaluated)).
Qed.

Lemma place_mesh s n : algorithm_filter.mesh (place s n) = algorithm_filter.mesh s.
Proof. now destruct n. Qed.
Lemma placed_moving : moving (fold_left place (placed high (inserts 4)) second) = at_doubles high.
Proof.
  cbn [placed fold_left place move_to moving]. unfold second. rewrite stepped_moving. apply functional_extensionality. intro v.
  destruct (Nat.eq_dec v 4) as [->|N]; [now rewrite set_same|now rewrite set_other].
Qed.

Lemma second_right : right {| of_filter := second; tracks := true |}.
Proof.
  assert (Ls : lists (algorithm_filter.mesh first) upright) by (rewrite (proj2 started); exact (numbered_lists low upright upright_accepted)).
  refine (call_keeps _ _ (proj1 started) _).
  exact (program_call_is_call no_event _ upright _ level (proj1 started) (accepted_glued low upright upright_accepted) Ls flips
    (accepted_glued high level level_accepted)).
Qed.
Lemma fourth_inserted v : inserts 4 = inserts v -> ~ vertex_of level v.
Proof. intros E (t & I & C). injection E as <-. cbn in I. destruct I as [<-|[<-|[]]]; cbn in C; lia. Qed.
Lemma third_evaluated : evaluates high (algorithm_filter.mesh (fold_left place (placed high (inserts 4)) second)) (numbered with_fifth) [] everything_there
  (verdicts_of high with_fifth).
Proof. apply evaluates_all; [exact fifth_accepted|]. intros i Q. cbn [placed fold_left]. rewrite place_mesh, second_mesh. now apply (numbered_outside high level). Qed.
Lemma third_mesh : algorithm_filter.mesh third = numbered with_fifth.
Proof.
  assert (Ls : lists (algorithm_filter.mesh second) level) by (rewrite second_mesh; exact (numbered_lists high level level_accepted)).
  exact (proj1 (inserted_ends second high (inserts 4) (numbered with_fifth) everything_there (verdicts_of high with_fifth) level
    with_fifth second_right (accepted_glued high level level_accepted) Ls high_coordinates placed_moving fourth_inserted third_evaluated
    (accepted_glued high with_fifth fifth_accepted) (numbered_lists high with_fifth fifth_accepted))).
Qed.

Lemma with_fifth_keeps v : vertex_of with_fifth v <-> vertex_of level v \/ v = 4%nat.
Proof.
  split.
  - intros (t & I & C). assert (v <= 4)%nat by (cbn in I; destruct I as [<-|[<-|[<-|[<-|[]]]]]; cbn in C; lia).
    destruct (Nat.eq_dec v 4); [now right|left]. exists (if (v =? 1)%nat then (0, 1, 2) else (0, 2, 3))%nat. destruct (Nat.eqb_spec v 1); (split; [simpl; tauto|cbn; lia]).
  - intros [(t & I & C)| ->]; [|exists (0, 2, 4)%nat; cbn; tauto]. cbn in I. destruct I as [<-|[<-|[]]]; [exists (0, 1, 2)%nat; cbn in *; tauto|].
    destruct C as [->|[->| ->]]; [exists (0, 1, 2)%nat|exists (0, 1, 2)%nat|exists (2, 3, 4)%nat]; cbn; tauto.
Qed.

Theorem insertion : program_call (inserts 4) {| of_filter := second; tracks := true |} level {| of_filter := third; tracks := true |} with_fifth.
Proof.
  apply (inserted second high (inserts 4) (numbered with_fifth) everything_there (verdicts_of high with_fifth)).
  - exact high_coordinates.
  - exact placed_moving.
  - exact fourth_inserted.
  - exact third_evaluated.
  - exact (accepted_glued high with_fifth fifth_accepted).
  - exact (numbered_lists high with_fifth fifth_accepted).
  - exact with_fifth_keeps.
  - now left.
Qed.
End calls.
