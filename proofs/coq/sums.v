(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Finite sums of real numbers over lists. *)
Require Import Reals Lra List Permutation.
Import ListNotations.
Open Scope R_scope.

Section sums.
Context {T : Type}.
Fixpoint sum (f : T -> R) (l : list T) : R := match l with [] => 0 | i :: l' => f i + sum f l' end.

Lemma sum_cons f i l : sum f (i :: l) = f i + sum f l.
Proof. reflexivity. Qed.

Lemma sum_ext f g l : (forall i, In i l -> f i = g i) -> sum f l = sum g l.
Proof. induction l as [|i l IH]; simpl; intro H; [reflexivity|]. rewrite (H i (or_introl eq_refl)), IH; [reflexivity|]. intros j J. apply H. now right. Qed.

Lemma sum_plus f g l : sum (fun i => f i + g i) l = sum f l + sum g l.
Proof. induction l as [|i l IH]; simpl; [ring|]. rewrite IH. ring. Qed.

Lemma sum_scale k f l : sum (fun i => k * f i) l = k * sum f l.
Proof. induction l as [|i l IH]; simpl; [ring|]. rewrite IH. ring. Qed.

Lemma sum_zero l : sum (fun _ => 0) l = 0.
Proof. induction l as [|i l IH]; simpl; [reflexivity|]. rewrite IH. ring. Qed.

Lemma sum_app f l k : sum f (l ++ k) = sum f l + sum f k.
Proof. induction l as [|i l IH]; simpl; [ring|]. rewrite IH. ring. Qed.

Lemma sum_permutation f l k : Permutation l k -> sum f l = sum f k.
Proof. induction 1; simpl; lra. Qed.

Lemma sum_le f g l : (forall i, In i l -> f i <= g i) -> sum f l <= sum g l.
Proof.
  induction l as [|i l IH]; simpl; intro H; [lra|]. generalize (H i (or_introl eq_refl)). intro.
  assert (sum f l <= sum g l) by (apply IH; intros j J; apply H; now right). lra.
Qed.

Lemma sum_nonneg f l : (forall i, In i l -> 0 <= f i) -> 0 <= sum f l.
Proof.
  induction l as [|i l IH]; simpl; intro H; [lra|]. generalize (H i (or_introl eq_refl)). intro.
  assert (0 <= sum f l) by (apply IH; intros j J; apply H; now right). lra.
Qed.

(* A sum of such terms is positive when one of them is. *)
Lemma sum_pos f l i : (forall j, In j l -> 0 <= f j) -> In i l -> 0 < f i -> 0 < sum f l.
Proof.
  induction l as [|j l IH]; simpl; intros H I P; [contradiction|]. destruct I as [E|I].
  - subst j. assert (0 <= sum f l) by (apply sum_nonneg; intros; apply H; now right). lra.
  - generalize (H j (or_introl eq_refl)). assert (0 < sum f l) by (apply IH; trivial; intros; apply H; now right). lra.
Qed.

Lemma sum_negative f l : sum f l < 0 -> exists i, In i l /\ f i < 0.
Proof.
  induction l as [|i l IH]; simpl; intro H; [lra|]. destruct (Rlt_dec (f i) 0) as [L|L]; [exists i; tauto|].
  destruct IH as (j & J & N); [lra|]. exists j. tauto.
Qed.
End sums.

Lemma sum_swap {T U : Type} (f : T -> U -> R) l k : sum (fun i => sum (f i) k) l = sum (fun j => sum (fun i => f i j) l) k.
Proof.
  induction l as [|i l IH]; simpl.
  - now rewrite sum_zero.
  - rewrite IH, <- sum_plus. reflexivity.
Qed.

Lemma sum_flat_map {T U : Type} (f : U -> R) (g : T -> list U) l : sum f (flat_map g l) = sum (fun i => sum f (g i)) l.
Proof. induction l as [|i l IH]; simpl; [reflexivity|]. now rewrite sum_app, IH. Qed.

Lemma sum_map {T U : Type} (f : U -> R) (g : T -> U) l : sum f (map g l) = sum (fun i => f (g i)) l.
Proof. induction l as [|i l IH]; simpl; [reflexivity|]. now rewrite IH. Qed.
