(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Positive tetrahedra, glued along their facets, have nothing beyond their border, whatever it looks like: plane_exit.v in space.

   - exit_facet      a segment from a point strictly inside a cell to one in no cell crosses a facet of the border outwards
   - outer_bounds    an affine function that is positive at no vertex of a border facet is positive at no vertex *)
Require Import Reals Lra Psatz List Permutation.
From Annulus Require Import tetrahedron sums small general_position space_line space_mesh space_crossings space_embedding.
Import ListNotations.
Open Scope R_scope.

Definition on_facet (s : four) (v : nat) : Prop := let '(a, b, c, _) := s in v = a \/ v = b \/ v = c.

Section placed.
Variables (T : mesh_3) (m : placement_3).
Hypothesis gluing : glued_3 T.
Hypothesis cells_positive : positive_3 m T.

Lemma outer_steps x y : (forall t, In t (cells T) -> general_position m t x y) ->
  sum (step_3 m x y) (outer T) = sum (fun t => inside_all (bary m t y)) (cells T) - sum (fun t => inside_all (bary m t x)) (cells T).
Proof.
  intro G. generalize (by_facets T (step_3 m x y) (fun _ => 1) gluing (step_turned m x y) (fun _ _ _ _ => conj eq_refl eq_refl) (step_swap_3 m x y)).
  rewrite (sum_ext (fun k => let '(a, b, c, p, q) := k in step_3 m x y (a, b, c, q) * (1 - 1)) (fun _ => 0)), sum_zero, Rplus_0_l
    by (intros [[[[a b] c] p] q] _; ring).
  rewrite (sum_ext (fun s => step_3 m x y s * 1) (step_3 m x y)) by (intros; ring). intros <-.
  transitivity (sum (fun t => inside_all (bary m t y) + -1 * inside_all (bary m t x)) (cells T)); [|rewrite sum_plus, sum_scale; ring].
  apply sum_ext. intros t I. rewrite (cell_steps m t x y (size_pos T m cells_positive t I) (G t I)). ring.
Qed.

Theorem exit_facet x y t : In t (cells T) -> all_positive (bary m t x) -> (forall r, In r (cells T) -> exists i, bary m r y i < 0) ->
  (forall r, In r (cells T) -> general_position m r x y) -> exists s, In s (outer T) /\ step_3 m x y s < 0.
Proof.
  intros It X Y G. apply sum_negative. rewrite (outer_steps x y G). rewrite (sum_ext (fun r => inside_all (bary m r y)) (fun _ => 0)), sum_zero
    by (intros r I; destruct (Y r I) as (i & N); now apply inside_none with i).
  assert (0 < sum (fun r => inside_all (bary m r x)) (cells T)); [|lra].
  apply sum_pos with t; [intros; apply inside_nonneg|exact It|]. rewrite (inside_one _ X). lra.
Qed.

Variables (n : vec) (k : R).
Hypothesis steep : n <> zero.
Hypothesis at_outer : forall s v, In s (outer T) -> on_facet s v -> n · m v + k <= 0.

(* Where the line meets the facet is between its corners, and between x and y. *)
Lemma no_step x y s : In s (outer T) -> step_3 m x y s < 0 -> 0 < n · x + k -> 0 < n · y + k -> False.
Proof.
  intros I S X Y. assert (A := fun v => at_outer s v I). destruct s as [[[a b] c] d].
  assert (Fa := A a ltac:(simpl; tauto)). assert (Fb := A b ltac:(simpl; tauto)). assert (Fc := A c ltac:(simpl; tauto)).
  assert (E : line m x y b c * (n · m a + k) + line m x y c a * (n · m b + k) + line m x y a b * (n · m c + k)
    = facet_height m (a, b, c, d) y * (n · x + k) - facet_height m (a, b, c, d) x * (n · y + k))
    by (unfold line, facet_height, orient; generalize (m a) (m b) (m c); vector).
  assert (O : line m x y b c + line m x y c a + line m x y a b = facet_height m (a, b, c, d) y - facet_height m (a, b, c, d) x)
    by (unfold line, facet_height, orient; generalize (m a) (m b) (m c); vector).
  cbn [step_3] in S. revert S E O Fa Fb Fc X Y. generalize (line m x y a b) (line m x y b c) (line m x y c a) (facet_height m (a, b, c, d) x)
    (facet_height m (a, b, c, d) y) (n · m a + k) (n · m b + k) (n · m c + k) (n · x + k) (n · y + k).
  intros l1 l2 l3 hx hy fa fb fc fx fy S E O Fa Fb Fc X Y.
  destruct (one_side_cases l1 l2 l3) as [Z|Z]; [rewrite Z in S; lra|].
  assert (H : 0 <= hx /\ hy <= 0 /\ hy < hx).
  { rewrite Z in S. unfold half, pos in S. repeat match type of S with context [Rlt_dec ?u ?v] => destruct (Rlt_dec u v) end; lra. }
  assert (L : l1 < 0 /\ l2 < 0 /\ l3 < 0).
  { unfold one_side in Z. repeat match type of Z with context [Rlt_dec ?u ?v] => destruct (Rlt_dec u v) end; lra. }
  assert (0 <= - l2 * - fa) by (apply Rmult_le_pos; lra). assert (0 <= - l3 * - fb) by (apply Rmult_le_pos; lra).
  assert (0 <= - l1 * - fc) by (apply Rmult_le_pos; lra). assert (0 <= - hy * fx) by (apply Rmult_le_pos; lra).
  assert (0 <= hx * fy) by (apply Rmult_le_pos; lra).
  destruct (Req_EM_T hx 0) as [Zx|Zx]; [assert (0 < - hy * fx) by (apply Rmult_lt_0_compat; lra)|assert (0 < hx * fy) by (apply Rmult_lt_0_compat; lra)]; lra.
Qed.

Lemma corners_bounded (f : nat -> R) (l : list four) : exists M, forall t i, In t l -> f (point_of t i) <= M.
Proof.
  induction l as [|t l (M & H)]; [exists 0; easy|]. exists (Rmax M (Rmax (Rmax (f (point_of t o)) (f (point_of t u))) (Rmax (f (point_of t v)) (f (point_of t w))))).
  intros r i [<-|I]; [|apply Rle_trans with (1 := H r i I), Rmax_l].
  unfold Rmax. destruct i; repeat destruct (Rle_dec _ _); lra.
Qed.

Lemma beyond_all M z r : (forall t i, In t (cells T) -> n · m (point_of t i) + k <= M) -> M < n · z + k -> In r (cells T) -> exists i, bary m r z i < 0.
Proof.
  intros B L I. apply outside_bary. intro W. rewrite in_bary in W. assert (A : affine (fun y => n · y + k)) by (exists n, k; reflexivity).
  assert (E := affine_bary m _ r z A). assert (S := size_pos T m cells_positive r I). assert (Tot := bary_total m r z). cbv beta in E.
  assert (H : forall i, bary m r z i * (n · m (point_of r i) + k) <= bary m r z i * M) by (intro i; apply Rmult_le_compat_l; [apply W|now apply B]).
  generalize (H o) (H u) (H v) (H w). intros. assert (size m r * M < size m r * (n · z + k)) by now apply Rmult_lt_compat_l. nra.
Qed.

Lemma outer_bounds_inside x t : In t (cells T) -> all_positive (bary m t x) -> (forall r, In r (cells T) -> forall i, In i corner_list -> bary m r x i <> 0) ->
  n · x + k <= 0.
Proof.
  intros It X R. apply Rnot_lt_le. intro P. destruct (corners_bounded (fun v => n · m v + k) (cells T)) as (M & B).
  assert (Q := sq_pos n steep). set (z := x ⊕ ((Rmax M 0 + 1) / sq n) ⊙ n).
  assert (Z : n · z + k = n · x + k + (Rmax M 0 + 1)).
  { unfold z. replace (n · (x ⊕ ((Rmax M 0 + 1) / sq n) ⊙ n)) with (n · x + (Rmax M 0 + 1) / sq n * sq n) by (generalize ((Rmax M 0 + 1) / sq n); vector). field. lra. }
  generalize (Rmax_l M 0) (Rmax_r M 0). intros M1 M2.
  assert (S : small (fun e => forall r, In r (cells T) -> exists i, bary m r (curve z z e) i < 0)).
  { apply small_all. intros r I. destruct (beyond_all M z r B ltac:(lra) I) as (i & N).
    apply (small_impl (fun e => bary m r (curve z z e) i < 0)); [intros; now exists i|]. now apply near_outside_3. }
  assert (A : affine (fun y => n · y + k)) by (exists n, k; reflexivity).
  assert (F : small (fun e => 0 < n · curve z z e + k)) by (apply (near_positive (fun y => n · y + k)); [exact A|left; lra]).
  destruct (small_exists _ (small_and _ _ (small_and _ _ S F) (near_general T m cells_positive x z z R))) as (e & _ & [Y Fy] & G).
  destruct (exit_facet x (curve z z e) t It X Y G) as (s & Is & St). now apply (no_step x (curve z z e) s).
Qed.

Theorem outer_bounds v : is_vertex T v -> n · m v + k <= 0.
Proof.
  intros (t & It & C). assert (E : exists i, v = point_of t i).
  { destruct t as [[[a b] c] d]. destruct C as [->|[->|[->| ->]]]; [now exists o|now exists u|now exists tetrahedron.v|now exists w]. }
  destruct E as (i & ->).
  assert (A : affine (fun y => -1 * (n · y + k) + 0 * (n · y + k))) by (apply affine_sum; exists n, k; reflexivity).
  assert (I : in_cell_3 m (m (point_of t i)) t).
  { apply in_bary. intro j. rewrite bary_corner. generalize (size_pos T m cells_positive t It). destruct (corner_dec j i); lra. }
  assert (L := near_limit _ (m (point_of t i)) (centre_3 m t) A). cbv beta in L. enough (0 <= -1 * (n · m (point_of t i) + k) + 0 * (n · m (point_of t i) + k)) by lra.
  apply L. apply (small_impl _ _) with (2 := small_and _ _ (near_centre T m cells_positive _ t It I) (near_regular T m cells_positive (m (point_of t i)) (centre_3 m t))).
  intros e _ [X R]. generalize (outer_bounds_inside _ t It X R). lra.
Qed.
End placed.
