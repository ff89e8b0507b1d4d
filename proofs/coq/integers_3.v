(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* integers_2.v in space: the terms of width_terms_3.h over integers are those over reals, times powers of two by degree.

   - tetrahedron_degrees, bicell_degrees   of which degree each term is *)
From Coq Require Import Reals ZArith List Lra.
From Flocq Require Import Core IEEE754.BinarySingleNaN IEEE754.PrimFloat.
From Coq Require Import Floats.
From Annulus Require Import operations filter_2 filter_3 integers_2.
Import ListNotations.
Close Scope float_scope.
Open Scope R_scope.

Definition real_point_3 (a b c : float) : vector_3 reals :=
  {| x3 := value a : number reals; y3 := value b : number reals; z3 := value c : number reals |}.
Definition integer_point_3 (k : Z) (a b c : float) : vector_3 integers :=
  {| x3 := integer k a : number integers; y3 := integer k b : number integers; z3 := integer k c : number integers |}.

Section over.
Variable o : operations.
Definition tetrahedron_of (a b c d : vector_3 o) := orientation_terms_3 o (difference_3 o b a) (difference_3 o c a) (difference_3 o d a).
Definition bicell_of (a b c p q : vector_3 o) :=
  bicell o (difference_3 o b a) (difference_3 o c a) (difference_3 o p a) (difference_3 o q a).

(* The half widths that make a tolerance, as terms; annuli are listed where they are judged, in ../link/truth_3.v. *)
Definition of_partition (t : bicell_terms o) (k : partition o) : width_terms o :=
  {| determinant := insphere _ t; inner := inner_3 _ k; outer := outer_3 _ k |}.
Definition of_cell (d l : number o) : width_terms o := {| determinant := d; inner := l; outer := l |}.
Definition two_cells (t : bicell_terms o) : list (width_terms o) :=
  [of_cell (cell_p _ t) (cell_p_slab _ t); of_cell (cell_q _ t) (cell_q_slab _ t)].
End over.

(* Scales: coordinates are c times integers, and a term of degree n is c^n times an integer. *)
Section scale.
Variable k : Z.
Let c := bpow radix2 k.
Definition degree (n : nat) (z : number integers) (r : number reals) : Prop := r = IZR z * c ^ n.
Definition degrees (n : nat) (v : vector_3 integers) (w : vector_3 reals) : Prop :=
  degree n (x3 _ v) (x3 _ w) /\ degree n (y3 _ v) (y3 _ w) /\ degree n (z3 _ v) (z3 _ w).

Lemma d_add : forall n z w r s, degree n z r -> degree n w s -> degree n (add integers z w) (add reals r s).
Proof. intros n z w r s. exact (add_scaled (c ^ n) r s z w). Qed.
Lemma d_sub : forall n z w r s, degree n z r -> degree n w s -> degree n (sub integers z w) (sub reals r s).
Proof. intros n z w r s. exact (sub_scaled (c ^ n) r s z w). Qed.
Lemma d_mul : forall n m z w r s, degree n z r -> degree m w s -> degree (n + m) (mul integers z w) (mul reals r s).
Proof. unfold degree. intros n m z w r s. rewrite pow_add. exact (mul_scaled (c ^ n) (c ^ m) r s z w). Qed.
Lemma d_square : forall n z r, degree n z r -> degree (n + n) (square integers z) (square reals r).
Proof. intros. now apply d_mul. Qed.
Lemma d_opp : forall n z r, degree n z r -> degree n (opposite integers z) (opposite reals r).
Proof. unfold degree. simpl. intros n z r ->. rewrite opp_IZR. ring. Qed.
Lemma d_max : forall n z w r s, degree n z r -> degree n w s -> degree n (greater integers z w) (greater reals r s).
Proof. unfold degree. simpl. intros n z w r s -> ->. apply Rmax_scaled. apply pow_le, bpow_ge_0. Qed.

Lemma v_plus : forall n v w v' w', degrees n v v' -> degrees n w w' -> degrees n (plus_3 integers v w) (plus_3 reals v' w').
Proof. intros n v w v' w' (A & B & C) (D & E & F). repeat split; now apply d_add. Qed.
Lemma v_difference : forall n v w v' w', degrees n v v' -> degrees n w w' ->
  degrees n (difference_3 integers v w) (difference_3 reals v' w').
