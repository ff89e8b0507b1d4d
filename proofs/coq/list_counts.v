(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lists without repetitions, and how many elements satisfy this or that. *)
Require Import List Bool Lia.
Import ListNotations.

Section counts.
Context {element : Type}.

Lemma NoDup_snoc : forall (l : list element) v, NoDup l -> ~ In v l -> NoDup (l ++ [v]).
Proof.
  intros l v N. induction N as [|x l X N IH]; intro H; [constructor; [easy|constructor]|].
  simpl. constructor.
  - rewrite in_app_iff. intros [A|[A|[]]]; [contradiction|subst; apply H; now left].
  - apply IH. intro A. apply H. now right.
Qed.

Lemma filter_partition : forall (f g h : element -> bool) l, (forall v, In v l -> f v = true -> g v = true \/ h v = true) ->
  length (filter f l) <= length (filter g l) + length (filter h l).
Proof.
  intros f g h l. induction l as [|v l IH]; intro H; simpl; [lia|].
  assert (K := IH (fun w W => H w (or_intror W))). specialize (H v (or_introl eq_refl)).
  destruct (f v), (g v), (h v); simpl; first [lia|destruct H; easy].
Qed.

Lemma filter_disjoint : forall (f g h : element -> bool) l,
  (forall v, In v l -> g v = true -> f v = true) -> (forall v, In v l -> h v = true -> f v = true) ->
  (forall v, In v l -> ~ (g v = true /\ h v = true)) ->
  length (filter g l) + length (filter h l) <= length (filter f l).
Proof.
  intros f g h l. induction l as [|v l IH]; intros G H D; simpl; [lia|].
  assert (K := IH (fun w W => G w (or_intror W)) (fun w W => H w (or_intror W)) (fun w W => D w (or_intror W))).
  specialize (G v (or_introl eq_refl)). specialize (H v (or_introl eq_refl)). specialize (D v (or_introl eq_refl)).
  destruct (f v), (g v), (h v); simpl; first [lia|exfalso; first
    [now apply D|specialize (G eq_refl); discriminate|specialize (H eq_refl); discriminate]].
Qed.
End counts.
