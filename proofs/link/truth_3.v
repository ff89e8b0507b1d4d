(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* As truth_2.v, in space: the tolerance of an empty sphere is the least of the half widths of four annuli, and of the two cells
   where a partition is not certainly the right way round (docs/theory.md 2.2, remark). Judged here are sign and tolerance of the
   later stages against the terms of width_terms_3.h in exact arithmetic. *)
From Coq Require Import Reals ZArith List Bool Lra.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import operations filter_2 filter_3.
From Annulus_link Require Import truth truth_2.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

Definition real_point_3 (a b c : float) : vector_3 reals :=
  {| x3 := value a : number reals; y3 := value b : number reals; z3 := value c : number reals |}.
Definition integer_point_3 (k : Z) (a b c : float) : vector_3 integers :=
  {| x3 := integer k a : number integers; y3 := integer k b : number integers; z3 := integer k c : number integers |}.

Section over.
Variable o : operations.
Definition tetrahedron_of (a b c d : vector_3 o) := orientation_terms_3 o (difference_3 o b a) (difference_3 o c a) (difference_3 o d a).
Definition bicell_of (a b c p q : vector_3 o) :=
  bicell o (difference_3 o b a) (difference_3 o c a) (difference_3 o p a) (difference_3 o q a).

(* The half widths that make a tolerance, as terms. *)
Definition of_partition (t : bicell_terms o) (k : partition o) : width_terms o :=
  {| determinant := insphere _ t; inner := inner_3 _ k; outer := outer_3 _ k |}.
Definition of_cell (d l : number o) : width_terms o := {| determinant := d; inner := l; outer := l |}.
Definition annuli (t : bicell_terms o) : list (width_terms o) :=
  [of_partition t (abc_pq _ t); of_partition t (ab_cpq _ t); of_partition t (ca_bpq _ t); of_partition t (bc_apq _ t)].
Definition two_cells (t : bicell_terms o) : list (width_terms o) :=
  [of_cell (cell_p _ t) (cell_p_slab _ t); of_cell (cell_q _ t) (cell_q_slab _ t)].
End over.

(* With cells where one of three sides is not positive. *)
Definition needed (t : bicell_terms integers) : bool :=
  (negb (0 <? side _ (ab_cpq _ t)) || negb (0 <? side _ (ca_bpq _ t)) || negb (0 <? side _ (bc_apq _ t)))%Z.
Definition widths (t : bicell_terms integers) : list (width_terms integers) :=
  annuli _ t ++ if needed t then two_cells _ t else [].
Definition needed_really (t : bicell_terms reals) : bool :=
  negb (Rlt_bool 0 (side _ (ab_cpq _ t))) || negb (Rlt_bool 0 (side _ (ca_bpq _ t))) || negb (Rlt_bool 0 (side _ (bc_apq _ t))).
Definition real_widths (t : bicell_terms reals) : list (width_terms reals) :=
  annuli _ t ++ if needed_really t then two_cells _ t else [].

(* Scales: coordinates are c times integers, and a term of degree n is c^n times an integer. *)
Section scale.
Variable k : Z.
Let c := bpow radix2 k.
Definition degree (n : nat) (z : number integers) (r : number reals) : Prop := r = IZR z * c ^ n.
Definition degrees (n : nat) (v : vector_3 integers) (w : vector_3 reals) : Prop :=
  degree n (x3 _ v) (x3 _ w) /\ degree n (y3 _ v) (y3 _ w) /\ degree n (z3 _ v) (z3 _ w).