Proof. intros n v w v' w' (A & B & C) (D & E & F). repeat split; now apply d_sub. Qed.
Lemma v_minus : forall n v v', degrees n v v' -> degrees n (minus_3 integers v) (minus_3 reals v').
Proof. intros n v v' (A & B & C). repeat split; now apply d_opp. Qed.
Lemma v_cross : forall n m v w v' w', degrees n v v' -> degrees m w w' -> degrees (n + m) (cross integers v w) (cross reals v' w').
Proof. intros n m v w v' w' (A & B & C) (D & E & F). repeat split; apply d_sub; now apply d_mul. Qed.
Lemma d_dot : forall n m v w v' w', degrees n v v' -> degrees m w w' -> degree (n + m) (dot integers v w) (dot reals v' w').
Proof. intros n m v w v' w' (A & B & C) (D & E & F). apply d_add; [apply d_add|]; now apply d_mul. Qed.
Lemma d_square_3 : forall n v v', degrees n v v' -> degree (n + n) (square_3 integers v) (square_3 reals v').
Proof. intros n v v' (A & B & C). apply d_add; [apply d_add|]; now apply d_square. Qed.
Lemma v_combination : forall n m r u s v t w r' u' s' v' t' w',
  degree n r r' -> degrees m u u' -> degree n s s' -> degrees m v v' -> degree n t t' -> degrees m w w' ->
  degrees (n + m) (combination integers r u s v t w) (combination reals r' u' s' v' t' w').
Proof.
  intros n m r u s v t w r' u' s' v' t' w' R (U & U1 & U2) S (V & V1 & V2) T (W & W1 & W2).
  repeat split; (apply d_add; [apply d_sub|]); now apply d_mul.
Qed.
Lemma v_minus_twice : forall n m v l a v' l' a', degrees (n + m) v v' -> degree n l l' -> degrees m a a' ->
  degrees (n + m) (minus_twice integers v l a) (minus_twice reals v' l' a').
Proof.
  intros n m v l a v' l' a' (V & V1 & V2) L (A & A1 & A2).
  repeat split; (apply d_sub; [assumption|]); apply d_mul; trivial; now apply d_add.
Qed.

Lemma d_slab : forall n u v w u' v' w', degrees n u u' -> degrees n v v' -> degrees n w w' ->
  degree (n + n) (largest_slab integers u v w) (largest_slab reals u' v' w').
Proof.
  intros n u v w u' v' w' U V W. unfold largest_slab. cbv zeta.
  pose proof (v_plus _ _ _ _ _ U V) as A. pose proof (v_plus _ _ _ _ _ V W) as B. pose proof (v_plus _ _ _ _ _ W U) as C.
  pose proof (v_plus _ _ _ _ _ A W) as D.
  apply d_max; apply d_max; try apply d_max; now apply d_square_3.
Qed.

Definition degree_terms (i j : nat) (t : width_terms integers) (t' : width_terms reals) : Prop :=
  degree i (determinant _ t) (determinant _ t') /\ degree j (inner _ t) (inner _ t') /\ degree j (outer _ t) (outer _ t').

Lemma degree_scaled : forall i t t', degree_terms (S i) (i + i) t t' -> scaled_terms c (c ^ i) t t'.
Proof.
  intros i t t' (D & I & O). unfold degree in *. repeat split; [exact D| |]; rewrite <- pow_add; assumption.
Qed.

Section bicell.
Variables (b d p q : vector_3 integers) (b' d' p' q' : vector_3 reals).
Hypothesis Hb : degrees 1 b b'.
Hypothesis Hc : degrees 1 d d'.
Hypothesis Hp : degrees 1 p p'.
Hypothesis Hq : degrees 1 q q'.
Let t := bicell integers b d p q.
Let t' := bicell reals b' d' p' q'.

Lemma bicell_degrees :
  (degree_terms 5 8 (of_partition _ t (abc_pq _ t)) (of_partition _ t' (abc_pq _ t')) /\
   degree_terms 5 8 (of_partition _ t (ab_cpq _ t)) (of_partition _ t' (ab_cpq _ t')) /\
   degree_terms 5 8 (of_partition _ t (ca_bpq _ t)) (of_partition _ t' (ca_bpq _ t')) /\
   degree_terms 5 8 (of_partition _ t (bc_apq _ t)) (of_partition _ t' (bc_apq _ t'))) /\
  (degree_terms 3 4 (of_cell _ (cell_p _ t) (cell_p_slab _ t)) (of_cell _ (cell_p _ t') (cell_p_slab _ t')) /\
   degree_terms 3 4 (of_cell _ (cell_q _ t) (cell_q_slab _ t)) (of_cell _ (cell_q _ t') (cell_q_slab _ t'))) /\
  (degree 3 (side _ (ab_cpq _ t)) (side _ (ab_cpq _ t')) /\ degree 3 (side _ (ca_bpq _ t)) (side _ (ca_bpq _ t')) /\
   degree 3 (side _ (bc_apq _ t)) (side _ (bc_apq _ t'))).
Proof.
  pose proof (v_cross 1 1 _ _ _ _ Hb Hc) as bc. pose proof (v_cross 1 1 _ _ _ _ Hb Hp) as bp.
  pose proof (v_cross 1 1 _ _ _ _ Hb Hq) as bq. pose proof (v_cross 1 1 _ _ _ _ Hc Hp) as cp.
  pose proof (v_cross 1 1 _ _ _ _ Hc Hq) as cq. pose proof (v_cross 1 1 _ _ _ _ Hp Hq) as pq.
  pose proof (d_square_3 1 _ _ Hb) as bb. pose proof (d_square_3 1 _ _ Hc) as cc.
  pose proof (d_square_3 1 _ _ Hp) as pp. pose proof (d_square_3 1 _ _ Hq) as qq.
  pose proof (d_dot 2 1 _ _ _ _ cp Hq) as lb. pose proof (d_dot 2 1 _ _ _ _ bq Hp) as lc.
  pose proof (d_dot 2 1 _ _ _ _ bc Hq) as lp. pose proof (d_dot 2 1 _ _ _ _ bc Hp) as nq.
  pose proof (d_add 5 _ _ _ _ (d_add 5 _ _ _ _ (d_mul 3 2 _ _ _ _ lb bb) (d_mul 3 2 _ _ _ _ lc cc))
                              (d_sub 5 _ _ _ _ (d_mul 3 2 _ _ _ _ lp pp) (d_mul 3 2 _ _ _ _ nq qq))) as det.
  pose proof (v_combination 2 2 _ _ _ _ _ _ _ _ _ _ _ _ bb cq cc bq qq bc) as up.
  pose proof (v_combination 2 2 _ _ _ _ _ _ _ _ _ _ _ _ bb cp cc bp pp bc) as vq.
  pose proof (v_combination 2 2 _ _ _ _ _ _ _ _ _ _ _ _ cc pq pp cq qq cp) as ub.
  pose proof (v_combination 2 2 _ _ _ _ _ _ _ _ _ _ _ _ bb pq pp bq qq bp) as vc.
  pose proof (d_sub 3 _ _ _ _ lp nq) as l1. pose proof (v_difference 4 _ _ _ _ up vq) as n1.
  pose proof (v_minus_twice 3 1 _ _ _ _ _ _ n1 l1 Hp) as m1.
  pose proof (d_add 3 _ _ _ _ l1 lc) as l2. pose proof (v_difference 4 _ _ _ _ n1 vc) as n2.
  pose proof (v_minus_twice 3 1 _ _ _ _ _ _ n2 l2 Hc) as m2.
  pose proof (d_add 3 _ _ _ _ l1 lb) as l3. pose proof (v_plus 4 _ _ _ _ n1 ub) as n3.
  pose proof (v_minus_twice 3 1 _ _ _ _ _ _ n3 l3 Hb) as m3.
  pose proof (d_add 3 _ _ _ _ lb lc) as l4. pose proof (v_difference 4 _ _ _ _ ub vc) as n4.
  pose proof (v_minus_twice 3 1 _ _ _ _ _ _ n4 l4 Hb) as m4.
  pose proof (d_slab 2 _ _ _ _ _ _ (v_minus 2 _ _ bc) bp (v_minus 2 _ _ cp)) as sp.
  pose proof (d_slab 2 _ _ _ _ _ _ bc cq (v_minus 2 _ _ bq)) as sq.
  repeat split; first
    [exact det|exact (d_square_3 4 _ _ n1)|exact (d_square_3 4 _ _ m1)|exact (d_square_3 4 _ _ n2)|exact (d_square_3 4 _ _ m2)
    |exact (d_square_3 4 _ _ n3)|exact (d_square_3 4 _ _ m3)|exact (d_square_3 4 _ _ n4)|exact (d_square_3 4 _ _ m4)
    |exact (d_opp 3 _ _ nq)|exact lp|exact sp|exact sq|exact l2|exact l3|exact (d_opp 3 _ _ l4)].
Qed.
End bicell.
End scale.

Lemma degrees_point : forall k a b c, (k <= exponent a)%Z -> (k <= exponent b)%Z -> (k <= exponent c)%Z ->
  degrees k 1 (integer_point_3 k a b c) (real_point_3 a b c).
Proof.
  intros k a b c A B C. unfold degrees, degree. simpl. rewrite Rmult_1_r.
  repeat split; now apply value_integer.
Qed.

Lemma tetrahedron_degrees : forall k u v w u' v' w', degrees k 1 u u' -> degrees k 1 v v' -> degrees k 1 w w' ->
  degree_terms k 3 4 (orientation_terms_3 integers u v w) (orientation_terms_3 reals u' v' w').
Proof.
  intros k u v w u' v' w' U V W.
  pose proof (v_cross k 1 1 _ _ _ _ U V) as uv. pose proof (v_cross k 1 1 _ _ _ _ V W) as vw. pose proof (v_cross k 1 1 _ _ _ _ W U) as wu.
  pose proof (d_slab k 2 _ _ _ _ _ _ uv vw wu) as slab. split; [exact (d_dot k 2 1 _ _ _ _ uv W)|split; exact slab].
Qed.
