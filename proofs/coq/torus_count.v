(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* How often glued, positive cells cover each point of a periodic plane: docs/theory.md 8.3.

   - counted   the rays from a point along the first vector of the box cross the sides of all translates of cells half as often as covers_2 says,
               counted with signs: the same for every point

   Rays cross infinitely many sides, so translates by at most n vectors are counted.
   A side and the one that it is glued to, t vectors away, cancel but for the
   translates by which the two ranges differ: those at one end are all crossed, those at the other are not. What is left depends on t and on how many
   translates of each vertex are above the ray; degree_2, with vertices at these heights, adds it up. *)
Require Import Reals ZArith Lra Lia Psatz List Permutation.
From Annulus Require Import sums width_2 plane_mesh plane_crossings torus_2 torus_powers.
Import ListNotations.
Open Scope R_scope.

(* ---- Large ranges ---- *)

Definition eventually (Q : Z -> Prop) : Prop := exists m, forall n, (m <= n)%Z -> Q n.

Lemma eventually_and Q Q' : eventually Q -> eventually Q' -> eventually (fun n => Q n /\ Q' n).
Proof. intros (m & H) (m' & H'). exists (Z.max m m'). intros n K. split; [apply H|apply H']; lia. Qed.

Lemma eventually_impl (Q Q' : Z -> Prop) : (forall n, Q n -> Q' n) -> eventually Q -> eventually Q'.
Proof. intros I (m & H). exists m. intros n K. now apply I, H. Qed.

Lemma eventually_all {S : Type} (Q : S -> Z -> Prop) l : (forall s, eventually (Q s)) -> eventually (fun n => forall s, In s l -> Q s n).
Proof.
  intro H. induction l as [|s l IH]; [exists 0%Z; now intros|]. apply (eventually_impl (fun n => Q s n /\ forall r, In r l -> Q r n)).
  - intros n [A B] r [<-|I]; [exact A|now apply B].
  - apply eventually_and; [apply H|exact IH].
Qed.

Lemma eventually_some Q : eventually Q -> exists n, Q n.
Proof. intros (m & H). exists m. apply H. lia. Qed.

Definition over (n : Z) (f : Z -> R) : R := sum f (up_to n).

Lemma over_ext n f g : (forall i, f i = g i) -> over n f = over n g.
Proof. intro H. apply sum_ext. intros i _. apply H. Qed.

Lemma over_plus n f g : over n (fun i => f i + g i) = over n f + over n g.
Proof. apply sum_plus. Qed.

Lemma over_scale n k f : over n (fun i => k * f i) = k * over n f.
Proof. apply sum_scale. Qed.

Lemma telescope (h : nat -> R) k : sum (fun i => h (S i) - h i) (seq 0 k) = h k - h O.
Proof. induction k as [|k IH]; [simpl; ring|]. rewrite seq_S, sum_app, IH. simpl. ring. Qed.

Lemma one_farther n f : (0 <= n)%Z -> over n (fun i => f (i + 1)%Z) = over n f + (f (n + 1)%Z - f (- n)%Z).
Proof.
  intro N. assert (E := telescope (fun k => f (Z.of_nat k - n)%Z) (Z.to_nat (2 * n + 1))). cbv beta in E.
  replace (Z.of_nat (Z.to_nat (2 * n + 1)) - n)%Z with (n + 1)%Z in E by lia. replace (Z.of_nat 0 - n)%Z with (- n)%Z in E by lia.
  rewrite <- E. unfold over, up_to. rewrite !sum_map, <- sum_plus. apply sum_ext. intros k _.
  replace (Z.of_nat k - n + 1)%Z with (Z.of_nat (S k) - n)%Z by lia. ring.
Qed.

(* 0 far down, g far up. *)
Definition settles (m : Z) (f : Z -> R) (g : R) : Prop := forall i, ((i < - m)%Z -> f i = 0) /\ ((m < i)%Z -> f i = g).

Lemma shifted_up m f g n k : settles m f g -> (m + Z.of_nat k < n)%Z -> (0 <= m)%Z ->
  over n (fun i => f (i + Z.of_nat k)%Z) = over n f + INR k * g.
Proof.
  intros S K M. induction k as [|k IH].
  - simpl INR. rewrite Rmult_0_l, Rplus_0_r. apply over_ext. intro i. f_equal. lia.
  - assert (E := one_farther n (fun i => f (i + Z.of_nat k)%Z)). cbv beta in E.
    rewrite (proj2 (S (n + 1 + Z.of_nat k)%Z)), (proj1 (S (- n + Z.of_nat k)%Z)), IH in E by lia.
    rewrite S_INR. replace (over n f + (INR k + 1) * g) with (over n f + INR k * g + (g - 0)) by ring. rewrite <- E by lia.
    apply over_ext. intro i. f_equal. lia.
Qed.

Lemma shifted m f g n t : settles m f g -> (m + 2 * Z.abs t < n)%Z -> (0 <= m)%Z -> over n (fun i => f (i + t)%Z) = over n f + IZR t * g.
Proof.
  intros S K M. destruct (Z_le_gt_dec 0 t) as [T|T].
  - assert (E := shifted_up m f g n (Z.to_nat t) S). rewrite INR_IZR_INZ, Z2Nat.id in E by lia. apply E; lia.
  - assert (S' : settles (m + Z.abs t) (fun i => f (i + t)%Z) g) by (intro i; split; intro H; apply S; lia).
    assert (E := shifted_up _ _ g n (Z.to_nat (- t)) S'). cbv beta in E. rewrite INR_IZR_INZ, Z2Nat.id, opp_IZR in E by lia.
    rewrite (over_ext n (fun i => f (i + - t + t)%Z) f) in E by (intro i; f_equal; lia). rewrite E by lia. ring.
Qed.

Lemma sum_list_prod {S U : Type} (f : S * U -> R) l k : sum f (list_prod l k) = sum (fun a => sum (fun b => f (a, b)) k) l.
Proof. induction l as [|a l IH]; simpl; [reflexivity|]. now rewrite sum_app, sum_map, IH. Qed.

Lemma two_of {S : Type} (f : S -> R) l a b : (forall s, In s l -> 0 <= f s) -> In a l -> In b l -> a <> b -> f a + f b <= sum f l.
Proof.
  intros N A B D. induction l as [|s l IH]; [destruct A|]. assert (Ns := N s (or_introl eq_refl)).
  assert (Nl : forall r, In r l -> 0 <= f r) by (intros r I; apply N; now right).
  assert (One : forall r, In r l -> f r <= sum f l).
  { clear - Nl. intros r I. induction l as [|q l IH]; [destruct I|]. simpl. assert (Nq := Nl q (or_introl eq_refl)).
    assert (0 <= sum f l) by (apply sum_nonneg; intros p J; apply Nl; now right).
    destruct I as [<-|I]; [lra|]. assert (f r <= sum f l); [apply IH; trivial; intros p J; apply Nl; now right|lra]. }
  simpl. destruct A as [<-|A], B as [<-|B]; [now elim D|generalize (One b B); lra|generalize (One a A); lra|].
  assert (f a + f b <= sum f l) by now apply IH. lra.
Qed.

Lemma multiple r D : 0 < D -> exists m, (0 <= m)%Z /\ Rabs r <= IZR m * D.
Proof.
  intro H. destruct (archimed (Rabs r / D)) as [U _]. exists (up (Rabs r / D)). assert (K : 0 <= Rabs r / D).
  { apply Rmult_le_pos; [apply Rabs_pos|]. now apply Rlt_le, Rinv_0_lt_compat. }
  split; [apply le_IZR; lra|]. apply Rlt_le. replace (Rabs r) with (Rabs r / D * D) at 1 by (field; lra). now apply Rmult_lt_compat_r.
Qed.

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

Lemma above_settles s : exists m, (0 <= m)%Z /\ settles m (above s) 1.
Proof.
  destruct (multiple (cross d z - cross d (spot s)) (det_2 L) box_positive) as (m & M & B). exists m. split; [exact M|].
  intro j. unfold above. rewrite height_moved. cbn [snd]. destruct (Rle_dec _ _) as [H|H]; split; intro J; try reflexivity; exfalso.
  - apply IZR_lt in J. assert (K := Rle_abs (cross d z - cross d (spot s))). nra.
  - apply IZR_lt in J. rewrite opp_IZR in J. assert (K := Rle_abs (- (cross d z - cross d (spot s)))). rewrite Rabs_Ropp in K. nra.
Qed.

Lemma above_moved t s j : above (moved_2 t s) j = above s (j + snd t)%Z.
Proof. unfold above. rewrite !height_moved. cbn [snd]. rewrite plus_IZR. destruct (Rle_dec _ _), (Rle_dec _ _); lra. Qed.

(* A side is crossed far ahead, never far behind. *)
Lemma turning_frame u v : turning u v z * det_2 L = (cross v (snd L) - cross z (snd L)) * (cross d z - cross d u) +
  (cross u (snd L) - cross z (snd L)) * (cross d v - cross d z).
Proof. unfold turning, turn, det_2, cross. ring. Qed.

Lemma passes_settle a b : exists m, (0 <= m)%Z /\
  forall j, settles m (fun i => passes d z (moved_spot (i, j) a) (moved_spot (i, j) b)) ((1 - above a j) * above b j).
Proof.
  destruct (multiple (cross z (snd L) - cross (spot a) (snd L)) (det_2 L) box_positive) as (m & M & B).
  destruct (multiple (cross z (snd L) - cross (spot b) (snd L)) (det_2 L) box_positive) as (m' & M' & B').
  exists (Z.max m m'). split; [lia|]. intros j i. cbv beta. unfold passes, above. generalize (turning_frame (moved_spot (i, j) a) (moved_spot (i, j) b)).
  rewrite !width_moved, !height_moved. cbn [fst snd]. intro E.
  assert (Far : (Z.max m m' < i)%Z -> 0 < cross (spot b) (snd L) + IZR i * det_2 L - cross z (snd L) /\ 0 < cross (spot a) (snd L) + IZR i *
  det_2 L - cross z (snd L)).
  { intro I. assert (I1 : IZR m < IZR i) by (apply IZR_lt; lia). assert (I2 : IZR m' < IZR i) by (apply IZR_lt; lia).
    assert (K := Rle_abs (cross z (snd L) - cross (spot a) (snd L))). assert (K' := Rle_abs (cross z (snd L) - cross (spot b) (snd L))). split; nra. }
  assert (Back : (i < - Z.max m m')%Z -> 0 < cross z (snd L) - (cross (spot b) (snd L) + IZR i * det_2 L) /\
  0 < cross z (snd L) - (cross (spot a) (snd L) + IZR i * det_2 L)).
  { intro I. assert (I1 : IZR i < - IZR m) by (rewrite <- opp_IZR; apply IZR_lt; lia).
    assert (I2 : IZR i < - IZR m') by (rewrite <- opp_IZR; apply IZR_lt; lia).
    assert (K := Rle_abs (- (cross z (snd L) - cross (spot a) (snd L)))). assert (K' := Rle_abs (- (cross z (snd L) - cross (spot b) (snd L)))).
    rewrite Rabs_Ropp in K, K'. split; nra. }
  destruct (Rle_dec (cross d (spot a) + IZR j * det_2 L) (cross d z)) as [Ha|Ha]; [|split; intros; lra].
  destruct (Rle_dec (cross d (spot b) + IZR j * det_2 L) (cross d z)) as [Hb|Hb]; [split; intros; lra|]. apply Rnot_le_lt in Hb.
  destruct (Rlt_dec 0 _) as [H|H]; split; intro I; try lra; exfalso.
  - destruct (Back I) as [Q1 Q2]. nra.
  - apply H. destruct (Far I) as [Q1 Q2]. apply Rmult_lt_reg_r with (det_2 L); [exact box_positive|]. rewrite E, Rmult_0_l. nra.
Qed.

Lemma crossing_settles a b : exists m, (0 <= m)%Z /\ forall j, settles m (fun i => side_crossing a b (i, j)) (above b j - above a j).
Proof.
  destruct (passes_settle a b) as (m & M & S), (passes_settle b a) as (m' & M' & S'). exists (Z.max m m'). split; [lia|].
  intros j i. unfold side_crossing, crossing. split; intro I.
  - rewrite (proj1 (S j i)), (proj1 (S' j i)) by lia. ring.
  - rewrite (proj2 (S j i)), (proj2 (S' j i)) by lia. ring.
Qed.

Lemma not_straddling a b i j : above a j = above b j -> side_crossing a b (i, j) = 0.
Proof.
  unfold above, side_crossing, crossing, passes. rewrite !height_moved. cbn [snd].
  repeat match goal with |- context [Rle_dec ?a ?b] => destruct (Rle_dec a b) end; intro; lra.
Qed.

(* ---- A side and what it is glued to ---- *)

Definition side_count (n : Z) (s : side_2) : R := over n (fun j => over n (fun i => side_crossing (fst s) (snd s) (i, j))).
Definition level (n : Z) (s : site_2) : R := over n (above s).

Lemma level_moved t s : eventually (fun n => level n (moved_2 t s) = level n s + IZR (snd t)).
Proof.
  destruct (above_settles s) as (m & M & S). exists (m + 2 * Z.abs (snd t) + 1)%Z. intros n K. unfold level.
  rewrite (over_ext n (above (moved_2 t s)) (fun j => above s (j + snd t)%Z)) by (intro; apply above_moved).
  rewrite (shifted m _ 1 n (snd t) S) by lia. ring.
Qed.

Lemma both_counted k : eventually (fun n => sum (side_count n) (both_sides_2 k) = - (IZR (fst (snd k)) * (level n (snd (fst k)) - level n (fst (fst k))))).
Proof.
  destruct k as ((a, b), t). cbn [fst snd both_sides_2 sum]. destruct (crossing_settles a b) as (m & M & S).
  destruct (above_settles a) as (ma & Ma & Sa), (above_settles b) as (mb & Mb & Sb).
  exists (Z.max m (Z.max ma mb) + 2 * Z.abs (fst t) + 2 * Z.abs (snd t) + 1)%Z. intros n K. unfold side_count. cbn [fst snd].
  set (A := fun j => over n (fun i => side_crossing a b (i, j))).
  assert (E : over n (fun j => over n (fun i => side_crossing (moved_2 t b) (moved_2 t a) (i, j)))
    = -1 * over n (fun j => A (j + snd t)%Z + IZR (fst t) * (above b (j + snd t)%Z - above a (j + snd t)%Z))).
  { rewrite <- over_scale. apply over_ext. intro j. unfold A. rewrite <- (shifted m _ _ n (fst t) (S (j + snd t)%Z)) by lia.
    rewrite <- over_scale. apply over_ext. intro i. unfold side_crossing. rewrite !moved_twice, crossing_swap. cbn [fst snd]. ring. }
  set (B := fun j => A j + IZR (fst t) * (above b j - above a j)).
  assert (Settled : settles (Z.max ma mb) B 0).
  { assert (Z : forall j, above a j = above b j -> B j = 0).
    { intros j Q. unfold B, A. rewrite (over_ext n _ (fun _ => 0)) by (intro i; now apply not_straddling). unfold over. rewrite sum_zero, Q. ring. }
    intro j. split; intro J; apply Z.
    - rewrite (proj1 (Sa j)), (proj1 (Sb j)) by lia. reflexivity.
    - rewrite (proj2 (Sa j)), (proj2 (Sb j)) by lia. reflexivity. }
  rewrite E. change (over n A + (-1 * over n (fun j => B (j + snd t)%Z) + 0) = - (IZR (fst t) * (level n b - level n a))).
  rewrite (shifted _ B 0 n (snd t) Settled) by lia. unfold B. rewrite over_plus, over_scale.
  rewrite (over_ext n (fun j => above b j - above a j) (fun j => above b j + -1 * above a j)) by (intro; ring).
  rewrite over_plus, over_scale. fold (level n a) (level n b). ring.
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

Lemma height_is s : eventually (fun n => level n s = snd (site_at (heights n) unit_box s)).
Proof.
  destruct s as (v, (i, j)). apply (eventually_impl (fun n => level n (moved_2 (i, j) (v, (0, 0)%Z)) = level n (v, (0, 0)%Z) + IZR j));
  [|apply level_moved].
  intros n E. cbn [moved_2 fst snd] in E. rewrite !Z.add_0_r in E. etransitivity; [exact E|]. unfold heights, unit_box. simpl. ring.
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

Theorem counted T : glued_torus_2 T -> eventually (fun n => 2 * sum (fun k => crossings_at (instance k)) (instances T n) = IZR (covers_2 T)).
Proof.
  intro G. assert (G' := G). destruct G' as (pairs & P).
  apply (eventually_impl (fun n => forall k, In k pairs -> 2 * sum (side_count n) (both_sides_2 k) = sum (trapezoid n) (both_sides_2 k))).
  - intros n H. rewrite count_by_sides, (covers_by_trapezoids T n G), !(sum_permutation _ _ _ P), !sum_flat_map, <- sum_scale. now apply sum_ext.
  - apply eventually_all. intro k.
    apply (eventually_impl (fun n => sum (side_count n) (both_sides_2 k) = - (IZR (fst (snd k)) * (level n (snd (fst k)) - level n (fst (fst k)))) /\
      level n (fst (fst k)) = snd (site_at (heights n) unit_box (fst (fst k))) /\
      level n (snd (fst k)) = snd (site_at (heights n) unit_box (snd (fst k))))).
    + intros n (E & A & B). rewrite E, trapezoids, A, B. ring.
    + apply eventually_and; [apply both_counted|]. apply eventually_and; apply height_is.
Qed.
End rays.
End placed.
