(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Affine functions over the cells of a mesh: docs/theory.md 1.2, the end of lemma 1.

   - planes_differ     across a bi-cell they differ by a multiple of the distance from its edge
   - same_weights      two cells that contain a point give it the same corners with the same weights
   - vertex_is_corner  a vertex in a cell is one of its corners *)
Require Import Reals Lra Psatz List Permutation Arith.
From Annulus Require Import sums small width_2 plane_mesh plane_crossings plane_border plane_embedding.
Import ListNotations.
Open Scope R_scope.

(* ---- Two cells ---- *)

(* The affine function through the heights f a, f b, f c. *)
Definition plane_through (m : placement) (f : nat -> R) (y : point_2) (t : nat * nat * nat) : R := let '(a, b, c) := t in
  (turning (m b) (m c) y * f a + turning (m c) (m a) y * f b + turning (m a) (m b) y * f c) / turn_at m a b c.

(* Positive when p is above the plane of a, b, q, and q above that of b, a, p. *)
Definition fold (m : placement) (f : nat -> R) a b p q : R :=
  turn_at m b p q * f a - turn_at m a p q * f b + turn_at m a b q * f p + turn_at m b a p * f q.

Lemma plane_cycle m f y a b c : plane_through m f y (b, c, a) = plane_through m f y (a, b, c).
Proof.
  unfold plane_through. replace (turn_at m b c a) with (turn_at m a b c) by (unfold turn_at, turning, turn; ring). unfold Rdiv. ring.
Qed.

Lemma plane_mix m f e x y t : plane_through m f (mix e x y) t = (1 - e) * plane_through m f x t + e * plane_through m f y t.
Proof. destruct t as [[a b] c]. unfold plane_through. rewrite !turning_mix. unfold Rdiv. ring. Qed.

