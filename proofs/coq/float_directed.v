(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Directed rounding in any binary format, as Flocq's binary_float computes it: what the interval stage does in doubles and MPFR with 128 bits.
   Infinities are bounds like others, so that overflow needs no care.

   - rounded_up, rounded_down    a result that is rounded upward is not below the truth, downward not above it; overflow and underflow in it
   - above_plus .. above_root    operations rounded upward keep upper bounds
   - quotient_le                 a determinant over two roots, from bounds of the three
   - is_at_least_sound           the comparison of a double with a quotient by two roots, in integers only; is_at_least_complete: the other way *)
Require Import Reals Lra Psatz ZArith.
From Coq Require Import SpecFloat.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
Open Scope R_scope.

Section format.
Variables prec emax : Z.
Context (prec_pos : Prec_gt_0 prec) (emax_large : Prec_lt_emax prec emax).
Notation number := (binary_float prec emax).
Notation power := (bpow radix2).
Notation round_to m := (round radix2 (SpecFloat.fexp prec emax) (round_mode m)).

#[local] Instance format_valid : Valid_exp (SpecFloat.fexp prec emax) := fexp_correct prec emax prec_pos.
#[local] Instance mode_valid m : Valid_rnd (round_mode m) := valid_rnd_round_mode m.

(* x is at most e; at least e. *)
Definition above (e : number) (x : R) : Prop := is_finite e = true /\ x <= B2R e \/ e = B754_infinity false.
Definition under (e : number) (x : R) : Prop := is_finite e = true /\ B2R e <= x \/ e = B754_infinity true.

Lemma above_le e x y : x <= y -> above e y -> above e x.
Proof. intros L [[F H]|H]; [left; split; [exact F|lra]|now right]. Qed.
Lemma under_le e x y : y <= x -> under e y -> under e x.
Proof. intros L [[F H]|H]; [left; split; [exact F|lra]|now right]. Qed.

Lemma under_opp e x : under e x <-> above (Bopp e) (- x).
Proof.
  unfold under, above. rewrite is_finite_Bopp, B2R_Bopp. split; intros [[F H]|H]; try (left; split; [exact F|lra]); right.
  - now rewrite H.
  - rewrite <- (Bopp_involutive _ _ e), H. reflexivity.
Qed.
Lemma opp_under e x : above e (- x) -> under (Bopp e) x.
Proof. intro H. apply under_opp. now rewrite Bopp_involutive. Qed.

(* What Flocq says of each operation: x rounded, or what the rounding has in place of too large a number. *)
Definition rounded (m : mode) (z : number) (x : R) : Prop :=
  if Rlt_bool (Rabs (round_to m x)) (power emax) then B2R z = round_to m x /\ is_finite z = true
  else B2SF z = binary_overflow prec emax m (Rlt_bool x 0).

Lemma greatest_value : IZR (Z.pos (Z.to_pos (2 ^ prec - 1))) * power (emax - prec) <= power emax.
Proof.
  assert (P : (1 <= prec)%Z) by (unfold Prec_gt_0 in prec_pos; lia). assert (T : (2 ^ 1 <= 2 ^ prec)%Z) by (apply Z.pow_le_mono_r; lia).
  replace (power emax) with (power prec * power (emax - prec)) by (rewrite <- bpow_plus; f_equal; ring).
  apply Rmult_le_compat_r; [apply bpow_ge_0|]. rewrite Z2Pos.id by lia. rewrite <- IZR_Zpower by lia. apply IZR_le. simpl radix_val. lia.
Qed.

