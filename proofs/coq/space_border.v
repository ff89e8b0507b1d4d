(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The border of a mesh of space whose silhouette winds once: docs/theory.md 1.2, lemma 3, for a direction of sight along which no edge lies.

   - once_seen       looking along it from a point of a cell, no two facets of the upper sheet are met: so the point is in one cell only
   - border_once_3   the two hypotheses of space_embedding.v follow *)
Require Import Reals Lra Psatz List Permutation.
From Annulus Require Import vectors tetrahedron sums small general_position space_line space_mesh space_crossings space_embedding space_triangulation.
From Annulus Require Import space_hull.
From Annulus Require plane_mesh plane_crossings plane_embedding.
From Annulus Require Import width_2 points_2 space_sheets.
Import ListNotations.
Open Scope R_scope.

Definition facet_of (s : four) : nat * nat * nat := let '(a, b, c, _) := s in (a, b, c).
Definition turned_over (t : nat * nat * nat) : nat * nat * nat := let '(a, b, c) := t in (b, a, c).

Section seen.
Variables (p q : R) (m : placement_3).
Notation sight := (V p q 1).
Notation image := (image p q m).

(* The facets of the border are those of the two sheets, turned to the inside; no edge of a cell is seen as a point. *)
Record seen_border (T : mesh_3) (U L : plane_mesh.mesh) : Prop := {
  upper : sheet p q m (-1) U;
  lower : sheet p q m 1 L;
  silhouette : plane_mesh.border U = plane_mesh.border L;
  facets : Permutation (map facet_of (outer T)) (map turned_over (plane_mesh.cells U) ++ plane_mesh.cells L);
  edges_seen : forall t i j, In t (cells T) -> i <> j -> image (point_of t i) <> image (point_of t j) }.

(* ---- Along the line of sight ---- *)

Definition ahead (k : R) (x : vec) : vec := x ⊕ k ⊙ sight.
Definition step_tri x y (t : nat * nat * nat) : R := let '(a, b, c) := t in step_3 m x y (a, b, c, O).

Lemma line_ahead k x a b : line m x (ahead k x) a b = k * turning (image a) (image b) (seen p q x).
Proof.
  unfold line, ahead, orient, space_sheets.image, seen, turning, turn. cbn [fst snd]. generalize (m a) (m b). intros [? ? ?] [? ? ?]. destruct x. coordinates. ring.
Qed.

Lemma height_ahead k x a b c d : facet_height m (a, b, c, d) (ahead k x) = facet_height m (a, b, c, d) x + k * turn_at image a b c.
Proof.
  unfold facet_height, ahead, orient, turn_at, space_sheets.image, seen, turning, turn. cbn [fst snd]. generalize (m a) (m b) (m c).
  intros [? ? ?] [? ? ?] [? ? ?]. destruct x. coordinates. ring.
Qed.

Lemma step_ahead k x a b c : 0 < k -> 0 < turn_at image a b c -> (step_tri x (ahead k x) (a, b, c) = 0 \/
  (0 <= step_tri x (ahead k x) (a, b, c) <= 1 /\ plane_mesh.inside_cell image (seen p q x) (a, b, c))).
Proof.
  intros K P. cbn [step_tri step_3]. rewrite !line_ahead. rewrite (one_side_scale k) by exact K. rewrite height_ahead.
  assert (Q : 0 < k * turn_at image a b c) by now apply Rmult_lt_0_compat. revert Q. generalize (k * turn_at image a b c) (facet_height m (a, b, c, O) x).
  intros d h Q. assert (S := plane_crossings.turning_sum (image a) (image b) (image c) (seen p q x)). unfold turn_at in P.
  unfold plane_mesh.inside_cell, plane_mesh.strictly_in. revert S P.
  generalize (turning (image a) (image b) (seen p q x)) (turning (image b) (image c) (seen p q x)) (turning (image c) (image a) (seen p q x))
    (turning (image a) (image b) (image c)). intros t1 t2 t3 t S P.
  destruct (one_side_cases t1 t2 t3) as [Z|Z]; [left; rewrite Z; ring|]. right. split.
  - rewrite Z. unfold half, pos. repeat match goal with |- context [Rlt_dec ?u ?v] => destruct (Rlt_dec u v) end; lra.
  - unfold one_side in Z. repeat match type of Z with context [Rlt_dec ?u ?v] => destruct (Rlt_dec u v) end; lra.
