(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What a step of `filter` (algorithm_filter.v) leaves alone: a certificate that is not evaluated keeps its reference and allowance.

   - stepped_untouched   so: a rebase moves bases and expiries, nothing else is written *)
Require Import Reals ZArith List Bool.
From Annulus Require Import algorithm_list algorithm_filter algorithm_check algorithm_step algorithm_run.
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

Lemma evaluated_untouched x s k i : i <> id k -> untouched s (commit_evaluated x s k) i.
Proof.
  intro N. unfold commit_evaluated. apply untouched_trans with (fold_left (write_point x (id k) (bound k)) (points (of k)) s).
  - apply untouched_fold. intros u v _. unfold write_point. apply untouched_trans with (anchor x u v); [apply anchor_untouched|now repeat split].
  - unfold set_written, untouched, same_promise. cbn [record set_record mesh]. unfold set. destruct (Z.eq_dec (id k) i); [congruence|now repeat split].
Qed.

Lemma finish_untouched s v i : untouched s (finish s v) i.
Proof.
  unfold finish, rebase, untouched, same_promise. destruct (worn _ _); cbn [record set_at mesh]; [|now repeat split].
  destruct (has s i v); now repeat split.
Qed.

Lemma commit_untouched x s m verdicts i : ~ In i (map id verdicts) -> same_promise s (commit x s m verdicts) i.
Proof.
  intro N. unfold commit. set (s1 := fold_left (commit_evaluated x) verdicts (with_mesh s m)).
  assert (U1 : untouched (with_mesh s m) s1 i).
  { apply untouched_fold. intros t k K. apply evaluated_untouched. intros ->. apply N. now apply in_map. }
  assert (U2 : untouched s1 (fold_left finish (anchored s1) s1) i) by (apply untouched_fold; intros; apply finish_untouched).
  exact (proj1 (untouched_trans _ _ _ _ U1 U2)).
Qed.

Theorem stepped_untouched s x failed m verdicts i : invariant s -> (forall v, valid (x v)) ->
  ~ In i (map id verdicts) -> same_promise s (stepped s x failed m verdicts) i.
Proof.
  intros V X N. unfold stepped.
  assert (R : record (fst (find_expired s x failed)) i = record s i) by (cbn [find_expired fst record]; now apply t_record).
  destruct (commit_untouched x (fst (find_expired s x failed)) m verdicts i N) as [A B]. unfold same_promise. rewrite A, B, R. now split.
Qed.
End untouched.
