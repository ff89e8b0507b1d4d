(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* From the certificates of space to Delaunay, under the hypotheses of space_embedding.v: docs/theory.md 1.2, the end of the proof.

   - regular_3              heights of vertices that are convex across each bi-cell are convex: no vertex is below a cell
   - space_delaunay         empty spheres of all bi-cells, ties included: then no vertex is strictly inside any sphere
   - space_delaunay_strict  with strict certificates all others are strictly outside *)
Require Import Reals Lra Psatz List Permutation Arith.
From Annulus Require bicell.
From Annulus Require Import tetrahedron sums small general_position space_line space_mesh space_crossings space_embedding.
Import ListNotations.
Open Scope R_scope.

(* The certificate of a bi-cell as the code computes it: bicell.v. *)
Definition insphere_at (m : placement_3) a b c p q : R := bicell.det (fun k =>
  match k with bicell.a => m a | bicell.b => m b | bicell.c => m c | bicell.p => m p | bicell.q => m q end).

Definition locally_delaunay_3 (m : placement_3) (T : mesh_3) : Prop :=
  forall a b c p q, In (a, b, c, p, q) (bicells T) -> 0 <= insphere_at m a b c p q.

Definition delaunay_3 (m : placement_3) (T : mesh_3) : Prop := forall t, In t (cells T) -> exists z r2,
  (forall i, sq (m (point_of t i) ⊖ z) = r2) /\ forall n, is_vertex T n -> r2 <= sq (m n ⊖ z).

(* A positive cell has a sphere. *)
Lemma circumsphere x : 0 < volume x -> exists z r2, forall k, sq (x k ⊖ z) = r2.
Proof.
  intro H. pose (d k := x k ⊖ x o). pose (h := bicell.twice_centre (d u) (d v) (d w)).
  exists (x o ⊕ / (2 * volume x) ⊙ h), (sq (/ (2 * volume x) ⊙ h)). intro k.
  assert (E : 2 * (h · d k) = 2 * volume x * sq (d k)).
  { unfold h, volume, bicell.twice_centre. fold (d u) (d v) (d w). destruct k.
    - replace (d o) with zero by (unfold d; vector). generalize (d u) (d v) (d w). vector.
    - generalize (d u) (d v) (d w). vector.
    - generalize (d u) (d v) (d w). vector.
    - generalize (d u) (d v) (d w). vector. }
  replace (x k ⊖ (x o ⊕ / (2 * volume x) ⊙ h)) with (d k ⊖ / (2 * volume x) ⊙ h) by (unfold d; generalize h (/ (2 * volume x)); vector).
  replace (sq (d k ⊖ / (2 * volume x) ⊙ h)) with (sq (d k) - / (2 * volume x) * (2 * (h · d k)) + sq (/ (2 * volume x) ⊙ h))
    by (generalize h (d k) (/ (2 * volume x)); vector).
  rewrite E. field. lra.
Qed.

Section heights.
Variables (m : placement_3) (f : nat -> R).

