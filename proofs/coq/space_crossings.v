(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Segments in general position that cross the cells of a mesh of space.

   - cell_steps   the steps of a segment across the sides of a cell, with signs: whether its end is inside less whether its beginning is
   - change_3     between two points on the inner side of all border facets, the sum of a function over the cells that contain a point
                  changes by its steps across the bi-cells between *)
Require Import Reals Lra Psatz List Permutation.
From Annulus Require Import tetrahedron sums small general_position space_line space_mesh.
Import ListNotations.
Open Scope R_scope.

Lemma one_side_turn q p r : one_side p r q = one_side q p r.
Proof. unfold one_side. repeat match goal with |- context [Rlt_dec ?x ?y] => destruct (Rlt_dec x y) end; lra. Qed.
Lemma one_side_swap q p r : one_side p q r = one_side q p r.
Proof. unfold one_side. repeat match goal with |- context [Rlt_dec ?x ?y] => destruct (Rlt_dec x y) end; lra. Qed.
Lemma one_side_neg q p r : one_side (- q) (- p) (- r) = one_side q p r.
Proof. unfold one_side. repeat match goal with |- context [Rlt_dec ?x ?y] => destruct (Rlt_dec x y) end; lra. Qed.
Lemma one_side_scale k q p r : 0 < k -> one_side (k * q) (k * p) (k * r) = one_side q p r.
Proof.
  intro K. assert (P : forall x, (0 < k * x <-> 0 < x) /\ (k * x < 0 <-> x < 0)) by (intro x; repeat split; intro; nra).
  unfold one_side. generalize (P q) (P p) (P r). intros.
  repeat match goal with |- context [Rlt_dec ?x ?y] => destruct (Rlt_dec x y) end; try reflexivity; exfalso; tauto.
Qed.
Lemma one_side_cases q p r : one_side q p r = 0 \/ one_side q p r = 1.
Proof. unfold one_side. repeat match goal with |- context [Rlt_dec ?x ?y] => destruct (Rlt_dec x y) end; lra. Qed.

Lemma one_side_turned q p r : one_side q r p = one_side q p r.
Proof. rewrite (one_side_turn p q r). apply one_side_swap. Qed.

(* 1/2, -1/2, or 0. *)
Definition half (x : R) : R := (pos x - pos (- x)) / 2.

Lemma half_opp x : half (- x) = - half x.
Proof. unfold half. rewrite Ropp_involutive. lra. Qed.

Lemma half_nonzero x : x <> 0 -> half x = pos x - 1 / 2.
Proof. intro N. unfold half, pos. destruct (Rdichotomy _ _ N), (Rlt_dec 0 x), (Rlt_dec 0 (- x)); lra. Qed.

(* Two facets at an edge e f of a cell, their heights at x and at y; then all pairs of facets of a cell, as side_of has them. *)
Lemma at_edge e f g h x y : orient e f g x * orient e f h y - orient e f g y * orient e f h x = orient e f g h * orient x y e f.
Proof.
  transitivity (orient e f g h * orient e f x y); [unfold orient; generalize (f ⊖ e) (g ⊖ e) (h ⊖ e) (x ⊖ e) (y ⊖ e)|f_equal; unfold orient]; vector.
Qed.
Lemma orient_turn a b c x : orient b c a x = orient a b c x.
Proof. unfold orient. vector. Qed.
Ltac facet e f g := rewrite ?(orient_turn e g f), ?(orient_turn f e g), ?(orient_turn f g e), ?(orient_turn e f g), ?(orient_swap e f g).

Lemma at_edges a b c d x y (S := orient a b c d) (O := orient b d c) (U := orient a c d) (V := orient a d b) (W := orient a b c) :
  O x * U y - O y * U x = - (S * orient x y d c) /\ O x * V y - O y * V x = - (S * orient x y b d) /\
  O x * W y - O y * W x = - (S * orient x y c b) /\ U x * V y - U y * V x = - (S * orient x y d a) /\
  U x * W y - U y * W x = - (S * orient x y a c) /\ V x * W y - V y * W x = - (S * orient x y b a).
Proof.
  assert (So : O a = S) by (unfold O, S, orient; vector). assert (Su : U b = S) by (unfold U, S, orient; vector).
  assert (Sv : V c = S) by (unfold V, S, orient; vector). unfold S, O, U, V, W in *.
  generalize (at_edge d c b a x y) (at_edge b d c a x y) (at_edge c b d a x y) (at_edge d a c b x y) (at_edge a c d b x y) (at_edge b a d c x y).
  facet b d c. facet a c d. facet a d b. facet a b c. rewrite So, Su, Sv. intros. repeat split; lra.
