(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Straight motions: what is continuous along them, and where a sign changes. *)
Require Import Reals Lra Psatz.
From Annulus Require Export vectors.
Open Scope R_scope.

Definition along (u v : vec) (t : R) := u ⊕ t ⊙ (v ⊖ u).

Lemma along_0 u v : along u v 0 = u.
Proof. unfold along. vector. Qed.

Lemma along_1 u v : along u v 1 = v.
Proof. unfold along. vector. Qed.

Lemma along_near u v t : 0 <= t <= 1 -> norm (along u v t ⊖ u) <= norm (v ⊖ u).
Proof.
  intro H. replace (along u v t ⊖ u) with (t ⊙ (v ⊖ u)) by (unfold along; vector). now apply norm_shorter.
Qed.

Definition continuous_vec (f : R -> vec) :=
  continuity (fun t => X1 (f t)) /\ continuity (fun t => X2 (f t)) /\ continuity (fun t => X3 (f t)).

Lemma continuous_const k : continuity (fun _ => k).
Proof. apply continuity_const. now intros ? ?. Qed.

Lemma continuous_plus f g : continuity f -> continuity g -> continuity (fun t => f t + g t).
Proof. apply continuity_plus. Qed.

Lemma continuous_minus f g : continuity f -> continuity g -> continuity (fun t => f t - g t).
Proof. apply continuity_minus. Qed.

Lemma continuous_mult f g : continuity f -> continuity g -> continuity (fun t => f t * g t).
Proof. apply continuity_mult. Qed.

Lemma continuous_opp f : continuity f -> continuity (fun t => - f t).
Proof. apply continuity_opp. Qed.

Lemma continuous_id : continuity (fun t => t).
Proof. apply derivable_continuous, derivable_id. Qed.

Lemma continuous_along u v : continuous_vec (along u v).
Proof.
  unfold along, continuous_vec, add, scale, sub. cbn [X1 X2 X3].
  repeat split; (apply continuous_plus; [apply continuous_const |
    apply continuous_mult; [apply continuous_id | apply continuous_const]]).
Qed.

Lemma continuous_sub f g : continuous_vec f -> continuous_vec g -> continuous_vec (fun t => f t ⊖ g t).
Proof. intros (? & ? & ?) (? & ? & ?). repeat split; cbn [sub X1 X2 X3]; now apply continuous_minus. Qed.

Lemma continuous_cross f g : continuous_vec f -> continuous_vec g -> continuous_vec (fun t => f t ✕ g t).
Proof.
  intros (? & ? & ?) (? & ? & ?). repeat split; cbn [cross X1 X2 X3];
    apply continuous_minus; now apply continuous_mult.
Qed.

Lemma continuous_dot f g : continuous_vec f -> continuous_vec g -> continuity (fun t => f t · g t).
Proof.
  intros (? & ? & ?) (? & ? & ?). unfold dot.
  repeat apply continuous_plus; now apply continuous_mult.
Qed.

Lemma continuous_vol f g h : continuous_vec f -> continuous_vec g -> continuous_vec h ->
  continuity (fun t => vol (f t) (g t) (h t)).
Proof. intros. apply continuous_dot; [now apply continuous_cross | assumption]. Qed.

Lemma continuous_sq f : continuous_vec f -> continuity (fun t => sq (f t)).
Proof. intro. now apply continuous_dot. Qed.

(* A number that is positive at the start and not at the end is 0 somewhere on the way. *)
Lemma vanishes f : continuity f -> 0 < f 0 -> f 1 <= 0 -> exists t, 0 <= t <= 1 /\ f t = 0.
Proof.
  intros C H0 H1. destruct (Req_dec (f 1) 0) as [E|E]; [exists 1; split; [lra | exact E]|].
  destruct (IVT (fun t => - f t) 0 1) as (t & Ht & Et); [now apply continuous_opp | lra | lra | lra |].
  exists t. split; [exact Ht | lra].
Qed.
