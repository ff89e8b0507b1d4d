(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The analysis of float_error.v is right: what it computes bounds exact and rounded values of an expression, and their difference. *)
Require Import Reals Lra Psatz ZArith List.
From Flocq Require Import Core.
From Annulus Require Import float_model.
From Annulus Require Export float_error.
Import ListNotations.
Open Scope R_scope.

(* Like injection, but without simplifying the integers. *)
Lemma some_eq {A} (a b : A) : Some a = Some b -> a = b.
Proof. congruence. Qed.

Section soundness.

Definition unit := bpow radix2 (-100).
Variable m : R.
Hypothesis m_large : bpow radix2 (-120) <= m.
Variables X x : nat -> R.
Hypothesis x_format : forall n, F (x n).
Hypothesis x_small : forall n, Rabs (x n) <= m.
Hypothesis x_close : forall n, Rabs (x n - X n) <= u * m.

(* The unit of degree k. *)
Definition scale k := unit * m ^ k.

Lemma m_pos : 0 < m.
Proof. apply Rlt_le_trans with (2 := m_large). apply bpow_gt_0. Qed.

Lemma unit_pos : 0 < unit.
Proof. apply bpow_gt_0. Qed.

Lemma scale_pos k : 0 < scale k.
Proof. apply Rmult_lt_0_compat; [apply unit_pos | apply pow_lt, m_pos]. Qed.

Lemma unit_one : IZR one * unit = 1.
Proof. unfold unit, one. rewrite (IZR_Zpower radix2) by lia. rewrite <- bpow_plus. reflexivity. Qed.

Lemma unit_u : IZR unit_roundoff * unit = u.
Proof.
  unfold unit, unit_roundoff. rewrite (IZR_Zpower radix2) by lia. rewrite <- bpow_plus.
  unfold u. reflexivity.
Qed.

Lemma u_53 : u * IZR (2 ^ 53) = 1.
Proof. unfold u. change (IZR (2 ^ 53)) with 9007199254740992. field. Qed.

Lemma scale_one : IZR one * scale 1 = m.
Proof. unfold scale. rewrite <- Rmult_assoc, unit_one. ring. Qed.

Lemma scale_u : IZR unit_roundoff * scale 1 = u * m.
Proof. unfold scale. rewrite <- Rmult_assoc, unit_u. ring. Qed.

(* The unit of degree k is above half the least positive number. *)
Lemma scale_underflow k : (k <= 8)%nat -> eta <= scale k.
Proof.
  intro K. unfold scale, unit, eta.
  apply Rle_trans with (bpow radix2 (-100) * bpow radix2 (-120) ^ k).
  - replace (bpow radix2 (-120) ^ k) with (bpow radix2 (-120 * Z.of_nat k)).
    + rewrite <- bpow_plus. apply bpow_le. lia.
    + clear K. induction k as [|k IH]; [reflexivity |].
      rewrite <- tech_pow_Rmult, <- IH, <- bpow_plus. f_equal. lia.
  - apply Rmult_le_compat_l; [apply bpow_ge_0 |].
    apply pow_incr. split; [apply bpow_ge_0 | apply m_large].
Qed.

Lemma up_le a k : (0 <= k)%Z -> IZR a <= IZR (up a k) * IZR (2 ^ k).
Proof.
  intro H. rewrite <- mult_IZR. apply IZR_le. unfold up. rewrite Z.shiftr_div_pow2 by exact H.
  generalize (Z.mul_div_le (- a) (2 ^ k) (Z.pow_pos_nonneg 2 k eq_refl H)). lia.
Qed.

(* A product of two bounds, in the unit of the sum of the degrees. *)
Lemma prod_le a b i j y z : 0 <= y <= IZR a * scale i -> 0 <= z <= IZR b * scale j ->
  y * z <= IZR (prod a b) * scale (i + j).
Proof.
  intros [Y0 Y] [Z0 Z].
  apply Rle_trans with ((IZR a * scale i) * (IZR b * scale j)).
  - apply Rmult_le_compat; assumption.
  - replace ((IZR a * scale i) * (IZR b * scale j)) with (IZR (a * b) * unit * scale (i + j)).
    + apply Rmult_le_compat_r; [left; apply scale_pos |].
      apply Rle_trans with (IZR (prod a b) * IZR one * unit).
      * apply Rmult_le_compat_r; [left; apply unit_pos |]. apply up_le. discriminate.
      * rewrite Rmult_assoc, unit_one. lra.
    + unfold scale. rewrite mult_IZR, pow_add. ring.