Qed.

Section placed.
Variables (T : mesh_3) (m : placement_3).

Definition point_of (t : four) (i : corner) : nat := let '(a, b, c, d) := t in match i with o => a | u => b | v => c | w => d end.
Definition side_of (t : four) (i : corner) : four := let '(a, b, c, d) := t in
  match i with o => (b, d, c, a) | u => (a, c, d, b) | v => (a, d, b, c) | w => (a, b, c, d) end.
(* The weights of the corners, times six volumes. *)
Definition bary (t : four) (x : vec) (i : corner) : R := facet_height m (side_of t i) x.
Definition size (t : four) : R := let '(a, b, c, d) := t in orient (m a) (m b) (m c) (m d).

Lemma sides_of t : sides t = map (side_of t) [o; u; v; w].
Proof. now destruct t as [[[a b] c] d]. Qed.

Lemma in_sides s t : In s (sides t) -> exists i, s = side_of t i.
Proof. rewrite sides_of. intro I. apply in_map_iff in I. destruct I as (i & <- & _). now exists i. Qed.
Lemma side_in t i : In (side_of t i) (sides t).
Proof. rewrite sides_of. apply in_map. apply in_corners. Qed.

Lemma bary_total t x : bary t x o + bary t x u + bary t x v + bary t x w = size t.
Proof. destruct t as [[[a b] c] d]. unfold bary, side_of, facet_height, size, orient. vector. Qed.

Lemma height_affine s : affine (facet_height m s).
Proof.
  destruct s as [[[a b] c] d]. exists ((m b ⊖ m a) ✕ (m c ⊖ m a)), (- (((m b ⊖ m a) ✕ (m c ⊖ m a)) · m a)). intro x. unfold facet_height, orient. vector.
Qed.
Lemma bary_affine t i : affine (fun x => bary t x i).
Proof. apply height_affine. Qed.

Lemma bary_corner t i j : bary t (m (point_of t j)) i = if corner_dec i j then size t else 0.
Proof. destruct t as [[[a b] c] d]. unfold bary, facet_height, size, orient.
  destruct i, j; cbn [side_of point_of]; (destruct (corner_dec _ _); [try discriminate|try congruence]); vector. Qed.

Lemma affine_bary f t x : affine f -> size t * f x = bary t x o * f (m (point_of t o)) + bary t x u * f (m (point_of t u))
  + bary t x v * f (m (point_of t v)) + bary t x w * f (m (point_of t w)).
Proof.
  intros (n & k & F). rewrite !F. destruct t as [[[a b] c] d]. unfold bary, side_of, facet_height, size, orient, point_of.
  generalize (m a) (m b) (m c) (m d). clear. vector.
Qed.

Definition line x y a b : R := orient x y (m a) (m b).
Definition step_3 (x y : vec) (s : four) : R := let '(a, b, c, _) := s in
  one_side (line x y a b) (line x y b c) (line x y c a) * (half (facet_height m s y) - half (facet_height m s x)).

Lemma step_turned x y s r : turned s r -> step_3 x y r = step_3 x y s.
Proof.
  intro H. generalize (turned_height m s r x H) (turned_height m s r y H).
  destruct H as [a b c d|a b c d|a b c d]; cbn [step_3]; [reflexivity|intros -> ->; now rewrite one_side_turn|intros -> ->; now rewrite <- one_side_turn].
Qed.

Lemma line_swap x y a b : line x y b a = - line x y a b.
Proof. unfold line, orient. vector. Qed.

Lemma step_swap_3 x y a b c p q : step_3 x y (b, a, c, p) = - step_3 x y (a, b, c, q).
Proof.
  unfold step_3, facet_height. rewrite !(orient_swap (m a) (m b)), !half_opp, (line_swap x y a b), (line_swap x y c a), (line_swap x y b c).
  rewrite one_side_neg, one_side_turned. ring.
Qed.

Definition general_position (t : four) (x y : vec) : Prop :=
  (forall i, bary t x i <> 0) /\ (forall i, bary t y i <> 0) /\ forall i j, i <> j -> order (bary t x) (bary t y) i j <> 0.

