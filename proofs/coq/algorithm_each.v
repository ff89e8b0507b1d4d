(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Why `filter-each` with certified tolerances is right (docs/theory.md 5.5): certificates are evaluated at the moving positions, and a
   point that was off its fixed position then is allowed what is left of the tolerance. algorithm_queue.v has the queue and its end;
   here: what holds while it is worked off, and that with nobody waiting every certificate holds where the points are.

   The paper's algorithm is the case in which references are fixed positions. *)
Require Import Reals Lra Wellfounded.
Open Scope R_scope.

Section each.
Variables (position vertex certificate : Type).
Variable dist : position -> position -> R.
Hypothesis dist_nonneg : forall a b, 0 <= dist a b.
Hypothesis dist_zero : forall a, dist a a = 0.
Hypothesis dist_symmetric : forall a b, dist a b = dist b a.
Hypothesis dist_triangle : forall a b c, dist a c <= dist a b + dist b c.

Definition placement := vertex -> position.
Variable has : certificate -> vertex -> Prop.
Variable holds : certificate -> placement -> Prop.
Variable counts_on : certificate -> certificate -> Prop.
Hypothesis counts_on_wf : well_founded counts_on.

Definition near (m reference : placement) (tolerance : R) (v : vertex) : Prop :=
  dist (reference v) (m v) < tolerance \/ m v = reference v.
Definition sound (c : certificate) (reference : placement) (tolerance : R) : Prop :=
  forall m, (forall v, has c v -> near m reference tolerance v) -> (forall d, counts_on d c -> holds d m) -> holds c m.

Record state := {
  moving : placement;
  fixed : placement;
  epsilon : vertex -> R;
  current : certificate -> Prop;
  reference : certificate -> placement;
  tolerance : certificate -> R;
  waiting : vertex -> Prop }.

Definition passes (s : state) (v : vertex) : Prop := dist (fixed s v) (moving s v) < epsilon s v \/ moving s v = fixed s v.

Record invariant (s : state) : Prop := {
  records : forall c, current s c -> sound c (reference s c) (tolerance s c);
  closed : forall c d, current s c -> counts_on d c -> current s d;
  J1 : forall c v, current s c -> has c v -> epsilon s v <= tolerance s c - dist (reference s c v) (fixed s v);
  J2 : forall v, waiting s v \/ passes s v;
  J3 : forall c v, current s c -> has c v -> waiting s v \/ near (fixed s) (reference s c) (tolerance s c) v }.

Theorem holds_everywhere : forall s, invariant s -> (forall v, ~ waiting s v) -> forall c, current s c -> holds c (moving s).
Proof.
  intros s I W c. induction c as [c IH] using (well_founded_ind counts_on_wf). intro C.
  apply (records s I c C).
  - intros v H. destruct (J2 s I v) as [K|[K|K]]; [now destruct (W v)| |].
    + left. generalize (J1 s I c v C H) (dist_triangle (reference s c v) (fixed s v) (moving s v)). lra.
    + unfold near. rewrite K. destruct (J3 s I c v C H) as [N|N]; [now destruct (W v)|exact N].
  - intros d D. apply IH; [exact D|exact (closed s I c d C D)].
Qed.

(* A vertex goes somewhere; it waits unless it passes. *)
Record moved (s : state) (v : vertex) (t : state) : Prop := {
  same_fixed : fixed t = fixed s;
  same_epsilon : epsilon t = epsilon s;
  same_current : current t = current s;
  same_reference : reference t = reference s;
  same_tolerance : tolerance t = tolerance s;
  only_v : forall w, w = v \/ moving t w = moving s w;
  v_waits : waiting t v \/ passes t v;
  still_waiting : forall w, waiting s w -> waiting t w }.

Theorem moved_preserves : forall s v t, invariant s -> moved s v t -> invariant t.
Proof.
  intros s v t [A B C D E] [F G H I J K L M]. split.
  - rewrite H, I, J. exact A.
  - rewrite H. exact B.
  - rewrite F, G, H, I, J. exact C.
  - intro w. destruct (K w) as [->|N]; [exact L|]. destruct (D w) as [P|P]; [left; now apply M|right].
    unfold passes in *. now rewrite N, F, G.
  - rewrite F, H, I, J. intros c w X Y. destruct (E c w X Y) as [P|P]; [left; now apply M|now right].
Qed.

(* process(): h is fixed where it is. Its certificates are evaluated at the moving positions, and what repair creates, there too. *)
Record processed (s : state) (h : vertex) (written : certificate -> Prop) (t : state) : Prop := {
  same_moving : moving t = moving s;
  fixed_h : fixed t h = moving s h;
  fixed_others : forall w, w = h \/ fixed t w = fixed s w;
  h_is_done : ~ waiting t h;
  waits_on : forall w, waiting s w -> w = h \/ waiting t w;
  who_fails_waits : forall w, waiting t w \/ passes t w;
  written_or_not : forall c, current t c -> written c \/ (current s c /\ ~ written c);
  still_closed : forall c d, current t c -> counts_on d c -> current t d;
  of_h : forall c, current t c -> has c h -> written c;
  lowered : forall w, w = h \/ epsilon t w <= epsilon s w;
  written_record : forall c, current t c -> written c -> reference t c = moving s /\ sound c (moving s) (tolerance t c) /\
    forall w, has c w -> epsilon t w <= tolerance t c - dist (moving s w) (fixed t w);
  kept_record : forall c, current t c -> ~ written c -> reference t c = reference s c /\ tolerance t c = tolerance s c }.

Theorem processed_preserves : forall s h written t, invariant s -> processed s h written t -> invariant t.
Proof.
  intros s h written t I P. split.
  - intros c C. destruct (written_or_not _ _ _ _ P c C) as [W|[C' W]].
    + destruct (written_record _ _ _ _ P c C W) as (-> & K & _). exact K.
    + destruct (kept_record _ _ _ _ P c C W) as [-> ->]. exact (records s I c C').
  - exact (still_closed _ _ _ _ P).
  - intros c v C H. destruct (written_or_not _ _ _ _ P c C) as [W|[C' W]].
    + destruct (written_record _ _ _ _ P c C W) as (-> & _ & K). exact (K v H).
    + destruct (kept_record _ _ _ _ P c C W) as [-> ->].
      destruct (lowered _ _ _ _ P v) as [->|L]; [now destruct W; apply (of_h _ _ _ _ P)|].
      destruct (fixed_others _ _ _ _ P v) as [->|F]; [now destruct W; apply (of_h _ _ _ _ P)|].
      rewrite F. generalize (J1 s I c v C' H). lra.
  - exact (who_fails_waits _ _ _ _ P).
  - intros c v C H. destruct (written_or_not _ _ _ _ P c C) as [W|[C' W]].
    + (* evaluated where v is: v is at its fixed position, or passes with what is left, or waits *)
      destruct (written_record _ _ _ _ P c C W) as (E & _ & K). unfold near. rewrite E.
      destruct (who_fails_waits _ _ _ _ P v) as [N|[N|N]]; [now left| |].
      * right. left. rewrite (same_moving _ _ _ _ P), dist_symmetric in N. generalize (K v H) (dist_nonneg (moving s v) (fixed t v)). lra.
      * right. right. now rewrite <- N, (same_moving _ _ _ _ P).
    + destruct (kept_record _ _ _ _ P c C W) as [E F]. unfold near. rewrite E, F.
      destruct (fixed_others _ _ _ _ P v) as [->|G]; [now destruct W; apply (of_h _ _ _ _ P)|]. rewrite G.
      destruct (J3 s I c v C' H) as [N|N]; [|right; exact N].
      destruct (waits_on _ _ _ _ P v N) as [->|M]; [now destruct W; apply (of_h _ _ _ _ P)|now left].
Qed.
End each.
