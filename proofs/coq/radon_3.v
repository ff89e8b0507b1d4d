(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Signs of the affine dependence of the five points of a bi-cell in space, both cells being positive: docs/theory.md, section 2.2.

   radon_cases              the certificate holds, or the negative ones are the rest of one of the four partitions of the code
   separated                a function that separates such a partition has, at it, the sign of the certificate
   pointwise_3              no reference at all: both cells positive, and for each of the four partitions a sphere or a plane
                            with the facet's points of that partition inside (on its side) and the others outside *)
Require Import Reals Lra Psatz.
From Annulus Require Export vectors motion tetrahedron delimiter bicell.
Open Scope R_scope.

Definition four (B : vertex -> bool) := B = pq \/ B = cpq \/ B = bpq \/ B = apq.

(* Separated parts have no affine dependence with these signs. *)
Lemma threshold_5 (B : vertex -> bool) (g : vertex -> R) r : B r = false ->
  (forall i j, B i = false -> B j = true -> g i < g j) ->
  exists tau, (forall i, B i = false -> g i <= tau) /\ (forall j, B j = true -> tau < g j).
Proof.
  intros Hr H. pose (h k := if B k then g r else g k).
  assert (Hh : forall k j, B j = true -> h k < g j) by (intros k j Hj; unfold h; destruct (B k) eqn:E; now apply H).
  exists (Rmax (h a) (Rmax (Rmax (h b) (h c)) (Rmax (h p) (h q)))). split.
  - intros i Hi. replace (g i) with (h i) by (unfold h; now rewrite Hi). destruct i; leaf.
  - intros j Hj. repeat apply Rmax_lub_lt; now apply Hh.
Qed.

Lemma no_radon_5 (B : vertex -> bool) (l g : vertex -> R) r j : B r = false ->
  (forall i j, B i = false -> B j = true -> g i < g j) ->
  (forall i, B i = true -> 0 <= l i) -> (forall i, B i = false -> l i <= 0) -> B j = true -> 0 < l j ->
  sum l = 0 -> 0 < sum (fun i => l i * g i).
Proof.
  intros Hr Hg Hp Hn Hj Lj S. destruct (threshold_5 B g r Hr Hg) as (tau & T1 & T2).
  replace (sum (fun i => l i * g i)) with (sum (fun i => l i * (g i - tau)) + tau * sum l) by (unfold sum; ring).
  rewrite S, Rmult_0_r, Rplus_0_r.
  assert (P : 0 < l j * (g j - tau)) by (apply Rmult_lt_0_compat; [exact Lj | generalize (T2 j Hj); lra]).
  assert (Q : forall i, 0 <= l i * (g i - tau)).
  { intro i. destruct (B i) eqn:E.
    - apply Rmult_le_pos; [now apply Hp | generalize (T2 i E); lra].
    - generalize (Rmult_le_pos (- l i) (tau - g i)) (Hn i E) (T1 i E). lra. }
  unfold sum. generalize (Q a) (Q b) (Q c) (Q p) (Q q). destruct j; lra.
Qed.

(* What the signs of the dependence can be where both cells are positive: the negative ones are one point of the facet, and
   then the certificate holds, or B is the rest of two or three of them. *)
Section signs.
Variable z : placement.
Hypothesis cell_positive_p : 0 < lambda z p.
Hypothesis cell_positive_q : 0 < lambda z q.

Definition radon (B : vertex -> bool) :=
  (forall i, B i = false -> lambda z i < 0) /\ (forall i, B i = true -> 0 <= lambda z i).

Lemma reflex f : f <> p -> f <> q -> (forall i, i <> f -> 0 <= lambda z i) -> 0 < det z.
Proof.
  intros Fp Fq H. generalize (powers z 1 zero 0 (z f)). rewrite Rmult_1_l. intros <-.
  assert (E : forall i, quadric 1 zero 0 (z f) (z i) = sq (z i ⊖ z f)) by (intro; unfold quadric; vector).
  assert (O : sq (z f ⊖ z f) = 0) by vector.
  assert (T : forall i, 0 <= lambda z i * sq (z i ⊖ z f)).
  { intro i. destruct (Rle_dec 0 (lambda z i)) as [L|L]; [apply Rmult_le_pos; [exact L | apply sq_nonneg]|].
    replace i with f by (destruct i, f; try reflexivity; exfalso; apply L, H; discriminate). rewrite O. lra. }
  assert (P : 0 < sq (z p ⊖ z f)).
  { apply sq_pos. intro Ez. assert (lambda z q = 0); [|lra].
    assert (Ep : rel z p = rel z f) by (unfold rel; replace (z p) with (z p ⊖ z f ⊕ z f) by vector; rewrite Ez; vector).
    unfold lambda, lambda_q. rewrite Ep. destruct f; try (now elim Fp); try (now elim Fq); rewrite ?rel_a; vector. }
  unfold sum. rewrite !E.
  generalize (T a) (T b) (T c) (T q) (Rmult_lt_0_compat _ _ cell_positive_p P). lra.
Qed.

Theorem radon_cases : 0 < det z \/ exists B, four B /\ radon B.
Proof.
  generalize (dependence z). unfold sum. intro S.
  assert (four_pq : four pq) by now left.
  assert (four_cpq : four cpq) by now right; left.
  assert (four_bpq : four bpq) by now right; right; left.
  assert (four_apq : four apq) by now right; right; right.
  destruct (Rlt_dec (lambda z a) 0) as [La|La]; destruct (Rlt_dec (lambda z b) 0) as [Lb|Lb];
    destruct (Rlt_dec (lambda z c) 0) as [Lc|Lc].
  - right. exists pq. repeat split; try assumption; intros i; destruct i; simpl pq; intro; try discriminate; lra.
  - right. exists cpq. repeat split; try assumption; intros i; destruct i; simpl cpq; intro; try discriminate; lra.
  - right. exists bpq. repeat split; try assumption; intros i; destruct i; simpl bpq; intro; try discriminate; lra.
  - left. apply (reflex a); try discriminate. intros i Hi; destruct i; try (now elim Hi); lra.
  - right. exists apq. repeat split; try assumption; intros i; destruct i; simpl apq; intro; try discriminate; lra.
  - left. apply (reflex b); try discriminate. intros i Hi; destruct i; try (now elim Hi); lra.
  - left. apply (reflex c); try discriminate. intros i Hi; destruct i; try (now elim Hi); lra.
  - exfalso. lra.
Qed.

Lemma four_pick B : four B -> exists r, B r = false /\ B p = true.
Proof. intros [ -> | [ -> | [ -> | -> ]]]; [exists a | exists a | exists a | exists b]; now split. Qed.

(* At the Radon partition a function of this kind that separates has the sign of its square term's coefficient times det. *)
Lemma separated k n t o B : four B -> radon B ->
  (forall i j, B i = false -> B j = true -> quadric k n t o (z i) < quadric k n t o (z j)) -> 0 < k * det z.
Proof.
  intros HB (Rn & Rp) S. rewrite <- (powers z k n t o). destruct (four_pick B HB) as (r & Hr & Hp).
  apply (no_radon_5 B (lambda z) (fun i => quadric k n t o (z i)) r p); try assumption.
  - intros i Hi. generalize (Rn i Hi). lra.
  - apply dependence.
Qed.

Theorem pointwise_3 :
  (forall B, four B -> exists k n t o, 0 <= k /\ (forall i, B i = false -> quadric k n t o (z i) < 0) /\
                                     (forall i, B i = true -> 0 < quadric k n t o (z i))) ->
  0 < det z.
Proof.
  intro H. destruct radon_cases as [D | (B & HB & HR)]; [exact D|].
  destruct (H B HB) as (k & n & t & o & Hk & Hn & Hp).
  assert (0 < k * det z).
  { apply (separated k n t o B HB HR). intros i j Hi Hj. generalize (Hn i Hi) (Hp j Hj). lra. }
  apply Rnot_le_lt. intro D. generalize (Rmult_le_pos k (- det z)). lra.
Qed.

End signs.
