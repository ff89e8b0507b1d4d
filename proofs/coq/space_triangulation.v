(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Cells of space that meet, under the hypotheses of space_embedding.v: docs/theory.md 1.2, the end of lemma 1.

   - same_weights_3        two cells that contain a point give it the same corners with the same weights
   - space_triangulation   the cells triangulate the convex hull of the vertices: they cover it once and meet in the hull of common corners, and no two
                           vertices have one place *)
Require Import Reals Lra Psatz List Permutation Arith.
From Annulus Require Import tetrahedron sums small general_position space_line space_mesh space_crossings space_embedding space_delaunay.
Import ListNotations.
Open Scope R_scope.

(* ---- Convex hulls ---- *)

Definition convex_set_3 (C : vec -> Prop) : Prop := forall e x y, 0 <= e <= 1 -> C x -> C y -> C ((1 - e) ⊙ x ⊕ e ⊙ y).
Definition in_hull_3 (m : placement_3) (vertex : nat -> Prop) (x : vec) : Prop :=
  forall C, convex_set_3 C -> (forall v, vertex v -> C (m v)) -> C x.

Record triangulation_3 (m : placement_3) (T : mesh_3) : Prop := {
  disjoint_cells : forall t rest r x, Permutation (cells T) (t :: rest) -> In r rest -> inside_3 m x t -> ~ in_cell_3 m x r;
  covering_cells : forall x, in_hull_3 m (is_vertex T) x <-> exists t, In t (cells T) /\ in_cell_3 m x t;
  common_corners : forall t r x, In t (cells T) -> In r (cells T) -> in_cell_3 m x t -> in_cell_3 m x r ->
    in_hull_3 m (fun v => is_corner v t /\ is_corner v r) x;
  distinct_places : forall v w, is_vertex T v -> is_vertex T w -> m v = m w -> v = w }.

(* A sum of points with weights k in all, or nothing yet. *)
Definition weighed (C : vec -> Prop) (k : R) (s : vec) : Prop := (k = 0 /\ s = zero) \/ (0 < k /\ C (/ k ⊙ s)).

Lemma weigh C k s h p : convex_set_3 C -> weighed C k s -> 0 <= h -> (0 < h -> C p) -> weighed C (k + h) (s ⊕ h ⊙ p).
Proof.
  intros S W H P. destruct H as [H|<-].
  - right. destruct W as [[-> ->]|[K W]].
    + split; [lra|]. replace (/ (0 + h) ⊙ (zero ⊕ h ⊙ p)) with p; [now apply P|]. destruct p. apply vec_eq; coordinates; field; lra.
    + split; [lra|]. replace (/ (k + h) ⊙ (s ⊕ h ⊙ p)) with ((1 - h / (k + h)) ⊙ (/ k ⊙ s) ⊕ (h / (k + h)) ⊙ p).
      * apply S; [|exact W|now apply P]. split; [apply Rlt_le, Rdiv_lt_0_compat; lra|]. apply (Rmult_le_reg_r (k + h)); [lra|]. field_simplify; lra.
      * destruct p, s. apply vec_eq; coordinates; field; lra.
  - rewrite Rplus_0_r. replace (s ⊕ 0 ⊙ p) with s; [exact W|]. destruct p, s. vector.
Qed.

Section one_cell.
Variables (m : placement_3) (t : four).
Hypothesis cell_positive : 0 < size m t.

Lemma weights_sum x : size m t ⊙ x = bary m t x o ⊙ m (point_of t o) ⊕ bary m t x u ⊙ m (point_of t u) ⊕ bary m t x v ⊙ m (point_of t v)
  ⊕ bary m t x w ⊙ m (point_of t w).
Proof.
  assert (A : affine X1 /\ affine X2 /\ affine X3) by (repeat split; [exists (V 1 0 0), 0|exists (V 0 1 0), 0|exists (V 0 0 1), 0]; vector).
  destruct A as (A1 & A2 & A3).
  apply vec_eq; cbn [add scale X1 X2 X3]; [now apply (affine_bary m X1)|now apply (affine_bary m X2)|now apply (affine_bary m X3)].
Qed.