Qed.

Definition fits (v V : R) (b : bnd) :=
  Rabs V <= IZR (ex b) * scale (deg b) /\ Rabs v <= IZR (co b) * scale (deg b) /\
  Rabs (v - V) <= IZR (er b) * scale (deg b).

Lemma min_IZR a b y s : y <= IZR a * s -> y <= IZR b * s -> y <= IZR (Z.min a b) * s.
Proof. intros. destruct (Z.min_dec a b) as [-> | ->]; assumption. Qed.

Lemma round_off_fits k vX vS vE t v V :
  Rabs V <= IZR vX * scale k -> Rabs v <= IZR vS * scale k -> Rabs (v - V) <= IZR vE * scale k ->
  Rabs (rnd v - v) <= u * Rabs v + IZR t * scale k ->
  fits (rnd v) V (round_off k vX vS vE t).
Proof.
  intros HX HS HE HR. unfold round_off, fits. cbn [deg ex co er].
  set (S' := Z.min vS (vX + vE)). set (r := (up S' 53 + t)%Z).
  assert (tri : forall y z, Rabs y <= Rabs z + Rabs (y - z)).
  { intros y z. replace y with (z + (y - z)) at 1 by ring. apply Rabs_triang. }
  assert (H : Rabs v <= IZR S' * scale k).
  { apply min_IZR; [exact HS |]. rewrite plus_IZR. generalize (tri v V). lra. }
  assert (R : Rabs (rnd v - v) <= IZR r * scale k).
  { apply Rle_trans with (1 := HR). unfold r. rewrite plus_IZR.
    rewrite Rmult_plus_distr_r. apply Rplus_le_compat_r.
    apply Rle_trans with (u * (IZR S' * scale k)).
    - apply Rmult_le_compat_l; [generalize u_bounds; lra | exact H].
    - rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [left; apply scale_pos |].
      apply Rle_trans with (u * (IZR (up S' 53) * IZR (2 ^ 53))).
      + apply Rmult_le_compat_l; [generalize u_bounds; lra |]. apply up_le. discriminate.
      + replace (u * (IZR (up S' 53) * IZR (2 ^ 53))) with (IZR (up S' 53) * (u * IZR (2 ^ 53))) by ring.
        rewrite u_53. lra. }
  assert (E : Rabs (rnd v - V) <= IZR (vE + r) * scale k).
  { rewrite plus_IZR. generalize (Rabs_triang (rnd v - v) (v - V)).
    replace (rnd v - v + (v - V)) with (rnd v - V) by ring. lra. }
  split; [exact HX | split; [| exact E]].
  apply min_IZR.
  - rewrite plus_IZR. generalize (tri (rnd v) v). lra.
  - rewrite plus_IZR. generalize (tri (rnd v) V). lra.
Qed.

Definition hints_hold (h : hints) :=
  Forall (fun ez => forall b, bound h (fst ez) = Some b -> Rabs (exact X (fst ez)) <= IZR (snd ez) * scale (deg b)) h.

Lemma tighten_le h e z s : Rabs (exact X e) <= IZR z * s ->
  Forall (fun ez => e = fst ez -> Rabs (exact X e) <= IZR (snd ez) * s) h ->
  Rabs (exact X e) <= IZR (tighten h e z) * s.
Proof.
  intros B H. induction H as [| [e' z'] h G H IH]; [exact B |]. cbn.
  destruct (expr_dec e e') as [-> | _]; [| exact IH].
  apply min_IZR; [now apply G | exact IH].
Qed.

Lemma tighten_bound h e b z : hints_hold h -> bound h e = Some b ->
  Rabs (exact X e) <= IZR z * scale (deg b) -> Rabs (exact X e) <= IZR (tighten h e z) * scale (deg b).
Proof.
  intros H B L. apply tighten_le; [exact L |].
  refine (Forall_impl _ _ H). intros [e' z'] G E. cbn in *. subst e'. now apply G.
Qed.

Lemma rounded_format e : F (rounded x e).
Proof. induction e; [apply x_format | apply F_rnd .. | now apply F_opp]. Qed.

(* A sum or a difference, from those of its parts. *)
Lemma sum_fits h e y z a b va Va vb Vb r : hints_hold h -> fits va Va a -> fits vb Vb b -> F va -> F vb ->
  (y = va + vb /\ z = Va + Vb \/ y = va - vb /\ z = Va - Vb) -> exact X e = z ->
  bound h e = Some r -> sum h e a b = Some r -> fits (rnd y) z r.
Proof.
  intros H (XA & CA & EA) (XB & CB & EB) Fa Fb D Z B S.
  unfold sum in S. destruct (Nat.eqb_spec (deg a) (deg b)) as [K | _]; [| discriminate].
  apply some_eq in S. rename S into R. rewrite <- K in *.
  assert (tri : forall s t, Rabs (s + t) <= Rabs s + Rabs t /\ Rabs (s - t) <= Rabs s + Rabs t).
  { intros s t. split; [apply Rabs_triang |]. generalize (Rabs_triang s (- t)). now rewrite Rabs_Ropp. }
  rewrite <- R. apply round_off_fits.
  - rewrite <- Z. replace (deg a) with (deg r) by now rewrite <- R. apply tighten_bound; [exact H | exact B |].
    rewrite <- R. cbn [deg round_off]. rewrite plus_IZR, Z. generalize (tri Va Vb). destruct D as [[_ ->] | [_ ->]]; lra.
  - rewrite plus_IZR. generalize (tri va vb). destruct D as [[-> _] | [-> _]]; lra.
  - rewrite plus_IZR. generalize (tri (va - Va) (vb - Vb)).
    destruct D as [[-> ->] | [-> ->]].
    + replace (va + vb - (Va + Vb)) with ((va - Va) + (vb - Vb)) by ring. lra.
    + replace (va - vb - (Va - Vb)) with ((va - Va) - (vb - Vb)) by ring. lra.
  - rewrite Rmult_0_l, Rplus_0_r. destruct D as [[-> _] | [-> _]]; [now apply rnd_add | now apply rnd_sub].
Qed.

(* Twice a number, which is exact. *)
Lemma double_fits h a p b : hints_hold h -> fits (rounded x a) (exact X a) p -> bound h (Plus a a) = Some b ->
  Bnd (deg p) (tighten h (Plus a a) (2 * ex p)) (2 * co p) (2 * er p) = b -> fits (rounded x (Plus a a)) (exact X (Plus a a)) b.
Proof.
  intros H (A1 & A2 & A3) B R. cbn [rounded]. unfold fadd. rewrite rnd_double by apply rounded_format.
  assert (two : forall t, Rabs (2 * t) = 2 * Rabs t) by (intro; rewrite Rabs_mult, (Rabs_pos_eq 2); lra).
  split; [| split].
  - rewrite <- R at 1. cbn [ex]. apply (tighten_bound _ _ _ _ H B).
    cbn [exact]. replace (exact X a + exact X a) with (2 * exact X a) by ring.
    rewrite <- R, two, mult_IZR. cbn [deg]. lra.
  - rewrite <- R, two. cbn [deg co]. rewrite mult_IZR. lra.
  - cbn [exact]. replace (exact X a + exact X a) with (2 * exact X a) by ring.
    rewrite <- Rmult_minus_distr_l, two, <- R. cbn [deg er]. rewrite mult_IZR. lra.
Qed.

Lemma product_fits h a b p q r : hints_hold h -> fits (rounded x a) (exact X a) p -> fits (rounded x b) (exact X b) q -> (deg p + deg q <= 8)%nat ->
  bound h (Times a b) = Some r ->
  round_off (deg p + deg q) (tighten h (Times a b) (prod (ex p) (ex q))) (prod (co p) (co q))
    (Z.min (prod (co p) (er q) + prod (er p) (ex q)) (prod (ex p) (er q) + prod (er p) (co q))) 1 = r ->
  fits (rounded x (Times a b)) (exact X (Times a b)) r.
Proof.
  intros H (A1 & A2 & A3) (B1 & B2 & B3) K B R.
  cbn [rounded exact]. set (va := rounded x a) in *. set (vb := rounded x b) in *.
  set (Va := exact X a) in *. set (Vb := exact X b) in *.
  assert (nonneg : forall t, 0 <= Rabs t) by apply Rabs_pos.
  rewrite <- R. apply round_off_fits.
  - replace (Va * Vb) with (exact X (Times a b)) by reflexivity.
    replace (deg p + deg q)%nat with (deg r) by now rewrite <- R.
    apply (tighten_bound _ _ _ _ H B). rewrite <- R. cbn [deg round_off exact]. rewrite Rabs_mult.
    apply prod_le; auto.
  - rewrite Rabs_mult. apply prod_le; auto.
  - apply min_IZR; rewrite plus_IZR, Rmult_plus_distr_r.
    + replace (va * vb - Va * Vb) with (va * (vb - Vb) + (va - Va) * Vb) by ring.
      apply Rle_trans with (1 := Rabs_triang _ _). rewrite !Rabs_mult.
      apply Rplus_le_compat; apply prod_le; auto.
    + replace (va * vb - Va * Vb) with (Va * (vb - Vb) + (va - Va) * vb) by ring.
      apply Rle_trans with (1 := Rabs_triang _ _). rewrite !Rabs_mult.
      apply Rplus_le_compat; apply prod_le; auto.
  - rewrite Rmult_1_l. apply Rle_trans with (1 := rnd_any _). generalize (scale_underflow _ K). lra.
Qed.

Theorem bound_sound h : hints_hold h -> forall e b, bound h e = Some b -> fits (rounded x e) (exact X e) b.
Proof.
  intro H. induction e as [n | a IHa b' IHb | a IHa b' IHb | a IHa b' IHb | a IHa]; intros b B; generalize B; intro B'; cbn [bound] in B'.
  - apply some_eq in B'. subst b. unfold fits. cbn [deg ex co er].
    assert (C : Rabs (x n) <= IZR one * scale 1) by (rewrite scale_one; apply x_small).
    assert (E : Rabs (x n - X n) <= IZR unit_roundoff * scale 1) by (rewrite scale_u; apply x_close).
    split; [| split; [exact C | exact E]].
    apply (tighten_bound _ _ _ _ H B). cbn [deg]. rewrite plus_IZR. cbn [exact].
    generalize (Rabs_triang (x n) (- (x n - X n))). rewrite Rabs_Ropp.
    replace (x n + - (x n - X n)) with (X n) by ring. lra.
  - destruct (bound h a) as [p |]; [| discriminate]. destruct (expr_dec a b') as [<- | _].
    + apply some_eq in B'. exact (double_fits h a p b H (IHa p eq_refl) B B').
    + destruct (bound h b') as [q |]; [| discriminate].
      apply (sum_fits h (Plus a b') _ _ p q _ _ _ _ b H (IHa p eq_refl) (IHb q eq_refl)); try apply rounded_format; auto.
  - destruct (bound h a) as [p |]; [| discriminate]. destruct (bound h b') as [q |]; [| discriminate].
    apply (sum_fits h (Minus a b') _ _ p q _ _ _ _ b H (IHa p eq_refl) (IHb q eq_refl)); try apply rounded_format; auto.
  - destruct (bound h a) as [p |]; [| discriminate]. destruct (bound h b') as [q |]; [| discriminate].
    destruct (Nat.leb_spec (deg p + deg q) 8) as [K |]; [| discriminate].
    apply some_eq in B'. exact (product_fits h a b' p q b H (IHa p eq_refl) (IHb q eq_refl) K B B').
  - destruct (IHa b B) as (A1 & A2 & A3). cbn [rounded exact]. unfold fits.
    replace (- rounded x a - - exact X a) with (- (rounded x a - exact X a)) by ring. rewrite !Rabs_Ropp. auto.
Qed.

(* The same as one comparison, for lists of constants. *)
Theorem error_below_sound h e k bX bC bE : hints_hold h -> error_below h e k bX bC bE = true ->
  Rabs (exact X e) <= IZR bX * scale k /\ Rabs (rounded x e) <= IZR bC * scale k /\
  Rabs (rounded x e - exact X e) <= IZR bE * scale k.
Proof.
  intros H E. unfold error_below in E. destruct (bound h e) as [b |] eqn:B; [| discriminate].
  apply andb_prop in E. destruct E as [E E4]. apply andb_prop in E. destruct E as [E E3].
  apply andb_prop in E. destruct E as [E1 E2].
  apply Nat.eqb_eq in E1. apply Z.leb_le, IZR_le in E2, E3, E4. subst k.
  destruct (bound_sound h H e b B) as (A1 & A2 & A3). generalize (scale_pos (deg b)). intro P.
  split; [| split]; eapply Rle_trans; try eassumption; apply Rmult_le_compat_r; lra.
Qed.
End soundness.
