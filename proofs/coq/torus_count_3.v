(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* How often glued, positive cells cover each point of a periodic box of space: docs/theory.md 8.3. As torus_count.v.

   - counted_3   where no facet is along the first vector of the box, a point in general position is strictly inside covers_3 / 6 translates of cells

   The shadows of the facets in the plane of the other two vectors are triangles of a periodic box of the plane, and how often the translates of one cover
   the ray is a sum over its edges, of what torus_count.v counts (shadow_crossed). covers_by_pairs takes that for the areas of the shadows. *)
Require Import Reals ZArith Lra Lia Psatz List Permutation.
From Annulus Require Import tetrahedron sums torus_2 torus_3 torus_degree_3.
From Annulus Require plane_mesh plane_crossings space_mesh space_crossings space_line torus_frames.
From Annulus Require Import torus_count torus_frames_3 torus_powers_3 torus_ray_3.
Import ListNotations.
Open Scope R_scope.

Section placed.
Variables (x : nat -> vec) (L : box_3).
Hypothesis box_positive : 0 < det_3 L.
Notation spot := (site_at_3 x L).
Notation weight := (weight x L).
Notation six_of := (six_of x L).
Notation across := (across L).
Notation lean := (lean L).
Notation ray_of := (ray_of x L).
Notation hits_of := (hits_of x L).
Notation lean_of := (lean_of x L).
Notation within_reach_3 := (within_reach_3 x L).

(* ---- Shadows ---- *)

Definition shadow (p : vec) : point_2 := (second_place L p, third_place L p).
Definition flat (s : site_3) : site_2 := (fst s, (snd (fst (snd s)), snd (snd s))).
Definition flat_box : box_2 := ((det_3 L, 0), (0, det_3 L)).
Definition flat_places (n : nat) : point_2 := shadow (x n).

Lemma flat_box_positive : 0 < det_2 flat_box.
Proof. unfold det_2, flat_box. cbn [fst snd]. nra. Qed.

Lemma flat_spot s : site_at flat_places flat_box (flat s) = shadow (spot s).
Proof.
  destruct s as (n, ((i, j), k)). unfold site_at, flat, flat_places, flat_box, shadow, second_place, third_place, det_3, site_at_3, lattice_3.
  cbn [fst snd].
  generalize (x n) (L1 L) (L2 L) (L3 L). intros. f_equal; coordinates; ring.
Qed.

Lemma flat_moved t s : flat (moved_3 t s) = moved_2 (snd (fst t), snd t) (flat s).
Proof. now destruct t as ((t1, t2), t3), s as (n, ((i, j), k)). Qed.

Lemma shadow_turning a b y : turning (shadow a) (shadow b) (shadow y) = det_3 L * across y a b.
Proof. unfold turning, width_2.turn, shadow, second_place, third_place, det_3, torus_ray_3.across. cbn [fst snd]. generalize (L1 L) (L2 L)
  (L3 L). vector. Qed.

Lemma shadow_lean a b c : turning (shadow a) (shadow b) (shadow c) = det_3 L * lean a b c.
Proof. rewrite shadow_turning. unfold torus_ray_3.across, torus_ray_3.lean. generalize (L1 L). intro. f_equal. vector. Qed.

Lemma shadow_crossed y a b c : across y a b <> 0 -> across y b c <> 0 -> across y c a <> 0 -> lean a b c <> 0 ->
  plane_crossings.crossings (fst flat_box) (shadow y) (shadow a) (shadow b) (shadow c) = hits L y a b c * (2 * half (lean a b c)).
