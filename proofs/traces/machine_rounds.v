(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The numbers of the machine (machine.v) are those that the theorems are about: every operation that the replay runs, on finite floats that do not
   overflow, is the one of filter_doubles.v and filter_plane.v on the reals that they stand for. `stands a f r` (bridge.v): f is
   finite, stands for r, and |r| <= 2^a.

   - half_stands, value_stands      Expiry::lower and Expiry::path_length are `lower` and `value` of truncated_double.v
   - below_stands_2, _3             the comparison of the step test is below_2, below_3, with a threshold that is
   - threshold_stands               set_threshold
   - path_length_stands_2, _3           path_length_2, path_length_3
   - sum_lower_stands, left_stands      what commit_points and rebase compute

   Points are in the coordinate domain, 2^500 at most; bases, tolerances and expiries below 2^1000, which no displacement budget reaches that is rebased:
   this is what remains of overflow, and NaN does not come up. With all bits of an upper half; tiny bounds drop some, which no theorem
   is about. *)
From Coq Require Import Reals ZArith Lia Lra List Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require float_model float_error float_tail float_sums float_displacement.
From Annulus Require Import algorithm_list truncated_double filter_doubles.
From Annulus Require Import operations bridge.
From Annulus_traces Require Import machine machine_bits.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

Notation real := operations.value.
Definition half_mask_32 : Z := 2 ^ 32 - 1.

(* ---- Constants ---- *)

Lemma real_of f m e : Prim2SF f = S754_finite false m e -> real f = IZR (Zpos m) * power e.
Proof. intro H. unfold real, Prim2B. rewrite B2R_SF2B, H. reflexivity. Qed.

Lemma constant_stands f m e r a : Prim2SF f = S754_finite false m e -> IZR (Zpos m) * power e = r -> r <= power a -> stands a f r.
Proof.
  intros H E B. assert (V := real_of f m e H). rewrite E in V. split; [|split; [exact V|]].
  - unfold finite, Prim2B. rewrite is_finite_SF2B, H. reflexivity.
  - rewrite Rabs_pos_eq; [exact B|]. rewrite <- E. apply Rmult_le_pos; [now apply IZR_le|apply bpow_ge_0].
Qed.

Lemma power_stands f e a : Prim2SF f = S754_finite false 4503599627370496 e -> a = (52 + e)%Z -> stands a f (power a).
Proof.
  intros H ->. apply constant_stands with (1 := H); [|lra]. now rewrite bpow_plus.
Qed.

Ltac constant e :=
  eapply constant_stands; [reflexivity| |];
  cbv [float_sums.ulp52 float_sums.grow float_tail.shrink float_displacement.shrink_squares]; unfold float_model.u;
  change (power (-53)) with (/ 9007199254740992); change (power (-52)) with (/ 4503599627370496);
  try (change (power e) with 1 || change (power e) with 2); simpl; lra.

Lemma grow_stands : stands 1 grow float_sums.grow. Proof. constant 1%Z. Qed.
Lemma ulp52_stands : stands (-52) ulp52 float_sums.ulp52.
Proof.
  replace float_sums.ulp52 with (power (-52)); [exact (power_stands ulp52 (-104) (-52) eq_refl eq_refl)|].
  unfold float_sums.ulp52, float_model.u. change (-52)%Z with (1 + -53)%Z. now rewrite bpow_plus.
Qed.
Lemma shrink_squares_stands : stands 0 0x1.ffffffffffff0p-1%float float_displacement.shrink_squares. Proof. constant 0%Z. Qed.
Lemma shrink_slack_stands : stands 0 0x1.ffffffffffff8p-1%float (1 - 8 * float_model.u). Proof. constant 0%Z. Qed.
Lemma zero_stands a : stands a 0%float 0.
Proof. split; [reflexivity|split; [reflexivity|]]. rewrite Rabs_R0. apply bpow_ge_0. Qed.

(* ---- Distances ---- *)

Definition in_bounds (c : float) : Prop := stands 500 c (real c).

