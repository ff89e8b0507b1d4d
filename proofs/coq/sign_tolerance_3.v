(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The empty sphere of a bi-cell in space, certified from a reference x for a placement y: docs/theory.md, section 2.2.

   delimiter_3              a partition whose annulus at x is wider than the moves of its two sides cannot be the Radon
                            partition of cospherical points
   sign_tolerance_3         all six half widths (four annuli, two cells) from one reference. The cells may have any sign at y
   sign_tolerance_3_unequal the same with a bound for each point's move
   sign_tolerance_3_own     both cells positive at y, by whatever certificate; then the half widths of the cells at x are needed only
                            where Lam < 0 for one of the partitions, and there the sign at y of one lambda will do instead
                            (own_cells.v: without either it is false) *)
Require Import Reals Lra Psatz.
From Annulus Require Export vectors motion tetrahedron delimiter bicell radon_3.
Open Scope R_scope.

(* The cells with their positive order of corners. *)
Definition corner_q k := match k with o => a | u => b | v => c | w => q end.
Definition corner_p k := match k with o => a | u => c | v => b | w => p end.
Definition cell_q (x : placement) : corners := fun k => x (corner_q k).
Definition cell_p (x : placement) : corners := fun k => x (corner_p k).

Lemma volume_q x : volume (cell_q x) = lambda x p.
Proof. unfold volume, cell_q, lambda, lambda_p, rel. cbn [corner_q]. vector. Qed.

Lemma volume_p x : volume (cell_p x) = lambda x q.
Proof. unfold volume, cell_p, lambda, lambda_q, rel. cbn [corner_p]. vector. Qed.

Lemma det_continuous x y : continuity (fun t => det (fun k => along (x k) (y k) t)).
Proof.
  assert (K : forall i, continuous_vec (fun t => rel (fun k => along (x k) (y k) t) i))
    by (intro; apply continuous_sub; apply continuous_along).
  assert (T : forall (f : R -> R) i, continuity f -> continuity (fun t => f t * sq (rel (fun k => along (x k) (y k) t) i)))
    by (intros f i Hf; apply continuous_mult; [exact Hf | apply continuous_sq, K]).
  unfold det. apply continuous_plus; [apply continuous_plus; [apply continuous_plus|]|]; apply T.
  - now apply continuous_vol.
  - now apply continuous_opp, continuous_vol.
  - now apply continuous_vol.
  - now apply continuous_opp, continuous_vol.
Qed.

Section certified.
Variables x y : placement.
Variable e : vertex -> R.   (* bounds of the moves *)
Definition close z := forall k, norm (z k ⊖ x k) < e k.
Hypothesis near : close y.
Hypothesis holds : 0 < det x.

(* The width of the annulus of B is at least what the two sides may have moved together. *)
Definition apart B := forall i j, B i = false -> B j = true -> (e i + e j) * arms x B i j <= 2 * det x.

Lemma moved B z i : quadric (Lam x B) (N x B) 0 (x a) (z i) =
  one x B i - one x B a + Lam x B * sq (z i ⊖ x i) - arm x B i · (z i ⊖ x i).
Proof.
  rewrite <- level. unfold quadric, arm, rel. generalize (Lam x B) (N x B) (x a) (x i) (z i). vector.
Qed.

Theorem delimiter_3 B z i j : apart B -> close z -> B i = false -> B j = true ->
  quadric (Lam x B) (N x B) 0 (x a) (z i) < quadric (Lam x B) (N x B) 0 (x a) (z j).
Proof.
  intros A Hz Hi Hj. rewrite !moved. unfold one. rewrite Hi, Hj.
  generalize (dot_ge (arm x B i) (z i ⊖ x i)) (dot_le (arm x B j) (z j ⊖ x j)). rewrite <- !norm_sq. intros Gi Gj.
  generalize (gap (Lam x B) (det x) (norm (arm x B i)) (norm (arm x B j)) (e i) (e j) (norm (z i ⊖ x i)) (norm (z j ⊖ x j))
    (radii x B i j Hi Hj) holds (norm_nonneg _) (norm_nonneg _) (arms_pos x B i j Hi Hj (Rgt_not_eq _ _ holds))
    (conj (norm_nonneg _) (Hz i)) (conj (norm_nonneg _) (Hz j)) (A i j Hi Hj)).
  lra.
