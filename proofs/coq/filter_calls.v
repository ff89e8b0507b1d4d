(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The filter of the plane together with the mesh that it works on, after any number of calls (plane_calls.v says what a call is).

   - evaluates_repaired what Repair does is what the model of the filter requires of it (`repaired`)
   - known_after        the border that such a call leaves is known: walked, or need not be (plane_motion.v)
   - call_vertices      no call loses a vertex that it does not remove
   - program_delaunay   from doubles, after any number of calls, the cells triangulate the hull of the moving vertices, which are all that there should be,
                        and are Delaunay *)
From Coq Require Import Reals ZArith List Bool Lra Lia Permutation.
From Annulus Require Import points_2 filter_doubles returned_2 algorithm_list algorithm_filter algorithm_check algorithm_step algorithm_run filter_world filter_plane filter_untouched.
From Annulus Require Import plane_mesh plane_triangulation plane_certificates plane_motion filter_delaunay signed_2 plane_listed plane_calls.
Import ListNotations.
Open Scope R_scope.

Lemma changed_glued w T T' : changed w T T' -> glued T -> glued T'.
Proof. destruct w; cbn [changed]; [now intros ->|tauto|tauto]. Qed.
Lemma changed_keeps w T T' : changed w T T' -> keeps no_event T T'.
Proof. destruct w; cbn [changed]; [intros -> v; reflexivity|tauto|tauto]. Qed.

Section calls.
Context {o : options}.

(* An inserted vertex is in no certificate yet. *)
Lemma placed_new (s : state) f e T : glued T -> lists (algorithm_filter.mesh s) T -> (forall v, e = inserts v -> ~ vertex_of T v) ->
  forall n i c, In n (placed f e) -> algorithm_filter.mesh s i = Some c -> ~ In (fst n) (points_2 c).
Proof.
  intros G [L _] New n i c I M V. destruct e as [|v|v]; try contradiction. destruct I as [<-|[]]. apply (New v eq_refl).
  apply (certified_vertices T c); trivial. apply L. now exists i.
Qed.
Lemma placed_valid f e : (forall v, coordinates_2 (f v)) -> forall n, In n (placed f e) -> valid_2 (snd n).
Proof. intros D n I. destruct e as [|v|v]; try contradiction. destruct I as [<-|[]]. apply coordinates_valid, D. Qed.

(* ---- Repair keeps its promise ---- *)

Lemma positive_by_signs m x T : lists m T -> (forall i a b c, m i = Some (cell a b c) -> 0 < turn_at x a b c) ->
  forall a b c, In (a, b, c) (cells T) -> 0 < turn_at x a b c.
Proof.
  intros [L _] P a b c I. apply (cell_of_circle no_fold). assert (C := cell_listed T _ I). cbn beta iota in C. apply L in C. destruct C as (i & M).
  unfold least_first in *. destruct (_ && _); [exact (P _ _ _ _ M)|]. destruct (_ && _); exact (P _ _ _ _ M).
Qed.

