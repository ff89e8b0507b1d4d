(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* When the winding of the border need not be looked at again: docs/theory.md 1.3, in the plane.

   - certified_keep    each ridge rests, or is certified from some reference before and after by a tolerance that covers both
   - one_vertex_keeps  one vertex moved and the border is convex before and after
   - stays_delaunay    a continuous motion with a convex border all along: at its end certificates without the winding imply Delaunay
   - steps_wind, steps_delaunay   any number of steps of which each keeps the border and is of one of the two kinds above, or checks the winding *)
Require Import Reals Lra Psatz List.
From Annulus Require Import width_2 plane_mesh plane_crossings plane_delaunay plane_winding.
Import ListNotations.
Open Scope R_scope.

Definition straight (m m' : placement) (t : R) : placement := fun v => mix t (m v) (m' v).

Lemma straight_continuous m m' : continuous_motion (straight m m').
Proof.
  assert (K : forall a b, continuity (fun t => (1 - t) * a + t * b)) by (intros; apply derivable_continuous; reg).
  intro v. split; apply K.
Qed.

Lemma mix_0 x y : mix 0 x y = x.
Proof. destruct x. unfold mix. cbn. f_equal; ring. Qed.
Lemma mix_1 x y : mix 1 x y = y.
Proof. destruct y. unfold mix. cbn. f_equal; ring. Qed.
Lemma mix_same t x : mix t x x = x.
Proof. destruct x. unfold mix. cbn. f_equal; ring. Qed.

(* What makes a ridge convex are the places of its vertices. *)
Lemma convex_at_local m m' u v w : m u = m' u -> m v = m' v -> m w = m' w -> convex_at m u v w -> convex_at m' u v w.
Proof. intros U V W. unfold convex_at, turn_at. now rewrite U, V, W. Qed.

Lemma winds_once_local m m' l : (forall u v w, In (u, v, w) (ridges l) -> m u = m' u /\ m v = m' v /\ m w = m' w) -> winds_once m l -> winds_once m' l.
Proof.
  intros E. unfold winds_once. intro W. rewrite <- W. f_equal. apply filter_ext_in. intros [[u v] w] I.
  destruct (E u v w I) as (U & V & X). unfold enters. now rewrite U, V, X.
Qed.

