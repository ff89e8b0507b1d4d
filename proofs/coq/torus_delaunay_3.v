(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* From local to global in a periodic box of space: docs/theory.md 8.3.

   - torus_covered_3    glued, positive, of degree 1: each point is in a translate of a cell
   - torus_disjoint_3   and a point strictly inside one is in no other
   - torus_delaunay_3   if besides it is locally Delaunay, ties or not, no vertex is strictly inside the sphere of a cell *)
Require Import Reals ZArith Lra Lia Psatz List Permutation.
From Annulus Require Import tetrahedron small sums general_position torus_2 torus_3.
From Annulus Require space_crossings space_embedding space_line.
From Annulus Require Import torus_count torus_frames_3 torus_powers_3 torus_walk_3 torus_ray_3 torus_count_3 torus_rebased_3.
Import ListNotations.
Open Scope R_scope.

(* ---- No facet along the first vector ---- *)

Section leaning.
Variables (x : nat -> vec) (L : box_3).
Hypothesis box_positive : 0 < det_3 L.
Variable T : list torus_cell_3.
Hypothesis gluing : glued_torus_3 T.
Hypothesis cells_positive : positive_torus_3 x L T.
Hypothesis once : covers_3 T = 6%Z.
Hypothesis leaning : forall c s, In c T -> In s (facets_3 c) -> leans x L s.
Notation weight := (weight x L).
Notation in_torus_cell_3 := (in_torus_cell_3 x L).
Notation inside_torus_cell_3 := (inside_torus_cell_3 x L).

Lemma six_of_instance k : In (fst k) T -> 0 < six_of x L (instance_3 k).
Proof. intro I. unfold instance_3. rewrite six_moved. now apply cells_positive. Qed.

