(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* How often glued, positive cells cover each point of a periodic plane: docs/theory.md 8.3.

   - counted        the rays from a point along the first vector of the box cross the sides of all translates of cells half as often as covers_2 says,
                    counted with signs: the same for every point
   - counted_near   counting translates by at most n vectors, one n does for all points that are near enough
   - side_moved     what is counted of one side, t vectors away

   Rays cross infinitely many sides, so translates by at most n vectors are counted.
   A side and the one that it is glued to, t vectors away, cancel but for the
   translates by which the two ranges differ: those at one end are all crossed, those at the other are not. What is left depends on t and on how many
   translates of each vertex are above the ray; degree_2, with vertices at these heights, adds it up. *)
Require Import Reals ZArith Lra Lia Psatz List Permutation.
From Annulus Require Import sums width_2 plane_mesh plane_crossings torus_2 torus_powers.
From Annulus Require Export torus_ranges.
Import ListNotations.
Open Scope R_scope.

Section placed.
Variables (x : nat -> point_2) (L : box_2).
Hypothesis box_positive : 0 < det_2 L.
Notation spot := (spot x L).
Notation moved_spot t s := (spot (moved_2 t s)).

(* ---- A side and a ray ---- *)

Section rays.
Variable z : point_2.
Notation d := (fst L).

Definition side_crossing (a b : site_2) (t : offset_2) : R := crossing d z (moved_spot t a) (moved_spot t b).
(* 1 on the left of the ray. *)
Definition above (s : site_2) (j : Z) : R := if Rle_dec (cross d (moved_spot (0, j)%Z s)) (cross d z) then 0 else 1.

Lemma height_moved t s : cross d (moved_spot t s) = cross d (spot s) + IZR (snd t) * det_2 L.
Proof. rewrite (spot_moved x L). unfold cross, lattice_2, det_2. cbn [fst snd]. ring. Qed.

Lemma width_moved t s : cross (moved_spot t s) (snd L) = cross (spot s) (snd L) + IZR (fst t) * det_2 L.
Proof. rewrite (spot_moved x L). unfold cross, lattice_2, det_2. cbn [fst snd]. ring. Qed.

