(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 1 of docs/theory.md 1.2 in space. Positive cells, glued along their facets; no vertex beyond a border facet; and some point in one cell only.

   - disjoint_3   then a point strictly inside a cell is in no other
   - cover_3      and the cells cover what is on the inner side of every border facet, nothing else

   That signs and the winding of the border's silhouette imply the last two of these hypotheses (lemma 3): space_silhouette.v. *)
Require Import Reals Lra Psatz List Permutation.
From Annulus Require Import tetrahedron sums small general_position space_line space_mesh space_crossings.
Import ListNotations.
Open Scope R_scope.

Section placed.
Variables (T : mesh_3) (m : placement_3).
Hypothesis gluing : glued_3 T.
Hypothesis cells_positive : positive_3 m T.
Hypothesis border_convex : forall s v, In s (outer T) -> is_vertex T v -> 0 <= facet_height m s (m v).
Hypothesis once : exists x t rest, Permutation (cells T) (t :: rest) /\ inside_3 m x t /\ forall r, In r rest -> ~ in_cell_3 m x r.

Lemma inside_bary x t : inside_3 m x t <-> all_positive (bary m t x).
Proof.
  split; [intros H i; apply H, side_in|]. intros H s I. destruct (in_sides s t I) as (i & ->). apply H.
Qed.

Lemma in_bary x t : in_cell_3 m x t <-> forall i, 0 <= bary m t x i.
Proof.
  split; [intros H i; apply H, side_in|]. intros H s I. destruct (in_sides s t I) as (i & ->). apply H.
Qed.

Lemma outside_bary x t : ~ in_cell_3 m x t -> exists i, bary m t x i < 0.
Proof.
  rewrite in_bary. intro N. destruct (Rlt_dec (bary m t x o) 0); [now exists o|]. destruct (Rlt_dec (bary m t x u) 0); [now exists u|].
  destruct (Rlt_dec (bary m t x v) 0); [now exists v|]. destruct (Rlt_dec (bary m t x w) 0); [now exists w|].
  exfalso. apply N. intros []; lra.
Qed.

(* Sides of bi-cells and of the border are sides of cells. *)
Lemma glued_side s : In s (flat_map shared_sides (bicells T) ++ outer T) -> exists t i, In t (cells T) /\ turned (side_of t i) s.
Proof.
  destruct gluing as (l & F & P). intro I. rewrite <- P in I. clear P. revert I.
  assert (K : forall r, In r (flat_map sides (cells T)) -> exists t i, In t (cells T) /\ r = side_of t i).
  { intros r R. apply in_flat_map in R. destruct R as (t & It & R). destruct (in_sides r t R) as (i & E). now exists t, i. }
  induction F as [|r p k l H F IH]; [easy|]. intros [<-|I].
  - destruct (K r (or_introl eq_refl)) as (t & i & It & ->). now exists t, i.
  - apply IH; [|exact I]. intros r' R. apply K. now right.
Qed.

Definition centre_3 (t : four) : vec := let '(a, b, c, d) := t in / 4 ⊙ (m a ⊕ m b ⊕ m c ⊕ m d).

Lemma centre_inside t : In t (cells T) -> all_positive (bary m t (centre_3 t)).
Proof.
  intros I i. generalize (size_pos T m cells_positive t I). destruct t as [[[a b] c] d]. unfold bary, facet_height, size, centre_3.
  assert (E : forall q p r, orient q p r (/ 4 ⊙ (m a ⊕ m b ⊕ m c ⊕ m d)) =
    (orient q p r (m a) + orient q p r (m b) + orient q p r (m c) + orient q p r (m d)) / 4).
  { intros. unfold orient. coordinates. field. }
  destruct i; cbn [side_of]; rewrite E; unfold orient; coordinates; lra.
Qed.

Lemma corner_vertex t i : In t (cells T) -> is_vertex T (point_of t i).
Proof. intro I. exists t. split; [exact I|]. destruct t as [[[a b] c] d], i; simpl; tauto. Qed.

Lemma inside_inner x t : In t (cells T) -> all_positive (bary m t x) -> inner T m x.
Proof.
  intros I P s S. assert (A := height_affine m s). assert (V := size_pos T m cells_positive t I).
  assert (N := fun i => border_convex s _ S (corner_vertex t i I)).
  assert (K := affine_bary m _ t x A).
  assert (L : 0 <= facet_height m s x).
  { apply (Rmult_le_reg_l (size m t)); [exact V|]. rewrite Rmult_0_r, K. repeat apply Rplus_le_le_0_compat; (apply Rmult_le_pos; [apply Rlt_le, P|apply N]). }
  destruct L as [L|L]; [exact L|exfalso]. rewrite <- L, Rmult_0_r in K.
  assert (M := fun i => Rmult_le_pos _ _ (Rlt_le _ _ (P i)) (N i)).
  assert (Z : forall i, facet_height m s (m (point_of t i)) = 0).
  { intro i. generalize (M o) (M u) (M v) (M w). intros. assert (Q : bary m t x i * facet_height m s (m (point_of t i)) = 0) by (destruct i; lra).
    apply Rmult_integral in Q. destruct Q as [Q|Q]; [generalize (P i); lra|exact Q]. }
  (* the height would be 0 everywhere, also at the fourth corner of its own cell *)
  assert (Zero : forall y, facet_height m s y = 0).
  { intro y. apply (Rmult_eq_reg_l (size m t)); [|lra]. rewrite (affine_bary m _ t y A), !Z. ring. }
  destruct (glued_side s) as (r & i & Ir & R); [apply in_or_app; now right|]. generalize (centre_inside r Ir i) (turned_height m _ _ (centre_3 r) R).
  unfold bary. rewrite Zero. lra.
Qed.

(* ---- Close by, in general position ---- *)

Lemma near_inside_3 z g t : (forall i, 0 < bary m t z i \/ (bary m t z i = 0 /\ 0 < bary m t g i)) -> small (fun e => all_positive (bary m t (curve z g e))).
Proof.
  intro H. apply (small_impl (fun e => forall i, In i corner_list -> 0 < bary m t (curve z g e) i)).
  - intros e _ K i. apply K, in_corners.
  - apply small_all. intros i _. apply (near_positive (fun x => bary m t x i)); [apply bary_affine|apply H].
Qed.

Lemma near_centre z t : In t (cells T) -> in_cell_3 m z t -> small (fun e => all_positive (bary m t (curve z (centre_3 t) e))).
Proof.
  intros I W. apply near_inside_3. intro i. rewrite in_bary in W. destruct (W i) as [L|E]; [now left|right]. split; [now symmetry|now apply centre_inside].
Qed.

Lemma near_outside_3 z g t i : bary m t z i < 0 -> small (fun e => bary m t (curve z g e) i < 0).
Proof.
  intro N. apply (small_impl (fun e => 0 < -1 * bary m t (curve z g e) i + 0 * bary m t (curve z g e) i)); [intros; lra|].
  apply (near_positive (fun x => -1 * bary m t x i + 0 * bary m t x i)); [apply affine_sum; apply bary_affine|left; lra].
Qed.

Lemma near_regular z g : small (fun e => forall t, In t (cells T) -> forall i, In i corner_list -> bary m t (curve z g e) i <> 0).
Proof.
  apply small_all. intros t It. apply small_all. intros i _. apply (near_nonzero (fun x => bary m t x i)); [apply bary_affine|].
  exists (m (point_of t i)). rewrite bary_corner. destruct (corner_dec i i) as [_|N]; [|now elim N]. generalize (size_pos T m cells_positive t It). lra.
Qed.

Lemma near_general x z g : (forall t, In t (cells T) -> forall i, In i corner_list -> bary m t x i <> 0) ->
  small (fun e => forall t, In t (cells T) -> general_position m t x (curve z g e)).
Proof.
  intro X. assert (O : small (fun e => forall t, In t (cells T) -> forall i, In i corner_list -> forall j, In j corner_list -> i <> j ->
    order (bary m t x) (bary m t (curve z g e)) i j <> 0)).
  { apply small_all. intros t It. apply small_all. intros i Ii. apply small_all. intros j _. destruct (corner_dec i j) as [->|N]; [exists 1; split; [lra|tauto]|].
    apply (small_impl (fun e => bary m t x i * bary m t (curve z g e) j + - bary m t x j * bary m t (curve z g e) i <> 0)).
    - intros e _ H _. unfold order, wedge, pair. cbn [fst snd]. intro E. apply H. lra.
    - apply (near_nonzero (fun y => bary m t x i * bary m t y j + - bary m t x j * bary m t y i)); [apply affine_sum; apply bary_affine|].
      exists (m (point_of t j)). rewrite !bary_corner. destruct (corner_dec j j) as [_|D]; [|now elim D]. destruct (corner_dec i j) as [D|_]; [contradiction|].
      rewrite Rmult_0_r, Rplus_0_r. apply Rmult_integral_contrapositive_currified; [now apply X|]. generalize (size_pos T m cells_positive t It). lra. }
  apply (small_impl _ _) with (2 := small_and _ _ (near_regular z g) O). intros e _ [R S] t It. split; [|split].
  - intro i. apply X; [exact It|apply in_corners].
  - intro i. apply R; [exact It|apply in_corners].
  - intros i j. apply S; [exact It|apply in_corners|apply in_corners].
Qed.

(* ---- No point twice ---- *)

Lemma inside_one f : all_positive f -> inside_all f = 1.
Proof. intro P. unfold inside_all, pos. repeat (destruct (Rlt_dec _ _) as [|N]; [|elim N; apply P]). ring. Qed.

Lemma inside_none f i : f i < 0 -> inside_all f = 0.
Proof. intro N. unfold inside_all. destruct i; [destruct (pos_cases (f o)) as [[_ K]|[-> _]]|destruct (pos_cases (f u)) as [[_ K]|[-> _]]|
  destruct (pos_cases (f v)) as [[_ K]|[-> _]]|destruct (pos_cases (f w)) as [[_ K]|[-> _]]]; lra. Qed.

Lemma inside_nonneg f : 0 <= inside_all f.
Proof. unfold inside_all. assert (P : forall x, 0 <= pos x) by (intro x; unfold pos; destruct (Rlt_dec 0 x); lra). repeat apply Rmult_le_pos; apply P. Qed.

(* A point in general position that is in one cell. *)
Lemma once_generic : exists x, inner T m x /\ sum (fun t => 1 * inside_all (bary m t x)) (cells T) = 1 /\
  forall t, In t (cells T) -> forall i, In i corner_list -> bary m t x i <> 0.
Proof.
  destruct once as (x & t & rest & P & I & N). assert (It : In t (cells T)) by (rewrite P; now left). apply inside_bary in I.
  assert (S : small (fun e => forall r, In r rest -> exists i, bary m r (curve x x e) i < 0)).
  { apply small_all. intros r R. destruct (outside_bary x r (N r R)) as (i & B). apply (small_impl (fun e => bary m r (curve x x e) i < 0)); [intros; now exists i|].
    now apply near_outside_3. }
  assert (S' := near_inside_3 x x t (fun i => or_introl (I i))).
  destruct (small_exists _ (small_and _ _ (small_and _ _ S S') (near_regular x x))) as (e & _ & [O J] & R).
  exists (curve x x e). split; [now apply inside_inner with t|]. split; [|exact R].
  rewrite (sum_permutation _ _ _ P), sum_cons, (inside_one _ J), (sum_ext _ (fun _ => 0)), sum_zero; [ring|].
  intros r Ir. destruct (O r Ir) as (i & B). rewrite (inside_none _ i B). ring.
Qed.

(* Every point in general position to it that is inside the border is in one cell too. *)
Lemma counted_3 x y : (forall t, In t (cells T) -> general_position m t x y) -> inner T m x -> inner T m y ->
  sum (fun t => 1 * inside_all (bary m t y)) (cells T) = sum (fun t => 1 * inside_all (bary m t x)) (cells T).
Proof.
  intros G X Y. apply Rminus_diag_uniq.
  rewrite (change_3 T m gluing cells_positive x y (fun _ => 1) G X Y (fun _ _ _ _ => conj eq_refl eq_refl)).
  rewrite (sum_ext _ (fun _ => 0)); [apply sum_zero|]. intros [[[[a b] c] p] q] _. ring.
Qed.

Theorem disjoint_3 x t r rest : Permutation (cells T) (t :: rest) -> In r rest -> inside_3 m x t -> ~ in_cell_3 m x r.
Proof.
  intros P Ir Ht Hr. apply inside_bary in Ht. destruct once_generic as (y & Y & C & G).
  assert (It : In t (cells T)) by (rewrite P; now left). assert (Ir' : In r (cells T)) by (rewrite P; now right).
  destruct (small_exists _ (small_and _ _ (small_and _ _ (near_inside_3 x (centre_3 r) t (fun i => or_introl (Ht i))) (near_centre x r Ir' Hr))
    (near_general y x (centre_3 r) G))) as (e & _ & [A B] & D).
  assert (E := counted_3 y _ D Y (inside_inner _ t It A)). rewrite C in E.
  rewrite (sum_permutation _ _ _ P), sum_cons, (inside_one _ A) in E.
  assert (0 < sum (fun t => 1 * inside_all (bary m t (curve x (centre_3 r) e))) rest); [|lra].
  apply sum_pos with r; [intros s _; generalize (inside_nonneg (bary m s (curve x (centre_3 r) e))); lra|exact Ir|]. rewrite (inside_one _ B). lra.
Qed.

(* ---- Every point ---- *)

Lemma cell_inner x t s : In t (cells T) -> in_cell_3 m x t -> In s (outer T) -> 0 <= facet_height m s x.
Proof.
  intros It W S. rewrite in_bary in W. apply (Rmult_le_reg_l (size m t)); [now apply (size_pos T m cells_positive)|].
  rewrite Rmult_0_r, (affine_bary m _ t x (height_affine m s)).
  repeat apply Rplus_le_le_0_compat; (apply Rmult_le_pos; [apply W|apply border_convex; [exact S|now apply corner_vertex]]).
Qed.

Lemma inner_covered x : (forall s, In s (outer T) -> 0 <= facet_height m s x) -> exists t, In t (cells T) /\ in_cell_3 m x t.
Proof.
  intro X. destruct once_generic as (y & Y & C & G).
  assert (Some : exists r, In r (cells T)) by (destruct once as (_ & r & rest & P & _); exists r; rewrite P; now left).
  destruct Some as (r & Ir). set (g := centre_3 r).
  assert (S : small (fun e => forall t, In t (cells T) -> all_positive (bary m t (curve x g e)) -> in_cell_3 m x t)).
  { apply small_all. intros t It. destruct (Classical_Prop.classic (in_cell_3 m x t)) as [I|N]; [exists 1; split; [lra|trivial]|].
    destruct (outside_bary x t N) as (i & B). apply (small_impl (fun e => bary m t (curve x g e) i < 0)); [|now apply near_outside_3].
    intros e _ L A. generalize (A i). lra. }
  assert (S' : small (fun e => forall s, In s (outer T) -> 0 < facet_height m s (curve x g e))).
  { apply small_all. intros s I. apply near_positive; [apply height_affine|]. destruct (X s I) as [L|E]; [now left|right].
    split; [now symmetry|]. now apply (inside_inner g r Ir (centre_inside r Ir)). }
  destruct (small_exists _ (small_and _ _ (small_and _ _ S S') (near_general y x g G))) as (e & _ & [A B] & D).
  assert (E := counted_3 y _ D Y B). rewrite C in E.
  destruct (sum_negative (fun t => -1 * (1 * inside_all (bary m t (curve x g e)))) (cells T)) as (t & It & N); [rewrite sum_scale; lra|].
  exists t. split; [exact It|]. apply (A t It). destruct (all_or_not (bary m t (curve x g e))) as [[_ P]|[Z _]]; [|exact P|rewrite Z in N; lra].
  intro i. destruct (D t It) as (_ & K & _). apply K.
Qed.

Theorem cover_3 x : (exists t, In t (cells T) /\ in_cell_3 m x t) <-> forall s, In s (outer T) -> 0 <= facet_height m s x.
Proof. split; [intros (t & It & W) s S; now apply cell_inner with t | apply inner_covered]. Qed.
End placed.
