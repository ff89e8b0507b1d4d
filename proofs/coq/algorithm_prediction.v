(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Prediction (docs/theory.md 5.4; src/annulus/relocation/prediction.h): `filter` with fixed positions that move along.

   - term_lasts         a record made at time t0 with tolerance s, velocities within rho of one vector, is sound at time t for
                        deviations of sigma s, as long as (t - t0) rho <= (1 - sigma) s
   - prediction_step    if every record whose term has ended is written again, all certificates hold after a step, and the
                        invariants are those of algorithm_filter.v again
   - prediction_is_right   by induction: after any number of steps, at times that do not run backwards

   A vertex with velocity u is described in a frame of its own, by y = m - t u: there its expected position is its fixed one, its deviation the
   distance from it, and a step is one of algorithm_filter.v. What is new is that `holds` depends on the time, and that it
   is the same for two placements that differ by one vector (`translated`).
   Numbers are real; that expected positions are computed with rounding, and `slack`, is not in the model. Velocities do not change (a settling
   begins anew). Second looks, `renewed` there, are off, as they are in the code under a prediction. *)
Require Import Reals Lra Wellfounded.
From Annulus Require Import vectors algorithm_filter.
Open Scope R_scope.

Definition dist a b := norm (b ⊖ a).

Lemma dist_nonneg a b : 0 <= dist a b.
Proof. apply norm_nonneg. Qed.

Lemma dist_zero a : dist a a = 0.
Proof.
  unfold dist, norm. replace (sq (a ⊖ a)) with 0 by vector. apply sqrt_0.
Qed.

Lemma dist_triangle a b c : dist a c <= dist a b + dist b c.
Proof.
  unfold dist. replace (c ⊖ a) with ((b ⊖ a) ⊕ (c ⊖ b)) by vector. apply norm_add.
Qed.

Section prediction.
Variables vertex certificate : Type.
Variable velocity : vertex -> vec.
Variable has : certificate -> vertex -> Prop.
Variable Holds : certificate -> (vertex -> vec) -> Prop.      (* at positions in space *)
Variable counts_on : certificate -> certificate -> Prop.
Hypothesis counts_on_wf : well_founded counts_on.
Hypothesis translated : forall c m w, Holds c (fun v => m v ⊕ w) -> Holds c m.
Hypothesis same_points : forall c m m', (forall v, m v = m' v) -> Holds c m -> Holds c m'.

Definition place := vertex -> vec.
Definition at_time (t : R) (y : place) : place := fun v => y v ⊕ t ⊙ velocity v.

(* At time t, in the frames; given the certificates it counts on. *)
Definition holds_at t c (y : place) := Holds c (at_time t y).
Definition given t c (y : place) := (forall d, counts_on d c -> holds_at t d y) -> holds_at t c y.
Definition alone (_ _ : certificate) := False.
Definition near_ := near vec vertex dist.
Definition sound_at t := sound vec vertex certificate dist has (given t) alone.

