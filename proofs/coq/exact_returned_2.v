(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The exact stage, for all finite doubles of the coordinate domain: exact_2.v is right.

   - quotient_right    the quotient by two roots is a finite double that is at most the truth
   - orientation_exact_returned, empty_sphere_exact_returned   a sign is right, 0 included; a tolerance is at most half the least altitude or half
                                                               the width; there is always an answer *)
From Coq Require Import Reals Lra Lia ZArith List Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import points_2 width_2 sign_tolerance_2 filter_plane.
From Annulus Require Import operations bridge connect filter_2 stages float_directed interval_2 integers_2 real_terms_2 returned_2 exact_2.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.
Notation is_finite := BinarySingleNaN.is_finite.

Lemma of_integer_below n : (0 <= n)%Z -> is_finite (of_integer mode_DN n 0) = true /\ 0 <= B2R (of_integer mode_DN n 0) <= IZR n.
Proof.
  intro P. apply IZR_le in P. assert (H := normalize_rounded bits exponents _ _ mode_DN n 0). simpl (bpow radix2 0) in H. rewrite Rmult_1_r in H.
  exact (rounded_down_pos bits exponents _ _ _ H P).
Qed.
Lemma root_above_right a : (0 <= a)%Z -> above (root_above a) (R_sqrt.sqrt (IZR a)).
Proof.
  intro P. apply IZR_le in P. apply above_root; [exact P|]. assert (H := normalize_rounded bits exponents _ _ mode_UP a 0).
  simpl (bpow radix2 0) in H. rewrite Rmult_1_r in H. now apply rounded_up.
Qed.
Lemma double_below_right x : is_finite x = true -> 0 <= B2R x -> is_finite (double_below x) = true /\ 0 <= B2R (double_below x) <= B2R x.
Proof.
  destruct x as [s|s| |s m e W]; try discriminate; intros _ P; [simpl; lra|].
  assert (H := normalize_rounded prec emax (eq_refl Lt) (eq_refl Lt) mode_DN (if s then Z.neg m else Z.pos m) e).
  assert (E : B2R (B754_finite s m e W : real) = IZR (if s then Z.neg m else Z.pos m) * bpow radix2 e) by now destruct s.
  rewrite E in *. exact (rounded_down_pos prec emax (eq_refl Lt) _ _ H P).
Qed.

Lemma is_at_least_right numerator a b k y : (0 <= numerator)%Z -> (0 <= a)%Z -> (0 <= b)%Z -> 0 < R_sqrt.sqrt (IZR a) + R_sqrt.sqrt (IZR b) ->
  is_at_least numerator a b k y = true -> B2R y <= IZR numerator * bpow radix2 k / (R_sqrt.sqrt (IZR a) + R_sqrt.sqrt (IZR b)).
