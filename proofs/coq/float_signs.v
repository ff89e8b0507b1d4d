(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The error analysis of float_error.v on formulas that are written over any numbers (filter_2.v, filter_3.v): an instance of expressions, what such an
   expression stands for, and bounds of its error from those of its inputs.

   - computed_near   the computed value is nearer to the exact one than the constant that the analysis gives
   - sign_certain    so a computed value beyond its error bound, itself computed, has the right sign *)
From Coq Require Import Reals Lra Lia ZArith List.
From Flocq Require Import Core.
From Annulus Require Import float_model float_error_sound float_filter operations.
Import ListNotations.
Open Scope R_scope.

(* Not used are division, root, magnitude, maxima, comparisons, constants. *)
Definition analysed : operations := {|
  number := expr; add := Plus; sub := Minus; mul := Times; div a _ := a; root a := a; opposite := Opp; magnitude a := a;
  square a := Times a a; greater a _ := a; less _ _ := false; less_equal _ _ := false; constant _ := Var 0 |}.

Section near.
Variable m : R.
Hypothesis M : bpow radix2 (-120) <= m.
Variables l k : list R.    (* differences as computed, and exact *)
Hypothesis l_format : Forall F l.
Hypothesis l_small : Forall (fun a => Rabs a <= m) l.
Hypothesis l_close : Forall2 (fun a b => Rabs (a - b) <= u * m) l k.

Theorem computed_near e d C E : error_below [] e d (C * one) (C * one) (E * half_u) = true ->
  Rabs (float_error.rounded (env l) e - exact (env k) e) <= IZR E / 2 * u * m ^ d.
Proof.
  intro W. generalize (m_positive m M) u_bounds. intros M0 U. rewrite <- half_units.
  refine (proj2 (proj2 (error_below_sound m M (env k) (env l) _ _ _ [] e d _ _ _ (Forall_nil _) W))).
  - intro n. now apply (env_all F); [exact F_0|].
  - intro n. apply (env_all (fun a => Rabs a <= m)); [rewrite Rabs_R0; lra|exact l_small].
  - intro n. apply (env_all_2 (fun a b => Rabs (a - b) <= u * m)); [rewrite Rminus_0_r, Rabs_R0; apply Rmult_le_pos; lra|exact l_close].
Qed.
End near.

Lemma sign_certain C E m p k computed truth : bpow radix2 (-120) <= m -> (k <= 8)%nat -> (1 <= C < 2 ^ 20)%Z -> (E + 1 <= 2 * C)%Z ->
  (1 - 6 * u) * m ^ k <= p <= (1 + 6 * u) * m ^ k -> Rabs (computed - truth) <= IZR E / 2 * u * m ^ k ->
  (error_bound C p < computed -> 0 < truth) /\ (error_bound C p < - computed -> truth < 0).
Proof.
  intros M K HC HE HP N. generalize (error_bound_range m M C p k K HC HP) u_bounds (pow_lt m k (m_positive m M)). intros [L _] U P.
  apply IZR_le in HE. rewrite plus_IZR, mult_IZR in HE. assert (C1 : IZR C <= 1048576) by (apply IZR_le; lia).
  assert (S : IZR E / 2 * u * m ^ k <= IZR C * u * (1 - 8 * u) * m ^ k).
  { apply Rmult_le_compat_r; [lra|]. rewrite (Rmult_comm (IZR C * u)), <- Rmult_assoc. apply Rmult_le_compat_r; [lra|].
    assert (IZR C * (8 * u) <= 1048576 * (8 * u)) by (apply Rmult_le_compat_r; lra). unfold u in *. lra. }
  apply Rabs_le_inv in N. split; intro; lra.
Qed.