Lemma d_add : forall n z w r s, degree n z r -> degree n w s -> degree n (add integers z w) (add reals r s).
Proof. unfold degree. simpl. intros n z w r s -> ->. rewrite plus_IZR. ring. Qed.
Lemma d_sub : forall n z w r s, degree n z r -> degree n w s -> degree n (sub integers z w) (sub reals r s).
Proof. unfold degree. simpl. intros n z w r s -> ->. rewrite minus_IZR. ring. Qed.
Lemma d_mul : forall n m z w r s, degree n z r -> degree m w s -> degree (n + m) (mul integers z w) (mul reals r s).
Proof. unfold degree. simpl. intros n m z w r s -> ->. rewrite mult_IZR, pow_add. ring. Qed.
Lemma d_square : forall n z r, degree n z r -> degree (n + n) (square integers z) (square reals r).
Proof. intros. now apply d_mul. Qed.
Lemma d_opp : forall n z r, degree n z r -> degree n (opposite integers z) (opposite reals r).
Proof. unfold degree. simpl. intros n z r ->. rewrite opp_IZR. ring. Qed.
Lemma d_max : forall n z w r s, degree n z r -> degree n w s -> degree n (greater integers z w) (greater reals r s).
Proof. unfold degree. simpl. intros n z w r s -> ->. apply Rmax_scaled. apply pow_le, bpow_ge_0. Qed.

Lemma v_plus : forall n v w v' w', degrees n v v' -> degrees n w w' -> degrees n (plus_3 integers v w) (plus_3 reals v' w').
Proof. intros n v w v' w' (A & B & C) (D & E & F). repeat split; now apply d_add. Qed.
Lemma v_difference : forall n v w v' w', degrees n v v' -> degrees n w w' ->
  degrees n (difference_3 integers v w) (difference_3 reals v' w').