Lemma straight_keeps m m' l : (forall t, 0 <= t <= 1 -> convex (straight m m' t) l) -> winds_once m l -> winds_once m' l.
Proof.
  intros C W. apply (winds_once_local (straight m m' 1)); [intros; unfold straight; now rewrite !mix_1|].
  apply winding_kept; [apply straight_continuous|exact C|].
  apply (winds_once_local m); [intros; unfold straight; now rewrite !mix_0|exact W].
Qed.

(* ---- Tolerances ---- *)

(* Every placement with each vertex of the ridge closer to x than the square root of s, or at x, has it convex, and both placements are such. *)
Definition certified_ridge (m m' : placement) (u v w : nat) : Prop := exists (x : placement) (s : nat -> R),
  let near n := forall z, In z [u; v; w] -> dist2 (n z) (x z) < s z \/ n z = x z in
  (forall n, near n -> convex_at n u v w) /\ near m /\ near m'.
Definition resting_ridge (m m' : placement) (u v w : nat) : Prop := convex_at m u v w /\ m u = m' u /\ m v = m' v /\ m w = m' w.

Lemma ball_convex t p q x r : 0 <= t <= 1 -> dist2 p x < r -> dist2 q x < r -> dist2 (mix t p q) x < r.
Proof.
  intros [T0 T1] P Q. assert (E : dist2 (mix t p q) x = (1 - t) * dist2 p x + t * dist2 q x - t * (1 - t) * dist2 p q)
    by (unfold dist2, d2, mix; cbn [fst snd]; ring).
  assert (0 <= t * (1 - t) * dist2 p q) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|apply d2_nonneg]).
  rewrite E. destruct (Rle_dec (dist2 p x) (dist2 q x)); nra.
Qed.

Lemma ball_or_centre t p q x r : 0 <= t <= 1 -> dist2 p x < r \/ p = x -> dist2 q x < r \/ q = x -> dist2 (mix t p q) x < r \/ mix t p q = x.
Proof.
  intros T P Q. assert (Z : dist2 x x = 0) by (unfold dist2, d2; ring). assert (N : forall y, dist2 y x < r -> dist2 x x < r).
  { intros y Y. rewrite Z. apply Rle_lt_trans with (2 := Y), d2_nonneg. }
  destruct P as [P| ->], Q as [Q| ->]; [left; now apply ball_convex|left; apply ball_convex; eauto|left; apply ball_convex; eauto|right; apply mix_same].
Qed.

Theorem certified_keep m m' l : (forall u v w, In (u, v, w) (ridges l) -> certified_ridge m m' u v w \/ resting_ridge m m' u v w) ->
  winds_once m l -> winds_once m' l.
Proof.
  intro K. apply straight_keeps. intros t T u v w I. destruct (K u v w I) as [(x & s & H & N & N')|(C & U & V & W)].
  - apply H. intros z Z. apply ball_or_centre; [exact T|now apply N|now apply N'].
  - apply (convex_at_local m); trivial; unfold straight; [rewrite U|rewrite V|rewrite W]; now rewrite mix_same.
Qed.

(* ---- One vertex ---- *)

Lemma convex_at_mix m m' n t u v w : 0 <= t <= 1 -> convex_at m u v w -> convex_at m' u v w ->
  turn_at n u v w = (1 - t) * turn_at m u v w + t * turn_at m' u v w ->
  (1 - t) * dot (vector (m u) (m v)) (vector (m v) (m w)) + t * dot (vector (m' u) (m' v)) (vector (m' v) (m' w))
    <= dot (vector (n u) (n v)) (vector (n v) (n w)) -> convex_at n u v w.
Proof.
  intros T. unfold convex_at. generalize (turn_at m u v w) (turn_at m' u v w) (turn_at n u v w)
    (dot (vector (m u) (m v)) (vector (m v) (m w))) (dot (vector (m' u) (m' v)) (vector (m' v) (m' w))) (dot (vector (n u) (n v)) (vector (n v) (n w))).
  intros a a' k d d' e A A' K L. assert (P : 0 <= a) by lra. assert (P' : 0 <= a') by lra.
  assert (Q : 0 <= (1 - t) * a) by (apply Rmult_le_pos; lra). assert (Q' : 0 <= t * a') by (apply Rmult_le_pos; lra).
  destruct (Rlt_dec 0 k) as [N|N]; [now left|]. right. split; [lra|].
  assert (Z : (1 - t) * a = 0) by lra. assert (Z' : t * a' = 0) by lra.
  apply Rmult_integral in Z. apply Rmult_integral in Z'. destruct Z as [Z|Z], Z' as [Z'|Z'].
  - lra.
  - replace t with 1 in L by lra. lra.
  - subst t. lra.
  - assert (0 < d) by lra. assert (0 < d') by lra. nra.
Qed.

Lemma ridge_distinct m u v w : convex_at m u v w -> u <> v /\ v <> w /\ u <> w.
Proof.
  intro C. destruct (convex_vectors m u v w C) as (N & N' & _). repeat split; intros ->; try tauto.
  unfold convex_at, turn_at, turning, turn, dot, vector in C. cbn [fst snd] in C.
  generalize (Rle_0_sqr (fst (m w) - fst (m v))) (Rle_0_sqr (snd (m w) - snd (m v))). unfold Rsqr. lra.
Qed.

Theorem one_vertex_keeps m m' z l : (forall v, v <> z -> m v = m' v) -> convex m l -> convex m' l -> winds_once m l -> winds_once m' l.
Proof.
  intros Same C C'. apply straight_keeps. intros t T u v w I. assert (K := C u v w I). assert (K' := C' u v w I).
  destruct (ridge_distinct m u v w K) as (Nuv & Nvw & Nuw). apply (convex_at_mix m m' _ t); trivial.
  - destruct (Nat.eq_dec u z) as [->|Nu]; [|destruct (Nat.eq_dec v z) as [->|Nv]].
    + unfold straight, turn_at. rewrite (Same v), (Same w), !mix_same by congruence. unfold turning, turn, mix. cbn [fst snd]. ring.
    + unfold straight, turn_at. rewrite (Same u), (Same w), !mix_same by congruence. unfold turning, turn, mix. cbn [fst snd]. ring.
    + unfold straight, turn_at. rewrite (Same u), (Same v), !mix_same by congruence. unfold turning, turn, mix. cbn [fst snd]. ring.
  - destruct (Nat.eq_dec v z) as [->|Nv].
    + unfold straight. rewrite (Same u), (Same w), !mix_same by congruence. apply Rminus_le, Ropp_le_cancel. rewrite Ropp_0.
      match goal with |- 0 <= ?e => replace e with (t * (1 - t) * dist2 (m z) (m' z)) by (unfold dist2, d2, dot, vector, mix; cbn [fst snd]; ring) end.
      apply Rmult_le_pos; [apply Rmult_le_pos; lra|apply d2_nonneg].
    + apply Req_le. destruct (Nat.eq_dec u z) as [->|Nu].
      * unfold straight. rewrite (Same v), (Same w), !mix_same by congruence. unfold dot, vector, mix. cbn [fst snd]. ring.
      * unfold straight. rewrite (Same u), (Same v), !mix_same by congruence. unfold dot, vector, mix. cbn [fst snd]. ring.
Qed.

(* ---- Delaunay after a motion ---- *)

Theorem stays_delaunay (m : R -> placement) T0 T1 : continuous_motion m -> border T1 = border T0 ->
  (forall t, 0 <= t <= 1 -> convex (m t) (border T0)) -> winds_once (m 0) (border T0) ->
  glued T1 -> positive (m 1) T1 -> locally_delaunay (m 1) T1 -> delaunay (m 1) T1.
Proof.
  intros M B C W G P L. apply plane_delaunay; trivial; rewrite B; [apply C; lra|]. now apply winding_kept.
Qed.

(* The border after a step: checked, or the same as before and one of the two cases in which the winding need not be looked at. *)
Definition border_known (m m' : placement) (T T' : mesh) : Prop :=
  winds_once m' (border T') \/
  (border T' = border T /\ ((exists z, forall v, v <> z -> m v = m' v) \/
    forall u v w, In (u, v, w) (ridges (border T)) -> certified_ridge m m' u v w \/ resting_ridge m m' u v w)).

Lemma known_winds m m' T T' : border_known m m' T T' -> winds_once m (border T) -> convex m (border T) -> convex m' (border T') -> winds_once m' (border T').
Proof.
  intros [N|(B & [(z & N)|N])] W C C'; [exact N| |]; rewrite B in *; [now apply (one_vertex_keeps m _ z)|now apply (certified_keep m)].
Qed.

Theorem steps_wind (m : nat -> placement) (T : nat -> mesh) : winds_once (m O) (border (T O)) -> (forall i, convex (m i) (border (T i))) ->
  (forall i, border_known (m i) (m (S i)) (T i) (T (S i))) -> forall i, winds_once (m i) (border (T i)).
Proof.
  intros W C K. induction i as [|i IH]; [exact W|]. now apply (known_winds _ _ _ _ (K i)).
Qed.

Theorem steps_delaunay (m : nat -> placement) (T : nat -> mesh) : winds_once (m O) (border (T O)) ->
  (forall i, glued (T i) /\ positive (m i) (T i) /\ convex (m i) (border (T i)) /\ locally_delaunay (m i) (T i)) ->
  (forall i, border_known (m i) (m (S i)) (T i) (T (S i))) -> forall i, delaunay (m i) (T i).
Proof.
  intros W H K i. assert (All := steps_wind m T W (fun i => proj1 (proj2 (proj2 (H i)))) K).
  destruct (H i) as (G & P & C & L). now apply plane_delaunay.
Qed.