Lemma near_bounded f z g : affine f -> small (fun e => Rabs (f (curve z g e)) <= Rabs (f z) + 1).
Proof.
  intro A. assert (B := Rle_abs (f z)). assert (B' := Rle_abs (- f z)). rewrite Rabs_Ropp in B'. destruct A as (n & k & F).
  assert (S1 : small (fun e => 0 < Rabs (f z) + 1 - f (curve z g e))).
  { apply (near_positive (fun p => Rabs (f z) + 1 - f p)); [exists (-1 ⊙ n), (Rabs (f z) + 1 - k); intro p; rewrite (F p); vector|left; lra]. }
  assert (S2 : small (fun e => 0 < Rabs (f z) + 1 + f (curve z g e))).
  { apply (near_positive (fun p => Rabs (f z) + 1 + f p)); [exists n, (Rabs (f z) + 1 + k); intro p; rewrite (F p); vector|left; lra]. }
  apply (small_impl _ _) with (2 := small_and _ _ S1 S2). intros e _ [H H']. apply Rabs_le. lra.
Qed.

Lemma near_generic z g n : small (fun e => forall k, In k (instances_3 T n) -> generic_ray x L (curve z g e) (instance_3 k)).
Proof.
  apply small_all. intros k Ik. assert (I := of_instances_3 _ _ _ Ik). assert (P := six_of_instance k I).
  assert (S1 : small (fun e => forall i, In i space_line.corner_list -> weight (instance_3 k) (curve z g e) i <> 0)).
  { apply small_all. intros i _. apply (near_nonzero (fun p => weight (instance_3 k) p i)); [apply space_crossings.bary_affine|].
    exists (middle_3 x L (instance_3 k)). generalize (middle_inside_3 x L (instance_3 k) P i). lra. }
  assert (S2 : small (fun e => forall s, In s (facets_3 (instance_3 k)) -> generic_edges x L (curve z g e) s)).
  { apply small_all. intros s Is. unfold instance_3 in Is. rewrite facets_moved in Is. apply in_map_iff in Is. destruct Is as (s0 & <- & I0).
    assert (N : lean_of x L (translate (snd k) s0) <> 0) by (rewrite lean_moved; assert (Q := leaning _ _ I I0); destruct s0 as ((a, b), c); exact Q).
    destruct s0 as ((a, b), c). unfold lean_of, translate in N. cbn [translate]. unfold generic_edges.
    set (A := site_at_3 x L (moved_3 (snd k) a)) in *. set (B := site_at_3 x L (moved_3 (snd k) b)) in *.
    set (C := site_at_3 x L (moved_3 (snd k) c)) in *.
    assert (Af : forall p q, affine (fun y => across L y p q)).
    { intros p q. exists (L1 L ✕ (q ⊖ p)), (vol (L1 L) p q). intro y. unfold across. generalize (L1 L). vector. }
    assert (E : forall p q s, lean L p q s <> 0 -> exists y, across L y p q <> 0).
    { intros p q s' K. exists s'. replace (across L s' p q) with (lean L p q s'); [exact K|]. unfold lean, across. generalize (L1 L). vector. }
    apply small_and; [|apply small_and]; (apply (near_nonzero (fun y => across L y _ _)); [apply Af|]).
    - now apply (E _ _ C).
    - apply (E _ _ A). replace (lean L B C A) with (lean L A B C); [exact N|]. unfold lean. generalize (L1 L). vector.
    - apply (E _ _ B). replace (lean L C A B) with (lean L A B C); [exact N|]. unfold lean. generalize (L1 L). vector. }
  apply (small_impl _ _) with (2 := small_and _ _ S1 S2). intros e _ [H H']. split; [|exact H']. intro i. apply H, space_line.in_corners.
Qed.

(* Points near y in general position are in one of finitely many translates. *)
Lemma near_once y : exists n0, forall n, (n0 <= n)%Z -> forall g, small (fun e => sum (fun k => space_line.inside_all (weight (instance_3 k)
  (curve y g e))) (instances_3 T n) = 1).
Proof.
  set (r := Rabs (first_place L y) + Rabs (second_place L y) + Rabs (third_place L y) + 1).
  destruct (counted_3 x L box_positive r T gluing cells_positive leaning) as (n0 & H). exists n0. intros n N g.
  assert (A1 : affine (first_place L)) by (exists (L2 L ✕ L3 L), 0; intro p; unfold first_place; generalize (L2 L) (L3 L); vector).
  assert (A2 : affine (second_place L)) by (exists (L3 L ✕ L1 L), 0; intro p; unfold second_place; generalize (L1 L) (L3 L); vector).
  assert (A3 : affine (third_place L)) by (exists (L1 L ✕ L2 L), 0; intro p; unfold third_place; generalize (L1 L) (L2 L); vector).
  apply (small_impl _ _) with (2 := small_and _ _ (near_generic y g n) (small_and _ _ (near_bounded _ y g A1) (small_and _ _ (near_bounded _ y g A2)
  (near_bounded _ y g A3)))).
  intros e _ (G & B1 & B2 & B3). specialize (H n N (curve y g e)). rewrite once in H. assert (Nr : near_3 L r (curve y g e)).
  { assert (P1 := Rabs_pos (first_place L y)). assert (P2 := Rabs_pos (second_place L y)). assert (P3 := Rabs_pos (third_place L y)). unfold r.
    repeat split; lra. }
  specialize (H Nr G). lra.
Qed.

Lemma disjoint_leaning y k k' : In (fst k) T -> In (fst k') T -> inside_torus_cell_3 y (instance_3 k) -> in_torus_cell_3 y (instance_3 k') -> k = k'.
Proof.
  intros I I' H H'. assert (dec : {k = k'} + {k <> k'}) by (repeat decide equality). destruct dec as [E|D]; [exact E|exfalso].
  assert (M := middle_inside_3 x L _ (six_of_instance k' I')). set (g := middle_3 x L (instance_3 k')) in M.
  destruct (near_once y) as (n0 & Once). destruct k as (c, ((p, q), s)), k' as (c', ((p', q'), s')).
  set (n := Z.max n0 (Z.max (Z.max (Z.abs p) (Z.max (Z.abs q) (Z.abs s))) (Z.max (Z.abs p') (Z.max (Z.abs q') (Z.abs s'))))).
  assert (J : In (c, (p, q, s)) (instances_3 T n)) by (apply in_instances_3; [exact I|lia]).
  assert (J' : In (c', (p', q', s')) (instances_3 T n)) by (apply in_instances_3; [exact I'|lia]).
  assert (N1 : small (fun e => inside_torus_cell_3 (curve y g e) (instance_3 (c, (p, q, s))))) by (apply near_inside_torus; intro i; left; apply H).
  assert (N2 : small (fun e => inside_torus_cell_3 (curve y g e) (instance_3 (c', (p', q', s'))))).
  { apply near_inside_torus. intro i. destruct (H' i) as [K|K]; [now left|right]. split; [now symmetry|apply M]. }
  destruct (small_exists _ (small_and _ _ (Once n ltac:(lia) g) (small_and _ _ N1 N2))) as (e & _ & E & K1 & K2).
  assert (Two := two_of (fun k => space_line.inside_all (weight (instance_3 k) (curve y g e))) (instances_3 T n) (c, (p, q, s)) (c', (p', q', s'))
    (fun k _ => space_embedding.inside_nonneg _) J J' D). cbv beta in Two.
  assert (O1 := space_embedding.inside_one _ K1). assert (O2 := space_embedding.inside_one _ K2). lra.
Qed.

Lemma covered_leaning y : exists k, In (fst k) T /\ in_torus_cell_3 y (instance_3 k).
Proof.
  destruct (near_once y) as (n0 & Once). specialize (Once n0 ltac:(lia) y).
  assert (Or : forall l, (forall k, In k l -> In (fst k) T) -> (exists k, In (fst k) T /\ in_torus_cell_3 y (instance_3 k)) \/
    small (fun e => forall k, In k l -> space_line.inside_all (weight (instance_3 k) (curve y y e)) = 0)).
  { induction l as [|k l IH]; intro A; [right; exists 1; split; [lra|easy]|]. destruct (some_negative x L y (instance_3 k)) as [In_|(i & N)].
    - left. exists k. split; [apply A; now left|exact In_].
    - destruct IH as [K|S]; [intros k' J; apply A; now right|now left|right].
      assert (S' : small (fun e => weight (instance_3 k) (curve y y e) i < 0)).
      { apply (small_impl (fun e => 0 < -1 * weight (instance_3 k) (curve y y e) i + 0 * weight (instance_3 k) (curve y y e) i)); [intros; lra|].
        apply (near_positive (fun p => -1 * weight (instance_3 k) p i + 0 * weight (instance_3 k) p i)); [apply affine_sum;
        apply space_crossings.bary_affine|left; lra]. }
      apply (small_impl _ _) with (2 := small_and _ _ S S'). intros e _ [K K'] k' [<-|J]; [exact (space_embedding.inside_none _ i K')|now apply K]. }
  destruct (Or (instances_3 T n0) (of_instances_3 T n0)) as [K|S]; [exact K|exfalso].
  destruct (small_exists _ (small_and _ _ Once S)) as (e & _ & E & Z). rewrite (sum_ext _ (fun _ => 0)), sum_zero in E; [lra|exact Z].
Qed.
End leaning.

(* ---- Any mesh ---- *)

Section placed.
Variables (x : nat -> vec) (L : box_3).
Hypothesis box_positive : 0 < det_3 L.
Notation spot := (site_at_3 x L).
Notation in_torus_cell_3 := (in_torus_cell_3 x L).
Notation inside_torus_cell_3 := (inside_torus_cell_3 x L).
Notation power_3 := (power_3 x L).

(* Glued, positive, of degree 1. *)
Definition covers_once_3 (T : list torus_cell_3) : Prop := glued_torus_3 T /\ positive_torus_3 x L T /\ sum (torus_volume x L) T = 6 * det_3 L.
(* No vertex, wherever a translate of it is, is strictly inside the sphere of a cell. *)
Definition spheres_empty (T : list torus_cell_3) : Prop := forall c, In c T -> exists m r2, (forall s, is_corner_3 s c -> sq (spot s ⊖ m) = r2) /\
  forall s, torus_vertex_3 T (fst s) -> r2 <= sq (spot s ⊖ m).

Lemma degree_one_3 T : covers_once_3 T -> covers_3 T = 6%Z.
Proof. intros (G & _ & A). rewrite (degree_3 T G) in A. apply eq_IZR. apply Rmult_eq_reg_r with (det_3 L); lra. Qed.

Theorem torus_disjoint_3 T y k k' : covers_once_3 T -> In (fst k) T -> In (fst k') T ->
  inside_torus_cell_3 y (instance_3 k) -> in_torus_cell_3 y (instance_3 k') -> k = k'.
Proof.
  intros C I I' H H'. assert (O := degree_one_3 T C). destruct C as (G & P & _). destruct (along_nothing x L T box_positive P) as (p & Lean).
  destruct (rebased_cells p x L T G P) as (G' & P' & C'). apply (new_instance_back p).
  apply (disjoint_leaning x (new_box p L) (eq_ind_r (fun d => 0 < d) box_positive (new_det p L)) (map (new_cell p) T) G' P' (eq_trans C' O) Lean y).
  - exact (in_map (new_cell p) T (fst k) I).
  - exact (in_map (new_cell p) T (fst k') I').
  - rewrite new_instance_is. intro i. rewrite new_weight. apply H.
  - rewrite new_instance_is. intro i. rewrite new_weight. apply H'.
Qed.

Lemma old_offset p t : exists t', combined_offset (new_basis p) t' = t.
Proof.
  destruct t as ((i, j), k). exists (i, j + i * p, k + i * (p * p))%Z. unfold combined_offset, new_basis. cbn [m1 m2 m3].
  apply f_equal2; [apply f_equal2|]; ring.
Qed.

Theorem torus_covered_3 T y : covers_once_3 T -> exists k, In (fst k) T /\ in_torus_cell_3 y (instance_3 k).
Proof.
  intro C. assert (O := degree_one_3 T C). destruct C as (G & P & _). destruct (along_nothing x L T box_positive P) as (p & Lean).
  destruct (rebased_cells p x L T G P) as (G' & P' & C').
  destruct (covered_leaning x (new_box p L) (eq_ind_r (fun d => 0 < d) box_positive (new_det p L))
  (map (new_cell p) T) G' P' (eq_trans C' O) Lean y) as ((c', t') & I & H).
  cbn [fst] in I. apply in_map_iff in I. destruct I as (c & <- & I). destruct (old_offset p t') as (t & <-). exists (c, t). split; [exact I|].
  intro i. assert (K := H i). change (new_cell p c, combined_offset (new_basis p) t) with (new_instance p (c, t)) in K.
  rewrite new_instance_is, new_weight in K. exact K.
Qed.

Theorem torus_delaunay_3 T : covers_once_3 T -> locally_delaunay_torus_3 x L T -> spheres_empty T.
Proof.
  intros C D c I. assert (C0 := C). destruct C as (G & P & _). destruct (has_sphere x L c (P c I)) as (m & r2 & On). exists m, r2. split; [exact On|].
  intros s (c0 & s0 & I0 & K0 & V).
  assert (Sh : exists u, moved_3 u s0 = s).
  { destruct s as (n, ((i, j), k)), s0 as (n0, ((i0, j0), k0)). cbn [fst] in V. subst n0. exists (i - i0, j - j0, k - k0)%Z. cbn [moved_3].
    apply f_equal2; [reflexivity|]. apply f_equal2; [apply f_equal2|]; ring. }
  destruct Sh as (t & M). assert (P0 : 0 < six_of x L (instance_3 (c0, t))) by (unfold instance_3; rewrite six_moved; now apply P).
  assert (K : is_corner_3 s (instance_3 (c0, t))).
  { rewrite <- M. destruct c0 as (((a, b), c'), d). unfold instance_3. cbn [fst snd moved_cell_3]. destruct K0 as [->|[->|[->| ->]]]; simpl; tauto. }
  destruct (has_sphere x L _ P0) as (m0 & r0 & On0). assert (Z := power_at_corner_3 x L s _ P0 K).
  assert (Mid := middle_inside_3 x L _ P0). set (g := middle_3 x L (instance_3 (c0, t))) in Mid.
  assert (In_ : in_torus_cell_3 (spot s) (instance_3 (c0, t))).
  { destruct (instance_3 (c0, t)) as (((a, b), c'), d). intro i. unfold weight.
    assert (E : exists j, spot s = places x L (a, b, c', d) (space_crossings.point_of t0 j)) by (destruct K as [->|[->|[->| ->]]];
    [exists o|exists u|exists v|exists w]; reflexivity).
    destruct E as (j & ->). rewrite space_crossings.bary_corner, size_is. destruct (space_line.corner_dec i j); lra. }
  assert (Near : small (fun e => inside_torus_cell_3 (curve (spot s) g e) (instance_3 (c0, t)))).
  { apply near_inside_torus. intro i. destruct (In_ i) as [Q|Q]; [now left|right]. split; [now symmetry|apply Mid]. }
  set (f := fun y => sq (y ⊖ m) - r2 - (sq (y ⊖ m0) - r0)).
  assert (A : affine f) by (exists (2 ⊙ (m0 ⊖ m)), (sq m - r2 - (sq m0 - r0)); intro y; unfold f; vector).
  assert (Lim : 0 <= f (spot s)).
  { apply (near_limit f (spot s) g A). apply (small_impl _ _) with (2 := Near). intros e _ H. set (y := curve (spot s) g e) in *.
    destruct (least_power_3 x L box_positive T y c G P D I) as (k & Ik & Hk & Low).
    assert (E := torus_disjoint_3 T y (c0, t) k C0 I0 Ik H Hk). subst k. assert (Q := Low (c, (0, 0, 0)%Z) I). rewrite instance_zero_3 in Q.
    rewrite (power_by_sphere x L c m r2 y (P c I) On), (power_by_sphere x L _ m0 r0 y P0 On0) in Q. unfold f. lra. }
  rewrite (power_by_sphere x L _ m0 r0 _ P0 On0) in Z. unfold f in Lim. lra.
Qed.
End placed.