Lemma answer_positive f k a b c : (forall v, coordinates_2 (f v)) -> of k = cell a b c -> is_answer f k -> 0 < turn_at (at_doubles f) a b c.
Proof.
  destruct k as [i c' t]. cbn [of]. intros D -> H. assert (A : answered_2 (at_doubles f) {| id := i; of := cell a b c; bound := t |}) by now apply answer_holds.
  destruct A as [(_ & _ & A & _)|(_ & A)]; exact A.
Qed.

Theorem evaluates_repaired f old m pending touched verdicts T : (forall v, coordinates_2 (f v)) -> evaluates f old m pending touched verdicts ->
  glued T -> lists m T -> (forall i a b c, old i = Some (cell a b c) -> ~ In i pending -> 0 < turn_at (at_doubles f) a b c) ->
  repaired (at_doubles f) old m pending verdicts.
Proof.
  intros D [Told Left Same] G L Old.
  assert (Known : forall i c, m i = Some c -> In i (map id verdicts) \/ (old i = Some c /\ ~ In i pending)).
  { intros i c M. destruct (in_dec Z.eq_dec i pending) as [S|S]; [left; apply (Left i c); auto|].
    destruct (in_dec Z.eq_dec i touched) as [C|C]; [left; apply (Left i c); auto|right]. rewrite <- (Same i C). now split. }
  assert (P : forall i a b c, m i = Some (cell a b c) -> 0 < turn_at (at_doubles f) a b c).
  { intros i a b c M. destruct (Known _ _ M) as [I|[I N]]; [|now apply (Old i)]. apply in_map_iff in I. destruct I as (k & <- & K).
    destruct (Told k K) as [M' H]. apply (answer_positive f k); trivial. congruence. }
  assert (All := positive_by_signs m (at_doubles f) T L P).
  assert (Counted := circles_counted m T L G (fun t => match t with (a, b, c) => fun I => positive_differ _ a b c (All a b c I) end)).
  split; [|exact Known|exact (proj2 L)|exact Counted].
  intros k K. destruct (Told k K) as [M H]. split; [exact M|]. apply answer_evaluated; trivial.
  destruct (of k) as [| |a b p q] eqn:E; trivial.
  assert (Q : forall u v w, counts_on_2 (least_first u v w) (circle a b p q) -> 0 < turn_at (at_doubles f) u v w).
  { intros u v w Q. destruct (Counted _ _ _ M Q) as (j & J). apply (cell_of_circle no_fold). unfold least_first in *.
    destruct (_ && _); [exact (P _ _ _ _ J)|]. destruct (_ && _); exact (P _ _ _ _ J). }
  split; apply Q; [now left|now right].
Qed.

#[local] Instance the_laws : laws := plane_laws list_length stamps_there_are worn_out stamps_positive no_fold no_fold_local.

Lemma holds_right y : right y -> forall i c, algorithm_filter.mesh (of_filter y) i = Some c -> holds_2 no_fold c (places y).
Proof. intros V. exact (proj2 (filter_is_right y y V (here y))). Qed.

Lemma cells_positive (m : Z -> option certificate_2) x : (forall i c, m i = Some c -> holds_2 no_fold c x) -> forall i a b c, m i = Some (cell a b c) -> 0 < turn_at x a b c.
Proof. intros H i a b c M. exact (H i _ M). Qed.

Lemma counted (m : Z -> option certificate_2) x T : glued T -> lists m T -> (forall i a b c, m i = Some (cell a b c) -> 0 < turn_at x a b c) ->
  forall i c d, m i = Some c -> counts_on_2 d c -> exists j, m j = Some d.
Proof.
  intros G L P. apply (circles_counted m T L G). intros [[a b] c] I. now apply (positive_differ x), (positive_by_signs m x T L P).
Qed.

Lemma step_repaired s f movers m touched verdicts T : right {| of_filter := s; tracks := true |} -> (forall v, coordinates_2 (f v)) ->
  covered s (at_doubles f) movers -> glued T -> lists m T -> let failed := find_failed s (at_doubles f) movers in
  let (u, pending) := find_expired s (at_doubles f) failed in
  evaluates f (algorithm_filter.mesh u) m pending touched verdicts -> repaired (at_doubles f) (algorithm_filter.mesh u) m pending verdicts.
Proof.
  intros V D Co G L failed. destruct (find_expired s (at_doubles f) failed) as [u pending] eqn:E. intro Ev.
  apply (evaluates_repaired f _ m pending touched verdicts T); trivial. intros i a b c M N.
  assert (H := no_pending_holds s (at_doubles f) failed V (fun v => coordinates_valid _ (D v))
    (failed_or_not s (at_doubles f) movers Co) i (cell a b c)).
  rewrite E in H. apply (H M N). intros d [].
Qed.

Lemma start_recomputes f m verdicts : start f m verdicts -> recomputed_by (at_doubles f) m verdicts.
Proof.
  intro St. split; [|intros i c M; left; now apply (all_answered _ _ _ St i c)|exact (ids _ _ _ St)|exact (with_cells _ _ _ St)].
  intros k K. split; [now apply (answers_right _ _ _ St)|]. apply (verdict_evaluated _ _ _ no_fold no_fold_local). now apply (start_answered f m verdicts).
Qed.

Theorem program_call_is_call e y T z T' : right y -> glued T -> lists (algorithm_filter.mesh (of_filter y)) T ->
  program_call e y T z T' -> glued T' -> call y z.
Proof.
  intros V GT LT C G. destruct C as [s f movers T D Co N|s f movers m touched verdicts w T T' D Co E Ch L W|s f movers T D Co|
    s f e m touched verdicts T T' D t Mo New E G' L Ke W|s b f e m verdicts T T' St G' L Ke W|s b f m T T' D H G' L Ke W|s b f e m T T' D H G' L Ke W|
    s f v m w T T' D Co H Ch L W|s T];
    try assert (X : forall v, valid_2 (at_doubles f v)) by (intro; apply coordinates_valid, D).
  - now apply passed with movers.
  - apply processed; trivial. assert (R := step_repaired s f movers m touched verdicts T' V D Co G L). cbv zeta in R |- *.
    destruct (find_expired _ _ _) as [u pending]. now apply R.
  - apply failing; [exact X|exact Co].
  - assert (Va := placed_valid f e D). assert (Fr := placed_new s f e T GT LT New).
    destruct (places_keep (placed f e) s V Va Fr) as [P M]. fold t in P, M. rewrite <- Mo. apply refreshed; trivial. cbv zeta. fold t. rewrite Mo.
    apply (evaluates_repaired f _ m [] touched verdicts T'); trivial. intros i a b c Q _.
    rewrite <- Mo. exact (holds_right {| of_filter := t; tracks := true |} P i _ Q).
  - apply recomputes; [intro; apply coordinates_valid, (in_domain _ _ _ St)|now apply start_recomputes].
  - assert (H' : forall i c, m i = Some c -> holds_2 no_fold c (at_doubles f)) by (intros i c M; now apply signed_holds, (H i)).
    apply everything; trivial. now apply (counted m (at_doubles f) T' G L), cells_positive.
  - apply everything; trivial. now apply (counted m (at_doubles f) T' G L), cells_positive.
  - assert (H' : forall i c, m i = Some c -> holds_2 no_fold c (at_doubles f)).
    { intros i c M. destruct (H i c M) as [Q|[Q N]]; [now apply signed_holds|]. apply (holds_2_local no_fold no_fold_local c (moving s)).
      - intros n I. symmetry. destruct (Co n) as [[<-|[]]|K]; [contradiction|exact K].
      - exact (holds_right _ V i c Q). }
    apply star with v; trivial.
    + intro n. destruct (Co n) as [[<-|[]]|K]; [now left|now right].
    + intros i c M. left. now apply (H' i).
    + now apply (counted m (at_doubles f) T' G L), cells_positive.
  - apply stops.
Qed.

(* ---- The border ---- *)

(* Of a ridge that was not evaluated the record is what it was. *)
Lemma ridge_kept s f movers m touched verdicts T i u v w : right {| of_filter := s; tracks := true |} -> (forall v, coordinates_2 (f v)) ->
  covered s (at_doubles f) movers -> glued T -> lists m T -> let failed := find_failed s (at_doubles f) movers in
  (let (u, pending) := find_expired s (at_doubles f) failed in
   evaluates f (algorithm_filter.mesh u) m pending touched verdicts) ->
  existsb turns verdicts = false -> m i = Some (ridge u v w) -> certified_ridge (moving s) (at_doubles f) u v w.
Proof.
  intros V D Co G L failed Ev No M. assert (X : forall v, valid_2 (at_doubles f v)) by (intro; apply coordinates_valid, D).
  assert (N : ~ In i (map id verdicts)).
  { intro I. apply in_map_iff in I. destruct I as (k & <- & K).
    assert (Q := proj1 (each_answered _ _ _ _ _ _ Ev k K)). assert (turns k = true) by (unfold turns; replace (of k) with (ridge u v w) by congruence; reflexivity).
    assert (existsb turns verdicts = true) by (apply existsb_exists; now exists k). congruence. }
  assert (R := step_repaired s f movers m touched verdicts T V D Co G L). fold failed in R. cbv zeta in R.
  assert (P := R Ev). destruct (committed s (at_doubles f) failed V X (failed_or_not s _ movers Co) m verdicts P) as (V' & M' & Mo).
  assert (Old : algorithm_filter.mesh s i = Some (ridge u v w)).
  { destruct (others_untouched _ _ _ _ _ P i _ M) as [I|[I _]]; [contradiction|]. revert I. unfold find_expired. cbn [fst algorithm_filter.mesh].
    now rewrite (t_mesh s (at_doubles f) failed V X). }
  destruct (stepped_untouched s (at_doubles f) failed m verdicts i V X N) as [Er Ea].
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

Lemma step_ends s f movers m touched verdicts T : right {| of_filter := s; tracks := true |} -> (forall v, coordinates_2 (f v)) ->
  covered s (at_doubles f) movers -> glued T -> lists m T -> let failed := find_failed s (at_doubles f) movers in
  (let (u, pending) := find_expired s (at_doubles f) failed in
   evaluates f (algorithm_filter.mesh u) m pending touched verdicts) ->
  algorithm_filter.mesh (stepped s (at_doubles f) failed m verdicts) = m /\ moving (stepped s (at_doubles f) failed m verdicts) = at_doubles f.
Proof.
  intros V D Co G L failed Ev. assert (R := step_repaired s f movers m touched verdicts T V D Co G L). fold failed in R. cbv zeta in R.
  destruct (committed s (at_doubles f) failed V (fun v => coordinates_valid _ (D v)) (failed_or_not s _ movers Co) m verdicts (R Ev)) as (_ & A & B). now split.
Qed.

Lemma inserted_ends s f e m touched verdicts T T' : right {| of_filter := s; tracks := true |} -> glued T -> lists (algorithm_filter.mesh s) T ->
  (forall v, coordinates_2 (f v)) -> let t := fold_left place (placed f e) s in moving t = at_doubles f -> (forall v, e = inserts v -> ~ vertex_of T v) ->
  evaluates f (algorithm_filter.mesh t) m [] touched verdicts -> glued T' -> lists m T' ->
  let r := stepped t (at_doubles f) [] m verdicts in algorithm_filter.mesh r = m /\ moving r = at_doubles f.
Proof.
  intros V G Ls D t Mo New E G' L. destruct (places_keep (placed f e) s V (placed_valid f e D) (placed_new s f e T G Ls New)) as [P M]. fold t in P, M.
  apply (step_ends t f [] m touched verdicts T'); trivial. intro v. right. now rewrite Mo.
Qed.

Lemma epoch_right y : right y -> (0 <= epoch (of_filter y))%Z.
Proof.
  unfold right. destruct (tracks y); intro V; [|exact (proj1 (proj2 V) O)]. generalize (algorithm_keep.stamp_range _ _ (fine_all _ V O)). lia.
Qed.
Lemma convex_right y T : right y -> lists (algorithm_filter.mesh (of_filter y)) T -> convex (places y) (border T).
Proof. intros V [L _]. apply (certificates_convex T (algorithm_filter.mesh (of_filter y))); [intro c; apply L|now apply holds_right]. Qed.

Lemma call_lists e y T z T' : right y -> glued T -> lists (algorithm_filter.mesh (of_filter y)) T -> program_call e y T z T' -> glued T' ->
  lists (algorithm_filter.mesh (of_filter z)) T'.
Proof.
  intros V Gy Ly C G. destruct C as [s f movers T D Co N|s f movers m touched verdicts w T T' D Co E Ch L W|s f movers T D Co|
    s f e m touched verdicts T T' D t Mo New E G' L Ke W|s b f e m verdicts T T' St G' L Ke W|s b f m T T' D H G' L Ke W|s b f e m T T' D H G' L Ke W|
    s f v m w T T' D Co H Ch L W|s T]; trivial.
  - unfold of_filter. now rewrite (proj1 (step_ends s f movers m touched verdicts T' V D Co G L E)).
  - cbn [of_filter] in *. rewrite (proj1 (proj2 (undone_else s (at_doubles f) failed V (fun v => coordinates_valid _ (D v))))). exact Ly.
  - exact (eq_ind_r (fun n => lists n T') L (proj1 (inserted_ends s f e m touched verdicts T T' V Gy Ly D Mo New E G L))).
  - exact (eq_ind_r (fun n => lists n T') L (proj2 (recompute_keeps (at_doubles f) s m verdicts (fun _ => epoch_right _ V)
      (fun v => coordinates_valid _ (in_domain _ _ _ St v)) (start_recomputes f m verdicts St)))).
Qed.

Theorem known_after e y T z T' : right y -> glued T -> lists (algorithm_filter.mesh (of_filter y)) T -> glued T' -> program_call e y T z T' ->
  border_known (places y) (places z) T T'.
Proof.
  intros V Gy Ly G C. destruct C as [s f movers T D Co N|s f movers m touched verdicts w T T' D Co E Ch L W|s f movers T D Co|
    s f e m touched verdicts T T' D t Mo New E G' L Ke W|s b f e m verdicts T T' St G' L Ke W|s b f m T T' D H G' L Ke W|s b f e m T T' D H G' L Ke W|
    s f v m w T T' D Co H Ch L W|s T];
    unfold places; cbn [of_filter] in *.
  - right. split; [reflexivity|]. right. intros u v w I. left. destruct (ridge_listed _ T u v w Ly I) as (i & M).
    apply (same_record_certifies {| of_filter := s; tracks := true |} {| of_filter := @move_to the_plane (at_doubles f) s; tracks := true |} i); trivial.
    apply (pass_keeps s (at_doubles f) movers V); trivial. intro. apply coordinates_valid, D.
  - rewrite (proj2 (step_ends s f movers m touched verdicts T' V D Co G L E)). destruct (in_doubt movers w verdicts) eqn:Q; [left; now apply W|].
    destruct w; cbn [in_doubt changed] in *; [|now apply one_moved with movers; [| |apply Ch]|discriminate].
    subst T'. apply andb_false_iff in Q. destruct Q as [Q|Q]; [now apply one_moved with movers|]. right. split; [reflexivity|]. right.
    intros u v w I. left. destruct (ridge_listed _ T u v w L I) as (i & M). now apply (ridge_kept s f movers m touched verdicts T i).
  - apply stays_known; [reflexivity|]. symmetry. exact (proj1 (undone_else s (at_doubles f) failed V (fun v => coordinates_valid _ (D v)))).
  - assert (R := proj2 (inserted_ends s f e m touched verdicts T T' V Gy Ly D Mo New E G L)). cbv zeta in R. fold t in R. rewrite R.
    destruct W as [B|W]; [|now left]. right. split; [exact B|]. left. rewrite <- Mo. unfold t, placed. destruct e as [|v|v]; cbn [fold_left]; [now exists O| |now exists O].
    exists v. intros n N. cbn [place move_to moving]. now rewrite set_other.
  - cbn [recomputed of_filter recompute moving]. destruct W as [[-> M]|W]; [now apply stays_known|now left].
  - now left.
  - now left.
  - cbn [move_to with_mesh moving]. destruct w; cbn [changed] in Ch; [subst T'| |left; now apply W]; now apply one_moved with [v]; [| |try apply Ch].
  - now apply stays_known.
Qed.

(* ---- From doubles to Delaunay ---- *)

Lemma call_glued e y T z T' : glued T -> program_call e y T z T' -> glued T'.
Proof. intros G C. destruct C; trivial; now apply (changed_glued w T). Qed.

Theorem call_vertices e y T z T' : program_call e y T z T' -> keeps e T T'.
Proof. intro C. destruct C; trivial; try (intro; reflexivity); now apply changed_keeps with w. Qed.

Lemma all_present n (e : nat -> event) (T : nat -> plane_mesh.mesh) : (forall i, (i < n)%nat -> keeps (e i) (T i) (T (S i))) ->
  forall i, (i <= n)%nat -> forall v, vertex_of (T i) v <-> present (vertex_of (T O)) e i v.
Proof.
  intros K. induction i as [|i IH]; intros L v; [reflexivity|]. rewrite (K i L v). cbn [present].
  destruct (e i); cbn [afterwards]; now rewrite (IH (Nat.lt_le_incl _ _ L)).
Qed.

(* After each of n calls: machine_delaunay (../traces) needs no more than 2^49. *)
Theorem program_delaunay_until n f m verdicts s (e : nat -> event) (y : nat -> system) (T : nat -> plane_mesh.mesh) : start f m verdicts -> (0 <= epoch s)%Z ->
  y O = recomputed f m verdicts s -> glued (T O) -> lists m (T O) -> winds_once (at_doubles f) (border (T O)) ->
  (forall i, (i < n)%nat -> program_call (e i) (y i) (T i) (y (S i)) (T (S i))) ->
  forall i, (i <= n)%nat -> triangulation (places (y i)) (T i) /\ delaunay (places (y i)) (T i) /\
    forall v, vertex_of (T i) v <-> present (vertex_of (T O)) e i v.
Proof.
  intros St E Y G L W C. assert (X : forall v, valid_2 (at_doubles f v)) by (intro; apply coordinates_valid, (in_domain _ _ _ St)).
  destruct (@recompute_keeps the_plane the_laws (at_doubles f) s m verdicts (fun _ => E) X (start_recomputes f m verdicts St)) as [V0 M0].
  assert (K : forall i, (i <= n)%nat ->
    right (y i) /\ glued (T i) /\ lists (algorithm_filter.mesh (of_filter (y i))) (T i) /\ winds_once (places (y i)) (border (T i))).
  { induction i as [|i IH]; intro Le.
    - rewrite Y. split; [exact V0|]. split; [exact G|]. split; [|exact W]. exact (eq_ind_r (fun n => lists n (T O)) L M0).
    - destruct (IH (Nat.lt_le_incl _ _ Le)) as (Vi & Gi & Li & Wi). specialize (C i Le).
      assert (G' := call_glued _ _ _ _ _ Gi C). assert (L' := call_lists _ _ _ _ _ Vi Gi Li C G').
      assert (V' := call_keeps _ _ Vi (program_call_is_call _ _ _ _ _ Vi Gi Li C G')).
      split; [exact V'|]. split; [exact G'|]. split; [exact L'|].
      apply (known_winds _ _ _ _ (known_after _ _ _ _ _ Vi Gi Li G' C) Wi); [apply (convex_right _ _ Vi Li)|apply (convex_right _ _ V' L')]. }
  intros i Le. destruct (K i Le) as (Vi & Gi & [Li _] & Wi). rewrite <- and_assoc. split.
  - apply (certificates_delaunay (T i) (algorithm_filter.mesh (of_filter (y i)))); [exact Gi|intros c; apply Li|exact (holds_right _ Vi)|exact Wi].
  - exact (all_present n e T (fun j J => call_vertices _ _ _ _ _ (C j J)) i Le).
Qed.

Theorem program_delaunay f m verdicts s (e : nat -> event) (y : nat -> system) (T : nat -> plane_mesh.mesh) : start f m verdicts -> (0 <= epoch s)%Z ->
  y O = recomputed f m verdicts s -> glued (T O) -> lists m (T O) -> winds_once (at_doubles f) (border (T O)) ->
  (forall i, program_call (e i) (y i) (T i) (y (S i)) (T (S i))) -> forall i, triangulation (places (y i)) (T i) /\ delaunay (places (y i)) (T i) /\
    forall v, vertex_of (T i) v <-> present (vertex_of (T O)) e i v.
Proof. intros St E Y G L W C i. exact (program_delaunay_until i f m verdicts s e y T St E Y G L W (fun j _ => C j) i (le_n i)). Qed.
End calls.
