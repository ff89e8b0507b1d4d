(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The strategy `filter` (docs/theory.md 5.1 to 5.3; src/annulus/relocation/filter.cpp) as a transition system: odometers, expiries, a
   step that evaluates some certificates and leaves the others alone.

   - travelled          an odometer bounds the way since any earlier anchoring
   - every_certificate_holds   after a step every certificate holds, evaluated or not
   - step_preserves     the invariants hold again
   - filter_is_right    by induction: after any number of steps

   Positions are of any metric space. A certificate may count on others (an empty circle on its two triangles); that is
   well-founded. What a record promises is `sound`: the certificate holds while each of its points is within an allowance of
   its reference, or at it. For evaluated certificates the allowance is the tolerance, for all points; unequal moves give
   two allowances, a kept circle one for each point: all are records like any other here.
   Numbers are real: of the rounded ones the step asks only that they err on the side that is named.

   Not in this model: that Repair makes the violated ones hold (it is part of the hypothesis `written`: a record of the step is
   sound at the new placement), and that all certificates together say Delaunay (theory 1). *)
Require Import Reals Lra Wellfounded.
Open Scope R_scope.

Section filter.
Variables (position vertex certificate : Type).
Variable dist : position -> position -> R.
Hypothesis dist_nonneg : forall a b, 0 <= dist a b.
Hypothesis dist_zero : forall a, dist a a = 0.
Hypothesis dist_triangle : forall a b c, dist a c <= dist a b + dist b c.

Definition placement := vertex -> position.
Variable has : certificate -> vertex -> Prop.              (* the points of a certificate *)
Variable holds : certificate -> placement -> Prop.
Variable counts_on : certificate -> certificate -> Prop.   (* counts_on d c: c is certified given that d holds *)
Hypothesis counts_on_wf : well_founded counts_on.

(* Near its reference, or at it (tolerance 0: only at it). *)
Definition near (m reference : placement) (allowance : vertex -> R) (v : vertex) : Prop :=
  dist (reference v) (m v) < allowance v \/ m v = reference v.

Definition sound (c : certificate) (reference : placement) (allowance : vertex -> R) : Prop :=
  forall m, (forall v, has c v -> near m reference allowance v) -> (forall d, counts_on d c -> holds d m) -> holds c m.

Record state := {
  moving : placement;
  fixed : placement;
  base : vertex -> R;                          (* odometer: length of the path of fixed positions, or more *)
  current : certificate -> Prop;               (* those of the triangulation *)
  reference : certificate -> placement;        (* where the record was made *)
  reading : certificate -> vertex -> R;        (* base of the point right after that *)
  allowance : certificate -> vertex -> R;
  expiry : certificate -> vertex -> R;
  earliest : vertex -> R }.

Record invariant (s : state) : Prop := {
  records : forall c, current s c -> sound c (reference s c) (allowance s c);
  closed : forall c d, current s c -> counts_on d c -> current s d;
  path : forall c v, current s c -> has c v -> dist (reference s c v) (fixed s v) <= base s v - reading s c v;
  expires : forall c v, current s c -> has c v -> expiry s c v <= reading s c v + allowance s c v;
  listed : forall c v, current s c -> has c v -> earliest s v <= expiry s c v;
  rests : forall c v, current s c -> has c v -> near (fixed s) (reference s c) (allowance s c) v;
  placed : forall c v, current s c -> has c v -> near (moving s) (reference s c) (allowance s c) v }.

(* 5.1: what an odometer says. *)
Lemma travelled : forall s, invariant s -> forall c v p, current s c -> has c v ->
  dist (reference s c v) p <= base s v + dist (fixed s v) p - reading s c v.
Proof.
  intros s I c v p C H. generalize (path s I c v C H) (dist_triangle (reference s c v) (fixed s v) p). lra.
Qed.

Theorem holds_everywhere : forall s, invariant s -> forall c, current s c -> holds c (moving s).
Proof.
  intros s I c. induction c as [c IH] using (well_founded_ind counts_on_wf). intro C.
  apply (records s I c C).
  - intros v H. exact (placed s I c v C H).
  - intros d D. apply IH; [exact D|exact (closed s I c d C D)].
Qed.

(* The test of a step, and what it has to imply: docs/theory.md 4.1, the comparison of squares. *)
Definition passes (s : state) (m : placement) (v : vertex) : Prop :=
  base s v + dist (fixed s v) (m v) < earliest s v \/ m v = fixed s v.

(* A step to m. `anchored`: vertices whose fixed position becomes m. `written`: certificates that were evaluated, created by
   repair, or proved around m by a kept circle; `renewed`: those whose expiries were changed without a new reference. *)