Proof.
  intros N A B P. set (roots := R_sqrt.sqrt _ + _) in *. assert (N' := IZR_le _ _ N).
  destruct y as [s|s| |[|] m e W]; try discriminate; intro H.
  { simpl. apply Rle_mult_inv_pos; [apply Rmult_le_pos; [exact N'|apply bpow_ge_0]|exact P]. }
  change (B2R (B754_finite false m e W : double)) with (IZR (Z.pos m) * bpow radix2 e). cbn [is_at_least] in H. cbv zeta in H.
  set (n := if (0 <=? k - e)%Z then _ else _) in H. set (z := if (0 <=? k - e)%Z then Z.pos m else _) in H.
  assert (S : (0 <= n)%Z /\ (0 <= z)%Z /\ exists j, IZR n * bpow radix2 j = IZR numerator * bpow radix2 k /\ IZR z * bpow radix2 j = IZR (Z.pos m) * bpow radix2 e).
  { unfold n, z. destruct (Z.leb_spec 0 (k - e)) as [L|L].
    - split; [apply Z.mul_nonneg_nonneg; [exact N|apply Z.pow_nonneg; lia]|]. split; [lia|]. exists e. split; [|reflexivity].
      rewrite mult_IZR. change 2%Z with (radix_val radix2). rewrite IZR_Zpower by exact L. rewrite Rmult_assoc, <- bpow_plus. f_equal. f_equal. lia.
    - split; [exact N|]. split; [apply Z.mul_nonneg_nonneg; [lia|apply Z.pow_nonneg; lia]|]. exists k. split; [reflexivity|].
      rewrite mult_IZR. change 2%Z with (radix_val radix2). rewrite IZR_Zpower by lia. rewrite Rmult_assoc, <- bpow_plus. f_equal. f_equal. lia. }
  destruct S as (Pn & Pz & j & En & Ez). apply andb_prop in H. destruct H as [H1 H2]. apply Z.leb_le, IZR_le in H1. apply Z.leb_le, IZR_le in H2.
  rewrite !mult_IZR, minus_IZR, !mult_IZR, plus_IZR in H2. rewrite minus_IZR, !mult_IZR, plus_IZR in H1. apply IZR_le in Pn. apply IZR_le in Pz. apply IZR_le in A.
  apply IZR_le in B.
  assert (Q := is_at_least_sound (IZR n) (IZR z) (IZR a) (IZR b) Pn Pz A B H1 H2). fold roots in Q. rewrite <- En, <- Ez.
  apply Rmult_le_reg_r with roots; [exact P|]. replace (IZR n * bpow radix2 j / roots * roots) with (IZR n * bpow radix2 j) by (field; lra).
  apply Rmult_le_compat_r with (r := bpow radix2 j) in Q; [|apply bpow_ge_0]. lra.
Qed.

Theorem quotient_right numerator a b k : (0 <= numerator)%Z -> (0 <= a)%Z -> (0 <= b)%Z -> 0 < R_sqrt.sqrt (IZR a) + R_sqrt.sqrt (IZR b) ->
  is_finite (quotient_by_roots_lower numerator a b k) = true /\
  0 <= B2R (quotient_by_roots_lower numerator a b k) <= IZR numerator * bpow radix2 k / (R_sqrt.sqrt (IZR a) + R_sqrt.sqrt (IZR b)).
Proof.
  intros N A B P. destruct (of_integer_below _ N) as (Fn & Pn & Ln).
  assert (R : above (Bplus mode_UP (root_above a) (root_above b)) (R_sqrt.sqrt (IZR a) + R_sqrt.sqrt (IZR b))) by (apply above_plus; now apply root_above_right).
  unfold quotient_by_roots_lower. cbv zeta. set (roots := Bplus _ _ _) in *. set (truth := R_sqrt.sqrt _ + _) in *.
  destruct (down_quotient bits exponents _ _ _ roots truth Fn Pn R P) as (Fq & Pq & Lq). set (q := Bdiv _ _ _) in *.
  assert (K := bpow_ge_0 radix2 k). assert (Pk : 0 <= B2R q * bpow radix2 k) by now apply Rmult_le_pos.
  destruct (rounded_down_pos bits exponents _ _ _ (ldexp_rounded bits exponents _ _ mode_DN q k Fq) Pk) as (Fr & Pr & Lr). set (result := Bldexp _ _ _) in *.
  destruct (double_below_right result Fr Pr) as (Fl & Pl & Ll). set (lower := double_below result) in *.
  assert (L : B2R lower <= IZR numerator * bpow radix2 k / truth).
  { apply Rle_trans with (B2R q * bpow radix2 k); [lra|]. replace (IZR numerator * bpow radix2 k / truth) with (IZR numerator / truth * bpow radix2 k) by (field; lra).
    apply Rmult_le_compat_r; [exact K|]. apply Rle_trans with (1 := Lq). unfold Rdiv. apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|exact Ln]. }
  set (next := Bsucc lower). destruct (is_finite next) eqn:Fx; [|now split]. simpl negb. cbv iota.
  destruct (Bltb _ _); [now split|]. destruct (is_at_least _ _ _ _ next) eqn:T; [|now split]. split; [exact Fx|].
  split; [|now apply is_at_least_right].
  clear - T. destruct next as [s|s| |[|] m e W]; try discriminate; [apply Rle_refl|]. simpl. now apply F2R_ge_0.
Qed.

(* Terms over integers beside those over reals. *)
Theorem verdict_right c g k t t' w : c = bpow radix2 k -> 0 < g -> scaled_terms c g t t' -> 0 <= inner _ t' -> 0 <= outer _ t' ->
  (0 < determinant _ t' -> half_width t' = w /\ 0 < R_sqrt.sqrt (inner _ t') + R_sqrt.sqrt (outer _ t')) ->
  right_answer (exact_verdict t k) (determinant _ t') w /\ exact_verdict t k <> refused.
Proof.
  intros -> G (D & I & O) PI PO W. assert (K := bpow_gt_0 radix2 k). assert (KG : 0 < bpow radix2 k * g) by now apply Rmult_lt_0_compat.
  unfold exact_verdict. cbv zeta. destruct (Z.ltb_spec (determinant _ t) 0) as [L|L].
  { split; [|discriminate]. simpl. rewrite D. apply IZR_lt in L. nra. }
  destruct (Z.eqb_spec (determinant _ t) 0) as [E|E]; [split; [simpl; rewrite D, E; ring|discriminate]|].
  split; [|discriminate]. assert (L' : (0 < determinant _ t)%Z) by lia. assert (P := IZR_lt _ _ L').
  assert (D' : 0 < determinant _ t') by (rewrite D; nra). destruct (W D') as [<- R].
  assert (G2 : 0 < g * g) by now apply Rmult_lt_0_compat.
  assert (Ai : 0 <= IZR (inner _ t)) by (rewrite I in PI; nra). assert (Ao : 0 <= IZR (outer _ t)) by (rewrite O in PO; nra).
  assert (Root : forall z, 0 <= z -> R_sqrt.sqrt (z * (g * g)) = R_sqrt.sqrt z * g) by (intros; rewrite sqrt_mult, sqrt_square by lra; reflexivity).
  rewrite I, O, !Root, <- Rmult_plus_distr_r in R by assumption.
  assert (Pos : 0 < R_sqrt.sqrt (IZR (inner _ t)) + R_sqrt.sqrt (IZR (outer _ t))) by nra.
  destruct (quotient_right (determinant _ t) (inner _ t) (outer _ t) k ltac:(lia) (le_IZR _ _ Ai) (le_IZR _ _ Ao) Pos) as (F & Q).
  unfold right_answer, finite, value, to_float. rewrite Prim2B_B2Prim. split; [exact F|]. split; [exact D'|].
  unfold half_width. rewrite D, I, O, !Root by assumption.
  replace (IZR (determinant _ t) * (bpow radix2 k * g) / _) with (IZR (determinant _ t) * bpow radix2 k / (R_sqrt.sqrt (IZR (inner _ t)) + R_sqrt.sqrt (IZR (outer _ t)))).
  - exact Q.
  - field. split; [nra|lra].
Qed.

Section returned.
Variable f : nat -> vector machine.
Let ref : nat -> point_2 := fun v => at_2 (f v).

Lemma common_numbers l v : In v l -> (common (numbers l) <= exponent (x _ v))%Z /\ (common (numbers l) <= exponent (y _ v))%Z.
Proof. intro I. split; apply common_le, in_flat_map; exists v; simpl; auto. Qed.

Lemma integers_stand l v w : In v l -> In w l ->
  scaled_vector (bpow radix2 (common (numbers l))) (difference integers (to_integers (common (numbers l)) v) (to_integers (common (numbers l)) w))
    (scaled_by 1 (value (x _ w)) (value (y _ w)) (value (x _ v)) (value (y _ v))).
Proof.
  intros V W. destruct (common_numbers l v V) as [A B], (common_numbers l w W) as [C D].
  destruct (scaled_difference _ _ _ _ _ (scaled_point _ _ _ A B) (scaled_point _ _ _ C D)) as [E G].
  split; [refine (eq_trans _ E)|refine (eq_trans _ G)]; simpl; ring.
Qed.

Theorem orientation_exact_returned a b c :
  right_answer (orientation_exact (f a) (f b) (f c)) (turn_at ref a b c) (half_altitude_at ref a b c) /\ orientation_exact (f a) (f b) (f c) <> refused.
Proof.
  unfold orientation_exact. cbv zeta. set (l := [f a; f b; f c]). set (k := common (numbers l)).
  assert (A : In (f a) l) by (simpl; tauto). assert (B : In (f b) l) by (simpl; tauto). assert (C : In (f c) l) by (simpl; tauto).
  assert (T := orientation_scaled _ _ _ _ _ _ _ (integers_stand l _ _ B A) (integers_stand l _ _ C A) (integers_stand l _ _ C B)).
  generalize (triangle_terms 1 Rlt_0_1 (value (x _ (f a))) (value (y _ (f a))) (value (x _ (f b))) (value (y _ (f b))) (value (x _ (f c))) (value (y _ (f c)))).
  intros (D & I & O & _). rewrite !Rmult_1_l in D. change (turn_at ref a b c) with
    (width_2.turn (value (x _ (f a))) (value (y _ (f a))) (value (x _ (f b))) (value (y _ (f b))) (value (x _ (f c))) (value (y _ (f c)))).
  rewrite <- D. apply (verdict_right _ _ k _ _ _ eq_refl (bpow_gt_0 radix2 k) T I O). rewrite D. intro P.
  destruct (triangle_half 1 Rlt_0_1 _ _ _ _ _ _ P) as [W R]. split; [|exact R]. rewrite W. apply Rmult_1_r.
Qed.

Theorem empty_sphere_exact_returned a b p q :
  right_answer (empty_sphere_exact (f a) (f b) (f p) (f q)) (incircle_at ref a b p q) (half_width_at ref a b p q) /\
  empty_sphere_exact (f a) (f b) (f p) (f q) <> refused.
Proof.
  unfold empty_sphere_exact. cbv zeta. set (l := [f a; f b; f p; f q]). set (k := common (numbers l)).
  assert (A : In (f a) l) by (simpl; tauto). assert (B : In (f b) l) by (simpl; tauto). assert (C : In (f p) l) by (simpl; tauto).
  assert (Q : In (f q) l) by (simpl; tauto).
  assert (T := annulus_scaled _ _ _ _ _ _ _ _ _ (integers_stand l _ _ B A) (integers_stand l _ _ C A) (integers_stand l _ _ Q A) (integers_stand l _ _ Q C)).
  generalize (circle_terms 1 Rlt_0_1 (value (x _ (f a))) (value (y _ (f a))) (value (x _ (f b))) (value (y _ (f b))) (value (x _ (f p))) (value (y _ (f p)))
    (value (x _ (f q))) (value (y _ (f q)))).
  intros (D & I & O & _). rewrite !Rmult_1_l in D. change (incircle_at ref a b p q) with
    (width_2.incircle (value (x _ (f a))) (value (y _ (f a))) (value (x _ (f b))) (value (y _ (f b))) (value (x _ (f p))) (value (y _ (f p)))
      (value (x _ (f q))) (value (y _ (f q)))).
  assert (G : 0 < bpow radix2 k * bpow radix2 k * bpow radix2 k) by (rewrite <- !bpow_plus; apply bpow_gt_0).
  rewrite <- D. apply (verdict_right _ _ k _ _ _ eq_refl G T I O). rewrite D. intro P.
  destruct (circle_half 1 Rlt_0_1 _ _ _ _ _ _ _ _ P) as [W R]. split; [|exact R]. rewrite W. apply Rmult_1_r.
Qed.
End returned.
