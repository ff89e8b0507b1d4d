(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Affine functions of space, and points close to a given one at which none of finitely many vanishes.

   - near_positive   close to z, in the direction of g, what is positive at z, or 0 there and positive at g, is positive
   - near_nonzero    what vanishes somewhere only, does not vanish

   Points come close on a curve that no plane holds. *)
Require Import Reals Lra Psatz List.
From Annulus Require Import vectors small.
Import ListNotations.
Open Scope R_scope.

Definition affine (f : vec -> R) : Prop := exists n k, forall x, f x = n · x + k.

Lemma affine_sum f g a b : affine f -> affine g -> affine (fun x => a * f x + b * g x).
Proof. intros (n & k & F) (n' & k' & G). exists (a ⊙ n ⊕ b ⊙ n'), (a * k + b * k'). intro x. rewrite F, G. generalize n n' x. vector. Qed.

Lemma affine_ext f g : (forall x, g x = f x) -> affine f -> affine g.
Proof. intros E (n & k & F). exists n, k. intro x. now rewrite E. Qed.

Definition curve (z g : vec) (e : R) : vec := z ⊕ e ⊙ (g ⊖ z) ⊕ V (e * e) (e * e * e) (e * e * e * e).

Fixpoint polynomial (c : list R) (e : R) : R := match c with [] => 0 | a :: c' => a + e * polynomial c' e end.

Lemma polynomial_bound c : exists k, 0 <= k /\ forall e, 0 < e < 1 -> Rabs (polynomial c e) <= k.
Proof.
  induction c as [|a c IH].
  - exists 0. split; [lra|]. intros e _. simpl. rewrite Rabs_R0. lra.
  - destruct IH as (k & K & H). exists (Rabs a + k). split; [generalize (Rabs_pos a); lra|]. intros e E. simpl.
    apply Rle_trans with (Rabs a + Rabs (e * polynomial c e)); [apply Rabs_triang|]. rewrite Rabs_mult, (Rabs_pos_eq e) by lra.
    generalize (H e E) (Rabs_pos (polynomial c e)). intros. nra.
Qed.

Lemma polynomial_positive a c : 0 < a -> small (fun e => 0 < polynomial (a :: c) e).
Proof.
  intro A. destruct (polynomial_bound c) as (k & K & H).
  apply (small_impl (fun e => 0 < (1 - e) * a + e * (a - k) /\ e < 1)).
  - intros e E [P L]. simpl. generalize (H e (conj E L)) (Rle_abs (- polynomial c e)). rewrite Rabs_Ropp. intros. nra.
  - apply small_and; [now apply small_positive|apply small_below; lra].
Qed.

Lemma polynomial_nonzero c : (exists a, In a c /\ a <> 0) -> small (fun e => polynomial c e <> 0).
Proof.
  induction c as [|a c IH]; intros (b & I & N); [easy|]. destruct (Rtotal_order a 0) as [L|[->|L]].
  - destruct (polynomial_bound c) as (k & K & H).
    apply (small_impl (fun e => 0 < (1 - e) * - a + e * (- a - k) /\ e < 1)).
    + intros e E [P Q]. simpl. generalize (H e (conj E Q)) (Rle_abs (polynomial c e)). intros. nra.
    + apply small_and; [apply small_positive; lra|apply small_below; lra].
  - assert (J : exists a, In a c /\ a <> 0) by (exists b; split; [destruct I as [<-|I]; [now elim N|exact I]|exact N]).
    apply (small_impl (fun e => polynomial c e <> 0)); [|now apply IH]. intros e E P. simpl. rewrite Rplus_0_l. apply Rmult_integral_contrapositive_currified; lra.
  - apply (small_impl (fun e => 0 < polynomial (a :: c) e)); [intros; lra|]. now apply polynomial_positive.
Qed.

Lemma affine_curve n k z g e : n · curve z g e + k = polynomial [n · z + k; n · g - n · z; X1 n; X2 n; X3 n] e.
Proof. unfold curve, polynomial, dot. simpl. ring. Qed.

Lemma near_positive f z g : affine f -> 0 < f z \/ (f z = 0 /\ 0 < f g) -> small (fun e => 0 < f (curve z g e)).
Proof.
  intros (n & k & F) P. rewrite !F in P.
  apply (small_impl (fun e => 0 < polynomial [n · z + k; n · g - n · z; X1 n; X2 n; X3 n] e)); [intros e _ H; now rewrite F, affine_curve|].
  destruct P as [P|[Z P]]; [now apply polynomial_positive|].
  apply (small_impl (fun e => 0 < polynomial [n · g - n · z; X1 n; X2 n; X3 n] e)); [|apply polynomial_positive; lra].
  intros e E H. cbn [polynomial] in *. rewrite Z, Rplus_0_l. now apply Rmult_lt_0_compat.
Qed.

Lemma near_nonzero f z g : affine f -> (exists p, f p <> 0) -> small (fun e => f (curve z g e) <> 0).
Proof.
  intros (n & k & F) (p & P). apply (small_impl (fun e => polynomial [n · z + k; n · g - n · z; X1 n; X2 n; X3 n] e <> 0)).
  - intros e _ H. now rewrite F, affine_curve.
  - apply polynomial_nonzero. destruct (Req_EM_T (X1 n) 0) as [N1|N1]; [|exists (X1 n); simpl; tauto].
    destruct (Req_EM_T (X2 n) 0) as [N2|N2]; [|exists (X2 n); simpl; tauto]. destruct (Req_EM_T (X3 n) 0) as [N3|N3]; [|exists (X3 n); simpl; tauto].
    exists (n · z + k). split; [now left|]. rewrite F in P. unfold dot in *. rewrite N1, N2, N3 in *. intro Z. apply P. lra.
Qed.

(* What is not negative close to z is not negative at z. *)
Lemma near_limit f z g : affine f -> small (fun e => 0 <= f (curve z g e)) -> 0 <= f z.
Proof.
  intros A S. apply Rnot_lt_le. intro N. assert (A' : affine (fun x => -1 * f x + 0 * f x)) by now apply affine_sum.
  assert (N' : 0 < -1 * f z + 0 * f z) by lra. assert (P := near_positive _ z g A' (or_introl N')).
  destruct (small_exists _ (small_and _ _ S P)) as (e & _ & H & K). lra.
Qed.
