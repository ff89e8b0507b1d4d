(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A function that is changed at one place: set, set_same, set_other. *)

Definition set {A B} (same : forall a b : A, {a = b} + {a <> b}) (f : A -> B) (a : A) (b : B) : A -> B :=
  fun x => if same a x then b else f x.

Lemma set_same {X Y} (same : forall a b : X, {a = b} + {a <> b}) (f : X -> Y) a b : set same f a b a = b.
Proof. unfold set. now destruct (same a a). Qed.
Lemma set_other {X Y} (same : forall a b : X, {a = b} + {a <> b}) (f : X -> Y) a b c : c <> a -> set same f a b c = f c.
Proof. unfold set. intro N. destruct (same a c); [subst; contradiction|reflexivity]. Qed.
