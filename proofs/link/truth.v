(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Comparing a double with P / (sqrt A + sqrt B) for integers P, A, B, without a square root:
   y (sqrt A + sqrt B) <= P exactly when 0 <= r and 4 y^4 A B <= r^2 with r = P^2 - y^2 (A + B). *)
From Coq Require Import Reals ZArith Lra Psatz.
Open Scope R_scope.

Definition at_most (y P A B : Z) : bool :=
  let r := (P * P - y * y * (A + B))%Z in
  ((0 <=? r) && (4 * (y * y) * (y * y) * (A * B) <=? r * r))%Z%bool.

Lemma squares_le : forall a b, 0 <= a -> 0 <= b -> (a * a <= b * b <-> a <= b).
Proof. intros a b Ha Hb. split; intro H; [apply Rnot_lt_le; intro; nra|apply Rmult_le_compat; trivial]. Qed.

Lemma at_most_real : forall y P A B, 0 <= y -> 0 <= P -> 0 <= A -> 0 <= B ->
  (y * (sqrt A + sqrt B) <= P <->
   0 <= P * P - y * y * (A + B) /\
   4 * (y * y) * (y * y) * (A * B) <= (P * P - y * y * (A + B)) * (P * P - y * y * (A + B))).
Proof.
  intros y P A B Hy HP HA HB.
  assert (sA := sqrt_pos A). assert (sB := sqrt_pos B).
  assert (qA := sqrt_sqrt A HA). assert (qB := sqrt_sqrt B HB).
  set (a := sqrt A) in *. set (b := sqrt B) in *.
  set (r := P * P - y * y * (A + B)). set (z := 2 * (y * y) * (a * b)).
  assert (Hz : 0 <= z) by (unfold z; apply Rmult_le_pos; [nra|apply Rmult_le_pos; assumption]).
  assert (E : y * (a + b) * (y * (a + b)) = y * y * (A + B) + z) by (unfold z; rewrite <- qA, <- qB; ring).
  assert (Z2 : z * z = 4 * (y * y) * (y * y) * (A * B)) by (unfold z; rewrite <- qA, <- qB; ring).
  assert (K : y * (a + b) <= P <-> y * y * (A + B) + z <= P * P).
  { rewrite <- E. symmetry. apply squares_le; [apply Rmult_le_pos; lra|exact HP]. }
  rewrite K, <- Z2. fold r. split.
  - intro H. assert (L : z <= r) by (unfold r; lra). split.
    + apply Rle_trans with z; assumption.
    + apply Rmult_le_compat; assumption.
  - intros [Pos S]. apply (proj1 (squares_le _ _ Hz Pos)) in S. unfold r in S. lra.
Qed.

Theorem at_most_spec : forall y P A B, (0 <= y)%Z -> (0 <= P)%Z -> (0 <= A)%Z -> (0 <= B)%Z ->
  (at_most y P A B = true <-> IZR y * (sqrt (IZR A) + sqrt (IZR B)) <= IZR P).
Proof.
  intros y P A B Hy HP HA HB. apply IZR_le in Hy, HP, HA, HB.
  rewrite at_most_real by assumption. unfold at_most. cbv zeta.
  rewrite Bool.andb_true_iff, !Z.leb_le.
  rewrite <- !plus_IZR, <- !mult_IZR, <- !minus_IZR, <- !mult_IZR.
  split; intros [Pos S]; split; first [apply IZR_le; assumption | apply le_IZR; assumption].
Qed.
