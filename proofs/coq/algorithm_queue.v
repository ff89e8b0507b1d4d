(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The queue of the paper's filtering algorithm: the strategies `paper` and `paper-hybrid` (docs/theory.md 5.5;
   src/annulus/published/paper_strategy.cpp; paper 3.2), as a program, with an oracle for what evaluation says.

   - processed_rests      a vertex that was processed has D = 0, and keeps it for the rest of the call
   - process_forgets      a vertex that is processed has no bound but those that evaluation gives it then
   - each_once            in a call every vertex is processed at most once: at most n times in all
   - queue_runs_dry       with n rounds the queue is empty
   - all_pass             and then every vertex passes: it is at its fixed position, or D < epsilon (passes_means)
   - processed_moves      calls one after another: processed in all <= vertices off their fixed positions at first + calls;
                          a time step that moves each of n vertices once relocates at most 2n times, k of them (k + 1) n times

   The oracle is any function: which certificates are evaluated, at the moving or at the fixed positions, flipped or reinserted, does
   not matter here. So this is true of the paper's algorithm (fixed positions, relocation) and of ours. *)
Require Import List Arith Bool Lia Reals Lra.
From Annulus Require Import updated list_counts.
Import ListNotations.
Open Scope nat_scope.

Section queue.
Variables (vertex position : Type).
Variable same_vertex : forall v w : vertex, {v = w} + {v <> w}.
Variable same_position : forall p q : position, {p = q} + {p <> q}.
Variable vertices : list vertex.
Hypothesis complete : forall v, In v vertices.
Hypothesis distinct : NoDup vertices.
Let n := length vertices.

Variable dist : position -> position -> R.

(* None is no bound at all: the infinity of the code. *)
Record state := {
  moving : vertex -> position;
  fixed : vertex -> position;
  epsilon : vertex -> option R;
  queue : list vertex }.

Definition below (d : R) (e : option R) : bool :=
  match e with None => true | Some e => if Rlt_dec d e then true else false end.
(* D < epsilon, or m = f: a vertex that rests passes whatever its epsilon. *)
Definition passes (s : state) (v : vertex) : bool :=
  if same_position (moving s v) (fixed s v) then true else below (dist (moving s v) (fixed s v)) (epsilon s v).

Lemma passes_means : forall s v, passes s v = true <->
  moving s v = fixed s v \/ match epsilon s v with None => True | Some e => (dist (moving s v) (fixed s v) < e)%R end.
Proof.
  intros s v. unfold passes, below. destruct (same_position (moving s v) (fixed s v)) as [E|N]; [tauto|].
  destruct (epsilon s v) as [e|]; [|tauto]. destruct (Rlt_dec (dist (moving s v) (fixed s v)) e) as [L|L]; [tauto|].
  split; [discriminate|]. now intros [E|E].
Qed.

Local Notation set := (updated.set same_vertex).
Definition queued (s : state) (v : vertex) : bool := if in_dec same_vertex v (queue s) then true else false.

(* lower(): a certificate allows v no more than t. *)
Definition lower (s : state) (update : vertex * R) : state :=
  let (v, t) := update in
  if below t (epsilon s v) then
    let s' := {| moving := moving s; fixed := fixed s; epsilon := set (epsilon s) v (Some t); queue := queue s |} in
    if queued s' v || passes s' v then s'
    else {| moving := moving s'; fixed := fixed s'; epsilon := epsilon s'; queue := queue s' ++ [v] |}
  else s.