Section distances.
Variables ax ay az bx by' bz : float.
Hypotheses (Ax : in_bounds ax) (Ay : in_bounds ay) (Az : in_bounds az) (Bx : in_bounds bx) (By : in_bounds by') (Bz : in_bounds bz).

Lemma off_stands a b : in_bounds a -> in_bounds b -> stands 501 (a - b)%float (float_error.fsub (real a) (real b)).
Proof. intros A B. exact (stands_sub 500 500 _ _ _ _ ltac:(lia) A B). Qed.
Lemma square_stands a b : in_bounds a -> in_bounds b ->
  let c := float_error.fsub (real a) (real b) in stands 1002 ((a - b) * (a - b))%float (float_error.fmul c c).
Proof. intros A B. exact (stands_mul 501 501 _ _ _ _ ltac:(lia) (off_stands a b A B) (off_stands a b A B)). Qed.

Theorem squares_stand_2 : stands 1004 (squared_distance [ax; ay] [bx; by']) (float_displacement.squared_distance_2 (real ax) (real ay) (real bx) (real by')).
Proof.
  apply (stands_add 1003 1002 _ _ _ _ ltac:(lia)); [|now apply square_stands].
  apply (stands_add 1002 1002 _ _ _ _ ltac:(lia)); [apply zero_stands|now apply square_stands].
Qed.
Theorem squares_stand_3 : stands 1006 (squared_distance [ax; ay; az] [bx; by'; bz])
  (float_displacement.squared_distance_3 (real ax) (real ay) (real az) (real bx) (real by') (real bz)).
Proof.
  apply stands_wider with 1005%Z; [lia|]. apply (stands_add 1004 1002 _ _ _ _ ltac:(lia)); [exact squares_stand_2|now apply square_stands].
Qed.

Lemma side_stands a b : in_bounds a -> in_bounds b -> stands 501 (PrimFloat.abs (a - b)) (Rabs (float_error.fsub (real a) (real b))).
Proof. intros A B. apply stands_abs. now apply off_stands. Qed.
Lemma sides_stand_2 : stands 503 (terms PrimFloat.abs [ax; ay] [bx; by'])
  (float_error.fadd (float_error.fadd 0 (Rabs (float_error.fsub (real ax) (real bx)))) (Rabs (float_error.fsub (real ay) (real by')))).
Proof.
  apply (stands_add 502 501 _ _ _ _ ltac:(lia)); [|now apply side_stands].
  apply (stands_add 501 501 _ _ _ _ ltac:(lia)); [apply zero_stands|now apply side_stands].
Qed.
Lemma sides_stand_3 : stands 504 (terms PrimFloat.abs [ax; ay; az] [bx; by'; bz])
  (float_error.fadd (float_error.fadd (float_error.fadd 0 (Rabs (float_error.fsub (real ax) (real bx)))) (Rabs (float_error.fsub (real ay) (real by'))))
    (Rabs (float_error.fsub (real az) (real bz)))).
Proof. apply (stands_add 503 501 _ _ _ _ ltac:(lia)); [exact sides_stand_2|now apply side_stands]. Qed.
End distances.

Lemma less_stands a b f g r s : stands a f r -> stands b g s -> (f <? g)%float = if Rlt_dec r s then true else false.
Proof.
  intros A B. rewrite (stands_ltb _ _ _ _ _ _ A B). case Rlt_bool_spec; intro; destruct (Rlt_dec r s); trivial; lra.
Qed.

Lemma distance_stands a b q t : stands 1006 (squared_distance a b) q -> stands 504 (terms PrimFloat.abs a b) t -> 0 <= q ->
  stands 505 (distance_upper a b) (float_displacement.distance_upper q t).
Proof.
  intros Q T P. unfold distance_upper, float_displacement.distance_upper.
  rewrite (less_stands _ _ _ _ _ _ (power_stands 0x1p-900%float (-952) (-900) eq_refl eq_refl) Q). destruct (Rlt_dec _ q).
  - apply stands_wider with 504%Z; [lia|]. apply (stands_mul 503 1 _ _ _ _ ltac:(lia)); [|exact grow_stands].
    exact (stands_sqrt 503 _ _ ltac:(lia) Q P).
  - exact (stands_mul 504 1 _ _ _ _ ltac:(lia) T grow_stands).
Qed.

(* ---- Sums ---- *)

Lemma sum_upper_stands a f g r s : (0 <= a <= 1000)%Z -> stands a f r -> stands a g s -> stands (a + 2) (sum_upper f g) (float_sums.sum_upper r s).
Proof.
  intros A Fr Gs. assert (S := stands_add_same a _ _ _ _ ltac:(lia) Fr Gs). replace (a + 2)%Z with (Z.max (a + 1) (a + 1 + -52) + 1)%Z by lia.
  apply (stands_add (a + 1) (a + 1 + -52) _ _ _ _ ltac:(lia)); [exact S|]. exact (stands_mul (a + 1) (-52) _ _ _ _ ltac:(lia) S ulp52_stands).
Qed.
Theorem sum_lower_stands a f g r s : (0 <= a <= 1000)%Z -> stands a f r -> stands a g s -> stands (a + 2) (sum_lower f g) (float_sums.sum_lower r s).
Proof.
  intros A Fr Gs. assert (S := stands_add_same a _ _ _ _ ltac:(lia) Fr Gs). replace (a + 2)%Z with (Z.max (a + 1) (a + 1 + -52) + 1)%Z by lia.
  apply (stands_sub (a + 1) (a + 1 + -52) _ _ _ _ ltac:(lia)); [exact S|]. exact (stands_mul (a + 1) (-52) _ _ _ _ ltac:(lia) S ulp52_stands).
Qed.

Lemma squares_pos_2 x y z t : 0 <= float_displacement.squared_distance_2 x y z t.
Proof.
  unfold float_displacement.squared_distance_2. cbv zeta. repeat apply float_model.rnd_pos.
  apply Rplus_le_le_0_compat; [apply float_model.rnd_pos; rewrite Rplus_0_l|]; apply float_model.rnd_pos, Rle_0_sqr.
Qed.
Lemma squares_pos_3 x y z t v w : 0 <= float_displacement.squared_distance_3 x y z t v w.
Proof.
  unfold float_displacement.squared_distance_3. cbv zeta. apply float_model.rnd_pos.
  apply Rplus_le_le_0_compat; [exact (squares_pos_2 x y t v)|apply float_model.rnd_pos, Rle_0_sqr].
Qed.

Section path_lengths.
Variables fx fy fz px py pz : float.
Hypotheses (Fx : in_bounds fx) (Fy : in_bounds fy) (Fz : in_bounds fz) (Px : in_bounds px) (Py : in_bounds py) (Pz : in_bounds pz).
Variables (a : Z) (b : float).
Hypothesis A : (505 <= a <= 1000)%Z.
Hypothesis B : stands a b (real b).

Lemma way_stands_2 : stands 505 (distance_upper [px; py] [fx; fy]) (float_displacement.distance_upper_2 (real px) (real py) (real fx) (real fy)).
Proof.
  apply distance_stands; [|apply stands_wider with 503%Z; [lia|now apply sides_stand_2]|apply squares_pos_2].
  apply stands_wider with 1004%Z; [lia|now apply squares_stand_2].
Qed.
Lemma way_stands_3 : stands 505 (distance_upper [px; py; pz] [fx; fy; fz])
  (float_displacement.distance_upper_3 (real px) (real py) (real pz) (real fx) (real fy) (real fz)).
Proof. apply distance_stands; [now apply squares_stand_3|now apply sides_stand_3|apply squares_pos_3]. Qed.

Theorem path_length_stands_2 : stands (a + 2) (path_length_at b [fx; fy] [px; py]) (path_length_2 (real b) (real fx, real fy) (real px, real py)).
Proof. apply sum_upper_stands; [lia|exact B|]. apply stands_wider with 505%Z; [lia|exact way_stands_2]. Qed.
Theorem path_length_stands_3 : stands (a + 2) (path_length_at b [fx; fy; fz] [px; py; pz])
  (path_length_3 (real b) {| vectors.X1 := real fx; vectors.X2 := real fy; vectors.X3 := real fz |} {| vectors.X1 := real px; vectors.X2 := real py; vectors.X3 := real pz |}).
Proof. apply sum_upper_stands; [lia|exact B|]. apply stands_wider with 505%Z; [lia|exact way_stands_3]. Qed.
End path_lengths.

(* ---- Upper halves ---- *)

(* Mantissa and exponent of a positive float make its bits. *)
Lemma bits_of f m e : Prim2SF f = S754_finite false m e -> let b := ((e + 1074) * 2 ^ 52 + Zpos m)%Z in
  (0 < b < never * 2 ^ 32)%Z /\ double b = real f.
Proof.
  intros H b. destruct (canonical_of f false m e H) as (N & E & L0). assert (D := digits m 53 N : (Zpos m < 2 ^ 53)%Z).
  rewrite (real_of f m e H). unfold double, truncated_double.number, mantissa, exponent. destruct (Z.lt_ge_cases (Zpos m) (2 ^ 52)) as [L|G].
  - assert (e = -1074)%Z as ->.
    { apply L0. destruct (Z.lt_ge_cases (Zpos (digits2_pos m)) 53) as [|G]; [assumption|exfalso].
      assert (S := digits_least m 53 ltac:(lia) ltac:(lia)). change (53 - 1)%Z with 52%Z in S. lia. }
    unfold b. replace ((-1074 + 1074) * 2 ^ 52 + Zpos m)%Z with (Zpos m) by lia. split; [unfold never; lia|].
    rewrite Z.div_small, Z.mod_small by lia. reflexivity.
  - assert (Q : (b / 2 ^ 52 = e + 1075)%Z) by (symmetry; apply Z.div_unique with (Zpos m - 2 ^ 52)%Z; unfold b; lia).
    assert (R : (b mod 2 ^ 52 = Zpos m - 2 ^ 52)%Z) by (symmetry; apply Z.mod_unique with (e + 1075)%Z; unfold b; lia).
    split; [unfold b, never; lia|]. rewrite Q, R. replace (e + 1075 =? 0)%Z with false by (symmetry; apply Z.eqb_neq; lia).
    f_equal; f_equal; lia.
Qed.

Theorem half_stands f : finite f = true -> half_of half_mask_32 f = lower (real f).
Proof.
  intro Fin. rewrite half_of_bits. destruct (Prim2SF f) as [s|s| |s m e] eqn:H.
  - rewrite lower_clips; [now destruct s|]. unfold real, Prim2B. rewrite B2R_SF2B, H. apply Rle_refl.
  - exfalso. unfold finite, Prim2B in Fin. rewrite is_finite_SF2B, H in Fin. discriminate.
  - exfalso. unfold finite, Prim2B in Fin. rewrite is_finite_SF2B, H in Fin. discriminate.
  - destruct s.
    + rewrite lower_clips; [reflexivity|]. unfold real, Prim2B. rewrite B2R_SF2B, H. apply F2R_le_0. easy.
    + destruct (bits_of f m e H) as [B <-]. rewrite truncated by exact B.
      unfold half_mask_32. rewrite <- (Z.ones_equiv 32 : Z.ones 32 = 2 ^ 32 - 1)%Z, Z.land_ones by lia. apply Z.mod_small.
      split; [apply Z.div_pos; lia|]. apply Z.div_lt_upper_bound; [lia|]. unfold never in B. lia.
Qed.

Lemma value_never : truncated_double.value never = power 1024.
Proof.
  unfold truncated_double.value, truncated_double.number. replace (exponent 20 (-1042) never) with 1004%Z by reflexivity.
  replace (mantissa 20 never) with (2 ^ 20)%Z by reflexivity. change (2 ^ 20)%Z with (Zpower radix2 20). now rewrite IZR_Zpower, <- bpow_plus by lia.
Qed.

Theorem value_is e : (0 <= e < never)%Z -> stands 1024 (value_of e) (truncated_double.value e).
Proof.
  intro E. assert (B : truncated_double.value e < power 1024) by (rewrite <- value_never; now apply number_increases). rewrite value_of_bits, (proj2 (Z.ltb_lt _ _) (proj2 E)).
  assert (M : (0 <= mantissa 20 e < 2 ^ 21)%Z).
  { unfold mantissa. generalize (Z.mod_pos_bound e (2 ^ 20) ltac:(lia)). destruct (_ =? _)%Z; lia. }
  assert (X : (-1042 <= exponent 20 (-1042) e < 1024)%Z).
  { unfold exponent. unfold never in E. assert (e / 2 ^ 20 < 2047)%Z by (apply Z.div_lt_upper_bound; lia).
    assert (0 <= e / 2 ^ 20)%Z by (apply Z.div_pos; lia). lia. }
  assert (P := truncated_double.value_pos e (proj1 E)).
  assert (I : value (of_uint63 (Uint63.of_Z (mantissa 20 e))) = IZR (mantissa 20 e) /\ finite (of_uint63 (Uint63.of_Z (mantissa 20 e))) = true).
  { unfold value, finite. rewrite of_int63_equiv, Uint63.of_Z_spec, Z.mod_small by (change Uint63.wB with (2 ^ 63)%Z; lia).
    generalize (binary_normalize_correct prec emax Hprec Hmax mode_NE (mantissa 20 e) 0 false). cbv zeta.
    assert (R : round radix2 (SpecFloat.fexp prec emax) (round_mode mode_NE) (F2R (Float radix2 (mantissa 20 e) 0)) = IZR (mantissa 20 e)).
    { rewrite round_generic; [unfold F2R; simpl; ring|apply valid_rnd_round_mode|]. replace (F2R _) with (IZR (mantissa 20 e)) by (unfold F2R; simpl; ring).
      apply (generic_format_FLT radix2 (-1074) 53). exists (Float radix2 (mantissa 20 e) 0); [unfold F2R; simpl; ring|simpl; lia|simpl; lia]. }
    rewrite R, Rlt_bool_true; [easy|]. rewrite <- (IZR_Zpower radix2 emax) by easy. rewrite <- abs_IZR. apply IZR_lt.
    rewrite Z.abs_eq by lia. apply Z.lt_trans with (2 ^ 21)%Z; [lia|reflexivity]. }
  assert (In_range : (0 <= exponent 20 (-1042) e + shift < Uint63.wB)%Z).
  { change shift with 2101%Z. change Uint63.wB with 9223372036854775808%Z. lia. }
  destruct I as [I Fin]. split; [|split; [|rewrite Rabs_pos_eq; [now apply Rlt_le|exact P]]]; unfold finite, value in *; rewrite ldshiftexp_equiv, Uint63.of_Z_spec,
    (Z.mod_small _ _ In_range);
    replace (exponent 20 (-1042) e + shift - shift)%Z with (exponent 20 (-1042) e) by lia;
    generalize (Bldexp_correct prec emax Hprec Hmax mode_NE (Prim2B (of_uint63 (Uint63.of_Z (mantissa 20 e)))) (exponent 20 (-1042) e));
    rewrite I, (round_generic _ _ _ _ (F_value e (proj1 E))), Rlt_bool_true.
  all: try (intros (V & Q & _); first [exact V | now rewrite Q]).
  all: rewrite Rabs_pos_eq; [exact B|exact P].
Qed.
Lemma value_stands e a : (0 <= e < never)%Z -> truncated_double.value e <= power a -> stands a (value_of e) (truncated_double.value e).
Proof. intros E B. apply stands_tighter with 1024%Z; [now apply value_is|]. now rewrite Rabs_pos_eq by now apply truncated_double.value_pos. Qed.

(* ---- What they are used for ---- *)

Theorem left_stands e b : (0 <= e < never)%Z -> truncated_double.value e <= power 1000 -> stands 1000 b (real b) ->
  stands 1002 (left_of e b) (filter_doubles.less e (real b)).
Proof.
  intros E V B. assert (S := stands_sub 1000 1000 _ _ _ _ ltac:(lia) (value_stands e 1000 E V) B).
  apply (stands_sub 1001 949 _ _ _ _ ltac:(lia)); [exact S|]. exact (stands_mul 1001 (-52) _ _ _ _ ltac:(lia) S ulp52_stands).
Qed.

(* What a threshold is kept as. *)
Lemma kept_stands f r : stands 1021 f r -> stands 1021 (value_of (half_of half_mask_32 f)) (truncated_double.value (lower r)).
Proof.
  intros (Fin & Val & Bnd). rewrite half_stands, Val by exact Fin. destruct (Rlt_le_dec 0 r) as [P|P].
  - assert (L := lower_below r ltac:(lra)). rewrite Rabs_pos_eq in Bnd by lra. apply value_stands; [|lra].
    split; [apply lower_range|]. destruct (Z.lt_ge_cases (lower r) never) as [|G]; [assumption|exfalso].
    assert (truncated_double.value never <= r) by (apply Rle_trans with (2 := L), value_le; unfold never in *; lia).
    rewrite value_never in H. assert (power 1021 < power 1024) by (apply bpow_lt; lia). lra.
  - rewrite lower_clips, value_0 by exact P. exact (zero_stands 1021).
Qed.

Theorem threshold_stands e b : (0 <= e < never)%Z -> truncated_double.value e <= power 1000 -> stands 1000 b (real b) ->
  stands 1021 (value_of (half_of half_mask_32 (squared_threshold_lower (slack e b)))) (threshold e (real b)).
Proof.
  intros E V B. assert (S := stands_sub 1000 1000 _ _ _ _ ltac:(lia) (value_stands e 1000 E V) B).
  assert (K := stands_mul 1001 0 _ _ _ _ ltac:(lia) S shrink_slack_stands). change (1001 + 0)%Z with 1001%Z in K. fold (slack e b) in K.
  apply kept_stands. unfold squared_threshold_lower, float_displacement.threshold, float_displacement.squared_threshold_lower.
  change (float_error.fmul (float_error.fsub (truncated_double.value e) (real b)) (1 - 8 * float_model.u)) with
    (rnd (rnd (truncated_double.value e - real b) * (1 - 8 * float_model.u))).
  rewrite (less_stands _ _ _ _ _ _ (power_stands 0x1p-450%float (-502) (-450) eq_refl eq_refl) K). destruct (Rlt_dec _ _) as [P|P]; [|apply zero_stands].
  simpl negb. cbv iota. rewrite (less_stands _ _ _ _ _ _ (power_stands 0x1p510%float 458 510 eq_refl eq_refl) K). destruct (Rlt_dec _ _) as [Q|Q].
  - apply stands_wider with 1020%Z; [lia|]. exact (power_stands 0x1p1020%float 968 1020 eq_refl eq_refl).
  - assert (K' : stands 510 (slack e b) (rnd (rnd (truncated_double.value e - real b) * (1 - 8 * float_model.u)))).
    { apply stands_tighter with 1001%Z; [exact K|]. rewrite Rabs_pos_eq; [lra|]. generalize (bpow_ge_0 radix2 (-450)). lra. }
    apply stands_wider with 1020%Z; [lia|]. exact (stands_mul 1020 0 _ _ _ _ ltac:(lia) (stands_mul 510 510 _ _ _ _ ltac:(lia) K' K') shrink_squares_stands).
Qed.

Lemma any_stands f : finite f = true -> stands 1024 f (real f).
Proof. intro F. split; [exact F|split; [reflexivity|]]. apply Rlt_le, (abs_B2R_lt_emax prec emax). Qed.

Theorem below_stands_2 r fx fy px py : finite r = true -> in_bounds fx -> in_bounds fy -> in_bounds px -> in_bounds py ->
  (squared_distance [px; py] [fx; fy] <? r)%float = below_2 (real fx, real fy) (real px, real py) (real r).
Proof. intros R Fx Fy Px Py. exact (less_stands _ _ _ _ _ _ (squares_stand_2 _ _ _ _ Px Py Fx Fy) (any_stands r R)). Qed.
Theorem below_stands_3 r fx fy fz px py pz : finite r = true -> in_bounds fx -> in_bounds fy -> in_bounds fz -> in_bounds px -> in_bounds py -> in_bounds pz ->
  (squared_distance [px; py; pz] [fx; fy; fz] <? r)%float =
  below_3 {| vectors.X1 := real fx; vectors.X2 := real fy; vectors.X3 := real fz |} {| vectors.X1 := real px; vectors.X2 := real py; vectors.X3 := real pz |} (real r).
Proof. intros R Fx Fy Fz Px Py Pz. exact (less_stands _ _ _ _ _ _ (squares_stand_3 _ _ _ _ _ _ Px Py Pz Fx Fy Fz) (any_stands r R)). Qed.
