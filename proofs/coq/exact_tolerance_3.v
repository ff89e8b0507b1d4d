(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* No tolerance of an empty sphere is larger than the half width of any partition's annulus.

   annulus_attained   all five points can be moved by exactly the half width to one sphere, or one plane where Lam = 0: det becomes 0
   tolerance_exact    where the cells are at least as wide as the annuli, tolerance_3 is the largest number with its property *)
Require Import Reals Lra Psatz.
From Annulus Require Import sign_tolerance_3 bicell_slab.
Open Scope R_scope.

(* At distance |rho - |v|| from v there is a vector of length rho. *)
Lemma stretched v rho : 0 <= rho -> exists v', norm v' = rho /\ norm (v' ⊖ v) = Rabs (rho - norm v).
Proof.
  intro H. destruct (Req_dec (norm v) 0) as [E|E].
  - assert (Z0 := norm_zero v E). exists (V rho 0 0).
    assert (K : norm (V rho 0 0) = rho).
    { unfold norm. replace (sq (V rho 0 0)) with (rho * rho) by (coordinates; ring). now apply sqrt_square. }
    split; [exact K|]. rewrite E, Z0, Rminus_0_r, Rabs_pos_eq by exact H.
    replace (V rho 0 0 ⊖ zero) with (V rho 0 0) by vector. exact K.
  - assert (L := norm_nonneg v). exists ((rho / norm v) ⊙ v). split.
    + rewrite norm_scale, Rabs_pos_eq; [field; exact E|]. apply Rmult_le_pos; [exact H|]. apply Rlt_le, Rinv_0_lt_compat. lra.
    + replace ((rho / norm v) ⊙ v ⊖ v) with ((rho / norm v - 1) ⊙ v) by (generalize (rho / norm v); vector).
      rewrite norm_scale. rewrite <- (Rabs_pos_eq (norm v)) at 2 by exact L. rewrite <- Rabs_mult. f_equal. field. exact E.
Qed.

Lemma vol_flat n s t r : 0 < sq n -> n · s = 0 -> n · t = 0 -> n · r = 0 -> vol s t r = 0.
Proof.
  intros Q Hs Ht Hr. apply Rmult_eq_reg_r with (sq n); [|lra].
  replace (vol s t r * sq n) with ((n · s) * ((t ✕ r) · n) + (n · t) * ((r ✕ s) · n) + (n · r) * ((s ✕ t) · n)) by vector.
  rewrite Hs, Ht, Hr. ring.
Qed.

Section attained.
Variable x : placement.
Variable B : vertex -> bool.
Variables i j : vertex.
Hypothesis outside : B i = false.
Hypothesis inside : B j = true.
Hypothesis nonzero : det x <> 0.

Lemma attained_sphere : Lam x B <> 0 ->
  exists y, (forall k, norm (y k ⊖ x k) = Rabs (half_width x B i j)) /\ det y = 0.
Proof.
  intro H. set (m := centre x B). set (ri := norm (m ⊖ x i)). set (rj := norm (m ⊖ x j)).
  assert (Hi : 0 <= ri) by apply norm_nonneg. assert (Hj : 0 <= rj) by apply norm_nonneg.
  assert (W : Rabs (rj - ri) = 2 * Rabs (half_width x B i j)).
  { unfold ri, rj, m. rewrite (width x B i j outside inside H). unfold Rdiv. rewrite !Rabs_mult, Rabs_inv, Rabs_Rabsolu, (Rabs_pos_eq 2) by lra.
    field. now apply Rabs_no_R0. }
  set (rho := (ri + rj) / 2).
  assert (K : forall k, exists z, norm (z ⊖ m) = rho /\ norm (z ⊖ x k) = Rabs (half_width x B i j)).
  { intro k. destruct (stretched (x k ⊖ m) rho) as (v' & N1 & N2); [unfold rho; lra|].
    exists (m ⊕ v'). split; [replace (m ⊕ v' ⊖ m) with v' by (generalize m; vector); exact N1|].
    replace (m ⊕ v' ⊖ x k) with (v' ⊖ (x k ⊖ m)) by (generalize m (x k); vector). rewrite N2, (norm_opp (x k)).
    assert (S : norm (m ⊖ x k) = if B k then rj else ri).
    { unfold ri, rj, m. destruct (B k) eqn:E; apply equidistant; congruence. }
    rewrite S. assert (T : Rabs (half_width x B i j) = Rabs (rj - ri) / 2) by lra. rewrite T. unfold rho.
    destruct (B k).
    - rewrite <- Rabs_Ropp. replace (- ((ri + rj) / 2 - rj)) with ((rj - ri) * / 2) by field. rewrite Rabs_mult, (Rabs_pos_eq (/ 2)) by lra. reflexivity.
    - replace ((ri + rj) / 2 - ri) with ((rj - ri) * / 2) by field. rewrite Rabs_mult, (Rabs_pos_eq (/ 2)) by lra. reflexivity. }
  destruct (K a) as (ya & Sa & Da). destruct (K b) as (yb & Sb & Db). destruct (K c) as (yc & Sc & Dc).
  destruct (K p) as (yp & Sp & Dp). destruct (K q) as (yq & Sq & Dq).
  exists (fun k => match k with a => ya | b => yb | c => yc | p => yp | q => yq end). split; [now intros [| | | |]|].
  rewrite <- (Rmult_1_l (det _)). rewrite <- (powers _ 1 zero (rho * rho) m). unfold sum, quadric.
  assert (Z0 : forall v, zero · v = 0) by vector. rewrite <- !norm_sq, Sa, Sb, Sc, Sp, Sq, !Z0. ring.
Qed.

Lemma attained_plane : Lam x B = 0 ->
  exists y, (forall k, norm (y k ⊖ x k) = Rabs (half_width x B i j)) /\ det y = 0.
Proof.
  intro H. set (n := N x B).
  assert (A := arms_pos x B i j outside inside nonzero). unfold arms in A. rewrite !(flat_arm x B H) in A. fold n in A.
  assert (P : 0 < norm n) by lra. assert (Q : 0 < sq n) by (rewrite <- norm_sq; nra).
  set (h := det x / (2 * sq n)). pose (y k := x k ⊕ (if B k then h else - h) ⊙ n). exists y. split.
  - intro k. unfold y. replace (x k ⊕ (if B k then h else - h) ⊙ n ⊖ x k) with ((if B k then h else - h) ⊙ n) by vector.
    rewrite norm_scale. replace (Rabs (if B k then h else - h)) with (Rabs h) by (destruct (B k); [|rewrite Rabs_Ropp]; reflexivity).
    unfold half_width, arms. rewrite !(flat_arm x B H). fold n.
    replace (det x / (norm n + norm n)) with (h * norm n) by (unfold h; rewrite <- norm_sq; field; lra).
    rewrite Rabs_mult, (Rabs_pos_eq (norm n)) by lra. reflexivity.
  - assert (S : forall k, n · rel y k = 0).
    { intro k. unfold rel, y.
      replace (n · (x k ⊕ (if B k then h else - h) ⊙ n ⊖ (x a ⊕ (if B a then h else - h) ⊙ n)))
        with (n · x k - n · x a + ((if B k then h else - h) - (if B a then h else - h)) * sq n) by (generalize n; vector).
      generalize (planes x B i outside H k) (planes x B i outside H a). fold n. intros -> ->.
      unfold h. destruct (B k), (B a); field; lra. }
    unfold det, lambda_b, lambda_c, lambda_p, lambda_q.
    rewrite !(vol_flat n) by (exact Q || apply S). ring.
Qed.

Theorem annulus_attained : exists y, (forall k, norm (y k ⊖ x k) = Rabs (half_width x B i j)) /\ det y = 0.
Proof. destruct (Req_dec (Lam x B) 0); [now apply attained_plane | now apply attained_sphere]. Qed.
End attained.

Theorem tolerance_exact x : 0 < det x -> annuli_half_width x <= cells_half_width x ->
  exists y, (forall k, norm (y k ⊖ x k) = tolerance_3 x) /\ det y = 0.
Proof.
  intros H C. unfold tolerance_3. rewrite Rmin_left by exact C.
  assert (K : forall B i j, B i = false -> B j = true -> exists y, (forall k, norm (y k ⊖ x k) = half_width x B i j) /\ det y = 0).
  { intros B i j Hi Hj. destruct (annulus_attained x B i j Hi Hj) as (y & Hy & D); [lra|]. exists y. split; [|exact D].
    intro k. rewrite Hy. apply Rabs_pos_eq. unfold half_width. apply Rmult_le_pos; [lra|].
    apply Rlt_le, Rinv_0_lt_compat, arms_pos; try assumption. lra. }
  unfold annuli_half_width, Rmin. repeat destruct Rle_dec; now apply K.
Qed.
