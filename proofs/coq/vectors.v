(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Vectors of space: products, the norm, and what the other files need of them. *)
Require Import Reals Lra Psatz.
Open Scope R_scope.

Record vec := V { X1 : R; X2 : R; X3 : R }.

Definition add u v := V (X1 u + X1 v) (X2 u + X2 v) (X3 u + X3 v).
Definition sub u v := V (X1 u - X1 v) (X2 u - X2 v) (X3 u - X3 v).
Definition scale k u := V (k * X1 u) (k * X2 u) (k * X3 u).
Definition zero := V 0 0 0.
Definition dot u v := X1 u * X1 v + X2 u * X2 v + X3 u * X3 v.
Definition cross u v := V (X2 u * X3 v - X3 u * X2 v) (X3 u * X1 v - X1 u * X3 v) (X1 u * X2 v - X2 u * X1 v).

Declare Scope vec_scope.
Notation "u ⊕ v" := (add u v) (at level 50, left associativity) : vec_scope.
Notation "u ⊖ v" := (sub u v) (at level 50, left associativity) : vec_scope.
Notation "k ⊙ u" := (scale k u) (at level 40, left associativity) : vec_scope.
Notation "u · v" := (dot u v) (at level 40, left associativity) : vec_scope.
Notation "u ✕ v" := (cross u v) (at level 40, left associativity) : vec_scope.
Open Scope vec_scope.

(* The square of the length, the length, and six times the volume of the tetrahedron 0, u, v, w. *)
Definition sq u := u · u.
Definition norm u := sqrt (sq u).
Definition vol u v w := (u ✕ v) · w.

Lemma vec_eq u v : X1 u = X1 v -> X2 u = X2 v -> X3 u = X3 v -> u = v.
Proof. destruct u, v. simpl. now intros -> -> ->. Qed.

(* Decides polynomial identities between vectors: coordinates, then ring. *)
Ltac coordinates := cbv beta iota delta [vol sq dot cross add sub scale zero X1 X2 X3].
Ltac vector :=
  intros; first [ apply vec_eq; coordinates; ring | coordinates; ring ].

Lemma sq_nonneg u : 0 <= sq u.
Proof. unfold sq, dot. generalize (Rle_0_sqr (X1 u)) (Rle_0_sqr (X2 u)) (Rle_0_sqr (X3 u)). unfold Rsqr. lra. Qed.

Lemma sq_zero u : sq u = 0 -> u = zero.
Proof.
  unfold sq, dot. intro H. generalize (Rle_0_sqr (X1 u)) (Rle_0_sqr (X2 u)) (Rle_0_sqr (X3 u)). unfold Rsqr. intros.
  apply vec_eq; apply Rsqr_0_uniq; unfold Rsqr, zero; lra.
Qed.

Lemma sq_pos u : u <> zero -> 0 < sq u.
Proof. intro H. destruct (Rle_lt_or_eq_dec _ _ (sq_nonneg u)) as [L|E]; [exact L|]. now elim H; apply sq_zero. Qed.

Lemma norm_nonneg u : 0 <= norm u.
Proof. apply sqrt_pos. Qed.

Lemma norm_sq u : norm u * norm u = sq u.
Proof. apply sqrt_sqrt, sq_nonneg. Qed.

Lemma norm_zero u : norm u = 0 -> u = zero.
Proof. intro H. apply sq_zero. rewrite <- norm_sq, H. ring. Qed.

Lemma norm_pos u : u <> zero -> 0 < norm u.
Proof. intro H. now apply sqrt_lt_R0, sq_pos. Qed.

Lemma norm_of_sq u v : sq u = sq v -> norm u = norm v.
Proof. unfold norm. now intros ->. Qed.

Lemma norm_scale k u : norm (k ⊙ u) = Rabs k * norm u.
Proof.
  unfold norm. replace (sq (k ⊙ u)) with (Rsqr k * sq u) by (unfold Rsqr; vector).
  rewrite sqrt_mult by (apply Rle_0_sqr || apply sq_nonneg). now rewrite sqrt_Rsqr_abs.
Qed.

Lemma norm_opp u v : norm (u ⊖ v) = norm (v ⊖ u).
Proof. apply norm_of_sq. vector. Qed.

(* Lagrange's identity, and from it the inequality of Cauchy and Schwarz. *)
Lemma lagrange u v : sq u * sq v - (u · v) * (u · v) = sq (u ✕ v).
Proof. vector. Qed.

Lemma cauchy u v : Rabs (u · v) <= norm u * norm v.
Proof.
  rewrite <- (Rabs_pos_eq (norm u * norm v)) by (apply Rmult_le_pos; apply norm_nonneg).
  apply Rsqr_le_abs_0. unfold Rsqr.
  replace (norm u * norm v * (norm u * norm v)) with ((norm u * norm u) * (norm v * norm v)) by ring.
  rewrite !norm_sq. generalize (lagrange u v) (sq_nonneg (u ✕ v)). lra.
Qed.

Lemma dot_le u v : u · v <= norm u * norm v.
Proof. generalize (cauchy u v) (Rle_abs (u · v)). lra. Qed.

Lemma dot_ge u v : - (norm u * norm v) <= u · v.
Proof. generalize (cauchy u v) (Rle_abs (- (u · v))). rewrite Rabs_Ropp. lra. Qed.

Lemma norm_add u v : norm (u ⊕ v) <= norm u + norm v.
Proof.
  apply Rsqr_incr_0; try (generalize (norm_nonneg u) (norm_nonneg v) (norm_nonneg (u ⊕ v)); lra).
  unfold Rsqr. rewrite norm_sq. replace (sq (u ⊕ v)) with (sq u + sq v + 2 * (u · v)) by vector.
  rewrite <- !norm_sq. generalize (dot_le u v). lra.
Qed.

(* Along a straight motion by d a point stays within the length of d. *)
Lemma norm_shorter t d : 0 <= t <= 1 -> norm (t ⊙ d) <= norm d.
Proof.
  intro H. rewrite norm_scale, Rabs_pos_eq by lra. generalize (norm_nonneg d). intro. nra.
Qed.

(* r is one of the numbers of a tree of maxima *)
Ltac leaf := first [ apply Rle_refl | apply Rle_trans with (2 := Rmax_l _ _); leaf | apply Rle_trans with (2 := Rmax_r _ _); leaf ].