Proof. intros n v w v' w' (A & B & C) (D & E & F). repeat split; now apply d_sub. Qed.
Lemma v_minus : forall n v v', degrees n v v' -> degrees n (minus_3 integers v) (minus_3 reals v').
Proof. intros n v v' (A & B & C). repeat split; now apply d_opp. Qed.
Lemma v_cross : forall n m v w v' w', degrees n v v' -> degrees m w w' -> degrees (n + m) (cross integers v w) (cross reals v' w').
Proof. intros n m v w v' w' (A & B & C) (D & E & F). repeat split; apply d_sub; now apply d_mul. Qed.
Lemma d_dot : forall n m v w v' w', degrees n v v' -> degrees m w w' -> degree (n + m) (dot integers v w) (dot reals v' w').
Proof. intros n m v w v' w' (A & B & C) (D & E & F). apply d_add; [apply d_add|]; now apply d_mul. Qed.
Lemma d_square_3 : forall n v v', degrees n v v' -> degree (n + n) (square_3 integers v) (square_3 reals v').
Proof. intros n v v' (A & B & C). apply d_add; [apply d_add|]; now apply d_square. Qed.
Lemma v_combination : forall n m r u s v t w r' u' s' v' t' w',
  degree n r r' -> degrees m u u' -> degree n s s' -> degrees m v v' -> degree n t t' -> degrees m w w' ->
  degrees (n + m) (combination integers r u s v t w) (combination reals r' u' s' v' t' w').
Proof.
  intros n m r u s v t w r' u' s' v' t' w' R (U & U1 & U2) S (V & V1 & V2) T (W & W1 & W2).
  repeat split; (apply d_add; [apply d_sub|]); now apply d_mul.
Qed.
Lemma v_minus_twice : forall n m v l a v' l' a', degrees (n + m) v v' -> degree n l l' -> degrees m a a' ->
  degrees (n + m) (minus_twice integers v l a) (minus_twice reals v' l' a').
Proof.
  intros n m v l a v' l' a' (V & V1 & V2) L (A & A1 & A2).
  repeat split; (apply d_sub; [assumption|]); apply d_mul; trivial; now apply d_add.
Qed.

Lemma d_slab : forall n u v w u' v' w', degrees n u u' -> degrees n v v' -> degrees n w w' ->
  degree (n + n) (largest_slab integers u v w) (largest_slab reals u' v' w').
Proof.
  intros n u v w u' v' w' U V W. unfold largest_slab. cbv zeta.
  pose proof (v_plus _ _ _ _ _ U V) as A. pose proof (v_plus _ _ _ _ _ V W) as B. pose proof (v_plus _ _ _ _ _ W U) as C.
  pose proof (v_plus _ _ _ _ _ A W) as D.
  apply d_max; apply d_max; try apply d_max; now apply d_square_3.
Qed.

Definition degree_terms (i j : nat) (t : width_terms integers) (t' : width_terms reals) : Prop :=
  degree i (determinant _ t) (determinant _ t') /\ degree j (inner _ t) (inner _ t') /\ degree j (outer _ t) (outer _ t').

Lemma degree_scaled : forall i t t', degree_terms (S i) (i + i) t t' -> scaled_terms c (c ^ i) t t'.
Proof.
  intros i t t' (D & I & O). unfold degree in *. repeat split; [exact D| |]; rewrite <- pow_add; assumption.
Qed.

Section bicell.
Variables (b d p q : vector_3 integers) (b' d' p' q' : vector_3 reals).
Hypothesis Hb : degrees 1 b b'.
Hypothesis Hc : degrees 1 d d'.
Hypothesis Hp : degrees 1 p p'.
Hypothesis Hq : degrees 1 q q'.
Let t := bicell integers b d p q.
Let t' := bicell reals b' d' p' q'.

Lemma bicell_degrees :
  (degree_terms 5 8 (of_partition _ t (abc_pq _ t)) (of_partition _ t' (abc_pq _ t')) /\
   degree_terms 5 8 (of_partition _ t (ab_cpq _ t)) (of_partition _ t' (ab_cpq _ t')) /\
   degree_terms 5 8 (of_partition _ t (ca_bpq _ t)) (of_partition _ t' (ca_bpq _ t')) /\
   degree_terms 5 8 (of_partition _ t (bc_apq _ t)) (of_partition _ t' (bc_apq _ t'))) /\
  (degree_terms 3 4 (of_cell _ (cell_p _ t) (cell_p_slab _ t)) (of_cell _ (cell_p _ t') (cell_p_slab _ t')) /\
   degree_terms 3 4 (of_cell _ (cell_q _ t) (cell_q_slab _ t)) (of_cell _ (cell_q _ t') (cell_q_slab _ t'))) /\
  (degree 3 (side _ (ab_cpq _ t)) (side _ (ab_cpq _ t')) /\ degree 3 (side _ (ca_bpq _ t)) (side _ (ca_bpq _ t')) /\
   degree 3 (side _ (bc_apq _ t)) (side _ (bc_apq _ t'))).
Proof.
  pose proof (v_cross 1 1 _ _ _ _ Hb Hc) as bc. pose proof (v_cross 1 1 _ _ _ _ Hb Hp) as bp.
  pose proof (v_cross 1 1 _ _ _ _ Hb Hq) as bq. pose proof (v_cross 1 1 _ _ _ _ Hc Hp) as cp.
  pose proof (v_cross 1 1 _ _ _ _ Hc Hq) as cq. pose proof (v_cross 1 1 _ _ _ _ Hp Hq) as pq.
  pose proof (d_square_3 1 _ _ Hb) as bb. pose proof (d_square_3 1 _ _ Hc) as cc.
  pose proof (d_square_3 1 _ _ Hp) as pp. pose proof (d_square_3 1 _ _ Hq) as qq.
  pose proof (d_dot 2 1 _ _ _ _ cp Hq) as lb. pose proof (d_dot 2 1 _ _ _ _ bq Hp) as lc.
  pose proof (d_dot 2 1 _ _ _ _ bc Hq) as lp. pose proof (d_dot 2 1 _ _ _ _ bc Hp) as nq.
  pose proof (d_add 5 _ _ _ _ (d_add 5 _ _ _ _ (d_mul 3 2 _ _ _ _ lb bb) (d_mul 3 2 _ _ _ _ lc cc))
                              (d_sub 5 _ _ _ _ (d_mul 3 2 _ _ _ _ lp pp) (d_mul 3 2 _ _ _ _ nq qq))) as det.
  pose proof (v_combination 2 2 _ _ _ _ _ _ _ _ _ _ _ _ bb cq cc bq qq bc) as up.
  pose proof (v_combination 2 2 _ _ _ _ _ _ _ _ _ _ _ _ bb cp cc bp pp bc) as vq.
  pose proof (v_combination 2 2 _ _ _ _ _ _ _ _ _ _ _ _ cc pq pp cq qq cp) as ub.
  pose proof (v_combination 2 2 _ _ _ _ _ _ _ _ _ _ _ _ bb pq pp bq qq bp) as vc.
  pose proof (d_sub 3 _ _ _ _ lp nq) as l1. pose proof (v_difference 4 _ _ _ _ up vq) as n1.
  pose proof (v_minus_twice 3 1 _ _ _ _ _ _ n1 l1 Hp) as m1.
  pose proof (d_add 3 _ _ _ _ l1 lc) as l2. pose proof (v_difference 4 _ _ _ _ n1 vc) as n2.
  pose proof (v_minus_twice 3 1 _ _ _ _ _ _ n2 l2 Hc) as m2.
  pose proof (d_add 3 _ _ _ _ l1 lb) as l3. pose proof (v_plus 4 _ _ _ _ n1 ub) as n3.
  pose proof (v_minus_twice 3 1 _ _ _ _ _ _ n3 l3 Hb) as m3.
  pose proof (d_add 3 _ _ _ _ lb lc) as l4. pose proof (v_difference 4 _ _ _ _ ub vc) as n4.
  pose proof (v_minus_twice 3 1 _ _ _ _ _ _ n4 l4 Hb) as m4.
  pose proof (d_slab 2 _ _ _ _ _ _ (v_minus 2 _ _ bc) bp (v_minus 2 _ _ cp)) as sp.
  pose proof (d_slab 2 _ _ _ _ _ _ bc cq (v_minus 2 _ _ bq)) as sq.
  repeat split; first
    [exact det|exact (d_square_3 4 _ _ n1)|exact (d_square_3 4 _ _ m1)|exact (d_square_3 4 _ _ n2)|exact (d_square_3 4 _ _ m2)
    |exact (d_square_3 4 _ _ n3)|exact (d_square_3 4 _ _ m3)|exact (d_square_3 4 _ _ n4)|exact (d_square_3 4 _ _ m4)
    |exact (d_opp 3 _ _ nq)|exact lp|exact sp|exact sq|exact l2|exact l3|exact (d_opp 3 _ _ l4)].
Qed.
End bicell.
End scale.

(* One half width, 0 where its determinant is not positive. *)
Definition width (t : width_terms reals) : R := if Rlt_bool 0 (determinant _ t) then half_width t else 0.

(* y = Y c against one: at most it; and less than it. *)
Definition at_most_width (t : width_terms integers) (Y : Z) : bool :=
  if (0 <? determinant _ t)%Z then proper t && below_half_width t Y else (Y =? 0)%Z.
Definition more_than_width (t : width_terms integers) (Y : Z) : bool :=
  if (0 <? determinant _ t)%Z then proper t && negb (below_half_width t Y) else (0 <? Y)%Z.

Lemma width_spec : forall c g t t' Y, 0 < c -> 0 < g -> scaled_terms c g t t' -> (0 <= Y)%Z ->
  (at_most_width t Y = true -> IZR Y * c <= width t') /\ (more_than_width t Y = true -> width t' < IZR Y * c).
Proof.
  intros c g t t' Y Hc Hg H PY. unfold width, at_most_width, more_than_width.
  destruct H as (D & I & O).
  assert (G : 0 < c * g) by now apply Rmult_lt_0_compat.
  destruct (0 <? determinant _ t)%Z eqn:P.
  - apply Z.ltb_lt in P. assert (P' := IZR_lt _ _ P).
    assert (D' : Rlt_bool 0 (determinant _ t') = true) by (apply Rlt_bool_true; rewrite D; nra). rewrite D'.
    unfold proper. rewrite !andb_true_iff, !Z.leb_le, !Z.ltb_lt.
    split; intros [[[Q1 Q2] Q3] L].
    + now apply (below_half_width_spec c g t t').
    + apply negb_true_iff in L. apply Rnot_le_lt. intro M.
      apply (below_half_width_spec c g t t') in M; trivial; [congruence|now repeat split].
  - apply Z.ltb_ge, IZR_le in P.
    assert (D' : Rlt_bool 0 (determinant _ t') = false) by (apply Rlt_bool_false; rewrite D; nra). rewrite D'.
    rewrite Z.eqb_eq, Z.ltb_lt. split; intro L.
    + rewrite L. lra.
    + apply IZR_lt in L. nra.
Qed.

(* Lists of half widths, integers beside reals. *)
Definition match_up (c : R) (t : width_terms integers) (t' : width_terms reals) := exists g, 0 < g /\ scaled_terms c g t t'.

Lemma forall_width : forall c ts ts' Y, 0 < c -> (0 <= Y)%Z -> Forall2 (match_up c) ts ts' ->
  forallb (fun t => at_most_width t Y) ts = true -> Forall (fun t => IZR Y * c <= width t) ts'.
Proof.
  intros c ts ts' Y Hc PY H. induction H as [|t t' ts ts' (g & G & S) H IH]; simpl; intro F; [constructor|].
  apply andb_prop in F. destruct F as [F1 F2]. constructor; [|now apply IH].
  now apply (width_spec c g t t' Y Hc G S PY).
Qed.
Lemma exists_width : forall c ts ts' Y, 0 < c -> (0 <= Y)%Z -> Forall2 (match_up c) ts ts' ->
  existsb (fun t => more_than_width t Y) ts = true -> Exists (fun t => width t < IZR Y * c) ts'.
Proof.
  intros c ts ts' Y Hc PY H. induction H as [|t t' ts ts' (g & G & S) H IH]; simpl; intro F; [discriminate|].
  apply orb_prop in F. destruct F as [F|F]; [left|right; now apply IH].
  now apply (width_spec c g t t' Y Hc G S PY).
Qed.

(* The answer of an empty sphere: sign, and the largest double that is at most every width (`sharp`), or one at most every one. *)
Definition sound_3 (t : bicell_terms integers) (k : Z) (a : answer float) : bool :=
  match a with
  | refused => true
  | negative y => (insphere _ t <? 0)%Z && is_zero y
  | zero y => (insphere _ t =? 0)%Z && is_zero y
  | positive y => (0 <? insphere _ t)%Z && plain_float y && (k <=? exponent y)%Z &&
                  forallb (fun w => at_most_width w (integer k y)) (widths t)
  end.
Definition sharp_3 (t : bicell_terms integers) (k : Z) (a : answer float) : bool :=
  sound_3 t k a &&
  match a with
  | refused => false
  | positive y => let z := PrimFloat.next_up y in
                  plain_float z && (k <=? exponent z)%Z && existsb (fun w => more_than_width w (integer k z)) (widths t)
  | _ => true
  end.
Definition soundly_3 (t : bicell_terms reals) (a : answer float) : Prop :=
  match a with
  | refused => True
  | negative y => insphere _ t < 0 /\ value y = 0
  | zero y => insphere _ t = 0 /\ value y = 0
  | positive y => 0 < insphere _ t /\ 0 <= value y /\ Forall (fun w => value y <= width w) (real_widths t)
  end.
Definition sharply_3 (t : bicell_terms reals) (a : answer float) : Prop :=
  soundly_3 t a /\
  match a with
  | refused => False
  | positive y => Exists (fun w => width w < value (PrimFloat.next_up y)) (real_widths t)
  | _ => True
  end.

Section judgement.
Variables (k : Z) (b c p q : vector_3 integers) (b' c' p' q' : vector_3 reals).
Hypothesis Hb : degrees k 1 b b'.
Hypothesis Hc : degrees k 1 c c'.
Hypothesis Hp : degrees k 1 p p'.
Hypothesis Hq : degrees k 1 q q'.
Let t := bicell integers b c p q.
Let t' := bicell reals b' c' p' q'.
Let s := bpow radix2 k.

Lemma power_positive : forall n, 0 < s ^ n.
Proof. intro n. apply pow_lt, bpow_gt_0. Qed.

Lemma side_sign : forall z r, degree k 3 z r -> negb (0 <? z)%Z = negb (Rlt_bool 0 r).
Proof.
  intros z r H. unfold degree in H. fold s in H. assert (P := power_positive 3). f_equal.
  destruct (Z.ltb_spec 0 z) as [L|L]; symmetry.
  - apply Rlt_bool_true. apply IZR_lt in L. rewrite H. now apply Rmult_lt_0_compat.
  - apply Rlt_bool_false. apply IZR_le in L. rewrite H. generalize (Rmult_le_compat_r _ _ _ (Rlt_le _ _ P) L). lra.
Qed.

Lemma widths_match : Forall2 (match_up s) (widths t) (real_widths t').
Proof.
  destruct (bicell_degrees k _ _ _ _ _ _ _ _ Hb Hc Hp Hq) as ((A1 & A2 & A3 & A4) & (C1 & C2) & (S2 & S3 & S4)).
  assert (M : forall i w w', degree_terms k (S i) (i + i) w w' -> match_up s w w').
  { intros i w w' H. exists (s ^ i). split; [apply power_positive|now apply degree_scaled]. }
  assert (E : needed t = needed_really t').
  { unfold needed, needed_really, t, t'. now rewrite (side_sign _ _ S2), (side_sign _ _ S3), (side_sign _ _ S4). }
  unfold widths, real_widths. rewrite E. apply Forall2_app.
  - repeat (constructor; [eapply (M 4%nat); eassumption|]). constructor.
  - destruct (needed_really t'); [|constructor]. repeat (constructor; [eapply (M 2%nat); eassumption|]). constructor.
Qed.

Lemma insphere_degree : insphere _ t' = IZR (insphere _ t) * s ^ 5.
Proof. exact (proj1 (proj1 (proj1 (bicell_degrees k _ _ _ _ _ _ _ _ Hb Hc Hp Hq)))). Qed.

Theorem sound_3_spec : forall a, sound_3 t k a = true -> soundly_3 t' a.
Proof.
  assert (P := power_positive 5). assert (D := insphere_degree).
  assert (Neg : forall z, (z < 0)%Z -> IZR z * s ^ 5 < 0).
  { intros z H. apply IZR_lt in H. generalize (Rmult_lt_compat_r _ _ _ P H). rewrite Rmult_0_l. exact (fun h => h). }
  assert (Pos : forall z, (0 < z)%Z -> 0 < IZR z * s ^ 5).
  { intros z H. apply IZR_lt in H. now apply Rmult_lt_0_compat. }
  intros [|f|f|f] H.
  - exact I.
  - apply andb_prop in H. destruct H as [N Z]. apply Z.ltb_lt in N.
    split; [rewrite D; exact (Neg _ N)|apply is_zero_value, Z].
  - apply andb_prop in H. destruct H as [N Z]. apply Z.eqb_eq in N.
    split; [rewrite D, N; apply Rmult_0_l|apply is_zero_value, Z].
  - unfold sound_3 in H. rewrite !andb_true_iff in H. destruct H as [[[N F] K] L]. apply Z.ltb_lt in N. apply Z.leb_le in K.
    assert (Y := plain_integer k f F K). split; [|split].
    + rewrite D. exact (Pos _ N).
    + rewrite (value_integer k f K). apply Rmult_le_pos; [apply IZR_le, Y|apply bpow_ge_0].
    + apply (forall_width s _ _ _ (bpow_gt_0 _ _) Y widths_match) in L.
      eapply Forall_impl; [|exact L]. intros w W. rewrite (value_integer k f K). exact W.
Qed.

Theorem sharp_3_spec : forall a, sharp_3 t k a = true -> sharply_3 t' a.
Proof.
  intros a H. apply andb_prop in H. destruct H as [S L]. split; [exact (sound_3_spec a S)|].
  destruct a as [|f|f|f]; trivial; [discriminate|]. cbv zeta in L. rewrite !andb_true_iff in L. destruct L as [[F K] L].
  apply Z.leb_le in K. assert (Y := plain_integer k _ F K).
  apply (exists_width s _ _ _ (bpow_gt_0 _ _) Y widths_match) in L.
  eapply Exists_impl; [|exact L]. intros w W. rewrite (value_integer k _ K). exact W.
Qed.
End judgement.

Lemma degrees_point : forall k a b c, (k <= exponent a)%Z -> (k <= exponent b)%Z -> (k <= exponent c)%Z ->
  degrees k 1 (integer_point_3 k a b c) (real_point_3 a b c).
Proof.
  intros k a b c A B C. unfold degrees, degree. simpl. rewrite Rmult_1_r.
  repeat split; now apply value_integer.
Qed.

(* Two answers of one bi-cell: the first sound, the second sharp. *)
Definition judge_bicell (ax ay az bx by' bz cx cy cz px py pz qx qy qz : float) (i e : answer float) : bool :=
  let k := common ([ax; ay; az; bx; by'; bz; cx; cy; cz; px; py; pz; qx; qy; qz] ++ numbers_of i ++ numbers_of e) in
  let t := bicell_of integers (integer_point_3 k ax ay az) (integer_point_3 k bx by' bz) (integer_point_3 k cx cy cz)
             (integer_point_3 k px py pz) (integer_point_3 k qx qy qz) in
  sound_3 t k i && sharp_3 t k e.
Definition true_bicell (ax ay az bx by' bz cx cy cz px py pz qx qy qz : float) (i e : answer float) : Prop :=
  let t := bicell_of reals (real_point_3 ax ay az) (real_point_3 bx by' bz) (real_point_3 cx cy cz)
             (real_point_3 px py pz) (real_point_3 qx qy qz) in
  soundly_3 t i /\ sharply_3 t e.

Theorem judge_bicell_spec : forall ax ay az bx by' bz cx cy cz px py pz qx qy qz i e,
  judge_bicell ax ay az bx by' bz cx cy cz px py pz qx qy qz i e = true ->
  true_bicell ax ay az bx by' bz cx cy cz px py pz qx qy qz i e.
Proof.
  intros ax ay az bx by' bz cx cy cz px py pz qx qy qz i e J. unfold judge_bicell in J. cbv zeta in J.
  apply andb_prop in J. destruct J as [I E]. unfold true_bicell. cbv zeta.
  set (k := common _) in *.
  assert (A : degrees k 1 (integer_point_3 k ax ay az) (real_point_3 ax ay az)) by (apply degrees_point; member).
  assert (B : degrees k 1 (integer_point_3 k bx by' bz) (real_point_3 bx by' bz)) by (apply degrees_point; member).
  assert (C : degrees k 1 (integer_point_3 k cx cy cz) (real_point_3 cx cy cz)) by (apply degrees_point; member).
  assert (P : degrees k 1 (integer_point_3 k px py pz) (real_point_3 px py pz)) by (apply degrees_point; member).
  assert (Q : degrees k 1 (integer_point_3 k qx qy qz) (real_point_3 qx qy qz)) by (apply degrees_point; member).
  pose proof (v_difference k 1 _ _ _ _ B A) as B'. pose proof (v_difference k 1 _ _ _ _ C A) as C'.
  pose proof (v_difference k 1 _ _ _ _ P A) as P'. pose proof (v_difference k 1 _ _ _ _ Q A) as Q'.
  split; [exact (sound_3_spec k _ _ _ _ _ _ _ _ B' C' P' Q' i I)|exact (sharp_3_spec k _ _ _ _ _ _ _ _ B' C' P' Q' e E)].
Qed.

(* Of a tetrahedron: one half width. *)
Lemma tetrahedron_degrees : forall k u v w u' v' w', degrees k 1 u u' -> degrees k 1 v v' -> degrees k 1 w w' ->
  degree_terms k 3 4 (orientation_terms_3 integers u v w) (orientation_terms_3 reals u' v' w').
Proof.
  intros k u v w u' v' w' U V W.
  pose proof (v_cross k 1 1 _ _ _ _ U V) as uv. pose proof (v_cross k 1 1 _ _ _ _ V W) as vw. pose proof (v_cross k 1 1 _ _ _ _ W U) as wu.
  pose proof (d_slab k 2 _ _ _ _ _ _ uv vw wu) as slab. split; [exact (d_dot k 2 1 _ _ _ _ uv W)|split; exact slab].
Qed.

Definition judge_tetrahedron (ax ay az bx by' bz cx cy cz dx dy dz : float) (i e : answer float) : bool :=
  let k := common ([ax; ay; az; bx; by'; bz; cx; cy; cz; dx; dy; dz] ++ numbers_of i ++ numbers_of e) in
  let t := tetrahedron_of integers (integer_point_3 k ax ay az) (integer_point_3 k bx by' bz) (integer_point_3 k cx cy cz)
             (integer_point_3 k dx dy dz) in
  sound t k i && sharp t k e.
Definition true_tetrahedron (ax ay az bx by' bz cx cy cz dx dy dz : float) (i e : answer float) : Prop :=
  let t := tetrahedron_of reals (real_point_3 ax ay az) (real_point_3 bx by' bz) (real_point_3 cx cy cz) (real_point_3 dx dy dz) in
  soundly t i /\ sharply t e.

Theorem judge_tetrahedron_spec : forall ax ay az bx by' bz cx cy cz dx dy dz i e,
  judge_tetrahedron ax ay az bx by' bz cx cy cz dx dy dz i e = true -> true_tetrahedron ax ay az bx by' bz cx cy cz dx dy dz i e.
Proof.
  intros ax ay az bx by' bz cx cy cz dx dy dz i e J. unfold judge_tetrahedron in J. cbv zeta in J.
  apply andb_prop in J. destruct J as [I E]. unfold true_tetrahedron. cbv zeta.
  set (k := common _) in *.
  assert (A : degrees k 1 (integer_point_3 k ax ay az) (real_point_3 ax ay az)) by (apply degrees_point; member).
  assert (B : degrees k 1 (integer_point_3 k bx by' bz) (real_point_3 bx by' bz)) by (apply degrees_point; member).
  assert (C : degrees k 1 (integer_point_3 k cx cy cz) (real_point_3 cx cy cz)) by (apply degrees_point; member).
  assert (D : degrees k 1 (integer_point_3 k dx dy dz) (real_point_3 dx dy dz)) by (apply degrees_point; member).
  pose proof (degree_scaled k 2 _ _ (tetrahedron_degrees k _ _ _ _ _ _ (v_difference k 1 _ _ _ _ B A) (v_difference k 1 _ _ _ _ C A)
    (v_difference k 1 _ _ _ _ D A))) as T.
  split; [exact (sound_spec k _ _ _ (power_positive k 2) T i I)|exact (sharp_spec k _ _ _ (power_positive k 2) T e E)].
Qed.
