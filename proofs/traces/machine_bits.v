(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Upper halves of doubles, which machine.v takes apart and puts together by operations on bits: they are what IEEE 754 says of mantissa and
   exponent, as truncated_double.v has it.

   - half_of_bits      Expiry::lower, in any bounds: the upper half of the bits of a positive number
   - value_of_bits     Expiry::path_length *)
From Coq Require Import Uint63 ZArith Lia Bool Floats.
From Flocq Require Import Core.
From Annulus Require Import algorithm_list truncated_double.
From Annulus_traces Require Import machine.

(* ---- Canonical mantissas ---- *)

Lemma digits m k : (SpecFloat.digits2_pos m <= k)%positive -> (Zpos m < 2 ^ Zpos k)%Z.
Proof.
  intro H. assert (C := Digits.Zdigits_correct radix2 (Zpos m)). rewrite <- Digits.Zpos_digits2_pos in C. destruct C as [_ C].
  apply Z.lt_le_trans with (1 := C). apply Z.pow_le_mono_r; [reflexivity|]. exact H.
Qed.
Lemma digits_least m k : (0 < k)%Z -> Zpos (SpecFloat.digits2_pos m) = k -> (2 ^ (k - 1) <= Zpos m)%Z.
Proof.
  intros K H. assert (C := Digits.Zdigits_correct radix2 (Zpos m)). rewrite <- Digits.Zpos_digits2_pos, H in C. exact (proj1 C).
Qed.

Lemma canonical_of f s m e : Prim2SF f = S754_finite s m e ->
  let d := Zpos (digits2_pos m) in (d <= 53 /\ -1074 <= e <= 971 /\ (d < 53 -> e = -1074))%Z.
Proof.
  intros H d. assert (V := Prim2SF_valid f). rewrite H in V. apply andb_prop in V. destruct V as [C E]. apply Zle_bool_imp_le in E.
  apply Zeq_bool_eq in C. unfold SpecFloat.fexp, SpecFloat.emin in C. change prec with 53%Z in C, E. change emax with 1024%Z in C, E. lia.
Qed.

(* ---- Both ways ---- *)

Theorem half_of_bits mask f : half_of mask f =
  match Prim2SF f with
  | S754_finite false m e => Z.land (((e + 1074) * 2 ^ 52 + Zpos m) / 2 ^ 32) mask
  | S754_infinity false => never
  | _ => 0%Z
  end.
Proof.
  unfold half_of. rewrite !FloatAxioms.ltb_spec. assert (Spec := frshiftexp_spec f). destruct (frshiftexp f) as [g k].
  destruct (Prim2SF f) as [[|]|[|]| |[|] m e] eqn:H; try reflexivity.
  change (SFltb (Prim2SF 0) (S754_finite false m e)) with true. change (SFltb (S754_finite false m e) (Prim2SF infinity)) with true. cbv iota. f_equal.
  destruct (canonical_of f false m e H) as (D & E & L). unfold SFfrexp in Spec. change (Z.to_pos prec) with 53%positive in Spec. change prec with 53%Z in Spec.
  assert (K : (0 <= to_Z k < 2 ^ 63)%Z) by apply to_Z_bounded. assert (N := normfr_mantissa_spec g). change shift with 2101%Z in Spec.
  destruct (53 <=? digits2_pos m)%positive eqn:C; injection Spec as G Q; rewrite G in N; simpl in N.
  - assert (B : (1080 <=? k)%uint63 = true) by (apply Uint63.leb_spec; change (to_Z 1080) with 1080%Z; lia). rewrite B.
    rewrite Uint63.add_spec, Uint63.lsl_spec, Uint63.lsr_spec, Uint63.sub_spec, N.
    change wB with (2 ^ 63)%Z. change (to_Z 1080) with 1080%Z. change (to_Z 20) with 20%Z. change (to_Z 32) with 32%Z.
    assert (0 <= Zpos m / 2 ^ 32 < 2 ^ 21)%Z by (split; [apply Z.div_pos; lia|apply Z.div_lt_upper_bound; [lia|]; generalize (digits m 53 D); lia]).
    replace (to_Z k) with (e + 2154)%Z by lia. rewrite (Z.mod_small (e + 2154 - 1080)) by lia. replace (e + 2154 - 1080)%Z with (e + 1074)%Z by lia.
    assert (0 <= (e + 1074) * 2 ^ 20 < 2 ^ 62)%Z by lia. rewrite (Z.mod_small ((e + 1074) * _)) by lia. rewrite Z.mod_small by lia.
    replace ((e + 1074) * 2 ^ 52)%Z with ((e + 1074) * 2 ^ 20 * 2 ^ 32)%Z by ring. symmetry. now apply Z.div_add_l.
  - apply Pos.leb_gt in C. set (d := digits2_pos m) in *. specialize (L ltac:(lia)). subst e. change (Z.pos_sub 53 d) with (53 - Zpos d)%Z in *.
    assert (B : (1080 <=? k)%uint63 = false) by (apply Bool.not_true_iff_false; rewrite Uint63.leb_spec; change (to_Z 1080) with 1080%Z; lia). rewrite B.
    rewrite Uint63.lsr_spec, Uint63.sub_spec, N, shift_pos_correct. change (to_Z 1112) with 1112%Z. change wB with (2 ^ 63)%Z.
    replace (to_Z k) with (1027 + Zpos d)%Z by lia. rewrite Z.mod_small by lia.
    change (Z.pow_pos 2 ?p) with (2 ^ Zpos p)%Z. rewrite Z2Pos.id by lia. replace (1112 - (1027 + Zpos d))%Z with (53 - Zpos d + 32)%Z by lia.
    rewrite Z.pow_add_r, Z.div_mul_cancel_l by lia. reflexivity.
Qed.

Theorem value_of_bits b :
  value_of b = if (b <? never)%Z then ldshiftexp (of_uint63 (Uint63.of_Z (mantissa 20 b))) (Uint63.of_Z (exponent 20 (-1042) b + shift)) else infinity.
Proof. unfold mantissa, exponent. now rewrite <- Z.shiftr_div_pow2, <- Z.land_ones by easy. Qed.