Proof.
  assert (D : fst (fst flat_box) <> 0 \/ snd (fst flat_box) <> 0) by (left; unfold flat_box; cbn [fst]; lra).
  assert (Left : forall a b c, across y a b <> 0 -> across y b c <> 0 -> across y c a <> 0 -> 0 < lean a b c ->
    plane_crossings.crossings (fst flat_box) (shadow y) (shadow a) (shadow b) (shadow c) = hits L y a b c).
  { clear a b c. intros a b c A B C P. destruct (plane_crossings.crossing_once (fst flat_box) (shadow y) (shadow a) (shadow b)
    (shadow c)) as (Z & In & Within);
      [rewrite shadow_lean; now apply Rmult_lt_0_compat|]. unfold plane_mesh.strictly_in, plane_mesh.within in *. rewrite !shadow_turning in In, Within.
    assert (F := lean_is L y a b c). destruct (hits_cases L y a b c) as [E|(E & [S|S])]; rewrite E.
    - destruct Z as [Z|Z]; [exact Z|exfalso]. destruct (Within Z) as (W1 & W2 & W3).
      assert (Pos : forall p, p <> 0 -> 0 <= det_3 L * p -> 0 < p) by (intros p N K; apply Rnot_le_lt; intro K'; nra).
      assert (P1 := Pos _ A W1). assert (P2 := Pos _ B W2). assert (P3 := Pos _ C W3). unfold hits, space_line.one_side in E.
      destruct (Rlt_dec 0 (across y a b)); [|lra]. destruct (Rlt_dec 0 (across y b c)); [|lra]. destruct (Rlt_dec 0 (across y c a)); lra.
    - apply In; [exact D|]. repeat split; apply Rmult_lt_0_compat; tauto.
    - exfalso. lra. }
  intros A B C N. destruct (Rdichotomy _ _ N) as [M|M].
  - assert (E := Left b a c). rewrite (across_back L y a b), (across_back L y c a), (across_back L y b c) in E.
    replace (lean b a c) with (- lean a b c) in E by (unfold torus_ray_3.lean; generalize (L1 L); vector).
    assert (H : hits L y b a c = hits L y a b c).
    { unfold hits. rewrite (across_back L y a b), (across_back L y c a), (across_back L y b c), space_crossings.one_side_neg.
      apply space_crossings.one_side_turned. }
    rewrite H in E. replace (plane_crossings.crossings (fst flat_box) (shadow y) (shadow a) (shadow b) (shadow c))
      with (- plane_crossings.crossings (fst flat_box) (shadow y) (shadow b) (shadow a) (shadow c)) by
      (unfold plane_crossings.crossings, plane_crossings.crossing; ring).
    rewrite E by (try apply Ropp_neq_0_compat; trivial; lra). rewrite space_crossings.half_nonzero by exact N. unfold space_line.pos.
    destruct (Rlt_dec 0 _); lra.
  - rewrite (Left a b c) by trivial. rewrite space_crossings.half_nonzero by exact N. unfold space_line.pos. destruct (Rlt_dec 0 _); lra.
Qed.

(* ---- A facet and what it is glued to ---- *)

Definition over_rows (n : Z) (f : Z -> Z -> R) : R := over n (fun k => over n (fun j => f j k)).
Definition facet_count (y : vec) (n : Z) (s : facet_3) : R := over_rows n (fun j k => over n (fun i => ray_of y (translate (i, j, k) s))).
Definition edge_count (y : vec) (n : Z) (a b : site_3) : R := side_count flat_places flat_box (shadow y) n (flat a, flat b).


Lemma ray_of_mate y t u a b c : ray_of y (translate u (moved_3 t b, moved_3 t a, moved_3 t c)) = - ray_of y (translate (sum_3 u t) (a, b, c)).
Proof. unfold torus_ray_3.ray_of, translate. rewrite !moved_twice_3. apply ray_back. Qed.

Lemma over_flat m n f t : settles m f 0 -> (0 <= m)%Z -> (m + 2 * Z.abs t < n)%Z -> over n (fun j => f (j + t)%Z) = over n f.
Proof. intros S M K. rewrite (shifted m f 0 n t S) by lia. ring. Qed.

Lemma facet_pair y m n k : let '((a, b, c), t) := k in (forall s, In s [a; b; c] -> within_reach_3 y m s) -> lean (spot a) (spot b) (spot c) <> 0 ->
  (0 <= m)%Z ->
  (m + 2 * Z.abs (fst (fst t)) + 2 * Z.abs (snd (fst t)) + 2 * Z.abs (snd t) < n)%Z ->
  sum (facet_count y n) (both_sides_3 k) = IZR (fst (fst t)) * over_rows n (fun j k => hits_of y (translate (0%Z, j, k)
  (a, b, c)) * (2 * half (lean (spot a) (spot b) (spot c)))).
Proof.
  destruct k as (((a, b), c), ((t1, t2), t3)). cbn [fst snd both_sides_3 sum]. intros W N M K.
  set (s := (a, b, c)). set (g := fun j k => hits_of y (translate (0%Z, j, k) s) * (2 * half (lean (spot a) (spot b) (spot c)))).
  assert (S := ray_settles x L box_positive y m s W N). change (torus_ray_3.lean_of x L s) with (lean (spot a) (spot b) (spot c)) in S.
  set (A := fun j k => over n (fun i => ray_of y (translate (i, j, k) s))). set (B := fun j k => A j k + IZR t1 * - g j k).
  assert (E : facet_count y n (moved_3 (t1, t2, t3) b, moved_3 (t1, t2, t3) a, moved_3 (t1, t2, t3) c) = -1 * over_rows n (fun j k => B (j +
  t2)%Z (k + t3)%Z)).
  { unfold facet_count, over_rows. rewrite <- over_scale. apply over_ext. intro k. rewrite <- over_scale. apply over_ext. intro j.
    assert (Sh := shifted m _ _ n t1 (S (j + t2)%Z (k + t3)%Z) ltac:(lia) M). cbv beta in Sh. unfold B, A, g. rewrite <- Sh, <- over_scale.
    apply over_ext. intro i. rewrite ray_of_mate. cbn [sum_3]. fold s. ring. }
  assert (Zero : forall j k, (m < Z.abs j \/ m < Z.abs k)%Z -> B j k = 0).
  { intros j k F. assert (H := ray_misses x L box_positive y m s j k W F). unfold B, g. rewrite H. unfold A.
    rewrite (over_ext n _ (fun _ => 0)); [unfold over; rewrite sum_zero; ring|]. intro i. assert (Hi := hits_moved x L y i j k s). rewrite H in Hi.
    subst s.
    unfold torus_ray_3.ray_of, translate, ray. unfold torus_ray_3.hits_of, translate in Hi. rewrite Hi. ring. }
  rewrite E. unfold over_rows at 1. rewrite (over_flat m n (fun k => over n (fun j => B (j + t2)%Z k)) t3).
  - transitivity (facet_count y n s + (-1 * over_rows n B + 0)).
    + f_equal. f_equal. f_equal. unfold over_rows. apply over_ext. intro k. apply (over_flat m n (fun j => B j k) t2); [|lia|lia].
      intro j. split; intro J; apply Zero; lia.
    + unfold over_rows, B. replace (facet_count y n s) with (over_rows n A) by reflexivity. unfold over_rows.
      rewrite (over_ext n (fun k => over n (fun j => A j k + IZR t1 * - g j k)) (fun k => over n (fun j => A j k) + - IZR t1 * over n (fun j => g j k))).
      * rewrite over_plus, over_scale. ring.
      * intro k. rewrite <- over_scale, <- over_plus. apply over_ext. intro j. ring.
  - intro k. split; intro J; (rewrite (over_ext n _ (fun _ => 0)); [unfold over; apply sum_zero|]); intro j; apply Zero; lia.
  - exact M.
  - lia.
Qed.

Lemma around_edges y n a b c : (forall j k, In j (torus_powers.up_to n) -> In k (torus_powers.up_to n) -> generic_edges x L y (translate (0%Z, j, k)
  (a, b, c))) ->
  lean (spot a) (spot b) (spot c) <> 0 ->
  over_rows n (fun j k => hits_of y (translate (0%Z, j, k) (a, b, c)) * (2 * half (lean (spot a) (spot b) (spot c)))) = around (edge_count y n) (a, b, c).
Proof.
  intros G N. unfold around, edge_count, side_count, over_rows. cbn [fst snd]. rewrite <- !over_plus. unfold over. apply sum_ext. intros k Ik.
  rewrite <- !sum_plus. apply sum_ext. intros j Ij. destruct (G j k Ij Ik) as (A & B & C). set (t := (0%Z, j, k)) in *.
  assert (Le := lean_moved x L t (a, b, c)). unfold torus_ray_3.lean_of, translate in Le. rewrite <- Le in N |- *. unfold torus_ray_3.hits_of, translate.
  rewrite <- shadow_crossed by trivial. unfold side_crossing. unfold torus_frames.spot. change (j, k) with (snd (fst t), snd t).
  rewrite <- !flat_moved, !flat_spot.
  unfold plane_crossings.crossings. ring.
Qed.

Lemma edge_count_back y n a b : edge_count y n b a = - edge_count y n a b.
Proof. apply side_count_back. Qed.

Definition flat_levels (y : vec) (n : Z) (h : nat) : R := level flat_places flat_box (shadow y) n (h, (0, 0)%Z).

Lemma edges_move y m n t a b : (forall s, In s [a; b; (fst a, (0, 0, 0)%Z); (fst b, (0, 0, 0)%Z)] ->
  within_reach flat_places flat_box (shadow y) m (flat s)) -> (0 <= m)%Z ->
  (m + 2 * Z.abs (snd (fst t)) + 2 * Z.abs (snd t) + 2 * Z.abs (snd (snd a)) + 2 * Z.abs (snd (snd b)) < n)%Z ->
  moves_along (flat_levels y n) (edge_count y n) t a b.
Proof.
  intros W M K. unfold moves_along, edge_count. rewrite !flat_moved.
  assert (Lv : forall s, within_reach flat_places flat_box (shadow y) m (flat (fst s, (0, 0, 0)%Z)) -> (m + 2 * Z.abs (snd (snd s)) < n)%Z ->
    level flat_places flat_box (shadow y) n (flat s) = third_of (flat_levels y n) s).
  { intros (h, ((i, j), k)) Ws Ks. unfold flat in *. cbn [fst snd] in *. unfold flat_levels, third_of.
    assert (E := level_moved flat_places flat_box flat_box_positive (shadow y) m n (j, k) (h, (0, 0)%Z) Ws M Ks). cbn [moved_2 fst snd] in E.
    now rewrite !Z.add_0_r in E. }
  rewrite (side_moved flat_places flat_box flat_box_positive (shadow y) m n (snd (fst t), snd t) (flat a) (flat b)); cbn [fst snd].
  - rewrite (Lv a), (Lv b); [reflexivity|apply W; simpl; tauto|lia|apply W; simpl; tauto|lia].
  - apply W. simpl. tauto.
  - apply W. simpl. tauto.
  - exact M.
  - lia.
Qed.

(* ---- All cells, and all points that are near enough ---- *)

Definition near_3 (r : R) (y : vec) : Prop := Rabs (first_place L y) <= r /\ Rabs (second_place L y) <= r /\ Rabs (third_place L y) <= r.

Lemma reached_3 r s : eventually (fun m => forall y, near_3 r y -> within_reach_3 y m s).
Proof.
  set (q := Rabs r + Rabs (first_place L (spot s)) + Rabs (second_place L (spot s)) + Rabs (third_place L (spot s))).
  destruct (multiple q (det_3 L) box_positive) as (m & M & B). exists m. intros n N y (F & S & T). apply IZR_le in N.
  assert (N' : IZR m * det_3 L <= IZR n * det_3 L) by (apply Rmult_le_compat_r; lra).
  assert (P1 := Rabs_pos (first_place L (spot s))). assert (P2 := Rabs_pos (second_place L (spot s))). assert (P3 := Rabs_pos (third_place L (spot s))).
  assert (P0 := Rabs_pos r). assert (Rr := Rle_abs r). rewrite (Rabs_pos_eq q) in B by (unfold q; lra). unfold q in B.
  assert (Far : forall p p', Rabs p <= r -> Rabs p' <= Rabs (first_place L (spot s)) + Rabs (second_place L (spot s)) + Rabs (third_place L (spot s)) ->
    Rabs (p - p') <= IZR n * det_3 L).
  { intros p p' A A'. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra. }
  repeat split.
  - replace (first_place L (y ⊖ spot s)) with (first_place L y - first_place L (spot s)) by (unfold first_place; generalize (spot s) (L2 L) (L3 L);
    vector). apply Far; lra.
  - replace (second_place L (y ⊖ spot s)) with (second_place L y - second_place L (spot s)) by (unfold second_place; generalize (spot s) (L1 L)
    (L3 L); vector). apply Far; lra.
  - replace (third_place L (y ⊖ spot s)) with (third_place L y - third_place L (spot s)) by (unfold third_place; generalize (spot s) (L1 L) (L2 L);
    vector). apply Far; lra.
Qed.

Lemma flat_reach y m s : within_reach_3 y m s -> within_reach flat_places flat_box (shadow y) m (flat s).
Proof.
  intros (_ & S & T). unfold within_reach, torus_frames.spot. rewrite flat_spot. unfold flat_box, shadow, plane_mesh.cross, det_2. cbn [fst snd].
  split.
  - replace (_ - _) with (det_3 L * third_place L (y ⊖ spot s)) by (unfold third_place; generalize (spot s) (L1 L) (L2 L); vector).
    rewrite Rabs_mult, Rabs_pos_eq by lra. nra.
  - replace (_ - _) with (det_3 L * second_place L (y ⊖ spot s)) by (unfold second_place; generalize (spot s) (L1 L) (L3 L); vector).
    rewrite Rabs_mult, Rabs_pos_eq by lra. nra.
Qed.

Lemma translate_turned t s s' : turned_facet s s' -> turned_facet (translate t s) (translate t s').
Proof. intros []; constructor. Qed.

Lemma facet_count_turned y n s s' : turned_facet s s' -> facet_count y n s' = facet_count y n s.
Proof.
  intro H. unfold facet_count, over_rows. apply over_ext. intro k. apply over_ext. intro j. apply over_ext. intro i. apply ray_of_turned.
  now apply translate_turned.
Qed.

Lemma generic_turned y s s' : turned_facet s s' -> generic_edges x L y s -> generic_edges x L y s'.
Proof. intros []; unfold generic_edges; tauto. Qed.

Lemma leans_turned s s' : turned_facet s s' -> leans x L s -> leans x L s'.
Proof.
  intros []; unfold leans, torus_ray_3.lean; trivial; intros N E; apply N; rewrite <- E; generalize (spot a) (spot b) (spot c) (L1 L); vector.
Qed.

Lemma facets_moved t c : facets_3 (moved_cell_3 t c) = map (translate t) (facets_3 c).
Proof. now destruct c as (((a, b), c), d). Qed.

Lemma instances_by_facets y T n : sum (fun k => sum (ray_of y) (facets_3 (instance_3 k))) (instances_3 T n) = sum (fun c => sum (facet_count y n)
  (facets_3 c)) T.
Proof.
  unfold instances_3. rewrite sum_list_prod. apply sum_ext. intros c _.
  transitivity (over n (fun i => over n (fun j => over n (fun k => sum (fun s => ray_of y (translate (i, j, k) s)) (facets_3 c))))).
  - rewrite (sum_list_prod (fun t => sum (ray_of y) (facets_3 (instance_3 (c, t))))), sum_list_prod. unfold over. apply sum_ext. intros i _.
    apply sum_ext. intros j _.
    apply sum_ext. intros k _. unfold instance_3. cbn [fst snd]. rewrite facets_moved. apply sum_map.
  - unfold facet_count, over_rows, over.
    rewrite (sum_ext _ (fun i => sum (fun j => sum (fun s => sum (fun k => ray_of y (translate (i, j, k) s)) (torus_powers.up_to n)) (facets_3 c))
    (torus_powers.up_to n)))
      by (intros i _; apply sum_ext; intros j _; apply sum_swap).
    rewrite (sum_ext _ (fun i => sum (fun s => sum (fun j => sum (fun k => ray_of y (translate (i, j, k) s)) (torus_powers.up_to n))
    (torus_powers.up_to n)) (facets_3 c)))
      by (intros i _; apply sum_swap).
    rewrite sum_swap. apply sum_ext. intros s _.
    rewrite (sum_ext _ (fun i => sum (fun k => sum (fun j => ray_of y (translate (i, j, k) s)) (torus_powers.up_to n)) (torus_powers.up_to n))) by
    (intros i _; apply sum_swap).
    rewrite sum_swap. apply sum_ext. intros k _. apply sum_swap.
Qed.

Theorem counted_3 r T : glued_torus_3 T -> positive_torus_3 x L T -> (forall c s, In c T -> In s (facets_3 c) -> leans x L s) ->
  eventually (fun n => forall y, near_3 r y -> (forall k, In k (instances_3 T n) -> generic_ray x L y (instance_3 k)) ->
    6 * sum (fun k => space_line.inside_all (weight (instance_3 k) y)) (instances_3 T n) = IZR (covers_3 T)).
Proof.
  intros (l & pairs & F & P) Pos Lean.
  assert (Ev : eventually (fun n => (0 <= n)%Z /\ forall k, In k pairs -> forall y, near_3 r y ->
    (forall j h, In j (torus_powers.up_to n) -> In h (torus_powers.up_to n) -> generic_edges x L y (translate (0%Z, j, h) (fst k))) -> leans x L (fst k) ->
    sum (facet_count y n) (both_sides_3 k) = IZR (fst (fst (snd k))) * around (edge_count y n) (fst k) /\ moves_so (flat_levels y n) (edge_count y n) k)).
  { apply eventually_and; [exists 0%Z; now intros|]. apply eventually_all. intros (((a, b), c), ((t1, t2), t3)).
    destruct a as (va, ((a1, a2), a3)), b as (vb, ((b1, b2), b3)), c as (vc, ((c1, c2), c3)).
    assert (E := eventually_and _ _ (eventually_and _ _ (reached_3 r (va, (a1, a2, a3))) (reached_3 r (va, (0, 0, 0)%Z)))
      (eventually_and _ _ (eventually_and _ _ (reached_3 r (vb, (b1, b2, b3))) (reached_3 r (vb, (0, 0, 0)%Z)))
        (eventually_and _ _ (reached_3 r (vc, (c1, c2, c3))) (reached_3 r (vc, (0, 0, 0)%Z))))).
    destruct E as (m & W). set (m' := Z.max 0 m).
    exists (m' + 2 * Z.abs t1 + 2 * Z.abs t2 + 2 * Z.abs t3 + 2 * Z.abs a3 + 2 * Z.abs b3 + 2 * Z.abs c3 + 1)%Z.
    intros n K y N Gen Ln. destruct (W m') as ((Wa & Wa') & (Wb & Wb') & (Wc & Wc')); [lia|].
    specialize (Wa y N). specialize (Wa' y N). specialize (Wb y N). specialize (Wb' y N). specialize (Wc y N). specialize (Wc' y N).
    cbn [fst snd] in *. split.
    - assert (Q := facet_pair y m' n ((va, (a1, a2, a3)), (vb, (b1, b2, b3)), (vc, (c1, c2, c3)), (t1, t2, t3))). cbn [fst snd] in Q.
      etransitivity; [apply Q; [intros s [<-|[<-|[<-|[]]]]; assumption|exact Ln|lia|lia]|]. f_equal. now apply around_edges.
    - repeat split; (apply (edges_move y m' n (t1, t2, t3)); [intros s [<-|[<-|[<-|[<-|[]]]]]; apply flat_reach; assumption|lia|cbn [fst snd]; lia]). }
  apply (eventually_impl _ _) with (2 := Ev). clear Ev. cbv beta. intros n (Nn & H) y N Gen.
  assert (Of : forall k, In k pairs -> exists c s, In c T /\ In s (facets_3 c) /\ turned_facet s (fst k)).
  { intros (f, t) I. destruct (forall2_right _ _ _ f F) as (s & Is & Ts).
    - apply (Permutation_in _ (Permutation_sym P)). apply in_flat_map. exists (f, t). split; [exact I|]. destruct f as ((a, b), c). simpl. tauto.
    - apply in_flat_map in Is. destruct Is as (c & Ic & Is). now exists c, s. }
  assert (All : forall k, In k pairs -> sum (facet_count y n) (both_sides_3 k) = IZR (fst (fst (snd k))) * around (edge_count y n) (fst k) /\
    moves_so (flat_levels y n) (edge_count y n) k).
  { intros k I. destruct (Of k I) as (c & s & Ic & Is & Ts). apply (H k I y N).
    - intros j h Ij Ih. apply (generic_turned y (translate (0%Z, j, h) s)); [now apply translate_turned|].
      assert (Ik : In (c, (0%Z, j, h)) (instances_3 T n)).
      { apply in_prod; [exact Ic|]. apply in_prod; [apply in_prod|]; trivial. apply torus_powers.in_up_to. simpl. lia. }
      destruct (Gen _ Ik) as [_ E]. apply E. unfold instance_3. cbn [fst snd]. rewrite facets_moved. now apply in_map.
    - apply (leans_turned s); [exact Ts|]. now apply (Lean c). }
  rewrite (covers_by_pairs (flat_levels y n) (edge_count y n)) with (l := l) (pairs := pairs); trivial; [|intros; apply edge_count_back|intros k I;
  now apply All].
  f_equal. transitivity (sum (fun k => sum (ray_of y) (facets_3 (instance_3 k))) (instances_3 T n)).
  - apply sum_ext. intros k Ik. assert (I := of_instances_3 _ _ _ Ik). symmetry. apply (ray_cell x L).
    + unfold instance_3. rewrite six_moved. now apply Pos.
    + now apply Gen.
    + intros s Is. unfold instance_3 in Is. rewrite facets_moved in Is. apply in_map_iff in Is. destruct Is as (s0 & <- & I0).
      assert (Q := lean_moved x L (snd k) s0). assert (Q0 := Lean _ _ I I0). destruct s0 as ((a, b), c). unfold leans, lean_of, translate in *.
      now rewrite Q.
  - rewrite instances_by_facets, (sum_by_pairs (facet_count y n) T l pairs (facet_count_turned y n) F P). apply sum_ext. intros k I. now apply All.
Qed.
End placed.