(* A point of a cell is in every convex set that has those corners whose weight is not 0. *)
Lemma weighted_corners_3 (C : vec -> Prop) x : convex_set_3 C -> (forall i, 0 <= bary m t x i) ->
  (forall i, 0 < bary m t x i -> C (m (point_of t i))) -> C x.
Proof.
  intros S N P. assert (W : weighed C 0 zero) by now left.
  assert (W4 := weigh C _ _ _ _ S (weigh C _ _ _ _ S (weigh C _ _ _ _ S (weigh C _ _ _ _ S W (N o) (P o)) (N u) (P u)) (N v) (P v)) (N w) (P w)).
  rewrite Rplus_0_l, bary_total in W4. replace (zero ⊕ _) with (bary m t x o ⊙ m (point_of t o)) in W4 by (generalize (m (point_of t o)); vector).
  rewrite <- weights_sum in W4. destruct W4 as [[Z _]|[_ H]]; [lra|]. replace (/ size m t ⊙ (size m t ⊙ x)) with x in H; [exact H|].
  destruct x. apply vec_eq; coordinates; field; lra.
Qed.

Definition at_vertex_3 (z n : nat) : R := if Nat.eq_dec n z then 1 else 0.

Lemma weight_of_corner x i : (forall j, 0 <= bary m t x j) -> 0 < bary m t x i -> 0 < plane_3 m (at_vertex_3 (point_of t i)) t x.
Proof.
  intros N P. unfold plane_3. apply Rdiv_lt_0_compat; [|exact cell_positive].
  assert (H : forall j, 0 <= bary m t x j * at_vertex_3 (point_of t i) (point_of t j)).
  { intro j. apply Rmult_le_pos; [apply N|]. unfold at_vertex_3. destruct (Nat.eq_dec _ _); lra. }
  assert (Q : 0 < bary m t x i * at_vertex_3 (point_of t i) (point_of t i)).
  { unfold at_vertex_3. destruct (Nat.eq_dec _ _) as [_|D]; [lra|now elim D]. }
  generalize (H o) (H u) (H v) (H w). destruct i; lra.
Qed.

Lemma corner_of_weight n x : 0 < plane_3 m (at_vertex_3 n) t x -> is_corner n t.
Proof.
  clear cell_positive. intro H. destruct (Nat.eq_dec (point_of t o) n) as [E|E0]; [|destruct (Nat.eq_dec (point_of t u) n) as [E|E1];
    [|destruct (Nat.eq_dec (point_of t v) n) as [E|E2]; [|destruct (Nat.eq_dec (point_of t w) n) as [E|E3]]]];
    try (destruct t as [[[a b] c] d]; simpl in *; now subst; tauto).
  exfalso. revert H. apply Rle_not_lt, Req_le. unfold plane_3, at_vertex_3.
  destruct (Nat.eq_dec (point_of t o) n); [contradiction|]. destruct (Nat.eq_dec (point_of t u) n); [contradiction|].
  destruct (Nat.eq_dec (point_of t v) n); [contradiction|]. destruct (Nat.eq_dec (point_of t w) n); [contradiction|]. unfold Rdiv. ring.
Qed.
End one_cell.

(* ---- Two cells ---- *)

Section placed.
Variables (T : mesh_3) (m : placement_3).
Hypothesis gluing : glued_3 T.
Hypothesis cells_positive : positive_3 m T.
Hypothesis border_convex : forall s n, In s (outer T) -> is_vertex T n -> 0 <= facet_height m s (m n).
Hypothesis once : exists x t rest, Permutation (cells T) (t :: rest) /\ inside_3 m x t /\ forall r, In r rest -> ~ in_cell_3 m x r.

Lemma near_value f z g d : affine f -> 0 < d -> small (fun e => Rabs (f (curve z g e) - f z) < d).
Proof.
  intros A D. assert (One : affine (fun _ => 1)) by (exists zero, 1; vector).
  apply (small_impl (fun e => 0 < 1 * f (curve z g e) + (d - f z) * 1 /\ 0 < -1 * f (curve z g e) + (d + f z) * 1)).
  - intros e _ [L U]. apply Rabs_def1; lra.
  - apply small_and; (apply (near_positive (fun x => _ * f x + _ * 1)); [now apply affine_sum|left; lra]).
Qed.

(* How much steeper one cell is than the other. *)
Definition steeper f a b c p q : R := (f q - plane_3 m f (b, a, c, p) (m q)) / size m (a, b, c, q).