Record step (s : state) (m : placement) (anchored : vertex -> Prop) (written renewed : certificate -> Prop) (t : state) : Prop := {
  to : moving t = m;
  anchored_or_not : forall v, anchored v \/ ~ anchored v;
  anchors : forall v, anchored v -> fixed t v = m v /\ base s v + dist (fixed s v) (m v) <= base t v;
  others : forall v, ~ anchored v -> fixed t v = fixed s v /\ base t v = base s v;
  failures : forall v, ~ anchored v -> passes s m v;
  written_or_not : forall c, current t c -> written c \/ (current s c /\ ~ written c);
  still_closed : forall c d, current t c -> counts_on d c -> current t d;
  (* A written record: sound at m, all its points anchored. *)
  written_record : forall c, current t c -> written c ->
    reference t c = m /\ sound c m (allowance t c) /\
    forall v, has c v -> anchored v /\ reading t c v = base t v /\ expiry t c v <= base t v + allowance t c v;
  (* A renewed record: the old reference, other allowances, nothing expired. *)
  renewed_record : forall c, current t c -> ~ written c -> renewed c ->
    reference t c = reference s c /\ reading t c = reading s c /\ sound c (reference s c) (allowance t c) /\
    forall v, has c v -> expiry t c v <= reading t c v + allowance t c v /\
                         base s v + dist (fixed s v) (m v) < expiry t c v;
  (* A record left alone: no point failed and found it expired. A point that passes need not be asked. *)
  kept_record : forall c, current t c -> ~ written c -> ~ renewed c ->
    reference t c = reference s c /\ reading t c = reading s c /\ allowance t c = allowance s c /\ expiry t c = expiry s c /\
    forall v, has c v -> passes s m v \/ base s v + dist (fixed s v) (m v) < expiry s c v;
  renewed_or_not : forall c, renewed c \/ ~ renewed c;
  relisted : forall c v, current t c -> has c v -> earliest t v <= expiry t c v }.

Section one.
Variables (s t : state) (m : placement) (anchored : vertex -> Prop) (written renewed : certificate -> Prop).
Hypothesis I : invariant s.
Hypothesis S : step s m anchored written renewed t.

