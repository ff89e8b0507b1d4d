(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The theorem of docs/theory.md 1.2 in the plane, without circles.

   - plane_triangulation   cells positive, border convex and winding once: then the cells triangulate the convex hull of the vertices *)
Require Import Reals Lra Psatz List Permutation Arith.
From Annulus Require Import width_2 plane_mesh plane_crossings plane_border plane_embedding plane_heights.
Import ListNotations.
Open Scope R_scope.

(* A point of a triangle is in every convex set that has those corners whose weight is not 0. *)
Lemma weighted_corners (C : point_2 -> Prop) a b c x : convex_set C -> 0 < turning a b c -> within x a b c ->
  (0 < turning b c x -> C a) -> (0 < turning c a x -> C b) -> (0 < turning a b x -> C c) -> C x.
Proof.
  intros S D (Hc & Ha & Hb) Ca Cb Cc. assert (E := turning_sum a b c x).
  assert (X : turning b c x * fst a + turning c a x * fst b + turning a b x * fst c = turning a b c * fst x) by (unfold turning, turn; ring).
  assert (Y : turning b c x * snd a + turning c a x * snd b + turning a b x * snd c = turning a b c * snd x) by (unfold turning, turn; ring).
  revert Hc Ha Hb Ca Cb Cc E X Y D. generalize (turning b c x) (turning c a x) (turning a b x) (turning a b c).
  intros A B K D HK HA HB Ca Cb Cc E X Y P.
  assert (Two : 0 < A + B -> C ((A * fst a + B * fst b) / (A + B), (A * snd a + B * snd b) / (A + B))).
  { intro Q. destruct HA as [HA| <-]; [destruct HB as [HB| <-]|].
    - replace (_, _) with (mix (B / (A + B)) a b) by (unfold mix; f_equal; field; lra). apply S; [|now apply Ca|now apply Cb].
      split; [apply Rlt_le, Rdiv_lt_0_compat; lra|]. apply (Rmult_le_reg_r (A + B)); [lra|]. field_simplify; lra.
    - replace (_, _) with a; [now apply Ca|]. rewrite (surjective_pairing a) at 1. f_equal; field; lra.
    - replace (_, _) with b; [apply Cb; lra|]. rewrite (surjective_pairing b) at 1. f_equal; field; lra. }
  destruct (Req_EM_T (A + B) 0) as [Z|Z].
  - assert (A = 0) by lra. assert (B = 0) by lra. subst A B. replace x with c; [apply Cc; lra|].
    destruct c as [c1 c2], x as [x1 x2]. cbn [fst snd] in *. f_equal; nra.
  - assert (Q : 0 < A + B) by lra. specialize (Two Q). set (p := (_, _)) in Two. destruct HK as [HK| <-].
    + replace x with (mix (K / D) p c).
      * apply S; [|exact Two|now apply Cc]. split; [apply Rlt_le, Rdiv_lt_0_compat; lra|]. apply (Rmult_le_reg_r D); [lra|]. field_simplify; lra.
      * rewrite (surjective_pairing x). unfold mix, p. cbn [fst snd]. f_equal.
        -- apply (Rmult_eq_reg_r D); [|lra]. rewrite (Rmult_comm (fst x)), <- X, <- E. field. lra.
        -- apply (Rmult_eq_reg_r D); [|lra]. rewrite (Rmult_comm (snd x)), <- Y, <- E. field. lra.
    + replace x with p; [exact Two|]. rewrite (surjective_pairing x). unfold p. f_equal.
      * apply (Rmult_eq_reg_r D); [|lra]. rewrite (Rmult_comm (fst x)), <- X, <- E. field. lra.
      * apply (Rmult_eq_reg_r D); [|lra]. rewrite (Rmult_comm (snd x)), <- Y, <- E. field. lra.
Qed.

Section placed.
Variables (T : mesh) (m : placement).
Hypothesis gluing : glued T.
Hypothesis cells_positive : positive m T.
Hypothesis border_convex : convex m (border T).
Hypothesis border_once : winds_once m (border T).

Lemma cell_in_hull x t : In t (cells T) -> in_cell m x t -> in_hull m (vertex_of T) x.
Proof.
  intros It W C S V. destruct t as [[a b] c].
  apply (weighted_corners C (m a) (m b) (m c)); trivial; [now apply cells_positive| | |]; intros _; apply V; exists (a, b, c); simpl; tauto.
Qed.

Lemma hull_in_cell x : in_hull m (vertex_of T) x -> exists t, In t (cells T) /\ in_cell m x t.
Proof.
  intro H. apply (cells_cover T m gluing cells_positive border_once border_convex). intros a b I.
  apply (H (fun y => 0 <= turning (m a) (m b) y)).
  - intros e y z E Y Z. rewrite turning_mix. apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra.
  - intros v (t & It & Cv). now apply (corners_left T m gluing cells_positive border_once border_convex a b t v).
Qed.

(* Corners with a positive weight in one cell have it in the other. *)
Lemma shared_corner v t u x : In t (cells T) -> In u (cells T) -> in_cell m x t -> in_cell m x u ->
  0 < plane_through m (at_vertex v) x t -> corner v u.
Proof.
  intros It Iu Ht Hu P. apply weight_corner with m x.
  now rewrite <- (same_weights T m gluing cells_positive border_convex border_once x t u It Iu Ht Hu).
Qed.

Theorem plane_triangulation : triangulation m T.
Proof.
  split.
  - intros t rest u x P I Ht Hu. now apply (interiors_disjoint T m gluing cells_positive border_once x t u rest).
  - intro x. split; [apply hull_in_cell|]. intros (t & It & W). now apply cell_in_hull with t.
  - intros [[a b] c] u x It Iu Ht Hu C S V. assert (P := cells_positive a b c It). assert (W := Ht). destruct W as (W1 & W2 & W3).
    assert (N : forall v w, 0 <= at_vertex v w) by (intros v w; unfold at_vertex; destruct (Nat.eq_dec w v); lra).
    assert (O : forall v, at_vertex v v = 1) by (intro v; unfold at_vertex; destruct (Nat.eq_dec v v); [reflexivity|contradiction]).
    apply (weighted_corners C (m a) (m b) (m c)); trivial; intro Q; apply V; (split; [simpl; tauto|]);
      apply (shared_corner _ (a, b, c) u x It Iu Ht Hu); (apply Rdiv_lt_0_compat; [|exact P]); rewrite O.
    + generalize (Rmult_le_pos _ _ W3 (N a b)) (Rmult_le_pos _ _ W1 (N a c)). lra.
    + generalize (Rmult_le_pos _ _ W2 (N b a)) (Rmult_le_pos _ _ W1 (N b c)). lra.
    + generalize (Rmult_le_pos _ _ W2 (N c a)) (Rmult_le_pos _ _ W3 (N c b)). lra.
  - intros v w Vv (t & It & Cw) E. assert (Cv : corner v t).
    { apply (vertex_is_corner T m gluing cells_positive border_convex border_once v t It Vv). rewrite E. now apply corner_in with T. }
    destruct t as [[a b] c]. generalize (cells_positive a b c It). unfold turn_at, turning, turn.
    destruct Cv as [->|[->| ->]], Cw as [->|[->| ->]]; trivial; rewrite E; intro; exfalso; lra.
Qed.
End placed.