(* A step across a facet that is taken close to it. *)
Lemma step_size x y s d : Rabs (facet_height m s y - facet_height m s x) <= d -> Rabs (step_3 m x y s * facet_height m s y) <= d.
Proof.
  intro D. assert (D0 := Rle_trans _ _ _ (Rabs_pos _) D). assert (U := Rle_trans _ _ _ (Rle_abs _) D). rewrite <- Rabs_Ropp in D.
  assert (L := Rle_trans _ _ _ (Rle_abs _) D). clear D. apply Rabs_le. destruct s as [[[a b] c] e]. cbn [step_3].
  destruct (one_side_cases (line m x y a b) (line m x y b c) (line m x y c a)) as [-> | ->]; [lra|].
  unfold half, pos. repeat match goal with |- context [Rlt_dec ?q ?p] => destruct (Rlt_dec q p) end; lra.
Qed.

Lemma planes_close f t r x y d : In t (cells T) -> In r (cells T) -> all_positive (bary m t x) -> all_positive (bary m r y) ->
  (forall k, In k (cells T) -> general_position m k x y) ->
  (forall a b c p q, In (a, b, c, p, q) (bicells T) -> Rabs (facet_height m (a, b, c, q) y - facet_height m (a, b, c, q) x) <= d) ->
  plane_3 m f r y - plane_3 m f t y <= d * sum (fun k => let '(a, b, c, p, q) := k in Rabs (steeper f a b c p q)) (bicells T).
Proof.
  intros It Ir X Y G D.
  assert (K := change_3 T m gluing cells_positive x y (fun s => plane_3 m f s y) G (inside_inner T m gluing cells_positive border_convex x t It X)
    (inside_inner T m gluing cells_positive border_convex y r Ir Y) (plane_same m f y)).
  rewrite (counted_once_3 T m gluing cells_positive border_convex once y r _ Ir Y),
    (counted_once_3 T m gluing cells_positive border_convex once x t _ It X) in K.
  rewrite K, <- sum_scale. apply sum_le. intros [[[[a b] c] p] q] I. destruct (size_bicell T m gluing cells_positive a b c p q I) as [P Q].
  assert (E := planes_apart m f a b c p q y P Q).
  replace (plane_3 m f (a, b, c, q) y - plane_3 m f (b, a, c, p) y) with (facet_height m (a, b, c, q) y * steeper f a b c p q).
  - rewrite <- Rmult_assoc. apply Rle_trans with (1 := Rle_abs _). rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|]. now apply step_size, (D a b c p q).
  - apply (Rmult_eq_reg_l (size m (a, b, c, q))); [|lra]. rewrite E. unfold steeper. field. lra.
Qed.