(* process(): h, no longer queued, is fixed where it is; its bound is forgotten; evaluation gives bounds to vertices, h among them. *)
Variable evaluate : state -> vertex -> list (vertex * R).
Definition process (h : vertex) (s : state) : state :=
  let s' := {| moving := moving s; fixed := set (fixed s) h (moving s h); epsilon := set (epsilon s) h None; queue := queue s |} in
  fold_left lower (evaluate s' h) s'.

Lemma lower_others : forall h us s, (forall u, In u us -> fst u <> h) -> epsilon (fold_left lower us s) h = epsilon s h.
Proof.
  intros h us. induction us as [|[v t] us IH]; intros s N; simpl; [reflexivity|].
  rewrite IH by (intros u U; apply N; now right). assert (D : v <> h) by exact (N (v, t) (or_introl eq_refl)).
  unfold lower. destruct (below t (epsilon s v)); [|reflexivity].
  assert (E : set (epsilon s) v (Some t) h = epsilon s h) by (apply set_other; intros ->; now apply D).
  destruct (_ || _); exact E.
Qed.
(* What the old certificates of h allowed does not count any longer. *)
Lemma process_forgets : forall h s, (forall s' u, In u (evaluate s' h) -> fst u <> h) -> epsilon (process h s) h = None.
Proof. intros h s N. unfold process. rewrite lower_others by apply N. simpl. apply set_same. Qed.

(* The loop, with the vertices it processed. *)
Fixpoint run (rounds : nat) (s : state) : state * list vertex :=
  match rounds, queue s with
  | O, _ | _, [] => (s, [])
  | S rounds, h :: q =>
      let (t, done) := run rounds (process h {| moving := moving s; fixed := fixed s; epsilon := epsilon s; queue := q |}) in
      (t, h :: done)
  end.

(* What holds around every round. *)
Record tidy (s : state) : Prop := {
  once : NoDup (queue s);
  away : forall v, In v (queue s) -> moving s v <> fixed s v;
  caught : forall v, In v (queue s) \/ passes s v = true }.

Lemma passes_at_rest : forall s v, moving s v = fixed s v -> passes s v = true.
Proof. intros s v H. unfold passes. now destruct (same_position (moving s v) (fixed s v)). Qed.

Lemma lower_positions : forall s u, moving (lower s u) = moving s /\ fixed (lower s u) = fixed s.
Proof. intros s [v t]. unfold lower. destruct (below t (epsilon s v)); [|easy]. now destruct (orb _ _). Qed.