(* The affine function through the heights of a cell's corners. *)
Definition plane_3 (t : four) (y : vec) : R :=
  (bary m t y o * f (point_of t o) + bary m t y u * f (point_of t u) + bary m t y v * f (point_of t v) + bary m t y w * f (point_of t w)) / size m t.

Lemma plane_affine t : affine (plane_3 t).
Proof.
  apply (affine_ext (fun y => 1 * (/ size m t * f (point_of t o) * bary m t y o + / size m t * f (point_of t u) * bary m t y u)
    + 1 * (/ size m t * f (point_of t v) * bary m t y v + / size m t * f (point_of t w) * bary m t y w))).
  - intro y. unfold plane_3, Rdiv. ring.
  - apply (affine_sum (fun y => _ * bary m t y o + _ * bary m t y u) (fun y => _ * bary m t y v + _ * bary m t y w));
      apply affine_sum; apply bary_affine.
Qed.

Lemma plane_at_corner t i : 0 < size m t -> plane_3 t (m (point_of t i)) = f (point_of t i).
Proof. intro P. unfold plane_3. rewrite !bary_corner. destruct i; cbn; field; lra. Qed.

Lemma plane_same y : same_for_cell (fun t => plane_3 t y).
Proof.
  intros a b c d. unfold plane_3.
  replace (size m (b, c, a, d)) with (size m (a, b, c, d)) by (unfold size, orient; vector).
  replace (size m (a, c, d, b)) with (size m (a, b, c, d)) by (unfold size, orient; vector).
  unfold bary, facet_height, side_of, point_of, Rdiv. facet (m b) (m d) (m c). facet (m a) (m c) (m d). facet (m a) (m d) (m b). facet (m a) (m b) (m c).
  split; ring.
Qed.

(* Across a bi-cell planes differ by a multiple of the height above its facet. *)
Lemma planes_apart a b c p q y : 0 < size m (a, b, c, q) -> 0 < size m (b, a, c, p) ->
  size m (a, b, c, q) * (plane_3 (a, b, c, q) y - plane_3 (b, a, c, p) y)
  = facet_height m (a, b, c, q) y * (f q - plane_3 (b, a, c, p) (m q)).
Proof.
  intros P Q. assert (A : affine (fun y => 1 * plane_3 (a, b, c, q) y + -1 * plane_3 (b, a, c, p) y)) by (apply affine_sum; apply plane_affine).
  generalize (affine_bary m _ (a, b, c, q) y A).
  generalize (plane_at_corner (a, b, c, q) o P) (plane_at_corner (a, b, c, q) u P) (plane_at_corner (a, b, c, q) v P) (plane_at_corner (a, b, c, q) w P)
    (plane_at_corner (b, a, c, p) o Q) (plane_at_corner (b, a, c, p) u Q) (plane_at_corner (b, a, c, p) v Q).
  cbn [point_of]. intros -> -> -> -> -> -> ->. unfold bary at 4. cbn [side_of]. intro E. lra.
Qed.
End heights.

Section placed.
Variables (T : mesh_3) (m : placement_3).
Hypothesis gluing : glued_3 T.
Hypothesis cells_positive : positive_3 m T.
Hypothesis border_convex : forall s n, In s (outer T) -> is_vertex T n -> 0 <= facet_height m s (m n).
Hypothesis once : exists x t rest, Permutation (cells T) (t :: rest) /\ inside_3 m x t /\ forall r, In r rest -> ~ in_cell_3 m x r.

Lemma size_turned s r : turned s r -> size m r = size m s.
Proof. intros []; unfold size, orient; vector. Qed.

Lemma size_bicell a b c p q : In (a, b, c, p, q) (bicells T) -> 0 < size m (a, b, c, q) /\ 0 < size m (b, a, c, p).
Proof.
  intro I. assert (K : forall s, In s (flat_map shared_sides (bicells T)) -> 0 < size m s).
  { intros s S. destruct (glued_side T gluing s) as (t & i & It & R); [apply in_or_app; now left|]. rewrite (size_turned _ _ R).
    replace (size m (side_of t i)) with (size m t); [now apply (size_pos T m cells_positive)|].
    destruct t as [[[a' b'] c'] d']. destruct i; cbn [side_of]; unfold size, orient; vector. }
  split; apply K, in_flat_map; exists (a, b, c, p, q); (split; [exact I|]); simpl; tauto.
Qed.

Lemma counted_once_3 x t (f : four -> R) : In t (cells T) -> all_positive (bary m t x) ->
  sum (fun r => f r * inside_all (bary m r x)) (cells T) = f t.
Proof.
  intros I P. apply in_split in I. destruct I as (l1 & l2 & E).
  assert (Q : Permutation (cells T) (t :: l1 ++ l2)) by (rewrite E; symmetry; apply Permutation_middle).
  rewrite (sum_permutation _ _ _ Q), sum_cons, (inside_one _ P), (sum_ext _ (fun _ => 0)), sum_zero; [ring|]. intros r R.
  assert (N := disjoint_3 T m gluing cells_positive border_convex once x t r (l1 ++ l2) Q R). rewrite inside_bary in N.
  destruct (outside_bary m x r (N P)) as (i & B). rewrite (inside_none _ i B). ring.
Qed.

Lemma step_signs x y s : step_3 m x y s = 0 \/ (step_3 m x y s < 0 /\ facet_height m s y <= 0) \/ (0 < step_3 m x y s /\ 0 <= facet_height m s y).
Proof.
  destruct s as [[[a b] c] d]. cbn [step_3]. destruct (one_side_cases (line m x y a b) (line m x y b c) (line m x y c a)) as [-> | ->]; [left; ring|].
  unfold half, pos. repeat match goal with |- context [Rlt_dec ?q ?p] => destruct (Rlt_dec q p) end; lra.
Qed.

Theorem regular_3 f : (forall a b c p q, In (a, b, c, p, q) (bicells T) -> plane_3 m f (b, a, c, p) (m q) <= f q) ->
  forall t n, In t (cells T) -> is_vertex T n -> plane_3 m f t (m n) <= f n.
Proof.
  intros Convex t n It (r & Ir & C). assert (E : exists i, n = point_of r i).
  { destruct r as [[[a b] c] d]. destruct C as [->|[->|[->| ->]]]; [now exists o|now exists u|now exists v|now exists w]. }
  destruct E as (i & ->). rewrite <- (plane_at_corner m f r i) by now apply (size_pos T m cells_positive).
  assert (Ct := centre_inside T m cells_positive t It).
  destruct (small_exists _ (small_and _ _ (near_inside_3 m (centre_3 m t) (centre_3 m t) t (fun j => or_introl (Ct j)))
    (near_regular T m cells_positive (centre_3 m t) (centre_3 m t)))) as (e & _ & X & R).
  set (x := curve (centre_3 m t) (centre_3 m t) e) in *. clearbody x.
  assert (Z : in_cell_3 m (m (point_of r i)) r).
  { apply in_bary. intro j. rewrite bary_corner. generalize (size_pos T m cells_positive r Ir). destruct (corner_dec j i); lra. }
  assert (G := small_and _ _ (near_centre T m cells_positive _ r Ir Z) (near_general T m cells_positive x (m (point_of r i)) (centre_3 m r) R)).
  assert (A : affine (fun y => 1 * plane_3 m f r y + -1 * plane_3 m f t y)) by (apply affine_sum; apply plane_affine).
  assert (L : 0 <= 1 * plane_3 m f r (m (point_of r i)) + -1 * plane_3 m f t (m (point_of r i))); [|lra].
  apply (near_limit _ _ (centre_3 m r) A). apply (small_impl _ _) with (2 := G). clear e G. intros e _ [Y Gp]. set (y := curve _ _ e) in *. clearbody y.
  assert (K := change_3 T m gluing cells_positive x y (fun s => plane_3 m f s y) Gp (inside_inner T m gluing cells_positive border_convex x t It X)
    (inside_inner T m gluing cells_positive border_convex y r Ir Y) (plane_same m f y)).
  rewrite (counted_once_3 y r _ Ir Y), (counted_once_3 x t _ It X) in K.
  assert (N : 0 <= plane_3 m f r y - plane_3 m f t y); [|lra]. rewrite K. apply sum_nonneg. intros [[[[a b] c] p] q] I.
  destruct (size_bicell a b c p q I) as [P Q]. assert (D := planes_apart m f a b c p q y P Q). assert (C' := Convex a b c p q I).
  assert (S := step_signs x y (a, b, c, q)). revert D C' S P. generalize (step_3 m x y (a, b, c, q)) (facet_height m (a, b, c, q) y) (size m (a, b, c, q))
    (plane_3 m f (a, b, c, q) y - plane_3 m f (b, a, c, p) y) (plane_3 m f (b, a, c, p) (m q)). intros k h V d g D C' S P.
  apply (Rmult_le_reg_l V); [exact P|]. rewrite Rmult_0_r. replace (V * (k * d)) with (k * (h * (f q - g))) by (rewrite <- D; ring).
  destruct S as [->|[[S H]|[S H]]]; [lra| |repeat apply Rmult_le_pos; lra].
  replace (k * (h * (f q - g))) with (- k * (- h * (f q - g))) by ring. repeat apply Rmult_le_pos; lra.
Qed.

(* ---- Spheres ---- *)

Definition lift_3 n : R := sq (m n).

(* The power of a point in the sphere of a cell is its height above the cell's plane. *)
Lemma power_lift_3 t z r2 y : 0 < size m t -> (forall i, sq (m (point_of t i) ⊖ z) = r2) -> sq (y ⊖ z) - r2 = sq y - plane_3 m lift_3 t y.
Proof.
  intros P H. assert (A : affine (fun x => sq (x ⊖ z) - sq x)) by (exists (-2 ⊙ z), (sq z); vector).
  assert (E := affine_bary m _ t y A). cbv beta in E. rewrite !H in E. apply (Rmult_eq_reg_l (size m t)); [|lra].
  assert (B : (bary m t y o + bary m t y u + bary m t y v + bary m t y w) * r2 = size m t * r2) by now rewrite bary_total.
  assert (C : size m t * plane_3 m lift_3 t y = bary m t y o * lift_3 (point_of t o) + bary m t y u * lift_3 (point_of t u)
    + bary m t y v * lift_3 (point_of t v) + bary m t y w * lift_3 (point_of t w)) by (unfold plane_3; field; lra).
  unfold lift_3 in *. lra.
Qed.

Lemma sphere_of t : 0 < size m t -> exists z r2, forall i, sq (m (point_of t i) ⊖ z) = r2.
Proof. intro P. apply (circumsphere (fun i => m (point_of t i))). now destruct t as [[[a b] c] d]. Qed.

(* The certificate is the height of q above the plane of b, a, c, p, lifted. *)
Lemma insphere_height a b c p q : 0 < size m (b, a, c, p) ->
  size m (b, a, c, p) * (lift_3 q - plane_3 m lift_3 (b, a, c, p) (m q)) = insphere_at m a b c p q.
Proof.
  intro P. destruct (sphere_of _ P) as (z & r2 & S). change (lift_3 q) with (sq (m q)). rewrite <- (power_lift_3 _ z r2 (m q) P S).
  unfold insphere_at. rewrite <- (bicell.empty_sphere _ z r2); [|exact (S u)|exact (S o)|exact (S v)|exact (S w)].
  f_equal. unfold size, orient, bicell.lambda, bicell.lambda_q, bicell.rel. vector.
Qed.

Theorem space_delaunay : locally_delaunay_3 m T -> delaunay_3 m T.
Proof.
  intros L t It. assert (P := size_pos T m cells_positive t It). destruct (sphere_of t P) as (z & r2 & S). exists z, r2. split; [exact S|].
  intros n N. assert (E := power_lift_3 t z r2 (m n) P S).
  assert (H : plane_3 m lift_3 t (m n) <= lift_3 n); [|change (lift_3 n) with (sq (m n)) in H; lra].
  apply regular_3; trivial. intros a b c p q I. destruct (size_bicell a b c p q I) as [_ Q].
  generalize (insphere_height a b c p q Q) (L a b c p q I). intros <- K. apply Rnot_lt_le. intro N'. nra.
Qed.

(* A vertex that is lowered a little keeps strict certificates. *)
Definition lowered_3 (n : nat) (e : R) (k : nat) : R := lift_3 k - e * (if Nat.eq_dec k n then 1 else 0).

Lemma plane_lowered n e t y : plane_3 m (lowered_3 n e) t y = plane_3 m lift_3 t y - e * plane_3 m (fun k => if Nat.eq_dec k n then 1 else 0) t y.
Proof. unfold plane_3, lowered_3, Rdiv. ring. Qed.

Theorem space_delaunay_strict : (forall a b c p q, In (a, b, c, p, q) (bicells T) -> 0 < insphere_at m a b c p q) ->
  forall t n z r2, In t (cells T) -> is_vertex T n -> (forall i, n <> point_of t i) -> (forall i, sq (m (point_of t i) ⊖ z) = r2) -> r2 < sq (m n ⊖ z).
Proof.
  intros L t n z r2 It Vn N S. assert (E := power_lift_3 t z r2 (m n) (size_pos T m cells_positive t It) S).
  assert (K : small (fun e => forall k, In k (bicells T) -> let '(a, b, c, p, q) := k in plane_3 m (lowered_3 n e) (b, a, c, p) (m q) <= lowered_3 n e q)).
  { apply small_all. intros [[[[a b] c] p] q] I. destruct (size_bicell a b c p q I) as [_ Q].
    assert (A : 0 < lift_3 q - plane_3 m lift_3 (b, a, c, p) (m q)).
    { generalize (insphere_height a b c p q Q) (L a b c p q I). intros <- K. apply (Rmult_lt_reg_l (size m (b, a, c, p))); [exact Q|]. now rewrite Rmult_0_r. }
    set (k := (if Nat.eq_dec q n then 1 else 0) - plane_3 m (fun k => if Nat.eq_dec k n then 1 else 0) (b, a, c, p) (m q)).
    apply (small_impl (fun e => 0 < (1 - e) * (lift_3 q - plane_3 m lift_3 (b, a, c, p) (m q)) + e * (lift_3 q - plane_3 m lift_3 (b, a, c, p) (m q) - k)));
      [|now apply small_positive].
    intros e _ H. rewrite plane_lowered. unfold lowered_3. unfold k in H. lra. }
  destruct (small_exists _ K) as (e & Pos & F).
  assert (H : plane_3 m (lowered_3 n e) t (m n) <= lowered_3 n e n) by (apply regular_3; trivial; intros a b c p q I; apply (F _ I)).
  rewrite plane_lowered in H. unfold lowered_3 in H. destruct (Nat.eq_dec n n) as [_|D]; [|now elim D].
  replace (plane_3 m (fun k => if Nat.eq_dec k n then 1 else 0) t (m n)) with 0 in H; [change (lift_3 n) with (sq (m n)) in H; lra|].
  unfold plane_3. destruct (Nat.eq_dec (point_of t o) n) as [D|_]; [now elim (N o)|]. destruct (Nat.eq_dec (point_of t u) n) as [D|_]; [now elim (N u)|].
  destruct (Nat.eq_dec (point_of t v) n) as [D|_]; [now elim (N v)|]. destruct (Nat.eq_dec (point_of t w) n) as [D|_]; [now elim (N w)|].
  unfold Rdiv. ring.
Qed.
End placed.
