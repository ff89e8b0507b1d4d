(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter of the plane together with the mesh that it works on: what a call does to certificates and border, and when the program walks the border.

   - in_doubt           Repair::border_in_doubt: whether the border is walked
   - evaluates          what Repair does: it evaluates all suspects that are there, and all certificates of cells that it touched
   - program_call       what one call may be
   - evaluates_repaired what Repair does is what the model of the filter asks of it (`repaired`)
   - known_after        the border that such a call leaves is known: walked, or need not be (plane_motion.v)
   - program_delaunay   from doubles, after any number of calls, the cells triangulate the hull of the moving vertices and are Delaunay *)
From Coq Require Import Reals ZArith List Bool Lra Lia Permutation.
From Annulus Require Import points_2 filter_doubles returned_2 algorithm_list algorithm_filter algorithm_look algorithm_step algorithm_run filter_world filter_plane filter_untouched.
From Annulus Require Import plane_mesh plane_triangulation plane_certificates plane_motion filter_delaunay.
Import ListNotations.
Open Scope R_scope.

(* The certificates of a mesh under their numbers. *)
Definition lists (m : Z -> option certificate_2) (T : plane_mesh.mesh) : Prop :=
  (forall c, In c (certificates T) <-> exists i, m i = Some c) /\ forall i c, m i = Some c -> is_id i.

(* ---- Cells that circles count on ---- *)

Definition corners_differ (t : nat * nat * nat) : Prop := let '(a, b, c) := t in a <> b /\ b <> c /\ a <> c.

Lemma least_turned a b c : corners_differ (a, b, c) -> least_first a b c = least_first b c a.
Proof.
  intros (A & B & C). unfold least_first.
  destruct (Nat.leb_spec a b), (Nat.leb_spec a c), (Nat.leb_spec b a), (Nat.leb_spec b c), (Nat.leb_spec c b), (Nat.leb_spec c a); cbn [andb]; try reflexivity; lia.
Qed.

Lemma positive_differ m a b c : 0 < turn_at m a b c -> corners_differ (a, b, c).
Proof. unfold turn_at, turning, width_2.turn. intro P. repeat split; intros ->; lra. Qed.

Lemma side_of_cell T a b c : (forall t, In t (cells T) -> corners_differ t) -> In (a, b, c) (flat_map sides (cells T)) ->
  In (least_first a b c) (certificates T).
Proof.
  intros D I. apply in_flat_map in I. destruct I as ([[x y] z] & I & S). assert (K := D _ I).
  assert (E : least_first a b c = least_first x y z).
  { destruct S as [S|[S|[S|[]]]]; injection S as <- <- <-; [reflexivity|symmetry; now apply least_turned|].
    apply least_turned. unfold corners_differ in *. intuition congruence. }
  rewrite E. apply in_or_app. left. apply in_map_iff. now exists (x, y, z).
Qed.

Lemma circle_listed T a b p q : In (circle a b p q) (certificates T) -> In (a, b, p, q) (bicells T).
Proof.
  unfold certificates. rewrite !in_app_iff, !in_map_iff. intros [(t & E & _)|[(r & E & _)|(k & E & I)]].
  - destruct t as [[x y] z]. unfold least_first in E. destruct (_ && _); [discriminate|]. now destruct (_ && _).
  - now destruct r as [[x y] z].
  - destruct k as [[[x y] z] w]. now injection E as -> -> -> ->.
Qed.