Lemma hit_line t x y i : 0 < size t -> let '(a, b, c, _) := side_of t i in
  hit (bary t x) (bary t y) i = one_side (line x y a b) (line x y b c) (line x y c a).
Proof.
  destruct t as [[[a b] c] d]. intro P. unfold size in P.
  assert (E : forall q p r q' p' r', q' = - (orient (m a) (m b) (m c) (m d) * q) -> p' = - (orient (m a) (m b) (m c) (m d) * p) ->
    r' = - (orient (m a) (m b) (m c) (m d) * r) -> one_side q' p' r' = one_side q p r)
    by (intros q p r q' p' r' -> -> ->; rewrite one_side_neg; now apply one_side_scale).
  unfold hit, others, order, wedge, pair, bary, facet_height.
  destruct (at_edges (m a) (m b) (m c) (m d) x y) as (OU & OV & OW & UV & UW & VW). fold (line x y d c) (line x y b d) (line x y c b) in OU, OV, OW.
  fold (line x y d a) (line x y a c) (line x y b a) in UV, UW, VW.
  destruct i; cbn [side_of fst snd].
  - rewrite <- (one_side_swap (line x y b d)). apply E; assumption.
  - rewrite <- (one_side_turn (line x y a c)). apply E; try assumption; rewrite line_swap; lra.
  - rewrite <- (one_side_swap (line x y a d)). apply E; try assumption; rewrite line_swap; lra.
  - rewrite <- (one_side_turn (line x y a b)). apply E; try assumption; rewrite line_swap; lra.
Qed.

Lemma cell_steps t x y : 0 < size t -> general_position t x y ->
  sum (step_3 x y) (sides t) = inside_all (bary t y) - inside_all (bary t x).
Proof.
  intros P (X & Y & G). rewrite <- (entered (bary t x) (bary t y)); trivial; [|now rewrite bary_total|now rewrite !bary_total].
  assert (E : forall i, step_3 x y (side_of t i) = hit (bary t x) (bary t y) i * (pos (bary t y i) - pos (bary t x i))).
  { intro i. generalize (hit_line t x y i P) (X i) (Y i). unfold bary. destruct (side_of t i) as [[[a b] c] d] eqn:S. cbn [step_3].
    intros -> Nx Ny. rewrite !half_nonzero by assumption. ring. }
  rewrite sides_of. cbn [map sum]. rewrite !E. ring.
Qed.

Hypothesis gluing : glued_3 T.
Hypothesis cells_positive : positive_3 m T.

Lemma size_pos t : In t (cells T) -> 0 < size t.
Proof. destruct t as [[[a b] c] d]. apply cells_positive. Qed.

(* On the inner side of every border facet. *)
Definition inner (x : vec) : Prop := forall s, In s (outer T) -> 0 < facet_height m s x.

Lemma outer_step x y s : 0 < facet_height m s x -> 0 < facet_height m s y -> step_3 x y s = 0.
Proof.
  destruct s as [[[a b] c] d]. intros X Y. unfold step_3. rewrite !half_nonzero by lra. unfold pos.
  destruct (Rlt_dec 0 (facet_height m (a, b, c, d) x)); [|lra]. destruct (Rlt_dec 0 (facet_height m (a, b, c, d) y)); [|lra]. ring.
Qed.

Theorem change_3 x y (f : four -> R) : (forall t, In t (cells T) -> general_position t x y) -> inner x -> inner y -> same_for_cell f ->
  sum (fun t => f t * inside_all (bary t y)) (cells T) - sum (fun t => f t * inside_all (bary t x)) (cells T)
  = sum (fun k => let '(a, b, c, p, q) := k in step_3 x y (a, b, c, q) * (f (a, b, c, q) - f (b, a, c, p))) (bicells T).
Proof.
  intros G X Y S. generalize (by_facets T (step_3 x y) f gluing (step_turned x y) S (step_swap_3 x y)).
  rewrite (sum_ext (fun s => step_3 x y s * f s) (fun _ => 0)), sum_zero, Rplus_0_r; [|intros s I; rewrite outer_step; [ring|now apply X|now apply Y]].
  intros <-. transitivity (sum (fun t => f t * inside_all (bary t y) + -1 * (f t * inside_all (bary t x))) (cells T)); [rewrite sum_plus, sum_scale; ring|].
  apply sum_ext. intros t I. rewrite (cell_steps t x y (size_pos t I) (G t I)). ring.
Qed.
End placed.