Qed.

Corollary excluded B z : apart B -> close z -> four B -> 0 < lambda z p -> 0 < lambda z q -> radon z B -> 0 < Lam x B * det z.
Proof.
  intros A Hz HB Hp Hq HR. apply (separated z) with (N x B) 0 (x a) B; try assumption.
  intros. now apply delimiter_3.
Qed.

Hypothesis annuli : forall B, four B -> apart B.

(* No cospherical placement this close has two positive cells. *)
Lemma not_cospherical z : close z -> 0 < lambda z p -> 0 < lambda z q -> det z <> 0.
Proof.
  intros Hz Hp Hq E. destruct (radon_cases z Hp Hq) as [D | (B & HB & HR)]; [lra|].
  generalize (excluded B z (annuli B HB) Hz HB Hp Hq HR). rewrite E. lra.
Qed.

(* The slabs of the two cells are at least that wide, too. *)
Definition slabs_apart (cell : corners) (f : corner -> R) := forall S i j, S o = false -> S i = false -> S j = true ->
  (f i + f j) * norm (normal cell S) <= volume cell.
Definition cells_apart := slabs_apart (cell_p x) (fun k => e (corner_p k)) /\ slabs_apart (cell_q x) (fun k => e (corner_q k)).

Lemma cells_stay z : close z -> 0 < lambda x p -> 0 < lambda x q -> cells_apart -> 0 < lambda z p /\ 0 < lambda z q.
Proof.
  intros Hz Hp Hq (Sp & Sq). rewrite <- !volume_p, <- !volume_q in *. split.
  - now apply orientation_certified with (cell_q x) (fun k => e (corner_q k)); [intro k; apply Hz | | ].
  - now apply orientation_certified with (cell_p x) (fun k => e (corner_p k)); [intro k; apply Hz | | ].
Qed.

Theorem sign_tolerance_3_unequal : 0 < lambda x p -> 0 < lambda x q -> cells_apart -> 0 < det y.
Proof.
  intros Hp Hq C. apply Rnot_le_lt. intro D.
  destruct (vanishes _ (det_continuous x y)) as (t & Ht & E).
  - replace (det (fun k => along (x k) (y k) 0)) with (det x); [exact holds|].
    unfold det, lambda_b, lambda_c, lambda_p, lambda_q, rel. now rewrite !along_0.
  - replace (det (fun k => along (x k) (y k) 1)) with (det y); [exact D|].
    unfold det, lambda_b, lambda_c, lambda_p, lambda_q, rel. now rewrite !along_1.
  - assert (Hz : close (fun k => along (x k) (y k) t)).
    { intro k. apply Rle_lt_trans with (2 := near k). now apply along_near. }
    destruct (cells_stay _ Hz Hp Hq C) as (Zp & Zq).
    now apply (not_cospherical _ Hz Zp Zq).
Qed.

(* With the cells' signs known at y: a partition whose annulus is the right way round (or flat) needs nothing more. One that
   is the wrong way round needs the half widths of the cells, from the same reference, or one positive lambda at y off B. *)
Theorem sign_tolerance_3_own_unequal : 0 < lambda x p -> 0 < lambda x q -> 0 < lambda y p -> 0 < lambda y q ->
  (forall B, four B -> 0 <= Lam x B \/ cells_apart \/ exists i, B i = false /\ 0 <= lambda y i) ->
  0 < det y.