Lemma plane_corner m f t v : (let '(a, b, c) := t in 0 < turn_at m a b c) -> corner v t -> plane_through m f (m v) t = f v.
Proof.
  destruct t as [[a b] c]. unfold plane_through, turn_at. intros P C. destruct C as [->|[->| ->]].
  - replace (turning (m c) (m a) (m a)) with 0 by (unfold turning, turn; ring). replace (turning (m a) (m b) (m a)) with 0 by (unfold turning, turn; ring).
    replace (turning (m b) (m c) (m a)) with (turning (m a) (m b) (m c)) by (unfold turning, turn; ring). field. lra.
  - replace (turning (m b) (m c) (m b)) with 0 by (unfold turning, turn; ring). replace (turning (m a) (m b) (m b)) with 0 by (unfold turning, turn; ring).
    replace (turning (m c) (m a) (m b)) with (turning (m a) (m b) (m c)) by (unfold turning, turn; ring). field. lra.
  - replace (turning (m b) (m c) (m c)) with 0 by (unfold turning, turn; ring). replace (turning (m c) (m a) (m c)) with 0 by (unfold turning, turn; ring).
    field. lra.
Qed.

Lemma planes_differ m f a b p q y : 0 < turn_at m a b q -> 0 < turn_at m b a p ->
  plane_through m f y (a, b, q) - plane_through m f y (b, a, p)
  = turning (m a) (m b) y * (fold m f a b p q / (turn_at m a b q * turn_at m b a p)).
Proof.
  intros Q P. unfold plane_through. apply (Rmult_eq_reg_r (turn_at m a b q * turn_at m b a p)); [|nra].
  transitivity ((turning (m b) (m q) y * f a + turning (m q) (m a) y * f b + turning (m a) (m b) y * f q) * turn_at m b a p
    - (turning (m a) (m p) y * f b + turning (m p) (m b) y * f a + turning (m b) (m a) y * f p) * turn_at m a b q); [field; lra|].
  transitivity (turning (m a) (m b) y * fold m f a b p q); [|field; lra].
  unfold fold, turn_at, turning, turn. ring.
Qed.

Lemma fold_incircle m a b p q : fold m (fun v => fst (m v) * fst (m v) + snd (m v) * snd (m v)) a b p q = incircle_at m a b p q.
Proof. unfold fold, incircle_at, incircle, turn_at, turning, turn. ring. Qed.

(* ---- The mesh ---- *)

Section placed.
Variables (T : mesh) (m : placement).
Hypothesis gluing : glued T.
Hypothesis cells_positive : positive m T.
Hypothesis border_convex : convex m (border T).
Hypothesis border_once : winds_once m (border T).

Lemma cells_of_bicell a b p q : In (a, b, p, q) (bicells T) -> 0 < turn_at m a b q /\ 0 < turn_at m b a p.
Proof.
  intro I. assert (P : forall c d e, In (c, d, e) (flat_map shared_sides (bicells T)) -> 0 < turn_at m c d e).
  { intros c d e K. assert (K' : In (c, d, e) (flat_map sides (cells T))) by (rewrite (proj1 gluing); apply in_or_app; now left).
    apply in_flat_map in K'. destruct K' as ([[u v] w] & Iu & E). generalize (cells_positive u v w Iu). unfold turn_at, turning, turn.
    destruct E as [E|[E|[E|[]]]]; injection E as <- <- <-; lra. }
  split; apply P, in_flat_map; exists (a, b, p, q); (split; [exact I|]); [now left | right; now left].
Qed.

Lemma positive_cell t : In t (cells T) -> let '(a, b, c) := t in 0 < turn_at m a b c.
Proof. destruct t as [[a b] c]. apply cells_positive. Qed.

(* How much steeper one cell is than the other. *)
Definition bend (f : nat -> R) a b p q : R := fold m f a b p q / (turn_at m a b q * turn_at m b a p).

Lemma planes_change f x y t u : fst (vector x y) <> 0 \/ snd (vector x y) <> 0 -> In t (cells T) -> In u (cells T) ->
  inside_cell m x t -> inside_cell m y u -> plane_through m f y u - plane_through m f y t
  = sum (fun k => let '(a, b, p, q) := k in step m x y a b * (turning (m a) (m b) y * bend f a b p q)) (bicells T).
Proof.
  intros D It Iu Ht Hu.
  rewrite (change T m gluing cells_positive border_once border_convex x y t u (plane_through m f y) D It Iu Ht Hu (plane_cycle m f y)).
  apply sum_ext. intros [[[a b] p] q] I. destruct (cells_of_bicell a b p q I). now rewrite planes_differ.
Qed.

Lemma mix_vector e x y z : vector (mix e z x) (mix e z y) = (e * fst (vector x y), e * snd (vector x y)).
Proof. unfold vector, mix. simpl. f_equal; ring. Qed.

(* Where both cells have the point z: close to it their planes can differ by little only, because between them little is crossed. *)
Lemma planes_above f z t u : In t (cells T) -> In u (cells T) -> in_cell m z t -> in_cell m z u ->
  plane_through m f z u <= plane_through m f z t.
Proof.
  intros It Iu Ht Hu. set (x := middle m t). set (y := middle m u).
  destruct (zero_or_not (vector x y)) as [Z|D].
  { replace u with t; [apply Rle_refl|]. apply (same_cell T m gluing cells_positive border_once y); trivial.
    - rewrite (same_place x y Z). now apply middle_inside with T.
    - apply inside_in. now apply middle_inside with T. }
  set (K := sum (fun k => let '(a, b, p, q) := k in Rabs ((turning (m a) (m b) y - turning (m a) (m b) x) * bend f a b p q)) (bicells T)).
  assert (S : small (fun e => 0 <= (1 - e) * (plane_through m f z t - plane_through m f z u) + e * (plane_through m f y t - plane_through m f y u + K)));
    [|generalize (small_limit _ _ S); lra].
  apply (small_impl (fun e => e < 1)); [|apply small_below; lra]. intros e E L.
  assert (V : fst (vector (mix e z x) (mix e z y)) <> 0 \/ snd (vector (mix e z x) (mix e z y)) <> 0).
  { rewrite mix_vector. destruct D as [D|D]; [left|right]; (apply Rmult_integral_contrapositive_currified; [lra|exact D]). }
  assert (C := planes_change f (mix e z x) (mix e z y) t u V It Iu).
  rewrite !plane_mix in C. specialize (C ltac:(apply mix_inside with T; trivial; lra) ltac:(apply mix_inside with T; trivial; lra)).
  assert (Le : sum (fun k => let '(a, b, p, q) := k in
    step m (mix e z x) (mix e z y) a b * (turning (m a) (m b) (mix e z y) * bend f a b p q)) (bicells T) <= e * K);
    [|lra].
  unfold K. rewrite <- sum_scale. apply sum_le. intros [[[a b] p] q] _.
  generalize (step_cases m (mix e z x) (mix e z y) a b). unfold kept_or_crossed. rewrite !turning_mix.
  generalize (step m (mix e z x) (mix e z y) a b) (turning (m a) (m b) z) (turning (m a) (m b) x) (turning (m a) (m b) y) (bend f a b p q).
  intros s tz tx ty k H. rewrite Rabs_mult. generalize (Rabs_pos k) (Rle_abs k) (Rle_abs (- k)). rewrite (Rabs_Ropp k). intros A1 A2 A3.
  destruct H as [->|[(-> & H1 & H2)|(-> & H1 & H2)]].
  - generalize (Rabs_pos (ty - tx)). intro. assert (0 <= e * (Rabs (ty - tx) * Rabs k)) by (repeat apply Rmult_le_pos; lra). lra.
  - assert (e * ty - e * tx < 0) by lra. rewrite Rabs_left by nra. nra.
  - assert (0 < e * ty - e * tx) by lra. rewrite Rabs_right by nra. nra.
Qed.

Theorem same_weights z t u : In t (cells T) -> In u (cells T) -> in_cell m z t -> in_cell m z u ->
  forall f, plane_through m f z t = plane_through m f z u.
Proof. intros It Iu Ht Hu f. apply Rle_antisym; now apply planes_above. Qed.

Definition at_vertex (z v : nat) : R := if Nat.eq_dec v z then 1 else 0.

(* The weight of a vertex in a cell is positive at the corners only. *)
Lemma weight_corner z t x : 0 < plane_through m (at_vertex z) x t -> corner z t.
Proof.
  destruct t as [[a b] c]. unfold plane_through, at_vertex, corner. destruct (Nat.eq_dec a z), (Nat.eq_dec b z), (Nat.eq_dec c z); auto.
  intro H. exfalso. rewrite !Rmult_0_r, !Rplus_0_l in H. unfold Rdiv in H. rewrite Rmult_0_l in H. lra.
Qed.

Theorem vertex_is_corner z t : In t (cells T) -> vertex_of T z -> in_cell m (m z) t -> corner z t.
Proof.
  intros It (u & Iu & Cz) W. apply weight_corner with (m z). rewrite (same_weights (m z) t u); trivial; [|now apply corner_in with T].
  rewrite (plane_corner m _ u z (positive_cell u Iu) Cz). unfold at_vertex. destruct (Nat.eq_dec z z); [lra|contradiction].
Qed.
End placed.
