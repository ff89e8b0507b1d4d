(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Positive triangles, glued along their sides, have nothing beyond their border: whatever it looks like.

   - exit_side       a ray from a point strictly inside a triangle leaves through a side of the border
   - border_bounds   an affine function that is positive at no vertex of the border is positive at no vertex *)
Require Import Reals Lra Psatz List Permutation.
From Annulus Require Import sums small width_2 plane_mesh plane_paths plane_crossings plane_embedding.
Import ListNotations.
Open Scope R_scope.

Lemma ring_ends u v l : In (u, v) (ring l) -> In u l /\ In v l.
Proof.
  assert (K : forall w, In w (l ++ firstn 1 l) -> In w l) by (intros w; destruct l as [|a l]; [easy|]; simpl; rewrite in_app_iff; simpl; tauto).
  intro I. apply steps_in in I. destruct I. split; now apply K.
Qed.

Section placed.
Variables (T : mesh) (m : placement).
Hypothesis gluing : glued T.
Hypothesis cells_positive : positive m T.

Lemma exit_side d x t : In t (cells T) -> inside_cell m x t -> fst d <> 0 \/ snd d <> 0 ->
  exists a b, In (a, b) (ring (border T)) /\ cross d (m a) <= cross d x < cross d (m b) /\ 0 < turning (m a) (m b) x.
Proof.
  intros It Ht D. assert (P : 0 < sum (crossings_of m d x) (cells T)).
  { apply sum_pos with t; trivial; [intros s K; now apply (crossings_nonneg T m cells_positive)|].
    destruct (crossings_count T m cells_positive d x t It) as (_ & K & _). rewrite K; trivial. lra. }
  rewrite (covered T m gluing) in P.
  destruct (sum_negative (fun s => -1 * (let '(a, b) := s in crossing d x (m a) (m b))) (ring (border T))) as ([a b] & I & N);
    [rewrite sum_scale; lra|].
  exists a, b. split; [exact I|]. unfold crossing in N. generalize (passes_nonneg d x (m b) (m a)). intro Z.
  assert (Q : 0 < passes d x (m a) (m b)) by lra. unfold passes in Q. destruct (Rle_dec (cross d (m a)) _); [|lra]. destruct (Rle_dec (cross d (m b)) _); [lra|].
  destruct (Rlt_dec 0 _); lra.
Qed.

Variables (n : point_2) (k : R).
Hypothesis at_border : forall v, In v (border T) -> dot n (m v) + k <= 0.

Lemma bounded_inside x t : In t (cells T) -> inside_cell m x t -> dot n x + k <= 0.
Proof.
  intros It Ht. destruct (zero_or_not n) as [[N1 N2]|N].
  - destruct (exit_side (1, 0) x t It Ht) as (a & b & I & _); [left; simpl; lra|]. apply ring_ends in I.
    generalize (at_border a (proj1 I)). unfold dot. rewrite N1, N2. lra.
  - destruct (exit_side n x t It Ht N) as (a & b & I & C & L). apply ring_ends in I. apply Rnot_lt_le. intro P.
    generalize (at_border a (proj1 I)) (at_border b (proj2 I)). intros A B.
    assert (E : (cross n (m b) - cross n (m a)) * (dot n x + k) + turning (m a) (m b) x * (fst n * fst n + snd n * snd n)
      = (cross n (m b) - cross n x) * (dot n (m a) + k) + (cross n x - cross n (m a)) * (dot n (m b) + k))
      by (unfold cross, dot, turning, turn; ring).
    assert (S : 0 <= fst n * fst n + snd n * snd n) by (generalize (Rle_0_sqr (fst n)) (Rle_0_sqr (snd n)); unfold Rsqr; lra).
    assert (0 < (cross n (m b) - cross n (m a)) * (dot n x + k)) by (apply Rmult_lt_0_compat; lra).
    assert (0 <= turning (m a) (m b) x * (fst n * fst n + snd n * snd n)) by (apply Rmult_le_pos; lra).
    assert (0 <= (cross n (m b) - cross n x) * - (dot n (m a) + k)) by (apply Rmult_le_pos; lra).
    assert (0 <= (cross n x - cross n (m a)) * - (dot n (m b) + k)) by (apply Rmult_le_pos; lra). lra.
Qed.

Theorem border_bounds v : vertex_of T v -> dot n (m v) + k <= 0.
Proof.
  intros (t & It & C). apply Ropp_le_cancel. rewrite Ropp_0. apply small_limit with (- (dot n (middle m t) + k)).
  apply (small_impl (fun e => e < 1)); [|apply small_below; lra]. intros e E L.
  assert (B := bounded_inside (mix e (m v) (middle m t)) t It).
  assert (I : inside_cell m (mix e (m v) (middle m t)) t) by (apply mix_inside with T; trivial; [lra|]; now apply corner_in with T).
  specialize (B I). unfold dot, mix in *. cbn [fst snd] in *. lra.
Qed.
End placed.
