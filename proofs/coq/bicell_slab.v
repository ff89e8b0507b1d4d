(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A partition of the five points of a bi-cell (bicell.v) whose annulus is a slab: docs/theory.md, section 4.

   slab_width            half_width is half the distance of the two planes, at least
   slab_width_attained   and at most *)
Require Import Reals Lra Psatz.
From Annulus Require Export bicell.
Open Scope R_scope.

(* Lam = 0: the rest lies on one plane, B on a parallel one, and the distance of the planes is det / |N|, which is twice
   the same formula. *)
Section slab.
Variable x : placement.
Variable B : vertex -> bool.
Variables i j : vertex.
Hypothesis outside : B i = false.
Hypothesis inside : B j = true.
Hypothesis flat : Lam x B = 0.

Lemma flat_arm m : arm x B m = N x B.
Proof. unfold arm. rewrite flat. generalize (N x B) (rel x m). vector. Qed.

Theorem planes k : N x B · x k = N x B · x i - (if B k then det x else 0).
Proof.
  generalize (level x B i) (level x B k). rewrite flat. unfold one, rel. rewrite outside.
  generalize (N x B) (x i) (x k) (x a). intros n u v o. 
  replace (n · (u ⊖ o)) with (n · u - n · o) by vector. replace (n · (v ⊖ o)) with (n · v - n · o) by vector. lra.
Qed.

Theorem slab_width u v : N x B <> zero -> N x B · u = N x B · x i -> N x B · v = N x B · x j ->
  Rabs (2 * half_width x B i j) <= norm (u ⊖ v).
Proof.
  intros Hn Hu Hv. unfold half_width, arms. rewrite !flat_arm.
  assert (L := norm_pos _ Hn).
  replace (2 * (det x / (norm (N x B) + norm (N x B)))) with (det x / norm (N x B)) by (field; lra).
  unfold Rdiv. rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq (norm _)) by lra.
  apply Rmult_le_reg_r with (norm (N x B)); [exact L|].
  rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  generalize (cauchy (N x B) (u ⊖ v)) (planes j). rewrite inside. intros C E.
  replace (N x B · (u ⊖ v)) with (N x B · u - N x B · v) in C by (generalize (N x B); vector).
  rewrite Hu, Hv, E in C. replace (N x B · x i - (N x B · x i - det x)) with (det x) in C by ring. lra.
Qed.

Theorem slab_width_attained : N x B <> zero ->
  let v := x i ⊖ (det x / sq (N x B)) ⊙ N x B in
  N x B · v = N x B · x j /\ norm (x i ⊖ v) = Rabs (2 * half_width x B i j).
Proof.
  intros Hn v. assert (L := norm_pos _ Hn). assert (Q := sq_pos _ Hn). split.
  - generalize (planes j). rewrite inside. intros ->. unfold v.
    replace (N x B · (x i ⊖ (det x / sq (N x B)) ⊙ N x B)) with (N x B · x i - det x / sq (N x B) * sq (N x B))
      by (generalize (N x B) (x i) (det x / sq (N x B)); vector). field. lra.
  - replace (x i ⊖ v) with ((det x / sq (N x B)) ⊙ N x B)
      by (unfold v; generalize (x i) ((det x / sq (N x B)) ⊙ N x B); vector).
    rewrite norm_scale. unfold half_width, arms. rewrite !flat_arm.
    replace (2 * (det x / (norm (N x B) + norm (N x B)))) with (det x / sq (N x B) * norm (N x B)).
    + rewrite Rabs_mult, (Rabs_pos_eq (norm _)) by lra. reflexivity.
    + rewrite <- norm_sq. field. lra.
Qed.
End slab.