Lemma lower_tidy : forall s u, tidy s -> tidy (lower s u).
Proof.
  intros s [v t] T. unfold lower. destruct (below t (epsilon s v)); [|exact T].
  set (s' := {| moving := moving s; fixed := fixed s; epsilon := set (epsilon s) v (Some t); queue := queue s |}).
  assert (O : forall w, w <> v -> passes s' w = passes s w).
  { intros w H. unfold passes, s'. simpl. now rewrite set_other. }
  destruct T as [N A C]. destruct (queued s' v || passes s' v)%bool eqn:Q.
  - split; simpl; trivial. intro w. destruct (same_vertex w v) as [->|H].
    + apply Bool.orb_true_iff in Q. destruct Q as [Q|Q]; [left|right; exact Q].
      unfold queued in Q. now destruct (in_dec same_vertex v (queue s')).
    + destruct (C w) as [K|K]; [now left|right]. now rewrite O.
  - apply Bool.orb_false_iff in Q. destruct Q as [Q P].
    assert (F : ~ In v (queue s)) by (unfold queued in Q; now destruct (in_dec same_vertex v (queue s'))).
    split; simpl.
    + apply NoDup_snoc; trivial.
    + intros w K. apply in_app_iff in K. destruct K as [K|[K|[]]]; [now apply A|subst w].
      intro E. assert (X : passes s' v = true) by (apply passes_at_rest; exact E). congruence.
    + intro w. destruct (same_vertex w v) as [->|H]; [left; apply in_app_iff; right; now left|].
      destruct (C w) as [K|K]; [left; apply in_app_iff; now left|right].
      change (passes s' w = true). now rewrite O.
Qed.

Lemma lower_all : forall us s, tidy s ->
  tidy (fold_left lower us s) /\ moving (fold_left lower us s) = moving s /\ fixed (fold_left lower us s) = fixed s.
Proof.
  intro us. induction us as [|u us IH]; intros s T; simpl; [easy|].
  destruct (lower_positions s u) as [E F]. destruct (IH _ (lower_tidy s u T)) as (A & B & C). now rewrite B, C, E, F.
Qed.

(* D = 0 for the vertex that is processed; no other vertex gets a new fixed position, and positions stay. *)
Lemma process_tidy : forall s h q, tidy s -> queue s = h :: q ->
  let t := process h {| moving := moving s; fixed := fixed s; epsilon := epsilon s; queue := q |} in
  tidy t /\ moving t = moving s /\ fixed t = set (fixed s) h (moving s h).
Proof.
  intros s h q [N A C] Q. rewrite Q in *. inversion N as [|x l H M]; subst.
  unfold process. cbv zeta.
  match goal with |- tidy (fold_left _ ?us ?r) /\ _ =>
    assert (T : tidy r); [|destruct (lower_all us r T) as (X & Y & Z); repeat split; [apply X|apply X|apply X|exact Y|exact Z]] end.
  split; simpl; trivial.
  - intros v K. rewrite set_other by (intros ->; contradiction). apply A. now right.
  - intro v. destruct (same_vertex v h) as [->|D].
    + right. apply passes_at_rest. simpl. now rewrite set_same.
    + destruct (C v) as [[K|K]|K]; [now destruct D|now left|right].
      unfold passes in *. simpl. now rewrite !set_other.
Qed.

Theorem processed_rests : forall rounds s t done, tidy s -> run rounds s = (t, done) ->
  tidy t /\ moving t = moving s /\
  (forall v, In v done -> fixed t v = moving t v) /\
  (forall v, ~ In v done -> fixed t v = fixed s v).
Proof.
  intro rounds. induction rounds as [|rounds IH]; intros s t done T; simpl.
  { intro E. inversion E; subst. split; [exact T|]. now repeat split. }
  destruct (queue s) as [|h q] eqn:Q.
  { intro E. inversion E; subst. split; [exact T|]. now repeat split. }
  destruct (process_tidy s h q T Q) as (U & M & F).
  destruct (run rounds _) as [r l] eqn:E. intro K. inversion K; subst; clear K.
  destruct (IH _ _ _ U E) as (V & W & X & Y). rewrite W, M. repeat split; try apply V.
  - intros v [->|H]; [|rewrite <- M, <- W; now apply X].
    destruct (in_dec same_vertex v l) as [H|H]; [rewrite <- M, <- W; now apply X|].
    rewrite (Y v H), F. apply set_same.
  - intros v H. rewrite Y by (intro K; apply H; now right). rewrite F. apply set_other. intros ->. apply H. now left.
Qed.

(* Only vertices off their fixed positions are processed, and never twice. *)
Theorem each_once : forall rounds s t done, tidy s -> run rounds s = (t, done) ->
  NoDup done /\ (forall v, In v done -> moving s v <> fixed s v) /\ (queue t <> [] -> length done = rounds).
Proof.
  intro rounds. induction rounds as [|rounds IH]; intros s t done T; simpl.
  { intro E. inversion E; subst. repeat split; [constructor|easy]. }
  destruct (queue s) as [|h q] eqn:Q.
  { intro E. inversion E; subst. repeat split; [constructor|easy|]. now rewrite Q. }
  destruct (process_tidy s h q T Q) as (U & M & F).
  destruct (run rounds _) as [r l] eqn:E. intro K. inversion K; subst; clear K.
  destruct (IH _ _ _ U E) as (N & X & L). rewrite M, F in X. repeat split.
  - constructor; [|exact N]. intro H. apply (X h H). now rewrite set_same.
  - intros v [<-|H]; [apply (away s T); rewrite Q; now left|].
    specialize (X v H). destruct (same_vertex v h) as [->|D]; [now rewrite set_same in X|now rewrite set_other in X].
  - intro H. simpl. now rewrite L.
Qed.

Theorem at_most_n : forall rounds s t done, tidy s -> run rounds s = (t, done) -> length done <= n.
Proof. intros rounds s t done T E. apply NoDup_incl_length; [exact (proj1 (each_once _ _ _ _ T E))|]. intros v _. apply complete. Qed.

Theorem queue_runs_dry : forall s t done, tidy s -> run (S n) s = (t, done) -> queue t = [].
Proof.
  intros s t done T E. destruct (queue t) eqn:Q; [reflexivity|exfalso].
  destruct (each_once _ _ _ _ T E) as (_ & _ & L).
  generalize (at_most_n _ _ _ _ T E). rewrite L by (rewrite Q; discriminate). lia.
Qed.

Theorem all_pass : forall s t done, tidy s -> run (S n) s = (t, done) -> forall v, passes t v = true.
Proof.
  intros s t done T E v. destruct (processed_rests _ _ _ _ T E) as (U & _).
  destruct (caught t U v) as [H|H]; [|exact H]. now rewrite (queue_runs_dry _ _ _ T E) in H.
Qed.

(* One call, move(): v goes to p; if it does not pass it is the first in the queue. *)
Definition call (s : state) (v : vertex) (p : position) : state * list vertex :=
  let s' := {| moving := set (moving s) v p; fixed := fixed s; epsilon := epsilon s; queue := [] |} in
  if passes s' v then (s', []) else run (S n) {| moving := moving s'; fixed := fixed s'; epsilon := epsilon s'; queue := [v] |}.

Definition at_rest (s : state) : Prop := queue s = [] /\ forall v, passes s v = true.

Lemma call_tidy : forall s v p, at_rest s ->
  let s' := {| moving := set (moving s) v p; fixed := fixed s; epsilon := epsilon s; queue := [] |} in
  passes s' v = false ->
  tidy {| moving := moving s'; fixed := fixed s'; epsilon := epsilon s'; queue := [v] |}.
Proof.
  intros s v p [_ P] s' H. split; simpl.
  - constructor; [easy|constructor].
  - intros w [->|[]] E. change (moving s' w = fixed s' w) in E. rewrite (passes_at_rest s' w E) in H. discriminate.
  - intro w. destruct (same_vertex w v) as [->|D]; [now left; left|right].
    unfold passes. simpl. rewrite set_other by exact D. exact (P w).
Qed.

Theorem call_comes_to_rest : forall s v p t done, at_rest s -> call s v p = (t, done) ->
  at_rest t /\ moving t = set (moving s) v p /\ NoDup done /\ length done <= n /\ (forall w, In w done -> fixed t w = moving t w).
Proof.
  intros s v p t done T. unfold call.
  destruct (passes {| moving := set (moving s) v p; fixed := fixed s; epsilon := epsilon s; queue := [] |} v) eqn:P.
  - intro E. inversion E; subst. repeat split; simpl; try easy; [|constructor|lia].
    intro w. destruct (same_vertex w v) as [->|D]; [exact P|].
    unfold passes. simpl. rewrite set_other by exact D. exact (proj2 T w).
  - intro E. assert (U := call_tidy s v p T P).
    destruct (processed_rests _ _ _ _ U E) as (_ & M & F & _).
    repeat split; [exact (queue_runs_dry _ _ _ U E)|exact (all_pass _ _ _ U E)|exact M| | |exact F].
    + exact (proj1 (each_once _ _ _ _ U E)).
    + exact (at_most_n _ _ _ _ U E).
Qed.

(* Counting. *)
Definition off (s : state) (v : vertex) : bool := if same_position (moving s v) (fixed s v) then false else true.
Definition number_off (s : state) : nat := length (filter (off s) vertices).

Definition among (l : list vertex) (v : vertex) : bool := if in_dec same_vertex v l then true else false.
Lemma length_among : forall l, NoDup l -> length (filter (among l) vertices) = length l.
Proof.
  intros l N. apply Nat.le_antisymm; apply NoDup_incl_length; try assumption.
  - apply NoDup_filter, distinct.
  - intros v H. apply filter_In in H. destruct H as [_ H]. unfold among in H. now destruct (in_dec same_vertex v l).
  - intros v H. apply filter_In. split; [apply complete|]. unfold among. now destruct (in_dec same_vertex v l).
Qed.

(* A call processes no more vertices than it takes off the list of those that are off, plus the one it moves. *)
Lemma call_counts : forall s v p t done, at_rest s -> call s v p = (t, done) -> length done + number_off t <= number_off s + 1.
Proof.
  intros s v p t done T. unfold call.
  set (s' := {| moving := set (moving s) v p; fixed := fixed s; epsilon := epsilon s; queue := [] |}).
  assert (B : number_off s' <= number_off s + 1).
  { unfold number_off. replace 1 with (length (filter (among [v]) vertices))
      by (rewrite length_among; [reflexivity|constructor; [easy|constructor]]).
    apply filter_partition. intros w _ H. destruct (same_vertex w v) as [->|D].
    - right. unfold among. destruct (in_dec same_vertex v [v]) as [_|K]; [reflexivity|]. exfalso. apply K. now left.
    - left. unfold off, s' in H. simpl in H. rewrite set_other in H by exact D. exact H. }
  destruct (passes s' v) eqn:P; intro E; [inversion E; subst; simpl; exact B|].
  assert (U := call_tidy s v p T P).
  destruct (processed_rests _ _ _ _ U E) as (_ & M & F & G). destruct (each_once _ _ _ _ U E) as (N & A & _).
  apply Nat.le_trans with (2 := B). unfold number_off. rewrite <- (length_among done N).
  apply filter_disjoint.
  - intros w _ H. unfold among in H. destruct (in_dec same_vertex w done) as [K|]; [|discriminate].
    specialize (A w K). unfold off. now destruct (same_position (moving s' w) (fixed s' w)).
  - intros w _ H. unfold off in *. destruct (in_dec same_vertex w done) as [K|K].
    + rewrite (F w K) in H. now destruct (same_position (moving t w) (moving t w)).
    + rewrite (G w K), M in H. exact H.
  - intros w _ [H K]. unfold among in H. destruct (in_dec same_vertex w done) as [L|]; [|discriminate].
    unfold off in K. rewrite (F w L) in K. now destruct (same_position (moving t w) (moving t w)).
Qed.

(* Calls one after another: how often anything was processed. *)
Fixpoint calls (s : state) (moves : list (vertex * position)) : state * nat :=
  match moves with
  | [] => (s, 0)
  | (v, p) :: moves => let (t, done) := call s v p in let (u, k) := calls t moves in (u, length done + k)
  end.

Theorem processed_moves : forall moves s t k, at_rest s -> calls s moves = (t, k) ->
  at_rest t /\ k + number_off t <= number_off s + length moves.
Proof.
  intro moves. induction moves as [|[v p] moves IH]; intros s t k T; simpl.
  - intro E. inversion E; subst. split; [exact T|lia].
  - destruct (call s v p) as [r done] eqn:C. destruct (calls r moves) as [u l] eqn:D. intro E. inversion E; subst.
    destruct (call_comes_to_rest _ _ _ _ _ T C) as (R & _). destruct (IH _ _ _ R D) as (X & Y).
    generalize (call_counts _ _ _ _ _ T C). split; [exact X|lia].
Qed.

Lemma number_off_le : forall s, number_off s <= n.
Proof. intro s. apply NoDup_incl_length; [apply NoDup_filter, distinct|]. intros v H. apply filter_In in H. apply H. Qed.

(* The paper's 2n, and what it amounts to in the long run. *)
Corollary time_step : forall moves s t k, at_rest s -> length moves <= n -> calls s moves = (t, k) -> k <= 2 * n.
Proof. intros moves s t k T L E. destruct (processed_moves _ _ _ _ T E) as [_ B]. generalize (number_off_le s). lia. Qed.

Corollary time_steps : forall times moves s t k, at_rest s -> length moves <= times * n -> calls s moves = (t, k) -> k <= (times + 1) * n.
Proof. intros times moves s t k T L E. destruct (processed_moves _ _ _ _ T E) as [_ B]. generalize (number_off_le s). lia. Qed.
End queue.