Proof.
  intros Xp Xq Hp Hq W. destruct (radon_cases y Hp Hq) as [D | (B & HB & HR)]; [exact D|].
  generalize (excluded B y (annuli B HB) near HB Hp Hq HR). intro E.
  destruct (W B HB) as [L | [C | (i & Hi & Li)]].
  - apply Rnot_le_lt. intro D. generalize (Rmult_le_pos (Lam x B) (- det y)). lra.
  - now apply sign_tolerance_3_unequal.
  - generalize (proj1 HR i Hi). lra.
Qed.
End certified.

(* What the code computes. The points named are the one with |N| alone and one of the other side. *)
Definition annuli_half_width x :=
  Rmin (Rmin (half_width x pq a p) (half_width x cpq a c)) (Rmin (half_width x bpq a b) (half_width x apq b a)).
Definition cells_half_width x := Rmin (half_width_simplex (cell_p x)) (half_width_simplex (cell_q x)).
Definition tolerance_3 x := Rmin (annuli_half_width x) (cells_half_width x).

Lemma annuli_equal x s : 0 < det x -> s <= annuli_half_width x -> forall B, four B -> apart x (fun _ => s) B.
Proof.
  intros H Hs B HB i j Hi Hj.
  assert (K : forall B r t, B r = false -> B t = true -> s <= half_width x B r t -> B i = false -> B j = true ->
    (s + s) * arms x B i j <= 2 * det x).
  { clear. intros B r t Hr Ht Hs Hi Hj. unfold half_width in Hs.
    assert (E : arms x B i j = arms x B r t).
    { unfold arms. rewrite (equal_arms x B i r), (equal_arms x B j t); congruence. }
    rewrite E. destruct (Req_dec (det x) 0) as [D|D].
    - rewrite D in *. unfold Rdiv in Hs. rewrite Rmult_0_l in Hs. generalize (arms_nonneg x B r t). nra.
    - assert (A := arms_pos x B r t Hr Ht D).
      apply Rmult_le_compat_r with (r := 2 * arms x B r t) in Hs; [|lra].
      replace (det x / arms x B r t * (2 * arms x B r t)) with (2 * det x) in Hs by (field; lra). lra. }
  unfold annuli_half_width in Hs.
  assert (s <= half_width x pq a p /\ s <= half_width x cpq a c /\ s <= half_width x bpq a b /\ s <= half_width x apq b a)
    as (S1 & S2 & S3 & S4).
  { revert Hs. unfold Rmin. repeat destruct Rle_dec; lra. }
  destruct HB as [ -> | [ -> | [ -> | -> ]]]; [apply (K pq a p) | apply (K cpq a c) | apply (K bpq a b) | apply (K apq b a)];
    assumption || reflexivity.
Qed.

Lemma slabs_equal cell s : 0 < volume cell -> 0 <= s -> s <= half_width_simplex cell -> slabs_apart cell (fun _ => s).
Proof.
  intros H H0 Hs S i j Ho Hi Hj. generalize (largest_pos cell H) (normal_le_largest cell S). intros L N.
  unfold half_width_simplex in Hs. apply Rmult_le_compat_r with (r := 2 * largest cell) in Hs; [|lra].
  replace (volume cell / (2 * largest cell) * (2 * largest cell)) with (volume cell) in Hs by (field; lra).
  assert (2 * s * norm (normal cell S) <= 2 * s * largest cell) by (apply Rmult_le_compat_l; lra). lra.
Qed.

Lemma cells_equal x s : 0 < lambda x p -> 0 < lambda x q -> 0 <= s -> s <= cells_half_width x -> cells_apart x (fun _ => s).
Proof.
  intros Hp Hq H0 Hs. unfold cells_half_width in Hs.
  assert (s <= half_width_simplex (cell_p x) /\ s <= half_width_simplex (cell_q x)) as (S1 & S2)
    by (revert Hs; unfold Rmin; destruct Rle_dec; lra).
  split; apply slabs_equal; try assumption; first [now rewrite volume_p | now rewrite volume_q].
Qed.

