(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What a step of `filter` (algorithm_filter.v) leaves alone: a certificate that is neither evaluated nor two-sided keeps its reference and allowance.

   - stepped_untouched   so: renewals are of two-sided certificates, a rebase moves bases and expiries, nothing else is written *)
Require Import Reals ZArith List Bool.
From Annulus Require Import algorithm_list algorithm_filter algorithm_look algorithm_step algorithm_run.
Import ListNotations.

Section untouched.
Context {W : world} {L : laws}.

(* What a record promises is the same. *)
Definition same_promise (s t : state) (i : Z) : Prop :=
  reference (record t i) = reference (record s i) /\ allowance (record t i) = allowance (record s i).
(* And what it is of. *)
Definition untouched (s t : state) (i : Z) : Prop := same_promise s t i /\ mesh t = mesh s.

Lemma untouched_trans s t u i : untouched s t i -> untouched t u i -> untouched s u i.
Proof. unfold untouched, same_promise. intros [[-> ->] ->] [[-> ->] ->]. now repeat split. Qed.
Lemma untouched_fold {A} (g : state -> A -> state) i l : (forall s a, In a l -> untouched s (g s a) i) -> forall s, untouched s (fold_left g l s) i.
Proof.
  induction l as [|a l IH]; intros H s; [now repeat split|]. cbn [fold_left].
  apply untouched_trans with (g s a); [apply H; now left|]. apply IH. intros t b I. apply H. now right.
Qed.

Lemma anchor_untouched x s v i : untouched s (anchor x s v) i.
Proof. unfold anchor. destruct (_ =? _)%Z; now repeat split. Qed.

Lemma write_at_untouched x j c far t s i : i <> j -> untouched s (write_at x j c far t s) i.
Proof.
  intro N. unfold write_at. apply untouched_trans with (fold_left (write_point x j far) (points c) s).
  - apply untouched_fold. intros u v _. unfold write_point. apply untouched_trans with (anchor x u v); [apply anchor_untouched|now repeat split].
  - unfold untouched, same_promise. cbn [record set_record mesh]. unfold set. destruct (Z.eq_dec j i); [congruence|now repeat split].
Qed.

Lemma renewal_untouched x s n i c : mesh s i = Some c -> two_sided c = false -> untouched s (commit_renewal x s n) i.
Proof.
  intros M T. destruct n as [[j d] k]. unfold commit_renewal. destruct (mesh s j) as [e|] eqn:E; [|now repeat split].
  destruct (two_sided e) eqn:Te; [|now repeat split]. assert (N : i <> j) by (intros ->; congruence). destruct k as [new allowed|far]; [|now apply write_at_untouched].
  eapply untouched_trans; [apply (untouched_fold (renew_point j new) i (points e))|].
  - intros u v _. unfold renew_point. destruct (_ =? _)%Z; now repeat split.
  - unfold untouched, same_promise. cbn [record set_record mesh]. unfold set. destruct (Z.eq_dec j i); [congruence|now repeat split].
Qed.

Lemma renewals_untouched x l i c : two_sided c = false -> forall s, mesh s i = Some c -> untouched s (fold_left (commit_renewal x) l s) i.
Proof.
  intro T. induction l as [|n l IH]; intros s M; [now repeat split|]. cbn [fold_left]. assert (U := renewal_untouched x s n i c M T).
  apply untouched_trans with (1 := U), IH. destruct U as [_ ->]. exact M.
Qed.

Lemma finish_untouched s v i : untouched s (finish s v) i.
Proof.
  unfold finish, rebase, untouched, same_promise. destruct (worn _ _); cbn [record set_at mesh]; [|now repeat split].
  destruct (has s i v); now repeat split.
Qed.

Lemma commit_untouched x s renewed m verdicts i c : m i = Some c -> two_sided c = false -> ~ In i (map id verdicts) ->
  same_promise s (commit x s renewed m verdicts) i.
Proof.
  intros M T N. unfold commit. set (s1 := fold_left (commit_renewal x) renewed (with_mesh s m)). set (s2 := fold_left (commit_evaluated x) verdicts s1).
  assert (U1 : untouched (with_mesh s m) s1 i) by now apply renewals_untouched with c.
  assert (U2 : untouched s1 s2 i).
  { apply untouched_fold. intros t k K. apply write_at_untouched. intros ->. apply N. now apply in_map. }
  assert (U3 : untouched s2 (fold_left finish (anchored s2) s2) i) by (apply untouched_fold; intros; apply finish_untouched).
  exact (proj1 (untouched_trans _ _ _ _ (untouched_trans _ _ _ _ U1 U2) U3)).
Qed.

Theorem stepped_untouched second_look s x failed m verdicts i c : invariant s -> (forall v, valid (x v)) ->
  m i = Some c -> two_sided c = false -> ~ In i (map id verdicts) -> same_promise s (stepped second_look s x failed m verdicts) i.
Proof.
  intros V X M T N. unfold stepped. destruct (find_expired second_look s x failed) as [[u suspects] renewed] eqn:E.
  assert (R : record u i = record s i).
  { unfold find_expired in E. injection E as <- _ _. cbn [record]. now apply t_record. }
  destruct (commit_untouched x u renewed m verdicts i c M T N) as [A B]. unfold same_promise. rewrite A, B, R. now split.
Qed.
End untouched.
