(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* As truth_2.v, in space: the tolerance of an empty sphere is the least of the half widths of four annuli, and of the two cells
   where a partition is not certainly the right way round (docs/theory.md 2.2, remark). Judged here are sign and tolerance of the
   later stages against the terms of width_terms_3.h in exact arithmetic. *)
From Coq Require Import Reals ZArith List Bool Lra.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import operations filter_2 filter_3 integers_2 integers_3.
From Annulus_link Require Import truth truth_2.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

(* The half widths that make a tolerance: of four annuli, with cells where one of three sides is not positive. *)
Definition annuli o (t : bicell_terms o) : list (width_terms o) :=
  [of_partition _ t (abc_pq _ t); of_partition _ t (ab_cpq _ t); of_partition _ t (ca_bpq _ t); of_partition _ t (bc_apq _ t)].
Definition needed (t : bicell_terms integers) : bool :=
  (negb (0 <? side _ (ab_cpq _ t)) || negb (0 <? side _ (ca_bpq _ t)) || negb (0 <? side _ (bc_apq _ t)))%Z.
Definition widths (t : bicell_terms integers) : list (width_terms integers) :=
  annuli _ t ++ if needed t then two_cells _ t else [].
Definition needed_really (t : bicell_terms reals) : bool :=
  negb (Rlt_bool 0 (side _ (ab_cpq _ t))) || negb (Rlt_bool 0 (side _ (ca_bpq _ t))) || negb (Rlt_bool 0 (side _ (bc_apq _ t))).
Definition real_widths (t : bicell_terms reals) : list (width_terms reals) :=
  annuli _ t ++ if needed_really t then two_cells _ t else [].

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
