(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* src/annulus/arithmetic/truncated_double.h and src/annulus/engine/expiry.h: the upper 32 bits of a double, as a number.

   - number_increases    numbers have the order of their bits: of doubles that are not negative, and of upper halves
   - floor_below, floor_above   the bits of the largest number not above x: `value(lower(x)) <= x`, and what is above them is above x
   - lower_below, lower_clips, not_reached, reached_from    what the filter needs of Expiry::lower and Expiry::reached (algorithm_filter.v)
   - half_of_double      the number of 32 bits is that of the double whose lower half is 0 (Truncated_double::value)
   - truncated           the largest upper half not above a double is its bits shifted right by 32 (Truncated_double::truncated)
   - double_of_bits      and the number of 64 bits is what IEEE 754 says (Flocq's b64_of_bits)

   Numbers are real, not negative and without NaN; infinity is 2^1024 here, which no path length reaches. *)
Require Import Reals Lra ZArith Lia.
From Flocq Require Import Core BinarySingleNaN Binary Bits.
From Annulus Require Import algorithm_list.
Open Scope R_scope.

(* A number of `width` explicit bits of mantissa and exponents from `low`, from its bits. *)
Section format.
Variables width low : Z.
Hypothesis width_pos : (0 < width)%Z.

Definition exponent (b : Z) : Z := (Z.max 1 (b / 2 ^ width) - 1 + low)%Z.
Definition mantissa (b : Z) : Z := (if (b / 2 ^ width =? 0)%Z then b mod 2 ^ width else 2 ^ width + b mod 2 ^ width)%Z.
Definition number (b : Z) : R := IZR (mantissa b) * bpow radix2 (exponent b).

Lemma unit_pos : (0 < 2 ^ width)%Z.
Proof. apply Z.pow_pos_nonneg; lia. Qed.

(* The next number is larger by one unit. *)
Lemma number_next b : (0 <= b)%Z -> number (b + 1) = number b + bpow radix2 (exponent b).
Proof.
  intro B. generalize unit_pos. intro P. unfold number, mantissa, exponent.
  assert (D := Z.div_mod b (2 ^ width) ltac:(lia)). assert (M := Z.mod_pos_bound b (2 ^ width) P).
  set (e := (b / 2 ^ width)%Z) in *. set (m := (b mod 2 ^ width)%Z) in *. assert (E : (0 <= e)%Z) by (apply Z.div_pos; lia).
  destruct (Z.eq_dec (m + 1) (2 ^ width)) as [L|L].
  - replace ((b + 1) / 2 ^ width)%Z with (e + 1)%Z by (apply Z.div_unique with 0%Z; lia).
    replace ((b + 1) mod 2 ^ width)%Z with 0%Z by (apply Z.mod_unique with (e + 1)%Z; lia).
    replace (e + 1 =? 0)%Z with false by (symmetry; apply Z.eqb_neq; lia).
    destruct (e =? 0)%Z eqn:Z0; [apply Z.eqb_eq in Z0|apply Z.eqb_neq in Z0].
    + replace (Z.max 1 (e + 1) - 1 + low)%Z with low by lia. replace (Z.max 1 e - 1 + low)%Z with low by lia.
      rewrite <- L, Z.add_0_r, plus_IZR. ring.
    + replace (Z.max 1 (e + 1) - 1 + low)%Z with (1 + (Z.max 1 e - 1 + low))%Z by lia. rewrite bpow_plus.
      change (bpow radix2 1) with 2. rewrite <- L, !plus_IZR. ring.
  - replace ((b + 1) / 2 ^ width)%Z with e by (apply Z.div_unique with (m + 1)%Z; lia).
    replace ((b + 1) mod 2 ^ width)%Z with (m + 1)%Z by (apply Z.mod_unique with e; lia).
    destruct (e =? 0)%Z; rewrite !plus_IZR; ring.
Qed.

Theorem number_increases a b : (0 <= a < b)%Z -> number a < number b.
Proof.
  intros [A L]. replace b with (a + Z.of_nat (Z.to_nat (b - a)))%Z by lia. assert (K : (0 < Z.to_nat (b - a))%nat) by lia.
  revert K. generalize (Z.to_nat (b - a)). clear L b. intros n H. destruct n as [|n]; [lia|]. clear H.
  induction n as [|n IH].
  - change (Z.of_nat 1) with 1%Z. rewrite number_next by exact A. generalize (bpow_gt_0 radix2 (exponent a)). lra.
  - rewrite Nat2Z.inj_succ. unfold Z.succ. rewrite Z.add_assoc, number_next by lia.
    generalize (bpow_gt_0 radix2 (exponent (a + Z.of_nat (S n)))). lra.
Qed.

Lemma number_le a b : (0 <= a <= b)%Z -> number a <= number b.
Proof. intros [A L]. destruct (Z.eq_dec a b) as [->|N]; [lra|]. left. apply number_increases. lia. Qed.

Lemma number_0 : number 0 = 0.
Proof. unfold number, mantissa. rewrite Z.div_0_l, Z.mod_0_l by (generalize unit_pos; lia). simpl. ring. Qed.

Lemma number_pos b : (0 <= b)%Z -> 0 <= number b.
Proof. intro B. rewrite <- number_0. apply number_le. lia. Qed.

Lemma number_order a b : (0 <= a)%Z -> (0 <= b)%Z -> number a < number b -> (a < b)%Z.
Proof. intros A B L. destruct (Z.lt_ge_cases a b) as [|G]; [assumption|]. generalize (number_le b a ltac:(lia)). lra. Qed.

(* The bits of the largest number not above x. *)
Notation fexp := (FLT_exp low (width + 1)).
Definition floor (x : R) : Z := ((cexp radix2 fexp x - low) * 2 ^ width + Zfloor (scaled_mantissa radix2 fexp x))%Z.

Lemma IZR_2pow n : (0 <= n)%Z -> IZR (2 ^ n) = bpow radix2 n.
Proof. intro H. apply (IZR_Zpower radix2 n H). Qed.

Lemma floor_spec x : 0 < x -> (0 <= floor x)%Z /\ number (floor x) <= x < number (floor x + 1).
Proof.
  intro X. generalize unit_pos. intro P. unfold floor. set (c := cexp radix2 fexp x). set (k := Zfloor (scaled_mantissa radix2 fexp x)).
  assert (S : scaled_mantissa radix2 fexp x = x * bpow radix2 (- c)) by reflexivity.
  assert (K : IZR k * bpow radix2 c <= x < (IZR k + 1) * bpow radix2 c).
  { generalize (Zfloor_lb (scaled_mantissa radix2 fexp x)) (Zfloor_ub (scaled_mantissa radix2 fexp x)). fold k. rewrite S. intros A B.
    assert (E : x = x * bpow radix2 (- c) * bpow radix2 c).
    { rewrite Rmult_assoc, <- bpow_plus. replace (- c + c)%Z with 0%Z by lia. simpl. ring. }
    split; rewrite E; [apply Rmult_le_compat_r|apply Rmult_lt_compat_r]; trivial; [apply bpow_ge_0|apply bpow_gt_0]. }
  generalize (bpow_mag_le radix2 x ltac:(lra)) (bpow_mag_gt radix2 x). rewrite Rabs_pos_eq by lra. set (g := mag radix2 x : Z). intros G1 G2.
  assert (C : c = Z.max (g - (width + 1)) low) by reflexivity.
  assert (K0 : (0 <= k)%Z).
  { apply Zfloor_lub. rewrite S. apply Rmult_le_pos; [lra|apply bpow_ge_0]. }
  assert (K1 : (k < 2 * 2 ^ width)%Z).
  { apply lt_IZR. rewrite mult_IZR, IZR_2pow by lia. apply Rmult_lt_reg_r with (bpow radix2 c); [apply bpow_gt_0|].
    apply Rle_lt_trans with x; [apply K|]. apply Rlt_le_trans with (1 := G2). change 2 with (bpow radix2 1).
    rewrite <- !bpow_plus. apply bpow_le. lia. }
  assert (E : exponent ((c - low) * 2 ^ width + k) = c /\ mantissa ((c - low) * 2 ^ width + k) = k).
  { unfold exponent, mantissa. destruct (Z.lt_ge_cases k (2 ^ width)) as [L|L].
    - assert (c = low).
      { destruct (Z.eq_dec c low) as [|N]; [assumption|exfalso]. assert (Q : c = (g - (width + 1))%Z) by lia.
        assert (IZR (k + 1) <= IZR (2 ^ width)) by (apply IZR_le; lia). rewrite plus_IZR, IZR_2pow in H by lia.
        assert (x < bpow radix2 (g - 1)); [|lra]. apply Rlt_le_trans with (1 := proj2 K).
        replace (g - 1)%Z with (width + c)%Z by lia. rewrite bpow_plus. apply Rmult_le_compat_r; [apply bpow_ge_0|exact H]. }
      rewrite H, Z.sub_diag, Z.mul_0_l, Z.add_0_l, Z.div_small, Z.mod_small by lia. simpl. split; lia.
    - replace ((c - low) * 2 ^ width + k)%Z with ((c - low + 1) * 2 ^ width + (k - 2 ^ width))%Z by ring.
      rewrite Z.div_add_l, Z.div_small, (Z.add_comm (_ * _)), Z.mod_add, Z.mod_small by lia.
      replace (c - low + 1 + 0 =? 0)%Z with false by (symmetry; apply Z.eqb_neq; lia). split; lia. }
  assert (F : (0 <= (c - low) * 2 ^ width + k)%Z) by (apply Z.add_nonneg_nonneg; [apply Z.mul_nonneg_nonneg; lia|exact K0]).
  split; [exact F|]. rewrite number_next by exact F. unfold number. destruct E as [-> ->]. lra.
Qed.

Lemma floor_unique x b : 0 < x -> (0 <= b)%Z -> number b <= x < number (b + 1) -> floor x = b.
Proof.
  intros X B [L U]. destruct (floor_spec x X) as (F & L' & U').
  assert (floor x < b + 1)%Z by (apply number_order; try lia; lra). assert (b < floor x + 1)%Z by (apply number_order; try lia; lra). lia.
Qed.
End format.

(* ---- The upper half, and expiries ---- *)

Definition value (b : Z) : R := number 20 (-1042) b.                       (* Truncated_double::value *)
Definition lower (x : R) : Z :=                                            (* Truncated_double::lower, Expiry::lower *)
  if Rlt_dec 0 x then Z.min never (floor 20 (-1042) x) else 0%Z.

Theorem lower_range x : (0 <= lower x <= never)%Z.
Proof. unfold lower. destruct (Rlt_dec 0 x) as [X|X]; [|easy]. destruct (floor_spec 20 (-1042) ltac:(lia) x X) as [F _]. unfold never in *. lia. Qed.

Theorem value_pos b : (0 <= b)%Z -> 0 <= value b.
Proof. apply number_pos. lia. Qed.

Theorem value_le a b : (0 <= a <= b)%Z -> value a <= value b.
Proof. apply number_le. lia. Qed.

Theorem value_0 : value 0 = 0.
Proof. apply number_0. lia. Qed.

Theorem lower_below x : 0 <= x -> value (lower x) <= x.
Proof.
  intro X. unfold lower. destruct (Rlt_dec 0 x) as [P|P]; [|rewrite value_0; lra].
  destruct (floor_spec 20 (-1042) ltac:(lia) x P) as (F & L & _). apply Rle_trans with (2 := L). apply number_le; unfold never; lia.
Qed.

Theorem lower_clips x : x <= 0 -> lower x = 0%Z.
Proof. intro X. unfold lower. destruct (Rlt_dec 0 x) as [P|P]; [lra|reflexivity]. Qed.

(* Expiry::reached(x) is not (lower(x) < e). *)
Theorem not_reached x e : 0 <= x -> (e <= never)%Z -> (lower x < e)%Z -> x < value e.
Proof.
  intros X N L. assert (R := lower_range x). unfold lower in *. destruct (Rlt_dec 0 x) as [P|P].
  - destruct (floor_spec 20 (-1042) ltac:(lia) x P) as (F & _ & U). apply Rlt_le_trans with (1 := U).
    apply number_le; lia.
  - replace x with 0 by lra. rewrite <- value_0. apply number_increases; lia.
Qed.

Theorem reached_from x e : (0 <= e)%Z -> value e <= x -> (e <= never)%Z -> (e <= lower x)%Z.
Proof.
  intros E L N. destruct (Z.le_gt_cases e (lower x)) as [|G]; [assumption|exfalso].
  assert (X : 0 <= x) by (apply Rle_trans with (2 := L); now apply value_pos). generalize (not_reached x e X N G). lra.
Qed.

(* ---- As the upper half of a double ---- *)

Definition double (b : Z) : R := number 52 (-1074) b.

Theorem half_of_double b : (0 <= b)%Z -> double (b * 2 ^ 32) = value b.
Proof.
  intro B. unfold double, value, number, exponent, mantissa.
  assert (D := Z.div_mod b (2 ^ 20) ltac:(lia)). assert (M := Z.mod_pos_bound b (2 ^ 20) ltac:(lia)).
  replace (b * 2 ^ 32 / 2 ^ 52)%Z with (b / 2 ^ 20)%Z by (apply Z.div_unique with ((b mod 2 ^ 20) * 2 ^ 32)%Z; lia).
  replace (b * 2 ^ 32 mod 2 ^ 52)%Z with ((b mod 2 ^ 20) * 2 ^ 32)%Z by (apply Z.mod_unique with (b / 2 ^ 20)%Z; lia).
  replace (Z.max 1 (b / 2 ^ 20) - 1 + -1042)%Z with (32 + (Z.max 1 (b / 2 ^ 20) - 1 + -1074))%Z by lia. rewrite (bpow_plus radix2 32).
  change (bpow radix2 32) with (IZR (2 ^ 32)). destruct (b / 2 ^ 20 =? 0)%Z.
  - rewrite mult_IZR. ring.
  - replace (2 ^ 52 + b mod 2 ^ 20 * 2 ^ 32)%Z with ((2 ^ 20 + b mod 2 ^ 20) * 2 ^ 32)%Z by ring. rewrite mult_IZR. ring.
Qed.

Theorem truncated b : (0 < b < never * 2 ^ 32)%Z -> lower (double b) = (b / 2 ^ 32)%Z.
Proof.
  intros [B N]. assert (P : 0 < double b) by (unfold double; rewrite <- (number_0 52 (-1074)) by lia; apply number_increases; lia).
  assert (D := Z.div_mod b (2 ^ 32) ltac:(lia)). assert (M := Z.mod_pos_bound b (2 ^ 32) ltac:(lia)).
  assert (Q : (0 <= b / 2 ^ 32)%Z) by (apply Z.div_pos; lia).
  assert (E : floor 20 (-1042) (double b) = (b / 2 ^ 32)%Z).
  { apply floor_unique; [lia|exact P|exact Q|]. fold (value (b / 2 ^ 32)) (value (b / 2 ^ 32 + 1)).
    rewrite <- !half_of_double by lia. split; [apply number_le|apply number_increases]; lia. }
  unfold lower. destruct (Rlt_dec 0 (double b)); [|lra]. rewrite E. lia.
Qed.

Lemma Zeq_bool_neq x y : x <> y -> Zeq_bool x y = false.
Proof. intro N. destruct (Zeq_bool x y) eqn:E; [apply Zeq_bool_eq in E; contradiction|reflexivity]. Qed.

Theorem double_of_bits b : (0 <= b < never * 2 ^ 32)%Z -> B2R 53 1024 (b64_of_bits b) = double b.
Proof.
  intros [B N]. unfold b64_of_bits, binary_float_of_bits. rewrite B2R_FF2B. unfold binary_float_of_bits_aux, split_bits.
  assert (D := Z.div_mod b (2 ^ 52) ltac:(lia)). assert (M := Z.mod_pos_bound b (2 ^ 52) ltac:(lia)).
  assert (L : (0 <= b / 2 ^ 52 < 2047)%Z).
  { unfold never in N. split; [apply Z.div_pos; lia|apply Z.div_lt_upper_bound; lia]. }
  cbv zeta. replace (Zle_bool (2 ^ 52 * 2 ^ 11) b) with false by (symmetry; apply Z.leb_gt; unfold never in N; lia).
  rewrite (Z.mod_small (b / 2 ^ 52)) by lia. unfold double, number, exponent, mantissa.
  set (e := (b / 2 ^ 52)%Z) in *. set (m := (b mod 2 ^ 52)%Z) in *.
  change (SpecFloat.emin (52 + 1) (2 ^ (11 - 1))) with (-1074)%Z. change (2 ^ 11 - 1)%Z with 2047%Z.
  replace (Zeq_bool e 2047) with false by (symmetry; apply Zeq_bool_neq; lia).
  destruct (Z.eq_dec e 0) as [E|E].
  - rewrite E. simpl Zeq_bool. cbv iota. rewrite Z.eqb_refl. simpl Z.add. destruct m as [|p|p]; [simpl; ring|reflexivity|lia].
  - replace (Zeq_bool e 0) with false by (symmetry; apply Zeq_bool_neq; lia).
    replace (e =? 0)%Z with false by (symmetry; now apply Z.eqb_neq). rewrite (Z.add_comm m).
    replace (Z.max 1 e - 1 + -1074)%Z with (e + -1074 - 1)%Z by lia.
    destruct (2 ^ 52 + m)%Z as [|p|p] eqn:Q; [lia|reflexivity|lia].
Qed.
