(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What one call of the program may be in space: plane_calls.v without the mesh, of which it requires only that its certificates have numbers and that the
   cells of each sphere are among them (`complete`).

   - evaluates_3         what Repair does: it evaluates all pending certificates that are there, and all certificates of cells that it touched
   - space_call          what one call may be
   - evaluates_repaired_3   what Repair does is what the model of the filter requires of it (`repaired`)
   - space_calls_are_calls  hence after any number of such calls every certificate holds (filter_delaunay_3.v) *)
From Coq Require Import Reals ZArith List.
From Annulus Require Import vectors filter_doubles returned_3 algorithm_list algorithm_filter algorithm_check algorithm_step algorithm_run filter_world filter_space.
From Annulus Require Import space_mesh space_crossings filter_delaunay_3 signed_3.
Import ListNotations.
Open Scope R_scope.

Section calls.
Context {o : options}.
#[local] Existing Instance the_space.

(* An inserted vertex is put where the doubles say. *)
Definition placed_3 (f : doubles_3) (newcomers : list nat) : list (vertex * position) := map (fun v => (v, at_doubles_3 f v)) newcomers.
Record complete (m : Z -> option certificate_3) : Prop := {
  numbers_are_ids : forall i c, m i = Some c -> is_id i;
  cells_are_there : forall i c d, m i = Some c -> counts_on_3 d c -> exists j, m j = Some d }.
(* Repair::evaluate and holds_after_flips, when they say yes. `touched`: the numbers of cells that were made or changed, and of their facets. *)
Record evaluates_3 (f : doubles_3) (old new : Z -> option certificate_3) (pending touched : list Z) (verdicts : list verdict) : Prop := {
  each_answered_3 : forall k, In k verdicts -> new (id k) = Some (of k) /\ is_answer_in_space f k;
  none_left_3 : forall i c, In i pending \/ In i touched -> new i = Some c -> In i (map id verdicts);
  others_same_3 : forall i, ~ In i touched -> new i = old i }.

