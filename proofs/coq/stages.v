(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A sequence of stages: each answers or passes the question on. When an answer is right.

   - stages_right    where each stage is right, so is the filtered predicate
   - stages_sign     its sign is right too where the first stage does not certify its tolerance *)
From Coq Require Import Reals Lra Floats.
From Annulus Require Import operations bridge filter_2.
Close Scope float_scope.
Open Scope R_scope.

Definition or_else {T} (first second : answer T) : answer T := match first with refused => second | _ => first end.
(* In the mode `correctly_rounded` a positive answer is computed again by the exact stage. *)
Definition staged {T} (correctly_rounded : bool) (filter interval exact : answer T) : answer T :=
  let first := or_else filter (or_else interval exact) in
  match first with positive _ => if correctly_rounded then exact else first | _ => first end.

(* A determinant's sign; a tolerance is finite and at most a number that certifies. *)
Definition right_sign (a : answer float) (det : R) : Prop :=
  match a with refused => True | negative _ => det < 0 | filter_2.zero _ => det = 0 | positive _ => 0 < det end.
Definition right_answer (a : answer float) (det certifying : R) : Prop :=
  match a with positive t => finite t = true /\ 0 < det /\ 0 <= value t <= certifying | _ => right_sign a det end.

Lemma right_answer_sign a det w : right_answer a det w -> right_sign a det.
Proof. destruct a; simpl; tauto. Qed.

Theorem stages_right correctly_rounded a b c det w : right_answer a det w -> right_answer b det w -> right_answer c det w -> c <> refused ->
  right_answer (staged correctly_rounded a b c) det w /\ staged correctly_rounded a b c <> refused.
Proof.
  intros A B C N. assert (H : right_answer (or_else a (or_else b c)) det w /\ or_else a (or_else b c) <> refused).
  { destruct a; try (now split). destruct b; now split. }
  unfold staged. cbv zeta. destruct (or_else a (or_else b c)); trivial. now destruct correctly_rounded.
Qed.
Theorem stages_sign a b c det v w : right_sign a det -> right_answer b det v -> right_answer c det w -> right_sign (staged false a b c) det.
Proof.
  intros A B C. apply right_answer_sign in B. apply right_answer_sign in C. destruct a; trivial. destruct b; trivial. destruct c; trivial.
Qed.

Lemma right_unscaled a k det w : 0 < k -> right_answer a (k * det) w -> right_answer a det w.
Proof.
  intros K. destruct a as [|t|t|t]; simpl; trivial.
  - intro H. apply Rmult_lt_reg_l with k; [exact K|]. now rewrite Rmult_0_r.
  - intro H. apply Rmult_eq_reg_l with k; [|lra]. now rewrite Rmult_0_r.
  - intros (F & P & H). split; [exact F|]. split; [|exact H]. apply Rmult_lt_reg_l with k; [exact K|]. now rewrite Rmult_0_r.
Qed.

(* A verdict that was made of an answer: its tolerance, or 0 where the determinant is 0 and a rule says that the certificate holds. *)
Definition says (a : answer float) (rule : Prop) (tolerance : R) : Prop :=
  match a with positive t => tolerance = value t | filter_2.zero _ => rule /\ tolerance = 0 | _ => False end.
