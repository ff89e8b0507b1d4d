(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* signed_2.v in space: certificates by signs alone, without tolerances, as src/annulus/engine/sign_evaluator.cpp evaluates them on doubles.

   - turns_left_3, keeps_out_3, signed_3   a sign is that of the prepared sphere of a cell, its corners in whichever order the table has them, or of the
                                           exact stages; an answer 0 stands for a sphere, or for a flat piece of the border where the rule says so
   - signed_holds_3                        what is signed holds *)
From Coq Require Import Reals Lra ZArith List.
From Coq Require Import Floats.
From Annulus Require bicell.
From Annulus Require Import vectors operations connect filter_2 filter_3 returned_3 signs_3 exact_sign_2 exact_sign_3.
From Annulus Require Import space_mesh space_crossings space_delaunay filter_space flat_ridges_3 filter_delaunay_3.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

(* The corners of a cell in another order that has the same sign. *)
Definition same_cell (t t' : nat * nat * nat * nat) : Prop := exists s, In s (sides t) /\ turned s t'.

Definition prepared_3 (f : doubles_3) (t : nat * nat * nat * nat) : filter_3.circumsphere machine :=
  let '(a, b, c, d) := t in filter_3.circumsphere_of machine (f a) (f b) (f c) (f d).
(* Sign_evaluator::test_cell, is_inverted: orientation_sign.h computes what the prepared sphere does. *)
Definition turns_left_3 (f : doubles_3) (t : nat * nat * nat * nat) : Prop :=
  sphere_positive machine (prepared_3 f t) = true \/ (let '(a, b, c, d) := t in exact_orientation_sign_3 (f a) (f b) (f c) (f d)) = 1%Z.
Definition flat_3 (f : doubles_3) (t : nat * nat * nat * nat) : Prop := let '(a, b, c, d) := t in exact_orientation_sign_3 (f a) (f b) (f c) (f d) = 0%Z.
(* test_cell, sphere_sign, is_violated: the cell a b c q has p outside of its sphere, evaluated alone or with others, or on it. *)
Definition keeps_out_3 (f : doubles_3) (a b c p q : nat) : Prop :=
  (exists t, same_cell (a, b, c, q) t /\
    (sphere_positive machine (prepared_3 f t) = true /\ excludes_3 machine (prepared_3 f t) (f p) = true \/
     exists others, In p others /\ excludes_all_3 machine (prepared_3 f t) (map f others) = true)) \/
  (0 <= exact_empty_sphere_sign_3 (f a) (f b) (f c) (f p) (f q))%Z.

Definition signed_3 (f : doubles_3) (c : certificate_3) : Prop :=
  match c with
  | cell_3 a b c d => exists t, same_cell (a, b, c, d) t /\ turns_left_3 f t
  | ridge_3 u w c d => exists t, same_cell (u, w, c, d) t /\ (turns_left_3 f t \/ flat_3 f t /\ flat_ridge_holds_3 (f u) (f w) (f c) (f d) = true)
  | sphere a b c p q => keeps_out_3 f a b c p q \/ keeps_out_3 f b a c q p
  end.

(* ---- It holds ---- *)

(* Of five points, by vectors to the first, which keeps polynomials short. *)
Ltac from_first a b c d e :=
  unfold beyond_3, five, insphere_at, bicell.det, bicell.lambda_b, bicell.lambda_c, bicell.lambda_p, bicell.lambda_q, bicell.rel;
  replace (a ⊖ b) with (vectors.zero ⊖ (b ⊖ a)) by vector; replace (c ⊖ b) with ((c ⊖ a) ⊖ (b ⊖ a)) by vector;
  replace (d ⊖ b) with ((d ⊖ a) ⊖ (b ⊖ a)) by vector; replace (e ⊖ b) with ((e ⊖ a) ⊖ (b ⊖ a)) by vector;
  generalize (b ⊖ a) (c ⊖ a) (d ⊖ a) (e ⊖ a); intros [] [] [] []; unfold sq, vol, vectors.dot, vectors.cross, sub, vectors.zero; cbn; ring.
Lemma beyond_rotated a b c d p : beyond_3 b c a d p = beyond_3 a b c d p.
Proof. from_first a b c d p. Qed.
Lemma beyond_first_two a b c d p : beyond_3 b a d c p = beyond_3 a b c d p.
Proof. from_first a b c d p. Qed.
(* What two exchanges of corners leave alone is the same of all orders. *)
Lemma even_orders (g : nat -> nat -> nat -> nat -> R) : (forall a b c d, g b c a d = g a b c d) -> (forall a b c d, g b a d c = g a b c d) ->
  forall a b c d t, same_cell (a, b, c, d) t -> let '(x, y, z, w) := t in g x y z w = g a b c d.
Proof.
  intros R S a b c d t (s & I & T). assert (E : let '(x, y, z, w) := s in g x y z w = g a b c d).
  { destruct I as [<-|[<-|[<-|[<-|[]]]]]; [| | |reflexivity].
    - rewrite (S d b a c), (R a d b c), (R b a d c). apply S.
    - rewrite (S c a b d), (R b c a d). apply R.
    - rewrite (R b a d c). apply S. }
  clear I. destruct T as [x y z w|x y z w|x y z w]; [exact E|now rewrite R|now rewrite (R y z x w), R].
Qed.

Section holds.
Variable f : doubles_3.
Hypothesis domain : forall v, coordinates_3 (f v).
Let m := at_doubles_3 f.

Lemma order_volume a b c d t : same_cell (a, b, c, d) t -> let '(x, y, z, w) := t in orient_at m x y z w = orient_at m a b c d.
Proof.
  apply (even_orders (orient_at m)); clear; intros a b c d; unfold orient_at, orient; generalize (m a) (m b) (m c) (m d); vector.
Qed.
Lemma order_sphere a b c q p t : same_cell (a, b, c, q) t ->
  let '(x, y, z, w) := t in beyond_3 (m x) (m y) (m z) (m w) (m p) = insphere_at m a b c p q.
Proof. apply (even_orders (fun x y z w => beyond_3 (m x) (m y) (m z) (m w) (m p))); intros; [apply beyond_rotated|apply beyond_first_two]. Qed.

Lemma turns_left_3_right t : turns_left_3 f t -> let '(a, b, c, d) := t in 0 < orient_at m a b c d.
Proof.
  destruct t as [[[a b] c] d]. intros [P|S].
  - apply (signs_3.positive_3 (f a) (f b) (f c) (f d)) in P; [exact P|]. repeat split; apply domain.
  - assert (H := exact_orientation_sign_3_right (f a) (f b) (f c) (f d)). rewrite S in H. apply H. intros v [<-|[<-|[<-|[<-|[]]]]]; apply domain.
Qed.
Lemma flat_3_right t : flat_3 f t -> let '(a, b, c, d) := t in orient_at m a b c d = 0.
Proof.
  destruct t as [[[a b] c] d]. unfold flat_3. intro S. assert (H := exact_orientation_sign_3_right (f a) (f b) (f c) (f d)). rewrite S in H.
  apply H. intros v [<-|[<-|[<-|[<-|[]]]]]; apply domain.
Qed.
Lemma keeps_out_3_right a b c p q : keeps_out_3 f a b c p q -> 0 <= insphere_at m a b c p q.
Proof.
  intros [(t & I & H)|S].
  - assert (E := order_sphere a b c q p t I). destruct t as [[[x y] z] w]. rewrite <- E. apply Rlt_le.
    assert (D : coordinates_3 (f x) /\ coordinates_3 (f y) /\ coordinates_3 (f z) /\ coordinates_3 (f w)) by (repeat split; apply domain).
    destruct H as [[P X]|(others & O & X)].
    + exact (proj1 (sides_of_sphere_3 _ _ _ _ D (f p) (domain p) P) X).
    + apply (excludes_all_3_sound _ _ _ _ D (map f others)) in X; [apply X; now apply in_map|]. intros n N. apply in_map_iff in N. destruct N as (v & <- & _). apply domain.
  - assert (H : has_sign (exact_empty_sphere_sign_3 (f a) (f b) (f c) (f p) (f q)) (insphere_at m a b c p q)).
    { apply (exact_empty_sphere_sign_3_right (f a) (f b) (f c) (f p) (f q)). intros v [<-|[<-|[<-|[<-|[<-|[]]]]]]; apply domain. }
    revert H. destruct (exact_empty_sphere_sign_3 _ _ _ _ _) as [|s|s]; simpl; intro H; [now right; symmetry|now left|]. now elim S.
Qed.
Lemma other_side a b c p q : insphere_at m b a c q p = insphere_at m a b c p q.
Proof. unfold insphere_at. generalize (m a) (m b) (m c) (m p) (m q). clear. intros a b c p q. from_first a b c p q. Qed.

Theorem signed_holds_3 c : signed_3 f c -> holds_3 no_fold_3 c m.
Proof.
  destruct c as [a b c d|u w c d|a b c p q]; cbn [signed_3 holds_3].
  - intros (t & I & H). assert (E := order_volume a b c d t I). apply turns_left_3_right in H. destruct t as [[[? ?] ?] ?]. now rewrite <- E.
  - intros (t & I & H). assert (E := order_volume u w c d t I). destruct H as [H|[H F]].
    + left. apply turns_left_3_right in H. destruct t as [[[? ?] ?] ?]. now rewrite <- E.
    + right. assert (Z : orient_at m u w c d = 0) by (apply flat_3_right in H; destruct t as [[[? ?] ?] ?]; now rewrite <- E).
      split; [exact Z|]. apply flat_ridge_right_3; trivial. intros v [<-|[<-|[<-|[<-|[]]]]]; apply domain.
  - intro H. assert (P : 0 <= insphere_at m a b c p q) by (destruct H as [H|H]; apply keeps_out_3_right in H; [exact H|now rewrite other_side in H]).
    destruct P as [P|P]; [now left|right]. split; [now symmetry|exact I].
Qed.
End holds.
