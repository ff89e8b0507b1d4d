(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The half width of a tetrahedron is the tolerance of its orientation: docs/theory.md, section 2.1.

   The corners are o, u, v, w. A partition of them is given by the part B that does not contain o, so there are seven. Its slab
   has the normal that is the sum, over B, of the area vectors v x w (of u), w x u (of v) and u x v (of w): one function that
   is 0 outside B and the volume on B. Three of the seven are pairs of opposite edges, four are facets.

   orientation_certified    unequal moves: whatever slab, the moves of two points on its different sides do not add up to its width
   orientation_tolerance    every point closer than half the width: the orientation stays positive
   orientation_attained     there is a flat placement with every point at exactly half the width *)
Require Import Reals Lra Psatz.
From Annulus Require Export vectors motion.
Open Scope R_scope.

Inductive corner := o | u | v | w.
Definition corners := corner -> vec.

Definition total (f : corner -> R) := f o + f u + f v + f w.

Section numbers.
Variable x : corners.
Let xu := x u ⊖ x o. Let xv := x v ⊖ x o. Let xw := x w ⊖ x o.

Definition volume := vol xu xv xw.
Definition area k := match k with o => zero | u => xv ✕ xw | v => xw ✕ xu | w => xu ✕ xv end.
Definition normal (B : corner -> bool) :=
  (if B u then area u else zero) ⊕ (if B v then area v else zero) ⊕ (if B w then area w else zero).

Theorem slab (B : corner -> bool) k : B o = false -> normal B · x k = normal B · x o + (if B k then volume else 0).
Proof.
  intro H. replace (normal B · x k) with (normal B · x o + normal B · (x k ⊖ x o)) by (generalize (normal B); vector).
  assert (A : forall m n z, (m ⊕ n) · z = m · z + n · z) by vector.
  assert (C : forall (t : bool) n z, (if t then n else zero) · z = if t then n · z else 0) by (intros [] n z; [reflexivity|vector]).
  assert (Z : forall (t : bool) r, r = 0 -> (if t then r else 0) = 0) by now intros [].
  f_equal. unfold normal. rewrite !A, !C. simpl area. unfold volume. destruct k; [|fold xu|fold xv|fold xw].
  - rewrite H. replace (x o ⊖ x o) with zero by vector. rewrite !Z by vector. ring.
  - rewrite (Z (B v)), (Z (B w)) by vector. replace (xv ✕ xw · xu) with (vol xu xv xw) by vector. ring.
  - rewrite (Z (B u)), (Z (B w)) by vector. replace (xw ✕ xu · xv) with (vol xu xv xw) by vector. ring.
  - rewrite (Z (B u)), (Z (B v)) by vector. unfold vol. ring.
Qed.

(* The seven, written out. *)
Definition largest :=
  Rmax (Rmax (Rmax (norm (xv ✕ xw)) (norm (xw ✕ xu))) (Rmax (norm (xu ✕ xv)) (norm (xu ✕ xv ⊕ xv ✕ xw ⊕ xw ✕ xu))))
       (Rmax (norm (xw ✕ xu ⊕ xu ✕ xv)) (Rmax (norm (xu ✕ xv ⊕ xv ✕ xw)) (norm (xv ✕ xw ⊕ xw ✕ xu)))).

Definition half_width_simplex := volume / (2 * largest).

Lemma normal_le_largest B : norm (normal B) <= largest.
Proof.
  unfold normal, largest. simpl area. generalize (xu ✕ xv) (xv ✕ xw) (xw ✕ xu). intros uv vw wu.
  destruct (B u), (B v), (B w); match goal with |- norm ?n <= _ => set (N := n) end;
    [replace N with (uv ⊕ vw ⊕ wu)|replace N with (vw ⊕ wu)|replace N with (uv ⊕ vw)|replace N with vw|
     replace N with (wu ⊕ uv)|replace N with wu|replace N with uv|]; subst N; try vector; try leaf.
  replace (zero ⊕ zero ⊕ zero) with (0 ⊙ uv) by vector. rewrite norm_scale, Rabs_R0, Rmult_0_l. apply Rle_trans with (1 := norm_nonneg uv). leaf.
Qed.