Lemma cell_listed T t : In t (cells T) -> In (let '(a, b, c) := t in least_first a b c) (certificates T).
Proof. intro I. apply in_or_app. left. apply in_map_iff. now exists t. Qed.

Lemma circles_counted m T : lists m T -> glued T -> (forall t, In t (cells T) -> corners_differ t) ->
  forall i c d, m i = Some c -> counts_on_2 d c -> exists j, m j = Some d.
Proof.
  intros [L _] [G _] D i c d M Q. destruct c as [| |a b p q]; try contradiction. apply L.
  assert (I : In (a, b, p, q) (bicells T)) by (apply circle_listed, L; now exists i).
  assert (S : forall s, In s (shared_sides (a, b, p, q)) -> In s (flat_map sides (cells T))).
  { intros s K. apply (Permutation_in s (Permutation_sym G)), in_or_app. left. apply in_flat_map. now exists (a, b, p, q). }
  destruct Q as [->| ->]; apply side_of_cell; trivial; apply S; [now left|right; now left].
Qed.

(* ---- What a call does to the table ---- *)

(* Nothing; cells inside are others now; cells at the border are, too (holds_after_mending: a cell with infinity was touched). *)
Inductive change := nothing | inside | at_border.
Definition changed (w : change) (T T' : plane_mesh.mesh) : Prop :=
  match w with nothing => T' = T | inside => glued T' /\ border T' = border T | at_border => glued T' end.

Lemma changed_glued w T T' : changed w T T' -> glued T -> glued T'.
Proof. destruct w; cbn [changed]; [now intros ->|tauto|trivial]. Qed.

Section calls.
Context {o : options}.
Variable second_look : state -> algorithm_filter.placement -> Z -> option renewal.
Hypothesis second_look_sound : second_look_right second_look.

(* Repair::border_in_doubt, with `many` as holds_after_mending leaves it: a cell or a ridge was evaluated, as after flips always. *)
Definition many (movers : list nat) : bool := match movers with [_] => false | _ => true end.
Definition turns (k : verdict) : bool := match of k with circle _ _ _ _ => false | _ => true end.
Definition in_doubt (movers : list nat) (w : change) (verdicts : list verdict) : bool :=
  match w with nothing => many movers && existsb turns verdicts | inside => many movers | at_border => true end.

(* Repair::evaluate and holds_after_mending, when they say yes. `touched`: the numbers of cells that were made or changed, and of their facets. *)
Record evaluates (f : doubles) (old new : Z -> option certificate_2) (suspects touched : list Z) (verdicts : list verdict) : Prop := {
  each_told : forall k, In k verdicts -> new (id k) = Some (of k) /\ told f k;
  none_left : forall i c, In i suspects \/ In i touched -> new i = Some c -> In i (map id verdicts);
  others_same : forall i, ~ In i touched -> new i = old i }.

Inductive program_call : system -> plane_mesh.mesh -> system -> plane_mesh.mesh -> Prop :=
  (* move, move_all: everybody passes *)
  | all_pass s f movers T : (forall v, coordinates_2 (f v)) -> covered s (at_doubles f) movers -> find_failed s (at_doubles f) movers = [] ->
      program_call {| of_filter := s; tracks := true |} T {| of_filter := move_to (at_doubles f) s; tracks := true |} T
  (* somebody fails: evaluated, flipped or built anew, and evaluated again; the border is walked where it is in doubt *)
  | step s f movers m touched verdicts w T T' : (forall v, coordinates_2 (f v)) -> covered s (at_doubles f) movers ->
      (let '(u, suspects, _) := find_expired second_look s (at_doubles f) (find_failed s (at_doubles f) movers) in
       evaluates f (algorithm_filter.mesh u) m suspects touched verdicts) ->
      changed w T T' -> lists m T' -> (in_doubt movers w verdicts = true -> winds_once (at_doubles f) (border T')) ->
      program_call {| of_filter := s; tracks := true |} T
        {| of_filter := stepped second_look s (at_doubles f) (find_failed s (at_doubles f) movers) m verdicts; tracks := true |} T'
  (* the call is refused *)
  | step_fails s f movers T : (forall v, coordinates_2 (f v)) -> covered s (at_doubles f) movers ->
      let failed := find_failed s (at_doubles f) movers in
      program_call {| of_filter := s; tracks := true |} T
        {| of_filter := undo_anchoring (begin_anchoring s) (fst (fst (find_expired second_look s (at_doubles f) failed))) failed; tracks := true |} T
  (* insertion and removal: that the border winds once is who inserts' word; or cells have other numbers *)
  | inserted s f placed m touched verdicts T T' : (forall v, coordinates_2 (f v)) -> let t := fold_left place placed s in moving t = at_doubles f ->
      (forall n, In n placed -> valid_2 (snd n)) -> (forall n i c, In n placed -> algorithm_filter.mesh s i = Some c -> ~ In (fst n) (points_2 c)) ->
      evaluates f (algorithm_filter.mesh t) m [] touched verdicts -> glued T' -> lists m T' ->
      (placed = [] /\ border T' = border T) \/ winds_once (at_doubles f) (border T') ->
      program_call {| of_filter := s; tracks := true |} T {| of_filter := stepped second_look t (at_doubles f) [] m verdicts; tracks := true |} T'
  (* all is evaluated: where it was right already, or after a rebuild, which has CGAL's word for the border *)
  | settles_all s b f m verdicts T T' : start f m verdicts -> glued T' -> lists m T' ->
      (T' = T /\ moving s = at_doubles f) \/ winds_once (at_doubles f) (border T') ->
      program_call {| of_filter := s; tracks := b |} T (settled f m verdicts s) T'
  (* by signs alone: of everything, or of what contains the one vertex that moves *)
  | signs_of_all s b f m T T' : (forall v, coordinates_2 (f v)) -> (forall i c, m i = Some c -> holds_2 no_fold c (at_doubles f)) ->
      glued T' -> lists m T' -> winds_once (at_doubles f) (border T') ->
      program_call {| of_filter := s; tracks := b |} T {| of_filter := move_to (at_doubles f) (with_mesh s m); tracks := false |} T'
  | signs_of_one s f v m w T T' : (forall n, coordinates_2 (f n)) -> covered s (at_doubles f) [v] ->
      (forall i c, m i = Some c -> holds_2 no_fold c (at_doubles f) \/ (algorithm_filter.mesh s i = Some c /\ ~ In v (points_2 c))) ->
      changed w T T' -> lists m T' -> (w = at_border -> winds_once (at_doubles f) (border T')) ->
      program_call {| of_filter := s; tracks := false |} T {| of_filter := move_to (at_doubles f) (with_mesh s m); tracks := false |} T'
  | stops_tracking s T : program_call {| of_filter := s; tracks := true |} T {| of_filter := s; tracks := false |} T.

(* ---- Repair keeps its promise ---- *)

Lemma positive_by_signs m x T : lists m T -> (forall i a b c, m i = Some (cell a b c) -> 0 < turn_at x a b c) ->
  forall a b c, In (a, b, c) (cells T) -> 0 < turn_at x a b c.
Proof.
  intros [L _] P a b c I. apply (cell_of_circle no_fold). assert (C := cell_listed T _ I). cbn beta iota in C. apply L in C. destruct C as (i & M).
  unfold least_first in *. destruct (_ && _); [exact (P _ _ _ _ M)|]. destruct (_ && _); exact (P _ _ _ _ M).
Qed.

Lemma told_positive f k a b c : (forall v, coordinates_2 (f v)) -> of k = cell a b c -> told f k -> 0 < turn_at (at_doubles f) a b c.
Proof.
  destruct k as [i c' t]. cbn [of]. intros D -> H. assert (A : answered_2 (at_doubles f) {| id := i; of := cell a b c; bound := t |}) by now apply told_answered.
  destruct A as [(_ & _ & A & _)|(_ & A & _)]; exact A.
Qed.

Theorem evaluates_repaired f old m suspects touched verdicts T : (forall v, coordinates_2 (f v)) -> evaluates f old m suspects touched verdicts ->
  glued T -> lists m T -> (forall i a b c, old i = Some (cell a b c) -> ~ In i suspects -> 0 < turn_at (at_doubles f) a b c) ->
  repaired (at_doubles f) old m suspects verdicts.
Proof.
  intros D [Told Left Same] G L Old.
  assert (Known : forall i c, m i = Some c -> In i (map id verdicts) \/ (old i = Some c /\ ~ In i suspects)).
  { intros i c M. destruct (in_dec Z.eq_dec i suspects) as [S|S]; [left; apply (Left i c); auto|].
    destruct (in_dec Z.eq_dec i touched) as [C|C]; [left; apply (Left i c); auto|right]. rewrite <- (Same i C). now split. }
  assert (P : forall i a b c, m i = Some (cell a b c) -> 0 < turn_at (at_doubles f) a b c).
  { intros i a b c M. destruct (Known _ _ M) as [I|[I N]]; [|now apply (Old i)]. apply in_map_iff in I. destruct I as (k & <- & K).
    destruct (Told k K) as [M' H]. apply (told_positive f k); trivial. congruence. }
  assert (All := positive_by_signs m (at_doubles f) T L P).
  assert (Counted := circles_counted m T L G (fun t => match t with (a, b, c) => fun I => positive_differ _ a b c (All a b c I) end)).
  split; [|exact Known|exact (proj2 L)|exact Counted].
  intros k K. destruct (Told k K) as [M H]. split; [exact M|]. apply told_evaluated; trivial.
  destruct (of k) as [| |a b p q] eqn:E; trivial.
  assert (Q : forall u v w, counts_on_2 (least_first u v w) (circle a b p q) -> 0 < turn_at (at_doubles f) u v w).
  { intros u v w Q. destruct (Counted _ _ _ M Q) as (j & J). apply (cell_of_circle no_fold). unfold least_first in *.
    destruct (_ && _); [exact (P _ _ _ _ J)|]. destruct (_ && _); exact (P _ _ _ _ J). }
  split; apply Q; [now left|now right].
Qed.

#[local] Instance the_laws : laws := plane_laws list_length stamps_there_are worn_out looks stamps_positive no_fold no_fold_local.

Lemma holds_right y : right y -> forall i c, algorithm_filter.mesh (of_filter y) i = Some c -> holds_2 no_fold c (places y).
Proof. intros V. exact (proj2 (filter_is_right second_look second_look_sound y y V (here second_look y))). Qed.

Lemma cells_positive (m : Z -> option certificate_2) x : (forall i c, m i = Some c -> holds_2 no_fold c x) -> forall i a b c, m i = Some (cell a b c) -> 0 < turn_at x a b c.
Proof. intros H i a b c M. exact (H i _ M). Qed.

Lemma counted (m : Z -> option certificate_2) x T : glued T -> lists m T -> (forall i a b c, m i = Some (cell a b c) -> 0 < turn_at x a b c) ->
  forall i c d, m i = Some c -> counts_on_2 d c -> exists j, m j = Some d.
Proof.
  intros G L P. apply (circles_counted m T L G). intros [[a b] c] I. now apply (positive_differ x), (positive_by_signs m x T L P).
Qed.

Lemma step_repaired s f movers m touched verdicts T : right {| of_filter := s; tracks := true |} -> (forall v, coordinates_2 (f v)) ->
  covered s (at_doubles f) movers -> glued T -> lists m T -> let failed := find_failed s (at_doubles f) movers in
  let '(u, suspects, _) := find_expired second_look s (at_doubles f) failed in
  evaluates f (algorithm_filter.mesh u) m suspects touched verdicts -> repaired (at_doubles f) (algorithm_filter.mesh u) m suspects verdicts.
Proof.
  intros V D Co G L failed. destruct (find_expired second_look s (at_doubles f) failed) as [[u suspects] renewed] eqn:E. intro Ev.
  apply (evaluates_repaired f _ m suspects touched verdicts T); trivial. intros i a b c M N.
  assert (H := no_suspect_holds second_look second_look_sound s (at_doubles f) failed V (fun v => coordinates_valid _ (D v))
    (failed_or_not s (at_doubles f) movers Co) i (cell a b c)).
  rewrite E in H. apply (H M N). intros d [].
Qed.

Lemma start_settles f m verdicts : start f m verdicts -> settled_by (at_doubles f) m verdicts.
Proof.
  intro St. split; [|intros i c M; left; now apply (all_told _ _ _ St i c)|exact (ids _ _ _ St)|exact (with_cells _ _ _ St)].
  intros k K. split; [now apply (told_right _ _ _ St)|]. apply (verdict_evaluated _ _ _ _ no_fold no_fold_local). now apply (start_answered f m verdicts).
Qed.

Theorem program_call_is_call y T z T' : right y -> program_call y T z T' -> glued T' -> call second_look y z.
Proof.
  intros V C G. destruct C as [s f movers T D Co N|s f movers m touched verdicts w T T' D Co E Ch L W|s f movers T D Co|
    s f placed m touched verdicts T T' D t Mo Va Fr E G' L W|s b f m verdicts T T' St G' L W|s b f m T T' D H G' L W|s f v m w T T' D Co H Ch L W|s T];
    try assert (X : forall v, valid_2 (at_doubles f v)) by (intro; apply coordinates_valid, D).
  - now apply passed with movers.
  - apply processed; trivial. assert (R := step_repaired s f movers m touched verdicts T' V D Co G L). cbv zeta in R |- *.
    destruct (find_expired _ _ _ _) as [[u suspects] renewed]. now apply R.
  - apply failing; [exact X|exact Co].
  - destruct (places_keep placed s V Va Fr) as [P M]. fold t in P, M. rewrite <- Mo. apply refreshed; trivial. cbv zeta. fold t. rewrite Mo.
    apply (evaluates_repaired f _ m [] touched verdicts T'); trivial. intros i a b c Q _.
    rewrite <- Mo. exact (holds_right {| of_filter := t; tracks := true |} P i _ Q).
  - apply settles; [intro; apply coordinates_valid, (in_domain _ _ _ St)|now apply start_settles].
  - apply everything; trivial. now apply (counted m (at_doubles f) T' G L), cells_positive.
  - assert (H' : forall i c, m i = Some c -> holds_2 no_fold c (at_doubles f)).
    { intros i c M. destruct (H i c M) as [Q|[Q N]]; [exact Q|]. apply (holds_2_local no_fold no_fold_local c (moving s)).
      - intros n I. symmetry. destruct (Co n) as [[<-|[]]|K]; [contradiction|exact K].
      - exact (holds_right _ V i c Q). }
    apply star with v; trivial.
    + intro n. destruct (Co n) as [[<-|[]]|K]; [now left|now right].
    + now apply (counted m (at_doubles f) T' G L), cells_positive.
  - apply stops.
Qed.

(* ---- The border ---- *)

(* Of a ridge that was not evaluated the record is what it was. *)
Lemma ridge_kept s f movers m touched verdicts T i u v w : right {| of_filter := s; tracks := true |} -> (forall v, coordinates_2 (f v)) ->
  covered s (at_doubles f) movers -> glued T -> lists m T -> let failed := find_failed s (at_doubles f) movers in
  (let '(u, suspects, _) := find_expired second_look s (at_doubles f) failed in
   evaluates f (algorithm_filter.mesh u) m suspects touched verdicts) ->
  existsb turns verdicts = false -> m i = Some (ridge u v w) -> certified_ridge (moving s) (at_doubles f) u v w.
Proof.
  intros V D Co G L failed Ev No M. assert (X : forall v, valid_2 (at_doubles f v)) by (intro; apply coordinates_valid, D).
  assert (N : ~ In i (map id verdicts)).
  { intro I. apply in_map_iff in I. destruct I as (k & <- & K). destruct (find_expired _ _ _ _) as [[t suspects] renewed].
    assert (Q := proj1 (each_told _ _ _ _ _ _ Ev k K)). assert (turns k = true) by (unfold turns; replace (of k) with (ridge u v w) by congruence; reflexivity).
    assert (existsb turns verdicts = true) by (apply existsb_exists; now exists k). congruence. }
  assert (R := step_repaired s f movers m touched verdicts T V D Co G L). fold failed in R. cbv zeta in R.
  assert (P : repaired (at_doubles f) (algorithm_filter.mesh (fst (fst (find_expired second_look s (at_doubles f) failed)))) m
    (snd (fst (find_expired second_look s (at_doubles f) failed))) verdicts)
    by (destruct (find_expired _ _ _ _) as [[t suspects] renewed]; now apply R).
  destruct (committed second_look second_look_sound s (at_doubles f) failed V X (failed_or_not s _ movers Co) m verdicts P) as (V' & M' & Mo).
  assert (St : stepped second_look s (at_doubles f) failed m verdicts = commit (at_doubles f) (fst (fst (find_expired second_look s (at_doubles f) failed)))
    (snd (find_expired second_look s (at_doubles f) failed)) m verdicts) by (unfold stepped; now destruct (find_expired _ _ _ _) as [[t suspects] renewed]).
  assert (Old : algorithm_filter.mesh s i = Some (ridge u v w)).
  { destruct (others_untouched _ _ _ _ _ P i _ M) as [I|[I _]]; [contradiction|]. revert I. unfold find_expired. cbn [fst algorithm_filter.mesh].
    now rewrite (t_mesh s (at_doubles f) failed V X). }
  destruct (stepped_untouched second_look s (at_doubles f) failed m verdicts i _ V X M eq_refl N) as [Er Ea]. rewrite St in Er, Ea.
  assert (K := same_record_certifies {| of_filter := s; tracks := true |} {| of_filter := _; tracks := true |} i u v w V V' eq_refl eq_refl Old
    (eq_trans (f_equal (fun g => g i) M') M) Er Ea).
  unfold places in K. cbn [of_filter] in K. now rewrite Mo in K.
Qed.
Lemma stays_known m m' T T' : border T' = border T -> m = m' -> border_known m m' T T'.
Proof. intros B ->. right. split; [exact B|]. left. now exists O. Qed.

Lemma one_moved s f movers T T' : covered s (at_doubles f) movers -> many movers = false -> border T' = border T -> border_known (moving s) (at_doubles f) T T'.
Proof.
  intros Co Ma B. destruct movers as [|z [|? ?]]; try discriminate. right. split; [exact B|]. left. exists z. intros v N.
  destruct (Co v) as [[E|[]]|E]; [congruence|now symmetry].
Qed.

Lemma ridge_listed m T u v w : lists m T -> In (u, v, w) (ridges (border T)) -> exists i, m i = Some (ridge u v w).
Proof. intros [L _] I. apply L, in_or_app. right. apply in_or_app. left. apply in_map_iff. now exists (u, v, w). Qed.

Lemma step_ends s f movers m touched verdicts T : right {| of_filter := s; tracks := true |} -> (forall v, coordinates_2 (f v)) ->
  covered s (at_doubles f) movers -> glued T -> lists m T -> let failed := find_failed s (at_doubles f) movers in
  (let '(u, suspects, _) := find_expired second_look s (at_doubles f) failed in
   evaluates f (algorithm_filter.mesh u) m suspects touched verdicts) ->
  algorithm_filter.mesh (stepped second_look s (at_doubles f) failed m verdicts) = m /\ moving (stepped second_look s (at_doubles f) failed m verdicts) = at_doubles f.
Proof.
  intros V D Co G L failed Ev. assert (R := step_repaired s f movers m touched verdicts T V D Co G L). fold failed in R. cbv zeta in R.
  assert (P := committed second_look second_look_sound s (at_doubles f) failed V (fun v => coordinates_valid _ (D v)) (failed_or_not s _ movers Co) m verdicts).
  unfold stepped. destruct (find_expired _ _ _ _) as [[t suspects] renewed]. destruct (P (R Ev)) as (_ & A & B). now split.
Qed.

Lemma inserted_ends s f placed m touched verdicts T : right {| of_filter := s; tracks := true |} -> (forall v, coordinates_2 (f v)) ->
  let t := fold_left place placed s in moving t = at_doubles f ->
  (forall n, In n placed -> valid_2 (snd n)) -> (forall n i c, In n placed -> algorithm_filter.mesh s i = Some c -> ~ In (fst n) (points_2 c)) ->
  evaluates f (algorithm_filter.mesh t) m [] touched verdicts -> glued T -> lists m T ->
  let r := stepped second_look t (at_doubles f) [] m verdicts in algorithm_filter.mesh r = m /\ moving r = at_doubles f.
Proof.
  intros V D t Mo Va Fr E G L. destruct (places_keep placed s V Va Fr) as [P M]. fold t in P, M.
  apply (step_ends t f [] m touched verdicts T); trivial. intro v. right. now rewrite Mo.
Qed.

Lemma epoch_right y : right y -> (0 <= epoch (of_filter y))%Z.
Proof.
  unfold right. destruct (tracks y); intro V; [|exact (proj1 (proj2 V) O)]. generalize (algorithm_keep.stamp_range _ _ (fine_all _ V O)). lia.
Qed.
Lemma convex_right y T : right y -> lists (algorithm_filter.mesh (of_filter y)) T -> convex (places y) (border T).
Proof. intros V [L _]. apply (certificates_convex T (algorithm_filter.mesh (of_filter y))); [intro c; apply L|now apply holds_right]. Qed.

Lemma call_lists y T z T' : right y -> lists (algorithm_filter.mesh (of_filter y)) T -> program_call y T z T' -> glued T' ->
  lists (algorithm_filter.mesh (of_filter z)) T'.
Proof.
  intros V Ly C G. destruct C as [s f movers T D Co N|s f movers m touched verdicts w T T' D Co E Ch L W|s f movers T D Co|
    s f placed m touched verdicts T T' D t Mo Va Fr E G' L W|s b f m verdicts T T' St G' L W|s b f m T T' D H G' L W|s f v m w T T' D Co H Ch L W|s T]; trivial.
  - unfold of_filter. now rewrite (proj1 (step_ends s f movers m touched verdicts T' V D Co G L E)).
  - cbn [of_filter] in *. rewrite (proj1 (proj2 (undone_else second_look s (at_doubles f) failed V (fun v => coordinates_valid _ (D v))))). exact Ly.
  - exact (eq_ind_r (fun n => lists n T') L (proj1 (inserted_ends s f placed m touched verdicts T' V D Mo Va Fr E G L))).
  - exact (eq_ind_r (fun n => lists n T') L (proj2 (settle_keeps (at_doubles f) s m verdicts (fun _ => epoch_right _ V)
      (fun v => coordinates_valid _ (in_domain _ _ _ St v)) (start_settles f m verdicts St)))).
Qed.

Theorem known_after y T z T' : right y -> lists (algorithm_filter.mesh (of_filter y)) T -> glued T' -> program_call y T z T' ->
  border_known (places y) (places z) T T'.
Proof.
  intros V Ly G C. destruct C as [s f movers T D Co N|s f movers m touched verdicts w T T' D Co E Ch L W|s f movers T D Co|
    s f placed m touched verdicts T T' D t Mo Va Fr E G' L W|s b f m verdicts T T' St G' L W|s b f m T T' D H G' L W|s f v m w T T' D Co H Ch L W|s T];
    unfold places; cbn [of_filter] in *.
  - right. split; [reflexivity|]. right. intros u v w I. left. destruct (ridge_listed _ T u v w Ly I) as (i & M).
    apply (same_record_certifies {| of_filter := s; tracks := true |} {| of_filter := @move_to the_plane (at_doubles f) s; tracks := true |} i); trivial.
    apply (pass_keeps s (at_doubles f) movers V); trivial. intro. apply coordinates_valid, D.
  - rewrite (proj2 (step_ends s f movers m touched verdicts T' V D Co G L E)). destruct (in_doubt movers w verdicts) eqn:Q; [left; now apply W|].
    destruct w; cbn [in_doubt changed] in *; [|now apply one_moved with movers; [| |apply Ch]|discriminate].
    subst T'. apply andb_false_iff in Q. destruct Q as [Q|Q]; [now apply one_moved with movers|]. right. split; [reflexivity|]. right.
    intros u v w I. left. destruct (ridge_listed _ T u v w L I) as (i & M). now apply (ridge_kept s f movers m touched verdicts T i).
  - apply stays_known; [reflexivity|]. symmetry. exact (proj1 (undone_else second_look s (at_doubles f) failed V (fun v => coordinates_valid _ (D v)))).
  - assert (R := proj2 (inserted_ends s f placed m touched verdicts T' V D Mo Va Fr E G L)). cbv zeta in R. fold t in R. rewrite R.
    destruct W as [[-> B]|W]; [|now left]. now apply stays_known.
  - cbn [settled of_filter settle moving]. destruct W as [[-> M]|W]; [now apply stays_known|now left].
  - now left.
  - cbn [move_to with_mesh moving]. destruct w; cbn [changed] in Ch; [subst T'| |left; now apply W]; now apply one_moved with [v]; [| |try apply Ch].
  - now apply stays_known.
Qed.

(* ---- From doubles to Delaunay ---- *)

Lemma call_glued y T z T' : glued T -> program_call y T z T' -> glued T'.
Proof. intros G C. destruct C; trivial; now apply (changed_glued w T). Qed.

Theorem program_delaunay f m verdicts s (y : nat -> system) (T : nat -> plane_mesh.mesh) : start f m verdicts -> (0 <= epoch s)%Z ->
  y O = settled f m verdicts s -> glued (T O) -> lists m (T O) -> winds_once (at_doubles f) (border (T O)) ->
  (forall i, program_call (y i) (T i) (y (S i)) (T (S i))) -> forall i, triangulation (places (y i)) (T i) /\ delaunay (places (y i)) (T i).
Proof.
  intros St E Y G L W C. assert (X : forall v, valid_2 (at_doubles f v)) by (intro; apply coordinates_valid, (in_domain _ _ _ St)).
  destruct (@settle_keeps the_plane the_laws (at_doubles f) s m verdicts (fun _ => E) X (start_settles f m verdicts St)) as [V0 M0].
  assert (K : forall i, right (y i) /\ glued (T i) /\ lists (algorithm_filter.mesh (of_filter (y i))) (T i) /\ winds_once (places (y i)) (border (T i))).
  { induction i as [|i (Vi & Gi & Li & Wi)].
    - rewrite Y. split; [exact V0|]. split; [exact G|]. split; [|exact W]. exact (eq_ind_r (fun n => lists n (T O)) L M0).
    - assert (G' := call_glued _ _ _ _ Gi (C i)). assert (L' := call_lists _ _ _ _ Vi Li (C i) G').
      assert (V' := call_keeps second_look second_look_sound _ _ Vi (program_call_is_call _ _ _ _ Vi (C i) G')).
      split; [exact V'|]. split; [exact G'|]. split; [exact L'|].
      apply (known_winds _ _ _ _ (known_after _ _ _ _ Vi Li G' (C i)) Wi); [apply (convex_right _ _ Vi Li)|apply (convex_right _ _ V' L')]. }
  intro i. destruct (K i) as (Vi & Gi & [Li _] & Wi).
  apply (certificates_delaunay (T i) (algorithm_filter.mesh (of_filter (y i)))); [exact Gi|intros c; apply Li|exact (holds_right _ Vi)|exact Wi].
Qed.
End calls.

(* As the filter comes there are no second looks. *)
Definition no_second_look {o : options} : state -> algorithm_filter.placement -> Z -> option renewal := fun _ _ _ => None.
Lemma no_second_look_right {o : options} : second_look_right no_second_look.
Proof. intros s x i c k _ _ _ E. discriminate E. Qed.
