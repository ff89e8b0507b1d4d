(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What holds for all positive numbers that are small enough. *)
Require Import Reals Lra List.
Open Scope R_scope.

Definition small (Q : R -> Prop) : Prop := exists e0, 0 < e0 /\ forall e, 0 < e < e0 -> Q e.

Lemma small_and Q Q' : small Q -> small Q' -> small (fun e => Q e /\ Q' e).
Proof.
  intros (a & A & H) (b & B & K). exists (Rmin a b). split; [now apply Rmin_glb_lt|].
  intros e [E L]. generalize (Rmin_l a b) (Rmin_r a b). intros. split; [apply H | apply K]; lra.
Qed.

Lemma small_impl (Q Q' : R -> Prop) : (forall e, 0 < e -> Q e -> Q' e) -> small Q -> small Q'.
Proof. intros I (a & A & H). exists a. split; [exact A|]. intros e E. apply I; [lra | now apply H]. Qed.

Lemma small_all {S : Type} (Q : S -> R -> Prop) l : (forall s, In s l -> small (Q s)) -> small (fun e => forall s, In s l -> Q s e).
Proof.
  induction l as [|s l IH]; intro H; [exists 1; split; [lra|easy]|].
  apply (small_impl (fun e => Q s e /\ forall r, In r l -> Q r e)).
  - intros e _ [H0 H1] r [<-|I]; [exact H0 | now apply H1].
  - apply small_and; [apply H; now left|]. apply IH. intros r I. apply H. now right.
Qed.

Lemma small_below b : 0 < b -> small (fun e => e < b).
Proof. intro B. exists b. split; [exact B|]. intros e E. apply E. Qed.

Lemma small_exists Q : small Q -> exists e, 0 < e /\ Q e.
Proof. intros (a & A & H). exists (a / 2). split; [lra|]. apply H. lra. Qed.

(* Between f and g, close to f. *)
Lemma small_positive f g : 0 < f -> small (fun e => 0 < (1 - e) * f + e * g).
Proof.
  intro F. exists (f / (f + Rabs g)). generalize (Rabs_pos g). intro A. split; [apply Rdiv_lt_0_compat; lra|].
  intros e [E L]. assert (K : e * (f + Rabs g) < f) by (apply (Rmult_lt_compat_r (f + Rabs g)) in L; [|lra]; unfold Rdiv in L; rewrite Rmult_assoc, Rinv_l in L; lra).
  generalize (Rle_abs (- g)). rewrite Rabs_Ropp. intro G. assert (e * - g <= e * Rabs g) by (apply Rmult_le_compat_l; lra). lra.
Qed.

Lemma small_limit f g : small (fun e => 0 <= (1 - e) * f + e * g) -> 0 <= f.
Proof.
  intro S. apply Rnot_lt_le. intro F. assert (P : small (fun e => 0 < (1 - e) * - f + e * - g)) by (apply small_positive; lra).
  destruct (small_exists _ (small_and _ _ S P)) as (e & _ & H & K). lra.
Qed.