Qed.

Lemma step_over x y t : step_tri x y (turned_over t) = - step_tri x y t.
Proof. destruct t as [[a b] c]. apply (step_swap_3 m x y a b c O O). Qed.

(* The upper sheet is met once at most. *)
Lemma met_once S s k x : sheet p q m s S -> 0 < k -> sum (step_tri x (ahead k x)) (plane_mesh.cells S) <= 1.
Proof.
  intros [G P C W R] K. assert (St : forall t, In t (plane_mesh.cells S) -> step_tri x (ahead k x) t = 0 \/
    (0 <= step_tri x (ahead k x) t <= 1 /\ plane_mesh.inside_cell image (seen p q x) t)) by (intros [[a b] c] I; apply step_ahead; [exact K|now apply P]).
  assert (D := fun t rest u Q I H J => plane_embedding.interiors_disjoint S image G P W (seen p q x) t u rest Q I H (plane_embedding.inside_in image _ _ J)).
  revert St D. generalize (plane_mesh.cells S). clear. intros l St D.
  assert (Z : (forall t, In t l -> step_tri x (ahead k x) t = 0) \/ exists t, In t l /\ step_tri x (ahead k x) t <> 0).
  { clear. induction l as [|t l [IH|(u & I & N)]]; [now left| |right; exists u; split; [now right|exact N]].
    destruct (Req_EM_T (step_tri x (ahead k x) t) 0) as [E|N]; [left; intros u [<-|I]; [exact E|now apply IH]|right; exists t; split; [now left|exact N]]. }
  destruct Z as [Z|(t & I & N)]; [rewrite (sum_ext _ (fun _ => 0)), sum_zero by exact Z; lra|].
  apply in_split in I. destruct I as (l1 & l2 & E). assert (Q : Permutation l (t :: l1 ++ l2)) by (rewrite E; symmetry; apply Permutation_middle).
  rewrite (sum_permutation _ _ _ Q), sum_cons. destruct (St t) as [E'|[B In']]; [rewrite Q; now left|contradiction|].
  rewrite (sum_ext _ (fun _ => 0)), sum_zero; [lra|]. intros u Iu. destruct (St u) as [E'|[_ J]]; [rewrite Q; now right|exact E'|].
  elim (D t (l1 ++ l2) u Q Iu In' J).
Qed.

(* ---- Points from which no edge and no facet is met edgewise ---- *)

Definition slope (t : four) (i : corner) : R := bary m t sight i - bary m t zero i.

Lemma bary_ahead k t x i : bary m t (ahead k x) i = bary m t x i + k * slope t i.
Proof.
  unfold slope. destruct (bary_affine m t i) as (n & c & A). rewrite !A. unfold ahead. generalize n x. vector.
Qed.

Lemma slopes_sum t f : affine f -> slope t o * f (m (point_of t o)) + slope t u * f (m (point_of t u)) + slope t v * f (m (point_of t v))
  + slope t w * f (m (point_of t w)) = size m t * (f sight - f zero).
Proof.
  intro A. assert (E := affine_bary m f t sight A). assert (E' := affine_bary m f t zero A). unfold slope. rewrite Rmult_minus_distr_l, E, E'. ring.
Qed.

Lemma slope_not_zero t i j : 0 < size m t -> (forall i j, i <> j -> image (point_of t i) <> image (point_of t j)) -> i <> j ->
  slope t i <> 0 \/ slope t j <> 0.
Proof.
  intros S D N. destruct (Req_EM_T (slope t i) 0) as [Zi|]; [|now left]. destruct (Req_EM_T (slope t j) 0) as [Zj|]; [exfalso|now right].
  assert (A3 : affine X3) by (exists (V 0 0 1), 0; vector).
  assert (A1 : affine (fun x => fst (seen p q x))) by (exists (V 1 0 (- p)), 0; intro; unfold seen; cbn [fst]; vector).
  assert (A2 : affine (fun x => snd (seen p q x))) by (exists (V 0 1 (- q)), 0; intro; unfold seen; cbn [snd]; vector).
  assert (A0 : affine (fun _ => 1)) by (exists zero, 1; vector).
  assert (E3 := slopes_sum t _ A3). assert (E1 := slopes_sum t _ A1). assert (E2 := slopes_sum t _ A2). assert (E0 := slopes_sum t _ A0). cbv beta in *.
  replace (fst (seen p q sight) - fst (seen p q zero)) with 0 in E1 by (unfold seen; coordinates; cbn [fst]; ring).
  replace (snd (seen p q sight) - snd (seen p q zero)) with 0 in E2 by (unfold seen; coordinates; cbn [snd]; ring).
  replace (X3 sight - X3 zero) with 1 in E3 by (coordinates; ring). rewrite Rminus_diag_eq in E0 by reflexivity.
  assert (Two : forall a b, a <> b -> slope t a * X3 (m (point_of t a)) + slope t b * X3 (m (point_of t b)) = size m t * 1 ->
    slope t a * fst (seen p q (m (point_of t a))) + slope t b * fst (seen p q (m (point_of t b))) = 0 ->
    slope t a * snd (seen p q (m (point_of t a))) + slope t b * snd (seen p q (m (point_of t b))) = 0 -> slope t a + slope t b = 0 -> False).
  { intros a b Nab H3 H1 H2 H0. apply (D a b Nab). assert (Sb : slope t b = - slope t a) by lra. rewrite Sb in *.
    assert (Na : slope t a <> 0) by (intro Z; rewrite Z in H3; lra).
    unfold space_sheets.image. rewrite (surjective_pairing (seen p q (m (point_of t a)))), (surjective_pairing (seen p q (m (point_of t b)))).
    f_equal; apply (Rmult_eq_reg_l (slope t a)); trivial; lra. }
  destruct i, j; try (now elim N); rewrite Zi, Zj in *;
    first [apply (Two o u); (discriminate || lra)|apply (Two o v); (discriminate || lra)|apply (Two o w); (discriminate || lra)
          |apply (Two u v); (discriminate || lra)|apply (Two u w); (discriminate || lra)|apply (Two v w); (discriminate || lra)].
Qed.

Section placed.
Variables (T : mesh_3) (U L : plane_mesh.mesh).
Hypothesis gluing : glued_3 T.
Hypothesis cells_positive : positive_3 m T.
Hypothesis border : seen_border T U L.

Lemma near_ahead k z g : 0 < k -> small (fun e => forall t, In t (cells T) -> general_position m t (curve z g e) (ahead k (curve z g e))).
Proof.
  intro K. assert (O : small (fun e => forall t, In t (cells T) -> forall i, In i corner_list -> bary m t (ahead k (curve z g e)) i <> 0 /\
    forall j, In j corner_list -> i <> j -> order (bary m t (curve z g e)) (bary m t (ahead k (curve z g e))) i j <> 0)).
  { apply small_all. intros t It. assert (S := size_pos T m cells_positive t It). apply small_all. intros i _. apply small_and.
    - apply (small_impl (fun e => 1 * bary m t (curve z g e) i + k * slope t i * 1 <> 0)); [intros e _ H; rewrite bary_ahead; lra|].
      apply (near_nonzero (fun x => 1 * bary m t x i + k * slope t i * 1)).
      + apply (affine_sum (fun x => bary m t x i) (fun _ => 1)); [apply bary_affine|exists zero, 1; vector].
      + exists (ahead (- k) (m (point_of t i))). rewrite bary_ahead, bary_corner. destruct (corner_dec i i) as [_|D]; [lra|now elim D].
    - apply small_all. intros j _. destruct (corner_dec i j) as [->|N]; [exists 1; split; [lra|tauto]|].
      apply (small_impl (fun e => slope t j * bary m t (curve z g e) i + - slope t i * bary m t (curve z g e) j <> 0)).
      + intros e _ H _. unfold order, wedge, pair. cbn [fst snd]. rewrite !bary_ahead. intro E. apply H. apply (Rmult_eq_reg_l k); lra.
      + apply (near_nonzero (fun x => slope t j * bary m t x i + - slope t i * bary m t x j)); [apply affine_sum; apply bary_affine|].
        destruct (slope_not_zero t i j S (fun a b => edges_seen T U L border t a b It) N) as [H|H].
        * exists (m (point_of t j)). rewrite !bary_corner. destruct (corner_dec i j) as [D|_]; [contradiction|].
          destruct (corner_dec j j) as [_|D]; [|now elim D]. rewrite Rmult_0_r, Rplus_0_l. apply Rmult_integral_contrapositive_currified; lra.
        * exists (m (point_of t i)). rewrite !bary_corner. destruct (corner_dec j i) as [D|_]; [congruence|].
          destruct (corner_dec i i) as [_|D]; [|now elim D]. rewrite Rmult_0_r, Rplus_0_r. apply Rmult_integral_contrapositive_currified; lra. }
  apply (small_impl _ _) with (2 := small_and _ _ (near_regular T m cells_positive z g) O). intros e _ [R H] t It. split; [|split].
  - intro i. apply R; [exact It|apply in_corners].
  - intro i. apply (H t It i (in_corners i)).
  - intros i j. apply (proj2 (H t It i (in_corners i)) j (in_corners j)).
Qed.

Lemma border_steps k x : 0 < k -> -1 <= sum (step_3 m x (ahead k x)) (outer T).
Proof.
  intro K. rewrite (sum_ext _ (fun s => step_tri x (ahead k x) (facet_of s))) by (intros [[[a b] c] d] _; reflexivity).
  rewrite <- (sum_map (step_tri x (ahead k x)) facet_of), (sum_permutation _ _ _ (facets T U L border)), sum_app, sum_map.
  rewrite (sum_ext (fun t => step_tri x (ahead k x) (turned_over t)) (fun t => -1 * step_tri x (ahead k x) t)) by (intros; rewrite step_over; ring).
  rewrite sum_scale. generalize (met_once U (-1) k x (upper T U L border) K).
  assert (0 <= sum (step_tri x (ahead k x)) (plane_mesh.cells L)); [|lra]. apply sum_nonneg. intros [[a b] c] I.
  destruct (step_ahead k x a b c K) as [E|[E _]]; [now apply (sheet_positive _ _ _ _ _ (lower T U L border))|lra|lra].
Qed.

Lemma some_border_cell : exists t, In t (cells T).
Proof.
  destruct (upper T U L border) as [G _ C W _]. destruct (plane_embedding.some_cell U image G W C) as (r & I).
  assert (J : In (turned_over r) (map facet_of (outer T))) by (rewrite (facets T U L border); apply in_or_app; left; now apply in_map).
  apply in_map_iff in J. destruct J as (s & _ & J). destruct (glued_side T gluing s) as (t & i & It & _); [apply in_or_app; now right|]. now exists t.
Qed.

Theorem once_seen : exists x t rest, Permutation (cells T) (t :: rest) /\ inside_3 m x t /\ forall r, In r rest -> ~ in_cell_3 m x r.
Proof.
  destruct some_border_cell as (t & It). set (z := centre_3 m t). destruct (corners_bounded (fun v => sight · m v + 0) (cells T)) as (M & B).
  assert (Q : 0 < sq sight) by (apply sq_pos; intro E; injection E; lra). set (k := (Rmax (M - sight · z) 0 + 1) / sq sight).
  assert (K : 0 < k) by (apply Rdiv_lt_0_compat; [generalize (Rmax_r (M - sight · z) 0)|]; lra).
  assert (Far : forall x, sight · ahead k x + 0 = sight · x + (Rmax (M - sight · z) 0 + 1)).
  { intro x. unfold ahead. replace (sight · (x ⊕ k ⊙ sight)) with (sight · x + k * sq sight) by (generalize k x; vector). unfold k. field. lra. }
  assert (S : small (fun e => 0 < sight · curve z z e + (Rmax (M - sight · z) 0 + 1 - M))).
  { apply (near_positive (fun x => sight · x + (Rmax (M - sight · z) 0 + 1 - M))); [now exists sight, (Rmax (M - sight · z) 0 + 1 - M)|left].
    generalize (Rmax_l (M - sight · z) 0). lra. }
  destruct (small_exists _ (small_and _ _ (small_and _ _ S (near_inside_3 m z z t (fun i => or_introl (centre_inside T m cells_positive t It i))))
    (near_ahead k z z K))) as (e & _ & [High X] & G). set (x := curve z z e) in *. clearbody x.
  assert (Y : sum (fun r => inside_all (bary m r (ahead k x))) (cells T) = 0).
  { rewrite (sum_ext _ (fun _ => 0)), sum_zero; [reflexivity|]. intros r I.
    destruct (beyond_all T m cells_positive sight 0 M (ahead k x) r B) as (i & N); [rewrite Far; lra|exact I|]. now apply inside_none with i. }
  assert (N := border_steps k x K). rewrite (outer_steps T m gluing cells_positive x (ahead k x) G), Y in N.
  apply in_split in It. destruct It as (l1 & l2 & E). assert (P : Permutation (cells T) (t :: l1 ++ l2)) by (rewrite E; symmetry; apply Permutation_middle).
  exists x, t, (l1 ++ l2). split; [exact P|]. split; [now apply inside_bary|]. intros r I W. rewrite in_bary in W.
  rewrite (sum_permutation _ _ _ P), sum_cons, (inside_one _ X) in N.
  assert (R : all_positive (bary m r x)).
  { intro i. assert (Ir : In r (cells T)) by (rewrite P; now right). destruct (G r Ir) as (D & _). generalize (W i) (D i). lra. }
  assert (0 < sum (fun s => inside_all (bary m s x)) (l1 ++ l2)); [|lra].
  apply sum_pos with r; [intros; apply inside_nonneg|exact I|]. rewrite (inside_one _ R). lra.
Qed.

(* Each facet of the border is one of a sheet. *)
Lemma facet_cases a b c d : In (a, b, c, d) (outer T) -> In (b, a, c) (plane_mesh.cells U) \/ In (a, b, c) (plane_mesh.cells L).
Proof.
  intro I. assert (J : In (a, b, c) (map facet_of (outer T))) by (apply in_map_iff; now exists (a, b, c, d)).
  rewrite (facets T U L border) in J. apply in_app_iff in J. destruct J as [J|J]; [left|now right].
  apply in_map_iff in J. destruct J as ([[x y] z] & E & J). injection E as -> -> ->. exact J.
Qed.

Lemma facet_vertex s n : In s (outer T) -> on_facet s n -> plane_mesh.vertex_of U n \/ plane_mesh.vertex_of L n.
Proof.
  destruct s as [[[a b] c] d]. intros I O. destruct (facet_cases a b c d I) as [J|J]; [left; exists (b, a, c)|right; exists (a, b, c)]; (split; [exact J|]);
    simpl in *; tauto.
Qed.

Lemma facets_bound s n : In s (outer T) -> plane_mesh.vertex_of U n \/ plane_mesh.vertex_of L n -> 0 <= facet_height m s (m n).
Proof.
  intros I V. destruct (nothing_beyond p q m U L n (upper T U L border) (lower T U L border) (silhouette T U L border) V) as [Hu Hl].
  destruct s as [[[a b] c] d]. destruct (facet_cases a b c d I) as [J|J]; [|now apply Hl].
  generalize (Hu b a c J). rewrite orient_swap. unfold facet_height. lra.
Qed.

Lemma facet_seen a b c d : In (a, b, c, d) (outer T) -> turn_at image a b c <> 0.
Proof.
  intro I. destruct (facet_cases a b c d I) as [J|J].
  - generalize (sheet_positive _ _ _ _ _ (upper T U L border) b a c J). unfold turn_at, turning, turn. intros P E. lra.
  - generalize (sheet_positive _ _ _ _ _ (lower T U L border) a b c J). lra.
Qed.

Theorem border_once_3 : (forall s n, In s (outer T) -> is_vertex T n -> 0 <= facet_height m s (m n)) /\
  exists x t rest, Permutation (cells T) (t :: rest) /\ inside_3 m x t /\ forall r, In r rest -> ~ in_cell_3 m x r.
Proof.
  split; [|exact once_seen]. intros s n I Vn. destruct (height_affine m s) as (h & k & A).
  assert (B : ((-1) ⊙ h) · m n + - k <= 0).
  { apply (outer_bounds T m gluing cells_positive); trivial.
    - intro Z. destruct s as [[[a b] c] d]. apply (facet_seen a b c d I). assert (E := height_ahead 1 (m n) a b c d). rewrite !A in E.
      assert (H : h = zero) by (apply vec_eq; [generalize (f_equal X1 Z)|generalize (f_equal X2 Z)|generalize (f_equal X3 Z)]; simpl; lra).
      rewrite H in E. unfold dot in E. simpl in E. lra.
    - intros s' v' I' O. generalize (facets_bound s v' I (facet_vertex s' v' I' O)). rewrite A.
      replace (((-1) ⊙ h) · m v') with (- (h · m v')) by (generalize h (m v'); vector). lra. }
  rewrite A. replace (((-1) ⊙ h) · m n) with (- (h · m n)) in B by (generalize h (m n); vector). lra.
Qed.
End placed.
End seen.
