(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The one inequality behind every annulus, in numbers: docs/theory.md, section 2.

   L |z|^2 - n.z has the value 0 at the points of A and D at those of B (bicell.v: `level`). Moved by d such a point's
   value changes by L |d|^2 - m.d, where m is its arm, with length nA on the side of A and nB on that of B. If the moves of the
   two sides add up to less than the width 2D / (nA + nB), the values of A stay below those of B. The sign of L does not
   matter, and where it is 0 the annulus is a slab. *)
Require Import Reals Lra Psatz.
Open Scope R_scope.

Theorem gap L D nA nB eA eB dA dB :
  nB * nB - nA * nA = 4 * L * D -> 0 < D -> 0 <= nA -> 0 <= nB -> 0 < nA + nB ->
  0 <= dA < eA -> 0 <= dB < eB -> (eA + eB) * (nA + nB) <= 2 * D ->
  L * (dA * dA) + nA * dA < D + L * (dB * dB) - nB * dB.
Proof.
  intros E HD HA HB HS HdA HdB W.
  set (S := nA + nB) in *. set (sigma := dA + dB). set (theta := dB - dA).
  assert (Hs : S * sigma < 2 * D) by (apply Rlt_le_trans with (2 := W); rewrite (Rmult_comm S); apply Rmult_lt_compat_r; unfold sigma; lra).
  assert (Hsn : 0 <= sigma) by (unfold sigma; lra).
  (* L theta is less than half of S *)
  assert (T : 2 * (L * theta) < S).
  { assert (A : Rabs (nB - nA) <= S) by (unfold S; apply Rabs_le; lra).
    assert (F : S * (nB - nA) = 4 * L * D) by (rewrite <- E; unfold S; ring).
    destruct (Req_dec L 0) as [Z0|Z0]; [rewrite Z0; lra|].
    assert (LL : 0 < Rabs L) by now apply Rabs_pos_lt.
    assert (G : S * Rabs (nB - nA) = 4 * Rabs L * D).
    { rewrite <- (Rabs_pos_eq S) by lra. rewrite <- Rabs_mult, F, !Rabs_mult, (Rabs_pos_eq 4), (Rabs_pos_eq D) by lra. ring. }
    apply Rmult_lt_reg_l with S; [exact HS|].
    apply Rle_lt_trans with (2 * Rabs L * (S * sigma)).
    - assert (L * theta <= Rabs L * sigma).
      { apply Rle_trans with (Rabs (L * theta)); [apply Rle_abs|]. rewrite Rabs_mult.
        apply Rmult_le_compat_l; [lra|]. unfold theta, sigma. apply Rabs_le. lra. }
      replace (2 * Rabs L * (S * sigma)) with (S * (2 * (Rabs L * sigma))) by ring.
      apply Rmult_le_compat_l; lra.
    - apply Rlt_le_trans with (4 * Rabs L * D).
      + replace (4 * Rabs L * D) with (2 * Rabs L * (2 * D)) by ring. apply Rmult_lt_compat_l; lra.
      + rewrite <- G. apply Rmult_le_compat_l; lra. }
  apply Rmult_lt_reg_l with S; [exact HS|]. apply Rminus_gt_0_lt.
  replace (S * (D + L * (dB * dB) - nB * dB) - S * (L * (dA * dA) + nA * dA))
    with ((2 * D - S * sigma) * (S - 2 * (L * theta)) / 2 + (4 * L * D - (nB * nB - nA * nA)) * theta / 2)
    by (unfold S, sigma, theta; field).
  rewrite E. generalize (Rmult_lt_0_compat (2 * D - S * sigma) (S - 2 * (L * theta)) ltac:(lra) ltac:(lra)). lra.
Qed.
