(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Glued, positive cells of degree 1 in a periodic box of the plane triangulate it: docs/theory.md 8.3.

   - face_to_face        a point of two translates of cells has the same corners around it in both: as sites, not only as places
   - vertex_is_corner    a vertex is in a translate of a cell only as a corner of it
   - torus_triangulates  all together: each point is in a cell, strictly inside one is in no other, cells meet in what they share

   A point near the common one, strictly inside the second cell, is in a cell with those corners; that cell is the second one, since they are disjoint. *)
Require Import Reals ZArith Lra Lia Psatz List Permutation.
From Annulus Require Import sums small width_2 plane_mesh plane_crossings plane_embedding torus_2 torus_powers torus_cover.
Import ListNotations.
Open Scope R_scope.

Section placed.
Variables (x : nat -> point_2) (L : box_2).
Hypothesis box_positive : 0 < det_2 L.
Variable T : list torus_cell_2.
Hypothesis gluing : glued_torus_2 T.
Hypothesis cells_positive : positive_torus_2 x L T.
Hypothesis once : covers_2 T = 2%Z.
Notation spot := (spot x L).
Notation in_torus_cell := (in_torus_cell x L).
Notation "'rotated' r k" := (In r (rotations_2 (instance k))) (at level 10, r at level 9, k at level 9).
Notation torus_middle := (torus_middle x L).
Notation inside_torus_cell := (inside_torus_cell x L).

Lemma corner_place a b q z : 0 < turning a b q -> turning a b z = 0 -> turning q a z = 0 -> z = a.
Proof.
  intros P H K. rewrite (surjective_pairing z), (surjective_pairing a). f_equal; apply Rmult_eq_reg_l with (turning a b q); try lra.
  - replace (turning a b q * fst z) with (turning a b q * fst a + (fst b - fst a) * turning q a z + (fst q - fst a) * turning a b z) by
    (unfold turning, turn; ring). rewrite H, K. ring.
  - replace (turning a b q * snd z) with (turning a b q * snd a + (snd b - snd a) * turning q a z + (snd q - snd a) * turning a b z) by
    (unfold turning, turn; ring). rewrite H, K. ring.
Qed.

(* The corners that have a weight at z are those around it: one at a corner, two on a side. *)
Definition corners_at (z : point_2) (k k' : torus_cell_2 * offset_2) : Prop :=
  forall a b q, In (a, b, q) (rotations_2 (instance k)) -> 0 < turning (spot b) (spot q) z -> corner_of_torus a (instance k').
Definition near (z y : point_2) (k : torus_cell_2 * offset_2) : Prop := small (fun e => in_torus_cell (mix e z y) (instance k)).

Lemma near_rotation z y k a b q : rotated (a, b, q) k -> small (fun e => 0 <= (1 - e) * turning (spot a) (spot b) z + e * turning (spot a) (spot b) y) ->
  small (fun e => 0 <= (1 - e) * turning (spot b) (spot q) z + e * turning (spot b) (spot q) y) ->
  small (fun e => 0 <= (1 - e) * turning (spot q) (spot a) z + e * turning (spot q) (spot a) y) -> near z y k.
Proof.
  intros R A B C. eapply small_impl; [|exact (small_and _ _ A (small_and _ _ B C))]. cbv beta. intros e _ H. apply (in_rotated x L _ _ _ R). simpl.
  now rewrite !turning_mix.
Qed.

Lemma small_weight f g : 0 < f -> small (fun e => 0 <= (1 - e) * f + e * g).
Proof. intro F. eapply small_impl; [|exact (small_positive f g F)]. cbv beta. intros e _ H. lra. Qed.

Lemma small_zero f g : f = 0 -> 0 <= g -> small (fun e => 0 <= (1 - e) * f + e * g).
Proof. intros -> G. exists 1. split; [lra|]. intros e E. rewrite Rmult_0_r, Rplus_0_l. apply Rmult_le_pos; lra. Qed.

Lemma near_corner z y k a b q : In (fst k) T -> rotated (a, b, q) k -> turning (spot a) (spot b) z = 0 -> turning (spot q) (spot a) z = 0 ->
  exists k', In (fst k') T /\ near z y k' /\ corner_of_torus a (instance k').