Lemma largest_is_one : exists B k, B o = false /\ B k = true /\ norm (normal B) = largest.
Proof.
  pose (part (s t r : bool) := fun k => match k with o => false | u => s | v => t | w => r end).
  unfold largest, normal. simpl area. generalize (xu ✕ xv) (xv ✕ xw) (xw ✕ xu). intros uv vw wu.
  Ltac pick P k vector := exists P, k; repeat split; simpl; apply norm_of_sq; vector.
  repeat (unfold Rmax at 1; match goal with |- context [Rle_dec ?s ?t] => destruct (Rle_dec s t) end);
    match goal with |- exists B k, _ /\ _ /\ _ = norm ?n =>
      first [ constr_eq n vw; pick (part true false false) u vector | constr_eq n wu; pick (part false true false) v vector
            | constr_eq n uv; pick (part false false true) w vector
            | constr_eq n (uv ⊕ vw ⊕ wu); pick (part true true true) u vector
            | constr_eq n (wu ⊕ uv); pick (part false true true) v vector
            | constr_eq n (uv ⊕ vw); pick (part true false true) u vector
            | constr_eq n (vw ⊕ wu); pick (part true true false) u vector ]
    end.
Qed.
End numbers.

Lemma slab_at x B k : B o = false -> B k = true -> 0 < volume x -> 0 < norm (normal x B).
Proof.
  intros Ho Hk H. apply norm_pos. intro E. generalize (slab x B k Ho). rewrite Hk, E.
  replace (zero · x k) with 0 by vector. replace (zero · x o) with 0 by vector. lra.
Qed.

(* Four coplanar points are affinely dependent, also where they are collinear or coincide. *)
Lemma flat_dependence (s t r : vec) : vol s t r = 0 ->
  exists i j k, (i <> 0 \/ j <> 0 \/ k <> 0) /\ i ⊙ s ⊕ j ⊙ t ⊕ k ⊙ r = zero.
Proof.
  intro H.
  assert (K : forall n, (n · (t ✕ r)) ⊙ s ⊕ (n · (r ✕ s)) ⊙ t ⊕ (n · (s ✕ t)) ⊙ r = vol s t r ⊙ n) by vector.
  assert (Z0 : forall n, vol s t r ⊙ n = zero) by (intro; rewrite H; vector).
  destruct (Req_dec (sq (t ✕ r)) 0) as [E1|N1].
  2: { exists (sq (t ✕ r)), ((t ✕ r) · (r ✕ s)), ((t ✕ r) · (s ✕ t)). split; [now left|].
       rewrite <- (Z0 (t ✕ r)), <- K. reflexivity. }
  destruct (Req_dec (sq (r ✕ s)) 0) as [E2|N2].
  2: { exists ((r ✕ s) · (t ✕ r)), (sq (r ✕ s)), ((r ✕ s) · (s ✕ t)). split; [now right; left|].
       rewrite <- (Z0 (r ✕ s)), <- K. reflexivity. }
  apply sq_zero in E1. apply sq_zero in E2.
  destruct (Req_dec (sq r) 0) as [E3|N3].
  - apply sq_zero in E3. exists 0, 0, 1. split; [right; right; lra|]. rewrite E3. vector.
  - exists (sq r), 0, (- (r · s)). split; [now left|].
    replace (sq r ⊙ s ⊕ 0 ⊙ t ⊕ (- (r · s)) ⊙ r) with ((r ✕ s) ✕ r) by vector. rewrite E2. vector.
Qed.

(* A level that separates. *)
Lemma threshold (B : corner -> bool) (g : corner -> R) : B o = false ->
  (forall i j, B i = false -> B j = true -> g i < g j) ->
  exists tau, (forall i, B i = false -> g i <= tau) /\ (forall j, B j = true -> tau < g j).
Proof.
  intros Ho H. pose (h k := if B k then g o else g k).
  assert (Hh : forall k j, B j = true -> h k < g j) by (intros k j Hj; unfold h; destruct (B k) eqn:E; now apply H).
  exists (Rmax (Rmax (h o) (h u)) (Rmax (h v) (h w))). split.
  - intros i Hi. replace (g i) with (h i) by (unfold h; now rewrite Hi).
    destruct i; leaf.
  - intros j Hj. repeat apply Rmax_lub_lt; now apply Hh.
Qed.

(* Separated parts have no affine dependence with these signs. *)
Lemma no_radon (B : corner -> bool) (l g : corner -> R) j : B o = false ->
  (forall i j, B i = false -> B j = true -> g i < g j) ->
  (forall i, B i = true -> 0 < l i) -> (forall i, B i = false -> l i <= 0) -> B j = true ->
  total l = 0 -> 0 < total (fun i => l i * g i).