Section equal.
Variables x y : placement.
Variable s : R.
Hypothesis near : forall k, norm (y k ⊖ x k) < s.
Hypothesis cell_positive_p : 0 < lambda x p.
Hypothesis cell_positive_q : 0 < lambda x q.
Hypothesis empty : 0 < det x.

Lemma s_nonneg : 0 <= s.
Proof. generalize (near a) (norm_nonneg (y a ⊖ x a)). lra. Qed.

Theorem sign_tolerance_3 : s <= tolerance_3 x -> 0 < det y /\ 0 < lambda y p /\ 0 < lambda y q.
Proof.
  intro H. assert (s <= annuli_half_width x /\ s <= cells_half_width x) as (A & C)
    by (revert H; unfold tolerance_3, Rmin at 1; destruct Rle_dec; lra).
  assert (G : cells_apart x (fun _ => s)) by (apply cells_equal; try assumption; apply s_nonneg). split.
  - apply sign_tolerance_3_unequal with x (fun _ => s); try assumption. now apply annuli_equal.
  - now apply cells_stay with x (fun _ => s).
Qed.

(* The bi-cell's own tolerance, its cells being certified at y by their own records. *)
Definition own_tolerance_3 :=
  if Rle_dec 0 (Rmin (Lam x cpq) (Rmin (Lam x bpq) (Lam x apq))) then annuli_half_width x else tolerance_3 x.

Theorem sign_tolerance_3_own : 0 < lambda y p -> 0 < lambda y q -> s <= own_tolerance_3 -> 0 < det y.
Proof.
  intros Yp Yq. unfold own_tolerance_3. destruct Rle_dec as [L|L]; intro H; [|now apply sign_tolerance_3].
  apply sign_tolerance_3_own_unequal with x (fun _ => s); try assumption; [now apply annuli_equal|].
  intros B HB. left.
  assert (0 <= Lam x cpq /\ 0 <= Lam x bpq /\ 0 <= Lam x apq) as (L1 & L2 & L3)
    by (revert L; unfold Rmin; repeat destruct Rle_dec; intros; lra).
  destruct HB as [ -> | [ -> | [ -> | -> ]]]; try assumption. rewrite (proj1 (abc_pq x)).
  simpl lambda in *. lra.
Qed.
End equal.

(* Where Lam < 0 one of the points off B has a positive lambda, so there always is a sign to certify. *)
Lemma negative_side x B : Lam x B < 0 -> exists i, B i = false /\ 0 < lambda x i.
Proof.
  intro H. assert (D := dependence x). unfold Lam, sum, among in *.
  destruct (B a) eqn:Ea, (B b) eqn:Eb, (B c) eqn:Ec, (B p) eqn:Ep, (B q) eqn:Eq;
  first [ lra
  | destruct (Rlt_dec 0 (lambda x a)); [exists a; split; assumption|]
  | idtac ];
  first [ lra | destruct (Rlt_dec 0 (lambda x b)); [exists b; split; assumption|] | idtac ];
  first [ lra | destruct (Rlt_dec 0 (lambda x c)); [exists c; split; assumption|] | idtac ];
  first [ lra | destruct (Rlt_dec 0 (lambda x p)); [exists p; split; assumption|] | idtac ];
  first [ lra | destruct (Rlt_dec 0 (lambda x q)); [exists q; split; assumption|] | idtac ]; lra.
Qed.

(* Each lambda is the volume of the other four points, so its sign has a tolerance by tetrahedron.v. *)
Definition corner_a k := match k with o => b | u => p | v => c | w => q end.
Definition corner_b k := match k with o => a | u => c | v => p | w => q end.
Definition corner_c k := match k with o => a | u => p | v => b | w => q end.

Lemma volume_others x : volume (fun k => x (corner_a k)) = lambda x a /\ volume (fun k => x (corner_b k)) = lambda x b /\
  volume (fun k => x (corner_c k)) = lambda x c.
Proof. unfold volume, lambda, lambda_b, lambda_c, lambda_p, lambda_q, rel. repeat split; simpl; vector. Qed.