Lemma planes_not_above f z t r : In t (cells T) -> In r (cells T) -> in_cell_3 m z t -> in_cell_3 m z r -> plane_3 m f r z <= plane_3 m f t z.
Proof.
  intros It Ir Zt Zr. set (s := sum (fun k => let '(a, b, c, p, q) := k in Rabs (steeper f a b c p q)) (bicells T)).
  assert (S : 0 <= s) by (apply sum_nonneg; intros [[[[a b] c] p] q] _; apply Rabs_pos).
  apply Rnot_lt_le. intro N. set (d := (plane_3 m f r z - plane_3 m f t z) / (3 + 2 * s)).
  assert (D : 0 < d) by (apply Rdiv_lt_0_compat; lra).
  assert (H : forall g, small (fun e => forall k, In k (bicells T) ->
    let '(a, b, c, p, q) := k in Rabs (facet_height m (a, b, c, q) (curve z g e) - facet_height m (a, b, c, q) z) < d)).
  { intro g. apply small_all. intros [[[[a b] c] p] q] _. apply near_value; [apply height_affine|exact D]. }
  destruct (small_exists _ (small_and _ _ (small_and _ _ (near_centre T m cells_positive z t It Zt) (near_regular T m cells_positive z (centre_3 m t)))
    (H (centre_3 m t)))) as (e & _ & [X R] & Hx).
  set (x := curve z (centre_3 m t) e) in *. clearbody x.
  destruct (small_exists _ (small_and _ _ (small_and _ _ (near_centre T m cells_positive z r Ir Zr) (near_general T m cells_positive x z (centre_3 m r) R))
    (small_and _ _ (H (centre_3 m r)) (small_and _ _ (near_value _ z (centre_3 m r) d (plane_affine m f r) D)
      (near_value _ z (centre_3 m r) d (plane_affine m f t) D))))) as (e' & _ & [Y G] & Hy & Pr & Pt).
  set (y := curve z (centre_3 m r) e') in *. clearbody y.
  assert (C : plane_3 m f r y - plane_3 m f t y <= 2 * d * s).
  { apply (planes_close f t r x y); trivial. intros a b c p q I. generalize (Hx _ I) (Hy _ I). cbv beta iota. intros A B.
    apply Rabs_def2 in A. apply Rabs_def2 in B. apply Rabs_le. lra. }
  apply Rabs_def2 in Pr. apply Rabs_def2 in Pt.
  assert (E : d * (3 + 2 * s) = plane_3 m f r z - plane_3 m f t z) by (unfold d; field; lra). lra.
Qed.

Theorem same_weights_3 z t r : In t (cells T) -> In r (cells T) -> in_cell_3 m z t -> in_cell_3 m z r -> forall f, plane_3 m f t z = plane_3 m f r z.
Proof. intros It Ir Zt Zr f. apply Rle_antisym; now apply planes_not_above. Qed.

(* ---- The triangulation ---- *)

Lemma corner_index n t : is_corner n t -> exists i, n = point_of t i.
Proof. destruct t as [[[a b] c] d]. intros [->|[->|[->| ->]]]; [now exists o|now exists u|now exists v|now exists w]. Qed.
Lemma index_corner t i : is_corner (point_of t i) t.
Proof. destruct t as [[[a b] c] d], i; simpl; tauto. Qed.

Lemma corner_in_3 t i : In t (cells T) -> in_cell_3 m (m (point_of t i)) t.
Proof. intro I. apply in_bary. intro j. rewrite bary_corner. generalize (size_pos T m cells_positive t I). destruct (corner_dec j i); lra. Qed.

Theorem space_triangulation : triangulation_3 m T.
Proof.
  split.
  - intros t rest r x. now apply disjoint_3.
  - intro x. split.
    + intro H. apply (proj2 (cover_3 T m gluing cells_positive border_convex once x)). intros s S. apply (H (fun y => 0 <= facet_height m s y)).
      * intros e y z E Y Z. destruct (height_affine m s) as (n & k & A). rewrite A in *.
        replace (n · ((1 - e) ⊙ y ⊕ e ⊙ z) + k) with ((1 - e) * (n · y + k) + e * (n · z + k)) by (generalize n y z; vector).
        apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra.
      * intros v V. now apply border_convex.
    + intros (t & It & W) C S V. rewrite in_bary in W. apply (weighted_corners_3 m t (size_pos T m cells_positive t It) C x S W).
      intros i _. apply V. exists t. split; [exact It|apply index_corner].
  - intros t r x It Ir Ht Hr C S V. assert (W := Ht). rewrite in_bary in W. assert (P := size_pos T m cells_positive t It).
    apply (weighted_corners_3 m t P C x S W). intros i B. apply V. split; [apply index_corner|]. apply (corner_of_weight m r) with x.
    rewrite <- (same_weights_3 x t r It Ir Ht Hr). now apply weight_of_corner.
  - intros v w (r & Ir & Cv) (t & It & Cw) E. destruct (corner_index v r Cv) as (i & ->). destruct (corner_index w t Cw) as (j & ->).
    set (f := at_vertex_3 (point_of r i)).
    assert (A := plane_at_corner m f r i (size_pos T m cells_positive r Ir)). assert (B := plane_at_corner m f t j (size_pos T m cells_positive t It)).
    rewrite <- E in B. rewrite (same_weights_3 _ t r It Ir) in B; [|rewrite E; now apply corner_in_3|now apply corner_in_3].
    rewrite A in B. unfold f, at_vertex_3 in B. destruct (Nat.eq_dec (point_of r i) (point_of r i)) as [_|D]; [|now elim D].
    destruct (Nat.eq_dec (point_of t j) (point_of r i)) as [D|_]; [now symmetry|lra].
Qed.
End placed.