Proof.
  intros Ho Hg Hp Hn Hj S. destruct (threshold B g Ho Hg) as (tau & T1 & T2).
  replace (total (fun i => l i * g i)) with (total (fun i => l i * (g i - tau)) + tau * total l) by (unfold total; ring).
  rewrite S, Rmult_0_r, Rplus_0_r.
  assert (P : forall i, B i = true -> 0 < l i * (g i - tau)).
  { intros i Hi. apply Rmult_lt_0_compat; [now apply Hp | generalize (T2 i Hi); lra]. }
  assert (Q : forall i, 0 <= l i * (g i - tau)).
  { intro i. destruct (B i) eqn:E; [now apply Rlt_le, P|].
    generalize (Rmult_le_pos (- l i) (tau - g i)) (Hn i E) (T1 i E). lra. }
  unfold total. generalize (Q o) (Q u) (Q v) (Q w) (P j Hj). destruct j; lra.
Qed.

Section certified.
Variables x y : corners.
Variable e : corner -> R.   (* bounds of the moves *)
Hypothesis near : forall k, norm (y k ⊖ x k) < e k.

Hypothesis positive : 0 < volume x.
Hypothesis apart : forall B i j, B o = false -> B i = false -> B j = true -> (e i + e j) * norm (normal x B) <= volume x.

Lemma still_apart z B i j : (forall k, norm (z k ⊖ x k) < e k) -> B o = false -> B i = false -> B j = true ->
  normal x B · z i < normal x B · z j.
Proof.
  intros Hz Ho Hi Hj. generalize (slab x B i Ho) (slab x B j Ho) (slab_at x B j Ho Hj positive) (apart B i j Ho Hi Hj).
  rewrite Hi, Hj. generalize (Hz i) (Hz j). intros Ni Nj Si Sj L A.
  generalize (dot_le (normal x B) (z i ⊖ x i)) (dot_ge (normal x B) (z j ⊖ x j)).
  replace (normal x B · (z i ⊖ x i)) with (normal x B · z i - normal x B · x i) by (generalize (normal x B); vector).
  replace (normal x B · (z j ⊖ x j)) with (normal x B · z j - normal x B · x j) by (generalize (normal x B); vector).
  intros Di Dj.
  assert (norm (normal x B) * norm (z i ⊖ x i) < norm (normal x B) * e i) by now apply Rmult_lt_compat_l.
  assert (norm (normal x B) * norm (z j ⊖ x j) < norm (normal x B) * e j) by now apply Rmult_lt_compat_l.
  lra.
Qed.

(* No placement within these bounds is flat. *)
Lemma not_flat z : (forall k, norm (z k ⊖ x k) < e k) -> volume z <> 0.
Proof.
  intros Hz F. destruct (flat_dependence _ _ _ F) as (i & j & k & NZ & E).
  assert (D : forall sgn, (sgn = 1 \/ sgn = -1) -> sgn * (i + j + k) >= 0 -> False).
  { intros sgn Hs So.
    pose (l m := match m with o => - sgn * (i + j + k) | u => sgn * i | v => sgn * j | w => sgn * k end).
    assert (S : total l = 0) by (unfold total, l; ring).
    pose (B m := if Rlt_dec 0 (l m) then true else false).
    assert (Ho : B o = false) by (unfold B; destruct (Rlt_dec 0 (l o)) as [K|]; [unfold l in K; lra | reflexivity]).
    assert (Hp : forall m, B m = true -> 0 < l m) by (intro; unfold B; now destruct (Rlt_dec 0 (l m))).
    assert (Hn : forall m, B m = false -> l m <= 0) by (intro; unfold B; destruct (Rlt_dec 0 (l m)); [discriminate | lra]).
    assert (J : exists m, B m = true).
    { destruct (B u) eqn:Eu; [now exists u|]. destruct (B v) eqn:Ev; [now exists v|]. destruct (B w) eqn:Ew; [now exists w|].
      exfalso. apply Hn in Eu. apply Hn in Ev. apply Hn in Ew. apply Hn in Ho. unfold l in *.
      destruct Hs as [-> | ->]; destruct NZ as [N|[N|N]]; apply N; lra. }
    destruct J as (m & Hm).
    assert (G : 0 < total (fun r => l r * (normal x B · z r))).
    { apply no_radon with (B := B) (j := m); try assumption. intros; now apply still_apart. }
    revert G. apply Rle_not_lt, Req_le. 
    replace (total (fun r => l r * (normal x B · z r)))
      with (normal x B · (sgn ⊙ (i ⊙ (z u ⊖ z o) ⊕ j ⊙ (z v ⊖ z o) ⊕ k ⊙ (z w ⊖ z o))))
      by (unfold total, l; generalize (normal x B); vector).
    rewrite E. generalize (normal x B). vector. }
  destruct (Rle_dec 0 (i + j + k)); [apply (D 1) | apply (D (-1))]; lra.