Proof.
  intros I R H K. assert (P := instance_positive x L T k _ cells_positive I R). rewrite (corner_place (spot a) (spot b) (spot q) z P H K).
  destruct (star_covers x L box_positive T gluing cells_positive a y k b q I R) as (k' & b' & q' & I' & R' & A & B). exists k'. split; [exact I'|].
  split; [|now apply (corner_of_rotation a b' q')].
  assert (P' := instance_positive x L T k' _ cells_positive I' R').
  destruct (turning_corner (spot a) (spot b')) as (Z & _), (turning_corner (spot a) (spot q')) as (_ & Z' & _).
  apply (near_rotation _ y k' a b' q' R').
  - now apply small_zero.
  - apply small_weight. rewrite <- turning_cycle, <- turning_cycle. exact P'.
  - now apply small_zero.
Qed.

Lemma near_side z y k a b q : In (fst k) T -> rotated (a, b, q) k -> turning (spot a) (spot b) z = 0 -> 0 < turning (spot b) (spot q) z ->
  0 < turning (spot q) (spot a) z ->
  exists k', In (fst k') T /\ near z y k' /\ corner_of_torus a (instance k') /\ corner_of_torus b (instance k').
Proof.
  intros I R Z A B. destruct (Rle_dec 0 (turning (spot a) (spot b) y)) as [N|N].
  - exists k. split; [exact I|]. split; [|split; apply (corner_of_rotation a b q k R)].
    apply (near_rotation z y k a b q R); [now apply small_zero|now apply small_weight|now apply small_weight].
  - destruct (neighbour T k a b q gluing I R) as (k' & p & I' & R'). exists k'. split; [exact I'|].
    split; [|split; apply (corner_of_rotation b a p k' R')].
    assert (P := instance_positive x L T k _ cells_positive I R). assert (P' := instance_positive x L T k' _ cells_positive I' R').
    change (0 < turning (spot a) (spot b) (spot q)) in P. change (0 < turning (spot b) (spot a) (spot p)) in P'.
    assert (E := turning_weights (spot a) (spot b) (spot q) (spot a) (spot p) z).
    assert (E' := turning_weights (spot a) (spot b) (spot q) (spot p) (spot b) z). rewrite Z in E, E'.
    replace (turning (spot a) (spot p) (spot a)) with 0 in E by (unfold turning, turn; ring).
    replace (turning (spot p) (spot b) (spot b)) with 0 in E' by (unfold turning, turn; ring).
    replace (turning (spot a) (spot p) (spot b)) with (turning (spot b) (spot a) (spot p)) in E by (unfold turning, turn; ring).
    replace (turning (spot p) (spot b) (spot a)) with (turning (spot b) (spot a) (spot p)) in E' by (unfold turning, turn; ring).
    assert (S : turning (spot b) (spot a) y = - turning (spot a) (spot b) y) by (unfold turning, turn; ring).
    apply (near_rotation z y k' b a p R').
    + apply small_zero; [rewrite turning_swap, Z; ring|lra].
    + apply small_weight. apply Rmult_lt_reg_l with (turning (spot a) (spot b) (spot q)); [exact P|]. rewrite <- E. nra.
    + apply small_weight. apply Rmult_lt_reg_l with (turning (spot a) (spot b) (spot q)); [exact P|]. rewrite <- E'. nra.
Qed.

Lemma near_cell z y k : In (fst k) T -> in_torus_cell z (instance k) -> exists k', In (fst k') T /\ near z y k' /\ corners_at z k k'.
Proof.
  intros I H. destruct (instance k) as ((a, b), q) eqn:C. destruct H as (H1 & H2 & H3).
  assert (R1 : rotated (a, b, q) k) by (rewrite C; simpl; tauto). assert (R2 := rotation_turns _ _ R1). assert (R3 := rotation_turns _ _ R2).
  simpl in R2, R3.
  assert (S := turning_sum (spot a) (spot b) (spot q) z). assert (P := instance_positive x L T k _ cells_positive I R1).
  change (0 < turning (spot a) (spot b) (spot q)) in P.
  assert (Found : forall k', (0 < turning (spot b) (spot q) z -> corner_of_torus a (instance k')) -> (0 < turning (spot q) (spot a) z ->
  corner_of_torus b (instance k')) ->
    (0 < turning (spot a) (spot b) z -> corner_of_torus q (instance k')) -> corners_at z k k').
  { intros k' A B Q u v w. rewrite C. intros [[=<- <- <-]|[[=<- <- <-]|[[=<- <- <-]|[]]]]; trivial. }
  destruct (Rlt_dec 0 (turning (spot a) (spot b) z)) as [N1|N1]; destruct (Rlt_dec 0 (turning (spot b) (spot q) z)) as [N2|N2];
    destruct (Rlt_dec 0 (turning (spot q) (spot a) z)) as [N3|N3].
  - exists k. split; [exact I|]. destruct (corner_of_rotation a b q k R1) as (A & B & Q). split; [|now apply Found].
    apply (near_rotation z y k a b q R1); now apply small_weight.
  - destruct (near_side z y k q a b I R3) as (k' & I' & Y & A & B); try lra. exists k'. split; [exact I'|]. split; [exact Y|]. apply Found; tauto.
  - destruct (near_side z y k b q a I R2) as (k' & I' & Y & A & B); try lra. exists k'. split; [exact I'|]. split; [exact Y|]. apply Found; tauto.
  - destruct (near_corner z y k q a b I R3) as (k' & I' & Y & A); try lra. exists k'. split; [exact I'|]. split; [exact Y|]. apply Found; tauto.
  - destruct (near_side z y k a b q I R1) as (k' & I' & Y & A & B); try lra. exists k'. split; [exact I'|]. split; [exact Y|]. apply Found; tauto.
  - destruct (near_corner z y k a b q I R1) as (k' & I' & Y & A); try lra. exists k'. split; [exact I'|]. split; [exact Y|]. apply Found; tauto.
  - destruct (near_corner z y k b q a I R2) as (k' & I' & Y & A); try lra. exists k'. split; [exact I'|]. split; [exact Y|]. apply Found; tauto.
  - exfalso. lra.
Qed.

Theorem face_to_face z k k' : In (fst k) T -> In (fst k') T -> in_torus_cell z (instance k) -> in_torus_cell z (instance k') -> corners_at z k k'.
Proof.
  intros I I' H H'. destruct (near_cell z (torus_middle (instance k')) k I H) as (k1 & I1 & Y & C).
  destruct (small_exists _ (small_and _ _ Y (small_below 1 Rlt_0_1))) as (e & E & A & B).
  rewrite (torus_disjoint x L box_positive T gluing cells_positive once _ k' k1 I' I1 (to_the_middle x L T cells_positive z k' I' H' e ltac:(lra)) A).
  exact C.
Qed.

(* ---- Vertices ---- *)

Theorem vertex_is_corner k s : In (fst k) T -> torus_vertex T (fst s) -> in_torus_cell (spot s) (instance k) -> corner_of_torus s (instance k).
Proof.
  intros I (c0 & s0 & I0 & C0 & V) H. destruct (rotation_at s0 c0 C0) as (b & q & R).
  set (u := (fst (snd s) - fst (snd s0), snd (snd s) - snd (snd s0))%Z).
  assert (M : moved_2 u s0 = s).
  { destruct s as (v, (i, j)), s0 as (v0, (i0, j0)). cbn [fst snd] in V, u. subst v0 u. cbn [moved_2 fst snd]. apply f_equal2; [reflexivity|].
    apply f_equal2; ring. }
  assert (R' : rotated (s, moved_2 u b, moved_2 u q) (c0, u)) by (rewrite <- M; exact (rotation_moved u _ _ R)).
  assert (P := instance_positive x L T (c0, u) _ cells_positive I0 R'). change (0 < turning (spot s) (spot (moved_2 u b)) (spot (moved_2 u q))) in P.
  apply (face_to_face (spot s) (c0, u) k I0 I) with (moved_2 u b) (moved_2 u q); trivial.
  - apply (in_rotated x L _ _ _ R'). simpl. destruct (turning_corner (spot s) (spot (moved_2 u b))) as (-> & _).
    destruct (turning_corner (spot s) (spot (moved_2 u q))) as (_ & -> & _).
    assert (0 < turning (spot (moved_2 u b)) (spot (moved_2 u q)) (spot s)) by (rewrite <- turning_cycle, <- turning_cycle; exact P). lra.
  - rewrite <- turning_cycle, <- turning_cycle. exact P.
Qed.

(* The translates of cells, each cell listed once, triangulate the plane. *)
Definition triangulates : Prop :=
  (forall z, exists k, In (fst k) T /\ in_torus_cell z (instance k)) /\
  (forall z k k', In (fst k) T -> In (fst k') T -> inside_torus_cell z (instance k) -> in_torus_cell z (instance k') -> k = k') /\
  NoDup T /\
  (forall z k k', In (fst k) T -> In (fst k') T -> in_torus_cell z (instance k) -> in_torus_cell z (instance k') -> corners_at z k k').

Theorem torus_triangulates : triangulates.
Proof.
  repeat split.
  - intro z. destruct (torus_covered x L box_positive T gluing cells_positive once z) as (c & u & I & H). now exists (c, u).
  - exact (torus_disjoint x L box_positive T gluing cells_positive once).
  - exact (torus_listed_once x L box_positive T gluing cells_positive once).
  - exact face_to_face.
Qed.
End placed.