(* What evaluation promises: a tolerance, at positions in space. *)
Definition tolerance c (m : place) (s : R) := forall m', (forall v, has c v -> near_ m' m (fun _ => s) v) ->
  (forall d, counts_on d c -> Holds d m') -> Holds c m'.

Theorem term_lasts c y0 t0 t s sigma rho w : 0 <= s -> 0 < sigma -> t0 <= t ->
  tolerance c (at_time t0 y0) s -> (forall v, has c v -> norm (velocity v ⊖ w) <= rho) ->
  (t - t0) * rho <= (1 - sigma) * s -> sound_at t c y0 (fun _ => sigma * s).
Proof.
  intros Hs Hsigma Ht T V L y Near _ Others.
  (* Everything moved back by what all of them moved. *)
  set (back := (- (t - t0)) ⊙ w).
  set (m' := fun v => at_time t y v ⊕ back).
  apply translated with back. apply (T m').
  - intros v H.
    assert (E : m' v ⊖ at_time t0 y0 v = (y v ⊖ y0 v) ⊕ (t - t0) ⊙ (velocity v ⊖ w)).
    { unfold m', back, at_time. generalize (y v) (y0 v) (velocity v). vector. }
    assert (D : norm ((t - t0) ⊙ (velocity v ⊖ w)) <= (1 - sigma) * s).
    { rewrite norm_scale, Rabs_pos_eq by lra. apply Rle_trans with ((t - t0) * rho); [|exact L].
      apply Rmult_le_compat_l; [lra|now apply V]. }
    unfold near_, near, dist. rewrite E.
    destruct (Near v H) as [N|N].
    + left. unfold dist in N. generalize (norm_add (y v ⊖ y0 v) ((t - t0) ⊙ (velocity v ⊖ w))). lra.
    + destruct (Rle_lt_or_eq_dec 0 s Hs) as [S|S].
      * left. rewrite N. replace ((y0 v ⊖ y0 v) ⊕ (t - t0) ⊙ (velocity v ⊖ w)) with ((t - t0) ⊙ (velocity v ⊖ w))
          by (generalize (y0 v) (velocity v); vector).
        assert (0 < sigma * s) by (now apply Rmult_lt_0_compat). lra.
      * right. rewrite <- S in D.
        assert (Z : (t - t0) ⊙ (velocity v ⊖ w) = zero).
        { apply norm_zero. generalize (norm_nonneg ((t - t0) ⊙ (velocity v ⊖ w))). lra. }
        replace (m' v) with (at_time t0 y0 v ⊕ (m' v ⊖ at_time t0 y0 v)) by (generalize (m' v) (at_time t0 y0 v); vector).
        rewrite E, Z, N. generalize (at_time t0 y0 v) (y0 v). vector.
  - intros d D. apply translated with ((t - t0) ⊙ w).
    apply (same_points d (at_time t y)); [|exact (Others d D)].
    intro v. unfold m', back. generalize (at_time t y v). vector.
Qed.

Notation state := (state vec vertex certificate).
Notation invariant t := (invariant vec vertex certificate dist has (given t) alone).
Notation step t := (step vec vertex certificate dist has (given t) alone).

(* Records whose term goes on at time t; and states in which every record is sound as long as its term. *)
Definition going_on (until : certificate -> R) (t : R) (s : state) : state :=
  {| moving := moving _ _ _ s; fixed := fixed _ _ _ s; base := base _ _ _ s;
     current := fun c => current _ _ _ s c /\ t <= until c;
     reference := reference _ _ _ s; reading := reading _ _ _ s; allowance := allowance _ _ _ s;
     expiry := expiry _ _ _ s; earliest := earliest _ _ _ s |}.

Definition lasting (until : certificate -> R) (now : R) (s : state) : Prop :=
  forall c, current _ _ _ s c -> now <= until c /\
    forall t, now <= t <= until c -> sound_at t c (reference _ _ _ s c) (allowance _ _ _ s c).

Definition right_at (until : certificate -> R) (now : R) (s : state) : Prop := invariant now s /\ lasting until now s.

Lemma all_hold until now s : right_at until now s -> forall c, current _ _ _ s c ->
  (forall c d, current _ _ _ s c -> counts_on d c -> current _ _ _ s d) -> Holds c (at_time now (moving _ _ _ s)).
Proof.
  intros [I _] c. induction c as [c IH] using (well_founded_ind counts_on_wf). intros C Closed.
  assert (W : well_founded alone) by (intro x; constructor; intros ? []).
  apply (holds_everywhere vec vertex certificate dist has (given now) alone W s I c C).
  intros d D. exact (IH d D (Closed c d C D) Closed).
Qed.

(* Time passes: what goes on is what it was. *)
Lemma time_passes until now t s : right_at until now s -> now <= t -> invariant t (going_on until t s).
Proof.
  intros [I L] N. destruct I. split; simpl.
  - intros c [C U]. exact (proj2 (L c C) t (conj N U)).
  - intros c d _ [].
  - intros c v [C _]. now apply path.
  - intros c v [C _]. now apply expires.
  - intros c v [C _]. now apply listed.
  - intros c v [C _]. now apply rests.
  - intros c v [C _]. now apply placed.
Qed.

Theorem prediction_step until until' now t s y anchored written s' : right_at until now s -> now <= t ->
  step t (going_on until t s) y anchored written (fun _ => False) s' ->
  (* written records: a term, and sound until its end; the others keep theirs *)
  (forall c, current _ _ _ s' c -> written c -> t <= until' c /\
    forall t', t <= t' <= until' c -> sound_at t' c y (allowance _ _ _ s' c)) ->
  (forall c, ~ written c -> until' c = until c) ->
  right_at until' t s'.
Proof.
  intros [I L] N S W K. assert (J := time_passes until now t s (conj I L) N). split.
  - exact (step_preserves vec vertex certificate dist dist_nonneg dist_zero dist_triangle has (given t) alone _ s' y _ _ _ J S).
  - intros c C. destruct (written_or_not _ _ _ _ _ _ _ _ _ _ _ _ _ S c C) as [A|[[C0 U] A]].
    + destruct (written_record _ _ _ _ _ _ _ _ _ _ _ _ _ S c C A) as (E & _). rewrite E. exact (W c C A).
    + destruct (kept_record _ _ _ _ _ _ _ _ _ _ _ _ _ S c C A (fun x => x)) as (E & _ & E' & _).
      rewrite E, E', (K c A). simpl. split; [exact U|]. intros t' [T T'].
      apply (proj2 (L c C0)). split; [now apply Rle_trans with t|exact T'].
Qed.

Inductive reached : (certificate -> R) -> R -> state -> (certificate -> R) -> R -> state -> Prop :=
  | start until now s : reached until now s until now s
  | later until now s until1 t1 s1 until2 t2 s2 y anchored written : reached until now s until1 t1 s1 -> t1 <= t2 ->
      step t2 (going_on until1 t2 s1) y anchored written (fun _ => False) s2 ->
      (forall c, current _ _ _ s2 c -> written c -> t2 <= until2 c /\
        forall t', t2 <= t' <= until2 c -> sound_at t' c y (allowance _ _ _ s2 c)) ->
      (forall c, ~ written c -> until2 c = until1 c) -> reached until now s until2 t2 s2.

Theorem prediction_is_right until now s until' t s' : right_at until now s -> reached until now s until' t s' ->
  (forall c d, current _ _ _ s' c -> counts_on d c -> current _ _ _ s' d) ->
  right_at until' t s' /\ forall c, current _ _ _ s' c -> Holds c (at_time t (moving _ _ _ s')).
Proof.
  intros R H Closed. assert (G : right_at until' t s').
  { clear Closed. induction H as [|until now s until1 t1 s1 until2 t2 s2 y anchored written H IH T S W K]; [exact R|].
    exact (prediction_step _ _ _ _ _ _ _ _ _ (IH R) T S W K). }
  split; [exact G|]. intros c C. exact (all_hold _ _ _ G c C Closed).
Qed.
End prediction.