(* No farther from the ray's beginning than m translates, both ways. *)
Definition within_reach (m : Z) (s : site_2) : Prop :=
  Rabs (cross d z - cross d (spot s)) <= IZR m * det_2 L /\ Rabs (cross z (snd L) - cross (spot s) (snd L)) <= IZR m * det_2 L.

Lemma above_settles m s : within_reach m s -> settles m (above s) 1.
Proof.
  intros [B _] j. unfold above. rewrite height_moved. cbn [snd]. destruct (Rle_dec _ _) as [H|H]; split; intro J; try reflexivity; exfalso.
  - apply IZR_lt in J. assert (K := Rle_abs (cross d z - cross d (spot s))). nra.
  - apply IZR_lt in J. rewrite opp_IZR in J. assert (K := Rle_abs (- (cross d z - cross d (spot s)))). rewrite Rabs_Ropp in K. nra.
Qed.

Lemma above_moved t s j : above (moved_2 t s) j = above s (j + snd t)%Z.
Proof. unfold above. rewrite !height_moved. cbn [snd]. rewrite plus_IZR. destruct (Rle_dec _ _), (Rle_dec _ _); lra. Qed.

(* A side is crossed far ahead, never far behind. *)
Lemma turning_frame u v : turning u v z * det_2 L = (cross v (snd L) - cross z (snd L)) * (cross d z - cross d u) +
  (cross u (snd L) - cross z (snd L)) * (cross d v - cross d z).
Proof. unfold turning, turn, det_2, cross. ring. Qed.

Lemma passes_settle m a b : within_reach m a -> within_reach m b ->
  forall j, settles m (fun i => passes d z (moved_spot (i, j) a) (moved_spot (i, j) b)) ((1 - above a j) * above b j).
Proof.
  intros [_ B] [_ B'] j i. cbv beta. unfold passes, above. generalize (turning_frame (moved_spot (i, j) a) (moved_spot (i, j) b)).
  rewrite !width_moved, !height_moved. cbn [fst snd]. intro E.
  assert (Far : (m < i)%Z -> 0 < cross (spot b) (snd L) + IZR i * det_2 L - cross z (snd L) /\
    0 < cross (spot a) (snd L) + IZR i * det_2 L - cross z (snd L)).
  { intro I. assert (I1 : IZR m < IZR i) by (apply IZR_lt; lia).
    assert (K := Rle_abs (cross z (snd L) - cross (spot a) (snd L))). assert (K' := Rle_abs (cross z (snd L) - cross (spot b) (snd L))). split; nra. }
  assert (Back : (i < - m)%Z -> 0 < cross z (snd L) - (cross (spot b) (snd L) + IZR i * det_2 L) /\
    0 < cross z (snd L) - (cross (spot a) (snd L) + IZR i * det_2 L)).
  { intro I. assert (I1 : IZR i < - IZR m) by (rewrite <- opp_IZR; apply IZR_lt; lia).
    assert (K := Rle_abs (- (cross z (snd L) - cross (spot a) (snd L)))). assert (K' := Rle_abs (- (cross z (snd L) - cross (spot b) (snd L)))).
    rewrite Rabs_Ropp in K, K'. split; nra. }
  destruct (Rle_dec (cross d (spot a) + IZR j * det_2 L) (cross d z)) as [Ha|Ha]; [|split; intros; lra].
  destruct (Rle_dec (cross d (spot b) + IZR j * det_2 L) (cross d z)) as [Hb|Hb]; [split; intros; lra|]. apply Rnot_le_lt in Hb.
  destruct (Rlt_dec 0 _) as [H|H]; split; intro I; try lra; exfalso.
  - destruct (Back I) as [Q1 Q2]. nra.
  - apply H. destruct (Far I) as [Q1 Q2]. apply Rmult_lt_reg_r with (det_2 L); [exact box_positive|]. rewrite E, Rmult_0_l. nra.
Qed.

Lemma crossing_settles m a b : within_reach m a -> within_reach m b -> forall j, settles m (fun i => side_crossing a b (i, j)) (above b j - above a j).
Proof.
  intros A B j i. assert (S := passes_settle m a b A B j i). assert (S' := passes_settle m b a B A j i). unfold side_crossing, crossing. split; intro I.
  - rewrite (proj1 S), (proj1 S') by lia. ring.
  - rewrite (proj2 S), (proj2 S') by lia. ring.
Qed.

Lemma not_straddling a b i j : above a j = above b j -> side_crossing a b (i, j) = 0.
Proof.
  unfold above, side_crossing, crossing, passes. rewrite !height_moved. cbn [snd].
  repeat match goal with |- context [Rle_dec ?a ?b] => destruct (Rle_dec a b) end; intro; lra.
Qed.

(* ---- A side and what it is glued to ---- *)

Definition side_count (n : Z) (s : side_2) : R := over n (fun j => over n (fun i => side_crossing (fst s) (snd s) (i, j))).
Definition level (n : Z) (s : site_2) : R := over n (above s).

Lemma level_moved m n t s : within_reach m s -> (0 <= m)%Z -> (m + 2 * Z.abs (snd t) < n)%Z -> level n (moved_2 t s) = level n s + IZR (snd t).
Proof.
  intros W M K. unfold level. rewrite (over_ext n (above (moved_2 t s)) (fun j => above s (j + snd t)%Z)) by (intro; apply above_moved).
  rewrite (shifted m _ 1 n (snd t) (above_settles m s W)) by lia. ring.
Qed.

Lemma side_moved m n t a b : within_reach m a -> within_reach m b -> (0 <= m)%Z -> (m + 2 * Z.abs (fst t) + 2 * Z.abs (snd t) < n)%Z ->
  side_count n (moved_2 t a, moved_2 t b) = side_count n (a, b) + IZR (fst t) * (level n b - level n a).
Proof.
  intros Wa Wb M K. assert (S := crossing_settles m a b Wa Wb). assert (Sa := above_settles m a Wa). assert (Sb := above_settles m b Wb).
  unfold side_count. cbn [fst snd]. set (A := fun j => over n (fun i => side_crossing a b (i, j))).
  assert (E : over n (fun j => over n (fun i => side_crossing (moved_2 t a) (moved_2 t b) (i, j)))
    = over n (fun j => A (j + snd t)%Z + IZR (fst t) * (above b (j + snd t)%Z - above a (j + snd t)%Z))).
  { apply over_ext. intro j. unfold A. rewrite <- (shifted m _ _ n (fst t) (S (j + snd t)%Z)) by lia.
    apply over_ext. intro i. unfold side_crossing. rewrite !moved_twice. reflexivity. }
  set (B := fun j => A j + IZR (fst t) * (above b j - above a j)).
  assert (Settled : settles m B 0).
  { assert (Z : forall j, above a j = above b j -> B j = 0).
    { intros j Q. unfold B, A. rewrite (over_ext n _ (fun _ => 0)) by (intro i; now apply not_straddling). unfold over. rewrite sum_zero, Q. ring. }
    intro j. split; intro J; apply Z.
    - rewrite (proj1 (Sa j)), (proj1 (Sb j)) by lia. reflexivity.
    - rewrite (proj2 (Sa j)), (proj2 (Sb j)) by lia. reflexivity. }
  rewrite E. change (over n (fun j => B (j + snd t)%Z) = over n A + IZR (fst t) * (level n b - level n a)).
  rewrite (shifted _ B 0 n (snd t) Settled) by lia. unfold B. rewrite over_plus, over_scale.
  rewrite (over_ext n (fun j => above b j - above a j) (fun j => above b j + -1 * above a j)) by (intro; ring).
  rewrite over_plus, over_scale. fold (level n a) (level n b). ring.
Qed.

Lemma side_count_back n a b : side_count n (b, a) = - side_count n (a, b).
Proof.
  unfold side_count. cbn [fst snd]. replace (- over n _) with (-1 * over n (fun j => over n (fun i => side_crossing a b (i, j)))) by ring.
  rewrite <- over_scale. apply over_ext. intro j. rewrite <- over_scale. apply over_ext. intro i. unfold side_crossing. rewrite crossing_swap. ring.
Qed.

Lemma both_counted m n k : within_reach m (fst (fst k)) -> within_reach m (snd (fst k)) -> (0 <= m)%Z ->
  (m + 2 * Z.abs (fst (snd k)) + 2 * Z.abs (snd (snd k)) < n)%Z ->
  sum (side_count n) (both_sides_2 k) = - (IZR (fst (snd k)) * (level n (snd (fst k)) - level n (fst (fst k)))).
Proof.
  destruct k as ((a, b), t). cbn [fst snd both_sides_2 sum]. intros Wa Wb M K. rewrite (side_count_back n (moved_2 t a) (moved_2 t b)).
  rewrite (side_moved m n t a b Wa Wb M K). ring.
Qed.

(* ---- All cells ---- *)

Definition crossings_at (c : torus_cell_2) : R := let '(a, b, q) := c in crossings d z (spot a) (spot b) (spot q).

Lemma count_by_sides T n : sum (fun k => crossings_at (instance k)) (instances T n) = sum (side_count n) (flat_map sides_2 T).
Proof.
  unfold instances. rewrite sum_list_prod, sum_flat_map. apply sum_ext. intros c _.
  rewrite (sum_list_prod (fun t => crossings_at (instance (c, t)))), sum_swap.
  destruct c as ((a, b), q). unfold side_count. cbn [sides_2 sum fst snd]. rewrite Rplus_0_r, <- !over_plus.
  apply over_ext. intro j. rewrite <- !over_plus. apply over_ext. intro i. unfold side_crossing, crossings_at, instance, crossings. simpl. ring.
Qed.

Definition unit_box : box_2 := ((1, 0), (0, 1)).
Definition heights (n : Z) (v : nat) : point_2 := (0, level n (v, (0, 0)%Z)).
(* Twice the area between a side and the second axis. *)
Definition trapezoid (n : Z) (s : side_2) : R := let at_ := site_at (heights n) unit_box in
  (fst (at_ (fst s)) + fst (at_ (snd s))) * (snd (at_ (snd s)) - snd (at_ (fst s))).

Lemma height_is m n s : within_reach m (fst s, (0, 0)%Z) -> (0 <= m)%Z -> (m + 2 * Z.abs (snd (snd s)) < n)%Z ->
  level n s = snd (site_at (heights n) unit_box s).
Proof.
  destruct s as (v, (i, j)). cbn [fst snd]. intros W M K. assert (E := level_moved m n (i, j) (v, (0, 0)%Z) W M K).
  cbn [moved_2 fst snd] in E. rewrite !Z.add_0_r in E. etransitivity; [exact E|]. unfold heights, unit_box. simpl. ring.
Qed.

Lemma trapezoids n k : sum (trapezoid n) (both_sides_2 k)
  = -2 * (IZR (fst (snd k)) * (snd (site_at (heights n) unit_box (snd (fst k))) - snd (site_at (heights n) unit_box (fst (fst k))))).
Proof.
  destruct k as (((v, (i, j)), (w, (k, l))), (t, u)). unfold trapezoid, unit_box. simpl. rewrite !plus_IZR. ring.
Qed.

Lemma covers_by_trapezoids T n : glued_torus_2 T -> IZR (covers_2 T) = sum (trapezoid n) (flat_map sides_2 T).
Proof.
  intro G. rewrite sum_flat_map. transitivity (sum (torus_area (heights n) unit_box) T).
  - rewrite (degree_2 T G). unfold det_2, unit_box. simpl. ring.
  - apply sum_ext. intros ((a, b), q) _. unfold torus_area, trapezoid, turning, turn. cbn [sides_2 sum fst snd]. ring.
Qed.

End rays.

(* ---- All points that are near enough ---- *)

Definition near (r : R) (z : point_2) : Prop := Rabs (cross (fst L) z) <= r /\ Rabs (cross z (snd L)) <= r.

Lemma reached r s : eventually (fun m => forall z, near r z -> within_reach z m s).
Proof.
  destruct (multiple (Rabs r + Rabs (cross (fst L) (spot s)) + Rabs (cross (spot s) (snd L))) (det_2 L) box_positive) as (m & M & B).
  exists m. intros n N z [Y X]. apply IZR_le in N. assert (N' : IZR m * det_2 L <= IZR n * det_2 L) by (apply Rmult_le_compat_r; lra).
  assert (Far : forall p q, Rabs p <= r -> Rabs q <= Rabs (cross (fst L) (spot s)) + Rabs (cross (spot s) (snd L)) -> Rabs (p - q) <= IZR n * det_2 L).
  { intros p q P Q. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. generalize (Rle_abs r). revert B. rewrite (Rabs_pos_eq (_ + _ + _)); [lra|].
    generalize (Rabs_pos r) (Rabs_pos (cross (fst L) (spot s))) (Rabs_pos (cross (spot s) (snd L))). lra. }
  generalize (Rabs_pos (cross (fst L) (spot s))) (Rabs_pos (cross (spot s) (snd L))). intros. split; apply Far; trivial; lra.
Qed.

Theorem counted_near r T : glued_torus_2 T ->
  eventually (fun n => forall z, near r z -> 2 * sum (fun k => crossings_at z (instance k)) (instances T n) = IZR (covers_2 T)).
Proof.
  intro G. assert (G' := G). destruct G' as (pairs & P).
  apply (eventually_impl (fun n => forall k, In k pairs -> forall z, near r z -> 2 * sum (side_count z n) (both_sides_2 k) = sum (trapezoid z n)
  (both_sides_2 k))).
  - intros n H z N. rewrite count_by_sides, (covers_by_trapezoids z T n G), !(sum_permutation _ _ _ P), !sum_flat_map, <- sum_scale.
    apply sum_ext. intros k I. now apply H.
  - apply eventually_all. intros ((a, b), (t1, t2)). destruct a as (v, (i, j)), b as (w, (k, l)).
    destruct (eventually_and _ _ (eventually_and _ _ (reached r (v, (i, j))) (reached r (w, (k, l))))
      (eventually_and _ _ (reached r (v, (0, 0)%Z)) (reached r (w, (0, 0)%Z)))) as (m & W).
    assert (Twice : forall p q t, 2 * - (t * (p - q)) = -2 * (t * (p - q))) by (intros; ring).
    set (m' := Z.max 0 m). exists (m' + 2 * Z.abs t1 + 2 * Z.abs t2 + 2 * Z.abs j + 2 * Z.abs l + 1)%Z.
    intros n K z N. destruct (W m') as [[Wa Wb] [Wa' Wb']]; [lia|].
    transitivity (2 * - (IZR t1 * (level z n (w, (k, l)) - level z n (v, (i, j))))).
    + f_equal. apply (both_counted z m' n ((v, (i, j)), (w, (k, l)), (t1, t2)) (Wa z N) (Wb z N)); cbn [fst snd]; lia.
    + etransitivity; [|symmetry; apply trapezoids]. cbn [fst snd].
      rewrite (height_is z m' n (v, (i, j))), (height_is z m' n (w, (k, l))); cbn [fst snd];
        first [apply Twice|now apply Wa'|now apply Wb'|lia].
Qed.

Theorem counted T z : glued_torus_2 T -> eventually (fun n => 2 * sum (fun k => crossings_at z (instance k)) (instances T n) = IZR (covers_2 T)).
Proof.
  intro G. eapply eventually_impl; [|exact (counted_near (Rmax (Rabs (cross (fst L) z)) (Rabs (cross z (snd L)))) T G)].
  cbv beta. intros n H. apply H. split; [apply Rmax_l|apply Rmax_r].
Qed.
End placed.