(* Where a certificate that was not evaluated has its points after the step. *)
Lemma kept_near : forall c v, current t c -> ~ written c -> has c v -> near m (reference t c) (allowance t c) v.
Proof.
  intros c v C W H. destruct (written_or_not _ _ _ _ _ _ S c C) as [N|[C' _]]; [contradiction|].
  destruct (renewed_or_not _ _ _ _ _ _ S c) as [N|N].
  - destruct (renewed_record _ _ _ _ _ _ S c C W N) as (Er & Eb & _ & K). destruct (K v H) as [X L].
    left. rewrite Er. rewrite Eb in X. generalize (travelled s I c v (m v) C' H). lra.
  - destruct (kept_record _ _ _ _ _ _ S c C W N) as (Er & _ & Ea & _ & K). unfold near. rewrite Er, Ea.
    assert (E := expires s I c v C' H). assert (T := travelled s I c v (m v) C' H).
    destruct (K v H) as [[P|P]|P].
    + left. generalize (listed s I c v C' H). lra.
    + rewrite P. exact (rests s I c v C' H).
    + left. lra.
Qed.

Lemma at_reference : forall c v, current t c -> written c -> near m (reference t c) (allowance t c) v.
Proof. intros c v C W. right. now rewrite (proj1 (written_record _ _ _ _ _ _ S c C W)). Qed.

Lemma all_near : forall c v, current t c -> has c v -> near m (reference t c) (allowance t c) v.
Proof.
  intros c v C H. destruct (written_or_not _ _ _ _ _ _ S c C) as [W|[_ W]]; [now apply at_reference|now apply kept_near].
Qed.

Theorem step_preserves : invariant t.
Proof.
  split.
  - intros c C. destruct (written_or_not _ _ _ _ _ _ S c C) as [W|[C' W]].
    + destruct (written_record _ _ _ _ _ _ S c C W) as (E & K & _). now rewrite E.
    + destruct (renewed_or_not _ _ _ _ _ _ S c) as [N|N].
      * destruct (renewed_record _ _ _ _ _ _ S c C W N) as (E & _ & K & _). now rewrite E.
      * destruct (kept_record _ _ _ _ _ _ S c C W N) as (E & _ & A & _). rewrite E, A. exact (records s I c C').
  - exact (still_closed _ _ _ _ _ _ S).
  - intros c v C H. destruct (written_or_not _ _ _ _ _ _ S c C) as [W|[C' W]].
    + destruct (written_record _ _ _ _ _ _ S c C W) as (E & _ & K). destruct (K v H) as (A & B & _).
      destruct (anchors _ _ _ _ _ _ S v A) as [F _]. rewrite E, F, B, dist_zero. lra.
    + assert (E : reference t c = reference s c /\ reading t c = reading s c).
      { destruct (renewed_or_not _ _ _ _ _ _ S c) as [N|N].
        - destruct (renewed_record _ _ _ _ _ _ S c C W N) as (X & Y & _). now split.
        - destruct (kept_record _ _ _ _ _ _ S c C W N) as (X & Y & _). now split. }
      destruct E as [-> ->]. destruct (anchored_or_not _ _ _ _ _ _ S v) as [A|A].
      * destruct (anchors _ _ _ _ _ _ S v A) as [-> B]. generalize (travelled s I c v (m v) C' H). lra.
      * destruct (others _ _ _ _ _ _ S v A) as [-> ->]. exact (path s I c v C' H).
  - intros c v C H. destruct (written_or_not _ _ _ _ _ _ S c C) as [W|[C' W]].
    + destruct (written_record _ _ _ _ _ _ S c C W) as (_ & _ & K). destruct (K v H) as (_ & -> & E). exact E.
    + destruct (renewed_or_not _ _ _ _ _ _ S c) as [N|N].
      * destruct (renewed_record _ _ _ _ _ _ S c C W N) as (_ & _ & _ & K). exact (proj1 (K v H)).
      * destruct (kept_record _ _ _ _ _ _ S c C W N) as (_ & -> & -> & -> & _). exact (expires s I c v C' H).
  - exact (relisted _ _ _ _ _ _ S).
  - (* A fixed position is the present one, or the old one. *)
    intros c v C H. destruct (anchored_or_not _ _ _ _ _ _ S v) as [A|A].
    + unfold near. rewrite (proj1 (anchors _ _ _ _ _ _ S v A)). exact (all_near c v C H).
    + unfold near. rewrite (proj1 (others _ _ _ _ _ _ S v A)).
      destruct (written_or_not _ _ _ _ _ _ S c C) as [W|[C' W]].
      * destruct (written_record _ _ _ _ _ _ S c C W) as (_ & _ & K). now destruct (K v H) as (B & _).
      * destruct (renewed_or_not _ _ _ _ _ _ S c) as [N|N].
        -- destruct (renewed_record _ _ _ _ _ _ S c C W N) as (-> & E & _ & K). destruct (K v H) as [X L]. rewrite E in X.
           left. generalize (path s I c v C' H) (dist_nonneg (fixed s v) (m v)). lra.
        -- destruct (kept_record _ _ _ _ _ _ S c C W N) as (-> & _ & -> & _). exact (rests s I c v C' H).
  - intros c v C H. rewrite (to _ _ _ _ _ _ S). exact (all_near c v C H).
Qed.

Theorem every_certificate_holds : forall c, current t c -> holds c m.
Proof. rewrite <- (to _ _ _ _ _ _ S). exact (holds_everywhere t step_preserves). Qed.
End one.

Inductive reachable (s : state) : state -> Prop :=
  | here : reachable s s
  | further : forall t u m anchored written renewed, reachable s t -> step t m anchored written renewed u -> reachable s u.

Theorem filter_is_right : forall s t, invariant s -> reachable s t -> invariant t /\ forall c, current t c -> holds c (moving t).
Proof.
  intros s t I R. assert (J : invariant t).
  { induction R as [|t u m anchored written renewed R IH S]; [exact I|exact (step_preserves _ _ _ _ _ _ IH S)]. }
  split; [exact J|exact (holds_everywhere t J)].
Qed.

(* After a settling: everything anchored and written here. *)
Theorem settled : forall s, (forall v, fixed s v = moving s v) -> (forall c, current s c -> reference s c = moving s) ->
  (forall c, current s c -> sound c (moving s) (allowance s c)) -> (forall c d, current s c -> counts_on d c -> current s d) ->
  (forall c v, current s c -> has c v -> reading s c v = base s v /\ expiry s c v <= base s v + allowance s c v /\
                                         earliest s v <= expiry s c v) -> invariant s.
Proof.
  intros s F R K D L. split; trivial.
  - intros c C. rewrite (R c C). exact (K c C).
  - intros c v C H. rewrite (R c C), F, dist_zero. destruct (L c v C H) as [-> _]. lra.
  - intros c v C H. destruct (L c v C H) as (-> & E & _). exact E.
  - intros c v C H. now destruct (L c v C H) as (_ & _ & E).
  - intros c v C H. right. now rewrite F, (R c C).
  - intros c v C H. right. now rewrite (R c C).
Qed.
End filter.
