(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 3 of docs/theory.md 1.2, from the signs of the code (mesh/border_3.cpp). What is seen from (e^2, e, 1), e as small as need be, is decided without e.

   - border_known_3     a border that falls into sheets that face to the one side and to the other, with convex ridges and one silhouette that turns
                        left and winds once, has no vertex beyond a facet; and some point is in one cell only
   - silhouette_triangulation, silhouette_delaunay   so with positive cells, glued along their facets, it is a triangulation; with empty spheres Delaunay
   - silhouette_rests   it need not be looked at again while the vertices of the border rest
   - flat_ridge_3       the rule of the code for a ridge whose determinant is 0: its facets lie on different sides of it

   That the silhouette's edges are one closed path, and none of its vertices has two that go out, is in `rim`: a list of vertices. *)
Require Import Reals Lra Psatz List Permutation.
From Annulus Require Import vectors small general_position space_line space_mesh space_crossings.
From Annulus Require plane_mesh.
From Annulus Require Import space_delaunay space_triangulation.
From Annulus Require Import width_2 points_2 space_sheets space_border.
Import ListNotations.
Open Scope R_scope.

(* The first component of z, y, x that is not 0 is positive. *)
Definition faces_viewer (n : vec) : Prop := 0 < X3 n \/ (X3 n = 0 /\ (0 < X2 n \/ (X2 n = 0 /\ 0 < X1 n))).
Definition normal_of (m : placement_3) a b c : vec := (m b ⊖ m a) ✕ (m c ⊖ m a).
(* Left, or straight on: no fold. *)
Definition turns_left (m : placement_3) u v w : Prop :=
  faces_viewer (normal_of m u v w) \/ (normal_of m u v w = zero /\ 0 < (m v ⊖ m u) · (m w ⊖ m v)).
(* The first of y, -z, x that differs grows. *)
Definition points_up_3 (x y : vec) : bool :=
  if Rlt_dec (X2 x) (X2 y) then true else if Req_EM_T (X2 x) (X2 y) then
    if Rlt_dec (X3 y) (X3 x) then true else if Req_EM_T (X3 x) (X3 y) then if Rlt_dec (X1 x) (X1 y) then true else false else false
  else false.
Definition enters_3 (m : placement_3) (r : nat * nat * nat) : bool :=
  let '(u, v, w) := r in negb (points_up_3 (m u) (m v)) && points_up_3 (m v) (m w).

(* The upper sheet turns left as seen from outside, the lower one as seen from inside: both face the viewer like this. *)
Record silhouette_once (m : placement_3) (T : mesh_3) (U L : plane_mesh.mesh) : Prop := {
  glued_upper : plane_mesh.glued U;
  glued_lower : plane_mesh.glued L;
  rim : plane_mesh.border U = plane_mesh.border L;
  all_facets : Permutation (map facet_of (outer T)) (map turned_over (plane_mesh.cells U) ++ plane_mesh.cells L);
  facing : forall a b c, In (a, b, c) (plane_mesh.cells U ++ plane_mesh.cells L) -> faces_viewer (normal_of m a b c);
  rim_turns : forall u v w, In (u, v, w) (plane_mesh.ridges (plane_mesh.border U)) -> turns_left m u v w;
  rim_once : length (filter (enters_3 m) (plane_mesh.ridges (plane_mesh.border U))) = 1%nat }.
Definition ridges_convex (m : placement_3) (U L : plane_mesh.mesh) : Prop :=
  (forall a b x y, In (a, b, x, y) (plane_mesh.bicells U) -> orient (m a) (m b) (m y) (m x) <= 0) /\
  (forall a b x y, In (a, b, x, y) (plane_mesh.bicells L) -> 0 <= orient (m a) (m b) (m y) (m x)).

(* degenerate.h tells a flat ridge, d along it, from a fold like this: seen along the first axis along which one facet has an area, the other has one of the opposite sign. *)
Definition opposite_first (n l : vec) : Prop := X1 n * X1 l < 0 \/ (X1 n = 0 /\ (X2 n * X2 l < 0 \/ (X2 n = 0 /\ X3 n * X3 l < 0))).

Theorem flat_ridge_3 d e f : vol d e f = 0 -> ((d ✕ e) · (d ✕ f) < 0 <-> opposite_first (d ✕ e) (d ✕ f)).
Proof.
  intro Z. assert (C : (d ✕ e) ✕ (d ✕ f) = zero) by (replace ((d ✕ e) ✕ (d ✕ f)) with (vol d e f ⊙ d) by vector; rewrite Z; vector).
  revert C. generalize (d ✕ e) (d ✕ f). clear. intros n l C.
  assert (P : sq n ⊙ l = (n · l) ⊙ n) by (replace (sq n ⊙ l) with ((n · l) ⊙ n ⊖ (n ✕ (n ✕ l))) by vector; rewrite C; vector).
  assert (K : forall x y, (n = zero -> x = 0) -> sq n * y = (n · l) * x -> (x * y < 0 <-> n · l < 0 /\ x <> 0)).
  { intros x y Zx E. assert (Q : sq n * (x * y) = (n · l) * (x * x)) by (rewrite <- (Rmult_assoc _ x x), <- E; ring).
    assert (Two : x <> 0 -> 0 < sq n /\ 0 < x * x) by (intro N; split; [apply sq_pos; tauto|now apply Rsqr_pos_lt]).
    split; [intro H|intros [H N]].
    - assert (N : x <> 0) by (intros ->; lra). split; [|exact N]. destruct (Two N) as [S X]. apply Rnot_le_lt. intro L.
      generalize (Rmult_le_pos _ _ L (Rlt_le _ _ X)) (Rmult_lt_0_compat (sq n) (- (x * y)) S ltac:(lra)). lra.
    - destruct (Two N) as [S X]. apply Rnot_le_lt. intro L.
      generalize (Rmult_le_pos _ _ (Rlt_le _ _ S) L) (Rmult_lt_0_compat (- (n · l)) (x * x) ltac:(lra) X). lra. }
  assert (K1 := K (X1 n) (X1 l) (fun E => f_equal X1 E) (f_equal X1 P)). assert (K2 := K (X2 n) (X2 l) (fun E => f_equal X2 E) (f_equal X2 P)).
  assert (K3 := K (X3 n) (X3 l) (fun E => f_equal X3 E) (f_equal X3 P)).
  unfold opposite_first. rewrite K1, K2, K3. split; [intro H|intuition].
  destruct (Req_EM_T (X1 n) 0) as [Z1|N1]; [right; split; [exact Z1|]|now left].
  destruct (Req_EM_T (X2 n) 0) as [Z2|N2]; [right; split; [exact Z2|]|now left].
  split; [exact H|]. intro Z3. unfold dot in H. rewrite Z1, Z2, Z3 in H. lra.
Qed.

(* ---- For small e ---- *)

Lemma small_first a b c : 0 < a \/ (a = 0 /\ (0 < b \/ (b = 0 /\ 0 < c))) -> small (fun e => 0 < a + e * b + e * e * c).
Proof.
  intro H. destruct H as [H|[-> [H|[-> H]]]].
  - apply (small_impl (fun e => 0 < polynomial [a; b; c] e)); [intros e _; simpl; lra|]. now apply polynomial_positive.
  - apply (small_impl (fun e => 0 < polynomial [b; c] e)); [|now apply polynomial_positive].
    intros e E P. simpl in P. replace (0 + e * b + e * e * c) with (e * (b + e * (c + e * 0))) by ring. now apply Rmult_lt_0_compat.
  - exists 1. split; [lra|]. intros e E. replace (0 + e * 0 + e * e * c) with (e * e * c) by ring. repeat apply Rmult_lt_0_compat; lra.
Qed.

(* Every comparison of numbers whose order is known. *)
Ltac decide_order := repeat ((destruct (Rlt_dec _ _) || destruct (Req_EM_T _ _)); trivial; try (exfalso; lra)).

Section seen.
Variable m : placement_3.
Notation image e := (image (e * e) e m).

Lemma turn_seen e a b c : turn_at (image e) a b c = X3 (normal_of m a b c) + e * X2 (normal_of m a b c) + e * e * X1 (normal_of m a b c).
Proof.
  unfold turn_at, turning, turn, space_sheets.image, seen, normal_of. cbn [fst snd]. generalize (m a) (m b) (m c). intros [? ? ?] [? ? ?] [? ? ?]. coordinates. ring.
Qed.

Lemma facing_seen a b c : faces_viewer (normal_of m a b c) -> small (fun e => 0 < turn_at (image e) a b c).
Proof. intro H. apply (small_impl _ _) with (2 := small_first _ _ _ H). intros e _. now rewrite turn_seen. Qed.

(* No vector is seen as a point for long. *)
Lemma vector_seen d : d <> zero -> small (fun e => X1 d - e * e * X3 d <> 0 \/ X2 d - e * X3 d <> 0).
Proof.
  intro N. destruct (Req_EM_T (X2 d) 0) as [Z2|N2]; [destruct (Req_EM_T (X3 d) 0) as [Z3|N3]|].
  - assert (N1 : X1 d <> 0) by (intro Z1; apply N; now apply vec_eq). exists 1. split; [lra|]. intros e _. left. rewrite Z3. lra.
  - exists 1. split; [lra|]. intros e E. right. rewrite Z2. intro H. assert (K : e * X3 d = 0) by lra. apply Rmult_integral in K. lra.
  - apply (small_impl (fun e => polynomial [X2 d; - X3 d] e <> 0)).
    + intros e _ H. right. intro K. apply H. simpl. lra.
    + apply polynomial_nonzero. exists (X2 d). split; [now left|exact N2].
Qed.

Lemma points_up_seen u v : small (fun e => plane_mesh.points_up (image e u) (image e v) = points_up_3 (m u) (m v)).
Proof.
  unfold plane_mesh.points_up, points_up_3, space_sheets.image, seen. cbn [fst snd]. generalize (m u) (m v). intros x y.
  destruct (Rtotal_order (X2 x) (X2 y)) as [H|[H|H]].
  - apply (small_impl (fun e => 0 < polynomial [X2 y - X2 x; X3 x - X3 y] e)); [|apply polynomial_positive; lra].
    intros e _ P. simpl in P. decide_order.
  - exists 1. split; [lra|]. intros e E. assert (P : forall r, (0 < r -> 0 < e * r) /\ (r < 0 -> e * r < 0)) by (intro r; split; intro; nra).
    generalize (P (X3 y - X3 x)). intro Q. destruct (Rtotal_order (X3 x) (X3 y)) as [K|[K|K]].
    + decide_order.
    + rewrite <- K. decide_order.
    + decide_order.
  - apply (small_impl (fun e => 0 < polynomial [X2 x - X2 y; X3 y - X3 x] e)); [|apply polynomial_positive; lra].
    intros e _ P. simpl in P. decide_order.
Qed.

Lemma turns_seen u v w : turns_left m u v w -> small (fun e => plane_mesh.convex_at (image e) u v w).
Proof.
  intros [H|[Z D]].
  - apply (small_impl _ _) with (2 := facing_seen u v w H). intros e _ P. now left.
  - set (d := m v ⊖ m u) in *. set (f := m w ⊖ m v) in *. assert (N : d <> zero) by (intro E; rewrite E in D; unfold dot in D; simpl in D; lra).
    assert (C : d ✕ f = zero) by (rewrite <- Z; unfold d, f, normal_of; generalize (m u) (m v) (m w); vector).
    assert (S := sq_pos d N). assert (P : f = ((d · f) / sq d) ⊙ d).
    { assert (K : sq d ⊙ f = (d · f) ⊙ d) by (replace (sq d ⊙ f) with ((d · f) ⊙ d ⊖ (d ✕ (d ✕ f))) by vector; rewrite C; vector).
      replace f with (/ sq d ⊙ (sq d ⊙ f)) at 1 by (apply vec_eq; cbn [scale X1 X2 X3]; field; lra).
      rewrite K. apply vec_eq; cbn [scale X1 X2 X3]; field; lra. }
    assert (Q : 0 < (d · f) / sq d) by now apply Rdiv_lt_0_compat. revert P Q. generalize ((d · f) / sq d). intros k P Q.
    apply (small_impl _ _) with (2 := vector_seen d N). intros e _ H. right. split.
    + rewrite turn_seen, Z. simpl. ring.
    + replace (plane_mesh.dot _ _) with ((X1 d - e * e * X3 d) * (X1 f - e * e * X3 f) + (X2 d - e * X3 d) * (X2 f - e * X3 f))
        by (unfold plane_mesh.dot, plane_mesh.vector, space_sheets.image, seen, d, f, sub; cbn [fst snd X1 X2 X3]; ring).
      rewrite P. cbn [scale X1 X2 X3].
      replace (_ + _) with (k * ((X1 d - e * e * X3 d) * (X1 d - e * e * X3 d) + (X2 d - e * X3 d) * (X2 d - e * X3 d))) by ring.
      apply Rmult_lt_0_compat; [exact Q|]. generalize (Rle_0_sqr (X1 d - e * e * X3 d)) (Rle_0_sqr (X2 d - e * X3 d)).
      destruct H as [H|H]; apply Rsqr_pos_lt in H; unfold Rsqr in *; lra.
Qed.

(* Corners of a cell are in different places. *)
Lemma corners_apart t i j : 0 < size m t -> i <> j -> m (point_of t i) ⊖ m (point_of t j) <> zero.
Proof.
  intros S N E. assert (P : m (point_of t i) = m (point_of t j)).
  { apply vec_eq; [generalize (f_equal X1 E)|generalize (f_equal X2 E)|generalize (f_equal X3 E)]; simpl; lra. }
  generalize (bary_corner m t i i) (bary_corner m t i j). rewrite P. destruct (corner_dec i i) as [_|D]; [|now elim D].
  destruct (corner_dec i j); [contradiction|]. lra.
Qed.
End seen.

Section placed.
Variables (T : mesh_3) (m : placement_3) (U L : plane_mesh.mesh).
Hypothesis gluing : glued_3 T.
Hypothesis cells_positive : positive_3 m T.
Hypothesis once : silhouette_once m T U L.
Hypothesis ridges : ridges_convex m U L.

Lemma seen_soon : small (fun e => seen_border (e * e) e m T U L).
Proof.
  destruct once as [Gu Gl B Fa Vi Tu En], ridges as [Ru Rl].
  assert (S1 : small (fun e => forall t, In t (plane_mesh.cells U ++ plane_mesh.cells L) -> let '(a, b, c) := t in 0 < turn_at (image (e * e) e m) a b c)).
  { apply small_all. intros [[a b] c] I. now apply facing_seen, Vi. }
  assert (S2 : small (fun e => forall r, In r (plane_mesh.ridges (plane_mesh.border U)) -> let '(u, v, w) := r in
    plane_mesh.convex_at (image (e * e) e m) u v w /\ plane_mesh.enters (image (e * e) e m) r = enters_3 m r)).
  { apply small_all. intros [[u v] w] I. apply small_and; [now apply turns_seen, Tu|].
    apply (small_impl _ _) with (2 := small_and _ _ (points_up_seen m u v) (points_up_seen m v w)). intros e _ [E F]. unfold plane_mesh.enters, enters_3. now rewrite E, F. }
  assert (S3 : small (fun e => forall t, In t (cells T) -> forall i, In i corner_list -> forall j, In j corner_list -> i <> j ->
    image (e * e) e m (point_of t i) <> image (e * e) e m (point_of t j))).
  { apply small_all. intros t It. apply small_all. intros i _. apply small_all. intros j _. destruct (corner_dec i j) as [->|N]; [exists 1; split; [lra|tauto]|].
    apply (small_impl _ _) with (2 := vector_seen _ (corners_apart m t i j (size_pos T m cells_positive t It) N)). intros e _ H _ E.
    unfold image, seen in E. injection E as E1 E2. cbn [sub X1 X2 X3] in H. lra. }
  apply (small_impl _ _) with (2 := small_and _ _ S1 (small_and _ _ S2 S3)). intros e _ (P & Q & R).
  assert (C : plane_mesh.convex (image (e * e) e m) (plane_mesh.border U)) by (intros u v w I; apply (Q _ I)).
  assert (W : plane_mesh.winds_once (image (e * e) e m) (plane_mesh.border U)).
  { unfold plane_mesh.winds_once. rewrite (filter_ext_in _ (enters_3 m)); [exact En|]. intros [[u v] w] I. apply (Q _ I). }
  split; trivial.
  - split; trivial.
    + intros a b c I. apply (P (a, b, c)). apply in_or_app. now left.
    + intros a b x y I. generalize (Ru a b x y I). lra.
  - split; rewrite <- ?B; trivial.
    + intros a b c I. apply (P (a, b, c)). apply in_or_app. now right.
    + intros a b x y I. generalize (Rl a b x y I). lra.
  - intros t i j It N. apply R; trivial; apply in_corners.
Qed.

Lemma border_known_3 : (forall s n, In s (outer T) -> is_vertex T n -> 0 <= facet_height m s (m n)) /\
  exists x t rest, Permutation (cells T) (t :: rest) /\ inside_3 m x t /\ forall r, In r rest -> ~ in_cell_3 m x r.
Proof.
  destruct (small_exists _ seen_soon) as (e & _ & B). exact (border_once_3 (e * e) e m T U L gluing cells_positive B).
Qed.

Theorem silhouette_triangulation : triangulation_3 m T.
Proof. destruct border_known_3. now apply space_triangulation. Qed.
Theorem silhouette_delaunay : locally_delaunay_3 m T -> delaunay_3 m T.
Proof. destruct border_known_3. now apply space_delaunay. Qed.
End placed.

(* ---- When it need not be looked at again ---- *)

Lemma bends_in u v w l : In (u, v, w) (plane_mesh.bends l) -> In u l /\ In v l /\ In w l.
Proof.
  induction l as [|a [|b [|c l]] IH]; [easy|easy|easy|]. intros [E|I]; [injection E as <- <- <-; simpl; tauto|].
  destruct (IH I) as (A & B & C). split; [|split]; now right.
Qed.

Theorem silhouette_rests m m' T U L : (forall v, plane_mesh.vertex_of U v \/ plane_mesh.vertex_of L v -> m v = m' v) ->
  silhouette_once m T U L -> silhouette_once m' T U L.
Proof.
  intros Same [Gu Gl B Fa Vi Tu En].
  assert (R : forall u v w, In (u, v, w) (plane_mesh.ridges (plane_mesh.border U)) -> m u = m' u /\ m v = m' v /\ m w = m' w).
  { intros u v w I. assert (K : forall x, In x (plane_mesh.border U ++ firstn 2 (plane_mesh.border U)) -> m x = m' x).
    { intros x J. apply Same. left. apply border_vertex; [exact Gu|]. apply in_app_iff in J. destruct J as [J|J]; [exact J|].
      rewrite <- (firstn_skipn 2 (plane_mesh.border U)). apply in_or_app. now left. }
    apply bends_in in I. destruct I as (Iu & Iv & Iw). split; [|split]; now apply K. }
  split; trivial.
  - intros a b c I. assert (K : m a = m' a /\ m b = m' b /\ m c = m' c).
    { apply in_app_iff in I. split; [|split]; apply Same; (destruct I as [I|I]; [left|right]; exists (a, b, c); (split; [exact I|simpl; tauto])). }
    destruct K as (A & B' & C). unfold normal_of. rewrite <- A, <- B', <- C. now apply Vi.
  - intros u v w I. destruct (R u v w I) as (A & B' & C). unfold turns_left, normal_of. rewrite <- A, <- B', <- C. now apply Tu.
  - rewrite <- En. f_equal. apply filter_ext_in. intros [[u v] w] I. destruct (R u v w I) as (A & B' & C). unfold enters_3. now rewrite <- A, <- B', <- C.
Qed.