Inductive space_call : system -> system -> Prop :=
  (* move, move_all: all vertices pass *)
  | all_pass_3 s f movers : (forall v, coordinates_3 (f v)) -> covered s (at_doubles_3 f) movers -> find_failed s (at_doubles_3 f) movers = [] ->
      space_call {| of_filter := s; tracks := true |} {| of_filter := move_to (at_doubles_3 f) s; tracks := true |}
  (* some vertex fails: evaluated, flipped or rebuilt, and evaluated again *)
  | step_3 s f movers m touched verdicts : (forall v, coordinates_3 (f v)) -> covered s (at_doubles_3 f) movers ->
      (let (u, pending) := find_expired s (at_doubles_3 f) (find_failed s (at_doubles_3 f) movers) in
       evaluates_3 f (algorithm_filter.mesh u) m pending touched verdicts) -> complete m ->
      space_call {| of_filter := s; tracks := true |}
        {| of_filter := stepped s (at_doubles_3 f) (find_failed s (at_doubles_3 f) movers) m verdicts; tracks := true |}
  (* the call is refused *)
  | step_fails_3 s f movers : (forall v, coordinates_3 (f v)) -> covered s (at_doubles_3 f) movers ->
      let failed := find_failed s (at_doubles_3 f) movers in
      space_call {| of_filter := s; tracks := true |}
        {| of_filter := undo_anchoring (begin_anchoring s) (fst (find_expired s (at_doubles_3 f) failed)) failed; tracks := true |}
  (* insertion and removal, while tolerances are kept; or cells have other numbers *)
  | inserted_3 s f newcomers m touched verdicts : (forall v, coordinates_3 (f v)) ->
      let t := fold_left place (placed_3 f newcomers) s in moving t = at_doubles_3 f ->
      (forall v i c, In v newcomers -> algorithm_filter.mesh s i = Some c -> ~ In v (points_3 c)) ->
      evaluates_3 f (algorithm_filter.mesh t) m [] touched verdicts -> complete m ->
      space_call {| of_filter := s; tracks := true |} {| of_filter := stepped t (at_doubles_3 f) [] m verdicts; tracks := true |}
  (* all is evaluated *)
  | recomputes_all_3 s b f m verdicts : start_in_space f m verdicts -> space_call {| of_filter := s; tracks := b |} (recomputed_in_space f m verdicts s)
  (* by signs alone (signed_3.v): of everything, when many moved *)
  | signs_of_all_3 s b f m : (forall v, coordinates_3 (f v)) -> (forall i c, m i = Some c -> signed_3 f c) -> complete m ->
      space_call {| of_filter := s; tracks := b |} {| of_filter := move_to (at_doubles_3 f) (with_mesh s m); tracks := false |}
  (* a rebuild, and insertion and removal without tolerances: CGAL's word for all of it *)
  | rebuilt_3 s b f m : (forall v, coordinates_3 (f v)) -> (forall i c, m i = Some c -> holds_3 no_fold_3 c (at_doubles_3 f)) -> complete m ->
      space_call {| of_filter := s; tracks := b |} {| of_filter := move_to (at_doubles_3 f) (with_mesh s m); tracks := false |}
  (* or of what contains the one vertex that moves *)
  | signs_of_one_3 s f v m : (forall n, coordinates_3 (f n)) -> covered s (at_doubles_3 f) [v] ->
      (forall i c, m i = Some c -> signed_3 f c \/ (algorithm_filter.mesh s i = Some c /\ ~ In v (points_3 c))) -> complete m ->
      space_call {| of_filter := s; tracks := false |} {| of_filter := move_to (at_doubles_3 f) (with_mesh s m); tracks := false |}
  | stops_tracking_3 s : space_call {| of_filter := s; tracks := true |} {| of_filter := s; tracks := false |}.

Inductive space_calls (y : system) : system -> Prop :=
  | at_first : space_calls y y
  | and_then z u : space_calls y z -> space_call z u -> space_calls y u.

(* ---- Repair keeps its promise ---- *)

#[local] Instance the_laws_3 : laws := space_laws list_length stamps_there_are worn_out stamps_positive no_fold_3 no_fold_3_local.

Theorem evaluates_repaired_3 f old m pending touched verdicts : (forall v, coordinates_3 (f v)) -> evaluates_3 f old m pending touched verdicts -> complete m ->
  (forall i a b c d, old i = Some (least_first_3 a b c d) -> ~ In i pending -> 0 < orient_at (at_doubles_3 f) a b c d) ->
  repaired (at_doubles_3 f) old m pending verdicts.
Proof.
  intros D [Told Left Same] [Ids Cells] Old.
  assert (Known : forall i c, m i = Some c -> In i (map id verdicts) \/ (old i = Some c /\ ~ In i pending)).
  { intros i c M. destruct (in_dec Z.eq_dec i pending) as [S|S]; [left; apply (Left i c); auto|].
    destruct (in_dec Z.eq_dec i touched) as [C|C]; [left; apply (Left i c); auto|right]. rewrite <- (Same i C). now split. }
  assert (P : forall i a b c d, m i = Some (least_first_3 a b c d) -> 0 < orient_at (at_doubles_3 f) a b c d).
  { intros i a b c d M. destruct (Known _ _ M) as [I|[I N]]; [|now apply (Old i)]. apply in_map_iff in I. destruct I as (k & <- & K).
    destruct (Told k K) as [M' H]. apply (answer_cell_3 f k); trivial. congruence. }
  split; [|exact Known|exact Ids|exact Cells].
  intros k K. destruct (Told k K) as [M H]. split; [exact M|]. apply answer_evaluated_3; trivial. unfold its_cells_positive.
  destruct (of k) as [| |a b c p q] eqn:E; trivial.
  assert (Q : forall u v w x, counts_on_3 (least_first_3 u v w x) (sphere a b c p q) -> 0 < orient_at (at_doubles_3 f) u v w x)
    by (intros u v w x Q; destruct (Cells _ _ _ M Q) as (j & J); exact (P j _ _ _ _ J)).
  split; apply Q; [now left|now right].
Qed.

Lemma start_recomputes_3 f m verdicts : start_in_space f m verdicts -> recomputed_by (at_doubles_3 f) m verdicts.
Proof.
  intro St. split; [|intros i c M; left; now apply (all_answered_3 _ _ _ St i c)|exact (ids_3 _ _ _ St)|exact (with_cells_3 _ _ _ St)].
  intros k K. split; [now apply (answers_right_3 _ _ _ St)|]. apply (verdict_evaluated_3 _ _ _ no_fold_3 no_fold_3_local). now apply (start_answered_3 f m verdicts).
Qed.

Theorem space_call_is_call y z : right y -> space_call y z -> call y z.
Proof.
  intros V C. destruct C as [s f movers D Co N|s f movers m touched verdicts D Co E Cm|s f movers D Co failed|s f newcomers m touched verdicts D t Mo New E Cm|
    s b f m verdicts St|s b f m D H Cm|s b f m D H Cm|s f v m D Co H Cm|s]; try assert (X : forall v, valid_3 (at_doubles_3 f v)) by (intro; apply coordinates_valid_3, D).
  - now apply passed with movers.
  - apply processed; trivial. cbv zeta. destruct (find_expired s (at_doubles_3 f) _) as [u pending] eqn:F.
    apply (evaluates_repaired_3 f _ m pending touched verdicts); trivial. intros i a b c d M N. apply (positive_cell no_fold_3).
    assert (H := no_pending_holds s (at_doubles_3 f) (find_failed s (at_doubles_3 f) movers) V X
      (failed_or_not s (at_doubles_3 f) movers Co) i (least_first_3 a b c d)).
    rewrite F in H. apply (H M N). destruct (least_first_cell a b c d) as (a' & b' & c' & d' & ->). intros k [].
  - apply failing; [exact X|exact Co].
  - assert (Va : forall n, In n (placed_3 f newcomers) -> valid_3 (snd n)) by (intros n I; apply in_map_iff in I; destruct I as (v & <- & _); apply X).
    assert (Fr : forall n i c, In n (placed_3 f newcomers) -> algorithm_filter.mesh s i = Some c -> ~ In (fst n) (points_3 c))
      by (intros n i c I; apply in_map_iff in I; destruct I as (v & <- & I); now apply New).
    destruct (places_keep (placed_3 f newcomers) s V Va Fr) as [P M]. fold t in P, M. rewrite <- Mo. apply refreshed; trivial. cbv zeta. fold t. rewrite Mo.
    apply (evaluates_repaired_3 f _ m [] touched verdicts); trivial. intros i a b c d Q _. apply (positive_cell no_fold_3). rewrite <- Mo.
    exact (proj2 (filter_is_right {| of_filter := t; tracks := true |} _ P (here _)) i _ Q).
  - apply recomputes; [intro; apply coordinates_valid_3, (in_domain_3 _ _ _ St)|now apply start_recomputes_3].
  - apply everything; [exact X| |exact (cells_are_there m Cm)]. intros i c M. now apply signed_holds_3, (H i).
  - apply everything; [exact X|exact H|exact (cells_are_there m Cm)].
  - apply star with v; [exact X| | |exact (cells_are_there m Cm)].
    + intro n. destruct (Co n) as [[<-|[]]|K]; [now left|now right].
    + intros i c M. destruct (H i c M) as [Q|Q]; [left; now apply signed_holds_3|now right].
  - apply stops.
Qed.

Theorem space_calls_are_calls f m verdicts s z : start_in_space f m verdicts -> (0 <= epoch s)%Z -> space_calls (recomputed_in_space f m verdicts s) z ->
  calls (recomputed_in_space f m verdicts s) z.
Proof.
  intros St E R. assert (V : right (recomputed_in_space f m verdicts s)).
  { apply (@algorithm_run.recompute_keeps the_space the_laws_3 (at_doubles_3 f) s m verdicts (fun _ => E)); [|now apply start_recomputes_3].
    intro v. apply coordinates_valid_3, (in_domain_3 _ _ _ St). }
  induction R as [|z u R IH C]; [apply here|]. apply further with z; [exact IH|].
  apply space_call_is_call; [|exact C]. exact (proj1 (filter_is_right _ z V IH)).
Qed.
End calls.