Lemma finite_value (z : number) s m e : B2SF z = S754_finite s m e -> is_finite z = true /\ B2R z = (if s then -1 else 1) * (IZR (Z.pos m) * power e).
Proof.
  destruct z as [s'|s'| |s' m' e' B]; try discriminate. intro H. injection H as -> -> ->. split; [reflexivity|].
  unfold B2R, F2R. simpl. destruct s; simpl; [|ring]. rewrite <- Pos2Z.opp_pos, opp_IZR. ring.
Qed.
Lemma infinite_value (z : number) s : B2SF z = S754_infinity s -> z = B754_infinity s.
Proof. destruct z; try discriminate. intro H. now injection H as ->. Qed.

Theorem rounded_up z x : rounded mode_UP z x -> above z x.
Proof.
  unfold rounded. assert (U : x <= round_to mode_UP x) by (apply round_UP_pt; auto with typeclass_instances). case Rlt_bool_spec; intro L.
  - intros [V F]. left. split; [exact F|]. now rewrite V.
  - simpl. case Rlt_bool_spec; intro N; simpl; intro E.
    + left. destruct (finite_value _ _ _ _ E) as [F V]. split; [exact F|]. rewrite V. generalize greatest_value.
      assert (R0 : round_to mode_UP x <= 0).
      { rewrite <- (round_0 radix2 (SpecFloat.fexp prec emax) (round_mode mode_UP)). apply round_le; auto with typeclass_instances; lra. }
      rewrite Rabs_left1 in L by exact R0. lra.
    + right. exact (infinite_value _ _ E).
Qed.

Theorem rounded_down z x : rounded mode_DN z x -> under z x.
Proof.
  unfold rounded. assert (U : round_to mode_DN x <= x) by (apply round_DN_pt; auto with typeclass_instances). case Rlt_bool_spec; intro L.
  - intros [V F]. left. split; [exact F|]. now rewrite V.
  - simpl. case Rlt_bool_spec; intro N; simpl; intro E.
    + right. exact (infinite_value _ _ E).
    + left. destruct (finite_value _ _ _ _ E) as [F V]. split; [exact F|]. rewrite V. generalize greatest_value.
      assert (R0 : 0 <= round_to mode_DN x).
      { rewrite <- (round_0 radix2 (SpecFloat.fexp prec emax) (round_mode mode_DN)). apply round_le; auto with typeclass_instances; lra. }
      rewrite Rabs_pos_eq in L by exact R0. lra.
Qed.

(* The sign bit that an overflow keeps is the sign. *)
Lemma sign_value (a : number) : if Bsign a then B2R a <= 0 else 0 <= B2R a.
Proof.
  destruct a as [[|]|[|]| |[|] m e B]; simpl; try lra.
  - apply F2R_le_0. simpl. easy.
  - apply F2R_ge_0. simpl. easy.
Qed.
Lemma too_large m x : power emax <= Rabs (round_to m x) -> x <> 0.
Proof.
  intros L ->. rewrite round_0, Rabs_R0 in L by auto with typeclass_instances. generalize (bpow_gt_0 radix2 emax). lra.
Qed.
Lemma overflow_sign (s : bool) m x : power emax <= Rabs (round_to m x) -> (if s then x <= 0 else 0 <= x) -> Rlt_bool x 0 = s.
Proof. intros L H. assert (N := too_large m x L). destruct s; [apply Rlt_bool_true|apply Rlt_bool_false]; lra. Qed.

Lemma product_sign (a b : number) : if xorb (Bsign a) (Bsign b) then B2R a * B2R b <= 0 else 0 <= B2R a * B2R b.
Proof. generalize (sign_value a) (sign_value b). destruct (Bsign a), (Bsign b); simpl; nra. Qed.

Lemma plus_rounded m (a b : number) : is_finite a = true -> is_finite b = true -> rounded m (Bplus m a b) (B2R a + B2R b).
Proof.
  intros A B. generalize (Bplus_correct prec emax _ _ m a b A B). unfold rounded. case Rlt_bool_spec; intro L; [intuition|].
  intros [-> S]. f_equal. symmetry. apply (overflow_sign _ m _ L). generalize (sign_value a) (sign_value b). rewrite <- S. destruct (Bsign a); lra.
Qed.
Lemma minus_rounded m (a b : number) : is_finite a = true -> is_finite b = true -> rounded m (Bminus m a b) (B2R a - B2R b).
Proof.
  intros A B. generalize (Bminus_correct prec emax _ _ m a b A B). unfold rounded. case Rlt_bool_spec; intro L; [intuition|].
  intros [-> S]. f_equal. symmetry. apply (overflow_sign _ m _ L). generalize (sign_value a) (sign_value b). rewrite S. destruct (Bsign b); simpl; lra.
Qed.
Lemma times_rounded m (a b : number) : is_finite a = true -> is_finite b = true -> rounded m (Bmult m a b) (B2R a * B2R b).
Proof.
  intros A B. generalize (Bmult_correct prec emax _ _ m a b). unfold rounded. rewrite A, B. case Rlt_bool_spec; intro L; [intuition|].
  intros ->. f_equal. symmetry. apply (overflow_sign _ m _ L), product_sign.
Qed.
Lemma over_rounded m (a b : number) : is_finite a = true -> B2R b <> 0 -> rounded m (Bdiv m a b) (B2R a / B2R b).
Proof.
  intros A B. generalize (Bdiv_correct prec emax _ _ m a b B). unfold rounded. rewrite A. case Rlt_bool_spec; intro L; [intuition|].
  intros ->. f_equal. symmetry. apply (overflow_sign _ m _ L). generalize (sign_value a) (sign_value b). intros Sa Sb.
  assert (I : if Bsign b then / B2R b < 0 else 0 < / B2R b) by (destruct (Bsign b); [apply Rinv_lt_0_compat|apply Rinv_0_lt_compat]; lra).
  unfold Rdiv. destruct (Bsign a), (Bsign b); simpl; nra.
Qed.
Lemma normalize_rounded m n e : rounded m (binary_normalize prec emax _ _ m n e false) (IZR n * power e).
Proof.
  generalize (binary_normalize_correct prec emax _ _ m n e false). cbv zeta. unfold F2R. simpl. unfold rounded.
  case Rlt_bool_spec; intro L; [intuition|trivial].
Qed.
Lemma ldexp_rounded m (a : number) e : is_finite a = true -> rounded m (Bldexp m a e) (B2R a * power e).
Proof.
  intro A. generalize (Bldexp_correct prec emax _ _ m a e). unfold rounded. rewrite A. case Rlt_bool_spec; intro L; [intuition|].
  intros ->. f_equal. symmetry. apply (overflow_sign _ m _ L). generalize (sign_value a) (bpow_gt_0 radix2 e). destruct (Bsign a); nra.
Qed.

(* ---- Upper bounds of results from bounds of operands ---- *)

Lemma above_plus a b x y : above a x -> above b y -> above (Bplus mode_UP a b) (x + y).
Proof.
  intros [[A X]| ->] [[B Y]| ->].
  - apply above_le with (B2R a + B2R b); [lra|]. now apply rounded_up, plus_rounded.
  - right. now destruct a.
  - right. now destruct b.
  - now right.
Qed.
Lemma above_minus a b x y : above a x -> under b y -> above (Bminus mode_UP a b) (x - y).
Proof.
  intros [[A X]| ->] [[B Y]| ->].
  - apply above_le with (B2R a - B2R b); [lra|]. now apply rounded_up, minus_rounded.
  - right. now destruct a.
  - right. now destruct b.
  - now right.
Qed.
Lemma above_root a x : 0 <= x -> above a x -> above (Bsqrt mode_UP a) (sqrt x).
Proof.
  intros P [[A X]| ->]; [left|now right]. destruct (Bsqrt_correct prec emax _ _ mode_UP a) as (V & F & _). split.
  - rewrite F. destruct a as [s|s| |[|] m e B]; try easy. exfalso. apply (Rlt_not_le 0 x); [|exact P]. apply Rle_lt_trans with (1 := X).
    simpl. now apply F2R_lt_0.
  - rewrite V. apply Rle_trans with (sqrt (B2R a)); [now apply sqrt_le_1_alt|]. apply round_UP_pt; auto with typeclass_instances.
Qed.

(* Downward from a number that is not negative: finite. *)
Lemma rounded_down_pos z x : rounded mode_DN z x -> 0 <= x -> is_finite z = true /\ 0 <= B2R z <= x.
Proof.
  intros H P. assert (D := rounded_down z x H). revert H. unfold rounded. case Rlt_bool_spec; intro L.
  - intros [V F]. split; [exact F|]. destruct D as [[_ D]|D]; [|now rewrite D in F]. split; [|exact D]. rewrite V.
    rewrite <- (round_0 radix2 (SpecFloat.fexp prec emax) (round_mode mode_DN)). apply round_le; auto with typeclass_instances.
  - rewrite (Rlt_bool_false x 0 P). intro E. destruct (finite_value _ _ _ _ E) as [F V]. split; [exact F|].
    destruct D as [[_ D]|D]; [|now rewrite D in F]. split; [|exact D]. rewrite V, Rmult_1_l. apply Rmult_le_pos; [now apply IZR_le|apply bpow_ge_0].
Qed.
Lemma down_quotient a b y : is_finite a = true -> 0 <= B2R a -> above b y -> 0 < y ->
  is_finite (Bdiv mode_DN a b) = true /\ 0 <= B2R (Bdiv mode_DN a b) <= B2R a / y.
Proof.
  intros A P [[B L]| ->] Y; assert (D : 0 <= B2R a / y) by (apply Rle_mult_inv_pos; assumption).
  - assert (I : 0 <= B2R a / B2R b <= B2R a / y).
    { unfold Rdiv. assert (/ B2R b <= / y) by (apply Rinv_le; lra). assert (0 < / B2R b) by (apply Rinv_0_lt_compat; lra). split; nra. }
    destruct (rounded_down_pos _ _ (over_rounded mode_DN a b A ltac:(lra)) (proj1 I)) as (F & Q). split; [exact F|]. lra.
  - destruct a as [s|s| |s m e W]; try discriminate; (split; [reflexivity|]; split; [apply Rle_refl|exact D]).
Qed.

(* A quotient rounded downward, as the opposite of one rounded upward: finite. *)
Lemma quotient_down a b y : is_finite a = true -> 0 <= B2R a -> above b y -> 0 < y ->
  let q := Bopp (Bdiv mode_UP (Bopp a) b) in is_finite q = true /\ 0 <= B2R q <= B2R a / y.
Proof.
  intros A P H Y q. assert (D : 0 <= B2R a / y) by (apply Rle_mult_inv_pos; assumption). destruct H as [[B L]| ->].
  - assert (I : B2R (Bopp a) / B2R b <= 0 /\ - (B2R (Bopp a) / B2R b) <= B2R a / y).
    { rewrite B2R_Bopp. unfold Rdiv. assert (/ B2R b <= / y) by (apply Rinv_le; lra). assert (0 < / B2R b) by (apply Rinv_0_lt_compat; lra). split; nra. }
    assert (R : rounded mode_UP (Bdiv mode_UP (Bopp a) b) (B2R (Bopp a) / B2R b)) by (apply over_rounded; [now rewrite is_finite_Bopp|lra]).
    assert (U := rounded_up _ _ R). assert (NP : is_finite (Bdiv mode_UP (Bopp a) b) = true /\ B2R (Bdiv mode_UP (Bopp a) b) <= 0).
    { revert R. unfold rounded. case Rlt_bool_spec; intro O.
      - intros [V F]. split; [exact F|]. rewrite V. rewrite <- (round_0 radix2 (SpecFloat.fexp prec emax) (round_mode mode_UP)).
        apply round_le; auto with typeclass_instances. apply I.
      - rewrite (overflow_sign true mode_UP _ O (proj1 I)). intro E. destruct (finite_value _ _ _ _ E) as [F V]. split; [exact F|]. rewrite V.
        assert (0 <= IZR (Z.pos (Z.to_pos (2 ^ prec - 1))) * power (emax - prec)) by (apply Rmult_le_pos; [now apply IZR_le|apply bpow_ge_0]). lra. }
    unfold q. rewrite is_finite_Bopp, B2R_Bopp. split; [apply NP|]. destruct U as [[_ U]|U]; [lra|]. rewrite U in NP. now destruct NP.
  - unfold q. destruct a as [s|s| |s m e W]; try discriminate; (split; [reflexivity|]; split; [apply Rle_refl|exact D]).
Qed.
End format.
Arguments above {prec emax} e x.
Arguments under {prec emax} e x.

(* Bounds of a determinant and of the squares below the roots, whatever they come from. *)
Lemma quotient_le det det' s s' : 0 <= det' <= det -> 0 < s -> s <= s' -> det' / s' <= det / s.
Proof. intros D P S. unfold Rdiv. apply Rmult_le_compat; try lra; [left; apply Rinv_0_lt_compat; lra|apply Rinv_le; lra]. Qed.

(* The comparison of a double y = z 2^k with x 2^k / (sqrt a + sqrt b), in integers only. *)
Theorem is_at_least_sound x z a b : 0 <= x -> 0 <= z -> 0 <= a -> 0 <= b ->
  let r := x * x - z * z * (a + b) in
  0 <= r -> 4 * (z * z) * (z * z) * a * b <= r * r -> z * (sqrt a + sqrt b) <= x.
Proof.
  intros X Z A B r R H.
  generalize (sqrt_sqrt a A) (sqrt_sqrt b B) (sqrt_pos a) (sqrt_pos b). set (s := sqrt a). set (t := sqrt b). intros S T S0 T0.
  assert (zz : 0 <= z * z) by (apply Rle_0_sqr). assert (st : 0 <= s * t) by now apply Rmult_le_pos.
  assert (C : 2 * (z * z) * (s * t) <= r).
  { apply Rsqr_incr_0_var; [| exact R]. unfold Rsqr.
    replace (2 * (z * z) * (s * t) * (2 * (z * z) * (s * t))) with (4 * (z * z) * (z * z) * (s * s) * (t * t)) by ring.
    now rewrite S, T. }
  apply Rsqr_incr_0_var; [| exact X]. unfold Rsqr.
  replace (z * (s + t) * (z * (s + t))) with (z * z * (s * s + t * t) + 2 * (z * z) * (s * t)) by ring.
  rewrite S, T. unfold r in C. lra.
Qed.

(* And the other way: it says no only where z is too large. *)
Theorem is_at_least_complete x z a b : 0 <= x -> 0 <= z -> 0 <= a -> 0 <= b ->
  let r := x * x - z * z * (a + b) in
  z * (sqrt a + sqrt b) <= x -> 0 <= r /\ 4 * (z * z) * (z * z) * a * b <= r * r.
Proof.
  intros X Z A B r H.
  generalize (sqrt_sqrt a A) (sqrt_sqrt b B) (sqrt_pos a) (sqrt_pos b). set (s := sqrt a) in *. set (t := sqrt b) in *.
  intros S T S0 T0.
  assert (zz : 0 <= z * z) by (apply Rle_0_sqr). assert (st : 0 <= s * t) by now apply Rmult_le_pos.
  assert (Q : z * (s + t) * (z * (s + t)) <= x * x).
  { apply Rmult_le_compat; try assumption; apply Rmult_le_pos; lra. }
  assert (C : 2 * (z * z) * (s * t) <= r).
  { unfold r. rewrite <- S, <- T. replace (z * (s + t) * (z * (s + t)))
      with (z * z * (s * s + t * t) + 2 * (z * z) * (s * t)) in Q by ring. lra. }
  assert (C0 : 0 <= 2 * (z * z) * (s * t)) by (apply Rmult_le_pos; lra).
  split; [lra |].
  rewrite <- S, <- T. replace (4 * (z * z) * (z * z) * (s * s) * (t * t))
    with (2 * (z * z) * (s * t) * (2 * (z * z) * (s * t))) by ring.
  apply Rmult_le_compat; assumption.
Qed.