Qed.

Theorem orientation_certified : 0 < volume y.
Proof.
  apply Rnot_le_lt. intro N.
  pose (f t := volume (fun k => along (x k) (y k) t)).
  destruct (vanishes f) as (t & Ht & E).
  - unfold f, volume. apply continuous_vol; apply continuous_sub; apply continuous_along.
  - unfold f, volume. now rewrite !along_0.
  - unfold f, volume. now rewrite !along_1.
  - apply (not_flat (fun k => along (x k) (y k) t)); [|exact E].
    intro k. apply Rle_lt_trans with (2 := near k). now apply along_near.
Qed.
End certified.

Lemma largest_pos x : 0 < volume x -> 0 < largest x.
Proof.
  intro H. destruct (largest_is_one x) as (B & k & Ho & Hk & <-). now apply slab_at with k.
Qed.

Theorem orientation_tolerance x y s : 0 < volume x -> s <= half_width_simplex x ->
  (forall k, norm (y k ⊖ x k) < s) -> 0 < volume y.
Proof.
  intros H Hs near. apply orientation_certified with x (fun _ => s); [exact near | exact H|].
  intros B i j Ho Hi Hj. unfold half_width_simplex in Hs. generalize (largest_pos x H) (normal_le_largest x B). intros L N.
  assert (0 < s) by (generalize (near o) (norm_nonneg (y o ⊖ x o)); lra).
  apply Rmult_le_compat_r with (r := 2 * largest x) in Hs; [|lra].
  unfold Rdiv in Hs. rewrite Rmult_assoc, Rinv_l, Rmult_1_r in Hs by lra.
  assert (2 * s * norm (normal x B) <= 2 * s * largest x) by (apply Rmult_le_compat_l; lra). lra.
Qed.

(* The half width is the largest such number. *)
Theorem orientation_attained x : 0 < volume x ->
  exists y, (forall k, norm (y k ⊖ x k) = half_width_simplex x) /\ volume y = 0.
Proof.
  intro H. destruct (largest_is_one x) as (B & m & Ho & Hm & E). generalize (slab_at x B m Ho Hm H). intro L.
  pose (n := normal x B). fold n in L, E. pose (h := volume x / (2 * sq n)).
  assert (Q : 0 < sq n) by (rewrite <- norm_sq; nra).
  pose (y k := x k ⊕ (if B k then - h else h) ⊙ n). exists y. split.
  - intro k. unfold y. replace (x k ⊕ (if B k then - h else h) ⊙ n ⊖ x k) with ((if B k then - h else h) ⊙ n) by vector.
    rewrite norm_scale. replace (Rabs (if B k then - h else h)) with h.
    + unfold h, half_width_simplex. rewrite <- E, <- norm_sq. field. lra.
    + assert (0 <= h) by (unfold h; apply Rlt_le, Rdiv_lt_0_compat; lra).
      destruct (B k); [rewrite Rabs_Ropp|]; now rewrite Rabs_pos_eq.
  - (* all corners are on the plane n.z = n.x_o + volume / 2 *)
    assert (S : forall k, n · (y k ⊖ y o) = 0).
    { intro k. unfold y. rewrite Ho. generalize (slab x B k Ho). fold n. intro S.
      replace (n · (x k ⊕ (if B k then - h else h) ⊙ n ⊖ (x o ⊕ h ⊙ n)))
        with (n · x k - n · x o + ((if B k then - h else h) - h) * sq n) by (generalize n; vector).
      rewrite S. unfold h. destruct (B k); field; lra. }
    assert (Z0 : forall s t r, n · s = 0 -> n · t = 0 -> n · r = 0 -> vol s t r = 0).
    { intros s t r Hs Ht Hr. apply Rmult_eq_reg_r with (sq n); [|lra]. 
      replace (vol s t r * sq n) with ((n · s) * ((t ✕ r) · n) + (n · t) * ((r ✕ s) · n) + (n · r) * ((s ✕ t) · n)) by vector.
      rewrite Hs, Ht, Hr. ring. }
    unfold volume. now apply Z0.
Qed.
